//! The `homolog` program; all of its code is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    homolog::cli::run(std::env::args_os())
}
