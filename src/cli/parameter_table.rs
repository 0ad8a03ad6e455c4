//! `homolog parameters`: prints `docs/parameters.md`.
//!
//! Everything on that page that the program knows is generated: names, types and descriptions come from the OpenAPI
//! document, defaults from the presets, and ranges from the program's answers to values that it refuses.

use super::error::CliError;
use super::output::print;
use crate::http::openapi_json;
use homolog_contract::parameters::{Method, preset, resolve};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The sources that define the enumerations of the parameters. The OpenAPI document lists their values without
/// meanings.
const ENUMERATIONS: [&str; 5] = [
    include_str!("../../crates/contract/src/parameters/displacement.rs"),
    include_str!("../../crates/contract/src/parameters/energy.rs"),
    include_str!("../../crates/contract/src/parameters/inference.rs"),
    include_str!("../../crates/contract/src/parameters/input.rs"),
    include_str!("../../crates/contract/src/parameters/registration.rs"),
];

/// Sections of the page, in the order of the pipeline. Parameters without a section are in the first table.
const SECTIONS: [&str; 8] =
    ["input", "features", "energy", "inference", "clamping", "registration", "displacement", "landmarks"];

const HEAD: &str = "# Parameters of a match

<!-- Generated: `make api` writes this file from the schema, the presets and the range checks. Do not edit it. -->

The service takes parameters as a JSON object, `homolog match` as `--params FILE.json` or as `--set energy.alpha=1.5`
(`--set features.0.weight=2` for an entry of a list). `method` names a preset; every other key changes a value of it.
Unknown keys, wrong types and values out of range are refused, each with a JSON pointer. The effective parameters come
back with the result. [method.md](method.md) explains what they do, [defaults.md](defaults.md) how the defaults were
chosen.

";

/// Prints the page.
pub(super) fn print_parameters() -> Result<(), CliError> {
    let page = page().map_err(|e| CliError::Failed(e.to_string()))?;
    print(page.trim_end())
}

fn page() -> Result<String, serde_json::Error> {
    let document: Value = serde_json::from_str(&openapi_json()?)?;
    let table = Table { schemas: &document["components"]["schemas"], meanings: meanings() };
    let defaults = serde_json::to_value(preset(Method::Balanced))?;
    let mut page = HEAD.to_owned();
    presets(&mut page, &defaults)?;
    let root = &table.schemas["MatchParameters"]["properties"];
    let mut general = Vec::new();
    for (name, schema) in members(root).filter(|(name, _)| !SECTIONS.contains(name)) {
        general.push(table.row(&[name], schema, Some(&defaults[name])));
    }
    section(&mut page, "General", "", &general);
    for name in SECTIONS {
        let schema = &root[name];
        let description = schema["description"].as_str().unwrap_or_default();
        let mut rows = Vec::new();
        if schema["type"] == "array" {
            let entry = entry_defaults(name);
            rows.push(table.row(&[name], schema, Some(&shortened(&defaults[name], &entry))));
            let (item, _) = table.target(&schema["items"]);
            for (key, member) in members(&item["properties"]) {
                let is_required = list(&item["required"]).any(|required| required == key);
                rows.push(table.row(&[name, "0", key], member, (!is_required).then_some(&entry[key])));
            }
        } else {
            table.rows(&mut vec![name], schema, &defaults[name], &mut rows);
        }
        section(&mut page, &format!("`{name}`"), description, &rows);
    }
    Ok(page)
}

/// The differences between each preset and the default.
fn presets(page: &mut String, defaults: &Value) -> Result<(), serde_json::Error> {
    page.push_str("## Presets\n\n| `method` | what it does | changes against `balanced` |\n|---|---|---|\n");
    for method in Method::ALL {
        let mut changes = Vec::new();
        differences(defaults, &serde_json::to_value(preset(method))?, &mut Vec::new(), &mut changes);
        changes.retain(|change| !change.starts_with("`method`"));
        let changes = if changes.is_empty() { "none: this is the default".to_owned() } else { changes.join("<br>") };
        let _ = writeln!(page, "| `{}` | {} | {changes} |", method.name(), cell(method.description()));
    }
    page.push('\n');
    Ok(())
}

