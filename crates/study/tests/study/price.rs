//! What computations are predicted to cost, beside the processor time that they take, at the ends of every count.
//!
//! Only ratios of one run are compared: all prices may be wrong by the speed of the machine.

use crate::making::{Extra, made, made_with};
use homolog_contract::parameters::resolve;
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use homolog_study::price::{Price, match_price, step_price};
use nalgebra::{Point3, Rotation3, Vector3};
use serde_json::{Value, json};

/// How far a price may be from the measured time, each way.
const FACTOR: f64 = 4.0;

/// Processor time of `work` on one thread, s.
fn measured(work: impl FnOnce() + Send) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    pool.install(|| {
        // Nanoseconds on a processor come first.
        let now = || {
            let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
            text.split_whitespace().next().unwrap().parse::<u64>().unwrap()
        };
        let began = now();
        work();
        (now() - began) as f64 * 1e-9
    })
}

/// A bent and tapered ellipsoid without symmetry, of `10 · 4^level + 2` vertices.
fn bean(level: u32, bend: f64) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + bend * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap()
}

/// The price of a match, and the seconds that it takes.
fn matched(levels: [u32; 2], request: &Value) -> (Price, f64) {
    let source = bean(levels[0], 0.02);
    let turned = Rotation3::from_euler_angles(0.3, -0.4, 0.6);
    let target = bean(levels[1], 0.024);
    let target = target.with_vertices(target.vertices().iter().map(|p| turned * p).collect()).unwrap();
    let parameters = resolve(request).unwrap();
    let price = match_price(&parameters, (source.n_vertices(), source.n_faces()), target.n_vertices());
    let [source, target] = [source, target].map(|mesh| write_ply(&mesh));
    let seconds = measured(|| {
        let file = |bytes| InputFile { bytes, name: Some("a.ply") };
        drop(run_match(file(&source), file(&target), &parameters, &IntakeLimits::default(), &Silent));
    });
    (price, seconds)
}

/// Fails unless the prices are within [`FACTOR`] of the seconds, up to one common factor.
fn compare(cases: Vec<(String, (Price, f64))>) {
    let ratios: Vec<f64> =
        cases.iter().map(|(_, (price, seconds))| price.processor_time.as_secs_f64() / seconds).collect();
    let speed = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
    let mut is_fine = true;
    let mut lines = vec![format!("all prices times {speed:.2}")];
    for ((name, (price, seconds)), ratio) in cases.iter().zip(ratios) {
        let share = ratio / speed;
        is_fine &= (1.0 / FACTOR..FACTOR).contains(&share);
        lines.push(format!("{name}: price {:?}, took {seconds:.3} s, {share:.2}", price.processor_time));
    }
    let text = lines.join("\n");
    println!("{text}");
    assert!(is_fine, "\n{text}");
}

#[test]
fn the_price_of_a_match_is_near_what_it_takes() {
    let thesis = |more: Value| {
        let mut request = json!({"method": "thesis"});
        for (name, value) in more.as_object().unwrap() {
            request[name.as_str()] = value.clone();
        }
        request
    };
    let iterated = |more: Value| {
        let mut request = json!({"method": "thesis", "clamping": {"max_rounds": 0}});
        request["inference"] = json!({"max_iterations": 40, "tolerance": 0});
        for (name, value) in more.as_object().unwrap() {
            request["inference"][name.as_str()] = value.clone();
        }
        request
    };
    let described = |feature: Value| {
        thesis(json!({"inference": {"max_iterations": 1, "coarse_vertices": 200}, "features": [feature]}))
    };
    let method = |name: &str| json!({"method": name});
    let cases = [
        ([2, 2], method("balanced")),
        ([4, 4], method("balanced")),
        ([5, 2], method("balanced")),
        ([4, 4], method("rigid")),
        ([4, 4], method("cpd")),
        ([3, 3], method("nonrigid_icp")),
        ([3, 3], method("functional_map")),
        ([2, 2], method("diffeomorphic")),
        ([3, 3], method("gibbs")),
        ([3, 3], method("metropolis")),
        ([3, 3], method("las_vegas")),
        ([4, 4], method("thesis")),
        ([4, 3], iterated(json!({}))),
        ([3, 3], iterated(json!({"update": "full", "max_iterations": 15}))),
        ([2, 2], iterated(json!({"lower_bound_iterations": 100}))),
        ([3, 3], iterated(json!({"lower_bound_iterations": 50}))),
        ([4, 4], described(json!({"kind": "shot", "support": 1}))),
        ([5, 5], described(json!({"kind": "shot", "support": 0.05}))),
        ([4, 4], described(json!({"kind": "shape_context"}))),
        ([4, 4], described(json!({"kind": "wave_kernel_signature"}))),
        ([4, 4], described(json!({"kind": "mean_curvature", "estimator": "quadric", "radius_mm": 100}))),
        ([4, 4], described(json!({"kind": "mean_curvature", "estimator": "quadric", "radius_mm": 2}))),
    ];
    compare(cases.map(|(levels, request)| (format!("{levels:?} {request}"), matched(levels, &request))).into());
}

#[test]
fn the_price_of_a_step_is_near_what_it_takes() {
    let cases = [
        (4, 1, 1, 0, 1),
        (5, 5, 1, 0, 2),
        (12, 3, 1, 0, 2_000),
        (12, 4, 1, 0, 100),
        (6, 3, 20, 0, 2),
        (6, 1, 20, 0, 2_000),
        (60, 2, 1, 0, 2_000),
        (150, 1, 1, 0, 2_000),
        (150, 3, 1, 0, 2),
        (400, 1, 1, 0, 2),
    ];
    let compared = cases.map(|(subjects, levels, contrasts, covariates, permutations)| {
        let study = made(subjects, levels, contrasts, covariates, permutations);
        let seconds = measured(|| drop(study.step()));
        let name = format!("{subjects} subjects, level {levels}, {contrasts} contrasts, {permutations} permutations");
        (name, (step_price(&study.size), seconds))
    });
    let mut compared: Vec<_> = compared.into();
    for (extra, subjects, levels) in [
        (Extra::Rivals, 12, 4),
        (Extra::Rivals, 60, 3),
        (Extra::Rivals, 250, 1),
        (Extra::OwnTemplates, 12, 4),
        (Extra::OwnTemplates, 60, 2),
    ] {
        let study = made_with(extra, subjects, levels, 1, 0, 2);
        let seconds = measured(|| drop(study.step()));
        compared.push((format!("{subjects} subjects, level {levels}, {extra:?}"), (step_price(&study.size), seconds)));
    }
    compare(compared);
}
