//! Reports on an input: its format, its topology, its repairs, and its suitability for matching.

use crate::parameters::Repair;
use crate::reason::UnreliableReason;
use homolog_mesh::topology::TopologyReport;

/// Format of an input file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InputFormat {
    /// NIfTI label volume, version 1 or 2, plain or gzip.
    Nifti,
    /// FreeSurfer label volume, MGH or MGZ.
    Mgh,
    /// NRRD label volume, also `.seg.nrrd` of 3D Slicer.
    Nrrd,
    /// MetaImage label volume in one file.
    MetaImage,
    /// DICOM segmentation.
    DicomSeg,
    /// FreeSurfer surface, binary or ASCII.
    Freesurfer,
    /// GIFTI surface.
    Gifti,
    /// Stanford PLY.
    Ply,
    /// STL.
    Stl,
    /// Legacy VTK.
    Vtk,
    /// VTK XML poly data.
    Vtp,
    /// Wavefront OBJ.
    Obj,
    /// OFF of Geomview.
    Off,
    /// MZ3 of Surf Ice.
    Mz3,
}

impl InputFormat {
    /// All formats, label volumes first.
    pub const ALL: [InputFormat; 14] = [
        InputFormat::Nifti,
        InputFormat::Mgh,
        InputFormat::Nrrd,
        InputFormat::MetaImage,
        InputFormat::DicomSeg,
        InputFormat::Freesurfer,
        InputFormat::Gifti,
        InputFormat::Ply,
        InputFormat::Stl,
        InputFormat::Vtk,
        InputFormat::Vtp,
        InputFormat::Obj,
        InputFormat::Off,
        InputFormat::Mz3,
    ];

    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            InputFormat::Nifti => "nifti",
            InputFormat::Mgh => "mgh",
            InputFormat::Nrrd => "nrrd",
            InputFormat::MetaImage => "meta_image",
            InputFormat::DicomSeg => "dicom_seg",
            InputFormat::Freesurfer => "freesurfer",
            InputFormat::Gifti => "gifti",
            InputFormat::Ply => "ply",
            InputFormat::Stl => "stl",
            InputFormat::Vtk => "vtk",
            InputFormat::Vtp => "vtp",
            InputFormat::Obj => "obj",
            InputFormat::Off => "off",
            InputFormat::Mz3 => "mz3",
        }
    }

    /// The name used in sentences.
    pub fn title(self) -> &'static str {
        match self {
            InputFormat::Nifti => "NIfTI",
            InputFormat::Mgh => "MGH/MGZ",
            InputFormat::Nrrd => "NRRD",
            InputFormat::MetaImage => "MetaImage",
            InputFormat::DicomSeg => "DICOM SEG",
            InputFormat::Freesurfer => "a FreeSurfer surface",
            InputFormat::Gifti => "GIFTI",
            InputFormat::Ply => "PLY",
            InputFormat::Stl => "STL",
            InputFormat::Vtk => "legacy VTK",
            InputFormat::Vtp => "VTP",
            InputFormat::Obj => "Wavefront OBJ",
            InputFormat::Off => "OFF",
            InputFormat::Mz3 => "MZ3",
        }
    }
}

/// The space of coordinates that a file declares. Inside, and in every answer, coordinates are RAS: those in LPS are converted,
/// all others stay as they are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum InputSpace {
    /// Right, anterior, superior, of the scanner or of an image aligned with it.
    ScannerRas,
    /// Surface RAS of FreeSurfer (tkregister): shifted against scanner RAS by the `c_ras` of the volume.
    FreesurferRas,
    /// Left, posterior, superior, as in DICOM and ITK; converted to RAS.
    Lps,
    /// Unstated, or another space.
    #[default]
    Unknown,
}

/// The side of the body on which a structure lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum BodySide {
    /// Left.
    Left,
    /// Right.
    Right,
}

impl BodySide {
    /// The name used in JSON and in tables.
    pub fn name(self) -> &'static str {
        match self {
            BodySide::Left => "left",
            BodySide::Right => "right",
        }
    }

    /// The side of a name: `left`, `l` or `lh`, `right`, `r` or `rh`, in upper or lower case.
    pub fn of_name(name: &str) -> Option<Self> {
        match name.to_ascii_lowercase().as_str() {
            "left" | "l" | "lh" => Some(BodySide::Left),
            "right" | "r" | "rh" => Some(BodySide::Right),
            _ => None,
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
    /// The space of coordinates that it declares.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub space: Option<InputSpace>,
    /// Topology of the surface before repairs.
    pub topology: TopologyReport,
    /// Repairs that changed the surface, in the order in which they were made.
    pub repairs: Vec<RepairNote>,
    /// Whether all faces were oriented inwards (the enclosed volume before repairs is negative) and were reversed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub turned_outward: bool,
    /// Changes of coordinates or values on reading, and a name that promises another format: a sentence each.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub notes: Vec<String>,
    /// Contradictions within the file, and everything dropped, joined, filled or smoothed away on the way to the surface.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub warnings: Vec<InputWarning>,
    /// Uncertainty due to the size of the voxels; absent for meshes.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub sampling: Option<SamplingReport>,
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

/// A contradiction within a file, or something dropped, joined, filled or smoothed away on the way to its surface.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputWarning {
    /// The reason for which an answer on this input is not reliable; absent if the warning alone is none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub reason: Option<UnreliableReason>,
    /// One sentence that says what was done, with numbers, and what to do if it was not meant.
    pub detail: String,
}

/// Uncertainty of a surface due to the size of its voxels: standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SamplingReport {
    /// Of the position of the surface along its normal, mm.
    pub noise_mm: f64,
    /// Of the rotation about the axis about which it is known least, by any method; 180 for surfaces that are round about it.
    pub rotation_deg: f64,
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
    /// The space of coordinates that it declares.
    #[cfg_attr(feature = "serde", serde(default))]
    pub space: InputSpace,
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
    /// Changes of coordinates or values on reading, and a name that promises another format: a sentence each.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub notes: Vec<String>,
    /// Contradictions within the file, and everything dropped, joined, filled or smoothed away on the way to the surface.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub warnings: Vec<InputWarning>,
    /// Uncertainty due to the size of the voxels; absent for meshes.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub sampling: Option<SamplingReport>,
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
    /// Distance between the centers of neighboring voxels along each axis, mm.
    pub spacing_mm: [f64; 3],
    /// Number of different labels, without the background 0.
    pub n_labels: u32,
    /// The labels without the background 0, ascending; at most the first thousand.
    pub labels: Vec<LabelCount>,
}

/// A label and its number of voxels.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LabelCount {
    /// The label.
    pub label: u32,
    /// Its name in the file, or in the table of the one well-known segmentation that has all labels of the volume.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<String>,
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
    /// The fault, its place, and its remedy.
    pub detail: String,
}
