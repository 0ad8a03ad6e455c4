//! A target vertex for every source vertex.

use super::scene::Scene;
use homolog_mrf::Labeling;
use homolog_mrf::inference::belief_spread;
use homolog_primitives::graph::LabelNeighborhoods;
use homolog_registration::RigidTransform;
use rayon::prelude::*;

/// Distance from the closest triangle, in edges, up to which a vertex may be the label.
const RINGS: usize = 1;

/// A target vertex for every source vertex, in canonical numbering of one level.
#[derive(Clone)]
pub(crate) struct VertexMap {
    pub labeling: Labeling,
    /// Probability of each label, or an estimate of it in `[0, 1]`.
    pub confidence: Vec<f64>,
    /// Root mean square distance of each belief from its mean, mm; 0 for minimizers without beliefs.
    pub spread_mm: Vec<f64>,
}

impl VertexMap {
    /// For every source vertex the nearest vertex of the target after the transform, with confidence and spread under
    /// `p(x) ∝ exp(−d²/2σ²)` over the vertices around it; `σ` is the root mean square distance of the surfaces.
    ///
    /// Cost `O(n log n')`.
    pub(crate) fn nearest(scene: &Scene<'_>, transform: &RigidTransform) -> VertexMap {
        let target = scene.target.mesh().vertices();
        let around = LabelNeighborhoods::new(&scene.target.mesh().edge_graph(), RINGS, |_, _| 0.0);
        let moved: Vec<_> = scene.source.mesh().vertices().iter().map(|p| transform.apply(p)).collect();
        let closest: Vec<_> = moved.par_iter().map(|p| scene.closest.index.closest(p)).collect();
        let squares: f64 = moved.iter().zip(&closest).map(|(p, found)| (found.point - p).norm_squared()).sum();
        // The distance of copies is 0; vertices are told apart no better than by half an edge.
        let sigma = (squares / moved.len() as f64).sqrt().max(0.5 * scene.edge_mm);
        let rows: Vec<(u32, f64, f64)> = moved
            .par_iter()
            .zip(&closest)
            .map(|(p, found)| {
                let mut candidates: Vec<u32> =
                    found.triangle.iter().flat_map(|&x| around.members(x as usize)).copied().collect();
                candidates.sort_unstable();
                candidates.dedup();
                let squared = |x: u32| (target[x as usize] - p).norm_squared();
                let best = candidates
                    .iter()
                    .copied()
                    .fold(found.triangle[0], |best, x| if squared(x) < squared(best) { x } else { best });
                let weights: Vec<f32> = candidates
                    .iter()
                    .map(|&x| ((squared(best) - squared(x)) / (2.0 * sigma * sigma)).exp() as f32)
                    .collect();
                let positions: Vec<_> = candidates.iter().map(|&x| target[x as usize]).collect();
                let sum: f32 = weights.iter().sum();
                (best, f64::from(1.0 / sum), belief_spread(&weights, &positions))
            })
            .collect();
        VertexMap {
            labeling: rows.iter().map(|r| r.0).collect(),
            confidence: rows.iter().map(|r| r.1).collect(),
            spread_mm: rows.iter().map(|r| r.2).collect(),
        }
    }
}
