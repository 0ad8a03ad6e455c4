//! Logs on the standard error, and metrics. Logs contain ids, never file names, labels or anything else that may identify a
//! patient.

use crate::config::LogFormat;
use metrics_exporter_prometheus::{Matcher, PrometheusBuilder, PrometheusHandle};
use std::sync::OnceLock;
use tracing_subscriber::filter::Targets;
use tracing_subscriber::layer::{Layer as _, SubscriberExt as _};
use tracing_subscriber::util::SubscriberInitExt as _;

/// Starts logging. Further calls have no effect.
///
/// # Errors
/// If the filter is invalid.
pub fn start(format: LogFormat, filter: &str) -> Result<(), String> {
    let filter: Targets = filter.parse().map_err(|e| format!("invalid log filter: {e}"))?;
    let layer = tracing_subscriber::fmt::layer().with_writer(std::io::stderr).with_target(false);
    let layer = match format {
        LogFormat::Text => layer.with_ansi(std::io::IsTerminal::is_terminal(&std::io::stderr())).boxed(),
        LogFormat::Json => layer.json().flatten_event(true).boxed(),
    };
    // An existing subscriber, as in tests, stays.
    let _ = tracing_subscriber::registry().with(layer.with_filter(filter)).try_init();
    log_panics();
    Ok(())
}

/// Logs panics with their location only, because their message may contain patient data.
fn log_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string);
        let thread = std::thread::current().name().map(str::to_owned);
        tracing::error!(place, thread, "panic");
    }));
}

/// Kind of a metric.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Only grows.
    Counter,
    /// Goes up and down.
    Gauge,
    /// Durations, in buckets.
    Histogram,
}

/// Every metric of this program, with its HELP text. On Linux the usual process metrics are added, such as
/// `process_open_fds`.
const METRICS: &[(&str, Kind, &str)] = &[
    ("homolog_build_info", Kind::Gauge, "1, with the version of the program"),
    ("homolog_jobs", Kind::Gauge, "Jobs that are queued or running, of the whole service"),
    ("homolog_workers", Kind::Gauge, "Processes that run jobs, of the whole service: busy with some, or idle"),
    ("homolog_queue_oldest_age_seconds", Kind::Gauge, "How long the oldest queued job has waited"),
    ("homolog_job_store_up", Kind::Gauge, "Whether the database answered when the metrics were read"),
    ("homolog_clock_jumped", Kind::Gauge, "Whether the database's clock is not believed, because it was set by days"),
    ("homolog_jobs_finished_total", Kind::Counter, "Runs of jobs in this process, by how they ended"),
    ("homolog_job_seconds", Kind::Histogram, "Duration of a run of a job in this process"),
    ("homolog_jobs_dead_total", Kind::Counter, "Jobs that lost their workers too often"),
    ("homolog_leases_expired_total", Kind::Counter, "Jobs that were taken back from lost workers"),
    ("homolog_prepared_surfaces_total", Kind::Counter, "Lookups of prepared surfaces, by whether they were kept"),
    ("homolog_prepared_surfaces_bytes", Kind::Gauge, "Memory of the prepared surfaces that are kept"),
    ("homolog_children_started_total", Kind::Counter, "Processes for computations that were started"),
    ("homolog_children_ended_total", Kind::Counter, "Processes for computations that ended, by reason"),
    ("homolog_http_requests_total", Kind::Counter, "Answered requests, by method, route and status"),
    ("homolog_http_request_seconds", Kind::Histogram, "Time from the head of a request to that of its answer"),
    ("homolog_problems_total", Kind::Counter, "Answers that refuse a request or report a failure, by type of problem"),
    ("homolog_audit_rows_total", Kind::Counter, "Rows of the audit log: written, lost, or left out"),
    ("homolog_webhook_attempts_total", Kind::Counter, "Attempts to deliver an event, by outcome"),
    ("homolog_webhook_attempt_seconds", Kind::Histogram, "Duration of an attempt to deliver an event"),
    (
        "homolog_database_connections",
        Kind::Gauge,
        "Connections of this process to the database: busy, idle, most allowed",
    ),
];

fn describe() {
    for &(name, kind, help) in METRICS {
        match kind {
            Kind::Counter => metrics::describe_counter!(name, help),
            Kind::Gauge => metrics::describe_gauge!(name, help),
            Kind::Histogram => metrics::describe_histogram!(name, help),
        }
    }
    #[cfg(target_os = "linux")]
    metrics_process::Collector::default().describe();
    let labels = [("version", env!("CARGO_PKG_VERSION")), ("commit", env!("HOMOLOG_COMMIT"))];
    metrics::gauge!("homolog_build_info", &labels).set(1.0);
    // An increase is visible only in a series that already exists.
    for end in ["succeeded", "failed", "cancelled", "given back", "lease lost", "not stored"] {
        metrics::counter!("homolog_jobs_finished_total", "end" => end).increment(0);
    }
    for row in ["written", "lost", "left out"] {
        metrics::counter!("homolog_audit_rows_total", "row" => row).increment(0);
    }
    for outcome in ["delivered", "failed", "given up"] {
        metrics::counter!("homolog_webhook_attempts_total", "outcome" => outcome).increment(0);
    }
    metrics::counter!("homolog_children_started_total").increment(0);
    for reason in ["once", "rested", "grown", "stopped", "panicked", "failed", "memory", "time", "killed", "crashed"] {
        metrics::counter!("homolog_children_ended_total", "reason" => reason).increment(0);
    }
    for lookup in ["hit", "miss"] {
        metrics::counter!("homolog_prepared_surfaces_total", "lookup" => lookup).increment(0);
    }
    metrics::gauge!("homolog_prepared_surfaces_bytes").set(0.0);
    metrics::counter!("homolog_jobs_dead_total").increment(0);
    metrics::counter!("homolog_leases_expired_total").increment(0);
}

/// The metrics of this process in the text format of Prometheus, collected from the first call on.
pub fn metrics_text() -> String {
    static RECORDER: OnceLock<Option<PrometheusHandle>> = OnceLock::new();
    let recorder = RECORDER.get_or_init(|| {
        let buckets = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0];
        // A job may run for an hour.
        let longer = [60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0];
        let builder = PrometheusBuilder::new().set_buckets(&buckets).ok()?;
        let job_buckets = [buckets.as_slice(), &longer].concat();
        let builder =
            builder.set_buckets_for_metric(Matcher::Full("homolog_job_seconds".to_owned()), &job_buckets).ok()?;
        let recorder = builder.install_recorder().ok();
        describe();
        recorder
    });
    recorder.as_ref().map_or_else(String::new, |recorder| {
        #[cfg(target_os = "linux")]
        metrics_process::Collector::default().collect();
        recorder.run_upkeep();
        recorder.render()
    })
}
