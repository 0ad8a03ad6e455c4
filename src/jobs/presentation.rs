//! The content of a part of a result in one of its file formats.
//!
//! Each part is stored in one format; the [`Engine`] converts it to the others on request.

use super::artifact::ArtifactRef;
use super::engine::Engine;
use super::error::JobError;
use super::ids::JobId;
use super::job::Tenant;
use super::result_part::{PartFormat, ResultPart};
use super::service::JobService;
use super::trace::NumberedPoint;
use super::uid::{DicomDetails, GivenUids};
use bytes::Bytes;
use std::sync::Arc;

/// Points of the energy trace that are read at once, and at most for a report: more than a plot can show.
const TRACE_PAGE: u32 = 1000;
const MOST_TRACE_POINTS: usize = 20_000;

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
        let made = made.await.map_err(|error| JobError::corrupt("a stored part of a result", error))?;
        Ok(Presented::Converted(made?.into()))
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
