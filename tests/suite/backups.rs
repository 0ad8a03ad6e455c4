//! Back-up and restore: made while the service runs, refused if anything is missing or damaged.

use super::cli::homolog;
use super::jobs_support::TestService;
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Exit code, standard output and standard error of `homolog`.
pub(crate) async fn run(arguments: &[&str], data_dir: &Path) -> (Option<i32>, String, String) {
    let mut command = homolog();
    command.args(arguments).arg("--data-dir").arg(data_dir);
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code(), text(done.stdout), text(done.stderr))
}

fn files_under(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { found.extend(files_under(&path)) } else { found.push(path) }
    }
    found
}

/// The blobs of results and uploads in a backup.
fn blobs(backup: &Path) -> Vec<PathBuf> {
    files_under(&backup.join("blobs"))
}

#[tokio::test]
async fn a_service_is_backed_up_while_it_runs_and_restored_whole() {
    let service = TestService::start(&[]).await;
    let folder = tempfile::tempdir().unwrap();
    let (backup, restored) = (folder.path().join("backup"), folder.path().join("restored"));
    let backup_text = backup.to_str().unwrap();
    let mut ids = Vec::new();
    for seed in 0..3 {
        ids.push(service.submit(json!({"seed": seed})).await);
        service.until_final(ids.last().unwrap()).await;
    }
    let (code, said, stderr) = run(&["backup", backup_text], service.folder.path()).await;
    assert!(code == Some(0) && said.starts_with("backed up the database and "), "{said}{stderr}");
    let n_first = blobs(&backup).len();

    // A second backup, while jobs are being run and deleted.
    let client = service.client.clone();
    let base = service.base.clone();
    let deleted = ids.remove(0);
    let busy = tokio::spawn(async move {
        client.delete(format!("{base}/v1/jobs/{deleted}")).send().await.unwrap();
        for seed in 10..40 {
            let form = super::jobs_support::form("a", &format!("b{seed}"), &json!({"seed": seed}));
            let sent = client.post(format!("{base}/v1/jobs")).multipart(form).send().await.unwrap();
            assert_eq!(sent.status(), 202);
        }
    });
    let upload = service.client.post(format!("{}/v1/meshes", service.base)).body("an upload").send().await.unwrap();
    let upload = upload.headers()["location"].to_str().unwrap().to_owned();
    let (code, said, stderr) = run(&["backup", backup_text], service.folder.path()).await;
    assert!(code == Some(0), "{said}{stderr}");
    busy.await.unwrap();
    assert!(blobs(&backup).len() > n_first);
    assert_eq!(fs::read_dir(&backup).unwrap().count(), 3, "blobs, one database, its description");
    let mut before = Vec::new();
    for id in &ids {
        before.push(service.get(&format!("/v1/jobs/{id}/correspondences")).await.bytes().await.unwrap());
    }
    service.end().await;

    let (code, said, stderr) = run(&["restore", backup_text], &restored).await;
    assert!(code == Some(0) && said.starts_with("restored the database and "), "{said}{stderr}");
    #[cfg(unix)]
    for path in files_under(&restored).into_iter().chain(files_under(&backup)) {
        use std::os::unix::fs::PermissionsExt as _;
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o077, 0, "{}", path.display());
    }
    let (code, said, stderr) = run(&["audit", "verify"], &restored).await;
    assert!(code == Some(0), "{said}{stderr}");
    // A restore into the data directory that is now in use is refused.
    let (code, _, stderr) = run(&["restore", backup_text], &restored).await;
    assert!(code == Some(2) && stderr.contains("is not empty"), "{stderr}");

    let holder = Arc::new(tempfile::tempdir_in(folder.path()).unwrap());
    for entry in fs::read_dir(&restored).unwrap() {
        let path = entry.unwrap().path();
        fs::rename(&path, holder.path().join(path.file_name().unwrap())).unwrap();
    }
    let service = TestService::start_in(holder, &[]).await;
    for (id, before) in ids.iter().zip(before) {
        let after = service.get(&format!("/v1/jobs/{id}/correspondences")).await;
        assert_eq!((after.status().as_u16(), after.bytes().await.unwrap()), (200, before));
    }
    assert_eq!(service.get(&format!("{upload}/content")).await.text().await.unwrap(), "an upload");
    // Every file that the copied database references is in the backup.
    let jobs: Value = service.json("/v1/jobs?state=succeeded&page_size=100").await;
    for job in jobs["jobs"].as_array().unwrap() {
        assert_eq!(service.get(job["links"]["result"].as_str().unwrap()).await.status(), 200);
    }
    service.end().await;
}

