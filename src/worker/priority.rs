//! Threads that compute run at a lower priority than those that serve clients and talk to the database, so that a job on
//! all cores does not delay them.

/// Niceness of computing threads. On an otherwise idle machine it costs nothing.
#[cfg(target_os = "linux")]
const NICENESS: i32 = 10;

/// Lowers the priority of this thread and of those that it starts. That needs no privilege; a failure is harmless, because
/// it only makes responses slower.
pub(crate) fn lower_priority() {
    // Only Linux has a priority for each thread; elsewhere this would change that of the whole process.
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, NICENESS) {
        tracing::debug!(%error, "a computing thread keeps its priority");
    }
}

/// Lowers the priority of rayon's global pool, whose threads would otherwise inherit that of the thread that uses it first.
pub(crate) fn lower_priority_of_global_pool() {
    // An error means that the pool exists already, as in a process that has called this before.
    let _ = rayon::ThreadPoolBuilder::new().start_handler(|_| lower_priority()).build_global();
}

/// Threads for one job, so that it uses exactly its own number of them, however many jobs run beside it.
///
/// # Errors
/// If the system gives none.
pub(crate) fn own_threads(n_threads: usize) -> std::io::Result<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(n_threads)
        .thread_name(|i| format!("compute-{i}"))
        .start_handler(|_| lower_priority())
        .build()
        .map_err(std::io::Error::other)
}
