//! From an answer for straightened tubes to an answer for the original tubes.

use super::along;
use super::deformed::Deformed;
use crate::pair::surfaces::Surfaces;
use crate::poses::compared::{ComparedPose, Origin};
use crate::starts::start_pose::StartPose;
use crate::starts::tubes::{Tubes, carried};
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::{RigidTransform, absolute_orientation_of};
use nalgebra::Point3;
use rayon::prelude::*;

/// Converts `deformed`, a deformation of straightened surfaces, to a deformation of the original ones, and the starts
/// `compared` from their `poses`, the one kept first. `None` if a number is not finite.
pub(crate) fn unstraighten(
    surfaces: &Surfaces<'_>,
    tubes: &Tubes<'_>,
    deformed: Deformed,
    compared: Vec<ComparedPose>,
    poses: &[StartPose],
) -> Option<(Deformed, Vec<ComparedPose>)> {
    let (source, target) = (&tubes.source, &tubes.target);
    let own = target.bent(&deformed.moved);
    // Straightening keeps the handedness.
    let rigid = |images: &[Point3<f64>], mirrored: bool| {
        let areas = vertex_areas(surfaces.source);
        absolute_orientation_of(surfaces.source.vertices(), images, Some(&areas), mirrored).ok()
    };
    let transform = rigid(&own, deformed.transform.is_reflection())?;
    let compared = compared
        .into_iter()
        .map(|compared| {
            let pose = compared.origin.rigid(poses);
            let moved: Vec<Point3<f64>> = source.straight.vertices().iter().map(|p| pose.apply(p)).collect();
            let bent: RigidTransform = rigid(&target.bent(&moved), pose.is_reflection()).unwrap_or(transform);
            ComparedPose { origin: Origin::Bent(bent), ..compared }
        })
        .collect();
    let error = along::squared_error(surfaces.source, &own, &deformed.agreement, &surfaces.lengths);
    let (moved, mut variances) = if surfaces.source == surfaces.full_source {
        (own, deformed.variances)
    } else {
        let moved = surfaces.source.with_vertices(own).ok()?;
        let carried = |p: &Point3<f64>| {
            let at = source.closest[0].closest(p);
            (carried(surfaces.source, &source.closest[0], &moved, p), at.blend(|k| deformed.variances[k]))
        };
        surfaces.full_source.vertices().par_iter().map(carried).unzip()
    };
    along::raise_variances(&mut variances, error, &surfaces.lengths);
    Some((Deformed { moved, variances, transform, ..deformed }, compared))
}
