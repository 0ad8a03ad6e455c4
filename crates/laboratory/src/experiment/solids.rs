//! Surfaces of known form: star-shaped solids on a subdivided icosahedron, and tori.

use super::draws::Draws;
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Isometry3, Point3, Vector3};
use serde::Serialize;
use std::collections::HashMap;

/// Corners of a regular icosahedron around the origin, times the golden ratio on one axis.
const CORNERS: [[f64; 3]; 12] = {
    const G: f64 = 1.618_033_988_749_895;
    [
        [-1.0, G, 0.0],
        [1.0, G, 0.0],
        [-1.0, -G, 0.0],
        [1.0, -G, 0.0],
        [0.0, -1.0, G],
        [0.0, 1.0, G],
        [0.0, -1.0, -G],
        [0.0, 1.0, -G],
        [G, 0.0, -1.0],
        [G, 0.0, 1.0],
        [-G, 0.0, -1.0],
        [-G, 0.0, 1.0],
    ]
};

/// Its faces, counter-clockwise from outside.
const FACES: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// Unit directions and triangles of the icosahedron, every triangle cut in four `levels` times:
/// `10 · 4^levels + 2` directions.
fn directions(levels: u32) -> (Vec<Vector3<f64>>, Vec<[u32; 3]>) {
    let mut points: Vec<Vector3<f64>> = CORNERS.iter().map(|c| Vector3::from(*c).normalize()).collect();
    let mut triangles = FACES.to_vec();
    for _ in 0..levels {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let mut middle = |p: u32, q: u32| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    points.push((points[p as usize] + points[q as usize]).normalize());
                    points.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    (points, triangles)
}

/// The surface whose point in direction `u` is `place(u)`, a positive multiple of `u` or an affine image of that.
fn around(levels: u32, place: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Result<SurfaceMesh, String> {
    let (points, triangles) = directions(levels);
    let vertices = points.iter().map(|u| Point3::from(place(u))).collect();
    SurfaceMesh::new(vertices, FaceArity::Triangle, triangles.concat()).map_err(|e| e.to_string())
}

/// The ellipsoid with these semi-axes, mm.
pub(super) fn ellipsoid(axes: Vector3<f64>, levels: u32) -> Result<SurfaceMesh, String> {
    around(levels, |u| u.component_mul(&axes))
}

/// A shape to which bumps are added, so that it has no symmetry.
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

/// Bumps on a form.
const N_BUMPS: usize = 12;
/// Height of a bump as a share of the radius, to either side.
const HEIGHT: f64 = 0.08;
/// The same of the bumps that a copy does not share.
const OWN_HEIGHT: f64 = 0.02;
/// Width of a bump, radians.
const WIDTH: f64 = 0.35;

/// Bumps in random directions, each with a height as a share of the radius.
fn bumps(seed: u64, height: f64) -> Vec<(Vector3<f64>, f64)> {
    let mut draws = Draws::new(seed);
    (0..N_BUMPS).map(|_| (draws.normals().normalize(), height * (2.0 * draws.unit() - 1.0))).collect()
}

/// How a solid differs from the others of its shape.
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
    around(levels, |u| {
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
    use homolog_mesh::shapes::torus;
    use std::f64::consts::TAU;

    #[test]
    fn the_solids_are_closed_and_oriented_outwards() {
        let sphere = ellipsoid(Vector3::repeat(10.0), 4).unwrap();
        assert_eq!(sphere.n_vertices(), 2562);
        let volume = 4.0 / 3.0 * std::f64::consts::PI * 1000.0;
        assert!((sphere.signed_volume() / volume - 1.0).abs() < 0.01);
        let ring = torus(10.0, 4.0, 60, 30, FaceArity::Triangle);
        assert!((ring.signed_volume() / (TAU * 10.0 * std::f64::consts::PI * 16.0) - 1.0).abs() < 0.02);
        for form in Form::ALL {
            let still = Isometry3::identity();
            let mesh = bumped(form, 3, Individual { seed: 1, own_seed: Some(2) }, &still, &still).unwrap();
            assert_eq!(mesh.edges().len(), 3 * (mesh.n_vertices() - 2));
            assert!(mesh.signed_volume() > 0.0);
        }
    }
}
