//! The command line.

pub mod serve;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Finds homologous points of two anatomical surfaces.
#[derive(Debug, Parser)]
#[command(name = "homolog", version, about)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Answer HTTP and run jobs
    Serve(serve::ServeArgs),
    /// Run jobs of a data directory that another process serves
    Worker(serve::WorkerArgs),
    /// Print the OpenAPI document
    Openapi,
    /// Print the table of problems
    #[command(hide = true)]
    Problems,
}

/// Does what the arguments say.
pub fn run() -> ExitCode {
    match Cli::parse().command {
        Command::Serve(args) => serve::serve(args),
        Command::Worker(args) => serve::worker(args),
        Command::Openapi => serve::print_openapi(),
        Command::Problems => serve::print_problems(),
    }
}
