//! One job, from its claim to its end.
//!
//! Writes to a store that does not answer are repeated for a while ([`super::retry`]); the fence of the lease makes repeats harmless.

use super::control::{Control, StopCause};
use super::error_text::with_sources;
use super::observer::JobObserver;
use super::pool_parts::PoolParts;
use super::priority::{lower_priority, own_threads};
use super::retry::{is_transient, retrying};
use super::study_material;
use crate::jobs::engine::{Answer, Product};
use crate::jobs::{
    Allotted, ArtifactKey, ArtifactKind, ArtifactRef, BLOB_HOLD, Computation, ComputeError, ComputeInputs, Failure,
    Job, JobError, JobInput, Lease, LeasedJob, Outcome, Purpose, SurfaceSize, Tenant, TraceChunk,
};
use crate::spans::{Fact, Span};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::oneshot;
use tokio::time::{MissedTickBehavior, interval, sleep, sleep_until};

/// How long a job's cores stay unused after a store was unavailable for longer than calls are repeated.
const AFTER_OUTAGE: Duration = Duration::from_secs(5);

/// The value that the computation's thread returns.
type Computed = Result<Answer, ComputeError>;

/// How a job ends.
enum Ending {
    Publish(Answer),
    Fail(Failure),
    Cancel,
    Release,
    /// The job does not end here: another worker holds the lease.
    Abandon,
}

/// The end of a job, as the log and the metrics name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum JobEnd {
    Succeeded,
    Failed,
    Cancelled,
    /// The job is in the queue again.
    GivenBack,
    /// Another worker holds the job, or it was deleted.
    LeaseLost,
    /// The store did not take the end of the job.
    NotStored,
}

impl JobEnd {
    fn label(self) -> &'static str {
        match self {
            JobEnd::Succeeded => "succeeded",
            JobEnd::Failed => "failed",
            JobEnd::Cancelled => "cancelled",
            JobEnd::GivenBack => "given back",
            JobEnd::LeaseLost => "lease lost",
            JobEnd::NotStored => "not stored",
        }
    }
}

/// The resources that a computation may use.
struct Allotment {
    n_threads: usize,
    memory_bytes: u64,
    max_run: Duration,
    owner: Tenant,
}

impl Allotment {
    fn new(job: &Job, lease: &Lease, computation: &dyn Computation, n_threads: usize, max_run: Duration) -> Self {
        let size = |input: &JobInput| SurfaceSize { n_vertices: input.n_vertices, n_faces: input.n_faces };
        let memory_bytes = computation.demand(size(&job.source), size(&job.target)).memory_bytes;
        Allotment { n_threads, memory_bytes, max_run, owner: lease.tenant.clone() }
    }

    fn lent(&self) -> Allotted<'_> {
        let Allotment { n_threads, memory_bytes, max_run, owner } = self;
        Allotted { n_threads: *n_threads, memory_bytes: *memory_bytes, max_run: *max_run, owner: owner.name() }
    }
}

/// Runs a claimed job on `n_threads` until it ends. Does not fail: every error becomes the outcome of the job, or its
/// lease expires.
pub(crate) async fn execute(
    parts: &PoolParts,
    leased: LeasedJob,
    computation: Result<Arc<dyn Computation>, Failure>,
    n_threads: usize,
) {
    parts.signals.tell_moved(leased.lease.job_id);
    let LeasedJob { lease, job } = leased;
    // The client's trace context joins the logs of the submission with those of the run.
    let trace = job.traceparent.as_deref();
    let (attempt, epoch) = (job.attempt, lease.epoch);
    tracing::info!(job_id = %lease.job_id, epoch, attempt, n_threads, traceparent = trace, "job started");
    let mut span = Span::of_job(trace);
    for (key, fact) in [
        ("homolog.job_id", Fact::Id(lease.job_id.uuid())),
        ("homolog.attempt", Fact::Number(attempt.into())),
        ("homolog.lease_epoch", Fact::Number(epoch)),
        ("homolog.threads", Fact::Number(n_threads as u64)),
    ] {
        span.set(key, fact);
    }
    if epoch == 1 {
        drop(Span::part_since("wait in queue", trace, job.created_at.into()));
    }
    let began = Instant::now();
    let control = Arc::new(Control::default());
    let _watch = parts.heartbeats.watch(&lease, Arc::clone(&control));
    let (end, unfinished) = match computation {
        Ok(computation) => run(parts, &lease, &job, computation, &control, n_threads, &span).await,
        Err(failure) => (settle(parts, &lease, [None, None], Ending::Fail(failure)).await, None),
    };
    parts.signals.tell_moved(lease.job_id);
    if let Some(study) = job.study_id
        && let Err(error) = parts.studies.advance(&lease.tenant, study).await
    {
        tracing::warn!(study_id = %study, error = %with_sources(&error), "a study goes on later");
    }
    let elapsed_ms = u64::try_from(began.elapsed().as_millis()).unwrap_or(u64::MAX);
    tracing::info!(job_id = %lease.job_id, epoch, elapsed_ms, end = end.label(), "job ended");
    span.set("homolog.end", Fact::Word(end.label()));
    if !matches!(end, JobEnd::Succeeded | JobEnd::Cancelled) {
        span.fail();
    }
    drop(span);
    metrics::counter!("homolog_jobs_finished_total", "end" => end.label()).increment(1);
    metrics::histogram!("homolog_job_seconds").record(began.elapsed().as_secs_f64());
    if let Some(mut computed) = unfinished
        && control.cause() != Some(StopCause::Shutdown)
    {
        // The job has ended, but its cores are not free while its threads still use them.
        if tokio::time::timeout(parts.settings.abandon_after, &mut computed).await.is_err() {
            tracing::error!(job_id = %lease.job_id, "a computation does not stop; its thread is abandoned");
        }
    }
}

