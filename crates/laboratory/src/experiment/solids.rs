//! Star-shaped surfaces with random bumps, which have no symmetry.

use super::draws::Draws;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::{Isometry3, Point3, Vector3};
use serde::Serialize;

/// The surface whose point in direction `u` is `place(u)`, on an icosahedron subdivided `levels` times.
fn star_shaped(levels: u32, place: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Result<SurfaceMesh, String> {
    let sphere = ellipsoid(Vector3::repeat(1.0), levels);
    let vertices = sphere.vertices().iter().map(|u| Point3::from(place(&u.coords))).collect();
    sphere.with_vertices(vertices).map_err(|e| e.to_string())
}

/// A shape to which bumps are added, which removes its symmetry.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Form {
    /// Semi-axes 15, 10 and 6.5 mm.
    Ellipsoid,
    /// Radius 10 mm.
    Sphere,
    /// Between a sphere and a cube: `x⁸ + y⁸ + z⁸ = 9⁸` mm.
    Cube,
    /// Semi-axes 16, 8 and 8 mm.
    Spindle,
}

impl Form {
    pub(super) const ALL: [Form; 4] = [Form::Ellipsoid, Form::Spindle, Form::Sphere, Form::Cube];

    pub(super) fn name(self) -> &'static str {
        match self {
            Form::Ellipsoid => "ellipsoid-like",
            Form::Sphere => "near-spherical",
            Form::Cube => "near-cubic",
            Form::Spindle => "spindle",
        }
    }

    fn place(self, u: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Form::Ellipsoid => u.component_mul(&Vector3::new(15.0, 10.0, 6.5)),
            Form::Spindle => u.component_mul(&Vector3::new(16.0, 8.0, 8.0)),
            Form::Sphere => 10.0 * u,
            Form::Cube => u * (9.0 / u.iter().map(|c| c.powi(8)).sum::<f64>().powf(0.125)),
        }
    }
}

/// Number of bumps on a solid.
const N_BUMPS: usize = 12;
/// Largest height or depth of a bump, as a share of the radius.
const HEIGHT: f64 = 0.08;
/// The same limit for the additional bumps of a copy.
const OWN_HEIGHT: f64 = 0.02;
/// Width of a bump, radians.
const WIDTH: f64 = 0.35;

/// Bumps in random directions, each with its height as a share of the radius.
fn bumps(seed: u64, height: f64) -> Vec<(Vector3<f64>, f64)> {
    let mut draws = Draws::new(seed);
    (0..N_BUMPS).map(|_| (draws.normals().normalize(), height * (2.0 * draws.unit() - 1.0))).collect()
}

/// Differences of a solid from others of its shape.
#[derive(Debug, Clone, Copy)]
pub(super) struct Individual {
    /// Seed of the bumps that distinguish it from others of its shape.
    pub(super) seed: u64,
    /// Seed of smaller bumps that only this copy has.
    pub(super) own_seed: Option<u64>,
}

/// The shape with the bumps of `of`, triangulated in a frame rotated by `frame`, then moved by `motion`.
pub(super) fn bumped(
    form: Form,
    levels: u32,
    of: Individual,
    frame: &Isometry3<f64>,
    motion: &Isometry3<f64>,
) -> Result<SurfaceMesh, String> {
    let mut all = bumps(of.seed, HEIGHT);
    all.extend(of.own_seed.into_iter().flat_map(|seed| bumps(seed, OWN_HEIGHT)));
    star_shaped(levels, |u| {
        let u = frame * u;
        let bump = |(center, height): &(Vector3<f64>, f64)| {
            height * (-(u - center).norm_squared() / (2.0 * WIDTH * WIDTH)).exp()
        };
        let swell = 1.0 + all.iter().map(bump).sum::<f64>();
        motion.rotation * (swell * form.place(&u)) + motion.translation.vector
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solids_are_closed_and_oriented_outwards() {
        for form in Form::ALL {
            let still = Isometry3::identity();
            let mesh = bumped(form, 3, Individual { seed: 1, own_seed: Some(2) }, &still, &still).unwrap();
            assert_eq!(mesh.edges().len(), 3 * (mesh.n_vertices() - 2));
            assert!(mesh.signed_volume() > 0.0);
        }
    }
}
