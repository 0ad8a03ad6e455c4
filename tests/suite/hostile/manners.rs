//! Small promises of the contract, each a regression test.

use crate::jobs_support::{TestService, form, problem};
use futures_util::StreamExt;
use reqwest::multipart::Form;
use serde_json::{Value, json};
use std::time::Duration;

#[tokio::test]
async fn faults_in_json_point_to_their_field() {
    let service = TestService::start(&["--workers", "0"]).await;
    let mesh = json!({"content_base64": "bWVzaA=="});
    for (member, value, pointer) in [
        ("priority", json!("high"), "/priority"),
        ("tags", json!([]), "/tags"),
        ("tags", json!({"study": 1}), "/tags/study"),
        ("deadline_at", json!("tomorrow"), "/deadline_at"),
        ("max_run_s", json!(-1), "/max_run_s"),
        ("use_cache", json!("no"), "/use_cache"),
        ("external_ref", json!(7), "/external_ref"),
        ("color", json!(1), "/color"),
    ] {
        let mut body = json!({"source": mesh, "target": mesh});
        body[member] = value;
        let answer = service.client.post(format!("{}/v1/jobs", service.base)).json(&body).send().await.unwrap();
        let refused = problem(answer, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], pointer, "{refused}");
    }
    service.end().await;
}

#[tokio::test]
async fn a_member_that_is_given_twice_is_refused() {
    let service = TestService::start(&["--workers", "0"]).await;
    let inputs = r#""source":{"content_base64":"bWVzaA=="},"target":{"content_base64":"bWVzaA=="}"#;
    for more in [
        r#""priority":1,"priority":2"#,
        r#""tags":{"a":"1","a":"2"}"#,
        r#""parameters":{"seed":1,"seed":2}"#,
        r#""parameters":{},"parameters":{}"#,
    ] {
        let request =
            service.client.post(format!("{}/v1/jobs", service.base)).header("content-type", "application/json");
        let answer = request.body(format!("{{{inputs},{more}}}")).send().await.unwrap();
        problem(answer, 422, "invalid-request").await;
    }
    let twice = form("a", "b", &json!({})).text("tags", r#"{"a":"1","a":"2"}"#);
    problem(service.send(twice).await, 422, "invalid-request").await;
    assert_eq!(service.json("/v1/jobs").await["jobs"], json!([]));
    service.end().await;
}

#[tokio::test]
async fn the_list_of_faults_of_a_form_is_bounded() {
    let service = TestService::start(&["--workers", "0"]).await;
    for name in ["priority", "source", "color"] {
        let form = (0..1000).fold(Form::new(), |form, _| form.text(name, "1"));
        let refused = problem(service.send(form).await, 422, "invalid-request").await;
        assert!(refused["errors"].as_array().unwrap().len() <= 20, "{name}: {}", refused["errors"]);
    }
    let query: String = (0..1000).map(|i| format!("x{i}=1&")).collect();
    let refused = problem(service.get(&format!("/v1/jobs?{query}")).await, 400, "invalid-query").await;
    assert!(refused["errors"].as_array().unwrap().len() <= 16);
    service.end().await;
}

#[tokio::test]
async fn tags_with_a_colon_can_be_filtered() {
    let service = TestService::start(&["--workers", "0"]).await;
    service.send(form("a", "b", &json!({})).text("tags", r#"{"dcm:study":"1.2:3"}"#)).await;
    service.send(form("a", "b", &json!({"seed": 1})).text("tags", r#"{"dcm":"study:1.2:3"}"#)).await;
    let found = service.json(r"/v1/jobs?tag=dcm\:study:1.2:3").await;
    assert_eq!(found["jobs"].as_array().unwrap().len(), 1);
    assert_eq!(found["jobs"][0]["tags"], json!({"dcm:study": "1.2:3"}));
    service.end().await;
}

/// The events of a stream: name and id.
async fn events(response: reqwest::Response) -> Vec<(String, String)> {
    let mut text = String::new();
    let mut stream = response.bytes_stream();
    while let Some(Ok(part)) = stream.next().await {
        text.push_str(std::str::from_utf8(&part).unwrap());
    }
    let field = |block: &str, name: &str| {
        block.lines().find_map(|line| line.strip_prefix(name)).map(|value| value.trim().to_owned())
    };
    let event = |block: &str| Some((field(block, "event:")?, field(block, "id:").unwrap_or_default()));
    text.split("\n\n").filter_map(event).collect()
}

#[tokio::test]
async fn every_event_has_an_id_and_nothing_follows_the_last() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 3, "step_ms": 30})).await;
    let url = format!("{}/v1/jobs/{id}/events", service.base);
    let all = tokio::time::timeout(Duration::from_secs(20), events(service.client.get(&url).send().await.unwrap()));
    let all = all.await.unwrap();
    assert!(all.iter().all(|(_, id)| !id.is_empty()), "{all:?}");
    assert_eq!(all.last().unwrap(), &("done".to_owned(), "3-done".to_owned()));
    let again = service.client.get(&url).header("last-event-id", "3-done").send().await.unwrap();
    assert_eq!(again.status(), 204, "an EventSource stops at 204");
    let before = service.client.get(&url).header("last-event-id", "3").send().await.unwrap();
    let rest = tokio::time::timeout(Duration::from_secs(20), events(before)).await.unwrap();
    assert_eq!(rest.iter().map(|(name, _)| name.as_str()).filter(|name| *name == "trace").count(), 0);
    service.end().await;
}

#[tokio::test]
async fn progress_says_what_is_done_in_words() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    let job: Value = service.until(&id, |job| job["progress"]["message"].is_string()).await;
    assert_eq!(job["progress"]["message"], "Minimizing the energy");
    service.end().await;
}

#[tokio::test]
async fn the_feed_of_changes_is_paged_like_the_other_lists() {
    let service = TestService::start(&["--workers", "0"]).await;
    for seed in 0..5 {
        service.submit(json!({"seed": seed})).await;
    }
    let (mut token, mut numbers) = (String::new(), Vec::new());
    loop {
        let page = service.json(&format!("/v1/changes?page_size=2{token}")).await;
        numbers.extend(page["changes"].as_array().unwrap().iter().map(|change| change["seq"].as_u64().unwrap()));
        let Some(next) = page["next_page_token"].as_str() else { break };
        token = format!("&page_token={next}");
    }
    assert_eq!(numbers, [1, 2, 3, 4, 5]);
    problem(service.get("/v1/changes?limit=1&page_size=1").await, 400, "invalid-query").await;
    service.end().await;
}

#[test]
fn settings_that_do_not_exist_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let start = |name: &str, value: &str| {
        let mut command = crate::cli::homolog();
        command.args(["keys", "list", "--data-dir"]).arg(folder.path()).env(name, value);
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, said) = start("HOMOLOG_RETAIN_RESULT_DAYS", "30");
    assert!(code == Some(2) && said.contains("HOMOLOG_RETAIN_RESULT_DAYS is no setting"), "{said}");
    let (code, said) = start("HOMOLOG_ARTIFACTS_URL", "ftp://x");
    assert!(code == Some(2) && said.contains("s3://bucket"), "{said}");
}
