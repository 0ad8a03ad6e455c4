//! The design matrix of an analysis: columns from covariates, and contrasts of these columns.

use crate::cohort::{Cohort, Values};
use crate::settings::Analysis;
use crate::statistics::linear::independent;
use faer::Mat;

/// Largest number of contrasts besides those of the effect: each has maps of every measure.
pub const MAX_CONTRASTS: usize = 100;

/// A design: a row for each subject with all covariates; a column for the mean, for each number, and for each level of
/// a factor except its reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Indices in the cohort of the subjects that are rows.
    pub rows: Vec<usize>,
    /// Requested subjects with a missing value.
    pub incomplete: Vec<usize>,
    /// Names of the columns: `mean`, `age`, `group:patient`.
    pub columns: Vec<String>,
    /// The matrix. Numbers are centered, so that `mean` is the mean of the reference levels at the mean of all numbers.
    pub matrix: Mat<f64>,
    /// The tested contrasts.
    pub contrasts: Vec<Contrast>,
}

/// A sum of columns of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Contrast {
    /// Its name in files: letters, digits, `_`, `-` and `.`.
    pub name: String,
    /// Its meaning, for people.
    pub meaning: String,
    /// The weight of each column.
    pub weights: Vec<f64>,
    /// Whether it compares levels of a factor, which makes its effect size a difference over a standard deviation.
    pub of_levels: bool,
}

impl Design {
    /// The design of an analysis over these subjects of the cohort.
    ///
    /// # Errors
    /// The fault of the analysis, in words: a covariate or a level that does not exist, too few subjects, linearly
    /// dependent columns.
    pub fn new(cohort: &Cohort, subjects: &[usize], analysis: &Analysis) -> Result<Self, String> {
        if analysis.contrasts.len() > MAX_CONTRASTS {
            return Err(format!(
                "{} further contrasts are asked for; a study has at most {MAX_CONTRASTS}, each with a test at every vertex",
                analysis.contrasts.len()
            ));
        }
        let names: Vec<&String> = analysis.effect.iter().chain(&analysis.adjust).collect();
        let mut covariates = Vec::new();
        for (k, name) in names.iter().enumerate() {
            if names[..k].contains(name) {
                return Err(format!("covariate {name} is named twice; name it in --effect or in --adjust, once"));
            }
            let known: Vec<&str> = cohort.covariates.iter().map(|c| c.name.as_str()).collect();
            let missing =
                || format!("the table has no covariate {name}; its covariates are: {}", or_none(&known.join(", ")));
            covariates.push(cohort.covariate(name).ok_or_else(missing)?);
        }
        let is_complete = |k: &usize| covariates.iter().all(|covariate| covariate.values.is_stated(*k));
        let (rows, incomplete): (Vec<usize>, Vec<usize>) = subjects.iter().copied().partition(is_complete);
        let (mut columns, mut data) = (vec!["mean".to_owned()], vec![vec![1.0; rows.len()]]);
        let mut contrasts = Vec::new();
        let mut reference_levels = Vec::new();
        for covariate in &covariates {
            let name = &covariate.name;
            let is_effect = analysis.effect.as_ref() == Some(name);
            match &covariate.values {
                Values::Numbers(of) => {
                    let values: Vec<f64> = rows.iter().filter_map(|&k| of[k]).collect();
                    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
                    columns.push(name.clone());
                    data.push(values.into_iter().map(|value| value - mean).collect());
                    if is_effect {
                        contrasts.push((plain(name), format!("change for each unit of {name}"), name.clone(), false));
                    }
                }
                Values::Factor { levels, of } => {
                    let present: Vec<usize> =
                        (0..levels.len()).filter(|level| rows.iter().any(|&k| of[k] == Some(*level))).collect();
                    let asked = analysis.reference.iter().find(|(of, _)| of == name).map(|(_, level)| level);
                    let reference = match asked {
                        None => present.first().copied(),
                        Some(level) => present.iter().copied().find(|&k| levels[k] == *level),
                    };
                    let Some(reference) = reference else {
                        let levels: Vec<&str> = present.iter().map(|&k| levels[k].as_str()).collect();
                        return Err(format!(
                            "covariate {name} has no level {}; its levels are: {}",
                            asked.map_or("", String::as_str),
                            or_none(&levels.join(", "))
                        ));
                    };
                    reference_levels.push(format!("{name}:{}", levels[reference]));
                    for &level in present.iter().filter(|&&level| level != reference) {
                        let column = format!("{name}:{}", levels[level]);
                        data.push(rows.iter().map(|&k| f64::from(u8::from(of[k] == Some(level)))).collect());
                        if is_effect {
                            let meaning = format!("{} minus {}, {name}", levels[level], levels[reference]);
                            let of_name = plain(&format!("{}-{}", levels[level], levels[reference]));
                            contrasts.push((of_name, meaning, column.clone(), true));
                        }
                        columns.push(column);
                    }
                }
            }
        }
        let matrix = Mat::from_fn(rows.len(), columns.len(), |i, k| data[k][i]);
        if rows.len() < columns.len() + 2 {
            return Err(format!(
                "{} subjects have all covariates of the analysis, which is too few for {} columns of its design; name fewer \
                 covariates",
                rows.len(),
                columns.len()
            ));
        }
        if let Some(k) = independent(&matrix) {
            return Err(format!(
                "column {} of the design follows from the columns before it ({}); leave out one of these covariates",
                columns[k],
                columns[..k].join(", ")
            ));
        }
        let more =
            analysis.contrasts.iter().map(|(name, sum)| (plain(name), sum.clone(), sum.clone(), sum.contains(':')));
        let contrasts = contrasts.into_iter().chain(more).map(|(name, meaning, sum, of_levels)| {
            let weights = weights(&sum, &columns, &reference_levels)?;
            Ok(Contrast { name, meaning, weights, of_levels })
        });
        let contrasts: Vec<Contrast> = contrasts.collect::<Result<_, String>>()?;
        for (k, contrast) in contrasts.iter().enumerate() {
            if contrasts[..k].iter().any(|other| other.name == contrast.name) {
                return Err(format!("two contrasts are named {}; give each a name of its own", contrast.name));
            }
        }
        Ok(Design { rows, incomplete, columns, matrix, contrasts })
    }
}

