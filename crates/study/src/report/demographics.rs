//! Subjects of the statistics: covariates and sizes by group, degrees of freedom, and the number of possible
//! permutations.

use super::table;
use crate::cohort::{Covariate, Values};
use crate::findings::Findings;
use crate::plan::Study;
use homolog_run::page::escaped;
use std::collections::BTreeSet;

/// Number of pairs below which sign flips are reported as few: no p below 0.001 is possible.
const FEW_PAIRS: usize = 11;
/// Number of different permutations below which they are reported as few: no p below 0.001 is possible.
const FEW_PERMUTATIONS: f64 = 1000.0;

/// Number of subjects below which Wald tests by the normal distribution are doubted: at 30, quantiles of t are 4 % larger than those of
/// the normal distribution.
const FEW_SUBJECTS: usize = 30;

/// Subjects of the model that are compared, with the name of the group.
struct Group {
    name: String,
    members: Vec<usize>,
}

/// All members of the model and, if the effect is a factor, those of each of its levels.
fn groups(study: &Study, found: &Findings) -> Vec<Group> {
    let mut groups = vec![Group { name: "all".to_owned(), members: found.members.clone() }];
    let effect = study.settings.analysis.effect.as_ref().and_then(|name| study.cohort.covariate(name));
    if let Some(Covariate { name, values: Values::Factor { levels, of } }) = effect {
        for (place, level) in levels.iter().enumerate() {
            let members: Vec<usize> = found.members.iter().copied().filter(|&k| of[k] == Some(place)).collect();
            if !members.is_empty() {
                groups.push(Group { name: format!("{name} {level}"), members });
            }
        }
    }
    groups
}

/// `n`, mean and standard deviation, and the range, of the available values.
fn moments(values: &[f64]) -> String {
    let n = values.len();
    if n == 0 {
        return "none".to_owned();
    }
    let mean = values.iter().sum::<f64>() / n as f64;
    let squares = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
    let sd = if n > 1 { format!(" ± {}", short((squares / (n - 1) as f64).sqrt())) } else { String::new() };
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
    format!("{}{sd} ({} to {}; n\u{a0}{n})", short(mean), short(low), short(high))
}

/// A number with digits appropriate to its size.
fn short(value: f64) -> String {
    let digits = if value.abs() >= 100.0 { 0 } else { 2 };
    format!("{value:.digits$}").replace('-', "−")
}

/// Number of people among these rows.
fn people(study: &Study, rows: &[usize]) -> usize {
    rows.iter().map(|&k| &study.cohort.subjects[k].subject).collect::<BTreeSet<_>>().len()
}

/// The number of subjects among these rows in words, and that of surfaces where subjects have several.
pub(super) fn counted(study: &Study, rows: &[usize]) -> String {
    let (n, people) = (rows.len(), people(study, rows));
    if n == people { format!("{n} subjects") } else { format!("{n} surfaces of {people} subjects") }
}

