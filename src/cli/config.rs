//! `homolog config`, and the sources of settings: the command line overrides the environment, which overrides the
//! configuration file.

use super::error::CliError;
use super::output::print;
use crate::config::file::{self, FileSettings};
use crate::config::{HttpSettings, ServiceSettings, WorkerEnd};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, FromArgMatches};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;

/// The setting that names the file; it is not in the file.
const CONFIG: &str = "config";
/// Printed in place of a secret.
const MASK: &str = "***";

/// Print every setting with its value and where the value comes from, secrets masked, in the form of a configuration file
#[derive(Debug, Clone, clap::Args)]
pub(super) struct ConfigArgs {
    #[command(flatten)]
    http: HttpSettings,
    #[command(flatten)]
    service: ServiceSettings,
    #[command(flatten)]
    worker: WorkerEnd,
}

/// Whether an argument is a setting of the service: settings have variables in the environment.
pub(super) fn is_setting(argument: &Arg) -> bool {
    let variable = argument.get_env().and_then(std::ffi::OsStr::to_str);
    argument.get_id() != CONFIG && variable.is_some_and(|name| name.starts_with("HOMOLOG_"))
}

/// Whether a command reads the configuration file.
fn reads_file(command: &Command) -> bool {
    command.get_arguments().any(|argument| argument.get_id() == CONFIG)
}

/// The names of all settings, taken from `homolog config`, which has them all.
fn known(program: &Command) -> Vec<String> {
    let config = program.find_subcommand(CONFIG);
    let settings = config.into_iter().flat_map(Command::get_arguments).filter(|argument| is_setting(argument));
    settings.map(|argument| argument.get_id().to_string()).collect()
}

/// The variables of all settings.
pub(super) fn variables(program: &Command) -> Vec<String> {
    let config = program.find_subcommand(CONFIG);
    let all = config.into_iter().flat_map(Command::get_arguments).filter_map(|argument| argument.get_env()?.to_str());
    all.map(str::to_owned).collect()
}

/// The matches of the innermost subcommand, such as `keys create`.
fn innermost(matches: &ArgMatches) -> &ArgMatches {
    matches.subcommand().map_or(matches, |(_, matches)| innermost(matches))
}

/// The arguments, completed with the settings of the configuration file that they or the environment name, and those
/// settings.
///
/// # Errors
/// A usage error, or why the file is refused.
pub(super) fn parse(program: &Command, arguments: &[OsString]) -> Result<(ArgMatches, FileSettings), Refused> {
    let matches = program.clone().try_get_matches_from(arguments).map_err(Refused::Usage)?;
    let path = innermost(&matches).try_get_one::<PathBuf>(CONFIG).ok().flatten().cloned();
    let Some(path) = path else { return Ok((matches, FileSettings::new())) };
    let settings = file::read(&path, &known(program)).map_err(|error| Refused::File(error.to_string()))?;
    // The arguments alone were accepted, so the file causes a refusal here.
    let matches = with_defaults(program.clone(), &settings).try_get_matches_from(arguments);
    let matches = matches.map_err(|error| Refused::File(format!("{}: {}", path.display(), first_line(&error))))?;
    Ok((matches, settings))
}

/// Why arguments are refused.
pub(super) enum Refused {
    /// The command line is invalid; help and version are refusals too.
    Usage(clap::Error),
    /// The configuration file is invalid.
    File(String),
}

fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

/// The program, with the values of a file in place of the defaults of its settings. The environment and the command
/// line override defaults.
fn with_defaults(command: Command, settings: &FileSettings) -> Command {
    let command = command.mut_subcommands(|command| with_defaults(command, settings));
    if !reads_file(&command) {
        return command;
    }
    command.mut_args(|argument| match settings.get(argument.get_id().as_str()) {
        // Defaults live as long as the process; this is done once.
        Some(values) => argument.default_values(values.iter().map(|value| &*value.clone().leak())),
        None => argument,
    })
}

/// Prints all settings.
pub(super) fn run(program: &Command, matches: &ArgMatches, file: &FileSettings) -> Result<(), CliError> {
    let matches = innermost(matches);
    let measured = ConfigArgs::from_arg_matches(matches).map(|settings| settings.service.on_this_machine());
    let measured = BTreeMap::from(measured.map_err(|error| CliError::BadInput(error.to_string()))?);
    let config = program.find_subcommand(CONFIG);
    let lines =
        config.into_iter().flat_map(Command::get_arguments).filter(|argument| is_setting(argument)).map(|argument| {
            let name = argument.get_id().as_str();
            let source = match matches.value_source(name) {
                Some(ValueSource::CommandLine) => "command line".to_owned(),
                Some(ValueSource::EnvVariable) => "environment".to_owned(),
                Some(_) if file.contains_key(name) => "file".to_owned(),
                Some(_) => "default".to_owned(),
                None => measured.get(name).map_or("not set".to_owned(), |here| format!("not set; here {here}")),
            };
            match values(argument, matches) {
                None => format!("# {name} = {:<width$} # {source}", "", width = 46usize.saturating_sub(name.len() + 2)),
                // A masked value is commented out, because it cannot be used.
                Some(value) if value.contains(MASK) => format!("{:<48} # {source}", format!("# {name} = {value}")),
                Some(value) => format!("{:<48} # {source}", format!("{name} = {value}")),
            }
        });
    print(&lines.collect::<Vec<_>>().join("\n"))
}

/// The value of a setting in TOML.
fn values(argument: &Arg, matches: &ArgMatches) -> Option<String> {
    let name = argument.get_id().as_str();
    if matches!(argument.get_action(), ArgAction::SetTrue) {
        return Some(matches.get_flag(name).to_string());
    }
    let given: Vec<String> = matches.get_raw(name)?.map(|value| value.to_string_lossy().into_owned()).collect();
    if argument.is_hide_env_values_set() {
        return Some(format!("\"{MASK}\""));
    }
    let is_list = matches!(argument.get_action(), ArgAction::Append);
    let written: Vec<String> = given.iter().map(|value| in_toml(value)).collect();
    Some(if is_list { format!("[{}]", written.join(", ")) } else { written.join("") })
}

/// Numbers and flags as they are, everything else as a text.
fn in_toml(value: &str) -> String {
    let is_bare = value.parse::<i64>().is_ok()
        || value.parse::<f64>().is_ok_and(f64::is_finite)
        || value == "true"
        || value == "false";
    if is_bare && !value.starts_with('+') && !value.starts_with('.') && !value.ends_with('.') {
        return value.to_owned();
    }
    toml::Value::from(value).to_string()
}
