//! Max-product compared with sum-product.

use super::{About, Body, Experiment, WITHIN_1, both_kinds, matched};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::results::Results;
use crate::experiment::study::{SYNTHETIC, Setting, Study};
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
            title: "Max-product versus sum-product",
            question: "Do max-product messages (minimum energy) give better correspondences than sum-product messages (marginals)?",
            varied: "The messages of belief propagation, with and without soft clamping; everything else as in the default \
                     method.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        both_kinds(study, &settings())
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let synthetic = results.group(SYNTHETIC);
        let plot = Plot {
            title: "Phantoms: correct match rate within one edge".to_owned(),
            kind: PlotKind::Bars,
            x: Axis::linear("messages", ""),
            y: Axis::linear("within 1 edge", "%"),
            categories: synthetic.categories(),
            series: vec![synthetic.bars("mean ± standard deviation", &WITHIN_1)],
        };
        matched(study, results, "messages", plot)
    }
}
