//! Rigid poses: results of their comparison, and the rigid part of a fit.

pub(crate) mod compared;
pub(crate) mod copies;
pub(crate) mod posed;
pub(crate) mod rigid_part;
