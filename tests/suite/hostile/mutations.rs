//! Valid requests with random damage: tokens, cursors, headers, multipart and JSON bodies. Every answer is below 500,
//! and a refusal is a problem document.

use crate::jobs_support::TestService;
use rand_core::Rng as _;
use rand_core::SeedableRng as _;
use rand_xoshiro::Xoshiro256PlusPlus;
use reqwest::header::{HeaderName, HeaderValue};
use reqwest::{Method, RequestBuilder};
use serde_json::json;
use std::time::Duration;

/// Requests of each kind.
const N: u32 = 150;

struct Chance(Xoshiro256PlusPlus);

impl Chance {
    fn below(&mut self, n: usize) -> usize {
        (self.0.next_u64() % n.max(1) as u64) as usize
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// Bytes with up to four of them changed, removed, doubled or replaced by others that matter to parsers.
    fn damaged(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        for _ in 0..=self.below(4) {
            let at = self.below(bytes.len());
            match self.below(6) {
                0 if !bytes.is_empty() => bytes[at] = self.below(256) as u8,
                1 if !bytes.is_empty() => drop(bytes.remove(at)),
                2 => bytes.insert(at, self.one_of(b"\0\r\n\"\\{}[]:,;=%&+-.0eE\xff\xc3")),
                3 => {
                    let end = (at + self.below(40)).min(bytes.len());
                    let part = bytes[at.min(end)..end].to_vec();
                    bytes.splice(at..at, part);
                }
                4 => bytes.truncate(at),
                _ => {
                    let number = self.one_of(&["-1", "1e999", "99999999999999999999", "NaN", "null", "\u{202e}"]);
                    bytes.splice(at..at, number.bytes());
                }
            }
        }
        bytes
    }

    /// As [`Self::damaged`], for the value of a header, which has no control characters.
    fn damaged_header(&mut self, text: &str) -> HeaderValue {
        let mut bytes = self.damaged(text.as_bytes());
        bytes.retain(|byte| *byte == b'\t' || (*byte >= 32 && *byte != 127));
        HeaderValue::from_bytes(&bytes).unwrap()
    }
}

/// Bytes as encoded in a path or a query.
fn encoded(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("%{byte:02X}")).collect()
}

async fn check(what: &str, request: RequestBuilder) {
    let request = request.timeout(Duration::from_secs(10)).build().unwrap();
    let said = format!("{what}: {} {} {:?}", request.method(), request.url(), request.headers());
    let answer = reqwest::Client::new().execute(request).await.unwrap_or_else(|error| panic!("{said}: {error}"));
    let status = answer.status().as_u16();
    assert!(status < 500, "{said}: {status} {}", answer.text().await.unwrap_or_default());
    if status >= 400 {
        assert_eq!(answer.headers()["content-type"], "application/problem+json", "{said}: {status}");
    }
}

#[tokio::test]
async fn damaged_requests_are_answered_and_never_with_an_internal_error() {
    let service = TestService::start(&["--workers", "0", "--max-queue", "100000"]).await;
    let guarded = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let mut chance = Chance(Xoshiro256PlusPlus::seed_from_u64(20_261_122));
    let job = service.submit(json!({})).await;
    let url = |path: &str| format!("{}{path}", service.base);
    let cursor = format!("19ab2c3d4e5.{job}");
    let lists = ["/v1/jobs", "/v1/batches", "/v1/meshes", "/v1/keys", "/v1/webhooks", "/v1/changes"];
    for _ in 0..N {
        let token = encoded(&chance.damaged(cursor.as_bytes()));
        let path = format!("{}?page_size=2&page_token={token}", chance.one_of(&lists));
        check("cursor", service.client.get(url(&path))).await;

        let id = encoded(&chance.damaged(job.as_bytes()));
        let end = chance.one_of(&["", "/result", "/trace", "/cancel", "/retry", "/events", "/correspondences"]);
        let method = if ["/cancel", "/retry"].contains(&end) { Method::POST } else { Method::GET };
        check("id", service.client.request(method, url(&format!("/v1/jobs/{id}{end}")))).await;

        let (name, value) = chance.one_of(&[
            ("if-none-match", "W/\"0123456789abcdef-1\", \"x\""),
            ("accept", "text/csv;q=0.8, application/json;q=0.2, */*;q=0.1"),
            ("prefer", "respond-async, wait=0"),
            ("traceparent", "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"),
            ("x-request-id", "abc-1.2:3"),
            ("last-event-id", "7"),
            ("content-type", "multipart/form-data; boundary=----x"),
            ("content-encoding", "gzip, identity"),
            ("origin", "http://localhost:8080"),
            ("range", "bytes=0-1,5-9"),
        ]);
        let (header, damaged) = (HeaderName::from_static(name), chance.damaged_header(value));
        let method = chance.one_of(&["GET", "POST"]).parse::<Method>().unwrap();
        let path = chance.one_of(&["/v1/jobs", "/v1/meshes", "/v1/keys", "/v1/methods"]);
        check("header", service.client.request(method, url(path)).header(header, damaged)).await;

        let key = format!("Bearer hml_3f9a1c07be52_{}", "0a".repeat(32));
        let bearer = chance.damaged_header(&key);
        let guarded_url = format!("{}/v1/jobs", guarded.base);
        check("key", guarded.client.get(guarded_url).header("authorization", bearer)).await;

        let json = json!({
            "source": {"mesh_id": format!("blake3:{}", "0a".repeat(32))}, "target": {"content_base64": "YQ=="},
            "parameters": {"points": 1, "seed": 7}, "tags": {"study": "x"}, "priority": -3, "deadline_at": "2030-01-01T00:00:00Z",
        });
        let body = chance.damaged(json.to_string().as_bytes());
        let path = chance.one_of(&["/v1/jobs", "/v1/batches", "/v1/webhooks", "/v1/keys"]);
        check("json", service.client.post(url(path)).header("content-type", "application/json").body(body)).await;

        let part = |name: &str, more: &str, content: &str| {
            format!("------x\r\ncontent-disposition: form-data; name=\"{name}\"{more}\r\n\r\n{content}\r\n")
        };
        let form = [
            part("source", "; filename=\"a.nii.gz\"", "source"),
            part("target", "; filename=\"b.ply\"", "target"),
            part("parameters", "", "{\"points\": 1}"),
            part("tags", "", "{\"study\": \"x\"}"),
            "------x--\r\n".to_owned(),
        ]
        .concat();
        let body = chance.damaged(form.as_bytes());
        let multipart = service.client.post(url(chance.one_of(&["/v1/jobs", "/v1/meshes"])));
        check("form", multipart.header("content-type", "multipart/form-data; boundary=----x").body(body)).await;
    }
    assert_eq!(service.json(&format!("/v1/jobs/{job}")).await["id"], job.as_str());
    guarded.end().await;
    service.end().await;
}
