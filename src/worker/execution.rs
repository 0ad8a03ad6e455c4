//! One job, from its claim to its end.

use super::control::{Control, StopCause};
use super::pool::{PoolParts, with_sources};
use super::priority::give_way;
use super::recorder::Recorder;
use crate::jobs::engine::Product;
use crate::jobs::{
    ArtifactKey, ArtifactRef, ComputeError, ComputeTask, Failure, JobError, JobInput, Lease, LeasedJob, Outcome,
    TraceChunk,
};
use std::future::Future;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::oneshot;
use tokio::time::{MissedTickBehavior, interval, sleep, sleep_until};

/// How long writing a result may take before its blobs count as nobody's.
const HOLD: Duration = Duration::from_secs(600);
/// How long a store that does not answer is asked again; then the lease runs out and the job is run anew.
const STORE_PATIENCE: Duration = Duration::from_secs(60);

/// How long a job's cores stay unused after a store was away for longer than that.
const AFTER_OUTAGE: Duration = Duration::from_secs(5);

/// What the computation's thread answers.
type Computed = Result<Vec<Product>, ComputeError>;

/// How the job is to end.
enum Ending {
    Publish(Vec<Product>),
    Fail(Failure),
    Cancel,
    GiveBack,
    /// It is not ours any more.
    Leave,
}

/// Runs a claimed job to its end, computing on `n_threads`. Never fails: what goes wrong becomes the job's outcome, or the
/// lease runs out.
pub async fn execute(parts: &PoolParts, leased: LeasedJob, n_threads: usize) {
    parts.signals.tell_moved(leased.lease.job_id);
    let LeasedJob { lease, job } = leased;
    // Logs of the submission and of its run can be joined by the client's own trace.
    let trace = job.traceparent.as_deref();
    let (attempt, epoch) = (job.attempt, lease.epoch);
    tracing::info!(job_id = %lease.job_id, epoch, attempt, n_threads, traceparent = trace, "job begins");
    let began = Instant::now();
    let control = Arc::new(Control::default());
    let _watch = parts.heart.watch(&lease, Arc::clone(&control));
    let read = async {
        let source = read_input(parts, &lease, &job.source).await?;
        let target = read_input(parts, &lease, &job.target).await?;
        Ok::<_, JobError>(ComputeTask {
            parameters: job.parameters.clone(),
            source,
            source_hint: job.source.name_hint.clone(),
            target,
            target_hint: job.target.name_hint.clone(),
        })
    };
    let task = match read.await {
        Ok(task) => task,
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "inputs could not be read");
            // A store that is away is no fault of the job's; what it holds unreadably is lost for every worker.
            if is_passing(&error) {
                settle(parts, &lease, None, Ending::GiveBack).await;
                sleep(AFTER_OUTAGE).await;
            } else {
                settle(parts, &lease, None, Ending::Fail(internal_error())).await;
            }
            return;
        }
    };
    let recorder = Arc::new(Recorder::new(Arc::clone(&control)));
    let mut answer = match start_computation(parts, task, &recorder, n_threads) {
        Ok(answer) => answer,
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, %error, "no thread for the computation");
            settle(parts, &lease, None, Ending::GiveBack).await;
            sleep(parts.settings.poll).await;
            return;
        }
    };
    let allowed = job.max_run_ms.map_or(parts.settings.max_run, Duration::from_millis).min(parts.settings.max_run);
    let (computed, unsaved) = follow(parts, &lease, &control, &recorder, allowed, &mut answer).await;
    let still_running = computed.is_none();
    let ending = decide(computed, control.cause());
    let last = [unsaved, recorder.take()];
    let name = settle(parts, &lease, Some(last), ending).await;
    parts.signals.tell_moved(lease.job_id);
    let elapsed_ms = began.elapsed().as_millis();
    tracing::info!(job_id = %lease.job_id, epoch = lease.epoch, elapsed_ms, end = name, "job ends");
    metrics::counter!("homolog_jobs_finished_total", "end" => name).increment(1);
    metrics::histogram!("homolog_job_seconds").record(began.elapsed().as_secs_f64());
    if still_running && control.cause() != Some(StopCause::Shutdown) {
        // Its job is ended; its cores are not free while the threads still take them.
        if tokio::time::timeout(parts.settings.abandon_after, &mut answer).await.is_err() {
            tracing::error!(job_id = %lease.job_id, "a computation ignores its end; its thread is given up");
        }
    }
}

async fn read_input(parts: &PoolParts, lease: &Lease, input: &JobInput) -> Result<Vec<u8>, JobError> {
    let key = ArtifactKey::of_hash(&lease.tenant, &input.hash);
    let key = key.ok_or(JobError::Corrupt { what: "an input's hash", source: None })?;
    let bytes = insist(|| parts.artifacts.get(&key)).await?;
    Ok(bytes.into())
}

fn start_computation(
    parts: &PoolParts,
    task: ComputeTask,
    recorder: &Arc<Recorder>,
    n_threads: usize,
) -> std::io::Result<oneshot::Receiver<Computed>> {
    let (engine, recorder) = (Arc::clone(&parts.engine), Arc::clone(recorder));
    let (sender, receiver) = oneshot::channel();
    // Of its own, so that a job has just the threads that it was given, however many run beside it.
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(n_threads)
        .thread_name(|i| format!("compute-{i}"))
        .start_handler(|_| give_way())
        .build();
    let pool = pool.map_err(std::io::Error::other)?;
    std::thread::Builder::new().name("compute".to_owned()).spawn(move || {
        give_way();
        // Nothing of the engine's outlives a panic: task and recorder are this job's own.
        let computed = catch_unwind(AssertUnwindSafe(|| pool.install(|| engine.compute(&task, recorder.as_ref()))));
        // The panic hook has logged where; what it said may hold a patient's data and is dropped.
        let _ = sender.send(computed.unwrap_or_else(|_| Err(ComputeError::Failed(internal_error()))));
    })?;
    Ok(receiver)
}