#[tokio::test]
async fn a_damaged_or_incomplete_backup_is_not_restored() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    let folder = tempfile::tempdir().unwrap();
    let backup = folder.path().join("backup");
    let backup_text = backup.to_str().unwrap();
    assert_eq!(run(&["backup", backup_text], service.folder.path()).await.0, Some(0));
    service.end().await;
    let mut n_tries = 0;
    let mut refused = async |said: &str| {
        n_tries += 1;
        let data_dir = folder.path().join(format!("try-{n_tries}"));
        let (code, _, stderr) = run(&["restore", backup_text], &data_dir).await;
        assert!(code == Some(1) && stderr.contains(said), "{code:?} {stderr}");
        assert!(!data_dir.join("homolog.sqlite").exists(), "{said}");
        assert_eq!(run(&["keys", "list"], &data_dir).await.0, Some(2), "it holds no service");
    };
    let blob = blobs(&backup).into_iter().next().unwrap();
    let content = fs::read(&blob).unwrap();
    let mut wrong = content.clone();
    wrong[0] ^= 1;
    fs::write(&blob, wrong).unwrap();
    refused("is damaged").await;
    fs::remove_file(&blob).unwrap();
    refused("1 blobs are missing").await;
    fs::write(&blob, content).unwrap();
    let database = fs::read_dir(&backup)
        .unwrap()
        .map(|e| e.unwrap().path())
        .find(|p| p.extension().is_some_and(|e| e == "sqlite"));
    let database = database.unwrap();
    let content = fs::read(&database).unwrap();
    let mut wrong = content.clone();
    *wrong.last_mut().unwrap() ^= 1;
    fs::write(&database, wrong).unwrap();
    refused("is damaged").await;
    fs::write(&database, content).unwrap();
    let fine = folder.path().join("fine");
    assert_eq!(run(&["restore", backup_text], &fine).await.0, Some(0), "repaired");
}

#[tokio::test]
async fn a_backup_succeeds_only_with_what_can_be_restored() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    let folder = tempfile::tempdir().unwrap();
    let backup = folder.path().join("backup");
    let back_up = async || run(&["backup", backup.to_str().unwrap()], service.folder.path()).await;
    assert_eq!(back_up().await.0, Some(0));
    // A copy that was damaged later, at the same length, is replaced.
    let copy = blobs(&backup).into_iter().next().unwrap();
    let own = service.folder.path().join(copy.strip_prefix(&backup).unwrap());
    let stored = fs::read(&own).unwrap();
    let mut wrong = stored.clone();
    wrong[0] ^= 1;
    fs::write(&copy, &wrong).unwrap();
    assert_eq!(back_up().await.0, Some(0));
    assert!(fs::read(&copy).unwrap() == stored, "as it was");
    // A blob that is damaged in the service cannot be restored, wherever it is copied.
    fs::write(&own, &wrong).unwrap();
    fs::remove_file(&copy).unwrap();
    let (code, _, stderr) = back_up().await;
    assert!(code == Some(1) && stderr.contains("is damaged"), "{code:?} {stderr}");
    service.end().await;
}

#[tokio::test]
async fn other_folders_and_other_stores_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let (data, other) = (folder.path().join("data"), folder.path().join("other"));
    fs::create_dir(&other).unwrap();
    fs::write(other.join("letter.txt"), "of somebody").unwrap();
    let other_text = other.to_str().unwrap();
    let (code, _, stderr) = run(&["backup", other_text], &data).await;
    assert!(code == Some(2) && stderr.contains("holds no service"), "{stderr}");
    assert_eq!(run(&["migrate"], &data).await.0, Some(0));
    let (code, _, stderr) = run(&["backup", other_text], &data).await;
    assert!(code == Some(2) && stderr.contains("no backup"), "{stderr}");
    let (code, _, stderr) = run(&["restore", other_text], &folder.path().join("new")).await;
    assert!(code == Some(2) && stderr.contains("holds no backup"), "{stderr}");
    let (code, _, stderr) = run(&["backup", "x", "--artifacts-url", "s3://bucket"], &data).await;
    assert!(code == Some(2) && stderr.contains("docs/runbook.md"), "{stderr}");
    assert_eq!(fs::read_dir(&other).unwrap().count(), 1, "nothing was written");
}
