//! Which processes on this data directory live: each holds a lock on a file of its own.
//!
//! The operating system drops a lock the moment its process ends, however it ends. So whoever can take the lock of
//! another's file knows that process is gone, and its jobs need not wait for their leases to run out. A process that
//! only sleeps keeps its lock; there the lease decides.

use crate::jobs::{DepartedProcess, Processes, WorkerId};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// This process, known to the others while this value lives.
#[derive(Debug)]
pub struct Presence {
    folder: PathBuf,
    own: PathBuf,
    _lock: File,
}

/// A process that is gone; its jobs may be taken. Its file is removed when it is forgotten.
#[derive(Debug)]
struct Departed {
    worker: WorkerId,
    path: PathBuf,
    _lock: File,
}

impl Presence {
    /// Makes `worker` known in `data_dir`.
    ///
    /// # Errors
    /// Of the file system.
    pub fn announce(data_dir: &Path, worker: &WorkerId) -> io::Result<Self> {
        let folder = data_dir.join("processes");
        fs::create_dir_all(&folder)?;
        // Locked before it has the name that others look for: nobody can find it unlocked.
        let draft = folder.join(format!("{}.draft", worker.name()));
        let own = folder.join(format!("{}.lock", worker.name()));
        let lock = File::create_new(&draft)?;
        lock.lock()?;
        fs::rename(&draft, &own)?;
        Ok(Presence { folder, own, _lock: lock })
    }

}

impl Processes for Presence {
    fn departed(&self) -> io::Result<Vec<Box<dyn DepartedProcess>>> {
        let mut gone: Vec<Box<dyn DepartedProcess>> = Vec::new();
        for entry in fs::read_dir(&self.folder)? {
            let path = entry?.path();
            if path == self.own || path.extension().is_none_or(|e| e != "lock") {
                continue;
            }
            let Some(name) = path.file_stem().and_then(|s| s.to_str()).map(str::to_owned) else { continue };
            // Another process may forget the same one first.
            let Ok(lock) = File::open(&path) else { continue };
            match lock.try_lock() {
                Ok(()) => gone.push(Box::new(Departed { worker: WorkerId::from_name(&name), path, _lock: lock })),
                Err(TryLockError::WouldBlock) => {}
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
        Ok(gone)
    }
}

impl DepartedProcess for Departed {
    fn worker(&self) -> &WorkerId {
        &self.worker
    }

    fn forget(self: Box<Self>) {
        let _ = fs::remove_file(&self.path);
    }
}

impl Drop for Presence {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.own);
    }
}

/// The exclusive right of one `serve` process to a data directory.
#[derive(Debug)]
pub struct Ownership {
    _lock: File,
}

impl Ownership {
    /// Takes the right, waiting for up to `patience` for a predecessor to end. `None` if it does not.
    ///
    /// # Errors
    /// Of the file system.
    pub fn take(data_dir: &Path, patience: Duration) -> io::Result<Option<Self>> {
        let file = File::options().create(true).truncate(false).write(true).open(data_dir.join("serve.lock"))?;
        let deadline = Instant::now() + patience;
        loop {
            match file.try_lock() {
                Ok(()) => return Ok(Some(Ownership { _lock: file })),
                Err(TryLockError::Error(error)) => return Err(error),
                Err(TryLockError::WouldBlock) if Instant::now() >= deadline => return Ok(None),
                Err(TryLockError::WouldBlock) => std::thread::sleep(Duration::from_millis(50)),
            }
        }
    }
}
