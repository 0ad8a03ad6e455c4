//! Starts of a displacement field, and the results of their comparison.

use crate::starts::start_pose::StartPose;
use homolog_registration::RigidTransform;

/// Where a start comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Origin {
    /// A rigid pose, by its index among those that were compared.
    Pose(usize),
    /// A correspondence of low energy of near isometries.
    Isometry {
        /// Its rigid part.
        pose: RigidTransform,
        /// The energy, a mean over the variables.
        mean_energy: f64,
    },
    /// A pose of straightened surfaces, given as the rigid part of its map of the original surfaces.
    Straightened(RigidTransform),
}

impl Origin {
    /// The rigid part of the start; `poses` are the rigid poses that [`Origin::Pose`] counts.
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

/// The result of the coarse stage for one start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComparedPose {
    pub origin: Origin,
    /// Whether the start mirrors the source.
    pub mirrored: bool,
    /// Misfit after the deformation: mean of `−ln` of the likelihood of the other surface at each point. Lower is
    /// better.
    pub misfit: f64,
    /// How the start fared in later stages.
    pub finer: ComparisonOutcome,
}

/// How a start fared in later stages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ComparisonOutcome {
    /// Not followed, or the answer itself.
    Undecided,
    /// Ended at the pose of a better start.
    Same,
    /// Leaves more unexplained, or has a higher energy.
    Outdone,
    /// Ended elsewhere and leaves no more unexplained.
    AsGood,
    /// Has the other handedness and leaves less unexplained.
    Better,
}
