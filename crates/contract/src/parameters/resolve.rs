//! Resolves a request to effective parameters, with a JSON pointer to every fault.

use super::ranges::{BOUNDS, fault};
use super::{MatchParameters, Method, ParameterError, preset};
use serde_json::Value;

/// The effective parameters of a request: the preset named by its `method`, overridden by its values.
///
/// # Errors
/// Every fault, each with its JSON pointer: unknown keys, wrong types, values out of range.
pub fn resolve(request: &Value) -> Result<MatchParameters, Vec<ParameterError>> {
    let method = match request.get("method") {
        None => Method::Balanced,
        Some(name) => serde_json::from_value(name.clone()).map_err(|_| {
            let known = Method::ALL.map(Method::name);
            let meant = name.as_str().and_then(|name| nearest(name, known.iter().copied()));
            let detail = format!("unknown method; {}known are {}", did_you_mean(meant), known.join(", "));
            vec![fault("/method", "out_of_range", detail)]
        })?,
    };
    let mut merged = serde_json::to_value(preset(method)).unwrap_or(Value::Null);
    let mut faults = Vec::new();
    let names = names(&merged, String::new());
    overlay(&mut merged, request, &mut String::new(), &names, &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    follow_the_request(&mut merged, request, method);
    let parameters: MatchParameters = serde_path_to_error::deserialize(merged).map_err(|e| {
        let pointer = format!("/{}", e.path().to_string().replace(['.', '['], "/").replace(']', ""));
        vec![fault(&pointer, "wrong_type", needed(&pointer, &e.inner().to_string()))]
    })?;
    parameters.check().map(|()| parameters)
}

/// Parameters of an energy of labels, or of RANSAC over labels.
const OF_LABELS: [&str; 7] = [
    "/features",
    "/energy",
    "/inference",
    "/clamping",
    "/registration/estimator",
    "/registration/confidence",
    "/registration/max_trials",
];

/// Adapts unstated parameters to the stated ones. The default minimizes no energy of labels, so a request that states a
/// parameter of one enables it. Landmarks enable it too if no smooth field uses them, because they enter its unary
/// potentials. Initial poses come from the labels of a minimizer, or without one from a search.
fn follow_the_request(merged: &mut Value, request: &Value, method: Method) {
    let names_algorithm = request.pointer("/inference/algorithm").is_some();
    let states = |pointer: &&str| request.pointer(pointer).is_some_and(|stated| *stated != serde_json::json!({}));
    let has_other_field = merged.pointer("/displacement/mode").is_some_and(|mode| mode != "smooth");
    let has_landmarks = request.get("landmarks").and_then(Value::as_array).is_some_and(|given| !given.is_empty());
    let draws = request.pointer("/registration/initial").is_some_and(|initial| initial == "ransac");
    let asks_for_labels = method == Method::Balanced
        && !names_algorithm
        && (OF_LABELS.iter().any(states) || draws || (has_other_field && has_landmarks));
    if asks_for_labels && let Some(algorithm) = merged.pointer_mut("/inference/algorithm") {
        *algorithm = "max_product".into();
    }
    if !(names_algorithm || asks_for_labels) || request.pointer("/registration/initial").is_some() {
        return;
    }
    let is_none = merged.pointer("/inference/algorithm").is_some_and(|name| name == "none");
    let Some(initial) = merged.pointer_mut("/registration/initial") else { return };
    match (is_none, *initial == "ransac") {
        (true, true) => *initial = "search".into(),
        (false, false) => *initial = "ransac".into(),
        _ => {}
    }
}

/// Overrides `base` with `request`: objects are merged key by key, other values are replaced. Unknown keys are faults.
fn overlay(
    base: &mut Value,
    request: &Value,
    pointer: &mut String,
    names: &[String],
    faults: &mut Vec<ParameterError>,
) {
    match (base, request) {
        (Value::Object(base), Value::Object(request)) => {
            for (key, value) in request {
                let length = pointer.len();
                pointer.push('/');
                pointer.push_str(&key.replace('~', "~0").replace('/', "~1"));
                match base.get_mut(key) {
                    Some(slot) => overlay(slot, value, pointer, names, faults),
                    None => {
                        let mut known: Vec<_> = base.keys().map(String::as_str).collect();
                        known.sort_unstable();
                        // A key known elsewhere is more likely meant than one of similar spelling.
                        let elsewhere = names.iter().find(|name| name.rsplit('.').next() == Some(key));
                        let meant = elsewhere.map(String::as_str).or_else(|| nearest(key, known.iter().copied()));
                        let known = known.join(", ");
                        let detail = format!("unknown key; {}known here are {known}", did_you_mean(meant));
                        faults.push(fault(pointer, "unknown_key", detail));
                    }
                }
                pointer.truncate(length);
            }
        }
        (Value::Object(_), _) => {
            faults.push(fault(pointer, "wrong_type", "an object is needed here".to_owned()));
        }
        (slot, value) => *slot = value.clone(),
    }
}

/// The dotted names of all keys within objects.
fn names(value: &Value, before: String) -> Vec<String> {
    let Value::Object(object) = value else { return Vec::new() };
    let mut found = Vec::new();
    for (key, value) in object {
        let name = if before.is_empty() { key.clone() } else { format!("{before}.{key}") };
        found.extend(names(value, name.clone()));
        found.push(name);
    }
    found
}

fn did_you_mean(name: Option<&str>) -> String {
    name.map_or_else(String::new, |name| format!("did you mean {name}? "))
}

/// The known name within the fewest edits, if these are few for its length.
fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let distances = known.map(|known| (strsim::damerau_levenshtein(name, known), known));
    let (distance, nearest) = distances.min()?;
    (distance <= nearest.len().min(name.len()) / 2).then_some(nearest)
}

