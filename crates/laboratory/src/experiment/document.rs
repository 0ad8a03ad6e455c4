//! The parts of a report: sections with tables and plots, every number with its unit.

use super::statistics::Summary;
pub use homolog_run::plot::{Axis, Plot, PlotKind, PlotPoint, Series};
use serde::{Deserialize, Serialize};

/// The whole report, stored as `report.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReportDocument {
    /// Version, commit, date and machine.
    pub provenance: ReportProvenance,
    /// Whether this is the quick report: coarse surfaces, few pairs.
    pub quick: bool,
    /// Number of units and computing time of every section.
    pub budget: Table,
    /// The sections, one for each question.
    pub sections: Vec<Section>,
}

/// Provenance of a report. The caller supplies it: the experiments read no clock and no system information.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ReportProvenance {
    /// Version of homolog.
    pub version: String,
    /// Commit from which it was built.
    pub commit: String,
    /// Day of the report.
    pub date: String,
    /// Processor, cores, system.
    pub machine: String,
}

/// One question and its answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// Identifier for file names and links.
    pub id: String,
    /// Heading.
    pub title: String,
    /// The question it answers.
    pub question: String,
    /// The parameters that were varied, and those that were fixed.
    pub varied: String,
    /// Number and kind of pairs or problems.
    pub pairs: String,
    /// One sentence with the numbers that answer the question.
    pub finding: String,
    /// Remarks, for example on missing data.
    pub notes: Vec<String>,
    /// The numbers.
    pub tables: Vec<Table>,
    /// Plots of the numbers.
    pub plots: Vec<Plot>,
    /// The command that reproduces this section.
    pub command: String,
}

/// A table; every row has as many cells as there are columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Identifier for the name of its CSV file.
    pub id: String,
    /// Heading.
    pub title: String,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows.
    pub rows: Vec<Vec<Cell>>,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Name of the quantity.
    pub name: String,
    /// Unit of its numbers, if they have one.
    pub unit: Option<String>,
    /// Decimals when printed.
    pub digits: usize,
}

impl Column {
    /// A column of numbers.
    pub fn new(name: &str, unit: &str, digits: usize) -> Self {
        let unit = (!unit.is_empty()).then(|| unit.to_owned());
        Column { name: name.to_owned(), unit, digits }
    }

    /// A column of texts or counts.
    pub fn plain(name: &str) -> Self {
        Column::new(name, "", 0)
    }

    /// Name and unit as a heading.
    pub fn heading(&self) -> String {
        with_unit(&self.name, self.unit.as_deref())
    }
}

/// `name (unit)`.
pub(super) fn with_unit(name: &str, unit: Option<&str>) -> String {
    match unit {
        Some(unit) => format!("{name} ({unit})"),
        None => name.to_owned(),
    }
}

/// A cell of a table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Cell {
    /// A count.
    Count(u64),
    /// One number.
    Number(f64),
    /// A sample, summarized.
    Spread(Summary),
    /// Text.
    Text(String),
    /// No measurement.
    Missing(()),
}

impl Cell {
    /// Text.
    pub fn text(words: impl Into<String>) -> Self {
        Cell::Text(words.into())
    }

    /// A number, if there is a finite one.
    pub fn number(value: Option<f64>) -> Self {
        value.filter(|v| v.is_finite()).map_or(Cell::Missing(()), Cell::Number)
    }

    /// The summary of a sample, if it is not empty.
    pub fn spread(summary: Option<Summary>) -> Self {
        summary.map_or(Cell::Missing(()), Cell::Spread)
    }
}
