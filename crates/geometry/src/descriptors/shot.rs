//! Signatures of histograms of orientations: the normals around a vertex, counted in sectors of a ball in a local
//! frame.
//!
//! The frame has the axes of the covariance of the points in the ball, weighted with `R − d`. `z` is the axis of least
//! extent and looks along the normal; `x` is the axis of largest extent and looks to the side with more area. The ball
//! has 8 sectors of azimuth, 2 of elevation and 2 shells. Each has a histogram of 11 bins of the cosine between `z` and
//! the normals in it, and all bins share their counts with neighboring bins. Differences from the publication: vertices
//! are weighted by their area; the normal, which a closed surface has, orients `z` in place of a majority vote.
//!
//! Source: Tombari, Salti, Di Stefano, "Unique signatures of histograms for local surface description", ECCV 2010.

use super::Descriptor;
use super::histogram::{around, between};
use super::samples::{Samples, tangents};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_primitives::points::NeighborGrid;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

const AZIMUTHS: usize = 8;
const ELEVATIONS: usize = 2;
const SHELLS: usize = 2;
const COSINES: usize = 11;

/// The SHOT descriptor of every vertex within `radius_mm`, of length 1: channel `((azimuth · 2 + elevation) · 2 + shell) · 11 + cosine`.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every vertex.
///
/// # Cost
/// `O(n k)` for `k` vertices in a ball, on all threads.
pub fn shot(mesh: &SurfaceMesh, radius_mm: f64, observer: &dyn Observer) -> Result<Descriptor, Cancelled> {
    let samples = Samples::at_vertices(mesh);
    let grid = NeighborGrid::new(&samples.points, radius_mm);
    let n_channels = AZIMUTHS * ELEVATIONS * SHELLS * COSINES;
    Descriptor::of_rows(mesh.n_vertices(), n_channels, observer, |i, row| {
        let p = samples.points[i];
        let mut near: Vec<(usize, Vector3<f64>)> = Vec::new();
        grid.within(&p, radius_mm, |k, squared| {
            if squared > 0.0 {
                near.push((k as usize, (samples.points[k as usize] - p) / radius_mm));
            }
        });
        let [x, y, z] = frame(&near, &samples, i);
        for (k, offset) in near {
            let distance = offset.norm();
            let shares = [
                around(offset.dot(&y).atan2(offset.dot(&x)) / TAU, AZIMUTHS),
                between(0.5 + 0.5 * offset.dot(&z) / distance, ELEVATIONS),
                between(distance, SHELLS),
                between(0.5 + 0.5 * z.dot(&samples.normals[k]), COSINES),
            ];
            for (azimuth, a) in shares[0] {
                for (elevation, b) in shares[1] {
                    for (shell, c) in shares[2] {
                        for (cosine, d) in shares[3] {
                            let bin = ((azimuth * ELEVATIONS + elevation) * SHELLS + shell) * COSINES + cosine;
                            row[bin] += samples.areas[k] * a * b * c * d;
                        }
                    }
                }
            }
        }
        let length = row.iter().map(|v| v * v).sum::<f64>().sqrt();
        row.iter_mut().for_each(|v| *v /= length);
    })
}

/// The axes at vertex `i` from its neighbors and their offsets in radii.
fn frame(near: &[(usize, Vector3<f64>)], samples: &Samples, i: usize) -> [Vector3<f64>; 3] {
    let normal = samples.normals[i];
    let weighted: Vec<f64> = near.iter().map(|(k, offset)| samples.areas[*k] * (1.0 - offset.norm())).collect();
    let total: f64 = weighted.iter().sum();
    let covariance = near
        .iter()
        .zip(&weighted)
        .fold(Matrix3::zeros(), |sum, ((_, offset), weight)| sum + (weight / total) * offset * offset.transpose());
    if !covariance.iter().all(|v| v.is_finite()) {
        let [x, y] = tangents(&normal);
        return [x, y, normal];
    }
    let eigen = covariance.symmetric_eigen();
    let axis = |k: usize| eigen.eigenvectors.column(k).into_owned();
    let (mut z, mut x) = (axis(eigen.eigenvalues.imin()), axis(eigen.eigenvalues.imax()));
    if z.dot(&normal) < 0.0 {
        z = -z;
    }
    let ahead: f64 = near.iter().map(|(k, offset)| samples.areas[*k] * offset.dot(&x).signum()).sum();
    if ahead < 0.0 {
        x = -x;
    }
    [x, z.cross(&x), z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::{bean, check_invariance};
    use homolog_primitives::observe::Silent;

    #[test]
    fn it_is_what_the_definition_gives_in_the_frame_of_the_covariance() {
        let mesh = bean(2);
        let (p, n, areas) = (mesh.vertices(), mesh.vertex_normals(), crate::curvature::vertex_areas(&mesh));
        let radius = 8.0;
        let found = shot(&mesh, radius, &Silent).unwrap();
        // Hat functions about the centers of bins, the outermost ones of a line flat to its end.
        let hat = |x: f64, bin: usize, n: usize, circle: bool| {
            let at = x * n as f64 - 0.5;
            let at = if circle { at.rem_euclid(n as f64) } else { at.clamp(0.0, n as f64 - 1.0) };
            let apart = (at - bin as f64).abs();
            (1.0 - if circle { apart.min(n as f64 - apart) } else { apart }).max(0.0)
        };
        for i in (0..p.len()).step_by(11) {
            let near: Vec<usize> = (0..p.len()).filter(|&j| j != i && (p[j] - p[i]).norm() <= radius).collect();
            let mut covariance = Matrix3::zeros();
            for &j in &near {
                let d: Vector3<f64> = p[j] - p[i];
                covariance += areas[j] * (radius - d.norm()) * d * d.transpose();
            }
            let svd = covariance.svd(true, false);
            let u = svd.u.unwrap();
            let mut z = u.column(svd.singular_values.imin()).into_owned();
            let mut x = u.column(svd.singular_values.imax()).into_owned();
            z *= z.dot(&n[i]).signum();
            let ahead = |j: &&usize| (p[**j] - p[i]).dot(&x) > 0.0;
            let (front, all): (f64, f64) =
                (near.iter().filter(ahead).map(|&j| areas[j]).sum(), near.iter().map(|&j| areas[j]).sum());
            if front < 0.5 * all {
                x = -x;
            }
            let y = z.cross(&x);
            let mut expected = vec![0.0; 352];
            for (bin, sum) in expected.iter_mut().enumerate() {
                let (azimuth, elevation, shell, cosine) = (bin / 44, bin / 22 % 2, bin / 11 % 2, bin % 11);
                for &j in &near {
                    let d = p[j] - p[i];
                    *sum += areas[j]
                        * hat(d.dot(&y).atan2(d.dot(&x)) / TAU, azimuth, 8, true)
                        * hat(0.5 + 0.5 * d.normalize().dot(&z), elevation, 2, false)
                        * hat(d.norm() / radius, shell, 2, false)
                        * hat(0.5 + 0.5 * z.dot(&n[j]), cosine, 11, false);
                }
            }
            let length = expected.iter().map(|v| v * v).sum::<f64>().sqrt();
            for (a, b) in found.row(i).iter().zip(&expected) {
                assert!((a - b / length).abs() < 1e-9, "{a} {}", b / length);
            }
        }
    }

    #[test]
    fn it_keeps_its_numbers_when_the_surface_is_moved_scaled_or_sampled_otherwise() {
        // Where two axes of the covariance are alike, a little noise turns the frame.
        check_invariance(&|mesh, size| shot(mesh, 8.0 * size, &Silent).unwrap(), 1e-6, 0.7);
    }
}
