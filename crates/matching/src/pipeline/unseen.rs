//! A match within a match, hidden from the observer.

use homolog_primitives::observe::Observer;

/// Forwards only cancellation; phases, progress and trace are those of the outer match.
pub(super) struct CancellationOnly<'a>(pub &'a dyn Observer);

impl Observer for CancellationOnly<'_> {
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
    fn is_stopped(&self) -> bool {
        self.0.is_stopped()
    }
}
