//! Blobs by content.

pub mod folder;

pub use folder::FolderArtifacts;
