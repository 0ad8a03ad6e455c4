//! A rigid starting pose.

use homolog_registration::RigidTransform;

/// A rigid starting pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StartPose {
    /// `target_from_source`.
    pub pose: RigidTransform,
    /// Excess misfit over the best pose that is known beforehand; added to the misfit of the pose.
    pub excess: f64,
    /// The index of the start of which this one is a rotation about the axis about which the source is most nearly
    /// round.
    pub rotation_of: Option<usize>,
}

impl StartPose {
    /// A start without excess that is no rotation of another.
    pub(crate) fn of(pose: RigidTransform) -> StartPose {
        StartPose { pose, excess: 0.0, rotation_of: None }
    }
}
