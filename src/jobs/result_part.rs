//! The parts of a result, the file formats in which they are available, and the reasons why a part is not available in one.

use super::artifact::ArtifactKind;
pub use homolog_contract::result::{WarpDirection, WarpSpace};
use serde::{Deserialize, Serialize};

/// A part of a result that a client can read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ResultPart {
    /// The dense correspondence.
    Correspondences {
        /// From source to target, or from target to source.
        direction: WarpDirection,
    },
    /// The rigid transform.
    Transform,
    /// The source surface to whose vertices the correspondences refer.
    SourceSurface,
    /// The target surface to which the correspondences refer.
    TargetSurface,
    /// The source surface moved rigidly onto the target.
    Aligned,
    /// One surface deformed onto the other, with the deformation at each vertex.
    Warped {
        /// Which is bent.
        direction: WarpDirection,
        /// In whose coordinates.
        space: WarpSpace,
    },
    /// A page for people, with everything that can be looked at.
    Report,
}

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PartFormat {
    /// JSON.
    Json,
    /// Comma-separated values.
    Csv,
    /// NumPy.
    Npy,
    /// Arrow IPC file.
    Arrow,
    /// Stanford PLY.
    Ply,
    /// Legacy VTK.
    Vtk,
    /// VTK XML poly data.
    Vtp,
    /// GIFTI.
    Gifti,
    /// STL.
    Stl,
    /// Plain text.
    Text,
    /// ITK transform.
    Itk,
    /// FreeSurfer linear transform array.
    Lta,
    /// A page for browsers.
    Html,
    /// NumPy arrays in a zip archive.
    Npz,
    /// Apache Parquet.
    Parquet,
    /// glTF 2.0 binary.
    Glb,
    /// DICOM, of the study of an input.
    Dicom,
}

impl ResultPart {
    /// The name used in file names.
    pub fn name(self) -> &'static str {
        match self {
            ResultPart::Correspondences { direction: WarpDirection::Forward } => "correspondences",
            ResultPart::Correspondences { direction: WarpDirection::Inverse } => "correspondences-inverse",
            ResultPart::Transform => "transform",
            ResultPart::SourceSurface => "source",
            ResultPart::TargetSurface => "target",
            ResultPart::Aligned => "aligned",
            ResultPart::Warped { direction: WarpDirection::Forward, .. } => "warped",
            ResultPart::Warped { direction: WarpDirection::Inverse, .. } => "warped-inverse",
            ResultPart::Report => "report",
        }
    }

    /// The available formats, the default first.
    pub fn formats(self) -> &'static [PartFormat] {
        use PartFormat::{
            Arrow, Csv, Dicom, Gifti, Glb, Html, Itk, Json, Lta, Npy, Npz, Parquet, Ply, Stl, Text, Vtk, Vtp,
        };
        match self {
            ResultPart::Correspondences { .. } => &[Json, Csv, Npy, Npz, Arrow, Parquet, Ply, Vtk, Vtp, Gifti, Glb],
            ResultPart::Transform => &[Json, Text, Itk, Lta, Dicom],
            ResultPart::SourceSurface | ResultPart::TargetSurface | ResultPart::Aligned => {
                &[Ply, Vtk, Vtp, Gifti, Stl, Glb]
            }
            ResultPart::Warped { .. } => &[Ply, Vtk, Vtp, Gifti, Stl, Glb, Json, Csv, Npy, Npz, Arrow, Parquet, Dicom],
            ResultPart::Report => &[Html],
        }
    }

    /// The format in which it is stored.
    pub(super) fn stored_as(self) -> Option<PartFormat> {
        match self {
            ResultPart::Correspondences { direction: WarpDirection::Forward } => Some(PartFormat::Json),
            ResultPart::Correspondences { direction: WarpDirection::Inverse }
            | ResultPart::Transform
            | ResultPart::Warped { .. }
            | ResultPart::Report => None,
            _ => Some(PartFormat::Ply),
        }
    }

    /// The blobs from which it is converted to a format.
    pub(super) fn made_from(self, format: PartFormat) -> &'static [ArtifactKind] {
        match (self, format) {
            (
                ResultPart::Correspondences { direction },
                PartFormat::Ply | PartFormat::Vtk | PartFormat::Vtp | PartFormat::Gifti,
            ) => match direction {
                WarpDirection::Forward => &[ArtifactKind::Correspondences, ArtifactKind::SourceSurface],
                WarpDirection::Inverse => &[ArtifactKind::Correspondences, ArtifactKind::TargetSurface],
            },
            (ResultPart::Correspondences { .. }, PartFormat::Glb) => &[
                ArtifactKind::Result,
                ArtifactKind::Correspondences,
                ArtifactKind::SourceSurface,
                ArtifactKind::TargetSurface,
            ],
            (ResultPart::Correspondences { .. }, _) => &[ArtifactKind::Correspondences],
            (ResultPart::Transform, PartFormat::Dicom | PartFormat::Lta) => {
                &[ArtifactKind::Result, ArtifactKind::Source, ArtifactKind::Target]
            }
            (ResultPart::Transform, _) => &[ArtifactKind::Result],
            (ResultPart::SourceSurface, _) => &[ArtifactKind::SourceSurface],
            (ResultPart::TargetSurface, _) => &[ArtifactKind::TargetSurface],
            (ResultPart::Aligned, _) => &[ArtifactKind::Aligned],
            (ResultPart::Warped { .. }, PartFormat::Dicom) => &[
                ArtifactKind::Result,
                ArtifactKind::Correspondences,
                ArtifactKind::SourceSurface,
                ArtifactKind::TargetSurface,
                ArtifactKind::Source,
                ArtifactKind::Target,
            ],
            (ResultPart::Warped { .. } | ResultPart::Report, _) => &[
                ArtifactKind::Result,
                ArtifactKind::Correspondences,
                ArtifactKind::SourceSurface,
                ArtifactKind::TargetSurface,
            ],
        }
    }
}

