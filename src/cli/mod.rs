//! The command line, one file for each command. Commands print answers to the standard output and everything else to the
//! standard error. Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.

mod admin;
mod demo;
mod error;
mod experiment;
mod files;
mod health;
mod inspect;
mod interrupt;
mod match_pair;
mod output;
mod parameter_table;
mod parameters;
mod phantom;
mod progress;
mod serve;
mod summary;

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
    Match(match_pair::MatchArgs),
    Inspect(inspect::InspectArgs),
    Phantom(phantom::PhantomArgs),
    Experiment(experiment::ExperimentArgs),
    Demo(demo::DemoArgs),
    Health(health::HealthArgs),
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
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version exit with 0, usage errors with 2, whether or not the text could be printed.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let done = match cli.command {
        Command::Serve(args) => serve::serve(args),
        Command::Worker(args) => serve::worker(args),
        Command::Migrate(args) => admin::migrate(&args),
        Command::Keys(args) => admin::keys(&args),
        Command::Purge(args) => admin::purge(&args),
        Command::Openapi => serve::print_openapi(),
        Command::Problems => serve::print_problems(),
        Command::Parameters => parameter_table::print_parameters(),
        Command::Match(args) => match_pair::run(&args),
        Command::Inspect(args) => inspect::run(&args),
        Command::Phantom(args) => phantom::run(&args),
        Command::Experiment(args) => experiment::run(&args),
        Command::Demo(args) => demo::run(&args),
        Command::Health(args) => health::run(&args),
    };
    match done {
        Ok(()) | Err(CliError::OutputClosed) => ExitCode::SUCCESS,
        Err(error) => {
            output::note(&format!("homolog: {error}"));
            error.exit_code()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }
}
