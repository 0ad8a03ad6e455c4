//! The map from the target back to the source.

use super::displaced::{Images, VertexImages};
use crate::pair::scene::Scene;
use homolog_contract::result::{Correspondences, OutlierReason};
use homolog_mesh::ClosestPointIndex;
use rayon::prelude::*;

/// For every vertex of the target the closest point of the moved source, as a point of the source, in the numbering of
/// the inputs. Confidence and spread are interpolated from the source vertices around it. `None` if a coordinate of the
/// moved source is not finite.
///
/// Cost `O(n' log n)`.
pub(crate) fn inverse(scene: &Scene<'_>, answer: &VertexImages) -> Option<Correspondences> {
    let source = scene.source.mesh();
    let moved = match &answer.images {
        Images::Smooth(smooth) => smooth.moved.clone(),
        Images::OnVertices => source.vertices().iter().map(|p| answer.transform.apply(p)).collect(),
    };
    let index = ClosestPointIndex::new(&source.with_vertices(moved).ok()?);
    let target = scene.target.mesh().vertices();
    let found: Vec<_> = target.par_iter().map(|q| index.closest(q)).collect();
    let rows = scene.target.surface.numbering.by_original();
    let original = |k: u32| scene.source.surface.numbering.original(k);
    let blended = |values: &[f64], i: usize| -> f64 { found[i].blend(|k| values[k]) };
    let vertex = |i: usize| found[i].nearest_corner();
    let residual = |i: usize| (answer.transform.apply(&source.vertices()[vertex(i) as usize]) - target[i]).norm();
    let inlier: Vec<bool> = rows.iter().map(|&(_, i)| residual(i) <= scene.tolerance_mm).collect();
    Some(Correspondences {
        source: rows.iter().map(|r| r.0).collect(),
        target: rows.iter().map(|&(_, i)| original(vertex(i))).collect(),
        confidence: rows.iter().map(|&(_, i)| blended(&answer.confidence, i)).collect(),
        spread_mm: rows.iter().map(|&(_, i)| blended(&answer.spread_mm, i)).collect(),
        outlier: inlier.iter().map(|&i| if i { OutlierReason::None } else { OutlierReason::Residual }).collect(),
        inlier,
        triangle: rows.iter().map(|&(_, i)| found[i].triangle.map(original)).collect(),
        barycentric: rows.iter().map(|&(_, i)| found[i].barycentric).collect(),
        inverse: None,
    })
}
