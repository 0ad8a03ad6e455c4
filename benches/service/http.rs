//! The service over HTTP: submissions, polling while all cores compute, followers of one job.

use crate::node::{Node, SPINNERS};
use crate::place::Place;
use crate::{Latencies, Scale};
use serde_json::{Value, json};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::net::TcpStream;
use tokio::task::JoinSet;

const CLIENTS: usize = 8;
const POLLERS: u64 = 50;
/// Time between two requests of a poller.
const POLL: Duration = Duration::from_millis(200);

/// A persistent connection. As little code as possible: it shares the cores with the service that it measures.
pub(crate) struct Client {
    stream: BufReader<TcpStream>,
}

impl Client {
    pub(crate) async fn connect(address: &str) -> Self {
        let stream = TcpStream::connect(address).await.unwrap();
        stream.set_nodelay(true).unwrap();
        Client { stream: BufReader::new(stream) }
    }

    /// Sends a request and returns status and body.
    pub(crate) async fn request(&mut self, method: &str, path: &str, media_type: &str, body: &[u8]) -> (u16, Vec<u8>) {
        let mut request = head(method, path, media_type, body.len() as u64);
        request.extend_from_slice(body);
        self.stream.write_all(&request).await.unwrap();
        let (status, length) = self.answer_head().await;
        let mut answer = vec![0; length];
        self.stream.read_exact(&mut answer).await.unwrap();
        (status, answer)
    }

    /// Sends a body of `n` repetitions of `part`.
    pub(crate) async fn send_parts(&mut self, path: &str, part: &[u8], n: u64) -> (u16, Vec<u8>) {
        let request = head("POST", path, "application/octet-stream", part.len() as u64 * n);
        self.stream.write_all(&request).await.unwrap();
        for _ in 0..n {
            self.stream.write_all(part).await.unwrap();
        }
        let (status, length) = self.answer_head().await;
        let mut answer = vec![0; length];
        self.stream.read_exact(&mut answer).await.unwrap();
        (status, answer)
    }

    async fn answer_head(&mut self) -> (u16, usize) {
        let (mut status, mut length, mut line) = (0, 0, String::new());
        loop {
            line.clear();
            assert!(self.stream.read_line(&mut line).await.unwrap() > 0, "the service closed the connection");
            let text = line.trim_end().to_ascii_lowercase();
            if let Some(code) = text.strip_prefix("http/1.1 ") {
                status = code[..3].parse().unwrap();
            } else if let Some(n) = text.strip_prefix("content-length: ") {
                length = n.parse().unwrap();
            } else if text.is_empty() {
                return (status, length);
            }
        }
    }

    async fn submit(&mut self, source: &str, target: &str, parameters: &Value) -> String {
        let part = |name: &str, file: &str, content: &str| {
            format!("--b\r\nContent-Disposition: form-data; name=\"{name}\"{file}\r\n\r\n{content}\r\n")
        };
        let body = part("source", "; filename=\"s.ply\"", source)
            + &part("target", "; filename=\"t.ply\"", target)
            + &part("parameters", "", &parameters.to_string())
            + "--b--\r\n";
        let (status, answer) =
            self.request("POST", "/v1/jobs", "multipart/form-data; boundary=b", body.as_bytes()).await;
        assert_eq!(status, 202, "{}", String::from_utf8_lossy(&answer));
        serde_json::from_slice::<Value>(&answer).unwrap()["id"].as_str().unwrap().to_owned()
    }

    /// Submits a job that is computed even if it equals an earlier one, and returns it as soon as it has finished.
    pub(crate) async fn submit_and_wait(&mut self, source: &[u8], target: &[u8], parameters: &Value) -> Value {
        let mut body = Vec::new();
        for (name, file, content) in [
            ("source", "; filename=\"s.ply\"", source),
            ("target", "; filename=\"t.ply\"", target),
            ("parameters", "", parameters.to_string().as_bytes()),
            ("use_cache", "", b"false".as_slice()),
        ] {
            let head = format!("--b\r\nContent-Disposition: form-data; name=\"{name}\"{file}\r\n\r\n");
            body.extend_from_slice(head.as_bytes());
            body.extend_from_slice(content);
            body.extend_from_slice(b"\r\n");
        }
        body.extend_from_slice(b"--b--\r\n");
        let form = "multipart/form-data; boundary=b\r\nPrefer: wait=30";
        let (mut status, mut answer) = self.request("POST", "/v1/jobs", form, &body).await;
        loop {
            assert!(status < 300, "{}", String::from_utf8_lossy(&answer));
            let job: Value = serde_json::from_slice(&answer).unwrap();
            if !["queued", "running"].contains(&job["state"].as_str().unwrap()) {
                return job;
            }
            let path = format!("/v1/jobs/{}?wait=30", job["id"].as_str().unwrap());
            (status, answer) = self.request("GET", &path, "", b"").await;
        }
    }

