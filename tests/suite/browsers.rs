//! The needs of browsers and dashboards: pages of other origins, `OPTIONS` and `HEAD` on every route, one stream of
//! events for all jobs, lists with selected members, compressed answers.

use super::clients::{modules, node, said};
use super::encryption::command;
use super::faults::site::{Backend, Site};
use super::jobs_support::{TestService, form, problem};
use super::representations::matched_with;
use reqwest::{Method, Response};
use serde_json::{Value, json};
use std::io::Read as _;
use std::path::Path;
use std::time::Duration;

const PAGE: &str = "https://viewer.example";

async fn asked(service: &TestService, method: Method, path: &str, headers: &[(&str, &str)]) -> Response {
    let mut request = service.client.request(method, format!("{}{path}", service.base));
    for (name, value) in headers {
        request = request.header(*name, *value);
    }
    request.send().await.unwrap()
}

fn header<'r>(response: &'r Response, name: &str) -> &'r str {
    response.headers().get(name).map_or("", |value| value.to_str().unwrap())
}

#[tokio::test]
async fn pages_of_listed_origins_may_use_the_service_and_no_others() {
    let service = TestService::start(&["--workers", "0", "--cors-origin", PAGE]).await;
    let preflight = |origin| {
        let headers = [
            ("origin", origin),
            ("access-control-request-method", "POST"),
            ("access-control-request-headers", "authorization,idempotency-key"),
        ];
        let service = &service;
        async move { asked(service, Method::OPTIONS, "/v1/jobs", &headers).await }
    };
    let permitted = preflight(PAGE).await;
    assert_eq!((permitted.status().as_u16(), header(&permitted, "access-control-allow-origin")), (200, PAGE));
    assert!(header(&permitted, "access-control-allow-headers").contains("authorization"));
    assert!(header(&permitted, "access-control-allow-methods").contains("DELETE"));
    let listed = asked(&service, Method::GET, "/v1/jobs", &[("origin", PAGE)]).await;
    assert_eq!((listed.status().as_u16(), header(&listed, "access-control-allow-origin")), (200, PAGE));
    assert!(header(&listed, "access-control-expose-headers").contains("etag"));
    assert_eq!(header(&listed, "access-control-allow-credentials"), "", "cookies play no part");
    for origin in ["https://evil.example", "https://viewer.example.evil.example", "http://viewer.example", "null"] {
        assert_eq!(header(&preflight(origin).await, "access-control-allow-origin"), "", "{origin}");
        let refused = asked(&service, Method::GET, "/v1/jobs", &[("origin", origin)]).await;
        assert_eq!(header(&refused, "access-control-allow-origin"), "", "{origin}");
        problem(refused, 403, "host-not-allowed").await;
    }
    service.end().await;

    let service = TestService::start(&["--workers", "0"]).await;
    let headers = [("origin", PAGE), ("access-control-request-method", "GET")];
    let off = asked(&service, Method::OPTIONS, "/v1/jobs", &headers).await;
    assert_eq!(header(&off, "access-control-allow-origin"), "", "off by default");
    service.end().await;
}

#[tokio::test]
async fn head_and_options_are_right_on_every_route() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 2})).await;
    service.until_final(&id).await;
    let document: Value = service.json("/openapi.json").await;
    let mut n_got = 0;
    for (template, item) in document["paths"].as_object().unwrap() {
        let of_mesh = template.contains("/meshes/");
        let mesh = format!("blake3:{}", blake3::hash(b"source").to_hex());
        let path = template.replace("{id}", if of_mesh { &mesh } else { &id }).replace("{which}", "source");
        let path = path.replace("{name}", "correspondences.csv").replace("{slug}", "queue-full");
        let options = asked(&service, Method::OPTIONS, &path, &[]).await;
        assert_eq!(options.status(), 204, "OPTIONS {path}");
        let allow: Vec<String> = header(&options, "allow").split(',').map(|method| method.trim().to_owned()).collect();
        for method in ["get", "post", "patch", "delete"] {
            let has = item.get(method).is_some();
            assert_eq!(allow.contains(&method.to_uppercase()), has, "{path}: {method} {allow:?}");
        }
        assert_eq!(allow.contains(&"HEAD".to_owned()), item.get("get").is_some(), "{path}");
        assert_eq!(options.bytes().await.unwrap().len(), 0);
        if item.get("get").is_some() {
            let head = asked(&service, Method::HEAD, &path, &[]).await;
            // Streams end when their client disconnects.
            let got = asked(&service, Method::GET, &path, &[]).await;
            assert_eq!(head.status(), got.status(), "{path}");
            assert_eq!(header(&head, "content-type"), header(&got, "content-type"), "{path}");
            assert_eq!(header(&head, "etag"), header(&got, "etag"), "{path}");
            assert_eq!(head.bytes().await.unwrap().len(), 0, "{path}");
            n_got += usize::from(got.status().is_success());
        }
    }
    assert!(n_got > 15, "{n_got}");
    problem(asked(&service, Method::OPTIONS, "/v1/nothing", &[]).await, 404, "route-not-found").await;
    service.end().await;
}

