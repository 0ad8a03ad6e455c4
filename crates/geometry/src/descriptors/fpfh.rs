//! Fast point feature histograms: the directions of the normals around a vertex relative to its own normal.
//!
//! A pair of points has three angles, in the frame of the point whose normal makes the smaller angle with the line
//! between them. The frame has the own normal as `u`, the direction perpendicular to it and to the line as `v`, and `w
//! = u × v`. `α` is the angle between the other normal and `v`, `φ` the angle between the own normal and the line, `θ`
//! the angle of the other normal about `v`. The simplified histogram of a vertex counts its pairs with all neighbors,
//! with 11 bins per angle. The FPFH of a vertex is the mean of its own simplified histogram and those of its neighbors,
//! which are weighted by the inverse of their distance.
//!
//! Differences from the publication: neighbors are weighted by their area; a pair is shared between two bins, on the
//! circle for `θ`; each histogram sums to 1 instead of 100.
//!
//! Source: Rusu, Blodow, Beetz, "Fast point feature histograms (FPFH) for 3D registration", ICRA 2009.

use super::Descriptor;
use super::histogram::{around, between};
use super::samples::Samples;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_primitives::points::NeighborGrid;
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

/// Bins per angle.
pub(super) const BINS: usize = 11;

/// The FPFH of every vertex within `radius_mm`: bins of `cos α` and `cos φ` in `[−1, 1]` and of `θ` in `[−π, π]`, in
/// this order.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every vertex.
///
/// # Cost
/// `O(n k)` for `k` vertices in a ball, twice, on all threads.
pub fn fpfh(mesh: &SurfaceMesh, radius_mm: f64, observer: &dyn Observer) -> Result<Descriptor, Cancelled> {
    let samples = Samples::at_vertices(mesh);
    let grid = NeighborGrid::new(&samples.points, radius_mm);
    let simplified = Descriptor::of_rows(mesh.n_vertices(), 3 * BINS, observer, |i, row| {
        let mut total = 0.0;
        grid.within(&samples.points[i], radius_mm, |k, squared| {
            let (j, distance) = (k as usize, squared.sqrt());
            let [one, other] = [i, j].map(|v| (&samples.points[v], &samples.normals[v]));
            let Some(angles) = angles(one, other, distance) else { return };
            let area = samples.areas[j];
            total += area;
            let shares = [
                between(0.5 + 0.5 * angles[0], BINS),
                between(0.5 + 0.5 * angles[1], BINS),
                around(0.5 + angles[2] / TAU, BINS),
            ];
            for (angle, shares) in shares.into_iter().enumerate() {
                for (bin, share) in shares {
                    row[angle * BINS + bin] += area * share;
                }
            }
        });
        row.iter_mut().for_each(|v| *v /= total);
    })?;
    Descriptor::of_rows(mesh.n_vertices(), 3 * BINS, observer, |i, row| {
        let mut total = 0.0;
        grid.within(&samples.points[i], radius_mm, |k, squared| {
            if squared > 0.0 {
                let weight = samples.areas[k as usize] / squared.sqrt();
                total += weight;
                row.iter_mut().zip(simplified.row(k as usize)).for_each(|(v, s)| *v += weight * s);
            }
        });
        let own = simplified.row(i);
        row.iter_mut().zip(own).for_each(|(v, s)| *v = if total > 0.0 { 0.5 * (s + *v / total) } else { *s });
    })
}

