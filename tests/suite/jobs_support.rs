//! A scripted engine, controlled by the parameters of its jobs, and a service with this engine on a separate port and
//! folder.

use crate::patience::PATIENCE;
use homolog::app::{self, App, Shutdown};
use homolog::config::{HttpSettings, ServiceSettings};
use homolog::jobs::engine::{Answer, MethodDescription, Product, Resolved};
use homolog::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Demand, Engine, Failure, InputBytes, InputRefusal,
    InputSummary, InputView, ParameterFault, PartFormat, PresentError, ResultPart, SurfaceSize,
};
use homolog_contract::result::{SurfaceDistanceDocument, UnreliableReason};
use homolog_contract::verdict::Verdict;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// Numbers that a job's parameters may set: the predicted processor time, points of the trace, ms between them, and switches (not 0 = on).
const KEYS: [&str; 11] =
    ["processor_ms", "points", "step_ms", "fail", "panic", "abort", "deaf", "sign", "seed", "cores", "energy"];

/// The verdict on the answers of the scripted engine.
pub(crate) fn doubtful() -> Verdict {
    let surface_distance = SurfaceDistanceDocument { mean_mm: 0.5, p95_mm: 1.25, max_mm: 3.0 };
    Verdict {
        reliable: Some(false),
        reasons: vec![UnreliableReason::AmbiguousPose],
        warnings: Vec::new(),
        surface_distance,
    }
}

/// Follows the parameters of each job.
#[derive(Debug, Default)]
pub(crate) struct ScriptedEngine {
    /// Number of computations.
    pub computed: Arc<AtomicU32>,
    /// Number of stored jobs whose parameters were read.
    pub restored: AtomicU32,
}

/// A computation of the scripted engine: the numbers of its parameters.
#[derive(Debug)]
struct Obedience {
    numbers: BTreeMap<String, u64>,
    computed: Arc<AtomicU32>,
}

impl Obedience {
    fn number(&self, key: &str) -> u64 {
        self.numbers.get(key).copied().unwrap_or(0)
    }
}

impl ScriptedEngine {
    fn computation(&self, parameters: &Value) -> Arc<dyn Computation> {
        let numbers = serde_json::from_value(parameters.clone()).unwrap();
        Arc::new(Obedience { numbers, computed: Arc::clone(&self.computed) })
    }
}

impl Engine for ScriptedEngine {
    fn methods(&self) -> Vec<MethodDescription> {
        vec![MethodDescription {
            name: "scripted".to_owned(),
            version: "1".to_owned(),
            description: "Does what its parameters say.".to_owned(),
            defaults: json!({}),
        }]
    }

    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>> {
        let faults: Vec<_> = request
            .as_object()
            .unwrap()
            .iter()
            .filter(|(key, value)| !KEYS.contains(&key.as_str()) || !value.is_u64())
            .map(|(key, _)| ParameterFault {
                pointer: format!("/{key}"),
                code: "unknown_key".to_owned(),
                detail: "unknown, or no number".to_owned(),
            })
            .collect();
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Resolved {
            method: "scripted".to_owned(),
            method_version: "1".to_owned(),
            parameters: request.clone(),
            computation: self.computation(request),
            input_keys: [String::new(), String::new()],
            result_version: "1".to_owned(),
        })
    }

    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure> {
        self.restored.fetch_add(1, Ordering::SeqCst);
        Ok(self.computation(parameters))
    }

    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        homolog::worker::presentation::present(part, format, stored)
    }
}

impl Computation for Obedience {
    fn check_input(&self, input: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        if input.bytes.starts_with(b"panic") {
            panic!("as requested");
        }
        if input.bytes.starts_with(b"slow") {
            std::thread::sleep(Duration::from_secs(30));
        }
        if input.bytes.starts_with(b"bad") {
            let topology = Some(json!({"n_components": 2}));
            return Err(InputRefusal {
                code: "unsuitable-surface".to_owned(),
                detail: "two pieces".to_owned(),
                topology,
                place_mm: Some([1.0, 2.0, 3.0]),
            });
        }
        Ok(InputSummary { n_vertices: 3, n_faces: 1, report: json!({"hint": input.name_hint}) })
    }

    fn show_input(&self, input: &InputBytes<'_>, view: InputView) -> Result<Vec<u8>, InputRefusal> {
        let what: &[u8] = if view == InputView::Surface { b"surface of " } else { b"volume of " };
        Ok([what, input.bytes].concat())
    }

