//! The plots of the page, which are also files of their own.

use super::signed;
use crate::findings::WholeEffect;
use crate::model::ModelQuality;
use homolog_run::plot::{Anchor, Drawing, Frame, Scale};

const BLUE: &str = "#2b6cb0";
const WIDTH: f64 = 860.0;

/// Standardized effects with their intervals, one line each.
pub(crate) fn forest(effects: &[WholeEffect]) -> String {
    let ends = effects.iter().flat_map(|whole| whole.effect.g_interval).filter(|g| g.is_finite());
    let reach = ends.fold(0.5, |top: f64, g| top.max(g.abs()));
    let row = 22.0;
    let bottom = 14.0 + row * effects.len() as f64;
    let (x, y) = (Scale::exact(-reach, reach), Scale::exact(0.0, 1.0));
    let frame = Frame { x, y, across: (320.0, 690.0), down: (4.0, bottom) };
    let mut drawing = Drawing::new(WIDTH, bottom + 26.0, "Forest plot of effects");
    frame.x_ticks(&mut drawing);
    drawing.line([(frame.x(0.0), frame.down.0), (frame.x(0.0), bottom)], "stroke=\"#5b6675\"");
    for (k, whole) in effects.iter().enumerate() {
        let y = 16.0 + row * k as f64;
        let ([low, high], g) = (whole.effect.g_interval, whole.effect.g);
        let at = |g: f64| frame.x(g).clamp(frame.across.0, frame.across.1);
        drawing.text((0.0, y + 4.0), Anchor::Start, format!("{}, {}", whole.variable, whole.contrast));
        drawing.line([(at(low), y), (at(high), y)], "stroke=\"#1c2430\" stroke-width=\"1.5\"");
        drawing.rectangle((at(g) - 3.5, y - 3.5), (7.0, 7.0), BLUE);
        let figures = format!("{} ({} to {})", signed(g, 2), signed(low, 2), signed(high, 2));
        drawing.text((frame.across.1 + 12.0, y + 4.0), Anchor::Start, figures);
    }
    drawing.finish()
}

/// Compactness, generalization and specificity over the number of modes, side by side.
pub(crate) fn model(quality: &ModelQuality) -> String {
    let mut drawing = Drawing::new(WIDTH, 200.0, "Quality of the shape model over its modes");
    let parts = [
        ("compactness", &quality.compactness, Some(1.0)),
        ("generalization, mm", &quality.generalization_mm, None),
        ("specificity, mm", &quality.specificity_mm, None),
    ];
    for (k, (name, values, top)) in parts.into_iter().enumerate() {
        let left = 46.0 + 288.0 * k as f64;
        let ends = values.iter().copied().chain([0.0]).chain(top);
        let Some(y) = Scale::new(ends, false) else { continue };
        let n = u32::try_from(values.len()).unwrap_or(u32::MAX);
        let frame = Frame { x: Scale::counts(1, n), y, across: (left, left + 226.0), down: (30.0, 150.0) };
        drawing.text((left, 18.0), Anchor::Start, name);
        frame.axes(&mut drawing);
        frame.line(&mut drawing, values.iter().enumerate().map(|(k, &value)| ((k + 1) as f64, value)), BLUE);
        drawing.text((left + 113.0, 190.0), Anchor::Middle, format!("{n} modes"));
    }
    drawing.finish()
}