/// Reads the inputs, computes, and settles the job. Returns how the job ended, for the log, and the channel of a
/// computation that was told to stop and still runs.
async fn run(
    parts: &PoolParts,
    lease: &Lease,
    job: &Job,
    computation: Arc<dyn Computation>,
    control: &Arc<Control>,
    n_threads: usize,
    span: &Span,
) -> (JobEnd, Option<oneshot::Receiver<Computed>>) {
    let context = span.traceparent();
    let reading = Span::part("read inputs", context.as_deref());
    let inputs = if job.is_step() || job.is_score() {
        study_material::read_step(parts, lease, job).await
    } else {
        read_inputs(parts, lease, job).await
    };
    drop(reading);
    let inputs = match inputs {
        Ok(inputs) => inputs,
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "the inputs could not be read");
            // An unavailable store is not the job's fault. Unreadable content is unreadable for every worker.
            if !is_transient(&error) {
                let failure = missing_input(parts, lease, job).await.unwrap_or_else(internal_error);
                return (settle(parts, lease, [None, None], Ending::Fail(failure)).await, None);
            }
            let end = settle(parts, lease, [None, None], Ending::Release).await;
            sleep(AFTER_OUTAGE).await;
            return (end, None);
        }
    };
    let observer = Arc::new(JobObserver::new(Arc::clone(control), context.clone()));
    let allowed = job.max_run_ms.map_or(parts.settings.max_run, Duration::from_millis).min(parts.settings.max_run);
    let allotment = Allotment::new(job, lease, computation.as_ref(), n_threads, allowed);
    let mut computed = match start_computation(computation, inputs, &observer, allotment) {
        Ok(computed) => computed,
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, %error, "no thread for the computation");
            let end = settle(parts, lease, [None, None], Ending::Release).await;
            sleep(parts.settings.poll).await;
            return (end, None);
        }
    };
    let (outcome, unsaved) = follow(parts, lease, control, &observer, allowed, &mut computed).await;
    let is_running = outcome.is_none();
    let has_begun = !matches!(outcome, Some(Err(ComputeError::NotStarted(_))));
    let ending = decide(outcome, control.cause());
    observer.end_phase();
    if let Ending::Publish(answer) = &ending
        && let Some(energy) = energy_of(answer)
    {
        observer.settle_energy(energy);
    }
    let storing = Span::part("store result", context.as_deref());
    let end = settle(parts, lease, [unsaved, observer.take()], ending).await;
    drop(storing);
    if !has_begun {
        sleep(AFTER_OUTAGE).await;
    }
    (end, is_running.then_some(computed))
}

