//! The engine that computes in child processes.

use super::limits::{BESIDES, Bounds, ComputeLimits};
use super::messages::{ChildMessage, Confinement, Handshake, KeptSurfaces, Outcome, Request};
use super::pool::{ChildSettings, Children, end, ended};
use super::process::{AskError, Child, Death};
use super::protocol::FrameError;
use crate::jobs::engine::{Answer, MethodDescription, Product, Resolved};
use crate::jobs::study::{ScoreQuestions, StudyDefinition, StudyFault};
use crate::jobs::{
    Allotted, Computation, ComputeError, ComputeInputs, Demand, Engine, Failure, InputBytes, InputRefusal,
    InputSummary, InputView, JobInput, OutOfProcess, ParameterFault, PartFormat, PresentError, Purpose, ResultPart,
    SurfaceSize,
};
use crate::worker::match_engine::MatchEngine;
use crate::worker::price::PriceLimit;
use bytes::Bytes;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use homolog_run::intake::IntakeLimits;
use serde_json::Value;
use std::fmt;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// How often a request is tried if its child died of a cause that may not be the request's fault.
const TRIES: usize = 2;
/// How long reading an input, or converting a part of a result, may take.
const READING_TIME: Duration = Duration::from_secs(300);
/// Least memory for the prepared surfaces of a child, bytes: a template of a few thousand vertices.
const LEAST_PREPARED: u64 = 48 << 20;

/// How computations are isolated.
#[derive(Debug, Clone)]
pub struct IsolationSettings {
    /// The program whose hidden command runs a child, usually the running program itself.
    pub program: PathBuf,
    /// Limits on inputs.
    pub limits: IntakeLimits,
    /// Limit on the predicted processor time of a computation.
    pub price: PriceLimit,
    /// Memory for the prepared surfaces of all children together, bytes.
    pub prepared_bytes: u64,
    /// Memory for jobs, bytes. Reading a file may not take more.
    pub memory_bytes: u64,
    /// Computations that may run at the same time.
    pub at_once: usize,
    /// Cores of this process.
    pub cores: usize,
    /// Memory that a computation may take in addition to its predicted memory, bytes.
    pub besides: u64,
}

impl IsolationSettings {
    /// Settings whose children run the running program.
    ///
    /// # Errors
    /// If the system does not report the path of the program.
    pub fn of_this_program(limits: IntakeLimits, memory_bytes: u64) -> io::Result<Self> {
        // This path leads to the running program, even if another version has replaced its file.
        let own = PathBuf::from("/proc/self/exe");
        let program = if cfg!(target_os = "linux") && own.exists() { own } else { std::env::current_exe()? };
        let cores = crate::worker::machine::cores();
        Ok(IsolationSettings {
            program,
            limits,
            price: PriceLimit::NONE,
            prepared_bytes: 0,
            memory_bytes,
            at_once: cores,
            cores,
            besides: BESIDES,
        })
    }
}

/// A [`MatchEngine`] that processes all bytes of clients in children of this process.
///
/// When a child dies, only its request is affected. A match or a step that runs out of memory or of processor time
/// fails for good. If the child crashed or was killed from outside, its request is computed once more in a new child.
/// The second run does not report what the first run has reported, because the same inputs give the same trace.
#[derive(Debug)]
pub struct IsolatedEngine {
    /// Resolves parameters and predicts; it receives no bytes of clients.
    local: MatchEngine,
    shared: Arc<Shared>,
    confinement: Confinement,
}

#[derive(Debug)]
struct Shared {
    children: Children,
    most: ComputeLimits,
    n_threads: usize,
}

/// The result of a request: the answer, or why there is none.
type RequestResult<T> = Result<T, RequestError>;

/// Why a request has no answer.
#[derive(Debug)]
enum RequestError {
    /// No child could be started.
    NotStarted(io::Error),
    /// The caller stopped the request.
    Stopped,
    /// The child died.
    Died(Death),
}

impl IsolatedEngine {
    /// Starts the first child.
    ///
    /// # Errors
    /// If it does not start.
    pub fn start(settings: IsolationSettings) -> io::Result<Self> {
        let IsolationSettings { program, limits, price, prepared_bytes, memory_bytes, at_once, cores, besides } =
            settings;
        let at_once = at_once.max(1);
        let share = (prepared_bytes / at_once as u64).max(LEAST_PREPARED.min(prepared_bytes));
        let beginning = Handshake { version: super::child::version(), limits, prepared_bytes: share };
        let upbringing = ChildSettings { program, beginning, n_threads: cores, most_resting: at_once };
        let (children, confinement) = Children::start(upbringing)?;
        let most = ComputeLimits { limits, budget: memory_bytes, besides };
        let shared = Arc::new(Shared { children, most, n_threads: cores });
        Ok(IsolatedEngine { local: MatchEngine::priced(limits, price, 0), shared, confinement })
    }

