//! The scale at which curvature is computed.

use super::{About, Body, Experiment, WITHIN_1, both_kinds, matched, rate_series};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::Results;
use crate::experiment::study::{Setting, Study};
use crate::experiment::units::Unit;
use serde_json::{Value, json};

pub(in crate::experiment) struct CurvatureScale;

/// Single scales, mm.
const SCALES: [f64; 6] = [0.7, 1.4, 2.0, 2.8, 4.5, 6.0];

fn name(scale_mm: f64) -> String {
    format!("K at {scale_mm} mm")
}

fn settings() -> Vec<Setting> {
    let feature = |kind: &str, scales: &[f64]| json!({"kind": kind, "scales_mm": scales});
    let request = |features: Vec<Value>| json!({"features": features, "clamping": {"mode": "none"}});
    let mut all: Vec<Setting> =
        SCALES.iter().map(|&s| (name(s), request(vec![feature("gaussian_curvature", &[s])]))).collect();
    let three = [1.4, 2.8, 4.5];
    let gaussian = feature("gaussian_curvature", &three);
    let mean = feature("mean_curvature", &three);
    all.push(("K at three scales".to_owned(), request(vec![gaussian.clone()])));
    all.push(("H at three scales".to_owned(), request(vec![mean.clone()])));
    all.push(("K and H at three scales".to_owned(), request(vec![gaussian, mean])));
    all
}

fn scale_of(setting: &str) -> Option<f64> {
    SCALES.into_iter().find(|&s| name(s) == setting)
}

impl Experiment for CurvatureScale {
    fn about(&self) -> About {
        About {
            id: "scale",
            title: "Curvature scale",
            question: "At which scale is curvature most discriminative, and are several scales better than one?",
            varied: "The scales σ of Gaussian curvature K and mean curvature H (heat-flow smoothing of the surface with \
                     standard deviation σ; the three scales are 1.4, 2.8 and 4.5 mm); clamping is off.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        both_kinds(study, &settings())
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let plot = Plot {
            title: "Correct match rate and label agreement versus the scale of Gaussian curvature".to_owned(),
            kind: PlotKind::Lines,
            x: Axis::linear("scale", "mm"),
            y: Axis::linear("share of vertices", "%"),
            categories: Vec::new(),
            series: rate_series(results, &[WITHIN_1], scale_of),
        };
        matched(study, results, "feature", plot)
    }
}
