//! Parameters on the command line: a file, then `--set a.b=value`, then `--seed`, resolved like those of a request.

use super::error::CliError;
use super::files::read_input;
use clap::Args;
use homolog_contract::parameters::{MatchParameters, Method, ParameterError, preset, resolve};
use homolog_run::intake::IntakeLimits;
use serde_json::{Map, Value};
use std::path::PathBuf;

/// Options that set parameters.
#[derive(Debug, Clone, Default, Args)]
pub(super) struct ParameterArgs {
    /// JSON file with parameters, in the form of the HTTP API
    #[arg(long, value_name = "FILE.json")]
    pub(super) params: Option<PathBuf>,
    /// Set one parameter, such as energy.alpha=1.5, features.0.weight=2 or method=thesis; may be repeated
    #[arg(long = "set", value_name = "A.B=VALUE")]
    pub(super) set: Vec<String>,
    /// Seed of the random numbers
    #[arg(long)]
    pub(super) seed: Option<u64>,
}

impl ParameterArgs {
    /// The parameters in the form of the HTTP API.
    pub(super) fn request(&self) -> Result<Value, CliError> {
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
        // The method first: its preset has the lists that indices such as features.0 refer to.
        settings.sort_by_key(|(path, _)| path.first().is_some_and(|key| key != "method"));
        for (path, value) in settings {
            apply(&mut request, &path, value)?;
        }
        if let (Some(seed), Some(object)) = (self.seed, request.as_object_mut()) {
            object.insert("seed".to_owned(), seed.into());
        }
        Ok(request)
    }

    /// All parameters, with defaults filled in.
    ///
    /// # Errors
    /// [`CliError::BadInput`] with every fault on its own line.
    pub(super) fn resolve(&self) -> Result<MatchParameters, CliError> {
        resolve(&self.request()?).map_err(|faults| CliError::BadInput(describe(&faults)))
    }
}

/// One line for each fault, with its pointer.
pub(super) fn describe(faults: &[ParameterError]) -> String {
    let lines: Vec<_> = faults
        .iter()
        .map(|f| format!("{}: {} ({})", if f.pointer.is_empty() { "/" } else { &f.pointer }, f.detail, f.code))
        .collect();
    lines.join("\n")
}

/// Splits `a.b=value` into path and value; a value that is not JSON is a string.
fn parse_setting(setting: &str) -> Result<(Vec<String>, Value), CliError> {
    let wrong = || CliError::BadInput(format!("--set {setting}: write a.b=value, such as energy.alpha=1.5"));
    let (path, value) = setting.split_once('=').ok_or_else(wrong)?;
    let path: Vec<String> = path.split('.').map(str::to_owned).collect();
    if path.iter().any(String::is_empty) {
        return Err(wrong());
    }
    Ok((path, serde_json::from_str(value).unwrap_or_else(|_| Value::String(value.to_owned()))))
}

/// Puts `value` at `path`. An index refers to the list in the request, or else in the preset.
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
        let args = ParameterArgs { set: settings.iter().map(|s| (*s).to_owned()).collect(), ..Default::default() };
        args.request().map_err(|e| e.to_string())
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
    fn each_fault_has_a_line_with_its_pointer() {
        let args = ParameterArgs { set: vec!["energy.alfa=1".into(), "sed=1".into()], ..Default::default() };
        let message = args.resolve().unwrap_err().to_string();
        let lines: Vec<_> = message.lines().map(|l| l.split(':').next().unwrap()).collect();
        assert_eq!(lines, ["/energy/alfa", "/sed"]);
    }
}
