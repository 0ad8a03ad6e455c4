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

/// Names of the files in the folder.
const PROVENANCE: &str = "provenance.json";
const FIGURES_FILE: &str = "accuracy.csv";

/// The contents of both files.
#[derive(Debug)]
struct Accuracy {
    provenance: Provenance,
    /// Methods in the order of the table.
    methods: Vec<String>,
    /// By method, set of pairs and figure.
    spreads: BTreeMap<(String, String, String), Spread>,
}

#[derive(Debug, Deserialize)]
struct Provenance {
    date: String,
    program: String,
    command: String,
    machine: String,
    cases_a_set: u64,
}

/// A row of the table of figures.
#[derive(Debug, Deserialize)]
struct Row {
    set: String,
    method: String,
    figure: String,
    #[serde(flatten)]
    spread: Spread,
}

/// Statistics over the pairs of a set; `low` and `high` bound the 95 % bootstrap confidence interval of the mean.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
struct Spread {
    mean: f64,
    #[serde(rename = "low95")]
    low: f64,
    #[serde(rename = "high95")]
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
/// [`ExperimentError::File`] if `provenance.json` or `accuracy.csv` cannot be read or parsed.
pub(super) fn section(folder: &Path) -> Result<Section, ExperimentError> {
    let (path, table) = (folder.join(PROVENANCE), folder.join(FIGURES_FILE));
    let read = |path: &Path| {
        fs::read_to_string(path).map_err(|source| ExperimentError::File { path: path.to_owned(), source })
    };
    let provenance = serde_json::from_str(&read(&path)?)
        .map_err(|error| ExperimentError::File { path, source: io::Error::from(error) })?;
    let mut accuracy = Accuracy { provenance, methods: Vec::new(), spreads: BTreeMap::new() };
    for row in csv::Reader::from_reader(read(&table)?.as_bytes()).deserialize() {
        let Row { set, method, figure, spread } =
            row.map_err(|error| ExperimentError::File { path: table.clone(), source: io::Error::other(error) })?;
        if !accuracy.methods.contains(&method) && !method.contains(':') {
            accuracy.methods.push(method.clone());
        }
        accuracy.spreads.insert((method, set, figure), spread);
    }
    Ok(written(&accuracy))
}

fn written(accuracy: &Accuracy) -> Section {
    let rows: Vec<Vec<Cell>> = accuracy
        .methods
        .iter()
        .map(|method| {
            std::iter::once(Cell::text(method.as_str()))
                .chain(FIGURES.iter().map(|f| cell(accuracy, method, f)))
                .collect()
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
    accuracy.spreads.get(&(method.to_owned(), set.to_owned(), key.to_owned())).copied()
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
    let names: Vec<&str> = accuracy.methods.iter().map(String::as_str).filter(|m| !OURS.contains(m)).collect();
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

    const WRITTEN: &str = "{\"date\": \"2026-01-31\", \"program\": \"homolog 0.1.0\", \"command\": \"make accuracy CASES=10\", \
                           \"machine\": \"two cores\", \"cases_a_set\": 10, \"packages\": {}}";

    #[test]
    fn the_section_repeats_the_table_and_names_the_best_other_method() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(PROVENANCE), WRITTEN).unwrap();
        let row = |set, method, figure, mean: f64| {
            format!("{set},{method},{figure},10,{mean},{},{},{mean},0\n", mean - 0.01, mean + 0.01)
        };
        let table = [
            "set,method,figure,n,mean,low95,high95,median,worst\n".to_owned(),
            row("real_warp4", "balanced", "w1", 0.9),
            row("real_warp4", "balanced", "seconds", 0.5),
            row("real_warp4", "variant: without", "w1", 0.95),
            row("real_warp4", "icp", "w1", 0.3),
            row("real_warp4", "bcpd", "w1", 0.8),
        ];
        fs::write(folder.path().join(FIGURES_FILE), table.concat()).unwrap();
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
        assert!(absent.contains(PROVENANCE), "{absent}");
        fs::write(folder.path().join(PROVENANCE), WRITTEN).unwrap();
        fs::write(folder.path().join(FIGURES_FILE), "set,method\nreal_warp4,balanced\n").unwrap();
        let refused = section(folder.path()).unwrap_err().to_string();
        assert!(refused.contains(FIGURES_FILE), "{refused}");
    }
}
