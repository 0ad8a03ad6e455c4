//! The parts of a result, and the file formats in which they are available.
//!
//! Each part is stored in one format; the [`Engine`] converts it to the others on request.

use super::engine::Engine;
use super::error::JobError;
use super::job::{JobId, Tenant};
use super::ports::{ArtifactKind, ArtifactRef};
use super::service::JobService;
use super::trace::NumberedPoint;
use super::uid::{DicomDetails, GivenUids};
use bytes::Bytes;
pub use homolog_contract::result::{WarpDirection, WarpSpace};
use std::sync::Arc;

/// Points of the energy trace that are read at once, and at most for a report: more than a plot can show.
const TRACE_PAGE: u32 = 1000;
const MOST_TRACE_POINTS: usize = 20_000;

/// A part of a result that a client can read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
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
    fn stored_as(self) -> Option<PartFormat> {
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
    fn made_from(self, format: PartFormat) -> &'static [ArtifactKind] {
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
        /// What.
        what: &'static str,
        /// Why.
        #[source]
        source: Option<Box<dyn std::error::Error + Send + Sync>>,
    },
}

/// A part in one format, found but not converted yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Presentation {
    part: ResultPart,
    format: PartFormat,
    blobs: Vec<ArtifactRef>,
    /// For DICOM: the identifiers that inputs do not state.
    uids: GivenUids,
    /// The job that they are of.
    of: (Tenant, JobId),
}

/// The content of a part in one format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Presented {
    /// The blob in which it is stored.
    Stored(ArtifactRef),
    /// Converted from the stored blobs.
    Converted(Bytes),
}

impl Presentation {
    /// Equal for equal content, different for different content: blobs are addressed by their content and never change, and
    /// conversions depend on nothing but the version of this program.
    pub fn validator(&self) -> String {
        let blobs: Vec<&str> = self.blobs.iter().map(|blob| &blob.key.hash()[..32]).collect();
        let form = if self.part.stored_as() == Some(self.format) {
            self.format.name().to_owned()
        } else {
            format!("{}-{}", self.format.name(), env!("CARGO_PKG_VERSION"))
        };
        let form = match self.part {
            ResultPart::Warped { direction, space } => format!("{form}-{}-{}", direction.name(), space.name()),
            ResultPart::Correspondences { direction } => format!("{form}-{}", direction.name()),
            _ => form,
        };
        let form = if self.format == PartFormat::Dicom && self.uids != GivenUids::default() {
            let uids = blake3::hash(format!("{:?}", self.uids.texts()).as_bytes()).to_hex();
            format!("{form}-{}", &uids[..32])
        } else {
            form
        };
        format!("{}-{form}", blobs.join("-"))
    }
}

impl JobService {
    /// Finds a part of a succeeded job's result. `uids` are for DICOM objects alone.
    ///
    /// # Errors
    /// As for [`JobService::result_part`].
    pub async fn presentation(
        &self,
        tenant: &Tenant,
        id: JobId,
        part: ResultPart,
        format: PartFormat,
        uids: GivenUids,
    ) -> Result<Presentation, JobError> {
        let mut blobs = Vec::new();
        for &kind in part.made_from(format) {
            blobs.push(self.result_part(tenant, id, kind).await?);
        }
        Ok(Presentation { part, format, blobs, uids, of: (tenant.clone(), id) })
    }

    /// Its content: the blob in which it is stored in this format, or what is converted on a blocking thread.
    ///
    /// # Errors
    /// [`JobError`]; [`JobError::Corrupt`] if it cannot be converted.
    pub async fn present(&self, wanted: &Presentation) -> Result<Presented, JobError> {
        let &Presentation { part, format, .. } = wanted;
        if let (true, [stored]) = (part.stored_as() == Some(format), wanted.blobs.as_slice()) {
            return Ok(Presented::Stored(stored.clone()));
        }
        // The wait for a permit ends with the time limit of the request.
        let permit = Arc::clone(&self.presentations).acquire_owned().await;
        let permit = permit.map_err(|error| JobError::Unavailable(Box::new(error)))?;
        let mut blobs = Vec::new();
        for blob in &wanted.blobs {
            blobs.push(self.read(blob).await?);
        }
        let (tenant, id) = &wanted.of;
        match (part, format) {
            (ResultPart::Report, _) => {
                let points = self.whole_trace(tenant, *id).await?;
                let points =
                    serde_json::to_vec(&points).map_err(|error| JobError::corrupt("an energy trace", error))?;
                blobs.push(points.into());
            }
            (_, PartFormat::Dicom) => {
                let finished_at = self.get(tenant, *id).await?.finished_at.unwrap_or_default();
                let ended_at = finished_at.strftime("%Y%m%d%H%M%S").to_string();
                let details = DicomDetails { ended_at, uids: wanted.uids.clone() };
                let details = serde_json::to_vec(&details);
                blobs.push(details.map_err(|error| JobError::corrupt("the details of an object", error))?.into());
            }
            _ => {}
        }
        let engine: Arc<dyn Engine> = Arc::clone(&self.engine);
        let made = tokio::task::spawn_blocking(move || {
            let _permit = permit;
            let stored: Vec<&[u8]> = blobs.iter().map(AsRef::as_ref).collect();
            engine.present(part, format, &stored)
        });
        match made.await {
            Ok(Ok(bytes)) => Ok(Presented::Converted(bytes.into())),
            Ok(Err(PresentError::NoInverse)) => Err(JobError::NoInverse),
            Ok(Err(PresentError::NotDicom)) => Err(JobError::NotDicom),
            Ok(Err(PresentError::NoSegmentation)) => Err(JobError::NoSegmentation),
            Ok(Err(error)) => Err(JobError::corrupt("a stored part of a result", error)),
            Err(error) => Err(JobError::corrupt("a stored part of a result", error)),
        }
    }

    /// The energy trace of a finished job, up to [`MOST_TRACE_POINTS`].
    async fn whole_trace(&self, tenant: &Tenant, id: JobId) -> Result<Vec<NumberedPoint>, JobError> {
        let mut points: Vec<NumberedPoint> = Vec::new();
        loop {
            let after = points.last().map_or(0, |point| point.seq);
            let page = self.trace(tenant, id, after, TRACE_PAGE).await?;
            points.extend(page.points);
            if page.complete
                || points.last().is_none_or(|point| point.seq == after)
                || points.len() >= MOST_TRACE_POINTS
            {
                return Ok(points);
            }
        }
    }
}
