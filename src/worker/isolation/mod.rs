//! Computations in separate processes: a computation that crashes, is compromised or takes too much harms nothing else.
//!
//! [`IsolatedEngine`] replaces [`MatchEngine`](super::match_engine::MatchEngine). Work that is quick and touches no
//! bytes of clients stays in the process. All other work goes to a child: the same program with the hidden command
//! [`COMMAND`]. Reading order: [`engine`] (requests to children, and the consequences of their deaths), `pool` (which
//! child), `process` (one child, as its parent sees it), `child` (the child's own code), `messages` and `protocol` (the
//! data exchanged), `limits` (memory and processor time), `sandbox` (files, connections, other processes).

mod child;
mod engine;
mod limits;
mod messages;
mod pool;
mod process;
mod protocol;
mod sandbox;

pub use child::run as run_child;
pub use engine::{IsolatedEngine, IsolationSettings};
pub use process::COMMAND;

/// Where computations run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Isolation {
    /// In separate processes, confined and bounded
    Process,
    /// In threads of the service: whatever breaks a computation breaks the service
    None,
}
