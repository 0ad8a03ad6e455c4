//! Blobs, addressed by their content.

pub mod folder;
mod pieces;
pub mod s3;
pub mod sealed;
mod stored_blobs;

/// Message about a blob that the store does not hold.
const NOT_THERE: &str = "a blob that is not there";

pub use folder::FolderArtifacts;
pub use s3::S3Artifacts;
pub use sealed::SealedArtifacts;
pub use stored_blobs::StoredBlobs;