fn or_none(text: &str) -> &str {
    if text.is_empty() { "none" } else { text }
}

/// A name for files.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.') { c } else { '_' }).collect()
}

/// The weights of a sum such as `group:a - 0.5*group:b`. A reference level has no column and weight 0.
fn weights(sum: &str, columns: &[String], reference_levels: &[String]) -> Result<Vec<f64>, String> {
    let mut weights = vec![0.0; columns.len()];
    let mut sign = 1.0;
    let mut expected = true;
    let wrong = |what: &str| {
        Err(format!(
            "the contrast {sum} {what}; write a sum of columns such as group:a - group:b, of: {}",
            columns.join(", ")
        ))
    };
    // Signs stand alone, so that names may contain them.
    for word in sum.split_whitespace() {
        match (word, expected) {
            ("-", _) => (sign, expected) = (-1.0, true),
            ("+", _) => (sign, expected) = (1.0, true),
            (_, false) => return wrong(&format!("has no sign before {word}")),
            (term, true) => {
                let (factor, name) = match term.split_once('*') {
                    Some((factor, name)) => (factor.parse::<f64>().ok(), name),
                    None => (Some(1.0), term),
                };
                let Some(factor) = factor.filter(|factor| factor.is_finite()) else {
                    return wrong(&format!("has {term}, which does not begin with a number"));
                };
                if let Some(k) = columns.iter().position(|column| column == name) {
                    weights[k] += sign * factor;
                } else if !reference_levels.iter().any(|level| level == name) {
                    return wrong(&format!("names {name}, which is no column of the design"));
                }
                (sign, expected) = (1.0, false);
            }
        }
    }
    if weights.iter().all(|&weight| weight == 0.0) {
        return wrong("has weight 0 for every column");
    }
    Ok(weights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn cohort() -> Cohort {
        let mut text = "id,file,group,age,site,years\n".to_owned();
        for k in 0..12 {
            let group = ["control", "mild", "severe"][k % 3];
            let age = if k == 4 { "NA".to_owned() } else { (60 + k * k % 7).to_string() };
            text.push_str(&format!("s{k},{k}.ply,{group},{age},{},{age}\n", ["a", "b"][k / 6]));
        }
        Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap()
    }

    fn design(analysis: Analysis) -> Result<Design, String> {
        Design::new(&cohort(), &(0..12).collect::<Vec<_>>(), &analysis)
    }

    #[test]
    fn covariates_become_columns_and_the_effect_contrasts() {
        let analysis = Analysis {
            effect: Some("group".to_owned()),
            adjust: vec!["age".to_owned()],
            reference: vec![("group".to_owned(), "mild".to_owned())],
            contrasts: vec![("ends".to_owned(), "group:severe - 2*group:control + group:mild".to_owned())],
            ..Analysis::default()
        };
        let design = design(analysis).unwrap();
        assert_eq!(design.columns, ["mean", "group:control", "group:severe", "age"]);
        assert_eq!((design.rows.len(), design.incomplete.as_slice()), (11, &[4][..]));
        let names: Vec<_> = design.contrasts.iter().map(|c| (c.name.as_str(), c.weights.clone())).collect();
        assert_eq!(names[0], ("control-mild", vec![0.0, 1.0, 0.0, 0.0]));
        assert_eq!(names[1], ("severe-mild", vec![0.0, 0.0, 1.0, 0.0]));
        assert_eq!(names[2], ("ends", vec![0.0, -2.0, 1.0, 0.0]));
        assert!((0..11).map(|i| design.matrix[(i, 3)]).sum::<f64>().abs() < 1e-12, "numbers are centered");
    }

    #[test]
    fn faults_name_what_is_wrong() {
        let effect = |name: &str| Analysis { effect: Some(name.to_owned()), ..Analysis::default() };
        let said = |analysis| design(analysis).unwrap_err();
        assert!(said(effect("grup")).contains("group, age"));
        let twice = Analysis { adjust: vec!["age".to_owned()], ..effect("age") };
        assert!(said(twice).contains("twice"));
        let same = Analysis { adjust: vec!["age".to_owned(), "years".to_owned()], ..effect("group") };
        assert!(said(same).contains("column years"));
        let level = Analysis { reference: vec![("group".to_owned(), "none".to_owned())], ..effect("group") };
        assert!(said(level).contains("control, mild, severe"));
        for (sum, part) in [
            ("group:x", "no column"),
            ("group:mild group:severe", "no sign"),
            ("group:control", "weight 0"),
            ("a*age", "number"),
        ] {
            let contrasts = vec![("c".to_owned(), sum.to_owned())];
            assert!(said(Analysis { contrasts, ..effect("group") }).contains(part), "{sum}");
        }
        let few = Design::new(&cohort(), &[0, 1, 2], &effect("group")).unwrap_err();
        assert!(few.contains("too few"), "{few}");
    }
}
