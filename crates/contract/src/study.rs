//! The size of a study, from which those who plan it know its memory and its time.

/// How large a study is, as far as the memory and the time of its steps depend on it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StudySize {
    /// Subjects.
    pub subjects: u64,
    /// Vertices of the template: of the given one, of the subject that it is made from, or of the largest.
    pub vertices: u64,
    /// Faces of that surface.
    pub faces: u64,
    /// Covariates of all subjects together.
    pub cells: u64,
    /// Columns of the design, at most.
    pub columns: u64,
    /// Contrasts, at most.
    pub contrasts: u64,
    /// Measures that were asked for; `None`: all.
    pub measures: Option<u64>,
    /// Permutations of each test; `None`: the default.
    pub permutations: Option<u64>,
    /// Subjects among which consistency is measured.
    pub ring: u64,
    /// The largest file, bytes.
    pub file_bytes: u64,
    /// Whether a file is a label volume.
    pub has_volumes: bool,
}
