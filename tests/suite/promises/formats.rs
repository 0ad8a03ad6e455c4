//! Promises on results and on the service's description of itself, with the real program.

use crate::cli::homolog;
use crate::faults::client::Client;
use crate::faults::on_both;
use crate::faults::site::{Backend, Site};
use crate::jobs_support::problem;
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};
use std::collections::BTreeSet;

on_both!(a_match_is_answered_in_every_format, methods_describe_their_parameters);

/// The formats of a result's links, with their media types, as in the API's design.
const FORMATS: [(&str, &[(&str, &str)]); 3] = [
    (
        "correspondences",
        &[
            ("json", "application/json"),
            ("csv", "text/csv"),
            ("npy", "application/x-npy"),
            ("arrow", "application/vnd.apache.arrow.file"),
            ("ply", "model/ply"),
            ("vtk", "model/vtk"),
            ("gifti", "application/gifti+xml"),
        ],
    ),
    (
        "transform",
        &[
            ("json", "application/json"),
            ("text", "text/plain"),
            ("tfm", "application/x-itk-transform"),
            ("lta", "application/x-freesurfer-lta"),
        ],
    ),
    (
        "aligned",
        &[("ply", "model/ply"), ("vtk", "model/vtk"), ("gifti", "application/gifti+xml"), ("stl", "model/stl")],
    ),
];

async fn a_match_is_answered_in_every_format(backend: Backend) {
    let site = Site::open(backend);
    let program = site.program(&[]);
    let client = Client::of(&program.base);
    let folder = site.folder.path().join("pair");
    let arguments = ["phantom", "--kind", "surface", "--edge", "3", "--out"];
    assert!(homolog().args(arguments).arg(&folder).output().unwrap().status.success());
    let file = |name: &str| Part::bytes(std::fs::read(folder.join(name)).unwrap()).file_name(name.to_owned());
    let form = Form::new().part("source", file("source.ply")).part("target", file("target.ply"));
    let form = form.text("parameters", json!({"inference": {"algorithm": "max_product"}}).to_string());
    let sent = client.http.post(format!("{}/v1/jobs", client.base)).multipart(form).send().await.unwrap();
    assert_eq!(sent.status(), 202, "{}", sent.text().await.unwrap());
    let job: Value = sent.json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    client.until_succeeded(id, super::SOON * 4).await;
    let path = format!("/v1/jobs/{id}");
    let result = client.json(&format!("{path}/result")).await;
    for member in ["transform", "surface_distance", "energy", "provenance", "links"] {
        assert!(result[member].is_object() || result[member].is_array(), "{member}: {result}");
    }
    for link in ["job", "correspondences", "transform", "aligned", "trace"] {
        assert_eq!(client.get(result["links"][link].as_str().unwrap()).await.unwrap().status(), 200, "{link}");
    }
    assert!(result["provenance"]["seed"].is_u64() && result["provenance"]["version"].is_string());
    for (part, formats) in FORMATS {
        for (format, media_type) in formats {
            let by_query = client.get(&format!("{path}/{part}?format={format}")).await.unwrap();
            assert_eq!(by_query.status(), 200, "{part} {format}");
            let got = by_query.headers()["content-type"].to_str().unwrap().to_owned();
            assert!(got.starts_with(media_type), "{part} {format}: {got}");
            let by_query = by_query.bytes().await.unwrap();
            let request = client.http.get(format!("{}{path}/{part}", client.base)).header("accept", *media_type);
            let by_accept = request.send().await.unwrap();
            assert_eq!(by_accept.status(), 200, "{part} {media_type}");
            assert!(by_accept.bytes().await.unwrap() == by_query && !by_query.is_empty(), "{part} {format}");
        }
    }
    let trace = client.json(&format!("{path}/trace")).await;
    let points = trace["points"].as_array().unwrap();
    let mut members = BTreeSet::new();
    for point in points {
        for member in ["seq", "round", "phase", "iteration", "elapsed_ms"] {
            assert!(!point[member].is_null(), "{member}: {point}");
        }
        members.extend(point.as_object().unwrap().keys().map(String::as_str));
    }
    for member in ["energy", "energy_unary", "energy_pairwise", "message_delta_max", "vertices_changed", "support"] {
        assert!(members.contains(member), "{member}: {members:?}");
    }
}

async fn methods_describe_their_parameters(backend: Backend) {
    let site = Site::open(backend);
    let program = site.program(&["--workers", "0"]);
    let client = Client::of(&program.base);
    let list = client.json("/v1/methods").await;
    let mut n_ranges = 0;
    for method in list["methods"].as_array().unwrap() {
        let name = method["name"].as_str().unwrap();
        let one = client.json(&format!("/v1/methods/{name}")).await;
        assert!(
            one["version"].is_string()
                && !one["description"].as_str().unwrap().is_empty()
                && one["defaults"].is_object()
        );
        // A reference into the OpenAPI document: one schema for all methods, with every bound.
        let reference = one["parameters_schema"]["$ref"].as_str().unwrap();
        let document = client.json("/openapi.json").await;
        let schema = document.pointer(reference.strip_prefix("/openapi.json#").unwrap()).unwrap();
        let whole = json!({"$ref": "#/components/schemas/PartialParameters", "components": document["components"]});
        let validator = jsonschema::draft202012::new(&whole).unwrap();
        let faults: Vec<_> = validator.iter_errors(&one["defaults"]).map(|fault| fault.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {faults:?}");
        assert!(!validator.is_valid(&json!({"energy": {"alpha": -1}})) && validator.is_valid(&json!({})));
        let text = document["components"]["schemas"].to_string();
        n_ranges += text.matches("\"minimum\"").count() + text.matches("\"exclusiveMinimum\"").count();
        for (property, described) in schema["properties"].as_object().unwrap() {
            assert!(described.to_string().contains("\"description\""), "{name}: {property}");
        }
    }
    assert!(n_ranges > 10, "{n_ranges}");
    problem(client.get("/v1/methods/none").await.unwrap(), 404, "method-not-found").await;

    assert_eq!(client.json("/healthz").await["status"], "alive");
    assert_eq!(
        client.json("/readyz").await["dependencies"],
        json!({"job_store": "ok", "artifact_store": "ok", "clock": "ok"})
    );
    assert_eq!(
        client.json("/openapi.json").await,
        serde_json::from_slice::<Value>(&std::fs::read("api/openapi.json").unwrap()).unwrap()
    );
    let metrics = client.get("/metrics").await.unwrap().text().await.unwrap();
    assert!(metrics.contains("# HELP homolog_jobs "), "{metrics}");
    // The service serves every file that the page loads.
    let page = client.get("/docs/").await.unwrap();
    assert_eq!(page.status(), 200);
    let page = page.text().await.unwrap();
    let loaded: Vec<_> = page.match_indices("src=\"").chain(page.match_indices("href=\"")).collect();
    assert!(!loaded.is_empty());
    for (at, attribute) in loaded {
        let address = page[at + attribute.len()..].split('"').next().unwrap();
        assert!(!address.starts_with("http") && !address.starts_with("//"), "{address}");
        let address = format!("/docs/{}", address.trim_start_matches("./"));
        assert_eq!(client.get(&address).await.unwrap().status(), 200, "{address}");
    }
}
