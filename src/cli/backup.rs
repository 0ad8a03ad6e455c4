//! `homolog backup` and `homolog restore`: copies of a service on SQLite and a folder, made while it runs.

use super::admin::{record, require_database, with_store};
use super::error::CliError;
use super::output::print;
use super::serve::in_runtime;
use crate::app;
use crate::config::ServiceSettings;
use crate::store::backup::{self, BackupError, Manifest};
use crate::store::layout::SECRET_KEY_FILE;
use crate::store::sql::SqlStore;
use std::path::PathBuf;

/// Back up a service on SQLite into a folder, while it runs; a further backup into the same folder copies only what is new
#[derive(Debug, Clone, clap::Args)]
pub(super) struct BackupArgs {
    /// Folder of the backup
    dir: PathBuf,
    #[command(flatten)]
    service: ServiceSettings,
}

/// Restore a backup into a data directory that is empty except for secret.key, and compare every file with its hash
#[derive(Debug, Clone, clap::Args)]
pub(super) struct RestoreArgs {
    /// Folder of the backup
    dir: PathBuf,
    #[command(flatten)]
    service: ServiceSettings,
}

impl From<BackupError> for CliError {
    fn from(error: BackupError) -> Self {
        match error {
            BackupError::Database(error) => error.into(),
            BackupError::NotABackup(_)
            | BackupError::NoBackup(_)
            | BackupError::NotEmpty(_)
            | BackupError::Encrypted => CliError::BadInput(error.to_string()),
            other => CliError::Failed(other.to_string()),
        }
    }
}

/// Back-ups of a database server and a bucket are made with their own tools.
fn refuse_servers(settings: &ServiceSettings) -> Result<(), CliError> {
    if settings.database_url.is_none() && settings.artifacts_url.is_none() {
        return Ok(());
    }
    Err(CliError::BadInput(
        "this command is for a service on SQLite and a folder; docs/runbook.md says how a database server and a bucket are backed up"
            .to_owned(),
    ))
}

fn contents(manifest: &Manifest) -> String {
    let Manifest { n_blobs, n_bytes, created_at, .. } = manifest;
    format!("the database and {n_blobs} files, {n_bytes} bytes, as of {created_at}")
}

/// Writes a backup.
pub(super) fn back_up(args: &BackupArgs) -> Result<(), CliError> {
    refuse_servers(&args.service)?;
    require_database(&args.service)?;
    with_store(&args.service, async |store| {
        // Recorded, because a backup reads everything.
        record(store, "back_up", None, None).await?;
        let keyring = app::open_keyring(&args.service).map_err(|error| CliError::Failed(error.to_string()))?;
        let manifest = backup::back_up(store, &args.service.data_dir, &args.dir, keyring).await?;
        let keys = match args.service.encryption_key_file.is_some() || args.service.encryption_key_command.is_some() {
            true => "the encryption keys",
            false => SECRET_KEY_FILE,
        };
        Ok(format!("backed up {}; keep a copy of {keys} in another place", contents(&manifest)))
    })
}

/// Restores a backup.
pub(super) fn restore(args: &RestoreArgs) -> Result<(), CliError> {
    refuse_servers(&args.service)?;
    let mut restored = Ok(String::new());
    in_runtime(&args.service, async {
        restored = async {
            let keyring = app::open_keyring(&args.service).map_err(|error| CliError::Failed(error.to_string()))?;
            let manifest = backup::restore(&args.dir, &args.service.data_dir, keyring).await?;
            // Opened without the key of secrets, which would otherwise be created: the operator has a copy of it.
            let store = SqlStore::open(&args.service.database(1)).await?;
            record(&store, "restore", None, None).await?;
            store.close().await;
            Ok::<_, CliError>(format!("restored {}", contents(&manifest)))
        }
        .await;
        Ok(())
    })?;
    print(&restored?)
}
