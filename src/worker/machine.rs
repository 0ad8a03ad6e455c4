//! The cores and the memory that the machine or the container makes available to this process.

use std::fs;

/// Cores on which this process may run, within the limit of the container.
pub(crate) fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Memory of the machine, or the limit of the container if that is lower, bytes; `None` if the system does not report it.
pub(crate) fn memory_bytes() -> Option<u64> {
    // Version 2 of control groups, then version 1. The group's own folder is the root in a container.
    let limits = ["/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"];
    let limits = limits.iter().filter_map(|path| fs::read_to_string(path).ok()?.trim().parse().ok());
    let installed = fs::read_to_string("/proc/meminfo").ok().and_then(|text| total_bytes(&text));
    limits.chain(installed).min()
}

/// The installed memory according to the text of `/proc/meminfo`, bytes.
fn total_bytes(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kib.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn installed_memory_is_read_from_meminfo() {
        let text = "MemTotal:       16318412 kB\nMemFree:         1024 kB\n";
        assert_eq!(total_bytes(text), Some(16_318_412 * 1024));
        for strange in ["", "MemTotal: many kB", "MemTotal: 12 MB"] {
            assert_eq!(total_bytes(strange), None, "{strange}");
        }
        assert!(cores() >= 1);
    }
}
