//! The energy of near isometries: a Markov random field in which distances along the surface are kept.

pub(crate) mod bias;
pub(crate) mod inference;
pub(crate) mod minimize;
pub(crate) mod model;
pub(crate) mod near_isometry;
pub(crate) mod settings;
pub(crate) mod signs;
pub(crate) mod variance;
