//! Registration from arbitrary orientation: the presets against first-order ellipsoids and ICP.

use super::{About, Body, Experiment, MATCHED, PARTS, ROTATION, SECONDS, pairs_of, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind, Table};
use crate::experiment::results::{Group, Metric, Results};
use crate::experiment::study::{COPIES, REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Registration;

const WITHIN_10: Metric = Metric::percent("within_10_deg", "within 10°");
const METRICS: [Metric; 6] = [
    WITHIN_10,
    ROTATION,
    Metric::number("surface_mean_mm", "surface distance, mean", "mm", 2),
    Metric::number("surface_p95_mm", "surface distance, 95th percentile", "mm", 2),
    PARTS,
    SECONDS,
];

fn settings(study: &Study<'_>) -> Vec<Setting> {
    let methods: &[&str] = study.either(&["balanced", "foe", "icp"], &["balanced", "thesis", "rigid", "foe", "icp"]);
    methods.iter().map(|&method| (method.to_owned(), json!({"method": method}))).collect()
}

impl Experiment for Registration {
    fn about(&self) -> About {
        About {
            id: "registration",
            title: "Registration from arbitrary orientation",
            question: "Which methods recover the pose of a surface from an arbitrary orientation?",
            varied: "The method: the presets of homolog; first-order ellipsoids (foe); ICP from aligned centroids (icp); ICP \
                     from aligned principal axes (rigid). Every target is rotated by a uniformly random rotation. For \
                     different subjects the reference pose is that of trimmed ICP from the scanner's frame.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let settings = settings(study);
        let mut units = study.matches(&study.phantoms(8), &settings);
        units.extend(study.matches(&study.real(10), &settings));
        units.extend(study.matches(&study.copies(4), &settings));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let kinds = [
            (SYNTHETIC, "Phantoms: deformed, rotated and resampled copies"),
            (REAL, "Pairs of different subjects, target rotated"),
            (COPIES, "Real subjects and their rotated copies"),
        ];
        let present: Vec<_> = kinds.iter().filter(|(group, _)| !results.group(group).is_empty()).collect();
        let table =
            |(group, title): &&(&str, &str)| -> Table { results.group(group).table(group, title, "method", &METRICS) };
        let bars = present.iter().map(|(group, _)| results.group(group).bars(group, &WITHIN_10)).collect();
        let settings: Vec<String> = settings(study).into_iter().map(|(name, _)| name).collect();
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                finding("synthetic", &results.group(SYNTHETIC)),
                finding("real", &results.group(REAL)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: present.iter().map(table).collect(),
            plots: vec![Plot {
                title: "Share of pairs registered within 10° of the reference".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("method", ""),
                y: Axis::linear("within 10°", "%"),
                categories: settings,
                series: without_spread(bars),
            }],
        }
    }
}

/// Removes the standard deviation of a success rate, which adds no information to the rate.
fn without_spread(mut series: Vec<crate::experiment::document::Series>) -> Vec<crate::experiment::document::Series> {
    for point in series.iter_mut().flat_map(|s| &mut s.points) {
        (point.low, point.high) = (None, None);
    }
    series
}

fn finding(kind: &str, group: &Group<'_>) -> Option<String> {
    let of = |method: &str| {
        let n = group.measured(method).len();
        let right = group.mean(method, WITHIN_10.key)? * n as f64;
        let median = group.summary(method, ROTATION.key)?.median;
        Some(format!("{method} {right:.0} of {n} (median error {median:.1}°)"))
    };
    let all: Vec<_> = group.configurations().into_iter().filter_map(of).collect();
    (!all.is_empty()).then(|| format!("Registered within 10° on {kind} pairs: {}.", all.join(", ")))
}
