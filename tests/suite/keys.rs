//! API keys: created and revoked on the command line, required by the service.

use super::cli::homolog;
use super::jobs_support::{TestService, form, problem};
use serde_json::{Value, json};
use std::path::Path;

pub(crate) fn keys(data_dir: &Path, arguments: &[&str]) -> String {
    let mut command = homolog();
    let done = command.arg("keys").args(arguments).arg("--data-dir").arg(data_dir).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap().trim().to_owned()
}

#[tokio::test]
async fn where_no_key_is_asked_for_the_answer_says_that_it_was_not_looked_at() {
    let service = TestService::start(&["--workers", "0"]).await;
    let get = service.client.get(format!("{}/v1/jobs", service.base));
    let nonsense = get.try_clone().unwrap().bearer_auth("nonsense").send().await.unwrap();
    assert_eq!(
        (nonsense.status().as_u16(), &nonsense.headers()["homolog-authentication"]),
        (200, &"none".parse().unwrap())
    );
    assert!(!get.send().await.unwrap().headers().contains_key("homolog-authentication"));
    service.end().await;
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let refused = service.client.get(format!("{}/v1/jobs", service.base)).bearer_auth("nonsense").send().await.unwrap();
    assert!(!refused.headers().contains_key("homolog-authentication"));
    problem(refused, 401, "unauthenticated").await;
    service.end().await;
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

#[tokio::test]
async fn admins_manage_the_keys_of_their_tenant_and_roles_allow_what_they_say() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let folder = service.folder.path().to_owned();
    let admin = keys(&folder, &["create", "--tenant", "clinic-a", "--role", "admin"]);
    let other = keys(&folder, &["create", "--tenant", "clinic-b", "--role", "admin"]);
    let ask = |method: &str, path: &str, key: &str| {
        let method = reqwest::Method::from_bytes(method.as_bytes()).unwrap();
        service.client.request(method, format!("{}{path}", service.base)).bearer_auth(key)
    };
    let create = async |key: &str, body: Value| ask("POST", "/v1/keys", key).json(&body).send().await.unwrap();

    let mut made = Vec::new();
    for role in ["reader", "submitter", "admin"] {
        let answer = create(&admin, json!({"role": role, "name": format!("for a {role}"), "expires_days": 30})).await;
        assert_eq!((answer.status().as_u16(), &answer.headers()["cache-control"]), (201, &"no-store".parse().unwrap()));
        let location = answer.headers()["location"].to_str().unwrap().to_owned();
        let document: Value = answer.json().await.unwrap();
        assert_eq!((&document["role"], &document["state"]), (&json!(role), &json!("valid")));
        let read: Value = ask("GET", &location, &admin).send().await.unwrap().json().await.unwrap();
        assert!(read["key"].is_null() && read["id"] == document["id"] && read["expires_at"].is_string(), "{read}");
        made.push((document["key"].as_str().unwrap().to_owned(), location));
    }
    // The rights of each key: read, submit, administer.
    let may = async |key: &str| {
        let read = ask("GET", "/v1/jobs", key).send().await.unwrap().status() == 200;
        let submit = ask("POST", "/v1/jobs", key).multipart(form("a", "b", &json!({}))).send().await.unwrap();
        let administer = ask("GET", "/v1/keys", key).send().await.unwrap();
        (read, submit.status() == 202, administer.status() == 200)
    };
    assert_eq!(may(&made[0].0).await, (true, false, false));
    assert_eq!(may(&made[1].0).await, (true, true, false));
    assert_eq!(may(&made[2].0).await, (true, true, true));
    let refused = problem(create(&made[1].0, json!({"role": "admin"})).await, 403, "scope-missing").await;
    assert!(refused["detail"].as_str().unwrap().contains("role admin"), "{refused}");

    // Lists have pages and no secrets, and show only the key's own tenant.
    let mut ids = Vec::new();
    let mut token = String::new();
    loop {
        let path = format!("/v1/keys?page_size=3&page_token={token}");
        let text = ask("GET", &path, &admin).send().await.unwrap().text().await.unwrap();
        assert!(made.iter().all(|(key, _)| !text.contains(key.rsplit('_').next().unwrap())), "{text}");
        let page: Value = serde_json::from_str(&text).unwrap();
        ids.extend(page["keys"].as_array().unwrap().iter().map(|key| key["id"].as_str().unwrap().to_owned()));
        match page["next_page_token"].as_str() {
            Some(next) => token = next.to_owned(),
            None => break,
        }
    }
    assert_eq!(ids.len(), 4, "{ids:?}");
    let foreign = format!("/v1/keys/{}", other.split('_').nth(1).unwrap());
    for method in ["GET", "DELETE"] {
        problem(ask(method, &foreign, &admin).send().await.unwrap(), 404, "key-not-found").await;
        problem(ask(method, "/v1/keys/nosuch", &admin).send().await.unwrap(), 404, "key-not-found").await;
    }

    // A revoked key is refused at once; its record stays.
    for _ in 0..2 {
        assert_eq!(ask("DELETE", &made[1].1, &admin).send().await.unwrap().status(), 204);
    }
    problem(ask("GET", "/v1/jobs", &made[1].0).send().await.unwrap(), 401, "unauthenticated").await;
    let read: Value = ask("GET", &made[1].1, &admin).send().await.unwrap().json().await.unwrap();
    assert!(read["state"] == "revoked" && read["revoked_at"].is_string(), "{read}");

    for (body, pointer) in [
        (json!({"role": "reader", "name": "n".repeat(101)}), "/name"),
        (json!({"role": "reader", "name": "two\nlines"}), "/name"),
        (json!({"role": "reader", "expires_days": 0}), "/expires_days"),
        (json!({"role": "owner"}), "/role"),
        (json!({}), "/role"),
        (json!({"role": "reader", "tenant": "clinic-b"}), "/tenant"),
    ] {
        let refused = problem(create(&admin, body).await, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], pointer, "{refused}");
    }
    service.end().await;
}

#[tokio::test]
async fn a_tenant_has_a_bounded_number_of_valid_keys() {
    let service = TestService::start(&["--workers", "0"]).await;
    let create = async || {
        let request = service.client.post(format!("{}/v1/keys", service.base));
        request.json(&json!({"role": "reader"})).send().await.unwrap()
    };
    let mut last = String::new();
    for _ in 0..200 {
        let answer = create().await;
        assert_eq!(answer.status(), 201);
        last = answer.headers()["location"].to_str().unwrap().to_owned();
    }
    problem(create().await, 409, "too-many-keys").await;
    assert_eq!(service.delete(&last).await.status(), 204);
    assert_eq!(create().await.status(), 201, "one that was revoked does not count");
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
        (["create", "--role", "owner"], "--role"),
        (["create", "--expires-days", "0"], "--expires-days"),
    ] {
        let done = homolog().arg("keys").args(arguments).arg("--data-dir").arg(folder.path()).output().unwrap();
        assert_eq!(done.status.code(), Some(2));
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(text.contains(said), "{text}");
    }
}
