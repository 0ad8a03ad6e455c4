//! Error along the surface of answers that do not begin at a rigid pose.
//!
//! A fit that begins at bending-invariant forms or at straightened tubes is biased along the surface: stretching
//! distorts forms, forms give correspondences of a few hundred sites only, and center lines are imprecise. The
//! posterior covariance of the field does not contain this bias, so it is estimated from the pair. An error `e` along
//! the surface lowers the correlation `c` of the curvatures of corresponding points by `e²` over the squared distance
//! within which curvature varies, and strains the surface by `e` over the distance within which the error varies.
//! Sampling and bending also change curvature, and bent surfaces stretch, so `1 − c` and the squared strain `ε²` each
//! overestimate the error. Their geometric mean is less affected. Both distances are assumed to be a constant share of
//! the root of the area.

use super::agreement::Agreement;
use super::strain::squared_strain;
use crate::pair::lengths::{Lengths, sampling_variance};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Squared error over the product of the area of the surface and the geometric mean of `1 − c` and `ε²`. Without unit;
/// fitted.
const SHARE_OF_AREA: f64 = 0.0028;

/// Squared error along the surface, mm², of an answer that moves the vertices of `source` to `moved`, for surfaces of
/// this `agreement`. It includes the errors of the field and of sampling.
///
/// Cost `O(n)`.
pub(crate) fn squared_error(
    source: &SurfaceMesh,
    moved: &[Point3<f64>],
    agreement: &Agreement,
    lengths: &Lengths,
) -> f64 {
    let unlike = (1.0 - agreement.curvature).max(0.0);
    SHARE_OF_AREA * lengths.root_mm * lengths.root_mm * (unlike * squared_strain(source, moved)).sqrt()
}

/// Raises the `variances` of a field, mm², so that each, together with the variance of sampling, is at least
/// `squared_error`, mm².
pub(crate) fn raise_variances(variances: &mut [f64], squared_error: f64, lengths: &Lengths) {
    let least = squared_error - sampling_variance(lengths.sampling_mm);
    variances.iter_mut().for_each(|variance| *variance = variance.max(least));
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    fn agreeing(curvature: f64) -> Agreement {
        Agreement { curvature, normals: 1.0 }
    }

    /// An ellipsoid, and its vertices slid along its surface: rotated about the x axis by an angle that varies along x.
    fn slid(size: f64, angle: f64) -> (SurfaceMesh, Vec<Point3<f64>>, Lengths) {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 5.0) * size, 4);
        let turn = |p: &Point3<f64>| {
            let by = angle * (0.6 * p.x / size).sin();
            nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), by) * p
        };
        let moved = mesh.vertices().iter().map(turn).collect();
        let lengths = Lengths { root_mm: mesh.area().sqrt(), sampling_mm: mesh.mean_edge_length() };
        (mesh, moved, lengths)
    }

    #[test]
    fn the_error_is_a_length_and_grows_with_the_slide() {
        let error = |size: f64, angle: f64, curvature: f64| {
            let (mesh, moved, lengths) = slid(size, angle);
            squared_error(&mesh, &moved, &agreeing(curvature), &lengths).sqrt()
        };
        let plain = error(1.0, 0.1, 0.96);
        assert!((error(8.0, 0.1, 0.96) / plain - 8.0).abs() < 1e-9);
        // The error is the square root of either: of twice the strain, or of four times the loss of correlation.
        assert!((error(1.0, 0.2, 0.96) / plain - 2f64.sqrt()).abs() < 0.02);
        assert!((error(1.0, 0.1, 0.84) / plain - 2f64.sqrt()).abs() < 1e-9);
        // Strain alone, or a loss of correlation alone, gives no error.
        assert!(error(1.0, 0.0, 0.96) < 0.01 * plain && error(1.0, 0.1, 1.0) == 0.0);
    }

    #[test]
    fn variances_are_raised_to_the_error_less_that_of_sampling_and_no_further() {
        let (mesh, moved, lengths) = slid(1.0, 0.5);
        let expected = squared_error(&mesh, &moved, &agreeing(0.5), &lengths);
        let sampling = sampling_variance(lengths.sampling_mm);
        assert!(expected > 2.0 * sampling, "{expected} {sampling}");
        let mut variances = [0.0, 0.5 * (expected - sampling), 3.0 * expected];
        raise_variances(&mut variances, expected, &lengths);
        assert_eq!(variances, [expected - sampling, expected - sampling, 3.0 * expected]);
    }

    #[test]
    fn a_map_without_strain_keeps_the_variances_to_the_bit() {
        let (mesh, moved, lengths) = slid(1.0, 0.0);
        let before = [0.0, 0.1, 2.5];
        let mut variances = before;
        raise_variances(&mut variances, squared_error(&mesh, &moved, &agreeing(0.7), &lengths), &lengths);
        assert_eq!(variances, before);
    }
}
