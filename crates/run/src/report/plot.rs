//! The energy over the iterations as SVG.

use homolog_primitives::observe::{Phase, Quantity, TracePoint};
use std::fmt::Write;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 240.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 750.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 205.0;
/// Largest number of points of the curve: more than the page has pixels.
const MOST_POINTS: usize = 1500;

/// The energies of the iterations in `phase`, after `initial`; `None` without two finite values. Points of different
/// rounds or starts are not joined. Means of starts are left out, because they are a different quantity. The axis is
/// logarithmic if all values are positive and the largest is more than ten times the smallest.
pub(super) fn energy_plot(initial: Option<f64>, phase: Phase, trace: &[TracePoint]) -> Option<String> {
    let iterations: Vec<(f64, (u32, Option<u32>))> = trace
        .iter()
        .filter(|point| point.phase == phase && point.quantity != Some(Quantity::MeanIsometryEnergy))
        .filter_map(|point| Some((point.energy?, (point.round, point.start))))
        .filter(|(energy, _)| energy.is_finite())
        .collect();
    let initial = initial.filter(|energy| energy.is_finite());
    let values: Vec<f64> = initial.into_iter().chain(iterations.iter().map(|(energy, _)| *energy)).collect();
    if iterations.is_empty() || values.len() < 2 {
        return None;
    }
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let logarithmic = low > 0.0 && high > 10.0 * low;
    let scale = |v: f64| if logarithmic { v.ln() } else { v };
    let span = if high > low { scale(high) - scale(low) } else { 1.0 };
    let x = |k: usize| LEFT + (RIGHT - LEFT) * k as f64 / (values.len() - 1).max(1) as f64;
    let y = |v: f64| BOTTOM - (BOTTOM - TOP) * (scale(v) - scale(low)) / span;
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"Energy over iterations\">\
         <path d=\"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}\" fill=\"none\" stroke=\"#9aa4b1\"/>"
    );
    let steps = values.len().div_ceil(MOST_POINTS).max(1);
    let mut curve = String::new();
    let offset = usize::from(initial.is_some());
    let begins_series = |k: usize| k > offset && iterations[k - offset].1 != iterations[k - offset - 1].1;
    for (k, &value) in values.iter().enumerate() {
        let begins = begins_series(k);
        if begins || k % steps == 0 || k + 1 == values.len() {
            let _ = write!(curve, "{}{:.1} {:.1}", if k == 0 || begins { "M" } else { "L" }, x(k), y(value));
        }
    }
    for (k, pair) in iterations.windows(2).enumerate() {
        if pair[0].1 != pair[1].1 {
            let at = x(k + offset);
            let _ = write!(svg, "<path d=\"M{at:.1} {TOP}V{BOTTOM}\" stroke=\"#c3cad3\" stroke-dasharray=\"4 4\"/>");
        }
    }
    let _ = write!(svg, "<path d=\"{curve}\" fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\"/>");
    let kind = if logarithmic { ", logarithmic axis" } else { "" };
    let _ = write!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{high:.2}</text><text x=\"{}\" y=\"{BOTTOM}\" \
         text-anchor=\"end\">{low:.2}</text><text x=\"{LEFT}\" y=\"{}\">iterations; dashed: a new round{kind}</text>\
         <text x=\"{RIGHT}\" y=\"{}\" text-anchor=\"end\">{}</text></svg>",
        LEFT - 6.0,
        TOP + 8.0,
        LEFT - 6.0,
        BOTTOM + 20.0,
        BOTTOM + 20.0,
        iterations.len()
    );
    Some(svg)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(round: u32, phase: Phase, energy: f64) -> TracePoint {
        let mut point = TracePoint::new(round, phase, 1);
        point.energy = Some(energy);
        point
    }

    #[test]
    fn the_curve_has_the_iterations_alone_and_a_line_for_each_further_round() {
        let trace = [
            point(0, Phase::Inference, 50.0),
            point(0, Phase::Registration, 50.0),
            point(1, Phase::Inference, 2.0),
            point(1, Phase::Displacement, 9.0),
        ];
        let svg = energy_plot(Some(100.0), Phase::Inference, &trace).unwrap();
        assert_eq!(svg.matches("stroke-dasharray").count(), 1);
        assert!(svg.contains(">100.00<") && svg.contains(">2.00<") && svg.contains("logarithmic"), "{svg}");
        let curve = svg.split("<path d=\"").nth(3).unwrap();
        assert_eq!(curve.split('"').next().unwrap().matches(['M', 'L']).count(), 3, "{curve}");
        assert_eq!(curve.split('"').next().unwrap().matches('M').count(), 2, "rounds are not joined: {curve}");
        let starts = TracePoint { quantity: Some(Quantity::MeanIsometryEnergy), ..point(0, Phase::Inference, 3.0) };
        assert_eq!(energy_plot(Some(1.0), Phase::Inference, &[starts]), None);
        assert_eq!(energy_plot(Some(1.0), Phase::Inference, &trace[3..]), None);
        assert_eq!(energy_plot(None, Phase::Displacement, &trace), None);
        let fits = [0, 0, 1].map(|round| point(round, Phase::Displacement, 3.0 - f64::from(round)));
        let svg = energy_plot(None, Phase::Displacement, &fits).unwrap();
        assert_eq!(svg.matches("stroke-dasharray").count(), 1);
        assert!(svg.contains(">3.00<") && svg.contains(">2.00<"), "{svg}");
    }
}
