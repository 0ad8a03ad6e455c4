//! The audit log: every request that changes something or reads a result leaves a row, and verification detects an
//! incomplete log.

use super::cli::homolog;
use super::encryption::command;
use super::faults::on_both;
use super::faults::site::{Backend, Site};
use super::faults::witness::Database;
use super::jobs_support::{TestService, form, problem};
use super::store::{Fixture, on_every_store};
use crate::patience::PATIENCE;
use homolog::jobs::audit::{AuditFault, AuditHead, AuditStore as _, Verifier};
use homolog::jobs::{AuditEvent, AuditRow, Tenant};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::{Duration, Instant};
use tokio::io::AsyncWriteExt as _;

fn event(action: &str) -> AuditEvent {
    AuditEvent {
        tenant: Some(Tenant::default()),
        key_id: None,
        action: action.to_owned(),
        resource: None,
        address: Some("192.0.2.7".to_owned()),
        status: Some(200),
    }
}

async fn verified(f: &Fixture, expected: Option<&AuditHead>) -> Result<AuditHead, AuditFault> {
    let mut verifier = Verifier::default();
    verifier.expect(f.store.audit_head().await.unwrap());
    expected.into_iter().for_each(|head| verifier.expect(head.clone()));
    f.store.list_audit(0, 1000).await.unwrap().iter().try_for_each(|row| verifier.add(row))?;
    verifier.end()
}

async fn rows_of_many_processes_are_one_chain(f: Fixture) {
    assert_eq!(verified(&f, None).await, Ok(AuditHead::start()));
    let writers: Vec<_> = (0..4)
        .map(|_| {
            let location = f.site.location();
            tokio::spawn(async move {
                let store = homolog::store::sql::SqlStore::open(&location).await.unwrap();
                for _ in 0..10 {
                    store.append_audit(&[event("submit_job"), event("get_result")]).await.unwrap();
                }
            })
        })
        .collect();
    for writer in writers {
        writer.await.unwrap();
    }
    let last = verified(&f, None).await.unwrap();
    assert_eq!(last.position, 80);
    let page = f.store.list_audit(78, 10).await.unwrap();
    assert_eq!(page.iter().map(|row| row.position).collect::<Vec<_>>(), [79, 80]);
    assert_eq!((page[1].tenant.as_deref(), page[1].status, &page[1].hash), (Some("default"), Some(200), &last.hash));
}

async fn rows_that_were_changed_removed_or_cut_off_are_found(f: Fixture) {
    let database = f.site.database().await;
    f.store.append_audit(&vec![event("submit_job"); 9]).await.unwrap();
    let noted = verified(&f, None).await.unwrap();
    // The tables themselves refuse changes, so only an owner of the database can tamper with the log on purpose.
    for refused in [
        "UPDATE audit SET tenant = 'other' WHERE position = 4",
        "DELETE FROM audit WHERE position = 9",
        "UPDATE audit_head SET position = 8",
    ] {
        database.try_execute(refused).await;
    }
    assert_eq!(verified(&f, None).await, Ok(noted.clone()));
    for trigger in ["audit_keeps_rows", "audit_keeps_content", "audit_keeps_all", "audit_grows"] {
        let table = if trigger == "audit_grows" { "audit_head" } else { "audit" };
        database.try_execute(&format!("DROP TRIGGER {trigger}")).await;
        database.try_execute(&format!("DROP TRIGGER {trigger} ON {table}")).await;
    }
    let after = async |change: &str| {
        database
            .execute("CREATE TABLE kept AS SELECT * FROM audit; CREATE TABLE kept_head AS SELECT * FROM audit_head;")
            .await;
        database.execute(change).await;
        let found = verified(&f, None).await;
        let with_note = verified(&f, Some(&noted)).await;
        database
            .execute(
                "DELETE FROM audit; INSERT INTO audit SELECT * FROM kept; DROP TABLE kept;
                 DELETE FROM audit_head; INSERT INTO audit_head SELECT * FROM kept_head; DROP TABLE kept_head;",
            )
            .await;
        assert_eq!(verified(&f, None).await, Ok(noted.clone()), "restored");
        (found, with_note)
    };
    let changed = after("UPDATE audit SET tenant = 'other' WHERE position = 4").await;
    assert_eq!(changed.0, Err(AuditFault::Changed(4)));
    let removed = after("DELETE FROM audit WHERE position = 4").await;
    assert_eq!(removed.0, Err(AuditFault::Missing(4)));
    let cut = after("DELETE FROM audit WHERE position > 6").await;
    assert_eq!(cut.0, Err(AuditFault::Truncated(7, 9)));
    // Cut off together with the record of its end: detected only with a noted position and hash.
    let both = "DELETE FROM audit WHERE position > 6;
                UPDATE audit_head SET position = 6, hash = (SELECT hash FROM audit WHERE position = 6)";
    let (unnoticed, noticed) = after(both).await;
    assert_eq!(unnoticed.map(|last| last.position), Ok(6));
    assert_eq!(noticed, Err(AuditFault::Truncated(7, 9)));
}

