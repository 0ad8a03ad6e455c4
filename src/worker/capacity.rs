//! The cores and the memory of a process, and how much of them each job gets.

use super::schedule::Room;
use super::settings::WorkerSettings;
use crate::jobs::Demand;

/// How a process divides its cores and its memory among jobs.
///
/// By default it predicts: each job takes as many cores as it benefits from, and jobs run side by side while cores are
/// free. With a fixed number of slots, each job takes one slot and an equal share of the cores. In both cases memory is
/// divided by prediction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Capacity {
    /// The total. With a fixed number of slots, `cores` is that number.
    pub(crate) budget: Room,
    n_cores: usize,
    n_slots: Option<usize>,
}

impl Capacity {
    /// The capacity that the settings state.
    pub(crate) fn new(settings: &WorkerSettings) -> Self {
        let n_cores = settings.cores.max(1);
        let cores = settings.slots.unwrap_or(n_cores);
        Capacity { budget: Room { cores, memory_bytes: settings.memory_bytes }, n_cores, n_slots: settings.slots }
    }

    /// The room to reserve for a job with this demand.
    pub(crate) fn need(&self, demand: Demand) -> Room {
        let cores = if self.n_slots.is_some() { 1 } else { demand.cores.max(1) };
        Room { cores, memory_bytes: demand.memory_bytes }.at_most(self.budget)
    }

    /// The number of threads of a job for which `need` is reserved.
    ///
    /// A job that runs alone, with nothing else queued, gets a thread for every core, because the cores would otherwise
    /// be idle. The additional cores are not reserved: the next job still starts at once. Until the first job ends, the
    /// operating system divides the cores among the threads of both, fewer than two threads for each core.
    pub(crate) fn n_threads(&self, need: Room, is_alone: bool) -> usize {
        match self.n_slots {
            _ if is_alone => self.n_cores,
            Some(slots) => (self.n_cores / slots.max(1)).max(1),
            None => need.cores,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn capacity(cores: usize, slots: Option<usize>) -> Capacity {
        Capacity::new(&WorkerSettings { cores, slots, memory_bytes: 1_000, ..WorkerSettings::default() })
    }

    #[test]
    fn by_prediction_a_job_gets_its_demand_up_to_the_whole_capacity() {
        let eight = capacity(8, None);
        for (wanted, given) in [(0, 1), (1, 1), (3, 3), (8, 8), (100, 8), (usize::MAX, 8)] {
            let need = eight.need(Demand { cores: wanted, memory_bytes: 10, ..Demand::UNKNOWN });
            assert_eq!((need.cores, eight.n_threads(need, false)), (given, given));
            assert_eq!(eight.n_threads(need, true), 8, "a job that is alone gets all cores");
        }
        assert_eq!(eight.need(Demand { cores: 1, memory_bytes: 5_000, ..Demand::UNKNOWN }).memory_bytes, 1_000);
    }

    #[test]
    fn with_fixed_slots_every_job_gets_an_equal_share() {
        for (slots, threads) in [(1, 8), (2, 4), (3, 2), (8, 1), (100, 1)] {
            let fixed = capacity(8, Some(slots));
            let need = fixed.need(Demand::UNKNOWN);
            assert_eq!((fixed.budget.cores, need.cores), (slots, 1));
            assert_eq!(fixed.n_threads(need, false), threads);
        }
        assert_eq!(capacity(8, Some(0)).budget.cores, 0, "a process without slots runs nothing");
    }
}
