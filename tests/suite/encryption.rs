//! Encryption at rest: the stored files contain no readable part of an upload, a result or a secret, in a folder and in
//! a bucket; changed files are refused; keys are rotated while the service runs; and no process runs without its keys.

use super::backups::run;
use super::faults::client::{Client, id_of, steps};
use super::faults::node::{Node, NotStarted};
use super::faults::on_both;
use super::faults::site::{Backend, SOON, Site};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

on_both!(
    nothing_stored_is_found_in_clear_and_changes_are_refused,
    keys_are_rotated_while_the_service_runs_and_none_is_left_out,
    a_service_does_not_run_without_its_keys,
);

const OLD: &str = "1111111111111111111111111111111111111111111111111111111111111111";
const NEW: &str = "2222222222222222222222222222222222222222222222222222222222222222";

fn files_under(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() { found.extend(files_under(&path)) } else { found.push(path) }
    }
    found
}

/// The files with blobs of a site, and its database if that is a file.
fn stored_files(site: &Site) -> Vec<PathBuf> {
    let mut found = files_under(&site.data_dir());
    if let Some(s3) = &site.s3 {
        found.extend(files_under(&s3.bucket()));
    }
    found
}

/// The stored files that contain a text.
fn files_with(site: &Site, text: &str) -> Vec<PathBuf> {
    let has =
        |path: &PathBuf| fs::read(path).unwrap_or_default().windows(text.len()).any(|window| window == text.as_bytes());
    stored_files(site).into_iter().filter(has).collect()
}

/// Writes a file with these keys into the folder of a site.
fn keys(site: &Site, name: &str, keys: &[&str]) -> String {
    let path = site.folder.path().join(name);
    fs::write(&path, keys.join("\n")).unwrap();
    path.to_str().unwrap().to_owned()
}

/// A surface with a unique text, larger than a chunk.
fn surface() -> String {
    let vertices: Vec<String> = (0..8_000).map(|i| format!("v {i}.5 {}.25 {}", i * 7 % 1_000, i * 13 % 977)).collect();
    format!("# KNOWN-SURFACE-OF-JANE-DOE\n{}\nf 1 2 3\n", vertices.join("\n"))
}

async fn upload(client: &Client, content: &str) -> String {
    let sent = client.http.post(format!("{}/v1/meshes", client.base)).body(content.to_owned()).send().await.unwrap();
    assert_eq!(sent.status(), 201);
    id_of(&sent.json::<Value>().await.unwrap())
}

/// Status and body of a download; `None` instead of a body that breaks off.
async fn download(client: &Client, path: &str, range: Option<&str>) -> (u16, Option<String>) {
    let mut request = client.http.get(format!("{}{path}", client.base));
    if let Some(range) = range {
        request = request.header("range", range);
    }
    let answer = request.send().await.unwrap();
    (answer.status().as_u16(), answer.text().await.ok())
}

/// The result document of a finished job, without the parts that change from request to request.
async fn result(client: &Client, job: &str) -> String {
    let (status, body) = download(client, &format!("/v1/jobs/{job}/result"), None).await;
    assert_eq!(status, 200);
    body.unwrap()
}

async fn nothing_stored_is_found_in_clear_and_changes_are_refused(backend: Backend) {
    let site = Site::open(backend);
    let ring = keys(&site, "keys", &[NEW]);
    let node = site.serve(&["--encryption-key-file", &ring]);
    let client = site.client(&node);
    let surface = surface();
    let mesh = upload(&client, &surface).await;
    let job = client.submit(steps(3, 1)).await;
    client.until_succeeded(&job, SOON).await;
    let hook = client.http.post(format!("{}/v1/webhooks", client.base)).json(&json!({"url": "https://example.org/"}));
    let secret = hook.send().await.unwrap().json::<Value>().await.unwrap()["secret"].as_str().unwrap().to_owned();

    assert!(stored_files(&site).len() > 5, "something is stored");
    let found: Value = client.json(&format!("/v1/jobs/{job}/result")).await;
    assert!(found.is_object());
    for text in ["KNOWN-SURFACE", "v 17.5 119.25", &surface[60_000..60_040], "ply ", "\"transform\"", &secret[6..]] {
        assert_eq!(files_with(&site, text), [] as [PathBuf; 0], "{text:?} is stored in clear");
    }
    assert!(!site.data_dir().join("secret.key").exists(), "no key beside the database");

    let content = format!("/v1/meshes/{mesh}/content");
    assert_eq!(download(&client, &content, None).await, (200, Some(surface.clone())));
    for (start, end) in [(0, 9), (65_530, 65_545), (100_000, 100_000), (surface.len() - 5, surface.len() - 1)] {
        let range = format!("bytes={start}-{end}");
        assert_eq!(
            download(&client, &content, Some(&range)).await,
            (206, Some(surface[start..=end].to_owned())),
            "{range}"
        );
    }

    let hash = mesh.strip_prefix("blake3:").unwrap();
    let file = stored_files(&site).into_iter().find(|path| path.to_string_lossy().ends_with(hash)).unwrap();
    let stored = fs::read(&file).unwrap();
    for at in [3, 500, stored.len() / 2, stored.len() - 20] {
        let mut changed = stored.clone();
        changed[at] ^= 0x10;
        fs::write(&file, &changed).unwrap();
        let (status, body) = download(&client, &content, None).await;
        assert!(status >= 500 || body.is_none(), "byte {at}: {status}");
        let chunk = (at.saturating_sub(16) / 65_552).min(1) * 65_536;
        let (status, body) = download(&client, &content, Some(&format!("bytes={chunk}-{}", chunk + 9))).await;
        assert!(status >= 500 || body.is_none(), "byte {at}: {status}");
    }
    fs::write(&file, &stored).unwrap();
    assert_eq!(download(&client, &content, Some("bytes=2-14")).await.1.unwrap(), "KNOWN-SURFACE");
}

