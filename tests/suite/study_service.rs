//! `/v1/studies`: the same bytes as the command, even if processes are killed; decisions, further subjects, tenants.

use super::cli::homolog;
use super::faults::site::{Backend, Program, Site};
use super::process::ENDLESS;
use super::studies::{OPTIONS, cohort, contents, study};
use reqwest::blocking::{Client, Response};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Longest time of a study, on a loaded machine.
const PATIENCE: Duration = Duration::from_secs(400);
/// A process that is killed uses up an attempt of each of its jobs.
const ATTEMPTS: [&str; 4] = ["--max-attempts", "100", "--crash-pause-ms", "0"];

/// A service over a study.
pub(super) struct Service {
    program: Program,
    client: Client,
}

impl Service {
    pub(super) fn start(site: &Site, more: &[&str]) -> Self {
        homolog::tls::prepare();
        let program = site.program(&[more, &ATTEMPTS].concat());
        Service { program, client: Client::builder().timeout(Duration::from_secs(120)).build().unwrap() }
    }

    fn url(&self, path: &str) -> String {
        format!("{}{path}", self.program.base)
    }

    /// An answer, whatever its status.
    pub(super) fn fetch(&self, path: &str) -> Response {
        self.client.get(self.url(path)).send().unwrap()
    }

    pub(super) fn get(&self, path: &str) -> Value {
        let response = self.fetch(path);
        assert_eq!(response.status(), 200, "{path}");
        response.json().unwrap()
    }

    pub(super) fn post(&self, path: &str, body: &Value) -> Response {
        self.client.post(self.url(path)).json(body).send().unwrap()
    }

    /// The id of an upload.
    pub(super) fn upload(&self, file: &Path) -> String {
        let body = fs::read(file).unwrap();
        let sent =
            self.client.post(self.url("/v1/meshes")).header("content-type", "application/octet-stream").body(body);
        let mesh: Value = sent.send().unwrap().json().unwrap();
        mesh["id"].as_str().unwrap_or_else(|| panic!("{mesh}")).to_owned()
    }

    /// Waits until the study is in a final state or `done` holds; returns it.
    fn until(&self, path: &str, done: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let study = self.get(path);
            if done(&study) || study["finished_at"].is_string() {
                return study;
            }
            assert!(began.elapsed() < PATIENCE, "still {study}");
            std::thread::sleep(Duration::from_millis(15));
        }
    }

    pub(super) fn finished(&self, path: &str) {
        let study = self.until(path, |_| false);
        assert_eq!(study["state"], "finished", "{study}");
    }

    /// The files of the archive by name.
    pub(super) fn archive(&self, path: &str) -> BTreeMap<PathBuf, Vec<u8>> {
        let response = self.client.get(self.url(&format!("{path}/archive"))).send().unwrap();
        assert_eq!(
            (response.status().as_u16(), &response.headers()["content-type"]),
            (200, &"application/zip".parse().unwrap())
        );
        let mut archive = zip::ZipArchive::new(std::io::Cursor::new(response.bytes().unwrap())).unwrap();
        (0..archive.len())
            .map(|k| {
                let mut file = archive.by_index(k).unwrap();
                let name = PathBuf::from(file.name().unwrap().into_owned());
                let mut bytes = Vec::new();
                std::io::copy(&mut file, &mut bytes).unwrap();
                (name, bytes)
            })
            .collect()
    }

    /// Ids of the matches of a study.
    pub(super) fn matches(&self, id: &str) -> BTreeSet<String> {
        let listed = self.get(&format!("/v1/jobs?study={id}&page_size=500&fields=id"));
        listed["jobs"].as_array().unwrap().iter().map(|job| job["id"].as_str().unwrap().to_owned()).collect()
    }
}

fn subject(service: &Service, folder: &Path, k: usize) -> Value {
    let mesh = service.upload(&folder.join(format!("p{k}/source.ply")));
    let group = ["a", "b"][k % 2];
    json!({"id": format!("s{k}"), "input": {"mesh_id": mesh}, "covariates": {"group": group}})
}

