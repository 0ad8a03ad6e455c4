//! What parts of a process tell each other of jobs, so that nobody has to wait for the next look at the store.
//!
//! Only hints: the store is the truth and everybody asks it now and then, which is all that happens between processes.

use super::job::JobId;
use tokio::sync::{Notify, broadcast};

/// Hints kept for a follower that is slow to hear them; whoever misses some looks at the store instead.
const KEPT: usize = 256;

/// Hints within one process.
#[derive(Debug)]
pub struct Signals {
    /// A job was queued.
    pub queued: Notify,
    moved: broadcast::Sender<JobId>,
}

impl Default for Signals {
    fn default() -> Self {
        Signals { queued: Notify::new(), moved: broadcast::Sender::new(KEPT) }
    }
}

impl Signals {
    /// Tells followers that the state of a job changed.
    pub fn tell_moved(&self, id: JobId) {
        // An error says that nobody follows.
        let _ = self.moved.send(id);
    }

    /// What is told from now on of one job.
    pub fn moves_of(&self, id: JobId) -> Moves {
        Moves { id, moved: self.moved.subscribe() }
    }
}

/// Hints of one job.
#[derive(Debug)]
pub struct Moves {
    id: JobId,
    moved: broadcast::Receiver<JobId>,
}

impl Moves {
    /// Returns when the job may have changed its state. May be dropped at any moment without a loss.
    pub async fn next(&mut self) {
        loop {
            match self.moved.recv().await {
                Ok(id) if id != self.id => {}
                // One of those missed may have been of this job.
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
    async fn a_follower_hears_of_its_own_job_alone() {
        let (signals, id) = (Signals::default(), JobId::new());
        signals.tell_moved(id);
        let mut moves = signals.moves_of(id);
        assert!(!is_told(&mut moves).await, "that was before it listened");
        signals.tell_moved(JobId::new());
        assert!(!is_told(&mut moves).await, "that was another job");
        signals.tell_moved(id);
        assert!(is_told(&mut moves).await);
        assert!(!is_told(&mut moves).await, "told once");
    }

    #[tokio::test]
    async fn a_follower_that_missed_hints_looks_rather_than_waits() {
        let signals = Signals::default();
        let mut moves = signals.moves_of(JobId::new());
        for _ in 0..=KEPT {
            signals.tell_moved(JobId::new());
        }
        assert!(is_told(&mut moves).await);
    }
}