fn section(page: &mut String, title: &str, description: &str, rows: &[String]) {
    let _ = write!(page, "## {title}\n\n");
    if !description.is_empty() {
        let _ = write!(page, "{}\n\n", description.replace('\n', " "));
    }
    page.push_str("| parameter | type | allowed | default | meaning |\n|---|---|---|---|---|\n");
    page.extend(rows.iter().map(String::as_str));
    page.push('\n');
}

struct Table<'a> {
    /// The component schemas of the OpenAPI document.
    schemas: &'a Value,
    /// The meaning of each value of an enumeration, by the enumeration's name and the value.
    meanings: BTreeMap<(String, String), String>,
}

impl Table<'_> {
    /// A row for each parameter below `path`.
    fn rows<'p>(&'p self, path: &mut Vec<&'p str>, schema: &'p Value, default: &Value, rows: &mut Vec<String>) {
        let (target, _) = self.target(schema);
        match target.get("properties") {
            Some(properties) => {
                for (name, member) in members(properties) {
                    path.push(name);
                    self.rows(path, member, &default[name], rows);
                    path.pop();
                }
            }
            None => rows.push(self.row(path, schema, Some(default))),
        }
    }

    /// One row; without a default the parameter is required.
    fn row(&self, path: &[&str], schema: &Value, default: Option<&Value>) -> String {
        let name = path.join(".").replace(".0", "[]");
        let (target, enumeration) = self.target(schema);
        let mut meaning = schema["description"].as_str().unwrap_or_default().to_owned();
        let (items, item_enumeration) = self.target(&target["items"]);
        let (values, enumeration) =
            if items["enum"].is_array() { (items, item_enumeration) } else { (target, enumeration) };
        let mut allowed = Vec::new();
        for value in list(&values["enum"]) {
            let key = (enumeration.to_owned(), value.to_owned());
            if let Some(text) = self.meanings.get(&key) {
                let _ = write!(meaning, "<br>`{value}`: {text}");
            }
            allowed.push(format!("`{value}`"));
        }
        let mut allowed = vec![allowed.join(", ")];
        allowed.extend(ranges(path, target, values["enum"].is_array()));
        allowed.retain(|text| !text.is_empty());
        let default = default.map_or("required".to_owned(), |value| format!("`{value}`"));
        format!(
            "| `{name}` | {} | {} | {} | {} |\n",
            cell(&self.type_of(target, &name)),
            cell(&allowed.join("; ")),
            cell(&default),
            cell(&meaning)
        )
    }

    fn type_of(&self, schema: &Value, name: &str) -> String {
        let unit = [("_mm", ", mm"), ("_bits", ", bits"), ("_ms", ", ms"), ("_deg", ", degrees")]
            .into_iter()
            .find_map(|(suffix, unit)| name.ends_with(suffix).then_some(unit))
            .unwrap_or_default();
        let types: Vec<&str> = match &schema["type"] {
            Value::Array(types) => types.iter().filter_map(Value::as_str).collect(),
            other => other.as_str().into_iter().collect(),
        };
        if let Some(choices) = schema["oneOf"].as_array() {
            let names: Vec<String> = choices.iter().map(|choice| self.type_of(self.target(choice).0, "")).collect();
            return names.join(" or ");
        }
        let names: Vec<String> = types
            .into_iter()
            .map(|kind| match kind {
                "array" => {
                    let items = self.type_of(self.target(&schema["items"]).0, "");
                    format!("list of {}s", items.replace(" or ", "s or "))
                }
                "string" if schema["enum"].is_array() => "name".to_owned(),
                other => other.to_owned(),
            })
            .collect();
        names.join(" or ") + unit
    }

    /// The schema that a reference names, with that name; any other schema unchanged.
    fn target<'s>(&'s self, schema: &'s Value) -> (&'s Value, &'s str) {
        let name = schema["$ref"].as_str().and_then(|path| path.rsplit('/').next());
        name.map_or((schema, ""), |name| (&self.schemas[name], name))
    }
}

