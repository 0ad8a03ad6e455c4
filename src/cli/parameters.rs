//! Parameters on the command line: a file, then `--set a.b=value`, then dedicated options such as `--seed`, resolved
//! like the parameters of a request.

use super::error::CliError;
use super::files::read_input;
use super::words::describe;
use clap::Args;
use clap::builder::PossibleValuesParser;
use homolog_contract::parameters::{MatchParameters, Method, preset, resolve};
use homolog_run::intake::IntakeLimits;
use serde_json::{Map, Value};
use std::path::PathBuf;

/// Options that set the parameters of inputs.
#[derive(Debug, Clone, Default, Args)]
pub(super) struct InputArgs {
    /// JSON file with parameters, in the form of the HTTP API
    #[arg(long, value_name = "FILE.json")]
    pub(super) params: Option<PathBuf>,
    /// Set one parameter, such as input.smoothing_mm=1 or features.0.weight=2; may be repeated
    #[arg(long = "set", value_name = "A.B=VALUE")]
    pub(super) set: Vec<String>,
    /// Label of the structure in a volume, by number or name; may be repeated; default: all
    #[arg(long = "label", value_name = "NUMBER|NAME")]
    pub(super) labels: Vec<String>,
    /// Repair to allow, instead of the default ones; may be repeated; none: no repair
    #[arg(long = "repair", value_delimiter = ',', value_name = "REPAIR", value_parser = PossibleValuesParser::new(REPAIRS))]
    pub(super) repair: Vec<String>,
    /// Simplify surfaces with more than N vertices to N vertices before they are matched (input.max_vertices)
    #[arg(long, value_name = "N")]
    pub(super) simplify: Option<u32>,
    /// Apply the coordinate transform that a GIFTI file states, or with =false none; default: only a rigid one
    #[arg(long = "apply-transform", value_name = "BOOL", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    pub(super) apply_transform: Option<bool>,
}

/// Options that limit the inputs.
#[derive(Debug, Clone, Default, Args)]
pub(super) struct LimitArgs {
    /// Most vertices of a surface; larger surfaces are refused unless they are simplified
    #[arg(long = "max-vertices", value_name = "N", default_value_t = IntakeLimits::default().max_vertices)]
    max_vertices: usize,
}

impl LimitArgs {
    /// Limits of the command line: the limits of the service, except those that were set. The ratio of faces to
    /// vertices is kept.
    pub(super) fn limits(&self) -> IntakeLimits {
        let usual = IntakeLimits::default();
        let faces_per_vertex = usual.max_faces / usual.max_vertices;
        let max_faces = usual.max_faces.max(self.max_vertices.saturating_mul(faces_per_vertex));
        IntakeLimits { max_vertices: self.max_vertices, max_faces, ..usual }
    }
}

/// Values of `--repair`: the repairs of [`homolog_contract::parameters::Repair`] that can be requested.
const REPAIRS: [&str; 7] = ["weld", "orient", "split", "largest_component", "fill", "triangulate", NO_REPAIR];
const NO_REPAIR: &str = "none";

/// Options that set parameters.
#[derive(Debug, Clone, Default, Args)]
pub(super) struct ParameterArgs {
    /// Method: a preset of all parameters
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(Method::ALL.map(Method::name)))]
    pub(super) method: Option<String>,
    #[command(flatten)]
    pub(super) input: InputArgs,
    /// Label of the structure in the source only; may be repeated
    #[arg(long = "source-label", value_name = "NUMBER|NAME")]
    pub(super) source_labels: Vec<String>,
    /// Label of the structure in the target only; may be repeated
    #[arg(long = "target-label", value_name = "NUMBER|NAME")]
    pub(super) target_labels: Vec<String>,
    /// Mirror this input before it is matched, for example to compare left with right; the answer stays in the
    /// coordinates of the file
    #[arg(long, value_name = "source|target", value_parser = PossibleValuesParser::new(["source", "target"]))]
    pub(super) mirror: Option<String>,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(super) seed: Option<u64>,
}

impl InputArgs {
    /// All parameters, with defaults filled in.
    ///
    /// # Errors
    /// As for [`ParameterArgs::resolve`].
    pub(super) fn resolve(&self) -> Result<MatchParameters, CliError> {
        resolve(&self.request(Vec::new())?).map_err(|faults| CliError::BadInput(describe(&faults)))
    }

