//! Values of two surfaces before any fit.

pub(crate) mod assignment;
pub(crate) mod lengths;
pub(crate) mod part;
pub(crate) mod prior;
pub(crate) mod problem;
pub(crate) mod progress;
pub(crate) mod role;
pub(crate) mod scene;
pub(crate) mod smooth_pair;
pub(crate) mod solver;
pub(crate) mod surfaces;
pub(crate) mod vertex_map;
