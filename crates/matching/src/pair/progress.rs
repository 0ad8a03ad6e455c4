//! Progress of a match at the beginning of its parts, as reported to an observer.

/// Progress of a match at the beginning of the rounds, or without rounds of its displacement field. This and the values
/// below were measured on pairs of hippocampi with a displacement field.
pub(crate) const PROGRESS_BEFORE_ROUNDS: f64 = 0.09;

/// Progress of a match at the beginning of its displacement field after rounds.
pub(crate) const PROGRESS_BEFORE_DISPLACEMENT: f64 = 0.2;

/// Progress of a match when only the report remains.
pub(crate) const PROGRESS_AT_END: f64 = 0.99;

/// Progress of a displacement at the beginning of its local stage.
pub(crate) const PROGRESS_BEFORE_LOCAL: f64 = 0.32;