    /// The missing confinement of children by the kernel, as a text for people; `None` if they are fully confined.
    pub fn unconfined(&self) -> Option<&'static str> {
        match self.confinement {
            Confinement { landlock: true, seccomp: true } => None,
            Confinement { landlock: false, seccomp: true } => Some("it has no Landlock"),
            Confinement { landlock: true, seccomp: false } => Some("it has no filters of system calls"),
            Confinement { landlock: false, seccomp: false } => {
                Some("it has neither Landlock nor filters of system calls")
            }
        }
    }

    /// Lets a child try what a computation must not be able to do, such as opening a file or a connection. Returns what
    /// succeeded.
    ///
    /// # Errors
    /// If there is no child.
    pub fn possible_in_a_child(&self) -> io::Result<Vec<String>> {
        let bounds = self.shared.reading(0);
        let mut child = self.shared.children.take_fresh()?;
        let done = child.ask(&Request::Attempt, &[], bounds, &|| false, &mut |_, _, _| Ok(()));
        end(child, "once");
        match done {
            Ok((Outcome::Attempted(possible), ..)) => Ok(possible),
            other => Err(io::Error::other(format!("a child did not try: {other:?}"))),
        }
    }

    fn apart(&self, parameters: Value, local: Arc<dyn Computation>) -> Arc<dyn Computation> {
        Arc::new(IsolatedComputation { parameters, local, shared: Arc::clone(&self.shared) })
    }
}

impl Engine for IsolatedEngine {
    fn methods(&self) -> Vec<MethodDescription> {
        self.local.methods()
    }

    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>> {
        let resolved = self.local.resolve(request)?;
        let computation = self.apart(resolved.parameters.clone(), Arc::clone(&resolved.computation));
        Ok(Resolved { computation, ..resolved })
    }

    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure> {
        Ok(self.apart(parameters.clone(), self.local.restore(parameters)?))
    }

    fn join_instances(&self, instances: Vec<Bytes>) -> Result<Bytes, InputRefusal> {
        self.local.join_instances(instances)
    }

    fn check_study(&self, study: &StudyDefinition) -> Result<(), Vec<StudyFault>> {
        self.local.check_study(study)
    }

    fn check_score(&self, study: &StudyDefinition, asked: &ScoreQuestions) -> Result<(), Vec<StudyFault>> {
        self.local.check_score(study, asked)
    }

    fn check_study_size(&self, study: &StudyDefinition) -> Result<(), InputRefusal> {
        self.local.check_study_size(study)
    }

    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        let unreadable =
            |why: String| PresentError::Unreadable { what: "a stored part of a result", source: Some(why.into()) };
        let lengths: Vec<usize> = stored.iter().map(|blob| blob.len()).collect();
        let n_bytes: usize = lengths.iter().sum();
        let request = Request::Present { part, format, lengths };
        match self.shared.once(&request, stored, n_bytes as u64) {
            Ok((Outcome::Made, made)) => Ok(made),
            Ok((Outcome::NotMade(why), _)) => Err(why.error(part, format)),
            Ok((outcome, _)) => Err(unreadable(format!("a child answered {outcome:?}"))),
            Err(unanswered) => Err(unreadable(format!("its child did not answer: {unanswered:?}"))),
        }
    }
}

impl Shared {
    fn reading(&self, n_bytes: u64) -> Bounds {
        Bounds::of_reading(&self.most, n_bytes, self.n_threads, READING_TIME)
    }

    /// Sends a request to a fresh child that serves it alone: the content of these bytes is not yet known.
    fn once(&self, request: &Request, body: &[&[u8]], n_bytes: u64) -> RequestResult<(Outcome, Vec<u8>)> {
        let bounds = self.reading(n_bytes);
        tried(|| {
            let began = Instant::now();
            let stop = || began.elapsed() > READING_TIME;
            let mut child = self.children.take_fresh().map_err(RequestError::NotStarted)?;
            match child.ask(request, body, bounds, &stop, &mut |_, _, _| Ok(())) {
                Ok((outcome, body, _)) => {
                    end(child, "once");
                    Ok((outcome, body))
                }
                Err(broken) => Err(unanswered(child, broken)),
            }
        })
    }
}

