//! The evaluation: the accuracy of each method on phantoms and on real hippocampi, in one report.
//!
//! A section answers one question. It plans **units** (a setting on a pair), which are computed one after another and
//! stored, so that an interrupted report resumes where it stopped; from the finished units it makes tables, plots and a
//! finding in words. [`run`] writes `report.html` (a self-contained page), `report.json` (all numbers), one CSV file per
//! table, and `units.jsonl` (the finished units).
//!
//! Order and seeds are fixed: the same program on the same inputs gives the same numbers, except for times, which come
//! from the caller's clock.

mod accuracy;
mod csv;
pub mod document;
mod draws;
mod hippocampi;
mod html;
mod measure;
mod pairs;
mod results;
mod sections;
mod solids;
mod statistics;
mod study;
#[cfg(test)]
mod tests;
mod units;

pub use statistics::Summary;

use document::{Cell, Column, ReportDocument, ReportProvenance, Section, Table};
use homolog_mesh::SurfaceMesh;
use results::Results;
use sections::Experiment;
use serde_json::Value;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;
use study::Study;
use units::{Ending, FinishedUnit, UnitStore, key};

/// A monotonic clock.
pub type Clock = Box<dyn Fn() -> Duration + Sync>;

/// Measures the peak memory, bytes, of matching a source to a target with the parameters of a request in a separate
/// process; or returns one line with the reason why it is unknown.
pub type MemoryMeter = Box<dyn Fn(&SurfaceMesh, &SurfaceMesh, &Value) -> Result<u64, String> + Sync>;

/// The sections to run, their data, and the destination of the report.
pub struct ExperimentOptions {
    /// Folder with `hippocampus/*.nii.gz`; if there is none, there are no real pairs.
    pub data: PathBuf,
    /// Folder for the report; finished units in it are not computed again.
    pub out: PathBuf,
    /// Coarse surfaces and two pairs per setting, about a minute in total.
    pub quick: bool,
    /// Only the sections with these ids, in the order of the report; all if empty.
    pub sections: Vec<String>,
    /// Folder written by `make accuracy`; its table becomes the last section.
    pub accuracy: Option<PathBuf>,
    /// Provenance printed in the report. Finished units of another version or commit are computed again.
    pub provenance: ReportProvenance,
    /// The clock for timing units.
    pub clock: Clock,
    /// Measures the memory of matches; `None` leaves memory out of the report.
    pub memory: Option<MemoryMeter>,
}

/// Progress of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress<'a> {
    /// Finished units.
    pub done: usize,
    /// All units.
    pub total: usize,
    /// Title of the current section.
    pub section: &'a str,
    /// The unit that starts now.
    pub unit: &'a str,
}

/// A written report.
#[derive(Debug, Clone, PartialEq)]
pub struct ExperimentReport {
    /// Its content.
    pub document: ReportDocument,
    /// Paths of the page, the numbers as JSON, and the tables, in this order.
    pub files: Vec<PathBuf>,
    /// Units computed in this run.
    pub computed: usize,
    /// Units found from an earlier run.
    pub reused: usize,
    /// Units of either kind that failed.
    pub failed: usize,
}

/// Reasons why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ExperimentError {
    /// A file cannot be read or written.
    #[error("cannot use {}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// No section has this id.
    #[error("there is no section {id}; the sections are {known}")]
    UnknownSection {
        /// The requested id.
        id: String,
        /// All ids, separated by commas.
        known: String,
    },
}

/// Ids of all sections, in the order of the report.
pub fn section_ids() -> impl Iterator<Item = &'static str> {
    sections::ALL.iter().map(|section| section.about().id)
}

