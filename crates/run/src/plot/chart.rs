//! Charts of series: lines, bars or points, with error bars, a legend and axes.

use super::COLORS;
use super::drawing::{Anchor, Drawing};
use super::frame::Frame;
use super::scale::Scale;
use serde::{Deserialize, Serialize};

const WIDTH: f64 = 720.0;
const LEFT: f64 = 72.0;
const RIGHT: f64 = 700.0;
const PLOT_HEIGHT: f64 = 260.0;
const LEGEND_ROW: f64 = 20.0;
const LABEL_LINE: f64 = 15.0;

/// A plot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// Heading.
    pub title: String,
    /// Kind of plot.
    pub kind: PlotKind,
    /// The horizontal axis; bar plots use only its label.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Names of the categories of a bar plot, in order: category `k` is at `x = k`.
    pub categories: Vec<String>,
    /// The series of points.
    pub series: Vec<Series>,
}

/// Kind of plot.
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
    /// The measured quantity.
    pub label: String,
    /// Unit, if there is one.
    pub unit: Option<String>,
    /// Whether the axis is logarithmic.
    pub log: bool,
}

impl Axis {
    /// A linear axis; an empty `unit` means none.
    pub fn linear(label: &str, unit: &str) -> Self {
        let unit = (!unit.is_empty()).then(|| unit.to_owned());
        Axis { label: label.to_owned(), unit, log: false }
    }

    /// The label with the unit.
    fn heading(&self) -> String {
        match &self.unit {
            Some(unit) => format!("{} ({unit})", self.label),
            None => self.label.clone(),
        }
    }

    /// A logarithmic axis.
    pub fn logarithmic(label: &str, unit: &str) -> Self {
        Axis { log: true, ..Axis::linear(label, unit) }
    }
}

/// A series of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Its points, in drawing order.
    pub points: Vec<PlotPoint>,
}

/// A point of a plot, with the ends of its error bar, if any.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlotPoint {
    /// Horizontal value.
    pub x: f64,
    /// Vertical value.
    pub y: f64,
    /// Lower end of the error bar.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub low: Option<f64>,
    /// Upper end of the error bar.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub high: Option<f64>,
}

impl PlotPoint {
    /// A point without error bar.
    pub fn at(x: f64, y: f64) -> Self {
        PlotPoint { x, y, low: None, high: None }
    }

    /// The mean of a sample, with a bar of one standard deviation to either side.
    pub fn of(x: f64, mean_and_deviation: impl Into<(f64, f64)>) -> Self {
        let (y, deviation) = mean_and_deviation.into();
        PlotPoint { x, y, low: Some(y - deviation), high: Some(y + deviation) }
    }
}

impl Plot {
    /// The plot as an `svg` element; `None` if nothing in it can be drawn.
    pub fn svg(&self) -> Option<String> {
        let places = |p: &PlotPoint| {
            (!self.x.log || p.x > 0.0) && (!self.y.log || p.y > 0.0) && p.x.is_finite() && p.y.is_finite()
        };
        let mut plot = self.clone();
        for series in &mut plot.series {
            series.points.retain(places);
        }
        plot.series.retain(|s| !s.points.is_empty());
        let points = || plot.series.iter().flat_map(|s| &s.points);
        let ends = points().flat_map(|p| [Some(p.y), p.low, p.high]).flatten().filter(|v| !plot.y.log || *v > 0.0);
        let bars = plot.kind == PlotKind::Bars;
        let y = Scale::new(ends.chain(bars.then_some(0.0).filter(|_| !plot.y.log)), plot.y.log)?;
        let x = if bars {
            Scale::exact(-0.5, plot.categories.len() as f64 - 0.5)
        } else {
            Scale::new(points().map(|p| p.x), plot.x.log)?
        };
        let columns = legend_columns(&plot.series);
        let top = 14.0 + LEGEND_ROW * plot.series.len().div_ceil(columns) as f64;
        let bottom = top + PLOT_HEIGHT;
        let frame = Frame { x, y, across: (LEFT, RIGHT), down: (top, bottom) };
        let labels = if bars { wrapped(&plot.categories) } else { Vec::new() };
        let lines = labels.iter().map(Vec::len).max().unwrap_or(1).max(1);
        let height = bottom + 34.0 + LABEL_LINE * lines as f64;
        let mut drawing = Drawing::new(WIDTH, height, &plot.title);
        legend(&mut drawing, &plot.series, columns);
        frame.y_ticks(&mut drawing);
        if bars {
            categories(&mut drawing, &frame, &labels);
        } else {
            frame.x_ticks(&mut drawing);
        }
        frame.ends(&mut drawing);
        drawing.text(((LEFT + RIGHT) / 2.0, height - 6.0), Anchor::Middle, plot.x.heading());
        drawing.upward_text((16.0, (top + bottom) / 2.0), plot.y.heading());
        for (k, series) in plot.series.iter().enumerate() {
            let color = COLORS[k % COLORS.len()];
            match plot.kind {
                PlotKind::Lines => line(&mut drawing, &frame, series, color),
                PlotKind::Bars => bar(&mut drawing, &frame, series, (k, plot.series.len())),
                PlotKind::Scatter => scatter(&mut drawing, &frame, series, color),
            }
        }
        Some(drawing.finish())
    }
}

