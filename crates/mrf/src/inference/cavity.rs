//! Cavity products of one block: `h_{i→j}(x) = φ_i(x) Π_{k ∈ N(i)\j} m_{k→i}(x)` for each of its lanes.
//!
//! The labels are processed in chunks. Forward and backward running products of a variable's messages are combined so
//! that each combination leaves out one message; rows are contiguous and the work stays in registers. The chunk is then
//! transposed, so that the lanes of one label lie side by side. The belief, which is the whole product, is decoded on
//! the way.

use super::block_plan::{BLOCK_LANES, BlockVariable};
use super::lanes::{CHAIN_SCALE, CHUNK, ChunkRow, ChunkRows, LINE_BYTES, Lanes};
use super::vector::{Simd, Vector, WIDTH, dispatch};

/// Number of neighbors up to which all products of a variable are computed at once, in registers.
const FEW: usize = 8;

/// Rows before and after those of a block, for products that the block does not send, of a variable with [`FEW`]
/// neighbors. Writing them too keeps the loop over the neighbors free of branches.
const OVERHANG: usize = FEW - 1;

/// Scratch of the cavity pass.
#[derive(Debug, Clone)]
pub(super) struct Chains {
    /// Products of the first messages of a variable, `[number of messages][label of the chunk]`.
    forward: Vec<ChunkRow>,
    /// Product of the last messages.
    backward: ChunkRow,
    /// Cavity products before they are transposed: [`OVERHANG`] rows, the rows of the lanes, and [`OVERHANG`] rows.
    rows: Box<[ChunkRow; OVERHANG + BLOCK_LANES + OVERHANG]>,
    /// The running peak of every variable of the block.
    beliefs: Vec<RunningPeak>,
}

impl Chains {
    pub(super) fn new() -> Self {
        Chains {
            forward: Vec::new(),
            backward: ChunkRow::splat(0.0),
            rows: Box::new([ChunkRow::splat(0.0); OVERHANG + BLOCK_LANES + OVERHANG]),
            beliefs: Vec::new(),
        }
    }

    /// The peaks of the beliefs of the variables of the last computed block, in its order.
    pub(super) fn peaks(&self) -> impl Iterator<Item = BeliefPeak> {
        self.beliefs.iter().map(RunningPeak::finish)
    }
}

/// The largest belief of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BeliefPeak {
    /// The label of the largest belief; ties go to the lowest label.
    pub label: u32,
    /// The largest belief, in an arbitrary scale.
    pub peak: f32,
    /// Sum of the beliefs over all labels, in the same scale.
    pub sum: f32,
}

/// The cavity products of every lane over all labels. Empty lanes hold arbitrary numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CavityTotals {
    /// Maximum of each lane.
    pub largest: Lanes,
    /// Sum of each lane, label after label; 0 if sums were not requested.
    pub sum: Lanes,
}

dispatch! {
    /// Writes the cavity products of all lanes of a block to `cavity`, label by label, and returns their totals; sums
    /// only if the second part of `scratch` requests them.
    ///
    /// `rows` has the labels of a row, negated, padded with −∞, and the unary factors of every variable of the block.
    /// `messages` has the incoming rows of all variables, one variable after the other. All rows are as long as
    /// `cavity`, a multiple of [`WIDTH`], and the factors are 0 in the padding. Empty lanes hold arbitrary numbers.
    pub(super) fn cavity_products(
        rows: (&[f32], &[&[f32]]),
        messages: &[&[f32]],
        variables: &[BlockVariable],
        scratch: (&mut Chains, bool),
        cavity: &mut [Lanes],
    ) -> CavityTotals = products
}

