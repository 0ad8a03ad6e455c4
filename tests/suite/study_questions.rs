//! What the service makes of a study's `visits` and `rivals`, and of `adjust` and `covariates` of a score: the fields have an effect,
//! and are refused where they cannot.

use super::cli::homolog;
use super::faults::site::{Backend, Site};
use super::solids::surface;
use super::studies::cohort;
use super::study_service::{Service, same};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Nearly symmetric solids of a study, of which about half have one pose alone.
const SOLIDS: u64 = 10;

/// A finished study.
struct Finished {
    path: String,
    /// The names of the files of its archive.
    names: Vec<PathBuf>,
    /// The study document.
    document: Value,
    /// Number of its matches.
    matches: usize,
}

fn finished(service: &Service, asked: &Value) -> Finished {
    let sent = service.post("/v1/studies", asked);
    let status = sent.status();
    let study: Value = sent.json().unwrap();
    assert_eq!(status, 202, "{study}");
    let id = study["id"].as_str().unwrap();
    let path = format!("/v1/studies/{id}");
    service.finished(&path);
    let names = service.archive(&path).into_keys().collect();
    Finished { document: service.get(&format!("{path}/result")), names, matches: service.matches(id).len(), path }
}

impl Finished {
    fn records_below(&self, folder: &str) -> usize {
        self.names.iter().filter(|name| name.parent() == Some(Path::new(folder))).count()
    }
}

/// Checks that a request is refused for one member, and returns the detail of the error.
fn refused(service: &Service, path: &str, asked: &Value, pointer: &str) -> String {
    let answer = service.post(path, asked);
    let status = answer.status();
    let said: Value = answer.json().unwrap();
    assert_eq!((status.as_u16(), &said["errors"][0]["pointer"]), (422, &json!(pointer)), "{said}");
    said["errors"][0]["detail"].as_str().unwrap().to_owned()
}

fn with(asked: &Value, member: &str, value: Value) -> Value {
    let mut asked = asked.clone();
    asked[member] = value;
    asked
}

/// Two visits of two persons: the second is longer by a twentieth.
#[test]
fn visits_of_a_person_go_through_its_own_template_as_by_the_command() {
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 2);
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let (mut rows, mut subjects) = ("id,file,subject,visit\n".to_owned(), Vec::new());
    for (person, visit) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let bytes = fs::read(place.path().join(format!("p{person}/source.ply"))).unwrap();
        let read = homolog_formats::read(&bytes, None, &homolog_formats::ReadLimits::default()).unwrap();
        let homolog_formats::FileContent::Mesh(mesh) = read.content else { panic!("no mesh") };
        let longer = |p: &nalgebra::Point3<f64>| nalgebra::Point3::new(p.x * (1.0 + 0.05 * f64::from(visit)), p.y, p.z);
        let mesh = mesh.mesh.with_vertices(mesh.mesh.vertices().iter().map(longer).collect()).unwrap();
        let (id, file) = (format!("v{person}{visit}"), format!("v{person}{visit}.ply"));
        fs::write(place.path().join(&file), homolog_formats::write_ply(&mesh)).unwrap();
        rows.push_str(&format!("{id},{file},p{person},{visit}\n"));
        let mesh = service.upload(&place.path().join(&file));
        subjects.push(json!({"id": id, "subject": format!("p{person}"), "input": {"mesh_id": mesh}, "covariates": {"visit": visit}}));
    }
    let (table, out) = (place.path().join("visits.csv"), place.path().join("out"));
    fs::write(&table, rows).unwrap();
    let mut command = homolog();
    let options = ["--template-rounds", "1", "--start", "v00", "--visits", "own-template", "--out"];
    let done = command.arg("study").arg(&table).args(options).arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));

    let asked = json!({"subjects": subjects, "template_rounds": 1, "start": "v00"});
    let plain = finished(&service, &asked);
    let own = finished(&service, &with(&asked, "visits", json!("own_template")));
    same(&service.archive(&own.path), &out);
    let members = |of: &Finished| of.document["found"]["subjects"]["model"].clone();
    assert_eq!((members(&plain), members(&own)), (json!(4), json!(4)));
    assert_eq!(own.document["settings"]["visits"], "own_template");
    assert_eq!(own.document["found"]["own_templates"], json!({"persons": 2, "matched_directly": 0}));
    assert!(plain.document["settings"]["visits"].is_null() && plain.document["found"]["own_templates"].is_null());
    assert_eq!((plain.records_below("matches/visits"), own.records_below("matches/visits")), (0, 4));
    // Of each person: a visit with the other, their mean with both, and the template of the group with that.
    let template = 4;
    assert_eq!((plain.matches, own.matches), (template + 4, template + 2 * 4));
    assert_ne!(plain.document["found"]["model"], own.document["found"]["model"]);

    let said = refused(&service, "/v1/studies", &with(&asked, "visits", json!("own")), "/visits");
    assert!(said.contains("group_template, own_template"), "{said}");
    let mut several = with(&asked, "visits", json!("own_template"));
    for (k, subject) in several["subjects"].as_array_mut().unwrap().iter_mut().enumerate() {
        subject["structure"] = json!(["amygdala", "hippocampus"][k % 2]);
        subject["covariates"] = json!({});
    }
    several["start"] = json!("p0");
    let third: Vec<Value> = several["subjects"].as_array().unwrap()[..2].to_vec();
    for mut subject in third {
        subject["id"] = json!(subject["id"].as_str().unwrap().replace('v', "w"));
        subject["subject"] = json!("p2");
        several["subjects"].as_array_mut().unwrap().push(subject);
    }
    let said = refused(&service, "/v1/studies", &several, "/visits");
    assert!(said.contains("one structure") && said.contains("leave visits out"), "{said}");
}

