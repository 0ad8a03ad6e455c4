//! Medial coordinates of a tubular structure: position along a center line, and position in the cross section there.
//!
//! In the coordinates of its [`CenterLine`] a bent tube is straight. Both straight tubes are scaled to one length and one mean radius; the image of a source vertex is the closest point
//! of the target there. Coordinates alone determine neither which ends correspond nor the angle between the cross
//! sections. Of both directions and all angles, the combination is chosen for which corresponding points lie closest in
//! the given pose.
//!
//! Source: Blum 1967 for the idea of a medial axis; [`homolog_geometry::center_line`] for the coordinates.

use crate::MethodError;
use homolog_geometry::center_line::{CenterLine, CenterLineOptions};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::{Point3, Rotation3, Vector3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MedialOptions {
    /// How center lines are computed.
    pub line: CenterLineOptions,
    /// Number of angles of the cross sections that are tried.
    pub n_angles: usize,
    /// Number of vertices used to compare directions and angles.
    pub n_compared: usize,
}

impl Default for MedialOptions {
    fn default() -> Self {
        MedialOptions { line: CenterLineOptions::default(), n_angles: 36, n_compared: 300 }
    }
}

/// The result of [`register`].
#[derive(Debug, Clone)]
pub struct Medial {
    /// The point of the target with the same coordinates, for every source vertex.
    pub images: Vec<Point3<f64>>,
    /// The coordinates of the source.
    pub source: CenterLine,
    /// The coordinates of the target.
    pub target: CenterLine,
}

/// A correspondence of `source` with `target`, in one pose. Surfaces that are not elongated have coordinates too, but
/// these are of little use.
///
/// # Errors
/// [`MethodError::Singular`] if a surface has no eigenfunction or no length; [`MethodError::Cancelled`].
///
/// # Cost
/// Two sparse factorizations, and `O((n + 2 n_angles n_compared) log n)`; memory `O(n log n)`.
pub fn register(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    options: &MedialOptions,
    observer: &dyn Observer,
) -> Result<Medial, MethodError> {
    let singular = MethodError::Singular { method: "medial coordinates" };
    let (of_source, of_target) =
        rayon::join(|| CenterLine::of(source, &options.line), || CenterLine::of(target, &options.line));
    checkpoint(observer)?;
    let (of_source, of_target) = (of_source.ok_or(singular.clone())?, of_target.ok_or(singular.clone())?);
    let (slender, other) = (of_source.slenderness(), of_target.slenderness());
    let ratio = (slender.ok_or(singular.clone())? * other.ok_or(singular.clone())?).sqrt();
    let (moving, normalized) = (of_source.normalized(ratio), of_target.normalized(ratio));
    let tube = target.with_vertices(normalized).map_err(|_| singular)?;
    let index = ClosestPointIndex::new(&tube);
    let image = |p: &Point3<f64>| Point3::from(index.closest(p).blend(|k| target.vertices()[k].coords));
    let step = moving.len().div_ceil(options.n_compared.max(1)).max(1);
    let apart = |turn: &Rotation3<f64>| -> f64 {
        let compared = (0..moving.len()).step_by(step);
        compared.map(|i| (image(&(turn * moving[i])) - source.vertices()[i]).norm_squared()).sum()
    };
    let angles = (0..options.n_angles).map(|k| TAU * k as f64 / options.n_angles as f64);
    let turns: Vec<Rotation3<f64>> = [0.0, TAU / 2.0]
        .into_iter()
        .flat_map(|end| angles.clone().map(move |angle| (end, angle)))
        .map(|(end, angle)| {
            Rotation3::from_axis_angle(&Vector3::x_axis(), angle) * Rotation3::from_axis_angle(&Vector3::y_axis(), end)
        })
        .collect();
    let distances: Vec<f64> = turns.par_iter().map(apart).collect();
    checkpoint(observer)?;
    // Ties go to the first: no rotation at all if the surfaces are copies.
    let best = (1..turns.len()).fold(0, |best, k| if distances[k] < distances[best] { k } else { best });
    let turn = turns[best];
    let images = moving.par_iter().map(|p| image(&(turn * p))).collect();
    Ok(Medial { images, source: of_source, target: of_target })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{bean, rms};
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use homolog_registration::absolute_orientation;

    /// A flattened, tapering tube without symmetry, straight.
    fn tube() -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(18.0, 4.0, 3.0), 4);
        let shaped = |p: &Point3<f64>| {
            let wide = 1.0 + 0.02 * p.x;
            Point3::new(p.x, p.y * wide + 0.5 * (0.2 * p.x).sin(), p.z * wide)
        };
        mesh.with_vertices(mesh.vertices().iter().map(shaped).collect()).unwrap()
    }

    /// Its axis bent into an arc of `angle` radians.
    fn bent(p: &Point3<f64>, angle: f64) -> Point3<f64> {
        let radius = 36.0 / angle;
        let at = p.x / radius;
        Point3::new((radius - p.y) * at.sin(), radius - (radius - p.y) * at.cos(), p.z)
    }

    #[test]
    fn copies_correspond_by_the_identity() {
        let mesh = bean(3);
        let found = register(&mesh, &mesh, &MedialOptions::default(), &Silent).unwrap();
        assert!(rms(&found.images, mesh.vertices()) < 1e-9);
    }

    #[test]
    fn a_tube_that_is_bent_by_a_right_angle_is_followed() {
        let source = tube();
        let truth: Vec<_> = source.vertices().iter().map(|p| bent(p, TAU / 4.0)).collect();
        let target = source.with_vertices(truth.clone()).unwrap();
        let pose = absolute_orientation(source.vertices(), &truth, None, false).unwrap();
        let posed = source.moved(&pose.matrix()).unwrap();
        let found = register(&posed, &target, &MedialOptions::default(), &Silent).unwrap();
        let index = ClosestPointIndex::new(&target);
        let nearest: Vec<_> = posed.vertices().iter().map(|p| index.closest(p).point).collect();
        let (error, before) = (rms(&found.images, &truth), rms(&nearest, &truth));
        // The bound was fixed before the measurement: a fifth of the error of nearest points.
        assert!(error < 0.2 * before, "{error} of {before}");
    }
}
