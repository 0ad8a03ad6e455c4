//! Marginals of candidates by sum-product belief propagation.
//!
//! The energy is a [`MetricModel`] whose labels are the candidates of all variables. The distance of two labels is the root of
//! their pairwise potential above the least of the two variables, and all edges ask for the distance 0. Exact for two variables; where
//! the graph has loops, evidence returns to where it came from, and beliefs are more extreme than marginals if the couplings
//! between variables are strong compared with the evidence of the observed subjects. Potentials are divided by the number of all
//! subjects, which keeps couplings of pairs weak; the unit tests compare with the enumeration of all labelings.

use super::settings::GroupSettings;
use homolog_mrf::metric::{ActiveOptions, MetricEdge, MetricModel, Semiring};

/// Potential, in a pair, above which a combination of candidates is impossible: `exp(−80)` is just above the smallest message.
/// Where two subjects contradict each other more strongly than this, the range of the reliable subjects decides.
const TRUNCATION: f32 = 80.0;
/// Potential of a candidate of another variable.
const IMPOSSIBLE: f32 = 1e6;

/// Energy of the candidates of a group, lower is better, in units of log-likelihood.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GroupEnergy {
    /// For each variable the potential of each candidate.
    pub(super) unary: Vec<Vec<f64>>,
    /// For pairs of variables `i < j` the potentials, by the candidates of `i`, then by those of `j`.
    pub(super) pairwise: Vec<([usize; 2], Vec<f64>)>,
}

fn least(of: &[f64]) -> f64 {
    of.iter().copied().fold(f64::INFINITY, f64::min)
}

impl GroupEnergy {
    /// The marginal of each candidate of each variable under `p ∝ exp(−E)`, as far as belief propagation knows them.
    pub(super) fn marginals(&self, settings: &GroupSettings) -> Vec<Vec<f64>> {
        let mut first = vec![0usize];
        for candidates in &self.unary {
            first.push(first[first.len() - 1] + candidates.len());
        }
        let n_labels = first[first.len() - 1];
        if n_labels == 0 {
            return Vec::new();
        }
        let mut unary = vec![IMPOSSIBLE; self.unary.len() * n_labels];
        for (i, candidates) in self.unary.iter().enumerate() {
            let least = least(candidates);
            let row = &mut unary[i * n_labels + first[i]..];
            row.iter_mut().zip(candidates).for_each(|(slot, u)| *slot = (u - least) as f32);
        }
        let (mut distances, mut edges) = (vec![0.0f32; n_labels * n_labels], Vec::new());
        for ([i, j], potentials) in &self.pairwise {
            let (least, width) = (least(potentials), self.unary[*j].len());
            for (at, potential) in potentials.iter().enumerate() {
                let (x, y) = (first[*i] + at / width, first[*j] + at % width);
                let distance = (potential - least).sqrt() as f32;
                distances[x * n_labels + y] = distance;
                distances[y * n_labels + x] = distance;
            }
            edges.push(MetricEdge { ends: [*i as u32, *j as u32], length: 0.0, weight: 1.0 });
        }
        let model = MetricModel::new(distances, unary, edges, TRUNCATION);
        let most = self.unary.iter().map(Vec::len).max().unwrap_or(0);
        let active = model.cheapest(&[], most);
        let options = ActiveOptions {
            semiring: Semiring::Sum,
            iterations: settings.iterations,
            damping: settings.damping,
            tolerance: settings.tolerance,
        };
        let beliefs = model.propagate(&active, &[], &options, |_, _, _| {});
        let marginal = |(i, candidates): (usize, &Vec<f64>)| {
            let mut own = vec![0.0; candidates.len()];
            for (label, belief) in beliefs.active.of(i).iter().zip(beliefs.of(i)) {
                // Variables of fewer candidates than others also have labels of others, which are impossible.
                if let Some(slot) = (*label as usize).checked_sub(first[i]).and_then(|at| own.get_mut(at)) {
                    *slot = f64::from(*belief);
                }
            }
            let sum: f64 = own.iter().sum();
            own.iter_mut().for_each(|p| *p /= sum);
            own
        };
        self.unary.iter().enumerate().map(marginal).collect()
    }
}
