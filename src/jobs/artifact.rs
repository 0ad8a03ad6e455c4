//! Blobs as jobs refer to them: kind, address and size.

use super::job::Tenant;
use super::lease::Lease;
use std::time::Duration;

/// Longest time from the hold of blobs to the reference to them; the hold then lapses, and they can be removed as unreferenced.
pub(crate) const BLOB_HOLD: Duration = Duration::from_secs(600);

/// Kind of the content of a blob of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ArtifactKind {
    /// The source as uploaded.
    Source,
    /// The target as uploaded.
    Target,
    /// The result document without its correspondences, JSON.
    Result,
    /// The correspondences in columns, JSON.
    Correspondences,
    /// The source surface to whose vertices the correspondences refer.
    SourceSurface,
    /// The target surface to whose vertices the correspondences refer.
    TargetSurface,
    /// The source surface moved onto the target.
    Aligned,
    /// The record of a match that a study keeps.
    StudyRecord,
    /// The matches that a step of a study found missing, JSON.
    StudyPlan,
    /// The template of a study.
    StudyTemplate,
    /// How that template was made, JSON; from then on it is kept.
    StudyKept,
    /// The templates of persons that the missing matches need, PLY files one after the other.
    StudyOwnTemplates,
    /// A study and its figures, JSON.
    StudyDocument,
    /// A page about a study.
    StudyReport,
    /// Everything that was found in a study, a zip archive.
    StudyArchive,
    /// The score of a new subject against a study, JSON.
    StudyScore,
}

impl ArtifactKind {
    /// The name in the database.
    pub fn name(self) -> &'static str {
        match self {
            ArtifactKind::Source => "source",
            ArtifactKind::Target => "target",
            ArtifactKind::Result => "result",
            ArtifactKind::Correspondences => "correspondences",
            ArtifactKind::SourceSurface => "source_surface",
            ArtifactKind::TargetSurface => "target_surface",
            ArtifactKind::Aligned => "aligned",
            ArtifactKind::StudyRecord => "study_record",
            ArtifactKind::StudyPlan => "study_plan",
            ArtifactKind::StudyTemplate => "study_template",
            ArtifactKind::StudyKept => "study_kept",
            ArtifactKind::StudyOwnTemplates => "study_own_templates",
            ArtifactKind::StudyDocument => "study_document",
            ArtifactKind::StudyReport => "study_report",
            ArtifactKind::StudyArchive => "study_archive",
            ArtifactKind::StudyScore => "study_score",
        }
    }
}

/// The address of a blob within a tenant: a path whose last part is the hash of the content.
///
/// An upload is addressed by its content alone, so that equal files are one blob. The address of a worker's result also
/// contains its lease: a worker that has lost its lease cannot overwrite what its successor writes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ArtifactKey {
    /// Owner; equal bytes of two tenants are two blobs.
    pub tenant: Tenant,
    path: String,
}

impl ArtifactKey {
    /// The address of an upload with this content.
    pub fn of(tenant: &Tenant, bytes: &[u8]) -> Self {
        let hash = blake3::hash(bytes).to_hex();
        let path = format!("{}/{}/{hash}", &hash[0..2], &hash[2..4]);
        ArtifactKey { tenant: tenant.clone(), path }
    }

    /// The address of an upload whose content has this hash; `None` if `hash` is not a hash.
    pub fn of_hash(tenant: &Tenant, hash: &str) -> Option<Self> {
        is_hash(hash).then(|| {
            let path = format!("{}/{}/{hash}", &hash[0..2], &hash[2..4]);
            ArtifactKey { tenant: tenant.clone(), path }
        })
    }

    /// The address of a result with this content, computed under `lease`.
    pub fn of_result(lease: &Lease, bytes: &[u8]) -> Self {
        let hash = blake3::hash(bytes).to_hex();
        ArtifactKey { tenant: lease.tenant.clone(), path: format!("results/{}/{}/{hash}", lease.job_id, lease.epoch) }
    }

    /// The address with this path; `None` if no address has this form.
    pub fn from_path(tenant: &Tenant, path: &str) -> Option<Self> {
        let (folder, hash) = path.rsplit_once('/')?;
        let safe = folder.split('/').all(|part| {
            !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
        });
        (safe && is_hash(hash)).then(|| ArtifactKey { tenant: tenant.clone(), path: path.to_owned() })
    }

    /// The path under the tenant.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// 64 lower-case hexadecimal digits of BLAKE3 of the content.
    pub fn hash(&self) -> &str {
        self.path.rsplit_once('/').map_or("", |(_, hash)| hash)
    }
}

/// Whether a text is a hash as this program writes it: 64 lower-case hexadecimal digits.
pub(super) fn is_hash(text: &str) -> bool {
    text.len() == 64 && text.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'))
}

/// A blob that a job refers to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ArtifactRef {
    /// Kind of its content.
    pub kind: ArtifactKind,
    /// Its address.
    pub key: ArtifactKey,
    /// Its size, bytes.
    pub n_bytes: u64,
}
