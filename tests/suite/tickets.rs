//! Tickets for browsers: one path below which events and downloads can be read, for one tenant, for a minute, and never
//! logged.

use super::encryption::command;
use super::faults::client::{id_of, steps};
use super::faults::on_both;
use super::faults::site::{Backend, SOON, Site};
use super::jobs_support::{form, problem};
use futures_util::StreamExt as _;
use serde_json::{Value, json};

on_both!(a_ticket_reads_one_resource_of_one_tenant_for_a_minute, a_tenant_has_a_thousand_tickets_at_a_time);

async fn key(site: &Site, tenant: &str) -> String {
    let (code, said) = command(site, &["keys", "create", "--tenant", tenant]).await;
    assert_eq!(code, Some(0), "{said}");
    said.split_whitespace().find(|word| word.starts_with("hml_")).unwrap().to_owned()
}

async fn a_ticket_reads_one_resource_of_one_tenant_for_a_minute(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--auth", "keys"]);
    let http = site.client(&node).http;
    let (owner, other) = (key(&site, "owner").await, key(&site, "other").await);
    let submit = async || {
        let sent = http.post(format!("{}/v1/jobs", node.base)).bearer_auth(&owner);
        id_of(&sent.multipart(form("a", "b", &steps(2, 1))).send().await.unwrap().json().await.unwrap())
    };
    let (job, another) = (submit().await, submit().await);
    let began = std::time::Instant::now();
    for id in [&job, &another] {
        loop {
            let got = http.get(format!("{}/v1/jobs/{id}", node.base)).bearer_auth(&owner).send().await.unwrap();
            if got.json::<Value>().await.unwrap()["state"] == "succeeded" {
                break;
            }
            assert!(began.elapsed() < SOON);
            tokio::time::sleep(std::time::Duration::from_millis(50)).await;
        }
    }
    let ask = async |key: &str, path: &str| {
        let sent = http.post(format!("{}/v1/tickets", node.base)).bearer_auth(key).json(&json!({"path": path}));
        let answer = sent.send().await.unwrap();
        let status = answer.status().as_u16();
        (status, answer.json::<Value>().await.unwrap()["ticket"].as_str().unwrap_or_default().to_owned())
    };
    let get = async |path: &str, ticket: &str| {
        let answer = http.get(format!("{}{path}?ticket={ticket}", node.base)).send().await.unwrap();
        (answer.status().as_u16(), answer.text().await.unwrap())
    };
    let of = |id: &str, rest: &str| format!("/v1/jobs/{id}{rest}");

    let (status, whole) = ask(&owner, &of(&job, "")).await;
    assert!(status == 201 && whole.starts_with("hmt_"), "{status} {whole}");
    let (status, events) = get(&of(&job, "/events"), &whole).await;
    assert!(status == 200 && events.contains("event: done"), "{events}");
    for download in ["/result", "/correspondences"] {
        assert_eq!(get(&of(&job, download), &whole).await.0, 200, "{download}");
    }
    let (_, narrow) = ask(&owner, &of(&job, "/events")).await;
    assert_eq!(get(&of(&job, "/events"), &narrow).await.0, 200);

    // Refused: other paths, resources that are neither events nor downloads, and changes.
    assert_eq!(get(&of(&job, "/result"), &narrow).await.0, 401);
    for path in
        [of(&another, "/events"), of(&another, "/result"), of(&job, ""), of(&job, "/trace"), "/v1/jobs".to_owned()]
    {
        assert_eq!(get(&path, &whole).await.0, 401, "{path}");
    }
    for method in ["POST", "DELETE"] {
        let path = if method == "POST" { of(&job, "/cancel") } else { of(&job, "") };
        let url = format!("{}{path}?ticket={whole}", node.base);
        let sent = http.request(method.parse().unwrap(), url).send().await.unwrap();
        assert_eq!(sent.status(), 401, "{method}");
    }
    let twice = format!("{whole}&ticket={whole}");
    for wrong in ["", "hmt_", &whole[..whole.len() - 1], &whole.to_uppercase(), &twice] {
        assert_eq!(get(&of(&job, "/result"), wrong).await.0, 401, "{wrong}");
    }
    // A ticket of another tenant sees its own jobs only, so this job does not exist.
    let (status, foreign) = ask(&other, &of(&job, "")).await;
    assert_eq!(status, 201, "the answer does not tell whether the job exists");
    assert_eq!(get(&of(&job, "/result"), &foreign).await.0, 404);
    for path in ["", "/v1/jobs", "/v1/keys/0123456789ab", "/v1/jobs/1/events", "https://example.org/"] {
        assert_eq!(ask(&owner, path).await.0, 422, "{path}");
    }
    let unauthenticated = http.post(format!("{}/v1/tickets", node.base)).json(&json!({"path": of(&job, "")}));
    assert_eq!(unauthenticated.send().await.unwrap().status(), 401);

    // Neither logged nor stored.
    let log = node.log();
    let (_, audit) = command(&site, &["audit", "export"]).await;
    for (place, text) in [("log", &log), ("audit log", &audit)] {
        assert!(!text.contains("hmt_") && !text.contains(&whole[4..]), "a ticket is in the {place}");
    }
    assert!(audit.contains("create_ticket") && audit.contains("get_result"), "{audit}");
    let database = site.database().await;
    assert!(database.texts("SELECT hash FROM tickets").await.iter().all(|hash| !whole.contains(hash.as_str())));

    // A ticket ends after its time, and with the key that requested it.
    let (_, brief) = ask(&owner, &of(&job, "")).await;
    database.execute("UPDATE tickets SET expires_at = 0").await;
    for ticket in [&whole, &brief] {
        assert_eq!(get(&of(&job, "/result"), ticket).await.0, 401, "it has expired");
    }
    let (_, last) = ask(&owner, &of(&job, "")).await;
    assert_eq!(get(&of(&job, "/result"), &last).await.0, 200);
    assert_eq!(command(&site, &["keys", "revoke", &owner]).await.0, Some(0));
    assert_eq!(get(&of(&job, "/result"), &last).await.0, 401, "its key is revoked");
}

