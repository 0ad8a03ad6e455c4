//! The parameters varied in the thesis, one at a time around the preset `thesis`; the chosen values, and their results
//! on other pairs.

use super::{About, Body, CONSISTENCY, Experiment, INLIERS, PARTS, ROTATION, SECONDS, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind, PlotPoint, Series};
use crate::experiment::results::{Group, Metric, Results};
use crate::experiment::statistics::Summary;
use crate::experiment::study::{Case, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::{Value, json};

pub(in crate::experiment) struct Thesis;

/// The pairs on which settings are compared and chosen, and the pairs on which the chosen ones are measured.
const CHOOSING: &str = "choosing";
const OTHERS: &str = "others";
/// Pairs of subjects of both halves together.
const PAIRS: usize = 24;

const THESIS: &str = "thesis";
const LETTER: &str = "the letter of the thesis";
const FOE: &str = "foe";

const WITHIN_10: Metric = Metric::percent("within_10_deg", "within 10°");
const BEFORE: Metric = Metric::percent("first_support_ratio", "inliers before clamping");
const AFTER: Metric = Metric { name: "inliers after clamping", ..INLIERS };
const FOLDED: Metric = Metric::percent("deformation_folded_area_share", "folded share of the area");
const ON_CHOOSING: [Metric; 7] = [PARTS, WITHIN_10, ROTATION, AFTER, FOLDED, CONSISTENCY, SECONDS];
const ON_OTHERS: [Metric; 7] = [PARTS, WITHIN_10, ROTATION, BEFORE, AFTER, FOLDED, SECONDS];

/// The exact settings of the thesis, as docs/thesis.md states them: Gaussian curvature at one scale, the hard
/// neighborhood constraint and hard clamping.
pub(in crate::experiment) fn letter() -> Value {
    json!({
        "method": "thesis",
        "features": [{"kind": "gaussian_curvature", "scales": [0.05]}],
        "energy": {"alpha": 1, "beta": 1, "truncation": null, "neighborhood_rings": 1},
        "inference": {"max_iterations": 40},
        "clamping": {"mode": "hard", "max_rounds": 3},
        "registration": {"refine": "none"},
    })
}

/// A varied parameter.
struct Varied {
    what: &'static str,
    /// Unit of the values; `None` if they are names.
    unit: Option<&'static str>,
    logarithmic: bool,
    /// A value, its horizontal position, and its request; `Null` for the chosen value.
    values: Vec<(String, f64, Value)>,
}

impl Varied {
    /// Numeric values, placed in the request by `request`.
    fn numbers(
        what: &'static str,
        unit: &'static str,
        logarithmic: bool,
        all: &[f64],
        chosen: f64,
        request: impl Fn(f64) -> Value,
    ) -> Self {
        let value = |&x: &f64| (x.to_string(), x, if x == chosen { Value::Null } else { request(x) });
        Varied { what, unit: Some(unit), logarithmic, values: all.iter().map(value).collect() }
    }

    /// Named values; the chosen one is `Null`.
    fn names(what: &'static str, all: Vec<(&str, Value)>) -> Self {
        let value = |(k, (name, request)): (usize, (&str, Value))| (name.to_owned(), k as f64, request);
        Varied { what, unit: None, logarithmic: false, values: all.into_iter().enumerate().map(value).collect() }
    }

    /// The name of the setting with `value`.
    fn setting(&self, value: &(String, f64, Value)) -> String {
        if value.2.is_null() { THESIS.to_owned() } else { format!("{}: {}", self.what, value.0) }
    }
}

/// The parameters varied in chapter 8 of the thesis.
fn varied() -> Vec<Varied> {
    let curvature = |scales: &[f64]| json!({"features": [{"kind": "gaussian_curvature", "scales": scales}]});
    let energy = |name: &str, value: Value| json!({"energy": {name: value}});
    vec![
        Varied::names(
            "messages",
            vec![("max-product", Value::Null), ("sum-product", json!({"inference": {"algorithm": "sum_product"}}))],
        ),
        Varied::numbers("radius r of the neighborhood", "edges", false, &[1.0, 2.0, 3.0], 2.0, |r| {
            energy("neighborhood_rings", json!(r as u32))
        }),
        Varied::names(
            "scales of Gaussian curvature",
            vec![
                ("0.035", curvature(&[0.035])),
                ("0.07", curvature(&[0.07])),
                ("0.11", curvature(&[0.11])),
                ("0.07 and 0.11", curvature(&[0.07, 0.11])),
                ("0.035, 0.07 and 0.11", Value::Null),
                ("0.05, 0.08, 0.12 and 0.16", curvature(&[0.05, 0.08, 0.12, 0.16])),
            ],
        ),
        Varied::numbers("weight α of curvature", "", true, &[0.25, 0.5, 1.0, 2.0], 0.5, |a| energy("alpha", json!(a))),
        Varied::numbers("weight β of distances", "", false, &[0.0, 0.3, 1.0], 0.0, |b| energy("beta", json!(b))),
        Varied::numbers("truncation T", "", true, &[5.0, 9.2, 14.0, 60.0], 9.2, |t| {
            // 60 is the cost of a broken edge under the hard constraint.
            energy("truncation", if t < 60.0 { json!(t) } else { Value::Null })
        }),
        Varied::names("update", vec![("sparse", Value::Null), ("active", json!({"inference": {"update": "active"}}))]),
        Varied::names(
            "clamping",
            vec![
                ("none", json!({"clamping": {"mode": "none"}})),
                ("hard", json!({"clamping": {"mode": "hard"}})),
                ("soft", Value::Null),
            ],
        ),
        Varied::numbers(
            "most rounds of clamping",
            "",
            false,
            &[1.0, 3.0, 6.0],
            3.0,
            |n| json!({"clamping": {"max_rounds": n as u32}}),
        ),
        Varied::names(
            "refinement by closest points",
            vec![
                ("none", json!({"registration": {"refine": "none"}})),
                ("none, up to 10 rounds", json!({"registration": {"refine": "none"}, "clamping": {"max_rounds": 10}})),
                ("of points", json!({"registration": {"refine": "point_to_point"}})),
                ("of planes", Value::Null),
            ],
        ),
        Varied::numbers(
            "iterations of the first round",
            "",
            true,
            &[6.0, 12.0, 20.0, 40.0],
            12.0,
            |n| json!({"inference": {"max_iterations": n as u32}}),
        ),
    ]
}

/// The preset, and the preset with one parameter changed.
fn settings() -> Vec<Setting> {
    let mut all = vec![(THESIS.to_owned(), json!({"method": "thesis"}))];
    for varied in varied() {
        for value in varied.values.iter().filter(|value| !value.2.is_null()) {
            let mut request = value.2.clone();
            request["method"] = "thesis".into();
            all.push((varied.setting(value), request));
        }
    }
    all
}

/// Pairs of subjects, divided alternately into two halves; phantoms without real data or in the quick report.
fn halves(study: &Study<'_>) -> [Vec<Case>; 2] {
    let real = study.real(PAIRS);
    let all = if real.is_empty() { study.phantoms(2) } else { real };
    let half = |group: &'static str, first: usize| {
        all.iter().skip(first).step_by(2).map(|case| Case { group, ..case.clone() }).collect::<Vec<_>>()
    };
    [half(CHOOSING, 0), half(OTHERS, 1)]
}

