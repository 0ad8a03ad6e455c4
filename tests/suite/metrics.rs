//! Metrics: every label has a closed set of values, whatever clients send.

use super::cli::homolog;
use super::jobs_support::{TestService, form};
use crate::patience::PATIENCE;
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The name of the metric and the labels of a line in the text format of Prometheus.
fn series(line: &str) -> (String, BTreeMap<String, String>) {
    let (name, rest) = line.split_once('{').unwrap_or_else(|| (line.split(' ').next().unwrap(), ""));
    let labels = rest.rsplit_once('}').map_or("", |(labels, _)| labels);
    let pairs = labels.split("\",").filter(|pair| !pair.is_empty()).map(|pair| {
        let (label, value) = pair.split_once("=\"").unwrap();
        (label.to_owned(), value.trim_end_matches('"').to_owned())
    });
    (name.to_owned(), pairs.collect())
}

/// The series in the text.
fn all_series(text: &str) -> BTreeSet<(String, BTreeMap<String, String>)> {
    text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).map(series).collect()
}

/// Requests with a made-up method, path, query, headers, key and host, and one with a wrong method for a real path.
async fn send_made_up(service: &TestService, made_up: &str) {
    let method = reqwest::Method::from_bytes(made_up.to_uppercase().as_bytes()).unwrap();
    for path in
        ["/v1/jobs".to_owned(), format!("/v1/jobs/{made_up}"), format!("/{made_up}"), format!("/docs/{made_up}")]
    {
        for method in [reqwest::Method::GET, method.clone()] {
            let request = service.client.request(method, format!("{}{path}?{made_up}=1", service.base));
            let request = request.bearer_auth(made_up).header("x-request-id", made_up).header("user-agent", made_up);
            let request = request.header("accept", format!("{made_up}/x")).header(format!("x-{made_up}"), made_up);
            request.send().await.unwrap();
        }
    }
}

#[tokio::test]
async fn made_up_requests_create_no_new_series() {
    let service = TestService::start(&["--auth", "keys"]).await;
    let key = async |tenant: &str| {
        let mut command = homolog();
        command.args(["keys", "create", "--tenant", tenant, "--data-dir"]).arg(service.folder.path());
        // Not on this thread: the service that runs on it may hold the database for which the command waits.
        let output = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    let submit = async |tenant: &str| {
        let request = service.client.post(format!("{}/v1/jobs", service.base)).bearer_auth(key(tenant).await);
        let job: serde_json::Value =
            request.multipart(form("a", "b", &json!({}))).send().await.unwrap().json().await.unwrap();
        assert!(job["id"].is_string(), "{job}");
    };
    // Creates the series in which such requests are counted.
    send_made_up(&service, "madeup-0").await;
    submit("tenant-0").await;
    service.get("/metrics").await;
    let before = all_series(&service.get("/metrics").await.text().await.unwrap());
    for number in 1..=5 {
        send_made_up(&service, &format!("madeup-{number}")).await;
        submit(&format!("tenant-{number}")).await;
    }
    let text = service.get("/metrics").await.text().await.unwrap();
    let after = all_series(&text);
    // Only the series on requests; others appear when a job first ends in some way or housekeeping first runs.
    let new: Vec<_> = after.difference(&before).filter(|(_, labels)| labels.contains_key("route")).collect();
    assert!(new.is_empty(), "{new:?}");
    assert!(!text.to_lowercase().contains("madeup") && !text.contains("tenant"), "{text}");
    assert!(text.contains("method=\"other\",route=\"none\""), "{text}");

    // All labels and their values: a new label needs a closed set of values, and a line here.
    let document = service.json("/openapi.json").await;
    let mut routes: BTreeSet<String> = document["paths"].as_object().unwrap().keys().cloned().collect();
    routes.extend(["/docs", "/docs/", "/docs/{*path}", "none"].map(str::to_owned));
    let problems = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("api/problems.md")).unwrap();
    let slugs = problems.split("`/problems/").skip(1).map(|rest| rest.split('`').next().unwrap().to_owned()).collect();
    let words = |words: &str| words.split(' ').map(str::to_owned).collect::<BTreeSet<_>>();
    let closed = BTreeMap::from([
        ("method", words("GET HEAD POST PUT PATCH DELETE OPTIONS other")),
        ("route", routes),
        ("state", words("queued running busy idle")),
        (
            "end",
            ["succeeded", "failed", "cancelled", "given back", "lease lost", "not stored"].map(str::to_owned).into(),
        ),
        ("lookup", words("hit miss")),
        ("reason", words("once rested grown stopped panicked failed memory time killed crashed")),
        ("type", slugs),
        ("outcome", ["delivered", "failed", "given up"].map(str::to_owned).into()),
        ("use", words("busy idle most")),
        ("version", words(env!("CARGO_PKG_VERSION"))),
        ("row", ["written", "lost", "left out"].map(str::to_owned).into()),
    ]);
    for (name, labels) in &after {
        for (label, value) in labels {
            match label.as_str() {
                "le" | "quantile" => {}
                "commit" => assert_eq!(name, "homolog_build_info"),
                "status" => assert!(value.len() == 3 && value.parse::<u16>().is_ok(), "{name} {value}"),
                label => {
                    let known = closed.get(label).unwrap_or_else(|| panic!("{name} has the unknown label {label}"));
                    assert!(known.contains(value), "{name}: {label} is {value}");
                }
            }
        }
    }
    service.end().await;
}