on_every_store! {
    rows_of_many_processes_are_one_chain,
    rows_that_were_changed_removed_or_cut_off_are_found,
}

/// Runs `homolog audit` and returns exit code, standard output and standard error.
async fn audit(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = homolog();
    command.arg("audit").args(arguments).arg("--data-dir").arg(folder);
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code(), text(done.stdout), text(done.stderr))
}

async fn rows(service: &TestService) -> Vec<AuditRow> {
    let (code, stdout, stderr) = audit(service.folder.path(), &["export"]).await;
    assert_eq!(code, Some(0), "{stderr}");
    stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

async fn key(service: &TestService, tenant: &str, role: &str) -> String {
    let mut command = homolog();
    command.args(["keys", "create", "--tenant", tenant, "--role", role, "--data-dir"]).arg(service.folder.path());
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    assert!(done.status.success(), "{done:?}");
    String::from_utf8(done.stdout).unwrap().trim().to_owned()
}

#[tokio::test]
async fn every_operation_that_changes_something_or_reads_a_result_leaves_a_row() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let key = key(&service, "clinic-a", "admin").await;
    let key_id = key.split('_').nth(1).unwrap();
    let document = service.json("/openapi.json").await;
    let id = uuid::Uuid::now_v7().to_string();
    let mesh = format!("blake3:{}", "0a".repeat(32));
    let mut n_before = rows(&service).await.len();
    let (mut recorded, mut left_alone) = (BTreeSet::new(), BTreeSet::new());
    for (path, item) in document["paths"].as_object().unwrap() {
        for (method, operation) in item.as_object().unwrap() {
            let Some(name) = operation["operationId"].as_str() else { continue };
            let id = match path.split('/').nth(2) {
                Some("meshes") => &mesh,
                Some("keys") => "0123456789ab",
                _ => &id,
            };
            let path = path.replace("{id}", id).replace("{which}", "source");
            let method: reqwest::Method = method.to_uppercase().parse().unwrap();
            let request = service.client.request(method, format!("{}{path}", service.base)).bearer_auth(&key);
            let status = request.send().await.unwrap().status().as_u16();
            let rows = rows(&service).await;
            let new = &rows[n_before..];
            n_before = rows.len();
            let [row] = new else {
                assert!(new.is_empty(), "{name}: {new:?}");
                left_alone.insert((name.to_owned(), operation["tags"][0].as_str().unwrap().to_owned()));
                continue;
            };
            assert_eq!((row.action.as_str(), row.status), (name, Some(status.into())), "{row:?}");
            assert_eq!((row.tenant.as_deref(), row.key_id.as_deref()), (Some("clinic-a"), Some(key_id)));
            assert_eq!(row.address.as_deref(), Some("127.0.0.1"));
            if path.contains(id) {
                let kind = path.split('/').nth(2).unwrap();
                assert_eq!(row.resource, Some(format!("{kind}/{id}")), "{name}");
            }
            recorded.insert(name.to_owned());
        }
    }
    // Every request except GET is recorded, and also every GET of a result or of the content of an upload.
    for (_, item) in document["paths"].as_object().unwrap() {
        for (method, operation) in item.as_object().unwrap().iter().filter(|(method, _)| *method != "get") {
            let name = operation["operationId"].as_str().unwrap();
            assert!(recorded.contains(name), "{method} {name} leaves no row");
        }
    }
    for (name, tag) in &left_alone {
        assert!(tag != "results", "{name} reads a result and leaves no row");
    }
    assert!(recorded.contains("get_mesh_content") && recorded.contains("get_result"));
    assert!(recorded.len() >= 22 && left_alone.len() >= 10, "{recorded:?} {left_alone:?}");
    service.end().await;
}

