//! Metrics: every label has a closed set of values, whatever clients send.

use super::cli::homolog;
use super::jobs_support::{TestService, form};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};

/// Labels of a line in the text format of Prometheus, and the name of its metric.
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
    // The series in which such requests are counted, each once.
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
    let words = |words: &str| words.split(' ').map(str::to_owned).collect::<BTreeSet<_>>();
    let closed = BTreeMap::from([
        ("method", words("GET HEAD POST PUT PATCH DELETE OPTIONS other")),
        ("route", routes),
        ("state", words("queued running")),
        ("end", ["succeeded", "failed", "cancelled", "given back", "lease lost"].map(str::to_owned).into()),
        ("lookup", words("hit miss")),
        ("row", ["written", "lost", "left out"].map(str::to_owned).into()),
    ]);
    for (name, labels) in &after {
        for (label, value) in labels {
            match label.as_str() {
                "le" | "quantile" => {}
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
