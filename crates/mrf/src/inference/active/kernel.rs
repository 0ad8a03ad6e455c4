//! The loops over candidates: incoming messages become cavity products, then updated messages, then new messages.
//!
//! Cavity products `h_{i→j}` are computed in rows over the candidates of `i`, then transposed so that eight neighbors
//! `j` lie side by side; both stay in the fastest cache. Every step is the same on every instruction set, in the same
//! order as in the dense engine.

use super::super::lanes::CHAIN_SCALE;
use super::super::message_writer::{Finish, inverse_of};
use super::super::pair_table::{pair_factor, truncated_pair_factor};
use super::plan::{LANES, NearLists};
use multiversion::multiversion;
use wide::f32x4;

/// One number for each of eight neighbors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub(super) struct EightLanes(pub [f32; LANES]);

/// Work space of one thread; grows to the need of the largest variable.
#[derive(Debug, Clone, Default)]
pub(super) struct Scratch {
    /// Products of the first messages, `[number of messages][candidate]`; the last row is the belief.
    forward: Vec<f32>,
    backward: Vec<f32>,
    /// Cavity products, `[neighbor][candidate]`, whole groups of eight neighbors.
    rows: Vec<f32>,
    /// Cavity products of one group, `[candidate][neighbor]`.
    pub cavity: Vec<EightLanes>,
    /// Updated messages before scaling, `[label of the union][neighbor]`.
    pub updated: Vec<EightLanes>,
    /// One updated message over the candidates of its neighbor.
    gathered: Vec<f32>,
}

/// The largest belief of a variable: its number (ties go to the lower label), its value, and the sum of all beliefs in
/// the same scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Peak {
    pub candidate: u32,
    pub value: f32,
    pub sum: f32,
}

impl Scratch {
    /// Computes the belief of a variable and its cavity products towards every neighbor. `phi` and `messages` are rows
    /// over its candidates, padded to a multiple of [`LANES`]; `phi` is 0 in the padding.
    pub(super) fn multiply(&mut self, phi: &[f32], messages: &[&[f32]]) {
        let stride = phi.len();
        let n_rows = messages.len().next_multiple_of(LANES);
        self.forward.resize((messages.len() + 1) * stride, 0.0);
        self.backward.resize(stride, 0.0);
        self.rows.resize(n_rows * stride, 0.0);
        multiply_rows(phi, messages, &mut self.forward, &mut self.backward, &mut self.rows);
    }

    /// Belief over the candidates of the last multiplied variable, in any scale; `phi` as passed there.
    pub(super) fn belief(&self, phi: &[f32]) -> &[f32] {
        &self.forward[self.forward.len() - phi.len()..]
    }

    /// The peak of the belief.
    pub(super) fn peak(&self, phi: &[f32]) -> Peak {
        peak(self.belief(phi))
    }

    /// Transposes the cavity products towards neighbors `first..first + 8`; returns the maximum of each.
    pub(super) fn transpose(&mut self, phi: &[f32], first: usize) -> EightLanes {
        let stride = phi.len();
        self.cavity.resize(stride, EightLanes([0.0; LANES]));
        transpose_rows(&self.rows[first * stride..(first + LANES) * stride], &mut self.cavity)
    }

