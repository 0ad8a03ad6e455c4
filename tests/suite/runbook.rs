//! Commands of docs/runbook.md, run to check their effects.

use crate::jobs_support::TestService;
use serde_json::json;
use std::path::Path;
use std::process::Command;

/// The shell block that follows the first line of the runbook with this text.
fn commands_after(text: &str) -> String {
    let runbook = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/runbook.md")).unwrap();
    let (_, rest) = runbook.split_once(text).unwrap_or_else(|| panic!("the runbook has no '{text}'"));
    let (_, block) = rest.split_once("```sh\n").unwrap();
    block.split("```").next().unwrap().to_owned()
}

/// Runs commands as an operator does, and returns their output.
async fn run(commands: &str, data_dir: &Path) -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_homolog")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    let mut command = Command::new("bash");
    command.args(["-euc", commands]).env("PATH", path).env("HOMOLOG_DATA_DIR", data_dir);
    let output = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    assert!(output.status.success(), "{commands}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[tokio::test]
async fn the_shorter_retention_for_a_full_disk_removes_older_results() {
    let service = TestService::start(&["--retain-results-days", "90"]).await;
    let [old, new] = [service.submit(json!({"seed": 1})).await, service.submit(json!({"seed": 2})).await];
    for id in [&old, &new] {
        assert_eq!(service.until_final(id).await["state"], "succeeded");
    }
    let database = service.folder.path().join("homolog.sqlite");
    let pool =
        sqlx::SqlitePool::connect_with(sqlx::sqlite::SqliteConnectOptions::new().filename(database)).await.unwrap();
    let age = sqlx::query("UPDATE jobs SET finished_at = finished_at - 40 * 86400000 WHERE id = $1").bind(&old);
    assert_eq!(age.execute(&pool).await.unwrap().rows_affected(), 1);
    pool.close().await;

    let said = run(&commands_after("Apply a shorter retention"), service.folder.path()).await;
    let said: Vec<&str> = said.lines().collect();
    assert!(said[0].starts_with("would be removed: results of 1 jobs"), "{said:?}");
    assert!(said[1].starts_with("removed: results of 1 jobs") && !said[1].ends_with(" 0 files"), "{said:?}");
    assert_eq!(service.get(&format!("/v1/jobs/{old}/result")).await.status(), 410);
    assert_eq!(service.get(&format!("/v1/jobs/{new}/result")).await.status(), 200);
    service.end().await;
}

/// Whether a tool of an operator is on this machine; prints a note if it is not.
fn has_tool(name: &str) -> bool {
    let found = Command::new(name).arg("--version").output().is_ok();
    if !found {
        println!("skipped: {name} is not installed");
    }
    found
}

#[tokio::test]
async fn the_write_ahead_log_is_truncated_while_the_service_runs() {
    if !has_tool("sqlite3") {
        return;
    }
    let service = TestService::start(&[]).await;
    for seed in 0..5 {
        let id = service.submit(json!({"seed": seed})).await;
        service.until_final(&id).await;
    }
    let log = service.folder.path().join("homolog.sqlite-wal");
    assert!(std::fs::metadata(&log).unwrap().len() > 0);
    let runbook = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/runbook.md")).unwrap();
    let command = runbook.split('`').find(|span| span.starts_with("sqlite3") && span.contains("TRUNCATE")).unwrap();
    let command = format!("D=$HOMOLOG_DATA_DIR; {command}");
    let said = run(&command, service.folder.path()).await;
    assert!(said.starts_with("0|"), "{said}");
    assert!(std::fs::metadata(&log).unwrap().len() < 100_000, "only what was written since");
    let id = service.submit(json!({"seed": 9})).await;
    assert_eq!(service.until_final(&id).await["state"], "succeeded");
    service.end().await;
}

#[tokio::test]
async fn the_queue_is_looked_at_through_the_api() {
    if !has_tool("curl") {
        return;
    }
    let service = TestService::start(&["--workers", "0"]).await;
    let id = service.submit(json!({})).await;
    let commands = commands_after("Through the API, with a key of the tenant concerned:");
    assert!(commands.contains("state=queued") && commands.contains("state=running"), "{commands}");
    let said = run(&format!("API={}; auth='x: y'; {commands}", service.base), service.folder.path()).await;
    assert!(said.contains(&id) && said.contains("\"jobs\":[]"), "{said}");
    service.end().await;
}

#[tokio::test]
async fn a_back_up_is_restored_and_passes_the_drill() {
    let runs = |command: &str| {
        let done = Command::new("bash").args(["-c", command]).output();
        done.is_ok_and(|done| done.status.success())
    };
    if !has_tool("curl") || !runs("unshare --net --map-root-user ip link set lo up") {
        println!("skipped: curl, or unshare and ip with the right to make a network, are missing");
        return;
    }
    let service = TestService::start(&[]).await;
    let ids = [service.submit(json!({"seed": 1})).await, service.submit(json!({"seed": 2})).await];
    for id in &ids {
        assert_eq!(service.until_final(id).await["state"], "succeeded");
    }
    let folder = tempfile::tempdir().unwrap();
    let [data, backup] = ["data", "backup"].map(|name| folder.path().join(name).display().to_string());
    let variables = format!("D='{}'; B='{backup}';", service.folder.path().display());
    let said = run(&format!("{variables} {}", commands_after("While the service runs:")), service.folder.path()).await;
    assert!(said.starts_with("backed up the database"), "{said}");
    let held = service.end().await;

    // The data directory of the test cannot be renamed; a copy of it can.
    let variables = format!("D='{data}'; B='{backup}';");
    let commands = commands_after("To restore, with the service stopped:");
    let copied = format!("cp -a '{}' '{data}'; {variables} {commands}", held.path().display());
    let said = run(&copied, Path::new(&data)).await;
    assert!(said.starts_with("restored the database"), "{said}");
    let [key, kept] = [data.clone(), format!("{data}.before")]
        .map(|data| std::fs::read(Path::new(&data).join("secret.key")).unwrap());
    assert_eq!(key, kept);

    let drill =
        commands_after("### Restore drill").replace("/tmp/drill", folder.path().join("drill").to_str().unwrap());
    let said = run(&format!("{variables} {drill}"), Path::new(&data)).await;
    assert!(said.contains("the audit log is whole") && !said.contains("no result"), "{said}");
    for id in &ids {
        assert!(said.contains(&format!("result: {id}")), "{said}");
    }
}

#[tokio::test]
async fn keys_are_created_listed_and_revoked() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let commands = commands_after("**API keys** may overlap");
    let (create, rest) = commands.split_once('\n').unwrap();
    let key = run(create, service.folder.path()).await;
    let asked = async || {
        let request = service.client.get(format!("{}/v1/jobs", service.base)).bearer_auth(key.trim());
        request.send().await.unwrap().status().as_u16()
    };
    assert_eq!(asked().await, 200);
    let said = run(&rest.replace("ID", key.split('_').nth(1).unwrap()), service.folder.path()).await;
    assert!(said.contains("PACS bridge 2027") && said.contains("submitter") && said.contains("is revoked"), "{said}");
    assert_eq!(asked().await, 401);
    service.end().await;
}

mod postgres {
    use super::*;
    use crate::faults::site::{Backend, Site};

    #[tokio::test]
    #[ignore = "needs PostgreSQL"]
    async fn the_queries_of_the_runbook_are_answered() {
        if !has_tool("psql") {
            return;
        }
        let site = Site::open(Backend::Postgres);
        let node = site.serve(&["--workers", "0"]);
        let id = site.client(&node).submit(json!({"points": 1, "step_ms": 1})).await;
        let url = site.cluster.as_ref().unwrap().url();
        for (place, answer) in [
            ("With SQL, over all tenants", id.as_str()),
            ("PostgreSQL's write-ahead log grows", "failed_count"),
            ("To see which migrations the database has:", "service"),
        ] {
            let commands = commands_after(place).replace("psql \"", "psql --set ON_ERROR_STOP=1 \"");
            let said = run(&format!("HOMOLOG_DATABASE_URL='{url}'; {commands}"), &site.data_dir()).await;
            assert!(said.contains(answer), "{place}: {said}");
        }
    }
}
