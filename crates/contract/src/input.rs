//! What an input was and what was done to it, and what an inspection tells.

use crate::parameters::Repair;
use homolog_mesh::topology::TopologyReport;

/// Formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InputFormat {
    /// NIfTI-1 label volume, plain or gzip.
    Nifti,
    /// Stanford PLY.
    Ply,
    /// STL.
    Stl,
    /// Legacy VTK.
    Vtk,
}

impl InputFormat {
    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            InputFormat::Nifti => "nifti",
            InputFormat::Ply => "ply",
            InputFormat::Stl => "stl",
            InputFormat::Vtk => "vtk",
        }
    }
}

/// What an input was, and what was done to it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputReport {
    /// The file's format.
    pub format: InputFormat,
    /// Topology of the surface before repairs.
    pub topology: TopologyReport,
    /// Repairs that changed something, in order.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces looked inwards (the volume before repairs is negative) and were turned.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub turned_outward: bool,
}

/// A repair that changed something.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RepairNote {
    /// Which repair.
    pub repair: Repair,
    /// What it changed, in one sentence with numbers.
    pub detail: String,
}

/// What an input is, what would be made of it, and whether that can be matched.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Inspection {
    /// The file's format.
    pub format: InputFormat,
    /// What it holds.
    pub kind: InputKind,
    /// The volume, if it holds one.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub volume: Option<VolumeInspection>,
    /// Topology of the surface before repairs; absent if there is no surface.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub topology: Option<TopologyReport>,
    /// Topology after the repairs that the parameters allow.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub repaired_topology: Option<TopologyReport>,
    /// Repairs that changed something, in order.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces looked inwards and would be turned.
    pub turned_outward: bool,
    /// Whether a match would accept it.
    pub suitable: bool,
    /// Why not.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub refusal: Option<Refusal>,
}

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InputKind {
    /// Voxels with labels.
    LabelVolume,
    /// Vertices and faces.
    Mesh,
}

/// A label volume.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LabelCount {
    /// The label.
    pub label: u32,
    /// Voxels that have it.
    pub n_voxels: u64,
}

/// Why a match would refuse the input.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Refusal {
    /// Stable name, as [`IntakeError::code`].
    pub code: String,
    /// What is wrong, where, and what to do.
    pub detail: String,
}