    /// Scales message `lane` of the last update, over the candidates at `places`, to maximum 1, floors it, and damps it
    /// with `old` into `new`. Returns its largest change.
    pub(super) fn finish(&mut self, lane: usize, places: &[u16], finish: Finish, old: &[f32], new: &mut [f32]) -> f32 {
        self.gathered.clear();
        self.gathered.resize(old.len(), 0.0);
        finish_message(&self.updated, lane, places, finish, &mut self.gathered, old, new)
    }
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn multiply_rows(phi: &[f32], messages: &[&[f32]], forward: &mut [f32], backward: &mut [f32], rows: &mut [f32]) {
    let stride = phi.len();
    for (product, &phi) in forward.iter_mut().zip(phi) {
        *product = phi * CHAIN_SCALE;
    }
    for (slot, message) in messages.iter().enumerate() {
        let (done, open) = forward[slot * stride..].split_at_mut(stride);
        for (product, (&a, &b)) in open.iter_mut().zip(done.iter().zip(*message)) {
            *product = a * b;
        }
    }
    backward.fill(CHAIN_SCALE);
    for (slot, message) in messages.iter().enumerate().rev() {
        let before = &forward[slot * stride..(slot + 1) * stride];
        let row = &mut rows[slot * stride..(slot + 1) * stride];
        for (((product, &before), after), &message) in row.iter_mut().zip(before).zip(backward.iter_mut()).zip(*message)
        {
            *product = before * *after;
            *after *= message;
        }
    }
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn peak(belief: &[f32]) -> Peak {
    let (mut values, mut vectors, mut sums) = ([-1.0f32; LANES], [0u32; LANES], [0.0f32; LANES]);
    for (vector, belief) in belief.as_chunks::<LANES>().0.iter().enumerate() {
        for k in 0..LANES {
            sums[k] += belief[k];
            vectors[k] = if belief[k] > values[k] { vector as u32 } else { vectors[k] };
            values[k] = if belief[k] > values[k] { belief[k] } else { values[k] };
        }
    }
    let mut best = Peak { candidate: u32::MAX, value: -1.0, sum: sums.iter().sum() };
    for k in 0..LANES {
        let candidate = vectors[k] * LANES as u32 + k as u32;
        if values[k] > best.value || (values[k] == best.value && candidate < best.candidate) {
            (best.candidate, best.value) = (candidate, values[k]);
        }
    }
    best
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn transpose_rows(rows: &[f32], transposed: &mut [EightLanes]) -> EightLanes {
    let stride = transposed.len();
    let row = |k: usize| rows[k * stride..(k + 1) * stride].as_chunks::<4>().0;
    for half in [0, 4] {
        let inputs = row(half).iter().zip(row(half + 1)).zip(row(half + 2)).zip(row(half + 3));
        for ([p, q, r, s], (((a, b), c), d)) in transposed.as_chunks_mut::<4>().0.iter_mut().zip(inputs) {
            let [a, b, c, d] = f32x4::transpose([f32x4::from(*a), f32x4::from(*b), f32x4::from(*c), f32x4::from(*d)]);
            p.0[half..half + 4].copy_from_slice(&a.to_array());
            q.0[half..half + 4].copy_from_slice(&b.to_array());
            r.0[half..half + 4].copy_from_slice(&c.to_array());
            s.0[half..half + 4].copy_from_slice(&d.to_array());
        }
    }
    let mut largest = [0.0f32; LANES];
    for h in transposed.iter() {
        for (top, &h) in largest.iter_mut().zip(&h.0) {
            *top = if h > *top { h } else { *top };
        }
    }
    EightLanes(largest)
}

/// `max(floor, max_{x ∈ N_r(y) ∩ C_i} h(x))` for every `y` of the union: max-product without a distance term.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn max_uniform(
    lists: &NearLists<'_>,
    cavity: &[EightLanes],
    floor: &EightLanes,
    updated: &mut [EightLanes],
) {
    let mut start = lists.start as usize;
    for (&end, updated) in lists.ends.iter().zip(updated) {
        let mut best = floor.0;
        for &x in &lists.near[start..end as usize] {
            let h = &cavity[x as usize].0;
            for k in 0..LANES {
                best[k] = if h[k] > best[k] { h[k] } else { best[k] };
            }
        }
        *updated = EightLanes(best);
        start = end as usize;
    }
}

/// Max-product with a distance term; `near` and `far` are the edge factors of each neighbor.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn max_weighted(
    lists: &NearLists<'_>,
    cavity: &[EightLanes],
    (near, far): (&EightLanes, &EightLanes),
    floor: &EightLanes,
    updated: &mut [EightLanes],
) {
    let mut start = lists.start as usize;
    for (&end, updated) in lists.ends.iter().zip(updated) {
        let mut best = floor.0;
        let list = start..end as usize;
        for (&x, &factors) in lists.near[list.clone()].iter().zip(&lists.factors[list]) {
            let h = &cavity[x as usize].0;
            for k in 0..LANES {
                let value = pair_factor((near.0[k], far.0[k]), factors) * h[k];
                best[k] = if value > best[k] { value } else { best[k] };
            }
        }
        *updated = EightLanes(best);
        start = end as usize;
    }
}

/// Sum-product without a distance term: `ε Σ_x h(x) + (1 − ε) Σ_{x ∈ N_r(y) ∩ C_i} h(x)`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn sum_uniform(lists: &NearLists<'_>, cavity: &[EightLanes], epsilon: f32, updated: &mut [EightLanes]) {
    let rest = total(cavity, epsilon);
    let share = 1.0 - epsilon;
    let mut start = lists.start as usize;
    for (&end, updated) in lists.ends.iter().zip(updated) {
        let mut sum = [0.0f32; LANES];
        for &x in &lists.near[start..end as usize] {
            let h = &cavity[x as usize].0;
            for k in 0..LANES {
                sum[k] += h[k];
            }
        }
        for k in 0..LANES {
            sum[k] = rest[k] + share * sum[k];
        }
        *updated = EightLanes(sum);
        start = end as usize;
    }
}

