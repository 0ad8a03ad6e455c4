//! Clients that send or read so slowly that others would have to wait for them.

use crate::jobs_support::{TestService, form};
use crate::patience::PATIENCE;
use serde_json::json;
use std::io::ErrorKind::WouldBlock;
use std::time::{Duration, Instant};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

/// Sends the beginning of a submission on a connection, and nothing more.
async fn begin_submission(service: &TestService, key: Option<&str>) -> TcpStream {
    let mut stream = TcpStream::connect(service.base.strip_prefix("http://").unwrap()).await.unwrap();
    let key = key.map(|key| format!("authorization: Bearer {key}\r\n")).unwrap_or_default();
    let head = format!(
        "POST /v1/jobs HTTP/1.1\r\nhost: localhost\r\n{key}content-type: multipart/form-data; boundary=x\r\n\
         content-length: 60000000\r\n\r\n--x\r\ncontent-disposition: form-data; name=\"source\"\r\n\r\n"
    );
    stream.write_all(head.as_bytes()).await.unwrap();
    stream
}

/// The status line with which the service ends a connection.
async fn ending(mut stream: TcpStream) -> String {
    let mut text = Vec::new();
    let _ = tokio::time::timeout(PATIENCE, stream.read_to_end(&mut text)).await.expect("it is not ended");
    String::from_utf8_lossy(&text).lines().next().unwrap_or_default().to_owned()
}

#[tokio::test]
async fn slow_uploads_do_not_keep_others_from_submitting() {
    let service = TestService::start(&["--stall-timeout-s", "10", "--max-uploads", "64"]).await;
    let mut slow = Vec::new();
    for _ in 0..8 {
        slow.push(begin_submission(&service, None).await);
    }
    tokio::time::sleep(Duration::from_millis(300)).await;
    service.submit(json!({"seed": 1})).await;
    for stream in &slow {
        assert!(stream.try_read(&mut [0; 1]).is_err_and(|e| e.kind() == WouldBlock), "a slow upload ended first");
    }
    for stream in slow {
        assert_eq!(ending(stream).await, "HTTP/1.1 408 Request Timeout");
    }
    service.end().await;
}

#[tokio::test]
async fn a_trickle_is_ended_like_silence() {
    let service = TestService::start(&["--stall-timeout-s", "1", "--least-rate", "100000"]).await;
    let mut stream = begin_submission(&service, None).await;
    let began = Instant::now();
    while stream.write_all(b"x").await.is_ok() && began.elapsed() < PATIENCE {
        tokio::time::sleep(Duration::from_millis(50)).await;
        let mut answer = [0; 64];
        if let Ok(n) = stream.try_read(&mut answer) {
            assert!(answer[..n].starts_with(b"HTTP/1.1 408"), "{}", String::from_utf8_lossy(&answer));
            break;
        }
    }
    assert!(began.elapsed() < PATIENCE, "it is not ended");
    service.end().await;
}

#[tokio::test]
async fn a_tenant_leaves_half_of_the_uploads_to_others() {
    let service = TestService::start(&["--auth", "keys", "--max-uploads", "4", "--stall-timeout-s", "120"]).await;
    let key = |tenant: &str| {
        let mut command = crate::cli::homolog();
        command.args(["keys", "create", "--tenant", tenant, "--data-dir"]).arg(service.folder.path());
        async move {
            let output = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
            String::from_utf8(output.stdout).unwrap().trim().to_owned()
        }
    };
    let (slow, other) = (key("slow").await, key("other").await);
    let mut streams = Vec::new();
    for _ in 0..6 {
        streams.push(begin_submission(&service, Some(&slow)).await);
    }
    tokio::time::sleep(Duration::from_millis(300)).await;
    let began = Instant::now();
    let request = service.client.post(format!("{}/v1/jobs", service.base)).bearer_auth(other);
    let answer = request.multipart(form("a", "b", &json!({}))).send().await.unwrap();
    assert_eq!(answer.status(), 202);
    assert!(began.elapsed() < Duration::from_secs(60), "it waited for other uploads: {:?}", began.elapsed());
    drop(streams);
    service.end().await;
}
