//! Shape contexts on surfaces: a histogram of the surface about a vertex in spherical coordinates whose pole is the normal.
//!
//! Shells are spaced by the logarithm of the radius, and a bin is weighted by the inverse cube root of its volume, as
//! by Frome et al. The origin of the azimuth is arbitrary. As in their harmonic shape contexts, absolute values of
//! Fourier coefficients remove it, here over the azimuth alone: `|Σ a e^(imφ)|` for `m` = 0, 1, 2 in each bin of radius
//! and elevation; `m = 0` is the sum over the azimuth. Square roots are taken, so that the Euclidean distance equals
//! the Hellinger distance, which is close to the `χ²` distance used by Belongie et al.
//!
//! Sources: Belongie, Malik, Puzicha, IEEE PAMI 24(4), 2002; Frome, Huber, Kolluri, Bülow, Malik, "Recognizing objects in range
//! data using regional point descriptors", ECCV 2004.

use super::Descriptor;
use super::histogram::between;
use super::samples::{Samples, tangents};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_primitives::points::NeighborGrid;
use std::f64::consts::PI;

/// Number of shells; number of bins of elevation between the poles.
const SHELLS: usize = 5;
const ELEVATIONS: usize = 6;
/// Harmonics of the azimuth.
const HARMONICS: usize = 3;
/// Inner radius of the shells as a share of the outer radius; nearer points fall into the innermost shell.
const INNER: f64 = 0.1;

/// The shape context of every vertex within `radius_mm`, channel `(shell · 6 + elevation) · 3 + m`.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every vertex.
///
/// # Cost
/// `O(n k)` for `k` parts of triangles in a ball, on all threads.
pub fn shape_contexts(mesh: &SurfaceMesh, radius_mm: f64, observer: &dyn Observer) -> Result<Descriptor, Cancelled> {
    // The narrowest bins belong to the inner shells, which have little weight.
    let (samples, normals) = (Samples::finer_than(mesh, radius_mm / 8.0), mesh.vertex_normals());
    let grid = NeighborGrid::new(&samples.points, radius_mm);
    let whole = PI * radius_mm * radius_mm;
    let bins = SHELLS * ELEVATIONS;
    Descriptor::of_rows(mesh.n_vertices(), bins * HARMONICS, observer, |i, row| {
        let (p, n) = (mesh.vertices()[i], normals[i]);
        let [u, v] = tangents(&n);
        let mut sums = [[[0.0; 2]; HARMONICS]; SHELLS * ELEVATIONS];
        grid.within(&p, radius_mm, |k, squared| {
            let offset = samples.points[k as usize] - p;
            let distance = squared.sqrt();
            let (x, y, z) = (offset.dot(&u), offset.dot(&v), offset.dot(&n));
            let flat = x.hypot(y);
            // Points on the pole have no azimuth.
            let (cosine, sine) = if flat > 1e-12 * radius_mm { (x / flat, y / flat) } else { (0.0, 0.0) };
            let turns = [[1.0, 0.0], [cosine, sine], [cosine * cosine - sine * sine, 2.0 * cosine * sine]];
            let area = samples.areas[k as usize] / whole;
            for (shell, of_shell) in between(1.0 - (distance / radius_mm).ln() / INNER.ln(), SHELLS) {
                for (elevation, of_elevation) in between(flat.atan2(z) / PI, ELEVATIONS) {
                    let share = area * of_shell * of_elevation;
                    for (sum, turn) in sums[shell * ELEVATIONS + elevation].iter_mut().zip(turns) {
                        sum[0] += share * turn[0];
                        sum[1] += share * turn[1];
                    }
                }
            }
        });
        for (bin, sums) in sums.iter().enumerate() {
            let weight = 1.0 / volume(bin).cbrt();
            for (m, [re, im]) in sums.iter().enumerate() {
                row[bin * HARMONICS + m] = (weight * re.hypot(*im)).sqrt();
            }
        }
    })
}

