//! Repairs of a voxel set: the largest piece, and closing tunnels and cavities by a small change.
//!
//! [`fill`] starts from a set with the topology of a ball (a full box, or one voxel) and changes it towards the given
//! set one simple point at a time, which preserves the topology. From the box, voxels far from the given set are
//! removed first; thin membranes across tunnels and around cavities remain. From the deepest voxel, deep voxels are
//! added first; thin cuts through handles remain. Mixtures, which keep small membranes and cut the rest, are tried too.
//! The candidate with the fewest changes is returned.

use super::VoxelMask;
use super::adjacency::{BettiNumbers, LocalTopology, components, flipped, is_well_composed, neighborhood};
use super::distance::squared_distance;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Treatment of voxels that touch along an edge or at a corner only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contacts {
    /// Keeps them: sufficient if the set is filtered before a surface is extracted.
    Allow,
    /// Separates or connects them, so that the boundary of the set is a 2-manifold.
    Resolve,
}

/// A filled set and the changes made.
#[derive(Debug, Clone, PartialEq)]
pub struct FillOutcome {
    /// The set: one piece, no tunnel, no cavity.
    pub mask: VoxelMask,
    /// The changes.
    pub change: FillChange,
}

/// The changes made to fill a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FillChange {
    /// Pieces, tunnels and cavities of the input.
    pub before: BettiNumbers,
    /// Voxels added.
    pub n_added: usize,
    /// Voxels removed.
    pub n_removed: usize,
}

impl FillChange {
    /// Voxels added or removed.
    pub fn n_changed(self) -> usize {
        self.n_added + self.n_removed
    }
}

/// The 6-connected piece with the most voxels (ties go to the first), the number of pieces, and the number of voxels in
/// the other pieces. Cost `O(voxels)`.
pub fn largest_component(mask: &VoxelMask) -> (VoxelMask, usize, usize) {
    let (number, sizes) = components(mask, true);
    let mut best = 0;
    for (k, &size) in sizes.iter().enumerate() {
        if size > sizes[best] {
            best = k;
        }
    }
    let voxels = number.iter().map(|&n| n as usize == best).collect();
    let removed = sizes.iter().sum::<usize>() - sizes.get(best).copied().unwrap_or(0);
    (mask.with_voxels(voxels), sizes.len(), removed)
}

/// A set whose touching pieces were joined.
#[derive(Debug, Clone, PartialEq)]
pub struct JoinOutcome {
    /// The set.
    pub mask: VoxelMask,
    /// Decrease of the number of 6-connected pieces.
    pub n_joined: usize,
    /// Voxels added.
    pub n_added: usize,
}

/// Adds one or two voxels to `mask` wherever two 6-connected pieces touch along an edge or at a corner only, as in a
/// thin oblique part. `None` if no pieces touch.
///
/// Among the voxels that would join two pieces, those with the most face neighbors in the set are added; ties go to the
/// first.
///
/// # Cost
/// `O(voxels)`.
pub fn join_touching(mask: &VoxelMask) -> Option<JoinOutcome> {
    let (mut piece, sizes) = components(mask, true);
    if sizes.len() < 2 {
        return None;
    }
    let mut voxels = mask.voxels.clone();
    let mut joined: Vec<u32> = (0..sizes.len() as u32).collect();
    let (mut n_joined, mut n_added) = (0, 0);
    let strides = mask.strides().map(|s| s as isize);
    let faces = [-strides[2], -strides[1], -strides[0], strides[0], strides[1], strides[2]];
    // Contacts along edges come first: they take one voxel.
    for n_axes in [2, 3] {
        for at in (0..voxels.len()).filter(|&at| mask.voxels[at]) {
            for direction in directions(n_axes) {
                let steps: Vec<isize> =
                    (0..3).filter(|&k| direction[k] != 0).map(|k| isize::from(direction[k]) * strides[k]).collect();
                let other = at.wrapping_add_signed(steps.iter().sum());
                // Voxels of the set are not on the border of the box, so every step stays in it.
                if !mask.voxels[other] || root(&mut joined, piece[at]) == root(&mut joined, piece[other]) {
                    continue;
                }
                let n_neighbors = |k: usize| faces.iter().filter(|&&f| voxels[k.wrapping_add_signed(f)]).count();
                let score = |path: &[usize]| path.iter().map(|&k| n_neighbors(k)).sum::<usize>();
                let Some(path) = paths(at, &steps).into_iter().rev().max_by_key(|path| score(path)) else { continue };
                for k in path {
                    if !std::mem::replace(&mut voxels[k], true) {
                        n_added += 1;
                        piece[k] = piece[at];
                    }
                    // Every piece with a face in common with the new voxel belongs to it.
                    for next in faces.map(|step| k.wrapping_add_signed(step)).into_iter().filter(|&next| voxels[next]) {
                        let (a, b) = (root(&mut joined, piece[k]), root(&mut joined, piece[next]));
                        n_joined += usize::from(a != b);
                        joined[a.max(b) as usize] = a.min(b);
                    }
                }
            }
        }
    }
    (n_joined > 0).then(|| JoinOutcome { mask: mask.with_voxels(voxels), n_joined, n_added })
}

