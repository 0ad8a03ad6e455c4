//! `homolog encryption`: encrypts all stored data with the current key.

use super::admin::{record, require_database, with_store};
use super::error::CliError;
use crate::app;
use crate::config::ServiceSettings;
use crate::store::artifacts::SealedArtifacts;
use crate::store::encryption::{Rotated, rotate};

/// Encryption at rest
#[derive(Debug, Clone, clap::Args)]
pub(super) struct EncryptionArgs {
    #[command(subcommand)]
    action: EncryptionAction,
}

#[derive(Debug, Clone, clap::Subcommand)]
enum EncryptionAction {
    /// Encrypt the key of each upload and result, and each secret, with the first of the given keys, including data
    /// stored unencrypted; the service may run at the same time
    Rotate {
        /// Only count the changes
        #[arg(long)]
        dry_run: bool,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
}

/// Rotates the keys.
pub(super) fn run(args: &EncryptionArgs) -> Result<(), CliError> {
    let EncryptionAction::Rotate { dry_run, service } = &args.action;
    require_database(service)?;
    let failed = |error: app::AppError| CliError::Failed(error.to_string());
    let Some(keyring) = app::open_keyring(service).map_err(failed)? else {
        return Err(CliError::BadInput(
            "give the keys with --encryption-key-file or --encryption-key-command".to_owned(),
        ));
    };
    let artifacts = SealedArtifacts::new(app::open_stored(service).map_err(failed)?, keyring.clone());
    with_store(service, async |store| {
        app::require_keys(store, Some(&keyring), *dry_run).await.map_err(failed)?;
        let Rotated { current, rewrapped, encrypted, secrets } = rotate(store, &artifacts, *dry_run).await?;
        if !dry_run {
            record(store, "rotate_encryption_keys", None, None).await?;
        }
        let verb = if *dry_run { "would be encrypted" } else { "are encrypted" };
        let key = keyring.current().map(|id| id.to_string()).unwrap_or_default();
        Ok(format!(
            "{} files {verb} with the key {key}: {current} before, {rewrapped} with another key before, {encrypted} not \
             before{}",
            current + rewrapped + encrypted,
            if *dry_run { String::new() } else { format!("; {secrets} secrets were encrypted anew") }
        ))
    })
}