/// Volume of a bin of radius and elevation, in cubes of the outer radius.
fn volume(bin: usize) -> f64 {
    let radius = |shell: usize| INNER.powf(1.0 - shell as f64 / SHELLS as f64);
    let pole = |elevation: usize| (PI * elevation as f64 / ELEVATIONS as f64).cos();
    let (shell, elevation) = (bin / ELEVATIONS, bin % ELEVATIONS);
    let cubes = radius(shell + 1).powi(3) - radius(shell).powi(3);
    2.0 * PI / 3.0 * cubes * (pole(elevation) - pole(elevation + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::{bean, check_invariance};
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    /// Areas of the bins, from which a channel was made.
    fn area(row: &[f64], bin: usize, m: usize) -> f64 {
        row[bin * HARMONICS + m].powi(2) * volume(bin).cbrt()
    }

    #[test]
    fn on_a_sphere_the_area_is_that_of_a_disc_and_the_same_all_around() {
        let found = shape_contexts(&ellipsoid(Vector3::repeat(10.0), 5), 6.0, &Silent).unwrap();
        for i in 0..found.n_vertices() {
            let sum = |m: usize| (0..SHELLS * ELEVATIONS).map(|bin| area(found.row(i), bin, m)).sum::<f64>();
            assert!((sum(0) - 1.0).abs() < 0.02 && sum(1) < 0.06 && sum(2) < 0.06, "{} {} {}", sum(0), sum(1), sum(2));
        }
    }

    #[test]
    fn the_volumes_of_all_bins_make_up_the_ball_outside_the_innermost_radius() {
        let total: f64 = (0..SHELLS * ELEVATIONS).map(volume).sum();
        assert!((total - 4.0 / 3.0 * PI * (1.0 - 1e-3)).abs() < 1e-12, "{total}");
    }

    #[test]
    fn harmonics_are_those_of_a_histogram_of_the_azimuth() {
        // A fine histogram of the azimuth in each bin, transformed; no grid, and a tangent direction of its own.
        let mesh = bean(2);
        let (radius, p) = (8.0, mesh.vertices());
        let found = shape_contexts(&mesh, radius, &Silent).unwrap();
        let parts = Samples::at_triangles(&mesh, 4);
        let steps = 20_000;
        for i in (0..p.len()).step_by(23) {
            let n = mesh.vertex_normals()[i];
            let east = (p[(i + 1) % p.len()] - p[i]).cross(&n).normalize();
            let mut bins = vec![vec![0.0; steps]; SHELLS * ELEVATIONS];
            for (point, area) in parts.points.iter().zip(&parts.areas) {
                let center = point - p[i];
                if center.norm() > radius {
                    continue;
                }
                let azimuth = center.dot(&n.cross(&east)).atan2(center.dot(&east));
                let at = ((azimuth + PI) / (2.0 * PI) * steps as f64) as usize % steps;
                for (s, a) in between(1.0 + (center.norm() / radius).log10(), SHELLS) {
                    for (e, b) in between((center.dot(&n) / center.norm()).acos() / PI, ELEVATIONS) {
                        bins[s * ELEVATIONS + e][at] += area * a * b;
                    }
                }
            }
            for (bin, histogram) in bins.iter().enumerate() {
                for m in 0..HARMONICS {
                    let turn = |k: usize| m as f64 * 2.0 * PI * k as f64 / steps as f64;
                    let re: f64 = histogram.iter().enumerate().map(|(k, a)| a * turn(k).cos()).sum();
                    let im: f64 = histogram.iter().enumerate().map(|(k, a)| a * turn(k).sin()).sum();
                    let expected = re.hypot(im) / (PI * radius * radius);
                    assert!((area(found.row(i), bin, m) - expected).abs() < 1e-4, "{bin} {m}");
                }
            }
        }
    }

    #[test]
    fn it_keeps_its_numbers_when_the_surface_is_moved_scaled_or_sampled_otherwise() {
        // The roots make much of rounding in bins that hold almost nothing.
        check_invariance(&|mesh, size| shape_contexts(mesh, 6.0 * size, &Silent).unwrap(), 1e-6, 0.5);
    }
}
