//! The value of each vertex feature: alone, together, with equal or learned weights.

use super::{About, Body, Experiment, PARTS, WITHIN_2, mean, on, pairs_of, range, sentences};
use crate::experiment::Clock;
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::measure::studied;
use crate::experiment::pairs::Pair;
use crate::experiment::results::{Group, Metric, Results};
use crate::experiment::study::{REAL, SYNTHETIC, Setting, Study, WARPED};
use crate::experiment::units::{Measurement, Unit};
use homolog_contract::parameters::FeatureKind;
use homolog_matching::{Levels, Silent, coarse_energy_model};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_mrf::MrfModel;
use homolog_mrf::inference::{BeliefPropagation, BpOptions, Product};
use nalgebra::Point3;
use rayon::prelude::*;
use serde_json::{Value, json};

pub(in crate::experiment) struct Descriptors;

const DEFAULT: &str = "default (K and H)";
const LEARNED_DEFAULT: &str = "default, learned";
const ALL_EQUAL: &str = "all, equal";
const ALL_LEARNED: &str = "all, learned";
/// Vertices of the coarse levels, as in the default method.
const COARSE: u32 = 400;
/// Iterations of belief propagation.
const ITERATIONS: u32 = 30;

/// Mean share of labels that cost more than the true label: 50 % by chance.
const AUC: Metric = Metric::percent("auc", "labels worse than the true one");
const MEDIAN: Metric = Metric::percent("median_rank", "median rank of the true label");
const NEAREST: Metric = Metric::percent("nearest_within_2_edges", "cheapest label within 2 edges");
const SECONDS: Metric = Metric::number("energy_seconds", "time of the energy", "s", 3);
/// Metrics for pairs whose truth is known at every vertex.
const METRICS: [Metric; 5] = [AUC, MEDIAN, NEAREST, WITHIN_2, SECONDS];

fn settings() -> Vec<Setting> {
    let name = |kind: FeatureKind| kind.name().replace('_', " ");
    let of =
        |features: Vec<Value>, precisions: &str| json!({"features": features, "energy": {"precisions": precisions}});
    let one = |kind: FeatureKind| json!({"kind": kind.name()});
    let curvature = || vec![one(FeatureKind::GaussianCurvature), one(FeatureKind::MeanCurvature)];
    // A request has up to eight features: Gaussian and mean curvature are functions of shape index and curvedness.
    let all = || FeatureKind::ALL[2..].iter().map(|kind| one(*kind)).collect();
    let mut settings: Vec<Setting> =
        vec![(DEFAULT.to_owned(), of(curvature(), "equal")), (LEARNED_DEFAULT.to_owned(), of(curvature(), "learned"))];
    settings.extend(FeatureKind::ALL.map(|kind| (name(kind), of(vec![one(kind)], "equal"))));
    settings.push((ALL_EQUAL.to_owned(), of(all(), "equal")));
    settings.push((ALL_LEARNED.to_owned(), of(all(), "learned")));
    settings
}

/// Measures the energy of the coarse levels of a pair: the rank of the true label, the labeling found by belief
/// propagation, and, if only parts are known, their agreement.
fn measure(pair: &Pair, request: &Value, clock: &Clock) -> Result<Measurement, String> {
    let parameters = studied(request)?;
    let (source, target) = (Levels::new(&pair.source, Some(COARSE)), Levels::new(&pair.target, Some(COARSE)));
    let begin = clock().as_secs_f64();
    let model = coarse_energy_model(&source, &target, &parameters).map_err(|e| e.to_string())?;
    let seconds = clock().as_secs_f64() - begin;
    let options = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 1e-5 };
    let found = BeliefPropagation::new(&model, options).run(ITERATIONS, &Silent, |_| ()).map_err(|e| e.to_string())?;
    let mut m = Measurement::default().with(SECONDS.key, seconds);
    let (variables, labels) = (of_surface(source.energy_mesh(), &pair.source), target.energy_mesh().vertices());
    if let Some(truth) = &pair.truth {
        let images: Vec<Point3<f64>> = variables.iter().map(|&k| truth[k]).collect();
        let near_mm = 2.0 * target.energy_mesh().mean_edge_length();
        let within = |labeling: &dyn Fn(usize) -> usize| {
            let right = images.iter().enumerate().filter(|(i, p)| (labels[labeling(*i)] - **p).norm() <= near_mm);
            right.count() as f64 / images.len() as f64
        };
        let cheapest = |i: usize| {
            let row = model.unary_row(i).iter().enumerate();
            row.min_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(label, _)| label)
        };
        let mut ranks: Vec<f64> = images.par_iter().enumerate().map(|(i, p)| rank(&model, labels, i, p)).collect();
        m.set(AUC.key, 1.0 - ranks.iter().sum::<f64>() / ranks.len() as f64);
        ranks.sort_by(f64::total_cmp);
        m.set(MEDIAN.key, ranks[ranks.len() / 2]);
        m.set(NEAREST.key, within(&cheapest));
        m.set(WITHIN_2.key, within(&|i| found.labeling[i] as usize));
    }
    if let Some((source_parts, target_parts)) = &pair.parts {
        let of_label = of_surface(target.energy_mesh(), &pair.target);
        let part = |label: u32| target_parts[of_label[label as usize]];
        let agree = variables.iter().zip(&found.labeling).filter(|(k, label)| source_parts[**k] == part(**label));
        m.set(PARTS.key, agree.count() as f64 / variables.len() as f64);
    }
    Ok(m)
}

