//! Parameters of the rigid transform.

/// The rigid transform.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct RegistrationParameters {
    /// Where the transform comes from before it is refined.
    pub initial: InitialPose,
    /// How three pairs give a transform.
    pub estimator: MinimalEstimator,
    /// How the pairs that agree give a transform.
    pub solver: OrientationSolver,
    /// Largest residual of an inlier, mm; `null`: chosen from the mean edge length of the target.
    pub tolerance_mm: Option<f64>,
    /// Wanted probability that one trial drew only inliers.
    pub confidence: f64,
    /// Trials at most.
    pub max_trials: u32,
    /// Whether a reflection may be answered.
    pub allow_reflection: bool,
    /// Whether the similarity transform, with scale, that fits the support best is reported beside the rigid one.
    pub similarity: bool,
    /// Iterative closest points after the initial pose.
    pub refine: Refinement,
}

/// Where the transform comes from before it is refined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InitialPose {
    /// RANSAC over the correspondence. Needs a minimiser.
    Ransac,
    /// A search of all orientations by soft assignment of patches.
    Search,
    /// The first-order ellipsoids laid on each other (Brechbühler, Gerig, Kübler 1995); of four poses the closest.
    FirstOrderEllipsoid,
    /// Centroid on centroid, not turned: for surfaces that are nearly aligned.
    Centroids,
}

/// How three pairs give a transform.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum MinimalEstimator {
    /// An orthonormal frame on each triple.
    Frame,
    /// The axis is what the rotation leaves fixed, then the angle.
    RotationAxis,
}

/// How pairs that agree give a transform.
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

/// Iterative closest points after the initial pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Refinement {
    /// None.
    None,
    /// Distance of points (Besl, McKay 1992).
    PointToPoint,
    /// Distance of points to tangent planes (Chen, Medioni 1992).
    PointToPlane,
}
