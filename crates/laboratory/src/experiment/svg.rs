//! Plots as SVG text: lines with error bars, bars, scatter.
//!
//! No plotting library is used: only three kinds of plot are needed, the text must use the fonts of the page, and equal
//! numbers must give equal bytes.

use super::document::{Axis, Plot, PlotKind, Series, with_unit};
use super::scale::{Scale, tick_label};
use std::fmt::Write;

const WIDTH: f64 = 720.0;
const LEFT: f64 = 72.0;
const RIGHT: f64 = 708.0;
const PLOT_HEIGHT: f64 = 260.0;
const LEGEND_ROW: f64 = 20.0;
const LABEL_LINE: f64 = 15.0;
/// Colors distinguishable with most kinds of color vision (Okabe, Ito 2008), without yellow, which is hard to see on
/// white; then three that differ in lightness, for plots of many series.
const COLORS: [&str; 10] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#444444", "#7b3294", "#8c510a", "#a0a0a0"];

/// Text escaped for HTML content and attributes.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The frame of a plot on the page.
struct Frame {
    x: Scale,
    y: Scale,
    top: f64,
    bottom: f64,
}

impl Frame {
    fn x(&self, value: f64) -> f64 {
        LEFT + (RIGHT - LEFT) * self.x.place(value)
    }

    fn y(&self, value: f64) -> f64 {
        self.bottom - (self.bottom - self.top) * self.y.place(value)
    }
}

