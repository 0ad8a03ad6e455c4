//! Computing threads run at a lower priority than threads that serve clients and talk to the database, so that a job on
//! all cores does not delay requests.

/// Niceness of computing threads. It costs nothing on an otherwise idle machine.
#[cfg(target_os = "linux")]
const NICENESS: i32 = 10;

/// Lowers the priority of this thread and of the threads that it starts. This needs no privilege; a failure is harmless
/// and only makes responses slower.
pub(crate) fn lower_priority() {
    // Only Linux has a priority for each thread; other systems would change the priority of the whole process.
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, NICENESS) {
        tracing::debug!(%error, "a computing thread keeps its priority");
    }
}

/// Lowers the priority of rayon's global pool, whose threads would otherwise inherit the priority of the thread that
/// uses it first.
pub(crate) fn lower_priority_of_global_pool() {
    // An error means that the pool already exists, for example after an earlier call.
    let _ = rayon::ThreadPoolBuilder::new().start_handler(|_| lower_priority()).build_global();
}

/// The threads of one job: it uses exactly `n_threads`, however many jobs run at the same time.
///
/// # Errors
/// If the system provides none.
pub(crate) fn own_threads(n_threads: usize) -> std::io::Result<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(n_threads)
        .thread_name(|i| format!("compute-{i}"))
        .start_handler(|_| lower_priority())
        .build()
        .map_err(std::io::Error::other)
}
