//! Surfaces of unlike sizes: the source is also matched scaled to the area of the target.
//!
//! From a rigid pose the field has to shrink or swell one surface before anything fits, and what it finds on the way may hold it.
//! Between surfaces of equal area there is nothing to swell. That the sizes differ does not say which is right, though: one of the two may
//! be a part of the other. So both are matched, and the answer under which the shapes are more alike is taken. An open surface that is smaller than a
//! closed one is a part, at its size.

use super::images::displaced;
use super::pose::posed;
use super::unseen::Unseen;
use crate::answer::displaced::Displaced;
use crate::answer::reliability;
use crate::error::MatchError;
use crate::pair::part::part;
use crate::pair::role::Role;
use crate::surface::levels::Levels;
use crate::surface::moments::AreaMoments;
use crate::thesis::coarse::coarse;
use homolog_contract::parameters::MatchParameters;
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_primitives::observe::Observer;
use homolog_registration::RigidTransform;
use nalgebra::{Point3, Vector3};

/// Ratio of the roots of two areas, and of the distances from the center, from which that is tried. It saves time: the likeness of the
/// shapes decides.
const UNLIKE_SIZES: f64 = 1.25;

/// Ratio of the roots of two areas up to which an open surface may be a part of a closed one: a tenth of its area.
const MOST_OF_PARTS: f64 = 3.2;

/// The better of `found` and the answer for `source` scaled to the area of `target`, if their sizes differ that much.
///
/// # Errors
/// As [`displaced()`].
///
/// # Cost
/// That of another match where the sizes differ, else none.
pub(crate) fn resized(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    found: Displaced,
    observer: &dyn Observer,
) -> Result<Displaced, MatchError> {
    let factor = target.full.root_mm / source.full.root_mm;
    let Some(as_they_are) = likeness(&found) else { return Ok(found) };
    let apart = |ratio: f64| ratio.max(1.0 / ratio);
    // Noise makes an area larger, and hardly the distances through space; bending changes these and no area.
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
    let observer = Unseen(observer);
    let coarse = coarse(&levels, target, &parameters, &observer)?;
    let posed = posed(&coarse)?;
    let of_equal_area = displaced(&coarse, &posed)?;
    if likeness(&of_equal_area).is_none_or(|likeness| likeness <= as_they_are) {
        return Ok(found);
    }
    let center = center(mesh);
    Ok(of_equal_area.of_original(&levels, |pose| unscaled(pose, factor, &center)))
}

/// Whether the sizes differ by so much, as a factor from the source to the target, because one surface shows a part of what the other shows.
fn is_of_a_part(source: &Levels, target: &Levels, factor: f64) -> bool {
    match part(&source.full, &target.full) {
        None => false,
        Some(Role::Source) => (1.0..MOST_OF_PARTS).contains(&factor),
        Some(Role::Target) => (1.0..MOST_OF_PARTS).contains(&(1.0 / factor)),
    }
}

/// How much the shapes are alike in an answer by a smooth field.
fn likeness(answer: &Displaced) -> Option<f64> {
    answer.reliability.as_ref().map(reliability::likeness)
}

/// The mean of the surface over its area, mm.
fn center(mesh: &SurfaceMesh) -> Vector3<f64> {
    AreaMoments::of(mesh).map_or_else(Vector3::zeros, |moments| moments.mean)
}

/// The root mean square distance of the surface from its mean, mm; 1 where it has no area.
fn spread_mm(mesh: &SurfaceMesh) -> f64 {
    AreaMoments::of(mesh).map_or(1.0, |moments| moments.variance().trace().sqrt())
}

/// The rigid transform that rotates as `pose` does and moves `center` to where `pose` moves it after scaling by `factor`.
fn unscaled(pose: &RigidTransform, factor: f64, center: &Vector3<f64>) -> RigidTransform {
    let at = pose.apply(&Point3::from(center * factor)).coords;
    RigidTransform { rotation: pose.rotation, translation: at - pose.rotation * center }
}