/// The request that corresponds to [`OPTIONS`] of the command.
fn asked(subjects: Vec<Value>) -> Value {
    assert!(OPTIONS.windows(2).any(|pair| pair == ["--permutations", "50"]));
    json!({"subjects": subjects, "effect": "group", "permutations": 50, "template_subjects": 3, "template_rounds": 2})
}

/// Asserts that both have the same files with the same bytes. In the study document the file names differ, because the
/// service has none.
pub(super) fn same(service: &BTreeMap<PathBuf, Vec<u8>>, command: &Path) {
    let command = contents(command);
    assert_eq!(service.keys().collect::<Vec<_>>(), command.keys().collect::<Vec<_>>());
    for (name, bytes) in &command {
        if name == Path::new("study.json") {
            let document = |bytes: &[u8]| {
                let mut document: Value = serde_json::from_slice(bytes).unwrap();
                for subject in document["cohort"]["subjects"].as_array_mut().unwrap() {
                    assert!(subject.as_object_mut().unwrap().remove("file").is_some());
                }
                document
            };
            assert_eq!(document(&service[name]), document(bytes));
        } else {
            assert!(service[name] == *bytes, "{} differs", name.display());
        }
    }
}

/// Files of a form, a priority that changes and waits for what happens: as for jobs.
#[test]
fn a_study_is_sent_as_a_form_raised_and_waited_for() {
    use reqwest::blocking::multipart::{Form, Part};
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 5);
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &["--auth", "none", "--workers", "0"]);
    let file = |k: usize| fs::read(place.path().join(format!("p{k}/source.ply"))).unwrap();
    let one = |k: usize| json!({"id": format!("s{k}"), "input": {"upload": format!("Jane Doe {k}.ply")}});
    let form = |subjects: Vec<Value>, files: &[usize]| {
        let document = json!({"subjects": subjects, "tags": {"site": "x"}}).to_string();
        let form = Form::new().part("document", Part::text(document).mime_str("application/json").unwrap());
        files
            .iter()
            .fold(form, |form, &k| form.part("files", Part::bytes(file(k)).file_name(format!("Jane Doe {k}.ply"))))
    };
    let send = |path: &str, form: Form| service.client.post(service.url(path)).multipart(form).send().unwrap();

    // Faults are those of the document, and of the files to which it refers.
    for (subjects, files, pointer) in [
        (vec![one(0), one(1), one(2)], vec![0, 1], "/subjects/2/input/upload"),
        (vec![one(0), one(1), json!({"id": "s2"})], vec![0, 1], "/subjects/2/input"),
        (vec![one(0), one(1), json!({"id": "s2", "input": {}})], vec![0, 1], "/subjects/2/input"),
        (vec![one(0), one(1), one(2)], vec![0, 1, 2, 2], "/files"),
    ] {
        let answer = send("/v1/studies", form(subjects, &files));
        assert_eq!(answer.status(), 422);
        let said: Value = answer.json().unwrap();
        assert_eq!(said["errors"][0]["pointer"], pointer, "{said}");
    }
    for (wrong, pointer) in [
        (Form::new().part("files", Part::text("x").file_name("x.ply")), "/document"),
        (Form::new().text("subjects", "[]"), "/subjects"),
        (Form::new().text("files", "a file without a name"), "/files"),
    ] {
        let said: Value = send("/v1/studies", wrong).json().unwrap();
        assert_eq!(said["errors"][0]["pointer"], pointer, "{said}");
    }
    let sent = send("/v1/studies", form((0..4).map(one).collect(), &[0, 1, 2, 3]));
    let status = sent.status();
    let study: Value = sent.json().unwrap();
    assert_eq!(status, 202, "{study}");
    assert_eq!((&study["tags"], &study["labels"]), (&json!({"site": "x"}), &json!({"site": "x"})));
    let path = format!("/v1/studies/{}", study["id"].as_str().unwrap());
    let document = json!({"subjects": [one(4)]}).to_string();
    let more = Form::new().text("document", document).part("files", Part::bytes(file(4)).file_name("Jane Doe 4.ply"));
    assert_eq!(send(&format!("{path}/subjects"), more).json::<Value>().unwrap()["n_subjects"], 5);
    let database = fs::read(site.data_dir().join("homolog.sqlite-wal")).unwrap();
    assert!(!database.windows(4).any(|w| w == b"Jane"), "names of files are not stored");

    // A wait ends when the study changes; an unchanged one is answered with 304.
    let get = |etag: &str, wait: u32| {
        let request = service.client.get(service.url(&format!("{path}?fields=id,state,priority&wait={wait}")));
        request.header("if-none-match", etag).send().unwrap()
    };
    let first = get("\"none\"", 20);
    assert_eq!(first.status(), 200, "another version than is known is answered at once");
    let etag = first.headers()["etag"].to_str().unwrap().to_owned();
    let began = Instant::now();
    let unchanged = get(&etag, 1);
    assert!(unchanged.status() == 304 && began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());
    let patch =
        |priority: i32| service.client.patch(service.url(&path)).json(&json!({"priority": priority})).send().unwrap();
    let changed = std::thread::scope(|scope| {
        let waiting = scope.spawn(|| get(&etag, 20));
        std::thread::sleep(Duration::from_millis(300));
        let raised = patch(7);
        assert_eq!((raised.status().as_u16(), &raised.json::<Value>().unwrap()["priority"]), (200, &json!(7)));
        waiting.join().unwrap()
    });
    assert_eq!(changed.status(), 200, "not 304 at the end of the wait");
    assert_eq!(changed.json::<Value>().unwrap()["priority"], 7);
    for wrong in [json!({"priority": 101}), json!({"priority": "high"}), json!({})] {
        let said: Value = service.client.patch(service.url(&path)).json(&wrong).send().unwrap().json().unwrap();
        assert_eq!(said["errors"][0]["pointer"], "/priority", "{said}");
    }

    // Its matches have the new priority, also those that were queued before.
    drop(service);
    let service = Service::start(&site, &["--auth", "none", "--workers", "1"]);
    service.until(&path, |_| !service.matches(study["id"].as_str().unwrap()).is_empty());
    let answer = service.client.patch(service.url(&path)).json(&json!({"priority": -3})).send().unwrap();
    assert_eq!(answer.status(), 200);
    let jobs = service.get(&format!("/v1/jobs?study={}", study["id"].as_str().unwrap()));
    assert!(
        jobs["jobs"].as_array().unwrap().iter().filter(|job| job["state"] == "queued").all(|job| job["priority"] == -3)
    );
    assert_eq!(service.post(&format!("{path}/cancel"), &json!({})).status(), 202);
    let answer = service.client.patch(service.url(&path)).json(&json!({"priority": 1})).send().unwrap();
    assert_eq!(answer.status(), 409);
    assert_eq!(answer.json::<Value>().unwrap()["type"], "/problems/study-finished");
}