/// Tries a request again if its child died of a cause that may not be the request's fault.
fn tried<T>(mut work: impl FnMut() -> RequestResult<T>) -> RequestResult<T> {
    let mut n_tries = 0;
    loop {
        n_tries += 1;
        match work() {
            Err(RequestError::Died(death @ (Death::Killed | Death::Crashed { .. }))) if n_tries < TRIES => {
                tracing::warn!(?death, "the process of a computation died; it is computed once more in another");
            }
            Err(RequestError::Died(death)) => {
                tracing::error!(?death, "the process of a computation died");
                return Err(RequestError::Died(death));
            }
            done => return done,
        }
    }
}

/// Why a child has not answered.
fn unanswered(child: Child, broken: AskError) -> RequestError {
    match broken {
        AskError::Stopped => {
            end(child, "stopped");
            RequestError::Stopped
        }
        AskError::Lost(error) => {
            let death = match error {
                FrameError::Closed | FrameError::Io(_) => child.end(),
                // A child that lives but sends malformed frames counts as dead.
                FrameError::TooLong { .. } | FrameError::Meaningless(_) => {
                    drop(child);
                    Death::Crashed { signal: None }
                }
            };
            ended(death.reason());
            tracing::warn!(%error, ?death, "a child was lost");
            RequestError::Died(death)
        }
    }
}

/// A computation in children.
struct IsolatedComputation {
    parameters: Value,
    local: Arc<dyn Computation>,
    shared: Arc<Shared>,
}

impl fmt::Debug for IsolatedComputation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.local.fmt(f)
    }
}

impl IsolatedComputation {
    fn input(&self, input: &InputBytes<'_>, view: Option<InputView>) -> Result<(Outcome, Vec<u8>), InputRefusal> {
        let request = Request::Input {
            parameters: self.parameters.clone(),
            name_hint: input.name_hint.map(str::to_owned),
            is_target: input.is_target,
            view,
        };
        let n_bytes = input.bytes.len() as u64;
        match self.shared.once(&request, &[input.bytes], n_bytes) {
            Ok((Outcome::Unfit(refusal), _)) => Err(refusal),
            Ok((Outcome::Panicked(place), _)) => {
                tracing::error!(place, "panic in a child");
                uncheckable()
            }
            Ok(done) => Ok(done),
            Err(RequestError::Died(Death::Memory)) => Err(too_large(format!(
                "reading this file takes more memory than the {} bytes that one file may take",
                self.shared.reading(n_bytes).memory_bytes
            ))),
            Err(RequestError::Stopped | RequestError::Died(Death::Time)) => {
                Err(too_large(format!("reading this file takes longer than {} s", READING_TIME.as_secs())))
            }
            Err(RequestError::Died(_) | RequestError::NotStarted(_)) => uncheckable(),
        }
    }
}

fn too_large(detail: String) -> InputRefusal {
    InputRefusal { code: "too-large".to_owned(), detail, topology: None, place_mm: None }
}

/// Ends a check without an outcome, so that none is stored, as a panic within this process does.
fn uncheckable<T>() -> T {
    std::panic::resume_unwind(Box::new("the check of an input has no outcome"))
}

impl Computation for IsolatedComputation {
    fn check_input(&self, input: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        match self.input(input, None)? {
            (Outcome::Fit(summary), _) => Ok(summary),
            _ => uncheckable(),
        }
    }

    fn show_input(&self, input: &InputBytes<'_>, view: InputView) -> Result<Vec<u8>, InputRefusal> {
        match self.input(input, Some(view))? {
            (Outcome::Made, shown) => Ok(shown),
            _ => uncheckable(),
        }
    }

    fn check_pair(&self, source: &InputSummary, target: &InputSummary) -> Result<(), InputRefusal> {
        self.local.check_pair(source, target)
    }

    fn demand(&self, source: SurfaceSize, target: SurfaceSize) -> Demand {
        self.local.demand(source, target)
    }

    fn compute(&self, inputs: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        let n_threads = rayon::current_num_threads();
        let allotted = Allotted { n_threads, memory_bytes: 0, max_run: Duration::MAX, owner: "" };
        OutOfProcess::compute(self, inputs, &allotted, observer)
    }

    fn apart(&self) -> Option<&dyn OutOfProcess> {
        Some(self)
    }
}

