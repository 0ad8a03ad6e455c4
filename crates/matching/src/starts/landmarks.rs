//! The pose of the landmarks.

use homolog_contract::parameters::Landmark;
use homolog_registration::{RigidTransform, absolute_orientation};
use nalgebra::Point3;

/// The rigid transform of the landmarks alone, weighted by their precisions, if three or more determine it.
pub(crate) fn landmark_pose(landmarks: &[Landmark], allow_reflection: bool) -> Option<RigidTransform> {
    let of = |point: fn(&Landmark) -> [f64; 3]| -> Vec<Point3<f64>> {
        landmarks.iter().map(|l| Point3::from(point(l))).collect()
    };
    let weights: Vec<f64> = landmarks.iter().map(|l| 1.0 / (l.sigma_mm * l.sigma_mm)).collect();
    absolute_orientation(&of(|l| l.source_mm), &of(|l| l.target_mm), Some(&weights), allow_reflection).ok()
}
