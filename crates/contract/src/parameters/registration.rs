//! Parameters of the rigid transform.

/// How the rigid transform is estimated.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct RegistrationParameters {
    /// The initial pose, before refinement. Where a request states `inference.algorithm` but not this, it is `ransac` with a minimizer and
    /// `search` without.
    pub initial: InitialPose,
    /// Minimal estimator of RANSAC: a transform from three pairs.
    pub estimator: MinimalEstimator,
    /// Least-squares solver of RANSAC: a transform from all inliers.
    pub solver: OrientationSolver,
    /// Largest residual of an inlier, mm; `null`: three mean edge lengths of the target.
    pub tolerance_mm: Option<f64>,
    /// Desired probability that at least one RANSAC trial drew only inliers.
    pub confidence: f64,
    /// Most RANSAC trials.
    pub max_trials: u32,
    /// Whether the transform may mirror the source.
    pub allow_reflection: bool,
    /// Whether the similarity transform (with scale) that fits the support best is reported in addition to the rigid one.
    /// Where the source is matched at the size of the target, a similarity is reported in any case.
    pub similarity: bool,
    /// Whether the pose that brings the surfaces closest is chosen among the four that align two first-order ellipsoids. Without
    /// it, it is the one that rotates least.
    pub resolve_ambiguity: bool,
    /// Refinement of the initial pose by iterative closest points.
    pub refine: Refinement,
}

/// Initial pose, before refinement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InitialPose {
    /// RANSAC over the correspondence. Needs a minimizer, and every minimizer needs it.
    Ransac,
    /// Search of all orientations by soft assignment of patches.
    Search,
    /// Alignment of the first-order ellipsoids (Brechbühler, Gerig, Kübler 1995); of four possible poses the one that rotates
    /// least, unless `resolve_ambiguity` asks for the closest.
    FirstOrderEllipsoid,
    /// Alignment of the centroids without rotation, for surfaces that are nearly aligned.
    Centroids,
}

/// Minimal estimator of RANSAC: a transform from three pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum MinimalEstimator {
    /// An orthonormal frame on each triple.
    Frame,
    /// The rotation axis from the displacements of the three pairs, then the angle.
    RotationAxis,
}

/// Least-squares solver of absolute orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum OrientationSolver {
    /// Singular value decomposition (Arun 1987, Umeyama 1991).
    Svd,
    /// Unit quaternion (Horn 1987).
    Quaternion,
    /// Orthonormal matrix by eigenvalue decomposition (Horn, Hilden, Negahdaripour 1988).
    OrthonormalMatrix,
}

/// Refinement by iterative closest points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Refinement {
    /// No refinement.
    None,
    /// Distance of points (Besl, McKay 1992).
    PointToPoint,
    /// Distance of points to tangent planes (Chen, Medioni 1992).
    PointToPlane,
}
