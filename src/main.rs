//! The `homolog` program; everything it does is in the library.

fn main() -> std::process::ExitCode {
    homolog::cli::run()
}
