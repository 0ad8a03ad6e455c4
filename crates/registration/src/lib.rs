#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

mod absolute_orientation;
pub mod alignment;
pub mod deformation;
mod icp;
mod orientation_solvers;
mod pose_search;
mod principal_axes;
mod procrustes;
mod ransac;
mod rotation_axis;
mod same_pose;
mod similarity;
mod three_point;
mod transform;
mod triple;
mod two_sided;

pub use absolute_orientation::{OrientationError, absolute_orientation, absolute_orientation_of};
pub use icp::{ClosestSurfacePoint, IcpMetric, IcpOptions, IcpReport, refine_icp};
pub use orientation_solvers::{OrientationSolver, solve_orientation};
pub use pose_search::{PoseSearchOptions, ScoredPose, pose_search, surroundings};
pub use principal_axes::{principal_axis_poses, principal_directions, weighted_moments};
pub use procrustes::{ProcrustesOptions, ProcrustesReport, procrustes};
pub use ransac::{RansacMethods, RansacOptions, RansacReport, ransac, ransac_weighted, ransac_with};
pub use same_pose::{SAME_POSE_ANGLE, SamePose};
pub use similarity::SimilarityTransform;
pub use three_point::MinimalEstimator;
pub use transform::RigidTransform;
pub use triple::TripleError;
pub use two_sided::{SurfaceSide, TwoSidedOptions, TwoSidedReport, align_both_ways};

#[cfg(test)]
mod testing {
    //! Random points and poses for the tests.

    use super::RigidTransform;
    use nalgebra::{Point3, Rotation3, Vector3};
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    /// Uniform numbers in `[0, 1)`.
    pub(crate) fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        move || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Points in a box of 40 × 20 × 10 mm.
    pub(crate) fn cloud(seed: u64, n: usize) -> Vec<Point3<f64>> {
        let mut number = numbers(seed);
        (0..n).map(|_| Point3::new(40.0 * number(), 20.0 * number(), 10.0 * number())).collect()
    }

    /// Random unit vectors.
    pub(crate) fn directions(seed: u64, n: usize) -> Vec<Vector3<f64>> {
        let mut number = numbers(seed);
        (0..n).map(|_| Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5).normalize()).collect()
    }

    /// A random rotation, and a translation of up to 50 mm along each axis.
    pub(crate) fn pose(seed: u64) -> RigidTransform {
        let mut number = numbers(seed);
        let axis = Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5);
        let angle = std::f64::consts::PI * number();
        let rotation = *Rotation3::new(axis.normalize() * angle).matrix();
        let translation = Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5) * 100.0;
        RigidTransform { rotation, translation }
    }
}
