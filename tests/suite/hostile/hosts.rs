//! Web pages that reach a service which requires no authentication.

use crate::faults::site::{Backend, SOON, Site};
use crate::jobs_support::{TestService, form, problem};
use serde_json::json;

#[tokio::test]
async fn without_authentication_no_web_page_is_answered_whatever_the_address() {
    let arguments = ["--listen", "0.0.0.0:0", "--auth", "none", "--insecure", "--allowed-host", "imaging.example"];
    let service = TestService::start(&arguments).await;
    let id = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    for path in ["/v1/jobs".to_owned(), format!("/v1/jobs/{id}"), "/metrics".to_owned()] {
        let get = |host: &str| service.client.get(format!("{}{path}", service.base)).header("host", host.to_owned());
        for host in ["evil.example", "0.0.0.0", "10.0.0.1:8080"] {
            problem(get(host).send().await.unwrap(), 403, "host-not-allowed").await;
        }
        for host in ["localhost", "127.0.0.1", "Imaging.Example:8080"] {
            assert_eq!(get(host).send().await.unwrap().status(), 200, "{path} {host}");
        }
    }
    let foreign =
        |path: &str| service.client.post(format!("{}{path}", service.base)).header("origin", "https://evil.example");
    problem(foreign(&format!("/v1/jobs/{id}/cancel")).send().await.unwrap(), 403, "host-not-allowed").await;
    let submitted = foreign("/v1/jobs").multipart(form("a", "b", &json!({}))).send().await.unwrap();
    problem(submitted, 403, "host-not-allowed").await;
    assert_ne!(service.json(&format!("/v1/jobs/{id}")).await["cancel_requested"], true);
    // Supervisors name the service by any address.
    for path in ["/healthz", "/readyz"] {
        let probe = service.client.get(format!("{}{path}", service.base)).header("host", "10.1.2.3:8080");
        assert_eq!(probe.send().await.unwrap().status(), 200, "{path}");
    }
    service.end().await;
}

#[tokio::test]
async fn allowed_hosts_are_never_ignored() {
    let arguments = ["--listen", "0.0.0.0:0", "--auth", "keys", "--allowed-host", "imaging.example"];
    let service = TestService::start(&arguments).await;
    let get = |host: &str| service.client.get(format!("{}/v1/jobs", service.base)).header("host", host.to_owned());
    problem(get("evil.example").send().await.unwrap(), 403, "host-not-allowed").await;
    problem(get("imaging.example").send().await.unwrap(), 401, "unauthenticated").await;
    service.end().await;
}

#[tokio::test]
async fn a_service_that_is_open_to_others_says_so_at_every_start() {
    let site = Site::open(Backend::Sqlite);
    for _ in 0..2 {
        let node = site.serve(&["--workers", "0", "--listen", "0.0.0.0:0", "--auth", "none", "--insecure"]);
        node.until_logged("no authentication is required, and other machines can reach the service", SOON).await;
    }
    let node = site.serve(&["--workers", "0"]);
    assert!(!node.log().contains("no authentication is required"));
}