/// The plot as an `svg` element; `None` if nothing in it can be drawn.
pub(super) fn svg(plot: &Plot) -> Option<String> {
    let drawn = |x: f64, y: f64| (!plot.x.log || x > 0.0) && (!plot.y.log || y > 0.0) && x.is_finite() && y.is_finite();
    let mut plot = plot.clone();
    for series in &mut plot.series {
        series.points.retain(|p| drawn(p.x, p.y));
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
    let frame = Frame { x, y, top, bottom: top + PLOT_HEIGHT };
    let labels = if bars { wrapped(&plot.categories) } else { Vec::new() };
    let lines = labels.iter().map(Vec::len).max().unwrap_or(1).max(1);
    let height = frame.bottom + 34.0 + LABEL_LINE * lines as f64;
    let mut out = String::new();
    let title = escaped(&plot.title);
    // Writing to a string cannot fail, here and below.
    let _ = writeln!(
        out,
        "<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"{title}\" xmlns=\"http://www.w3.org/2000/svg\">"
    );
    legend(&mut out, &plot.series, columns);
    axes(&mut out, &plot, &frame, &labels);
    axis_labels(&mut out, &plot, &frame, height);
    for (k, series) in plot.series.iter().enumerate() {
        let color = COLORS[k % COLORS.len()];
        match plot.kind {
            PlotKind::Lines => line(&mut out, &frame, series, color),
            PlotKind::Bars => bar(&mut out, &frame, series, color, k, plot.series.len()),
            PlotKind::Scatter => scatter(&mut out, &frame, series, color),
        }
    }
    out.push_str("</svg>\n");
    Some(out)
}

/// As many legend columns as the longest name allows.
fn legend_columns(series: &[Series]) -> usize {
    let longest = series.iter().map(|s| s.name.chars().count()).max().unwrap_or(0) as f64;
    (((RIGHT - LEFT) / (30.0 + 6.6 * longest)) as usize).clamp(1, series.len().max(1))
}

fn legend(out: &mut String, series: &[Series], columns: usize) {
    let width = (RIGHT - LEFT) / columns as f64;
    for (k, s) in series.iter().enumerate() {
        let (x, y) = (LEFT + width * (k % columns) as f64, 12.0 + LEGEND_ROW * (k / columns) as f64);
        let color = COLORS[k % COLORS.len()];
        let _ = writeln!(out, "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"14\" height=\"5\" fill=\"{color}\"/>", y - 6.0);
        let _ = writeln!(out, "<text x=\"{:.1}\" y=\"{y:.1}\">{}</text>", x + 20.0, escaped(&s.name));
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

fn axes(out: &mut String, plot: &Plot, frame: &Frame, labels: &[Vec<String>]) {
    let (top, bottom) = (frame.top, frame.bottom);
    for tick in frame.y.ticks() {
        let y = frame.y(tick);
        let label = tick_label(tick, &frame.y);
        let _ = writeln!(out, "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{RIGHT}\"/>");
        let _ = writeln!(out, "<text class=\"y\" x=\"{:.1}\" y=\"{:.1}\">{label}</text>", LEFT - 8.0, y + 4.0);
    }
    if plot.kind == PlotKind::Bars {
        for (k, lines) in labels.iter().enumerate() {
            for (row, line) in lines.iter().enumerate() {
                let (x, y) = (frame.x(k as f64), bottom + 18.0 + LABEL_LINE * row as f64);
                let _ = writeln!(out, "<text class=\"x\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escaped(line));
            }
        }
    } else {
        for tick in frame.x.ticks() {
            let (x, label) = (frame.x(tick), tick_label(tick, &frame.x));
            let _ = writeln!(out, "<path class=\"grid\" d=\"M{x:.1} {top}V{bottom}\"/>");
            let _ = writeln!(out, "<text class=\"x\" x=\"{x:.1}\" y=\"{:.1}\">{label}</text>", bottom + 18.0);
        }
    }
    let _ = writeln!(out, "<path class=\"axis\" d=\"M{LEFT} {top}V{bottom}H{RIGHT}\"/>");
}

fn axis_labels(out: &mut String, plot: &Plot, frame: &Frame, height: f64) {
    let label = |axis: &Axis| escaped(&with_unit(&axis.label, axis.unit.as_deref()));
    let (middle, center) = ((LEFT + RIGHT) / 2.0, (frame.top + frame.bottom) / 2.0);
    let _ = writeln!(out, "<text class=\"x\" x=\"{middle}\" y=\"{:.1}\">{}</text>", height - 6.0, label(&plot.x));
    let _ = writeln!(
        out,
        "<text class=\"x\" transform=\"translate(16 {center:.1}) rotate(-90)\">{}</text>",
        label(&plot.y)
    );
}

/// An error bar, in page coordinates.
fn whisker(out: &mut String, frame: &Frame, x: f64, low: f64, high: f64, color: &str) {
    let (low, high) = (frame.y(low).clamp(frame.top, frame.bottom), frame.y(high).clamp(frame.top, frame.bottom));
    let (left, right) = (x - 4.0, x + 4.0);
    let _ = writeln!(
        out,
        "<path d=\"M{x:.1} {low:.1}V{high:.1}M{left:.1} {low:.1}H{right:.1}M{left:.1} {high:.1}H{right:.1}\" \
         stroke=\"{color}\" fill=\"none\"/>"
    );
}

fn line(out: &mut String, frame: &Frame, series: &Series, color: &str) {
    let mut path = String::new();
    for (k, p) in series.points.iter().enumerate() {
        let _ = write!(path, "{}{:.1} {:.1}", if k == 0 { 'M' } else { 'L' }, frame.x(p.x), frame.y(p.y));
    }
    let _ = writeln!(out, "<path d=\"{path}\" stroke=\"{color}\" stroke-width=\"2\" fill=\"none\"/>");
    // Markers on a long trace would hide the line.
    if series.points.len() <= 20 {
        scatter(out, frame, series, color);
    }
}

fn scatter(out: &mut String, frame: &Frame, series: &Series, color: &str) {
    for p in &series.points {
        let (x, y) = (frame.x(p.x), frame.y(p.y));
        if let (Some(low), Some(high)) = (p.low, p.high) {
            whisker(out, frame, x, low, high, color);
        }
        let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"{color}\"/>");
    }
}

fn bar(out: &mut String, frame: &Frame, series: &Series, color: &str, k: usize, n: usize) {
    let slot = (frame.x(1.0) - frame.x(0.0)) * 0.8;
    let width = (slot / n as f64).min(60.0);
    for p in &series.points {
        let x = frame.x(p.x) + width * (k as f64 - n as f64 / 2.0);
        let (y, zero) = (frame.y(p.y), if frame.y.is_log() { frame.bottom } else { frame.y(0.0) });
        let (upper, height) = (y.min(zero), (zero - y).abs());
        let inner = (width - 2.0).max(1.0);
        let _ = writeln!(
            out,
            "<rect x=\"{x:.1}\" y=\"{upper:.1}\" width=\"{inner:.1}\" height=\"{height:.1}\" fill=\"{color}\"/>"
        );
        if let (Some(low), Some(high)) = (p.low, p.high) {
            whisker(out, frame, x + inner / 2.0, low, high, "#333333");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::document::PlotPoint;

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
            let text = svg(&plot(kind, points.clone())).unwrap();
            assert!(text.matches(mark).count() >= 2, "{text}");
            assert!(text.contains("a &lt; b") && text.contains("this &amp; that") && text.contains("time (s)"));
            assert!(!text.contains("NaN") && !text.contains("inf"));
        }
    }

    #[test]
    fn values_without_a_logarithm_are_left_out() {
        assert_eq!(svg(&plot(PlotKind::Lines, vec![PlotPoint::at(0.0, 0.0)])), None);
        assert_eq!(svg(&plot(PlotKind::Lines, vec![])), None);
    }
}
