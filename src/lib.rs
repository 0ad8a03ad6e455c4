//! homolog finds homologous points of two anatomical surfaces: a dense correspondence and a rigid transform.
//!
//! The modules in reading order, by layer. Each knows only those above it, as far as ARCHITECTURE.md allows.
//!
//! Numerics (no runtime, no database, no HTTP, no clock, no files): [`observe`], [`mesh`], [`matching`].
//! Inputs: [`intake`]; synthetic ones: [`phantom`]. One match from bytes to the result document: [`run`].
//! The command line: [`cli`].

pub mod graph;
pub mod observe;

pub mod mesh;

pub mod curvature;
pub mod inference;
pub mod mrf;
pub mod registration;

pub mod intake;
pub mod matching;
pub mod phantom;

pub mod run;

pub mod cli;
