//! The rights that the table of operations states, asked of the service.

use super::jobs_support::{TestService, problem};
use super::keys::keys;
use homolog::http::{OPERATIONS, Operation};

/// The answer to a request for an operation without a body, about a resource that does not exist.
async fn send(service: &TestService, row: &Operation, key: Option<&str>) -> reqwest::Response {
    let path: Vec<&str> = row.path.split('/').map(|part| if part.starts_with('{') { "x" } else { part }).collect();
    let request = service.client.request(row.method.clone(), format!("{}{}", service.base, path.join("/")));
    let request = if let Some(key) = key { request.bearer_auth(key) } else { request };
    request.send().await.unwrap()
}

#[tokio::test]
async fn every_operation_asks_for_the_scope_of_its_row_and_no_other_will_do() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let make = |scope| keys(service.folder.path(), &["create", "--tenant", "clinic-a", "--scope", scope]);
    let keys = ["read", "submit", "admin"].map(|scope| (scope, make(scope)));
    for row in OPERATIONS {
        let Some(needed) = row.scope else {
            let status = send(&service, row, None).await.status().as_u16();
            assert!([200, 404].contains(&status), "{}: {status} without a key", row.name);
            continue;
        };
        problem(send(&service, row, None).await, 401, "unauthenticated").await;
        for (scope, key) in &keys {
            let answer = send(&service, row, Some(key)).await;
            if *scope == needed.name() {
                let status = answer.status().as_u16();
                assert!(![401, 403, 405, 500].contains(&status), "{} with {scope}: {status}", row.name);
            } else {
                problem(answer, 403, "scope-missing").await;
            }
        }
    }
    service.end().await;
}
