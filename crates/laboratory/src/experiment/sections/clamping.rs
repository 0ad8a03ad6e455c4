//! Ablation: feedback from registration (clamping), and a larger neighborhood as a replacement for it.

use super::{
    About, Body, Experiment, INLIERS, MATCHED, PARTS, WITHIN_1, against, match_tables, on, pairs_of, sentences,
};
use crate::experiment::document::{Axis, Plot, PlotKind, Series};
use crate::experiment::results::{Group, Metric, Results};
use crate::experiment::study::{REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::json;

pub(in crate::experiment) struct Clamping;

const MODES: [(&str, &str); 3] = [("no clamping", "none"), ("hard clamping", "hard"), ("soft clamping", "soft")];

fn name(mode: &str, r: u32) -> String {
    format!("{mode}, r = {r}")
}

/// Settings without refinement, so that the inliers are those of the correspondence.
fn settings(radii: &[u32]) -> Vec<Setting> {
    let mut all = Vec::new();
    for (mode, word) in MODES {
        for &r in radii {
            let request = json!({
                "energy": {"neighborhood_rings": r},
                "clamping": {"mode": word, "max_rounds": if word == "none" { 0 } else { 3 }},
            });
            all.push((name(mode, r), request));
        }
    }
    all
}

impl Experiment for Clamping {
    fn about(&self) -> About {
        About {
            id: "clamping",
            title: "Ablation: feedback from registration (clamping)",
            question: "Does feedback from registration improve the correspondence, and can a larger neighborhood replace it?",
            varied: "Clamping (none; hard: inliers of the registration are fixed, as in the thesis; soft: distances and \
                     normals after registration are added to the unary potentials; at most three rounds) and the \
                     neighborhood radius r.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = study.matches(&study.phantoms(8), &settings(study.either(&[1, 2], &[1, 2, 3])));
        units.extend(study.matches(&study.real(6), &settings(&[1, 2])));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                on(
                    "synthetic",
                    compared(&synthetic, "the correct match rate within one mean edge length was", &WITHIN_1),
                ),
                on("real", compared(&real, "the inlier ratio was", &INLIERS)),
                on("real", compared(&real, "the agreement of anterior and posterior labels was", &PARTS)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: match_tables(results, "clamping and radius"),
            plots: vec![
                by_radius("Phantoms: correct match rate within one edge", &synthetic, &WITHIN_1),
                by_radius("Different subjects: inlier ratio", &real, &INLIERS),
            ]
            .into_iter()
            .filter(|plot| plot.series.iter().any(|s| !s.points.is_empty()))
            .collect(),
        }
    }
}

/// Compares soft and hard clamping with none, at the default radius.
fn compared(group: &Group<'_>, what: &str, metric: &Metric) -> Option<String> {
    let [none, hard, soft] = MODES.map(|(mode, _)| name(mode, 2));
    let n = group.measured(&soft).len();
    let hard = super::mean(group, &hard, metric).map_or(String::new(), |m| format!(", {m} with hard clamping"));
    Some(format!("{what} {}{hard} ({n} pairs).", against(group, &soft, &none, metric)?))
}

fn by_radius(title: &str, group: &Group<'_>, metric: &Metric) -> Plot {
    let series = MODES.map(|(mode, _)| {
        let radius = |setting: &str| setting.strip_prefix(mode)?.strip_prefix(", r = ")?.parse().ok();
        let series = group.series(mode, metric, radius);
        Series { points: series.points, name: mode.to_owned() }
    });
    Plot {
        title: title.to_owned(),
        kind: PlotKind::Lines,
        x: Axis::linear("radius r", "edges"),
        y: Axis::linear(metric.name, metric.unit),
        categories: Vec::new(),
        series: series.into(),
    }
}
