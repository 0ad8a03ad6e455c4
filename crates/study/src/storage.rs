//! Storage of a study's files: in a folder on disk, or in memory for a caller that stores them elsewhere.
//!
//! On disk every file is written beside its final place and renamed, so that a killed process leaves complete files or
//! none.

use crate::plan::hash;
use parking_lot::Mutex;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;
use std::fs;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Suffix of the names of unfinished files.
const UNFINISHED: &str = ".study.tmp";

/// The files of subjects of a study that is not on disk.
pub trait Inputs: Debug + Send + Sync {
    /// The content of a subject's file.
    ///
    /// # Errors
    /// Errors of the underlying storage.
    fn read(&self, file: &Path) -> io::Result<Vec<u8>>;

    /// The hash of that content, without reading the content.
    ///
    /// # Errors
    /// [`io::ErrorKind::NotFound`] if there is no such file.
    fn hash(&self, file: &Path) -> io::Result<String>;
}

/// Storage of files.
#[derive(Debug)]
pub(crate) enum Storage {
    /// In a folder; the number of files written makes the names of unfinished ones unique.
    Disk(PathBuf, AtomicU64),
    /// In memory, by name.
    Memory(Mutex<BTreeMap<String, Vec<u8>>>, Box<dyn Inputs>),
}

impl Storage {
    /// The path of a file, for people.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        match self {
            Storage::Disk(folder, _) => folder.join(name),
            Storage::Memory(..) => PathBuf::from(name),
        }
    }

    /// Writes a file as a whole, and the folders above it.
    pub(crate) fn write(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        let (folder, written) = match self {
            Storage::Disk(folder, written) => (folder, written),
            Storage::Memory(files, _) => {
                files.lock().insert(name.to_owned(), bytes.to_vec());
                return Ok(());
            }
        };
        let path = folder.join(name);
        let number = written.fetch_add(1, Ordering::Relaxed);
        let unfinished = path.with_extension(format!("{}-{number}{UNFINISHED}", std::process::id()));
        let done = (|| {
            if let Some(above) = path.parent() {
                fs::create_dir_all(above)?;
            }
            let mut file = fs::File::create(&unfinished)?;
            file.write_all(bytes)?;
            file.sync_data()?;
            fs::rename(&unfinished, &path)
        })();
        if done.is_err() {
            // The write has already failed; leftovers are removed later.
            let _ = fs::remove_file(&unfinished);
        }
        done
    }

    /// The content of a file; `None` if it does not exist.
    pub(crate) fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        match self {
            Storage::Disk(folder, _) => match fs::read(folder.join(name)) {
                Ok(bytes) => Ok(Some(bytes)),
                Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
                Err(error) => Err(error),
            },
            Storage::Memory(files, _) => Ok(files.lock().get(name).cloned()),
        }
    }

    /// A part of a file.
    pub(crate) fn read_part(&self, name: &str, part: Range<u64>) -> io::Result<Vec<u8>> {
        match self {
            Storage::Disk(folder, _) => {
                let mut bytes = vec![0; (part.end - part.start) as usize];
                let mut file = fs::File::open(folder.join(name))?;
                file.seek(SeekFrom::Start(part.start))?;
                file.read_exact(&mut bytes)?;
                Ok(bytes)
            }
            Storage::Memory(files, _) => {
                let files = files.lock();
                let file = files.get(name).ok_or(io::ErrorKind::NotFound)?;
                let found = file.get(part.start as usize..part.end as usize);
                Ok(found.ok_or(io::ErrorKind::UnexpectedEof)?.to_vec())
            }
        }
    }

    /// Removes a file, if possible.
    pub(crate) fn remove(&self, name: &str) {
        match self {
            // A file that cannot be removed is replaced later or harmless.
            Storage::Disk(folder, _) => drop(fs::remove_file(folder.join(name))),
            Storage::Memory(files, _) => drop(files.lock().remove(name)),
        }
    }

    /// Removes the files of a subfolder except those with these names.
    pub(crate) fn keep_only(&self, part: &str, names: &BTreeSet<String>) {
        match self {
            Storage::Disk(folder, _) => {
                for entry in fs::read_dir(folder.join(part)).into_iter().flatten().flatten() {
                    if !names.contains(&*entry.file_name().to_string_lossy()) {
                        // An old output that cannot be removed is harmless.
                        let _ = fs::remove_file(entry.path());
                    }
                }
            }
            Storage::Memory(files, _) => files.lock().retain(|name, _| {
                let in_part = name.strip_prefix(part).and_then(|rest| rest.strip_prefix('/'));
                in_part.is_none_or(|name| names.contains(name))
            }),
        }
    }

    /// Removes unfinished files of killed processes from these subfolders and the folders in them; of the folder itself,
    /// `""`, from that alone.
    ///
    /// # Errors
    /// The subfolder that cannot be read, and the reason.
    pub(crate) fn sweep(&self, parts: &[&str]) -> Result<(), (PathBuf, io::Error)> {
        let Storage::Disk(folder, _) = self else { return Ok(()) };
        let mut left: Vec<(PathBuf, bool)> =
            parts.iter().map(|part| (folder.join(part), !part.is_empty())).filter(|(part, _)| part.is_dir()).collect();
        while let Some((part, is_deep)) = left.pop() {
            for entry in fs::read_dir(&part).map_err(|error| (part.clone(), error))?.flatten() {
                if entry.file_name().to_string_lossy().ends_with(UNFINISHED) {
                    // A file that is already gone is not an error.
                    let _ = fs::remove_file(entry.path());
                } else if is_deep && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                    left.push((entry.path(), true));
                }
            }
        }
        Ok(())
    }

    /// The content of a subject's file.
    pub(crate) fn input(&self, file: &Path) -> io::Result<Vec<u8>> {
        match self {
            Storage::Disk(..) => fs::read(file),
            Storage::Memory(_, inputs) => inputs.read(file),
        }
    }

    /// The hash of that content.
    pub(crate) fn input_hash(&self, file: &Path) -> io::Result<String> {
        match self {
            Storage::Disk(..) => fs::read(file).map(|bytes| hash(&bytes)),
            Storage::Memory(_, inputs) => inputs.hash(file),
        }
    }
}
