#![doc = include_str!("../README.md")]

pub mod adjustment;
pub mod align;
pub mod average;
pub mod cohort;
pub mod complex;
pub mod consistency;
pub mod error;
pub mod findings;
pub mod folder;
pub mod joint;
pub mod labels;
pub mod matching;
pub mod measures;
pub mod memory;
mod mirror;
pub mod model;
pub mod normative;
pub mod output;
pub mod plan;
mod pose;
pub mod price;
pub mod quality;
pub mod record;
mod report;
pub mod rivals;
mod rotation;
pub mod score;
pub mod settings;
pub mod sides;
pub mod statistics;
pub mod storage;
pub mod structures;
pub mod subjects;
mod visits;
mod whole;

pub use error::StudyError;