#[tokio::test]
async fn rows_say_who_did_what_and_nothing_of_a_patient() {
    let service = TestService::start(&["--auth", "keys"]).await;
    let [submitter, reader] = [key(&service, "clinic-a", "submitter").await, key(&service, "clinic-a", "reader").await];
    let url = |path: &str| format!("{}{path}", service.base);
    let submission = form("a", "b", &json!({})).text("tags", json!({"patient": "Doe-Jane"}).to_string());
    let submission = submission.text("external_ref", "Doe-Jane");
    let request = service.client.post(url("/v1/jobs")).bearer_auth(&submitter).header("x-request-id", "Doe-Jane");
    let job: Value = request.multipart(submission).send().await.unwrap().json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    let began = Instant::now();
    let result = loop {
        let result =
            service.client.get(url(&format!("/v1/jobs/{id}/result"))).bearer_auth(&reader).send().await.unwrap();
        if result.status() == 200 {
            break result;
        }
        assert!(began.elapsed() < PATIENCE);
        tokio::time::sleep(Duration::from_millis(50)).await;
    };
    assert!(result.json::<Value>().await.unwrap()["transform"].is_object());
    for path in
        ["/v1/jobs/Doe-Jane/result", "/v1/meshes?file_name=Doe-Jane.ply", "/v1/jobs/cancel?tag=patient:Doe-Jane"]
    {
        let method = if path.ends_with("result") { reqwest::Method::GET } else { reqwest::Method::POST };
        service.client.request(method, url(path)).bearer_auth(&submitter).body("mesh").send().await.unwrap();
    }
    // An unknown caller: the log does not contain the key that was sent.
    let refused =
        service.client.delete(url(&format!("/v1/jobs/{id}"))).bearer_auth("hml_Doe-Jane").send().await.unwrap();
    assert_eq!(refused.status(), 401);
    let rows = rows(&service).await;
    let text = serde_json::to_string(&rows).unwrap();
    assert!(!text.contains("Doe") && !text.contains("Jane"), "{text}");
    for secret in [&submitter, &reader] {
        assert!(!text.contains(secret.rsplit('_').next().unwrap()));
    }
    let of = |action: &str, status: i64| {
        let found = rows.iter().find(|row| row.action == action && row.status == Some(status));
        found.unwrap_or_else(|| panic!("no {action} {status}: {rows:?}"))
    };
    let resource = Some(format!("jobs/{id}"));
    assert_eq!(
        (&of("submit_job", 202).resource, of("submit_job", 202).key_id.as_deref()),
        (&resource, submitter.split('_').nth(1))
    );
    assert_eq!(
        (&of("get_result", 200).resource, of("get_result", 200).key_id.as_deref()),
        (&resource, reader.split('_').nth(1))
    );
    assert_eq!(of("get_result", 404).resource, None);
    assert!(of("upload_mesh", 201).resource.as_deref().unwrap().starts_with("meshes/blake3:"));
    assert_eq!((&of("delete_job", 401).tenant, &of("delete_job", 401).key_id), (&None, &None));
    // Rows of the commands that created the keys.
    let created: Vec<_> = rows.iter().filter(|row| row.action == "create_key").collect();
    assert_eq!(created.len(), 2);
    assert_eq!((created[0].tenant.as_deref(), created[0].address.as_deref()), (Some("clinic-a"), Some("command-line")));
    service.end().await;
}

