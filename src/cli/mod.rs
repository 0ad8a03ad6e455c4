//! The command line, one file for each command. Commands print answers to the standard output and everything else to the
//! standard error. Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.

mod admin;
mod audit;
mod backup;
mod companions;
mod completions;
mod config;
mod demo;
mod encryption;
mod error;
mod experiment;
mod files;
mod health;
mod inspect;
mod interrupt;
mod match_args;
mod match_many;
mod match_pair;
mod output;
mod pair;
mod parameter_table;
mod parameters;
mod peak_memory;
mod phantom;
mod progress;
mod serve;
mod study;
mod study_run;
mod study_score;
mod summary;
mod used;
mod words;

use crate::worker::isolation;
use config::Refused;
use error::CliError;

use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

/// Dense correspondence and rigid registration of anatomical surfaces
#[derive(Debug, Parser)]
#[command(name = "homolog", version = version(), propagate_version = true, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run the HTTP service, with workers in the same process
    Serve(serve::ServeArgs),
    /// Run workers only, for a service in another process or on another machine
    Worker(serve::WorkerArgs),
    Migrate(admin::MigrateArgs),
    Keys(admin::KeysArgs),
    Purge(admin::PurgeArgs),
    Audit(audit::AuditArgs),
    Encryption(encryption::EncryptionArgs),
    Config(config::ConfigArgs),
    Backup(backup::BackupArgs),
    Restore(backup::RestoreArgs),
    Match(match_args::MatchArgs),
    Study(study::StudyArgs),
    Inspect(inspect::InspectArgs),
    Phantom(phantom::PhantomArgs),
    Experiment(experiment::ExperimentArgs),
    Demo(demo::DemoArgs),
    Health(health::HealthArgs),
    Completions(completions::CompletionsArgs),
    #[command(hide = true)]
    PeakMemory(peak_memory::PeakMemoryArgs),
    /// Print the OpenAPI document of the service
    Openapi,
    /// Print the table of problem types
    #[command(hide = true)]
    Problems,
    /// Print the table of parameters of a match
    #[command(hide = true)]
    Parameters,
}

/// Version and commit of the program.
fn version() -> &'static str {
    concat!(env!("CARGO_PKG_VERSION"), " (", env!("HOMOLOG_COMMIT"), ")")
}

/// Runs the program with these arguments, of which the first is the name of the program.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    // Checked before anything is read or set up: the service starts this command again and again, and waits for it.
    if arguments.get(1).is_some_and(|command| command == isolation::COMMAND) {
        let parent = arguments.get(2).and_then(|pid| pid.to_str()?.parse().ok());
        return isolation::run_child(parent);
    }
    let program = used::only_used(<Cli as clap::CommandFactory>::command());
    let parsed = config::parse(&program, &arguments).and_then(|(matches, file)| {
        let cli = <Cli as clap::FromArgMatches>::from_arg_matches(&matches).map_err(Refused::Usage)?;
        Ok((cli, matches, file))
    });
    let (cli, matches, file) = match parsed {
        Ok(parsed) => parsed,
        Err(Refused::Usage(error)) => {
            // Help and version exit with 0, usage errors with 2, whether or not the text could be printed.
            let text = error.to_string();
            let said = words::plain(&text);
            if said == text {
                let _ = error.print();
            } else {
                output::note(said.trim_end());
            }
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
        Err(Refused::File(reason)) => {
            output::note(&format!("homolog: {reason}"));
            return ExitCode::from(2);
        }
    };
    if let Some(unknown) = unknown_setting(&cli.command) {
        let nearest = nearest_variable(&program, &unknown);
        output::note(&format!(
            "homolog: {unknown} is no setting of this program; did you mean {nearest}? `homolog config` lists all settings"
        ));
        return ExitCode::from(2);
    }
    let done = match cli.command {
        Command::Serve(args) => serve::serve(args),
        Command::Worker(args) => serve::worker(args),
        Command::Migrate(args) => admin::migrate(&args),
        Command::Keys(args) => admin::keys(&args),
        Command::Purge(args) => admin::purge(&args),
        Command::Audit(args) => audit::run(&args),
        Command::Encryption(args) => encryption::run(&args),
        Command::Backup(args) => backup::back_up(&args),
        Command::Restore(args) => backup::restore(&args),
        Command::Config(_) => config::run(&program, &matches, &file),
        Command::Openapi => serve::print_openapi(),
        Command::Problems => serve::print_problems(),
        Command::Parameters => parameter_table::print_parameters(),
        Command::Match(args) => match_pair::run(&args),
        Command::Study(args) => study::run(&args),
        Command::Inspect(args) => inspect::run(&args),
        Command::Phantom(args) => phantom::run(&args),
        Command::Experiment(args) => experiment::run(&args),
        Command::PeakMemory(args) => peak_memory::run(&args),
        Command::Demo(args) => demo::run(&args),
        Command::Health(args) => health::run(&args),
        Command::Completions(args) => completions::run(&args, &program),
    };
    match done {
        Ok(()) | Err(CliError::OutputClosed) => ExitCode::SUCCESS,
        Err(error) => {
            output::note(&format!("homolog: {error}"));
            error.exit_code()
        }
    }
}

