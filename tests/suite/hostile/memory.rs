//! Memory that one request takes from the process.

use crate::faults::client::Client;
use crate::faults::site::{Backend, Site};
use reqwest::Response;

/// Size of the hostile bodies, just below the limit for JSON.
const BODY: usize = 31 << 20;
/// Most memory of the process during any of these requests: its own, the body, and a copy of the body while it is
/// received.
const MOST: u64 = 400 << 20;

/// `head`, then as many copies of `entry` as fit, then `tail`.
fn filled(head: &str, entry: &str, tail: &str) -> String {
    let n = (BODY - head.len() - tail.len()) / entry.len();
    [head, entry.repeat(n).trim_end_matches(','), tail].concat()
}

async fn post(client: &Client, path: &str, body: String) -> Response {
    let request = client.http.post(format!("{}{path}", client.base)).header("content-type", "application/json");
    request.body(body).send().await.unwrap()
}

#[tokio::test]
async fn a_json_body_of_millions_of_values_takes_little_memory() {
    let site = Site::open(Backend::Sqlite);
    let node = site.serve(&["--workers", "0"]);
    let client = site.client(&node);
    let values = filled(r#"{"source":{},"target":{},"parameters":{"x":["#, r#"{"":0},"#, "]}}");
    let texts = filled(r#"{"pairs":[],"parameters":{"x":["#, r#""","#, "]}}");
    let deep = filled(r#"{"source":{},"target":{},"parameters":{"x":["#, r#"[[[]]],"#, "]}}");
    for (path, body) in
        [("/v1/jobs", values.clone()), ("/v1/batches", values), ("/v1/batches", texts), ("/v1/jobs", deep)]
    {
        let answer = post(&client, path, body).await;
        let (status, text) = (answer.status().as_u16(), answer.text().await.unwrap());
        assert!([413, 422].contains(&status) && text.len() < 4_000, "{path}: {status} {text}");
        let peak = node.peak_memory_bytes();
        assert!(peak < MOST, "{path}: {} MiB", peak >> 20);
    }
}

#[tokio::test]
async fn lists_and_labels_of_any_length_take_little_memory() {
    let site = Site::open(Backend::Sqlite);
    let node = site.serve(&["--workers", "0"]);
    let client = site.client(&node);
    let tags: String = (0..2_000_000).map(|i| format!("\"{i}\":\"\",")).collect();
    let tags = &tags[..tags.len() - 1];
    for (path, body) in [
        ("/v1/jobs", format!(r#"{{"source":{{}},"target":{{}},"tags":{{{tags}}}}}"#)),
        ("/v1/batches", format!(r#"{{"pairs":[],"tags":{{{tags}}}}}"#)),
        ("/v1/batches", filled(r#"{"template":{},"subjects":["#, r#"{"input":{},"tags":{"a":""}},"#, "]}")),
        ("/v1/batches", filled(r#"{"pairs":["#, r#"{"source":{},"target":{}},"#, "]}")),
    ] {
        let answer = post(&client, path, body).await;
        let (status, text) = (answer.status().as_u16(), answer.text().await.unwrap());
        assert!([413, 422].contains(&status) && text.len() < 8_000, "{path}: {status} {text}");
        let peak = node.peak_memory_bytes();
        assert!(peak < MOST, "{path}: {} MiB", peak >> 20);
    }
}

#[tokio::test]
async fn bodies_that_are_read_at_the_same_time_share_one_stock_of_memory() {
    let site = Site::open(Backend::Sqlite);
    // Enough memory for two bodies of 31 MiB, each counted as raw and decoded; enough for one body of a single client.
    let node = site.serve(&["--workers", "0", "--max-body-memory-bytes", "134217728", "--max-file-bytes", "16777216"]);
    let client = site.client(&node);
    let body = filled(r#"{"source":{"content_base64":""#, "AAAA", r#""},"target":{}}"#);
    let mut sent = tokio::task::JoinSet::new();
    for _ in 0..16 {
        let (client, body) = (client.clone(), body.clone());
        sent.spawn(async move { post(&client, "/v1/jobs", body).await.status().as_u16() });
    }
    let mut statuses = Vec::new();
    while let Some(status) = sent.join_next().await {
        statuses.push(status.unwrap());
    }
    assert!(statuses.iter().all(|status| [422, 503].contains(status)), "{statuses:?}");
    assert!(statuses.iter().filter(|status| **status == 422).count() >= 2, "{statuses:?}");
    let peak = node.peak_memory_bytes();
    assert!(peak < MOST, "{} MiB", peak >> 20);
}

/// Uploads `n_bytes` and returns the path of their content.
async fn upload(client: &Client, n_bytes: usize) -> String {
    let content: Vec<u8> = (0..n_bytes).map(|i| (i / 251 % 251) as u8).collect();
    let request = client.http.post(format!("{}/v1/meshes?inspect=false", client.base)).body(content);
    let location = request.send().await.unwrap().headers()["location"].to_str().unwrap().to_owned();
    format!("{location}/content")
}

#[tokio::test]
async fn readers_of_a_large_upload_take_little_memory_and_one_that_reads_nothing_is_disconnected() {
    use tokio::io::{AsyncReadExt, AsyncWriteExt};
    const SIZE: usize = 60 << 20;
    let site = Site::open(Backend::Sqlite);
    let node = site.serve(&["--workers", "0", "--stall-timeout-s", "3"]);
    let client = site.client(&node);
    let path = upload(&client, SIZE).await;
    let mut readers = Vec::new();
    for _ in 0..40 {
        let mut stream = tokio::net::TcpStream::connect(node.base.strip_prefix("http://").unwrap()).await.unwrap();
        stream.write_all(format!("GET {path} HTTP/1.1\r\nhost: localhost\r\n\r\n").as_bytes()).await.unwrap();
        readers.push(stream);
    }
    tokio::time::sleep(std::time::Duration::from_secs(8)).await;
    let peak = node.peak_memory_bytes();
    assert!(peak < MOST, "{} MiB", peak >> 20);
    for mut reader in readers {
        let mut read = Vec::new();
        let ended = tokio::time::timeout(std::time::Duration::from_secs(20), reader.read_to_end(&mut read)).await;
        assert!(ended.is_ok() && read.len() < SIZE, "{} bytes", read.len());
    }
    let whole = client.get(&path).await.unwrap().bytes().await.unwrap();
    assert_eq!(whole.len(), SIZE, "who reads gets all of it");
}

/// `make memory` in a short form, on the build of the tests.
#[test]
fn the_service_stays_within_its_memory_under_all_attacks_at_once() {
    let script = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/memory");
    let mut command = std::process::Command::new(script);
    command.arg(env!("CARGO_BIN_EXE_homolog")).args(["--only", "api", "--seconds", "8"]);
    let Ok(done) = command.output() else {
        println!("skipped: python3 is not installed");
        return;
    };
    let record = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(done.status.success(), "{record}{}", String::from_utf8_lossy(&done.stderr));
    println!("{record}");
}

#[tokio::test]
async fn ranges_and_lengths_of_an_upload_are_answered() {
    let service = crate::jobs_support::TestService::start(&["--workers", "0"]).await;
    let client = Client::of(&service.base);
    let path = upload(&client, 1_000_000).await;
    let whole = client.get(&path).await.unwrap();
    let etag = whole.headers()["etag"].clone();
    assert_eq!(
        (&whole.headers()["accept-ranges"], &whole.headers()["content-length"]),
        (&"bytes".parse().unwrap(), &"1000000".parse().unwrap())
    );
    let whole = whole.bytes().await.unwrap();
    let head = client.http.head(format!("{}{path}", client.base)).send().await.unwrap();
    assert_eq!((head.status().as_u16(), head.headers()["content-length"].to_str().unwrap()), (200, "1000000"));
    let range = |range: &str, if_range: &str| {
        let request = client.http.get(format!("{}{path}", client.base)).header("range", range.to_owned());
        if if_range.is_empty() { request.send() } else { request.header("if-range", if_range.to_owned()).send() }
    };
    let part = range("bytes=300000-799999", etag.to_str().unwrap()).await.unwrap();
    assert_eq!(
        (part.status().as_u16(), part.headers()["content-range"].to_str().unwrap()),
        (206, "bytes 300000-799999/1000000")
    );
    assert_eq!(part.bytes().await.unwrap(), whole[300_000..800_000]);
    assert_eq!(range("bytes=-5", "").await.unwrap().bytes().await.unwrap(), whole[999_995..]);
    assert_eq!(range("bytes=0-1", "\"other\"").await.unwrap().status(), 200, "another version");
    let beyond = range("bytes=1000000-", "").await.unwrap();
    assert_eq!(beyond.headers()["content-range"], "bytes */1000000");
    crate::jobs_support::problem(beyond, 416, "range-not-satisfiable").await;
    service.end().await;
}

#[tokio::test]
async fn long_texts_are_compressed_for_clients_that_accept_it() {
    let service = crate::jobs_support::TestService::start(&["--workers", "0"]).await;
    let get = |encoding: &str| {
        service
            .client
            .get(format!("{}/openapi.json", service.base))
            .header("accept-encoding", encoding.to_owned())
            .send()
    };
    let plain = get("identity").await.unwrap();
    assert!(!plain.headers().contains_key("content-encoding"));
    let plain = plain.bytes().await.unwrap();
    let compressed = get("gzip").await.unwrap();
    assert_eq!(compressed.headers()["content-encoding"], "gzip");
    let compressed = compressed.bytes().await.unwrap();
    assert!(compressed.len() < plain.len() / 4);
    let mut text = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(&compressed[..]), &mut text).unwrap();
    assert_eq!(text, plain);
    service.end().await;
}
