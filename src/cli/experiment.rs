//! `homolog experiment`: measures all methods and writes one report.

use super::error::CliError;
use super::output::{note, print};
use super::peak_memory;
use super::progress::{Progress, WithoutTerminal};
use clap::Args;
use homolog_laboratory::experiment::document::ReportProvenance;
use homolog_laboratory::experiment::{ExperimentError, ExperimentOptions, run as run_experiments};
use std::path::PathBuf;
use std::time::Instant;

/// Measure all methods on phantoms and real hippocampi, and write a report
///
/// Writes report.html (a single self-contained page), report.json and a CSV file for each table. Finished measurements are
/// kept in units.jsonl: after an interruption the same command continues with the rest.
#[derive(Debug, Clone, Args)]
pub(super) struct ExperimentArgs {
    /// Folder with hippocampus/*.nii.gz; if it is missing, only phantoms are measured
    #[arg(long, value_name = "DIR", default_value = "data")]
    pub(super) data: PathBuf,
    /// Folder for the report
    #[arg(long, value_name = "DIR", default_value = "experiment")]
    pub(super) out: PathBuf,
    /// Use coarse surfaces and few pairs: a check that takes about a minute
    #[arg(long)]
    pub(super) quick: bool,
    /// Run only this section; may be repeated
    #[arg(long = "section", value_name = "ID")]
    pub(super) sections: Vec<String>,
    /// Folder written by `make accuracy`, such as docs/accuracy/DATE, whose table to include in the report
    #[arg(long, value_name = "DIR")]
    pub(super) accuracy: Option<PathBuf>,
}

/// Runs the command.
pub(super) fn run(args: &ExperimentArgs) -> Result<(), CliError> {
    let begun = Instant::now();
    let temporary = args.out.join(".memory");
    let options = ExperimentOptions {
        data: args.data.clone(),
        out: args.out.clone(),
        quick: args.quick,
        sections: args.sections.clone(),
        accuracy: args.accuracy.clone(),
        provenance: ReportProvenance {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: env!("HOMOLOG_COMMIT").to_owned(),
            date: jiff::Timestamp::now().strftime("%Y-%m-%d").to_string(),
            machine: machine(),
        },
        clock: Box::new(move || begun.elapsed()),
        memory: Some(Box::new(move |source, target, request| {
            peak_memory::of_match(&temporary, source, target, request)
        })),
    };
    let display = Progress::new(WithoutTerminal::Lines);
    let written = run_experiments(&options, &mut |at| {
        display.phase(at.section);
        display.fraction(at.done as f64 / at.total.max(1) as f64);
    });
    drop(display);
    let report = written.map_err(|error| match error {
        ExperimentError::UnknownSection { .. } => CliError::BadInput(error.to_string()),
        ExperimentError::File { .. } => CliError::Failed(error.to_string()),
    })?;
    if report.failed > 0 {
        note(&format!("{} measurements failed; the report says why", report.failed));
    }
    note(&format!("{} measurements made, {} reused", report.computed, report.reused));
    match report.files.first() {
        Some(page) => print(&page.display().to_string()),
        None => Ok(()),
    }
}

/// Processor, cores and system.
fn machine() -> String {
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = information
        .lines()
        .find_map(|line| line.strip_prefix("model name"))
        .map_or(std::env::consts::ARCH, |name| name.trim_matches([':', ' ', '\t']));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{processor}, {cores} cores, {}", std::env::consts::OS)
}
