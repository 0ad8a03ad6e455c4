//! Limits of a child: the memory planned for its job, and processor time.
//!
//! `RLIMIT_DATA` is the effective memory limit: the kernel counts the memory that a process has made writable for
//! itself, which is its heap and the stacks of its threads, and not address space that is only reserved, as the
//! system's allocator does for each thread. The limit on the address space (`RLIMIT_AS`) is well above it. The parent
//! sets both from outside before each job; the child cannot change them.

use crate::jobs::Allotted;
use homolog_run::intake::IntakeLimits;
use std::time::Duration;

/// Memory that any computation may take in addition, bytes: code that is touched first, tables, the text of an answer.
pub(super) const BESIDES: u64 = 256 << 20;
/// Factor between a prediction and the limit of a computation: predictions count arrays, not the memory that the
/// allocator loses between them.
const SLACK: u64 = 2;
/// Memory of a thread besides scratch space, bytes: its stack, and its part of the allocator.
const THREAD: u64 = 8 << 20;
/// Address space that the allocator reserves for each thread and never uses, bytes.
const RESERVED: u64 = 192 << 20;
/// Memory for reading a file, as a multiple of its decompressed size; the reader's own tests bound what it holds.
const READING: u64 = 8;
/// Memory for a voxel of the box around a structure, bytes: labels, and distances before and after smoothing.
const VOXEL: u64 = 24;
/// Processor time that a job may take in addition to the time of its longest run.
const CPU_BESIDES: Duration = Duration::from_secs(30);
/// Ticks per second of the clock in which the kernel states processor time; the same on all its processors.
#[cfg(target_os = "linux")]
const TICKS: u64 = 100;

/// Limits of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Bounds {
    /// Memory in addition to what the child already has, bytes.
    pub(super) memory_bytes: u64,
    /// Threads.
    pub(super) n_threads: u64,
    /// Processor time.
    pub(super) cpu: Duration,
}

impl Bounds {
    /// Limits of a computation over inputs of `input_bytes`.
    pub(super) fn of_computation(allotted: &Allotted<'_>, most: &ComputeLimits, input_bytes: u64) -> Self {
        let n_threads = allotted.n_threads.max(1) as u64;
        // A job without a prediction is bounded by the memory that any match may take.
        let planned = if allotted.memory_bytes == 0 { most.limits.max_match_bytes } else { allotted.memory_bytes };
        let computed = planned.saturating_mul(SLACK);
        let memory_bytes = computed.max(most.reading(input_bytes)).saturating_add(most.besides);
        let cpu = allotted.max_run.saturating_mul(u32::try_from(n_threads).unwrap_or(u32::MAX));
        Bounds { memory_bytes, n_threads, cpu: cpu.saturating_add(CPU_BESIDES) }
    }

    /// Limits of reading an input of `n_bytes` within `time`, on all cores.
    pub(super) fn of_reading(most: &ComputeLimits, n_bytes: u64, n_threads: usize, time: Duration) -> Self {
        let n_threads = n_threads.max(1) as u64;
        let cpu = time.saturating_mul(u32::try_from(n_threads).unwrap_or(u32::MAX)).saturating_add(CPU_BESIDES);
        Bounds { memory_bytes: most.reading(n_bytes).saturating_add(most.besides), n_threads, cpu }
    }
}

/// Limits from the settings of a process.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ComputeLimits {
    /// Limits on inputs.
    pub(super) limits: IntakeLimits,
    /// Memory for jobs, bytes. No reading may take more.
    pub(super) budget: u64,
    /// Memory that any computation may take in addition, bytes: [`BESIDES`].
    pub(super) besides: u64,
}

impl ComputeLimits {
    /// Memory for reading files of `n_bytes` together: their decompressed size, and the box of a volume.
    fn reading(&self, n_bytes: u64) -> u64 {
        let IntakeLimits { max_inflation, max_inflated_bytes, max_voxels, .. } = self.limits;
        let inflated = n_bytes.saturating_mul(max_inflation as u64).max(1 << 20);
        let inflated = inflated.min((max_inflated_bytes as u64).max(n_bytes));
        inflated.saturating_mul(READING).saturating_add(max_voxels.saturating_mul(VOXEL)).min(self.budget)
    }
}

/// The memory of a process, bytes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Memory {
    /// Memory that the process made writable for itself.
    pub(super) data: u64,
    /// Its address space.
    pub(super) space: u64,
    /// Resident memory.
    pub(super) resident: u64,
}

/// The memory of a process; `None` if the system does not report it.
pub(super) fn memory_of(pid: Option<u32>) -> Option<Memory> {
    let path = pid.map_or_else(|| "/proc/self/status".to_owned(), |pid| format!("/proc/{pid}/status"));
    memory_in(&std::fs::read_to_string(path).ok()?)
}

fn memory_in(status: &str) -> Option<Memory> {
    let field = |name: &str| {
        let line = status.lines().find_map(|line| line.strip_prefix(name))?;
        line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
    };
    Some(Memory { data: field("VmData:")?, space: field("VmSize:")?, resident: field("VmRSS:")? })
}

