//! Energy minimization: belief propagation, tree-reweighted messages, annealing with two samplers, Las Vegas.

use super::{About, Body, Experiment, MATCHED, WITHIN_1, pairs_of, sentences};
use crate::experiment::document::{Axis, Cell, Column, Plot, PlotKind, PlotPoint, Series, Table};
use crate::experiment::results::{Group, Results};
use crate::experiment::statistics::Summary;
use crate::experiment::study::{REAL, SYNTHETIC, Setting, Study};
use crate::experiment::units::Unit;
use serde_json::{Value, json};

pub(in crate::experiment) struct Minimizers;

const BP: &str = "belief propagation";

fn settings(study: &Study<'_>) -> Vec<Setting> {
    let (gibbs, metropolis, bound) = study.either((60, 300, 20), (300, 3000, 100));
    let of = |mut request: Value, more: Value| {
        request["clamping"] = json!({"mode": "none"});
        request["registration"] = json!({"refine": "none"});
        request["inference"] = more;
        request
    };
    let annealed = |method: &str, sweeps: u32, schedule: &str| {
        of(json!({"method": method}), json!({"max_iterations": sweeps, "annealing": {"schedule": schedule}}))
    };
    let mut all = vec![(BP.to_owned(), of(json!({}), json!({"lower_bound_iterations": bound})))];
    all.push((
        "tree-reweighted messages".to_owned(),
        of(json!({}), json!({"algorithm": "tree_reweighted", "max_iterations": study.either(10, 40)})),
    ));
    for schedule in ["geometric", "linear", "logarithmic"] {
        all.push((format!("Gibbs, {schedule}"), annealed("gibbs", gibbs, schedule)));
        all.push((format!("Metropolis, {schedule}"), annealed("metropolis", metropolis, schedule)));
    }
    all.push(("Las Vegas".to_owned(), of(json!({"method": "las_vegas"}), json!({"max_iterations": metropolis}))));
    all
}

impl Experiment for Minimizers {
    fn about(&self) -> About {
        About {
            id: "minimizers",
            title: "Energy minimization: message passing, simulated annealing and Las Vegas",
            question: "Which minimizer reaches the lowest energy, how long does it take, and how far above the lower bound \
                       does it end?",
            varied: "The minimizer and the cooling schedule; the energy, the seed and the budget of sweeps are fixed, and \
                     clamping is off.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let settings = settings(study);
        let mut units = study.matches(&study.phantoms(4), &settings);
        units.extend(study.matches(&study.real(2), &settings));
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let kinds = [(SYNTHETIC, "Phantoms"), (REAL, "Pairs of different subjects")];
        let groups: Vec<_> =
            kinds.iter().map(|(id, title)| (*id, *title, results.group(id))).filter(|g| !g.2.is_empty()).collect();
        Body {
            pairs: pairs_of(results, &MATCHED),
            finding: sentences([
                finding("synthetic", &results.group(SYNTHETIC)),
                finding("real", &results.group(REAL)),
            ]),
            notes: study.real_absent().into_iter().collect(),
            tables: groups.iter().map(|(id, title, group)| table(id, title, group)).collect(),
            plots: groups.iter().flat_map(|(_, title, group)| plots(title, group)).collect(),
        }
    }
}

/// Relative excess of the final energy over that of belief propagation on the same pair, percent.
fn excess(group: &Group<'_>, setting: &str) -> Option<Summary> {
    Summary::of(group.measured(setting).iter().filter_map(|(case, m)| {
        let reference = group.value(BP, case, "energy_final")?;
        Some(100.0 * (m.values.get("energy_final")? - reference) / reference.abs())
    }))
}

/// Relative gap of the final energy to the lower bound, percent.
fn gap(group: &Group<'_>, setting: &str) -> Option<Summary> {
    Summary::of(group.measured(setting).iter().filter_map(|(case, m)| {
        let bound = group.value(BP, case, "energy_lower_bound")?;
        Some(100.0 * (m.values.get("energy_final")? - bound) / bound.abs())
    }))
}

fn table(id: &str, title: &str, group: &Group<'_>) -> Table {
    let columns = vec![
        Column::plain("minimizer"),
        Column::plain("pairs"),
        Column::new("energy", "", 1),
        Column::new("excess over belief propagation", "%", 1),
        Column::new("gap to the lower bound", "%", 1),
        Column::new("iterations or sweeps", "", 0),
        Column::new("time of inference", "s", 2),
        Column::new(WITHIN_1.name, "%", 1),
    ];
    let rows = group.configurations().into_iter().map(|setting| {
        vec![
            Cell::text(setting),
            Cell::Count(group.measured(setting).len() as u64),
            Cell::spread(group.summary(setting, "energy_final")),
            Cell::spread(excess(group, setting)),
            Cell::spread(gap(group, setting)),
            Cell::spread(group.summary(setting, "iterations")),
            Cell::spread(group.summary(setting, "inference_seconds")),
            Cell::spread(group.summary(setting, WITHIN_1.key).map(|s| s.scaled(100.0))),
        ]
    });
    Table { id: id.to_owned(), title: title.to_owned(), rows: rows.collect(), columns }
}

/// The energy trace of the first pair, by sweep and by time.
fn plots(title: &str, group: &Group<'_>) -> Vec<Plot> {
    let Some(case) = group.cases().first().copied() else { return Vec::new() };
    let axes = [
        ("energy_by_iteration", Axis::logarithmic("iteration or sweep", "")),
        ("energy_by_second", Axis::logarithmic("time of inference", "s")),
    ];
    axes.into_iter()
        .map(|(curve, x)| {
            let mut series: Vec<Series> =
                group.configurations().iter().filter_map(|s| group.curve(s, s, case, curve)).collect();
            let reach = |pick: fn(f64, f64) -> f64, start: f64| {
                series.iter().flat_map(|s| &s.points).map(|p| p.x).filter(|x| *x > 0.0).fold(start, pick)
            };
            let (low, high) = (reach(f64::min, f64::INFINITY), reach(f64::max, 0.0));
            if let Some(bound) = group.value(BP, case, "energy_lower_bound").filter(|_| low < high) {
                let points = vec![PlotPoint::at(low, bound), PlotPoint::at(high, bound)];
                series.push(Series { name: "lower bound".to_owned(), points });
            }
            Plot {
                title: format!("{title}: energy trace of {case}"),
                kind: PlotKind::Lines,
                x,
                y: Axis::logarithmic("energy", ""),
                categories: Vec::new(),
                series,
            }
        })
        .collect()
}

fn finding(kind: &str, group: &Group<'_>) -> Option<String> {
    let reference = group.summary(BP, "energy_final")?;
    let n = reference.n;
    let others: Vec<_> = group
        .configurations()
        .into_iter()
        .filter(|s| *s != BP)
        .filter_map(|s| Some(format!("{s} {:+.0} %", excess(group, s)?.mean)))
        .collect();
    let bound = gap(group, BP).map_or(String::new(), |g| {
        format!(", {:.1} % above the lower bound and hence at most that far above the optimum", g.mean)
    });
    let against = if others.is_empty() { String::new() } else { format!("; relative to it, {}", others.join(", ")) };
    Some(format!(
        "On {n} {kind} pairs, the mean final energy of belief propagation was {:.0}{bound}{against}.",
        reference.mean
    ))
}
