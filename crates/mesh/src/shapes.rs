//! Closed surfaces given by formulas, with known curvature: for examples, experiments and tests.

use super::{FaceArity, SurfaceMesh};
use nalgebra::{Point3, Vector3};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// An ellipsoid with the given half axes, mm: an icosahedron, subdivided `levels` times, with `20 · 4^levels`
/// triangles.
///
/// ```
/// use homolog_mesh::{shapes::ellipsoid, topology::topology_report};
/// use nalgebra::Vector3;
///
/// let mesh = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 2);
/// assert_eq!(mesh.n_faces(), 320);
/// assert_eq!(topology_report(&mesh).genus, Some(0));
/// ```
///
/// # Panics
/// If a half axis is not finite.
#[allow(clippy::unwrap_used)] // the faces are valid for any finite half axes
pub fn ellipsoid(axes: Vector3<f64>, levels: u32) -> SurfaceMesh {
    let g = (1.0 + 5.0f64.sqrt()) / 2.0;
    let mut vertices: Vec<Vector3<f64>> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        vertices.extend([Vector3::new(0.0, a, b), Vector3::new(a, b, 0.0), Vector3::new(b, 0.0, a)]);
    }
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for a in 0..12usize {
        for b in a + 1..12 {
            for c in b + 1..12 {
                let near = |i: usize, j: usize| ((vertices[i] - vertices[j]).norm() - 2.0).abs() < 1e-9;
                if near(a, b) && near(b, c) && near(a, c) {
                    let outwards = vertices[a].dot(&vertices[b].cross(&vertices[c])) > 0.0;
                    let (b, c) = if outwards { (b, c) } else { (c, b) };
                    triangles.push([a as u32, b as u32, c as u32]);
                }
            }
        }
    }
    for _ in 0..levels {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let mut middle = |p: u32, q: u32| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    vertices.push((vertices[p as usize] + vertices[q as usize]).normalize() * vertices[0].norm());
                    vertices.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    let on_axes = vertices.iter().map(|v| Point3::from(v.normalize().component_mul(&axes))).collect();
    SurfaceMesh::new(on_axes, FaceArity::Triangle, triangles.concat()).unwrap()
}

/// A torus with the given radii, mm, of `around × across` quads or twice as many triangles.
///
/// # Panics
/// If a radius is not finite, or `around` or `across` is less than 3.
#[allow(clippy::unwrap_used)] // the faces are valid for any finite radii and enough quads
pub fn torus(radius: f64, tube: f64, around: u32, across: u32, arity: FaceArity) -> SurfaceMesh {
    let mut vertices = Vec::new();
    let mut indices = Vec::new();
    for i in 0..around {
        for j in 0..across {
            let (u, v) = (TAU * f64::from(i) / f64::from(around), TAU * f64::from(j) / f64::from(across));
            let ring = radius + tube * v.cos();
            vertices.push(Point3::new(ring * u.cos(), ring * u.sin(), tube * v.sin()));
            let at = |i: u32, j: u32| (i % around) * across + j % across;
            let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            match arity {
                FaceArity::Quad => indices.extend(quad),
                FaceArity::Triangle => indices.extend([quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]]),
            }
        }
    }
    SurfaceMesh::new(vertices, arity, indices).unwrap()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_shapes_face_outwards_and_enclose_the_volumes_of_their_formulas() {
        let relative = |mesh: SurfaceMesh, volume: f64| mesh.signed_volume() / volume;
        let sphere = ellipsoid(Vector3::repeat(10.0), 4);
        assert_eq!(sphere.n_vertices(), 2562);
        assert!((relative(sphere, 4.0 / 3.0 * PI * 1000.0) - 1.0).abs() < 0.01);
        let flat = ellipsoid(Vector3::new(12.0, 8.0, 2.0), 4);
        assert!((relative(flat, 4.0 / 3.0 * PI * 192.0) - 1.0).abs() < 0.01);
        for arity in [FaceArity::Triangle, FaceArity::Quad] {
            let ring = torus(10.0, 4.0, 60, 30, arity);
            assert!((relative(ring, TAU * 10.0 * PI * 16.0) - 1.0).abs() < 0.02);
        }
    }
}
