//! Commands of docs/runbook.md, run for their effect.

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
