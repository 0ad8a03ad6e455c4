//! What a process may use, and how much of it each job gets.

use super::pool::WorkerSettings;
use super::schedule::Room;
use crate::jobs::Demand;

/// How a process shares its cores and its memory among jobs.
///
/// By prediction, the usual way: each job takes the cores that it gains from, side by side while there are enough. Or in
/// a fixed number of places: each job takes one place with its share of the cores, whatever it would gain from more. In
/// both ways memory is shared by prediction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capacity {
    /// All that there is. Cores here are places where those are fixed.
    pub budget: Room,
    n_cores: usize,
    n_places: Option<usize>,
}

impl Capacity {
    /// As the settings say.
    pub fn new(settings: &WorkerSettings) -> Self {
        let n_cores = settings.cores.max(1);
        let cores = settings.places.unwrap_or(n_cores);
        Capacity { budget: Room { cores, memory_bytes: settings.memory_bytes }, n_cores, n_places: settings.places }
    }

    /// What is set aside for a job with this demand.
    pub fn need(&self, demand: Demand) -> Room {
        let cores = if self.n_places.is_some() { 1 } else { demand.cores.max(1) };
        Room { cores, memory_bytes: demand.memory_bytes }.at_most(self.budget)
    }

    /// Threads for a job for which `need` was set aside.
    ///
    /// One that is alone, with nothing running and nothing else waiting, gets a thread for every core: they would idle
    /// otherwise. It is a loan, not counted: the next job starts at once all the same, and until the first one ends the
    /// system shares the cores among their threads, fewer than two for each core.
    pub fn n_threads(&self, need: Room, is_alone: bool) -> usize {
        match self.n_places {
            _ if is_alone => self.n_cores,
            Some(places) => (self.n_cores / places.max(1)).max(1),
            None => need.cores,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn capacity(cores: usize, places: Option<usize>) -> Capacity {
        Capacity::new(&WorkerSettings { cores, places, memory_bytes: 1_000, ..WorkerSettings::default() })
    }

    #[test]
    fn by_prediction_a_job_gets_what_it_gains_from_and_no_more_than_there_is() {
        let eight = capacity(8, None);
        for (wanted, given) in [(0, 1), (1, 1), (3, 3), (8, 8), (100, 8), (usize::MAX, 8)] {
            let need = eight.need(Demand { cores: wanted, memory_bytes: 10 });
            assert_eq!((need.cores, eight.n_threads(need, false)), (given, given));
            assert_eq!(eight.n_threads(need, true), 8, "alone it has them all");
        }
        assert_eq!(eight.need(Demand { cores: 1, memory_bytes: 5_000 }).memory_bytes, 1_000);
    }

    #[test]
    fn in_fixed_places_every_job_gets_its_share() {
        for (places, threads) in [(1, 8), (2, 4), (3, 2), (8, 1), (100, 1)] {
            let fixed = capacity(8, Some(places));
            let need = fixed.need(Demand::UNKNOWN);
            assert_eq!((fixed.budget.cores, need.cores), (places, 1));
            assert_eq!(fixed.n_threads(need, false), threads);
        }
        assert_eq!(capacity(8, Some(0)).budget.cores, 0, "a process without places runs nothing");
    }
}