#[tokio::test]
async fn a_request_whose_client_leaves_is_recorded() {
    let service = TestService::start(&["--workers", "0"]).await;
    let mut stream = tokio::net::TcpStream::connect(service.base.trim_start_matches("http://")).await.unwrap();
    let head = "POST /v1/meshes HTTP/1.1\r\nhost: localhost\r\ncontent-length: 1000\r\n\r\npart";
    stream.write_all(head.as_bytes()).await.unwrap();
    tokio::time::sleep(Duration::from_millis(200)).await;
    drop(stream);
    let began = Instant::now();
    while rows(&service).await.iter().all(|row| row.action != "upload_mesh" || row.status == Some(201)) {
        assert!(began.elapsed() < PATIENCE);
    }
    service.end().await;
}

#[tokio::test]
async fn the_log_is_exported_and_verified_by_command() {
    let service = TestService::start(&["--workers", "0"]).await;
    let folder = service.folder.path().to_owned();
    service.submit(json!({})).await;
    let (code, said, _) = audit(&folder, &["verify"]).await;
    let noted = said.trim().rsplit(' ').next().unwrap().to_owned();
    assert!(code == Some(0) && noted.starts_with("1:"), "{said}");
    service.submit(json!({"seed": 1})).await;
    service.submit(json!({"seed": 2})).await;
    let (code, said, _) = audit(&folder, &["verify", "--expect", &noted]).await;
    assert!(code == Some(0) && said.contains("3 rows"), "{said}");
    assert_eq!(audit(&folder, &["export", "--after", "2"]).await.1.lines().count(), 1);
    let _kept = service.end().await;

    let exported = folder.join("audit.jsonl");
    let text = audit(&folder, &["export"]).await.1;
    std::fs::write(&exported, &text).unwrap();
    let file = exported.to_str().unwrap();
    assert_eq!(audit(&folder, &["verify", "--file", file, "--expect", &noted]).await.0, Some(0));
    std::fs::write(&exported, text.replacen("\"status\":202", "\"status\":200", 2)).unwrap();
    let (code, _, stderr) = audit(&folder, &["verify", "--file", file]).await;
    assert!(code == Some(1) && stderr.contains("row 1 was changed"), "{stderr}");

    let database = Database::sqlite(&folder.join("homolog.sqlite")).await;
    database.execute("DROP TRIGGER audit_keeps_rows; DELETE FROM audit WHERE position = 2").await;
    let (code, _, stderr) = audit(&folder, &["verify"]).await;
    assert!(code == Some(1) && stderr.contains("row 2 is missing"), "{stderr}");
    database.execute("DELETE FROM audit").await;
    let (code, _, stderr) = audit(&folder, &["verify"]).await;
    assert!(code == Some(1) && stderr.contains("at least 3 rows"), "{stderr}");
    for wrong in ["1", "x:y", &format!("1:{}", "g".repeat(64))] {
        assert_eq!(audit(&folder, &["verify", "--expect", wrong]).await.0, Some(2), "{wrong}");
    }
}

on_both!(a_pruned_log_is_still_verified_from_where_it_begins);

