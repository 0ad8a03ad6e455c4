//! Published methods, for comparison.

#[cfg_attr(not(feature = "comparison"), path = "absent.rs")]
pub(crate) mod field_methods;
pub(crate) mod registration_only;
