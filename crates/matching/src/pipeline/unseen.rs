//! A match inside of a match, of which the observer hears nothing.

use homolog_primitives::observe::Observer;

/// Passes on nothing but cancellation: phases, progress and trace are those of the match outside.
pub(super) struct Unseen<'a>(pub &'a dyn Observer);

impl Observer for Unseen<'_> {
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
    fn is_stopped(&self) -> bool {
        self.0.is_stopped()
    }
}
