//! One word and one shape for one thing, in jobs, batches and studies: tags, references to inputs, and what is said of faults.

use super::jobs_support::{TestService, form, problem};
use reqwest::Response;
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};
use std::time::Duration;

async fn post(service: &TestService, path: &str, body: &Value) -> Response {
    service.client.post(format!("{}{path}", service.base)).json(body).send().await.unwrap()
}

async fn accepted(response: Response) -> Value {
    let status = response.status();
    let body: Value = response.json().await.unwrap();
    assert!(status == 202 || status == 201, "{status}: {body}");
    body
}

async fn upload(service: &TestService, content: &str) -> String {
    let sent =
        service.client.post(format!("{}/v1/meshes", service.base)).body(content.to_owned()).send().await.unwrap();
    accepted(sent).await["id"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn tags_have_their_former_name_for_a_release() {
    let service = TestService::start(&["--workers", "0"]).await;
    let mesh = json!({"mesh_id": upload(&service, "a").await});
    for name in ["tags", "labels"] {
        let text = json!({"site": "x"}).to_string();
        let of_form = accepted(service.send(form("a", "b", &json!({})).text(name, text)).await).await;
        let of_json =
            accepted(post(&service, "/v1/jobs", &json!({"source": mesh, "target": mesh, name: {"site": "x"}})).await)
                .await;
        let pair = json!({"source": mesh, "target": mesh, name: {"side": "left"}});
        let batch = accepted(post(&service, "/v1/batches", &json!({"pairs": [pair], name: {"site": "x"}})).await).await;
        let path = format!("/v1/batches/{}/jobs", batch["id"].as_str().unwrap());
        let of_batch = service.json(&path).await["jobs"][0].clone();
        for document in [&of_form, &of_json, &batch] {
            assert_eq!(
                (&document["tags"], &document["labels"]),
                (&json!({"site": "x"}), &json!({"site": "x"})),
                "{name}"
            );
        }
        assert_eq!(of_batch["tags"], json!({"site": "x", "side": "left"}), "{name}");
    }
    for (query, n) in [("tag=site:x", 6), ("label=site:x", 6), ("tag=site:x&label=side:left", 2), ("tag=side:right", 0)]
    {
        assert_eq!(service.json(&format!("/v1/jobs?{query}")).await["jobs"].as_array().unwrap().len(), n, "{query}");
    }
    let refused = problem(service.get("/v1/jobs?tag=x").await, 400, "invalid-query").await;
    assert_eq!(refused["errors"][0]["pointer"], "/query/tag");

    // Both at once would leave open which one counts.
    let both = form("a", "b", &json!({})).text("tags", "{\"a\": \"1\"}").text("labels", "{\"a\": \"2\"}");
    let refused = problem(service.send(both).await, 422, "invalid-request").await;
    assert_eq!(refused["errors"][0]["pointer"], "/labels");
    let both = json!({"source": mesh, "target": mesh, "tags": {"a": "1"}, "labels": {"a": "2"}});
    let refused = problem(post(&service, "/v1/jobs", &both).await, 422, "invalid-request").await;
    assert_eq!(refused["errors"][0]["pointer"], "/labels");
    assert!(refused["errors"][0]["detail"].as_str().unwrap().contains("former name of tags"), "{refused}");
    // A fault is at the name that was sent.
    for name in ["tags", "labels"] {
        let wrong = json!({"source": mesh, "target": mesh, name: {"": "x"}});
        let refused = problem(post(&service, "/v1/jobs", &wrong).await, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], format!("/{name}"));
    }
    service.end().await;
}

#[tokio::test]
async fn inputs_have_one_shape_in_jobs_and_batches() {
    let service = TestService::start(&["--workers", "0"]).await;
    let (a, b) = (upload(&service, "a").await, upload(&service, "b").await);
    let small = json!({"content_base64": "c21hbGw=", "file_name": "Jane Doe.ply"});
    let (by_id, other) = (json!({"mesh_id": a}), json!({"mesh_id": b}));

    // A template and its subjects: uploads and small files.
    let batch = json!({"template": by_id, "subjects": [{"input": other}, {"input": small}]});
    let batch = accepted(post(&service, "/v1/batches", &batch).await).await;
    let nothing = json!({"template": null, "pairs": [{"source": by_id, "target": other}]});
    accepted(post(&service, "/v1/batches", &nothing).await).await;
    let jobs = service.json(&format!("/v1/batches/{}/jobs", batch["id"].as_str().unwrap())).await;
    let jobs = jobs["jobs"].as_array().unwrap();
    assert!(jobs.len() == 2 && jobs.iter().all(|job| job["target"]["hash"] == a.as_str()), "{jobs:?}");
    assert_eq!(jobs[0]["source"]["hash"], b.as_str());
    assert_eq!(jobs[1]["source"]["n_bytes"], 5);

    // Pairs, and files of a form, which are named by the document and not stored under these names.
    let file = |content: &str, name: &str| Part::bytes(content.as_bytes().to_vec()).file_name(name.to_owned());
    let document = |pairs: Value| Form::new().text("document", json!({"pairs": pairs}).to_string());
    let pair = |source: Value, target: Value| json!({"source": source, "target": target});
    let send = async |form: Form| {
        service.client.post(format!("{}/v1/batches", service.base)).multipart(form).send().await.unwrap()
    };
    let pairs =
        json!([pair(json!({"upload": "Jane Doe.ply"}), by_id.clone()), pair(small, json!({"upload": "Jane Doe.ply"}))]);
    let made = accepted(send(document(pairs).part("files", file("c", "Jane Doe.ply"))).await).await;
    let jobs = service.json(&format!("/v1/batches/{}/jobs", made["id"].as_str().unwrap())).await;
    assert_eq!(jobs["jobs"][0]["source"]["hash"], jobs["jobs"][1]["target"]["hash"]);
    assert!(!jobs.to_string().contains("Jane"), "{jobs}");
    let missing = document(json!([pair(json!({"upload": "no.ply"}), by_id.clone())]));
    let refused = problem(send(missing).await, 422, "invalid-request").await;
    assert_eq!(refused["errors"][0]["pointer"], "/pairs/0/source/upload");
    let bad = document(json!([pair(json!({"upload": "bad"}), by_id)])).part("files", file("bad", "bad"));
    let refused = problem(send(bad).await, 422, "unsuitable-batch").await;
    assert_eq!(refused["errors"][0]["pointer"], "/pairs/0/source");
    service.end().await;
}

#[tokio::test]
async fn faults_say_the_field_and_its_shape() {
    let service = TestService::start(&["--workers", "0"]).await;
    let id = upload(&service, "a").await;
    let mesh = json!({"mesh_id": id});
    let shape = "an object with mesh_id, the id of an upload, or content_base64";
    for (path, body, pointer, code, detail) in [
        ("jobs", json!({"source": id, "target": mesh}), "/source", "wrong_form", shape),
        ("jobs", json!({"source": mesh}), "/target", "missing", shape),
        (
            "jobs",
            json!({"source": {"mesh": id}, "target": mesh}),
            "/source/mesh",
            "unknown_field",
            "mesh_id, content_base64",
        ),
        ("jobs", json!({"source": [], "target": mesh}), "/source", "wrong_form", "not a list"),
        (
            "jobs",
            json!({"source": mesh, "target": mesh, "priority": "high"}),
            "/priority",
            "wrong_form",
            "must be an integer, not a string",
        ),
        (
            "jobs",
            json!({"source": mesh, "target": mesh, "tags": {"a": 1}}),
            "/tags/a",
            "wrong_form",
            "must be a string, not a number",
        ),
        ("batches", json!({"template": 7, "subjects": [{"input": mesh}]}), "/template", "wrong_form", shape),
        (
            "batches",
            json!({"template": mesh, "subjects": [{"external_ref": "x"}]}),
            "/subjects/0/input",
            "missing",
            shape,
        ),
        (
            "batches",
            json!({"template": mesh, "subjects": [{"input": {}}]}),
            "/subjects/0/input",
            "out_of_range",
            "exactly one of mesh_id",
        ),
        (
            "batches",
            json!({"template": mesh, "subjects": [id]}),
            "/subjects/0",
            "wrong_form",
            "must be a JSON object, not a string",
        ),
        ("batches", json!({"pairs": [{"source": mesh}]}), "/pairs/0/target", "missing", shape),
        ("batches", json!({"pairs": {"source": mesh}}), "/pairs", "wrong_form", "not an object"),
        (
            "batches",
            json!({"template": mesh, "template_as": "both", "subjects": [{"input": mesh}]}),
            "/template_as",
            "out_of_range",
            "must be target or source",
        ),
        ("studies", json!({"subjects": [{"id": "s", "input": id}]}), "/subjects/0/input", "wrong_form", shape),
        ("studies", json!({"subjects": [{"input": mesh}]}), "/subjects/0/id", "missing", "is required"),
        (
            "studies",
            json!({"subjects": [{"id": "s", "input": mesh, "role": "x"}]}),
            "/subjects/0/role",
            "out_of_range",
            "must be model or score",
        ),
        (
            "studies",
            json!({"subjects": [{"id": "s", "input": mesh, "covariates": {"age": []}}]}),
            "/subjects/0/covariates/age",
            "wrong_form",
            "a number, a string or null",
        ),
        ("studies", json!({"subjects": [], "template": id}), "/template", "wrong_form", shape),
    ] {
        let refused = problem(post(&service, &format!("/v1/{path}"), &body).await, 422, "invalid-request").await;
        let fault = &refused["errors"][0];
        assert_eq!((&fault["pointer"], &fault["code"]), (&json!(pointer), &json!(code)), "{body}: {fault}");
        let said = fault["detail"].as_str().unwrap();
        assert!(said.contains(detail), "{body}: {said}");
        for word in ["`", "struct", "variant", "invalid type", "i32", "sequence", " map"] {
            assert!(!said.contains(word), "{body}: {said}");
        }
    }
    service.end().await;
}

#[tokio::test]
async fn jobs_have_parameters_only_if_these_are_asked_for() {
    let service = TestService::start(&[]).await;
    let sent = accepted(service.send(form("a", "b", &json!({"seed": 3, "points": 2}))).await).await;
    assert_eq!((sent.get("parameters"), &sent["seed"]), (None, &json!(3)));
    let path = format!("/v1/jobs/{}", sent["id"].as_str().unwrap());
    service.until_final(sent["id"].as_str().unwrap()).await;
    for place in ["/v1/jobs", path.as_str()] {
        let job = |document: Value| if place == "/v1/jobs" { document["jobs"][0].clone() } else { document };
        assert!(job(service.json(place).await).get("parameters").is_none());
        let whole = job(service.json(&format!("{place}?fields=*")).await);
        assert_eq!((&whole["parameters"]["seed"], &whole["state"]), (&json!(3), &json!("succeeded")));
        let named = job(service.json(&format!("{place}?fields=id,parameters")).await);
        assert_eq!(named.as_object().unwrap().len(), 2, "{named}");
        let slim = job(service.json(&format!("{place}?fields=id,state")).await);
        assert_eq!(slim, json!({"id": sent["id"], "state": "succeeded"}));
        let refused = problem(service.get(&format!("{place}?fields=color")).await, 400, "invalid-query").await;
        assert_eq!(refused["errors"][0]["pointer"], "/query/fields");
    }
    let events = async |query: &str| {
        let reading = service.get(&format!("{path}/events{query}")).await.text();
        let text = tokio::time::timeout(Duration::from_secs(20), reading).await.unwrap().unwrap();
        let done = text.split("\n\n").find(|block| block.contains("event: done")).unwrap().to_owned();
        let data = done.lines().find_map(|line| line.strip_prefix("data:")).unwrap().to_owned();
        serde_json::from_str::<Value>(&data).unwrap()
    };
    assert!(events("").await.get("parameters").is_none());
    assert_eq!(events("?fields=*").await["parameters"]["seed"], 3);
    assert_eq!(events("?fields=state").await, json!({"state": "succeeded"}));
    service.end().await;
}

/// Parts of the contract in which a label is an anatomical structure of a volume, or the former name of a tag.
const OF_LABELS: [&str; 23] = [
    "BatchDocument",
    "BatchSubmissionDocument",
    "InputParameters",
    "JobDocument",
    "LabelChoice",
    "MeshForm",
    "PairDocument",
    "PartialInputParameters",
    "PartialSideParameters",
    "ScoreSubmissionDocument",
    "SideParameters",
    "StudyDocument",
    "StudyResultDocument",
    "StudySubjectDocument",
    "StudySubjectStateDocument",
    "StudySubmissionDocument",
    "SubjectDocument",
    "SubmissionDocument",
    "SubmissionForm",
    "SurfaceKind",
    "Correspondences",
    "UnreliableReason",
    "VolumeInspection",
];

/// Names of members, and texts, with the word label.
fn labels_in(value: &Value, path: &str, found: &mut Vec<String>) {
    let has = |text: &str| text.to_lowercase().contains("label");
    match value {
        Value::Object(members) => {
            for (name, member) in members.iter().filter(|(name, _)| *name != "example" && *name != "examples") {
                if has(name) || member.as_str().is_some_and(has) {
                    found.push(format!("{path}/{name}"));
                }
                labels_in(member, &format!("{path}/{name}"), found);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| {
            if value.as_str().is_some_and(has) {
                found.push(path.to_owned());
            }
            labels_in(value, path, found);
        }),
        _ => {}
    }
}

#[test]
fn a_label_is_anatomical_and_never_a_target_vertex() {
    let contract = include_str!("../../api/openapi.json");
    let contract: Value = serde_json::from_str(contract).unwrap();
    let mut wrong = Vec::new();
    for (name, schema) in contract["components"]["schemas"].as_object().unwrap() {
        if !OF_LABELS.contains(&name.as_str()) {
            labels_in(schema, name, &mut wrong);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    let energy = &contract["components"]["schemas"]["EnergyDocument"]["properties"];
    assert!(energy["n_target_vertices"].is_object() && energy.get("n_labels").is_none());
    let point = &contract["components"]["schemas"]["TracePoint"]["properties"];
    assert!(point["vertices_changed"].is_object() && point.get("labels_changed").is_none());
}