/// Reads events of a stream until `done` holds for the events so far.
async fn events(mut stream: Response, done: impl Fn(&[(String, Value)]) -> bool) -> Vec<(String, Value)> {
    assert_eq!(stream.status(), 200);
    let mut text = String::new();
    let mut found = Vec::new();
    while !done(&found) {
        let chunk = tokio::time::timeout(Duration::from_secs(20), stream.chunk()).await.expect("an event").unwrap();
        text.push_str(std::str::from_utf8(&chunk.expect("the stream goes on")).unwrap());
        found = text
            .split("\n\n")
            .filter_map(|event| {
                let of = |name: &str| event.lines().find_map(|line| line.strip_prefix(&format!("{name}: ")));
                let data = serde_json::from_str(of("data")?).ok()?;
                Some((format!("{} {}", of("event")?, of("id")?), data))
            })
            .collect();
    }
    found
}

#[tokio::test]
async fn one_stream_has_every_change_of_all_jobs_and_resumes() {
    let service = TestService::start(&[]).await;
    let earlier = service.submit(json!({})).await;
    service.until_final(&earlier).await;
    let states = |found: &[(String, Value)], id: &str| -> Vec<String> {
        let of_job = found.iter().filter(|(_, data)| data["job_id"] == id);
        of_job.map(|(_, data)| data["state"].as_str().unwrap().to_owned()).collect()
    };
    let stream = service.get("/v1/events").await;
    assert_eq!(header(&stream, "content-type"), "text/event-stream");
    let (first, second) = (service.submit(json!({"seed": 1})).await, service.submit(json!({"seed": 2})).await);
    let found =
        events(stream, |found| found.iter().filter(|(_, data)| data["state"] == "succeeded").count() == 2).await;
    assert_eq!(found[0].0, "open 3", "three changes of the earlier job");
    assert!(states(&found, &earlier).is_empty(), "begins now");
    for id in [&first, &second] {
        assert_eq!(states(&found, id), ["queued", "running", "succeeded"]);
    }
    let numbers: Vec<u64> = found[1..].iter().map(|(_, data)| data["seq"].as_u64().unwrap()).collect();
    assert_eq!(numbers, (4..=9).collect::<Vec<u64>>());
    // From the beginning, and from any later event.
    let all = events(service.get("/v1/events?since=0").await, |found| found.len() == 10).await;
    assert_eq!(states(&all, &earlier), ["queued", "running", "succeeded"]);
    let resumed = asked(&service, Method::GET, "/v1/events", &[("last-event-id", "7")]).await;
    let rest = events(resumed, |found| found.len() == 3).await;
    assert_eq!(rest.iter().map(|(id, _)| id.as_str()).collect::<Vec<_>>(), ["open 7", "change 8", "change 9"]);
    problem(asked(&service, Method::GET, "/v1/events", &[("last-event-id", "x")]).await, 400, "bad-request").await;
    problem(service.get("/v1/events?since=-1").await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn lists_have_only_the_members_that_are_asked_for() {
    let service = TestService::start(&["--workers", "0", "--allow-private-webhooks"]).await;
    let id = service.submit(json!({})).await;
    let slim = service.json("/v1/jobs?fields=id,state,links").await;
    let job = &slim["jobs"][0];
    assert_eq!((&job["id"], &job["state"]), (&id.into(), &"queued".into()));
    let members: Vec<&String> = job.as_object().unwrap().keys().collect();
    assert_eq!(members, ["id", "links", "state"]);
    let refused = problem(service.get("/v1/jobs?fields=id,stat").await, 400, "invalid-query").await;
    assert!(refused["errors"][0]["detail"].as_str().unwrap().contains("queue_position"), "{refused}");
    // Every other list omits the members that are not requested, and a refusal names the members that it has.
    let mesh: Value = service
        .client
        .post(format!("{}/v1/meshes", service.base))
        .body("mesh")
        .send()
        .await
        .unwrap()
        .json()
        .await
        .unwrap();
    let batch = json!({"template": {"mesh_id": mesh["id"]}, "subjects": [{"input": {"mesh_id": mesh["id"]}}]});
    let post = async |path: &str, body: &Value| -> Value {
        let sent = service.client.post(format!("{}{path}", service.base)).json(body).send().await.unwrap();
        assert!(sent.status().is_success(), "{path}: {}", sent.status());
        sent.json().await.unwrap()
    };
    let batch = post("/v1/batches", &batch).await;
    let hook = post("/v1/webhooks", &json!({"url": "http://127.0.0.1:9/"})).await;
    let hook = format!("/v1/webhooks/{}", hook["id"].as_str().unwrap());
    service.client.post(format!("{}{hook}/test", service.base)).send().await.unwrap();
    let lists = [
        ("/v1/batches".to_owned(), "batches", "counts,id", "finished"),
        (format!("/v1/batches/{}/jobs", batch["id"].as_str().unwrap()), "jobs", "id,state", "cached"),
        ("/v1/meshes".to_owned(), "meshes", "id,n_bytes", "created_at"),
        ("/v1/webhooks".to_owned(), "webhooks", "id,url", "states"),
        (format!("{hook}/deliveries"), "deliveries", "id,state", "attempts"),
        ("/v1/changes".to_owned(), "changes", "job_id,seq", "state"),
    ];
    for (path, name, fields, other) in lists {
        let whole = service.json(&path).await;
        let slim = service.json(&format!("{path}?fields={fields}")).await;
        let entries = slim[name].as_array().unwrap();
        assert!(!entries.is_empty() && entries.len() == whole[name].as_array().unwrap().len(), "{path}: {slim}");
        for (entry, whole) in entries.iter().zip(whole[name].as_array().unwrap()) {
            let mut members: Vec<&str> = entry.as_object().unwrap().keys().map(String::as_str).collect();
            members.sort_unstable();
            assert_eq!(members.join(","), fields, "{path}: {entry}");
            assert!(members.iter().all(|member| entry[member] == whole[member]), "{path}: {entry}");
        }
        let refused = problem(service.get(&format!("{path}?fields=nothing")).await, 400, "invalid-query").await;
        assert!(refused["errors"][0]["detail"].as_str().unwrap().contains(other), "{path}: {refused}");
    }
    service.end().await;
}

#[tokio::test]
async fn links_lead_somewhere() {
    let (service, job) = matched_with(json!({"method": "balanced"})).await;
    let document = service.json(&job).await;
    let links = document["links"].as_object().unwrap();
    assert!(links.len() >= 11, "{links:?}");
    for (name, link) in links.iter().filter(|(name, _)| *name != "retry") {
        let answer = asked(&service, Method::HEAD, link.as_str().unwrap(), &[]).await;
        assert_eq!(answer.status(), 200, "{name}");
    }
    service.end().await;
}

#[tokio::test]
async fn compressed_answers_are_whole() {
    let (service, job) = matched_with(json!({"method": "rigid"})).await;
    for part in [
        "/correspondences",
        "/result",
        "/report",
        "/correspondences?format=csv",
        "/correspondences?format=arrow",
        "/surfaces/source?format=ply",
        "/surfaces/source?format=stl",
        "/aligned?format=vtk",
        "/warped?format=glb",
        "/files/aligned.ply",
    ] {
        let path = format!("{job}{part}");
        let plain = asked(&service, Method::GET, &path, &[]).await.bytes().await.unwrap();
        let gzip = asked(&service, Method::GET, &path, &[("accept-encoding", "gzip")]).await;
        assert_eq!(header(&gzip, "content-encoding"), "gzip", "{part}");
        let (gzip, mut unpacked) = (gzip.bytes().await.unwrap(), Vec::new());
        flate2::read::GzDecoder::new(&gzip[..]).read_to_end(&mut unpacked).unwrap();
        // Coordinates share few digits, so they compress poorly.
        let is_binary = part.contains("format=") && !part.contains("csv") || part.contains("files");
        let most = if is_binary { plain.len() * 9 / 10 } else { plain.len() / 2 };
        println!("{part}: {} bytes, {} with gzip", plain.len(), gzip.len());
        assert!(unpacked == plain && gzip.len() < most, "{part}: {} of {}", gzip.len(), plain.len());
        let zstd = asked(&service, Method::GET, &path, &[("accept-encoding", "gzip;q=0.5, zstd")]).await;
        assert_eq!(header(&zstd, "content-encoding"), "zstd", "{part}");
        let zstd = zstd.bytes().await.expect("a whole answer");
        assert!(zstd.starts_with(&[0x28, 0xb5, 0x2f, 0xfd]) && zstd.len() < most, "{part}: {}", zstd.len());
    }
    // Formats that are already compressed are not compressed again.
    for part in ["/correspondences?format=npz", "/correspondences?format=parquet", "/files/correspondences.npz"] {
        let answer = asked(&service, Method::GET, &format!("{job}{part}"), &[("accept-encoding", "gzip, zstd")]).await;
        assert!(answer.status() == 200 && !answer.headers().contains_key("content-encoding"), "{part}");
    }
    service.end().await;
}

#[tokio::test]
async fn compressed_downloads_and_ranges_are_not_taken_for_each_other() {
    let service = TestService::start(&["--workers", "0"]).await;
    let content = "v 1.5 2.5 3.5\n".repeat(5_000);
    let upload = async |content: Vec<u8>| {
        let sent = service.client.post(format!("{}/v1/meshes", service.base)).body(content).send().await.unwrap();
        let mesh: Value = sent.json().await.unwrap();
        format!("/v1/meshes/{}/content", mesh["id"].as_str().unwrap())
    };
    let path = upload(content.clone().into_bytes()).await;
    let with = async |headers: &[(&str, &str)]| asked(&service, Method::GET, &path, headers).await;
    let accepts = ("accept-encoding", "gzip");
    let plain = with(&[]).await;
    let strong = header(&plain, "etag").to_owned();
    assert!(strong.starts_with('"') && header(&plain, "accept-ranges") == "bytes", "{strong}");
    let packed = with(&[accepts]).await;
    let weak = header(&packed, "etag").to_owned();
    assert_eq!((header(&packed, "content-encoding"), weak.as_str()), ("gzip", format!("W/{strong}").as_str()));
    assert!(!packed.headers().contains_key("accept-ranges") && !packed.headers().contains_key("content-length"));
    let (packed, mut unpacked) = (packed.bytes().await.unwrap(), Vec::new());
    flate2::read::GzDecoder::new(&packed[..]).read_to_end(&mut unpacked).unwrap();
    assert!(unpacked == content.as_bytes() && packed.len() < content.len() / 10);
    // A range covers the uncompressed bytes, and does not continue a compressed answer.
    let part = with(&[accepts, ("range", "bytes=100-50099"), ("if-range", &strong)]).await;
    assert_eq!((part.status().as_u16(), header(&part, "etag")), (206, strong.as_str()));
    assert_eq!(header(&part, "content-range"), format!("bytes 100-50099/{}", content.len()));
    assert!(!part.headers().contains_key("content-encoding"));
    assert!(header(&part, "vary").contains("accept-encoding"));
    assert_eq!(part.bytes().await.unwrap(), content.as_bytes()[100..50_100]);
    let whole = with(&[accepts, ("range", "bytes=100-50099"), ("if-range", &weak)]).await;
    assert_eq!((whole.status().as_u16(), header(&whole, "content-encoding")), (200, "gzip"));
    // Both copies are current, and each keeps its encoding.
    for known in [&strong, &weak] {
        let same = with(&[accepts, ("if-none-match", known)]).await;
        assert_eq!((same.status().as_u16(), header(&same, "etag")), (304, known.as_str()));
        assert!(header(&same, "vary").contains("accept-encoding"));
    }
    let head = asked(&service, Method::HEAD, &path, &[accepts]).await;
    assert_eq!((header(&head, "content-encoding"), header(&head, "etag")), ("gzip", weak.as_str()));
    assert!(!head.headers().contains_key("content-length"), "that of the other form");
    // A compressed upload is not compressed again.
    let path = upload(packed.to_vec().repeat(40)).await;
    let again = asked(&service, Method::GET, &path, &[accepts]).await;
    assert!(again.status() == 200 && !again.headers().contains_key("content-encoding"));
    service.end().await;
}

#[tokio::test]
async fn files_are_the_parts_in_their_formats() {
    let (service, job) = matched_with(json!({"both_directions": true})).await;
    for (file, part) in [
        ("correspondences.csv", "correspondences?format=csv"),
        ("correspondences.json", "correspondences"),
        ("correspondences-inverse.npy", "correspondences?format=npy&direction=inverse"),
        ("transform.tfm", "transform?format=tfm"),
        ("source.ply", "surfaces/source"),
        ("aligned.stl", "aligned?format=stl"),
        ("warped.vtk", "warped?format=vtk"),
        ("warped-inverse.ply", "warped?direction=inverse"),
        ("report.html", "report"),
    ] {
        let got = service.get(&format!("{job}/files/{file}")).await;
        assert_eq!((got.status().as_u16(), header(&got, "content-type")), (200, "application/octet-stream"), "{file}");
        assert!(header(&got, "content-disposition").starts_with("attachment; filename=\"homolog-"), "{file}");
        assert_eq!(header(&got, "x-content-type-options"), "nosniff");
        let etag = header(&got, "etag").to_owned();
        assert_eq!(
            got.bytes().await.unwrap(),
            service.get(&format!("{job}/{part}")).await.bytes().await.unwrap(),
            "{file}"
        );
        let path = format!("{job}/files/{file}");
        assert_eq!(asked(&service, Method::GET, &path, &[("if-none-match", &etag)]).await.status(), 304, "{file}");
    }
    problem(service.get(&format!("{job}/files/warped.doc")).await, 404, "route-not-found").await;
    problem(service.get(&format!("{job}/files/report.html?format=ply")).await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn a_template_can_be_the_source_of_a_batch() {
    let service = TestService::start(&["--workers", "0"]).await;
    let upload = async |content: &'static str| {
        let sent = service.client.post(format!("{}/v1/meshes", service.base));
        let sent = sent.header("content-type", "application/octet-stream").body(content).send().await.unwrap();
        sent.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
    };
    let (template, subject) = (upload("template").await, upload("subject").await);
    let submit = async |body: Value| {
        service.client.post(format!("{}/v1/batches", service.base)).json(&body).send().await.unwrap()
    };
    for (side, [source, target]) in [
        (Some("source"), [&template, &subject]),
        (Some("target"), [&subject, &template]),
        (None, [&subject, &template]),
    ] {
        let mut body = json!({"template": {"mesh_id": template}, "subjects": [{"input": {"mesh_id": subject}}], "use_cache": false});
        if let Some(side) = side {
            body["template_as"] = side.into();
        }
        let made = submit(body).await;
        assert_eq!(made.status(), 202);
        let links = made.json::<Value>().await.unwrap()["links"].clone();
        let job = service.json(links["jobs"].as_str().unwrap()).await["jobs"][0].clone();
        assert_eq!((&job["source"]["hash"], &job["target"]["hash"]), (&json!(source), &json!(target)), "{side:?}");
        assert_eq!(job["links"]["batch"], links["self"]);
    }
    let pairs =
        json!({"pairs": [{"source": {"mesh_id": template}, "target": {"mesh_id": subject}}], "template_as": "source"});
    problem(submit(pairs).await, 422, "invalid-request").await;
    service.end().await;
}

/// A page of another origin, in Chromium: it fetches, submits and streams, with a key and a ticket, and without
/// credentials where none are required.
#[tokio::test]
#[ignore = "needs chromium and the packages of tests/clients"]
async fn chromium_uses_the_service_from_another_origin() {
    let site = Site::open(Backend::Sqlite);
    let page = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = page.local_addr().unwrap().port();
    drop(page);
    let origin = format!("http://localhost:{port}");
    let folder = tempfile::tempdir().unwrap();
    let (code, made) = command(&site, &["keys", "create", "--init", "--tenant", "clinic"]).await;
    assert_eq!(code, Some(0), "{made}");
    let key = made.split_whitespace().find(|word| word.starts_with("hml_")).unwrap().to_owned();
    for (auth, key) in [("none", ""), ("keys", key.as_str())] {
        let service = site.program(&["--auth", auth, "--cors-origin", &origin, "--log", "error"]);
        let other = Site::open(Backend::Sqlite);
        let refusing = other.program(&["--auth", "none", "--log", "error"]);
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/clients/browser.mjs");
        modules(folder.path());
        std::fs::copy(script, folder.path().join("browser.mjs")).unwrap();
        let mut run = node();
        run.arg(folder.path().join("browser.mjs")).args([&port.to_string(), &service.base, &refusing.base, key]);
        assert!(said(run).await.contains("all of it"));
    }
}

#[tokio::test]
async fn forms_are_accepted_as_browsers_and_generated_clients_send_them() {
    let service = TestService::start(&["--workers", "0"]).await;
    let empty = ["external_ref", "priority", "deadline_at", "max_run_s", "use_cache", "labels"];
    let unfilled = empty.iter().fold(form("a", "b", &json!({})), |form, name| form.text(*name, ""));
    assert_eq!(service.send(unfilled).await.status(), 202, "a form in which nothing was filled in");
    for word in ["True", "False", "TRUE", "true", "false"] {
        let sent = form("a", "b", &json!({"seed": 5})).text("use_cache", word);
        assert_eq!(service.send(sent).await.status(), 202, "{word}");
    }
    problem(service.send(form("a", "b", &json!({})).text("use_cache", "yes")).await, 422, "invalid-request").await;
    service.end().await;
}
