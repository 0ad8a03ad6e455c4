//! The parts of a report: sections with tables and plots, every number with its unit.

use super::statistics::Summary;
use serde::{Deserialize, Serialize};

/// The whole report; `report.json` is this.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReportDocument {
    /// Version, commit, date and machine.
    pub provenance: ReportProvenance,
    /// Whether it is the quick form: coarse surfaces, few pairs.
    pub quick: bool,
    /// Number of units and computing time of every section.
    pub budget: Table,
    /// One for each question.
    pub sections: Vec<Section>,
}

/// Provenance of a report. The caller supplies it: the experiments read no clock and no system information.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ReportProvenance {
    /// Version of homolog.
    pub version: String,
    /// Commit it was built from.
    pub commit: String,
    /// Day of the report.
    pub date: String,
    /// Processor, cores, system.
    pub machine: String,
}

/// One question and its answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// A word for file names and links.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// The question it answers.
    pub question: String,
    /// What was varied, and what was fixed.
    pub varied: String,
    /// Number and kind of pairs or problems.
    pub pairs: String,
    /// One sentence with the numbers that answer the question.
    pub finding: String,
    /// Remarks, such as data that are absent.
    pub notes: Vec<String>,
    /// The numbers.
    pub tables: Vec<Table>,
    /// The numbers, drawn.
    pub plots: Vec<Plot>,
    /// The command that reproduces this section.
    pub command: String,
}

/// A table; every row has as many cells as there are columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// A word for the name of its CSV file.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows.
    pub rows: Vec<Vec<Cell>>,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// What it holds.
    pub name: String,
    /// Unit of its numbers, if they have one.
    pub unit: Option<String>,
    /// Digits after the point where it is printed.
    pub digits: usize,
}

impl Column {
    /// A column of numbers.
    pub fn new(name: &str, unit: &str, digits: usize) -> Self {
        let unit = (!unit.is_empty()).then(|| unit.to_owned());
        Column { name: name.to_owned(), unit, digits }
    }

    /// A column of words or counts.
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
    /// Nothing was measured.
    Missing(()),
}

impl Cell {
    /// Text.
    pub fn text(words: impl Into<String>) -> Self {
        Cell::Text(words.into())
    }

    /// A number, if there is one that can be written.
    pub fn number(value: Option<f64>) -> Self {
        value.filter(|v| v.is_finite()).map_or(Cell::Missing(()), Cell::Number)
    }

    /// Many numbers, if there are any.
    pub fn spread(summary: Option<Summary>) -> Self {
        summary.map_or(Cell::Missing(()), Cell::Spread)
    }
}

/// A plot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// How it is drawn.
    pub kind: PlotKind,
    /// The horizontal axis; of bars, only its label is used.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Names of the places of bars, in order: place `k` is at `x = k`.
    pub categories: Vec<String>,
    /// What is drawn.
    pub series: Vec<Series>,
}

/// How a plot is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PlotKind {
    /// Points joined by lines.
    Lines,
    /// Bars from zero.
    Bars,
    /// Points alone.
    Scatter,
}

/// An axis of a plot.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Axis {
    /// What it measures.
    pub label: String,
    /// In which unit.
    pub unit: Option<String>,
    /// Whether equal steps are equal factors.
    pub log: bool,
}

impl Axis {
    /// A linear axis; an empty `unit` is none.
    pub fn linear(label: &str, unit: &str) -> Self {
        let unit = (!unit.is_empty()).then(|| unit.to_owned());
        Axis { label: label.to_owned(), unit, log: false }
    }

    /// A logarithmic axis.
    pub fn logarithmic(label: &str, unit: &str) -> Self {
        Axis { log: true, ..Axis::linear(label, unit) }
    }
}

/// Points of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Its points, in drawing order.
    pub points: Vec<PlotPoint>,
}

/// A point of a plot, with the ends of its error bar if it has one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlotPoint {
    /// Horizontal value.
    pub x: f64,
    /// Vertical value.
    pub y: f64,
    /// Lower end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub low: Option<f64>,
    /// Upper end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub high: Option<f64>,
}

impl PlotPoint {
    /// A point without error bar.
    pub fn at(x: f64, y: f64) -> Self {
        PlotPoint { x, y, low: None, high: None }
    }

    /// The mean with a bar of one standard deviation to either side.
    pub fn of(x: f64, summary: &Summary) -> Self {
        let (low, high) = (summary.mean - summary.sd, summary.mean + summary.sd);
        PlotPoint { x, y: summary.mean, low: Some(low), high: Some(high) }
    }
}
