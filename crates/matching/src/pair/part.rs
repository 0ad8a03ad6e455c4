//! Which of two surfaces shows only a part of the structure.

use super::role::Role;
use crate::surface::side::SurfaceLevel;

/// The surface that shows only a part of the structure: an open one, if the other is closed.
pub(crate) fn part(source: &SurfaceLevel, target: &SurfaceLevel) -> Option<Role> {
    match (source.is_open, target.is_open) {
        (true, false) => Some(Role::Source),
        (false, true) => Some(Role::Target),
        _ => None,
    }
}
