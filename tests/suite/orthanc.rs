//! The recipe of `deploy/orthanc`: a segmentation arrives in Orthanc, and its registration comes back, despite restarts
//! of each part.

use super::jobs_support::TestService;
use crate::patience::PATIENCE;
use homolog::worker::match_engine::MatchEngine;
use homolog_formats::write_zip;
use homolog_run::intake::IntakeLimits;
use serde_json::{Value, json};
use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A process that ends with the test.
struct Running(Child);

impl Running {
    fn start(command: &mut Command) -> Self {
        Running(command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap())
    }

    /// Asks the process to end, and waits until it has.
    fn stop(mut self) {
        Command::new("kill").arg(self.0.id().to_string()).status().unwrap();
        self.0.wait().unwrap();
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

struct Orthanc {
    folder: PathBuf,
    base: String,
    client: reqwest::Client,
}

impl Orthanc {
    fn new(folder: PathBuf) -> Self {
        let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        fs::create_dir_all(&folder).unwrap();
        homolog::tls::prepare();
        let settings = json!({
            "StorageDirectory": folder.join("db"), "IndexDirectory": folder.join("db"), "HttpPort": port,
            "DicomServerEnabled": false, "RemoteAccessAllowed": false, "AuthenticationEnabled": false, "Plugins": [],
        });
        fs::write(folder.join("config.json"), settings.to_string()).unwrap();
        Orthanc { folder, base: format!("http://127.0.0.1:{port}"), client: reqwest::Client::new() }
    }

    async fn start(&self) -> Running {
        let program = ["/usr/sbin/Orthanc", "/usr/bin/Orthanc"].into_iter().find(|path| Path::new(path).exists());
        let running = Running::start(Command::new(program.unwrap_or("Orthanc")).arg(self.folder.join("config.json")));
        let began = Instant::now();
        while self.client.get(format!("{}/system", self.base)).send().await.is_err() {
            assert!(began.elapsed() < PATIENCE, "Orthanc does not answer");
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
        running
    }

    async fn get(&self, path: &str) -> (u16, Vec<u8>) {
        let answer = self.client.get(format!("{}{path}", self.base)).send().await.unwrap();
        (answer.status().as_u16(), answer.bytes().await.unwrap().to_vec())
    }

    async fn json(&self, path: &str) -> Value {
        serde_json::from_slice(&self.get(path).await.1).unwrap()
    }

    /// The metadata of an instance, once it exists.
    async fn note_on(&self, instance: &str) -> String {
        let began = Instant::now();
        loop {
            match self.get(&format!("/instances/{instance}/metadata/1024")).await {
                (200, text) => return String::from_utf8(text).unwrap(),
                _ => assert!(began.elapsed() < PATIENCE, "nothing came back"),
            }
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
    }
}

fn python(script: &str, arguments: &[&Path]) {
    let program = root().join("target/readers-env/bin/python");
    let done = Command::new(program).arg(root().join("tests/readers").join(script)).args(arguments).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
}

#[test]
#[ignore = "needs dciodvfy and the Python environment that scripts/setup campaigns makes"]
fn a_bent_structure_is_a_segmentation_on_the_grid_of_the_target() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let homolog = |arguments: &[&str], paths: &[&Path]| {
        let done = Command::new(env!("CARGO_BIN_EXE_homolog")).args(arguments).args(paths).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        done.stdout
    };
    homolog(&["phantom", "--spacing", "1.5", "--rotate-seed", "7", "--out"], &[folder.path()]);
    for (name, study) in [("source", "1.2.3.4.5"), ("target", "1.2.3.4.6")] {
        python("make_seg.py", &[&at(&format!("{name}.nii.gz")), &at(&format!("{name}.dcm")), Path::new(study)]);
    }
    homolog(&["match", "--out"], &[&at("out"), &at("source.dcm"), &at("target.dcm")]);
    let files = ["out/warped.dcm", "out/warped.ply", "target.dcm", "target.nii.gz", "target.nrrd"].map(&at);
    python("check_segmentation.py", &files.each_ref().map(PathBuf::as_path));
    let checked = Command::new("dciodvfy").arg(at("out/warped.dcm")).output().unwrap();
    let said = String::from_utf8_lossy(&checked.stderr);
    assert!(said.contains("Segmentation") && !said.contains("Error"), "{said}");
    // The written segmentation is read like any other; a folder of instances, their archive and one file are the same
    // input.
    let topology = |name: &str| {
        let seen: Value = serde_json::from_slice(&homolog(&["inspect", "--json"], &[&at(name)])).unwrap();
        assert!(seen["suitable"].as_bool().unwrap(), "{name}: {seen}");
        seen["topology"].clone()
    };
    topology("out/warped.dcm");
    assert_eq!(topology("target.nrrd"), topology("target.nii.gz"));
    fs::create_dir_all(at("study/series")).unwrap();
    fs::copy(at("target.dcm"), at("study/series/1")).unwrap();
    fs::write(at("study/notes.txt"), "not a DICOM file").unwrap();
    assert_eq!(topology("study"), topology("target.dcm"));
    fs::write(at("target.zip"), write_zip(&[("a/1".to_owned(), fs::read(at("target.dcm")).unwrap())]).unwrap())
        .unwrap();
    assert_eq!(topology("target.zip"), topology("target.dcm"));
    fs::remove_file(at("study/series/1")).unwrap();
    let refused = Command::new(env!("CARGO_BIN_EXE_homolog")).arg("inspect").arg(at("study")).output().unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("is a folder without DICOM files"));
}

#[tokio::test]
#[ignore = "needs Orthanc, dciodvfy and the Python environment that scripts/setup campaigns makes"]
async fn a_registration_comes_back_to_the_study_whatever_is_restarted() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let made = Command::new(env!("CARGO_BIN_EXE_homolog"))
        .args(["phantom", "--spacing", "1.5", "--rotate-seed", "7", "--out"])
        .arg(folder.path())
        .output();
    assert!(made.unwrap().status.success());
    python("make_seg.py", &[&at("source.nii.gz"), &at("source.dcm"), Path::new("1.2.3.4.5")]);
    let bridge = |orthanc: &Orthanc, homolog: &str| {
        let mut command = Command::new("python3");
        command.arg(root().join("deploy/orthanc/homolog_bridge.py")).args(["--orthanc", &orthanc.base]);
        command.args(["--homolog", homolog, "--every-s", "0.2", "--template"]).arg(at("target.nii.gz"));
        Running::start(command.arg("--state").arg(at("bridge.json")))
    };

    // The segmentation arrives while homolog is stopped.
    let orthanc = Orthanc::new(at("orthanc"));
    let running = orthanc.start().await;
    let arrived = orthanc.client.post(format!("{}/instances", orthanc.base)).body(fs::read(at("source.dcm")).unwrap());
    let arrived: Value = arrived.send().await.unwrap().json().await.unwrap();
    let (instance, study) = (arrived["ID"].as_str().unwrap(), arrived["ParentStudy"].as_str().unwrap());
    let first = bridge(&orthanc, "http://127.0.0.1:9");
    let began = Instant::now();
    while !fs::read_to_string(at("bridge.json")).is_ok_and(|state| state.contains(instance)) {
        assert!(began.elapsed() < PATIENCE, "the bridge does not see the segmentation");
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    first.stop();
    running.stop();

    // All three are started again; the segmentation is submitted only now.
    let running = orthanc.start().await;
    let data = Arc::new(tempfile::tempdir().unwrap());
    let start = || {
        let engine = Arc::new(MatchEngine::new(IntakeLimits::default(), 0));
        TestService::start_with(Arc::clone(&data), &[], Some(engine))
    };
    let service = start().await;
    let second = bridge(&orthanc, &service.base);
    let note = orthanc.note_on(instance).await;
    assert!(note.starts_with("homolog: reliable; registration "), "{note}");
    let registration = note.rsplit(' ').next().unwrap().to_owned();
    second.stop();
    service.end().await;
    let series = orthanc.json(&format!("/studies/{study}/series")).await;
    let mut modalities: Vec<_> =
        series.as_array().unwrap().iter().map(|s| s["MainDicomTags"]["Modality"].as_str().unwrap()).collect();
    modalities.sort_unstable();
    assert_eq!(modalities, ["REG", "SEG"], "in the same study");
    let (status, page) = orthanc.get(&format!("/instances/{registration}/attachments/1024/data")).await;
    let page = String::from_utf8(page).unwrap();
    assert!(status == 200 && page.starts_with("<!doctype html>") && page.contains("RELIABLE"), "{status}");
    assert!(!page.contains("Doe^Jane") && !page.contains("4711"), "the report has no names");

    // A bridge that has lost its state, and a restarted service, repeat nothing.
    fs::remove_file(at("bridge.json")).unwrap();
    orthanc.client.delete(format!("{}/instances/{instance}/metadata/1024", orthanc.base)).send().await.unwrap();
    let service = start().await;
    let third = bridge(&orthanc, &service.base);
    assert!(orthanc.note_on(instance).await.ends_with(&registration));
    third.stop();
    assert_eq!(orthanc.json("/statistics").await["CountInstances"], 2);
    let jobs = service.json("/v1/jobs").await;
    let [job] = jobs["jobs"].as_array().unwrap().as_slice() else { panic!("one job: {jobs}") };
    assert_eq!((&job["reliable"], &job["external_ref"]), (&json!(true), &json!(instance)));

    // The registration equals the one that the service computed, and is a valid object.
    let transform = service.json(&format!("{}/transform", job["links"]["self"].as_str().unwrap())).await;
    service.end().await;
    fs::write(at("transform.json"), transform.to_string()).unwrap();
    fs::write(at("registration.dcm"), orthanc.get(&format!("/instances/{registration}/file")).await.1).unwrap();
    running.stop();
    python("check_registration.py", &[&at("registration.dcm"), &at("source.dcm"), &at("transform.json")]);
    let checked = Command::new("dciodvfy").arg(at("registration.dcm")).output().unwrap();
    let said = String::from_utf8_lossy(&checked.stderr);
    assert!(said.contains("SpatialRegistration") && !said.contains("Error"), "{said}");
}