/// Left and right surfaces: the files of the command's table and the subjects of the service are the same.
#[test]
fn sides_are_mirrored_as_by_the_command() {
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 4);
    let mut text = "id,file,side,group\n".to_owned();
    for k in 0..4 {
        let file = place.path().join(format!("p{k}/source.ply"));
        let side = ["left", "right"][k % 2];
        if side == "right" {
            let read = homolog_formats::read(&fs::read(&file).unwrap(), None, &homolog_formats::ReadLimits::default());
            let homolog_formats::FileContent::Mesh(mesh) = read.unwrap().content else { panic!("no mesh") };
            let mirror = [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
            fs::write(&file, homolog_formats::write_ply(&mesh.mesh.moved(&mirror).unwrap())).unwrap();
        }
        text.push_str(&format!("s{k},p{k}/source.ply,{side},{}\n", ["a", "a", "b", "b"][k]));
    }
    let table = place.path().join("sides.csv");
    fs::write(&table, text).unwrap();
    let out = place.path().join("out");
    let options = ["--effect", "side", "--permutations", "6", "--template-rounds", "1", "--start", "s1"];
    let done = homolog().arg("study").arg(&table).args(options).arg("--out").arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));

    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let subjects: Vec<Value> = (0..4)
        .map(|k| {
            let mut subject = subject(&service, place.path(), k);
            subject["side"] = ["left", "right"][k % 2].into();
            subject["covariates"]["group"] = ["a", "a", "b", "b"][k].into();
            subject
        })
        .collect();
    let mut asked =
        json!({"subjects": subjects, "effect": "side", "permutations": 6, "template_rounds": 1, "start": "s1"});
    let accepted: Value = service.post("/v1/studies", &asked).json().unwrap();
    let path = format!("/v1/studies/{}", accepted["id"].as_str().unwrap_or_else(|| panic!("{accepted}")));
    service.finished(&path);
    same(&service.archive(&path), &out);
    let study = service.get(&path);
    assert_eq!((&study["subjects"][0]["side"], &study["subjects"][1]["side"]), (&json!("left"), &json!("right")));
    let result = service.get(&format!("{path}/result"));
    assert_eq!(
        (&result["settings"]["template_side"], &result["found"]["subjects"]["model"]),
        (&json!("right"), &json!(4))
    );

    // Contradictory requests are refused before the first match.
    let refused = |asked: &Value| {
        let response = service.post("/v1/studies", asked);
        assert_eq!(response.status(), 422);
        let problem: Value = response.json().unwrap();
        let error = &problem["errors"][0];
        (error["pointer"].as_str().unwrap().to_owned(), error["detail"].as_str().unwrap().to_owned())
    };
    let template = asked["subjects"][0]["input"].clone();
    asked["start"].take();
    asked.as_object_mut().unwrap().remove("start");
    asked["template"] = template;
    let (pointer, said) = refused(&asked);
    assert!(pointer == "/template_side" && said.contains("template_side"), "{pointer}: {said}");
    asked["template_side"] = "left".into();
    asked["parameters"] = json!({"input": {"target": {"mirror": true}}});
    let (pointer, said) = refused(&asked);
    assert!(pointer == "/template_side" && said.contains("input.target.mirror"), "{pointer}: {said}");
    asked["parameters"] = json!({});
    asked["subjects"][0]["covariates"]["side"] = "left".into();
    let (pointer, said) = refused(&asked);
    assert!(pointer == "/subjects/0/covariates" && said.contains("side"), "{pointer}: {said}");
}

