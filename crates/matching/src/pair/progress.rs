//! The shares of a match that are done before its parts, as an observer is told.

/// The share of a match that is done when the rounds begin, or without rounds its displacement field. This one and those below were measured on
/// pairs of hippocampi with a displacement field.
pub(crate) const PROGRESS_BEFORE_ROUNDS: f64 = 0.09;

/// The share of a match that is done when its displacement field, if it has one, is begun after rounds.
pub(crate) const PROGRESS_BEFORE_DISPLACEMENT: f64 = 0.2;

/// The share of a match that is done when only the report remains.
pub(crate) const PROGRESS_AT_END: f64 = 0.99;

/// The share of a displacement that is done when its local stage begins.
pub(crate) const PROGRESS_BEFORE_LOCAL: f64 = 0.438;
