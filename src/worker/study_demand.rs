//! The predicted demand of the steps of a study.

use super::machine;
use crate::jobs::Demand;
use homolog_contract::study::StudySize;
use homolog_study::memory::step_bytes;
use homolog_study::price::step_price;

/// Most cores that a step is given.
const CORES: usize = 8;

/// Memory of a step besides the arrays that depend on its size: stacks of threads, and free memory that the allocator keeps; bytes.
const BESIDES: u64 = 64 << 20;

/// Threads that a step may have: a job that is alone on a large machine gets every core.
pub(super) fn cores() -> usize {
    CORES.max(machine::cores())
}

/// The demand of the largest step of a study.
pub(super) fn demand_of(size: &StudySize) -> Demand {
    Demand {
        cores: usize::try_from(size.subjects).unwrap_or(CORES).clamp(1, CORES),
        memory_bytes: step_bytes(size, cores()).saturating_add(BESIDES),
        processor_time: step_price(size).processor_time,
    }
}
