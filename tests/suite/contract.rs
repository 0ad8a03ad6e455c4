//! The committed API description equals the one that the program generates. `make api` updates it.

use serde_json::Value;
use std::path::Path;

fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("api").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
fn openapi_json_is_up_to_date() {
    let made = homolog::http::openapi_json().unwrap();
    assert!(committed("openapi.json") == made, "api/openapi.json is not what the code says; run `make api`");
}

#[test]
fn problems_md_is_up_to_date() {
    let made = homolog::http::problems_markdown();
    assert!(committed("problems.md") == made, "api/problems.md is not what the code says; run `make api`");
}

#[test]
fn every_reference_in_openapi_json_resolves() {
    let document: Value = serde_json::from_str(&committed("openapi.json")).unwrap();
    let mut references = Vec::new();
    collect(&document, &mut references);
    assert!(references.len() > 50);
    for reference in references {
        let pointer = reference.trim_start_matches("/openapi.json").strip_prefix('#').unwrap();
        assert!(document.pointer(pointer).is_some(), "{reference}");
    }
}

fn collect(value: &Value, references: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            if let Some(Value::String(reference)) = map.get("$ref") {
                references.push(reference.clone());
            }
            map.values().for_each(|v| collect(v, references));
        }
        Value::Array(items) => items.iter().for_each(|v| collect(v, references)),
        _ => {}
    }
}

/// Every operation of the document with its operation id.
fn operations(document: &Value) -> Vec<(String, Value)> {
    let items = document["paths"].as_object().unwrap().values();
    let operations = items.flat_map(|item| item.as_object().unwrap().values()).filter(|o| o["operationId"].is_string());
    operations.map(|operation| (operation["operationId"].as_str().unwrap().to_owned(), operation.clone())).collect()
}

#[test]
fn every_body_has_an_example_that_matches_its_schema() {
    let document: Value = serde_json::from_str(&committed("openapi.json")).unwrap();
    let mut faults = Vec::new();
    let mut n_checked = 0;
    for (name, operation) in operations(&document) {
        let answers = operation["responses"].as_object().unwrap().iter();
        let bodies = answers.map(|(status, answer)| (status.as_str(), &answer["content"]));
        for (place, content) in bodies.chain([("request", &operation["requestBody"]["content"])]) {
            for (media_type, body) in content.as_object().into_iter().flatten() {
                // Neither files nor the OpenAPI document itself have an example.
                let is_text = media_type.contains("json") || media_type.starts_with("text/");
                if name == "openapi" && place == "200" || !is_text && place != "request" {
                    continue;
                }
                let Some(example) = body.get("example") else {
                    faults.push(format!("{name} {place} {media_type} has no example"));
                    continue;
                };
                let mut schema = body["schema"].clone();
                schema["components"] = document["components"].clone();
                let validator = jsonschema::draft202012::new(&schema).unwrap();
                faults.extend(
                    validator.iter_errors(example).map(|e| format!("{name} {place}: {e} at {}", e.instance_path())),
                );
                n_checked += 1;
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(n_checked > 60, "{n_checked}");
}

#[test]
fn every_error_of_every_operation_is_a_problem() {
    let document: Value = serde_json::from_str(&committed("openapi.json")).unwrap();
    for (name, operation) in operations(&document) {
        let responses = operation["responses"].as_object().unwrap();
        for status in ["403", "500", "503"] {
            assert!(responses.contains_key(status), "{name} has no {status}");
        }
        for (status, response) in responses.iter().filter(|(status, _)| status.as_str() >= "400") {
            let content = response["content"].as_object().unwrap_or_else(|| panic!("{name} {status} has no body"));
            let problem = &content["application/problem+json"];
            assert_eq!(
                (content.len(), &problem["schema"]["$ref"]),
                (1, &"#/components/schemas/ProblemDocument".into())
            );
            assert_eq!(problem["example"]["status"].to_string(), *status, "{name}");
        }
    }
}

#[test]
fn every_example_file_is_used() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("api/examples");
    let document: Value = serde_json::from_str(&committed("openapi.json")).unwrap();
    let text = document.to_string();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let example: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
        assert!(text.contains(&example.to_string()), "{}", path.display());
    }
}