/// `cos α`, `cos φ` and `θ` of a pair at this distance; `None` for a pair without a frame, such as a point with itself.
fn angles(one: (&Point3<f64>, &Vector3<f64>), other: (&Point3<f64>, &Vector3<f64>), distance: f64) -> Option<[f64; 3]> {
    if distance == 0.0 {
        return None;
    }
    let line = (other.0 - one.0) / distance;
    let (of_one, of_other) = (one.1.dot(&line), other.1.dot(&line));
    // The smaller angle with the line has the larger cosine, in either direction of the line.
    let (line, u, n, phi) = if of_one.abs() >= of_other.abs() {
        (line, one.1, other.1, of_one)
    } else {
        (-line, other.1, one.1, -of_other)
    };
    let v = line.cross(u).try_normalize(1e-12)?;
    let w = u.cross(&v);
    Some([v.dot(n), phi, w.dot(n).atan2(u.dot(n))])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::{bean, check_invariance};
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;

    fn center(bin: usize) -> f64 {
        2.0 * (bin as f64 + 0.5) / BINS as f64 - 1.0
    }

    #[test]
    fn on_a_sphere_the_angles_have_the_means_of_a_chord() {
        let (r, radius) = (10.0, 6.0);
        let found = fpfh(&ellipsoid(Vector3::repeat(r), 5), radius, &Silent).unwrap();
        for i in 0..found.n_vertices() {
            let row = found.row(i);
            // Normals and line of a pair lie in one plane, up to the error of normals: α is a right angle.
            assert!((row[BINS / 2] - 1.0).abs() < 0.01, "{row:?}");
            // cos φ = −d/2r, and the mean distance in a disc is 2R/3; the chord subtends an angle γ, sin(γ/2) = d/2r.
            let mean = |angle: usize| (0..BINS).map(|b| row[angle * BINS + b] * center(b)).sum::<f64>();
            assert!((mean(1) + radius / (3.0 * r)).abs() < 0.01, "{}", mean(1));
            let turned = mean(2).abs() * std::f64::consts::PI;
            assert!((turned - 2.0 * (radius / (3.0 * r)).asin()).abs() < 0.02, "{turned}");
        }
    }

    #[test]
    fn it_is_what_the_definition_gives_for_all_pairs() {
        let mesh = bean(2);
        let (p, n, areas) = (mesh.vertices(), mesh.vertex_normals(), crate::curvature::vertex_areas(&mesh));
        let radius = 6.0;
        let hat = |x: f64, bin: usize, circle: bool| {
            let (at, n) = (x * BINS as f64 - 0.5, BINS as f64);
            let at = if circle { at } else { at.clamp(0.0, n - 1.0) };
            let apart = (at - bin as f64).abs();
            (1.0 - if circle { apart.min((apart - n).abs()) } else { apart }).max(0.0)
        };
        let simplified = |i: usize| {
            let (mut sums, mut total) = (vec![0.0; 3 * BINS], 0.0);
            for j in (0..p.len()).filter(|&j| j != i && (p[j] - p[i]).norm() <= radius) {
                // The publication's order: the source is the point whose normal is closer to the line to the other.
                let toward = |a: usize, b: usize| n[a].angle(&(p[b] - p[a]));
                let acute = |angle: f64| angle.min(std::f64::consts::PI - angle);
                let (s, t) = if acute(toward(i, j)) <= acute(toward(j, i)) { (i, j) } else { (j, i) };
                let line = (p[t] - p[s]).normalize();
                let v = line.cross(&n[s]).normalize();
                let w = n[s].cross(&v);
                let (alpha, phi) = (v.dot(&n[t]), n[s].dot(&line));
                let theta = w.dot(&n[t]).atan2(n[s].dot(&n[t]));
                total += areas[j];
                for bin in 0..BINS {
                    sums[bin] += areas[j] * hat(0.5 + alpha / 2.0, bin, false);
                    sums[BINS + bin] += areas[j] * hat(0.5 + phi / 2.0, bin, false);
                    sums[2 * BINS + bin] += areas[j] * hat(0.5 + theta / TAU, bin, true);
                }
            }
            sums.iter().map(|s| s / total).collect::<Vec<_>>()
        };
        let all: Vec<_> = (0..p.len()).map(simplified).collect();
        let found = fpfh(&mesh, radius, &Silent).unwrap();
        for i in 0..p.len() {
            let near: Vec<usize> = (0..p.len()).filter(|&j| j != i && (p[j] - p[i]).norm() <= radius).collect();
            let weight = |j: usize| areas[j] / (p[j] - p[i]).norm();
            let total: f64 = near.iter().map(|&j| weight(j)).sum();
            for (c, own) in all[i].iter().enumerate() {
                let of_near: f64 = near.iter().map(|&j| weight(j) * all[j][c]).sum();
                assert!((found.row(i)[c] - 0.5 * (own + of_near / total)).abs() < 1e-9, "{i} {c}");
            }
        }
    }

    #[test]
    fn it_keeps_its_numbers_when_the_surface_is_moved_scaled_or_sampled_otherwise() {
        check_invariance(&|mesh, size| fpfh(mesh, 6.0 * size, &Silent).unwrap(), 1e-9, 0.2);
    }
}