impl OutOfProcess for IsolatedComputation {
    fn compute(
        &self,
        inputs: &ComputeInputs,
        allotted: &Allotted<'_>,
        observer: &dyn Observer,
    ) -> Result<Answer, ComputeError> {
        let n_threads = allotted.n_threads;
        let parameters = self.parameters.clone();
        let (request, body): (Request, Vec<&[u8]>) = match &inputs.purpose {
            Purpose::Step(material) => {
                let files = material.files.iter().map(|(name, bytes)| (name.clone(), bytes.len())).collect();
                let definition = Box::new(material.definition.clone());
                let failures = material.failures.clone();
                let request = Request::Step { parameters, definition, files, failures, n_threads };
                (request, material.files.values().map(Vec::as_slice).collect())
            }
            purpose @ (Purpose::Result | Purpose::Record) => {
                let hints = [inputs.source_hint.clone(), inputs.target_hint.clone()];
                let record = matches!(purpose, Purpose::Record);
                let source_bytes = inputs.source.len();
                let request = Request::Match { parameters, hints, source_bytes, record, n_threads };
                (request, vec![&inputs.source, &inputs.target])
            }
        };
        let n_bytes: usize = body.iter().map(|part| part.len()).sum();
        // A step reads the files of its subjects one after another.
        let largest = match &inputs.purpose {
            Purpose::Step(material) => inputs_of(&material.definition).map(|input| input.n_bytes).max(),
            Purpose::Result | Purpose::Record => None,
        };
        let bounds = Bounds::of_computation(allotted, &self.shared.most, largest.unwrap_or(0).max(n_bytes as u64));
        let hashes: Vec<[u8; 32]> = match inputs.purpose {
            Purpose::Step(_) => Vec::new(),
            _ => body.iter().map(|file| *blake3::hash(file).as_bytes()).collect(),
        };
        let reported = AtomicUsize::new(0);
        let computed = tried(|| {
            let child = self.shared.children.take(allotted.owner, &hashes).map_err(RequestError::NotStarted)?;
            let observer = ResumedObserver { inner: observer, reported: &reported, seen: AtomicUsize::new(0) };
            self.attempt(child, &request, &body, bounds, inputs, &observer)
        });
        match computed {
            Ok(answered) => answered,
            Err(RequestError::Stopped) => Err(ComputeError::Cancelled),
            Err(RequestError::NotStarted(error)) => Err(ComputeError::NotStarted(error.to_string())),
            Err(RequestError::Died(death)) => Err(ComputeError::Failed(failure(death, bounds))),
        }
    }
}

impl IsolatedComputation {
    fn attempt(
        &self,
        mut child: Child,
        request: &Request,
        body: &[&[u8]],
        bounds: Bounds,
        inputs: &ComputeInputs,
        observer: &dyn Observer,
    ) -> RequestResult<Result<Answer, ComputeError>> {
        let mut products = Vec::new();
        let mut hear = |told: ChildMessage, body: Vec<u8>, child: &mut dyn Write| -> io::Result<()> {
            match told {
                ChildMessage::Phase(phase) => observer.phase(phase),
                ChildMessage::Progress(fraction) => observer.progress(fraction),
                ChildMessage::Trace(point) => observer.trace(&point),
                ChildMessage::Product(kind) => products.push(Product { kind, bytes: body }),
                ChildMessage::Fetch(hash) => fetch(&inputs.purpose, &hash, child)?,
                ChildMessage::Ready { .. } | ChildMessage::Done { .. } => {
                    return Err(io::Error::other("a child spoke out of turn"));
                }
            }
            Ok(())
        };
        let asked = child.ask(request, body, bounds, &|| observer.is_cancelled(), &mut hear);
        let (outcome, _, kept) = match asked {
            Ok(answered) => answered,
            Err(broken) => return Err(unanswered(child, broken)),
        };
        count(kept);
        let failed = |failure| Ok(Err(ComputeError::Failed(failure)));
        match outcome {
            Outcome::Answered(verdict) => {
                self.shared.children.give_back(child, kept);
                Ok(Ok(Answer { products, verdict }))
            }
            Outcome::Failed(failure) => {
                self.shared.children.give_back(child, kept);
                failed(failure)
            }
            Outcome::Panicked(place) => {
                tracing::error!(place, "panic in a child");
                end(child, "panicked");
                failed(internal_error())
            }
            Outcome::NoThreads(error) => {
                end(child, "failed");
                Err(RequestError::NotStarted(io::Error::other(error)))
            }
            _ => {
                end(child, "failed");
                failed(internal_error())
            }
        }
    }
}

/// The files of a study.
fn inputs_of(study: &StudyDefinition) -> impl Iterator<Item = &JobInput> {
    study.subjects.iter().map(|subject| &subject.input).chain(&study.template)
}

