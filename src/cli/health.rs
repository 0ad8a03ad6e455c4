//! `homolog health`: asks a running service whether it is alive, for container health checks.

use super::demo::client::ServiceClient;
use super::error::CliError;
use super::output::print;
use clap::Args;
use std::time::Duration;

/// Ask a running service whether it is alive
#[derive(Debug, Clone, Args)]
pub struct HealthArgs {
    /// Address of the service
    #[arg(long, default_value = "http://127.0.0.1:8080", env = "HOMOLOG_URL")]
    pub url: String,
}

/// Exits 0 if `GET /healthz` answers 200.
///
/// # Errors
/// [`CliError::Failed`] for anything else, within three seconds.
pub fn run(args: &HealthArgs) -> Result<(), CliError> {
    let answer = ServiceClient::new(&args.url, Duration::from_secs(3)).get("/healthz")?;
    if answer.status == 200 {
        print("ok")
    } else {
        Err(CliError::Failed(format!("{}/healthz answered {}", args.url.trim_end_matches('/'), answer.status)))
    }
}
