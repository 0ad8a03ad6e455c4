//! Workers: claim a job, read its inputs, compute on its own threads, and store the result under the lease.
//!
//! A worker does not know what it computes: the [`crate::jobs::Engine`] does; in production it is [`match_engine`].
//! Reading order: [`schedule`] (which job starts next), [`capacity`], [`machine`] and [`prediction`] (the available
//! cores and memory, and the demand of a match), [`price`] (the limit on its processor time), `settings` and `pool_parts`, [`pool`] (claims jobs that can start), [`execution`] (one job from its
//! claim to its end), `retry` (of calls to a store), [`heartbeat`] (on its own thread, so that no computation can starve it), [`observer`] (trace and
//! progress), [`control`] (how a computation is told to stop), [`priority`] (computing threads run at a lower
//! priority), [`quota`] (when a process exits by itself), [`presentation`] (results in other file formats),
//! [`study_material`], `opened_study`, `study_demand`, [`study_engine`] and `study_score` (the steps of a study), [`isolation`] (computations in separate processes),
//! [`housekeeper`] (jobs of lost workers, unreferenced blobs), [`webhook_delivery`].

pub(crate) mod capacity;
pub(crate) mod control;
pub(crate) mod error_text;
pub(crate) mod execution;
mod file_name;
pub(crate) mod heartbeat;
pub(crate) mod housekeeper;
pub mod isolation;
pub(crate) mod machine;
pub mod match_engine;
pub(crate) mod observer;
mod opened_study;
pub(crate) mod pool;
mod pool_parts;
pub(crate) mod prediction;
pub mod presentation;
pub mod price;
pub(crate) mod priority;
pub mod quota;
mod retry;
pub(crate) mod schedule;
#[cfg(test)]
mod schedule_tests;
mod settings;
mod study_demand;
pub(crate) mod study_engine;
pub(crate) mod study_material;
mod study_score;
mod study_templates;
pub mod webhook_delivery;

pub(crate) use pool::Pool;
pub(crate) use pool_parts::PoolParts;
pub use settings::WorkerSettings;