#[inline(always)]
fn products<S: Simd>(
    simd: S,
    (labels, phi): (&[f32], &[&[f32]]),
    messages: &[&[f32]],
    variables: &[BlockVariable],
    (chains, with_sums): (&mut Chains, bool),
    cavity: &mut [Lanes],
) -> CavityTotals {
    chains.beliefs.clear();
    chains.beliefs.resize(variables.len(), RunningPeak::new());
    let mut totals = CavityTotals { largest: Lanes::splat(0.0), sum: Lanes::splat(0.0) };
    for (chunk, transposed) in cavity.chunks_mut(CHUNK).enumerate() {
        let start = chunk * CHUNK;
        let mut first = 0;
        for (at, of) in variables.iter().enumerate() {
            let incoming = &messages[first..first + of.incoming.len()];
            first += incoming.len();
            let phi = (&labels[start..start + transposed.len()], &phi[at][start..start + transposed.len()]);
            // The degrees of nearly all vertices of triangle and quad meshes.
            match incoming.len() {
                3 => multiply_few::<S, 3>(simd, phi, incoming, (at, of), chains, start),
                4 => multiply_few::<S, 4>(simd, phi, incoming, (at, of), chains, start),
                5 => multiply_few::<S, 5>(simd, phi, incoming, (at, of), chains, start),
                6 => multiply_few::<S, 6>(simd, phi, incoming, (at, of), chains, start),
                7 => multiply_few::<S, 7>(simd, phi, incoming, (at, of), chains, start),
                8 => multiply_few::<S, 8>(simd, phi, incoming, (at, of), chains, start),
                _ => multiply_many(simd, phi, incoming, (at, of), chains, start),
            }
        }
        let Some(rows) = chains.rows[OVERHANG..].first_chunk() else { continue };
        if with_sums {
            transpose_chunk::<S, true>(simd, rows, transposed, &mut totals);
        } else {
            transpose_chunk::<S, false>(simd, rows, transposed, &mut totals);
        }
    }
    totals
}

/// `transposed[x][l] = rows[l][x]` for the labels of `transposed`; also accumulates the totals, with sums if `SUMS`.
#[inline(always)]
fn transpose_chunk<S: Simd, const SUMS: bool>(
    simd: S,
    rows: &ChunkRows,
    transposed: &mut [Lanes],
    totals: &mut CavityTotals,
) {
    for (group, rows) in rows.as_chunks::<WIDTH>().0.iter().enumerate() {
        let lanes = group * WIDTH..(group + 1) * WIDTH;
        let (Some(largest), Some(sums)) =
            (totals.largest[lanes.clone()].first_chunk_mut(), totals.sum[lanes.clone()].first_chunk_mut())
        else {
            continue;
        };
        let (mut top, mut sum) = (simd.load(largest), simd.load(sums));
        let rows: [&[[f32; WIDTH]]; WIDTH] = std::array::from_fn(|l| rows[l].as_chunks().0);
        for (tile, transposed) in transposed.as_chunks_mut::<WIDTH>().0.iter_mut().enumerate() {
            for (half, transposed) in transposed.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                let columns = simd.columns(std::array::from_fn(|l| &rows[l][tile].as_chunks().0[half]));
                for (column, transposed) in columns.into_iter().zip(transposed) {
                    top = column.max(top);
                    if SUMS {
                        sum = sum.add(column);
                    }
                    if let Some(transposed) = transposed[lanes.clone()].first_chunk_mut() {
                        column.store(transposed);
                    }
                }
            }
        }
        top.store(largest);
        sum.store(sums);
    }
}

/// Computes the products of variable number `at` of its block, with `D` neighbors, at most [`FEW`], over one chunk of
/// labels from label `start` on, into the rows from its lane on. Products for neighbors to which the block sends
/// nothing go to the rows before and after. No lane owns those rows if the variable is the first or the last of the
/// block; otherwise the next variable overwrites them.
#[inline(always)]
fn multiply_few<S: Simd, const D: usize>(
    simd: S,
    (labels, phi): (&[f32], &[f32]),
    incoming: &[&[f32]],
    (at, of): (usize, &BlockVariable),
    chains: &mut Chains,
    start: usize,
) {
    let n = phi.len() / WIDTH;
    let messages: [&[[f32; WIDTH]]; D] =
        std::array::from_fn(|slot| &incoming[slot][start..start + phi.len()].as_chunks().0[..n]);
    let Some(rows) = chains.rows[OVERHANG + of.lane - of.slots.start..].first_chunk_mut::<D>() else { return };
    let rows = rows.each_mut().map(|row| &mut row.as_chunks_mut::<WIDTH>().0[..n]);
    let labels = &labels.as_chunks::<WIDTH>().0[..n];
    let scale = simd.splat(CHAIN_SCALE);
    let mut peak = Peak::load(simd, &chains.beliefs[at]);
    for (tile, phi) in phi.as_chunks::<WIDTH>().0.iter().enumerate() {
        if (tile * WIDTH * size_of::<f32>()).is_multiple_of(LINE_BYTES) {
            for row in &messages {
                simd.prefetch(row.as_flattened(), tile * WIDTH + CHUNK);
            }
        }
        let mut product = simd.load(phi).mul(scale);
        let mut before = [product; D];
        for slot in 0..D {
            before[slot] = product;
            product = product.mul(simd.load(&messages[slot][tile]));
        }
        peak.add(product, simd.load(&labels[tile]));
        let mut after = scale;
        for slot in (0..D).rev() {
            before[slot].mul(after).store(&mut rows[slot][tile]);
            after = after.mul(simd.load(&messages[slot][tile]));
        }
    }
    peak.store(&mut chains.beliefs[at]);
}

