//! Starts of a displacement field, and the results of their comparison.

use crate::starts::start_pose::StartPose;
use homolog_registration::RigidTransform;

/// Where a start comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Origin {
    /// A rigid pose, by its index among those that were compared.
    Pose(usize),
    /// A pose related to that of this index by an approximate symmetry of the surface.
    Symmetric(usize, RigidTransform),
    /// A start that bends the source, given as its rigid part: a correspondence of near isometries, or a pose of
    /// straightened surfaces.
    Bent(RigidTransform),
}

impl Origin {
    /// The rigid part of the start; `poses` are the rigid poses that [`Origin::Pose`] counts.
    pub(crate) fn rigid(&self, poses: &[StartPose]) -> RigidTransform {
        match self {
            Origin::Pose(k) => poses[*k].pose,
            Origin::Symmetric(_, pose) | Origin::Bent(pose) => *pose,
        }
    }

    /// The same start in the other direction.
    pub(crate) fn inverse(self) -> Origin {
        match self {
            Origin::Pose(k) => Origin::Pose(k),
            Origin::Symmetric(k, pose) => Origin::Symmetric(k, pose.inverse()),
            Origin::Bent(pose) => Origin::Bent(pose.inverse()),
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

impl ComparedPose {
    /// Whether this start, of the handedness of the `best`, explains the surfaces as well.
    pub(crate) fn is_as_good_as(&self, best: &ComparedPose) -> bool {
        self.mirrored == best.mirrored && self.finer == ComparisonOutcome::AsGood
    }
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
