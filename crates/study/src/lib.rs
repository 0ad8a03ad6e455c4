//! Group studies: findings on a group from matches of many subjects to one template.
//!
//! A study reads a [`cohort`] and matches a template to every subject: [`plan`] determines the next matches, [`record`]
//! stores the results of a match, and [`average`] makes a template from a round of them. Subjects of the other side of
//! the body are mirrored ([`sides`]), all maps are revised together if requested ([`joint`]), and all shapes are brought
//! into one frame ([`align`]). From the shapes it
//! computes a shape [`model`], [`measures`] at every vertex with their [`statistics`], a list for [`quality`] control,
//! volumes and [`labels`], and a folder with a report ([`output`]). This crate knows no service and no clock, and
//! prints nothing; only [`place`] accesses files.

pub mod align;
pub mod average;
pub mod cohort;
pub mod consistency;
pub mod error;
pub mod findings;
pub mod folder;
pub mod joint;
pub mod labels;
pub mod matching;
pub mod measures;
pub mod memory;
pub mod model;
pub mod output;
pub mod place;
pub mod plan;
pub mod price;
pub mod quality;
pub mod record;
mod report;
pub mod settings;
pub mod sides;
pub mod statistics;

pub use error::StudyError;
