//! Topology consistency: whether a labeling is a map of surfaces.

use super::{About, Body, CONSISTENCY, Experiment, MATCHED, WITHIN_1, on, pairs_of, range, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::{COPIES, REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Topology;

const METRICS: [Metric; 5] = [
    CONSISTENCY,
    Metric::percent("flipped_share", "triangles flipped"),
    Metric::percent("degenerate_share", "triangles without area"),
    Metric::percent("coverage", "target vertices hit"),
    WITHIN_1,
];

/// Consistency is counted with the radius of the energy, which is therefore the same in all.
fn settings() -> Vec<Setting> {
    let free = json!({"mode": "none"});
    vec![
        ("unary alone".to_owned(), json!({"energy": {"truncation": 1e-6}, "clamping": free})),
        ("one iteration".to_owned(), json!({"inference": {"max_iterations": 1}, "clamping": free})),
        ("no clamping".to_owned(), json!({"clamping": free})),
        ("no clamping, distances too".to_owned(), json!({"energy": {"beta": 0.5}, "clamping": free})),
        ("hard clamping".to_owned(), json!({"clamping": {"mode": "hard"}})),
        ("soft clamping".to_owned(), json!({})),
    ]
}

impl Experiment for Topology {
    fn about(&self) -> About {
        About {
            id: "topology",
            title: "Topology consistency",
            question: "Do neighbours stay neighbours, and do triangles keep their side?",
            varied: "What holds neighbours together: nothing (truncation 0), one iteration of messages, all iterations, \
                     differences of distances beside (β = 0.5), hard and soft clamping; two edges count as neighbours.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = study.matches(&study.phantoms(8), &settings());
        units.extend(study.matches(&study.real(6), &settings()));
        units.extend(study.matches(&study.copies(2), &settings()));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
        let kinds =
            [(SYNTHETIC, "Phantoms"), (REAL, "Different real subjects"), (COPIES, "Real subjects and their copies")];
        let tables = kinds.iter().filter(|(group, _)| !results.group(group).is_empty());
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                on("synthetic", range(&synthetic, &CONSISTENCY, true)),
                on("real", range(&real, &CONSISTENCY, true)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: tables
                .map(|(group, title)| results.group(group).table(group, title, "what holds neighbours", &METRICS))
                .collect(),
            plots: vec![Plot {
                title: "Share of edges kept and of target vertices hit, phantoms".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("what holds neighbours", ""),
                y: Axis::linear("share", "%"),
                categories: synthetic.categories(),
                series: vec![
                    synthetic.bars("edges kept", &CONSISTENCY),
                    synthetic.bars("target vertices hit", &METRICS[3]),
                ],
            }],
        }
    }
}
