//! API keys: made and revoked by the command line, asked for by the service.

use super::cli::homolog;
use super::jobs_support::{TestService, form, problem};
use serde_json::{Value, json};
use std::path::Path;

fn keys(data_dir: &Path, arguments: &[&str]) -> String {
    let mut command = homolog();
    let done = command.arg("keys").args(arguments).arg("--data-dir").arg(data_dir).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap().trim().to_owned()
}

#[tokio::test]
async fn keys_open_what_their_scopes_say_and_only_their_tenant() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let folder = service.folder.path().to_owned();
    let make = |tenant: &str, scope: &str| keys(&folder, &["create", "--tenant", tenant, "--scope", scope]);
    let (reader, submitter) = (make("clinic-a", "read"), make("clinic-a", "submit,read"));
    let other = make("clinic-b", "read,submit,admin");
    let ask = |method: &str, path: &str, key: &str| {
        let method = reqwest::Method::from_bytes(method.as_bytes()).unwrap();
        service.client.request(method, format!("{}{path}", service.base)).bearer_auth(key)
    };
    let without = service.get("/v1/jobs").await;
    assert_eq!(without.headers()["www-authenticate"], "Bearer");
    problem(without, 401, "unauthenticated").await;
    for wrong in ["", "x", &reader[..reader.len() - 1], &format!("{}0", &reader[..reader.len() - 1])] {
        if wrong != reader {
            problem(ask("GET", "/v1/jobs", wrong).send().await.unwrap(), 401, "unauthenticated").await;
        }
    }
    let submit = |key: &str| ask("POST", "/v1/jobs", key).multipart(form("a", "b", &json!({}))).send();
    problem(submit(&reader).await.unwrap(), 403, "scope-missing").await;
    let job: Value = submit(&submitter).await.unwrap().json().await.unwrap();
    let path = format!("/v1/jobs/{}", job["id"].as_str().unwrap());
    assert_eq!(ask("GET", &path, &reader).send().await.unwrap().status(), 200);
    problem(ask("GET", &path, &other).send().await.unwrap(), 404, "job-not-found").await;
    problem(ask("GET", "/v1/webhooks", &submitter).send().await.unwrap(), 403, "scope-missing").await;
    assert_eq!(ask("GET", "/v1/webhooks", &other).send().await.unwrap().status(), 200);
    for open in ["/healthz", "/readyz", "/openapi.json", "/docs/", "/v1/methods"] {
        assert_eq!(service.get(open).await.status(), 200, "{open}");
    }

    let listed = keys(&folder, &["list"]);
    let secret = reader.rsplit('_').next().unwrap();
    assert!(listed.contains("clinic-a") && !listed.contains(secret), "{listed}");
    let stored = std::fs::read(folder.join("homolog.sqlite-wal")).unwrap();
    let stored = [stored, std::fs::read(folder.join("homolog.sqlite")).unwrap()].concat();
    assert!(!stored.windows(secret.len()).any(|w| w == secret.as_bytes()), "only its hash is stored");
    let id = reader.split('_').nth(1).unwrap();
    assert!(keys(&folder, &["revoke", id]).contains("is revoked"));
    problem(ask("GET", &path, &reader).send().await.unwrap(), 401, "unauthenticated").await;
    service.end().await;
}

#[test]
fn wrong_arguments_are_named() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, said) in [
        (["create", "--tenant", "A b"], "--tenant"),
        (["create", "--scope", "write"], "--scope"),
        (["create", "--expires-days", "0"], "--expires-days"),
    ] {
        let done = homolog().arg("keys").args(arguments).arg("--data-dir").arg(folder.path()).output().unwrap();
        assert_eq!(done.status.code(), Some(2));
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(text.contains(said), "{text}");
    }
}
