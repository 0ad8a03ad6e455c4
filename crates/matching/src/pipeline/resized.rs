//! Surfaces of unlike sizes: the source is also matched scaled to the area of the target.
//!
//! From a rigid pose the field has to shrink or enlarge one surface before anything fits, and may stop in a local
//! minimum on the way. Surfaces of equal area avoid this. But different sizes may also mean that one surface is a part
//! of the other. So both sizes are matched, and the answer with the higher likeness of shapes is taken. An open surface
//! that is smaller than a closed one is taken for a part and keeps its size.

use super::images::find_images;
use super::pose::find_pose;
use super::unseen::StepsOnly;
use crate::answer::displaced::VertexImages;
use crate::answer::reliability;
use crate::error::MatchError;
use crate::pair::part::part;
use crate::pair::role::Role;
use crate::surface::levels::Levels;
use crate::surface::moments::AreaMoments;
use crate::thesis::coarse::prepare_problem;
use homolog_contract::parameters::MatchParameters;
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_primitives::observe::Observer;
use homolog_registration::RigidTransform;
use nalgebra::{Point3, Vector3};

/// Ratio of the roots of the areas, and of the spreads, from which the scaled source is matched too. This test only
/// saves time; the likeness of the shapes decides.
const UNLIKE_SIZES: f64 = 1.25;

/// Largest ratio of the roots of the areas at which an open surface may be a part of a closed one: a tenth of its area.
const MOST_OF_PARTS: f64 = 3.2;

/// The better of `found` and the answer for `source` scaled to the area of `target`, if their sizes differ enough.
///
/// # Errors
/// As [`find_images()`].
///
/// # Cost
/// Another match if the sizes differ, otherwise none.
pub(crate) fn with_rescaled_source(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    found: VertexImages,
    observer: &dyn Observer,
) -> Result<VertexImages, MatchError> {
    let factor = target.full.root_mm / source.full.root_mm;
    let Some(as_they_are) = likeness(&found) else { return Ok(found) };
    let apart = |ratio: f64| ratio.max(1.0 / ratio);
    // Noise enlarges the area but hardly the spread; bending changes the spread but not the area. So both must differ.
    let of_spread = spread_mm(target.full.mesh()) / spread_mm(source.full.mesh());
    let differ = factor.is_finite() && apart(factor).min(apart(of_spread)) >= UNLIKE_SIZES;
    if !differ || is_of_a_part(source, target, factor) {
        return Ok(found);
    }
    let mesh = source.full.mesh();
    let Ok(scaled) = mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()) else {
        return Ok(found);
    };
    let numbering = Numbering::identity(scaled.n_vertices());
    let levels = Levels::observed(&scaled, &numbering, parameters.inference.coarse_vertices, observer)?;
    let mut parameters = parameters.clone();
    for landmark in &mut parameters.landmarks {
        landmark.source_mm = landmark.source_mm.map(|x| x * factor);
    }
    let observer = StepsOnly(observer);
    let coarse = prepare_problem(&levels, target, &parameters, &observer)?;
    let posed = find_pose(&coarse)?;
    let of_equal_area = find_images(&coarse, &posed)?;
    if likeness(&of_equal_area).is_none_or(|likeness| likeness <= as_they_are) {
        return Ok(found);
    }
    let center = center(mesh);
    Ok(of_equal_area.of_original(&levels, |pose| unscaled(pose, factor, &center)))
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

/// Likeness of the shapes according to an answer by a displacement field.
fn likeness(answer: &VertexImages) -> Option<f64> {
    answer.reliability.as_ref().map(reliability::likeness)
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
