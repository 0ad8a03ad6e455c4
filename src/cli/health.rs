//! `homolog health`: checks that a running service answers, for container health checks.

use super::demo::client::ServiceClient;
use super::error::CliError;
use super::output::print;
use clap::Args;
use std::time::Duration;

/// Check that a running service answers
#[derive(Debug, Clone, Args)]
pub(super) struct HealthArgs {
    /// Address of the service
    #[arg(long, default_value = "http://127.0.0.1:8080", env = "HOMOLOG_URL")]
    pub(super) url: String,
}

/// Exits 0 if `GET /healthz` answers 200.
///
/// # Errors
/// [`CliError::Failed`] otherwise, after at most three seconds.
pub(super) fn run(args: &HealthArgs) -> Result<(), CliError> {
    let answer = ServiceClient::new(&args.url, Duration::from_secs(3)).get("/healthz")?;
    if answer.status == 200 {
        print("ok")
    } else {
        Err(CliError::Failed(format!("{}/healthz answered {}", args.url.trim_end_matches('/'), answer.status)))
    }
}
