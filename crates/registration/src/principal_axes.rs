//! Candidate poses that align the principal axes of two point sets.

use super::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};

/// The four proper rotations that align the principal axes of `source` with those of `target`, with coincident
/// centroids.
///
/// Axes have no sign, so there are four candidates, which differ by rotations of 180° about the axes. `None` for fewer
/// than three points. Cost `O(n)`.
pub fn principal_axis_poses(source: &[Point3<f64>], target: &[Point3<f64>]) -> Option<[RigidTransform; 4]> {
    if source.len().min(target.len()) < 3 {
        return None;
    }
    let (source_center, source_axes) = axes(source);
    let (target_center, target_axes) = axes(target);
    Some([[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[a, b]| {
        let signs = Matrix3::from_diagonal(&Vector3::new(a, b, a * b));
        let rotation = target_axes * signs * source_axes.transpose();
        RigidTransform { rotation, translation: target_center - rotation * source_center }
    }))
}

/// Weighted centroid, mm, of `points`, and the sum of `weight · d dᵀ` over their offsets `d` from it. `weights` are
/// areas or volumes with the sum `total`. `None` if the result is not finite, because an eigendecomposition of it would
/// not terminate. Cost `O(n)`.
pub fn weighted_moments(points: &[Point3<f64>], weights: &[f64], total: f64) -> Option<(Vector3<f64>, Matrix3<f64>)> {
    let weighted = || points.iter().zip(weights);
    let center = weighted().fold(Vector3::zeros(), |s, (p, &w)| s + p.coords * w) / total;
    let scatter = weighted().fold(Matrix3::zeros(), |s, (p, &w)| {
        let d = p.coords - center;
        s + d * d.transpose() * w
    });
    scatter.iter().all(|c| c.is_finite()).then_some((center, scatter))
}

/// The eigenvectors of a symmetric, finite matrix as columns, by descending eigenvalue. Signs are arbitrary.
pub fn principal_directions(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let eigen = matrix.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    Matrix3::from_columns(&order.map(|k| eigen.eigenvectors.column(k).into_owned()))
}

/// Centroid, and the principal axes as columns of a rotation, longest first.
fn axes(points: &[Point3<f64>]) -> (Vector3<f64>, Matrix3<f64>) {
    let n = points.len() as f64;
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / n;
    let covariance = points.iter().fold(Matrix3::zeros(), |s, p| {
        let d = p.coords - center;
        s + d * d.transpose()
    });
    let directions = principal_directions(&covariance);
    let (first, second) = (directions.column(0), directions.column(1));
    (center, Matrix3::from_columns(&[first.into(), second.into(), first.cross(&second)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn one_of_the_four_undoes_any_pose(seed in any::<u64>()) {
            let (points, truth) = (cloud(seed, 60), pose(seed ^ 1));
            let moved: Vec<_> = points.iter().map(|p| truth.apply(p)).collect();
            let poses = principal_axis_poses(&points, &moved).unwrap();
            let nearest = poses.iter().map(|p| p.angle_to(&truth)).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest < 1e-6, "{nearest}");
            prop_assert!(poses.iter().all(|p| (p.rotation.determinant() - 1.0).abs() < 1e-9));
        }
    }
}
