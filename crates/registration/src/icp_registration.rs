//! Registration by ICP alone, from several starts: the baseline that knows no correspondence.
//!
//! ICP ends in the minimum next to its start. Runs from several starts, on a sample, show which minima there are; the
//! best one is then finished with all points, and the others are reported with their residuals, so that a caller sees
//! how clear the choice was.

use super::icp::trimmed_rms;
use super::{ClosestSurfacePoint, IcpOptions, IcpReport, RigidTransform, principal_axis_poses, refine_icp};
use homolog_primitives::observe::{Cancelled, Observer};
use nalgebra::{Matrix3, Point3, Vector3};

/// Two runs that end within this angle, radians, and this share of the source's size are one minimum.
const SAME_ANGLE: f64 = 0.05;
const SAME_SHIFT: f64 = 0.02;

/// Where a run begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IcpStart {
    /// Principal axes on principal axes, one of the four proper ways, numbered as by [`principal_axis_poses`].
    PrincipalAxes(usize),
    /// No motion: the surfaces share a frame already.
    Identity,
    /// No rotation, centroid on centroid.
    Centroids,
}

/// Which starts are tried; at least one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IcpStarts {
    /// The four poses of the principal axes.
    pub principal_axes: bool,
    /// The identity.
    pub identity: bool,
    /// Centroid on centroid without a rotation.
    pub centroids: bool,
}

impl Default for IcpStarts {
    /// The principal axes only: they need no common frame.
    fn default() -> Self {
        IcpStarts { principal_axes: true, identity: false, centroids: false }
    }
}

/// How registration by ICP runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegisterByIcpOptions {
    /// Where runs begin.
    pub starts: IcpStarts,
    /// Source points at most in the runs that compare the starts, evenly by index; at least three.
    pub max_sample: usize,
    /// How each of those runs ends.
    pub screening: IcpOptions,
    /// How the best one is finished with all source points.
    pub refinement: IcpOptions,
}

/// The minimum that a run on the sample ended in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IcpCandidate {
    /// Where the run began.
    pub start: IcpStart,
    /// Where it ended.
    pub target_from_source: RigidTransform,
    /// Root mean square distance of the kept share of the sample there, mm; one measure for all candidates.
    pub rms_mm: f64,
    /// Iterations made.
    pub iterations: u32,
    /// Whether it ended by its tolerance.
    pub converged: bool,
}

/// The best minimum and its rivals.
#[derive(Debug, Clone, PartialEq)]
pub struct IcpRegistration {
    /// The best candidate, finished with all points.
    pub refined: IcpReport,
    /// Root mean square distance at the refined transform, of the kept share of all points, mm.
    pub rms_mm: f64,
    /// The best candidate, as the sample saw it.
    pub best: IcpCandidate,
    /// Other minima, the smallest residual first; runs that ended in one minimum are named once, by the best of them.
    pub runner_ups: Vec<IcpCandidate>,
}

/// Registers `source` to the surface `closest` by ICP from several starts.
///
/// `source`: points, mm; `target`: points of the target surface, mm, of which only the centroid and principal axes are
/// used. `None` if either has fewer than three points, or no start is chosen. Candidates are ordered by their residual,
/// those with equal ones by the order of the starts.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// One ICP run on the sample for each start, and one on all points.
pub fn register_by_icp(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    closest: &dyn ClosestSurfacePoint,
    options: &RegisterByIcpOptions,
    observer: &dyn Observer,
) -> Result<Option<IcpRegistration>, Cancelled> {
    let sample: Vec<Point3<f64>> =
        source.iter().step_by(source.len().div_ceil(options.max_sample.max(3)).max(1)).copied().collect();
    let mut candidates = Vec::new();
    for (start, pose) in starting_poses(source, target, options.starts) {
        let report = refine_icp(&sample, closest, &pose, &options.screening, observer)?;
        candidates.push(IcpCandidate {
            start,
            target_from_source: report.target_from_source,
            rms_mm: trimmed_rms(&sample, closest, &report.target_from_source, options.screening.keep),
            iterations: report.iterations,
            converged: report.converged,
        });
    }
    // Stable: equal residuals stay in the order of the starts.
    candidates.sort_by(|a, b| a.rms_mm.total_cmp(&b.rms_mm));
    let mut minima = distinct(candidates, source).into_iter();
    let Some(best) = minima.next() else { return Ok(None) };
    let refined = refine_icp(source, closest, &best.target_from_source, &options.refinement, observer)?;
    let rms_mm = trimmed_rms(source, closest, &refined.target_from_source, options.refinement.keep);
    Ok(Some(IcpRegistration { refined, rms_mm, best, runner_ups: minima.collect() }))
}

fn starting_poses(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    starts: IcpStarts,
) -> Vec<(IcpStart, RigidTransform)> {
    let Some(on_axes) = principal_axis_poses(source, target) else { return Vec::new() };
    let mut poses = Vec::new();
    if starts.principal_axes {
        poses.extend(on_axes.into_iter().enumerate().map(|(k, pose)| (IcpStart::PrincipalAxes(k), pose)));
    }
    if starts.identity {
        poses.push((IcpStart::Identity, RigidTransform::identity()));
    }
    if starts.centroids {
        let translation = centroid(target) - centroid(source);
        poses.push((IcpStart::Centroids, RigidTransform { rotation: Matrix3::identity(), translation }));
    }
    poses
}

