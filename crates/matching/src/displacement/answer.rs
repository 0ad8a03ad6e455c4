//! Images of source vertices between target vertices, with a probability that they are close to the truth.
//!
//! The variance of an image rests on an amplitude and a noise that are themselves estimated from the pair, so that it is known
//! up to a factor. Errors of which only that is known follow Student's t instead of a normal distribution: more of them are
//! small, and more are large, than their variance would have it.
//!
//! Source: Gelman et al., "Bayesian Data Analysis", 3rd edition, 2013, section 3.2 (t as a mixture of normal distributions).

use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use homolog_primitives::points::NeighborGrid;
use nalgebra::Point3;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Squared error of an image that no field explains, in squared sampling distances. Fitted with the share of the field's
/// covariance that counts.
const SAMPLING_VARIANCE: f64 = 0.039;
/// Degrees of freedom of the errors, and their scale in standard deviations of the estimated variance. Chosen on the calibration of
/// confidences of five families (people, bodies, beans, hippocampi with warps of all widths, bent capsules; 17 sets, each family with
/// one weight) from 4 to 12 and 0.825 to 0.95; without each of the families in turn the best are 6 to 12 and 0.925 to 0.95.
const DEGREES_OF_FREEDOM: f64 = 8.0;
const ERROR_SCALE: f64 = 0.925;
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
    let radii = equally_probable_radii();
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
            let scale = ERROR_SCALE * (variance / 2.0).sqrt();
            let confidence = within(edge_mm, best.0.sqrt(), scale, &radii);
            let spread_mm = scale * (2.0 * DEGREES_OF_FREEDOM / (DEGREES_OF_FREEDOM - 2.0)).sqrt();
            Image { moved: *p, closest, label: best.1, confidence, spread_mm }
        })
        .collect()
}

/// Lengths of an error in a plane, of Student's t with scale 1 along each axis, in the middles of intervals of one probability.
fn equally_probable_radii() -> [f64; RADII] {
    std::array::from_fn(|k| {
        // The length that is exceeded with the probability `q` has (1 + r²/ν)^(−ν/2) = q.
        let exceeded = (k as f64 + 0.5) / RADII as f64;
        (DEGREES_OF_FREEDOM * (exceeded.powf(-2.0 / DEGREES_OF_FREEDOM) - 1.0)).sqrt()
    })
}

/// Probability that an error in a plane, of Student's t with this `scale` along each axis, ends within `radius` of a point that
/// is `offset` away; by quadrature at these `radii` and equally spaced angles.
fn within(radius: f64, offset: f64, scale: f64, radii: &[f64; RADII]) -> f64 {
    let mut hits = 0.0;
    for r in radii.map(|r| scale * r) {
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
    use crate::testing::numbers;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    /// An error in a plane that is normal with variances drawn from the inverse gamma distribution whose mixture
    /// is Student's t with this scale.
    fn drawn(number: &mut impl FnMut() -> f64, scale: f64) -> [f64; 2] {
        let mut normal = || (0..12).map(|_| number()).sum::<f64>() - 6.0;
        let chi_squared: f64 = (0..DEGREES_OF_FREEDOM as usize).map(|_| normal().powi(2)).sum();
        let sigma = scale * (DEGREES_OF_FREEDOM / chi_squared).sqrt();
        [sigma * normal(), sigma * normal()]
    }

    #[test]
    fn the_probability_is_that_of_normal_errors_of_uncertain_variance() {
        let mut number = numbers(5);
        let radii = equally_probable_radii();
        let probability = |radius: f64, offset: f64, scale: f64| within(radius, offset, scale, &radii);
        for (offset, scale) in [(0.0, 0.2f64), (0.0, 0.5), (0.4, 0.5), (0.3, 1.0), (0.7, 0.3)] {
            let n = 20_000;
            let is_hit = |[x, y]: [f64; 2]| (x + offset).powi(2) + y * y <= 1.0;
            let hits = (0..n).filter(|_| is_hit(drawn(&mut number, scale))).count() as f64 / f64::from(n);
            assert!((probability(1.0, offset, scale) - hits).abs() < 0.03, "{offset} {scale}: {hits}");
        }
        // On the edge of a wide disc a small error falls within as often as not.
        assert!((probability(100.0, 100.0, 0.1) - 0.5).abs() < 0.05);
        assert!(probability(1.0, 0.2, 0.3) > probability(1.0, 0.6, 0.3));
        assert!(probability(1.0, 0.2, 0.3) > probability(1.0, 0.2, 0.6));
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
