//! The energy over curvature: labels of vertices, rounds of inference and registration, clamping.

pub(crate) mod active_labels;
pub(crate) mod bound;
pub(crate) mod clamping;
pub(crate) mod closer_pose;
pub(crate) mod coarse;
pub(crate) mod features;
pub(crate) mod minimizer;
pub(crate) mod minimizers;
pub(crate) mod prepare;
pub(crate) mod propagation;
pub(crate) mod rounds;
