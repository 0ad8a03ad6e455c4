//! Registration by first-order ellipsoids, which aligns their centers and axes.
//!
//! Axes have no sign, so four proper rotations align them; these differ by rotations of 180°. The ellipsoids do not
//! determine the right rotation; the distances between the surfaces do.

use super::FirstOrderEllipsoid;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use homolog_registration::{ClosestSurfacePoint, RigidTransform};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Options of the alignment of ellipsoids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipsoidOptions {
    /// Ratio of two half axes of one ellipsoid below which the rotation about the third is ambiguous.
    pub ambiguous_ratio: f64,
    /// Whether to choose the pose with the smallest residual; otherwise the pose with the smallest rotation is chosen.
    pub resolve: bool,
    /// Largest number of source points on which residuals are measured, spaced evenly by index.
    pub max_sample: usize,
}

impl Default for EllipsoidOptions {
    fn default() -> Self {
        EllipsoidOptions { ambiguous_ratio: 1.1, resolve: true, max_sample: 500 }
    }
}

/// One of the four alignments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipsoidPose {
    /// The transform; `det R = +1`.
    pub target_from_source: RigidTransform,
    /// Angle of its rotation, radians, in `[0, π]`.
    pub rotation_angle_rad: f64,
    /// Root mean square distance of the moved source sample from the target surface, mm.
    pub rms_mm: f64,
}

/// The four alignments, and the chosen one.
#[derive(Debug, Clone, PartialEq)]
pub struct EllipsoidRegistration {
    /// All four, the smallest rotation first.
    pub poses: [EllipsoidPose; 4],
    /// Index of the chosen pose: 0, or with [`EllipsoidOptions::resolve`] the index of the smallest residual.
    pub chosen: usize,
    /// First over second and second over third half axis of the source's ellipsoid.
    pub source_axis_ratios: [f64; 2],
    /// The same ratios of the target's ellipsoid.
    pub target_axis_ratios: [f64; 2],
    /// Whether one of those four ratios is below [`EllipsoidOptions::ambiguous_ratio`]: then more than these four poses
    /// align the ellipsoids.
    pub ambiguous_axes: bool,
}

impl EllipsoidRegistration {
    /// The chosen pose.
    pub fn pose(&self) -> &EllipsoidPose {
        &self.poses[self.chosen]
    }
}

/// Aligns the ellipsoid of the source with the ellipsoid of the target.
///
/// `points`: points of the source surface, mm, at least one; `closest`: the target surface.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// Four closest-point queries per sampled point, on all threads; any number of threads gives the same bits.
pub fn register_by_ellipsoids(
    source: &FirstOrderEllipsoid,
    target: &FirstOrderEllipsoid,
    points: &[Point3<f64>],
    closest: &dyn ClosestSurfacePoint,
    options: &EllipsoidOptions,
    observer: &dyn Observer,
) -> Result<EllipsoidRegistration, Cancelled> {
    checkpoint(observer)?;
    let sample: Vec<Point3<f64>> =
        points.iter().step_by(points.len().div_ceil(options.max_sample.max(1)).max(1)).copied().collect();
    let mut poses = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[a, b]| {
        let signs = Matrix3::from_diagonal(&Vector3::new(a, b, a * b));
        let rotation = target.axes * signs * source.axes.transpose();
        let translation = target.center.coords - rotation * source.center.coords;
        let target_from_source = RigidTransform { rotation, translation };
        let squares: Vec<f64> = sample
            .par_iter()
            .map(|p| {
                let moved = target_from_source.apply(p);
                (closest.closest(&moved).0 - moved).norm_squared()
            })
            .collect();
        let rms_mm = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        EllipsoidPose { target_from_source, rotation_angle_rad: target_from_source.angle_rad(), rms_mm }
    });
    poses.sort_by(|a, b| a.rotation_angle_rad.total_cmp(&b.rotation_angle_rad));
    let mut chosen = 0;
    if options.resolve {
        for (k, pose) in poses.iter().enumerate() {
            if pose.rms_mm < poses[chosen].rms_mm {
                chosen = k;
            }
        }
    }
    let (source_axis_ratios, target_axis_ratios) = (source.axis_ratios(), target.axis_ratios());
    let ambiguous_axes =
        source_axis_ratios.iter().chain(&target_axis_ratios).any(|&ratio| ratio < options.ambiguous_ratio);
    Ok(EllipsoidRegistration { poses, chosen, source_axis_ratios, target_axis_ratios, ambiguous_axes })
}
