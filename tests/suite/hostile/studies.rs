//! Studies of many subjects and covariates, read by many at once, and probes beside them.

use crate::faults::site::{Backend, Site};
use crate::jobs_support::TestService;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::time::{Duration, Instant};

const N_SUBJECTS: usize = 1000;
const N_COVARIATES: usize = 256;
/// Requests at the same time.
const N_AT_ONCE: usize = 60;
/// What the process may take beside what it had when the study was stored: the stock of answers, and as much again.
const MOST: u64 = 512 << 20;

/// The status and the document of a probe, which is answered within a second.
fn probe(address: &str, path: &str) -> (u16, String) {
    let began = Instant::now();
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    assert!(began.elapsed() < Duration::from_secs(2), "{path} took {:?}", began.elapsed());
    let status = answer.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap();
    (status, answer)
}

/// A runtime whose only thread is kept busy answers nobody; the probes have a thread of their own.
#[tokio::test]
async fn probes_are_answered_while_nothing_else_is() {
    let service = TestService::start(&["--workers", "0", "--probe-listen", "127.0.0.1:0"]).await;
    // Both answer, so that both have started.
    for url in [&service.base, &service.probes] {
        assert_eq!(reqwest::get(format!("{url}/readyz")).await.unwrap().status(), 200);
    }
    let [probes, clients] = [&service.probes, &service.base].map(|url| url.trim_start_matches("http://").to_owned());
    let asking = std::thread::spawn(move || {
        let answers = ["/healthz", "/readyz", "/metrics"].map(|path| probe(&probes, path).0);
        let mut client = TcpStream::connect(&clients).unwrap();
        client.set_read_timeout(Some(Duration::from_millis(500))).unwrap();
        write!(client, "GET /healthz HTTP/1.1\r\nHost: {clients}\r\nConnection: close\r\n\r\n").unwrap();
        (answers, client.read(&mut [0; 16]).is_err())
    });
    let began = Instant::now();
    while !asking.is_finished() {
        // Not a wait of the runtime: its thread does nothing else meanwhile.
        std::thread::sleep(Duration::from_millis(5));
        assert!(began.elapsed() < Duration::from_secs(30), "no probe is answered");
    }
    let (answers, is_silent) = asking.join().unwrap();
    assert_eq!(answers, [200, 200, 200]);
    assert!(is_silent, "the thread of the clients was not busy");
    service.end().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_large_study_is_read_and_decided_on_by_many_at_once_in_little_memory() {
    let site = Site::open(Backend::Sqlite);
    let program = site.program(&["--workers", "0", "--max-batch", "1000", "--max-queue", "100000"]);
    homolog::tls::prepare();
    let client = reqwest::Client::builder().timeout(Duration::from_secs(120)).build().unwrap();
    let url = |path: &str| format!("{}{path}", program.base);
    let mesh = homolog_formats::write_ply(&ellipsoid(Vector3::new(9.0, 7.0, 5.0), 3));
    let sent = client.post(url("/v1/meshes")).header("content-type", "application/octet-stream").body(mesh);
    let mesh: Value = sent.send().await.unwrap().json().await.unwrap();
    let covariates: Value =
        (0..N_COVARIATES).map(|k| (format!("covariate_{k:03}"), json!(k))).collect::<serde_json::Map<_, _>>().into();
    let subjects: Vec<Value> = (0..N_SUBJECTS)
        .map(|k| json!({"id": format!("s{k}"), "input": {"mesh_id": mesh["id"]}, "covariates": covariates}))
        .collect();
    let study = json!({"subjects": subjects, "template": {"mesh_id": mesh["id"]}});
    let sent = client.post(url("/v1/studies")).json(&study).send().await.unwrap();
    let (status, study): (u16, Value) = (sent.status().as_u16(), sent.json().await.unwrap());
    assert_eq!(status, 202, "{study}");
    let path = format!("/v1/studies/{}", study["id"].as_str().unwrap());
    let before = program.peak_memory_bytes();
    let mut sent = tokio::task::JoinSet::new();
    for k in 0..N_AT_ONCE {
        let request = client.get(url(&path));
        sent.spawn(async move { request.send().await.unwrap().status().as_u16() });
        let decided = url(&format!("{path}/subjects/s{k}/decision"));
        let request = client.put(decided).json(&json!({"decision": "kept", "reason": "seen"}));
        sent.spawn(async move { request.send().await.unwrap().status().as_u16() });
    }
    let mut n_answered = 0;
    while let Some(status) = sent.join_next().await {
        let status = status.unwrap();
        assert!([200, 202, 409, 503].contains(&status), "{status}");
        n_answered += usize::from(status < 300);
    }
    assert!(n_answered >= 4, "{n_answered} were answered");
    let grown = program.peak_memory_bytes() - before;
    assert!(grown < MOST, "{} MiB more", grown >> 20);
    // Whoever waits is served; the document is whole.
    let read: Value = client.get(url(&path)).send().await.unwrap().json().await.unwrap();
    assert_eq!(read["subjects"].as_array().unwrap().len(), N_SUBJECTS);
    assert_eq!(read["subjects"][7]["id"], "s7");
}
