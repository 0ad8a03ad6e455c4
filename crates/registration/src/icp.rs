//! Trimmed iterative closest points.
//!
//! Source: Besl, McKay 1992 (point-to-point); Chen, Medioni 1992 (point-to-plane, linearized for small rotations);
//! Chetverikov et al. 2002 (trimming: only the closest share of the points is used).

use super::{RigidTransform, absolute_orientation};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::{Matrix6, Point3, Rotation3, Vector3, Vector6};
use rayon::prelude::*;

/// Finds the closest point of a surface.
pub trait ClosestSurfacePoint: Sync {
    /// The closest point, mm, and the unit normal of the surface there.
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>);

    /// The closest point, unless it lies on the rim of an open surface: the counterpart of `query` may then lie beyond
    /// the rim, where the surface is missing.
    fn closest_inside(&self, query: &Point3<f64>) -> Option<(Point3<f64>, Vector3<f64>)> {
        Some(self.closest(query))
    }
}

/// The distance that ICP minimizes between a point and its closest point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IcpMetric {
    /// Euclidean distance.
    PointToPoint,
    /// Distance along the normal of the target.
    PointToPlane,
}

/// Options of the refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IcpOptions {
    /// The distance to minimize.
    pub metric: IcpMetric,
    /// Share of the points that is used, in `(0, 1]`: the points closest to the target.
    pub keep: f64,
    /// Largest number of iterations.
    pub max_iterations: u32,
    /// The iteration ends when a step rotates by less than this, radians, and moves the centroid by less than this
    /// share of the extent.
    pub tolerance: f64,
}

/// The result of [`refine_icp`].
#[derive(Debug, Clone, PartialEq)]
pub struct IcpReport {
    /// The refined transform.
    pub target_from_source: RigidTransform,
    /// Number of iterations.
    pub iterations: u32,
    /// Root mean square distance of the points used in the last iteration, before its step, mm.
    pub rms_mm: f64,
    /// Whether the last step was below the tolerance.
    pub converged: bool,
}

/// Refines `start`, the transform from `source` (mm) to the surface `target`, by trimmed ICP. A reflection in `start`
/// is kept.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// `O(iterations · n log n)`, with closest points on all threads and sums in the order of the points, so any number of
/// threads gives the same bits.
pub fn refine_icp(
    source: &[Point3<f64>],
    target: &dyn ClosestSurfacePoint,
    start: &RigidTransform,
    options: &IcpOptions,
    observer: &dyn Observer,
) -> Result<IcpReport, Cancelled> {
    let mut report = IcpReport { target_from_source: *start, iterations: 0, rms_mm: f64::NAN, converged: false };
    let extent = extent(source);
    while report.iterations < options.max_iterations && !report.converged {
        checkpoint(observer)?;
        let moved: Vec<Point3<f64>> = source.iter().map(|p| report.target_from_source.apply(p)).collect();
        let closest: Vec<(Point3<f64>, Vector3<f64>)> = moved.par_iter().map(|p| target.closest(p)).collect();
        let squared: Vec<f64> = moved.iter().zip(&closest).map(|(p, (q, _))| (p - q).norm_squared()).collect();
        let kept = closest_share(&squared, options.keep);
        report.rms_mm = (kept.iter().map(|&i| squared[i]).sum::<f64>() / kept.len() as f64).sqrt();
        report.iterations += 1;
        let step = match options.metric {
            IcpMetric::PointToPoint => {
                let from: Vec<_> = kept.iter().map(|&i| moved[i]).collect();
                let to: Vec<_> = kept.iter().map(|&i| closest[i].0).collect();
                absolute_orientation(&from, &to, None, false).ok()
            }
            IcpMetric::PointToPlane => point_to_plane_step(&moved, &closest, &kept),
        };
        let Some(step) = step else { break };
        let center = moved.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / moved.len() as f64;
        let shift = (step.apply(&Point3::from(center)).coords - center).norm();
        report.target_from_source = step.after(&report.target_from_source);
        report.converged = step.angle_rad() < options.tolerance && shift < options.tolerance * extent;
    }
    Ok(report)
}

