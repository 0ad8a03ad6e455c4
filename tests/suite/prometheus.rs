//! `deploy/prometheus` and `deploy/grafana` with the programs that read them: promtool, and a Prometheus that scrapes a
//! service.

use super::jobs_support::TestService;
use crate::patience::PATIENCE;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A program of the package prometheus: unpacked by `scripts/setup`, or installed on the system.
fn program(name: &str) -> PathBuf {
    let unpacked = root().join("target/tools/prometheus/usr/bin").join(name);
    if unpacked.is_file() { unpacked } else { name.into() }
}

fn check(what: &str, done: &Output) {
    let texts = [&done.stdout, &done.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(done.status.success(), "{what}: {}", texts.concat());
}

#[test]
#[ignore = "needs Prometheus"]
fn the_alert_rules_pass_their_tests() {
    for arguments in [["check", "rules", "homolog.rules.yaml"], ["test", "rules", "homolog.rules.test.yaml"]] {
        let mut command = Command::new(program("promtool"));
        check(arguments[0], &command.args(arguments).current_dir(root().join("deploy/prometheus")).output().unwrap());
    }
}

/// A Prometheus that scrapes one service; killed when dropped.
struct Prometheus {
    process: Child,
    base: String,
    _folder: tempfile::TempDir,
}

impl Drop for Prometheus {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Prometheus {
    async fn start(target: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let rules = root().join("deploy/prometheus/homolog.rules.yaml");
        let config = json!({
            "global": {"scrape_interval": "200ms", "scrape_timeout": "200ms", "evaluation_interval": "200ms"},
            "rule_files": [rules],
            "scrape_configs": [{"job_name": "homolog", "static_configs": [{"targets": [target.trim_start_matches("http://")]}]}],
        });
        // JSON is valid YAML.
        std::fs::write(folder.path().join("prometheus.yml"), config.to_string()).unwrap();
        let free = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
        let process = Command::new(program("prometheus"))
            .arg(format!("--config.file={}", folder.path().join("prometheus.yml").display()))
            .arg(format!("--storage.tsdb.path={}", folder.path().join("data").display()))
            .arg(format!("--web.listen-address={free}"))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        Prometheus { process, base: format!("http://{free}"), _folder: folder }
    }

    async fn ask(&self, path: &str, query: &[(&str, &str)]) -> Option<Value> {
        let url = reqwest::Url::parse_with_params(&format!("{}/api/v1/{path}", self.base), query).unwrap();
        reqwest::get(url).await.ok()?.json().await.ok()
    }

    /// The result of a query.
    async fn query(&self, expression: &str) -> Vec<Value> {
        let answer = self.ask("query", &[("query", expression)]).await.unwrap();
        assert_eq!(answer["status"], "success", "{expression}: {answer}");
        answer["data"]["result"].as_array().unwrap().clone()
    }

    /// Waits until a query has a result.
    async fn until(&self, expression: &str) -> Vec<Value> {
        let began = Instant::now();
        loop {
            if let Some(answer) = self.ask("query", &[("query", expression)]).await
                && answer["data"]["result"].as_array().is_some_and(|result| !result.is_empty())
            {
                return answer["data"]["result"].as_array().unwrap().clone();
            }
            assert!(began.elapsed() < PATIENCE, "nothing for {expression}");
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
    }
}

/// Every `expr` of the dashboard.
fn expressions(value: &Value, into: &mut Vec<String>) {
    match value {
        Value::Object(members) => {
            into.extend(members.get("expr").and_then(Value::as_str).map(str::to_owned));
            members.values().for_each(|value| expressions(value, into));
        }
        Value::Array(items) => items.iter().for_each(|item| expressions(item, into)),
        _ => {}
    }
}

#[tokio::test]
#[ignore = "needs Prometheus"]
async fn a_prometheus_collects_evaluates_the_rules_and_answers_the_dashboard() {
    let service = TestService::start(&["--workers", "1"]).await;
    let prometheus = Prometheus::start(&service.base).await;
    prometheus.until("up{job=\"homolog\"} == 1").await;
    let id = service.submit(json!({"points": 3})).await;
    service.until_final(&id).await;
    service.submit(json!({"points": 500, "step_ms": 20})).await;
    let waiting = service.submit(json!({"seed": 3})).await;
    prometheus.until("homolog_jobs_finished_total{end=\"succeeded\"} == 1").await;
    prometheus.until("homolog_jobs{state=\"queued\"} == 1").await;

    // The page of metrics is valid, with types and help texts.
    let page = service.get("/metrics").await.text().await.unwrap();
    let described: BTreeSet<_> =
        page.lines().filter_map(|line| line.strip_prefix("# HELP ")?.split(' ').next()).collect();
    let known = prometheus.ask("metadata", &[]).await.unwrap();
    for name in described {
        let metadata = &known["data"][name][0];
        assert!(
            ["counter", "gauge", "histogram"].contains(&metadata["type"].as_str().unwrap_or_default()),
            "{name}: {metadata}"
        );
    }
    let mut lint = Command::new(program("promtool"));
    let mut lint = lint
        .args(["check", "metrics"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::io::Write::write_all(&mut lint.stdin.take().unwrap(), page.as_bytes()).unwrap();
    let lint = lint.wait_with_output().unwrap();
    // Code 3 is advice on names; process_* are not ours.
    let advice = [&lint.stdout, &lint.stderr].map(|text| String::from_utf8_lossy(text).into_owned()).concat();
    assert!(
        !advice.contains("error while linting") && !advice.lines().any(|line| line.starts_with("homolog_")),
        "{advice}"
    );

    // Rules are evaluated without errors, and no alert fires for a working service.
    let began = Instant::now();
    let rules = loop {
        let rules = prometheus.ask("rules", &[]).await.unwrap();
        let rules = rules["data"]["groups"][0]["rules"].as_array().unwrap().clone();
        if rules.iter().all(|rule| rule["health"] != "unknown") {
            break rules;
        }
        assert!(began.elapsed() < PATIENCE, "{rules:?}");
        tokio::time::sleep(Duration::from_millis(100)).await;
    };
    assert!(rules.len() > 5);
    for rule in &rules {
        assert!(rule["health"] == "ok" && rule["state"] == "inactive", "{rule}");
    }
    // Every panel of the dashboard has a valid query; the ones on events that have happened have data.
    let dashboard = std::fs::read_to_string(root().join("deploy/grafana/homolog.json")).unwrap();
    let mut all = Vec::new();
    expressions(&serde_json::from_str(&dashboard).unwrap(), &mut all);
    assert!(all.len() > 10);
    for expression in &all {
        let expression = expression.replace("$job", ".*");
        // Events that have not happened: no problem, no webhook. A rate needs two scrapes after the first event.
        if expression.contains("problems") || expression.contains("webhook") {
            prometheus.query(&expression).await;
        } else {
            prometheus.until(&expression).await;
        }
    }

    service.post(&format!("/v1/jobs/{waiting}/cancel")).await;
    service.end().await;
    prometheus.until("up{job=\"homolog\"} == 0").await;
    prometheus.until("ALERTS{alertname=\"HomologDown\",alertstate=\"pending\"}").await;
}
