//! Curvature from corner angles and from the Laplacian of the positions.
//!
//! Source: Meyer, Desbrun, Schröder, Barr, "Discrete differential-geometry operators for triangulated
//! 2-manifolds", 2003: angle defect over mixed Voronoi area, mean curvature normal by cotangents.

use super::Curvatures;
use super::laplacian::{both_triangulations, laplacian_of_positions};
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

/// Angle at `at` between the directions to `a` and `b`, radians. By `atan2`, exact also for thin corners.
fn corner_angle(at: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let (u, v) = (a - at, b - at);
    u.cross(&v).norm().atan2(u.dot(&v))
}

/// Area `A_i` of every vertex, mm²: mixed Voronoi area on triangles, a quarter of each face on quads. The areas sum to
/// the area of the surface.
///
/// Cost `O(faces)`.
pub fn vertex_areas(mesh: &SurfaceMesh) -> Vec<f64> {
    let v = mesh.vertices();
    let mut areas = vec![0.0; mesh.n_vertices()];
    for (face, vector_area) in mesh.faces().zip(mesh.face_vector_areas()) {
        let area = vector_area.norm();
        if mesh.arity() == FaceArity::Quad {
            for &k in face {
                areas[k as usize] += area / 4.0;
            }
            continue;
        }
        let corners = [v[face[0] as usize], v[face[1] as usize], v[face[2] as usize]];
        let sides: [Vector3<f64>; 3] = std::array::from_fn(|k| corners[(k + 1) % 3] - corners[k]);
        // Products of the two sides at each corner; divided by twice the area they are the cotangents.
        let products: [f64; 3] = std::array::from_fn(|k| -sides[k].dot(&sides[(k + 2) % 3]));
        let obtuse = products.iter().position(|&product| product < 0.0);
        for k in 0..3 {
            areas[face[k] as usize] += match obtuse {
                Some(wide) if wide == k => area / 2.0,
                Some(_) => area / 4.0,
                // Two corners coincide.
                None if area == 0.0 => 0.0,
                None => {
                    // Voronoi region: an eighth of each adjacent squared edge times the cotangent opposite to it.
                    let (next, last) = ((k + 1) % 3, (k + 2) % 3);
                    let to_next = sides[k].norm_squared() * products[last];
                    let to_last = sides[last].norm_squared() * products[next];
                    (to_next + to_last) / (16.0 * area)
                }
            };
        }
    }
    areas
}

/// Gaussian curvature `K_i = (2π − Σ φ) / A_i` of every vertex, 1/mm². A boundary vertex gets the mean of its interior
/// neighbors.
///
/// Zero where the area of a vertex vanishes. Cost `O(faces)`.
pub fn gaussian_curvature(mesh: &SurfaceMesh) -> Vec<f64> {
    gaussian_with(mesh, &vertex_areas(mesh))
}

fn gaussian_with(mesh: &SurfaceMesh, areas: &[f64]) -> Vec<f64> {
    let v = mesh.vertices();
    let mut defect = vec![TAU; mesh.n_vertices()];
    // A triangle counts once; a quad counts as the mean of its two triangulations, so that the corners of a skew quad
    // also sum to 2π. On a flat quad the mean equals the corner angle.
    let mut subtract = |corners: [u32; 3], share: f64| {
        for k in 0..3 {
            let [at, next, last] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]].map(|c| &v[c as usize]);
            defect[corners[k] as usize] -= share * corner_angle(at, next, last);
        }
    };
    for f in mesh.faces() {
        match mesh.arity() {
            FaceArity::Triangle => subtract([f[0], f[1], f[2]], 1.0),
            FaceArity::Quad => both_triangulations(f).into_iter().for_each(|corners| subtract(corners, 0.5)),
        }
    }
    let found = defect.iter().zip(areas).map(|(d, &area)| if area > 0.0 { d / area } else { 0.0 });
    extended_to_boundary(mesh, found.collect())
}

/// Mean curvature `H_i` of every vertex, 1/mm, positive where the surface is convex (`1/r` on a sphere).
///
/// Half the component of the Laplacian of the positions along the vertex normal, over the area. Cost `O(faces)`.
pub fn mean_curvature(mesh: &SurfaceMesh) -> Vec<f64> {
    mean_with(mesh, &vertex_areas(mesh))
}

fn mean_with(mesh: &SurfaceMesh, areas: &[f64]) -> Vec<f64> {
    let normals = mesh.vertex_normals();
    let laplacian: Vec<Vector3<f64>> = laplacian_of_positions(mesh);
    let found = laplacian
        .iter()
        .zip(&normals)
        .zip(areas)
        .map(|((l, n), &area)| if area > 0.0 { l.dot(n) / (2.0 * area) } else { 0.0 });
    extended_to_boundary(mesh, found.collect())
}

/// [`gaussian_curvature`] and [`mean_curvature`] of every vertex. Cost `O(faces)`.
pub fn angle_defect_curvatures(mesh: &SurfaceMesh) -> Curvatures {
    both_curvatures(mesh, &vertex_areas(mesh))
}

/// [`gaussian_curvature`] and [`mean_curvature`] from the given vertex areas.
pub(super) fn both_curvatures(mesh: &SurfaceMesh, areas: &[f64]) -> Curvatures {
    Curvatures { gaussian: gaussian_with(mesh, areas), mean: mean_with(mesh, areas) }
}

/// `values` with the boundary vertices, where neither formula holds, set to the mean over their interior neighbors, or
/// to 0 if they have none.
fn extended_to_boundary(mesh: &SurfaceMesh, mut values: Vec<f64>) -> Vec<f64> {
    let Some(on_boundary) = mesh.boundary_vertices() else { return values };
    let graph = mesh.edge_graph();
    for i in (0..values.len()).filter(|&i| on_boundary[i]) {
        let (sum, count) = graph
            .neighbors(i)
            .iter()
            .filter(|&&j| !on_boundary[j as usize])
            .fold((0.0, 0.0), |(sum, count), &j| (sum + values[j as usize], count + 1.0));
        values[i] = if count > 0.0 { sum / count } else { 0.0 };
    }
    values
}
