//! Blobs in a folder: `blobs/<tenant>/ab/cd/abcd…` for uploads, `blobs/<tenant>/results/<job>/<epoch>/…` for results.
//!
//! A blob is written to a temporary file, flushed to disk and renamed into place, and the folders of its path are
//! flushed too; so a blob under its final name is complete and survives a loss of power. Equal content is stored once.

use super::NOT_THERE;
use super::pieces::in_pieces;
use super::stored_blobs::StoredBlobs;
use crate::jobs::{ArtifactKey, ArtifactStore, ArtifactWriter, BlobStream, JobError, Tenant};
use crate::store::{private_files, reserve};
use async_trait::async_trait;
use bytes::Bytes;
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Bytes written to test whether the disk has room.
const TRIED_BYTES: usize = 64 << 10;
/// Memory of a reader of a blob, bytes.
const PIECE: u64 = 256 << 10;

/// Age at which a temporary file is removed: no write takes this long, so the process that wrote it has ended.
const STALE: Duration = Duration::from_secs(3600);

/// A folder of blobs.
#[derive(Debug, Clone)]
pub struct FolderArtifacts {
    blobs: PathBuf,
    temporary: PathBuf,
}

impl FolderArtifacts {
    /// The blobs under `data_dir`, which is created if it does not exist.
    ///
    /// # Errors
    /// [`JobError::Unavailable`] if it cannot be created.
    pub fn open(data_dir: &Path) -> Result<Self, JobError> {
        let store = FolderArtifacts { blobs: data_dir.join("blobs"), temporary: data_dir.join("incoming") };
        for folder in [&store.blobs, &store.temporary] {
            private_files::create_dir_all(folder).map_err(domain_error)?;
        }
        sync_folder(data_dir).map_err(domain_error)?;
        Ok(store)
    }

    /// The blobs under `data_dir`, for reading only: nothing is created.
    pub(in crate::store) fn of_blobs(data_dir: &Path) -> Self {
        FolderArtifacts { blobs: data_dir.join("blobs"), temporary: data_dir.join("incoming") }
    }

    /// The file of a blob. A key has no `..` and no absolute parts, so the path stays in the folder.
    fn path(&self, key: &ArtifactKey) -> PathBuf {
        self.blobs.join(key.tenant.name()).join(key.path())
    }

    /// Renames a completely written file to its final name.
    fn publish(&self, file: &File, temporary: &Path, path: &Path) -> io::Result<()> {
        file.sync_all()?;
        let parent = path.parent().ok_or(io::ErrorKind::InvalidInput)?;
        private_files::create_dir_all(parent)?;
        fs::rename(temporary, path)?;
        // The blob's folder and its ancestors up to the root of the blobs, any of which may be new.
        for folder in parent.ancestors().take_while(|folder| folder.starts_with(&self.blobs)) {
            sync_folder(folder)?;
        }
        Ok(())
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        if fs::metadata(path).is_ok_and(|m| m.len() == bytes.len() as u64) {
            return Ok(()); // the name is the hash of the content, and only complete blobs get their name
        }
        let temporary = self.temporary.join(uuid::Uuid::new_v4().to_string());
        let written = (|| {
            let mut file = private_files::create_new(&temporary)?;
            file.write_all(bytes)?;
            self.publish(&file, &temporary, path)
        })();
        if written.is_err() {
            let _ = fs::remove_file(&temporary);
        }
        written
    }
}

/// A blob that is written to a temporary file in parts.
struct FolderWriter {
    store: FolderArtifacts,
    temporary: PathBuf,
    file: Option<File>,
}

#[async_trait]
impl ArtifactWriter for FolderWriter {
    async fn write(&mut self, part: Bytes) -> Result<(), JobError> {
        let mut file = self.file.take().ok_or_else(|| domain_error(io::ErrorKind::InvalidInput.into()))?;
        let file = blocking(move || file.write_all(&part).map(|()| file)).await?;
        self.file = Some(file);
        Ok(())
    }

    async fn commit(mut self: Box<Self>, key: &ArtifactKey) -> Result<(), JobError> {
        let file = self.file.take().ok_or_else(|| domain_error(io::ErrorKind::InvalidInput.into()))?;
        let (store, temporary, path) = (self.store.clone(), self.temporary.clone(), self.store.path(key));
        blocking(move || store.publish(&file, &temporary, &path)).await
    }
}

