//! Reasons to doubt an answer, from the match or from an input.

/// A reason to doubt an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum UnreliableReason {
    /// One surface has to be drawn out about as far to become the other as curvatures of corresponding points agree: they show
    /// different structures.
    UnlikeShape,
    /// A mirrored copy of the source fits better: the two are of different sides, which `input.source.mirror: true` matches, or one
    /// image is mirrored.
    OtherHandedness,
    /// Another pose fits as well.
    AmbiguousPose,
    /// The default method finds another pose or other corresponding points.
    SecondOpinion,
    /// An input states two orientations of different handedness: left and right may be exchanged.
    UncertainSide,
    /// The sizes differ by the ratio of two units of length, such as 10, 25.4 or 1000.
    UnitsDiffer,
    /// A piece of at least 5 % of a structure was dropped, without having been asked for.
    PieceDropped,
    /// Labels of one input were joined, without having been asked for, and the other input has other labels.
    LabelsJoined,
    /// A structure had cavities of at least 5 % of its volume, or closing them and its tunnels changed as much, without having been
    /// asked for.
    CavityFilled,
    /// The voxels are so large for the structure that they leave its rotation uncertain.
    TooCoarse,
}