/// The energy that the result document states.
fn energy_of(answer: &Answer) -> Option<f64> {
    #[derive(serde::Deserialize)]
    struct Energy {
        r#final: f64,
    }
    #[derive(serde::Deserialize)]
    struct Document {
        energy: Option<Energy>,
    }
    let document = answer.products.iter().find(|product| product.kind == ArtifactKind::Result)?;
    serde_json::from_slice::<Document>(&document.bytes).ok()?.energy.map(|energy| energy.r#final)
}

async fn read_inputs(parts: &PoolParts, lease: &Lease, job: &Job) -> Result<ComputeInputs, JobError> {
    Ok(ComputeInputs {
        source: read_input(parts, lease, &job.source).await?,
        source_hint: job.source.name_hint.clone(),
        target: read_input(parts, lease, &job.target).await?,
        target_hint: job.target.name_hint.clone(),
        purpose: if job.study_id.is_some() { Purpose::Record } else { Purpose::Result },
    })
}

/// The input that the blob store does not hold or holds damaged, by its place and its hash; `None` if something else
/// failed.
async fn missing_input(parts: &PoolParts, lease: &Lease, job: &Job) -> Option<Failure> {
    for (name, input) in [("source", &job.source), ("target", &job.target)] {
        if let Err(JobError::Corrupt { what, .. }) = read_input(parts, lease, input).await {
            let hash = &input.hash;
            let detail = format!("the blob store has {what} for the {name}, the upload with the BLAKE3 hash {hash}");
            return Some(Failure::new("input-missing", detail));
        }
    }
    None
}

async fn read_input(parts: &PoolParts, lease: &Lease, input: &JobInput) -> Result<Vec<u8>, JobError> {
    let key = ArtifactKey::of_hash(&lease.tenant, &input.hash);
    let key = key.ok_or(JobError::Corrupt { what: "an input's hash", source: None })?;
    let bytes = retrying(|| parts.artifacts.get(&key)).await?;
    Ok(bytes.into())
}

fn start_computation(
    computation: Arc<dyn Computation>,
    inputs: ComputeInputs,
    observer: &Arc<JobObserver>,
    allotment: Allotment,
) -> std::io::Result<oneshot::Receiver<Computed>> {
    let observer = Arc::clone(observer);
    let (sender, receiver) = oneshot::channel();
    // A child process has its own threads.
    let pool = if computation.apart().is_none() { Some(own_threads(allotment.n_threads)?) } else { None };
    std::thread::Builder::new().name("compute".to_owned()).spawn(move || {
        let work = || match (computation.apart(), pool) {
            (Some(apart), _) => apart.compute(&inputs, &allotment.lent(), observer.as_ref()),
            (None, Some(pool)) => {
                lower_priority();
                pool.install(|| computation.compute(&inputs, observer.as_ref()))
            }
            (None, None) => Err(ComputeError::Failed(internal_error())),
        };
        // A panic cannot leave state inconsistent that is used again: inputs and observer belong to this job alone.
        let computed = catch_unwind(AssertUnwindSafe(work));
        // The panic hook has logged the location. The message is dropped, because it may contain a patient's data.
        let _ = sender.send(computed.unwrap_or_else(|_| Err(ComputeError::Failed(internal_error()))));
    })?;
    Ok(receiver)
}

/// Stores trace and progress while the computation runs. Returns the outcome of the computation, or `None` if it does
/// not stop although it was told to, and the part of the trace that could not be stored yet.
async fn follow(
    parts: &PoolParts,
    lease: &Lease,
    control: &Control,
    observer: &JobObserver,
    max_run: Duration,
    answer: &mut oneshot::Receiver<Computed>,
) -> (Option<Computed>, Option<TraceChunk>) {
    let settings = &parts.settings;
    let time_limit = tokio::time::Instant::now() + max_run;
    let mut give_up_at = None;
    let mut unsaved: Option<TraceChunk> = None;
    let mut ticks = interval(settings.flush);
    ticks.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        tokio::select! {
            computed = &mut *answer => {
                // The sender is dropped without a value only if the thread could not even catch its panic.
                let computed = computed.unwrap_or_else(|_| Err(ComputeError::Failed(internal_error())));
                return (Some(computed), unsaved);
            }
            () = control.stopped(), if give_up_at.is_none() => {
                give_up_at = Some(tokio::time::Instant::now() + settings.stop_timeout);
            }
            () = sleep_until(give_up_at.unwrap_or(time_limit)), if give_up_at.is_some() => return (None, unsaved),
            () = sleep_until(time_limit), if give_up_at.is_none() => control.stop(StopCause::TimeLimit),
            () = parts.give_back.cancelled(), if give_up_at.is_none() => control.stop(StopCause::Shutdown),
            _ = ticks.tick() => {
                if unsaved.is_none() {
                    unsaved = observer.take();
                }
                if let Some(chunk) = &unsaved {
                    match parts.store.append_trace(lease, chunk).await {
                        Ok(()) => unsaved = None,
                        Err(JobError::LeaseLost) => control.stop(StopCause::LeaseLost),
                        Err(error) => {
                            tracing::warn!(job_id = %lease.job_id, error = %with_sources(&error), "the trace could not be stored; it is tried again");
                        }
                    }
                }
            }
        }
    }
}

