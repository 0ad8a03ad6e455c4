//! Sparse compared with full message updates.

use super::{About, Body, Experiment, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::measure::{observed_match, studied};
use crate::experiment::pairs::Pair;
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::{SYNTHETIC, Study};
use crate::experiment::units::{Measurement, Unit};
use crate::phantom::DEFAULT_EDGE_MM;
use homolog_matching::{energy_model, match_memory_bytes};
use serde_json::{Value, json};

pub(in crate::experiment) struct Update;

/// Number of timed iterations.
const ITERATIONS: u32 = 5;
/// Number of vertices of a phantom with the default edge length.
const DEFAULT_VERTICES: f64 = 2400.0;

const SPARSE: Metric = Metric::number("sparse_ms", "sparse update", "ms per iteration", 1);
const FULL: Metric = Metric::number("full_ms", "full update", "ms per iteration", 1);

fn request(update: &str, product: &str) -> Value {
    json!({
        "inference": {"algorithm": product, "max_iterations": ITERATIONS, "tolerance": 0.0, "update": update},
        "clamping": {"mode": "none"},
        "registration": {"refine": "none"},
    })
}

/// Both updates on one pair.
fn compare(pair: &Pair, product: &str, study: &Study<'_>) -> Result<Measurement, String> {
    let (sparse, first) = observed_match(pair, &request("sparse", product), study.clock)?;
    let (full, second) = observed_match(pair, &request("full", product), study.clock)?;
    let time =
        |m: &Measurement| m.values.get("inference_seconds").map_or(f64::NAN, |s| 1e3 * s / f64::from(ITERATIONS));
    let pairs = first.correspondences.target.iter().zip(&second.correspondences.target);
    let equal = pairs.filter(|(a, b)| a == b).count() as f64 / first.correspondences.target.len().max(1) as f64;
    let energy = |m: &Measurement| m.values.get("energy_final").copied().unwrap_or(f64::NAN);
    let parameters = studied(&request("sparse", product))?;
    let model = energy_model(&pair.source, &pair.target, &parameters).map_err(|e| e.to_string())?;
    let (n, mib) = (model.n_labels() as f64, f64::from(1 << 20));
    let messages =
        match_memory_bytes((pair.source.n_vertices(), pair.source.n_faces()), pair.target.n_vertices(), &parameters);
    let (sparse_ms, full_ms) = (time(&sparse), time(&full));
    Ok(Measurement::default()
        .with("vertices", pair.source.n_vertices() as f64)
        .with("sparse_ms", sparse_ms)
        .with("full_ms", full_ms)
        .with("ratio", full_ms / sparse_ms)
        .with("equal_labels", equal)
        .with("energy_difference", (energy(&sparse) - energy(&full)).abs())
        .with("messages_mib", messages as f64 / mib)
        // A neighbor is a label and a distance; a stored table of all pairs would have one potential per pair.
        .with("neighbors_mib", 8.0 * n * model.labels.mean_size() / mib)
        .with("pairs_mib", 4.0 * n * n / mib)
        .with("neighbors", model.labels.mean_size()))
}

impl Experiment for Update {
    fn about(&self) -> About {
        About {
            id: "update",
            title: "Sparse versus full update",
            question: "Is the sparse message update (neighboring labels only) equivalent to the full one (all label pairs), and what \
                       does it save?",
            varied: "The update, the messages (max- or sum-product) and the number of vertices; 5 iterations from uniform \
                     messages, time of inference only.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for size in study.either(vec![150u32, 300], vec![150, 300, 500, 750, 1000]) {
            let edge_mm = DEFAULT_EDGE_MM * (DEFAULT_VERTICES / f64::from(size)).sqrt();
            for case in study.phantoms_with(2, edge_mm, 0.0) {
                for (name, product) in [("max-product", "max_product"), ("sum-product", "sum_product")] {
                    let setting = format!("{name}, about {size} vertices");
                    let inputs = json!([request("full", product), size]);
                    units.push(study.unit(&case, &setting, inputs, move |pair| compare(pair, product, study)));
                }
            }
        }
        units
    }

    fn report(&self, _study: &Study<'_>, results: &Results) -> Body {
        let group = results.group(SYNTHETIC);
        let metrics = [
            Metric::number("vertices", "vertices", "", 0),
            SPARSE,
            FULL,
            Metric::number("ratio", "full / sparse", "×", 1),
            Metric::percent("equal_labels", "identical labels"),
            Metric::number("energy_difference", "energy difference", "", 3),
            Metric::number("neighbors", "mean neighborhood size", "", 1),
            Metric::number("messages_mib", "memory of messages", "MiB", 1),
            Metric::number("neighbors_mib", "memory of neighborhoods", "MiB", 2),
            Metric::number("pairs_mib", "memory of a full pairwise table", "MiB", 2),
        ];
        let series = |product: &str, metric: &Metric| {
            let of_product =
                |setting: &str| setting.strip_prefix(product).and_then(|_| group.mean(setting, "vertices"));
            group.series(&format!("{product}, {}", metric.name), metric, of_product)
        };
        let largest = group.configurations().last().copied().unwrap_or_default();
        let finding = || {
            let settings = group.configurations();
            let equal = settings.iter().filter_map(|s| group.mean(s, "equal_labels")).fold(f64::INFINITY, f64::min);
            Some(format!(
                "For {largest}, an iteration took {:.1} ms with the sparse update and {:.1} ms with the full one, {:.0} times \
                 as long; in every setting at least {:.2} % of the labels were identical.",
                group.mean(largest, "sparse_ms")?,
                group.mean(largest, "full_ms")?,
                group.mean(largest, "ratio")?,
                100.0 * equal
            ))
        };
        Body {
            pairs: format!("{} synthetic pairs per size", group.cases().len()),
            finding: sentences([finding()]),
            notes: vec![
                "Both updates store the same messages and no table of potentials; memory is computed from the sizes."
                    .to_owned(),
            ],
            tables: vec![group.table("sizes", "Time, memory and agreement", "update", &metrics)],
            plots: vec![Plot {
                title: "Time per iteration versus number of vertices".to_owned(),
                kind: PlotKind::Lines,
                x: Axis::logarithmic("source vertices", ""),
                y: Axis::logarithmic("time per iteration", "ms"),
                categories: Vec::new(),
                series: vec![
                    series("max-product", &SPARSE),
                    series("max-product", &FULL),
                    series("sum-product", &SPARSE),
                    series("sum-product", &FULL),
                ],
            }],
        }
    }
}
