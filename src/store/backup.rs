//! Back-up and restore of a service on SQLite and a folder of blobs, while the service runs.
//!
//! A backup is a folder that contains `blobs`, as in the data directory, a copy of the database, and `backup.json`,
//! which names that copy and is replaced last, so an interrupted backup leaves the previous one intact. The content of
//! a blob never changes, but a rotation of keys writes an encrypted blob again, with the same length. A further backup
//! into the same folder therefore copies blobs that are new or differ. Blobs are copied before the database and once
//! more after it, so every blob to which the copied database refers is present.
//!
//! A backup makes the same comparisons as [`restore`], so it succeeds only if it can be restored.

use super::artifacts::sealed::{FOOTER, is_sealed_blob, sealed_size};
use super::artifacts::{FolderArtifacts, SealedArtifacts};
use super::keyring::Keyring;
use super::layout::{DATABASE_FILE, SECRET_KEY_FILE};
use super::private_files;
use super::sql::{DatabaseLocation, SqlStore};
use crate::jobs::{ArtifactKey, ArtifactStore as _, JobError};
use futures_util::TryStreamExt as _;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The file that describes a backup.
const MANIFEST: &str = "backup.json";
/// The folder of blobs, in the data directory and in a backup.
const BLOBS: &str = "blobs";
/// The folder in which a copy of the database is prepared and checked.
const DRAFT: &str = "next";
/// How often the database is copied again because a blob was created and deleted during the copy.
const TRIES: u32 = 3;

/// The description of a backup.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of the program that wrote it.
    pub version: String,
    /// When it was written.
    pub created_at: jiff::Timestamp,
    /// Name of the copy of the database.
    pub database: String,
    /// BLAKE3 of the copy.
    pub database_blake3: String,
    /// Number of blobs to which the database refers.
    pub n_blobs: u64,
    /// Size of these blobs, bytes.
    pub n_bytes: u64,
}

/// Why a backup is not written or not restored.
#[derive(Debug, thiserror::Error)]
pub enum BackupError {
    /// The database does not answer.
    #[error("the database cannot be copied")]
    Database(#[from] JobError),
    /// A file or folder cannot be read or written.
    #[error("{}: {error}", path.display())]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The cause.
        error: io::Error,
    },
    /// The folder for a backup holds something else.
    #[error("{} holds something that is no backup; choose an empty folder", .0.display())]
    NotABackup(PathBuf),
    /// The folder to restore from holds no backup.
    #[error("{} holds no backup: there is no backup.json", .0.display())]
    NoBackup(PathBuf),
    /// The data directory is in use or was used.
    #[error("{} is not empty; restore into an empty data directory, which may hold secret.key alone", .0.display())]
    NotEmpty(PathBuf),
    /// A file differs from what was written.
    #[error("{} is damaged; use another backup", .0.display())]
    Damaged(PathBuf),
    /// Encrypted blobs cannot be compared with their hashes.
    #[error(
        "the blobs of this backup are encrypted; give their key with --encryption-key-file or --encryption-key-command"
    )]
    Encrypted,
    /// Blobs are missing.
    #[error("{n} blobs are missing, the first is {first}")]
    Missing {
        /// Number of missing blobs.
        n: u64,
        /// Address of the first.
        first: String,
    },
}

fn at(path: &Path) -> impl FnOnce(io::Error) -> BackupError + '_ {
    move |error| BackupError::File { path: path.to_owned(), error }
}

/// Runs file operations on a thread that may block.
async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, BackupError> + Send + 'static,
) -> Result<T, BackupError> {
    match tokio::task::spawn_blocking(work).await {
        Ok(done) => done,
        Err(join) => Err(JobError::Unavailable(Box::new(join)).into()),
    }
}

