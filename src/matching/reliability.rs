//! Whether an answer can be relied on: do the two surfaces show one structure, in one pose, of one handedness?

use super::displacement::{DisplacementAnswer, Image};
use super::result::{ReliabilityDocument, UnreliableReason};
use crate::mesh::{ClosestPoint, SurfaceMesh};

/// Correlation of curvatures below which surfaces may show different structures. Two hippocampi have 0.65 and more, an
/// ellipsoid and a hippocampus 0.33 to 0.61, copies of which one has noise of 2 % of its diagonal 0.48 to 0.6.
const MIN_CURVATURE_AGREEMENT: f64 = 0.62;
/// Mean cosine between normals below which they may.
const MIN_NORMAL_AGREEMENT: f64 = 0.8;
/// They do unless the pose fits better than any other by this much, as one structure does through noise: there it was
/// 0.08 and more, with the ellipsoid 0.03 at most.
const CLEAR: f64 = 0.06;
/// A pose that fits no worse than by this much is another answer.
const AMBIGUITY: f64 = 0.01;
/// What an unreliable answer's confidences are multiplied by.
pub(super) const UNRELIABLE_CONFIDENCE: f64 = 0.1;

/// Mean target edges beyond which an image has left the target, and at a boundary, where the surface ends, so soon.
const AWAY_EDGES: f64 = 4.0;
const AWAY_EDGES_AT_BOUNDARY: f64 = 1.0;

/// For every image whether the target, of mean edge length `edge_mm`, has nothing there.
pub(super) fn without_counterpart(target: &SurfaceMesh, edge_mm: f64, images: &[Image]) -> Vec<bool> {
    let on_boundary = target.boundary_vertices();
    let at_end = |at: &ClosestPoint| {
        let ends = |k: usize| on_boundary.as_ref().is_some_and(|b| b[at.triangle[k] as usize]);
        // Within the rim: on an edge or a corner of it.
        (0..3).all(|k| ends(k) || at.barycentric[k] < 1e-6)
    };
    let away = |image: &Image| {
        let distance = (image.moved - image.closest.point).norm();
        let limit = if at_end(&image.closest) { AWAY_EDGES_AT_BOUNDARY } else { AWAY_EDGES };
        distance > limit * edge_mm
    };
    images.iter().map(away).collect()
}

/// What `found` says of its own reliability.
pub(super) fn reliability(found: &DisplacementAnswer) -> ReliabilityDocument {
    let best = found.judged[0];
    let of = |mirrored: bool| {
        let others = found.judged[1..].iter().filter(|j| j.mirrored == mirrored).map(|j| j.misfit);
        others.fold(None, |least: Option<f64>, m| Some(least.map_or(m, |l| l.min(m))))
    };
    let (runner_up, mirrored) = (of(best.mirrored), of(!best.mirrored));
    let mut reasons = Vec::new();
    let unlike = found.agreement.curvature < MIN_CURVATURE_AGREEMENT || found.agreement.normals < MIN_NORMAL_AGREEMENT;
    let clear = [runner_up, mirrored].into_iter().flatten().all(|m| m > best.misfit + CLEAR);
    if unlike && !clear {
        reasons.push(UnreliableReason::UnlikeShape);
    }
    if mirrored.is_some_and(|m| m < best.misfit) {
        reasons.push(UnreliableReason::OtherHandedness);
    }
    if runner_up.is_some_and(|m| m < best.misfit + AMBIGUITY) {
        reasons.push(UnreliableReason::AmbiguousPose);
    }
    ReliabilityDocument {
        reliable: reasons.is_empty(),
        reasons,
        misfit: best.misfit,
        runner_up_misfit: runner_up,
        other_handedness_misfit: mirrored,
        curvature_agreement: found.agreement.curvature,
        normal_agreement: found.agreement.normals,
        residual_mm: found.residual_mm,
    }
}