/// Stores trace and progress while the computation runs. `None`: it was told to stop and does not.
async fn follow(
    parts: &PoolParts,
    lease: &Lease,
    control: &Control,
    recorder: &Recorder,
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
                // The sender is gone without an answer only if the thread could not even catch its panic.
                let computed = computed.unwrap_or_else(|_| Err(ComputeError::Failed(internal_error())));
                return (Some(computed), unsaved);
            }
            () = control.stopped(), if give_up_at.is_none() => {
                give_up_at = Some(tokio::time::Instant::now() + settings.stop_patience);
            }
            () = sleep_until(give_up_at.unwrap_or(time_limit)), if give_up_at.is_some() => return (None, unsaved),
            () = sleep_until(time_limit), if give_up_at.is_none() => control.stop(StopCause::TimeLimit),
            () = parts.give_back.cancelled(), if give_up_at.is_none() => control.stop(StopCause::Shutdown),
            _ = ticks.tick() => {
                if unsaved.is_none() {
                    unsaved = recorder.take();
                }
                if let Some(chunk) = &unsaved {
                    match parts.store.append_trace(lease, chunk).await {
                        Ok(()) => unsaved = None,
                        Err(JobError::LeaseLost) => control.stop(StopCause::LeaseLost),
                        Err(error) => {
                            tracing::warn!(job_id = %lease.job_id, error = %with_sources(&error), "trace waits");
                        }
                    }
                }
            }
        }
    }
}

/// What becomes of a job whose computation answered `computed` (`None`: it does not stop) after `cause`.
fn decide(computed: Option<Computed>, cause: Option<StopCause>) -> Ending {
    match (computed, cause) {
        (_, Some(StopCause::LeaseLost)) => Ending::Leave,
        // A result that is there counts, whatever came meanwhile.
        (Some(Ok(products)), _) => Ending::Publish(products),
        (Some(Err(ComputeError::Failed(failure))), _) => Ending::Fail(failure),
        (_, Some(StopCause::CancelRequested)) => Ending::Cancel,
        (_, Some(StopCause::Shutdown)) => Ending::GiveBack,
        (_, Some(StopCause::TimeLimit)) => {
            Ending::Fail(Failure::new("run-time-exceeded", "the job ran longer than this service allows"))
        }
        // It stopped though nobody asked: a fault of the engine.
        (_, None) => Ending::Fail(internal_error()),
    }
}

/// Writes the ending, asking a store that does not answer again. Returns a word for the log.
async fn settle(
    parts: &PoolParts,
    lease: &Lease,
    last: Option<[Option<TraceChunk>; 2]>,
    ending: Ending,
) -> &'static str {
    if matches!(ending, Ending::Leave) {
        return "lease lost";
    }
    let written = async {
        for chunk in last.iter().flatten().flatten() {
            insist(|| parts.store.append_trace(lease, chunk)).await?;
        }
        match ending {
            Ending::Publish(products) => {
                let artifacts = publish(parts, lease, products).await?;
                let outcome = Outcome::Succeeded(artifacts);
                insist(|| parts.store.finish(lease, &outcome, parts.settings.keep_results)).await?;
                Ok("succeeded")
            }
            Ending::Fail(failure) => {
                let outcome = Outcome::Failed(failure);
                insist(|| parts.store.finish(lease, &outcome, parts.settings.keep_results)).await?;
                Ok("failed")
            }
            Ending::Cancel => {
                insist(|| parts.store.finish(lease, &Outcome::Cancelled, None)).await?;
                Ok("cancelled")
            }
            Ending::GiveBack => {
                insist(|| parts.store.release(lease)).await?;
                Ok("given back")
            }
            Ending::Leave => Ok("lease lost"),
        }
    };
    match written.await {
        Ok(name) => name,
        Err(JobError::LeaseLost) => "lease lost",
        // The result is lost and will be computed anew; that the blob store was away must not count as a crash.
        Err(error) if is_passing(&error) && parts.store.release(lease).await.is_ok() => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "the result could not be stored");
            sleep(AFTER_OUTAGE).await;
            "given back"
        }
        Err(error) => {
            tracing::error!(job_id = %lease.job_id, error = %with_sources(&error), "the job's end could not be stored");
            "not stored"
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
    insist(|| parts.store.hold_blobs(&holder, &keys, HOLD, Some(lease))).await?;
    for (artifact, bytes) in &products {
        insist(|| parts.artifacts.put(&artifact.key, bytes.clone())).await?;
    }
    Ok(products.into_iter().map(|(artifact, _)| artifact).collect())
}

/// Does `work` again while the store does not answer, for a while. The fence makes a repeat harmless.
async fn insist<T, F: Future<Output = Result<T, JobError>>>(work: impl Fn() -> F) -> Result<T, JobError> {
    let began = Instant::now();
    let mut wait = Duration::from_millis(50);
    loop {
        match work().await {
            Err(error) if is_passing(&error) && began.elapsed() < STORE_PATIENCE => {
                sleep(wait).await;
                wait = (wait * 2).min(Duration::from_secs(2));
            }
            done => return done,
        }
    }
}

/// Whether the same may succeed later.
fn is_passing(error: &JobError) -> bool {
    matches!(error, JobError::Unavailable(_) | JobError::StorageFull | JobError::BeingRemoved)
}

fn internal_error() -> Failure {
    Failure::new("internal-error", "the computation ended unexpectedly; the cause is in the service's log")
}
