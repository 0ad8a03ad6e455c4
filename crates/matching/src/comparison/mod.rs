//! Published methods, for comparison.

pub(crate) mod field_methods;
pub(crate) mod registration_only;