/// The same for any number of neighbors, restricted to those to which the block sends.
#[inline(always)]
fn multiply_many<S: Simd>(
    simd: S,
    (labels, phi): (&[f32], &[f32]),
    incoming: &[&[f32]],
    (at, of): (usize, &BlockVariable),
    chains: &mut Chains,
    start: usize,
) {
    let length = phi.len();
    let Chains { forward, backward, rows, beliefs } = chains;
    if forward.len() <= incoming.len() {
        forward.resize(incoming.len() + 1, ChunkRow::splat(0.0));
    }
    for (product, &phi) in forward[0].iter_mut().zip(phi) {
        *product = phi * CHAIN_SCALE;
    }
    let message = |slot: usize| incoming[slot][start..start + length].as_chunks::<WIDTH>().0;
    for slot in 0..incoming.len() {
        let (done, open) = forward.split_at_mut(slot + 1);
        let factors = done[slot].as_chunks().0.iter().zip(message(slot));
        for (product, (so_far, factor)) in open[0].as_chunks_mut().0.iter_mut().zip(factors) {
            simd.load(so_far).mul(simd.load(factor)).store(product);
        }
    }
    let mut peak = Peak::load(simd, &beliefs[at]);
    for (belief, labels) in forward[incoming.len()][..length].as_chunks().0.iter().zip(labels.as_chunks().0) {
        peak.add(simd.load(belief), simd.load(labels));
    }
    peak.store(&mut beliefs[at]);
    backward.fill(CHAIN_SCALE);
    for slot in (of.slots.start..incoming.len()).rev() {
        if slot < of.slots.end {
            let row = &mut rows[OVERHANG + of.lane + slot - of.slots.start][..length];
            for (product, (&a, &b)) in row.iter_mut().zip(forward[slot].iter().zip(backward.iter())) {
                *product = a * b;
            }
        }
        for (product, factor) in backward.as_chunks_mut().0.iter_mut().zip(message(slot)) {
            simd.load(product).mul(simd.load(factor)).store(product);
        }
    }
}

/// Running peak of a belief, [`WIDTH`] labels at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RunningPeak {
    peaks: [f32; WIDTH],
    /// The label of each of these peaks, negated.
    labels: [f32; WIDTH],
    sums: [f32; WIDTH],
}

impl RunningPeak {
    fn new() -> Self {
        RunningPeak { peaks: [-1.0; WIDTH], labels: [f32::NEG_INFINITY; WIDTH], sums: [0.0; WIDTH] }
    }

    fn finish(&self) -> BeliefPeak {
        let (mut peak, mut label) = (self.peaks[0], self.labels[0]);
        for k in 1..WIDTH {
            if self.peaks[k] > peak || (self.peaks[k] == peak && self.labels[k] > label) {
                (peak, label) = (self.peaks[k], self.labels[k]);
            }
        }
        BeliefPeak { label: -label as u32, peak, sum: self.sums.iter().sum() }
    }
}

/// Running peak in registers.
#[derive(Clone, Copy)]
struct Peak<V> {
    peaks: V,
    labels: V,
    sums: V,
}

impl<V: Vector> Peak<V> {
    #[inline(always)]
    fn load(simd: impl Simd<Vector = V>, from: &RunningPeak) -> Self {
        Peak { peaks: simd.load(&from.peaks), labels: simd.load(&from.labels), sums: simd.load(&from.sums) }
    }

