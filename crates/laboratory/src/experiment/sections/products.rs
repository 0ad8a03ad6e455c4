//! Max-product against sum-product.

use super::{About, Body, Experiment, MATCHED, PARTS, WITHIN_1, match_tables, on, pairs_of, range, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::Results;
use crate::experiment::study::{REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Products;

fn settings() -> Vec<Setting> {
    let mut all = Vec::new();
    for (name, mode) in [("without clamping", "none"), ("with soft clamping", "soft")] {
        for (product, algorithm) in [("max-product", "max_product"), ("sum-product", "sum_product")] {
            let request = json!({"inference": {"algorithm": algorithm}, "clamping": {"mode": mode}});
            all.push((format!("{product} {name}"), request));
        }
    }
    all
}

impl Experiment for Products {
    fn about(&self) -> About {
        About {
            id: "products",
            title: "Max-product against sum-product",
            question: "Do max-product messages (minimum energy) give better correspondences than sum-product messages (marginals)?",
            varied: "The messages of belief propagation, with and without soft clamping; everything else as in the default \
                     method.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = study.matches(&study.phantoms(8), &settings());
        units.extend(study.matches(&study.real(6), &settings()));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                on("synthetic", range(&synthetic, &WITHIN_1, true)),
                on("real", range(&real, &PARTS, true)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: match_tables(results, "messages"),
            plots: vec![Plot {
                title: "Phantoms: correct match rate within one edge".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("messages", ""),
                y: Axis::linear("within 1 edge", "%"),
                categories: synthetic.categories(),
                series: vec![synthetic.bars("mean ± standard deviation", &WITHIN_1)],
            }],
        }
    }
}
