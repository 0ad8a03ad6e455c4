//! homolog finds homologous points of two anatomical surfaces: a dense correspondence and a rigid transform.
//!
//! The modules in reading order, by layer. Each knows only those above it, as far as ARCHITECTURE.md allows.
//!
//! Numerics (no runtime, no database, no HTTP, no clock, no files): [`observe`], [`mesh`], [`matching`].
//! Inputs: [`intake`]. One match from bytes to the result document: [`run`].
//!
//! The service: [`jobs`] (what a job is, and the ports), [`store`] (SQLite and a folder of blobs), [`worker`] (who runs
//! them), [`http`] (how the outside asks). Wiring: [`app`], [`cli`], [`config`], [`telemetry`].

pub mod observe;

pub mod mesh;

pub mod intake;
pub mod matching;

pub mod run;

pub mod jobs;
pub mod store;
pub mod worker;

pub mod http;

pub mod app;
pub mod cli;
pub mod config;
pub mod telemetry;