/// The table of covariates and sizes by group.
pub(super) fn section(study: &Study, found: &Findings) -> String {
    let groups = groups(study, found);
    let numbers = |name: &str, of: &dyn Fn(&Group) -> usize| -> Vec<String> {
        std::iter::once(name.to_owned()).chain(groups.iter().map(|group| of(group).to_string())).collect()
    };
    let mut rows = vec![numbers("subjects", &|group| people(study, &group.members))];
    if study.cohort.is_longitudinal() {
        rows.push(numbers("surfaces", &|group| group.members.len()));
    }
    let mut row = |name: String, cell: &dyn Fn(&Group) -> String| {
        rows.push(std::iter::once(name).chain(groups.iter().map(cell)).collect());
    };
    for Covariate { name, values } in &study.cohort.covariates {
        row(escaped(name), &|group| match values {
            Values::Numbers(of) => moments(&group.members.iter().filter_map(|&k| of[k]).collect::<Vec<_>>()),
            Values::Factor { levels, of } => {
                let count = |place: usize| group.members.iter().filter(|&&k| of[k] == Some(place)).count();
                let present = levels.iter().enumerate().map(|(place, level)| (level, count(place)));
                let listed: Vec<String> =
                    present.filter(|(_, n)| *n > 0).map(|(level, n)| format!("{} {n}", escaped(level))).collect();
                if listed.is_empty() { "none".to_owned() } else { listed.join(", ") }
            }
        });
    }
    type OfSubject<'a> = &'a dyn Fn(usize) -> Option<f64>;
    let measured: [(&str, OfSubject<'_>); 3] = [
        ("volume, mm³", &|k| found.subjects[k].facts.volume_mm3),
        ("area, mm²", &|k| Some(found.subjects[k].facts.area_mm2)),
        ("centroid size, mm", &|k| Some(found.subjects[k].size_mm)),
    ];
    for (name, of) in measured {
        row(name.to_owned(), &|group| moments(&group.members.iter().filter_map(|&k| of(k)).collect::<Vec<_>>()));
    }
    let header: Vec<String> =
        std::iter::once(String::new()).chain(groups.iter().map(|group| escaped(&group.name))).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    format!(
        "<h2>Subjects of the model</h2>\n<p class=\"hint\">Mean ± standard deviation (range; n with a value); of factors, subjects of \
         each level.</p>\n{}",
        table(&header, &rows, "free")
    )
}

/// Subjects, columns and degrees of freedom of the statistics, and a warning if few permutations are possible.
pub(super) fn degrees(study: &Study, found: &Findings) -> String {
    let Some(statistics) = &found.statistics else { return String::new() };
    let (n, p) = (statistics.design.rows.len(), statistics.design.columns.len());
    let mut html = format!(
        "<p>{}, {p} columns of the design ({}), {:.0} degrees of freedom of the residuals.</p>\n",
        counted(study, &statistics.design.rows),
        escaped(&statistics.design.columns.join(", ")),
        statistics.degrees
    );
    if statistics.longitudinal {
        html.push_str(
            "<p>Subjects have several surfaces: a random intercept for each subject, Wald tests by the normal distribution, no \
             permutations.</p>\n",
        );
        let people = people(study, &statistics.design.rows);
        if people < FEW_SUBJECTS {
            html.push_str(&format!(
                "<p class=\"warning\"><strong>Few subjects:</strong> Wald tests by the normal distribution give too small p-values for \
                 {people} subjects; take them as a hint where to look.</p>\n"
            ));
        }
        return html;
    }
    html.push_str(&format!(
        "<p>With {} permutations or sign flips no corrected p is below {:.4}.</p>\n",
        study.settings.analysis.permutations,
        1.0 / study.settings.analysis.permutations.max(1) as f64
    ));
    if let Some(of) = &statistics.pairs {
        let (pairs, single) = (of.pairs.len(), of.single);
        html.push_str(&format!(
            "<p>Differences within {pairs} subjects are tested against zero, by flipping their signs; {single} subjects with one \
             surface are left out.</p>\n"
        ));
        if pairs < FEW_PAIRS {
            html.push_str(&format!(
                "<p class=\"warning\"><strong>Few sign flips are possible:</strong> the signs of {pairs} differences can be chosen in {} \
                 ways that differ in |t|, so that no corrected p can be below {:.3}, however many are drawn.</p>\n",
                1u32 << (pairs - 1),
                1.0 / f64::from(1u32 << (pairs - 1))
            ));
        }
        return html;
    }
    // With further covariates, residuals differ within a group, so that nearly all orders differ.
    let analysis = &study.settings.analysis;
    let effect = analysis.effect.as_ref().filter(|_| analysis.adjust.is_empty());
    let effect = effect.and_then(|name| study.cohort.covariate(name));
    if let Some(possible) = effect.map(|effect| arrangements(&statistics.design.rows, &effect.values))
        && possible < FEW_PERMUTATIONS
    {
        html.push_str(&format!(
            "<p class=\"warning\"><strong>Few permutations are possible:</strong> {n} subjects can be arranged in {possible:.0} ways \
             that differ in |t|, so that no corrected p can be below {:.3}, however many are drawn.</p>\n",
            1.0 / possible
        ));
    }
    html
}

/// Number of ways to distribute the values of a covariate over subjects that differ in the |t| of its effect: `n! / Π mᵢ!` for
/// values that occur `mᵢ` times, and half of that if the values are symmetric about their mean (two groups of equal size, ages at
/// equal distances), because the mirrored arrangement has the same |t|.
fn arrangements(rows: &[usize], values: &Values) -> f64 {
    let mut found: Vec<f64> = match values {
        Values::Numbers(of) => rows.iter().filter_map(|&k| of[k]).collect(),
        Values::Factor { of, .. } => rows.iter().filter_map(|&k| of[k]).map(|level| level as f64).collect(),
    };
    found.sort_by(f64::total_cmp);
    let groups: Vec<&[f64]> = found.chunk_by(|a, b| a == b).collect();
    let symmetric = match values {
        // Exchanging two of several groups also exchanges their effects, which are tested one by one.
        Values::Factor { .. } => groups.len() == 2 && groups[0].len() == groups[1].len(),
        Values::Numbers(_) => {
            let ends = found.first().zip(found.last()).map_or(0.0, |(least, most)| least + most);
            let round_off = 1e-12 * found.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            groups.len() > 1 && found.iter().zip(found.iter().rev()).all(|(a, b)| (a + b - ends).abs() <= round_off)
        }
    };
    // A product of binomial coefficients, which is exact as long as it is small.
    let mut left = found.len();
    let all = groups.iter().fold(1.0, |all, group| {
        let chosen = (0..group.len()).fold(1.0, |all, i| all * (left - i) as f64 / (i + 1) as f64);
        left -= group.len();
        all * chosen
    });
    if symmetric { all / 2.0 } else { all }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_subjects_have_three_splits_that_differ() {
        let factor = |of: &[usize]| Values::Factor {
            levels: vec!["a".to_owned(), "b".to_owned()],
            of: of.iter().map(|k| Some(*k)).collect(),
        };
        let rows: Vec<usize> = (0..4).collect();
        assert_eq!(arrangements(&rows, &factor(&[0, 0, 1, 1])).round(), 3.0);
        let numbers = |of: [f64; 4]| arrangements(&rows, &Values::Numbers(of.map(Some).to_vec())).round();
        assert_eq!(
            [numbers([1.0, 2.0, 3.0, 4.0]), numbers([4.0, 1.0, 2.0, 8.0]), numbers([5.0; 4])],
            [12.0, 24.0, 1.0]
        );
        assert_eq!(arrangements(&rows[..3], &factor(&[0, 0, 0, 1])).round(), 1.0);
        assert!(
            arrangements(&(0..400).collect::<Vec<_>>(), &factor(&(0..400).map(|k| k % 2).collect::<Vec<_>>())) > 1e100
        );
    }

    #[test]
    fn moments_are_those_of_a_sample() {
        assert_eq!(moments(&[1.0, 2.0, 3.0]), "2.00 ± 1.00 (1.00 to 3.00; n\u{a0}3)");
        assert_eq!((moments(&[]).as_str(), moments(&[250.4]).as_str()), ("none", "250 (250 to 250; n\u{a0}1)"));
    }
}
