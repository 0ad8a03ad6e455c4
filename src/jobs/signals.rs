//! Signals between the parts of one process, so that they need not wait for the next query of the store.
//!
//! They are hints only. The store is the truth, and every follower also queries it at intervals, which is all that connects
//! one process with another.

use super::ids::JobId;
use tokio::sync::{Mutex, Notify, broadcast};

/// Signals kept for a receiver that falls behind; a receiver that missed signals queries the store.
const KEPT: usize = 256;

/// The signals of one process.
#[derive(Debug)]
pub struct Signals {
    /// A job was queued.
    pub queued: Notify,
    /// Held while a study is planned, so that only one study definition is in memory at a time.
    pub planning: Mutex<()>,
    moved: broadcast::Sender<JobId>,
}

impl Default for Signals {
    fn default() -> Self {
        Signals { queued: Notify::new(), planning: Mutex::default(), moved: broadcast::Sender::new(KEPT) }
    }
}

impl Signals {
    /// Signals that the state of a job changed.
    pub fn tell_moved(&self, id: JobId) {
        // An error only says that there are no receivers.
        let _ = self.moved.send(id);
    }

    /// The changes of one job's state from now on.
    pub fn moves_of(&self, id: JobId) -> Moves {
        Moves { id: Some(id), moved: self.moved.subscribe() }
    }

    /// The changes of any job's state from now on.
    pub fn all_moves(&self) -> Moves {
        Moves { id: None, moved: self.moved.subscribe() }
    }
}

/// Changes of state, of one job or of all.
#[derive(Debug)]
pub struct Moves {
    id: Option<JobId>,
    moved: broadcast::Receiver<JobId>,
}

impl Moves {
    /// Returns when a job may have changed its state. Cancel-safe: dropping the future loses no signal.
    pub async fn next(&mut self) {
        loop {
            match self.moved.recv().await {
                Ok(id) if self.id.is_some_and(|own| own != id) => {}
                // A missed signal may have been one of these jobs'.
                Ok(_) | Err(broadcast::error::RecvError::Lagged(_)) => return,
                Err(broadcast::error::RecvError::Closed) => std::future::pending().await,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    async fn is_told(moves: &mut Moves) -> bool {
        tokio::time::timeout(Duration::from_millis(20), moves.next()).await.is_ok()
    }

    #[tokio::test]
    async fn a_follower_of_one_job_gets_its_signals_only() {
        let (signals, id) = (Signals::default(), JobId::new());
        signals.tell_moved(id);
        let mut moves = signals.moves_of(id);
        assert!(!is_told(&mut moves).await, "sent before the subscription");
        signals.tell_moved(JobId::new());
        assert!(!is_told(&mut moves).await, "sent for another job");
        signals.tell_moved(id);
        assert!(is_told(&mut moves).await);
        assert!(!is_told(&mut moves).await, "each signal counts once");
    }

    #[tokio::test]
    async fn a_follower_of_all_jobs_gets_every_signal() {
        let signals = Signals::default();
        let mut moves = signals.all_moves();
        for _ in 0..2 {
            signals.tell_moved(JobId::new());
            assert!(is_told(&mut moves).await);
        }
        assert!(!is_told(&mut moves).await);
    }

    #[tokio::test]
    async fn a_follower_that_fell_behind_is_woken() {
        let signals = Signals::default();
        let mut moves = signals.moves_of(JobId::new());
        for _ in 0..=KEPT {
            signals.tell_moved(JobId::new());
        }
        assert!(is_told(&mut moves).await);
    }
}
