//! The server loop: slow headers, too many connections, shutdown, and host validation.

use super::jobs_support::{TestService, form, problem};
use crate::patience::PATIENCE;
use serde_json::json;
use std::time::{Duration, Instant};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::time::timeout;

async fn connect(service: &TestService) -> TcpStream {
    TcpStream::connect(service.base.strip_prefix("http://").unwrap()).await.unwrap()
}

/// A request, after whose answer the connection stays open.
const PING: &[u8] = b"GET /healthz HTTP/1.1\r\nhost: localhost\r\n\r\n";

/// Sends a request and reads its answer to the end of its body.
async fn ping(stream: &mut TcpStream) -> String {
    stream.write_all(PING).await.unwrap();
    answer(stream).await
}

async fn answer(stream: &mut TcpStream) -> String {
    let mut text = Vec::new();
    while !text.ends_with(b"}") {
        let n = stream.read_buf(&mut text).await.unwrap();
        assert!(n > 0, "closed after {:?}", String::from_utf8_lossy(&text));
    }
    String::from_utf8(text).unwrap()
}

/// Reads until the server closes the connection; returns what it sent.
async fn until_closed(stream: &mut TcpStream) -> Vec<u8> {
    let mut rest = Vec::new();
    // A reset closes the connection too.
    let _ = timeout(PATIENCE, stream.read_to_end(&mut rest)).await.expect("still open");
    rest
}

#[tokio::test]
async fn slow_headers_and_idle_connections_are_closed_at_their_timeout() {
    let service = TestService::start(&["--header-timeout-s", "1"]).await;
    let began = Instant::now();
    let (mut silent, mut half, mut trickle, mut idle) =
        (connect(&service).await, connect(&service).await, connect(&service).await, connect(&service).await);
    half.write_all(b"GET /healthz HTTP/1.1\r\nhos").await.unwrap();
    let dripping = tokio::spawn(async move {
        for byte in PING.iter().cycle() {
            if trickle.write_all(&[*byte]).await.is_err() {
                break;
            }
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    });
    assert!(ping(&mut idle).await.starts_with("HTTP/1.1 200"));
    for stream in [&mut silent, &mut half, &mut idle] {
        until_closed(stream).await;
    }
    let elapsed = began.elapsed();
    assert!(elapsed > Duration::from_millis(900), "{elapsed:?}");
    timeout(PATIENCE, dripping).await.expect("a byte now and then gains no time").unwrap();
    assert_eq!(service.json("/healthz").await["status"], "alive");
    service.end().await;
}

#[tokio::test]
async fn connections_beyond_the_limit_wait_for_one_to_close() {
    let service = TestService::start(&["--max-connections", "2", "--workers", "0"]).await;
    let (mut first, mut second) = (connect(&service).await, connect(&service).await);
    ping(&mut first).await;
    ping(&mut second).await;
    let mut third = connect(&service).await;
    third.write_all(PING).await.unwrap();
    let mut byte = [0];
    assert!(timeout(Duration::from_millis(300), third.read(&mut byte)).await.is_err(), "it waits");
    ping(&mut second).await;
    drop(first);
    let served = timeout(PATIENCE, answer(&mut third)).await.expect("served when another closes");
    assert!(served.starts_with("HTTP/1.1 200"), "{served}");
    drop((second, third));
    service.end().await;
}

#[tokio::test]
async fn idle_connections_do_not_delay_shutdown() {
    let service = TestService::start(&["--header-timeout-s", "120"]).await;
    let (mut idle, silent) = (connect(&service).await, connect(&service).await);
    ping(&mut idle).await;
    let began = Instant::now();
    service.end().await;
    assert!(began.elapsed() < Duration::from_secs(60), "it waited for idle connections: {:?}", began.elapsed());
    assert!(until_closed(&mut idle).await.is_empty());
    drop(silent);
}

#[tokio::test]
async fn requests_in_progress_are_answered_before_shutdown() {
    let service = TestService::start(&["--workers", "0"]).await;
    let id = service.submit(json!({})).await;
    let mut waiting = connect(&service).await;
    let request = format!("GET /v1/jobs/{id}?wait=30 HTTP/1.1\r\nhost: localhost\r\n\r\n");
    waiting.write_all(request.as_bytes()).await.unwrap();
    tokio::time::sleep(Duration::from_millis(300)).await;
    let base = service.base.clone();
    service.end().await;
    let answer = String::from_utf8(until_closed(&mut waiting).await).unwrap();
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains(&id), "{answer}");
    assert!(TcpStream::connect(base.strip_prefix("http://").unwrap()).await.is_err(), "the port is closed");
}

#[tokio::test]
async fn a_request_that_never_ends_is_cut_off_at_shutdown() {
    let service = TestService::start(&["--stall-timeout-s", "120"]).await;
    let mut stuck = connect(&service).await;
    let head = "POST /v1/jobs HTTP/1.1\r\nhost: localhost\r\ncontent-type: multipart/form-data; boundary=x\r\ncontent-length: 1000\r\n\r\n--x\r\n";
    stuck.write_all(head.as_bytes()).await.unwrap();
    tokio::time::sleep(Duration::from_millis(200)).await;
    let began = Instant::now();
    service.end().await;
    assert!(began.elapsed() < Duration::from_secs(60), "it waited for the body: {:?}", began.elapsed());
    until_closed(&mut stuck).await;
}

