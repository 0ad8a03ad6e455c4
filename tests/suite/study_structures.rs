//! Several structures of each person, through the command and the service.

use super::cli::homolog;
use super::faults::site::{Backend, Site};
use super::study_labels::joined;
use super::study_service::{Service, same};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

const PERSONS: usize = 3;
/// The structures and their labels in the volume of each person.
const STRUCTURES: [(&str, u32); 2] = [("amygdala", 17), ("hippocampus", 53)];

/// The volumes of the persons, `v0.nii.gz` and so on.
fn volumes(folder: &Path) {
    for person in 0..PERSONS {
        let structures = [2 * person, 2 * person + 1].map(|k| {
            let out = folder.join(format!("p{k}"));
            let made = ["phantom", "--spacing", "2", "--subject"];
            let done = homolog().args(made).arg((k + 1).to_string()).arg("--out").arg(&out).output().unwrap();
            assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
            out.join("source.nii.gz")
        });
        joined(structures, &folder.join(format!("v{person}.nii.gz")));
    }
}

#[test]
fn structures_of_a_person_are_analyzed_together_as_by_the_command() {
    let place = tempfile::tempdir().unwrap();
    volumes(place.path());
    let out = place.path().join("out");
    let rows = (0..PERSONS)
        .flat_map(|k| STRUCTURES.map(|(name, label)| format!("p{k}.{name},p{k},{name},v{k}.nii.gz,{label},{k}\n")));
    let table = place.path().join("structures.csv");
    fs::write(&table, format!("id,subject,structure,file,label,age\n{}", rows.collect::<String>())).unwrap();
    let options = ["--template-rounds", "1", "--start", "p1", "--out"];
    let done = homolog().arg("study").arg(&table).args(options).arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let said = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(said.contains("3 subjects, 3 in the shape model") && said.contains("amygdala: "), "{said}");
    for (options, part) in [
        (["--template", "x.ply"], "amygdala, hippocampus"),
        (["--template", "thalamus=x.ply"], "amygdala, hippocampus"),
        (["--cycles", "3"], "one structure"),
    ] {
        let mut command = homolog();
        let refused = command.arg("study").arg(&table).arg("--out").arg(place.path().join("no")).args(options);
        let refused = refused.output().unwrap();
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(!refused.status.success() && said.contains(part), "{said}");
    }
    let scored = homolog().args(["study", "score"]).arg(&out).arg(place.path().join("v0.nii.gz")).output().unwrap();
    let said = String::from_utf8_lossy(&scored.stderr).into_owned();
    assert!(!scored.status.success() && said.contains("one structure"), "{said}");

    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let meshes: Vec<String> =
        (0..PERSONS).map(|k| service.upload(&place.path().join(format!("v{k}.nii.gz")))).collect();
    let subject = |k: usize, (name, label): (&str, u32)| {
        json!({"id": format!("p{k}.{name}"), "subject": format!("p{k}"), "structure": name, "labels": label,
               "input": {"mesh_id": meshes[k]}, "covariates": {"age": k}})
    };
    let subjects: Vec<Value> = (0..PERSONS).flat_map(|k| STRUCTURES.map(|of| subject(k, of))).collect();
    let asked = json!({"subjects": subjects, "template_rounds": 1, "start": "p1"});
    let with = |pointer: &str, value: Value| {
        let mut asked = asked.clone();
        match asked.pointer_mut(pointer) {
            Some(place) => *place = value,
            None => drop(asked.as_object_mut().unwrap().insert(pointer[1..].to_owned(), value)),
        }
        asked
    };
    for (wrong, pointer) in [
        (with("/subjects/3/structure", json!("amygdala")), "/subjects/3/structure"),
        (with("/subjects/3/structure", Value::Null), "/subjects/3/structure"),
        (with("/subjects/3/subject", Value::Null), "/subjects/3/subject"),
        (with("/subjects/3/covariates", json!({"structure": "x"})), "/subjects/3/covariates"),
        (with("/subjects/3/covariates", json!({"age": 7})), "/subjects/3/covariates"),
        (with("/start", json!("p9")), "/start"),
        (with("/template", json!({"mesh_id": meshes[0]})), "/template"),
        (with("/cycles", json!(3)), "/cycles"),
    ] {
        let answer = service.post("/v1/studies", &wrong);
        let status = answer.status();
        let said: Value = answer.json().unwrap();
        assert_eq!((status.as_u16(), &said["errors"][0]["pointer"]), (422, &json!(pointer)), "{said}");
    }
    let study: Value = service.post("/v1/studies", &asked).json().unwrap();
    let path = format!("/v1/studies/{}", study["id"].as_str().unwrap_or_else(|| panic!("{study}")));
    service.finished(&path);
    assert_eq!(service.get(&path)["subjects"][1]["structure"], "hippocampus");
    same(&service.archive(&path), &out);
    let score = service.post(&format!("{path}/score"), &json!({"input": {"mesh_id": meshes[0]}}));
    let status = score.status();
    let said = score.text().unwrap();
    assert!(status.as_u16() == 422 && said.contains("one structure"), "{status} {said}");
}