/// Backs up the service of this database and data directory into the folder `to`. With `keyring`, encrypted blobs are
/// compared with their hashes; without it, only with the blobs of the service.
///
/// # Errors
/// [`BackupError`]; the description of the previous backup then remains.
///
/// # Cost
/// Reads every blob of the backup, and the new or encrypted blobs of the service.
pub async fn back_up(
    store: &SqlStore,
    data_dir: &Path,
    to: &Path,
    keyring: Option<Arc<Keyring>>,
) -> Result<Manifest, BackupError> {
    let (from, to) = (data_dir.join(BLOBS), to.to_owned());
    let folder = to.clone();
    blocking(move || prepare(&folder)).await?;
    let mut tries = 0;
    let (database, counted) = loop {
        let copy = async |known: Known| {
            let (from, blobs) = (from.clone(), to.join(BLOBS));
            blocking(move || copy_blobs(&from, &blobs, known)).await
        };
        copy(Known::ByContent).await?;
        let draft = to.join(DRAFT);
        let folder = draft.clone();
        blocking(move || recreate(&folder)).await?;
        store.copy_into(&draft.join(DATABASE_FILE)).await?;
        copy(Known::ByEnd).await?;
        match checked(&draft, &to).await {
            Err(BackupError::Missing { .. }) if tries + 1 < TRIES => tries += 1,
            done => break (draft.join(DATABASE_FILE), done?),
        }
    };
    if keyring.is_some() {
        check_encrypted(&to.join(DRAFT), &to, keyring).await?;
    }
    blocking(move || publish(&database, &to, counted)).await
}

/// Number and size of blobs.
type Counted = (u64, u64);

/// Checks the database in `folder`, and that all of its blobs are in `data`.
async fn checked(folder: &Path, data: &Path) -> Result<Counted, BackupError> {
    let store = SqlStore::open(&DatabaseLocation::Folder(folder.to_owned())).await?;
    let found = async {
        if !store.is_intact().await? {
            return Err(BackupError::Damaged(folder.join(DATABASE_FILE)));
        }
        let (mut n_blobs, mut n_bytes, mut n_missing, mut first) = (0, 0, 0, None);
        let mut after = None;
        loop {
            let page = store.list_blobs(after.take()).await?;
            let Some(last) = page.last() else { break };
            after = Some((last.tenant.clone(), last.path.clone()));
            for blob in page {
                let path = data.join(BLOBS).join(blob.tenant.name()).join(&blob.path);
                let is_whole = |n: u64| n == blob.n_bytes || Some(n) == sealed_size(blob.n_bytes);
                if fs::metadata(path).is_ok_and(|found| is_whole(found.len())) {
                    (n_blobs, n_bytes) = (n_blobs + 1, n_bytes + blob.n_bytes);
                } else {
                    n_missing += 1;
                    first.get_or_insert_with(|| format!("{}/{}", blob.tenant.name(), blob.path));
                }
            }
        }
        match first {
            Some(first) => Err(BackupError::Missing { n: n_missing, first }),
            None => Ok((n_blobs, n_bytes)),
        }
    };
    let found = found.await;
    store.close().await;
    found
}

/// Creates the folder of a backup; refuses a folder that holds something else.
fn prepare(folder: &Path) -> Result<(), BackupError> {
    private_files::create_dir_all(folder).map_err(at(folder))?;
    let is_empty = fs::read_dir(folder).map_err(at(folder))?.next().is_none();
    let is_backup = folder.join(MANIFEST).is_file() || folder.join(BLOBS).is_dir();
    if is_empty || is_backup { Ok(()) } else { Err(BackupError::NotABackup(folder.to_owned())) }
}

fn recreate(folder: &Path) -> Result<(), BackupError> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(at(folder)(error)),
        _ => {}
    }
    private_files::create_dir_all(folder).map_err(at(folder))?;
    // Created with its final permissions before the copy is written into it.
    let file = folder.join(DATABASE_FILE);
    private_files::create_new(&file).map(|_| ()).map_err(at(&file))
}

/// Renames the checked copy of the database to its final name, and replaces the description.
fn publish(database: &Path, to: &Path, (n_blobs, n_bytes): Counted) -> Result<Manifest, BackupError> {
    let hash = hash_of(database)?;
    let manifest = Manifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        created_at: jiff::Timestamp::now(),
        database: format!("database-{}.sqlite", &hash[..16]),
        database_blake3: hash,
        n_blobs,
        n_bytes,
    };
    let named = to.join(&manifest.database);
    fs::rename(database, &named).map_err(at(&named))?;
    let (draft, path) = (to.join(format!("{MANIFEST}.next")), to.join(MANIFEST));
    let text = serde_json::to_string_pretty(&manifest).map_err(|error| at(&path)(error.into()))?;
    let written = private_files::options().create(true).truncate(true).write(true).open(&draft).and_then(|mut file| {
        writeln!(file, "{text}")?;
        file.sync_all()
    });
    written.map_err(at(&draft))?;
    fs::rename(&draft, &path).map_err(at(&path))?;
    sync_folder(to)?;
    // The description no longer names these files.
    let _ = fs::remove_dir_all(to.join(DRAFT));
    for entry in fs::read_dir(to).map_err(at(to))?.flatten() {
        let name = entry.file_name();
        let is_older = name.to_str().is_some_and(|name| name.starts_with("database-") && name != manifest.database);
        if is_older {
            let _ = fs::remove_file(entry.path());
        }
    }
    Ok(manifest)
}