/// Sum-product with a distance term, `ψ` not below `ε`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn sum_weighted(
    lists: &NearLists<'_>,
    cavity: &[EightLanes],
    (near, far): (&EightLanes, &EightLanes),
    epsilon: f32,
    updated: &mut [EightLanes],
) {
    let rest = total(cavity, epsilon);
    let mut start = lists.start as usize;
    for (&end, updated) in lists.ends.iter().zip(updated) {
        let mut sum = rest;
        let list = start..end as usize;
        for (&x, &factors) in lists.near[list.clone()].iter().zip(&lists.factors[list]) {
            let h = &cavity[x as usize].0;
            for k in 0..LANES {
                let psi = truncated_pair_factor((near.0[k], far.0[k]), factors, epsilon);
                sum[k] += (psi - epsilon) * h[k];
            }
        }
        *updated = EightLanes(sum);
        start = end as usize;
    }
}

/// `ε Σ_x h(x)` for every neighbor.
#[inline(always)]
fn total(cavity: &[EightLanes], epsilon: f32) -> [f32; LANES] {
    let mut total = [0.0f32; LANES];
    for h in cavity {
        for (total, &h) in total.iter_mut().zip(&h.0) {
            *total += h;
        }
    }
    total.map(|total| total * epsilon)
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn finish_message(
    updated: &[EightLanes],
    lane: usize,
    places: &[u16],
    finish: Finish,
    gathered: &mut [f32],
    old: &[f32],
    new: &mut [f32],
) -> f32 {
    for (value, &place) in gathered.iter_mut().zip(places) {
        *value = updated[place as usize].0[lane];
    }
    let Finish { floor, damping } = finish;
    let share = 1.0 - damping;
    let mut tops = [0.0f32; LANES];
    for values in gathered.as_chunks::<LANES>().0 {
        for k in 0..LANES {
            tops[k] = if values[k] > tops[k] { values[k] } else { tops[k] };
        }
    }
    let top = tops.iter().fold(0.0f32, |a, &b| if b > a { b } else { a });
    let scale = inverse_of(top, 1.0);
    // A message whose products all vanished carries no information and becomes flat.
    let floor = if scale > 0.0 { floor } else { 1.0 };
    let mut most = [0.0f32; LANES];
    let vectors = gathered.as_chunks::<LANES>().0.iter().zip(old.as_chunks::<LANES>().0);
    for ((values, old), new) in vectors.zip(new.as_chunks_mut::<LANES>().0) {
        for k in 0..LANES {
            let value = values[k] * scale;
            let value = if value > floor { value } else { floor };
            let value = share * value + damping * old[k];
            let step = (value - old[k]).abs();
            most[k] = if step > most[k] { step } else { most[k] };
            new[k] = value;
        }
    }
    most.iter().fold(0.0, |a, &b| if b > a { b } else { a })
}
