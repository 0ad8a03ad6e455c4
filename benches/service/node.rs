//! The service in a separate process: the program itself, or this benchmark with an engine whose work the parameters
//! set.

use homolog::app::{self, App, Shutdown};
use homolog::config::{HttpSettings, ServiceSettings};
use homolog::jobs::engine::{Answer, MethodDescription, Product, Resolved};
use homolog::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Engine, Failure, InputBytes, InputRefusal, InputSummary,
    InputView, ParameterFault, PartFormat, PresentError, ResultPart,
};
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use rayon::prelude::*;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Environment variable that is set in a process that is to run as a node.
const IS_NODE: &str = "SERVICE_BENCH_NODE";
/// Environment variable: number of threads that compute beside the service, at normal priority.
pub(crate) const SPINNERS: &str = "SERVICE_BENCH_SPINNERS";

/// Ticks of processor times in `/proc`: `USER_HZ` of Linux on x86-64 and ARM.
const TICKS_A_SECOND: f64 = 100.0;

/// A process of the service; killed when dropped.
pub(crate) struct Node {
    process: Child,
    /// `127.0.0.1:port`.
    pub address: String,
}

impl Node {
    /// This program, with the engine below.
    pub(crate) fn start(environment: &[(&'static str, String)]) -> Self {
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.env(IS_NODE, "1");
        Node::spawn(command, environment)
    }

    /// `homolog serve`.
    pub(crate) fn program(environment: &[(&'static str, String)]) -> Self {
        // The kernel kills it when this process ends, even if this process is killed.
        let mut command = Command::new("setpriv");
        let program = std::env::var_os("SERVICE_BENCH_PROGRAM").unwrap_or_else(|| env!("CARGO_BIN_EXE_homolog").into());
        command.args(["--pdeathsig", "KILL", "--"]).arg(program).arg("serve");
        Node::spawn(command, environment)
    }

    fn spawn(mut command: Command, environment: &[(&'static str, String)]) -> Self {
        for (name, _) in std::env::vars_os() {
            if name.to_str().is_some_and(|name| name.starts_with("HOMOLOG_") || name.starts_with("AWS_")) {
                command.env_remove(name);
            }
        }
        command.env("HOMOLOG_LOG", "error").envs(environment.iter().map(|(name, value)| (name, value)));
        let mut process = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().rsplit("http://").next().unwrap().to_owned();
        assert!(!address.is_empty(), "the service does not start");
        Node { process, address }
    }

    /// A line of `/proc/<pid>/status` in kB, as MiB.
    pub(crate) fn status_mib(&self, name: &str) -> f64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.process.id())).unwrap();
        let line = status.lines().find(|l| l.starts_with(&format!("{name}:"))).unwrap();
        line.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap() / 1024.0
    }

    /// Processor time of the node and its descendants, ended ones too, s. Unlike the time of a clock it hardly depends
    /// on what else the machine does.
    pub(crate) fn processor_s(&self) -> f64 {
        let processes: Vec<ProcessStat> = std::fs::read_dir("/proc")
            .unwrap()
            .filter_map(|entry| ProcessStat::read(entry.ok()?.file_name().to_str()?.parse().ok()?))
            .collect();
        let mut counted = vec![self.process.id()];
        let mut ticks = 0;
        while let Some(id) = counted.pop() {
            ticks += processes.iter().filter(|p| p.id == id).map(|p| p.ticks).sum::<u64>();
            counted.extend(processes.iter().filter(|p| p.parent == id).map(|p| p.id));
        }
        ticks as f64 / TICKS_A_SECOND
    }
}

/// A line of `/proc/<pid>/stat`.
struct ProcessStat {
    id: u32,
    parent: u32,
    /// Processor time of the process and of its children that have ended.
    ticks: u64,
}

impl ProcessStat {
    /// `None` if the process has ended.
    fn read(id: u32) -> Option<ProcessStat> {
        let stat = std::fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
        let (_, after_name) = stat.rsplit_once(')')?;
        let fields: Vec<&str> = after_name.split_whitespace().collect();
        let number = |k: usize| fields.get(k)?.parse::<u64>().ok();
        let ticks = (11..15).map(number).sum::<Option<u64>>()?;
        Some(ProcessStat { id, parent: u32::try_from(number(1)?).ok()?, ticks })
    }
}

impl Drop for Node {
    fn drop(&mut self) {
        let _ = kill_process(Pid::from_child(&self.process), Signal::KILL);
        let _ = self.process.wait();
    }
}

/// Whether this process is to run as a node.
pub(crate) fn is_wanted() -> bool {
    std::env::var_os(IS_NODE).is_some()
}

#[derive(Debug, clap::Parser)]
struct Arguments {
    #[command(flatten)]
    http: HttpSettings,
    #[command(flatten)]
    service: ServiceSettings,
}

/// Runs the service as `homolog serve` does, with the engine below.
pub(crate) fn run() {
    rustix::process::set_parent_process_death_signal(Some(Signal::KILL)).unwrap();
    homolog::tls::prepare();
    let Arguments { http, service } = clap::Parser::parse_from(["node"]);
    homolog::telemetry::start(service.log_format, &service.log).unwrap();
    for _ in 0..std::env::var(SPINNERS).map_or(0, |n| n.parse().unwrap()) {
        std::thread::spawn(|| burn(Instant::now() + Duration::from_secs(3600)));
    }
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    runtime.block_on(async {
        let shutdown = Shutdown::default();
        let listener = app::listen(&http).await.unwrap();
        let address = listener.local_addr().unwrap();
        let app = App::open(&service, Arc::new(Told), &shutdown, true).await.unwrap();
        println!("http://{address}");
        app.run(Some((listener, http, service)), &shutdown).await;
    });
}

fn burn(until: Instant) -> f64 {
    let mut x = 1.0_f64;
    while Instant::now() < until {
        for _ in 0..100_000 {
            x = std::hint::black_box((x * 1.000_001).sqrt() + 0.5);
        }
    }
    x
}

/// Accepts any input. Computes on all cores for `burn_ms`, or emits `points` trace points at intervals of `step_ms`.
struct Told;

impl Engine for Told {
    fn methods(&self) -> Vec<MethodDescription> {
        vec![MethodDescription {
            name: "told".to_owned(),
            version: "1".to_owned(),
            description: "Does what its parameters say.".to_owned(),
            defaults: json!({}),
        }]
    }

    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>> {
        Ok(Resolved {
            method: "told".to_owned(),
            method_version: "1".to_owned(),
            parameters: request.clone(),
            computation: Arc::new(ToldComputation { parameters: request.clone() }),
            input_keys: [String::new(), String::new()],
            result_version: "1".to_owned(),
        })
    }

    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure> {
        Ok(Arc::new(ToldComputation { parameters: parameters.clone() }))
    }

    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        homolog::worker::presentation::present(part, format, stored)
    }
}

/// A computation of [`Told`].
#[derive(Debug)]
struct ToldComputation {
    parameters: Value,
}

impl Computation for ToldComputation {
    fn check_input(&self, _: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        Ok(InputSummary { n_vertices: 3, n_faces: 1, report: json!({}) })
    }

    fn show_input(&self, _: &InputBytes<'_>, _: InputView) -> Result<Vec<u8>, InputRefusal> {
        Ok(Vec::new())
    }

    fn compute(&self, _: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        let number = |key: &str| self.parameters.get(key).and_then(Value::as_u64).unwrap_or(0);
        observer.phase(Phase::Inference);
        let end = Instant::now() + Duration::from_millis(number("burn_ms"));
        while Instant::now() < end && !observer.is_cancelled() {
            // As a match does: short pieces of work on rayon's threads, one on each core.
            let slice = (Instant::now() + Duration::from_millis(50)).min(end);
            let sum: f64 = (0..rayon::current_num_threads()).into_par_iter().map(|_| burn(slice)).sum();
            std::hint::black_box(sum);
        }
        if observer.is_cancelled() {
            return Err(ComputeError::Cancelled);
        }
        for i in 1..=number("points") {
            let mut point = TracePoint::new(0, Phase::Inference, i as u32);
            point.energy = Some(1000.0 / i as f64);
            observer.trace(&point);
            observer.progress(i as f64 / number("points") as f64);
            std::thread::sleep(Duration::from_millis(number("step_ms")));
        }
        let products = vec![Product { kind: ArtifactKind::Result, bytes: b"{}".to_vec() }];
        Ok(Answer { products, verdict: None })
    }
}