/// As many legend columns as the longest name allows.
fn legend_columns(series: &[Series]) -> usize {
    let longest = series.iter().map(|s| s.name.chars().count()).max().unwrap_or(0) as f64;
    (((RIGHT - LEFT) / (30.0 + 6.6 * longest)) as usize).clamp(1, series.len().max(1))
}

fn legend(to: &mut Drawing, series: &[Series], columns: usize) {
    let width = (RIGHT - LEFT) / columns as f64;
    for (k, s) in series.iter().enumerate() {
        let (x, y) = (LEFT + width * (k % columns) as f64, 12.0 + LEGEND_ROW * (k / columns) as f64);
        to.rectangle((x, y - 6.0), (14.0, 5.0), COLORS[k % COLORS.len()]);
        to.text((x + 20.0, y), Anchor::Start, &s.name);
    }
}

/// The names of the categories, broken into lines that fit the width of a category.
fn wrapped(categories: &[String]) -> Vec<Vec<String>> {
    let room = ((RIGHT - LEFT) / categories.len().max(1) as f64 / 6.4) as usize;
    let lines_of = |name: &String| {
        let mut lines: Vec<String> = Vec::new();
        for word in name.split(' ') {
            match lines.last_mut().filter(|line| line.chars().count() + 1 + word.chars().count() <= room) {
                Some(line) => {
                    line.push(' ');
                    line.push_str(word);
                }
                None => lines.push(word.to_owned()),
            }
        }
        lines
    };
    categories.iter().map(lines_of).collect()
}

fn categories(to: &mut Drawing, frame: &Frame, labels: &[Vec<String>]) {
    for (k, lines) in labels.iter().enumerate() {
        for (row, line) in lines.iter().enumerate() {
            let place = (frame.x(k as f64), frame.down.1 + 18.0 + LABEL_LINE * row as f64);
            to.text(place, Anchor::Middle, line);
        }
    }
}

fn line(to: &mut Drawing, frame: &Frame, series: &Series, color: &str) {
    frame.line(to, series.points.iter().map(|p| (p.x, p.y)), color);
    // Markers on a long trace would hide the line.
    if series.points.len() <= 20 {
        scatter(to, frame, series, color);
    }
}

fn scatter(to: &mut Drawing, frame: &Frame, series: &Series, color: &str) {
    for p in &series.points {
        if let (Some(low), Some(high)) = (p.low, p.high) {
            frame.whisker(to, frame.x(p.x), (low, high), color);
        }
        to.disc((frame.x(p.x), frame.y(p.y)), 3.5, color);
    }
}

/// The bars of series `k` of `n`, side by side in each category.
fn bar(to: &mut Drawing, frame: &Frame, series: &Series, (k, n): (usize, usize)) {
    let slot = (frame.x(1.0) - frame.x(0.0)) * 0.8;
    let width = (slot / n as f64).min(60.0);
    let inner = (width - 2.0).max(1.0);
    for p in &series.points {
        let x = frame.x(p.x) + width * (k as f64 - n as f64 / 2.0);
        let (y, zero) = (frame.y(p.y), if frame.y.is_log() { frame.down.1 } else { frame.y(0.0) });
        to.rectangle((x, y.min(zero)), (inner, (zero - y).abs()), COLORS[k % COLORS.len()]);
        if let (Some(low), Some(high)) = (p.low, p.high) {
            frame.whisker(to, x + inner / 2.0, (low, high), "#333333");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(kind: PlotKind, points: Vec<PlotPoint>) -> Plot {
        Plot {
            title: "a < b".to_owned(),
            kind,
            x: Axis::linear("size", "vertices"),
            y: Axis::logarithmic("time", "s"),
            categories: vec!["one".to_owned(), "two".to_owned()],
            series: vec![Series { name: "this & that".to_owned(), points }],
        }
    }

    #[test]
    fn every_kind_draws_its_points_and_escapes_its_text() {
        let points = vec![PlotPoint::at(0.0, 0.1), PlotPoint { x: 1.0, y: 30.0, low: Some(20.0), high: Some(40.0) }];
        for (kind, mark) in [(PlotKind::Lines, "<circle"), (PlotKind::Bars, "<rect"), (PlotKind::Scatter, "<circle")] {
            let text = plot(kind, points.clone()).svg().unwrap();
            assert!(text.matches(mark).count() >= 2, "{text}");
            assert!(text.contains("a &lt; b") && text.contains("this &amp; that") && text.contains("time (s)"));
            assert!(!text.contains("NaN") && !text.contains("inf"));
        }
    }

    #[test]
    fn values_without_a_logarithm_are_left_out() {
        assert_eq!(plot(PlotKind::Lines, vec![PlotPoint::at(0.0, 0.0)]).svg(), None);
        assert_eq!(plot(PlotKind::Lines, vec![]).svg(), None);
    }
}
