//! Computing gives way to answering: threads that compute run at a lower priority than those that talk to clients and
//! to the database, so that a job on all cores does not delay them.

/// How nice computing threads are. On an otherwise idle machine they lose nothing by it.
#[cfg(target_os = "linux")]
const NICENESS: i32 = 10;

/// Lowers the priority of this thread and of those that it starts. Lowering needs no right; that it failed would only
/// make answers slower.
pub fn give_way() {
    // Only Linux has priorities of threads; elsewhere this would be the whole process's.
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, NICENESS) {
        tracing::debug!(%error, "a computing thread keeps its priority");
    }
}

/// Has rayon's threads give way too: they begin at their first use, by whichever thread that is.
pub fn have_pool_give_way() {
    // An error says that they run already, as in a process that has done this before.
    let _ = rayon::ThreadPoolBuilder::new().start_handler(|_| give_way()).build_global();
}
