//! Rigid poses to start from: of an earlier stage, of landmarks, of a search and its rotations.

use super::landmarks::landmark_pose;
use super::rotations::rotations_of_best;
use super::search::searched;
use super::start_pose::StartPose;
use crate::pair::problem::Coarse;
use homolog_contract::result::PoseOrigin;
use homolog_registration::{RigidTransform, ScoredPose};

/// A rigid pose to start from.
pub(crate) struct Start {
    pub origin: PoseOrigin,
    pub pose: RigidTransform,
    /// The index of the start that was rotated to give this one.
    pub rotation_of: Option<usize>,
}

impl Start {
    fn new(origin: PoseOrigin, pose: RigidTransform) -> Start {
        Start { origin, pose, rotation_of: None }
    }
}

/// Rigid poses to start from, the most trusted first.
pub(crate) struct Starts {
    pub poses: Vec<Start>,
    /// All that the search found, the best first.
    of_search: Vec<ScoredPose>,
}

impl Starts {
    /// The pose that an earlier stage found, alone.
    pub(crate) fn of(own: Option<(PoseOrigin, RigidTransform)>) -> Starts {
        let poses = own.map(|(origin, pose)| Start::new(origin, pose)).into_iter().collect();
        Starts { poses, of_search: Vec::new() }
    }

    /// The pose that an earlier stage found, that of the landmarks, and those of a search of all orientations.
    pub(crate) fn with_search(coarse: &Coarse<'_>, own: Option<(PoseOrigin, RigidTransform)>) -> Starts {
        let parameters = coarse.full.parameters;
        let Starts { mut poses, .. } = Starts::of(own);
        let of_landmarks = landmark_pose(&parameters.landmarks, parameters.registration.allow_reflection);
        poses.extend(of_landmarks.map(|pose| Start::new(PoseOrigin::Landmarks, pose)));
        // Of either handedness, so that a mirrored image is noticed.
        let of_search = searched(&coarse.source.middle, &coarse.target.middle, true);
        let first = poses.len();
        poses.extend(of_search.iter().map(|p| Start::new(PoseOrigin::Search, p.target_from_source)));
        let rotations = rotations_of_best(&coarse.source.middle, &of_search);
        let rotation = |(k, pose)| Start { rotation_of: Some(first + k), ..Start::new(PoseOrigin::Search, pose) };
        poses.extend(rotations.into_iter().map(rotation));
        Starts { poses, of_search }
    }

    /// The most trusted pose that may be answered.
    pub(crate) fn first(&self, coarse: &Coarse<'_>) -> Option<RigidTransform> {
        let allow_reflection = coarse.full.parameters.registration.allow_reflection;
        self.poses.iter().map(|start| start.pose).find(|pose| allow_reflection || !pose.is_reflection())
    }

    /// These poses, each with how much worse than the best the search found it.
    pub(crate) fn with_excess(&self, are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool) -> Vec<StartPose> {
        let start_pose = |start: &Start| StartPose {
            pose: start.pose,
            excess: self.excess(&start.pose, &are_same),
            rotation_of: start.rotation_of,
        };
        self.poses.iter().map(start_pose).collect()
    }

    /// How much worse than the best the search found `pose`: as much as the best pose it returned that is the same;
    /// a pose that it did not return is as bad as its last.
    fn excess(&self, pose: &RigidTransform, are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool) -> f64 {
        let alike = self.of_search.iter().filter(|p| are_same(&p.target_from_source, pose));
        let least = alike.map(|p| p.excess).fold(f64::INFINITY, f64::min);
        least.min(self.of_search.last().map_or(0.0, |p| p.excess))
    }
}