/// The required type of a value that has another type.
fn needed(pointer: &str, message: &str) -> String {
    let indices = |name: &str| name.bytes().all(|b| b.is_ascii_digit());
    let dotted = pointer.split('/').skip(1).fold(String::new(), |path, name| match (path.is_empty(), indices(name)) {
        (_, true) => path + "[]",
        (true, false) => name.to_owned(),
        (false, false) => format!("{path}.{name}"),
    });
    if let Some(bounds) = BOUNDS.iter().find(|bounds| bounds.name == dotted) {
        return bounds.demand_of_number();
    }
    if message.starts_with("unknown variant") {
        let mut words = message.split('`').skip(1).step_by(2);
        let given = words.next().unwrap_or_default();
        let known: Vec<&str> = words.collect();
        let meant = did_you_mean(nearest(given, known.iter().copied()));
        return format!("unknown word; {meant}known here are {}", known.join(", "));
    }
    let expected =
        message.rsplit_once("expected ").map(|(_, expected)| expected.split(" at line").next().unwrap_or(""));
    match expected {
        Some("u64" | "u32" | "usize") => "must be a whole number of at least 0".to_owned(),
        Some("i64" | "i32") => "must be a whole number".to_owned(),
        Some("f64" | "f32") => "must be a number".to_owned(),
        Some("a boolean") => "must be true or false".to_owned(),
        Some("a string" | "string or map" | "a borrowed string") => "must be a text".to_owned(),
        Some("a sequence") => "must be a list".to_owned(),
        _ => message.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::{Algorithm, InitialPose};
    use serde_json::json;

    #[test]
    fn an_empty_request_is_the_default_preset() {
        assert_eq!(resolve(&json!({})), Ok(preset(Method::Balanced)));
    }

    #[test]
    fn the_initial_pose_follows_the_algorithm_unless_it_is_stated() {
        let initial = |request: Value| resolve(&request).map(|p| p.registration.initial);
        assert_eq!(initial(json!({})), Ok(InitialPose::Search));
        assert_eq!(initial(json!({"inference": {"algorithm": "sum_product"}})), Ok(InitialPose::Ransac));
        assert_eq!(
            initial(json!({"method": "thesis", "inference": {"algorithm": "none"},
            "clamping": {"mode": "none"}})),
            Ok(InitialPose::Search)
        );
        assert_eq!(initial(json!({"method": "icp", "inference": {"algorithm": "none"}})), Ok(InitialPose::Centroids));
        assert_eq!(initial(json!({"method": "icp", "energy": {"alpha": 2}})), Ok(InitialPose::Centroids));
        let stated = json!({"inference": {"algorithm": "max_product"}, "registration": {"initial": "search"}});
        assert_eq!(initial(stated).unwrap_err()[0].pointer, "/registration/initial");
    }

    #[test]
    fn who_states_something_about_an_energy_of_labels_asks_for_one() {
        let algorithm = |request: Value| resolve(&request).map(|p| p.inference.algorithm);
        let landmark = json!({"source_mm": [0.0, 0.0, 0.0], "target_mm": [1.0, 0.0, 0.0], "sigma_mm": 1.0});
        let nothing = json!({"displacement": {"bending": "none"}, "inference": {}, "seed": 3, "landmarks": [landmark]});
        assert_eq!(algorithm(nothing), Ok(Algorithm::None));
        for request in [
            json!({"energy": {"beta": 0.3}}),
            json!({"inference": {"max_iterations": 5}}),
            json!({"clamping": {"mode": "soft"}}),
            json!({"features": [{"kind": "gaussian_curvature"}]}),
            json!({"registration": {"initial": "ransac"}}),
            json!({"registration": {"max_trials": 50}}),
            json!({"displacement": {"mode": "none"}, "landmarks": [landmark]}),
        ] {
            assert_eq!(algorithm(request.clone()), Ok(Algorithm::MaxProduct), "{request}");
            assert_eq!(resolve(&request).map(|p| p.registration.initial), Ok(InitialPose::Ransac), "{request}");
        }
        let stated = json!({"energy": {"beta": 0.3}, "inference": {"algorithm": "none"}});
        assert_eq!(algorithm(stated), Ok(Algorithm::None));
    }

    #[test]
    fn every_unknown_key_is_named_with_its_place() {
        let faults = resolve(&json!({"energy": {"alfa": 1}, "sed": 3})).unwrap_err();
        let pointers: Vec<_> = faults.iter().map(|f| f.pointer.as_str()).collect();
        assert_eq!(pointers, ["/energy/alfa", "/sed"]);
    }

    #[test]
    fn ranges_and_types_name_their_place() {
        let at = |request: Value| resolve(&request).unwrap_err()[0].pointer.clone();
        assert_eq!(at(json!({"inference": {"damping": 1.0}})), "/inference/damping");
        assert_eq!(at(json!({"energy": {"alpha": "two"}})), "/energy/alpha");
        assert_eq!(
            at(json!({"features": [{"kind": "gaussian_curvature", "scales_mm": [-1.0]}]})),
            "/features/0/scales_mm/0"
        );
        assert_eq!(at(json!({"features": [{"kind": "spin", "scales_mm": [1.0]}]})), "/features/0/kind");
        assert_eq!(at(json!({"method": "magic"})), "/method");
        assert_eq!(at(json!({"energy": 3})), "/energy");
    }

    #[test]
    fn faults_say_what_was_meant_and_what_is_needed() {
        let detail = |request: Value| resolve(&request).unwrap_err()[0].detail.clone();
        assert!(detail(json!({"energy": {"alfa": 1}})).starts_with("unknown key; did you mean alpha? known here are "));
        assert!(detail(json!({"alpha": 1})).starts_with("unknown key; did you mean energy.alpha? known here are "));
        assert!(detail(json!({"zzzzzzzz": 1})).starts_with("unknown key; known here are "));
        assert!(
            detail(json!({"method": "thesys"})).starts_with("unknown method; did you mean thesis? known are balanced")
        );
        assert!(detail(json!({"method": 7})).starts_with("unknown method; known are "));
        assert_eq!(detail(json!({"seed": -1})), "must be a whole number of at least 0");
        assert_eq!(detail(json!({"seed": "one"})), "must be a whole number of at least 0");
        assert_eq!(detail(json!({"both_directions": 1})), "must be true or false");
        let number = detail(json!({"energy": {"alpha": "two"}}));
        assert!(number.starts_with("must be a number from 0 to "), "{number}");
        let whole = detail(json!({"input": {"max_vertices": 1.5}}));
        assert_eq!(whole, "must be a whole number from 100 to 1000000, or null");
        let word = detail(json!({"input": {"surface": "smoth"}}));
        assert_eq!(word, "unknown word; did you mean smooth? known here are smooth, voxel");
        for request in [
            json!({"features": 3}),
            json!({"features": [{"kind": "gaussian_curvature", "scales_mm": "x"}]}),
            json!({"input": {"labels": [1.5]}}),
            json!({"energy": {"alpha": []}}),
            json!({"inference": {"max_iterations": "many"}}),
        ] {
            let said = detail(request);
            for word in ["u64", "u32", "f64", "usize", "sequence", "invalid type", "`"] {
                assert!(!said.contains(word), "{said}");
            }
        }
    }

    #[test]
    fn stored_parameters_resolve_to_themselves() {
        for method in Method::ALL {
            let stored = serde_json::to_value(preset(method)).unwrap();
            assert_eq!(resolve(&stored), Ok(preset(method)));
        }
    }
}
