//! `homolog migrate`, `homolog keys`, `homolog purge`: administration of the database of a service.
//!
//! Only `migrate` and `keys create --init` create a database. The other commands refuse a data directory without a
//! database and do not change it: usually `--data-dir` or `HOMOLOG_DATA_DIR` names another directory than the
//! service's.

use super::error::CliError;
use super::output::{note, print};
use super::serve::in_runtime;
use crate::app;
use crate::config::ServiceSettings;
use crate::jobs::{
    ApiKey, AuditEvent, AuditStore as _, BlobHolds as _, ClockState, Housekeeping as _, JobError, JobStore as _,
    KeyStore as _, Purged, Role, Scope, SecretKey, Tenant,
};
use crate::store::sql::SqlStore;
use std::time::{Duration, Instant};

/// Rows purged in one transaction.
const PURGED_AT_ONCE: u32 = 1000;
/// How long a command tries to overwrite deleted content.
const OVERWRITTEN_WITHIN: Duration = Duration::from_secs(10);

/// Create the database, or bring its schema up to date, and exit
#[derive(Debug, Clone, clap::Args)]
pub(super) struct MigrateArgs {
    #[command(flatten)]
    service: ServiceSettings,
}

/// Create, list and revoke API keys
#[derive(Debug, Clone, clap::Args)]
pub(super) struct KeysArgs {
    #[command(subcommand)]
    action: KeysAction,
}