#[tokio::test]
async fn only_host_names_of_this_machine_are_accepted() {
    let service = TestService::start(&["--allowed-host", "imaging.example", "--workers", "0"]).await;
    let get = |host: &str| service.client.get(format!("{}/v1/jobs", service.base)).header("host", host.to_owned());
    for host in ["localhost", "localhost:1234", "127.0.0.1", "127.1.2.3:80", "[::1]:8080", "Imaging.Example:443"] {
        assert_eq!(get(host).send().await.unwrap().status(), 200, "{host}");
    }
    for host in ["rebound.example", "rebound.example:8080", "10.0.0.1", "localhost.rebound.example"] {
        problem(get(host).send().await.unwrap(), 403, "host-not-allowed").await;
    }
    let page = |origin: &str| get("localhost").header("origin", origin.to_owned());
    assert_eq!(page("http://localhost:3000").send().await.unwrap().status(), 200);
    for origin in ["https://page.example", "null", "http://127.0.0.1.page.example"] {
        problem(page(origin).send().await.unwrap(), 403, "host-not-allowed").await;
    }
    let submit = service.client.post(format!("{}/v1/jobs", service.base)).header("origin", "http://page.example");
    problem(submit.multipart(form("a", "b", &json!({}))).send().await.unwrap(), 403, "host-not-allowed").await;
    assert_eq!(service.json("/v1/jobs").await["jobs"], json!([]), "nothing was submitted");
    service.end().await;
}

#[tokio::test]
async fn a_service_that_requires_keys_accepts_any_host_name() {
    let service = TestService::start(&["--listen", "0.0.0.0:0"]).await;
    let request = service.client.get(format!("{}/v1/jobs", service.base)).header("host", "imaging.example");
    problem(request.send().await.unwrap(), 401, "unauthenticated").await;
    service.end().await;
}

#[tokio::test]
async fn what_is_no_http_is_answered_with_an_empty_body_as_documented() {
    let service = TestService::start(&["--workers", "0"]).await;
    let long = "a".repeat(70_000);
    let many: String = (0..101).map(|n| format!("x-{n}: 1\r\n")).collect();
    for (request, status) in [
        ("nonsense\r\n\r\n".to_owned(), 400),
        ("GET /healthz HTTP/1.1\r\nhost localhost\r\n\r\n".to_owned(), 400),
        ("GET /healthz HTTP/1.1\r\nhost: localhost\r\ncontent-length: 1\r\ncontent-length: 2\r\n\r\n".to_owned(), 400),
        (format!("GET /{long} HTTP/1.1\r\nhost: localhost\r\n\r\n"), 414),
        (format!("GET /healthz HTTP/1.1\r\nhost: localhost\r\n{many}\r\n"), 431),
    ] {
        let mut stream = connect(&service).await;
        stream.write_all(request.as_bytes()).await.unwrap();
        let answer = String::from_utf8(until_closed(&mut stream).await).unwrap();
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")), "{answer}");
        assert!(answer.ends_with("\r\n\r\n"), "an empty body: {answer}");
    }
    assert_eq!(service.json("/healthz").await["status"], "alive");
    service.end().await;
}

#[tokio::test]
async fn heads_that_are_too_long_are_problems_and_what_is_no_http_ends_its_connection_only() {
    let service = TestService::start(&["--workers", "0"]).await;
    let long = |n: usize| "x".repeat(n);
    let refused = problem(service.get(&format!("/v1/jobs?tag={}", long(17 << 10))).await, 414, "target-too-long").await;
    assert_eq!(refused["limit_bytes"], 16 << 10);
    let with_headers = service.client.get(format!("{}/v1/jobs", service.base)).header("x-a", long(40 << 10));
    let refused =
        problem(with_headers.header("x-b", long(30 << 10)).send().await.unwrap(), 431, "headers-too-large").await;
    assert_eq!(refused["limit_bytes"], 64 << 10);
    assert_eq!(service.get(&format!("/healthz?{}", long(15 << 10))).await.status(), 200);

    // hyper's own answers: a status without a body, then the connection is closed.
    let headers: String = (0..101).map(|k| format!("x-{k}: 1\r\n")).collect();
    for (request, status) in [
        ("nonsense\r\n\r\n".to_owned(), 400),
        ("GET /healthz HTTP/1.1\r\nhost localhost\r\n\r\n".to_owned(), 400),
        ("GET /\u{1} HTTP/1.1\r\nhost: localhost\r\n\r\n".to_owned(), 400),
        (format!("GET /{} HTTP/1.1\r\nhost: localhost\r\n\r\n", long(70_000)), 414),
        (format!("GET /healthz HTTP/1.1\r\nhost: localhost\r\n{headers}\r\n"), 431),
        (format!("GET /healthz HTTP/1.1\r\nhost: localhost\r\nx: {}\r\n\r\n", long(500_000)), 431),
    ] {
        let mut stream = connect(&service).await;
        // The connection may be closed before everything is sent.
        let _ = stream.write_all(request.as_bytes()).await;
        let answer = String::from_utf8(until_closed(&mut stream).await).unwrap();
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")), "{status}: {answer}");
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        assert!(
            body.is_empty() && head.contains("content-length: 0") && head.contains("connection: close"),
            "{answer}"
        );
        assert_eq!(service.json("/healthz").await["status"], "alive");
    }
    service.end().await;
}
