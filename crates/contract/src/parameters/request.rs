//! The schemas of the parameters for the OpenAPI document: the schemas of a request, in which every value is optional,
//! and the effective ones, in which every value is stated. Both have the bounds of [`BOUNDS`] and [`LENGTHS`], which
//! the check of a request enforces.

use super::ranges::{BOUNDS, LENGTHS};
use super::{LabelChoice, MatchParameters};
use serde_json::{Map, Number, Value};
use std::collections::BTreeMap;
use utoipa::openapi::schema::Schema;
use utoipa::openapi::{Ref, RefOr};
use utoipa::{PartialSchema, ToSchema};

/// Prefix of the names of request schemas: `PartialParameters`, `PartialEnergyParameters`.
const PARTIAL: &str = "Partial";
const ROOT: &str = "MatchParameters";
const REFERENCE: &str = "#/components/schemas/";
/// Groups of parameters that a request may state in part. Entries of lists replace the preset's, and are complete.
const GROUPS: [&str; 8] = [
    "InputParameters",
    "SideParameters",
    "EnergyParameters",
    "InferenceParameters",
    "AnnealingParameters",
    "ClampingParameters",
    "RegistrationParameters",
    "DisplacementParameters",
];

/// The parameters of a request: those that differ from the preset named by `method`.
#[derive(Debug, Clone, Copy)]
pub struct PartialParameters;

impl PartialSchema for PartialParameters {
    fn schema() -> RefOr<Schema> {
        let schema = parameter_schemas().remove(Self::name().as_ref());
        schema.unwrap_or_else(|| Ref::from_schema_name(Self::name()).into())
    }
}

impl ToSchema for PartialParameters {
    fn name() -> std::borrow::Cow<'static, str> {
        "PartialParameters".into()
    }
}

/// The schemas of the parameters by name, with every bound: the effective ones, and those of requests.
pub fn parameter_schemas() -> BTreeMap<String, RefOr<Schema>> {
    let mut named = Vec::new();
    MatchParameters::schemas(&mut named);
    named.push((ROOT.to_owned(), MatchParameters::schema()));
    let mut schemas: Map<String, Value> =
        named.into_iter().filter_map(|(name, schema)| Some((name, serde_json::to_value(schema).ok()?))).collect();
    for bounds in BOUNDS {
        let Some(schema) = place(&mut schemas, bounds.name) else { continue };
        let minimum = if bounds.exclusive_minimum { "exclusiveMinimum" } else { "minimum" };
        let maximum = if bounds.exclusive_maximum { "exclusiveMaximum" } else { "maximum" };
        schema.retain(|key, _| !["minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"].contains(&key.as_str()));
        // JSON can express only finite numbers.
        if bounds.maximum < f64::MAX {
            schema.insert(minimum.to_owned(), number(bounds.minimum));
            schema.insert(maximum.to_owned(), number(bounds.maximum));
        }
        if !bounds.unit.is_empty() {
            schema.insert("x-unit".to_owned(), bounds.unit.into());
        }
    }
    for list in LENGTHS {
        let Some(schema) = place(&mut schemas, list.name) else { continue };
        schema.insert("minItems".to_owned(), list.minimum.into());
        schema.insert("maxItems".to_owned(), list.maximum.into());
    }
    for point in ["landmarks[].source_mm", "landmarks[].target_mm"] {
        let Some(schema) = place(&mut schemas, point) else { continue };
        schema.insert("minItems".to_owned(), 3.into());
        schema.insert("maxItems".to_owned(), 3.into());
    }
    for labels in ["input.labels", "input.source.labels", "input.target.labels"] {
        if let Some(schema) = place(&mut schemas, labels) {
            schema.insert("minItems".to_owned(), 1.into());
        }
    }
    // Label 0 is the background.
    if let Some(number) = schemas.get_mut(LabelChoice::name().as_ref()).and_then(|s| s.pointer_mut("/oneOf/0")) {
        number["minimum"] = 1.into();
    }
    for name in GROUPS.into_iter().chain([ROOT]) {
        if let Some(mut schema) = schemas.get(name).cloned() {
            make_partial(&mut schema);
            schemas.insert(partial(name), schema);
        }
    }
    if let Some(root) = schemas.get_mut(PartialParameters::name().as_ref()) {
        root["description"] =
            "Parameters that differ from the preset that `method` names; `{}` for the defaults.".into();
    }
    let read = |(name, schema): (String, Value)| Some((name, serde_json::from_value(schema).ok()?));
    schemas.into_iter().filter_map(read).collect()
}

