//! The rate of requests of each tenant, limited by a token bucket: an average number a second, and a number at once.

use parking_lot::Mutex;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// Length of a burst, in seconds of requests at the average rate.
const BURST_S: u32 = 10;
/// Number of owners above which idle ones are forgotten.
const MANY: usize = 10_000;

/// The remaining requests of each owner.
#[derive(Debug)]
pub(super) struct RequestRate {
    per_s: u32,
    buckets: Mutex<HashMap<String, Bucket>>,
}

#[derive(Debug, Clone, Copy)]
struct Bucket {
    tokens: f64,
    at: Instant,
}

impl RequestRate {
    /// A limit of `per_s` requests a second; 0: no limit.
    pub(super) fn new(per_s: u32) -> Self {
        RequestRate { per_s, buckets: Mutex::default() }
    }

    /// Requests a second.
    pub(super) fn per_s(&self) -> u32 {
        self.per_s
    }

    /// Requests at once.
    pub(super) fn burst(&self) -> u32 {
        self.per_s.saturating_mul(BURST_S)
    }

    /// Counts a request at this time.
    ///
    /// # Errors
    /// The time after which the next request is allowed.
    pub(super) fn take(&self, owner: &str, now: Instant) -> Result<(), Duration> {
        if self.per_s == 0 {
            return Ok(());
        }
        let (rate, burst) = (f64::from(self.per_s), f64::from(self.burst()));
        let filled = |bucket: &Bucket| {
            (bucket.tokens + now.saturating_duration_since(bucket.at).as_secs_f64() * rate).min(burst)
        };
        let mut buckets = self.buckets.lock();
        if buckets.len() >= MANY && !buckets.contains_key(owner) {
            // A full bucket need not be stored.
            buckets.retain(|_, bucket| filled(bucket) < burst);
        }
        let bucket = buckets.entry(owner.to_owned()).or_insert(Bucket { tokens: burst, at: now });
        let tokens = filled(bucket);
        let allowed = tokens >= 1.0;
        *bucket = Bucket { tokens: if allowed { tokens - 1.0 } else { tokens }, at: now };
        if allowed { Ok(()) } else { Err(Duration::from_secs_f64((1.0 - tokens) / rate)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_owner_has_a_rate_and_a_burst_of_its_own() {
        let rate = RequestRate::new(2);
        let began = Instant::now();
        let sent = |owner: &str, at: Instant| (0..100).take_while(|_| rate.take(owner, at).is_ok()).count();
        assert_eq!((sent("a", began), sent("b", began)), (20, 20));
        let wait = rate.take("a", began).unwrap_err();
        assert_eq!(wait, Duration::from_millis(500));
        assert_eq!(sent("a", began + wait), 1);
        assert_eq!(sent("a", began + wait + Duration::from_secs(3)), 6);
        assert_eq!(sent("a", began + Duration::from_secs(3600)), 20, "a pause earns no more than the burst");
        assert!((0..1000).all(|_| RequestRate::new(0).take("a", began).is_ok()));
    }

    #[test]
    fn owners_that_pause_are_forgotten() {
        let rate = RequestRate::new(1);
        let began = Instant::now();
        for n in 0..MANY {
            rate.take(&n.to_string(), began).unwrap();
        }
        rate.take("next", began + Duration::from_secs(60)).unwrap();
        assert_eq!(rate.buckets.lock().len(), 1);
    }
}
