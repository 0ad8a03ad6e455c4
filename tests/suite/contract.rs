//! The committed contract is the contract that is served. `make api` writes it anew.

use serde_json::Value;
use std::path::Path;

fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("api").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
fn openapi_json_is_up_to_date() {
    let made = homolog::http::openapi::openapi_json().unwrap();
    assert!(committed("openapi.json") == made, "api/openapi.json is not what the code says; run `make api`");
}

#[test]
fn problems_md_is_up_to_date() {
    let made = homolog::http::problem_table::problems_markdown();
    assert!(committed("problems.md") == made, "api/problems.md is not what the code says; run `make api`");
}

#[test]
fn every_reference_in_openapi_json_leads_somewhere() {
    let document: Value = serde_json::from_str(&committed("openapi.json")).unwrap();
    let mut references = Vec::new();
    collect(&document, &mut references);
    assert!(references.len() > 50);
    for reference in references {
        let pointer = reference.strip_prefix('#').unwrap();
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
