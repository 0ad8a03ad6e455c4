//! Spin images: a histogram of the surface in cylindrical coordinates about the normal of a vertex.
//!
//! The coordinates of a point are its distance `α` from the line along the normal and its height `β` above the tangent
//! plane. The angle about the line is ignored, so no direction in the plane has to be chosen. Both coordinates are
//! shared bilinearly between bins, as in the publication. Bins count area instead of points, so meshes need not be
//! uniform as the authors demand. The support is a ball and includes all of the surface in it, also the far side of a
//! thin part (a support angle of 180°): there is no clutter.
//!
//! Source: Johnson, Hebert, "Using spin images for efficient object recognition in cluttered 3D scenes", IEEE PAMI 21(5), 1999.

use super::Descriptor;
use super::histogram::between;
use super::samples::Samples;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_primitives::points::NeighborGrid;
use std::f64::consts::PI;

/// Bins of `α` in `[0, R]` and of `β` in `[−R, R]`, of equal size.
pub(super) const BINS: [usize; 2] = [8, 16];

/// The spin image of every vertex within `radius_mm`, channel `a · 16 + b`: areas in units of `πR²`, so that they sum to 1 on a
/// plane and on any sphere.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every vertex.
///
/// # Cost
/// `O(n k)` for `k` parts of triangles in a ball, on all threads.
pub fn spin_images(mesh: &SurfaceMesh, radius_mm: f64, observer: &dyn Observer) -> Result<Descriptor, Cancelled> {
    let (samples, normals) = (Samples::finer_than(mesh, radius_mm / BINS[0] as f64), mesh.vertex_normals());
    let grid = NeighborGrid::new(&samples.points, radius_mm);
    let whole = PI * radius_mm * radius_mm;
    Descriptor::of_rows(mesh.n_vertices(), BINS[0] * BINS[1], observer, |i, row| {
        let (p, n) = (mesh.vertices()[i], normals[i]);
        grid.within(&p, radius_mm, |k, squared| {
            let beta = n.dot(&(samples.points[k as usize] - p));
            let alpha = (squared - beta * beta).max(0.0).sqrt();
            let share = samples.areas[k as usize] / whole;
            for (a, of_a) in between(alpha / radius_mm, BINS[0]) {
                for (b, of_b) in between(0.5 + 0.5 * beta / radius_mm, BINS[1]) {
                    row[a * BINS[1] + b] += share * of_a * of_b;
                }
            }
        });
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::{bean, check_invariance};
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn on_a_sphere_the_area_in_a_ball_is_that_of_a_disc_and_the_height_falls_with_its_square() {
        let (r, radius) = (10.0, 6.0);
        let found = spin_images(&ellipsoid(Vector3::repeat(r), 5), radius, &Silent).unwrap();
        for i in 0..found.n_vertices() {
            let row = found.row(i);
            let total: f64 = row.iter().sum();
            let height: f64 = (0..row.len())
                .map(|c| row[c] * radius * (2.0 * ((c % BINS[1]) as f64 + 0.5) / BINS[1] as f64 - 1.0))
                .sum();
            // Archimedes: the squared chord is uniform on [0, R²], and the height is that over −2r.
            assert!((total - 1.0).abs() < 0.02, "{total}");
            assert!((height / total + radius * radius / (4.0 * r)).abs() < 0.03, "{height}");
        }
    }

    #[test]
    fn it_is_the_sum_over_all_parts_of_what_each_adds() {
        // Written out: hat functions about the centers of the bins, the outermost ones flat to the border, no grid.
        let mesh = bean(2);
        let (radius, p) = (7.0, mesh.vertices());
        let found = spin_images(&mesh, radius, &Silent).unwrap();
        let parts = Samples::at_triangles(&mesh, 4);
        let hat = |x: f64, bin: usize, n: usize| {
            let center = (bin as f64 + 0.5) / n as f64;
            let x = x.clamp(0.5 / n as f64, 1.0 - 0.5 / n as f64);
            (1.0 - (x - center).abs() * n as f64).max(0.0)
        };
        for i in (0..p.len()).step_by(7) {
            let n = mesh.vertex_normals()[i];
            for a in 0..BINS[0] {
                for b in 0..BINS[1] {
                    let mut sum = 0.0;
                    for (point, area) in parts.points.iter().zip(&parts.areas) {
                        let offset = point - p[i];
                        if offset.norm() > radius {
                            continue;
                        }
                        let beta = offset.dot(&n);
                        let alpha = (offset - beta * n).norm();
                        sum += area * hat(alpha / radius, a, 8) * hat(0.5 + beta / (2.0 * radius), b, 16);
                    }
                    assert!((found.row(i)[a * 16 + b] - sum / (PI * radius * radius)).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn it_keeps_its_numbers_when_the_surface_is_moved_scaled_or_sampled_otherwise() {
        check_invariance(&|mesh, size| spin_images(mesh, 6.0 * size, &Silent).unwrap(), 1e-9, 0.1);
    }
}
