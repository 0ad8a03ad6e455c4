//! Reports on an input: its format, its topology, the repairs made, and whether it can be matched.

use crate::parameters::Repair;
use homolog_mesh::topology::TopologyReport;

/// Format of an input file.
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

/// An input: its format, its topology and the repairs made to it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputReport {
    /// The file's format.
    pub format: InputFormat,
    /// Topology of the surface before repairs.
    pub topology: TopologyReport,
    /// Repairs that changed the surface, in the order in which they were made.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces were oriented inwards (the enclosed volume before repairs is negative) and were reversed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub turned_outward: bool,
}

/// A repair that changed the surface.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RepairNote {
    /// Which repair.
    pub repair: Repair,
    /// One sentence that says what was changed, with numbers.
    pub detail: String,
}

/// The report of an inspection: the contents of an input, the surface that would be made of it, and whether that surface
/// can be matched.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Inspection {
    /// The file's format.
    pub format: InputFormat,
    /// Its contents.
    pub kind: InputKind,
    /// The label volume; absent for meshes.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub volume: Option<VolumeInspection>,
    /// Topology of the surface before repairs; absent if no surface could be made.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub topology: Option<TopologyReport>,
    /// Topology after the repairs that the parameters allow.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub repaired_topology: Option<TopologyReport>,
    /// Repairs that changed the surface, in the order in which they were made.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces are oriented inwards and would be reversed.
    pub turned_outward: bool,
    /// Whether a match would accept the input.
    pub suitable: bool,
    /// Why a match would refuse it; absent if it would not.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub refusal: Option<Refusal>,
}

/// The contents of a file.
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
    /// Distance between the centres of neighbouring voxels along each axis, mm.
    pub spacing_mm: [f64; 3],
    /// Number of different labels, without the background 0.
    pub n_labels: u32,
    /// The labels without the background 0, ascending; at most the first thousand.
    pub labels: Vec<LabelCount>,
}

/// A label and its number of voxels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LabelCount {
    /// The label.
    pub label: u32,
    /// Number of voxels with this label.
    pub n_voxels: u64,
}

/// Why a match would refuse the input.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Refusal {
    /// Stable name of the reason.
    pub code: String,
    /// What is wrong, where, and what can be done about it.
    pub detail: String,
}
