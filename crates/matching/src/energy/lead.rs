//! Significance of the difference in cost between two labelings.

use crate::surface::robust::mean_over_standard_error;
use crate::surface::sites::Sites;

/// Standard errors of the mean difference from which one of two labelings costs more.
pub(crate) const DISTINCT_LABELINGS: f64 = 3.0;

/// Groups of neighboring variables over which the costs of two labelings are compared.
const GROUPS: usize = 40;

/// Groups of neighboring variables. The costs of neighbors are correlated; means over groups hardly are.
#[derive(Debug, Clone)]
pub(crate) struct VariableClusters {
    /// The group of each variable.
    of: Vec<u32>,
    n: usize,
}

impl VariableClusters {
    /// The groups of `variables`, which are `sites` in farthest-point order. The first variables are the centers of the
    /// groups; each variable belongs to the nearest center.
    pub(crate) fn new(sites: &Sites, variables: &[u32]) -> VariableClusters {
        let n = GROUPS.min(variables.len());
        let nearest = |&site: &u32| {
            let row = sites.row(site as usize);
            let distance = |group: &u32| row[variables[*group as usize] as usize];
            (0..n as u32).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };
        VariableClusters { of: variables.iter().map(nearest).collect(), n }
    }

    /// Excess of `others` over `own`, the costs of each variable: the mean difference over groups, in standard errors.
    pub(crate) fn lead(&self, own: &[f64], others: &[f64]) -> f64 {
        let mut sums = vec![0.0; self.n];
        for ((own, other), &group) in own.iter().zip(others).zip(&self.of) {
            sums[group as usize] += other - own;
        }
        mean_over_standard_error(&sums)
    }
}