async fn a_tenant_has_a_thousand_tickets_at_a_time(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "0", "--auth", "keys"]);
    let http = site.client(&node).http;
    let (owner, other) = (key(&site, "owner").await, key(&site, "other").await);
    let path = json!({"path": "/v1/jobs/0198c0de-0000-7000-8000-000000000000"});
    let ask = async |key: &str| {
        http.post(format!("{}/v1/tickets", node.base)).bearer_auth(key).json(&path).send().await.unwrap()
    };
    let database = site.database().await;
    let filled = "WITH RECURSIVE n(k) AS (SELECT 1 UNION ALL SELECT k + 1 FROM n WHERE k < 980) \
                  INSERT INTO tickets (hash, tenant, key_id, path, expires_at) \
                  SELECT 'filled-' || k, 'owner', NULL, '/v1/jobs/1', 9999999999999 FROM n";
    database.execute(filled).await;
    // The limit also holds for concurrent requests.
    let answers = futures_util::stream::iter(0..40).map(|_| ask(&owner)).buffer_unordered(8);
    let statuses: Vec<u16> = answers.map(|answer| answer.status().as_u16()).collect().await;
    let counted = [201, 429].map(|status| statuses.iter().filter(|s| **s == status).count());
    assert_eq!(counted, [20, 20]);
    let refused = ask(&owner).await;
    assert_eq!(refused.headers()["retry-after"], "60");
    let refused = problem(refused, 429, "too-many-requests").await;
    assert!(refused["detail"].as_str().unwrap().contains("1000 tickets"), "{refused}");
    assert_eq!(ask(&other).await.status(), 201, "it is a limit of each tenant");
    database.execute("UPDATE tickets SET expires_at = 0").await;
    assert_eq!(ask(&owner).await.status(), 201, "tickets that have expired do not count");
}
