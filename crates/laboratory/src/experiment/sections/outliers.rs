//! Outlier detection: synthetic bumps without a counterpart, and the vertices flagged between real subjects.

use super::{About, Body, Experiment, MATCHED, mean, pairs_of, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::draws::Draws;
use crate::experiment::measure::observed_match;
use crate::experiment::pairs::Pair;
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::{REAL, SYNTHETIC, Study};
use crate::experiment::units::{Measurement, Unit};
use homolog_matching::MatchOutcome;
use nalgebra::Point3;
use serde_json::{Value, json};

pub(in crate::experiment) struct Outliers;

/// Radius of the synthetic bump, as Euclidean distance, mm.
const RADIUS_MM: f64 = 6.0;
/// Heights of the bumps, mm.
const HEIGHTS: [f64; 4] = [2.0, 4.0, 6.0, 8.0];
/// A vertex displaced by more than this has no counterpart, mm: the tolerance of the registration.
const TOLERANCE_MM: f64 = 3.0;

const REASONS: [&str; 3] = ["residual", "neighborhood", "both"];

fn name(height_mm: f64) -> String {
    format!("bump of {height_mm} mm")
}

fn request() -> Value {
    json!({"registration": {"tolerance_mm": TOLERANCE_MM}})
}

/// The reasons of all source vertices, `none` for vertices that are not outliers.
fn reasons(outcome: &MatchOutcome) -> Vec<String> {
    let columns = serde_json::to_value(&outcome.correspondences).unwrap_or_default();
    let named = columns["outlier"].as_array().filter(|reasons| !reasons.is_empty());
    match named {
        Some(reasons) => reasons.iter().map(|r| r.as_str().unwrap_or("none").to_owned()).collect(),
        None => {
            let of = |&inlier: &bool| if inlier { "none" } else { "residual" }.to_owned();
            outcome.correspondences.inlier.iter().map(of).collect()
        }
    }
}

fn shares(m: &mut Measurement, reasons: &[String]) {
    let share = |wanted: &dyn Fn(&str) -> bool| {
        reasons.iter().filter(|r| wanted(r)).count() as f64 / reasons.len().max(1) as f64
    };
    m.set("flagged", share(&|r| r != "none"));
    for reason in REASONS {
        m.set(reason, share(&|r| r == reason));
    }
}

/// Displaces a round patch of the source smoothly along its normals and measures how well it is flagged.
fn planted(pair: &Pair, height_mm: f64, seed: u64, study: &Study<'_>) -> Result<Measurement, String> {
    let vertices = pair.source.vertices();
    let center = vertices[Draws::new(800 + seed).below(vertices.len())];
    let lift = |p: &Point3<f64>| {
        let share = ((p - center).norm() / RADIUS_MM).min(1.0);
        height_mm * (1.0 - share * share).powi(2)
    };
    let normals = pair.source.vertex_normals();
    let moved = vertices.iter().zip(&normals).map(|(p, n)| p + lift(p) * n).collect();
    let source = pair.source.with_vertices(moved).map_err(|e| e.to_string())?;
    let planted: Vec<bool> = vertices.iter().map(|p| lift(p) > TOLERANCE_MM).collect();
    let bumped = Pair { source, ..pair.clone() };
    let (mut m, outcome) = observed_match(&bumped, &request(), study.clock)?;
    let reasons = reasons(&outcome);
    shares(&mut m, &reasons);
    let flagged: Vec<bool> = reasons.iter().map(|r| r != "none").collect();
    let count = |wanted: &dyn Fn(usize) -> bool| (0..planted.len()).filter(|&i| wanted(i)).count() as f64;
    let both = count(&|i| planted[i] && flagged[i]);
    m.set("planted", count(&|i| planted[i]) / planted.len().max(1) as f64);
    // Without synthetic outliers recall is undefined; without flags precision is undefined. Undefined values are left
    // out.
    m.set("recall", both / count(&|i| planted[i]));
    m.set("precision", both / count(&|i| flagged[i]));
    m.set("false_alarms", count(&|i| !planted[i] && flagged[i]) / count(&|i| !planted[i]));
    Ok(m)
}

impl Experiment for Outliers {
    fn about(&self) -> About {
        About {
            id: "outliers",
            title: "Outlier detection",
            question: "With which precision and recall are vertices without a counterpart flagged?",
            varied: "The height of a smooth bump of 6 mm radius added to the source; a vertex displaced by more than the \
                     tolerance of 3 mm is a synthetic outlier. Between different subjects, the share flagged by reason: \
                     residual (too far away after registration), neighborhood (the images of most neighbors are not \
                     neighbors), or both.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for (k, case) in study.phantoms(8).into_iter().enumerate() {
            for height in study.either(vec![2.0, 6.0], HEIGHTS.to_vec()) {
                let work = move |pair: &Pair| planted(pair, height, k as u64, study);
                units.push(study.unit(&case, &name(height), json!([request(), height, k]), work));
            }
        }
        for case in study.real(8) {
            units.push(study.unit(&case, "default method", request(), move |pair| {
                let (mut m, outcome) = observed_match(pair, &request(), study.clock)?;
                shares(&mut m, &reasons(&outcome));
                Ok(m)
            }));
        }
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
        let precision = Metric::percent("precision", "precision");
        let recall = Metric::percent("recall", "recall");
        let flagged = [
            Metric::percent("flagged", "flagged"),
            Metric::percent("residual", "by residual"),
            Metric::percent("neighborhood", "by neighborhood"),
            Metric::percent("both", "by both"),
        ];
        let mut metrics = vec![
            Metric::percent("planted", "synthetic outliers"),
            precision,
            recall,
            Metric::percent("false_alarms", "false positive rate"),
        ];
        metrics.extend(flagged);
        let planted = || {
            let (best, _) = synthetic.best(recall.key, true)?;
            Some(format!(
                "For a {best}, recall was {} and precision {} ({} pairs).",
                mean(&synthetic, best, &recall)?,
                mean(&synthetic, best, &precision)?,
                synthetic.measured(best).len()
            ))
        };
        let between = || {
            let setting = real.configurations().first().copied()?;
            let of = |k: usize| mean(&real, setting, &flagged[k]);
            Some(format!(
                "On {} pairs of different subjects {} of the vertices were flagged: {} by the residual alone, {} by the \
                 neighborhood alone, {} by both.",
                real.measured(setting).len(),
                of(0)?,
                of(1)?,
                of(2)?,
                of(3)?
            ))
        };
        let height = |setting: &str| HEIGHTS.into_iter().find(|&h| name(h) == setting);
        let mut tables = vec![synthetic.table("planted", "Synthetic bumps on phantoms", "bump", &metrics)];
        if !real.is_empty() {
            tables.push(real.table("real", "Pairs of different subjects", "setting", &flagged));
        }
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([planted(), between()]),
            notes: study.real_absent().into_iter().collect(),
            tables,
            plots: vec![Plot {
                title: "Precision and recall versus bump height".to_owned(),
                kind: PlotKind::Lines,
                x: Axis::linear("bump height", "mm"),
                y: Axis::linear("share", "%"),
                categories: Vec::new(),
                series: vec![
                    synthetic.series("recall", &recall, height),
                    synthetic.series("precision", &precision, height),
                ],
            }],
        }
    }
}