fn equal_to_the_command_whatever_happens(backend: Backend) {
    let place = tempfile::tempdir().unwrap();
    let table = cohort(place.path(), 7);
    let seven = fs::read_to_string(&table).unwrap();
    let six: String = seven.lines().take(7).map(|line| format!("{line}\n")).collect();
    fs::write(&table, six).unwrap();
    let out = place.path().join("out");
    let done = study(&table, &out);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));

    let site = Site::open(backend);
    let mut service = Service::start(&site, &[]);
    let subjects: Vec<Value> = (0..6).map(|k| subject(&service, place.path(), k)).collect();
    let response = service.post("/v1/studies", &asked(subjects));
    assert_eq!(response.status(), 202, "{}", response.text().unwrap());
    let made: Value = response.json().unwrap();
    let id = made["id"].as_str().unwrap().to_owned();
    let path = format!("/v1/studies/{id}");
    assert_eq!((&made["state"], &made["n_subjects"]), (&"queued".into(), &6.into()));

    // Killed after each further match or change of state, and during modeling.
    let (mut kills, mut states) = (0, BTreeSet::new());
    loop {
        let mark = |study: &Value| (study["state"].clone(), study["progress"].clone());
        let before = mark(&service.get(&path));
        let study = service.until(&path, |study| mark(study) != before);
        states.insert(study["state"].as_str().unwrap().to_owned());
        if study["finished_at"].is_string() || kills >= 12 {
            break;
        }
        drop(service);
        kills += 1;
        service = Service::start(&site, &[]);
    }
    assert!(kills >= 5, "{kills} times");
    service.finished(&path);
    assert!(states.contains("matching"), "{states:?}");
    same(&service.archive(&path), &out);

    // No match is computed twice: there are as many as records, and steps are not listed.
    let records = contents(&out.join("matches")).len();
    let matches = service.matches(&id);
    assert_eq!(matches.len(), records);

    // The parts of the result.
    let result = service.get(&format!("{path}/result"));
    assert_eq!(result["found"]["subjects"]["model"], 6);
    let report = service.client.get(service.url(&format!("{path}/report"))).send().unwrap();
    assert!(report.headers()["content-security-policy"].to_str().unwrap().starts_with("sandbox"));
    assert!(report.bytes().unwrap() == fs::read(out.join("report.html")).unwrap());

    // A decision is computed without a match.
    let decision = format!("{path}/subjects/s1/decision");
    let sent =
        service.client.put(service.url(&decision)).json(&json!({"decision": "dropped", "reason": "motion, see scan"}));
    assert_eq!(sent.send().unwrap().status(), 202);
    service.finished(&path);
    assert_eq!(service.matches(&id), matches);
    fs::write(out.join("decisions.csv"), "id,decision,reason\ns1,dropped,\"motion, see scan\"\n").unwrap();
    assert!(study(&table, &out).status.success());
    same(&service.archive(&path), &out);
    let subjects = service.get(&path)["subjects"].clone();
    assert_eq!((&subjects[1]["decision"], &subjects[1]["reason"]), (&"dropped".into(), &"motion, see scan".into()));

    // A further subject costs one match.
    let added = service.post(&format!("{path}/subjects"), &json!({"subjects": [subject(&service, place.path(), 6)]}));
    assert_eq!(added.status(), 202, "{}", added.text().unwrap());
    service.finished(&path);
    let more = service.matches(&id);
    assert!(more.len() == matches.len() + 1 && more.is_superset(&matches));
    fs::write(&table, seven).unwrap();
    assert!(study(&table, &out).status.success());
    same(&service.archive(&path), &out);

    // Deleted with its matches; uploads stay.
    assert_eq!(service.client.delete(service.url(&path)).send().unwrap().status(), 204);
    assert_eq!(service.client.get(service.url(&path)).send().unwrap().status(), 404);
    assert!(service.matches(&id).is_empty());
    let listed = service.get("/v1/meshes");
    assert_eq!(listed["meshes"].as_array().unwrap().len(), 7);
    for mesh in listed["meshes"].as_array().unwrap() {
        let path = format!("/v1/meshes/{}", mesh["id"].as_str().unwrap());
        assert_eq!(service.client.delete(service.url(&path)).send().unwrap().status(), 204);
    }
}

