//! The child process: `homolog compute-child`, which only the service starts.
//!
//! It reads requests from its standard input, which is a connection to its parent, and answers on the same connection.
//! It prints and logs nothing, and ends when the connection closes.

use super::limits;
use super::messages::{ChildMessage, Handshake, KeptSurfaces, Outcome, Request};
use super::protocol::{FrameError, Longest, read_frame, write_frame};
use super::sandbox;
use crate::jobs::engine::Answer;
use crate::jobs::study::{StudyInputs, StudyMaterial};
use crate::jobs::{Computation, ComputeError, ComputeInputs, Engine, Failure, InputBytes, Purpose};
use crate::worker::match_engine::MatchEngine;
use crate::worker::priority::{lower_priority_of_global_pool, own_threads};
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use metrics::{Counter, Gauge, Histogram, Key, KeyName, Metadata, Recorder, SharedString, Unit};
use parking_lot::Mutex;
use std::io;
use std::os::fd::AsFd as _;
use std::os::unix::net::UnixStream;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Smallest increase of the progress that a child reports.
const STEP_OF_PROGRESS: f64 = 0.002;
/// The file from which the kernel reads the priority of this process when it ends processes to free memory.
#[cfg(target_os = "linux")]
const PREFERENCE: (&str, &str) = ("/proc/self/oom_score_adj", "500");

/// The location of the last panic.
static PANIC: Mutex<Option<String>> = Mutex::new(None);

