//! Files and folders that only the user of the service can read, because they hold patient data, keys and secrets.

use std::fs::{self, DirBuilder, File, OpenOptions};
use std::io;
use std::path::Path;

/// Creates a folder and its parents, which only this user can enter. An existing folder is restricted too if it belongs
/// to this user; a folder of another user stays as it is.
///
/// # Errors
/// If it cannot be created.
pub(crate) fn create_dir_all(path: &Path) -> io::Result<()> {
    let mut builder = DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(path)?;
    restrict(path, 0o700);
    Ok(())
}

/// Options to open a file that, if created, only this user can read.
pub(crate) fn options() -> OpenOptions {
    #[allow(unused_mut, reason = "only Unix has modes")]
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}

/// Creates a file for writing.
///
/// # Errors
/// If it exists, or cannot be created.
pub(crate) fn create_new(path: &Path) -> io::Result<File> {
    options().write(true).create_new(true).open(path)
}

/// Creates an empty file unless it exists, and restricts it. An existing file is not opened: on Unix, closing a
/// descriptor of a database releases all locks that this process holds on it, and another process would consider it
/// unused.
///
/// # Errors
/// If it cannot be created.
pub(crate) fn create(path: &Path) -> io::Result<()> {
    match create_new(path) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
        _ => {}
    }
    for ending in ["", "-wal", "-shm"] {
        let mut name = path.as_os_str().to_owned();
        name.push(ending);
        restrict(Path::new(&name), 0o600);
    }
    Ok(())
}

#[cfg(unix)]
fn restrict(path: &Path, mode: u32) {
    use std::os::unix::fs::PermissionsExt as _;
    let is_open = fs::metadata(path).is_ok_and(|found| found.permissions().mode() & 0o777 & !mode != 0);
    if is_open && let Err(error) = fs::set_permissions(path, fs::Permissions::from_mode(mode)) {
        tracing::warn!(%error, "a file of the data directory can be read by others and cannot be restricted");
    }
}

#[cfg(not(unix))]
fn restrict(_: &Path, _: u32) {}
