//! Whether an answer can be relied on: the two surfaces show one structure, in one pose, of one handedness.

use super::displacement::DisplacementAnswer;
use super::images::Image;
use crate::poses::compared::{ComparedPose, ComparisonOutcome, Origin};
use crate::surface::moments::AreaMoments;
use crate::surface::side::SurfaceLevel;
use homolog_contract::result::{ReliabilityDocument, UnreliableReason};
use homolog_mesh::{ClosestPoint, SurfaceMesh};

/// Likeness of the shapes below which they may be of different structures. Correlated curvatures increase the likeness.
/// Angular distortion lowers it: a smooth field brings any two shapes close to each other, but unlike shapes only with
/// strong stretching. A small lead over other poses lowers it too.
const MIN_LIKENESS: f64 = 0.41;
const WEIGHT_OF_DISTORTION: f64 = 0.8;
const WEIGHT_OF_LEAD: f64 = 0.3;
/// Most that the lead over other poses of the same handedness counts.
const MAX_LEAD: f64 = 0.3;
/// Contribution of the energy to the likeness of an answer that begins with a near isometry: a weight, times the
/// difference between a neutral energy and the mean energy of a variable, up to a bound.
const WEIGHT_OF_ENERGY: f64 = 0.3;
const NEUTRAL_ENERGY: f64 = 5.2;
const MAX_GAIN_OF_ENERGY: f64 = 0.2;
/// Mean cosine between normals below which surfaces may show different structures.
const MIN_NORMAL_AGREEMENT: f64 = 0.8;
/// Distortion below which normals may disagree: the closest points of thin walls are often on the wrong side of the
/// wall.
const DISTORTION_OF_WALLS: f64 = 0.2;
/// Largest ratio of the lengths of two closed surfaces of one structure. The length is the standard deviation along the
/// first principal axis.
const MAX_LENGTH_RATIO: f64 = 1.5;

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

/// Ratio of the lengths of two closed surfaces, at least 1. It is 1 if one is open, because a region of it may be
/// missing.
fn length_ratio(source: &SurfaceLevel, target: &SurfaceLevel) -> f64 {
    if source.is_open || target.is_open {
        return 1.0;
    }
    let (a, b) = (length_mm(source.mesh()), length_mm(target.mesh()));
    a.max(b) / a.min(b).max(f64::MIN_POSITIVE)
}

/// Standard deviation of the area of `mesh` along its first principal axis, mm; 0 if it is undefined.
fn length_mm(mesh: &SurfaceMesh) -> f64 {
    AreaMoments::of(mesh).map_or(0.0, |moments| moments.variance().symmetric_eigenvalues().max().sqrt())
}

/// Likeness of the two shapes according to an answer of this reliability, about 1 for copies; see [`MIN_LIKENESS`].
pub(crate) fn likeness(found: &ReliabilityDocument) -> f64 {
    let lead = found.runner_up_misfit.map_or(MAX_LEAD, |misfit| misfit - found.misfit).min(MAX_LEAD);
    found.curvature_agreement - WEIGHT_OF_DISTORTION * found.distortion.unwrap_or(0.0) + WEIGHT_OF_LEAD * lead
}