/// Computes the missing units and writes the report. A unit that fails is stored with its reason and counted.
///
/// # Errors
/// [`ExperimentError`].
///
/// # Cost
/// Under a minute if quick, otherwise up to 40 minutes on two cores; every unit uses all cores.
pub fn run(
    options: &ExperimentOptions,
    progress: &mut dyn FnMut(&Progress<'_>),
) -> Result<ExperimentReport, ExperimentError> {
    let chosen = chosen(&options.sections)?;
    let file = |path: &Path, source| ExperimentError::File { path: path.to_owned(), source };
    fs::create_dir_all(&options.out).map_err(|e| file(&options.out, e))?;
    let mut store = UnitStore::open(&options.out.join("units.jsonl"))?;
    // Read first, so that a wrong folder is reported before hours of work.
    let beside_peers = options.accuracy.as_deref().map(accuracy::section).transpose()?;
    let study = Study::new(options);
    let version = format!("{} {}", options.provenance.version, options.provenance.commit);
    let plans: Vec<_> = chosen.iter().map(|section| (*section, section.units(&study))).collect();
    let total = plans.iter().map(|(_, units)| units.len()).sum();
    let (mut done, mut reused) = (0, 0);
    let mut finished_sections = Vec::new();
    for (section, units) in plans {
        let about = section.about();
        let mut finished = Vec::with_capacity(units.len());
        for unit in units {
            let name = format!("{}, {}", unit.configuration, unit.case);
            progress(&Progress { done, total, section: about.title, unit: &name });
            let key = key(about.id, &version, &unit.inputs);
            let known = store.find(&key).cloned();
            reused += usize::from(known.is_some());
            let result = match known {
                Some(result) => {
                    FinishedUnit { group: unit.group, configuration: unit.configuration, case: unit.case, ..result }
                }
                None => {
                    let begin = (options.clock)();
                    let ending = (unit.work)().map_or_else(Ending::Failed, Ending::Measured);
                    let result = FinishedUnit {
                        key,
                        section: about.id.to_owned(),
                        group: unit.group,
                        configuration: unit.configuration,
                        case: unit.case,
                        seconds: (options.clock)().saturating_sub(begin).as_secs_f64(),
                        ending,
                    };
                    store.keep(&result)?;
                    result
                }
            };
            finished.push(result);
            done += 1;
        }
        // Sections seldom share pairs, and pairs take much memory.
        study.clear_pairs();
        finished_sections.push((section, Results::new(finished)));
    }
    progress(&Progress { done, total, section: "Report", unit: "writing" });
    let document = ReportDocument {
        provenance: options.provenance.clone(),
        quick: options.quick,
        budget: budget(&finished_sections),
        sections: finished_sections
            .iter()
            .map(|(s, results)| written(*s, &study, options, results))
            .chain(beside_peers)
            .collect(),
    };
    let files = write_files(&document, &options.out)?;
    let failed = finished_sections.iter().map(|(_, results)| results.n_failed()).sum();
    Ok(ExperimentReport { document, files, computed: total - reused, reused, failed })
}

/// The sections with these ids.
fn chosen(ids: &[String]) -> Result<Vec<&'static dyn Experiment>, ExperimentError> {
    if let Some(id) = ids.iter().find(|id| section_ids().all(|known| known != id.as_str())) {
        let known: Vec<_> = section_ids().collect();
        return Err(ExperimentError::UnknownSection { id: id.clone(), known: known.join(", ") });
    }
    let wanted = |s: &&dyn Experiment| ids.is_empty() || ids.iter().any(|id| id == s.about().id);
    Ok(sections::ALL.iter().copied().filter(wanted).collect())
}

/// A section of the report from its finished units.
fn written(section: &dyn Experiment, study: &Study, options: &ExperimentOptions, results: &Results) -> Section {
    let about = section.about();
    let body = section.report(study, results);
    let mut notes = body.notes;
    for (reason, n) in results.failures() {
        notes.push(format!("Failed on {n} pairs: {reason}."));
    }
    let quick = if options.quick { " --quick" } else { "" };
    Section {
        id: about.id.to_owned(),
        title: about.title.to_owned(),
        question: about.question.to_owned(),
        varied: about.varied.to_owned(),
        pairs: body.pairs,
        finding: body.finding,
        notes,
        tables: body.tables,
        plots: body.plots,
        command: format!("homolog experiment --section {}{quick} --data {}", about.id, options.data.display()),
    }
}

/// The number of units and the computing time of every section.
fn budget(sections: &[(&dyn Experiment, Results)]) -> Table {
    let row = |name: &str, units: usize, failed: usize, seconds: f64| {
        vec![Cell::text(name), Cell::Count(units as u64), Cell::Count(failed as u64), Cell::Number(seconds)]
    };
    let mut rows: Vec<_> =
        sections.iter().map(|(s, r)| row(s.about().title, r.n_units(), r.n_failed(), r.seconds())).collect();
    let sum = |count: fn(&Results) -> usize| sections.iter().map(|(_, r)| count(r)).sum();
    let seconds = sections.iter().map(|(_, r)| r.seconds()).sum();
    rows.push(row("total", sum(Results::n_units), sum(Results::n_failed), seconds));
    Table {
        id: "budget".to_owned(),
        title: "Number of units and computing time by section".to_owned(),
        columns: vec![
            Column::plain("section"),
            Column::plain("units"),
            Column::plain("failed"),
            Column::new("time", "s", 1),
        ],
        rows,
    }
}

/// Writes the page, the numbers and the tables.
fn write_files(document: &ReportDocument, out: &Path) -> Result<Vec<PathBuf>, ExperimentError> {
    let mut files = Vec::new();
    let mut write = |name: &str, text: String| {
        let path = out.join(name);
        // Written under a temporary name and renamed, so that no reader sees a partial file.
        let unfinished = out.join(format!(".{name}.unfinished"));
        let written = fs::write(&unfinished, text).and_then(|()| fs::rename(&unfinished, &path));
        written.map_err(|source| ExperimentError::File { path: path.clone(), source })?;
        files.push(path);
        Ok(())
    };
    write("report.html", html::page(document))?;
    let json = serde_json::to_string_pretty(document)
        .map_err(|e| ExperimentError::File { path: out.join("report.json"), source: e.into() })?;
    write("report.json", json + "\n")?;
    for section in &document.sections {
        for table in &section.tables {
            write(&format!("{}-{}.csv", section.id, table.id), csv::csv(table))?;
        }
    }
    write("budget.csv", csv::csv(&document.budget))?;
    Ok(files)
}
