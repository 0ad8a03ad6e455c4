//! The software bill of materials names everything that is linked into the program, and nothing else.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

fn sbom() -> Option<String> {
    let mut command = Command::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/sbom"));
    let Ok(done) = command.output() else {
        println!("skipped: python3 is not installed");
        return None;
    };
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    Some(String::from_utf8(done.stdout).unwrap())
}

#[test]
fn every_linked_crate_is_listed_with_license_and_hash() {
    let Some(text) = sbom() else { return };
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&document["bomFormat"], &document["specVersion"]), (&"CycloneDX".into(), &"1.6".into()));
    assert_eq!(document["metadata"]["component"]["name"], "homolog");
    let components = document["components"].as_array().unwrap();
    let names: BTreeSet<&str> = components.iter().map(|c| c["name"].as_str().unwrap()).collect();
    for linked in ["axum", "sqlx-sqlite", "libsqlite3-sys", "ring", "tokio", "nalgebra", "homolog-matching"] {
        assert!(names.contains(linked), "{linked} is missing");
    }
    for only_in_tests in ["proptest", "jsonschema", "s3s", "tempfile"] {
        assert!(!names.contains(only_in_tests), "{only_in_tests} is not linked");
    }
    let mut references = BTreeSet::from([document["metadata"]["component"]["bom-ref"].as_str().unwrap()]);
    for component in components {
        let name = component["name"].as_str().unwrap();
        assert!(references.insert(component["bom-ref"].as_str().unwrap()), "{name} is listed twice");
        assert!(component["licenses"][0]["expression"].is_string(), "{name} has no license");
        let is_hashed = component["hashes"][0]["content"].as_str().is_some_and(|hash| hash.len() == 64);
        assert!(is_hashed || name.starts_with("homolog-"), "{name} has no hash");
    }
    let edges = document["dependencies"].as_array().unwrap();
    assert_eq!(edges.len(), references.len());
    for edge in edges {
        for reference in edge["dependsOn"].as_array().unwrap().iter().chain([&edge["ref"]]) {
            assert!(references.contains(reference.as_str().unwrap()), "{reference} is not listed");
        }
    }
    assert_eq!(sbom().unwrap(), text, "the same commit gives the same bytes");
}