    fn demand(&self, _: SurfaceSize, _: SurfaceSize) -> Demand {
        let number = |key| self.numbers.get(key).copied();
        Demand {
            cores: number("cores").map_or(Demand::UNKNOWN.cores, |cores| cores as usize),
            processor_time: Duration::from_millis(number("processor_ms").unwrap_or(0)),
            ..Demand::UNKNOWN
        }
    }

    fn compute(&self, _: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        self.computed.fetch_add(1, Ordering::SeqCst);
        let number = |key: &str| self.number(key);
        let points = number("points");
        observer.phase(Phase::Inference);
        for i in 1..=points {
            if number("deaf") == 0 && observer.is_cancelled() {
                return Err(ComputeError::Cancelled);
            }
            let mut point = TracePoint::new(0, Phase::Inference, i as u32);
            point.energy = Some(1000.0 / i as f64);
            observer.trace(&point);
            observer.progress(i as f64 / points as f64);
            std::thread::sleep(Duration::from_millis(number("step_ms")));
        }
        if number("abort") != 0 {
            std::process::abort();
        }
        if number("panic") != 0 {
            panic!("as requested, with Jane Doe in the message");
        }
        if number("fail") != 0 {
            return Err(ComputeError::Failed(Failure::new("no-registration", "as requested")));
        }
        let mut result = json!({"transform": {"matrix": [[1.5]]}, "points": points});
        if number("sign") != 0 {
            result["process"] = json!(std::process::id());
            result["n_threads"] = json!(rayon::current_num_threads());
        }
        if number("energy") != 0 {
            result["energy"] = json!({"final": number("energy")});
        }
        let product = |kind, text: String| Product { kind, bytes: text.into_bytes() };
        let columns = json!({
            "source": [0, 1], "target": [1, 0], "confidence": [0.5, 0.25], "inlier": [true, false], "spread_mm": [0.0, 0.0],
            "outlier": ["none", "none"], "triangle": [[1, 1, 1], [0, 0, 0]],
            "barycentric": [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
        });
        let products = vec![
            product(ArtifactKind::Result, result.to_string()),
            product(ArtifactKind::Correspondences, columns.to_string()),
            product(ArtifactKind::SourceSurface, "ply source".to_owned()),
            product(ArtifactKind::TargetSurface, "ply target".to_owned()),
            product(ArtifactKind::Aligned, "ply aligned".to_owned()),
        ];
        Ok(Answer { products, verdict: Some(doubtful()) })
    }
}

#[derive(Debug, clap::Parser)]
struct Arguments {
    #[command(flatten)]
    http: HttpSettings,
    #[command(flatten)]
    service: ServiceSettings,
}

/// A service in this process.
pub(crate) struct TestService {
    pub base: String,
    pub client: reqwest::Client,
    pub engine: Arc<ScriptedEngine>,
    pub shutdown: Shutdown,
    pub folder: Arc<tempfile::TempDir>,
    /// The address of its probes, if `--probe-listen` is given.
    pub probes: String,
    running: tokio::task::JoinHandle<()>,
}

/// A service process that only runs jobs, within this process.
pub(crate) struct WorkerProcess {
    pub shutdown: Shutdown,
    pub engine: Arc<ScriptedEngine>,
    pub running: tokio::task::JoinHandle<()>,
}

impl TestService {
    pub(crate) async fn start(more: &[&str]) -> Self {
        TestService::start_in(Arc::new(tempfile::tempdir().unwrap()), more).await
    }

    pub(crate) async fn start_in(folder: Arc<tempfile::TempDir>, more: &[&str]) -> Self {
        TestService::start_with(folder, more, None).await
    }

    /// As [`Self::start`], with another engine instead of the scripted one.
    pub(crate) async fn start_with(
        folder: Arc<tempfile::TempDir>,
        more: &[&str],
        other: Option<Arc<dyn Engine>>,
    ) -> Self {
        let data_dir = folder.path().to_str().unwrap().to_owned();
        let mut arguments = vec!["test", "--data-dir", &data_dir, "--poll-ms", "20"];
        if !more.contains(&"--listen") {
            arguments.extend(["--listen", "127.0.0.1:0"]);
        }
        let Arguments { http, service } = clap::Parser::parse_from(arguments.iter().chain(more));
        homolog::tls::prepare();
        let shutdown = Shutdown::default();
        let listener = app::listen(&http).await.unwrap();
        let base = format!("http://127.0.0.1:{}", listener.local_addr().unwrap().port());
        let engine = Arc::new(ScriptedEngine::default());
        let used = other.unwrap_or_else(|| Arc::clone(&engine) as Arc<dyn Engine>);
        let app = App::open(&service, used, &shutdown, true).await.unwrap();
        let ends = shutdown.clone();
        let probe_listener = match http.probe_listen {
            Some(address) => Some(app::bind(address).await.unwrap()),
            None => None,
        };
        let probes = probe_listener.as_ref().map(|probes| format!("http://{}", probes.local_addr().unwrap()));
        let running =
            tokio::spawn(async move { app.run_probed(Some((listener, http, service)), probe_listener, &ends).await });
        let probes = probes.unwrap_or_default();
        TestService { base, client: reqwest::Client::new(), engine, shutdown, folder, probes, running }
    }