/// Diagonal of the bounding box, mm.
pub(crate) fn extent(points: &[Point3<f64>]) -> f64 {
    let (low, high) = points
        .iter()
        .fold((Point3::from([f64::INFINITY; 3]), Point3::from([f64::NEG_INFINITY; 3])), |(low, high), p| {
            (low.inf(p), high.sup(p))
        });
    (high - low).norm()
}

/// Indices, ascending, of the `keep` share with the smallest values; at least three.
fn closest_share(values: &[f64], keep: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    let n = ((values.len() as f64 * keep).ceil() as usize).clamp(3.min(values.len()), values.len());
    if n < values.len() {
        order.select_nth_unstable_by(n, |&a, &b| values[a].total_cmp(&values[b]).then(a.cmp(&b)));
        order.truncate(n);
        order.sort_unstable();
    }
    order
}

/// One Gauss-Newton step of `Σ (n · (ω × (p − c) + v + p − q))²` about the centroid `c`.
fn point_to_plane_step(
    moved: &[Point3<f64>],
    closest: &[(Point3<f64>, Vector3<f64>)],
    kept: &[usize],
) -> Option<RigidTransform> {
    let center = kept.iter().fold(Vector3::zeros(), |s, &i| s + moved[i].coords) / kept.len() as f64;
    let (mut normal_matrix, mut right_side) = (Matrix6::<f64>::zeros(), Vector6::<f64>::zeros());
    for &i in kept {
        let (q, n) = &closest[i];
        let arm = (moved[i].coords - center).cross(n);
        let row = Vector6::new(arm.x, arm.y, arm.z, n.x, n.y, n.z);
        normal_matrix += row * row.transpose();
        right_side -= row * n.dot(&(moved[i] - q));
    }
    let solution = normal_matrix.cholesky()?.solve(&right_side);
    let rotation = *Rotation3::new(solution.fixed_rows::<3>(0).into_owned()).matrix();
    let translation = center + solution.fixed_rows::<3>(3) - rotation * center;
    Some(RigidTransform { rotation, translation })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::cloud;
    use homolog_primitives::observe::Silent;

    /// An ellipsoid with the given half axes.
    struct Ellipsoid(Vector3<f64>);

    impl ClosestSurfacePoint for Ellipsoid {
        /// The closest point is `aᵢ² qᵢ / (t + aᵢ²)` for the `t` that puts it on the surface, found by bisection.
        fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
            let squares = self.0.component_mul(&self.0);
            let at = |t: f64| squares.component_mul(&query.coords).component_div(&squares.add_scalar(t));
            let (mut low, mut high) = (-squares.min() * (1.0 - 1e-9), 1e4);
            for _ in 0..200 {
                let middle = (low + high) / 2.0;
                let outside = at(middle).component_div(&self.0).norm() > 1.0;
                (low, high) = if outside { (middle, high) } else { (low, middle) };
            }
            (Point3::from(at(low)), at(low).component_div(&squares).normalize())
        }
    }

    #[test]
    fn a_small_motion_is_undone_by_both_metrics() {
        let surface = Ellipsoid(Vector3::new(20.0, 9.0, 5.0));
        let center = Vector3::new(20.0, 10.0, 5.0);
        let points: Vec<_> =
            cloud(3, 400).iter().map(|p| surface.closest(&Point3::from((p.coords - center) * 3.0)).0).collect();
        let motion = RigidTransform {
            rotation: *Rotation3::new(Vector3::new(0.02, -0.01, 0.015)).matrix(),
            translation: Vector3::new(0.05, -0.02, 0.03),
        };
        let moved: Vec<_> = points.iter().map(|p| motion.apply(p)).collect();
        for metric in [IcpMetric::PointToPoint, IcpMetric::PointToPlane] {
            let options = IcpOptions { metric, keep: 0.9, max_iterations: 500, tolerance: 1e-10 };
            let report = refine_icp(&moved, &surface, &RigidTransform::identity(), &options, &Silent).unwrap();
            let expected = motion.inverse();
            assert!((report.target_from_source.rotation - expected.rotation).norm() < 1e-6, "{metric:?} {report:?}");
            assert!(report.converged);
        }
    }
}
