//! Requests whose process died in the middle.

use crate::faults::site::{Backend, Site};
use crate::jobs_support::form;
use crate::patience::PATIENCE;
use serde_json::json;
use std::time::{Duration, Instant};

#[tokio::test]
async fn an_idempotency_key_is_free_soon_after_its_process_was_killed() {
    let site = Site::open(Backend::Sqlite);
    let mut node = site.serve(&["--workers", "0"]);
    let client = site.client(&node);
    let send = |base: &str, source: &str| {
        let request = client.http.post(format!("{base}/v1/jobs")).header("idempotency-key", "one");
        request.multipart(form(source, "target", &json!({}))).send()
    };
    // The check of this input takes 30 s.
    let slow = tokio::spawn(send(&node.base, "slow"));
    tokio::time::sleep(Duration::from_secs(13)).await;
    let again = send(&node.base, "slow").await.unwrap();
    assert_eq!(again.status(), 409, "the key is kept as long as the request is carried out");
    node.kill();
    assert!(slow.await.unwrap().is_err());

    let node = site.serve(&["--workers", "0"]);
    let began = Instant::now();
    loop {
        let status = send(&node.base, "source").await.unwrap().status().as_u16();
        if status == 202 {
            break;
        }
        assert_eq!(status, 422, "while it is reserved, another request is refused");
        assert!(began.elapsed() < PATIENCE, "{:?}", began.elapsed());
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
}
