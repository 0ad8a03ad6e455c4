//! What both schedules do with one block of lanes: from cavity products to messages not yet scaled.

use super::block_plan::{BlockVariable, LANES};
use super::full_update::{FullPotential, full_max_update, full_sum_update};
use super::options::{BpMethod, BpOptions, Product, Update};
use super::outcome::Decoded;
use super::sparse_update::{Lanes, PairTable, Scratch, cavity_products, max_update, max_update_uniform, sum_update};
use crate::mrf::MrfModel;

/// Everything that a message update reads besides the messages.
#[derive(Clone, Copy)]
pub(super) struct Kernel<'a> {
    pub model: &'a MrfModel,
    pub options: BpOptions,
    pub method: BpMethod,
    pub table: &'a PairTable,
    /// Values of a row of `phi` and of a message.
    pub stride: usize,
    pub phi: &'a [f32],
}

impl Kernel<'_> {
    /// Cavity products of `of` into its lanes of `scratch`, their maxima into `largest`; the decoded belief.
    pub fn cavity(&self, messages: &[f32], of: &BlockVariable, scratch: &mut Scratch, largest: &mut Lanes) -> Decoded {
        let phi = &self.phi[of.variable * self.stride..][..self.stride];
        let best = cavity_products(phi, messages, of, scratch, largest);
        let confidence = if best.sum > 0.0 { f64::from(best.peak / best.sum) } else { 0.0 };
        Decoded { variable: of.variable as u32, label: best.label, confidence }
    }

    /// Messages of all lanes from the cavity products of `scratch`, unscaled, into its `updated`; returns the largest
    /// value of each lane. `(near, far)` are the edge factors and `largest` the maxima of the cavity products.
    pub fn update(&self, (near, far): (&Lanes, &Lanes), largest: &Lanes, scratch: &mut Scratch) -> Lanes {
        // 0 for the hard constraint, a truncation of infinity: pairs outside the neighbourhood then add nothing.
        let epsilon = (-self.model.pairwise.truncation).exp() as f32;
        let Scratch { cavity, updated, dense, .. } = scratch;
        let potential = FullPotential { near, far, epsilon };
        match (self.method.update, self.options.product) {
            (Update::Full, Product::Max) => full_max_update(self.table, cavity, potential, dense, updated),
            (Update::Full, Product::Sum) => full_sum_update(self.table, cavity, potential, dense, updated),
            (Update::Sparse, Product::Sum) => sum_update(self.table, cavity, (near, far), epsilon, updated),
            (Update::Sparse, Product::Max) => {
                let floor = largest.map(|top| top * epsilon);
                if self.model.pairwise.beta == 0.0 {
                    max_update_uniform(self.table, cavity, &floor, updated)
                } else {
                    max_update(self.table, cavity, (near, far), &floor, updated)
                }
            }
        }
    }
}

/// The factors of up to [`LANES`] edges, lane by lane; 0 in lanes without an edge.
pub(super) fn lane_factors(edges: impl Iterator<Item = (f32, f32)>) -> (Lanes, Lanes) {
    let mut factors = ([0.0; LANES], [0.0; LANES]);
    for (lane, (near, far)) in edges.enumerate() {
        (factors.0[lane], factors.1[lane]) = (near, far);
    }
    factors
}
