//! What is measured on a finished match.

use super::prepare::Side;
use super::result::{ConsistencyDocument, SurfaceDistanceDocument, TransformDocument};
use crate::mesh::{ClosestPointIndex, SurfaceMesh};
use crate::mrf::MrfModel;
use crate::registration::RigidTransform;
use nalgebra::Point3;
use rayon::prelude::*;

/// The transform in all its forms.
pub(super) fn transform_document(transform: &RigidTransform) -> TransformDocument {
    let q = transform.quaternion();
    TransformDocument {
        matrix: transform.matrix(),
        rotation_quaternion_wxyz: [q.w, q.i, q.j, q.k],
        rotation_angle_deg: transform.angle_rad().to_degrees(),
        translation_mm: transform.translation.into(),
    }
}

/// Distances of the vertices of both surfaces from the other, the source moved by `transform`.
pub(super) fn surface_distance(
    source: &Side,
    target: &SurfaceMesh,
    target_index: &ClosestPointIndex,
    transform: &RigidTransform,
) -> SurfaceDistanceDocument {
    let moved: Vec<Point3<f64>> = source.mesh().vertices().iter().map(|p| transform.apply(p)).collect();
    let distances = |points: &[Point3<f64>], index: &ClosestPointIndex| -> Vec<f64> {
        points.par_iter().map(|p| (index.closest(p).point - p).norm()).collect()
    };
    let mut all = distances(&moved, target_index);
    // Moved the other way, the target meets the source where it is.
    let back = transform.inverse();
    let returned: Vec<Point3<f64>> = target.vertices().iter().map(|p| back.apply(p)).collect();
    all.extend(distances(&returned, &ClosestPointIndex::new(source.mesh())));
    all.sort_by(f64::total_cmp);
    let at = |share: f64| all[((all.len() - 1) as f64 * share).round() as usize];
    SurfaceDistanceDocument { mean_mm: all.iter().sum::<f64>() / all.len() as f64, p95_mm: at(0.95), max_mm: at(1.0) }
}

/// Topology consistency and coverage of a labeling.
pub(super) fn consistency(model: &MrfModel, labeling: &[u32]) -> ConsistencyDocument {
    let mut edges = 0usize;
    let mut kept = 0usize;
    for i in 0..model.n_variables() {
        for edge in model.variables.row(i) {
            edges += 1;
            let (x, y) = (labeling[i], labeling[model.variables.head(edge)]);
            kept += usize::from(model.labels.distance_within(x as usize, y as usize).is_some());
        }
    }
    let mut hit = vec![false; model.n_labels()];
    for &x in labeling {
        hit[x as usize] = true;
    }
    let covered = hit.iter().filter(|&&h| h).count();
    ConsistencyDocument {
        consistency: kept as f64 / edges.max(1) as f64,
        coverage: covered as f64 / hit.len().max(1) as f64,
    }
}
