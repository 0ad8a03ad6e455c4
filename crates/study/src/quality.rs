//! Quality control: the subjects to look at, the most urgent first.

use crate::subjects::{Flag, SubjectFindings, SubjectOutcome};

/// Robust deviations from the median beyond which a value is unusual.
const UNUSUAL: f64 = 3.5;
/// Largest deviation that counts in the order of urgency, so that classes of subjects do not overlap.
const MOST_DEVIATION: f64 = 1e6;
/// Share of turned triangles below which no map is flagged.
const FEW_FOLDS: f64 = 0.005;

/// Deviations of values from their median, in units of their robust standard deviation (1.4826 times the median
/// absolute deviation); 0 if all are equal.
///
/// Source: Iglewicz, Hoaglin, *How to detect and handle outliers*, 1993, whose bound is 3.5.
pub fn deviations(values: &[f64]) -> Vec<f64> {
    let median = |mut of: Vec<f64>| {
        of.sort_by(f64::total_cmp);
        let n = of.len();
        if n == 0 { 0.0 } else { f64::midpoint(of[(n - 1) / 2], of[n / 2]) }
    };
    let middle = median(values.to_vec());
    let spread = 1.4826 * median(values.iter().map(|x| (x - middle).abs()).collect());
    // Rounding does not count as spread.
    let least = 1e-9 * middle.abs();
    values.iter().map(|x| if spread > least { (x - middle) / spread } else { 0.0 }).collect()
}

/// The largest of the deviations that may raise a flag, so that flagged subjects come before all others; unreliable ones come
/// first. `least`: of a subject with another flag.
fn urgency(deviations: [f64; 4], least: f64, is_unreliable: bool) -> f64 {
    let largest = deviations.into_iter().fold(least, f64::max).min(MOST_DEVIATION);
    if is_unreliable { largest + MOST_DEVIATION } else { largest }
}

/// Flags every subject, and computes its urgency.
pub(crate) fn flags(subjects: &mut [SubjectFindings]) {
    let matched: Vec<usize> = (0..subjects.len()).filter(|&k| subjects[k].place != SubjectOutcome::Failed).collect();
    let of = |value: &dyn Fn(&SubjectFindings) -> f64| {
        deviations(&matched.iter().map(|&k| value(&subjects[k])).collect::<Vec<_>>())
    };
    let mut residual = of(&|s| s.facts.residual_mm.max(1e-12).ln());
    let folds = of(&|s| s.facts.folded);
    // Of structures each is compared with the same structure of the others: the largest would hide the rest.
    let mut reasons: Vec<(usize, String)> = Vec::new();
    let n_structures = matched.first().map_or(0, |&k| subjects[k].structures.len());
    for at in 0..n_structures {
        let of_structure = of(&|s| s.structures[at].facts.residual_mm.max(1e-12).ln());
        for ((most, own), &k) in residual.iter_mut().zip(of_structure).zip(&matched) {
            *most = most.max(own);
            if own > UNUSUAL {
                let reason = format!("{}: {}", subjects[k].structures[at].name, Flag::UnusualResidual.title());
                reasons.push((k, reason));
            }
        }
    }
    // Squared distances are skewed; their logarithms are nearly normal.
    let shape = of(&|s| s.distance.unwrap_or(1.0).max(1e-12).ln());
    let size = of(&|s| s.size_mm.max(1e-12).ln());
    reasons.into_iter().for_each(|(k, reason)| subjects[k].facts.reasons.push(reason));
    for (row, &k) in matched.iter().enumerate() {
        let subject = &mut subjects[k];
        let mut raise = |flag: Flag, is_raised: bool| {
            if is_raised {
                subject.flags.push(flag);
            }
        };
        let unreliable = subject.facts.reliable == Some(false);
        raise(Flag::UnreliableMatch, unreliable);
        raise(Flag::UnusualResidual, residual[row] > UNUSUAL);
        let is_folded = folds[row] > UNUSUAL && subject.facts.folded > FEW_FOLDS;
        raise(Flag::UnusualFolds, is_folded);
        raise(Flag::UnusualShape, shape[row] > UNUSUAL);
        raise(Flag::UnusualSize, size[row].abs() > UNUSUAL);
        let is_decided = subject.group_decisions().any(|(_, decision)| decision.decided);
        if is_decided {
            subject.flags.push(Flag::PoseByGroup);
        }
        let folds = if is_folded { folds[row] } else { 0.0 };
        let least = if is_decided { UNUSUAL } else { f64::NEG_INFINITY };
        subject.urgency = urgency([residual[row], shape[row], size[row].abs(), folds], least, unreliable);
    }
    for subject in subjects.iter_mut().filter(|subject| subject.place == SubjectOutcome::Failed) {
        (subject.flags, subject.urgency) = (vec![Flag::NoMatch], 2.0 * MOST_DEVIATION + 1.0);
    }
}

/// The indices of subjects, the most urgent first; ties keep the order of the cohort.
pub fn most_urgent_first(subjects: &[SubjectFindings]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..subjects.len()).collect();
    order.sort_by(|&a, &b| subjects[b].urgency.total_cmp(&subjects[a].urgency).then(a.cmp(&b)));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_flag_comes_before_what_has_none() {
        let none = f64::NEG_INFINITY;
        let usual = urgency([UNUSUAL, UNUSUAL, UNUSUAL, 0.0], none, false);
        for flagged in 0..4 {
            let mut deviations = [0.0; 4];
            deviations[flagged] = UNUSUAL + 0.01;
            assert!(urgency(deviations, none, false) > usual, "flag {flagged}");
        }
        assert!(urgency([-1.0; 4], none, true) > urgency([500.0; 4], none, false));
        assert!(urgency([-1.0; 4], UNUSUAL, false) >= usual);
    }

    #[test]
    fn one_far_value_does_not_hide_itself() {
        let found = deviations(&[1.0, 1.1, 0.9, 1.05, 0.95, 9.0]);
        assert!(found[5] > 50.0 && found[..5].iter().all(|d| d.abs() < 2.0), "{found:?}");
        assert_eq!(deviations(&[2.0; 5]), [0.0; 5]);
        assert_eq!(deviations(&[]), Vec::<f64>::new());
    }
}
