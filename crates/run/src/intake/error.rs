//! Why a file is refused.

use super::repair_name;
use homolog_contract::parameters::Repair;
use homolog_formats::FormatError;
use homolog_mesh::topology::{SurfaceFault, TopologyReport};

/// Why a file is refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntakeError {
    /// None of the formats that are read.
    #[error("the file is none of NIfTI-1, PLY, STL, legacy VTK")]
    UnknownFormat,
    /// The format is known, the content is wrong.
    #[error(transparent)]
    Unreadable(FormatError),
    /// A limit of the service is exceeded.
    #[error("the file has {found} {what}, but at most {limit} are accepted")]
    TooLarge {
        /// What is counted, plural.
        what: &'static str,
        /// How many there are, at least.
        found: u64,
        /// How many are accepted.
        limit: u64,
    },
    /// No voxel has a wanted label.
    #[error("no voxel has {}; {}", wanted_labels(wanted.as_deref()), present_labels(present, *n_present))]
    EmptyStructure {
        /// The labels asked for; `None`: any but 0.
        wanted: Option<Vec<u32>>,
        /// Labels of the volume, ascending, the first of them if there are many.
        present: Vec<u32>,
        /// How many labels the volume has.
        n_present: usize,
    },
    /// The filter leaves nothing of the structure.
    #[error(
        "smoothing by {smoothing_mm} mm leaves nothing of a structure of {n_voxels} voxels; \
         lower smoothing_mm or ask for the voxel surface"
    )]
    Vanished {
        /// Standard deviation of the filter, mm.
        smoothing_mm: f64,
        /// Voxels of the structure.
        n_voxels: u64,
    },
    /// Faces that name a vertex twice, where dropping them was not allowed.
    #[error(
        "{n_faces} faces name a vertex twice; the first is face {face} with vertex {vertex}; \
         allow the repair weld, which drops them"
    )]
    DegenerateFaces {
        /// How many.
        n_faces: u64,
        /// The first.
        face: u64,
        /// The vertex it names twice.
        vertex: u32,
        /// Topology without them.
        topology: Box<TopologyReport>,
    },
    /// What came out is not a closed manifold of genus 0.
    #[error("{fault}; {advice}")]
    UnsuitableSurface {
        /// What is wrong and where; vertices as uploaded for meshes.
        fault: SurfaceFault,
        /// What would help.
        advice: Advice,
        /// Topology after the repairs that were allowed.
        topology: Box<TopologyReport>,
    },
}

/// What would help an unsuitable surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Advice {
    /// These repairs, allowed together, make it suitable.
    Allow(Vec<Repair>),
    /// No repair that there is does.
    Edit,
}

impl std::fmt::Display for Advice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Advice::Allow(repairs) => {
                let names: Vec<String> = repairs.iter().map(|&r| format!("\"{}\"", repair_name(r))).collect();
                write!(f, "it becomes suitable with \"repair\": [{}]", names.join(", "))
            }
            Advice::Edit => f.write_str("no repair here helps, mend it in the program that made it"),
        }
    }
}

fn wanted_labels(wanted: Option<&[u32]>) -> String {
    match wanted {
        None => "a label other than 0".to_owned(),
        Some(labels) => format!("any of the labels {labels:?}"),
    }
}

fn present_labels(present: &[u32], n_present: usize) -> String {
    if present.is_empty() {
        return "the volume is empty".to_owned();
    }
    let more =
        if n_present > present.len() { format!(" and {} more", n_present - present.len()) } else { String::new() };
    format!("the volume holds {present:?}{more}")
}

impl IntakeError {
    /// The stable name of this kind of refusal, used as problem type: `unknown-format`, `unreadable-file`,
    /// `too-large`, `empty-structure`, `unsuitable-surface`.
    pub fn code(&self) -> &'static str {
        match self {
            IntakeError::UnknownFormat => "unknown-format",
            IntakeError::Unreadable(_) => "unreadable-file",
            IntakeError::TooLarge { .. } => "too-large",
            IntakeError::EmptyStructure { .. } | IntakeError::Vanished { .. } => "empty-structure",
            IntakeError::DegenerateFaces { .. } | IntakeError::UnsuitableSurface { .. } => "unsuitable-surface",
        }
    }

    /// The topology of the surface that was refused, where there was one.
    pub fn topology(&self) -> Option<&TopologyReport> {
        match self {
            IntakeError::DegenerateFaces { topology, .. } | IntakeError::UnsuitableSurface { topology, .. } => {
                Some(topology)
            }
            _ => None,
        }
    }
}
