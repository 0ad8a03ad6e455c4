//! Whether an answer can be relied on: the two surfaces show one structure, in one pose, of one handedness.

use super::displacement::DisplacementAnswer;
use super::images::Image;
use crate::poses::compared::ComparisonOutcome;
use homolog_contract::result::{ReliabilityDocument, UnreliableReason};
use homolog_mesh::{ClosestPoint, SurfaceMesh};

/// Likeness of the shapes ([`likeness`](crate::field::agreement::Agreement::likeness)) below which they may be of
/// different structures.
const MIN_LIKENESS: f64 = 0.16;

/// Distance from the target, in mean target edges, beyond which an image has no counterpart; the second value holds at
/// a boundary.
const AWAY_EDGES: f64 = 4.0;
const AWAY_EDGES_AT_BOUNDARY: f64 = 1.0;

/// For every image whether the target, of mean edge length `edge_mm`, has no surface there.
pub(crate) fn without_counterpart(target: &SurfaceMesh, edge_mm: f64, images: &[Image]) -> Vec<bool> {
    let on_boundary = target.boundary_vertices();
    let at_end = |at: &ClosestPoint| on_boundary.as_ref().is_some_and(|ends| at.is_between(|k| ends[k]));
    let away = |image: &Image| {
        let distance = (image.moved - image.closest.point).norm();
        let limit = if at_end(&image.closest) { AWAY_EDGES_AT_BOUNDARY } else { AWAY_EDGES };
        distance > limit * edge_mm
    };
    images.iter().map(away).collect()
}

/// Reliability of `found`.
pub(crate) fn reliability(found: &DisplacementAnswer) -> ReliabilityDocument {
    let best = found.compared[0];
    let of = |mirrored: bool| {
        let others = found.compared[1..].iter().filter(|j| j.mirrored == mirrored).map(|j| j.misfit);
        others.fold(None, |least: Option<f64>, m| Some(least.map_or(m, |l| l.min(m))))
    };
    let (runner_up, mirrored) = (of(best.mirrored), of(!best.mirrored));
    let mut answer = ReliabilityDocument {
        reliable: true,
        reasons: Vec::new(),
        misfit: best.misfit,
        runner_up_misfit: runner_up,
        other_handedness_misfit: mirrored,
        curvature_agreement: found.agreement.curvature,
        normal_agreement: found.agreement.normals,
        distortion: Some(found.distortion),
        residual_mm: found.residual_mm,
        second_opinion: None,
    };
    let mut reasons = Vec::new();
    if found.agreement.likeness(found.distortion) < MIN_LIKENESS {
        reasons.push(UnreliableReason::UnlikeShape);
    }
    if found.compared[1..].iter().any(|other| other.finer == ComparisonOutcome::Better) {
        reasons.push(UnreliableReason::OtherHandedness);
    }
    if found.compared[1..].iter().any(|other| other.is_as_good_as(&best)) {
        reasons.push(UnreliableReason::AmbiguousPose);
    }
    answer.reliable = reasons.is_empty();
    answer.reasons = reasons;
    answer
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::agreement::Agreement;
    use crate::poses::compared::{ComparedPose, Origin};
    use homolog_registration::RigidTransform;

    #[test]
    fn a_closer_look_at_another_start_decides_whether_an_answer_is_ambiguous() {
        let reasons = |misfit: f64, finer: ComparisonOutcome| {
            let start = |misfit: f64, finer: ComparisonOutcome| ComparedPose {
                origin: Origin::Bent(RigidTransform::identity()),
                mirrored: false,
                misfit,
                finer,
            };
            let found = DisplacementAnswer {
                images: Vec::new(),
                transform: RigidTransform::identity(),
                compared: vec![start(1.4, ComparisonOutcome::Undecided), start(misfit, finer)],
                residual_mm: 0.1,
                agreement: Agreement { curvature: 0.9, normals: 0.95 },
                distortion: 0.2,
            };
            let found = reliability(&found);
            assert_eq!(found.runner_up_misfit, Some(misfit));
            found.reasons
        };
        assert!(
            reasons(1.3, ComparisonOutcome::Outdone).is_empty() && reasons(1.3, ComparisonOutcome::Same).is_empty()
        );
        assert_eq!(reasons(1.6, ComparisonOutcome::AsGood), [UnreliableReason::AmbiguousPose]);
    }

    #[test]
    fn shapes_are_unlike_if_the_map_distorts_about_as_much_as_curvatures_agree() {
        let is_reliable = |curvature: f64, distortion: f64| {
            let best = ComparedPose {
                origin: Origin::Pose(0),
                mirrored: false,
                misfit: 1.2,
                finer: ComparisonOutcome::Undecided,
            };
            let found = DisplacementAnswer {
                images: Vec::new(),
                transform: RigidTransform::identity(),
                compared: vec![best],
                residual_mm: 0.1,
                agreement: Agreement { curvature, normals: 0.95 },
                distortion,
            };
            reliability(&found).reliable
        };
        // Two subjects; noisy copies; a hippocampus and a putamen; structures that have nothing in common.
        assert!(is_reliable(0.78, 0.38) && is_reliable(0.55, 0.1));
        assert!(!is_reliable(0.69, 0.58) && !is_reliable(0.1, 0.9));
    }
}