/// Half of the directions in which `n_axes` coordinates change by one; the others are their opposites.
fn directions(n_axes: usize) -> impl Iterator<Item = [i8; 3]> {
    let all = (14..27).map(|k: i8| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1]);
    all.filter(move |d| d.iter().filter(|c| **c != 0).count() == n_axes)
}

/// The voxels between `at` and the end of all `steps`, for each order of the steps.
fn paths(at: usize, steps: &[isize]) -> Vec<Vec<usize>> {
    let to = |at: usize, step: isize| at.wrapping_add_signed(step);
    match *steps {
        [a, b] => vec![vec![to(at, a)], vec![to(at, b)]],
        [a, b, c] => [[a, b], [a, c], [b, a], [b, c], [c, a], [c, b]]
            .into_iter()
            .map(|[first, second]| vec![to(at, first), to(to(at, first), second)])
            .collect(),
        _ => Vec::new(),
    }
}

/// The lowest member of a set, with path halving.
fn root(sets: &mut [u32], mut k: u32) -> u32 {
    while sets[k as usize] != k {
        sets[k as usize] = sets[sets[k as usize] as usize];
        k = sets[k as usize];
    }
    k
}

/// Closes the tunnels and cavities of `mask` by a small change: the result is one piece with the topology of a ball,
/// 6-connected foreground and 26-connected background. `mask` should be one piece; further pieces are joined or lost.
///
/// Finding the smallest change is NP-hard; this returns the smallest of a few candidates.
///
/// # Cost
/// `O(voxels log voxels)`, for each of at most ten candidates.
pub fn fill(mask: &VoxelMask, contacts: Contacts) -> FillOutcome {
    let before = BettiNumbers::of(mask);
    if mask.n_voxels() == 0 || before.is_ball() && (contacts == Contacts::Allow || is_well_composed(mask)) {
        return FillOutcome { mask: mask.clone(), change: FillChange { before, n_added: 0, n_removed: 0 } };
    }
    let filler = Filler::new(mask, contacts);
    let membranes = filler.approach(filler.box_around(), mask.voxels());
    let mut best = membranes.clone();
    let mut best_change = filler.change(&best);
    for goal in filler.mixtures(&membranes) {
        // A mixture removes none of the voxels it has added.
        if filler.change(&goal) >= best_change {
            break;
        }
        let cut = filler.approach(filler.deepest(), &goal);
        let polished = filler.approach(cut, mask.voxels());
        let change = filler.change(&polished);
        if change < best_change {
            (best, best_change) = (polished, change);
        }
    }
    let count = |added: bool| mask.voxels.iter().zip(&best).filter(|&(&was, &is)| was != is && is == added).count();
    let change = FillChange { before, n_added: count(true), n_removed: count(false) };
    FillOutcome { mask: mask.with_voxels(best), change }
}

/// Largest number of mixtures tried, by size of the kept membranes.
const MAX_MIXTURES: usize = 8;