/// How a job ends, from what its computation returned (`None`: it does not stop) and the `cause` for which it was told
/// to stop.
fn decide(computed: Option<Computed>, cause: Option<StopCause>) -> Ending {
    match (computed, cause) {
        (_, Some(StopCause::LeaseLost)) => Ending::Abandon,
        // A finished result is accepted, even if a stop was requested in the meantime.
        (Some(Ok(answer)), _) => Ending::Publish(answer),
        (Some(Err(ComputeError::Failed(failure))), _) => Ending::Fail(failure),
        (_, Some(StopCause::CancelRequested)) => Ending::Cancel,
        (_, Some(StopCause::Shutdown)) => Ending::Release,
        (_, Some(StopCause::TimeLimit)) => {
            Ending::Fail(Failure::new("run-time-exceeded", "the job ran longer than this service allows"))
        }
        (Some(Err(ComputeError::NotStarted(why))), None) => {
            tracing::error!(why, "no process for the computation");
            Ending::Release
        }
        // The computation stopped although nobody told it to: a fault of the engine.
        (_, None) => Ending::Fail(internal_error()),
    }
}

/// Stores the rest of the trace and the end of the job. Returns how it ended, for the log and the metrics.
async fn settle(parts: &PoolParts, lease: &Lease, rest: [Option<TraceChunk>; 2], ending: Ending) -> JobEnd {
    if matches!(ending, Ending::Abandon) {
        return JobEnd::LeaseLost;
    }
    let written = async {
        for chunk in rest.iter().flatten() {
            retrying(|| parts.store.append_trace(lease, chunk)).await?;
        }
        match ending {
            Ending::Publish(Answer { products, verdict }) => {
                let artifacts = publish(parts, lease, products).await?;
                let outcome = Outcome::Succeeded { artifacts, verdict };
                retrying(|| {
                    parts.store.finish_job(lease, &outcome, parts.settings.retention.of(&lease.tenant).results)
                })
                .await?;
                Ok(JobEnd::Succeeded)
            }
            Ending::Fail(failure) => {
                let outcome = Outcome::Failed(failure);
                retrying(|| {
                    parts.store.finish_job(lease, &outcome, parts.settings.retention.of(&lease.tenant).results)
                })
                .await?;
                Ok(JobEnd::Failed)
            }
            Ending::Cancel => {
                retrying(|| parts.store.finish_job(lease, &Outcome::Cancelled, None)).await?;
                Ok(JobEnd::Cancelled)
            }
            Ending::Release => {
                retrying(|| parts.store.release_job(lease)).await?;
                Ok(JobEnd::GivenBack)
            }
            Ending::Abandon => Ok(JobEnd::LeaseLost),
        }
    };
    match written.await {
        Ok(end) => end,
        Err(JobError::LeaseLost) => JobEnd::LeaseLost,
        // The result is lost and will be computed again. An unavailable blob store must not count as a crash.
        Err(error) if is_transient(&error) && parts.store.release_job(lease).await.is_ok() => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "the result could not be stored");
            sleep(AFTER_OUTAGE).await;
            JobEnd::NotStored
        }
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "the job's end could not be stored");
            JobEnd::NotStored
        }
    }
}

async fn publish(parts: &PoolParts, lease: &Lease, products: Vec<Product>) -> Result<Vec<ArtifactRef>, JobError> {
    let products: Vec<_> = products
        .into_iter()
        .map(|p| {
            let key = ArtifactKey::of_result(lease, &p.bytes);
            (ArtifactRef { kind: p.kind, key, n_bytes: p.bytes.len() as u64 }, bytes::Bytes::from(p.bytes))
        })
        .collect();
    let keys: Vec<_> = products.iter().map(|(artifact, _)| artifact.key.clone()).collect();
    let holder = lease.holder();
    retrying(|| parts.store.hold_blobs(&holder, &keys, BLOB_HOLD, Some(lease))).await?;
    for (artifact, bytes) in &products {
        retrying(|| parts.artifacts.put(&artifact.key, bytes.clone())).await?;
    }
    Ok(products.into_iter().map(|(artifact, _)| artifact).collect())
}

fn internal_error() -> Failure {
    Failure::new("internal-error", "the computation ended unexpectedly; the cause is in the service's log")
}
