//! Robustness to noise on the vertices, which curvature amplifies.

use super::{About, Body, Experiment, MATCHED, WITHIN_1, match_tables, mean, pairs_of, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::measure::measure_match;
use crate::experiment::results::Results;
use crate::experiment::study::{SYNTHETIC, Study};
use crate::experiment::units::Unit;
use serde_json::{Value, json};

pub(in crate::experiment) struct Noise;

/// Standard deviations of the noise, in percent of the diagonal.
const LEVELS: [f64; 6] = [0.0, 0.1, 0.25, 0.5, 1.0, 2.0];

fn name(scales: &str, level: f64) -> String {
    format!("{scales}, noise {level} %")
}

fn level_of(scales: &str, setting: &str) -> Option<f64> {
    LEVELS.into_iter().find(|&level| name(scales, level) == setting)
}

fn features() -> [(&'static str, Value); 2] {
    let request = |scales: &[f64]| {
        let feature = |kind: &str| json!({"kind": kind, "scales_mm": scales});
        json!({"features": [feature("gaussian_curvature"), feature("mean_curvature")]})
    };
    [("no smoothing", request(&[0.0])), ("three scales", request(&[1.4, 2.8, 4.5]))]
}

impl Experiment for Noise {
    fn about(&self) -> About {
        About {
            id: "noise",
            title: "Robustness to vertex noise",
            question: "How robust is the correspondence to noise on the vertices, and does the scale space help?",
            varied: "Isotropic Gaussian noise on every vertex of both surfaces (standard deviation per axis, in percent of \
                     the diagonal of the bounding box), and the curvature scales (no smoothing, or σ = 1.4, 2.8 and \
                     4.5 mm); everything else as in the default method.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for (scales, request) in features() {
            for level in study.either(vec![0.0, 0.5, 2.0], LEVELS.to_vec()) {
                for case in study.phantoms_with(6, study.edge_mm(), level / 100.0) {
                    let of = request.clone();
                    let work = move |pair: &_| measure_match(pair, &of, study.clock);
                    units.push(study.unit(&case, &name(scales, level), request.clone(), work));
                }
            }
        }
        units
    }

    fn report(&self, _study: &Study<'_>, results: &Results) -> Body {
        let group = results.group(SYNTHETIC);
        let series = features().map(|(scales, _)| group.series(scales, &WITHIN_1, |s| level_of(scales, s)));
        let finding = || {
            let at = |scales, level| mean(&group, &name(scales, level), &WITHIN_1);
            Some(format!(
                "With three scales the correct match rate within one edge was {} without noise, {} at 0.5 % and {} at 2 % \
                 noise; without smoothing {}, {} and {}.",
                at("three scales", 0.0)?,
                at("three scales", 0.5)?,
                at("three scales", 2.0)?,
                at("no smoothing", 0.0)?,
                at("no smoothing", 0.5)?,
                at("no smoothing", 2.0)?,
            ))
        };
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([finding()]),
            tables: match_tables(results, "scales and noise level"),
            plots: vec![Plot {
                title: "Correct match rate within one edge versus noise".to_owned(),
                kind: PlotKind::Lines,
                x: Axis::linear("noise, percent of the diagonal", "%"),
                y: Axis::linear("within 1 edge", "%"),
                categories: Vec::new(),
                series: series.into(),
            }],
            ..Body::default()
        }
    }
}
