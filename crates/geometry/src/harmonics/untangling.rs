//! Removes the folds of the initial map: vertices near them move to the weighted mean of their neighbors.
//!
//! With positive weights and a fixed boundary the result is Tutte's embedding of the patch on the sphere, which has no
//! folds if the patch is convex. Patches grow as long as folds remain.

use super::HarmonicsError;
use super::sphere::TargetAreas;
use super::weights::WeightedEdges;
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::Vector3;

/// Share of its target area below which a triangle counts as folded in the first rounds, because it would slow the
/// optimization. Later rounds treat true folds only, because large patches would shrink.
const CRUSHED: f64 = 1e-3;
const CRUSHED_ROUNDS: usize = 6;
/// Largest number of rounds, sweeps per round, and rounds after which patches grow by a ring.
const ROUNDS: usize = 60;
const SWEEPS: usize = 20;
const ROUNDS_A_RING: usize = 3;

/// Moves vertices of `directions` until no triangle is folded or crushed; returns how many were folded initially.
///
/// # Errors
/// [`HarmonicsError::Folded`]; [`HarmonicsError::Cancelled`].
///
/// # Cost
/// `O(n)` per round; an initial map by heat conduction rarely needs more than a few rounds.
pub(super) fn untangle(
    directions: &mut [Vector3<f64>],
    edges: &WeightedEdges,
    areas: &TargetAreas,
    observer: &dyn Observer,
) -> Result<usize, HarmonicsError> {
    let n_folded = areas.smaller_than(0.0, directions).len();
    for round in 0..ROUNDS {
        checkpoint(observer)?;
        let faulty = areas.smaller_than(if round < CRUSHED_ROUNDS { CRUSHED } else { 0.0 }, directions);
        if faulty.is_empty() {
            return Ok(n_folded);
        }
        let patch = patch_around(&faulty, 1 + round / ROUNDS_A_RING, edges, areas);
        for _ in 0..SWEEPS {
            for &k in &patch {
                let mean = edges.neighbors(k).fold(Vector3::zeros(), |s, (j, w)| s + w * directions[j]);
                if let Some(direction) = mean.try_normalize(1e-12) {
                    directions[k] = direction;
                }
            }
        }
    }
    match areas.smaller_than(0.0, directions).len() {
        0 => Ok(n_folded),
        n_triangles => Err(HarmonicsError::Folded { n_triangles }),
    }
}

/// The corners of the triangles `faulty` and all vertices within `rings` edges of them, ascending.
fn patch_around(faulty: &[usize], rings: usize, edges: &WeightedEdges, areas: &TargetAreas) -> Vec<usize> {
    let mut inside = vec![false; areas.n_vertices];
    for &f in faulty {
        areas.triangles[f].iter().for_each(|&k| inside[k] = true);
    }
    for _ in 0..rings {
        let seeds: Vec<usize> = (0..inside.len()).filter(|&k| inside[k]).collect();
        for k in seeds {
            edges.graph.neighbors(k).iter().for_each(|&j| inside[j as usize] = true);
        }
    }
    (0..inside.len()).filter(|&k| inside[k]).collect()
}
