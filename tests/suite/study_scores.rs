//! `homolog study score` and `POST /v1/studies/{id}/score`: one answer from both, and what is refused.

use super::cli::{homolog, read_json};
use super::faults::site::{Backend, Site};
use super::studies::{OPTIONS, cohort, study};
use super::study_service::Service;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// A study of six subjects by the command, in `out`; the seventh is left out.
fn made(place: &Path, out: &Path) {
    let table = cohort(place, 7);
    let rows: String = fs::read_to_string(&table).unwrap().lines().take(7).map(|line| format!("{line}\n")).collect();
    fs::write(&table, rows).unwrap();
    let done = study(&table, out);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
}

#[test]
fn the_service_scores_as_the_command() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join("out");
    made(place.path(), &out);
    let new = place.path().join("p6/source.ply");
    let before = fs::read(out.join("study.json")).unwrap();
    let score = |more: &[&str]| homolog().args(["study", "score"]).arg(&out).arg(&new).args(more).output().unwrap();
    let done = score(&["--threads", "2"]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let said = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(said.contains("against 6 members") && said.contains("unusual shape: p "), "{said}");
    let by_command = read_json(&out.join("scores/source/score.json"));
    for name in ["subject.vtk", "subject.surf.gii", "mean.vtk"] {
        assert!(out.join("scores/source").join(name).exists(), "{name}");
    }
    assert_eq!(fs::read(out.join("study.json")).unwrap(), before, "the study is unchanged");
    for (more, part) in [
        (&["--group", "group=c"], "no level c"),
        (&["--group", "sex=f"], "no covariate sex"),
        (&["--group", "group"], "COVARIATE=LEVEL"),
        (&["--group", "group=a"], "at least four"),
        (&["--side", "left"], "no sides"),
    ] {
        let refused = score(more);
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(refused.status.code() == Some(2) && said.contains(part), "{said}");
    }

    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let subjects: Vec<Value> = (0..6)
        .map(|k| {
            let mesh = service.upload(&place.path().join(format!("p{k}/source.ply")));
            json!({"id": format!("s{k}"), "input": {"mesh_id": mesh}, "covariates": {"group": (["a", "b"][k % 2])}})
        })
        .collect();
    assert!(OPTIONS.contains(&"--template-subjects"));
    let asked = json!({"subjects": subjects, "effect": "group", "permutations": 50, "template_subjects": 3, "template_rounds": 2});
    let study: Value = service.post("/v1/studies", &asked).json().unwrap();
    let path = format!("/v1/studies/{}", study["id"].as_str().unwrap());
    let mesh = json!({"mesh_id": service.upload(&new)});
    let early = service.post(&format!("{path}/score"), &json!({"input": mesh}));
    assert_eq!(early.status(), 409);
    assert_eq!(early.json::<Value>().unwrap()["type"], "/problems/study-not-ready");
    service.finished(&path);
    let study = service.get(&path);

    let sent = service.post(&format!("{path}/score"), &json!({"input": mesh, "external_ref": "new"}));
    assert_eq!(sent.status(), 202, "{}", sent.text().unwrap());
    let job: Value = sent.json().unwrap();
    assert_eq!((&job["method"], &job["external_ref"]), (&json!("study_score"), &json!("new")));
    let job_path = job["links"]["self"].as_str().unwrap().to_owned();
    let began = Instant::now();
    let done = loop {
        let job = service.get(&format!("{job_path}?wait=20"));
        if job["finished_at"].is_string() {
            break job;
        }
        assert!(began.elapsed() < Duration::from_secs(400), "{job}");
    };
    assert_eq!(done["state"], "succeeded", "{done}");
    assert!(done["links"]["result"].is_null());
    let by_service = service.get(done["links"]["score"].as_str().unwrap());
    assert_eq!(by_service, by_command);
    assert_eq!(service.fetch(&format!("{job_path}/result")).status(), 409);
    let others = format!("/v1/studies/{}/scores/{}", uuid::Uuid::now_v7(), job["id"].as_str().unwrap());
    assert_eq!(service.fetch(&others).status(), 404);
    let after = service.get(&path);
    assert_eq!(
        (&after["state"], &after["n_subjects"], &after["finished_at"]),
        (&study["state"], &json!(6), &study["finished_at"])
    );

    for (wrong, pointer) in [
        (json!({"input": mesh, "group": {"covariate": "sex", "level": "f"}}), "/group"),
        (json!({"input": mesh, "group": {"covariate": "", "level": "f"}}), "/group/covariate"),
        (json!({"input": mesh, "side": "left"}), "/side"),
        (json!({"input": {}}), "/input"),
    ] {
        let refused = service.post(&format!("{path}/score"), &wrong);
        assert_eq!(refused.status(), 422);
        let said: Value = refused.json().unwrap();
        assert_eq!(said["errors"][0]["pointer"], pointer, "{said}");
    }
}
