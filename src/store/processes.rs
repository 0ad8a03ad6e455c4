//! The processes on a data directory: each holds a lock on its own file while it is alive.
//!
//! The operating system releases the lock as soon as the process ends, however it ends. A process that can lock the
//! file of another process knows that it has ended, so that process's jobs need not wait for their leases to expire. A
//! suspended process keeps its lock; its jobs wait for the lease.

use super::private_files;
use crate::jobs::{DepartedProcess, Processes, WorkerId};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The record of this process, visible to the others while this value exists.
#[derive(Debug)]
pub(crate) struct ProcessRecord {
    folder: PathBuf,
    own: PathBuf,
    _lock: File,
}

/// The record of a process that has ended.
#[derive(Debug)]
struct Departed {
    worker: WorkerId,
    path: PathBuf,
    _lock: File,
}

impl ProcessRecord {
    /// Records this process in `data_dir` under the identity `worker`.
    ///
    /// # Errors
    /// Those of the file system.
    pub(crate) fn create(data_dir: &Path, worker: &WorkerId) -> io::Result<Self> {
        let folder = data_dir.join("processes");
        private_files::create_dir_all(&folder)?;
        // Locked before it gets its final name, so that no process can find it unlocked.
        let draft = folder.join(format!("{}.draft", worker.name()));
        let own = folder.join(format!("{}.lock", worker.name()));
        let lock = private_files::create_new(&draft)?;
        lock.lock()?;
        fs::rename(&draft, &own)?;
        Ok(ProcessRecord { folder, own, _lock: lock })
    }
}

impl Processes for ProcessRecord {
    fn departed(&self) -> io::Result<Vec<Box<dyn DepartedProcess>>> {
        let mut ended: Vec<Box<dyn DepartedProcess>> = Vec::new();
        for entry in fs::read_dir(&self.folder)? {
            let path = entry?.path();
            if path == self.own || path.extension().is_none_or(|e| e != "lock") {
                continue;
            }
            let Some(name) = path.file_stem().and_then(|s| s.to_str()).map(str::to_owned) else { continue };
            // Another process may have removed the record in the meantime.
            let Ok(lock) = File::open(&path) else { continue };
            match lock.try_lock() {
                Ok(()) => ended.push(Box::new(Departed { worker: WorkerId::from_name(&name), path, _lock: lock })),
                Err(TryLockError::WouldBlock) => {}
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
        Ok(ended)
    }
}

impl DepartedProcess for Departed {
    fn worker(&self) -> &WorkerId {
        &self.worker
    }

    fn remove_record(self: Box<Self>) {
        let _ = fs::remove_file(&self.path);
    }
}

impl Drop for ProcessRecord {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.own);
    }
}

/// The lock of the one `serve` process on a data directory.
#[derive(Debug)]
pub(crate) struct ServeLock {
    _lock: File,
}

impl ServeLock {
    /// Takes the lock, waiting up to `timeout` for a predecessor to exit. `None` if the predecessor does not exit in
    /// time.
    ///
    /// # Errors
    /// Those of the file system.
    pub(crate) fn acquire(data_dir: &Path, timeout: Duration) -> io::Result<Option<Self>> {
        let file =
            private_files::options().create(true).truncate(false).write(true).open(data_dir.join("serve.lock"))?;
        let deadline = Instant::now() + timeout;
        loop {
            match file.try_lock() {
                Ok(()) => return Ok(Some(ServeLock { _lock: file })),
                Err(TryLockError::Error(error)) => return Err(error),
                Err(TryLockError::WouldBlock) if Instant::now() >= deadline => return Ok(None),
                Err(TryLockError::WouldBlock) => std::thread::sleep(Duration::from_millis(50)),
            }
        }
    }
}