/// Reliability of `found`, an answer for `source` on `target`.
pub(crate) fn reliability(
    found: &DisplacementAnswer,
    source: &SurfaceLevel,
    target: &SurfaceLevel,
) -> ReliabilityDocument {
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
        // Only poses of the same handedness: a symmetric shape fits its mirror image as well, which does not lower its
        // likeness.
        runner_up_misfit: runner_up,
        other_handedness_misfit: mirrored,
        curvature_agreement: found.agreement.curvature,
        normal_agreement: found.agreement.normals,
        distortion: Some(found.distortion),
        residual_mm: found.residual_mm,
        second_opinion: None,
    };
    let mut reasons = Vec::new();
    let normals_disagree = found.agreement.normals < MIN_NORMAL_AGREEMENT && found.distortion >= DISTORTION_OF_WALLS;
    let of_energy = match best.origin {
        Origin::Isometry { mean_energy, .. } => {
            (WEIGHT_OF_ENERGY * (NEUTRAL_ENERGY - mean_energy)).min(MAX_GAIN_OF_ENERGY)
        }
        Origin::Pose(_) | Origin::Straightened(_) => 0.0,
    };
    let unlike = likeness(&answer) + of_energy < MIN_LIKENESS || normals_disagree;
    // Lengths are measured in space, so those of bent surfaces are not compared.
    if unlike || best.origin.is_pose() && length_ratio(source, target) > MAX_LENGTH_RATIO {
        reasons.push(UnreliableReason::UnlikeShape);
    }
    if found.compared[1..].iter().any(|other| other.finer == ComparisonOutcome::Better) {
        reasons.push(UnreliableReason::OtherHandedness);
    }
    let is_rival = |other: &ComparedPose| other.mirrored == best.mirrored && other.finer == ComparisonOutcome::AsGood;
    if found.compared[1..].iter().any(is_rival) {
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
    use homolog_mesh::FaceArity;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_registration::RigidTransform;
    use nalgebra::Vector3;

    #[test]
    fn a_closer_look_at_another_start_decides_whether_an_answer_is_ambiguous() {
        let side = SurfaceLevel::new(&ellipsoid(Vector3::new(6.0, 5.0, 4.0), 2));
        let reasons = |misfit: f64, finer: ComparisonOutcome| {
            let start = |misfit: f64, finer: ComparisonOutcome| ComparedPose {
                origin: Origin::Straightened(RigidTransform::identity()),
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
            let found = reliability(&found, &side, &side);
            assert_eq!(found.runner_up_misfit, Some(misfit));
            found.reasons
        };
        assert!(
            reasons(1.3, ComparisonOutcome::Outdone).is_empty() && reasons(1.3, ComparisonOutcome::Same).is_empty()
        );
        assert_eq!(reasons(1.6, ComparisonOutcome::AsGood), [UnreliableReason::AmbiguousPose]);
    }

    #[test]
    fn normals_that_disagree_tell_structures_apart_but_not_of_thin_walls() {
        let side = SurfaceLevel::new(&ellipsoid(Vector3::new(6.0, 5.0, 4.0), 2));
        let is_reliable = |normals: f64, distortion: f64| {
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
                agreement: Agreement { curvature: 0.85, normals },
                distortion,
            };
            reliability(&found, &side, &side).reliable
        };
        assert!(is_reliable(0.82, 0.3) && !is_reliable(0.78, 0.3) && is_reliable(0.55, 0.1));
    }

    #[test]
    fn a_low_energy_of_near_isometries_speaks_for_one_structure_and_a_high_one_against_it() {
        let side = SurfaceLevel::new(&ellipsoid(Vector3::new(6.0, 5.0, 4.0), 2));
        let is_reliable = |energy: Option<f64>, curvature: f64| {
            let pose = RigidTransform::identity();
            let isometry = |mean_energy| Origin::Isometry { pose, mean_energy };
            let origin = energy.map_or(Origin::Straightened(pose), isometry);
            let best = ComparedPose { origin, mirrored: false, misfit: 1.2, finer: ComparisonOutcome::Undecided };
            let found = DisplacementAnswer {
                images: Vec::new(),
                transform: RigidTransform::identity(),
                compared: vec![best],
                residual_mm: 0.1,
                agreement: Agreement { curvature, normals: 0.9 },
                distortion: 0.5,
            };
            reliability(&found, &side, &side).reliable
        };
        // Without other poses the lead is 0.3, so the likenesses are 0.34, 0.49 and 0.14.
        assert!(!is_reliable(None, 0.65) && is_reliable(Some(4.5), 0.65) && !is_reliable(Some(5.2), 0.65));
        assert!(is_reliable(None, 0.8) && !is_reliable(Some(6.0), 0.8));
        // The lowest energy does not make shapes alike that have nothing in common.
        assert!(!is_reliable(Some(0.0), 0.45));
    }

    #[test]
    fn the_length_is_that_of_the_area_along_the_longest_axis() {
        // On a sphere the variance of a coordinate is a third of the squared radius.
        let sphere = ellipsoid(Vector3::new(6.0, 6.0, 6.0), 4);
        assert!((length_mm(&sphere) - 6.0 / 3f64.sqrt()).abs() < 0.02, "{}", length_mm(&sphere));
        let [short, long] = [12.0, 24.0].map(|x| SurfaceLevel::new(&ellipsoid(Vector3::new(x, 5.0, 4.0), 4)));
        assert!((1.9..2.1).contains(&length_ratio(&short, &long)), "{}", length_ratio(&short, &long));
        assert_eq!(length_ratio(&short, &long), length_ratio(&long, &short));
    }

    #[test]
    fn the_lengths_of_open_surfaces_are_not_compared() {
        let whole = ellipsoid(Vector3::new(12.0, 5.0, 4.0), 3);
        let kept = whole.triangles().into_iter().skip(40).flatten().collect();
        let open = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, kept).unwrap();
        let short = ellipsoid(Vector3::new(6.0, 5.0, 4.0), 3);
        let [whole, open, short] = [whole, open, short].map(|mesh| SurfaceLevel::new(&mesh));
        assert_eq!(length_ratio(&open, &short), 1.0);
        assert!(length_ratio(&whole, &short) > MAX_LENGTH_RATIO);
    }
}
