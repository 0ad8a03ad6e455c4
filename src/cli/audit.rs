//! `homolog audit`: the audit log is exported, and verified.

use super::admin::{require_database, with_store};
use super::error::CliError;
use super::output::{print, print_json};
use crate::config::ServiceSettings;
use crate::jobs::audit::{AuditHead, AuditRow, AuditStore as _, Verifier};
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
    /// Check that no row was changed, removed or inserted, and print the position and hash of the last one
    Verify {
        /// Position and hash of a row as an earlier verification printed them: also find out whether the log was cut off
        /// before that row, or written anew; repeatable
        #[arg(long, value_parser = noted, value_name = "POSITION:HASH")]
        expect: Vec<AuditHead>,
        /// Check this file, which `homolog audit export` has written from the first row on, instead of the database
        #[arg(long, value_name = "FILE")]
        file: Option<PathBuf>,
        #[command(flatten)]
        service: Box<ServiceSettings>,
    },
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
                let mut after = *after;
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
        AuditAction::Verify { expect, file, service } => {
            let mut verifier = Verifier::default();
            expect.iter().cloned().for_each(|head| verifier.expect(head));
            if let Some(file) = file {
                return print(&said(verify_file(verifier, file)?));
            }
            require_database(service)?;
            with_store(service, async |store| {
                // Before the rows: those that are appended meanwhile come after it.
                verifier.expect(store.audit_head().await?);
                let mut after = 0;
                loop {
                    let rows = store.list_audit(after, PAGE).await?;
                    for row in &rows {
                        verifier.add(row).map_err(|fault| broken(&fault))?;
                    }
                    match rows.last() {
                        Some(last) => after = last.position,
                        None => return Ok(said(verifier.end().map_err(|fault| broken(&fault))?)),
                    }
                }
            })
        }
    }
}

fn verify_file(mut verifier: Verifier, path: &Path) -> Result<AuditHead, CliError> {
    let unreadable = |error: std::io::Error| CliError::BadInput(format!("cannot read {}: {error}", path.display()));
    for (index, line) in BufReader::new(File::open(path).map_err(unreadable)?).lines().enumerate() {
        let row: AuditRow = serde_json::from_str(&line.map_err(unreadable)?).map_err(|error| {
            CliError::BadInput(format!("{}: line {} is no row of the audit log: {error}", path.display(), index + 1))
        })?;
        verifier.add(&row).map_err(|fault| broken(&fault))?;
    }
    verifier.end().map_err(|fault| broken(&fault))
}

fn said(last: AuditHead) -> String {
    format!("the audit log is whole; {} rows, the last is {last}", last.position)
}

fn broken(fault: &crate::jobs::audit::AuditFault) -> CliError {
    CliError::Failed(format!("the audit log is not as it was written: {fault}"))
}
