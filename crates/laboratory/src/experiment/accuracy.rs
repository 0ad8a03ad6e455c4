//! The accuracy comparison with other tools, read from the output of `make accuracy`.
//!
//! Those tools are Python packages, so the table is not computed from units here; the report includes it with its
//! provenance.

use super::ExperimentError;
use super::document::{Cell, Column, Section, Table};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// Name of the file in the folder.
const FILE: &str = "accuracy.json";

/// The fields that are read from the file.
#[derive(Debug, Deserialize)]
struct Accuracy {
    provenance: Provenance,
    /// The order of the methods.
    records: Vec<Record>,
    /// By `method | set of pairs`: figures by name.
    summaries: BTreeMap<String, Option<BTreeMap<String, serde_json::Value>>>,
}

#[derive(Debug, Deserialize)]
struct Provenance {
    date: String,
    program: String,
    command: String,
    machine: String,
    cases_a_set: u64,
}

#[derive(Debug, Deserialize)]
struct Record {
    method: String,
}

/// Statistics over the pairs of a set; `low` and `high` bound the 95 % bootstrap confidence interval of the mean.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
struct Spread {
    mean: f64,
    low: f64,
    high: f64,
    median: f64,
}

/// A column: the set of pairs, the figure in it, and how it is shown.
struct Figure {
    set: &'static str,
    key: &'static str,
    heading: &'static str,
    unit: &'static str,
    digits: usize,
    /// Whether the median is shown; otherwise the mean with its confidence interval.
    median: bool,
    /// Factor by which values are multiplied for display.
    factor: f64,
}

const fn mean(
    set: &'static str,
    key: &'static str,
    heading: &'static str,
    unit: &'static str,
    digits: usize,
) -> Figure {
    Figure { set, key, heading, unit, digits, median: false, factor: 1.0 }
}

const FIGURES: [Figure; 10] = [
    mean("real_warp4", "w1", "warp 4 %: within one edge", "", 3),
    mean("real_warp4", "err_mm", "warp 4 %: error", "mm", 2),
    mean("real_warp8", "w1", "warp 8 %: within one edge", "", 3),
    mean("real_warp8", "err_mm", "warp 8 %: error", "mm", 2),
    mean("real_cross", "label", "different subjects: label agreement", "", 3),
    Figure { median: true, ..mean("real_resample", "rot_deg", "copies: rotation error, median", "°", 2) },
    mean("real_resample", "within_10_deg", "copies within 10°", "", 2),
    mean("real_cross", "within_10_deg", "different subjects within 10°", "", 2),
    Figure { median: true, ..mean("real_warp4", "seconds", "time, median", "s", 2) },
    Figure { median: true, factor: 1e-6, ..mean("real_warp4", "peak_bytes", "peak memory, median", "MB", 0) },
];

/// The section, from the folder that `make accuracy` wrote.
///
/// # Errors
/// [`ExperimentError::File`] if its `accuracy.json` cannot be read or parsed.
pub(super) fn section(folder: &Path) -> Result<Section, ExperimentError> {
    let path = folder.join(FILE);
    let text = fs::read_to_string(&path);
    let parsed = text.and_then(|text| serde_json::from_str::<Accuracy>(&text).map_err(io::Error::from));
    match parsed {
        Ok(accuracy) => Ok(written(&accuracy)),
        Err(source) => Err(ExperimentError::File { path, source }),
    }
}

fn written(accuracy: &Accuracy) -> Section {
    let mut methods: Vec<&str> = Vec::new();
    for record in &accuracy.records {
        if !methods.contains(&record.method.as_str()) && !record.method.contains(':') {
            methods.push(&record.method);
        }
    }
    let rows: Vec<Vec<Cell>> = methods
        .iter()
        .map(|method| {
            std::iter::once(Cell::text(*method)).chain(FIGURES.iter().map(|f| cell(accuracy, method, f))).collect()
        })
        .collect();
    let mut columns = vec![Column::plain("method")];
    columns.extend(FIGURES.iter().map(|f| Column::new(f.heading, f.unit, f.digits)));
    let Provenance { date, program, command, machine, cases_a_set } = &accuracy.provenance;
    Section {
        id: "accuracy".to_owned(),
        title: "Accuracy compared with other methods".to_owned(),
        question: "How accurate are correspondence and pose, compared with other methods on the same pairs?".to_owned(),
        varied:
            "The method. The pairs are fixed: real hippocampi, resampled, warped by 4 % and 8 % of the diagonal, and of \
                 different subjects, each target in an arbitrary pose."
                .to_owned(),
        pairs: format!("{cases_a_set} pairs per set; three times as many resampled copies and pairs of different subjects"),
        finding: finding(accuracy),
        notes: vec![
            format!("Measured on {date} by {program}, {machine}."),
            "Brackets: 95 % bootstrap confidence interval of the mean over pairs. Within 10°: rotation error against the \
             reference. Edge: mean edge length of the target. The times of homolog are those of the whole command; for the \
             other methods reading the surfaces is not counted."
                .to_owned(),
        ],
        tables: vec![Table { id: "peers".to_owned(), title: "Comparison of methods".to_owned(), columns, rows }],
        plots: Vec::new(),
        command: command.clone(),
    }
}

