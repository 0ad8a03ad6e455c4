//! From a request to effective parameters, with a JSON pointer to every fault.

use super::ranges::fault;
use super::{MatchParameters, Method, ParameterError, preset};
use serde_json::Value;

/// The effective parameters of a request: the preset that its `method` names, overridden by its values.
///
/// # Errors
/// Every fault found, each with its JSON pointer: unknown keys, wrong types, values out of range.
pub fn resolve(request: &Value) -> Result<MatchParameters, Vec<ParameterError>> {
    let method = match request.get("method") {
        None => Method::Balanced,
        Some(name) => serde_json::from_value(name.clone()).map_err(|_| {
            let known: Vec<_> = Method::ALL.iter().map(|m| m.name()).collect();
            vec![fault("/method", "out_of_range", format!("unknown method; known are {}", known.join(", ")))]
        })?,
    };
    let mut merged = serde_json::to_value(preset(method)).unwrap_or(Value::Null);
    let mut faults = Vec::new();
    overlay(&mut merged, request, &mut String::new(), &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let parameters: MatchParameters = serde_path_to_error::deserialize(merged).map_err(|e| {
        let pointer = format!("/{}", e.path().to_string().replace(['.', '['], "/").replace(']', ""));
        vec![fault(&pointer, "wrong_type", e.inner().to_string())]
    })?;
    parameters.check().map(|()| parameters)
}

/// Overrides `base` with `request`: objects are merged key by key, other values are replaced. Unknown keys are faults.
fn overlay(base: &mut Value, request: &Value, pointer: &mut String, faults: &mut Vec<ParameterError>) {
    match (base, request) {
        (Value::Object(base), Value::Object(request)) => {
            for (key, value) in request {
                let length = pointer.len();
                pointer.push('/');
                pointer.push_str(&key.replace('~', "~0").replace('/', "~1"));
                match base.get_mut(key) {
                    Some(slot) => overlay(slot, value, pointer, faults),
                    None => {
                        let mut known: Vec<_> = base.keys().map(String::as_str).collect();
                        known.sort_unstable();
                        faults.push(fault(
                            pointer,
                            "unknown_key",
                            format!("unknown key; known here are {}", known.join(", ")),
                        ));
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

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn an_empty_request_is_the_default_preset() {
        assert_eq!(resolve(&json!({})), Ok(preset(Method::Balanced)));
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
        assert_eq!(at(json!({"inference": {"message_bits": 8}})), "/inference/message_bits");
        assert_eq!(
            at(json!({"features": [{"kind": "gaussian_curvature", "scales_mm": [-1.0]}]})),
            "/features/0/scales_mm/0"
        );
        assert_eq!(at(json!({"features": [{"kind": "spin", "scales_mm": [1.0]}]})), "/features/0/kind");
        assert_eq!(at(json!({"method": "magic"})), "/method");
        assert_eq!(at(json!({"energy": 3})), "/energy");
    }

    #[test]
    fn stored_parameters_resolve_to_themselves() {
        for method in Method::ALL {
            let stored = serde_json::to_value(preset(method)).unwrap();
            assert_eq!(resolve(&stored), Ok(preset(method)));
        }
    }

    #[test]
    fn half_precision_messages_require_flooding_over_all_labels() {
        let resolved = |inference: Value| resolve(&json!({"inference": inference}));
        for update in ["sparse", "full"] {
            for algorithm in ["max_product", "sum_product"] {
                let request = json!({"message_bits": 16, "update": update, "algorithm": algorithm});
                assert_eq!(resolved(request).unwrap().inference.message_bits, 16);
            }
        }
        for request in [json!({"update": "active"}), json!({"schedule": "residual"}), json!({"algorithm": "gibbs"})] {
            assert!(resolved(request.clone()).is_ok());
            let mut request = request;
            request["message_bits"] = 16.into();
            let faults = resolved(request).unwrap_err();
            assert_eq!(faults[0].pointer, "/inference/message_bits");
        }
    }
}
