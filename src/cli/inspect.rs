//! `homolog inspect FILE`: the format of a file, the topology of its surface, and the repairs that a match would make.

use super::error::CliError;
use super::files::{file_name, read_input};
use super::output::{print, print_json};
use super::parameters::{InputArgs, LimitArgs};
use clap::Args;
use homolog_run::intake::{inspect, prepare_surface};
use serde_json::Value;
use std::path::PathBuf;

/// Show format, topology and repairs of a surface or label volume
#[derive(Debug, Clone, Args)]
pub(super) struct InspectArgs {
    /// File to inspect: a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label volume (NIfTI, MGZ, NRRD,
    /// MetaImage, DICOM SEG)
    pub(super) file: PathBuf,
    /// Print the report as JSON
    #[arg(long)]
    pub(super) json: bool,
    #[command(flatten)]
    pub(super) parameters: InputArgs,
    #[command(flatten)]
    pub(super) limits: LimitArgs,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::BadInput`] for a file that cannot be read. A surface that a match would refuse is not an error.
pub(super) fn run(args: &InspectArgs) -> Result<(), CliError> {
    let limits = args.limits.limits();
    let parameters = args.parameters.resolve()?;
    let bytes = read_input(&args.file, &limits)?;
    let report = inspect(&bytes, file_name(&args.file), &parameters.input, &limits)
        .map_err(|e| CliError::BadInput(format!("{}: {e}", args.file.display())))?;
    if args.json {
        return print_json(&report);
    }
    let is_refused = report.refusal.is_some();
    let mut report = serde_json::to_value(&report)
        .map_err(|e| CliError::Failed(format!("the report cannot be written as JSON: {e}")))?;
    // The report has the parameters of an API request; a terminal gets the option that sets them.
    if is_refused && let Err(error) = prepare_surface(&bytes, file_name(&args.file), &parameters.input, &limits) {
        report["refusal"]["detail"] = error.for_command_line().into();
    }
    let mut lines = Vec::new();
    flatten(&report, 0, &mut lines);
    print(&lines.join("\n"))
}

/// A document as indented `name  value` lines.
fn flatten(value: &Value, depth: usize, lines: &mut Vec<String>) {
    let indent = "  ".repeat(depth);
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                match value {
                    Value::Object(_) => {
                        lines.push(format!("{indent}{key}"));
                        flatten(value, depth + 1, lines);
                    }
                    Value::Array(items) if items.iter().any(Value::is_object) => {
                        lines.push(format!("{indent}{key}"));
                        items.iter().for_each(|item| flatten(item, depth + 1, lines));
                    }
                    Value::Array(items) => {
                        let items: Vec<_> = items.iter().map(plain).collect();
                        let items = if items.is_empty() { "none".to_owned() } else { items.join(", ") };
                        lines.push(format!("{indent}{key:<width$} {items}", width = 26 - 2 * depth.min(10)));
                    }
                    _ => lines.push(format!("{indent}{key:<width$} {}", plain(value), width = 26 - 2 * depth.min(10))),
                }
            }
        }
        other => lines.push(format!("{indent}{}", plain(other))),
    }
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Null => "none".to_owned(),
        Value::Bool(yes) => if *yes { "yes" } else { "no" }.to_owned(),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_report_becomes_lines() {
        let mut lines = Vec::new();
        flatten(&json!({"format": "ply", "topology": {"genus": 0, "oriented": true}, "repairs": []}), 0, &mut lines);
        let words: Vec<Vec<&str>> = lines.iter().map(|l| l.split_whitespace().collect()).collect();
        let mut expected = vec![
            vec!["format", "ply"],
            vec!["repairs", "none"],
            vec!["topology"],
            vec!["genus", "0"],
            vec!["oriented", "yes"],
        ];
        let mut words = words;
        words.sort();
        expected.sort();
        assert_eq!(words, expected);
    }
}