#[test]
fn a_study_is_that_of_the_command_whatever_happens_to_its_processes() {
    equal_to_the_command_whatever_happens(Backend::Sqlite);
}

#[test]
#[ignore = "needs PostgreSQL"]
fn a_study_is_that_of_the_command_on_postgres() {
    equal_to_the_command_whatever_happens(Backend::Postgres);
}

#[test]
fn a_study_that_fails_says_why() {
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 4);
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &["--workers", "2"]);
    let subjects: Vec<Value> = (0..4).map(|k| subject(&service, place.path(), k)).collect();
    let mut body = asked(subjects);
    // No match ends within its time, so there is nothing to build a model from.
    body["parameters"] = serde_json::from_str(ENDLESS).unwrap();
    body["max_run_s"] = json!(1);
    let sent = service.post("/v1/studies", &body);
    assert_eq!(sent.status(), 202, "{}", sent.text().unwrap());
    let path = format!("/v1/studies/{}", sent.json::<Value>().unwrap()["id"].as_str().unwrap());
    let study = service.until(&path, |_| false);
    assert_eq!(study["state"], "failed", "{study}");
    let said = |member: &str| study["error"][member].as_str().unwrap_or_default().to_owned();
    assert!(!said("detail").is_empty() && !said("type").is_empty(), "{study}");
    println!("{study}");
}