/// A variable of the environment that looks like a setting but is unknown: a misspelled limit must not be ignored.
/// Checked only for commands with settings, and not for variables that Kubernetes adds for a service of this name.
fn unknown_setting(command: &Command) -> Option<String> {
    let runs_service = matches!(
        command,
        Command::Serve(_)
            | Command::Worker(_)
            | Command::Migrate(_)
            | Command::Keys(_)
            | Command::Purge(_)
            | Command::Audit(_)
            | Command::Encryption(_)
            | Command::Backup(_)
            | Command::Restore(_)
            | Command::Config(_)
    );
    let names = std::env::vars_os().filter_map(|(name, _)| name.into_string().ok());
    if runs_service { names.into_iter().find(|name| is_unknown(name)) } else { None }
}

fn is_unknown(name: &str) -> bool {
    // Variables of the build, the tests and the benchmarks of this repository.
    const OTHERS: [&str; 4] = ["HOMOLOG_COMMIT", "HOMOLOG_REAL_DATA", "HOMOLOG_FAULTS", "HOMOLOG_BENCH_PEER"];
    let is_of_kubernetes = name.contains("_SERVICE_") || name.ends_with("_PORT") || name.contains("_PORT_");
    let program = <Cli as clap::CommandFactory>::command();
    name.starts_with("HOMOLOG_") && !OTHERS.contains(&name) && !is_of_kubernetes && !has_variable(&program, name)
}

/// The known variable most similar to an unknown one.
fn nearest_variable(program: &clap::Command, unknown: &str) -> String {
    let variables: Vec<String> = config::variables(program);
    crate::config::file::nearest(unknown, &variables).unwrap_or_default().to_owned()
}

fn has_variable(command: &clap::Command, name: &str) -> bool {
    command.get_arguments().any(|argument| argument.get_env().is_some_and(|env| env == name))
        || command.get_subcommands().any(|command| has_variable(command, name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }

    #[test]
    fn misspelled_settings_are_recognized() {
        for known in ["HOMOLOG_LISTEN", "HOMOLOG_PROBE_LISTEN", "HOMOLOG_URL", "PATH", "HOMOLOG_FAULTS"] {
            assert!(!is_unknown(known), "{known}");
        }
        for injected in ["HOMOLOG_SERVICE_HOST", "HOMOLOG_PORT", "HOMOLOG_PORT_8080_TCP_ADDR"] {
            assert!(!is_unknown(injected), "{injected}");
        }
        for wrong in ["HOMOLOG_LISTN", "HOMOLOG_MAX_QUEUES", "HOMOLOG_"] {
            assert!(is_unknown(wrong), "{wrong}");
        }
    }
}