/// Sends a child the upload that it requests, if the upload belongs to the child's study.
fn fetch(purpose: &Purpose, hash: &str, child: &mut dyn Write) -> io::Result<()> {
    let Purpose::Step(material) = purpose else { return Err(io::Error::other("a match has both its files")) };
    let read = match inputs_of(&material.definition).any(|input| input.hash == hash) {
        true => material.inputs.read(hash),
        false => Err(io::Error::other("no file of this study")),
    };
    let (error, bytes) = match read {
        Ok(bytes) => (None, bytes),
        Err(error) => (Some(error.to_string()), Vec::new()),
    };
    super::protocol::write_frame(&mut { child }, &Request::Fetched { error }, &[&bytes])
}

/// Adds the cache lookups of a child to the metrics of this process.
fn count(kept: KeptSurfaces) {
    for (lookup, n) in [("hit", kept.hits), ("miss", kept.misses)] {
        metrics::counter!("homolog_prepared_surfaces_total", "lookup" => lookup).increment(n);
    }
    metrics::gauge!("homolog_prepared_surfaces_bytes").set(kept.bytes as f64);
}

/// The failure of a job whose child died.
fn failure(death: Death, bounds: Bounds) -> Failure {
    match death {
        Death::Memory => Failure::new(
            "out-of-memory",
            format!(
                "the computation took more memory than the {} bytes that were planned for it and ended; nothing else was \
                 affected",
                bounds.memory_bytes
            ),
        ),
        Death::Time => Failure::new(
            "run-time-exceeded",
            format!("the computation took more than the {} s of processor time that it may take", bounds.cpu.as_secs()),
        ),
        Death::Killed => Failure::new(
            "computation-crashed",
            "the process that computed the job was killed twice, by someone or for want of memory; nothing else was affected",
        ),
        Death::Crashed { signal } => {
            let how = signal.map_or_else(String::new, |signal| format!(" with signal {signal}"));
            Failure::new(
                "computation-crashed",
                format!("the process that computed the job crashed twice{how}; nothing else was affected"),
            )
        }
    }
}

fn internal_error() -> Failure {
    Failure::new("internal-error", "the computation ended unexpectedly; the cause is in the service's log")
}

/// Passes on the reports of a computation, except those that an earlier try has already passed on.
struct ResumedObserver<'a> {
    inner: &'a dyn Observer,
    /// Points that all tries together have passed on.
    reported: &'a AtomicUsize,
    /// Points of this try.
    seen: AtomicUsize,
}

impl Observer for ResumedObserver<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.inner)
    }

    fn phase(&self, phase: Phase) {
        self.inner.phase(phase);
    }

    fn trace(&self, point: &TracePoint) {
        let seen = self.seen.fetch_add(1, Ordering::Relaxed) + 1;
        if seen > self.reported.load(Ordering::Relaxed) {
            self.reported.store(seen, Ordering::Relaxed);
            self.inner.trace(point);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[derive(Default)]
    struct Heard(Mutex<Vec<u32>>);

    impl Observer for Heard {
        fn trace(&self, point: &TracePoint) {
            self.0.lock().unwrap().push(point.iteration);
        }
    }

    #[test]
    fn a_second_try_reports_only_what_the_first_one_did_not() {
        let (heard, reported) = (Heard::default(), AtomicUsize::new(0));
        for n_points in [3, 0, 5] {
            let observer = ResumedObserver { inner: &heard, reported: &reported, seen: AtomicUsize::new(0) };
            (1..=n_points).for_each(|i| observer.trace(&TracePoint::new(0, Phase::Inference, i)));
        }
        assert_eq!(*heard.0.lock().unwrap(), [1, 2, 3, 4, 5]);
    }

    #[test]
    fn only_deaths_that_need_not_be_the_requests_fault_are_tried_again() {
        for (death, expected) in
            [(Death::Memory, 1), (Death::Time, 1), (Death::Killed, TRIES), (Death::Crashed { signal: Some(11) }, TRIES)]
        {
            let mut n_tries = 0;
            let done: RequestResult<()> = tried(|| {
                n_tries += 1;
                Err(RequestError::Died(death))
            });
            assert!(matches!(done, Err(RequestError::Died(of)) if of == death));
            assert_eq!(n_tries, expected, "{death:?}");
        }
    }

    #[test]
    fn failures_say_what_was_planned_and_name_no_one() {
        let bounds = Bounds { memory_bytes: 12_345, n_threads: 1, cpu: Duration::from_secs(7) };
        let of = |death| failure(death, bounds);
        assert!(of(Death::Memory).detail.contains("12345 bytes"));
        assert_eq!(of(Death::Memory).code, "out-of-memory");
        assert!(of(Death::Time).detail.contains("7 s"));
        assert!(of(Death::Crashed { signal: Some(11) }).detail.contains("signal 11"));
    }
}
