//! The size of a study, from which planners predict its memory and its time.

/// Size of a study: the quantities that determine the memory and the time of its steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StudySize {
    /// Number of subjects.
    pub subjects: u64,
    /// Vertices of the template: of the given one, of the subject it is made from, or of the largest subject.
    pub vertices: u64,
    /// Faces of that surface.
    pub faces: u64,
    /// Number of covariates of all subjects together.
    pub cells: u64,
    /// Largest possible number of columns of the design.
    pub columns: u64,
    /// Largest possible number of contrasts.
    pub contrasts: u64,
    /// Number of requested measures; `None` for all.
    pub measures: Option<u64>,
    /// Number of permutations of each test; `None` for the default.
    pub permutations: Option<u64>,
    /// Number of subjects used to measure consistency.
    pub ring: u64,
    /// Size of the largest file, bytes.
    pub file_bytes: u64,
    /// Whether a file is a label volume.
    pub has_volumes: bool,
    /// Whether maps are revised together.
    #[cfg_attr(feature = "serde", serde(default))]
    pub joint: bool,
    /// Whether persons with several visits have templates of their own.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub own_templates: bool,
    /// Whether subjects whose pose is ambiguous are also matched in their other poses.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub rivals: bool,
}