#[derive(Debug, Clone, clap::Subcommand)]
enum KeysAction {
    /// Create a key and print it; it is not shown again
    Create {
        /// Tenant that the key belongs to: lower-case letters, digits and hyphens
        #[arg(long, default_value = "default")]
        tenant: String,
        /// Who the key is for: reader reads results, submitter also submits jobs, admin also manages webhooks and keys;
        /// default: submitter
        #[arg(long, value_name = "ROLE", conflicts_with = "scope")]
        role: Option<String>,
        /// Scopes of the key, separated by commas, where no role fits: read, submit, admin
        #[arg(long, value_delimiter = ',', value_name = "SCOPES")]
        scope: Vec<String>,
        /// Days until the key expires; absent: it does not expire
        #[arg(long, value_parser = clap::value_parser!(u64).range(1..=36_500), value_name = "DAYS")]
        expires_days: Option<u64>,
        /// Note by which to recognize the key, shown by `keys list`
        #[arg(long, default_value = "")]
        name: String,
        /// Create the database first if the data directory has none, for a service that has not been started yet
        #[arg(long)]
        init: bool,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// List all keys, without their secrets
    List {
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// Revoke a key with immediate effect
    Revoke {
        /// Id of the key, as `keys list` shows it, or the whole key
        id: String,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
}

/// Delete results and records that are past their retention time
#[derive(Debug, Clone, clap::Args)]
pub(super) struct PurgeArgs {
    /// Only count what would be deleted
    #[arg(long)]
    dry_run: bool,
    /// Trust the clock of the database from now on, although it has jumped since the service last saw it
    #[arg(long)]
    trust_clock: bool,
    #[command(flatten)]
    service: ServiceSettings,
}

impl From<JobError> for CliError {
    fn from(error: JobError) -> Self {
        CliError::Failed(app::store_error("the database", &error).to_string())
    }
}

/// Creates the database or brings its schema up to date.
pub(super) fn migrate(args: &MigrateArgs) -> Result<(), CliError> {
    let is_new = require_database(&args.service).is_err();
    with_store(&args.service, async |store| {
        store.ping().await?;
        Ok(match is_new {
            true => format!("created a database in {}", args.service.data_dir.display()),
            false => "the database is up to date".to_owned(),
        })
    })
}

/// Creates, lists or revokes keys.
pub(super) fn keys(args: &KeysArgs) -> Result<(), CliError> {
    match &args.action {
        KeysAction::Create { tenant, role, scope, expires_days, name, init, service } => {
            let allowed = "lower-case letters, digits and hyphens, at most 64";
            let owner = Tenant::new(tenant).ok_or_else(|| CliError::BadInput(format!("--tenant: {allowed}")))?;
            let role = match role.as_deref() {
                None => Role::Submitter,
                Some(name) => Role::from_name(name)
                    .ok_or_else(|| CliError::BadInput(format!("--role: reader, submitter, admin, not {name}")))?,
            };
            let mut scopes = if scope.is_empty() { role.scopes().to_vec() } else { Vec::new() };
            for word in scope {
                let scope = Scope::from_name(word.trim());
                scopes.push(
                    scope.ok_or_else(|| CliError::BadInput(format!("--scope: read, submit, admin, not {word}")))?,
                );
            }
            scopes.sort_unstable();
            scopes.dedup();
            if !init {
                require_database(service).map_err(|error| {
                    CliError::BadInput(format!("{error}, or add --init to create the database with the key"))
                })?;
            }
            let valid_for = expires_days.map(|days| Duration::from_secs(days * 86_400));
            with_store(service, async |store| {
                let key = SecretKey::random();
                store.insert_key(&key, &owner, name, &scopes, valid_for).await?;
                record(store, "create_key", Some(&owner), Some(key.id())).await?;
                Ok(key.reveal())
            })
        }
        KeysAction::List { service } => {
            require_database(service)?;
            with_store(service, async |store| {
                let lines: Vec<String> = store.list_keys().await?.iter().map(line).collect();
                Ok(format!("id\ttenant\trole\tscopes\tstate\tcreated\texpires\tname\n{}", lines.join("\n")))
            })
        }
        KeysAction::Revoke { id, service } => {
            require_database(service)?;
            // The whole key is accepted too; its secret is not printed.
            let id = SecretKey::parse(id).map_or_else(|| id.clone(), |key| key.id().to_owned());
            with_store(service, async |store| {
                if store.revoke_key(&id).await? {
                    let tenant = store.get_key(&id).await?.map(|key| key.tenant);
                    record(store, "revoke_key", tenant.as_ref(), Some(&id)).await?;
                    return Ok(format!("{id} is revoked"));
                }
                match store.list_keys().await?.iter().any(|key| key.id == id) {
                    true => Ok(format!("{id} was revoked before")),
                    false => {
                        Err(CliError::BadInput(format!("there is no key {id}; `homolog keys list` shows all ids")))
                    }
                }
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
    let role = Role::of_scopes(&key.scopes).map_or("-", Role::name);
    format!("{id}\t{tenant}\t{role}\t{}\t{state}\t{}\t{expires}\t{name}", scopes.join(","), key.created_at)
}

/// Deletes results and records past their retention time.
pub(super) fn purge(args: &PurgeArgs) -> Result<(), CliError> {
    require_database(&args.service)?;
    let artifacts = app::open_artifacts(&args.service).map_err(|error| CliError::Failed(error.to_string()))?;
    let (retention, dry_run) = (args.service.retention(), args.dry_run);
    let trusted = args.trust_clock && !dry_run;
    with_store(&args.service, async |store| {
        if let ClockState::Jumped { by_ms } = store.check_clock(trusted).await?
            && !dry_run
        {
            let hours = by_ms / 3_600_000;
            return Err(CliError::BadInput(format!(
                "the clock of the database is {hours} hours from the last time that the service saw, so that what is removed may be \
                 removed too early; if the clock is right, say so with --trust-clock"
            )));
        }
        let mut total = Purged::default();
        loop {
            let purged = store.purge(&retention, PURGED_AT_ONCE, dry_run).await?;
            total.add(&purged);
            if dry_run || purged.results + purged.jobs + purged.meshes == 0 {
                break;
            }
        }
        let mut blobs = 0;
        if !dry_run {
            overwrite_deleted(store).await?;
            blobs = store.remove_unreferenced_blobs(artifacts.as_ref()).await?;
            blobs += artifacts.sweep().await?;
            record(store, "purge", None, None).await?;
        }
        let verb = if dry_run { "would be removed" } else { "removed" };
        let Purged { results, jobs, studies, meshes, changes, deliveries, idempotency_keys } = total;
        Ok(format!(
            "{verb}: results of {results} jobs, {jobs} jobs, {studies} studies, {meshes} meshes, {changes} changes, {deliveries} deliveries, \
             {idempotency_keys} idempotency keys{}",
            if dry_run { String::new() } else { format!(", {blobs} files") }
        ))
    })
}

/// Overwrites deleted content in the files of the database; tries again while others read it.
pub(super) async fn overwrite_deleted(store: &SqlStore) -> Result<(), JobError> {
    let began = Instant::now();
    while !store.overwrite_deleted().await? {
        if began.elapsed() > OVERWRITTEN_WITHIN {
            note(
                "others read the database; until they end, its log still holds what was deleted: run this command again",
            );
            break;
        }
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    Ok(())
}

/// Refuses a data directory that holds no database.
pub(super) fn require_database(settings: &ServiceSettings) -> Result<(), CliError> {
    if settings.database(1).is_there() {
        return Ok(());
    }
    Err(CliError::BadInput(format!(
        "{} holds no service; name its data directory with --data-dir, or create the database with `homolog migrate` or \
         `homolog serve`",
        settings.data_dir.display()
    )))
}

/// Records a change by a command in the audit log. Commands have no tenant and no key: everybody who can read the
/// database can run them.
pub(super) async fn record(
    store: &SqlStore,
    action: &str,
    tenant: Option<&Tenant>,
    key_id: Option<&str>,
) -> Result<(), JobError> {
    let event = AuditEvent {
        tenant: tenant.cloned(),
        key_id: None,
        action: action.to_owned(),
        resource: key_id.map(|id| format!("keys/{id}")),
        address: Some("command-line".to_owned()),
        status: None,
    };
    store.append_audit(&[event]).await
}

/// Opens the database, runs `work` on it, and prints the answer unless it is empty.
pub(super) fn with_store(
    settings: &ServiceSettings,
    work: impl AsyncFnOnce(&SqlStore) -> Result<String, CliError>,
) -> Result<(), CliError> {
    let mut answer = Ok(String::new());
    in_runtime(settings, async {
        if settings.database_url.is_none() {
            app::create_data_dir(settings)?;
        }
        let store = app::open_database(settings).await?;
        answer = work(&store).await;
        store.close().await;
        Ok(())
    })?;
    let answer = answer?;
    if answer.is_empty() { Ok(()) } else { print(answer.trim_end()) }
}
