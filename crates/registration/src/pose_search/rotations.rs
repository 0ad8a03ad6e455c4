//! A low-discrepancy sample of all rotations.
//!
//! Source: Alexa, "Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3)", CVPR 2022.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion};
use std::f64::consts::{SQRT_2, TAU};

/// The root of `ψ⁴ = ψ + 4` above 1, the second of the two irrational frequencies of the spiral.
const PSI: f64 = 1.533_751_168_755_204_3;

/// `n` rotations on a spiral through the unit quaternions; deterministic. Cost `O(n)`.
pub(super) fn spread_rotations(n: usize) -> Vec<Matrix3<f64>> {
    let along = |k: usize| {
        let s = k as f64 + 0.5;
        let share = s / n as f64;
        let (first, second) = ((TAU * s / SQRT_2).sin_cos(), (TAU * s / PSI).sin_cos());
        let (near, far) = (share.sqrt(), (1.0 - share).sqrt());
        Quaternion::new(far * second.1, near * first.0, near * first.1, far * second.0)
    };
    (0..n).map(|k| *UnitQuaternion::new_normalize(along(k)).to_rotation_matrix().matrix()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RigidTransform;
    use crate::testing::pose;
    use nalgebra::Vector3;

    #[test]
    fn every_rotation_is_within_32_degrees_of_one_of_600_on_the_spiral() {
        let spread = spread_rotations(600);
        let nearest = |seed: u64| {
            let angle = |r: &Matrix3<f64>| {
                pose(seed).angle_to(&RigidTransform { rotation: *r, translation: Vector3::zeros() }).to_degrees()
            };
            spread.iter().map(angle).fold(f64::INFINITY, f64::min)
        };
        let farthest = (0..500).map(nearest).fold(0.0, f64::max);
        assert!(farthest < 32.0, "{farthest} degrees");
    }
}
