//! Tags and references: the same limits on every way in.

use crate::faults::on_both;
use crate::faults::site::{Backend, SOON, Site};
use crate::jobs_support::problem;
use serde_json::{Value, json};

on_both!(metadata_has_the_same_limits_on_every_way_in);

async fn metadata_has_the_same_limits_on_every_way_in(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&[]);
    let client = site.client(&node);
    let mesh = client.http.post(format!("{}/v1/meshes", node.base)).body("a mesh").send().await.unwrap();
    let mesh = mesh.json::<Value>().await.unwrap()["id"].clone();
    let many: Value = (0..65).map(|i| (format!("k{i}"), json!(""))).collect::<serde_json::Map<_, _>>().into();
    let wrong = [
        ("external_ref", json!("r".repeat(201))),
        ("external_ref", json!("r".repeat(8_000))),
        ("external_ref", json!("r".repeat(1 << 20))),
        ("external_ref", json!("a\0b")),
        ("labels", many.clone()),
        ("tags", many),
        ("tags", json!({"": "x"})),
        ("tags", json!({"k": "v".repeat(8_000)})),
        ("tags", json!({"k".repeat(257): "v"})),
        ("tags", json!({"k": "a\0b"})),
        ("tags", json!({"a\0b": "v"})),
    ];
    let input = json!({"mesh_id": mesh});
    for (field, value) in &wrong {
        let mut job = json!({"source": input, "target": input});
        job[field] = value.clone();
        let mut batch = json!({"pairs": [{"source": input, "target": input}]});
        batch[field] = value.clone();
        let mut pair = json!({"pairs": [{"source": input, "target": input}, {"source": input, "target": input}]});
        pair["pairs"][1][field] = value.clone();
        let mut subject = json!({"template": input, "subjects": [{"input": input}]});
        subject["subjects"][0][field] = value.clone();
        for (path, body, pointer) in [
            ("/v1/jobs", job, format!("/{field}")),
            ("/v1/batches", batch, format!("/{field}")),
            ("/v1/batches", pair, format!("/pairs/1/{field}")),
            ("/v1/batches", subject, format!("/subjects/0/{field}")),
        ] {
            let answer = client.http.post(format!("{}{path}", node.base)).json(&body).send().await.unwrap();
            let refused = problem(answer, 422, "invalid-request").await;
            assert_eq!(refused["errors"][0]["pointer"], pointer, "{refused}");
        }
    }
    // Together, the tags of a batch and of its pair are limited too.
    let half = |prefix: &str| -> Value {
        (0..40).map(|i| (format!("{prefix}{i}"), json!(""))).collect::<serde_json::Map<_, _>>().into()
    };
    let body = json!({"tags": half("a"), "pairs": [{"source": input, "target": input, "tags": half("b")}]});
    let answer = client.http.post(format!("{}/v1/batches", node.base)).json(&body).send().await.unwrap();
    assert_eq!(problem(answer, 422, "invalid-request").await["errors"][0]["pointer"], "/pairs/0/tags");
    assert!(client.list().await.is_empty(), "nothing was stored");
}

/// An earlier version stored such references; a retry must not copy them.
#[tokio::test]
async fn a_retry_does_not_copy_what_is_not_allowed() {
    let site = Site::open(Backend::Sqlite);
    let node = site.serve(&[]);
    let client = site.client(&node);
    let id = client.submit(json!({})).await;
    client.until_succeeded(&id, SOON).await;
    let options = sqlx::sqlite::SqliteConnectOptions::new().filename(site.data_dir().join("homolog.sqlite"));
    let pool = sqlx::SqlitePool::connect_with(options).await.unwrap();
    let poison = sqlx::query("UPDATE jobs SET external_ref = $1 WHERE id = $2").bind("r".repeat(3 << 20)).bind(&id);
    assert_eq!(poison.execute(&pool).await.unwrap().rows_affected(), 1);
    let answer = client.post(&format!("/v1/jobs/{id}/retry")).await.unwrap();
    let refused = problem(answer, 422, "invalid-request").await;
    assert_eq!(refused["errors"][0]["pointer"], "/external_ref");
    assert_eq!(client.list().await.len(), 1);
}