#[test]
fn a_study_belongs_to_its_tenant_and_can_be_cancelled() {
    let place = tempfile::tempdir().unwrap();
    cohort(place.path(), 5);
    let site = Site::open(Backend::Sqlite);
    let key = |tenant: &str, role: &str| {
        let mut command = homolog();
        command
            .args(["keys", "create", "--init", "--tenant", tenant, "--role", role, "--data-dir"])
            .arg(site.data_dir());
        let done = command.output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        String::from_utf8(done.stdout).unwrap().trim().to_owned()
    };
    let [own, reader, other] = [key("clinic-a", "submitter"), key("clinic-a", "reader"), key("clinic-b", "submitter")];
    let service = Service::start(&site, &["--auth", "keys", "--workers", "0"]);
    let ask = |method: &str, path: &str, key: &str, body: Option<Value>| {
        let method = reqwest::Method::from_bytes(method.as_bytes()).unwrap();
        let request = service.client.request(method, service.url(path)).bearer_auth(key);
        match body {
            Some(body) => request.json(&body).send().unwrap(),
            None => request.send().unwrap(),
        }
    };
    let problem = |response: Response, status: u16, kind: &str| {
        let at = response.status().as_u16();
        let text = response.text().unwrap();
        assert_eq!(at, status, "{text}");
        assert!(text.contains(&format!("/problems/{kind}\"")), "{text}");
        text
    };
    use base64::Engine as _;
    let subjects: Vec<Value> = (0..5)
        .map(|k| {
            let bytes = fs::read(place.path().join(format!("p{k}/source.ply"))).unwrap();
            let content = base64::prelude::BASE64_STANDARD.encode(bytes);
            json!({"id": format!("s{k}"), "input": {"content_base64": content, "file_name": "Jane Doe.ply"}, "covariates": {"age": 60 + k}})
        })
        .collect();
    let body = json!({"subjects": subjects, "effect": "age", "external_ref": "trial 7", "tags": {"site": "x"}});

    // Faults are found before anything is stored.
    problem(ask("POST", "/v1/studies", &reader, Some(body.clone())), 403, "scope-missing");
    let mut wrong = body.clone();
    wrong["effect"] = "grup".into();
    assert!(problem(ask("POST", "/v1/studies", &own, Some(wrong)), 422, "invalid-request").contains("/effect"));
    let mut wrong = body.clone();
    wrong["subjects"][2]["id"] = "s1".into();
    assert!(problem(ask("POST", "/v1/studies", &own, Some(wrong)), 422, "invalid-request").contains("/subjects/2/id"));
    let mut wrong = body.clone();
    wrong["subjects"][1]["input"] = json!({"mesh_id": format!("blake3:{}", "0".repeat(64))});
    assert!(
        problem(ask("POST", "/v1/studies", &own, Some(wrong)), 422, "invalid-request").contains("/subjects/1/input")
    );
    let listed: Value = ask("GET", "/v1/studies", &own, None).json().unwrap();
    assert_eq!(listed["studies"], json!([]));

    // Equal requests with the same key create one study.
    let send = || {
        let request = service.client.post(service.url("/v1/studies")).bearer_auth(&own).header("idempotency-key", "k1");
        request.json(&body).send().unwrap()
    };
    let first: Value = send().json().unwrap();
    let again = send();
    assert_eq!(again.headers()["idempotency-replayed"], "true");
    assert_eq!(again.json::<Value>().unwrap()["id"], first["id"]);
    let path = format!("/v1/studies/{}", first["id"].as_str().unwrap());
    assert_eq!(first["external_ref"], "trial 7");

    for (method, below) in [
        ("GET", ""),
        ("DELETE", ""),
        ("POST", "/cancel"),
        ("GET", "/result"),
        ("GET", "/report"),
        ("GET", "/archive"),
        ("DELETE", "/subjects/s1/decision"),
    ] {
        problem(ask(method, &format!("{path}{below}"), &other, None), 404, "study-not-found");
    }
    let of_others: Value = ask("GET", "/v1/studies", &other, None).json().unwrap();
    assert_eq!(of_others["studies"], json!([]));
    problem(ask("GET", &format!("{path}/result"), &reader, None), 409, "study-not-ready");
    problem(ask("DELETE", &path, &own, None), 409, "study-active");
    problem(ask("DELETE", &format!("{path}/subjects/s9/decision"), &own, None), 404, "subject-not-found");

    let cancelled = ask("POST", &format!("{path}/cancel"), &own, None);
    assert_eq!((cancelled.status().as_u16(), &cancelled.json::<Value>().unwrap()["state"]), (202, &"cancelled".into()));
    assert_eq!(ask("POST", &format!("{path}/cancel"), &own, None).status(), 202, "again");
    let jobs: Value = ask("GET", "/v1/jobs", &own, None).json().unwrap();
    assert_eq!(jobs["jobs"], json!([]), "the step that plans is hidden");
    let changes: Value = ask("GET", "/v1/changes", &own, None).json().unwrap();
    assert_eq!(changes["changes"], json!([]), "and so are its changes");

    // The database contains neither ids of subjects nor covariates; all data are deleted with the study.
    let blobs = || contents(&site.data_dir()).into_keys().filter(|path| path.starts_with("blobs")).count();
    let database = fs::read(site.data_dir().join("homolog.sqlite-wal")).unwrap();
    assert!(!database.windows(4).any(|w| w == b"Jane"));
    assert_eq!(ask("DELETE", &path, &own, None).status(), 204);
    problem(ask("GET", &path, &own, None), 404, "study-not-found");
    assert_eq!(blobs(), 0);
}

