//! Plots as SVG, without inline styles: the policy of the page allows no style attributes. As files, they stand alone.

use super::{escaped, signed};
use crate::findings::WholeEffect;
use crate::model::ModelQuality;
use std::fmt::Write;

/// A plot of the page as a file of its own.
pub(crate) fn standalone(plot: &str) -> String {
    let svg = plot.split_once("</svg>").map_or(plot, |(svg, _)| svg);
    // `viewBox` is `0 0 width height`.
    let size = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(size, _)| size);
    let (width, height) = size.split_once(' ').unwrap_or(("860", "190"));
    let own = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" \
         font-size=\"12\" fill=\"#5b6675\""
    );
    let ground = format!("><rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    svg.replacen("<svg class=\"plot\"", &own, 1).replacen('>', &ground, 1) + "</svg>\n"
}

/// Standardized effects with their intervals, one line each.
pub(crate) fn forest(effects: &[WholeEffect]) -> String {
    let finite = |x: &f64| x.is_finite();
    let reach = effects
        .iter()
        .flat_map(|whole| whole.effect.g_interval)
        .filter(finite)
        .fold(0.5, |top: f64, x| top.max(x.abs()));
    let (left, width, line) = (330.0, 380.0, 22.0);
    let x = |g: f64| left + width * (0.5 + 0.5 * (g / reach).clamp(-1.0, 1.0));
    let height = 40.0 + line * effects.len() as f64;
    let mut svg =
        format!("<svg class=\"plot\" viewBox=\"0 0 860 {height}\" role=\"img\" aria-label=\"Forest plot of effects\">");
    let bottom = height - 26.0;
    for tick in [-reach, -reach / 2.0, 0.0, reach / 2.0, reach] {
        let (at, stroke) = (x(tick), if tick == 0.0 { "#5b6675" } else { "#d9dee5" });
        let _ = write!(
            svg,
            "<line x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"4\" y2=\"{bottom}\" stroke=\"{stroke}\"/>\
             <text x=\"{at:.1}\" y=\"{:.0}\" text-anchor=\"middle\">{}</text>",
            height - 10.0,
            signed(tick, 2)
        );
    }
    for (k, whole) in effects.iter().enumerate() {
        let y = 16.0 + line * k as f64;
        let [low, high] = whole.effect.g_interval;
        let _ = write!(
            svg,
            "<text x=\"0\" y=\"{:.0}\">{}, {}</text>\
             <line x1=\"{:.1}\" x2=\"{:.1}\" y1=\"{y}\" y2=\"{y}\" stroke=\"#1c2430\" stroke-width=\"1.5\"/>\
             <rect x=\"{:.1}\" y=\"{:.1}\" width=\"7\" height=\"7\" fill=\"#2b6cb0\"/>\
             <text x=\"{:.0}\" y=\"{:.0}\">{} ({} to {})</text>",
            y + 4.0,
            escaped(&whole.variable),
            escaped(&whole.contrast),
            x(low),
            x(high),
            x(whole.effect.g) - 3.5,
            y - 3.5,
            left + width + 12.0,
            y + 4.0,
            signed(whole.effect.g, 2),
            signed(low, 2),
            signed(high, 2)
        );
    }
    svg.push_str("</svg>\n<p class=\"hint\">Hedges' g, the effect over the standard deviation of the residuals, with its 95 % interval.</p>\n");
    svg
}

/// Compactness, generalization and specificity over the number of modes, side by side.
pub(crate) fn model(quality: &ModelQuality) -> String {
    let mut svg = "<svg class=\"plot\" viewBox=\"0 0 860 190\" role=\"img\" aria-label=\"Quality of the shape model over its modes\">".to_owned();
    let parts = [
        ("compactness", &quality.compactness, 1.0),
        ("generalization, mm", &quality.generalization_mm, top(&quality.generalization_mm)),
        ("specificity, mm", &quality.specificity_mm, top(&quality.specificity_mm)),
    ];
    for (k, (name, values, top)) in parts.into_iter().enumerate() {
        let (left, width) = (40.0 + 285.0 * k as f64, 225.0);
        let n = values.len().max(2) as f64;
        let at = |k: usize, value: f64| (left + width * k as f64 / (n - 1.0), 150.0 - 120.0 * value / top);
        let points: Vec<String> =
            values.iter().enumerate().map(|(k, &v)| at(k, v)).map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = write!(
            svg,
            "<text x=\"{left}\" y=\"18\">{name}</text>\
             <path d=\"M{left} 30V150H{:.0}\" fill=\"none\" stroke=\"#b7bfca\"/>\
             <polyline points=\"{}\" fill=\"none\" stroke=\"#2b6cb0\" stroke-width=\"2\"/>\
             <text x=\"{:.0}\" y=\"34\" text-anchor=\"end\">{top:.2}</text>\
             <text x=\"{:.0}\" y=\"154\" text-anchor=\"end\">0</text>\
             <text x=\"{left}\" y=\"168\">1</text><text x=\"{:.0}\" y=\"168\" text-anchor=\"end\">{} modes</text>",
            left + width,
            points.join(" "),
            left - 6.0,
            left - 6.0,
            left + width,
            values.len()
        );
    }
    svg.push_str("</svg>\n");
    svg
}

fn top(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::MIN_POSITIVE, f64::max)
}
