//! The `homolog` program; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    homolog::cli::run(std::env::args_os())
}
