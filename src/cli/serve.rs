//! `homolog serve`, `homolog worker`, and the generated contract files.

use crate::app::{self, App, AppError, Shutdown};
use crate::config::{HttpSettings, ServiceSettings};
use crate::http::openapi::openapi_json;
use crate::http::problem_table::problems_markdown;
use crate::telemetry;
use std::io::Write;
use std::process::ExitCode;
use std::time::Duration;

/// Arguments of `homolog serve`.
#[derive(Debug, Clone, clap::Args)]
pub struct ServeArgs {
    /// HTTP.
    #[command(flatten)]
    pub http: HttpSettings,
    /// Everything else.
    #[command(flatten)]
    pub service: ServiceSettings,
}

/// Arguments of `homolog worker`.
#[derive(Debug, Clone, clap::Args)]
pub struct WorkerArgs {
    /// Everything.
    #[command(flatten)]
    pub service: ServiceSettings,
}

/// Answers HTTP and runs jobs until a signal. Prints one line with the address when it is ready.
pub fn serve(args: ServeArgs) -> ExitCode {
    let service = args.service.clone();
    in_runtime(&service, async move {
        let shutdown = Shutdown::default();
        shutdown.follow_signals(Duration::from_millis(args.service.shutdown_grace_ms));
        let listener = app::listen(&args.http).await?;
        let address = listener.local_addr().map_err(|error| AppError::Listen { address: args.http.listen, error })?;
        let app = App::open(&args.service, app::engine(&args.service), &shutdown, true).await?;
        say(&format!("homolog listens on http://{address}"));
        app.run(Some((listener, args.http, args.service)), &shutdown).await;
        Ok(())
    })
}

/// Runs jobs until a signal.
pub fn worker(args: WorkerArgs) -> ExitCode {
    let service = args.service.clone();
    in_runtime(&service, async move {
        let shutdown = Shutdown::default();
        shutdown.follow_signals(Duration::from_millis(args.service.shutdown_grace_ms));
        let app = App::open(&args.service, app::engine(&args.service), &shutdown, false).await?;
        say(&format!("homolog worker runs jobs of {}", args.service.data_dir.display()));
        app.run(None, &shutdown).await;
        Ok(())
    })
}

/// Prints the OpenAPI document.
pub fn print_openapi() -> ExitCode {
    match openapi_json() {
        Ok(text) => {
            say(text.trim_end());
            ExitCode::SUCCESS
        }
        Err(error) => complain(&error.to_string()),
    }
}

/// Prints `api/problems.md`.
pub fn print_problems() -> ExitCode {
    say(problems_markdown().trim_end());
    ExitCode::SUCCESS
}

fn in_runtime(settings: &ServiceSettings, work: impl Future<Output = Result<(), AppError>>) -> ExitCode {
    if let Err(error) = telemetry::start(settings.log_format, &settings.log) {
        return complain(&error);
    }
    let runtime = match tokio::runtime::Builder::new_multi_thread().enable_all().build() {
        Ok(runtime) => runtime,
        Err(error) => return complain(&AppError::Thread(error).to_string()),
    };
    let done = runtime.block_on(work);
    // A check of an input that still runs must not hold up the end.
    runtime.shutdown_background();
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => complain(&error.to_string()),
    }
}

/// A line on standard output; a reader that is gone is no reason to fail.
fn say(line: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{line}").and_then(|()| out.flush());
}

fn complain(line: &str) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "homolog: {line}");
    ExitCode::FAILURE
}
