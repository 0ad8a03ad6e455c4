//! The energy of near isometries: a Markov random field that keeps distances along the surface.

pub(crate) mod bias;
pub(crate) mod inference;
pub(crate) mod lead;
pub(crate) mod minimize;
pub(crate) mod model;
pub(crate) mod near_isometry;
pub(crate) mod settings;
pub(crate) mod signs;
pub(crate) mod variance;