fn centroid(points: &[Point3<f64>]) -> Vector3<f64> {
    points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64
}

/// `candidates` without those that ended where an earlier one did.
fn distinct(candidates: Vec<IcpCandidate>, source: &[Point3<f64>]) -> Vec<IcpCandidate> {
    let mut kept: Vec<IcpCandidate> = Vec::new();
    if candidates.is_empty() {
        return kept;
    }
    let center = Point3::from(centroid(source));
    let radius = source.iter().map(|p| (p - center).norm()).fold(0.0, f64::max);
    for candidate in candidates {
        let place = |c: &IcpCandidate| c.target_from_source.apply(&center);
        let known = kept.iter().any(|k| {
            k.target_from_source.angle_to(&candidate.target_from_source) < SAME_ANGLE
                && (place(k) - place(&candidate)).norm() < SAME_SHIFT * radius
        });
        if !known {
            kept.push(candidate);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::IcpMetric;
    use crate::testing::pose;
    use homolog_primitives::observe::Silent;

    /// A closed blob known by many of its points: the closest of them is the closest point, its direction the normal.
    struct Cloud(Vec<(Point3<f64>, Vector3<f64>)>);

    impl ClosestSurfacePoint for Cloud {
        fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
            let near = self.0.iter().min_by(|a, b| (a.0 - query).norm().total_cmp(&(b.0 - query).norm())).unwrap();
            *near
        }
    }

    /// A lopsided ellipsoid by `n` points on a spiral: no half turn maps it to itself.
    fn blob(n: usize) -> Vec<(Point3<f64>, Vector3<f64>)> {
        (0..n)
            .map(|k| {
                let z: f64 = 1.0 - 2.0 * (k as f64 + 0.5) / n as f64;
                let (sin, cos) = (2.399963229728653 * k as f64).sin_cos();
                let ring = (1.0 - z * z).sqrt();
                let (x, y) = (ring * cos, ring * sin);
                let width = 1.0 + 0.35 * x;
                let p = Point3::new(14.0 * x, 6.0 * y * width + 3.0 * x * x, 4.0 * z * width + 1.5 * x * y);
                (p, Vector3::new(x, y, z))
            })
            .collect()
    }

    fn options(starts: IcpStarts) -> RegisterByIcpOptions {
        let icp = IcpOptions { metric: IcpMetric::PointToPoint, keep: 0.9, max_iterations: 60, tolerance: 1e-6 };
        RegisterByIcpOptions { starts, max_sample: 200, screening: icp, refinement: icp }
    }

    #[test]
    fn a_moved_copy_is_found_from_any_pose_and_its_rivals_are_worse() {
        let surface = blob(600);
        let target: Vec<_> = surface.iter().map(|s| s.0).collect();
        let closest = Cloud(surface.clone());
        for seed in 0..3 {
            let truth = pose(seed);
            let source: Vec<_> = target.iter().step_by(2).map(|p| truth.inverse().apply(p)).collect();
            let found =
                register_by_icp(&source, &target, &closest, &options(IcpStarts::default()), &Silent).unwrap().unwrap();
            let angle = found.refined.target_from_source.angle_to(&truth).to_degrees();
            assert!(angle < 0.5, "seed {seed}: {angle} degrees");
            assert!(found.rms_mm < 0.05 && !found.runner_ups.is_empty());
            assert!(found.runner_ups.iter().all(|r| r.rms_mm > 2.0 * found.best.rms_mm));
            assert!(found.runner_ups.is_sorted_by(|a, b| a.rms_mm <= b.rms_mm));
        }
    }

    #[test]
    fn starts_without_a_rotation_serve_small_motions_and_end_in_one_minimum() {
        let surface = blob(600);
        let target: Vec<_> = surface.iter().map(|s| s.0).collect();
        let source: Vec<_> = target.iter().map(|p| p + Vector3::new(0.08, -0.05, 0.03)).collect();
        let starts = IcpStarts { principal_axes: false, identity: true, centroids: true };
        let found = register_by_icp(&source, &target, &Cloud(surface), &options(starts), &Silent).unwrap().unwrap();
        assert!(found.rms_mm < 0.01 && found.runner_ups.is_empty(), "{found:?}");
        assert_eq!(found.best.start, IcpStart::Centroids);
    }

    #[test]
    fn nothing_comes_of_two_points_or_no_start() {
        let surface = blob(50);
        let target: Vec<_> = surface.iter().map(|s| s.0).collect();
        let closest = Cloud(surface);
        let run =
            |n: usize, starts| register_by_icp(&target[..n], &target, &closest, &options(starts), &Silent).unwrap();
        assert_eq!(run(2, IcpStarts::default()), None);
        assert_eq!(run(50, IcpStarts { principal_axes: false, identity: false, centroids: false }), None);
    }
}