    /// The parameters in the form of the HTTP API, with additional settings.
    fn request(&self, more: Vec<Setting>) -> Result<Value, CliError> {
        let mut request = match &self.params {
            None => Value::Object(Map::new()),
            Some(path) => {
                let bytes = read_input(path, &IntakeLimits { max_bytes: 1 << 20, ..IntakeLimits::default() })?;
                serde_json::from_slice(&bytes)
                    .map_err(|e| CliError::BadInput(format!("{} is not JSON: {e}", path.display())))?
            }
        };
        if !request.is_object() {
            return Err(CliError::BadInput("the parameters must be a JSON object".to_owned()));
        }
        let mut settings = self.set.iter().map(|s| parse_setting(s)).collect::<Result<Vec<_>, _>>()?;
        settings.extend(labels_setting("input.labels", &self.labels));
        if !self.repair.is_empty() {
            let repairs = self.repair.iter().filter(|name| *name != NO_REPAIR).map(|name| Value::from(name.as_str()));
            settings.push((names("input.repair"), repairs.collect()));
        }
        settings.extend(self.simplify.map(|n| (names("input.max_vertices"), Value::from(n))));
        settings.extend(self.apply_transform.map(|apply| (names("input.apply_transform"), Value::from(apply))));
        settings.extend(more);
        // The method comes first: indices such as features.0 refer to the lists of its preset.
        settings.sort_by_key(|(path, _)| path.first().is_some_and(|key| key != "method"));
        for (path, value) in settings {
            apply(&mut request, &path, value)?;
        }
        Ok(request)
    }
}

/// The path of a parameter and its value.
type Setting = (Vec<String>, Value);

fn names(dotted: &str) -> Vec<String> {
    dotted.split('.').map(str::to_owned).collect()
}

/// Labels by number, or otherwise by name; nothing if none are given.
fn labels_setting(place: &str, labels: &[String]) -> Option<Setting> {
    let label = |text: &String| text.parse::<u32>().map_or_else(|_| Value::from(text.as_str()), Value::from);
    (!labels.is_empty()).then(|| (names(place), labels.iter().map(label).collect()))
}

impl ParameterArgs {
    /// The parameters in the form of the HTTP API.
    pub(super) fn request(&self) -> Result<Value, CliError> {
        let method = self.method.as_deref().map(|method| (names("method"), Value::from(method)));
        let seed = self.seed.map(|seed| (names("seed"), Value::from(seed)));
        let of_sides = [("input.source.labels", &self.source_labels), ("input.target.labels", &self.target_labels)];
        let of_sides = of_sides.into_iter().filter_map(|(place, labels)| labels_setting(place, labels));
        let mirror = self.mirror.as_deref().map(|side| (names(&format!("input.{side}.mirror")), Value::from(true)));
        self.input.request(method.into_iter().chain(seed).chain(of_sides).chain(mirror).collect())
    }

    /// All parameters, with defaults filled in.
    ///
    /// # Errors
    /// [`CliError::BadInput`] with every fault on its own line.
    pub(super) fn resolve(&self) -> Result<MatchParameters, CliError> {
        resolve(&self.request()?).map_err(|faults| CliError::BadInput(describe(&faults)))
    }
}

/// Splits `a.b=value` into path and value; a value that is not JSON is a string.
fn parse_setting(setting: &str) -> Result<Setting, CliError> {
    let wrong = || CliError::BadInput(format!("--set {setting}: write a.b=value, such as energy.alpha=1.5"));
    let (path, value) = setting.split_once('=').ok_or_else(wrong)?;
    let path: Vec<String> = path.split('.').map(str::to_owned).collect();
    if path.iter().any(String::is_empty) {
        return Err(wrong());
    }
    Ok((path, serde_json::from_str(value).unwrap_or_else(|_| Value::String(value.to_owned()))))
}