/// The name of the schema of requests.
fn partial(name: &str) -> String {
    if name == ROOT { PartialParameters::name().into_owned() } else { format!("{PARTIAL}{name}") }
}

/// Makes every value optional, and redirects references to groups to the groups of requests.
fn make_partial(schema: &mut Value) {
    let Value::Object(fields) = schema else { return };
    fields.remove("required");
    for property in fields.get_mut("properties").and_then(Value::as_object_mut).into_iter().flat_map(Map::values_mut) {
        let Some(Value::String(reference)) = property.get_mut("$ref") else { continue };
        if let Some(name) = reference.strip_prefix(REFERENCE).filter(|name| GROUPS.contains(name)) {
            *reference = format!("{REFERENCE}{}", partial(name));
        }
    }
}

/// The schema of the value with this dotted name, such as `features[].scales[]`.
fn place<'s>(schemas: &'s mut Map<String, Value>, name: &str) -> Option<&'s mut Map<String, Value>> {
    let mut component = ROOT.to_owned();
    let mut pointer = String::new();
    for part in name.split('.') {
        let key = part.trim_end_matches("[]");
        pointer.push_str("/properties/");
        pointer.push_str(key);
        let n_lists = (part.len() - key.len()) / 2;
        (0..n_lists).for_each(|_| pointer.push_str("/items"));
        let reference = schemas.get(&component)?.pointer(&pointer)?.get("$ref").and_then(Value::as_str);
        if let Some(next) = reference.and_then(|reference| reference.strip_prefix(REFERENCE)) {
            component = next.to_owned();
            pointer.clear();
        }
    }
    schemas.get_mut(&component)?.pointer_mut(&pointer)?.as_object_mut()
}

/// A whole number without a fraction.
fn number(value: f64) -> Value {
    if value.fract() == 0.0 && value.abs() < 1e15 {
        return Value::from(value as i64);
    }
    Number::from_f64(value).map_or(Value::Null, Value::Number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn schemas() -> Map<String, Value> {
        let made = parameter_schemas().into_iter();
        made.map(|(name, schema)| (name, serde_json::to_value(schema).unwrap())).collect()
    }

    #[test]
    fn every_bound_stands_in_both_schemas() {
        let mut schemas = schemas();
        let mut of_requests = schemas.clone();
        // The schemas of requests, under the names of the effective ones.
        for name in GROUPS.into_iter().chain([ROOT]) {
            let mut schema = of_requests.remove(&partial(name)).unwrap();
            let text = schema.to_string().replace(&format!("{REFERENCE}{PARTIAL}"), REFERENCE);
            schema = serde_json::from_str(&text).unwrap();
            assert!(schema.get("required").is_none() && schema["additionalProperties"] == false, "{name}");
            of_requests.insert(name.to_owned(), schema);
        }
        for schemas in [&mut schemas, &mut of_requests] {
            for bounds in BOUNDS {
                let schema = place(schemas, bounds.name).unwrap_or_else(|| panic!("no schema of {}", bounds.name));
                let (low, high) = match (bounds.exclusive_minimum, bounds.exclusive_maximum) {
                    (false, false) => ("minimum", "maximum"),
                    (true, false) => ("exclusiveMinimum", "maximum"),
                    (false, true) => ("minimum", "exclusiveMaximum"),
                    (true, true) => ("exclusiveMinimum", "exclusiveMaximum"),
                };
                if bounds.maximum < f64::MAX {
                    assert_eq!(schema[low].as_f64(), Some(bounds.minimum), "{}", bounds.name);
                    assert_eq!(schema[high].as_f64(), Some(bounds.maximum), "{}", bounds.name);
                }
                let takes_null = schema["type"].as_array().is_some_and(|types| types.contains(&"null".into()));
                assert_eq!(takes_null, bounds.nullable, "{}", bounds.name);
                assert_eq!(schema.get("x-unit").and_then(Value::as_str).unwrap_or(""), bounds.unit);
                let is_element = bounds.name.ends_with("[]");
                assert!(is_element || schema["description"].is_string(), "{} is not described", bounds.name);
            }
            for list in LENGTHS {
                let schema = place(schemas, list.name).unwrap();
                assert_eq!((&schema["minItems"], &schema["maxItems"]), (&list.minimum.into(), &list.maximum.into()));
            }
        }
    }
}
