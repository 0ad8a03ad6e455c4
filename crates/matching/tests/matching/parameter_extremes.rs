//! Every parameter at the ends of its allowed range, every pair of them together: a match answers with finite numbers or
//! with an error, and never panics.
//!
//! The bounds are those of `homolog_contract::parameters::BOUNDS`. Parameters that only cost time have a lower maximum
//! here ([`SHORTER`]).

use homolog_geometry::hierarchy::coarsen;
use homolog_matching::parameters::{BOUNDS, FeatureKind, resolve};
use homolog_matching::{MatchError, MatchOutcome, Method, Silent, SurfaceMesh, match_surfaces, preset, shapes};
use nalgebra::Point3;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use serde_json::{Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Highest values here of parameters whose larger values only cost time.
const SHORTER: &[(&str, f64)] = &[
    ("inference.max_iterations", 6.0),
    ("inference.restart_after", 3.0),
    ("inference.lower_bound_iterations", 3.0),
    ("registration.max_trials", 2000.0),
    ("clamping.max_rounds", 3.0),
];

/// Seed of the order in which the covering generator tries values.
const SEED: u64 = 20;

/// One parameter, by the JSON pointers that it is written to, and its values.
struct Factor {
    name: String,
    pointers: Vec<String>,
    values: Vec<Value>,
}

/// Every numeric parameter with its lowest and highest value, and `null`; every enumeration with all of its values.
fn factors() -> Vec<Factor> {
    // Before the values of its elements.
    let mut factors = vec![Factor {
        name: "landmarks".to_owned(),
        pointers: vec!["/landmarks".to_owned()],
        values: vec![json!([]), template()["landmarks"].clone()],
    }];
    for bounds in BOUNDS {
        let highest = SHORTER.iter().find(|(name, _)| *name == bounds.name).map_or(bounds.highest(), |(_, most)| *most);
        let number = |value: f64| if bounds.is_whole { json!(value as u64) } else { json!(value) };
        let mut values = vec![number(bounds.lowest()), number(highest)];
        if bounds.nullable {
            values.push(Value::Null);
        }
        let mut pointers = expanded(bounds.name);
        if bounds.name.ends_with("_mm[]") && bounds.name.starts_with("landmarks") {
            // One coordinate of one landmark: identical landmarks would not determine the orientation.
            pointers.truncate(1);
        }
        factors.push(Factor { name: bounds.name.to_owned(), pointers, values });
    }
    let mut choice = |name: &str, values: &[Value]| {
        factors.push(Factor { name: name.to_owned(), pointers: expanded(name), values: values.to_vec() });
    };
    let names = |names: &[&str]| names.iter().map(|name| json!(name)).collect::<Vec<_>>();
    choice("features[].kind", &names(&FeatureKind::ALL.map(FeatureKind::name)));
    choice("features[].estimator", &names(&["angle_defect", "covariance", "quadric"]));
    choice("energy.precisions", &names(&["equal", "learned"]));
    choice("energy.pairwise_distance", &names(&["euclidean", "graph", "geodesic"]));
    choice(
        "inference.algorithm",
        &names(&["max_product", "sum_product", "tree_reweighted", "gibbs", "metropolis", "las_vegas", "none"]),
    );
    choice("inference.update", &names(&["sparse", "active", "full"]));
    choice("inference.annealing.schedule", &names(&["geometric", "logarithmic", "linear"]));
    choice("clamping.mode", &names(&["none", "hard", "soft"]));
    choice("registration.initial", &names(&["ransac", "search", "first_order_ellipsoid", "centroids"]));
    choice("registration.estimator", &names(&["frame", "rotation_axis"]));
    choice("registration.solver", &names(&["svd", "quaternion", "orthonormal_matrix"]));
    choice("registration.refine", &names(&["none", "point_to_point", "point_to_plane"]));
    choice("registration.allow_reflection", &[json!(false), json!(true)]);
    choice("registration.similarity", &[json!(false), json!(true)]);
    choice(
        "displacement.mode",
        &names(&[
            "none",
            "smooth",
            "cpd",
            "bcpd",
            "nonrigid_icp",
            "spharm_pdm",
            "functional_map",
            "medial",
            "diffeomorphic",
        ]),
    );
    choice("displacement.bending", &names(&["none", "straightened", "near_isometry"]));
    choice("displacement.starts", &names(&["inference", "search", "initial"]));
    choice("displacement.uncertainty", &names(&["posterior", "residual"]));
    choice("both_directions", &[json!(false), json!(true)]);
    choice("seed", &[json!(0), json!(u64::MAX)]);
    factors
}

/// The pointers that a dotted name stands for in the lists of [`template()`].
fn expanded(name: &str) -> Vec<String> {
    fn elements(pattern: &str) -> Vec<String> {
        let Some((list, after)) = pattern.split_once("[]") else { return vec![pattern.to_owned()] };
        let n = template().pointer(list).and_then(Value::as_array).map_or(0, Vec::len);
        (0..n).flat_map(|k| elements(&format!("{list}/{k}{after}"))).collect()
    }
    elements(&format!("/{}", name.replace('.', "/")))
}

/// A whole request with two features and four landmarks.
fn template() -> Value {
    let mut request = serde_json::to_value(preset(Method::Balanced)).unwrap();
    let landmark = |p: [f64; 3]| json!({"source_mm": p, "target_mm": p, "sigma_mm": 0.5});
    let corners = [[14.0, 0.0, 0.0], [0.0, 6.0, 0.0], [0.0, 0.0, 4.5], [-14.0, 0.0, 0.0]];
    request["landmarks"] = corners.map(landmark).to_vec().into();
    request
}

/// The request of a row: `chosen[k]` is the value of factor `k`, if it has one; the others are those of `base`.
fn request(factors: &[Factor], chosen: &[Option<usize>], base: &Value) -> Value {
    let mut request = base.clone();
    for (factor, value) in factors.iter().zip(chosen) {
        for pointer in &factor.pointers {
            // Where a row has no landmarks, their coordinates are written nowhere.
            if let (Some(value), Some(slot)) = (value, request.pointer_mut(pointer)) {
                *slot = factor.values[*value].clone();
            }
        }
    }
    request
}

/// Rows that hold every pair of values of every two factors, unless the pair is refused: greedy, one row after another,
/// each begun with a pair that none has and filled with the values that add most pairs.
fn covering(factors: &[Factor]) -> Vec<Vec<Option<usize>>> {
    let bases = {
        let mut balanced = template();
        balanced["clamping"]["mode"] = json!("none");
        balanced["inference"]["algorithm"] = json!("max_product");
        balanced["registration"]["initial"] = json!("ransac");
        let mut alone = serde_json::to_value(preset(Method::Rigid)).unwrap();
        alone["landmarks"] = balanced["landmarks"].clone();
        [balanced, alone]
    };
    // A partial row can be completed if it is allowed over one of the two.
    let allowed = |row: &[Option<usize>]| bases.iter().any(|base| resolve(&request(factors, row, base)).is_ok());
    let mut random = Xoshiro256PlusPlus::seed_from_u64(SEED);
    let mut shuffled = |n: usize| {
        let mut order: Vec<usize> = (0..n).collect();
        for k in (1..n).rev() {
            order.swap(k, (random.next_u64() % (k as u64 + 1)) as usize);
        }
        order
    };
    let n = factors.len();
    let mut missing = std::collections::BTreeSet::new();
    for a in 0..n {
        for b in a + 1..n {
            for x in 0..factors[a].values.len() {
                for y in 0..factors[b].values.len() {
                    missing.insert((a, x, b, y));
                }
            }
        }
    }
    let mut rows = Vec::new();
    while let Some((a, x, b, y)) = missing.pop_first() {
        let mut row = vec![None; n];
        (row[a], row[b]) = (Some(x), Some(y));
        if !allowed(&row) {
            continue;
        }
        for k in shuffled(n) {
            if row[k].is_some() {
                continue;
            }
            let gain = |value: usize, row: &[Option<usize>]| {
                let with = |j: usize, other: usize| {
                    if j < k { (j, other, k, value) } else { (k, value, j, other) }
                };
                let pairs = row.iter().enumerate().filter_map(|(j, other)| other.map(|other| with(j, other)));
                pairs.filter(|pair| missing.contains(pair)).count()
            };
            let mut values = shuffled(factors[k].values.len());
            values.sort_by_key(|&value| std::cmp::Reverse(gain(value, &row)));
            row[k] = values.into_iter().find(|&value| {
                let mut tried = row.clone();
                tried[k] = Some(value);
                allowed(&tried)
            });
        }
        for (a, x) in row.iter().enumerate() {
            for (b, y) in row.iter().enumerate().skip(a + 1) {
                if let (Some(x), Some(y)) = (x, y) {
                    missing.remove(&(a, *x, b, *y));
                }
            }
        }
        rows.push(row);
    }
    rows
}

/// Two lopsided surfaces of 100 to 150 vertices: enough for a coarse level of 100.
fn pair() -> (SurfaceMesh, SurfaceMesh) {
    let bent = |axes: [f64; 3], by: f64, n: usize| {
        let mesh = shapes::ellipsoid(axes.into(), 2);
        let points = mesh.vertices().iter().map(|p| {
            let along = p.x / 14.0;
            Point3::new(p.x, p.y * (1.0 + 0.3 * along) + by * along * along, p.z * (1.0 + 0.2 * along) + 0.5 * along)
        });
        let mesh = coarsen(&mesh.with_vertices(points.collect()).unwrap(), n).unwrap().mesh;
        assert!((101..150).contains(&mesh.n_vertices()), "{} vertices", mesh.n_vertices());
        mesh
    };
    (bent([14.0, 6.0, 4.5], 3.0, 130), bent([14.0, 6.5, 4.5], 2.5, 120))
}

/// Every number of an outcome that is not finite, by the name of its part.
fn not_finite(outcome: &MatchOutcome) -> Vec<String> {
    // A number that is not finite has no form in JSON and becomes `null`; fields without a value are absent.
    fn nulls(value: &Value, name: &str, found: &mut Vec<String>) {
        match value {
            Value::Null => found.push(name.to_owned()),
            Value::Object(fields) => fields.iter().for_each(|(key, v)| nulls(v, &format!("{name}/{key}"), found)),
            Value::Array(items) => items.iter().enumerate().for_each(|(k, v)| nulls(v, &format!("{name}/{k}"), found)),
            _ => {}
        }
    }
    let parts = [
        ("transform", serde_json::to_value(&outcome.transform)),
        ("support", serde_json::to_value(&outcome.support)),
        ("surface_distance", serde_json::to_value(&outcome.surface_distance)),
        ("energy", serde_json::to_value(outcome.energy.iter().collect::<Vec<_>>())),
        ("topology", serde_json::to_value(&outcome.topology)),
        ("rounds", serde_json::to_value(&outcome.rounds)),
        ("poses", serde_json::to_value(&outcome.poses)),
        ("reliability", serde_json::to_value(outcome.reliability.iter().collect::<Vec<_>>())),
        ("correspondences", serde_json::to_value(&outcome.correspondences)),
    ];
    let mut found = Vec::new();
    for (name, value) in parts {
        nulls(&value.unwrap(), name, &mut found);
    }
    found
}

#[test]
fn extremes_of_all_parameters_in_pairs_give_finite_answers_or_errors() {
    let factors = factors();
    let rows = covering(&factors);
    let (source, target) = pair();
    let (mut answered, mut faults) = (0, Vec::new());
    for row in &rows {
        let request = request(&factors, row, &template());
        let parameters = resolve(&request).unwrap_or_else(|faults| panic!("{faults:?} in {request}"));
        let found = catch_unwind(AssertUnwindSafe(|| match_surfaces(&source, &target, &parameters, &Silent)));
        match found {
            Ok(Ok(outcome)) => {
                answered += 1;
                let not_finite = not_finite(&outcome);
                if !not_finite.is_empty() {
                    faults.push(format!("not finite: {:?} of {request}", &not_finite[..not_finite.len().min(6)]));
                }
            }
            Ok(Err(MatchError::Cancelled(_))) => faults.push(format!("cancelled without a request: {request}")),
            Ok(Err(error)) => println!("refused: {error}"),
            Err(_) => faults.push(format!("panic with {request}")),
        }
    }
    println!("{answered} of {} requests were answered", rows.len());
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    // Errors are for combinations that leave no transform; they are not the rule.
    assert!(2 * answered > rows.len(), "{answered} of {}", rows.len());
}

#[test]
fn the_rows_hold_every_pair_that_is_allowed() {
    let factors = factors();
    let rows = covering(&factors);
    let has = |name: &str, value: Value, row: &[Option<usize>]| {
        let k = factors.iter().position(|f| f.name == name).unwrap();
        row[k].map(|v| &factors[k].values[v]) == Some(&value)
    };
    let together = |a: (&str, Value), b: (&str, Value)| {
        rows.iter().any(|row| has(a.0, a.1.clone(), row) && has(b.0, b.1.clone(), row))
    };
    assert!(together(("energy.alpha", json!(1000.0)), ("inference.algorithm", json!("sum_product"))));
    assert!(together(("energy.truncation", Value::Null), ("inference.update", json!("active"))));
    assert!(together(("registration.initial", json!("search")), ("displacement.mode", json!("smooth"))));
    // Registration alone has no minimizer.
    assert!(!together(("registration.initial", json!("search")), ("inference.algorithm", json!("gibbs"))));
    assert!(rows.iter().all(|row| row.iter().all(Option::is_some)), "every row states every parameter");
}
