//! Computations in processes of their own, so that one that crashes, is broken into, or takes too much harms nothing else.
//!
//! [`IsolatedEngine`] stands where [`MatchEngine`](super::match_engine::MatchEngine) stands: what is quick and touches no bytes
//! of clients stays in the process, everything else goes to a child, which is the same program with the hidden command
//! [`COMMAND`]. Reading order: [`engine`] (what is asked of children, and what their deaths mean), `pool` (which child), `process`
//! (one child, as its parent sees it), `child` (the same from within), `messages` and `protocol` (what crosses), `limits`
//! (memory and processor time), `sandbox` (files, connections, other processes).

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
    /// In processes of their own, confined and bounded
    Process,
    /// In threads of the service: whatever breaks a computation breaks the service
    None,
}
