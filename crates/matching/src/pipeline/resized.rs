//! Surfaces of unlike sizes: the source as it is, or scaled to the area of the target.
//!
//! From a rigid pose the field has to shrink or enlarge one surface before anything fits, and may stop in a local
//! minimum on the way. Surfaces of equal area avoid this. But different sizes may also mean that one surface is a part
//! of the other. So the coarse stage of the field is run at both sizes, and the match goes on at the size at which the
//! shapes are more alike. An open surface that is smaller than a closed one is taken for a part and keeps
//! its size.

use super::images::{AfterCoarseStage, find_field_images, find_images};
use super::pose::find_pose;
use super::unseen::UnseenUntilKept;
use crate::answer::displaced::VertexImages;
use crate::error::MatchError;
use crate::pair::part::part;
use crate::pair::problem::MatchProblem;
use crate::pair::role::Role;
use crate::poses::posed::PoseResult;
use crate::surface::levels::Levels;
use crate::surface::moments::AreaMoments;
use crate::thesis::coarse::prepare_problem;
use homolog_contract::parameters::DisplacementMode;
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_registration::RigidTransform;
use nalgebra::{Point3, Vector3};

/// Ratio of the roots of the areas, and of the spreads, from which the scaled source is tried too. This test only saves
/// time; the likeness of the shapes decides.
const UNLIKE_SIZES: f64 = 1.25;

/// Largest ratio of the roots of the areas at which an open surface may be a part of a closed one: a tenth of its area.
const MOST_OF_PARTS: f64 = 3.2;

/// The images of [`find_images()`], of `source` as it is or scaled to the area of `target`.
///
/// # Errors
/// As [`find_images()`].
///
/// # Cost
/// A match; if the sizes differ, also another one up to its coarse stage.
pub(super) fn find_images_at_either_size(
    (source, target): (&Levels, &Levels),
    (coarse, posed): (&MatchProblem<'_>, &PoseResult<'_>),
) -> Result<VertexImages, MatchError> {
    let parameters = coarse.full.parameters;
    let factor = target.full.root_mm / source.full.root_mm;
    let by_field = parameters.displacement.mode == DisplacementMode::Smooth;
    if !by_field || !differ_in_size(source, target, factor) || is_of_a_part(source, target, factor) {
        return find_images(coarse, posed, None);
    }
    let scaled = |as_they_are: f64| {
        let found = find_scaled_images((source, target), factor, coarse, as_they_are)?;
        Ok(found.map_or(AfterCoarseStage::GoOn, |found| AfterCoarseStage::End(Some(Box::new(found)))))
    };
    find_images(coarse, posed, Some(&scaled))
}

/// The images for `source` scaled by `factor`. `None` if the shapes are no more alike than `as_they_are`, or if no field
/// can be fitted.
fn find_scaled_images(
    (source, target): (&Levels, &Levels),
    factor: f64,
    problem: &MatchProblem<'_>,
    as_they_are: f64,
) -> Result<Option<VertexImages>, MatchError> {
    let mesh = source.full.mesh();
    let Ok(scaled) = mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()) else {
        return Ok(None);
    };
    let observer = UnseenUntilKept::new(problem.full.observer);
    let mut parameters = problem.full.parameters.clone();
    for landmark in &mut parameters.landmarks {
        landmark.source_mm = landmark.source_mm.map(|x| x * factor);
    }
    let numbering = Numbering::identity(scaled.n_vertices());
    let levels = Levels::observed(&scaled, &numbering, parameters.inference.coarse_vertices, &observer)?;
    let coarse = prepare_problem(&levels, target, &parameters, &observer)?;
    let posed = find_pose(&coarse)?;
    let decide = |likeness: f64| {
        if likeness <= as_they_are {
            return Ok(AfterCoarseStage::End(None));
        }
        observer.keep();
        Ok(AfterCoarseStage::GoOn)
    };
    let found = find_field_images(&coarse, &posed, &decide)?;
    let center = center(mesh);
    Ok(found.map(|found| found.of_original(&levels, |pose| unscaled(pose, factor, &center))))
}

/// Whether the sizes differ, `factor` from the source to the target. Noise enlarges the area but hardly the spread;
/// bending changes the spread but not the area. So both must differ.
fn differ_in_size(source: &Levels, target: &Levels, factor: f64) -> bool {
    let apart = |ratio: f64| ratio.max(1.0 / ratio);
    let of_spread = spread_mm(target.full.mesh()) / spread_mm(source.full.mesh());
    factor.is_finite() && apart(factor).min(apart(of_spread)) >= UNLIKE_SIZES
}

/// Whether a difference in size, `factor` from the source to the target, is explained by one surface being a part of
/// the other.
fn is_of_a_part(source: &Levels, target: &Levels, factor: f64) -> bool {
    match part(&source.full, &target.full) {
        None => false,
        Some(Role::Source) => (1.0..MOST_OF_PARTS).contains(&factor),
        Some(Role::Target) => (1.0..MOST_OF_PARTS).contains(&(1.0 / factor)),
    }
}

/// The mean of the surface over its area, mm.
fn center(mesh: &SurfaceMesh) -> Vector3<f64> {
    AreaMoments::of(mesh).map_or_else(Vector3::zeros, |moments| moments.mean)
}

/// The root mean square distance of the surface from its mean, mm; 1 if it has no area.
fn spread_mm(mesh: &SurfaceMesh) -> f64 {
    AreaMoments::of(mesh).map_or(1.0, |moments| moments.variance().trace().sqrt())
}

/// The rigid transform with the rotation of `pose` that moves `center` to the place to which `pose` moves it after
/// scaling by `factor`.
fn unscaled(pose: &RigidTransform, factor: f64, center: &Vector3<f64>) -> RigidTransform {
    let at = pose.apply(&Point3::from(center * factor)).coords;
    RigidTransform { rotation: pose.rotation, translation: at - pose.rotation * center }
}