#[test]
fn a_score_is_adjusted_for_covariates_of_the_subject() {
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 8);
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let mesh = |k: usize| json!({"mesh_id": service.upload(&place.path().join(format!("p{k}/source.ply")))});
    let subject = |k: usize| {
        json!({"id": format!("s{k}"), "input": mesh(k),
               "covariates": {"age": 60 + 5 * k * k % 17, "sex": (["f", "m"][k % 2]), "site": "x"}})
    };
    let subjects: Vec<Value> = (0..7).map(subject).collect();
    let study = finished(&service, &json!({"subjects": subjects, "template": mesh(2)}));
    let path = format!("{}/score", study.path);
    let input = mesh(7);
    let scored = |more: &Value| {
        let mut asked = json!({"input": input});
        asked.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        let sent = service.post(&path, &asked);
        let status = sent.status();
        let job: Value = sent.json().unwrap();
        assert_eq!(status, 202, "{job}");
        let (at, began) = (job["links"]["self"].as_str().unwrap(), Instant::now());
        loop {
            let job = service.get(&format!("{at}?wait=20"));
            if job["finished_at"].is_string() {
                assert_eq!(job["state"], "succeeded", "{job}");
                return service.get(job["links"]["score"].as_str().unwrap());
            }
            assert!(began.elapsed() < Duration::from_secs(400), "{job}");
        }
    };
    let plain = scored(&json!({}));
    let old = scored(&json!({"adjust": ["age"], "covariates": {"age": 90}}));
    let young = scored(&json!({"adjust": ["age"], "covariates": {"age": 62}}));
    assert!(plain["adjusted"].is_null() && plain["members"] == 7, "{}", plain["adjusted"]);
    let adjusted = &old["adjusted"];
    assert_eq!(
        (&adjusted["covariates"], &adjusted["incomplete"], &adjusted["degrees"]),
        (&json!({"age": "90"}), &json!(0), &json!(5.0))
    );
    let warnings = |of: &Value| of["adjusted"]["warnings"].as_array().unwrap().clone();
    assert!(warnings(&old).len() == 1 && warnings(&old)[0].as_str().unwrap().contains("age 90"), "{adjusted}");
    assert!(warnings(&young).is_empty(), "{}", young["adjusted"]);
    // The values of the subject count, not only those of the group.
    for (a, b) in [(&plain, &old), (&plain, &young), (&old, &young)] {
        assert_ne!(a["scores"], b["scores"]);
        assert_ne!(a["deviation_mm"], b["deviation_mm"]);
        assert_eq!((&a["residual_mm"], &a["reasons"]), (&b["residual_mm"], &b["reasons"]), "one match");
    }

    for (adjust, covariates, pointer, part) in [
        (
            json!(["weight"]),
            json!({"weight": 70}),
            "/adjust",
            "no covariate weight; its covariates are: age, sex, site",
        ),
        (json!(["age", "age"]), json!({"age": 70}), "/adjust", "named twice"),
        (json!(["age"]), json!({}), "/covariates", "no value of age"),
        (json!(["age"]), json!({"age": null}), "/covariates", "no value of age"),
        (json!(["age", "sex"]), json!({"age": 70}), "/covariates", "no value of sex"),
        (json!(["age"]), json!({"age": "old"}), "/covariates", "not a number"),
        (json!(["sex"]), json!({"sex": "x"}), "/covariates", "no level x; it has f, m"),
        (json!(["age"]), json!({"age": 70, "sex": "f"}), "/covariates", "value of sex"),
        (json!([]), json!({"age": 70}), "/covariates", "value of age"),
    ] {
        let asked = json!({"input": input, "adjust": adjust, "covariates": covariates});
        let said = refused(&service, &path, &asked, pointer);
        assert!(said.contains(part), "{asked}: {said}");
    }
}

#[test]
fn subjects_of_ambiguous_pose_are_matched_in_other_poses_or_left_out() {
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let input = |k: u64| {
        let file = site.folder.path().join(format!("{k}.ply"));
        fs::write(&file, homolog_formats::write_ply(&surface(k))).unwrap();
        json!({"mesh_id": service.upload(&file)})
    };
    let subjects: Vec<Value> = (1..=SOLIDS).map(|k| json!({"id": format!("s{k}"), "input": input(k)})).collect();
    let asked = json!({"subjects": subjects, "template": input(0)});
    let left = finished(&service, &with(&asked, "rivals", json!("leave_out")));
    let decided = finished(&service, &asked);
    assert_eq!(
        (&left.document["settings"]["rivals"], &decided.document["settings"]["rivals"]),
        (&json!("leave_out"), &Value::Null)
    );
    let count = |of: &Finished, place: &str| of.document["found"]["subjects"][place].as_u64().unwrap() as usize;
    let (members, open) = (count(&left, "model"), count(&left, "unreliable"));
    assert!(members >= 3 && open >= 1 && members + open == SOLIDS as usize, "{members} and {open}");
    assert_eq!((left.matches, &left.document["found"]["ambiguous_poses"]), (SOLIDS as usize, &Value::Null));
    let poses = decided.document["found"]["ambiguous_poses"].as_array().unwrap();
    assert_eq!(poses.len(), open);
    assert!(poses.iter().all(|pose| pose["reliable"] == members), "{poses:?}");
    let taken = poses.iter().filter(|pose| pose["decided"] == true).count();
    assert_eq!((count(&decided, "model"), count(&decided, "unreliable")), (members + taken, open - taken));
    let further = decided.matches - left.matches;
    assert!((open..=4 * open).contains(&further), "{further} further matches of {open}");

    let said = refused(&service, "/v1/studies", &with(&asked, "rivals", json!("drop")), "/rivals");
    assert!(said.contains("drop is none of decide, leave_out"), "{said}");
}