/// The allowed values of the parameter at `path`, from the program's message when it refuses a value.
fn ranges(path: &[&str], schema: &Value, is_enumeration: bool) -> Vec<String> {
    let is = |kind: &str| schema["type"] == kind || list(&schema["type"]).any(|t| t == kind);
    let probes: Vec<Value> = if is_enumeration {
        list(&schema["enum"]).map(Value::from).collect()
    } else if is("integer") {
        vec![json!(u32::MAX), json!(0)]
    } else if is("number") {
        vec![json!(f64::MAX), json!(f64::MIN)]
    } else if is("array") {
        vec![json!([]), json!([f64::MAX]), json!([0]), json!([f64::MAX, 0.0, 0.0])]
    } else if is("boolean") {
        return vec!["`true`, `false`".to_owned()];
    } else {
        Vec::new()
    };
    let pointer = format!("/{}", path.join("/"));
    let mut found: Vec<String> = Vec::new();
    for probe in probes {
        for fault in resolve(&request(path, probe)).err().unwrap_or_default() {
            let is_here = fault.pointer.strip_prefix(&pointer).is_some_and(|rest| rest.len() <= 2);
            let text = ["must be ", "state "].iter().find_map(|verb| fault.detail.strip_prefix(verb));
            let text = text.unwrap_or(&fault.detail).to_owned();
            if fault.code == "out_of_range" && is_here && !found.contains(&text) {
                found.push(text);
            }
        }
    }
    if found.is_empty() {
        let bounds = [("minimum", "at least", ""), ("maximum", "at most", ""), ("maxItems", "at most", " entries")];
        let stated =
            bounds.iter().filter_map(|(key, limit, what)| Some(format!("{limit} {}{what}", schema.get(*key)?)));
        found.extend(stated);
    }
    found
}

/// A request that sets one parameter. Entries of lists get their required members.
fn request(path: &[&str], value: Value) -> Value {
    match path {
        [] => value,
        [list, "0", key] => {
            let mut entry = smallest_entry(list);
            entry[*key] = value;
            json!({ *list: [entry] })
        }
        [first, rest @ ..] => json!({ *first: request(rest, value) }),
    }
}

/// An entry of a list of objects with only its required members.
fn smallest_entry(list: &str) -> Value {
    match list {
        "features" => json!({ "kind": "gaussian_curvature" }),
        _ => json!({ "source_mm": [0.0, 0.0, 0.0], "target_mm": [0.0, 0.0, 0.0] }),
    }
}

/// The defaults of an entry of a list of objects.
fn entry_defaults(list: &str) -> Value {
    let resolved = resolve(&json!({ list: [smallest_entry(list)] })).ok();
    resolved.and_then(|parameters| serde_json::to_value(parameters).ok()).map_or(Value::Null, |p| p[list][0].clone())
}

/// A list of objects without the members that have their default values, except required ones.
fn shortened(entries: &Value, defaults: &Value) -> Value {
    let Value::Array(entries) = entries else { return entries.clone() };
    let short = entries.iter().map(|entry| {
        let kept = members(entry).filter(|(key, value)| *key == "kind" || **value != defaults[*key]);
        kept.map(|(key, value)| (key.to_owned(), value.clone())).collect::<serde_json::Map<_, _>>().into()
    });
    Value::Array(short.collect())
}

/// Every value of `changed` that differs from `base`, as `name`: value.
fn differences(base: &Value, changed: &Value, path: &mut Vec<String>, found: &mut Vec<String>) {
    let keys: Vec<String> = match (base, changed) {
        (Value::Object(base), Value::Object(_)) => base.keys().cloned().collect(),
        (Value::Array(base), Value::Array(changed)) if base.iter().chain(changed).all(Value::is_object) => {
            (0..base.len().max(changed.len())).map(|k| k.to_string()).collect()
        }
        _ if base == changed => return,
        _ if changed.is_null() && !path.is_empty() && base.is_object() => {
            found.push(format!("without `{}`", path.join(".")));
            return;
        }
        _ => {
            found.push(format!("`{}`: `{changed}`", path.join(".")));
            return;
        }
    };
    let member = |value: &Value, key: &str| match value {
        Value::Array(entries) => key.parse::<usize>().ok().and_then(|k| entries.get(k)).cloned().unwrap_or_default(),
        other => other[key].clone(),
    };
    for key in keys {
        let (before, after) = (member(base, &key), member(changed, &key));
        path.push(key);
        differences(&before, &after, path, found);
        path.pop();
    }
}

