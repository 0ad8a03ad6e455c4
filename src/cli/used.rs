//! The settings of the service that each command uses: its help lists only these. The others are also accepted, because
//! one configuration file and one environment serve all commands.

use super::config::is_setting;
use clap::Command;

/// Settings of the location of the database, of its decryption, and of the log.
const DATABASE: [&str; 9] = [
    "config",
    "data_dir",
    "database_url",
    "database_connections",
    "secret_key_file",
    "encryption_key_file",
    "encryption_key_command",
    "log",
    "log_format",
];
const BLOBS: &[&str] = &["artifacts_url"];
const RETENTION: &[&str] = &[
    "artifacts_url",
    "retain_results_days",
    "retain_jobs_days",
    "tenant_retain_results_days",
    "tenant_retain_jobs_days",
];

/// Commands that use only a few settings, and which ones besides [`DATABASE`].
const COMMANDS: [(&str, &[&str]); 7] = [
    ("migrate", &[]),
    ("keys", &[]),
    ("audit", &[]),
    ("purge", RETENTION),
    ("encryption", BLOBS),
    ("backup", BLOBS),
    ("restore", BLOBS),
];

/// The program, with the help of each command reduced to the settings that the command uses.
pub(super) fn only_used(program: Command) -> Command {
    COMMANDS
        .iter()
        .fold(program, |program, (name, more)| program.mut_subcommand(name, |command| reduced(command, more)))
}

fn reduced(command: Command, more: &[&str]) -> Command {
    let command = command.mut_subcommands(|command| reduced(command, more));
    command.mut_args(|argument| {
        let name = argument.get_id().as_str();
        let is_used = DATABASE.contains(&name) || more.contains(&name) || !is_setting(&argument);
        argument.hide(!is_used)
    })
}