/// Sets the limits of a child from now on. Where the system has no such limits, the parent bounds the time only.
#[cfg(target_os = "linux")]
pub(super) fn bound(pid: u32, bounds: Bounds, scratch_bytes: u64) {
    use rustix::process::{Pid, Resource, Rlimit, prlimit};
    let Some(process) = i32::try_from(pid).ok().and_then(Pid::from_raw) else { return };
    let set = |resource, most: u64| {
        // The hard limit stays, so that the next job may take more. Children have the hard limit of this process.
        let hard = rustix::process::getrlimit(resource).maximum;
        let current = Some(hard.map_or(most, |hard| most.min(hard)));
        if let Err(error) = prlimit(Some(process), resource, Rlimit { current, maximum: hard }) {
            tracing::warn!(%error, "what a computation takes cannot be bounded");
        }
    };
    if let Some(Memory { data, space, .. }) = memory_of(Some(pid)) {
        // The threads of the job and the threads that serve reading both have scratch space.
        let threads = bounds.n_threads.saturating_mul(scratch_bytes.saturating_add(THREAD));
        let more = bounds.memory_bytes.saturating_add(threads.saturating_mul(2));
        set(Resource::Data, data.saturating_add(more));
        let reserved = bounds.n_threads.saturating_mul(2).saturating_add(2).saturating_mul(RESERVED);
        set(Resource::As, space.saturating_add(more).saturating_add(reserved));
    }
    if let Some(used) = cpu_seconds(pid) {
        set(Resource::Cpu, used.saturating_add(bounds.cpu.as_secs()));
    }
}

#[cfg(not(target_os = "linux"))]
pub(super) fn bound(_: u32, _: Bounds, _: u64) {}

/// Processor time that a process has used, s.
#[cfg(target_os = "linux")]
fn cpu_seconds(pid: u32) -> Option<u64> {
    cpu_seconds_in(&std::fs::read_to_string(format!("/proc/{pid}/stat")).ok()?)
}

#[cfg(target_os = "linux")]
fn cpu_seconds_in(stat: &str) -> Option<u64> {
    // The name of the program, in parentheses, may contain anything; the fields after it do not.
    let (_, fields) = stat.rsplit_once(')')?;
    let ticks = |at: usize| fields.split_whitespace().nth(at)?.parse::<u64>().ok();
    Some((ticks(11)? + ticks(12)?) / TICKS)
}

/// Limits that a child sets for itself, once: it writes no files and no core dump, and opens almost no files.
pub(super) fn bound_self() {
    use rustix::process::{Resource, Rlimit, setrlimit};
    for (resource, most) in [(Resource::Core, 0), (Resource::Fsize, 0), (Resource::Nofile, 16)] {
        // Ignored: this limit is one of several.
        let _ = setrlimit(resource, Rlimit { current: Some(most), maximum: Some(most) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_read_from_the_status_of_a_process() {
        let status = "Name:\thomolog\nVmSize:\t  1000 kB\nVmRSS:\t     30 kB\nVmData:\t     20 kB\n";
        let expected = Memory { data: 20 << 10, space: 1000 << 10, resident: 30 << 10 };
        assert_eq!(memory_in(status), Some(expected));
        assert_eq!(memory_in("VmSize: 1 MB"), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn processor_time_is_read_whatever_the_program_is_called() {
        let fields = "S 1 2 3 0 -1 4194304 5 6 7 8 250 150 0 0 20 0 1 0 100";
        for name in ["homolog", "a b", ") R 9 9", "(("] {
            assert_eq!(cpu_seconds_in(&format!("77 ({name}) {fields}")), Some(4), "{name}");
        }
        assert_eq!(cpu_seconds_in("77 (x) S 1"), None);
    }

    #[test]
    fn bounds_grow_with_what_was_planned_and_never_overflow() {
        let most = ComputeLimits { limits: IntakeLimits::default(), budget: 4 << 30, besides: BESIDES };
        let of = |memory_bytes, n_threads, max_run| {
            let allotted = Allotted { n_threads, memory_bytes, max_run, owner: "" };
            Bounds::of_computation(&allotted, &most, 1000)
        };
        let hour = Duration::from_secs(3600);
        assert!(of(8 << 30, 1, hour).memory_bytes >= 16 << 30);
        assert!(of(1 << 30, 1, hour).memory_bytes <= of(2 << 30, 1, hour).memory_bytes);
        assert!(of(0, 1, hour).memory_bytes >= most.limits.max_match_bytes, "what is unknown is bounded too");
        assert!(of(0, 4, hour).cpu >= 4 * hour);
        let all = of(u64::MAX, usize::MAX, Duration::MAX);
        assert_eq!((all.memory_bytes, all.cpu), (u64::MAX, Duration::MAX));
        let read = Bounds::of_reading(&most, u64::MAX, 2, hour);
        assert_eq!(read.memory_bytes, most.budget + BESIDES, "reading takes no more than there is for jobs");
    }
}
