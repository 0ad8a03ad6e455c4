//! Topological consistency: whether a labeling is a continuous map between surfaces.

use super::{About, Body, CONSISTENCY, Experiment, MATCHED, WITHIN_1, both_kinds, on, pairs_of, range, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::{COPIES, REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Topology;

const METRICS: [Metric; 5] = [
    CONSISTENCY,
    Metric::percent("flipped_share", "flipped triangles"),
    Metric::percent("degenerate_share", "degenerate triangles"),
    Metric::percent("coverage", "coverage of the target"),
    WITHIN_1,
];

/// Consistency is measured with the neighborhood radius of the energy, so all settings use the same radius.
fn settings() -> Vec<Setting> {
    let free = json!({"mode": "none"});
    vec![
        ("unary terms only".to_owned(), json!({"energy": {"truncation": 1e-6}, "clamping": free})),
        ("one iteration".to_owned(), json!({"inference": {"max_iterations": 1}, "clamping": free})),
        ("no clamping".to_owned(), json!({"clamping": free})),
        ("no clamping, β = 0.5".to_owned(), json!({"energy": {"beta": 0.5}, "clamping": free})),
        ("hard clamping".to_owned(), json!({"clamping": {"mode": "hard", "max_rounds": 3}})),
        ("soft clamping".to_owned(), json!({"clamping": {"mode": "soft", "max_rounds": 3}})),
    ]
}

impl Experiment for Topology {
    fn about(&self) -> About {
        About {
            id: "topology",
            title: "Topological consistency",
            question: "Are adjacent vertices mapped to adjacent vertices, and do triangles keep their orientation?",
            varied: "The regularization: none (truncation 0), one iteration of belief propagation, all iterations, an \
                     additional distance term (β = 0.5), hard and soft clamping. Vertices within two edges count as \
                     adjacent.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = both_kinds(study, &settings());
        units.extend(study.matches(&study.copies(2), &settings()));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
        let kinds = [
            (SYNTHETIC, "Phantoms"),
            (REAL, "Pairs of different subjects"),
            (COPIES, "Real subjects and their rotated copies"),
        ];
        let tables = kinds.iter().filter(|(group, _)| !results.group(group).is_empty());
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                on("synthetic", range(&synthetic, &CONSISTENCY, true)),
                on("real", range(&real, &CONSISTENCY, true)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: tables
                .map(|(group, title)| results.group(group).table(group, title, "regularization", &METRICS))
                .collect(),
            plots: vec![Plot {
                title: "Phantoms: edges preserved and coverage of the target".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("regularization", ""),
                y: Axis::linear("share", "%"),
                categories: synthetic.categories(),
                series: vec![
                    synthetic.bars("edges preserved", &CONSISTENCY),
                    synthetic.bars("coverage of the target", &METRICS[3]),
                ],
            }],
        }
    }
}