/// Exit code and output of a command on a site.
pub(crate) async fn command(site: &Site, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homolog"));
    command.args(arguments).envs(site.environment());
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    (done.status.code(), String::from_utf8_lossy(&done.stdout).into_owned() + &String::from_utf8_lossy(&done.stderr))
}

async fn keys_are_rotated_while_the_service_runs_and_none_is_left_out(backend: Backend) {
    let site = Site::open(backend);
    // Stored before any key was given.
    let plain = site.serve(&[]);
    let client = site.client(&plain);
    let mesh = upload(&client, &surface()).await;
    assert!(!files_with(&site, "KNOWN-SURFACE").is_empty());
    drop(plain);
    let old = keys(&site, "old", &[OLD]);
    let node = site.serve(&["--encryption-key-file", &old]);
    let client = site.client(&node);
    let job = client.submit(steps(3, 1)).await;
    client.until_succeeded(&job, SOON).await;
    let before = result(&client, &job).await;
    let small = upload(&client, "tiny").await;
    drop(node);

    // First all processes get the new key in addition to the old one, then the new key is used.
    let both = keys(&site, "both", &[NEW, OLD]);
    let node = site.serve(&["--encryption-key-file", &both]);
    let client = site.client(&node);
    let (code, said) = command(&site, &["encryption", "rotate", "--dry-run", "--encryption-key-file", &both]).await;
    assert!(code == Some(0) && said.contains("would be encrypted") && said.contains(", 1 not before"), "{said}");
    assert!(!files_with(&site, "KNOWN-SURFACE").is_empty(), "a dry run changes nothing");
    let (code, said) = command(&site, &["encryption", "rotate", "--encryption-key-file", &both]).await;
    assert!(code == Some(0) && said.contains(": 0 before") && said.contains(", 1 not before"), "{said}");
    assert_eq!(files_with(&site, "KNOWN-SURFACE"), [] as [PathBuf; 0]);
    let (_, said) = command(&site, &["encryption", "rotate", "--encryption-key-file", &both]).await;
    assert!(said.contains(" 0 with another key before, 0 not before"), "nothing is left: {said}");
    assert_eq!(result(&client, &job).await, before);
    drop(node);

    // The old key is no longer needed.
    let new = keys(&site, "new", &[NEW]);
    let node = site.serve(&["--encryption-key-file", &new]);
    let client = site.client(&node);
    assert_eq!(result(&client, &job).await, before);
    assert_eq!(download(&client, &format!("/v1/meshes/{mesh}/content"), None).await.1.unwrap(), surface());
    assert_eq!(download(&client, &format!("/v1/meshes/{small}/content"), None).await.1.unwrap(), "tiny");
    drop(node);
}