impl PartFormat {
    /// Its name in requests.
    pub fn name(self) -> &'static str {
        match self {
            PartFormat::Json => "json",
            PartFormat::Csv => "csv",
            PartFormat::Npy => "npy",
            PartFormat::Arrow => "arrow",
            PartFormat::Ply => "ply",
            PartFormat::Vtk => "vtk",
            PartFormat::Vtp => "vtp",
            PartFormat::Gifti => "gifti",
            PartFormat::Stl => "stl",
            PartFormat::Text => "text",
            PartFormat::Itk => "tfm",
            PartFormat::Lta => "lta",
            PartFormat::Html => "html",
            PartFormat::Npz => "npz",
            PartFormat::Parquet => "parquet",
            PartFormat::Glb => "glb",
            PartFormat::Dicom => "dicom",
        }
    }
}

/// Why a part is not available in a format.
#[derive(Debug, thiserror::Error)]
pub enum PresentError {
    /// The engine does not convert this part to this format.
    #[error("{} is not made as {}", part.name(), format.name())]
    NotOffered {
        /// The part.
        part: ResultPart,
        /// The format.
        format: PartFormat,
    },
    /// The job did not compute the map from the target to the source.
    #[error("the inverse correspondences were not computed")]
    NoInverse,
    /// Neither input is a DICOM object, and no study was given.
    #[error("neither input is a DICOM object, and no study was given")]
    NotDicom,
    /// The bent surface is open or too large for a grid, so that it has no segmentation.
    #[error("the bent surface has no segmentation")]
    NoSegmentation,
    /// The stored part cannot be read, or not be written in this format.
    #[error("{what}")]
    Unreadable {
        /// Description of the part or of its fault.
        what: &'static str,
        /// Why.
        #[source]
        source: Option<Box<dyn std::error::Error + Send + Sync>>,
    },
}
