//! OpenTelemetry spans, as a collector on loopback receives them from the program: one trace from the request to the
//! phases of the job in another process, without any patient data.

use super::cli::homolog;
use crate::patience::PATIENCE;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::routing::post;
use bytes::Bytes;
use opentelemetry_proto::tonic::collector::trace::v1::ExportTraceServiceRequest;
use opentelemetry_proto::tonic::common::v1::any_value::Value as Attribute;
use opentelemetry_proto::tonic::trace::v1::Span;
use prost::Message as _;
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A collector, and a receiver of webhooks.
#[derive(Clone, Default)]
struct Collector {
    bodies: Arc<Mutex<Vec<Bytes>>>,
    hooks: Arc<Mutex<Vec<HeaderMap>>>,
}

impl Collector {
    async fn start() -> (Self, String) {
        let collector = Collector::default();
        let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
        let base = format!("http://{}", listener.local_addr().unwrap());
        let traces = async |State(collector): State<Collector>, headers: HeaderMap, body: Bytes| {
            assert_eq!(headers["content-type"], "application/x-protobuf");
            collector.bodies.lock().unwrap().push(body);
        };
        let hook = async |State(collector): State<Collector>, headers: HeaderMap| {
            collector.hooks.lock().unwrap().push(headers);
        };
        let made = collector.clone();
        let router = axum::Router::new().route("/otlp/v1/traces", post(traces)).route("/hook", post(hook));
        tokio::spawn(async move { axum::serve(listener, router.with_state(made)).await });
        (collector, base)
    }

    fn requests(&self) -> Vec<ExportTraceServiceRequest> {
        let bodies = self.bodies.lock().unwrap();
        bodies.iter().map(|body| ExportTraceServiceRequest::decode(body.clone()).unwrap()).collect()
    }

    fn spans(&self) -> Vec<Span> {
        let resources = self.requests().into_iter().flat_map(|request| request.resource_spans);
        resources.flat_map(|resource| resource.scope_spans).flat_map(|scope| scope.spans).collect()
    }
}

/// A process of the program; killed when dropped.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Process {
    fn start(role: &str, data_dir: &Path, more: &[&str]) -> (Self, String) {
        let mut command = homolog();
        command.args([role, "--log", "warn", "--poll-ms", "50", "--data-dir"]).arg(data_dir).args(more);
        let mut process = Process(command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap());
        let mut line = String::new();
        BufReader::new(process.0.stdout.take().unwrap()).read_line(&mut line).unwrap();
        (process, line.split_whitespace().last().unwrap_or_default().to_owned())
    }

    /// Sends SIGTERM; returns the time until the process has ended, and its log.
    fn terminate(mut self) -> (Duration, String) {
        let began = Instant::now();
        assert!(Command::new("kill").arg(self.0.id().to_string()).status().unwrap().success());
        assert!(self.0.wait().unwrap().success());
        (began.elapsed(), std::io::read_to_string(self.0.stderr.take().unwrap()).unwrap())
    }
}

/// A pair of small surfaces.
fn pair(folder: &Path) -> [Vec<u8>; 2] {
    let arguments = ["phantom", "--kind", "surface", "--edge", "3", "--out"];
    assert!(homolog().args(arguments).arg(folder).output().unwrap().status.success());
    ["source.ply", "target.ply"].map(|name| std::fs::read(folder.join(name)).unwrap())
}

async fn submit(base: &str, [source, target]: &[Vec<u8>; 2], traceparent: &str) -> String {
    let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("Doe^Jane.ply");
    let form = Form::new().part("source", file(source)).part("target", file(target));
    let form = form.text("tags", json!({"ward": "ward-7"}).to_string()).text("external_ref", "MRN-4711");
    let request = reqwest::Client::new().post(format!("{base}/v1/jobs")).multipart(form);
    let answer = request.header("traceparent", traceparent).header("x-request-id", "Doe-Jane").send().await.unwrap();
    assert_eq!(answer.status(), 202);
    answer.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
}

