//! Neighborhood radius: the largest distance between the images of adjacent vertices.

use super::{About, Body, Experiment, WITHIN_1, WITHIN_2, both_kinds, matched, rate_series};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::Results;
use crate::experiment::study::{Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Neighborhood;

fn settings() -> Vec<Setting> {
    let free = json!({"mode": "none"});
    let mut all: Vec<Setting> =
        (1..=4).map(|r| (format!("r = {r}"), json!({"energy": {"neighborhood_rings": r}, "clamping": free}))).collect();
    for r in [1, 2] {
        let energy = json!({"neighborhood_rings": r, "truncation": null});
        all.push((format!("r = {r}, hard"), json!({"energy": energy, "clamping": free})));
    }
    all
}

/// The radius in the name of a setting with the truncated potential.
fn radius(setting: &str) -> Option<f64> {
    setting.strip_prefix("r = ")?.parse().ok()
}

impl Experiment for Neighborhood {
    fn about(&self) -> About {
        About {
            id: "neighborhood",
            title: "Neighborhood radius",
            question: "How far apart, in edges, may the images of adjacent vertices lie before the pairwise potential is truncated?",
            varied: "The radius r in edges, with the truncated potential and with the hard constraint of the thesis (infinite \
                     truncation); clamping is off, so that the energy alone determines the result.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        both_kinds(study, &settings())
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let plot = Plot {
            title: "Correct match rate and label agreement versus neighborhood radius".to_owned(),
            kind: PlotKind::Lines,
            x: Axis::linear("radius r", "edges"),
            y: Axis::linear("share of vertices", "%"),
            categories: Vec::new(),
            series: rate_series(results, &[WITHIN_1, WITHIN_2], radius),
        };
        matched(study, results, "neighborhood", plot)
    }
}