#[test]
fn a_study_that_does_not_fit_is_refused_like_its_pair() {
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &["--auth", "none", "--workers", "0"]);
    let upload = |levels: u32| {
        let mesh = homolog_mesh::shapes::ellipsoid(nalgebra::Vector3::new(12.0, 6.0, 4.0), levels);
        let file = site.folder.path().join(format!("{levels}.ply"));
        fs::write(&file, homolog_formats::write_ply(&mesh)).unwrap();
        service.upload(&file)
    };
    let (large, small) = (upload(6), upload(3));
    let subjects = |mesh: &str| {
        let one = |k: usize| {
            let group = ["a", "b"][k % 2];
            json!({"id": format!("s{k}"), "input": {"mesh_id": mesh}, "covariates": {"group": group}})
        };
        (0..8).map(one).collect::<Vec<Value>>()
    };
    let refused = |path: &str, body: &Value, status: u16, slug: &str| {
        let answer = service.post(path, body);
        assert_eq!(answer.status(), status, "{path}");
        let document: Value = answer.json().unwrap();
        assert!(document["type"].as_str().unwrap().ends_with(slug), "{document}");
        document.to_string()
    };
    // 40,962 vertices a side: too much for the energy over curvature, for a single pair as for a study.
    let parameters = json!({"method": "thesis"});
    let pair = json!({"source": {"mesh_id": large}, "target": {"mesh_id": large}, "parameters": parameters});
    refused("/v1/jobs", &pair, 413, "too-large");
    let study = json!({"subjects": subjects(&large), "parameters": parameters});
    let said = refused("/v1/studies", &study, 413, "too-large");
    assert!(said.contains("the largest match of the study"), "{said}");

    // Names of one sum, each with maps at every vertex.
    let names = |n: usize| (0..n).map(|k| (format!("c{k}"), json!("group:b"))).collect::<serde_json::Map<_, _>>();
    let asked = |mesh: &str, contrasts: usize, permutations: u32| json!({"subjects": subjects(mesh), "effect": "group", "contrasts": names(contrasts), "permutations": permutations});
    let said = refused("/v1/studies", &asked(&small, 1_000, 100), 422, "invalid-request");
    assert!(said.contains("at most 100"), "{said}");
    // Too long for the default run time on any number of cores: 3·10¹² values of t.
    let said = refused("/v1/studies", &asked(&large, 20, 1_000_000), 413, "too-large");
    assert!(
        said.contains("40962 vertices, 3 measures, 21 contrasts and 1000000 permutations would take about"),
        "{said}"
    );
    assert!(said.contains("fewer permutations, measures or contrasts"), "{said}");
    // A study within the limit is accepted.
    let accepted = service.post("/v1/studies", &asked(&small, 3, 1_000));
    assert_eq!(accepted.status(), 202, "{}", accepted.text().unwrap());

    // The limit is the one of a match.
    drop(service);
    let service = Service::start(&site, &["--auth", "none", "--workers", "0", "--max-match-bytes", "300000000"]);
    let answer = service.post("/v1/studies", &asked(&large, 50, 10));
    let (status, said) = (answer.status().as_u16(), answer.text().unwrap());
    assert!(status == 413 && said.contains("8 subjects with a template of 40962 vertices"), "{status} {said}");
}