/// Restores the backup in `from` into a data directory that is empty or does not exist. Every blob is compared with
/// its hash; encrypted blobs are decrypted with `keyring` for the comparison.
///
/// # Errors
/// [`BackupError`]; the data directory then holds no database, and must be emptied before the next try.
pub async fn restore(from: &Path, data_dir: &Path, keyring: Option<Arc<Keyring>>) -> Result<Manifest, BackupError> {
    let (source, data) = (from.to_owned(), data_dir.to_owned());
    let draft = data_dir.join(DRAFT);
    let folder = draft.clone();
    let manifest = blocking(move || {
        let manifest = read_manifest(&source)?;
        refuse_used(&data)?;
        private_files::create_dir_all(&data).map_err(at(&data))?;
        recreate(&folder)?;
        let database = source.join(&manifest.database);
        if hash_of(&database)? != manifest.database_blake3 {
            return Err(BackupError::Damaged(database));
        }
        copy_file(&database, &folder.join(DATABASE_FILE))?;
        copy_blobs(&source.join(BLOBS), &data.join(BLOBS), Known::ByContent)?;
        Ok(manifest)
    });
    let manifest = manifest.await?;
    checked(&draft, data_dir).await?;
    check_encrypted(&draft, data_dir, keyring).await?;
    let data = data_dir.to_owned();
    blocking(move || {
        // Last: a data directory without this file holds no service.
        fs::rename(draft.join(DATABASE_FILE), data.join(DATABASE_FILE)).map_err(at(&data))?;
        let _ = fs::remove_dir_all(&draft);
        sync_folder(&data)
    })
    .await?;
    Ok(manifest)
}

/// Decrypts the blobs that are encrypted, and compares them with their hashes.
async fn check_encrypted(folder: &Path, data: &Path, keyring: Option<Arc<Keyring>>) -> Result<(), BackupError> {
    let store = SqlStore::open(&DatabaseLocation::Folder(folder.to_owned())).await?;
    let checked = async {
        if store.encryption_key().await?.is_none() {
            return Ok(());
        }
        let Some(keyring) = keyring else { return Err(BackupError::Encrypted) };
        let artifacts = SealedArtifacts::new(Arc::new(FolderArtifacts::of_blobs(data)), keyring);
        let mut after = None;
        loop {
            let page = store.list_blobs(after.take()).await?;
            let Some(last) = page.last() else { return Ok(()) };
            after = Some((last.tenant.clone(), last.path.clone()));
            for blob in page {
                let Some(key) = ArtifactKey::from_path(&blob.tenant, &blob.path) else { continue };
                let read = async {
                    let mut content = artifacts.open(&key, blob.n_bytes, None).await?;
                    while content.try_next().await?.is_some() {}
                    Ok::<_, JobError>(())
                };
                read.await
                    .map_err(|_| BackupError::Damaged(data.join(BLOBS).join(blob.tenant.name()).join(&blob.path)))?;
            }
        }
    };
    let checked = checked.await;
    store.close().await;
    checked
}

fn read_manifest(folder: &Path) -> Result<Manifest, BackupError> {
    let path = folder.join(MANIFEST);
    let text = match fs::read(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Err(BackupError::NoBackup(folder.to_owned()));
        }
        read => read.map_err(at(&path))?,
    };
    let manifest: Manifest = serde_json::from_slice(&text).map_err(|_| BackupError::Damaged(path.clone()))?;
    // A file name in this folder, not a path that leaves it.
    let is_name = manifest.database.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'.');
    if is_name { Ok(manifest) } else { Err(BackupError::Damaged(path)) }
}

fn refuse_used(data_dir: &Path) -> Result<(), BackupError> {
    let entries = match fs::read_dir(data_dir) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        read => read.map_err(at(data_dir))?,
    };
    let is_empty = entries.flatten().all(|entry| entry.file_name() == SECRET_KEY_FILE);
    if is_empty { Ok(()) } else { Err(BackupError::NotEmpty(data_dir.to_owned())) }
}

