//! Nodes: the service in separate processes, with the scripted engine, which tests can kill, suspend and shut down.
//!
//! A node is a second process of this test binary that runs only the ignored test below. It ends with the test that
//! started it, even if that test is killed.

use crate::jobs_support::ScriptedEngine;
use homolog::app::{self, App, Shutdown};
use homolog::config::{HttpSettings, ServiceSettings};
use homolog::jobs::Engine;
use homolog::telemetry;
use rustix::process::{Pid, Signal, kill_process};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Environment variable with the role of a node: `serve` or `worker`.
const ROLE: &str = "FAULTS_NODE_ROLE";
/// Environment variable with its arguments, one per line.
const ARGUMENTS: &str = "FAULTS_NODE_ARGUMENTS";
/// Prefix of the line with its address that a node prints when it is ready.
const READY: &str = "node-is-ready";
/// Maximum time for a node to start or to exit, on a loaded machine.
const PATIENCE: Duration = crate::patience::PATIENCE;

/// A node; killed when dropped.
pub(crate) struct Node {
    process: Child,
    /// Its base URL; empty for a worker.
    pub base: String,
    log: PathBuf,
}

/// The output of a node that did not start.
#[derive(Debug)]
pub(crate) struct NotStarted(pub String);

/// A node that was started and may not be ready yet.
pub(crate) struct Starting {
    node: Node,
    base: Receiver<String>,
}

impl Starting {
    /// Starts a node whose log goes to `log`. Call it on the test's main thread: the node is killed when that thread
    /// ends.
    pub(crate) fn new(role: &str, arguments: &[String], environment: &[(&str, String)], log: &Path) -> Self {
        let file = std::fs::File::create(log).unwrap();
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.args(["--exact", "faults::node::node_process", "--ignored", "--nocapture"]);
        for (name, _) in std::env::vars_os() {
            if name.to_str().is_some_and(|name| name.starts_with("HOMOLOG_") || name.starts_with("AWS_")) {
                command.env_remove(name);
            }
        }
        command.env(ROLE, role).env(ARGUMENTS, arguments.join("\n")).env("RUST_BACKTRACE", "0");
        command.envs(environment.iter().map(|(name, value)| (name, value)));
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(file);
        let mut process = command.spawn().unwrap();
        let (sender, receiver) = channel();
        let output = process.stdout.take().unwrap();
        // Read to the end, so that the node never waits for a reader.
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if let Some((_, base)) = line.split_once(READY) {
                    let _ = sender.send(base.trim().to_owned());
                }
            }
        });
        Starting { node: Node { process, base: String::new(), log: log.to_owned() }, base: receiver }
    }

    /// Waits until the node is ready; otherwise returns its output.
    pub(crate) fn ready(self) -> Result<Node, NotStarted> {
        let Starting { mut node, base } = self;
        match base.recv_timeout(PATIENCE) {
            Ok(base) => {
                node.base = base;
                Ok(node)
            }
            Err(_) => {
                node.kill();
                Err(NotStarted(node.log()))
            }
        }
    }
}

/// Peak memory of a process so far, bytes.
pub(super) fn peak_memory_bytes(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    peak.trim().strip_suffix(" kB").unwrap().parse::<u64>().unwrap() << 10
}

impl Node {
    /// SIGKILL.
    pub(crate) fn kill(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }

    /// SIGSTOP: suspends the process; its connections and locks remain.
    pub(crate) fn freeze(&self) {
        self.signal(Signal::STOP);
    }

    /// SIGCONT.
    pub(crate) fn thaw(&self) {
        self.signal(Signal::CONT);
    }

    /// SIGTERM: shuts down gracefully; a second one at once.
    pub(crate) fn terminate(&self) {
        self.signal(Signal::TERM);
    }

    /// Waits until the process exits. Returns its exit status and the time this took.
    pub(crate) async fn ended(&mut self) -> (ExitStatus, Duration) {
        let began = Instant::now();
        loop {
            if let Some(status) = self.process.try_wait().unwrap() {
                return (status, began.elapsed());
            }
            assert!(began.elapsed() < PATIENCE, "the node does not end: {}", self.log());
            tokio::time::sleep(Duration::from_millis(10)).await;
        }
    }

    /// Whether the process runs.
    pub(crate) fn is_running(&mut self) -> bool {
        self.process.try_wait().unwrap().is_none()
    }

    /// Peak memory of the process so far, bytes.
    pub(crate) fn peak_memory_bytes(&self) -> u64 {
        peak_memory_bytes(self.process.id())
    }

    /// Its log so far.
    pub(crate) fn log(&self) -> String {
        std::fs::read_to_string(&self.log).unwrap_or_default()
    }

    /// Waits until its log contains `text`.
    pub(crate) async fn until_logged(&self, text: &str, patience: Duration) {
        let began = Instant::now();
        while !self.log().contains(text) {
            assert!(began.elapsed() < patience, "no '{text}' in {}", self.log());
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }

    fn signal(&self, signal: Signal) {
        kill_process(Pid::from_child(&self.process), signal).unwrap();
    }
}

impl Drop for Node {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let log = self.log();
            let lines: Vec<_> = log.lines().collect();
            println!("--- {}\n{}", self.log.display(), lines[lines.len().saturating_sub(40)..].join("\n"));
        }
        self.kill();
        let _ = std::fs::remove_file(&self.log);
    }
}

#[derive(Debug, clap::Parser)]
struct Arguments {
    #[command(flatten)]
    http: HttpSettings,
    #[command(flatten)]
    service: ServiceSettings,
}

#[test]
#[ignore = "runs as a node of the other tests"]
fn node_process() {
    let (Ok(role), Ok(arguments)) = (std::env::var(ROLE), std::env::var(ARGUMENTS)) else { return };
    #[cfg(target_os = "linux")]
    rustix::process::set_parent_process_death_signal(Some(Signal::KILL)).unwrap();
    let arguments = std::iter::once("node").chain(arguments.lines());
    let Arguments { http, service } = clap::Parser::parse_from(arguments);
    telemetry::start(service.log_format, &service.log).unwrap();
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap();
    let begun = runtime.block_on(serve(&role, http, service));
    if let Err(error) = &begun {
        eprintln!("not started: {error}");
    }
    runtime.shutdown_background();
    // Exit here, because the test harness would print its summary.
    std::process::exit(i32::from(begun.is_err()));
}

/// Runs `homolog serve` or `homolog worker` with the scripted engine.
async fn serve(role: &str, http: HttpSettings, service: ServiceSettings) -> Result<(), app::AppError> {
    let shutdown = Shutdown::default();
    shutdown.follow_signals(Duration::from_millis(service.shutdown_grace_ms));
    let engine = Arc::new(ScriptedEngine::default()) as Arc<dyn Engine>;
    if role == "worker" {
        let app = App::open(&service, engine, &shutdown, false).await?;
        say_ready("");
        app.run(None, &shutdown).await;
        return Ok(());
    }
    let listener = app::listen(&http).await?;
    let base = format!("http://{}", listener.local_addr().unwrap());
    let app = App::open(&service, engine, &shutdown, true).await?;
    say_ready(&base);
    app.run(Some((listener, http, service)), &shutdown).await;
    Ok(())
}

fn say_ready(base: &str) {
    println!("\n{READY} {base}");
    std::io::stdout().flush().unwrap();
}
