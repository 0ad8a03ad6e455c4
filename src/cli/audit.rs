//! `homolog audit`: exports and verifies the audit log.

use super::admin::{overwrite_deleted, require_database, with_store};
use super::error::CliError;
use super::output::{print, print_json};
use crate::config::ServiceSettings;
use crate::jobs::audit::{AuditHead, AuditRow, AuditStore as _, Verifier};
use jiff::Timestamp;
use jiff::civil::Date;
use jiff::tz::TimeZone;
use std::fs::File;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};

/// Rows read at once.
const PAGE: u32 = 1000;

/// Export and verify the audit log
#[derive(Debug, Clone, clap::Args)]
pub(super) struct AuditArgs {
    #[command(subcommand)]
    action: AuditAction,
}

#[derive(Debug, Clone, clap::Subcommand)]
enum AuditAction {
    /// Print the rows of the log, one JSON object per line
    Export {
        /// Only the rows after this position
        #[arg(long, default_value_t = 0, value_name = "POSITION")]
        after: u64,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// Remove the rows before a time, after an export; the log records the place, so the remaining rows can still be
    /// verified
    Prune {
        /// Date, such as 2026-01-31, or time, such as 2026-01-31T12:00:00Z; a date begins at midnight UTC
        #[arg(long, value_parser = time, value_name = "TIME")]
        before: Timestamp,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
    /// Check that no row was changed, removed or inserted, and print the position and hash of the last row
    Verify {
        /// Position and hash of a row as printed by an earlier verification: also check that the log was not cut off
        /// before that row or rewritten; repeatable
        #[arg(long, value_parser = noted, value_name = "POSITION:HASH")]
        expect: Vec<AuditHead>,
        /// Check this file, which `homolog audit export` has written from the first row on, instead of the database
        #[arg(long, value_name = "FILE")]
        file: Option<PathBuf>,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
}

fn time(text: &str) -> Result<Timestamp, String> {
    let midnight = || text.parse::<Date>().ok()?.to_zoned(TimeZone::UTC).ok();
    let time = text.parse().ok().or_else(|| midnight().map(|midnight| midnight.timestamp()));
    time.ok_or_else(|| "a date such as 2026-01-31, or a time such as 2026-01-31T12:00:00Z, is needed here".to_owned())
}

fn noted(text: &str) -> Result<AuditHead, String> {
    AuditHead::parse(text).ok_or_else(|| "POSITION:HASH is needed here, as `homolog audit verify` prints it".to_owned())
}

/// Exports or verifies the log.
pub(super) fn run(args: &AuditArgs) -> Result<(), CliError> {
    match &args.action {
        AuditAction::Export { after, service } => {
            require_database(service)?;
            with_store(service, async |store| {
                // Rows that are being pruned no longer belong to the log.
                let mut after = store.audit_anchor().await?.position.max(*after);
                loop {
                    let rows = store.list_audit(after, PAGE).await?;
                    rows.iter().try_for_each(print_json)?;
                    match rows.last() {
                        Some(last) => after = last.position,
                        None => return Ok(String::new()),
                    }
                }
            })
        }
        AuditAction::Prune { before, service } => {
            require_database(service)?;
            with_store(service, async |store| {
                let (anchor, n_removed) = store.prune_audit(*before).await?;
                overwrite_deleted(store).await?;
                Ok(match n_removed {
                    0 => format!("no row is older than {before}; the log begins after {anchor}"),
                    n => format!("removed {n} rows; the log begins after {anchor}"),
                })
            })
        }
        AuditAction::Verify { expect, file, service } => {
            if let Some(file) = file {
                let anchor = beginning_of(file)?;
                let mut verifier = Verifier::after(anchor.clone());
                expect.iter().cloned().for_each(|head| verifier.expect(head));
                return print(&said(&anchor, &verify_file(verifier, file)?));
            }
            require_database(service)?;
            with_store(service, async |store| {
                let anchor = store.audit_anchor().await?;
                let mut after = anchor.position;
                let mut verifier = Verifier::after(anchor.clone());
                expect.iter().cloned().for_each(|head| verifier.expect(head));
                // Read before the rows, because rows that are appended in the meantime follow it.
                verifier.expect(store.audit_head().await?);
                loop {
                    let rows = store.list_audit(after, PAGE).await?;
                    for row in &rows {
                        verifier.add(row).map_err(|fault| broken(&fault))?;
                    }
                    match rows.last() {
                        Some(last) => after = last.position,
                        None => return Ok(said(&anchor, &verifier.end().map_err(|fault| broken(&fault))?)),
                    }
                }
            })
        }
    }
}

/// The rows of an exported log.
fn rows_of(path: &Path) -> Result<impl Iterator<Item = Result<AuditRow, CliError>>, CliError> {
    let unreadable = |error: std::io::Error| CliError::BadInput(format!("cannot read {}: {error}", path.display()));
    let lines = BufReader::new(File::open(path).map_err(unreadable)?).lines().enumerate();
    Ok(lines.map(move |(index, line)| {
        serde_json::from_str(&line.map_err(unreadable)?).map_err(|error| {
            CliError::BadInput(format!("{}: line {} is no row of the audit log: {error}", path.display(), index + 1))
        })
    }))
}

/// Where an exported log begins: after the last pruned row, which one of its rows records.
fn beginning_of(path: &Path) -> Result<AuditHead, CliError> {
    let mut rows = rows_of(path)?;
    let first = rows.next().transpose()?.map_or(1, |row| row.position);
    if first <= 1 {
        return Ok(AuditHead::start());
    }
    for row in rows {
        if let Some(anchor) = row?.pruned()
            && anchor.position + 1 == first
        {
            return Ok(anchor);
        }
    }
    Ok(AuditHead::start())
}

fn verify_file(mut verifier: Verifier, path: &Path) -> Result<AuditHead, CliError> {
    for row in rows_of(path)? {
        verifier.add(&row?).map_err(|fault| broken(&fault))?;
    }
    verifier.end().map_err(|fault| broken(&fault))
}

fn said(anchor: &AuditHead, last: &AuditHead) -> String {
    format!("the audit log is whole; {} rows, the last is {last}", last.position - anchor.position)
}

fn broken(fault: &crate::jobs::audit::AuditFault) -> CliError {
    CliError::Failed(format!("the audit log is not as it was written: {fault}"))
}
