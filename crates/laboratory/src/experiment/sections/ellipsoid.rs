//! Limits of first-order ellipsoids: shapes whose principal axes do not determine the pose.

use super::{About, Body, Experiment, INLIERS, ROTATION, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind, Series};
use crate::experiment::measure::{found_pose, observed_match};
use crate::experiment::pairs::Pair;
use crate::experiment::results::{Metric, Results};
use crate::experiment::solids::Form;
use crate::experiment::study::{SOLIDS, Study};
use crate::experiment::units::{Measurement, Unit};
use homolog_registration::principal_axis_poses;
use serde_json::json;

pub(in crate::experiment) struct Ellipsoid;

const METHODS: [(&str, &str); 3] =
    [("first-order ellipsoids", "foe"), ("principal axes and ICP", "rigid"), ("homolog (balanced)", "balanced")];
const WITHIN_10: Metric = Metric::percent("within_10_deg", "within 10°");
const FOLDED: Metric = Metric::percent("folded_within_10_deg", "within 10° modulo axis flips");

fn name(form: Form, method: &str) -> String {
    format!("{}, {method}", form.name())
}

/// The rotation error, and the rotation error modulo half-turns about the principal axes of the shape.
fn measure(pair: &Pair, method: &str, study: &Study<'_>) -> Result<Measurement, String> {
    let (mut m, outcome) = observed_match(pair, &json!({"method": method}), study.clock)?;
    let source = pair.source.vertices();
    let half_turns = principal_axis_poses(source, source).into_iter().flatten();
    if let Some(truth) = &pair.pose {
        let found = found_pose(&outcome);
        let folded =
            half_turns.map(|turn| found.after(&turn).angle_to(truth).to_degrees()).fold(f64::INFINITY, f64::min);
        m.set("folded_error_deg", folded);
        m.set("folded_within_10_deg", f64::from(u8::from(folded <= 10.0)));
    }
    Ok(m)
}

impl Experiment for Ellipsoid {
    fn about(&self) -> About {
        About {
            id: "ellipsoid",
            title: "Limits of first-order ellipsoids",
            question: "For which shapes do the axes of the first-order ellipsoid not determine the pose, and does dense correspondence?",
            varied: "The shape (ellipsoid-like, spindle, near-spherical, near-cubic), each with twelve random bumps of up to \
                     8 % of the radius so that exactly one pose is correct, and the method. Targets are rotated and \
                     resampled copies with twelve additional bumps of up to 2 %.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for form in Form::ALL {
            for case in study.solids(form, 6) {
                for (label, method) in METHODS {
                    let work = move |pair: &Pair| measure(pair, method, study);
                    units.push(study.unit(&case, &name(form, label), json!(method), work));
                }
            }
        }
        units
    }

    fn report(&self, _study: &Study<'_>, results: &Results) -> Body {
        let group = results.group(SOLIDS);
        let folded = Metric::number("folded_error_deg", "rotation error modulo axis flips", "°", 2);
        let metrics = [WITHIN_10, FOLDED, ROTATION, folded, INLIERS];
        let bars = |label: &str, metric: &Metric, word: &str| {
            let place = |setting: &str| Form::ALL.iter().position(|f| name(*f, label) == setting).map(|k| k as f64);
            let mut series: Series = group.series(&format!("{label}{word}"), metric, place);
            for point in &mut series.points {
                (point.low, point.high) = (None, None);
            }
            series
        };
        let finding = || {
            let of = |form: Form, label: &str, metric: &Metric| {
                let setting = name(form, label);
                let n = group.measured(&setting).len() as f64;
                Some((group.mean(&setting, metric.key)? * n).round())
            };
            let sentence = |form: Form| {
                let (foe, ours) = (METHODS[0].0, METHODS[2].0);
                let n = group.measured(&name(form, ours)).len();
                let baseline = match (of(form, foe, &WITHIN_10), of(form, foe, &FOLDED)) {
                    (Some(right), Some(folded)) => format!("{foe} {right} of {n} ({folded} modulo axis flips), "),
                    _ => String::new(),
                };
                Some(format!("{}: {baseline}{ours} {} of {n}", form.name(), of(form, ours, &WITHIN_10)?))
            };
            let all: Vec<_> = Form::ALL.into_iter().filter_map(sentence).collect();
            (!all.is_empty()).then(|| format!("Poses recovered within 10°: {}.", all.join("; ")))
        };
        Body {
            pairs: format!("{} rotated copies of each shape", group.cases().len() / Form::ALL.len().max(1)),
            finding: sentences([finding()]),
            tables: vec![group.table("forms", "Registration by shape and method", "shape and method", &metrics)],
            plots: vec![Plot {
                title: "Share of poses recovered within 10°".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("shape", ""),
                y: Axis::linear("within 10°", "%"),
                categories: Form::ALL.map(|f| f.name().to_owned()).into(),
                series: vec![
                    bars(METHODS[0].0, &FOLDED, ", modulo axis flips"),
                    bars(METHODS[0].0, &WITHIN_10, ""),
                    bars(METHODS[1].0, &WITHIN_10, ""),
                    bars(METHODS[2].0, &WITHIN_10, ""),
                ],
            }],
            notes: Vec::new(),
        }
    }
}