/// The metrics of a service after one use of every feature, with their help texts.
async fn described() -> (BTreeSet<String>, BTreeMap<String, String>) {
    let service = TestService::start(&["--allow-private-webhooks"]).await;
    let receiver = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let webhook = json!({"url": format!("http://{}/", receiver.local_addr().unwrap())});
    drop(receiver); // nobody listens: the attempt fails
    service.client.post(format!("{}/v1/webhooks", service.base)).json(&webhook).send().await.unwrap();
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    let began = std::time::Instant::now();
    let text = loop {
        let text = service.get("/metrics").await.text().await.unwrap();
        if text.contains("homolog_webhook_attempt_seconds") {
            break text;
        }
        assert!(began.elapsed() < PATIENCE, "{text}");
        tokio::time::sleep(std::time::Duration::from_millis(100)).await;
    };
    service.end().await;
    let helps = text.lines().filter_map(|line| line.strip_prefix("# HELP ")?.split_once(' '));
    let helps = helps.map(|(name, help)| (name.to_owned(), help.to_owned())).collect();
    (all_series(&text).into_iter().map(|(name, _)| name).collect(), helps)
}

/// The name of a metric without the suffixes of a histogram's series.
fn family(name: &str) -> &str {
    ["_bucket", "_sum", "_count"].iter().find_map(|end| name.strip_suffix(end)).unwrap_or(name)
}

#[tokio::test]
async fn every_metric_has_a_help_text_and_every_one_that_is_described_exists() {
    let (series, helps) = described().await;
    let families: BTreeSet<&str> = series.iter().map(|name| family(name)).collect();
    let without: Vec<_> = families.iter().filter(|name| !helps.contains_key(**name)).collect();
    assert!(without.is_empty(), "no HELP: {without:?}");
    let missing: Vec<_> = helps.keys().filter(|name| !families.contains(name.as_str())).collect();
    assert!(missing.iter().all(|name| name.starts_with("process_")), "described, but never there: {missing:?}");
    for name in ["process_resident_memory_bytes", "process_open_fds", "process_max_fds", "process_cpu_seconds_total"] {
        assert!(!cfg!(target_os = "linux") || families.contains(name), "{name}");
    }
}

#[tokio::test]
async fn every_metric_of_the_alert_rules_and_the_dashboard_exists() {
    let (_, helps) = described().await;
    let deploy = Path::new(env!("CARGO_MANIFEST_DIR")).join("deploy");
    for file in ["prometheus/homolog.rules.yaml", "prometheus/homolog.rules.test.yaml", "grafana/homolog.json"] {
        let text = std::fs::read_to_string(deploy.join(file)).unwrap();
        let mut named = BTreeSet::new();
        for prefix in ["homolog_", "process_"] {
            for (at, _) in text.match_indices(prefix) {
                let is_tail = text[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
                let end = text[at..].find(|c: char| !(c.is_ascii_lowercase() || c == '_')).unwrap();
                if !is_tail {
                    named.insert(text[at..at + end].to_owned());
                }
            }
        }
        assert!(named.len() >= 5, "{file}: {named:?}");
        let unknown: Vec<_> = named.iter().filter(|name| !helps.contains_key(family(name))).collect();
        assert!(unknown.is_empty(), "{file}: no such metric: {unknown:?}");
    }
    serde_json::from_str::<serde_json::Value>(&std::fs::read_to_string(deploy.join("grafana/homolog.json")).unwrap())
        .unwrap();
}

/// What a metric says of a state.
async fn workers(service: &TestService, state: &str) -> u32 {
    let text = service.get("/metrics").await.text().await.unwrap();
    let line = text.lines().find_map(|line| line.strip_prefix(&format!("homolog_workers{{state=\"{state}\"}} ")));
    line.unwrap_or_else(|| panic!("{text}")).parse().unwrap()
}

#[tokio::test]
async fn idle_and_busy_workers_are_counted_over_processes() {
    let service = TestService::start(&[]).await;
    let until = async |busy: u32, idle: u32| {
        let began = std::time::Instant::now();
        while (workers(&service, "busy").await, workers(&service, "idle").await) != (busy, idle) {
            let found = (workers(&service, "busy").await, workers(&service, "idle").await);
            assert!(began.elapsed() < PATIENCE, "{found:?} instead of {:?}", (busy, idle));
            tokio::time::sleep(std::time::Duration::from_millis(50)).await;
        }
    };
    until(0, 1).await;
    let other = service.worker(&[]).await;
    until(0, 2).await;
    let id = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    until(1, 1).await;
    assert_eq!(service.post(&format!("/v1/jobs/{id}/cancel")).await.status(), 202);
    until(0, 2).await;
    // One that ends is not counted for the rest of its minute; a process that runs no jobs is no worker.
    other.shutdown.stop.cancel();
    other.running.await.unwrap();
    until(0, 1).await;
    let folder = service.end().await;
    let front = TestService::start_in(folder, &["--workers", "0"]).await;
    assert_eq!((workers(&front, "busy").await, workers(&front, "idle").await), (0, 0));
    front.end().await;
}
