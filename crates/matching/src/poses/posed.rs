//! The rigid transform from rounds of inference and registration, or from registration alone. By default the
//! displacement field searches all orientations instead.

use crate::pair::problem::EnergyProblem;
use crate::pair::vertex_map::VertexMap;
use homolog_contract::result::{PoseDocument, RoundDocument, StopReason};
use homolog_registration::RigidTransform;

/// The pose of a match, as far as it is known before the displacement field: the result of the second stage.
pub(crate) enum PoseResult<'c> {
    /// Rounds of inference on the level of `problem`.
    Inference { problem: &'c EnergyProblem<'c>, inferred: RoundsResult },
    /// Registration alone, on all vertices.
    Registration(Registered),
    /// No transform yet: the displacement field searches poses itself.
    ByField,
}

/// Result of the rounds.
pub(crate) struct RoundsResult {
    /// The labeling of the chosen round, or of the only round if it supports no transform.
    pub map: VertexMap,
    /// Why inference ended in the chosen round.
    pub stop_reason: StopReason,
    /// All rounds, in order.
    pub rounds: Vec<RoundDocument>,
    pub pose: InferredPose,
}

/// Whether the rounds found a rigid transform.
pub(crate) enum InferredPose {
    /// The transform of the chosen round.
    Supported {
        transform: RigidTransform,
        /// RANSAC trials in all rounds that found a transform.
        trials: u64,
        confidence_reached: bool,
    },
    /// No rigid transform has three inliers among the labels of the first round.
    Unsupported,
}

/// Result of registration alone.
pub(crate) struct Registered {
    pub transform: RigidTransform,
    /// Poses that were compared.
    pub poses: Vec<PoseDocument>,
    /// Whether two semi-axes of an ellipsoid are so nearly equal that the rotation about the third is arbitrary.
    pub ambiguous_axes: bool,
}

impl PoseResult<'_> {
    /// The transform. `None` if the rounds found none or the field searches poses.
    pub(crate) fn transform(&self) -> Option<RigidTransform> {
        match self {
            PoseResult::Inference { inferred, .. } => match inferred.pose {
                InferredPose::Supported { transform, .. } => Some(transform),
                InferredPose::Unsupported => None,
            },
            PoseResult::Registration(registered) => Some(registered.transform),
            PoseResult::ByField => None,
        }
    }
}
