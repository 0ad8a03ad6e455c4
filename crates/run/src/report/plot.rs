//! The energy over the iterations.

use crate::plot::{Anchor, COLORS, Drawing, Frame, Scale};
use homolog_primitives::observe::{Phase, Quantity, TracePoint};

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 250.0;
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
    // The initial energy is at 0, or the first iteration at 1.
    let offset = usize::from(initial.is_some());
    let number = |k: usize| (k + 1 - offset) as f64;
    let frame = Frame {
        x: Scale::counts(1 - offset as u32, u32::try_from(iterations.len()).unwrap_or(u32::MAX)),
        y: Scale::new(values.iter().copied(), logarithmic)?,
        across: (76.0, 744.0),
        down: (26.0, 200.0),
    };
    let mut drawing = Drawing::new(WIDTH, HEIGHT, "Energy over iterations");
    let kind = if logarithmic { "; logarithmic axis" } else { "" };
    let about = format!("lowest {low:.2}, highest {high:.2}; dashed: a new round{kind}");
    drawing.text((frame.across.0, 14.0), Anchor::Start, about);
    frame.axes(&mut drawing);
    drawing.text(((frame.across.0 + frame.across.1) / 2.0, HEIGHT - 8.0), Anchor::Middle, "iterations");
    drawing.upward_text((14.0, (frame.down.0 + frame.down.1) / 2.0), "energy");
    let every = values.len().div_ceil(MOST_POINTS).max(1);
    let begins = |k: usize| k > offset && iterations[k - offset].1 != iterations[k - offset - 1].1;
    let mut first = 0;
    for end in (1..=values.len()).filter(|&end| end == values.len() || begins(end)) {
        if first > 0 {
            frame.divide(&mut drawing, number(first));
        }
        let shown = (first..end).filter(|&k| k == first || k % every == 0 || k + 1 == values.len());
        frame.line(&mut drawing, shown.map(|k| (number(k), values[k])), COLORS[0]);
        first = end;
    }
    Some(drawing.finish())
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
        assert!(svg.contains("lowest 2.00, highest 100.00") && svg.contains("logarithmic"), "{svg}");
        let curves: Vec<&str> = svg.lines().filter(|line| line.contains(COLORS[0])).collect();
        assert_eq!(curves.len(), 2, "rounds are not joined: {svg}");
        assert_eq!(curves.iter().map(|curve| curve.matches(['M', 'L']).count()).sum::<usize>(), 3, "{svg}");
        let starts = TracePoint { quantity: Some(Quantity::MeanIsometryEnergy), ..point(0, Phase::Inference, 3.0) };
        assert_eq!(energy_plot(Some(1.0), Phase::Inference, &[starts]), None);
        assert_eq!(energy_plot(Some(1.0), Phase::Inference, &trace[3..]), None);
        assert_eq!(energy_plot(None, Phase::Displacement, &trace), None);
        let fits = [0, 0, 1].map(|round| point(round, Phase::Displacement, 3.0 - f64::from(round)));
        let svg = energy_plot(None, Phase::Displacement, &fits).unwrap();
        assert_eq!(svg.matches("stroke-dasharray").count(), 1);
        assert!(svg.contains("lowest 2.00, highest 3.00"), "{svg}");
    }
}
