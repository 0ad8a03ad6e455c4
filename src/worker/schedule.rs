//! The rule by which a process picks its next job: a function of what is free and of what waits, nothing else.
//!
//! Jobs start in the order of the queue. One that needs more than is free just now may be passed by later ones that fit,
//! so that no core idles while there is work for it; but once it has waited for longer than the patience, nothing later
//! starts before it, and what runs drains until there is room. A large job therefore waits at most for its patience and
//! the longest job then running, and the price is cores that idle for the drain. Processes that share a queue follow the
//! rule each for itself; the first that has room takes the job.

use std::time::Duration;

/// Cores and memory: of a process, or of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    /// Cores.
    pub cores: usize,
    /// Memory, bytes.
    pub memory_bytes: u64,
}

impl Room {
    /// Nothing.
    pub const NONE: Room = Room { cores: 0, memory_bytes: 0 };

    /// Whether `need` is to be had from this.
    pub fn holds(self, need: Room) -> bool {
        need.cores <= self.cores && need.memory_bytes <= self.memory_bytes
    }

    /// Both together.
    #[must_use]
    pub fn plus(self, other: Room) -> Room {
        Room {
            cores: self.cores.saturating_add(other.cores),
            memory_bytes: self.memory_bytes.saturating_add(other.memory_bytes),
        }
    }

    /// What is left without `other`.
    #[must_use]
    pub fn minus(self, other: Room) -> Room {
        Room {
            cores: self.cores.saturating_sub(other.cores),
            memory_bytes: self.memory_bytes.saturating_sub(other.memory_bytes),
        }
    }

    /// As much of it as `budget` has. A job that asks for more than there is can have everything, and runs alone.
    #[must_use]
    pub fn at_most(self, budget: Room) -> Room {
        Room { cores: self.cores.min(budget.cores), memory_bytes: self.memory_bytes.min(budget.memory_bytes) }
    }
}

/// A waiting job in the eyes of the rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Candidate {
    /// What it needs; never more than the budget.
    pub need: Room,
    /// For how long it could have started.
    pub waited: Duration,
}

/// The jobs of `waiting`, in the order of the queue, of which any one may start now, by their places. Whoever shares the
/// queue with other processes tries them in this order, starts one, and asks again with what is then free.
///
/// # Cost
/// `O(n)` for `n` waiting jobs.
pub fn startable(free: Room, waiting: &[Candidate], patience: Duration) -> Vec<usize> {
    let mut places = Vec::new();
    for (place, candidate) in waiting.iter().enumerate() {
        if free.holds(candidate.need) {
            places.push(place);
        } else if candidate.waited >= patience {
            break;
        }
    }
    places
}