async fn a_service_does_not_run_without_its_keys(backend: Backend) {
    let site = Site::open(backend);
    let new = keys(&site, "new", &[NEW]);
    let print = format!("cat {new}");
    let node = site.serve(&["--encryption-key-command", &print, "--workers", "0"]);
    upload(&site.client(&node), "tiny").await;
    drop(node);
    let old = keys(&site, "old", &[OLD]);
    let refused = |started: Result<Node, NotStarted>, why: &str| {
        let Err(NotStarted(log)) = started else { panic!("it runs") };
        assert!(log.contains(why), "{log}");
        assert!(!log.contains(OLD) && !log.contains(NEW), "a key is in the log: {log}");
    };
    for role in ["serve", "worker"] {
        refused(site.node(role, &[], &[]), "are encrypted with the key");
        refused(site.node(role, &["--encryption-key-file", &old], &[]), "is not among the given ones");
        refused(site.node(role, &["--encryption-key-command", "exit 1"], &[]), "failed");
        refused(site.node(role, &["--encryption-key-command", &print, "--encryption-key-file", &new], &[]), "not both");
    }
    drop(site.serve(&["--encryption-key-file", &new]));
}

#[tokio::test]
async fn an_encrypted_backup_is_restored_with_its_keys_only() {
    let site = Site::open(Backend::Sqlite);
    let ring = keys(&site, "keys", &[NEW]);
    let node = site.serve(&["--encryption-key-file", &ring]);
    let client = site.client(&node);
    let mesh = upload(&client, &surface()).await;
    let backup = site.folder.path().join("backup");
    let backup_text = backup.to_str().unwrap();
    let (code, said, stderr) = run(&["backup", backup_text, "--encryption-key-file", &ring], &site.data_dir()).await;
    assert!(code == Some(0) && said.contains("encryption keys"), "{said}{stderr}");
    drop(node);
    let target = site.folder.path().join("restored");
    let (code, _, stderr) = run(&["restore", backup_text], &target).await;
    assert!(code == Some(2) && stderr.contains("give their key"), "{stderr}");
    fs::remove_dir_all(&target).unwrap();

    let hash = mesh.strip_prefix("blake3:").unwrap();
    let file = files_under(&backup).into_iter().find(|path| path.to_string_lossy().ends_with(hash)).unwrap();
    let stored = fs::read(&file).unwrap();
    let mut changed = stored.clone();
    changed[70_000] ^= 1;
    fs::write(&file, &changed).unwrap();
    let (code, _, stderr) = run(&["restore", backup_text, "--encryption-key-file", &ring], &target).await;
    assert!(code == Some(1) && stderr.contains("is damaged"), "{stderr}");
    fs::remove_dir_all(&target).unwrap();
    fs::write(&file, &stored).unwrap();
    let (code, said, stderr) = run(&["restore", backup_text, "--encryption-key-file", &ring], &target).await;
    assert!(code == Some(0), "{said}{stderr}");
}

#[tokio::test]
async fn a_backup_into_the_same_folder_after_a_rotation_can_be_restored() {
    let site = Site::open(Backend::Sqlite);
    let (old, both, new) = (keys(&site, "old", &[OLD]), keys(&site, "both", &[NEW, OLD]), keys(&site, "new", &[NEW]));
    let node = site.serve(&["--encryption-key-file", &old]);
    let mesh = upload(&site.client(&node), &surface()).await;
    let backup = site.folder.path().join("backup");
    let backup_text = backup.to_str().unwrap();
    let back_up =
        async |ring: &str| run(&["backup", backup_text, "--encryption-key-file", ring], &site.data_dir()).await;
    assert_eq!(back_up(&old).await.0, Some(0));
    drop(node);
    let (code, said) = command(&site, &["encryption", "rotate", "--encryption-key-file", &both]).await;
    assert!(code == Some(0) && said.contains("with another key before"), "{said}");
    let (code, said, stderr) = back_up(&new).await;
    assert!(code == Some(0), "{said}{stderr}");
    // The old key is gone.
    let target = site.folder.path().join("restored");
    let (code, said, stderr) = run(&["restore", backup_text, "--encryption-key-file", &new], &target).await;
    assert!(code == Some(0), "{said}{stderr}");

    // A copy that was damaged later is replaced; a damaged blob in the service fails the backup.
    let hash = mesh.strip_prefix("blake3:").unwrap();
    let under = |folder: &Path| files_under(folder).into_iter().find(|p| p.to_string_lossy().ends_with(hash)).unwrap();
    let (copy, own) = (under(&backup), under(&site.data_dir()));
    let stored = fs::read(&own).unwrap();
    let mut changed = stored.clone();
    changed[70_000] ^= 1;
    fs::write(&copy, &changed).unwrap();
    assert_eq!(back_up(&new).await.0, Some(0));
    assert!(fs::read(&copy).unwrap() == stored, "as it was");
    fs::write(&own, &changed).unwrap();
    let (code, _, stderr) = back_up(&new).await;
    assert!(code == Some(1) && stderr.contains("is damaged"), "{code:?} {stderr}");
}
