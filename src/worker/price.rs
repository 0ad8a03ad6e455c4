//! The limit on what a job may cost: the processor time that [`homolog_study::price`] predicts.

use crate::jobs::Demand;
use std::time::Duration;

/// A job may be predicted to take this many times what it is allowed to run: predictions are mostly within a factor of 4 of what a
/// job takes.
const ERROR: u32 = 4;

/// The largest predicted processor time of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PriceLimit {
    each_core: Duration,
    cores: usize,
}

/// A price above the limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Exceeded {
    /// The predicted processor time.
    pub(crate) needed: Duration,
    /// The largest allowed one.
    pub(crate) limit: Duration,
}

impl PriceLimit {
    /// Any price.
    pub const NONE: PriceLimit = PriceLimit::fixed(Duration::MAX);

    /// The same for every job.
    pub const fn fixed(limit: Duration) -> Self {
        PriceLimit { each_core: limit, cores: 1 }
    }

    /// The processor time that a job can take within `max_run` on the cores that it gets, at most `cores`, with a factor for the error of predictions.
    pub const fn of_run(max_run: Duration, cores: usize) -> Self {
        PriceLimit { each_core: max_run.saturating_mul(ERROR), cores }
    }

    /// Refuses a demand above the limit.
    pub(crate) fn check(&self, demand: &Demand) -> Result<(), Exceeded> {
        let cores = u32::try_from(demand.cores.min(self.cores).max(1)).unwrap_or(u32::MAX);
        let (needed, limit) = (demand.processor_time, self.each_core.saturating_mul(cores));
        if needed > limit { Err(Exceeded { needed, limit }) } else { Ok(()) }
    }
}

impl Exceeded {
    /// The numbers and `advice`, after the words for what is refused.
    pub(crate) fn said_of(&self, what: &str, advice: &str) -> String {
        let [needed, limit] = [self.needed, self.limit].map(|time| time.as_secs_f64().ceil());
        format!(
            "{what} would take about {needed} s of processor time, which exceeds the limit of {limit} s; what lowers it most: {advice}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_default_a_job_may_cost_what_it_can_compute_on_its_cores() {
        let demand = |cores, seconds| Demand { cores, processor_time: Duration::from_secs(seconds), ..Demand::UNKNOWN };
        let limit = PriceLimit::of_run(Duration::from_secs(10), 2);
        for (cores, allowed) in [(1, 40), (2, 80), (8, 80)] {
            assert_eq!(limit.check(&demand(cores, allowed)), Ok(()));
            assert_eq!(limit.check(&demand(cores, allowed + 1)).unwrap_err().limit, Duration::from_secs(allowed));
        }
        let limit = PriceLimit::fixed(Duration::from_secs(10));
        assert!(limit.check(&demand(8, 11)).is_err() && limit.check(&demand(1, 10)).is_ok());
        assert_eq!(PriceLimit::NONE.check(&demand(1, u64::MAX)), Ok(()));
        assert_eq!(limit.check(&Demand::UNKNOWN), Ok(()));
    }
}
