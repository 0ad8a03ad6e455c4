//! The answer: images with their confidence, and measures of the correspondence.

pub(crate) mod confidence;
pub(crate) mod consistency;
pub(crate) mod deformation;
pub(crate) mod displaced;
pub(crate) mod displacement;
pub(crate) mod images;
pub(crate) mod inverse;
pub(crate) mod of_field;
pub(crate) mod outcome;
pub(crate) mod outliers;
pub(crate) mod reliability;
pub(crate) mod report;