/// Runs the child of the process with number `parent` until the connection closes.
pub fn run(parent: Option<u32>) -> ExitCode {
    match serve(parent) {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}

fn serve(parent: Option<u32>) -> Result<(), FrameError> {
    leave_with(parent)?;
    let stream = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    let channel = Channel(Arc::new(Mutex::new(stream)));
    let (beginning, _): (Handshake, _) = channel.read()?;
    if beginning.version != version() {
        return Err(io::Error::other("the parent is another version of the program").into());
    }
    // Only the location of a panic is reported: its message may contain a patient's data.
    std::panic::set_hook(Box::new(|panic| {
        *PANIC.lock() = panic.location().map(ToString::to_string);
    }));
    let counts = Counts::install();
    let before = limits::memory_of(None).unwrap_or_default();
    homolog_run::read_caches();
    let after = limits::memory_of(None).unwrap_or_default();
    #[cfg(target_os = "linux")]
    let _ = std::fs::write(PREFERENCE.0, PREFERENCE.1);
    limits::bound_self();
    let confinement = sandbox::enter();
    lower_priority_of_global_pool();
    let scratch_bytes = after.data.saturating_sub(before.data);
    channel.tell(&ChildMessage::Ready { confinement, scratch_bytes }, &[])?;
    let engine = MatchEngine::new(beginning.limits, beginning.prepared_bytes);
    loop {
        let (request, body) = match channel.read() {
            Err(FrameError::Closed) => return Ok(()),
            read => read?,
        };
        counts.reset();
        // After a panic only the kept surfaces are used again, and each of them is either complete or absent.
        let answered = catch_unwind(AssertUnwindSafe(|| answer(&engine, &channel, request, body)));
        let (outcome, body) = match answered {
            Ok(done) => done?,
            Err(_) => (Outcome::Panicked(PANIC.lock().take()), Vec::new()),
        };
        let kept = counts.taken();
        channel.tell(&ChildMessage::Done { outcome, kept }, &[&body])?;
    }
}

/// The version of the program, which a parent and its children must share.
pub(super) fn version() -> String {
    concat!(env!("CARGO_PKG_VERSION"), "+", env!("HOMOLOG_COMMIT")).to_owned()
}

/// Makes this process end with its parent, and detaches it from the signals of the parent's terminal.
fn leave_with(parent: Option<u32>) -> io::Result<()> {
    // Fails if this process already leads a group, for example when a shell started it.
    let _ = rustix::process::setsid();
    #[cfg(target_os = "linux")]
    rustix::process::set_parent_process_death_signal(Some(rustix::process::Signal::KILL))?;
    // The parent may have ended before the call above.
    let current = rustix::process::getppid().map(|pid| pid.as_raw_nonzero().get().unsigned_abs());
    if parent.is_some() && current == parent {
        return Ok(());
    }
    Err(io::Error::other("this command is for the service itself, which starts it"))
}

/// Handles a request. Returns the outcome and the body of the answer.
fn answer(
    engine: &MatchEngine,
    channel: &Channel,
    request: Request,
    body: Vec<u8>,
) -> Result<(Outcome, Vec<u8>), FrameError> {
    let nothing = |outcome| (outcome, Vec::new());
    let restored = |parameters| engine.restore(&parameters);
    Ok(match request {
        Request::Input { parameters, name_hint, is_target, view } => {
            let computation = match restored(parameters) {
                Ok(computation) => computation,
                Err(failure) => return Ok(nothing(Outcome::Failed(failure))),
            };
            let input = InputBytes { bytes: &body, name_hint: name_hint.as_deref(), is_target };
            match view {
                Some(view) => match computation.show_input(&input, view) {
                    Ok(shown) => (Outcome::Made, shown),
                    Err(refusal) => nothing(Outcome::Unfit(refusal)),
                },
                None => nothing(computation.check_input(&input).map_or_else(Outcome::Unfit, Outcome::Fit)),
            }
        }
        Request::Match { parameters, hints: [source_hint, target_hint], source_bytes, record, n_threads } => {
            let mut source = body;
            let target = source.split_off(source_bytes.min(source.len()));
            let purpose = if record { Purpose::Record } else { Purpose::Result };
            let inputs = ComputeInputs { source, source_hint, target, target_hint, purpose };
            nothing(match restored(parameters) {
                Ok(computation) => compute(channel, computation.as_ref(), &inputs, n_threads)?,
                Err(failure) => Outcome::Failed(failure),
            })
        }
        Request::Step { parameters, definition, files, failures, n_threads } => {
            let mut rest = body.as_slice();
            let mut next = |length: usize| {
                let (part, others) = rest.split_at(length.min(rest.len()));
                rest = others;
                part.to_vec()
            };
            let files = files.into_iter().map(|(name, length)| (name, next(length))).collect();
            let inputs = Box::new(channel.clone());
            let material = StudyMaterial { definition: *definition, files, failures, inputs };
            drop(body);
            let inputs = ComputeInputs {
                source: Vec::new(),
                source_hint: None,
                target: Vec::new(),
                target_hint: None,
                purpose: Purpose::Step(Arc::new(material)),
            };
            nothing(match restored(parameters) {
                Ok(computation) => compute(channel, computation.as_ref(), &inputs, n_threads)?,
                Err(failure) => Outcome::Failed(failure),
            })
        }
        Request::Present { part, format, lengths } => {
            let mut rest = body.as_slice();
            let stored: Vec<&[u8]> = lengths
                .into_iter()
                .map(|length| {
                    let (part, others) = rest.split_at(length.min(rest.len()));
                    rest = others;
                    part
                })
                .collect();
            match engine.present(part, format, &stored) {
                Ok(made) => (Outcome::Made, made),
                Err(error) => nothing(Outcome::NotMade(error.into())),
            }
        }
        Request::Attempt => nothing(Outcome::Attempted(sandbox::attempt())),
        Request::Fetched { .. } => return Err(io::Error::other("nothing was fetched").into()),
    })
}

/// Computes on its own threads, as a worker within the process does, and sends the products.
fn compute(
    channel: &Channel,
    computation: &dyn Computation,
    inputs: &ComputeInputs,
    n_threads: usize,
) -> Result<Outcome, FrameError> {
    let threads = match own_threads(n_threads) {
        Ok(threads) => threads,
        Err(error) => return Ok(Outcome::NoThreads(error.to_string())),
    };
    let observer = Reporter { channel: channel.clone(), progress: Mutex::new(0.0) };
    let computed = threads.install(|| computation.compute(inputs, &observer));
    Ok(match computed {
        Ok(Answer { products, verdict }) => {
            for product in products {
                channel.tell(&ChildMessage::Product(product.kind), &[&product.bytes])?;
            }
            Outcome::Answered(verdict)
        }
        Err(ComputeError::Failed(failure)) => Outcome::Failed(failure),
        // A child is killed, never asked to stop.
        Err(ComputeError::Cancelled | ComputeError::NotStarted(_)) => {
            Outcome::Failed(Failure::new("internal-error", "the computation stopped without having been told to"))
        }
    })
}

/// The connection to the parent, shared by the threads of a computation.
#[derive(Debug, Clone)]
struct Channel(Arc<Mutex<UnixStream>>);

impl Channel {
    fn read<H: serde::de::DeserializeOwned>(&self) -> Result<(H, Vec<u8>), FrameError> {
        read_frame(&mut *self.0.lock(), Longest::FROM_PARENT)
    }

    fn tell(&self, told: &ChildMessage, body: &[&[u8]]) -> Result<(), FrameError> {
        Ok(write_frame(&mut *self.0.lock(), told, body)?)
    }
}

/// Requests the uploads of a study from the parent, which knows their owner.
impl StudyInputs for Channel {
    fn read(&self, hash: &str) -> io::Result<Vec<u8>> {
        // Locked from request to answer, so that another thread cannot receive the answer to this request.
        let mut stream = self.0.lock();
        write_frame(&mut *stream, &ChildMessage::Fetch(hash.to_owned()), &[])?;
        match read_frame(&mut *stream, Longest::FROM_PARENT) {
            Ok((Request::Fetched { error: None }, bytes)) => Ok(bytes),
            Ok((Request::Fetched { error: Some(why) }, _)) => Err(io::Error::other(why)),
            Ok(_) => Err(io::Error::other("the parent answers something else")),
            Err(error) => Err(io::Error::other(error)),
        }
    }
}

/// Sends the parent what a computation reports.
struct Reporter {
    channel: Channel,
    progress: Mutex<f64>,
}

impl Reporter {
    fn tell(&self, told: &ChildMessage) {
        if self.channel.tell(told, &[]).is_err() {
            // The parent no longer waits for this computation.
            std::process::exit(1);
        }
    }
}

impl Observer for Reporter {
    fn phase(&self, phase: Phase) {
        self.tell(&ChildMessage::Phase(phase));
    }

    fn progress(&self, fraction: f64) {
        let mut told = self.progress.lock();
        if fraction >= *told + STEP_OF_PROGRESS || (fraction >= 1.0 && *told < 1.0) {
            *told = fraction.min(1.0);
            self.tell(&ChildMessage::Progress(*told));
        }
    }

    fn trace(&self, point: &TracePoint) {
        self.tell(&ChildMessage::Trace(point.clone()));
    }
}

/// Metrics counted in a child, for the metrics of its parent.
#[derive(Debug, Clone, Default)]
struct Counts {
    hits: Arc<AtomicU64>,
    misses: Arc<AtomicU64>,
    /// The bits of an `f64`.
    bytes: Arc<AtomicU64>,
}

impl Counts {
    fn install() -> Self {
        let counts = Counts::default();
        // Cannot fail: this process has no other recorder.
        let _ = metrics::set_global_recorder(counts.clone());
        counts
    }

    fn reset(&self) {
        self.hits.store(0, Ordering::Relaxed);
        self.misses.store(0, Ordering::Relaxed);
    }

    fn taken(&self) -> KeptSurfaces {
        KeptSurfaces {
            hits: self.hits.load(Ordering::Relaxed),
            misses: self.misses.load(Ordering::Relaxed),
            bytes: f64::from_bits(self.bytes.load(Ordering::Relaxed)) as u64,
        }
    }
}

impl Recorder for Counts {
    fn describe_counter(&self, _: KeyName, _: Option<Unit>, _: SharedString) {}
    fn describe_gauge(&self, _: KeyName, _: Option<Unit>, _: SharedString) {}
    fn describe_histogram(&self, _: KeyName, _: Option<Unit>, _: SharedString) {}

    fn register_counter(&self, key: &Key, _: &Metadata<'_>) -> Counter {
        let is_hit = key.labels().any(|label| label.value() == "hit");
        match key.name() {
            "homolog_prepared_surfaces_total" if is_hit => Counter::from_arc(Arc::clone(&self.hits)),
            "homolog_prepared_surfaces_total" => Counter::from_arc(Arc::clone(&self.misses)),
            _ => Counter::noop(),
        }
    }

    fn register_gauge(&self, key: &Key, _: &Metadata<'_>) -> Gauge {
        match key.name() {
            "homolog_prepared_surfaces_bytes" => Gauge::from_arc(Arc::clone(&self.bytes)),
            _ => Gauge::noop(),
        }
    }

    fn register_histogram(&self, _: &Key, _: &Metadata<'_>) -> Histogram {
        Histogram::noop()
    }
}
