//! A file that is deleted when the disk is full, so that a service can start and a purge can free space: deleting needs
//! some space itself, for the log of the database.

use super::private_files;
use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

/// Name of the file in the data directory.
const NAME: &str = "reserve";
/// Names of the file while it is written, and of the file that tests for room.
const PART: &str = "reserve.part";
const TRIAL: &str = "reserve.trial";
/// Size of the file, bytes: the log of the database grows to half of this before it is written back.
const N_BYTES: usize = 8 << 20;
/// Bytes written to test whether the disk has room.
const TRIED_BYTES: usize = 256 << 10;

fn write(folder: &Path, name: &str, n_bytes: usize) -> io::Result<()> {
    let path = folder.join(name);
    // Left by a process that has ended.
    let _ = fs::remove_file(&path);
    let written = private_files::create_new(&path).and_then(|mut file| {
        let block = vec![0xa5; 64 << 10];
        for _ in 0..n_bytes / block.len() {
            file.write_all(&block)?;
        }
        file.sync_data()
    });
    if written.is_err() {
        let _ = fs::remove_file(&path);
    }
    written
}

/// Space that this user may fill, bytes.
#[cfg(unix)]
fn room(folder: &Path) -> io::Result<u64> {
    let disk = rustix::fs::statvfs(folder)?;
    Ok(disk.f_bavail.saturating_mul(disk.f_frsize))
}

/// Unknown: only a write shows it.
#[cfg(not(unix))]
fn room(_: &Path) -> io::Result<u64> {
    Ok(u64::MAX)
}

/// Creates the file unless it exists. A file that was given up is not written again before there is room for as much
/// beside it: it would take the space that the database was given.
///
/// # Errors
/// If there is no room for it.
pub(in crate::store) fn keep(folder: &Path) -> io::Result<()> {
    if fs::metadata(folder.join(NAME)).is_ok_and(|found| found.len() == N_BYTES as u64) {
        return Ok(());
    }
    if room(folder)? < 2 * N_BYTES as u64 {
        return Err(io::ErrorKind::StorageFull.into());
    }
    write(folder, PART, N_BYTES)?;
    fs::rename(folder.join(PART), folder.join(NAME))
}

/// Removes the file if the disk is full. Returns whether it did.
pub(crate) fn give_up_if_full(folder: &Path) -> bool {
    let tried = write(folder, TRIAL, TRIED_BYTES);
    let is_full =
        tried.is_err_and(|error| matches!(error.kind(), io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded));
    let _ = fs::remove_file(folder.join(TRIAL));
    is_full && fs::remove_file(folder.join(NAME)).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_is_kept_while_there_is_room() {
        let folder = tempfile::tempdir().unwrap();
        keep(folder.path()).unwrap();
        keep(folder.path()).unwrap();
        assert!(!give_up_if_full(folder.path()));
        let names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(names, [NAME]);
        assert_eq!(fs::metadata(folder.path().join(NAME)).unwrap().len(), N_BYTES as u64);
    }
}
