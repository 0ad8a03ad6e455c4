//! What an input is and whether it can be matched, told instead of refused.

use super::candidate::Candidate;
use super::{InputFormat, IntakeError, IntakeLimits, RepairNote, read};
use crate::formats::FileContent;
use crate::matching::parameters::InputParameters;
use crate::mesh::topology::TopologyReport;
use crate::volume::LabelVolume;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Labels listed at most.
const MAX_LISTED_LABELS: usize = 1000;

/// What an input is, what would be made of it, and whether that can be matched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Inspection {
    /// The file's format.
    pub format: InputFormat,
    /// What it holds.
    pub kind: InputKind,
    /// The volume, if it holds one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub volume: Option<VolumeInspection>,
    /// Topology of the surface before repairs; absent if there is no surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub topology: Option<TopologyReport>,
    /// Topology after the repairs that the parameters allow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub repaired_topology: Option<TopologyReport>,
    /// Repairs that changed something, in order.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces looked inwards and would be turned.
    pub turned_outward: bool,
    /// Whether a match would accept it.
    pub suitable: bool,
    /// Why not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refusal: Option<Refusal>,
}

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum InputKind {
    /// Voxels with labels.
    LabelVolume,
    /// Vertices and faces.
    Mesh,
}

/// A label volume.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct VolumeInspection {
    /// Voxels along each axis.
    pub dims: [u32; 3],
    /// Distance of neighbouring voxel centres along each axis.
    pub spacing_mm: [f64; 3],
    /// How many labels but 0 occur.
    pub n_labels: u32,
    /// Labels but 0, ascending, the first thousand.
    pub labels: Vec<LabelCount>,
}

/// A label and how often it occurs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct LabelCount {
    /// The label.
    pub label: u32,
    /// Voxels that have it.
    pub n_voxels: u64,
}

/// Why a match would refuse the input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Refusal {
    /// Stable name, as [`IntakeError::code`].
    pub code: String,
    /// What is wrong, where, and what to do.
    pub detail: String,
}

/// Reads `bytes` and tells what it is and what would be made of it.
///
/// # Errors
/// [`IntakeError`] if the file cannot be read; what can be read but not matched is told in the answer.
///
/// # Cost
/// As [`super::prepare_surface`]; for unsuitable inputs up to four times that, to find which repair would help.
pub fn inspect(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Inspection, IntakeError> {
    let (format, content) = read(bytes, file_name, limits)?;
    let (kind, volume) = match &content {
        FileContent::Labels(volume) => (InputKind::LabelVolume, Some(describe(volume))),
        FileContent::Mesh(_) => (InputKind::Mesh, None),
    };
    let mut inspection = Inspection {
        format,
        kind,
        volume,
        topology: None,
        repaired_topology: None,
        repairs: Vec::new(),
        turned_outward: false,
        suitable: false,
        refusal: None,
    };
    let refusal = match Candidate::from_content(&content, parameters, limits) {
        Ok(candidate) => {
            let refusal = candidate.refusal(&content, parameters, limits);
            inspection.topology = Some(candidate.topology);
            inspection.repaired_topology = Some(candidate.repaired);
            inspection.repairs = candidate.repairs;
            inspection.turned_outward = candidate.turned_outward;
            refusal
        }
        Err(error) => {
            inspection.topology = error.topology().cloned();
            Some(error)
        }
    };
    inspection.suitable = refusal.is_none();
    inspection.refusal = refusal.map(|e| Refusal { code: e.code().to_owned(), detail: e.to_string() });
    Ok(inspection)
}

fn describe(volume: &LabelVolume) -> VolumeInspection {
    let counts = volume.label_counts();
    VolumeInspection {
        dims: volume.dims().map(|d| d as u32),
        spacing_mm: volume.spacing_mm(),
        n_labels: counts.len() as u32,
        labels: counts
            .into_iter()
            .take(MAX_LISTED_LABELS)
            .map(|(label, n_voxels)| LabelCount { label, n_voxels })
            .collect(),
    }
}
