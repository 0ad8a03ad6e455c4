//! Operations on one block of lanes of a message update: from cavity products to messages.

use super::block_plan::BlockVariable;
use super::cavity::{CavityTotals, cavity_products};
use super::full_update::{FullPotential, full_max_update, full_sum_update};
use super::label_order::LabelOrder;
use super::lanes::{CHUNK, Lanes};
use super::message_writer::{BlockRows, Finish, write_chunk};
use super::options::{BpOptions, Product, Update};
use super::outcome::Decoded;
use super::pair_table::PairTable;
use super::sparse_update::{
    Scratch, max_chunk, max_steps_but_last, max_update, max_update_uniform, sum_update, sum_update_uniform,
};
use crate::MrfModel;

/// Inputs of a message update besides the messages.
#[derive(Clone, Copy)]
pub(super) struct Kernel<'a> {
    pub model: &'a MrfModel,
    pub options: BpOptions,
    pub update: Update,
    pub order: &'a LabelOrder,
    /// In the order of `order`, like all rows over the labels.
    pub table: &'a PairTable,
    /// Length of a row of `phi` and of a message.
    pub stride: usize,
    pub phi: &'a [f32],
}

impl Kernel<'_> {
    /// Computes the cavity products of the lanes of `variables` into `scratch`; returns their totals. `message` returns
    /// the row of an incoming message.
    pub(super) fn cavity<'m>(
        &self,
        message: impl Fn(u32) -> &'m [f32],
        variables: &[BlockVariable],
        scratch: &mut Scratch,
    ) -> CavityTotals {
        let phi: Vec<&[f32]> = variables.iter().map(|of| self.phi_row(of.variable)).collect();
        let messages: Vec<&[f32]> = variables.iter().flat_map(|of| &of.incoming).map(|&row| message(row)).collect();
        cavity_products(
            (&self.order.negated()[..self.stride], &phi),
            &messages,
            variables,
            (&mut scratch.chains, self.options.product == Product::Sum),
            &mut scratch.cavity[..self.stride],
        )
    }

    /// `φ` of a variable.
    pub(super) fn phi_row(&self, variable: usize) -> &[f32] {
        &self.phi[variable * self.stride..][..self.stride]
    }

    /// The decoded beliefs of the `variables` whose cavity products were computed last.
    pub(super) fn decode<'v>(
        &self,
        variables: &'v [BlockVariable],
        scratch: &Scratch,
    ) -> impl Iterator<Item = (&'v BlockVariable, Decoded)> {
        variables.iter().zip(scratch.chains.peaks()).map(|(of, best)| {
            let confidence = if best.sum > 0.0 { f64::from(best.peak / best.sum) } else { 0.0 };
            (of, Decoded { variable: of.variable as u32, label: best.label, confidence })
        })
    }

    /// Computes the messages of all lanes from the cavity products of `scratch`, unscaled, into its `updated`; returns
    /// the largest value of each lane. `(near, far)` are the edge factors and `totals` the totals of the cavity
    /// products.
    pub(super) fn update(&self, (near, far): (&Lanes, &Lanes), totals: &CavityTotals, scratch: &mut Scratch) -> Lanes {
        let epsilon = self.model.pairwise.epsilon();
        let rest = Lanes(totals.sum.map(|sum| sum * epsilon));
        if self.update == Update::Sparse && self.model.pairwise.beta == 0.0 {
            return match self.options.product {
                Product::Max => {
                    max_update_uniform(self.table, &self.least(totals), scratch);
                    totals.largest
                }
                Product::Sum => sum_update_uniform(self.table, &rest, epsilon, scratch),
            };
        }
        let Scratch { cavity, updated, dense, .. } = scratch;
        let potential = FullPotential { near, far, epsilon };
        match (self.update, self.options.product) {
            (Update::Full, Product::Max) => full_max_update(self.table, cavity, potential, dense, updated),
            (Update::Full, Product::Sum) => full_sum_update(self.table, cavity, potential, dense, updated),
            (Update::Sparse, Product::Sum) => sum_update(self.table, cavity, (near, far), (&rest, epsilon), updated),
            (Update::Sparse, Product::Max) => max_update(self.table, cavity, (near, far), &self.least(totals), updated),
        }
    }

    /// Writes the next messages of all lanes, from the cavity products of `scratch`, into `rows`; returns the largest
    /// change.
    pub(super) fn write(
        &self,
        factors: (&Lanes, &Lanes),
        totals: &CavityTotals,
        scratch: &mut Scratch,
        rows: &mut BlockRows<'_>,
    ) -> f32 {
        let finish = Finish { floor: self.options.floor, damping: self.options.damping };
        let mut change = 0.0f32;
        let starts = (0..self.stride).step_by(CHUNK);
        let sparse_max = (self.update, self.options.product) == (Update::Sparse, Product::Max);
        if sparse_max && self.model.pairwise.beta == 0.0 {
            // The scale is known before the messages: updated values are written while they are in the nearest cache.
            max_steps_but_last(self.table, scratch);
            let floor = self.least(totals);
            for (chunk, start) in starts.enumerate() {
                let updated = &mut scratch.chunk[..CHUNK.min(self.stride - start)];
                max_chunk(&self.table.steps, chunk, &scratch.cavity, &floor, updated);
                change = change.max(write_chunk(updated, start, &totals.largest, finish, rows));
            }
        } else {
            let largest = self.update(factors, totals, scratch);
            for start in starts {
                let updated = &scratch.updated[start..(start + CHUNK).min(self.stride)];
                change = change.max(write_chunk(updated, start, &largest, finish, rows));
            }
        }
        change
    }

    /// Lower bound of max-product messages before scaling.
    fn least(&self, totals: &CavityTotals) -> Lanes {
        let epsilon = self.model.pairwise.epsilon();
        Lanes(totals.largest.map(|top| top * epsilon))
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