/// Sets `value` at `path`. An index refers to the list in the request, or otherwise in the preset.
fn apply(request: &mut Value, path: &[String], value: Value) -> Result<(), CliError> {
    let method = request.get("method").and_then(|m| serde_json::from_value(m.clone()).ok());
    let defaults = serde_json::to_value(preset(method.unwrap_or(Method::Balanced))).unwrap_or_default();
    let mut default = Some(&defaults);
    let mut at = request;
    for (depth, key) in path.iter().enumerate() {
        let here = path[..=depth].join(".");
        let next_is_index = path.get(depth + 1).is_some_and(|k| k.parse::<usize>().is_ok());
        default = default.and_then(|d| match d {
            Value::Array(items) => key.parse::<usize>().ok().and_then(|k| items.get(k)),
            other => other.get(key),
        });
        at = match at {
            Value::Array(items) => {
                let n = items.len();
                key.parse::<usize>().ok().and_then(|k| items.get_mut(k)).ok_or_else(|| {
                    CliError::BadInput(format!("--set {here}: the list has {n} entries, counted from 0"))
                })?
            }
            Value::Object(object) => object.entry(key.clone()).or_insert_with(|| match default {
                Some(list @ Value::Array(_)) if next_is_index => list.clone(),
                _ => Value::Object(Map::new()),
            }),
            _ => {
                return Err(CliError::BadInput(format!(
                    "--set {here}: {} is a value and holds no {key}",
                    path[..depth].join(".")
                )));
            }
        };
    }
    *at = value;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn request(settings: &[&str]) -> Result<Value, String> {
        let input = InputArgs { set: settings.iter().map(|s| (*s).to_owned()).collect(), ..Default::default() };
        ParameterArgs { input, ..Default::default() }.request().map_err(|e| e.to_string())
    }

    #[test]
    fn values_that_are_not_json_are_strings() {
        let stated = request(&["energy.alpha=1.5", "inference.algorithm=sum_product", "input.labels=[1,2]"]);
        let expected = json!({
            "energy": {"alpha": 1.5}, "inference": {"algorithm": "sum_product"}, "input": {"labels": [1, 2]}
        });
        assert_eq!(stated, Ok(expected));
    }

    #[test]
    fn an_index_points_into_the_list_of_the_preset() {
        let resolved = |settings: &[&str]| resolve(&request(settings).unwrap()).unwrap();
        let balanced = resolved(&["features.1.weight=2"]);
        assert_eq!((balanced.features.len(), balanced.features[1].weight), (2, 2.0));
        let thesis = resolved(&["features.0.scales.0=1", "method=thesis"]);
        assert_eq!((thesis.features.len(), thesis.features[0].scales[0]), (1, 1.0));
    }

    #[test]
    fn wrong_settings_say_what_is_wrong() {
        assert!(request(&["alpha"]).unwrap_err().contains("a.b=value"));
        assert!(request(&["energy..alpha=1"]).unwrap_err().contains("a.b=value"));
        assert!(request(&["features.7.weight=1"]).unwrap_err().contains("2 entries"));
        assert!(request(&["seed=1", "seed.x=1"]).unwrap_err().contains("holds no x"));
    }

    #[test]
    fn each_fault_has_a_line_with_its_dotted_name() {
        let input = InputArgs { set: vec!["energy.alfa=1".into(), "sed=1".into()], ..Default::default() };
        let message = ParameterArgs { input, ..Default::default() }.resolve().unwrap_err().to_string();
        let lines: Vec<_> = message.lines().map(|l| l.split(':').next().unwrap()).collect();
        assert_eq!(lines, ["energy.alfa", "sed"]);
    }

    #[test]
    fn options_go_before_settings_and_say_the_same() {
        let args = ParameterArgs {
            method: Some("thesis".into()),
            input: InputArgs {
                set: vec!["method=balanced".into(), "features.0.scales.0=1".into(), "input.labels=9".into()],
                labels: vec!["17".into(), "Left Hippocampus".into()],
                repair: vec!["weld".into(), "fill".into()],
                simplify: Some(5000),
                apply_transform: Some(true),
                ..Default::default()
            },
            target_labels: vec!["53".into()],
            mirror: Some("source".into()),
            seed: Some(7),
            ..Default::default()
        };
        let stated = args.request().unwrap();
        assert_eq!((&stated["method"], &stated["seed"]), (&json!("thesis"), &json!(7)));
        let expected = json!({
            "labels": [17, "Left Hippocampus"], "repair": ["weld", "fill"], "target": {"labels": [53]},
            "source": {"mirror": true},
            "max_vertices": 5000, "apply_transform": true
        });
        assert_eq!(stated["input"], expected);
        assert_eq!(args.resolve().unwrap().features.len(), 1);
        let none = InputArgs { repair: vec!["none".into()], ..Default::default() };
        assert_eq!(none.resolve().unwrap().input.repair, Some(Vec::new()));
    }

    #[test]
    fn every_repair_that_can_be_asked_for_has_a_name_here() {
        for name in REPAIRS.into_iter().filter(|name| *name != NO_REPAIR) {
            serde_json::from_value::<homolog_contract::parameters::Repair>(json!(name)).unwrap();
        }
    }
}
