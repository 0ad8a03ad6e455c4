//! From matches of many subjects to one template to what the group shows.
//!
//! A study reads a [`cohort`], matches a template to every subject ([`plan`] says what to match next, [`record`] is what is
//! kept of a match, [`average`] what makes a template of a round of them), mirrors those of the other side of the body ([`sides`]), brings all shapes into one frame ([`align`]), and computes from them a shape [`model`], [`measures`] at
//! every vertex, [`statistics`] of these, a list for [`quality`] control, volumes and [`labels`], and a folder with a report
//! ([`output`]). This crate knows no service and no clock, and prints nothing; [`place`] alone touches files.

pub mod align;
pub mod average;
pub mod cohort;
pub mod consistency;
pub mod error;
pub mod findings;
pub mod folder;
pub mod labels;
pub mod matching;
pub mod measures;
pub mod memory;
pub mod model;
pub mod output;
pub mod place;
pub mod plan;
pub mod quality;
pub mod record;
mod report;
pub mod settings;
pub mod sides;
pub mod statistics;

pub use error::StudyError;