    async fn until_state(&mut self, id: &str, wanted: &[&str]) {
        loop {
            let (_, body) = self.request("GET", &format!("/v1/jobs/{id}"), "", b"").await;
            let job: Value = serde_json::from_slice(&body).unwrap();
            if wanted.contains(&job["state"].as_str().unwrap()) {
                return;
            }
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    }
}

fn head(method: &str, path: &str, media_type: &str, length: u64) -> Vec<u8> {
    let mut head = format!("{method} {path} HTTP/1.1\r\nHost: localhost\r\n");
    if method != "GET" {
        head += &format!("Content-Type: {media_type}\r\nContent-Length: {length}\r\n");
    }
    (head + "\r\n").into_bytes()
}

pub(crate) async fn submissions(scale: Scale) {
    println!("\n## Durable submissions over HTTP\n");
    println!(
        "`POST /v1/jobs` as a form with two files of 20 bytes, {CLIENTS} clients, {:?} each; files in a",
        scale.time()
    );
    println!("folder with fsync. New files are written before the job; held files are already stored.\n");
    println!("| store | files | workers | submissions/s | p50 ms | p99 ms |\n|---|---|---|---|---|---|");
    for postgres in [false, true] {
        for (files, workers) in [("new", "0"), ("new", "1"), ("held", "0")] {
            let place = if postgres { Place::postgres() } else { Some(Place::sqlite()) };
            let Some(place) = place else { continue };
            let mut environment = place.environment();
            let more = [("HOMOLOG_WORKERS", workers), ("HOMOLOG_MAX_QUEUE", "1000000"), ("HOMOLOG_MAX_UPLOADS", "8")];
            environment.extend(more.map(|(name, value)| (name, value.to_owned())));
            let node = Node::start(&environment);
            let number = Arc::new(AtomicU64::new(0));
            let mut tasks = JoinSet::new();
            let began = Instant::now();
            for _ in 0..CLIENTS {
                let (number, mut client) = (Arc::clone(&number), Client::connect(&node.address).await);
                tasks.spawn(async move {
                    let mut taken = Vec::new();
                    while began.elapsed() < scale.time() {
                        let n = number.fetch_add(1, Ordering::Relaxed);
                        let name = if files == "new" { n } else { 0 };
                        let (source, target) = (format!("source{name:014}"), format!("target{name:014}"));
                        let one = Instant::now();
                        client.submit(&source, &target, &json!({"seed": n})).await;
                        taken.push(one.elapsed().as_secs_f64());
                    }
                    taken
                });
            }
            let all = Latencies::new(tasks.join_all().await.concat());
            let rate = all.count() as f64 / began.elapsed().as_secs_f64();
            let (p50, p99) = (all.ms(0.5), all.ms(0.99));
            println!("| {} | {files} | {workers} | {rate:.0} | {p50:.2} | {p99:.2} |", place.name());
        }
    }
}

pub(crate) async fn polling(scale: Scale) {
    println!("\n## Polling while all cores compute\n");
    println!(
        "`GET /v1/jobs/{{id}}` of one job by {POLLERS} clients, each every {POLL:?}, over {:?}, on",
        scale.time() * 2
    );
    println!(
        "the same cores. \"A job\": the service runs a job that keeps rayon's threads busy. \"Unyielding\": as many"
    );
    println!(
        "threads as cores compute in the process at normal priority, as a match would without its own priority.\n"
    );
    println!("| store | computing | requests | p50 ms | p90 ms | p99 ms | max ms | target p99 |");
    println!("|---|---|---|---|---|---|---|---|");
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    for place in Place::all() {
        for computing in ["nothing", "a job", "unyielding"] {
            let mut environment = place.environment();
            if computing == "unyielding" {
                environment.push((SPINNERS, cores.to_string()));
            }
            let node = Node::start(&environment);
            let mut first = Client::connect(&node.address).await;
            let burn_ms = if computing == "a job" { 3_600_000 } else { 0 };
            let parameters = json!({"burn_ms": burn_ms, "seed": computing});
            let id = first.submit("s", "t", &parameters).await;
            first.until_state(&id, &[if burn_ms > 0 { "running" } else { "succeeded" }]).await;
            let path = format!("/v1/jobs/{id}");
            let mut tasks = JoinSet::new();
            let (began, time) = (Instant::now(), scale.time() * 2);
            for poller in 0..POLLERS {
                let (mut client, path) = (Client::connect(&node.address).await, path.clone());
                tasks.spawn(async move {
                    let mut taken = Vec::new();
                    tokio::time::sleep(POLL.mul_f64(poller as f64 / POLLERS as f64)).await;
                    let mut ticks = tokio::time::interval(POLL);
                    while began.elapsed() < time {
                        ticks.tick().await;
                        let one = Instant::now();
                        let (status, _) = client.request("GET", &path, "", b"").await;
                        taken.push(one.elapsed().as_secs_f64());
                        assert_eq!(status, 200);
                    }
                    taken
                });
            }
            let all = Latencies::new(tasks.join_all().await.concat());
            let verdict = if all.ms(0.99) < 5.0 { "met" } else { "missed" };
            println!(
                "| {} | {computing} | {} | {:.2} | {:.2} | {:.2} | {:.1} | {verdict} |",
                place.name(),
                all.count(),
                all.ms(0.5),
                all.ms(0.9),
                all.ms(0.99),
                all.ms(1.0)
            );
            if burn_ms > 0 {
                // Otherwise the next process would run it again. The first connection has been closed as idle.
                let mut first = Client::connect(&node.address).await;
                first.request("POST", &format!("{path}/cancel"), "application/json", b"").await;
                first.until_state(&id, &["cancelled"]).await;
            }
        }
    }
}

pub(crate) async fn followers(scale: Scale) {
    let points = scale.pick(10, 200);
    println!("\n## Followers of one job\n");
    println!(
        "`GET /v1/jobs/{{id}}/events` of a job that writes {points} trace points in {} s. Delay: from the last event of",
        points * 25 / 1000
    );
    println!("the first follower to the last event of the last one. Transactions: those of the database in that time,");
    println!("including the worker's.\n");
    println!("| store | followers | all events | delay ms | transactions | memory before MiB | max MiB |");
    println!("|---|---|---|---|---|---|---|");
    for place in Place::all() {
        for n_followers in [1, scale.pick(20, 1_000)] {
            let mut environment = place.environment();
            environment.push(("HOMOLOG_MAX_CONNECTIONS", "4096".to_owned()));
            let node = Node::start(&environment);
            let mut first = Client::connect(&node.address).await;
            let before = node.status_mib("VmRSS");
            // Another job runs first, so that all followers can connect before theirs starts.
            let blocker = first.submit("s", "t", &json!({"points": 1, "step_ms": 2_000, "seed": n_followers})).await;
            first.until_state(&blocker, &["running"]).await;
            let transactions = n_transactions(&place).await;
            let parameters = json!({"points": points, "step_ms": 25, "seed": n_followers});
            let id = first.submit("s", "t", &parameters).await;
            let path = format!("/v1/jobs/{id}/events");
            let mut tasks = JoinSet::new();
            for _ in 0..n_followers {
                let (address, path) = (node.address.clone(), path.clone());
                tasks.spawn(async move {
                    let mut client = Client::connect(&address).await;
                    client.stream.write_all(&head("GET", &path, "", 0)).await.unwrap();
                    let (mut n_points, mut line) = (0_u64, String::new());
                    loop {
                        line.clear();
                        if client.stream.read_line(&mut line).await.unwrap() == 0 {
                            panic!("the stream broke off");
                        }
                        n_points += u64::from(line.starts_with("event: trace"));
                        if line.starts_with("event: done") {
                            return (n_points, Instant::now());
                        }
                    }
                });
            }
            let seen = tasks.join_all().await;
            let first_done = seen.iter().map(|(_, at)| *at).min().unwrap();
            let last_done = seen.iter().map(|(_, at)| *at).max().unwrap();
            let complete = seen.iter().filter(|(n, _)| *n == points).count();
            let transactions = match (transactions, n_transactions(&place).await) {
                (Some(before), Some(after)) => (after - before).to_string(),
                _ => "not counted".to_owned(),
            };
            println!(
                "| {} | {n_followers} | {complete} of {n_followers} | {:.0} | {transactions} | {before:.0} | {:.0} |",
                place.name(),
                (last_done - first_done).as_secs_f64() * 1e3,
                node.status_mib("VmHWM")
            );
        }
    }
}

/// Number of transactions so far, as counted by PostgreSQL; SQLite has no such counter.
async fn n_transactions(place: &Place) -> Option<i64> {
    if !place.is_postgres() {
        return None;
    }
    // Sessions report their statistics with a delay of about a second.
    tokio::time::sleep(Duration::from_millis(1_500)).await;
    Some(place.database().await.number("SELECT SUM(xact_commit)::BIGINT FROM pg_stat_database").await)
}