#[test]
fn what_would_compute_too_long_is_refused_as_pair_batch_and_study() {
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &["--auth", "none", "--workers", "0", "--max-processor-s", "3"]);
    let mesh = homolog_mesh::shapes::ellipsoid(nalgebra::Vector3::new(12.0, 6.0, 4.0), 3);
    let file = site.folder.path().join("mesh.ply");
    fs::write(&file, homolog_formats::write_ply(&mesh)).unwrap();
    let mesh = service.upload(&file);
    let subjects: Vec<Value> = (0..8)
        .map(|k| {
            let group = ["a", "b"][k % 2];
            json!({"id": format!("s{k}"), "input": {"mesh_id": mesh}, "covariates": {"group": group}})
        })
        .collect();
    let forms = |parameters: Value, permutations: u32| {
        let one = json!({"mesh_id": mesh});
        [
            ("/v1/jobs", json!({"source": one, "target": one, "parameters": parameters})),
            ("/v1/batches", json!({"pairs": [{"source": one, "target": one}], "parameters": parameters})),
            (
                "/v1/studies",
                json!({"subjects": subjects, "effect": "group", "permutations": permutations, "parameters": parameters}),
            ),
        ]
    };
    let refused = |path: &str, body: &Value, advice: &str| {
        let answer = service.post(path, body);
        let (status, said) = (answer.status().as_u16(), answer.text().unwrap());
        assert!(status == 413 && said.contains("/problems/too-large"), "{path}: {status} {said}");
        assert!(said.contains("s of processor time, which exceeds the limit of 3 s"), "{path}: {said}");
        assert!(said.contains(advice), "{path}: {said}");
    };
    let long = json!({"method": "thesis", "inference": {"max_iterations": 100_000}});
    for (path, body) in forms(long, 100) {
        refused(path, &body, "fewer inference.max_iterations");
    }
    let [pair, batch, study] = forms(json!({}), 1_000_000);
    refused(study.0, &study.1, "fewer permutations");
    let [.., (path, shorter)] = forms(json!({}), 100);
    for (path, body) in [pair, batch, (path, shorter)] {
        let accepted = service.post(path, &body);
        assert!(accepted.status().is_success(), "{path}: {}", accepted.text().unwrap());
    }
}