impl Experiment for Thesis {
    fn about(&self) -> About {
        About {
            id: "thesis",
            title: "The preset thesis: what the thesis varies, and what was chosen",
            question: "Which settings of the thesis serve two subjects best, and what do they reach on pairs that they were not chosen on?",
            varied: "One parameter at a time around the preset thesis, on one half of the pairs: messages, neighborhood, scales of Gaussian \
                     curvature, weights, truncation, update, clamping, rounds, refinement and iterations. Then the preset beside the letter of the thesis \
                     (one scale, hard neighborhood, hard clamping) and first-order ellipsoids on the other half.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let [choosing, others] = halves(study);
        let compared = |name: &str, request: Value| (name.to_owned(), request);
        let compared = [
            compared(THESIS, json!({"method": "thesis"})),
            compared(LETTER, letter()),
            compared(FOE, json!({"method": "foe"})),
        ];
        let mut units = study.matches(&choosing, &settings());
        units.extend(study.matches(&others, &compared));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (choosing, others) = (results.group(CHOOSING), results.group(OTHERS));
        let kind = if study.real(PAIRS).is_empty() { "phantoms" } else { "pairs of different subjects" };
        let pairs = format!("{} {kind} to choose on and {} others", choosing.cases().len(), others.cases().len());
        let reached = [THESIS, LETTER, FOE].map(|setting| reached(&others, setting));
        let better = varied().iter().filter_map(|varied| clearly_better(&choosing, varied)).collect::<Vec<_>>();
        let chosen = (!choosing.measured(THESIS).is_empty()).then(|| {
            if better.is_empty() {
                "No other value of any parameter had labels that agree better by more than two standard errors of the difference.".to_owned()
            } else {
                format!("Labels agree better by more than two standard errors of the difference with {}.", better.join(", "))
            }
        });
        let [thesis, letter, foe] = reached;
        Body {
            pairs,
            finding: sentences([thesis, letter, foe, chosen]),
            notes: study.real_absent().into_iter().collect(),
            tables: vec![
                others.table(OTHERS, "Pairs that nothing was chosen on", "method", &ON_OTHERS),
                choosing.table(CHOOSING, "Pairs that the settings were chosen on", "setting", &ON_CHOOSING),
            ],
            plots: varied().iter().map(|varied| plot(&choosing, varied)).collect(),
        }
    }
}

/// The results of a method, in words.
fn reached(group: &Group<'_>, setting: &str) -> Option<String> {
    let labels = group.summary(setting, PARTS.key)?;
    let n = group.measured(setting).len() as f64;
    let near = group.mean(setting, WITHIN_10.key)? * n;
    let median = group.summary(setting, ROTATION.key)?.median;
    let least = group
        .measured(setting)
        .iter()
        .filter_map(|(_, m)| m.values.get(INLIERS.key).copied())
        .fold(f64::INFINITY, f64::min);
    Some(format!(
        "With {setting}, labels agree at {} of the vertices, {near:.0} of {n} poses are within 10° (median {median:.1}°), and at least {:.0} % of \
         the vertices are inliers.",
        interval(&labels),
        100.0 * least
    ))
}

/// The mean in percent with its 95 % interval, by the normal approximation.
fn interval(s: &Summary) -> String {
    let half = 1.96 * s.sd / (s.n as f64).sqrt();
    format!("{:.1} % (95 % interval {:.1} to {:.1})", 100.0 * s.mean, 100.0 * (s.mean - half), 100.0 * (s.mean + half))
}

/// A value of a parameter, if any, that beats the chosen one on the same pairs by more than two standard errors.
fn clearly_better(group: &Group<'_>, varied: &Varied) -> Option<String> {
    let better = |setting: &str| -> Option<f64> {
        let of = |(case, m): &(&str, &crate::experiment::units::Measurement)| {
            Some(m.values.get(PARTS.key)? - group.value(THESIS, case, PARTS.key)?)
        };
        let gain = Summary::of(group.measured(setting).iter().filter_map(of))?;
        (gain.mean > 2.0 * gain.sd / (gain.n as f64).sqrt()).then_some(gain.mean)
    };
    let settings = varied.values.iter().filter(|value| !value.2.is_null()).map(|value| varied.setting(value));
    let found = settings.filter_map(|setting| Some((better(&setting)?, setting)));
    let best = found.reduce(|best, next| if next.0 > best.0 { next } else { best });
    best.map(|(gain, setting)| format!("{setting} (by {:.1} %)", 100.0 * gain))
}

/// Label agreement and inliers over the values of a parameter, with the chosen value marked.
fn plot(group: &Group<'_>, varied: &Varied) -> Plot {
    let points = |metric: &Metric, only_chosen: bool| -> Vec<PlotPoint> {
        let of = |value: &(String, f64, Value)| {
            let summary = group.summary(&varied.setting(value), metric.key)?.scaled(metric.factor);
            Some(if only_chosen { PlotPoint::at(value.1, summary.mean) } else { PlotPoint::of(value.1, &summary) })
        };
        varied.values.iter().filter(|value| !only_chosen || value.2.is_null()).filter_map(of).collect()
    };
    let series = |name: &str, metric: &Metric, only_chosen| Series {
        name: name.to_owned(),
        points: points(metric, only_chosen),
    };
    let mut all = vec![series("label agreement", &PARTS, false), series("inliers", &INLIERS, false)];
    if varied.unit.is_some() {
        all.push(series("chosen", &PARTS, true));
    }
    let name = |value: &(String, f64, Value)| {
        if value.2.is_null() { format!("{} (chosen)", value.0) } else { value.0.clone() }
    };
    let unit = varied.unit.unwrap_or("");
    Plot {
        title: format!("Two subjects: {}", varied.what),
        kind: if varied.unit.is_some() { PlotKind::Lines } else { PlotKind::Bars },
        x: if varied.logarithmic { Axis::logarithmic(varied.what, unit) } else { Axis::linear(varied.what, unit) },
        y: Axis::linear("share of vertices", "%"),
        categories: if varied.unit.is_some() { Vec::new() } else { varied.values.iter().map(name).collect() },
        series: all,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_contract::parameters::{Method, preset, resolve};

    #[test]
    fn every_setting_changes_one_parameter_of_the_preset_and_the_chosen_value_none() {
        let thesis = preset(Method::Thesis);
        for (name, request) in settings() {
            let parameters = resolve(&request).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
            assert_eq!(parameters == thesis, name == THESIS, "{name}");
        }
        for varied in varied() {
            assert_eq!(varied.values.iter().filter(|value| value.2.is_null()).count(), 1, "{}", varied.what);
        }
    }

    #[test]
    fn the_marked_values_are_those_of_the_preset() {
        let thesis = serde_json::to_value(preset(Method::Thesis)).unwrap();
        let marked = |what: &str| {
            varied()
                .into_iter()
                .find(|v| v.what.starts_with(what))
                .unwrap()
                .values
                .into_iter()
                .find(|v| v.2.is_null())
                .unwrap()
        };
        for (what, pointer) in [
            ("radius r", "/energy/neighborhood_rings"),
            ("weight α", "/energy/alpha"),
            ("weight β", "/energy/beta"),
            ("truncation", "/energy/truncation"),
            ("most rounds", "/clamping/max_rounds"),
            ("iterations", "/inference/max_iterations"),
        ] {
            assert_eq!(thesis.pointer(pointer).unwrap().as_f64(), Some(marked(what).1), "{what}");
        }
        assert_eq!(thesis.pointer("/clamping/mode").unwrap(), &marked("clamping").0);
        assert_eq!(thesis.pointer("/inference/update").unwrap(), &marked("update").0);
        assert_eq!(thesis.pointer("/inference/algorithm").unwrap(), &marked("messages").0.replace('-', "_"));
        let scales = thesis.pointer("/features/0/scales").unwrap().as_array().unwrap().len();
        assert_eq!(marked("scales").0.matches("0.").count(), scales);
    }

    #[test]
    fn the_page_on_the_thesis_states_its_letter() {
        let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/thesis.md");
        let page = std::fs::read_to_string(page).unwrap();
        let stated = page.split("```json").nth(1).and_then(|rest| rest.split("```").next()).expect("a request");
        assert_eq!(serde_json::from_str::<Value>(stated).unwrap(), letter());
    }
}