async fn until_succeeded(base: &str, id: &str) {
    let began = Instant::now();
    loop {
        let job: Value = reqwest::get(format!("{base}/v1/jobs/{id}?wait=5")).await.unwrap().json().await.unwrap();
        match job["state"].as_str().unwrap() {
            "succeeded" => return,
            "queued" | "running" => assert!(began.elapsed() < PATIENCE, "{job}"),
            _ => panic!("{job}"),
        }
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn attribute(span: &Span, key: &str) -> Option<String> {
    let found = span.attributes.iter().find(|attribute| attribute.key == key)?;
    Some(match found.value.as_ref()?.value.as_ref()? {
        Attribute::StringValue(text) => text.clone(),
        Attribute::IntValue(number) => number.to_string(),
        other => panic!("{key}: {other:?}"),
    })
}

#[tokio::test(flavor = "multi_thread")]
async fn one_trace_leads_from_the_request_to_the_phases_of_the_job_and_names_no_patient() {
    const TRACE: &str = "0af7651916cd43dd8448eb211c80319c";
    homolog::tls::prepare();
    let (collector, base) = Collector::start().await;
    let folder = tempfile::tempdir().unwrap();
    let (pair, data_dir) = (pair(&folder.path().join("pair")), folder.path().join("data"));
    let endpoint = format!("{base}/otlp");
    let otlp = ["--otlp-endpoint", &endpoint];
    let more = [&otlp[..], &["--listen", "127.0.0.1:0", "--workers", "0", "--allow-private-webhooks"]].concat();
    let (serve, service) = Process::start("serve", &data_dir, &more);
    let client = reqwest::Client::new();
    let webhook = json!({"url": format!("{base}/hook"), "states": ["succeeded"]});
    let webhook = client.post(format!("{service}/v1/webhooks")).json(&webhook).send().await.unwrap();
    assert_eq!(webhook.status(), 201);
    let id = submit(&service, &pair, &format!("00-{TRACE}-b7ad6b7169203331-01")).await;
    let (worker, _) = Process::start("worker", &data_dir, &otlp);
    until_succeeded(&service, &id).await;
    for path in ["/v1/jobs?external_ref=MRN-4711&tag=ward:ward-7", "/v1/jobs/Doe%5EJane", "/Doe", "/healthz"] {
        client.get(format!("{service}{path}")).send().await.unwrap();
    }
    // A client that wants no spans gets none.
    submit(&service, &pair, "00-11111111111111111111111111111111-b7ad6b7169203331-00").await;
    let began = Instant::now();
    while collector.hooks.lock().unwrap().len() < 2 {
        assert!(began.elapsed() < PATIENCE);
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    // Unsent spans are sent at the end.
    tokio::time::sleep(Duration::from_millis(500)).await;
    worker.terminate();
    serve.terminate();

    let all = collector.spans();
    let of_trace: Vec<_> = all.iter().filter(|span| hex(&span.trace_id) == TRACE).collect();
    let found = |name: &str| {
        let mut with_name = of_trace.iter().filter(|span| span.name == name);
        let span = with_name.next().unwrap_or_else(|| panic!("no span {name}"));
        assert!(with_name.next().is_none(), "{name} twice");
        *span
    };
    let request = found("POST /v1/jobs");
    assert_eq!(hex(&request.parent_span_id), "b7ad6b7169203331", "a child of the client's");
    assert_eq!(attribute(request, "http.response.status_code").as_deref(), Some("202"));
    let run = found("run job");
    for name in ["wait in queue", "run job", "deliver webhook"] {
        assert_eq!(found(name).parent_span_id, request.span_id, "{name}");
    }
    assert_eq!(attribute(run, "homolog.job_id").as_deref(), Some(id.as_str()));
    assert_eq!(attribute(run, "homolog.end").as_deref(), Some("succeeded"));
    assert_eq!(attribute(run, "homolog.attempt").as_deref(), Some("1"));
    assert!(request.start_time_unix_nano <= run.start_time_unix_nano);
    let mut parts: Vec<_> = of_trace.iter().filter(|span| span.parent_span_id == run.span_id).collect();
    parts.sort_by_key(|span| span.start_time_unix_nano);
    let names: Vec<_> = parts.iter().map(|span| span.name.as_str()).collect();
    assert_eq!((names.first(), names.last()), (Some(&"read inputs"), Some(&"store result")), "{names:?}");
    for phase in ["reading", "features", "displacement", "reporting"] {
        assert!(names.contains(&phase), "{phase}: {names:?}");
    }
    for two in parts.windows(2) {
        assert!(two[0].end_time_unix_nano <= two[1].start_time_unix_nano, "{} and {}", two[0].name, two[1].name);
    }
    let (begin, end) = (run.start_time_unix_nano, run.end_time_unix_nano);
    assert!(parts.iter().all(|part| part.start_time_unix_nano >= begin && part.end_time_unix_nano <= end));
    // The hooks are in the order of their arrival, in which the second job may be the first.
    let hooks = collector.hooks.lock().unwrap().clone();
    let of_trace: Vec<_> =
        hooks.iter().map(|hook| hook["traceparent"].to_str().unwrap()).filter(|hook| hook.contains(TRACE)).collect();
    let delivery = format!("00-{TRACE}-{}-01", hex(&found("deliver webhook").span_id));
    assert_eq!(of_trace, [delivery], "the receiver goes on");
    assert!(all.iter().all(|span| hex(&span.trace_id) != "1".repeat(32)), "not sampled");

    // No text that a client has chosen.
    let bodies = collector.bodies.lock().unwrap().clone();
    for body in &bodies {
        let text = String::from_utf8_lossy(body);
        for word in ["Doe", "Jane", "MRN", "4711", "ward", ".ply", "blake3", "/hook", &service] {
            assert!(!text.contains(word), "{word} in {text:?}");
        }
    }
    let names: BTreeSet<_> = all.iter().map(|span| span.name.as_str()).collect();
    for name in ["GET /v1/jobs", "GET /v1/jobs/{id}", "GET none"] {
        assert!(names.contains(name), "{name}: {names:?}");
    }
    assert!(!names.contains("GET /healthz"), "supervisors ask often");
    for request in collector.requests() {
        let resource = request.resource_spans[0].resource.clone().unwrap();
        let name = resource.attributes.iter().find(|attribute| attribute.key == "service.name").unwrap();
        assert_eq!(name.value.clone().unwrap().value.unwrap(), Attribute::StringValue("homolog".to_owned()));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_collector_that_does_not_answer_delays_nothing_and_is_logged_once() {
    homolog::tls::prepare();
    let folder = tempfile::tempdir().unwrap();
    let (pair, data_dir) = (pair(&folder.path().join("pair")), folder.path().join("data"));
    // A collector that accepts connections and never answers.
    let collector = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let endpoint = format!("http://{}", collector.local_addr().unwrap());
    let (serve, service) =
        Process::start("serve", &data_dir, &["--listen", "127.0.0.1:0", "--otlp-endpoint", &endpoint]);
    let id = submit(&service, &pair, "").await;
    until_succeeded(&service, &id).await;
    tokio::time::sleep(Duration::from_secs(11)).await;
    let log = serve.terminate().1;
    assert_eq!(log.matches("spans cannot be sent").count(), 1, "{log}");
    let output = homolog().args(["serve", "--otlp-endpoint", "collector:4318"]).output().unwrap();
    assert!(!output.status.success() && String::from_utf8_lossy(&output.stderr).contains("address of a collector"));
}
