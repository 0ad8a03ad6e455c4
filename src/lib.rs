//! homolog finds homologous points of two anatomical surfaces: a dense correspondence and a rigid transform.
//!
//! This package is the program: the service and the command line. The computation is in the crates under `crates/`; a
//! Rust program that matches surfaces needs only `homolog-matching`. ARCHITECTURE.md is the map.
//!
//! The modules in reading order:
//!
//! - The service: [`jobs`] (jobs and the ports), [`store`] (SQLite or PostgreSQL, and blobs), [`worker`] (runs jobs),
//!   [`http`] (the API).
//! - Wiring: [`app`], [`cli`], [`config`], [`telemetry`], [`spans`], [`tls`].

pub mod jobs;

pub mod store;

pub mod worker;

pub mod http;

pub mod app;
pub mod cli;
pub mod config;
pub mod spans;
pub mod telemetry;
pub mod tls;
