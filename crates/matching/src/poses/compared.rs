//! Starts of a displacement field, and what is known of them after they were compared.

use crate::starts::start_pose::StartPose;
use homolog_registration::RigidTransform;

/// Where a start comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Origin {
    /// A rigid pose, by its index among those that were compared.
    Pose(usize),
    /// A correspondence of least energy of near isometries.
    Isometry {
        /// Its rigid part.
        pose: RigidTransform,
        /// The energy, a mean over the variables.
        mean_energy: f64,
    },
    /// A pose of straightened surfaces; this is the rigid part of what it does to the surfaces themselves.
    Straightened(RigidTransform),
}

impl Origin {
    /// The rigid part of the start, one of `poses` if it is not that of a bent surface.
    pub(crate) fn rigid(&self, poses: &[StartPose]) -> RigidTransform {
        match self {
            Origin::Pose(k) => poses[*k].pose,
            Origin::Isometry { pose, .. } | Origin::Straightened(pose) => *pose,
        }
    }

    /// Whether the start is one of the rigid poses.
    pub(crate) fn is_pose(&self) -> bool {
        matches!(self, Origin::Pose(_))
    }

    /// The same start in the other direction.
    pub(crate) fn inverse(self) -> Origin {
        match self {
            Origin::Pose(k) => Origin::Pose(k),
            Origin::Isometry { pose, mean_energy } => Origin::Isometry { pose: pose.inverse(), mean_energy },
            Origin::Straightened(pose) => Origin::Straightened(pose.inverse()),
        }
    }
}

/// The first stage's verdict on one start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComparedPose {
    pub origin: Origin,
    /// Whether it mirrors.
    pub mirrored: bool,
    /// Misfit after the deformation: mean of `−ln` of the likelihood of the other surface at each point. Lower is better.
    pub misfit: f64,
    /// What is known of it beyond this misfit.
    pub finer: Finer,
}

/// How a start fared in later stages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Finer {
    /// It was not followed.
    None,
    /// It ended where a better one did.
    Same,
    /// It leaves more unexplained, or has a higher energy.
    Outdone,
    /// It ends elsewhere and leaves no more unexplained.
    AsGood,
    /// It is of the other handedness and leaves less unexplained.
    Better,
}
