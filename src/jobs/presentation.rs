//! The parts of a result in the file formats in which they can be had.
//!
//! Each part is stored in one form; the [`Engine`] makes the others from it when they are asked for.

use super::engine::Engine;
use super::error::JobError;
use super::job::{JobId, Tenant};
use super::ports::{ArtifactKind, ArtifactRef};
use super::service::JobService;
use bytes::Bytes;
use std::sync::Arc;

/// A part of a result that a client can read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ResultPart {
    /// The dense correspondence.
    Correspondences,
    /// The rigid transform.
    Transform,
    /// The source surface whose vertices are counted.
    SourceSurface,
    /// The target surface, likewise.
    TargetSurface,
    /// The source surface moved onto the target.
    Aligned,
}

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
}

impl ResultPart {
    /// The name used in file names.
    pub fn name(self) -> &'static str {
        match self {
            ResultPart::Correspondences => "correspondences",
            ResultPart::Transform => "transform",
            ResultPart::SourceSurface => "source",
            ResultPart::TargetSurface => "target",
            ResultPart::Aligned => "aligned",
        }
    }

    /// The formats in which it can be had, the first if nothing is asked for.
    pub fn formats(self) -> &'static [PartFormat] {
        use PartFormat::{Arrow, Csv, Gifti, Itk, Json, Lta, Npy, Ply, Stl, Text, Vtk};
        match self {
            ResultPart::Correspondences => &[Json, Csv, Npy, Arrow, Ply, Vtk, Gifti],
            ResultPart::Transform => &[Json, Text, Itk, Lta],
            ResultPart::SourceSurface | ResultPart::TargetSurface | ResultPart::Aligned => &[Ply, Vtk, Gifti, Stl],
        }
    }

    /// The format in which its blob can be answered as it is.
    fn stored_as(self) -> Option<PartFormat> {
        match self {
            ResultPart::Correspondences => Some(PartFormat::Json),
            ResultPart::Transform => None,
            _ => Some(PartFormat::Ply),
        }
    }

    /// The blobs that a format of it is made from.
    fn made_from(self, format: PartFormat) -> &'static [ArtifactKind] {
        match (self, format) {
            (ResultPart::Correspondences, PartFormat::Ply | PartFormat::Vtk | PartFormat::Gifti) => {
                &[ArtifactKind::Correspondences, ArtifactKind::SourceSurface]
            }
            (ResultPart::Correspondences, _) => &[ArtifactKind::Correspondences],
            (ResultPart::Transform, _) => &[ArtifactKind::Result],
            (ResultPart::SourceSurface, _) => &[ArtifactKind::SourceSurface],
            (ResultPart::TargetSurface, _) => &[ArtifactKind::TargetSurface],
            (ResultPart::Aligned, _) => &[ArtifactKind::Aligned],
        }
    }
}

impl PartFormat {
    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            PartFormat::Json => "json",
            PartFormat::Csv => "csv",
            PartFormat::Npy => "npy",
            PartFormat::Arrow => "arrow",
            PartFormat::Ply => "ply",
            PartFormat::Vtk => "vtk",
            PartFormat::Gifti => "gifti",
            PartFormat::Stl => "stl",
            PartFormat::Text => "text",
            PartFormat::Itk => "tfm",
            PartFormat::Lta => "lta",
        }
    }
}

/// Why a stored part cannot be had in a format.
#[derive(Debug, thiserror::Error)]
pub enum PresentError {
    /// The engine does not make this format of this part.
    #[error("{} is not made as {}", part.name(), format.name())]
    NotOffered {
        /// The part.
        part: ResultPart,
        /// The format.
        format: PartFormat,
    },
    /// What is stored cannot be read, or not be written in this format.
    #[error("{what}")]
    Unreadable {
        /// What.
        what: &'static str,
        /// Why.
        #[source]
        source: Option<Box<dyn std::error::Error + Send + Sync>>,
    },
}

/// A part in one format, found but not made yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Presentation {
    part: ResultPart,
    format: PartFormat,
    blobs: Vec<ArtifactRef>,
}

impl Presentation {
    /// Equal for equal bytes and different for different ones: blobs are named by their content and never change, and
    /// what is made from them depends on nothing but the version of this program.
    pub fn validator(&self) -> String {
        let blobs: Vec<&str> = self.blobs.iter().map(|blob| &blob.key.hash()[..32]).collect();
        let form = if self.part.stored_as() == Some(self.format) {
            self.format.name().to_owned()
        } else {
            format!("{}-{}", self.format.name(), env!("CARGO_PKG_VERSION"))
        };
        format!("{}-{form}", blobs.join("-"))
    }
}

impl JobService {
    /// Finds a part of a succeeded job's result.
    ///
    /// # Errors
    /// As for [`JobService::result_part`].
    pub async fn presentation(
        &self,
        tenant: &Tenant,
        id: JobId,
        part: ResultPart,
        format: PartFormat,
    ) -> Result<Presentation, JobError> {
        let mut blobs = Vec::new();
        for &kind in part.made_from(format) {
            blobs.push(self.result_part(tenant, id, kind).await?);
        }
        Ok(Presentation { part, format, blobs })
    }

    /// Its bytes. What is not stored in this format is made on a blocking thread.
    ///
    /// # Errors
    /// [`JobError`]; `Corrupt` if it cannot be made.
    pub async fn present(&self, wanted: &Presentation) -> Result<Bytes, JobError> {
        let &Presentation { part, format, .. } = wanted;
        // Waiting ends with the request: whoever cannot be served in time is told so.
        let place = Arc::clone(&self.presentations).acquire_owned().await;
        let place = place.map_err(|error| JobError::Unavailable(Box::new(error)))?;
        let mut blobs = Vec::new();
        for blob in &wanted.blobs {
            blobs.push(self.read(blob).await?);
        }
        if let (true, [stored]) = (part.stored_as() == Some(format), blobs.as_slice()) {
            return Ok(stored.clone());
        }
        let engine: Arc<dyn Engine> = Arc::clone(&self.engine);
        let made = tokio::task::spawn_blocking(move || {
            let _place = place;
            let stored: Vec<&[u8]> = blobs.iter().map(AsRef::as_ref).collect();
            engine.present(part, format, &stored)
        });
        match made.await {
            Ok(Ok(bytes)) => Ok(bytes.into()),
            Ok(Err(error)) => Err(JobError::corrupt("a stored part of a result", error)),
            Err(error) => Err(JobError::corrupt("a stored part of a result", error)),
        }
    }
}
