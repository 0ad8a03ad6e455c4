//! What both schedules do with one block of lanes: from cavity products to messages not yet scaled.

use super::block_plan::BlockVariable;
use super::cavity::cavity_products;
use super::full_update::{FullPotential, full_max_update, full_sum_update};
use super::lanes::Lanes;
use super::options::{BpMethod, BpOptions, Product, Update};
use super::outcome::Decoded;
use super::sparse_update::{PairTable, Scratch, max_update, max_update_uniform, sum_update, sum_update_uniform};
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
    /// Cavity products of the lanes of `variables` into `scratch`; returns their maxima. `message` is the row of an
    /// incoming message.
    pub fn cavity<'m>(
        &self,
        message: impl Fn(u32) -> &'m [f32],
        variables: &[BlockVariable],
        scratch: &mut Scratch,
    ) -> Lanes {
        let phi: Vec<&[f32]> =
            variables.iter().map(|of| &self.phi[of.variable * self.stride..][..self.stride]).collect();
        let messages: Vec<&[f32]> = variables.iter().flat_map(|of| &of.incoming).map(|&row| message(row)).collect();
        cavity_products(&phi, &messages, variables, &mut scratch.chains, &mut scratch.cavity)
    }

    /// The decoded beliefs of the `variables` whose cavity products were computed last.
    pub fn decode<'v>(
        &self,
        variables: &'v [BlockVariable],
        scratch: &Scratch,
    ) -> impl Iterator<Item = (&'v BlockVariable, Decoded)> {
        variables.iter().zip(scratch.chains.peaks()).map(|(of, best)| {
            let confidence = if best.sum > 0.0 { f64::from(best.peak / best.sum) } else { 0.0 };
            (of, Decoded { variable: of.variable as u32, label: best.label, confidence })
        })
    }

    /// Messages of all lanes from the cavity products of `scratch`, unscaled, into its `updated`; returns the largest
    /// value of each lane. `(near, far)` are the edge factors and `largest` the maxima of the cavity products.
    pub fn update(&self, (near, far): (&Lanes, &Lanes), largest: &Lanes, scratch: &mut Scratch) -> Lanes {
        // 0 for the hard constraint, a truncation of infinity: pairs outside the neighbourhood then add nothing.
        let epsilon = (-self.model.pairwise.truncation).exp() as f32;
        let floor = Lanes(largest.map(|top| top * epsilon));
        if self.method.update == Update::Sparse && self.model.pairwise.beta == 0.0 {
            return match self.options.product {
                Product::Max => {
                    max_update_uniform(self.table, &floor, scratch);
                    *largest
                }
                Product::Sum => sum_update_uniform(self.table, &scratch.cavity, epsilon, &mut scratch.updated),
            };
        }
        let Scratch { cavity, updated, dense, .. } = scratch;
        let potential = FullPotential { near, far, epsilon };
        match (self.method.update, self.options.product) {
            (Update::Full, Product::Max) => full_max_update(self.table, cavity, potential, dense, updated),
            (Update::Full, Product::Sum) => full_sum_update(self.table, cavity, potential, dense, updated),
            (Update::Sparse, Product::Sum) => sum_update(self.table, cavity, (near, far), epsilon, updated),
            (Update::Sparse, Product::Max) => max_update(self.table, cavity, (near, far), &floor, updated),
        }
    }
}

/// The factors of the edges of a block, lane by lane; 0 in lanes without an edge.
pub(super) fn lane_factors(edges: impl Iterator<Item = (f32, f32)>) -> (Lanes, Lanes) {
    let mut factors = (Lanes::splat(0.0), Lanes::splat(0.0));
    for (lane, (near, far)) in edges.enumerate() {
        (factors.0[lane], factors.1[lane]) = (near, far);
    }
    factors
}
