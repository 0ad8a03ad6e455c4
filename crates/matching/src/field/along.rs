//! The error along the surface of answers that no rigid pose leads to.
//!
//! The posterior covariance of a field is that of its fit to a surface that lies close. From bending-invariant forms, and between
//! straightened tubes, a field also starts a little beside the truth, along the surface: forms distort what stretches, their
//! correspondences are those of a few hundred places, and a center line is known imprecisely. The pair itself shows how far. A map
//! that is off by `e` along the surface makes the curvatures of corresponding points differ: their correlation `c` falls by `e²`
//! over the squared distance within which curvature varies. It also strains the surface, by `e` over the distance within which the
//! error varies. Each of `1 − c` and the squared strain `ε²` has a share that is no error: sampling and bending change curvature, and bent
//! surfaces do stretch. Their geometric mean has less of either, and both distances are taken to be the same part of every surface.

use super::agreement::Agreement;
use super::strain::squared_strain;
use crate::pair::lengths::{Lengths, sampling_variance};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Squared error over the area of the surface and the geometric mean of `1 − c` and `ε²`. Fitted to the calibration of
/// confidences on each of six families of synthetic shapes by itself, its root is 0.053 to 0.055 (capsules bent by 90°, 120°
/// and 150°), 0.047 (animals in two poses), 0.048 (bodies of unlike build) and 0.057 (people in two poses): rounded.
const SHARE_OF_AREA: f64 = 0.0028;

/// Squared error along the surface, mm², of an answer that moves the vertices of `source` to `moved`, where the surfaces agree
/// so far. The error of the field and of sampling is part of it.
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

/// Raises variances of a field, mm², so that with that of sampling no image is expected to be nearer to the truth than
/// `squared_error`, mm².
pub(crate) fn raise(variances: &mut [f64], squared_error: f64, lengths: &Lengths) {
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

    /// An ellipsoid, and its vertices slid along it: about the x axis by an angle that varies along x.
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
        // A root of each of both: twice the strain, or four times the loss of correlation.
        assert!((error(1.0, 0.2, 0.96) / plain - 2f64.sqrt()).abs() < 0.02);
        assert!((error(1.0, 0.1, 0.84) / plain - 2f64.sqrt()).abs() < 1e-9);
        // By either sign alone there is none.
        assert!(error(1.0, 0.0, 0.96) < 0.01 * plain && error(1.0, 0.1, 1.0) == 0.0);
    }

    #[test]
    fn variances_are_raised_to_the_error_less_that_of_sampling_and_no_further() {
        let (mesh, moved, lengths) = slid(1.0, 0.5);
        let expected = squared_error(&mesh, &moved, &agreeing(0.5), &lengths);
        let sampling = sampling_variance(lengths.sampling_mm);
        assert!(expected > 2.0 * sampling, "{expected} {sampling}");
        let mut variances = [0.0, 0.5 * (expected - sampling), 3.0 * expected];
        raise(&mut variances, expected, &lengths);
        assert_eq!(variances, [expected - sampling, expected - sampling, 3.0 * expected]);
    }

    #[test]
    fn a_map_without_strain_keeps_the_variances_to_the_bit() {
        let (mesh, moved, lengths) = slid(1.0, 0.0);
        let before = [0.0, 0.1, 2.5];
        let mut variances = before;
        raise(&mut variances, squared_error(&mesh, &moved, &agreeing(0.7), &lengths), &lengths);
        assert_eq!(variances, before);
    }
}
