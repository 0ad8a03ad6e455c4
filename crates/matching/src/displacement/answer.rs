//! Images of source vertices between target vertices, with a probability that they are close to the truth.

use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use homolog_primitives::points::NeighborGrid;
use nalgebra::Point3;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Squared error of an image that no field explains, in squared sampling distances. Fitted with the share of the field's
/// covariance that counts.
const SAMPLING_VARIANCE: f64 = 0.039;
/// Radii and angles of the quadrature over an error in the tangent plane.
const RADII: usize = 16;
const ANGLES: usize = 24;

/// The image of a source vertex on the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Image {
    /// The moved vertex, mm; off the target by the distance of the two surfaces along the normal.
    pub moved: Point3<f64>,
    /// The closest point of the target: triangle, barycentric coordinates and position, mm.
    pub closest: ClosestPoint,
    /// The target vertex nearest to `moved`.
    pub label: u32,
    /// Probability that `label` is within a mean target edge length of the true image.
    pub confidence: f64,
    /// Expected root mean square error of `moved`, mm.
    pub spread_mm: f64,
}

/// Variance of an image that no field explains, mm², on surfaces sampled at a distance of `sampling_mm`.
pub(super) fn sampling_variance(sampling_mm: f64) -> f64 {
    SAMPLING_VARIANCE * sampling_mm * sampling_mm
}

/// The images of source vertices that are moved to `moved`, with the variance of each, mm², on surfaces sampled at a distance
/// of `sampling_mm`.
///
/// Cost `O(n log n')`.
pub(crate) fn images(
    target: &SurfaceMesh,
    index: &ClosestPointIndex,
    moved: &[Point3<f64>],
    variances: &[f64],
    sampling_mm: f64,
) -> Vec<Image> {
    let edge_mm = target.mean_edge_length();
    let grid = NeighborGrid::new(target.vertices(), 2.0 * edge_mm);
    moved
        .par_iter()
        .zip(variances)
        .map(|(p, variance)| {
            let closest = index.closest(p);
            // The nearest corner, unless a vertex around it is nearer still: triangles can be obtuse.
            let corner = closest.nearest_corner();
            let mut best = ((target.vertices()[corner as usize] - p).norm_squared(), corner);
            grid.within(p, best.0.sqrt().min(2.0 * edge_mm), |j, squared| {
                if squared < best.0 {
                    best = (squared, j);
                }
            });
            let variance = sampling_variance(sampling_mm) + variance;
            let confidence = within(edge_mm, best.0.sqrt(), (variance / 2.0).sqrt());
            Image { moved: *p, closest, label: best.1, confidence, spread_mm: variance.sqrt() }
        })
        .collect()
}

/// Probability that a normal error of standard deviation `sigma` along each axis of a plane ends within `radius` of a
/// point that is `offset` away; by quadrature at equally probable radii and equally spaced angles.
fn within(radius: f64, offset: f64, sigma: f64) -> f64 {
    let mut hits = 0.0;
    for k in 0..RADII {
        let r = sigma * (-2.0 * ((k as f64 + 0.5) / RADII as f64).ln()).sqrt();
        for a in 0..ANGLES {
            let angle = TAU * (a as f64 + 0.5) / ANGLES as f64;
            let squared = offset * offset + r * r + 2.0 * offset * r * angle.cos();
            hits += f64::from(u8::from(squared <= radius * radius));
        }
    }
    hits / (RADII * ANGLES) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn the_probability_is_that_of_a_normal_error() {
        for sigma in [0.2f64, 0.5, 1.0] {
            // About its own center the radius of the error follows Rayleigh's law.
            let exact = 1.0 - (-1.0 / (2.0 * sigma * sigma)).exp();
            assert!((within(1.0, 0.0, sigma) - exact).abs() < 0.04, "{sigma}");
        }
        // On the edge of a wide disc a small error falls within as often as not.
        assert!((within(100.0, 100.0, 0.1) - 0.5).abs() < 0.05);
        assert!(within(1.0, 0.2, 0.3) > within(1.0, 0.6, 0.3));
        assert!(within(1.0, 0.2, 0.3) > within(1.0, 0.2, 0.6));
    }

    #[test]
    fn vertices_of_the_target_are_their_own_images() {
        let target = ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3);
        let none = vec![0.0; target.n_vertices()];
        for (i, image) in
            images(&target, &ClosestPointIndex::new(&target), target.vertices(), &none, 1.0).iter().enumerate()
        {
            assert_eq!(image.label as usize, i);
            assert!((image.closest.point - target.vertices()[i]).norm() < 1e-9);
            assert!(image.confidence > 0.99);
        }
    }

    #[test]
    fn an_image_between_vertices_has_the_nearest_as_label() {
        let target = ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3);
        let points: Vec<Point3<f64>> = target
            .triangles()
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|k| target.vertices()[k as usize].coords);
                Point3::from(0.3 * a + 0.45 * b + 0.25 * c)
            })
            .collect();
        for (p, image) in points.iter().zip(images(
            &target,
            &ClosestPointIndex::new(&target),
            &points,
            &vec![0.75; points.len()],
            1.0,
        )) {
            let nearest = target.vertices().iter().map(|q| (q - p).norm()).fold(f64::INFINITY, f64::min);
            assert_eq!((target.vertices()[image.label as usize] - p).norm(), nearest);
            assert!((image.closest.point - p).norm() < 1e-9 && image.confidence < 0.99);
        }
    }
}
