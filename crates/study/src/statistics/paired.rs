//! Paired designs: two rows of each person that differ in the effect, such as left and right, compared within persons.
//!
//! The differences within persons are tested against zero: what a person has in both rows cancels, and with it every
//! covariate that does not vary within persons. Signs of differences are exchangeable if there is no effect and errors are
//! symmetric, so there are permutation tests, which visits do not allow otherwise.

use crate::cohort::{Cohort, Values};
use crate::settings::Analysis;
use crate::statistics::design::Design;
use std::collections::BTreeMap;

/// The pairs of a paired design.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pairs {
    /// For each person the places in [`Design::rows`] of the row with the tested level and of that with the reference.
    pub pairs: Vec<[usize; 2]>,
    /// Persons with one row, who are left out.
    pub single: usize,
}

impl Pairs {
    /// The pairs of an analysis, if it is paired: its effect is a factor of two levels, no person has two rows of one level, at
    /// least three have both, no adjusted covariate varies within a person, and there are no further contrasts.
    pub fn of(cohort: &Cohort, design: &Design, analysis: &Analysis) -> Option<Self> {
        let [contrast] = design.contrasts.as_slice() else { return None };
        let effect = cohort.covariate(analysis.effect.as_ref()?)?;
        if !contrast.of_levels || !matches!(effect.values, Values::Factor { .. }) {
            return None;
        }
        // The column of the level that is not the reference.
        let column = contrast.weights.iter().position(|&weight| weight == 1.0)?;
        let mut persons: BTreeMap<&str, [Option<usize>; 2]> = BTreeMap::new();
        for (row, &k) in design.rows.iter().enumerate() {
            let level = usize::from(design.matrix[(row, column)] == 0.0);
            let of_person = persons.entry(&cohort.subjects[k].subject).or_default();
            if of_person[level].replace(row).is_some() {
                return None;
            }
        }
        let both = |of: &[Option<usize>; 2]| Some([of[0]?, of[1]?]);
        let pairs: Vec<[usize; 2]> = persons.values().filter_map(both).collect();
        let varies = |[a, b]: &[usize; 2]| {
            (0..design.columns.len()).any(|k| k != column && design.matrix[(*a, k)] != design.matrix[(*b, k)])
        };
        let single = persons.len() - pairs.len();
        (pairs.len() >= 3 && !pairs.iter().any(varies)).then_some(Pairs { pairs, single })
    }

    /// The difference of each pair.
    pub fn differences(&self, values: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let difference = |[a, b]: &[usize; 2]| values[*a].iter().zip(&values[*b]).map(|(a, b)| a - b).collect();
        self.pairs.iter().map(difference).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn pairs(rows: &str, analysis: &Analysis) -> Option<Pairs> {
        let cohort =
            Cohort::from_csv(format!("id,file,subject,side,age,dose\n{rows}").as_bytes(), Path::new("")).unwrap();
        let all: Vec<usize> = (0..cohort.subjects.len()).collect();
        let design = Design::new(&cohort, &all, analysis).unwrap();
        Pairs::of(&cohort, &design, analysis)
    }

    fn rows() -> String {
        let row = |k: usize, side: &str| {
            format!("s{k}{side},{k}{side}.ply,p{k},{side},{},{}\n", 60 + k * k % 5, k + side.len())
        };
        let mut rows: String = (0..5).flat_map(|k| ["left", "right"].map(|side| row(k, side))).collect();
        rows.push_str(&row(5, "right"));
        rows
    }

    #[test]
    fn rows_of_one_person_are_paired_unless_more_than_the_effect_differs() {
        let asked = |adjust: &[&str]| Analysis {
            effect: Some("side".to_owned()),
            adjust: adjust.iter().map(|name| (*name).to_owned()).collect(),
            ..Analysis::default()
        };
        let found = pairs(&rows(), &asked(&["age"])).unwrap();
        assert_eq!((found.pairs.len(), found.single), (5, 1));
        assert_eq!(found.pairs[1], [3, 2], "right minus left");
        assert!(pairs(&rows(), &asked(&["dose"])).is_none(), "it varies within persons");
        let twice = rows() + "again,again.ply,p0,left,60,4\n";
        assert!(pairs(&twice, &asked(&[])).is_none());
        let of_age = Analysis { effect: Some("age".to_owned()), ..Analysis::default() };
        assert!(pairs(&rows(), &of_age).is_none());
    }

    #[test]
    fn differences_are_of_the_tested_level_minus_the_reference() {
        let pairs = Pairs { pairs: vec![[1, 0], [2, 3]], single: 0 };
        let values = vec![vec![1.0, 2.0], vec![4.0, 1.0], vec![0.0, 0.0], vec![0.5, -1.0]];
        assert_eq!(pairs.differences(&values), [[3.0, -1.0], [-0.5, 1.0]]);
    }
}
