//! Patient data and secrets that remain in the data directory.

use crate::jobs_support::{TestService, form};
use crate::patience::PATIENCE;
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A folder and all files and folders below it.
fn everything_under(folder: &Path) -> Vec<PathBuf> {
    let mut found = vec![folder.to_owned()];
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { found.extend(everything_under(&path)) } else { found.push(path) }
    }
    found
}

/// The files that contain a text.
fn files_with(folder: &Path, text: &str) -> Vec<PathBuf> {
    let contains = |path: &PathBuf| {
        let content = fs::read(path).unwrap_or_default();
        content.windows(text.len()).any(|window| window == text.as_bytes())
    };
    everything_under(folder).into_iter().filter(|path| path.is_file()).filter(contains).collect()
}

#[cfg(unix)]
#[tokio::test]
async fn only_the_user_of_the_service_can_read_its_files() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = std::sync::Arc::new(tempfile::tempdir().unwrap());
    // Permissions as an operator or an earlier version may have set them.
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).unwrap();
    let service = TestService::start_in(folder, &[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    let upload = service.client.post(format!("{}/v1/meshes", service.base)).body("mesh").send().await.unwrap();
    assert_eq!(upload.status(), 201);
    let all = everything_under(service.folder.path());
    assert!(all.len() > 15, "{all:?}");
    for path in all {
        let mode = fs::metadata(&path).unwrap().permissions().mode() & 0o777;
        assert_eq!(mode & 0o077, 0, "{}: {mode:o}", path.display());
    }
    service.end().await;
}

#[tokio::test]
async fn nothing_of_a_deleted_job_is_left_in_the_files() {
    let service = TestService::start(&[]).await;
    let (label, reference) = ("Doe-Jane-label", "Doe-Jane-reference");
    let submission = form("a", "b", &json!({})).text("tags", json!({"patient": label}).to_string());
    let job: Value = service.send(submission.text("external_ref", reference)).await.json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    service.until_final(id).await;
    for text in [label, reference] {
        assert!(!files_with(service.folder.path(), text).is_empty(), "{text} was stored");
    }
    assert_eq!(service.delete(&format!("/v1/jobs/{id}")).await.status(), 204);
    for text in [label, reference] {
        let began = Instant::now();
        loop {
            let found = files_with(service.folder.path(), text);
            if found.is_empty() {
                break;
            }
            assert!(began.elapsed() < PATIENCE, "{text} is still in {found:?}");
            tokio::time::sleep(Duration::from_millis(200)).await;
        }
    }
    service.end().await;
}

#[tokio::test]
async fn nothing_of_a_purged_job_is_left_in_the_files() {
    let service = TestService::start(&[]).await;
    let texts = ["Doe-Jane-label", "Doe-Jane-reference", "Doe-Jane-source", "Doe-Jane-target", "Doe-Jane-upload"];
    let [label, reference, source, target, upload] = texts;
    let submission = form(source, target, &json!({})).text("tags", json!({"patient": label}).to_string());
    let job: Value = service.send(submission.text("external_ref", reference)).await.json().await.unwrap();
    service.until_final(job["id"].as_str().unwrap()).await;
    let sent = service.client.post(format!("{}/v1/meshes", service.base)).body(upload).send().await.unwrap();
    assert_eq!(sent.status(), 201);
    // Searched by another process: opening and closing a file of the database in this process would release the locks
    // of the service.
    let found_by_grep = |text: &str| {
        let done = std::process::Command::new("grep").args(["-rlaF", "-e", text]).arg(service.folder.path()).output();
        String::from_utf8(done.unwrap().stdout).unwrap()
    };
    for text in texts {
        assert_ne!(found_by_grep(text), "", "{text} was stored");
    }
    // Purged while the service runs and reads.
    let arguments = ["purge", "--retain-results-days", "0.0000001", "--retain-jobs-days", "0.0000001"];
    let (code, said, stderr) = crate::backups::run(&arguments, service.folder.path()).await;
    assert!(code == Some(0) && said.contains("1 jobs"), "{said}{stderr}");
    // The database with its log, the folder of blobs, and unfinished writes.
    for text in texts.into_iter().chain(["ply source", "ply aligned", "transform"]) {
        assert_eq!(found_by_grep(text), "", "{text:?} is still stored");
    }
    service.end().await;
}

#[tokio::test]
async fn secrets_of_webhooks_are_sealed() {
    let service = TestService::start(&["--workers", "0"]).await;
    let create = service.client.post(format!("{}/v1/webhooks", service.base));
    let made: Value = create.json(&json!({"url": "https://example.org/"})).send().await.unwrap().json().await.unwrap();
    let secret = made["secret"].as_str().unwrap().to_owned();
    assert!(secret.starts_with("whsec_"));
    assert_eq!(files_with(service.folder.path(), &secret["whsec_".len()..]), [] as [PathBuf; 0]);
    let folder = service.end().await;

    // An earlier version has stored the secret unsealed: it is sealed at the next start.
    let options = sqlx::sqlite::SqliteConnectOptions::new().filename(folder.path().join("homolog.sqlite"));
    let pool = sqlx::SqlitePool::connect_with(options).await.unwrap();
    sqlx::query("UPDATE webhooks SET secret = $1").bind(&secret).execute(&pool).await.unwrap();
    pool.close().await;
    assert!(!files_with(folder.path(), &secret).is_empty());
    let service = TestService::start_in(folder, &["--workers", "0"]).await;
    let began = Instant::now();
    while !files_with(service.folder.path(), &secret).is_empty() {
        assert!(began.elapsed() < PATIENCE);
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
    service.end().await;
}

#[tokio::test]
async fn a_name_leaves_only_the_ending_of_a_format() {
    let service = TestService::start(&["--workers", "0"]).await;
    let upload = service.client.post(format!("{}/v1/meshes?file_name=Doe^Jane.19700131", service.base));
    assert_eq!(upload.body("mesh").send().await.unwrap().status(), 201);
    assert_eq!(files_with(service.folder.path(), "19700131"), [] as [PathBuf; 0]);
    service.end().await;
}
