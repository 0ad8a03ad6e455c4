//! The sections of the report, one file each: a question, the units that answer it, and the finding.

mod clamping;
mod curvature;
mod descriptors;
mod ellipsoid;
mod estimators;
mod methods;
mod minimizers;
mod neighborhood;
mod noise;
mod outliers;
mod products;
mod ransac;
mod registration;
mod scale;
mod thesis;
mod topology;
mod update;

use super::document::{Plot, Series, Table};
use super::results::{Group, Metric, Results};
use super::study::{COPIES, REAL, SYNTHETIC, Setting, Study};
use super::units::Unit;

/// All sections, in the order of the report.
pub(super) const ALL: [&dyn Experiment; 17] = [
    &thesis::Thesis,
    &minimizers::Minimizers,
    &products::Products,
    &neighborhood::Neighborhood,
    &scale::CurvatureScale,
    &update::Update,
    &clamping::Clamping,
    &noise::Noise,
    &estimators::Estimators,
    &ransac::Ransac,
    &registration::Registration,
    &topology::Topology,
    &outliers::Outliers,
    &curvature::Curvature,
    &ellipsoid::Ellipsoid,
    &descriptors::Descriptors,
    &methods::Methods,
];

/// One section: a question and the units that answer it.
pub(super) trait Experiment: Sync {
    /// The question, and the parameters varied to answer it.
    fn about(&self) -> About;
    /// The units to compute, in order.
    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>>;
    /// Tables, plots and the finding, from the finished units.
    fn report(&self, study: &Study<'_>, results: &Results) -> Body;
}

/// The fixed text of a section.
pub(super) struct About {
    pub(super) id: &'static str,
    pub(super) title: &'static str,
    pub(super) question: &'static str,
    pub(super) varied: &'static str,
}

/// The results of a section.
#[derive(Default)]
pub(super) struct Body {
    pub(super) pairs: String,
    pub(super) finding: String,
    pub(super) notes: Vec<String>,
    pub(super) tables: Vec<Table>,
    pub(super) plots: Vec<Plot>,
}

const WITHIN_1: Metric = Metric::percent("within_1_edges", "within 1 edge");
const WITHIN_2: Metric = Metric::percent("within_2_edges", "within 2 edges");
const ERROR: Metric = Metric::number("error_mm", "mean error", "mm", 2);
const PARTS: Metric = Metric::percent("part_agreement", "label agreement");
const ROTATION: Metric = Metric::number("rotation_error_deg", "rotation error", "°", 2);
const INLIERS: Metric = Metric::percent("support_ratio", "inlier ratio");
const CONSISTENCY: Metric = Metric::percent("consistency", "edges preserved");
const SECONDS: Metric = Metric::number("seconds", "time", "s", 2);

/// Metrics for pairs whose ground truth is known at every vertex.
const ON_PHANTOMS: [Metric; 7] = [WITHIN_1, WITHIN_2, ERROR, ROTATION, INLIERS, CONSISTENCY, SECONDS];
/// Metrics for different subjects, for which only anterior and posterior labels are known.
const ON_SUBJECTS: [Metric; 5] = [PARTS, ROTATION, INLIERS, CONSISTENCY, SECONDS];

/// The tables of the matched kinds of pair, with a row for each setting.
fn match_tables(results: &Results, setting: &str) -> Vec<Table> {
    let kinds = [
        (SYNTHETIC, "Phantoms: deformed, rotated and resampled copies", ON_PHANTOMS.as_slice()),
        (REAL, "Pairs of different subjects, target rotated", ON_SUBJECTS.as_slice()),
        (COPIES, "Real subjects and their rotated copies", ON_PHANTOMS.as_slice()),
    ];
    kinds
        .into_iter()
        .filter(|(group, ..)| !results.group(group).is_empty())
        .map(|(group, title, metrics)| results.group(group).table(group, title, setting, metrics))
        .collect()
}

/// The number of pairs of each kind.
fn pairs_of(results: &Results, kinds: &[(&str, &str)]) -> String {
    let counted = kinds.iter().filter_map(|(group, noun)| {
        let n = results.group(group).cases().len();
        (n > 0).then(|| format!("{n} {noun}"))
    });
    counted.collect::<Vec<_>>().join(", ")
}

/// The kinds of pairs that are matched.
const MATCHED: [(&str, &str); 3] = [
    (SYNTHETIC, "synthetic pairs"),
    (REAL, "pairs of different subjects"),
    (COPIES, "real subjects with rotated copies"),
];

/// The matches of a section that compares `settings` by [`matched`]: 8 synthetic pairs and 6 pairs of different
/// subjects.
fn both_kinds<'a>(study: &'a Study<'_>, settings: &[Setting]) -> Vec<Unit<'a>> {
    let mut units = study.matches(&study.phantoms(8), settings);
    units.extend(study.matches(&study.real(6), settings));
    units
}

/// A report that compares settings by the match rate of synthetic pairs and the label agreement of different subjects.
/// `setting` is the heading of the settings in the tables.
fn matched(study: &Study<'_>, results: &Results, setting: &str, plot: Plot) -> Body {
    Body {
        pairs: pairs_of(results, &MATCHED),
        finding: sentences([
            on("synthetic", range(&results.group(SYNTHETIC), &WITHIN_1, true)),
            on("real", range(&results.group(REAL), &PARTS, true)),
        ]),
        notes: study.real_absent().into_iter().collect(),
        tables: match_tables(results, setting),
        plots: vec![plot],
    }
}

/// The `rates` of synthetic pairs, and the label agreement of different subjects if there are any, as curves over
/// settings with the horizontal position `x`.
fn rate_series(results: &Results, rates: &[Metric], x: impl Fn(&str) -> Option<f64> + Copy) -> Vec<Series> {
    let (synthetic, real) = (results.group(SYNTHETIC), results.group(REAL));
    let mut series: Vec<_> =
        rates.iter().map(|rate| synthetic.series(&format!("phantoms, {}", rate.name), rate, x)).collect();
    if !real.is_empty() {
        series.push(real.series("different subjects, label agreement", &PARTS, x));
    }
    series
}

/// The sentences whose numbers were measured; if there are none, a sentence that says so.
fn sentences<const N: usize>(found: [Option<String>; N]) -> String {
    let found: Vec<_> = found.into_iter().flatten().collect();
    if found.is_empty() { "No results: no unit of this section finished.".to_owned() } else { found.join(" ") }
}

/// One metric of two settings in words: `78 ± 5 % with A versus 42 ± 7 % with B`.
fn against(group: &Group<'_>, one: &str, other: &str, metric: &Metric) -> Option<String> {
    Some(format!("{} with {one} versus {} with {other}", mean(group, one, metric)?, mean(group, other, metric)?))
}

/// A metric of a setting in words: `78 ± 5 %`.
fn mean(group: &Group<'_>, setting: &str, metric: &Metric) -> Option<String> {
    let s = group.summary(setting, metric.key)?.scaled(metric.factor);
    let d = metric.digits;
    let unit = match metric.unit {
        "°" => "°".to_owned(),
        unit => format!(" {unit}"),
    };
    Some(format!("{:.d$} ± {:.d$}{unit}", s.mean, s.sd).trim_end().to_owned())
}

/// The best and the worst setting by a metric: `label agreement: best for r = 2 (93 ± 2 %), worst for r = 1 (71 ± 4 %), …`.
fn range(group: &Group<'_>, metric: &Metric, largest: bool) -> Option<String> {
    let (best, _) = group.best(metric.key, largest)?;
    let (worst, _) = group.best(metric.key, !largest)?;
    let n = group.measured(best).len();
    let noun = if n == 1 { "pair" } else { "pairs" };
    let (first, last) = (mean(group, best, metric)?, mean(group, worst, metric)?);
    Some(format!("{}: best for {best} ({first}), worst for {worst} ({last}), mean ± SD over {n} {noun}.", metric.name))
}

/// The sentence, introduced by the kind of pair.
fn on(kind: &str, sentence: Option<String>) -> Option<String> {
    sentence.map(|s| format!("On {kind} pairs, {s}"))
}
