//! A rigid pose to start from.

use homolog_registration::RigidTransform;

/// A rigid pose to start from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StartPose {
    /// `target_from_source`.
    pub pose: RigidTransform,
    /// How much worse than the best it is known to be beforehand; added to its misfit.
    pub excess: f64,
    /// The index of the start that was rotated about the axis about which the source is most nearly round to give this one.
    pub rotation_of: Option<usize>,
}

impl StartPose {
    /// A start that is as good as any and was found as it is.
    pub(crate) fn of(pose: RigidTransform) -> StartPose {
        StartPose { pose, excess: 0.0, rotation_of: None }
    }
}