fn spread(accuracy: &Accuracy, method: &str, set: &str, key: &str) -> Option<Spread> {
    let figures = accuracy.summaries.get(&format!("{method} | {set}"))?.as_ref()?;
    serde_json::from_value(figures.get(key)?.clone()).ok()
}

fn cell(accuracy: &Accuracy, method: &str, figure: &Figure) -> Cell {
    let Some(found) = spread(accuracy, method, figure.set, figure.key) else { return Cell::Missing(()) };
    if figure.median {
        return Cell::Number(found.median * figure.factor);
    }
    let [mean, low, high] = [found.mean, found.low, found.high].map(|v| v * figure.factor);
    let d = figure.digits;
    Cell::text(format!("{mean:.d$} [{low:.d$}, {high:.d$}]"))
}

/// Compares the default method with the best other tool.
fn finding(accuracy: &Accuracy) -> String {
    const OURS: [&str; 2] = ["balanced", "rigid"];
    let names: std::collections::BTreeSet<&str> =
        accuracy.records.iter().map(|r| r.method.as_str()).filter(|m| !m.contains(':') && !OURS.contains(m)).collect();
    let sentence = |set: &str, key: &str, what: &str| {
        let ours = spread(accuracy, OURS[0], set, key)?.mean;
        let peer = names
            .iter()
            .filter_map(|&name| Some((name, spread(accuracy, name, set, key)?.mean)))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        Some(match peer {
            Some((name, theirs)) => {
                format!("{what} {ours:.3} with {}, {theirs:.3} with {name}, the best other method.", OURS[0])
            }
            None => format!("{what} {ours:.3} with {}.", OURS[0]),
        })
    };
    [
        sentence("real_warp4", "w1", "Correct match rate within one edge on 4 % warps:"),
        sentence("real_warp8", "w1", "Correct match rate within one edge on 8 % warps:"),
        sentence("real_cross", "label", "Label agreement between different subjects:"),
    ]
    .into_iter()
    .flatten()
    .collect::<Vec<_>>()
    .join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn spread_of(mean: f64) -> serde_json::Value {
        json!({"n": 10, "mean": mean, "low": mean - 0.01, "high": mean + 0.01, "median": mean, "worst": 0.0})
    }

    #[test]
    fn the_section_repeats_the_table_and_names_the_best_other_method() {
        let folder = tempfile::tempdir().unwrap();
        let file = json!({
            "provenance": {"date": "2026-01-31", "program": "homolog 0.1.0", "command": "make accuracy CASES=10",
                           "machine": "two cores", "cases_a_set": 10, "packages": {}},
            "records": [{"method": "balanced"}, {"method": "variant: without"}, {"method": "icp"}, {"method": "bcpd"}],
            "summaries": {
                "balanced | real_warp4": {"w1": spread_of(0.9), "seconds": spread_of(0.5), "status": {"answered": 10}},
                "icp | real_warp4": {"w1": spread_of(0.3)},
                "bcpd | real_warp4": {"w1": spread_of(0.8), "err_mm": null},
                "bcpd | real_warp8": null,
            },
        });
        fs::write(folder.path().join(FILE), file.to_string()).unwrap();
        let section = section(folder.path()).unwrap();
        assert_eq!(
            section.finding,
            "Correct match rate within one edge on 4 % warps: 0.900 with balanced, 0.800 with bcpd, the best other method."
        );
        let rows = &section.tables[0].rows;
        assert_eq!(rows.len(), 3);
        assert!(rows.iter().all(|row| row.len() == section.tables[0].columns.len()));
        assert_eq!(rows[0][1], Cell::text("0.900 [0.890, 0.910]"));
        assert_eq!(rows[0][9], Cell::Number(0.5));
        assert_eq!(rows[2][2], Cell::Missing(()));
    }

    #[test]
    fn a_file_in_another_format_is_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let absent = section(folder.path()).unwrap_err().to_string();
        assert!(absent.contains(FILE), "{absent}");
        fs::write(folder.path().join(FILE), "{\"records\": 3}").unwrap();
        assert!(section(folder.path()).is_err());
    }
}
