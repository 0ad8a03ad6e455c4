//! A15: small disks that can be filled.

use super::client::{Client, id_of, steps};
use super::on_postgres;
use super::site::{Backend, SOON, Site};
use crate::patience::PATIENCE;
use serde_json::json;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A disk of a few MiB, in memory. A shell keeps it mounted and unmounts it when this value is dropped or the process
/// ends.
struct Disk {
    folder: TempDir,
    keeper: Child,
}

impl Disk {
    /// Panics where mounting is not allowed.
    fn of_mib(size: u32) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let script = format!(
            "trap '' INT TERM HUP; mount -t tmpfs -o size={size}m,mode=1777 tmpfs \"$1\" || exit 1; \
             echo mounted; cat >/dev/null; umount -l \"$1\""
        );
        let mut keeper = Command::new("sh")
            .args(["-c", &script, "sh"])
            .arg(folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut answer = String::new();
        BufReader::new(keeper.stdout.take().unwrap()).read_line(&mut answer).unwrap();
        assert_eq!(answer.trim(), "mounted", "no small disk can be mounted here; that takes root");
        Disk { folder, keeper }
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Fills the disk except for `left` bytes.
    fn fill(&self, left: u64) {
        self.empty();
        let mut file = File::create(self.filler()).unwrap();
        let block = vec![0xa5; 4096];
        let mut n_bytes = 0;
        while file.write_all(&block).is_ok() {
            n_bytes += block.len() as u64;
        }
        file.set_len(n_bytes.saturating_sub(left)).unwrap();
    }

    /// Frees the space again.
    fn empty(&self) {
        let _ = fs::remove_file(self.filler());
    }

    fn filler(&self) -> PathBuf {
        self.path().join("filler")
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        drop(self.keeper.stdin.take());
        let _ = self.keeper.wait();
    }
}

/// Asserts that a submission is refused because of the full disk. A client gives up after a minute.
async fn is_refused(client: &Client, source: &str) {
    let (status, body) = client.try_submit_files(source, "target", &steps(1, 1)).await.unwrap();
    assert!([503, 507].contains(&status), "{status}: {body}");
}

/// Asserts that all listed jobs succeed, so that none was stored partially.
async fn all_of(client: &Client, acknowledged: &[String]) {
    let listed = client.list().await;
    for id in acknowledged {
        assert!(listed.iter().any(|(listed, _)| listed == id), "{id} was acknowledged and is lost");
    }
    for (id, _) in &listed {
        client.until_succeeded(id, SOON * 3).await;
        assert!(client.json(&format!("/v1/jobs/{id}/result")).await["points"].is_u64());
    }
}

#[tokio::test]
#[ignore = "needs root, to mount a small disk"]
async fn a15_sqlite() {
    let disk = Disk::of_mib(32);
    let site = Site::open_on(Backend::Sqlite, disk.path(), disk.path());
    let node = site.serve(&["--workers", "1"]);
    let client = site.client(&node);
    let database = site.database().await;
    database.watch().await;
    let mut acknowledged = vec![client.submit(steps(1, 1)).await];
    client.until_succeeded(&acknowledged[0], SOON).await;

    // Space for rows, but not for the file.
    let large = "s".repeat(2 << 20);
    disk.fill(512 << 10);
    let before = (client.list().await, site.blobs());
    is_refused(&client, &large).await;
    assert_eq!((client.list().await, site.blobs()), before);
    let incoming: Vec<_> = fs::read_dir(site.data_dir().join("incoming")).unwrap().collect();
    assert!(incoming.is_empty(), "{incoming:?}");
    disk.empty();
    acknowledged.push(id_of(&client.try_submit_files(&large, "target", &steps(1, 1)).await.unwrap().1));

    // No space at all while a job runs: storing its result waits for space.
    let running = client.submit(steps(60, 25)).await;
    client.until_traced(&running, 3, SOON).await;
    disk.fill(0);
    is_refused(&client, "source").await;
    tokio::time::sleep(Duration::from_secs(4)).await;
    is_refused(&client, "source").await;
    assert_eq!(client.job(&running).await["id"], json!(running), "what is there can be read");
    let ready = client.get("/readyz").await.unwrap();
    assert_eq!(ready.status(), 503, "it says so, as every submission is refused");
    assert_eq!(ready.json::<serde_json::Value>().await.unwrap()["dependencies"]["artifact_store"], "full");
    assert_eq!(database.number("SELECT COUNT(*) FROM seen_results").await, 2);
    disk.empty();
    acknowledged.push(running.clone());
    all_of(&client, &acknowledged).await;
    assert_eq!(database.n_results(&running).await, 1);
    let id = client.submit(steps(1, 1)).await;
    client.until_succeeded(&id, SOON).await;
}

/// Waits until `/readyz` responds with this status and state of the artifact store.
async fn until_readiness_is(client: &Client, expected: (u16, &str)) {
    let began = Instant::now();
    loop {
        let ready = client.get("/readyz").await.unwrap();
        let status = ready.status().as_u16();
        let body: serde_json::Value = ready.json().await.unwrap();
        if (status, body["dependencies"]["artifact_store"].as_str()) == (expected.0, Some(expected.1)) {
            return;
        }
        assert!(began.elapsed() < PATIENCE, "readiness is never {expected:?}: {status} {body}");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}

/// Without any space the service starts and reports why it refuses submissions, and a purge frees space.
#[tokio::test]
#[ignore = "needs root, to mount a small disk"]
async fn a15_a_service_and_a_purge_start_on_a_full_disk() {
    let disk = Disk::of_mib(48);
    let site = Site::open_on(Backend::Sqlite, disk.path(), disk.path());
    let mut node = site.serve(&["--workers", "1"]);
    let client = site.client(&node);
    let id = client.submit(steps(1, 1)).await;
    client.until_succeeded(&id, SOON).await;
    assert_eq!(client.get("/readyz").await.unwrap().status(), 200);
    let database = site.database().await;
    database.execute("UPDATE jobs SET finished_at = finished_at - 864000000 WHERE finished_at IS NOT NULL").await;
    drop(database);
    node.kill();
    disk.fill(0);
    let mut node = site.serve(&["--workers", "1", "--retain-results-days", "30"]);
    let client = site.client(&node);
    until_readiness_is(&client, (503, "full")).await;
    assert_eq!(client.job(&id).await["state"], "succeeded", "what is there can be read");
    disk.empty();
    until_readiness_is(&client, (200, "ok")).await;
    node.kill();
    disk.fill(0);
    let mut purge = crate::cli::homolog();
    purge.args(["purge", "--retain-results-days", "5"]).arg("--data-dir").arg(site.data_dir());
    let purged = purge.output().unwrap();
    let text = String::from_utf8_lossy(&purged.stdout).into_owned() + &String::from_utf8_lossy(&purged.stderr);
    assert!(purged.status.success() && text.contains("results of 1 jobs"), "{text}");
}

on_postgres!(needs "needs PostgreSQL, and root to mount a small disk":
    a15_the_disk_of_the_database_is_full,
    a15_the_disk_of_the_blobs_is_full,
);

async fn a15_the_disk_of_the_database_is_full() {
    let disk = Disk::of_mib(160);
    let mut site = Site::open_on(Backend::Postgres, disk.path(), &std::env::temp_dir());
    let node = site.serve(&["--workers", "1", "--max-attempts", "20"]);
    let client = site.client(&node);
    let database = site.database().await;
    database.watch().await;
    let mut acknowledged = vec![client.submit(steps(60, 25)).await];
    client.until_traced(&acknowledged[0], 3, SOON).await;
    disk.fill(0);
    let (began, mut n_refused) = (Instant::now(), 0);
    // Writes go into preallocated space until that is full; then every submission is refused.
    while n_refused < 5 {
        let (status, body) = client.try_submit(&steps(1, 1)).await.unwrap();
        match status {
            202 => acknowledged.push(id_of(&body)),
            507 => {
                n_refused += 1;
                let ready = client.get("/readyz").await.unwrap();
                assert_eq!(ready.status(), 503, "it says so, as submissions are refused");
            }
            503 => n_refused += 1,
            other => panic!("{other}: {body}"),
        }
        assert!(began.elapsed() < PATIENCE, "the disk never gets full");
        // Fills the log of the database faster than jobs would.
        database
            .try_execute("CREATE TABLE IF NOT EXISTS ballast AS SELECT repeat('x', 100) FROM generate_series(1, 20000)")
            .await;
        database.try_execute("UPDATE ballast SET repeat = repeat || 'y'").await;
    }
    disk.empty();
    let cluster = site.cluster.as_mut().unwrap();
    if !cluster.is_running() {
        // Without space for its log the server shuts down and has to be restarted.
        cluster.start_again();
    }
    let began = Instant::now();
    while client.try_submit(&steps(1, 1)).await.unwrap().0 != 202 {
        assert!(began.elapsed() < PATIENCE, "no submission is taken though there is room");
        tokio::time::sleep(Duration::from_millis(500)).await;
    }
    all_of(&client, &acknowledged).await;
    let (jobs, results) = site.database().await.jobs_and_results().await;
    assert_eq!(jobs, results);
}

async fn a15_the_disk_of_the_blobs_is_full() {
    let disk = Disk::of_mib(8);
    let site = Site::open_on(Backend::Postgres, &std::env::temp_dir(), disk.path());
    let node = site.serve(&["--workers", "1"]);
    let client = site.client(&node);
    let database = site.database().await;
    database.watch().await;
    let mut acknowledged = vec![client.submit(steps(60, 25)).await];
    client.until_traced(&acknowledged[0], 3, SOON).await;
    disk.fill(0);
    let listed = client.list().await.len();
    for _ in 0..3 {
        is_refused(&client, "another source").await;
    }
    assert_eq!(client.list().await.len(), listed);
    tokio::time::sleep(Duration::from_secs(3)).await;
    disk.empty();
    acknowledged.push(client.submit(steps(1, 1)).await);
    all_of(&client, &acknowledged).await;
    assert_eq!(database.jobs_and_results().await, (2, 2));
}
