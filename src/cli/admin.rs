//! `homolog migrate`, `homolog keys`, `homolog purge`: what an operator does to the database.

use super::error::CliError;
use super::output::print;
use super::serve::in_runtime;
use crate::app::{self, AppError};
use crate::config::ServiceSettings;
use crate::jobs::{
    ApiKey, BlobHolds as _, Housekeeping as _, JobError, JobStore as _, KeyStore as _, Purged, Scope, SecretKey, Tenant,
};
use crate::store::sql::SqlStore;
use std::time::Duration;

/// Jobs purged in one round.
const AT_ONCE: u32 = 1000;

/// Bring the database up to date, and end
#[derive(Debug, Clone, clap::Args)]
pub struct MigrateArgs {
    /// Which database.
    #[command(flatten)]
    pub service: ServiceSettings,
}

/// Make, list and revoke API keys
#[derive(Debug, Clone, clap::Args)]
pub struct KeysArgs {
    /// What to do.
    #[command(subcommand)]
    pub action: KeysAction,
}

/// What is done to keys.
#[derive(Debug, Clone, clap::Subcommand)]
pub enum KeysAction {
    /// Make a key and print it, once
    Create {
        /// Whose requests it makes: lower-case letters, digits and hyphens
        #[arg(long, default_value = "default")]
        tenant: String,
        /// What it allows, separated by commas: read, submit, admin
        #[arg(long, value_delimiter = ',', default_value = "read,submit")]
        scope: Vec<String>,
        /// When it ends; absent: never
        #[arg(long, value_parser = clap::value_parser!(u64).range(1..=36_500), value_name = "DAYS")]
        expires_days: Option<u64>,
        /// What it is for
        #[arg(long, default_value = "")]
        name: String,
        /// Which database
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// List all keys, without their secrets
    List {
        /// Which database
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// End a key now
    Revoke {
        /// The part of the key between the two underscores
        id: String,
        /// Which database
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
}

/// Remove what outlived its retention, now
#[derive(Debug, Clone, clap::Args)]
pub struct PurgeArgs {
    /// Only count what would be removed
    #[arg(long)]
    pub dry_run: bool,
    /// Which database, and how long things are kept.
    #[command(flatten)]
    pub service: ServiceSettings,
}

/// Brings the tables up to date.
pub fn migrate(args: &MigrateArgs) -> Result<(), CliError> {
    with_store(&args.service, async |store| {
        store.ping().await?;
        Ok("the database is up to date".to_owned())
    })
}

/// Makes, lists, revokes.
pub fn keys(args: &KeysArgs) -> Result<(), CliError> {
    match &args.action {
        KeysAction::Create { tenant, scope, expires_days, name, service } => {
            let allowed = "lower-case letters, digits and hyphens, at most 64";
            let owner = Tenant::new(tenant).ok_or_else(|| CliError::BadInput(format!("--tenant: {allowed}")))?;
            let mut scopes = Vec::new();
            for word in scope {
                let scope = Scope::from_name(word.trim());
                scopes.push(
                    scope.ok_or_else(|| CliError::BadInput(format!("--scope: read, submit, admin, not {word}")))?,
                );
            }
            scopes.sort_unstable();
            scopes.dedup();
            let valid_for = expires_days.map(|days| Duration::from_secs(days * 86_400));
            with_store(service, async |store| {
                let key = SecretKey::random();
                store.insert_key(&key, &owner, name, &scopes, valid_for).await?;
                Ok(key.reveal())
            })
        }
        KeysAction::List { service } => with_store(service, async |store| {
            let lines: Vec<String> = store.list_keys().await?.iter().map(line).collect();
            Ok(format!("id\ttenant\tscopes\tstate\tcreated\texpires\tname\n{}", lines.join("\n")))
        }),
        KeysAction::Revoke { id, service } => {
            // Also taken: the whole key, as its owner has it.
            let id = SecretKey::parse(id).map_or_else(|| id.clone(), |key| key.id().to_owned());
            with_store(service, async |store| match store.revoke_key(&id).await? {
                true => Ok(format!("{id} is revoked")),
                false => Ok(format!("there is no key {id} that could be revoked")),
            })
        }
    }
}

fn line(key: &ApiKey) -> String {
    let scopes: Vec<_> = key.scopes.iter().map(|scope| scope.name()).collect();
    let state = match (key.is_valid, key.revoked_at) {
        (true, _) => "valid",
        (false, Some(_)) => "revoked",
        (false, None) => "expired",
    };
    let expires = key.expires_at.map_or_else(|| "never".to_owned(), |time| time.to_string());
    let (id, tenant, name) = (&key.id, key.tenant.name(), &key.name);
    format!("{id}\t{tenant}\t{}\t{state}\t{}\t{expires}\t{name}", scopes.join(","), key.created_at)
}

/// Removes what outlived its retention.
pub fn purge(args: &PurgeArgs) -> Result<(), CliError> {
    let artifacts = app::open_artifacts(&args.service).map_err(|error| CliError::Failed(error.to_string()))?;
    let (retention, dry_run) = (args.service.retention(), args.dry_run);
    with_store(&args.service, async |store| {
        let mut total = Purged::default();
        loop {
            let purged = store.purge(&retention, AT_ONCE, dry_run).await?;
            total.results += purged.results;
            total.jobs += purged.jobs;
            total.meshes += purged.meshes;
            total.changes += purged.changes;
            total.deliveries += purged.deliveries;
            total.idempotency_keys += purged.idempotency_keys;
            if dry_run || purged.results + purged.jobs + purged.meshes == 0 {
                break;
            }
        }
        let mut blobs = 0;
        if !dry_run {
            blobs = store.remove_unreferenced_blobs(artifacts.as_ref()).await?;
            blobs += artifacts.sweep().await?;
        }
        let verb = if dry_run { "would be removed" } else { "removed" };
        let Purged { results, jobs, meshes, changes, deliveries, idempotency_keys } = total;
        Ok(format!(
            "{verb}: results of {results} jobs, {jobs} jobs, {meshes} meshes, {changes} changes, {deliveries} deliveries, \
             {idempotency_keys} idempotency keys{}",
            if dry_run { String::new() } else { format!(", {blobs} files") }
        ))
    })
}

/// Does something to the database, and prints what it answers.
fn with_store(
    settings: &ServiceSettings,
    work: impl AsyncFnOnce(&SqlStore) -> Result<String, JobError>,
) -> Result<(), CliError> {
    let mut answer = String::new();
    in_runtime(settings, async {
        if settings.database_url.is_none() {
            std::fs::create_dir_all(&settings.data_dir)
                .map_err(|error| AppError::DataDir { path: settings.data_dir.clone(), error })?;
        }
        let store = app::open_database(settings).await?;
        let done = work(&store).await;
        store.close().await;
        answer = done.map_err(|error| app::store_error("the database", &error))?;
        Ok(())
    })?;
    print(answer.trim_end())
}