/// The meaning of each value of each enumeration: the doc comments of its variants.
fn meanings() -> BTreeMap<(String, String), String> {
    let mut found = BTreeMap::new();
    for source in ENUMERATIONS {
        let (mut enumeration, mut text) = (None, String::new());
        for line in source.lines() {
            let code = line.trim();
            if let Some(words) = code.strip_prefix("///") {
                text.push_str(words);
            } else if let Some(name) = code.strip_prefix("pub enum ") {
                enumeration = Some(name.trim_end_matches(" {").to_owned());
                text.clear();
            } else if let (Some(name), Some(variant)) = (&enumeration, code.strip_suffix(',')) {
                found.insert((name.clone(), snake_case(variant)), text.trim().to_owned());
                text.clear();
            } else if !code.starts_with("#[") {
                text.clear();
                if code == "}" {
                    enumeration = None;
                }
            }
        }
    }
    found
}

/// `MaxProduct` as `max_product`, the form that serde writes.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for (k, letter) in name.chars().enumerate() {
        if letter.is_uppercase() && k > 0 {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

fn members(object: &Value) -> impl Iterator<Item = (&str, &Value)> {
    object.as_object().into_iter().flatten().map(|(name, value)| (name.as_str(), value))
}

fn list(values: &Value) -> impl Iterator<Item = &str> {
    values.as_array().into_iter().flatten().filter_map(Value::as_str)
}

/// Text as a cell of a Markdown table.
fn cell(text: &str) -> String {
    text.replace('\n', " ").replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_parameter_has_a_row_and_every_value_a_meaning() {
        let page = page().unwrap();
        let mut leaves = Vec::new();
        leaves_of(&serde_json::to_value(preset(Method::Balanced)).unwrap(), String::new(), &mut leaves);
        assert!(leaves.len() > 40, "{leaves:?}");
        for name in leaves {
            assert!(page.contains(&format!("| `{name}` |")), "{name} has no row");
        }
        let document: Value = serde_json::from_str(&openapi_json().unwrap()).unwrap();
        let meanings = meanings();
        for name in
            ["Algorithm", "ClampingMode", "CurvatureEstimator", "FeatureKind", "InitialPose", "Precisions", "Repair"]
        {
            let values: Vec<&str> = list(&document["components"]["schemas"][name]["enum"]).collect();
            assert!(!values.is_empty(), "{name} is no enumeration of the document");
            for value in values {
                let meaning = meanings.get(&(name.to_owned(), value.to_owned()));
                assert!(meaning.is_some_and(|text| !text.is_empty()), "{name} {value} has no meaning");
            }
        }
    }

    /// The dotted names of all values; `[]` stands for any entry of a list of objects.
    fn leaves_of(value: &Value, name: String, leaves: &mut Vec<String>) {
        match value {
            Value::Object(object) => {
                for (key, member) in object {
                    leaves_of(member, if name.is_empty() { key.clone() } else { format!("{name}.{key}") }, leaves);
                }
            }
            Value::Array(entries) if entries.first().is_some_and(Value::is_object) => {
                leaves_of(&entries[0], format!("{name}[]"), leaves);
            }
            _ => leaves.push(name),
        }
    }

    #[test]
    fn ranges_are_those_of_the_checks() {
        let of = |path: &[&str], schema: Value| ranges(path, &schema, false).join("; ");
        assert_eq!(of(&["energy", "alpha"], json!({"type": "number"})), "from 0 to 1000");
        assert_eq!(of(&["inference", "max_iterations"], json!({"type": "integer"})), "from 1 to 100000");
        assert!(of(&["features", "0", "weight"], json!({"type": "number"})).contains("at most 100"));
        assert!(of(&["features", "0", "scales_mm"], json!({"type": "array"})).contains("1 to 8"));
    }

    #[test]
    fn a_preset_shows_what_it_changes() {
        let mut changes = Vec::new();
        let base = json!({"a": 1, "b": [{"c": 1}, {"c": 2}], "d": [1, 2]});
        differences(&base, &json!({"a": 1, "b": [{"c": 3}], "d": [1]}), &mut Vec::new(), &mut changes);
        assert_eq!(changes, ["`b.0.c`: `3`", "without `b.1`", "`d`: `[1]`"]);
    }
}
