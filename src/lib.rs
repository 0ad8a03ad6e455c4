//! homolog finds homologous points of two anatomical surfaces: a dense correspondence and a rigid transform.
//!
//! The modules in reading order, by layer; ARCHITECTURE.md says which may know which.
//!
//! - Numerics (no runtime, no database, no HTTP, no clock, no files): [`graph`], [`observe`], [`mesh`], [`volume`],
//!   [`formats`], [`curvature`], [`geodesic`], [`mrf`], [`inference`], [`registration`], [`harmonics`],
//!   [`deformation`], [`hierarchy`], [`matching`], [`phantom`], [`intake`].
//! - One match from uploaded bytes to the result document: [`run`].
//! - The service: [`jobs`] (what a job is, and the ports), [`store`] (SQLite or PostgreSQL, and blobs), [`worker`] (who
//!   runs them), [`http`] (how the outside asks).
//! - Wiring: [`app`], [`cli`], [`config`], [`telemetry`], [`tls`].

pub mod graph;
pub mod observe;

pub mod mesh;
pub mod volume;

pub mod formats;

pub mod curvature;

pub mod geodesic;

pub mod mrf;

pub mod inference;

pub mod registration;

pub mod harmonics;

mod exponential;

pub mod deformation;

pub mod hierarchy;

pub mod matching;

pub mod phantom;

pub mod intake;

pub mod run;

pub mod experiment;

pub mod jobs;

pub mod store;

pub mod worker;

pub mod http;

pub mod app;
pub mod cli;
pub mod config;
pub mod telemetry;
pub mod tls;