    /// Starts another process on the same folder that runs jobs and serves no HTTP.
    pub(crate) async fn worker(&self, more: &[&str]) -> WorkerProcess {
        let data_dir = self.folder.path().to_str().unwrap().to_owned();
        let Arguments { service, .. } = clap::Parser::parse_from(["test", "--data-dir", &data_dir].iter().chain(more));
        let (shutdown, engine) = (Shutdown::default(), Arc::new(ScriptedEngine::default()));
        let app = App::open(&service, Arc::clone(&engine) as Arc<dyn Engine>, &shutdown, false).await.unwrap();
        let ends = shutdown.clone();
        let running = tokio::spawn(async move { app.run(None, &ends).await });
        WorkerProcess { shutdown, engine, running }
    }

    /// Shuts down as after a signal and returns the folder.
    pub(crate) async fn end(self) -> Arc<tempfile::TempDir> {
        self.shutdown.stop.cancel();
        self.shutdown.give_back.cancel();
        self.running.await.unwrap();
        self.folder
    }

    pub(crate) async fn get(&self, path: &str) -> reqwest::Response {
        self.client.get(format!("{}{path}", self.base)).send().await.unwrap()
    }

    pub(crate) async fn json(&self, path: &str) -> Value {
        self.get(path).await.json().await.unwrap()
    }

    pub(crate) async fn post(&self, path: &str) -> reqwest::Response {
        self.client.post(format!("{}{path}", self.base)).send().await.unwrap()
    }

    pub(crate) async fn delete(&self, path: &str) -> reqwest::Response {
        self.client.delete(format!("{}{path}", self.base)).send().await.unwrap()
    }

    pub(crate) async fn send(&self, form: Form) -> reqwest::Response {
        self.client.post(format!("{}/v1/jobs", self.base)).multipart(form).send().await.unwrap()
    }

    /// Submits a job and returns its id.
    pub(crate) async fn submit(&self, parameters: Value) -> String {
        let response = self.send(form("source", "target", &parameters)).await;
        assert_eq!(response.status(), 202, "{}", response.text().await.unwrap());
        response.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
    }

    /// The job once `done` holds.
    pub(crate) async fn until(&self, id: &str, done: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let job = self.json(&format!("/v1/jobs/{id}")).await;
            if done(&job) {
                return job;
            }
            assert!(began.elapsed() < PATIENCE, "still {job}");
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }

    pub(crate) async fn until_final(&self, id: &str) -> Value {
        self.until(id, |job| !["queued", "running"].contains(&job["state"].as_str().unwrap())).await
    }

    /// Trace points of a job, at most 10,000.
    pub(crate) async fn n_traced(&self, id: &str) -> usize {
        self.json(&format!("/v1/jobs/{id}/trace?limit=10000")).await["points"].as_array().unwrap().len()
    }

    pub(crate) async fn until_running(&self, id: &str) -> Value {
        self.until(id, |job| job["state"] == "running").await
    }
}

/// The form of a submission.
pub(crate) fn form(source: &str, target: &str, parameters: &Value) -> Form {
    let file = |content: &str, name: &str| Part::bytes(content.as_bytes().to_vec()).file_name(name.to_owned());
    Form::new()
        .part("source", file(source, "Doe^Jane.nii.gz"))
        .part("target", file(target, "target.ply"))
        .text("parameters", parameters.to_string())
}

/// Asserts that an answer is a problem document of this status and type, and returns it.
pub(crate) async fn problem(response: reqwest::Response, status: u16, slug: &str) -> Value {
    let got = response.status().as_u16();
    let media_type = response.headers().get("content-type").cloned();
    let id = response.headers().get("x-request-id").unwrap().to_str().unwrap().to_owned();
    let text = response.text().await.unwrap();
    assert_eq!(got, status, "{text}");
    assert_eq!(media_type.unwrap(), "application/problem+json");
    let body: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(body["type"], format!("/problems/{slug}"), "{text}");
    assert_eq!(body["status"], status);
    assert!(body["title"].is_string());
    assert_eq!(body["request_id"], id);
    body
}
