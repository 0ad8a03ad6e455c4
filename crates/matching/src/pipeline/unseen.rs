//! A match within a match, hidden from the observer.

use homolog_primitives::observe::Observer;

/// Forwards only steps and cancellation; phases, progress and trace are those of the outer match.
pub(super) struct StepsOnly<'a>(pub &'a dyn Observer);

impl Observer for StepsOnly<'_> {
    fn step(&self) {
        self.0.step();
    }
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}
