//! API keys: created and revoked on the command line, required by the service.

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
async fn keys_grant_their_scopes_within_their_tenant() {
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

/// Exit code, standard output and standard error of `homolog`.
fn run(data_dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let done = homolog().args(arguments).arg("--data-dir").arg(data_dir).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code(), text(done.stdout), text(done.stderr))
}

#[test]
fn a_folder_without_a_service_is_refused_and_left_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in
        [&["keys", "create"][..], &["keys", "list"], &["keys", "revoke", "nosuch"], &["purge"], &["purge", "--dry-run"]]
    {
        for data_dir in [folder.path().to_owned(), folder.path().join("missing")] {
            let (code, stdout, stderr) = run(&data_dir, arguments);
            assert_eq!((code, stdout.as_str()), (Some(2), ""), "{arguments:?}: {stderr}");
            assert!(stderr.contains(data_dir.to_str().unwrap()) && stderr.contains("--data-dir"), "{stderr}");
            assert!(stderr.contains("homolog migrate"), "{stderr}");
            assert_eq!(stderr.contains("--init"), arguments == ["keys", "create"], "{stderr}");
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "{arguments:?} left something");
        }
    }
}

#[test]
fn the_first_key_is_created_before_the_service_starts() {
    let folder = tempfile::tempdir().unwrap();
    let (by_flag, by_migration) = (folder.path().join("a"), folder.path().join("b"));
    let (code, key, stderr) = run(&by_flag, &["keys", "create", "--init"]);
    assert!(code == Some(0) && key.starts_with("hml_"), "{stderr}");
    assert_eq!(run(&by_flag, &["keys", "create", "--init"]).0, Some(0), "again, on the database that there is now");
    assert_eq!(run(&by_flag, &["keys", "list"]).1.lines().count(), 3);

    let (_, said, _) = run(&by_migration, &["migrate"]);
    assert!(said.starts_with("created a database in ") && said.trim_end().ends_with("/b"), "{said}");
    assert_eq!(run(&by_migration, &["migrate"]).1, "the database is up to date\n");
    assert_eq!(run(&by_migration, &["keys", "create"]).0, Some(0));
}

#[test]
fn only_keys_that_exist_are_revoked() {
    let folder = tempfile::tempdir().unwrap();
    let (_, key, _) = run(folder.path(), &["keys", "create", "--init"]);
    let (code, stdout, stderr) = run(folder.path(), &["keys", "revoke", "nosuch"]);
    assert_eq!((code, stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains("no key nosuch") && stderr.contains("keys list"), "{stderr}");
    let (key, secret) = (key.trim(), key.trim().rsplit('_').next().unwrap());
    let (code, stdout, _) = run(folder.path(), &["keys", "revoke", key]);
    assert!(code == Some(0) && stdout.ends_with("is revoked\n") && !stdout.contains(secret), "{stdout}");
    let (code, stdout, _) = run(folder.path(), &["keys", "revoke", key]);
    assert!(code == Some(0) && stdout.ends_with("was revoked before\n"), "{stdout}");
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
