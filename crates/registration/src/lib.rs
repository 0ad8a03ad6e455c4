//! The rigid transform between two surfaces, from point pairs and from points alone.
//!
//! [`mod@absolute_orientation`] fits a transform to pairs; [`mod@ransac`] finds the pairs that agree with one transform among
//! many that do not, from minimal samples of three; [`refine_icp`] improves a transform by closest points. Two baselines
//! stand alone: [`procrustes()`] on given pairs, with scale on request, and [`register_by_icp`] from several starts. Nothing
//! here knows a mesh: points, pairs, and a [`ClosestSurfacePoint`] given by the caller.
//!
//! Transforms are `target_from_source`: `p' = R p + t`, mm.

mod absolute_orientation;
pub mod deformation;
mod icp;
mod icp_registration;
mod orientation_solvers;
mod pose_search;
mod principal_axes;
mod procrustes;
mod ransac;
mod rotation_axis;
mod similarity;
mod three_point;
mod transform;
mod two_sided;

pub use absolute_orientation::{OrientationError, absolute_orientation};
pub use icp::{ClosestSurfacePoint, IcpMetric, IcpOptions, IcpReport, refine_icp};
pub use icp_registration::{IcpCandidate, IcpRegistration, IcpStart, IcpStarts, RegisterByIcpOptions, register_by_icp};
pub use orientation_solvers::{OrientationSolver, solve_orientation};
pub use pose_search::{OrientedPoints, PoseSearchOptions, SAME_POSE_ANGLE, ScoredPose, pose_search};
pub use principal_axes::{principal_axis_poses, principal_directions, weighted_moments};
pub use procrustes::{ProcrustesOptions, ProcrustesReport, procrustes};
pub use ransac::{RansacMethods, RansacOptions, RansacReport, ransac, ransac_with};
pub use rotation_axis::rotation_axis_estimate;
pub use similarity::SimilarityTransform;
pub use three_point::{MinimalEstimator, TripleError, frame_estimate};
pub use transform::RigidTransform;
pub use two_sided::{SurfaceSide, TwoSidedOptions, TwoSidedReport, align_both_ways};

#[cfg(test)]
mod testing {
    //! Random points and poses for the tests of this module.

    use super::RigidTransform;
    use nalgebra::{Point3, Rotation3, Vector3};
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    /// Uniform numbers in `[0, 1)`.
    pub fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        move || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Points in a box of 40 × 20 × 10 mm.
    pub fn cloud(seed: u64, n: usize) -> Vec<Point3<f64>> {
        let mut number = numbers(seed);
        (0..n).map(|_| Point3::new(40.0 * number(), 20.0 * number(), 10.0 * number())).collect()
    }

    /// Any rotation, a translation of up to 50 mm an axis.
    pub fn pose(seed: u64) -> RigidTransform {
        let mut number = numbers(seed);
        let axis = Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5);
        let angle = std::f64::consts::PI * number();
        let rotation = *Rotation3::new(axis.normalize() * angle).matrix();
        let translation = Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5) * 100.0;
        RigidTransform { rotation, translation }
    }
}
