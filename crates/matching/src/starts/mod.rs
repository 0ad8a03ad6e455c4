//! Starts of a fit, one file for each kind.

pub(crate) mod candidates;
pub(crate) mod extremities;
pub(crate) mod landmarks;
pub(crate) mod limbs;
pub(crate) mod rotations;
pub(crate) mod search;
pub(crate) mod start_pose;
pub(crate) mod tubes;
