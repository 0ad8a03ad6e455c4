//! Every figure of the statistics beside that of statsmodels or scipy, in `reference/reference.json`, which
//! `reference/make.py` makes: `python crates/study/tests/reference/make.py crates/study/tests/reference/reference.json`.

use faer::Mat;
use homolog_primitives::observe::Silent;
use homolog_study::statistics::VertexValues;
use homolog_study::statistics::effect::{interval_of_d, noncentral_t_cdf, power, subjects_needed};
use homolog_study::statistics::linear::LinearModel;
use homolog_study::statistics::mixed::MixedModel;
use homolog_study::statistics::multiple::false_discovery;
use homolog_study::statistics::permutation::t_of_orders;
use serde_json::Value;

fn reference() -> Value {
    serde_json::from_str(include_str!("../reference/reference.json")).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn rows(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

fn matrix(value: &Value) -> Mat<f64> {
    let rows = rows(value);
    Mat::from_fn(rows.len(), rows[0].len(), |i, k| rows[i][k])
}

#[track_caller]
fn near(ours: f64, theirs: f64, tolerance: f64) {
    assert!((ours - theirs).abs() <= tolerance * theirs.abs().max(1.0), "{ours} is not {theirs}");
}

const CONTRAST: [f64; 3] = [0.0, 1.0, 0.0];

#[test]
fn contrasts_robust_errors_and_p_values_are_those_of_statsmodels() {
    let reference = reference();
    let model = LinearModel::new(&matrix(&reference["x"]));
    let found = model.contrast(&VertexValues::from_subjects(&rows(&reference["y"])), &CONTRAST, &Silent).unwrap();
    for (k, expected) in reference["linear"].as_array().unwrap().iter().enumerate() {
        let theirs = |name: &str| expected[name].as_f64().unwrap();
        near(found.effect[k], theirs("effect"), 1e-10);
        near(found.t[k], theirs("t"), 1e-10);
        near(found.robust_se[k], theirs("robust_se"), 1e-10);
        near(found.robust_t[k], theirs("robust_t"), 1e-10);
        near(found.robust_p[k], theirs("robust_p"), 1e-9);
        near(found.g[k], theirs("d") * (1.0 - 3.0 / (4.0 * 27.0 - 1.0)), 1e-10);
    }
    let adjusted = false_discovery(&found.robust_p);
    for (ours, theirs) in adjusted.iter().zip(numbers(&reference["false_discovery"])) {
        near(*ours, theirs, 1e-9);
    }
}

#[test]
fn permuted_t_is_that_of_freedman_and_lane_step_by_step() {
    let reference = reference();
    let model = LinearModel::new(&matrix(&reference["x"]));
    let values = VertexValues::from_subjects(&rows(&reference["y"]));
    let orders: Vec<Vec<usize>> =
        rows(&reference["orders"]).iter().map(|order| order.iter().map(|&k| k as usize).collect()).collect();
    let found = t_of_orders(&model, &values, &CONTRAST, &orders, &Silent).unwrap();
    for (ours, theirs) in found.iter().zip(rows(&reference["permuted_t"])) {
        ours.iter().zip(theirs).for_each(|(ours, theirs)| near(*ours, theirs, 1e-9));
    }
}

#[test]
fn the_mixed_model_of_visits_is_that_of_statsmodels() {
    let reference = &reference()["visits"];
    let subjects: Vec<usize> = numbers(&reference["subjects"]).iter().map(|&k| k as usize).collect();
    let model = MixedModel::new(&matrix(&reference["x"]), &subjects);
    let found =
        model.contrast(&VertexValues::from_subjects(&rows(&reference["y"])), &[0.0, 0.0, 1.0], &Silent).unwrap();
    for (k, expected) in reference["fits"].as_array().unwrap().iter().enumerate() {
        let theirs = |name: &str| expected[name].as_f64().unwrap();
        // Its optimizer stops where the likelihood is flat.
        near(found.between[k], theirs("between"), 2e-3);
        near(found.effect[k], theirs("effect"), 1e-3);
        near(found.se[k], theirs("se"), 2e-3);
        near(found.p[k], theirs("p"), 5e-3);
    }
}

#[test]
fn noncentral_t_intervals_and_power_are_those_of_scipy_and_statsmodels() {
    let reference = reference();
    for row in rows(&reference["noncentral_t"]) {
        near(noncentral_t_cdf(row[0], row[1], row[2]), row[3], 1e-8);
    }
    for row in rows(&reference["power"]) {
        near(power(row[0], row[1], row[2], 0.05), row[3], 1e-6);
    }
    for row in rows(&reference["intervals"]) {
        let found = interval_of_d(row[0], row[1], row[2]);
        near(found[0], row[3], 1e-7);
        near(found[1], row[4], 1e-7);
    }
    // Two groups of equal size: the weights of 100 subjects have the length √(1/50 + 1/50).
    for row in rows(&reference["needed"]) {
        let found = subjects_needed(row[0], 100, 2, 0.2, 0.05, 0.8).unwrap() as f64;
        assert!((found - row[1].ceil()).abs() <= 1.0, "{found} {}", row[1]);
    }
}
