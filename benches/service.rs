//! The service under load: submissions, claims, polling while all cores compute, large tables, followers, memory.
//!
//! `make bench-service` runs this and stores the output as a dated record under `benches/records/`. `--quick` is a
//! smoke run whose figures mean nothing. An argument (`submit`, `claim`, `poll`, `follow`, `idle`, `upload`, `table`,
//! `overhead`, `schedule`, `template`, `isolation`) runs one part, and `schedule-gain`, `schedule-small`, `schedule-middle` or
//! `schedule-mixed` one part of `schedule`. SERVICE_BENCH_PARAMETERS (JSON) and SERVICE_BENCH_JOBS set the parameters
//! of these matches and the number of jobs of each workload; `template` takes the files of the folder
//! SERVICE_BENCH_SUBJECTS, if set, in place of phantoms: the first as template, the next 100 as subjects.
//! SERVICE_BENCH_PROGRAM is another build of the program, for `template`, `isolation` and `overhead`. PostgreSQL is
//! a private cluster as in the fault tests; where it is not installed, its rows are missing. No test depends on this
//! benchmark.
#![allow(clippy::unwrap_used, clippy::print_stdout, clippy::panic, missing_docs)]

#[path = "service/http.rs"]
mod http;
#[path = "service/isolation.rs"]
mod isolation;
#[path = "service/memory.rs"]
mod memory;
#[path = "service/node.rs"]
mod node;
#[path = "service/overhead.rs"]
mod overhead;
#[path = "service/pairs.rs"]
mod pairs;
#[path = "../tests/suite/patience.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod patience;
#[path = "service/place.rs"]
mod place;
#[path = "../tests/suite/faults/postgres.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod postgres;
#[path = "service/queue.rs"]
mod queue;
#[path = "../tests/suite/faults/s3.rs"]
#[allow(dead_code, unused_imports, reason = "the tests use more of it")]
mod s3;
#[path = "service/schedule.rs"]
mod schedule;
#[path = "service/table.rs"]
mod table;

use std::time::Duration;

/// Duration and size of the measurements.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    pub quick: bool,
}

impl Scale {
    /// Time for which a rate is measured.
    pub fn time(self) -> Duration {
        if self.quick { Duration::from_millis(500) } else { Duration::from_secs(5) }
    }

    pub fn pick<T>(self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }
}

/// Latencies of a run, sorted.
pub struct Latencies(Vec<f64>);

impl Latencies {
    pub fn new(mut seconds: Vec<f64>) -> Self {
        seconds.sort_by(f64::total_cmp);
        Latencies(seconds)
    }

    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// A quantile, ms.
    pub fn ms(&self, quantile: f64) -> f64 {
        let last = self.0.len().saturating_sub(1);
        self.0.get((last as f64 * quantile).round() as usize).map_or(f64::NAN, |s| s * 1e3)
    }
}

fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|l| l.strip_prefix("model name"))
        .map_or("unknown processor", |m| m.trim_matches([':', ' ', '\t']));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split_whitespace().next().unwrap_or("unknown").to_owned();
    format!("{model}, {cores} cores; load before the run: {load}")
}

fn main() {
    if node::is_wanted() {
        return node::run();
    }
    let words: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let scale = Scale { quick: words.iter().any(|w| w == "--quick") };
    let parts: Vec<_> = words.iter().filter(|w| !w.starts_with("--")).collect();
    let is_named = |name: &str| parts.iter().any(|w| *w == name);
    let wanted = |name: &str| parts.is_empty() || is_named(name);
    let of_schedule = |name: &str| wanted("schedule") || is_named(name);
    homolog::tls::prepare();
    place::allow_many_files();
    println!("machine: {}, shared with other work", machine());
    println!("commit: {}", option_env!("HOMOLOG_COMMIT").unwrap_or("unknown"));
    if scale.quick {
        println!("smoke run: the figures mean nothing");
    }
    // On the main thread: child processes are killed when the thread that started them ends.
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap();
    runtime.block_on(async {
        if wanted("submit") {
            queue::submissions(scale).await;
            http::submissions(scale).await;
        }
        if wanted("claim") {
            queue::claims(scale).await;
        }
        if wanted("poll") {
            http::polling(scale).await;
        }
        if wanted("follow") {
            http::followers(scale).await;
        }
        if wanted("idle") {
            memory::idle(scale).await;
        }
        if wanted("upload") {
            memory::upload(scale).await;
        }
        if wanted("table") {
            table::latencies(scale).await;
        }
        if wanted("overhead") {
            overhead::overhead(scale).await;
        }
        if of_schedule("schedule-gain") {
            schedule::gains(scale);
        }
        let parts: Vec<_> = schedule::PARTS.into_iter().filter(|part| of_schedule(part)).collect();
        if !parts.is_empty() {
            schedule::explain();
        }
        for part in parts {
            schedule::compare(&schedule::workload(part, scale)).await;
        }
        if wanted("template") {
            schedule::template(scale).await;
        }
        if wanted("isolation") {
            isolation::price(scale).await;
        }
    });
    runtime.shutdown_background();
}
