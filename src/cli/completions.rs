//! `homolog completions SHELL`: a script that completes commands and options.

use super::error::CliError;
use super::output::print;
use clap::{Args, Command};
use clap_complete::Shell;

/// Print a script that completes commands and options in a shell
///
/// For bash: homolog completions bash > ~/.local/share/bash-completion/completions/homolog;
/// for zsh: homolog completions zsh > a file named _homolog in a folder of $fpath;
/// for fish: homolog completions fish > ~/.config/fish/completions/homolog.fish
#[derive(Debug, Clone, Args)]
pub(super) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Prints the script.
pub(super) fn run(args: &CompletionsArgs, program: &Command) -> Result<(), CliError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut program.clone(), "homolog", &mut script);
    print(String::from_utf8_lossy(&script).trim_end())
}
