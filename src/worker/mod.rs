//! Workers: lease a job, read its inputs, compute on a thread of its own, finish under the fence.
//!
//! A worker knows nothing of what it computes: that is the [`crate::jobs::Engine`]'s, of which
//! [`match_engine`] is the real one. Reading order: [`schedule`] (which job starts next), [`capacity`], [`machine`] and
//! [`prediction`] (what there is, and what a match takes of it), [`pool`] (claims what can start), [`execution`] (one job
//! from claim to finish), [`heartbeat`] (its own thread, so that no computation can starve it), [`recorder`] (trace and
//! progress), [`control`] (how a computation is told to stop), [`priority`] (computing gives way to answering),
//! [`presentation`] (results in other file formats), [`housekeeper`] (jobs of the dead, blobs of nobody), [`courier`]
//! (webhooks).

pub mod capacity;
pub mod control;
pub mod courier;
pub mod execution;
pub mod heartbeat;
pub mod housekeeper;
pub mod machine;
pub mod match_engine;
pub mod pool;
pub mod prediction;
pub mod presentation;
pub mod priority;
pub mod quota;
pub mod recorder;
pub mod schedule;
#[cfg(test)]
mod schedule_tests;

pub use pool::{Pool, PoolParts, WorkerSettings};
