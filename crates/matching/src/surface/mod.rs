//! Values of one surface, independent of the other.

pub(crate) mod form;
pub(crate) mod levels;
pub(crate) mod light_smoothing;
pub(crate) mod moments;
pub(crate) mod robust;
pub(crate) mod round_axis;
pub(crate) mod side;
pub(crate) mod sites;
pub(crate) mod smooth;
pub(crate) mod surface_index;
