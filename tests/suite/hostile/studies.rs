//! Studies of many subjects and covariates, read by many clients at once, and probes during these reads.

use crate::faults::site::{Backend, Program, Site};
use crate::jobs_support::TestService;
use crate::patience::PATIENCE;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

const N_SUBJECTS: usize = 1000;
const N_COVARIATES: usize = 256;
/// Concurrent reads.
const N_READS: usize = 200;
/// Concurrent reads, and the same number of concurrent decisions.
const N_AT_ONCE: usize = 60;
/// Default memory of all answers that are not streamed.
const STOCK: u64 = 256 << 20;
/// Most additional memory of the process after the study was stored: the stock of answers, and the same amount again.
const MOST: u64 = 512 << 20;

/// The status and the document of a probe.
fn probe(address: &str, path: &str) -> (u16, String) {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(PATIENCE)).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    let status = answer.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap();
    (status, answer)
}

/// A runtime whose only thread is busy answers no requests; the probes have a separate thread.
#[tokio::test]
async fn probes_are_answered_while_nothing_else_is() {
    let service = TestService::start(&["--workers", "0", "--probe-listen", "127.0.0.1:0"]).await;
    // Both have started once both answer.
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
        // A blocking sleep, so that the runtime's thread does nothing else.
        std::thread::sleep(Duration::from_millis(5));
        assert!(began.elapsed() < PATIENCE, "no probe is answered");
    }
    let (answers, is_silent) = asking.join().unwrap();
    assert_eq!(answers, [200, 200, 200]);
    assert!(is_silent, "the thread of the clients was not busy");
    service.end().await;
}

/// A service with a study of [`N_SUBJECTS`] subjects that no worker computes.
struct LargeStudy {
    program: Program,
    client: reqwest::Client,
    /// The address of its probes.
    probes: String,
    /// Path of the study.
    path: String,
    _site: Site,
}

impl LargeStudy {
    async fn stored() -> Self {
        let site = Site::open(Backend::Sqlite);
        let probes = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().to_string();
        let limits = ["--workers", "0", "--max-batch", "1000", "--max-queue", "100000", "--probe-listen", &probes];
        let program = site.program(&limits);
        homolog::tls::prepare();
        let client = reqwest::Client::builder().timeout(Duration::from_secs(120)).build().unwrap();
        let url = |path: &str| format!("{}{path}", program.base);
        let mesh = homolog_formats::write_ply(&ellipsoid(Vector3::new(9.0, 7.0, 5.0), 3));
        let sent = client.post(url("/v1/meshes")).header("content-type", "application/octet-stream").body(mesh);
        let mesh: Value = sent.send().await.unwrap().json().await.unwrap();
        let covariates: Value = (0..N_COVARIATES)
            .map(|k| (format!("covariate_{k:03}"), json!(k)))
            .collect::<serde_json::Map<_, _>>()
            .into();
        let subjects: Vec<Value> = (0..N_SUBJECTS)
            .map(|k| json!({"id": format!("s{k}"), "input": {"mesh_id": mesh["id"]}, "covariates": covariates}))
            .collect();
        let study = json!({"subjects": subjects, "template": {"mesh_id": mesh["id"]}});
        let sent = client.post(url("/v1/studies")).json(&study).send().await.unwrap();
        let (status, study): (u16, Value) = (sent.status().as_u16(), sent.json().await.unwrap());
        assert_eq!(status, 202, "{study}");
        let path = format!("/v1/studies/{}", study["id"].as_str().unwrap());
        LargeStudy { program, client, probes, path, _site: site }
    }

    fn url(&self, below: &str) -> String {
        format!("{}{}{below}", self.program.base, self.path)
    }

    /// The status and the document of an answer.
    async fn get(&self, below: &str) -> (u16, Value) {
        let answer = self.client.get(self.url(below)).send().await.unwrap();
        (answer.status().as_u16(), answer.json().await.unwrap())
    }

