//! Blobs, addressed by their content.

pub mod folder;
mod pieces;
pub mod s3;
pub mod sealed;

pub use folder::FolderArtifacts;
pub use s3::S3Artifacts;
pub use sealed::{SealedArtifacts, StoredBlobs};