async fn a_pruned_log_is_still_verified_from_where_it_begins(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "0"]);
    for _ in 0..3 {
        site.client(&node).submit(json!({})).await;
    }
    let (code, said) = command(&site, &["audit", "prune", "--before", "2000-01-01"]).await;
    assert!(code == Some(0) && said.contains("no row is older"), "{said}");
    let database = site.database().await;
    database.try_execute("DELETE FROM audit WHERE position = 1").await;
    assert_eq!(database.number("SELECT COUNT(*) FROM audit").await, 3, "rows go only by a prune that is recorded");
    let (code, said) = command(&site, &["audit", "prune", "--before", "2100-01-01"]).await;
    assert!(code == Some(0) && said.contains("removed 2 rows; the log begins after 2:"), "{said}");
    site.client(&node).submit(json!({})).await;
    let (code, said) = command(&site, &["audit", "verify"]).await;
    assert!(code == Some(0) && said.contains("is whole; 3 rows, the last is 5:"), "{said}");

    let (_, exported) = command(&site, &["audit", "export"]).await;
    let rows: Vec<&str> = exported.lines().filter(|line| line.starts_with('{')).collect();
    assert!(rows.len() == 3 && rows[0].contains("\"position\":3,") && rows[1].contains("prune_audit"), "{exported}");
    let file = site.folder.path().join("audit.jsonl");
    std::fs::write(&file, rows.join("\n")).unwrap();
    let (code, said) = command(&site, &["audit", "verify", "--file", file.to_str().unwrap()]).await;
    assert_eq!(code, Some(0), "{said}");

    // A log that is cut off at its beginning, with a matching anchor, has no row that records the pruning.
    database.try_execute("DELETE FROM audit WHERE position = 3").await;
    assert_eq!(database.number("SELECT COUNT(*) FROM audit").await, 3);
    let of_third: Value = serde_json::from_str(rows[0]).unwrap();
    database
        .execute(&format!("UPDATE audit_anchor SET position = 3, hash = '{}'", of_third["hash"].as_str().unwrap()))
        .await;
    database.execute("DELETE FROM audit WHERE position = 3").await;
    let (code, said) = command(&site, &["audit", "verify"]).await;
    assert!(code == Some(1) && said.contains("no row says that it was pruned"), "{said}");
}

#[tokio::test]
async fn requests_that_cannot_be_recorded_are_refused_if_the_log_is_required() {
    for required in [false, true] {
        let arguments: &[&str] = if required { &["--audit-required"] } else { &[] };
        let service = TestService::start(arguments).await;
        let id = service.submit(json!({})).await;
        service.until_final(&id).await;
        let file = service.folder.path().join("homolog.sqlite");
        let database = Database::sqlite(&file).await;
        database
            .execute(
                "CREATE TRIGGER fail_audit BEFORE INSERT ON audit BEGIN SELECT RAISE(ABORT, 'injected failure'); END",
            )
            .await;
        let path = format!("/v1/jobs/{id}/result");
        match required {
            true => drop(problem(service.get(&path).await, 503, "unavailable").await),
            false => assert_eq!(service.get(&path).await.status(), 200),
        }
        assert_eq!(service.get(&format!("/v1/jobs/{id}")).await.status(), 200, "what is not recorded is answered");
        assert!(service.get("/metrics").await.text().await.unwrap().contains("homolog_audit_rows_total{row=\"lost\"}"));
        database.execute("DROP TRIGGER fail_audit").await;
        assert_eq!(service.get(&path).await.status(), 200);
        service.end().await;
    }
}

#[tokio::test]
async fn what_the_service_purges_by_itself_is_recorded() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    assert!(rows(&service).await.iter().all(|row| row.action != "purge"));
    let folder = service.end().await;
    let service = TestService::start_in(folder, &["--retain-results-days", "0.0000001"]).await;
    let began = Instant::now();
    loop {
        let rows = rows(&service).await;
        if let Some(row) = rows.iter().find(|row| row.action == "purge") {
            assert_eq!((row.tenant.as_deref(), row.address.as_deref()), (None, Some("service")));
            break;
        }
        assert!(began.elapsed() < PATIENCE, "{rows:?}");
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    assert_eq!(service.get(&format!("/v1/jobs/{id}/result")).await.status(), 410);
    service.end().await;
}
