//! A rigid transform, from rounds of inference and registration or from registration alone; by default it is left to the displacement
//! field, which searches all orientations itself.

use crate::pair::problem::EnergyProblem;
use crate::pair::vertex_map::VertexMap;
use homolog_contract::result::{PoseDocument, RoundDocument, StopReason};
use homolog_registration::RigidTransform;

/// What the second stage hands over.
pub(crate) enum Posed<'c> {
    /// Rounds of inference on the level of `problem`.
    Inference { problem: &'c EnergyProblem<'c>, inferred: Inferred },
    /// Registration alone, on all vertices.
    Registration(Registered),
    /// Nothing yet: the displacement field compares the poses of a search of its own.
    ByField,
}

/// What the rounds found.
pub(crate) struct Inferred {
    /// The labeling of the chosen round, or of the only one where that supports no transform.
    pub map: VertexMap,
    /// Why inference ended in that round.
    pub stop_reason: StopReason,
    /// All rounds, in order.
    pub rounds: Vec<RoundDocument>,
    pub pose: InferredPose,
}

/// Whether the rounds found a rigid transform.
pub(crate) enum InferredPose {
    /// That of the chosen round.
    Supported {
        transform: RigidTransform,
        /// RANSAC trials in all rounds that found a transform.
        trials: u64,
        confidence_reached: bool,
    },
    /// No rigid transform has three inliers in the first labeling.
    Unsupported,
}

/// What registration alone found.
pub(crate) struct Registered {
    pub transform: RigidTransform,
    /// Poses that were compared.
    pub poses: Vec<PoseDocument>,
    /// Whether an ellipsoid has two half axes so alike that the rotation about the third is arbitrary.
    pub ambiguous_axes: bool,
}

impl Posed<'_> {
    /// The transform, unless the rounds found none or it is left to the field.
    pub(crate) fn transform(&self) -> Option<RigidTransform> {
        match self {
            Posed::Inference { inferred, .. } => match inferred.pose {
                InferredPose::Supported { transform, .. } => Some(transform),
                InferredPose::Unsupported => None,
            },
            Posed::Registration(registered) => Some(registered.transform),
            Posed::ByField => None,
        }
    }
}