impl Drop for FolderWriter {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.temporary); // gone already if it was committed
    }
}

#[cfg(unix)]
fn read_at(file: &File, into: &mut [u8], start: u64) -> io::Result<()> {
    std::os::unix::fs::FileExt::read_exact_at(file, into, start)
}

#[cfg(not(unix))]
fn read_at(mut file: &File, into: &mut [u8], start: u64) -> io::Result<()> {
    use std::io::{Read as _, Seek as _, SeekFrom};
    file.seek(SeekFrom::Start(start))?;
    file.read_exact(into)
}

fn sync_folder(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

fn domain_error(error: io::Error) -> JobError {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => JobError::StorageFull,
        _ => JobError::Unavailable(Box::new(error)),
    }
}

/// Runs file operations on a thread that may block.
async fn blocking<T: Send + 'static>(work: impl FnOnce() -> io::Result<T> + Send + 'static) -> Result<T, JobError> {
    match tokio::task::spawn_blocking(work).await {
        Ok(done) => done.map_err(domain_error),
        Err(join) => Err(JobError::Unavailable(Box::new(join))),
    }
}

#[async_trait]
impl ArtifactStore for FolderArtifacts {
    async fn ping(&self) -> Result<(), JobError> {
        let (blobs, temporary) = (self.blobs.clone(), self.temporary.join(uuid::Uuid::new_v4().to_string()));
        blocking(move || {
            fs::metadata(blobs)?;
            // A read would not show that the disk is full.
            let written = private_files::create_new(&temporary).and_then(|mut file| {
                file.write_all(&[1; TRIED_BYTES])?;
                file.sync_data()
            });
            let _ = fs::remove_file(&temporary);
            written?;
            // Without room for the reserve, there is too little room for submissions.
            temporary.parent().and_then(Path::parent).map_or(Ok(()), reserve::keep)
        })
        .await
    }

    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError> {
        let (store, path) = (self.clone(), self.path(key));
        blocking(move || store.write(&path, &bytes)).await
    }

    async fn begin(&self, _: &Tenant) -> Result<Box<dyn ArtifactWriter>, JobError> {
        let store = self.clone();
        let writer = blocking(move || {
            let temporary = store.temporary.join(uuid::Uuid::new_v4().to_string());
            let file = Some(private_files::create_new(&temporary)?);
            Ok(FolderWriter { store, temporary, file })
        });
        Ok(Box::new(writer.await?))
    }

    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError> {
        let bytes = self.stored(key).await?;
        if blake3::hash(&bytes).to_hex().as_str() != key.hash() {
            return Err(JobError::Corrupt { what: "a blob whose content is not its name", source: None });
        }
        Ok(bytes)
    }

    async fn open(&self, key: &ArtifactKey, n_bytes: u64, range: Option<Range<u64>>) -> Result<BlobStream, JobError> {
        let path = self.path(key);
        let file = Arc::new(blocking(move || File::open(path)).await?);
        in_pieces(key, n_bytes, range, PIECE, move |range| {
            let file = Arc::clone(&file);
            blocking(move || {
                let length = usize::try_from(range.end - range.start).map_err(io::Error::other)?;
                let mut piece = vec![0; length];
                read_at(&file, &mut piece, range.start)?;
                Ok(piece.into())
            })
        })
        .await
    }

    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError> {
        let path = self.path(key);
        blocking(move || match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        })
        .await
    }

    async fn sweep(&self) -> Result<u32, JobError> {
        let temporary = self.temporary.clone();
        blocking(move || {
            let mut removed = 0;
            for entry in fs::read_dir(temporary)? {
                let entry = entry?;
                let age = entry.metadata()?.modified()?.elapsed().unwrap_or_default();
                if age > STALE && fs::remove_file(entry.path()).is_ok() {
                    removed += 1;
                }
            }
            Ok(removed)
        })
        .await
    }
}

#[async_trait]
impl StoredBlobs for FolderArtifacts {
    async fn stored(&self, key: &ArtifactKey) -> Result<Bytes, JobError> {
        let path = self.path(key);
        let read = blocking(move || match fs::read(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            read => read.map(Some),
        });
        let bytes = read.await?.ok_or(JobError::Corrupt { what: NOT_THERE, source: None })?;
        Ok(Bytes::from(bytes))
    }
}
