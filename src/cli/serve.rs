//! `homolog serve`, `homolog worker`, and the generated files of the API.

use super::error::CliError;
use super::output::print;
use crate::app::{self, App, AppError, Shutdown};
use crate::config::{HttpSettings, ServiceSettings, WorkerProcessSettings};
use crate::http::{openapi_json, problems_markdown};
use crate::spans;
use crate::telemetry;
use crate::worker::quota::Quota;
use std::time::Duration;

/// Arguments of `homolog serve`.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct ServeArgs {
    /// HTTP.
    #[command(flatten)]
    pub(super) http: HttpSettings,
    /// Everything else.
    #[command(flatten)]
    pub(super) service: ServiceSettings,
}

/// Arguments of `homolog worker`.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct WorkerArgs {
    /// When the process exits.
    #[command(flatten)]
    pub(super) process: WorkerProcessSettings,
    /// Settings of the service.
    #[command(flatten)]
    pub(super) service: ServiceSettings,
}

/// Serves HTTP and runs jobs until a signal. Prints one line with the address when ready.
pub(super) fn serve(args: ServeArgs) -> Result<(), CliError> {
    raise_file_limit();
    let service = args.service.clone();
    in_runtime(&service, async move {
        let shutdown = Shutdown::default();
        shutdown.follow_signals(Duration::from_millis(args.service.shutdown_grace_ms));
        let listener = app::listen(&args.http).await?;
        let address = listener.local_addr().map_err(|error| AppError::Listen { address: args.http.listen, error })?;
        let probes = match args.http.probe_listen {
            Some(address) => Some(app::bind(address).await?),
            None => None,
        };
        let app = App::open(&args.service, app::engine(&args.service)?, &shutdown, true).await?;
        let scheme = if args.http.tls_cert.is_some() { "https" } else { "http" };
        say(&format!("homolog listens on {scheme}://{address}"));
        app.run_probed(Some((listener, args.http, args.service)), probes, &shutdown).await;
        Ok(())
    })
}

/// Runs jobs until a signal, or until the limits in the arguments are reached.
pub(super) fn worker(args: WorkerArgs) -> Result<(), CliError> {
    let service = args.service.clone();
    in_runtime(&service, async move {
        let shutdown = Shutdown::default();
        shutdown.follow_signals(Duration::from_millis(args.service.shutdown_grace_ms));
        let probes = match args.process.probe_listen {
            Some(address) => Some(app::bind(address).await?),
            None => None,
        };
        let mut app = App::open(&args.service, app::engine(&args.service)?, &shutdown, false).await?;
        app.limit_to(Quota::new(args.process.end.exit_when_idle_s.map(Duration::from_secs), args.process.end.max_jobs));
        say(&match &args.service.database_url {
            None => format!("homolog worker runs jobs of {}", args.service.data_dir.display()),
            Some(_) => "homolog worker runs jobs of the database server".to_owned(),
        });
        match probes {
            Some(listener) => app.run_with_probes(listener, &args.service, &shutdown).await,
            None => app.run(None, &shutdown).await,
        }
        Ok(())
    })
}

/// Prints the OpenAPI document.
pub(super) fn print_openapi() -> Result<(), CliError> {
    let text = openapi_json().map_err(|e| CliError::Failed(e.to_string()))?;
    print(text.trim_end())
}

/// Prints `api/problems.md`.
pub(super) fn print_problems() -> Result<(), CliError> {
    print(problems_markdown().trim_end())
}

pub(super) fn in_runtime(
    settings: &ServiceSettings,
    work: impl Future<Output = Result<(), AppError>>,
) -> Result<(), CliError> {
    let failed = |error: AppError| CliError::Failed(error.to_string());
    telemetry::start(settings.log_format, &settings.log).map_err(CliError::BadInput)?;
    if let Some(endpoint) = &settings.otlp_endpoint {
        spans::start(endpoint).map_err(CliError::BadInput)?;
    }
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .map_err(|error| failed(AppError::Thread(error)))?;
    let done = runtime.block_on(work);
    // Input checks that are still running must not delay the exit.
    runtime.shutdown_background();
    spans::finish();
    done.map_err(failed)
}

/// Raises the soft limit of open files, because each connection is a file.
#[cfg(unix)]
fn raise_file_limit() {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let Rlimit { maximum, .. } = getrlimit(Resource::Nofile);
    let wanted = Rlimit { current: maximum.map_or(Some(65_536), |most| Some(most.min(65_536))), maximum };
    // On failure the current limit stays.
    let _ = setrlimit(Resource::Nofile, wanted);
}

#[cfg(not(unix))]
fn raise_file_limit() {}

/// Prints a line; the service continues if the output is closed.
fn say(line: &str) {
    let _ = print(line);
}
