//! The rule by which a process chooses its next job: a pure function of the free resources and the queue.
//!
//! Jobs start in the order of the queue. Later jobs that fit may overtake a job that needs more than is free, so that
//! no core idles while there is work for it. Once the job has waited for `patience`, no later job starts before it, and
//! the running jobs finish until there is room. A large job therefore waits at most for `patience` plus the longest job
//! that is then running; meanwhile some cores are idle. Processes that share a queue apply the rule independently; the
//! first that has room claims the job.

use std::time::Duration;

/// An amount of cores and memory: what a process has, or what a job needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Room {
    /// Cores.
    pub(crate) cores: usize,
    /// Memory, bytes.
    pub(crate) memory_bytes: u64,
}

impl Room {
    /// Nothing.
    pub(crate) const NONE: Room = Room { cores: 0, memory_bytes: 0 };

    /// Whether `need` fits into this.
    pub(crate) fn holds(self, need: Room) -> bool {
        need.cores <= self.cores && need.memory_bytes <= self.memory_bytes
    }

    /// The sum.
    #[must_use]
    pub(crate) fn plus(self, other: Room) -> Room {
        Room {
            cores: self.cores.saturating_add(other.cores),
            memory_bytes: self.memory_bytes.saturating_add(other.memory_bytes),
        }
    }

    /// The difference, not below zero.
    #[must_use]
    pub(crate) fn minus(self, other: Room) -> Room {
        Room {
            cores: self.cores.saturating_sub(other.cores),
            memory_bytes: self.memory_bytes.saturating_sub(other.memory_bytes),
        }
    }

    /// The minimum of this and `budget`: a job that needs more than the budget gets all of it, and runs alone.
    #[must_use]
    pub(crate) fn at_most(self, budget: Room) -> Room {
        Room { cores: self.cores.min(budget.cores), memory_bytes: self.memory_bytes.min(budget.memory_bytes) }
    }
}

/// The properties of a queued job that the rule uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Candidate {
    /// Room that the job needs; at most the budget.
    pub(crate) need: Room,
    /// How long the job has been waiting.
    pub(crate) waited: Duration,
}

/// The indices of the jobs of `waiting`, in the order of the queue, that may start now. The caller claims the first one
/// that no other process has claimed, starts it, and calls again with the remaining resources.
///
/// # Cost
/// `O(n)` for `n` waiting jobs.
pub(crate) fn startable(free: Room, waiting: &[Candidate], patience: Duration) -> Vec<usize> {
    let mut positions = Vec::new();
    for (position, candidate) in waiting.iter().enumerate() {
        if free.holds(candidate.need) {
            positions.push(position);
        } else if candidate.waited >= patience {
            break;
        }
    }
    positions
}