    #[inline(always)]
    fn store(self, to: &mut RunningPeak) {
        self.peaks.store(&mut to.peaks);
        self.labels.store(&mut to.labels);
        self.sums.store(&mut to.sums);
    }

    /// Takes the beliefs of some labels. Labels are negated, so the larger number is the lower label.
    #[inline(always)]
    fn add(&mut self, beliefs: V, labels: V) {
        let of_equal = labels.max(self.labels);
        let if_not_above = self.peaks.choose_if_above(beliefs, self.labels, of_equal);
        self.sums = self.sums.add(beliefs);
        self.labels = beliefs.choose_if_above(self.peaks, labels, if_not_above);
        self.peaks = beliefs.max(self.peaks);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Also for the first and the last variable of a block, which sends only some of their messages, and in both
        /// kinds of loop.
        #[test]
        fn cavity_products_leave_out_one_message_and_peaks_none(
            degrees in prop::collection::vec(1usize..12, 1..9),
            before in 0usize..12,
            vectors in 1usize..20,
            entropy in prop::collection::vec(0.01f32..1.0, 389),
        ) {
            let stride = vectors * super::super::block_plan::LANES;
            let mut numbers = entropy.iter().copied().cycle();
            let mut rows = |n: usize| (0..n).map(|_| numbers.by_ref().take(stride).collect()).collect::<Vec<Vec<f32>>>();
            let (mut variables, mut messages, mut start, mut lane) = (Vec::new(), Vec::new(), before % degrees[0], 0);
            for (variable, &degree) in degrees.iter().enumerate() {
                let slots = start..degree.min(start + BLOCK_LANES - lane);
                start = 0;
                if !slots.is_empty() {
                    lane += slots.len();
                    variables.push(BlockVariable { variable, incoming: vec![0; degree], lane: lane - slots.len(), slots });
                    messages.push(rows(degree));
                }
            }
            let phi = rows(variables.len());
            let mut cavity = vec![Lanes::splat(0.0); stride];
            let mut chains = Chains::new();
            // Labels in reverse order; the last place has no label.
            let n = stride - 1;
            let labels: Vec<f32> = (0..n).rev().map(|x| -(x as f32)).chain([f32::NEG_INFINITY]).collect();
            let phi: Vec<Vec<f32>> = phi.into_iter().map(|row| [&row[..n], &[0.0]].concat()).collect();
            let CavityTotals { largest, sum } = cavity_products(
                (&labels, &phi.iter().map(Vec::as_slice).collect::<Vec<_>>()),
                &messages.iter().flatten().map(Vec::as_slice).collect::<Vec<_>>(),
                &variables,
                (&mut chains, true),
                &mut cavity,
            );
            let found: Vec<BeliefPeak> = chains.peaks().collect();
            prop_assert_eq!(found.len(), variables.len());
            let scale = f64::from(CHAIN_SCALE);
            for (((of, phi), messages), found) in variables.iter().zip(&phi).zip(&messages).zip(found) {
                let product = |x: usize, without: usize| {
                    let others = messages.iter().enumerate().filter(|(k, _)| *k != without);
                    f64::from(phi[x]) * others.map(|(_, message)| f64::from(message[x])).product::<f64>() * scale
                };
                for (lane, slot) in (of.lane..).zip(of.slots.clone()) {
                    for (x, h) in cavity.iter().enumerate() {
                        let product = product(x, slot) * scale;
                        prop_assert!((f64::from(h[lane]) - product).abs() <= 2e-6 * product);
                    }
                    prop_assert_eq!(largest[lane], cavity.iter().fold(0.0, |top, h| h[lane].max(top)));
                    prop_assert_eq!(sum[lane], cavity.iter().fold(0.0, |sum, h| sum + h[lane]));
                }
                let beliefs: Vec<f64> = (0..stride).map(|x| product(x, usize::MAX)).collect();
                let (peak, sum) = (beliefs.iter().copied().fold(0.0, f64::max), beliefs.iter().sum::<f64>());
                prop_assert!((f64::from(found.peak) - peak).abs() <= 2e-6 * peak);
                prop_assert!((beliefs[n - 1 - found.label as usize] - peak).abs() <= 2e-6 * peak);
                prop_assert!((f64::from(found.sum) - sum).abs() <= 1e-4 * sum);
            }
        }
    }
}