struct Filler<'a> {
    mask: &'a VoxelMask,
    contacts: Contacts,
    local: LocalTopology,
    /// Squared distance of each voxel from the other side of the mask.
    distance: Vec<u32>,
}

impl<'a> Filler<'a> {
    fn new(mask: &'a VoxelMask, contacts: Contacts) -> Self {
        let outside = squared_distance(mask.dims, |k| mask.voxels[k]);
        let inside = squared_distance(mask.dims, |k| !mask.voxels[k]);
        let distance = outside.iter().zip(&inside).map(|(&a, &b)| a.max(b)).collect();
        Filler { mask, contacts, local: LocalTopology::new(), distance }
    }

    /// All voxels except the border of the box.
    fn box_around(&self) -> Vec<bool> {
        (0..self.mask.voxels.len()).map(|k| self.mask.is_inner(k)).collect()
    }

    /// Only the deepest voxel of the mask; ties go to the first.
    fn deepest(&self) -> Vec<bool> {
        let inside = (0..self.distance.len()).filter(|&k| self.mask.voxels[k]);
        let seed = inside.max_by_key(|&k| (self.distance[k], Reverse(k)));
        (0..self.distance.len()).map(|k| Some(k) == seed).collect()
    }

    fn change(&self, voxels: &[bool]) -> usize {
        self.mask.voxels.iter().zip(voxels).filter(|(a, b)| a != b).count()
    }

    /// The mask with a growing selection of the connected pieces of `membranes − mask` added: none, the smallest, then
    /// also larger ones.
    fn mixtures(&self, membranes: &[bool]) -> Vec<Vec<bool>> {
        let added: Vec<bool> = membranes.iter().zip(&self.mask.voxels).map(|(&m, &v)| m && !v).collect();
        let kept = added.iter().map(|a| !a).collect();
        // Components of the complement as background, so that pieces that touch at a corner are connected.
        let (number, sizes) = components(&self.mask.with_voxels(kept), false);
        let mut thresholds: Vec<usize> = sizes.clone();
        thresholds.push(0);
        thresholds.sort_unstable();
        thresholds.dedup();
        thresholds.truncate(MAX_MIXTURES);
        let with = |limit: usize| -> Vec<bool> {
            let small = |k: usize| sizes.get(number[k] as usize).is_some_and(|&size| size <= limit);
            self.mask.voxels.iter().enumerate().map(|(k, &v)| v || added[k] && small(k)).collect()
        };
        thresholds.into_iter().map(with).collect()
    }

    /// `from` changed towards `goal`, voxels far from the boundary of the mask first, with its topology preserved.
    fn approach(&self, from: Vec<bool>, goal: &[bool]) -> Vec<bool> {
        let strides = self.mask.strides();
        let mut set = from;
        let mut queued = vec![false; set.len()];
        let mut queue = BinaryHeap::new();
        for k in 0..set.len() {
            if set[k] != goal[k]
                && self.mask.is_inner(k)
                && strides.iter().any(|&s| set[k - s] != set[k] || set[k + s] != set[k])
            {
                queued[k] = true;
                queue.push((self.distance[k], Reverse(k)));
            }
        }
        while let Some((_, Reverse(k))) = queue.pop() {
            queued[k] = false;
            let block = neighborhood(&set, k, strides);
            let allowed = self.local.is_simple(block)
                && (self.contacts == Contacts::Allow || self.local.is_well_composed(flipped(block)));
            if !allowed {
                continue;
            }
            set[k] = !set[k];
            // Voxels around the changed one may have become simple.
            for plane in [k - strides[2], k, k + strides[2]] {
                for row in [plane - strides[1], plane, plane + strides[1]] {
                    for next in row - 1..=row + 1 {
                        if set[next] != goal[next] && !queued[next] && self.mask.is_inner(next) {
                            queued[next] = true;
                            queue.push((self.distance[next], Reverse(next)));
                        }
                    }
                }
            }
        }
        set
    }
}

#[cfg(test)]
#[path = "repair_tests.rs"]
mod tests;
