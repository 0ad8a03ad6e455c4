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
/// Potentials of labels that no candidate has, and of candidates of other variables; both have probability 0.
const FILLED_UP: f32 = 1e3;
const OF_OTHERS: f32 = 1e6;

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
        let most = self.unary.iter().map(Vec::len).max().unwrap_or(0);
        let n_labels = self.unary.len() * most;
        if n_labels == 0 {
            return Vec::new();
        }
        // Variables of fewer candidates than others are filled up with labels that nothing is consistent with.
        let mut unary = vec![OF_OTHERS; self.unary.len() * n_labels];
        for (i, candidates) in self.unary.iter().enumerate() {
            let least = least(candidates);
            let row = &mut unary[i * n_labels + i * most..][..most];
            row.fill(FILLED_UP);
            row.iter_mut().zip(candidates).for_each(|(slot, u)| *slot = (u - least) as f32);
        }
        let (mut distances, mut edges) = (vec![TRUNCATION.sqrt(); n_labels * n_labels], Vec::new());
        for ([i, j], potentials) in &self.pairwise {
            let (least, width) = (least(potentials), self.unary[*j].len());
            for (at, potential) in potentials.iter().enumerate() {
                let (x, y) = (i * most + at / width, j * most + at % width);
                let distance = (potential - least).sqrt() as f32;
                distances[x * n_labels + y] = distance;
                distances[y * n_labels + x] = distance;
            }
            edges.push(MetricEdge { ends: [*i as u32, *j as u32], length: 0.0, weight: 1.0 });
        }
        let model = MetricModel::new(distances, unary, edges, TRUNCATION);
        let active = model.cheapest(&[], most);
        let options = ActiveOptions {
            semiring: Semiring::Sum,
            iterations: settings.iterations,
            damping: settings.damping,
            tolerance: 0.0,
        };
        let beliefs = model.propagate(&active, &[], &options, |_, _, _| {});
        let marginal = |(i, candidates): (usize, &Vec<f64>)| {
            let own = beliefs.of(i).iter().take(candidates.len()).map(|&belief| f64::from(belief));
            let sum: f64 = own.clone().sum();
            own.map(|belief| belief / sum).collect()
        };
        self.unary.iter().enumerate().map(marginal).collect()
    }
}
