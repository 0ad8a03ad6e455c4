//! Every dense method side by side: accuracy, folds, time and memory.

use super::{About, Body, Experiment, ROTATION, SECONDS, on, pairs_of, range, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::measure::observed_match;
use crate::experiment::pairs::Pair;
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::{REAL, SYNTHETIC, Study, WARPED};
use crate::experiment::units::{Measurement, Unit};
use homolog_contract::result::Correspondences;
use homolog_mesh::SurfaceMesh;
use nalgebra::{Point3, Vector3};
use serde_json::json;

pub(in crate::experiment) struct Methods;

/// The default, the energy of the thesis, and two rigid baselines; then the published methods. `fast` and `accurate` are names
/// of `balanced`.
const METHODS: [&str; 11] = [
    "balanced",
    "thesis",
    "icp",
    "rigid",
    "cpd",
    "bcpd",
    "nonrigid_icp",
    "spharm_pdm",
    "functional_map",
    "medial",
    "diffeomorphic",
];

const ERROR: Metric = Metric { digits: 2, ..Metric::percent("point_error_share", "mean error, of the diagonal") };
const NEAR: Metric = Metric::percent("points_within_1_edges", "within 1 edge");
const DICE: Metric = Metric::percent("dice", "Dice of the parts");
const FOLDED: Metric = Metric::number("deformation_folded_triangles", "folded triangles", "", 1);
const FOLDED_AREA: Metric =
    Metric { digits: 2, ..Metric::percent("deformation_folded_area_share", "folded share of the area") };
const MEMORY: Metric = Metric::number("peak_mib", "peak memory", "MiB", 0);

const ON_KNOWN: [Metric; 7] = [ERROR, NEAR, ROTATION, FOLDED, FOLDED_AREA, SECONDS, MEMORY];
const ON_SUBJECTS: [Metric; 6] = [DICE, ROTATION, FOLDED, FOLDED_AREA, SECONDS, MEMORY];

/// A match, the errors of its corresponding points, and its memory in a separate process.
fn measure(pair: &Pair, method: &str, study: &Study<'_>) -> Result<Measurement, String> {
    let request = json!({"method": method});
    let (mut m, outcome) = observed_match(pair, &request, study.clock)?;
    let pairs = &outcome.correspondences;
    if let Some(truth) = &pair.truth {
        let (low, high) = pair.source.bounding_box();
        let errors = point_errors(&pair.target, pairs, truth);
        let n = errors.len().max(1) as f64;
        let edge_mm = pair.target.mean_edge_length();
        m.set("point_error_share", errors.iter().sum::<f64>() / n / (high - low).norm());
        m.set("points_within_1_edges", errors.iter().filter(|&&e| e <= edge_mm).count() as f64 / n);
    }
    if let Some((of_source, of_target)) = &pair.parts {
        let images = |row: usize| of_target[pairs.target[row] as usize];
        let couples = pairs.source.iter().enumerate().map(|(row, &v)| (of_source[v as usize], images(row)));
        m.set("dice", mean_dice(&couples.collect::<Vec<_>>()));
    }
    if let Some(meter) = study.memory {
        m.set("peak_mib", meter(&pair.source, &pair.target, &request)? as f64 / f64::from(1 << 20));
    }
    Ok(m)
}

/// Distances of the corresponding points from the true ones, mm, one per row.
fn point_errors(target: &SurfaceMesh, pairs: &Correspondences, truth: &[Point3<f64>]) -> Vec<f64> {
    let corners = pairs.triangle.iter().zip(&pairs.barycentric);
    let points = corners.map(|(triangle, weights)| {
        let weighted = triangle.iter().zip(weights).map(|(&v, w)| target.vertices()[v as usize].coords * *w);
        Point3::from(weighted.sum::<Vector3<f64>>())
    });
    pairs.source.iter().zip(points).map(|(&v, point)| (point - truth[v as usize]).norm()).collect()
}

/// The Dice overlap between the parts of vertices and the parts of their images, `2 |A ∩ B| / (|A| + |B|)`, averaged
/// over the parts.
fn mean_dice(couples: &[(u32, u32)]) -> f64 {
    let mut parts: Vec<u32> = couples.iter().flat_map(|&(a, b)| [a, b]).collect();
    parts.sort_unstable();
    parts.dedup();
    let of = |&part: &u32| {
        let both = couples.iter().filter(|&&couple| couple == (part, part)).count();
        let either = couples.iter().map(|&(a, b)| usize::from(a == part) + usize::from(b == part)).sum::<usize>();
        2.0 * both as f64 / either as f64
    };
    parts.iter().map(of).sum::<f64>() / parts.len().max(1) as f64
}

impl Experiment for Methods {
    fn about(&self) -> About {
        About {
            id: "methods",
            title: "All dense methods",
            question: "How accurate is each method, how often does its map fold the surface, and what time and memory does it take?",
            varied: "The method, with its default parameters. Each searches for the pose itself: every target is rotated by a \
                     uniformly random rotation. Phantoms and real subjects are deformed by a smooth field of 4 % of the diagonal \
                     (RMS) and sampled anew, real ones from new voxels, so that the true corresponding point of every vertex is \
                     known; of two subjects, the anterior and posterior parts. Errors are those of corresponding points, which may lie between vertices. \
                     Memory is the peak of a process that computes one match, program and files included.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        // The quick pair is coarse, since flows take seconds where other methods take hundredths of a second. A surface with
        // fewer vertices than harmonics of degree 12 has no SPHARM-PDM.
        let mut cases = study.phantoms_with(study.either(1, 4), study.either(2.6, study.edge_mm()), 0.0);
        cases.extend(study.warped(4));
        cases.extend(study.real(4));
        let mut units = Vec::new();
        for case in &cases {
            for method in METHODS {
                let work = move |pair: &Pair| measure(pair, method, study);
                units.push(study.unit(case, method, json!(method), work));
            }
        }
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let kinds = [
            (SYNTHETIC, "Phantoms: deformed, rotated and resampled copies", ON_KNOWN.as_slice()),
            (WARPED, "Real subjects and their deformed, rotated copies from new voxels", ON_KNOWN.as_slice()),
            (REAL, "Pairs of different subjects, target rotated", ON_SUBJECTS.as_slice()),
        ];
        let present = kinds.into_iter().filter(|(group, ..)| !results.group(group).is_empty());
        let known = [SYNTHETIC, WARPED].map(|group| (group, results.group(group)));
        let bars = known.iter().filter(|(_, group)| !group.is_empty()).map(|(name, group)| group.bars(name, &ERROR));
        Body {
            pairs: pairs_of(
                results,
                &[
                    (SYNTHETIC, "synthetic pairs"),
                    (WARPED, "deformed real subjects"),
                    (REAL, "pairs of different subjects"),
                ],
            ),
            finding: sentences([
                on("synthetic", range(&known[0].1, &ERROR, false)),
                on("deformed real", range(&known[1].1, &ERROR, false)),
                on("real", range(&results.group(REAL), &DICE, true)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: present
                .map(|(group, title, metrics)| results.group(group).table(group, title, "method", metrics))
                .collect(),
            plots: vec![Plot {
                title: "Mean error of corresponding points".to_owned(),
                kind: PlotKind::Bars,
                x: Axis::linear("method", ""),
                y: Axis::linear("mean error, of the diagonal", "%"),
                categories: METHODS.map(str::to_owned).into(),
                series: bars.collect(),
            }],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dice_is_that_of_the_counts() {
        assert_eq!(mean_dice(&[(1, 1), (2, 2), (2, 2)]), 1.0);
        assert_eq!(mean_dice(&[(1, 2), (2, 1)]), 0.0);
        // Part 1: 2 · 1 / (1 + 2); part 2: 2 · 2 / (3 + 2).
        let found = mean_dice(&[(1, 1), (2, 1), (2, 2), (2, 2)]);
        assert!((found - (2.0 / 3.0 + 4.0 / 5.0) / 2.0).abs() < 1e-12);
    }
}
