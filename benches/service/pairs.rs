//! Surfaces of about a given size, and batches of matches through the service.

use crate::http::Client;
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::PhantomPair;
use jiff::Timestamp;
use serde_json::{Value, json};
use std::time::Duration;

/// Approximate number of vertices of a phantom times the square of its edge length in mm.
const VERTICES_MM2: f64 = 1_480.0;
/// Maximum number of jobs on a page.
const PAGE: usize = 500;

/// Parameters of the matches; the service's defaults unless the environment says otherwise.
pub(crate) fn parameters() -> Value {
    std::env::var("SERVICE_BENCH_PARAMETERS").map_or_else(|_| json!({}), |text| serde_json::from_str(&text).unwrap())
}

/// Prints these parameters.
pub(crate) fn say_parameters() {
    match parameters() {
        Value::Object(none) if none.is_empty() => println!("Default parameters.\n"),
        told => println!("Parameters: `{told}`.\n"),
    }
}

/// Source and target, two subjects of about `n_vertices` each in different poses, as PLY.
pub(crate) fn pair(n_vertices: usize) -> [Vec<u8>; 2] {
    subject(1, n_vertices)
}

/// The subject of this number and the template, which is the same for all, as PLY.
pub(crate) fn subject(number: u64, n_vertices: usize) -> [Vec<u8>; 2] {
    let edge_mm = (VERTICES_MM2 / n_vertices as f64).sqrt();
    let meshes = PhantomPair::against_template(number).unwrap().meshes(edge_mm).unwrap();
    meshes.map(|mesh| write_ply(&mesh))
}

/// A file to upload: its name and what it holds.
pub(crate) struct Upload {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// A template and subjects of about `n_vertices` each: phantoms, or the files of the folder that
/// `SERVICE_BENCH_SUBJECTS` names in the order of their names, of which the first is the template.
pub(crate) fn template_and_subjects(n_subjects: usize, n_vertices: usize) -> (Upload, Vec<Upload>) {
    let Ok(folder) = std::env::var("SERVICE_BENCH_SUBJECTS") else {
        let phantom = |bytes| Upload { name: "phantom.ply".to_owned(), bytes };
        let [_, template] = subject(0, n_vertices);
        let subjects = (0..n_subjects as u64).map(|number| {
            let [source, _] = subject(number, n_vertices);
            phantom(source)
        });
        return (phantom(template), subjects.collect());
    };
    let mut paths: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert!(paths.len() > n_subjects, "{folder} has to hold {} files, a template and the subjects", n_subjects + 1);
    let mut files = paths.into_iter().take(n_subjects + 1).map(|path| Upload {
        name: path.file_name().unwrap().to_str().unwrap().to_owned(),
        bytes: std::fs::read(&path).unwrap(),
    });
    let template = files.next().unwrap();
    (template, files.collect())
}

/// When a job was accepted, started and finished, and how large it was.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Times {
    pub created: Timestamp,
    pub started: Timestamp,
    pub finished: Timestamp,
    pub n_vertices: u64,
}

impl Times {
    pub(crate) fn waited_s(&self) -> f64 {
        self.started.duration_since(self.created).as_secs_f64()
    }

    pub(crate) fn ran_s(&self) -> f64 {
        self.finished.duration_since(self.started).as_secs_f64()
    }
}

/// Time from the first acceptance to the last end, s.
pub(crate) fn makespan_s(times: &[Times]) -> f64 {
    let began = times.iter().map(|t| t.created).min().unwrap();
    let ended = times.iter().map(|t| t.finished).max().unwrap();
    ended.duration_since(began).as_secs_f64()
}

/// Uploads a surface and returns its id.
pub(crate) async fn upload(client: &mut Client, ply: &[u8]) -> String {
    upload_file(client, "s.ply", ply).await
}

/// Uploads a file of this name and returns the id of its surface.
pub(crate) async fn upload_file(client: &mut Client, name: &str, bytes: &[u8]) -> String {
    let path = format!("/v1/meshes?file_name={name}");
    let (status, body) = client.request("POST", &path, "application/octet-stream", bytes).await;
    assert!(status == 200 || status == 201, "{}", String::from_utf8_lossy(&body));
    serde_json::from_slice::<Value>(&body).unwrap()["id"].as_str().unwrap().to_owned()
}

/// Submits a batch, waits until all of its jobs have finished, and returns their times.
pub(crate) async fn run_batch(client: &mut Client, batch: &Value) -> Vec<Times> {
    let (status, body) = client.request("POST", "/v1/batches", "application/json", batch.to_string().as_bytes()).await;
    let answer: Value = serde_json::from_slice(&body).unwrap();
    assert!((200..300).contains(&status), "{answer}");
    let path = format!("/v1/batches/{}/jobs?page_size={PAGE}", answer["id"].as_str().unwrap());
    loop {
        tokio::time::sleep(Duration::from_millis(200)).await;
        let (_, body) = client.request("GET", &path, "", b"").await;
        let page: Value = serde_json::from_slice(&body).unwrap();
        let jobs = page["jobs"].as_array().unwrap();
        let of = |state: &str| jobs.iter().filter(|job| job["state"] == state).count();
        if of("queued") + of("running") == 0 {
            assert_eq!(of("succeeded"), jobs.len(), "{page}");
            return jobs.iter().map(times).collect();
        }
    }
}

fn times(job: &Value) -> Times {
    let time = |name: &str| job[name].as_str().unwrap().parse::<Timestamp>().unwrap();
    let n_vertices = job["source"]["n_vertices"].as_u64().unwrap();
    Times { created: time("created_at"), started: time("started_at"), finished: time("finished_at"), n_vertices }
}