/// For each vertex of a coarse level, its vertex on `surface`.
fn of_surface(coarse: &SurfaceMesh, surface: &SurfaceMesh) -> Vec<usize> {
    let index = ClosestPointIndex::new(surface);
    coarse.vertices().iter().map(|p| index.closest(p).nearest_corner() as usize).collect()
}

/// Share of labels that cost variable `i` less than the label nearest to `truth`; labels of equal cost count half.
fn rank(model: &MrfModel, labels: &[Point3<f64>], i: usize, truth: &Point3<f64>) -> f64 {
    let away = |x: &usize| (labels[*x] - truth).norm_squared();
    let nearest = (0..labels.len()).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(0);
    let row = model.unary_row(i);
    let (mut less, mut same) = (0usize, 0usize);
    for theta in row {
        less += usize::from(*theta < row[nearest]);
        same += usize::from(*theta == row[nearest]);
    }
    (less as f64 + 0.5 * (same - 1) as f64) / (labels.len() - 1).max(1) as f64
}

impl Experiment for Descriptors {
    fn about(&self) -> About {
        About {
            id: "descriptors",
            title: "Descriptors as features",
            question: "Which vertex features tell corresponding points from others, and what do they cost?",
            varied: "The features of the energy on coarse levels of 400 vertices, each with its default size: each kind alone, the \
                     default (Gaussian and mean curvature), and all that one request may have (the eight kinds from shape index \
                     to SHOT), with equal and with learned precisions. Measured of the unary potentials alone: the share of labels that cost more than \
                     the true one (50 % by chance), the median rank of the true label, and whether the cheapest label is within two \
                     edges of the truth; and of 30 iterations of belief propagation over them, without a pose. Between different \
                     subjects, whether anterior is matched to anterior.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for case in study.phantoms(8).iter().chain(&study.warped(8)).chain(&study.real(6)) {
            for (name, request) in settings() {
                let of = request.clone();
                units.push(study.unit(case, &name, request, move |pair| measure(pair, &of, study.clock)));
            }
        }
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let kinds = [
            (SYNTHETIC, "Phantoms: deformed, rotated and resampled copies", METRICS.as_slice()),
            (WARPED, "Real hippocampi and their deformed, rotated copies from new voxels", METRICS.as_slice()),
            (REAL, "Pairs of different subjects", &[PARTS, SECONDS]),
        ];
        let finding = |group: &Group<'_>| {
            let (alone, _) = group.best(AUC.key, true)?;
            Some(format!(
                "{alone} ranks best ({} of labels worse than the true one, {} with the default); belief propagation brings {} \
                 within 2 edges with the default, {} with learned precisions, {} with all features and {} with all and learned \
                 precisions.",
                mean(group, alone, &AUC)?,
                mean(group, DEFAULT, &AUC)?,
                mean(group, DEFAULT, &WITHIN_2)?,
                mean(group, LEARNED_DEFAULT, &WITHIN_2)?,
                mean(group, ALL_EQUAL, &WITHIN_2)?,
                mean(group, ALL_LEARNED, &WITHIN_2)?,
            ))
        };
        let (synthetic, warped) = (results.group(SYNTHETIC), results.group(WARPED));
        let between_subjects = range(&results.group(REAL), &PARTS, true);
        let present = kinds.iter().filter(|(group, ..)| !results.group(group).is_empty());
        let known = present.clone().filter(|(group, ..)| *group != REAL);
        Body {
            pairs: pairs_of(
                results,
                &[
                    (SYNTHETIC, "synthetic pairs"),
                    (WARPED, "real subjects with deformed copies"),
                    (REAL, "pairs of different subjects"),
                ],
            ),
            finding: sentences([
                on("synthetic", finding(&synthetic)),
                on("deformed real", finding(&warped)),
                on("different", between_subjects),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: present
                .map(|(group, title, metrics)| results.group(group).table(group, title, "features", metrics))
                .collect(),
            plots: known
                .map(|(group, title, _)| Plot {
                    title: (*title).to_owned(),
                    kind: PlotKind::Bars,
                    x: Axis::linear("features", ""),
                    y: Axis::linear("share", "%"),
                    categories: results.group(group).categories(),
                    series: vec![
                        results.group(group).bars("labels worse than the true one", &AUC),
                        results.group(group).bars("within 2 edges after belief propagation", &WITHIN_2),
                    ],
                })
                .collect(),
        }
    }
}
