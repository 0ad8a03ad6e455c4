//! Rigid starting poses: from an earlier stage, landmarks, the labels of an energy, a search, and rotations of these.

use super::landmarks::landmark_pose;
use super::rotations::{rotations_of_best, symmetric_poses};
use super::search::searched;
use super::start_pose::StartPose;
use crate::pair::problem::MatchProblem;
use homolog_contract::result::PoseOrigin;
use homolog_registration::{RigidTransform, ScoredPose};

/// A rigid starting pose.
pub(crate) struct Start {
    pub origin: PoseOrigin,
    pub pose: RigidTransform,
    /// The index of the start of which this one is a rotation.
    pub rotation_of: Option<usize>,
}

impl Start {
    fn new(origin: PoseOrigin, pose: RigidTransform) -> Start {
        Start { origin, pose, rotation_of: None }
    }
}

/// Rigid starting poses, the most trusted first.
pub(crate) struct Starts {
    pub poses: Vec<Start>,
    /// All poses that the search found, the best first.
    of_search: Vec<ScoredPose>,
}

impl Starts {
    /// Only the pose of an earlier stage.
    pub(crate) fn of(own: Option<(PoseOrigin, RigidTransform)>) -> Starts {
        let poses = own.map(|(origin, pose)| Start::new(origin, pose)).into_iter().collect();
        Starts { poses, of_search: Vec::new() }
    }

    /// The pose of an earlier stage and the pose of the landmarks.
    pub(crate) fn known(coarse: &MatchProblem<'_>, own: Option<(PoseOrigin, RigidTransform)>) -> Starts {
        let parameters = coarse.full.parameters;
        let mut starts = Starts::of(own);
        let of_landmarks = landmark_pose(&parameters.landmarks, parameters.registration.allow_reflection);
        starts.poses.extend(of_landmarks.map(|pose| Start::new(PoseOrigin::Landmarks, pose)));
        starts
    }

    /// Adds the poses that the labels of an energy support, the best of them also after `aligned`, and rotations.
    pub(crate) fn add_inferred(
        &mut self,
        coarse: &MatchProblem<'_>,
        found: &[RigidTransform],
        aligned: impl Fn(&RigidTransform) -> Option<RigidTransform>,
    ) {
        let best = self.poses.len();
        self.add(coarse, PoseOrigin::Inference, found);
        // The spacing of labels limits the precision of this pose; alignment is more precise for surfaces that are
        // nearly copies.
        if let Some(pose) = found.first().and_then(aligned) {
            self.poses.push(Start { rotation_of: Some(best), ..Start::new(PoseOrigin::Inference, pose) });
        }
        self.add_symmetric(coarse, PoseOrigin::Inference, found);
    }

    /// Adds the poses of a search of all orientations, of either handedness, so that mirror images are detected.
    pub(crate) fn add_searched(&mut self, coarse: &MatchProblem<'_>) {
        self.of_search = searched(&coarse.source.middle, &coarse.target.middle, true);
        let found: Vec<RigidTransform> = self.of_search.iter().map(|p| p.target_from_source).collect();
        self.add(coarse, PoseOrigin::Search, &found);
        self.add_symmetric(coarse, PoseOrigin::Search, &found);
    }

    /// Adds poses related to the best of `found` by a possible symmetry of the surface, so that symmetries are
    /// detected.
    fn add_symmetric(&mut self, coarse: &MatchProblem<'_>, origin: PoseOrigin, found: &[RigidTransform]) {
        let poses = symmetric_poses(&coarse.source.middle, found);
        self.poses.extend(poses.into_iter().map(|pose| Start::new(origin, pose)));
    }

    /// Adds `found`, the best first, and small rotations of the best of each handedness.
    fn add(&mut self, coarse: &MatchProblem<'_>, origin: PoseOrigin, found: &[RigidTransform]) {
        let first = self.poses.len();
        self.poses.extend(found.iter().map(|pose| Start::new(origin, *pose)));
        let rotations = rotations_of_best(&coarse.source.middle, found);
        let rotation = |(k, pose)| Start { rotation_of: Some(first + k), ..Start::new(origin, pose) };
        self.poses.extend(rotations.into_iter().map(rotation));
    }

    /// The most trusted pose that is allowed as an answer.
    pub(crate) fn first(&self, coarse: &MatchProblem<'_>) -> Option<RigidTransform> {
        let allow_reflection = coarse.full.parameters.registration.allow_reflection;
        self.poses.iter().map(|start| start.pose).find(|pose| allow_reflection || !pose.is_reflection())
    }

    /// These poses, each with its excess misfit in the search.
    pub(crate) fn with_excess(&self, are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool) -> Vec<StartPose> {
        let start_pose = |start: &Start| StartPose {
            pose: start.pose,
            excess: self.excess(&start.pose, &are_same),
            rotation_of: start.rotation_of,
        };
        self.poses.iter().map(start_pose).collect()
    }

    /// Excess misfit of `pose` in the search: the least excess of the poses found that are the same, at most that of
    /// the last pose found.
    fn excess(&self, pose: &RigidTransform, are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool) -> f64 {
        let alike = self.of_search.iter().filter(|p| are_same(&p.target_from_source, pose));
        let least = alike.map(|p| p.excess).fold(f64::INFINITY, f64::min);
        least.min(self.of_search.last().map_or(0.0, |p| p.excess))
    }
}