/// How a blob is recognized as already copied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Known {
    /// By content: the hash that is its name; for an encrypted blob, every byte.
    ByContent,
    /// By length and, for an encrypted blob, by its footer; for blobs that were already compared by content.
    ByEnd,
}

/// Copies the blobs that are missing in the copy or differ from it. Each unencrypted blob is compared with the hash
/// that is its name. Encrypted blobs are compared afterwards, with the keys.
fn copy_blobs(from: &Path, to: &Path, known: Known) -> Result<(), BackupError> {
    private_files::create_dir_all(to).map_err(at(to))?;
    let entries = match fs::read_dir(from) {
        // Nothing has been uploaded yet, or the folder was removed with its last blob.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        read => read.map_err(at(from))?,
    };
    let mut is_new = false;
    for entry in entries {
        let entry = entry.map_err(at(from))?;
        let (source, target) = (entry.path(), to.join(entry.file_name()));
        let Ok(found) = entry.metadata() else { continue };
        if found.is_dir() {
            copy_blobs(&source, &target, known)?;
            continue;
        }
        match copy_blob(&source, &target, known) {
            // Deleted during the copy; blobs to which the database still refers are checked afterwards.
            Err(BackupError::File { error, .. }) if error.kind() == io::ErrorKind::NotFound && !source.exists() => {}
            copied => is_new |= copied?,
        }
    }
    if is_new { sync_folder(to) } else { Ok(()) }
}

/// Whether a blob had to be copied.
fn copy_blob(source: &Path, target: &Path, known: Known) -> Result<bool, BackupError> {
    let name = source.file_name().unwrap_or_default().to_string_lossy();
    let is_encrypted = is_encrypted(source)?;
    let length = |path: &Path| fs::metadata(path).map(|found| found.len());
    let is_as_long = length(target).is_ok_and(|copy| length(source).is_ok_and(|found| found == copy));
    let is_there = is_as_long
        && match (is_encrypted, known) {
            (false, Known::ByEnd) => true,
            (false, Known::ByContent) => hash_of(target)? == name,
            (true, Known::ByEnd) => end_of(source)? == end_of(target)?,
            (true, Known::ByContent) => hash_of(source)? == hash_of(target)?,
        };
    if is_there {
        return Ok(false);
    }
    if !is_encrypted && hash_of(source)? != name {
        return Err(BackupError::Damaged(source.to_owned()));
    }
    copy_file(source, target).map(|()| true)
}

/// The footer of an encrypted blob, which changes with the key.
fn end_of(path: &Path) -> Result<Vec<u8>, BackupError> {
    let mut end = Vec::new();
    let read = File::open(path).and_then(|mut file| {
        let length = file.metadata()?.len();
        file.seek(SeekFrom::Start(length.saturating_sub(FOOTER)))?;
        file.read_to_end(&mut end)
    });
    read.map_err(at(path))?;
    Ok(end)
}

/// Copies a file under a temporary name, and renames it when complete.
fn copy_file(from: &Path, to: &Path) -> Result<(), BackupError> {
    let mut source = File::open(from).map_err(at(from))?;
    let draft = to.with_extension("part");
    let written = private_files::options().create(true).truncate(true).write(true).open(&draft).and_then(|mut file| {
        io::copy(&mut source, &mut file)?;
        file.sync_all()
    });
    written.map_err(at(&draft))?;
    fs::rename(&draft, to).map_err(at(to))
}

fn is_encrypted(path: &Path) -> Result<bool, BackupError> {
    let mut first = Vec::new();
    File::open(path).and_then(|file| file.take(64).read_to_end(&mut first)).map_err(at(path))?;
    Ok(is_sealed_blob(&first))
}

fn hash_of(path: &Path) -> Result<String, BackupError> {
    let mut file = File::open(path).map_err(at(path))?;
    let (mut hasher, mut part) = (blake3::Hasher::new(), vec![0; 1 << 20]);
    loop {
        match file.read(&mut part).map_err(at(path))? {
            0 => return Ok(hasher.finalize().to_hex().to_string()),
            n => hasher.update(&part[..n]),
        };
    }
}

fn sync_folder(folder: &Path) -> Result<(), BackupError> {
    File::open(folder).and_then(|open| open.sync_all()).map_err(at(folder))
}
