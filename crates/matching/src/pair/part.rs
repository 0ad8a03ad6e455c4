//! Which of two surfaces shows a part of what the other shows.

use super::role::Role;
use crate::surface::side::Side;

/// Which of the two surfaces shows a part of what the other shows: an open one, if the other is closed.
pub(crate) fn part(source: &Side, target: &Side) -> Option<Role> {
    match (source.is_open, target.is_open) {
        (true, false) => Some(Role::Source),
        (false, true) => Some(Role::Target),
        _ => None,
    }
}
