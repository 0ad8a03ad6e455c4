//! The dashboard: in a real browser; the built-in page against its sources; and the API that it uses.

use super::jobs_support::{TestService, problem};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("dashboard")
}

fn text(done: &Output) -> String {
    [&done.stdout, &done.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat()
}

mod chromium {
    use super::*;

    /// The tests are in dashboard/tests/run.mjs, which prints a line for each.
    #[test]
    #[ignore = "needs Chromium and node"]
    fn the_dashboard_does_what_it_promises_in_a_browser() {
        let mut command = Command::new("node");
        command.arg("tests/run.mjs").current_dir(folder()).env("DASHBOARD_BINARY", env!("CARGO_BIN_EXE_homolog"));
        let done = command.output().unwrap();
        let said = text(&done);
        println!("{said}");
        assert!(done.status.success(), "{said}");
        assert!(said.matches("\nok ").count() + usize::from(said.starts_with("ok ")) >= 10, "{said}");
    }
}

mod node {
    use super::*;
    use std::collections::BTreeMap;
    use std::fs;

    fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
        let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
        entries.map(|e| (e.file_name().to_string_lossy().into_owned(), fs::read(e.path()).unwrap())).collect()
    }

    #[test]
    #[ignore = "needs node and the packages of the dashboard"]
    fn the_page_that_is_built_in_is_what_its_sources_build() {
        let checked = Command::new("node_modules/.bin/tsc").arg("--noEmit").current_dir(folder()).output().unwrap();
        assert!(checked.status.success(), "{}", text(&checked));
        let out = tempfile::tempdir().unwrap();
        let built = Command::new("node").arg("build.mjs").arg(out.path()).current_dir(folder()).output().unwrap();
        assert!(built.status.success(), "{}", text(&built));
        let (committed, built) = (files(&folder().join("dist")), files(out.path()));
        assert_eq!(committed.keys().collect::<Vec<_>>(), built.keys().collect::<Vec<_>>(), "run make dashboard");
        for (name, bytes) in &committed {
            assert!(built[name] == *bytes, "{name} differs: run make dashboard");
        }
    }
}

#[tokio::test]
async fn the_page_needs_no_key_and_every_answer_of_the_api_does() {
    let service = TestService::start(&["--auth", "keys"]).await;
    let page = service.get("/").await;
    assert_eq!(page.status(), 200);
    assert!(page.headers()["content-security-policy"].to_str().unwrap().starts_with("default-src 'none'"));
    let text = page.text().await.unwrap();
    let script = text.split("src=\"").nth(1).unwrap().split('"').next().unwrap();
    let script = service.get(&format!("/{script}")).await;
    assert_eq!(script.status(), 200);
    assert!(script.headers()["cache-control"].to_str().unwrap().contains("immutable"));
    problem(service.get("/assets/none.js").await, 404, "route-not-found").await;
    problem(service.get("/v1/jobs").await, 401, "unauthenticated").await;
    service.end().await;
}

#[tokio::test]
async fn the_built_in_phantoms_are_served_as_files() {
    let service = TestService::start(&[]).await;
    for side in ["source", "target"] {
        let bytes = service.get(&format!("/phantoms/{side}.nii.gz")).await.bytes().await.unwrap();
        assert_eq!(bytes[..2], [0x1f, 0x8b], "gzip");
    }
    problem(service.get("/phantoms/index.html").await, 404, "route-not-found").await;
    service.end().await;
}

#[tokio::test]
async fn another_host_is_refused_the_page_too() {
    let service = TestService::start(&[]).await;
    let request = service.client.get(format!("{}/", service.base)).header("host", "evil.example");
    problem(request.send().await.unwrap(), 403, "host-not-allowed").await;
    service.end().await;
}

#[tokio::test]
async fn an_upload_can_be_looked_at_before_it_is_matched() {
    let service = TestService::start(&[]).await;
    let upload = async |content: &str| -> Value {
        let sent = service.client.post(format!("{}/v1/meshes", service.base)).body(content.to_owned());
        sent.send().await.unwrap().json().await.unwrap()
    };
    let mesh = upload("mesh").await;
    let path = format!("/v1/meshes/{}/surface", mesh["id"].as_str().unwrap());
    let surface = service.get(&path).await;
    assert_eq!(surface.headers()["content-type"], "model/ply");
    let etag = surface.headers()["etag"].clone();
    assert_eq!(surface.text().await.unwrap(), "surface of mesh");
    let again = service.client.get(format!("{}{path}", service.base)).header("if-none-match", etag);
    assert_eq!(again.send().await.unwrap().status(), 304);
    // A refused upload has its surface, and the location of its fault.
    let bad = upload("bad").await;
    assert_eq!((&bad["suitable"], &bad["problem"]["place_mm"]), (&json!(false), &json!([1.0, 2.0, 3.0])));
    assert_eq!(service.get(&format!("/v1/meshes/{}/surface", bad["id"].as_str().unwrap())).await.status(), 200);
    let refused = service.send(super::jobs_support::form("bad", "target", &json!({}))).await;
    let refused = problem(refused, 422, "unsuitable-surface").await;
    assert_eq!(refused["place_mm"], json!([1.0, 2.0, 3.0]));
    problem(service.get("/v1/meshes/none/surface").await, 404, "mesh-not-found").await;
    service.end().await;
}

#[tokio::test]
async fn a_priority_can_be_changed_until_the_job_has_ended() {
    let service = TestService::start(&["--workers", "1"]).await;
    let running = service.submit(json!({"points": 100_000, "step_ms": 20})).await;
    let job = service.until_running(&running).await;
    assert!(job["worker"].is_string(), "{job}");
    let [first, second] = [service.submit(json!({"seed": 1})).await, service.submit(json!({"seed": 2})).await];
    let change = async |id: &str, body: &str| {
        let url = format!("{}/v1/jobs/{id}", service.base);
        service.client.patch(url).header("content-type", "application/json").body(body.to_owned()).send().await.unwrap()
    };
    let changed: Value = change(&second, r#"{"priority": 50}"#).await.json().await.unwrap();
    assert_eq!((&changed["priority"], &changed["id"]), (&json!(50), &json!(second)));
    let position = async |id: &str| service.json(&format!("/v1/jobs/{id}")).await["queue_position"].clone();
    assert_eq!((position(&second).await, position(&first).await), (json!(1), json!(2)));
    problem(change(&second, r#"{"priority": 101}"#).await, 422, "invalid-request").await;
    problem(change(&second, r#"{"priority": 1, "state": "failed"}"#).await, 422, "invalid-request").await;
    assert!(service.post(&format!("/v1/jobs/{running}/cancel")).await.status().is_success());
    let ended = service.until_final(&running).await;
    assert!(ended["worker"].is_null(), "{ended}");
    problem(change(&running, r#"{"priority": 1}"#).await, 409, "job-finished").await;
    service.end().await;
}
