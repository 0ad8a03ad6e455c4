//! The least rate of a transfer: a slow client holds slots and memory for which others wait.

use std::pin::Pin;
use std::task::{Context, Poll};
use std::time::Duration;
use tokio::time::{Instant, Sleep, sleep};

/// The least rate at which a peer sends a body or reads an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LeastRate {
    /// Bytes a second.
    pub bytes_per_s: u64,
    /// How long the peer may be idle, and how far it may fall behind the rate.
    pub patience: Duration,
}

/// A peer's progress. Only the time in which this process waits for the peer counts.
///
/// It is a bucket of time: waiting empties it, each byte refills it by the time that the byte may take, and its
/// capacity is the patience.
#[derive(Debug)]
pub(super) struct Pace {
    least: LeastRate,
    left: Duration,
    waiting: Option<(Instant, Pin<Box<Sleep>>)>,
}

impl Pace {
    pub(super) fn new(least: LeastRate) -> Self {
        Pace { least, left: least.patience, waiting: None }
    }

    /// Records that the peer has moved `n` bytes.
    pub(super) fn moved(&mut self, n: usize) {
        if let Some((since, _)) = self.waiting.take() {
            self.left = self.left.saturating_sub(since.elapsed());
        }
        let gained = Duration::from_secs_f64(n as f64 / self.least.bytes_per_s.max(1) as f64);
        self.left = self.left.saturating_add(gained).min(self.least.patience);
    }

    /// Records that the peer moves nothing. Ready once it is too slow; wakes the task then.
    pub(super) fn poll_too_slow(&mut self, cx: &mut Context<'_>) -> Poll<()> {
        let left = self.left;
        let (_, alarm) = self.waiting.get_or_insert_with(|| (Instant::now(), Box::pin(sleep(left))));
        alarm.as_mut().poll(cx)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::future::poll_fn;

    const LEAST: LeastRate = LeastRate { bytes_per_s: 1_000, patience: Duration::from_millis(200) };

    /// Waits for the peer for `time`; `true` if that was too long.
    async fn wait(pace: &mut Pace, time: Duration) -> bool {
        tokio::time::timeout(time, poll_fn(|cx| pace.poll_too_slow(cx))).await.is_ok()
    }

    #[tokio::test]
    async fn silence_is_too_slow_and_so_is_a_trickle() {
        assert!(wait(&mut Pace::new(LEAST), Duration::from_secs(2)).await);
        let mut trickle = Pace::new(LEAST);
        let mut n_bytes = 0;
        while !wait(&mut trickle, Duration::from_millis(20)).await {
            trickle.moved(1);
            n_bytes += 1;
            assert!(n_bytes < 100, "50 bytes a second pass for 1000");
        }
    }

    #[tokio::test]
    async fn a_peer_at_the_rate_is_fast_enough_and_gains_no_credit() {
        let mut pace = Pace::new(LEAST);
        for _ in 0..20 {
            assert!(!wait(&mut pace, Duration::from_millis(20)).await);
            pace.moved(100);
        }
        pace.moved(1_000_000);
        assert!(wait(&mut pace, Duration::from_secs(2)).await, "a burst long ago excuses no silence");
    }
}