    /// The statuses of concurrent requests while probes are answered, and the additional memory of the service.
    async fn all_at_once(&self, requests: Vec<reqwest::RequestBuilder>) -> (Vec<u16>, u64) {
        let before = self.program.peak_memory_bytes();
        let (stop, probes) = (Arc::new(AtomicBool::new(false)), self.probes.clone());
        let prober = std::thread::spawn({
            let stop = Arc::clone(&stop);
            move || {
                let mut n_probes = 0;
                while !stop.load(Ordering::Relaxed) {
                    for path in ["/healthz", "/readyz"] {
                        let (status, answer) = probe(&probes, path);
                        assert_eq!(status, 200, "{answer}");
                        n_probes += 1;
                    }
                    std::thread::sleep(Duration::from_millis(50));
                }
                n_probes
            }
        });
        let mut sent = tokio::task::JoinSet::new();
        for request in requests {
            sent.spawn(async move {
                let answer = request.send().await.unwrap();
                let status = answer.status().as_u16();
                let _whole = answer.bytes().await.unwrap();
                status
            });
        }
        let statuses = sent.join_all().await;
        stop.store(true, Ordering::Relaxed);
        assert!(prober.join().unwrap() > 0, "no probe was answered");
        (statuses, self.program.peak_memory_bytes() - before)
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_large_study_is_read_by_many_at_once_within_the_stock_and_in_pages() {
    let study = LargeStudy::stored().await;
    let reads =
        (0..N_READS).map(|k| study.client.get(study.url(if k % 2 == 0 { "" } else { "/subjects?page_size=500" })));
    let (statuses, grown) = study.all_at_once(reads.collect()).await;
    // A request that gets no memory within the waiting time is told to come again.
    assert!(statuses.iter().all(|status| [200, 503].contains(status)), "{statuses:?}");
    let n_served = statuses.iter().filter(|status| **status == 200).count();
    assert!(n_served >= N_READS / 4, "{n_served} were served");
    assert!(grown < STOCK, "{} MiB more", grown >> 20);

    let (status, document) = study.get("").await;
    assert_eq!((status, document["subjects"].as_array().unwrap().len()), (200, 500));
    assert!(document["parameters"].is_object() && document["n_subjects"] == N_SUBJECTS);
    let list = document["links"]["subjects"].as_str().unwrap().strip_prefix(&study.path).unwrap().to_owned();
    let (mut ids, mut query) = (Vec::new(), "?page_size=300".to_owned());
    loop {
        let (status, page) = study.get(&format!("{list}{query}")).await;
        assert_eq!(status, 200, "{page}");
        ids.extend(
            page["subjects"].as_array().unwrap().iter().map(|subject| subject["id"].as_str().unwrap().to_owned()),
        );
        let Some(token) = page["next_page_token"].as_str() else { break };
        query = format!("?page_size=300&page_token={token}");
    }
    assert_eq!(ids, (0..N_SUBJECTS).map(|k| format!("s{k}")).collect::<Vec<_>>());

    let (status, followed) = study.get("?fields=id,state,progress").await;
    let members: Vec<&String> = followed.as_object().unwrap().keys().collect();
    assert_eq!((status, members), (200, vec![&"id".to_owned(), &"progress".to_owned(), &"state".to_owned()]));
    for wrong in ["?fields=covariates", "/subjects?page_token=x", "/subjects?page_size=501"] {
        assert_eq!(study.get(wrong).await.0, 400, "{wrong}");
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_large_study_is_read_and_decided_on_by_many_at_once_in_little_memory() {
    let study = LargeStudy::stored().await;
    let decided = json!({"decision": "kept", "reason": "seen"});
    let requests = (0..N_AT_ONCE).flat_map(|k| {
        let decision = study.url(&format!("/subjects/s{k}/decision"));
        [study.client.get(study.url("")), study.client.put(decision).json(&decided)]
    });
    let (statuses, grown) = study.all_at_once(requests.collect()).await;
    assert!(statuses.iter().all(|status| [200, 202, 409, 503].contains(status)), "{statuses:?}");
    let n_answered = statuses.iter().filter(|status| **status < 300).count();
    assert!(n_answered >= 4, "{n_answered} were answered");
    assert!(grown < MOST, "{} MiB more", grown >> 20);
    // Waiting requests are served, and the decisions are stored.
    let (status, read) = study.get("").await;
    assert_eq!(status, 200, "{read}");
    let subjects = read["subjects"].as_array().unwrap();
    assert_eq!(subjects[7]["id"], "s7");
    assert!(subjects.iter().any(|subject| subject["decision"] == "kept"), "no decision was recorded");
}
