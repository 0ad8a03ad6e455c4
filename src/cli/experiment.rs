//! `homolog experiment`: what each method is worth, measured, in one report.

use super::error::CliError;
use super::output::{note, print};
use super::progress::{Progress, WithoutTerminal};
use clap::Args;
use homolog_laboratory::experiment::document::ReportProvenance;
use homolog_laboratory::experiment::{ExperimentError, ExperimentOptions, run as run_experiments};
use std::path::PathBuf;
use std::time::Instant;

/// Measure every method on phantoms and on real hippocampi, and write a report
///
/// Writes report.html (one page that needs nothing else), report.json and a CSV file for each table. What is finished is
/// kept in units.jsonl: the same command goes on where it was stopped.
#[derive(Debug, Clone, Args)]
pub struct ExperimentArgs {
    /// Folder that holds hippocampus/*.nii.gz; without it only phantoms are measured
    #[arg(long, value_name = "DIR", default_value = "data")]
    pub data: PathBuf,
    /// Folder for the report
    #[arg(long, value_name = "DIR", default_value = "experiment")]
    pub out: PathBuf,
    /// Coarse surfaces and few pairs: about a minute, to see that it works
    #[arg(long)]
    pub quick: bool,
    /// Only this section; may be repeated
    #[arg(long = "section", value_name = "ID")]
    pub sections: Vec<String>,
    /// Folder that `make accuracy` wrote, such as docs/accuracy/DATE: its table becomes part of the report
    #[arg(long, value_name = "DIR")]
    pub accuracy: Option<PathBuf>,
}

/// Runs the command.
pub(super) fn run(args: &ExperimentArgs) -> Result<(), CliError> {
    let begun = Instant::now();
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
        note(&format!("{} units have no numbers; the report says why", report.failed));
    }
    note(&format!("{} units measured, {} known from before", report.computed, report.reused));
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
