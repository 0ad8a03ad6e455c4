//! Parameters of RANSAC, on point pairs with a known inlier ratio.

use super::{About, Body, Experiment, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::draws::Draws;
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::Study;
use crate::experiment::units::{Measurement, Unit};
use crate::phantom::{Phantom, random_pose};
use homolog_primitives::observe::Silent;
use homolog_registration::{RansacOptions, RigidTransform, ransac};
use serde_json::json;

pub(in crate::experiment) struct Ransac;

const GROUP: &str = "planted";
/// Mean edge of the phantom whose vertices are the points, mm: about 600.
const EDGE_MM: f64 = 1.6;
/// Standard deviation of the noise on inliers per axis, mm.
const NOISE_MM: f64 = 0.5;
/// A rotation within this angle of the true one is a success, degrees.
const SUCCESS_DEG: f64 = 2.0;

const RATIOS: [f64; 6] = [0.03, 0.05, 0.1, 0.2, 0.4, 0.8];
const TOLERANCES: [f64; 5] = [0.5, 1.0, 2.0, 4.0, 8.0];
const CONFIDENCES: [f64; 4] = [0.5, 0.9, 0.99, 0.999];

/// The parameters of one problem.
#[derive(Debug, Clone, Copy)]
struct Setup {
    ratio: f64,
    tolerance_mm: f64,
    confidence: f64,
}

const USUAL: Setup = Setup { ratio: 0.2, tolerance_mm: 2.0, confidence: 0.999 };

fn ratio_name(ratio: f64) -> String {
    format!("inlier ratio {} %", 100.0 * ratio)
}

fn tolerance_name(tolerance_mm: f64) -> String {
    format!("tolerance {tolerance_mm} mm")
}

fn confidence_name(confidence: f64) -> String {
    format!("confidence {confidence}")
}

fn setups() -> Vec<(String, Setup)> {
    let ratios = RATIOS.map(|ratio| (ratio_name(ratio), Setup { ratio, ..USUAL }));
    let tolerances = TOLERANCES.map(|tolerance_mm| (tolerance_name(tolerance_mm), Setup { tolerance_mm, ..USUAL }));
    let confidences = CONFIDENCES.map(|confidence| (confidence_name(confidence), Setup { confidence, ..USUAL }));
    ratios.into_iter().chain(tolerances).chain(confidences).collect()
}

/// Recovers a known pose from inliers among outliers.
fn solve(setup: &Setup, problem: u64) -> Result<Measurement, String> {
    let phantom = Phantom::new(problem).surface(EDGE_MM).map_err(|e| e.to_string())?;
    let source = phantom.mesh.vertices();
    let motion = random_pose(600 + problem);
    let mut draws = Draws::new(700 + problem);
    let right: Vec<bool> = source.iter().map(|_| draws.unit() < setup.ratio).collect();
    let near = draws.jitter(source, NOISE_MM);
    let target: Vec<_> = (0..source.len())
        .map(|i| motion * if right[i] { near[i] } else { source[draws.below(source.len())] })
        .collect();
    let options = RansacOptions {
        tolerance_mm: setup.tolerance_mm,
        confidence: setup.confidence,
        max_trials: 100_000,
        allow_reflection: false,
        seed: problem,
    };
    let report = ransac(source, &target, &options, &Silent).map_err(|e| e.to_string())?;
    let Some(report) = report else {
        return Ok(Measurement::default().with("success", 0.0));
    };
    let truth = RigidTransform {
        rotation: *motion.rotation.to_rotation_matrix().matrix(),
        translation: motion.translation.vector,
    };
    let error = report.target_from_source.angle_to(&truth).to_degrees();
    let found = (0..source.len()).filter(|&i| report.inlier_mask[i] && right[i]).count() as f64;
    let planted = right.iter().filter(|&&r| r).count().max(1) as f64;
    Ok(Measurement::default()
        .with("success", f64::from(u8::from(error <= SUCCESS_DEG)))
        .with("error_deg", error)
        .with("trials", report.trials as f64)
        .with("recall", found / planted)
        .with("precision", found / report.support.max(1) as f64)
        .with("confidence_reached", f64::from(u8::from(report.confidence_reached))))
}

impl Experiment for Ransac {
    fn about(&self) -> About {
        About {
            id: "ransac",
            title: "Parameters of RANSAC",
            question: "Which inlier ratio is sufficient, and how do tolerance and confidence trade the number of trials against success?",
            varied: "The inlier ratio, the tolerance and the confidence, one at a time, the others at 20 %, 2 mm and 0.999. \
                     Inliers carry Gaussian noise of 0.5 mm per axis, outliers join random vertices; success is a rotation \
                     error of at most 2°.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for problem in 1..=study.either(2, 20) {
            for (name, setup) in setups() {
                let inputs = json!([problem, setup.ratio, setup.tolerance_mm, setup.confidence]);
                units.push(Unit {
                    group: GROUP.to_owned(),
                    configuration: name,
                    case: format!("problem {problem}"),
                    inputs,
                    work: Box::new(move || solve(&setup, problem)),
                });
            }
        }
        units
    }

    fn report(&self, _study: &Study<'_>, results: &Results) -> Body {
        let group = results.group(GROUP);
        let success = Metric::percent("success", "success rate");
        let trials = Metric::number("trials", "trials", "", 0);
        let metrics = [
            success,
            Metric::number("error_deg", "rotation error", "°", 2),
            trials,
            Metric::percent("recall", "inlier recall"),
            Metric::percent("precision", "inlier precision"),
            Metric::percent("confidence_reached", "confidence reached"),
        ];
        let ratio = |setting: &str| RATIOS.into_iter().find(|&r| ratio_name(r) == setting).map(|r| 100.0 * r);
        let tolerance = |setting: &str| TOLERANCES.into_iter().find(|&t| tolerance_name(t) == setting);
        let finding = || {
            let rate = |setting: &String| group.mean(setting, success.key);
            let always = RATIOS.into_iter().find(|&r| rate(&ratio_name(r)).is_some_and(|s| s >= 1.0));
            let usual = ratio_name(USUAL.ratio);
            let enough = match always {
                Some(r) => format!("All problems were solved at inlier ratios from {} % upwards", 100.0 * r),
                None => "No inlier ratio was sufficient for all problems".to_owned(),
            };
            let (few, many) = (confidence_name(CONFIDENCES[0]), confidence_name(CONFIDENCES[3]));
            Some(format!(
                "{enough} ({} problems each). At {} % inliers the default took {:.0} trials on average; confidence {} solved \
                 {:.0} % of the problems with {:.0} trials, confidence {} solved {:.0} % with {:.0}.",
                group.cases().len(),
                100.0 * USUAL.ratio,
                group.mean(&usual, trials.key)?,
                CONFIDENCES[0],
                100.0 * rate(&few)?,
                group.mean(&few, trials.key)?,
                CONFIDENCES[3],
                100.0 * rate(&many)?,
                group.mean(&many, trials.key)?,
            ))
        };
        let plot = |title: &str, x: Axis, y: Axis, series| Plot {
            title: title.to_owned(),
            kind: PlotKind::Lines,
            x,
            y,
            categories: Vec::new(),
            series: vec![series],
        };
        let rate = || Axis::linear("success rate", "%");
        Body {
            pairs: format!("{} problems per setting, 600 point pairs each", group.cases().len()),
            finding: sentences([finding()]),
            tables: vec![group.table("settings", "One parameter varied at a time", "setting", &metrics)],
            plots: vec![
                plot(
                    "Success rate versus inlier ratio",
                    Axis::logarithmic("inlier ratio", "%"),
                    rate(),
                    group.series("mean ± standard deviation", &success, ratio),
                ),
                plot(
                    "Trials versus inlier ratio",
                    Axis::logarithmic("inlier ratio", "%"),
                    Axis::logarithmic("trials", ""),
                    group.series("mean ± standard deviation", &trials, ratio),
                ),
                plot(
                    "Success rate versus tolerance, at an inlier ratio of 20 %",
                    Axis::logarithmic("tolerance", "mm"),
                    rate(),
                    group.series("mean ± standard deviation", &success, tolerance),
                ),
            ],
            notes: Vec::new(),
        }
    }
}
