//! The real program in a separate process: killed, terminated, and sent malformed requests.

use super::cli::homolog;
use crate::patience::PATIENCE;
use homolog_formats::{write_nifti, write_nifti_gz, write_ply, write_stl, write_vtk};
use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use reqwest::blocking::multipart::{Form, Part};
use reqwest::blocking::{Client, Response};
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

/// Parameters of a match with a hundred iterations over all vertices, many times longer than a test takes to look at the job once.
pub(crate) const SLOW: &str = r#"{"inference": {"coarse_vertices": null, "max_iterations": 100, "tolerance": 0}}"#;

/// Parameters of a match that no test lives to see the end of: sampling does not converge, and these are 100,000 sweeps over all
/// pairs of vertices and labels.
pub(crate) const ENDLESS: &str =
    r#"{"method": "gibbs", "inference": {"coarse_vertices": null, "max_iterations": 100000}}"#;

/// A service process; killed when dropped, so that no test leaves one behind.
pub(crate) struct Server {
    process: Child,
    pub base: String,
    pub client: Client,
}

impl Server {
    pub(crate) fn start(data_dir: &Path, more: &[&str]) -> Self {
        homolog::tls::prepare();
        let mut process = homolog()
            .args(["serve", "--listen", "127.0.0.1:0", "--log", "warn", "--data-dir"])
            .arg(data_dir)
            .args(more)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let base = line.split_whitespace().find(|word| word.starts_with("http://")).expect("an address").to_owned();
        let client = Client::builder().timeout(Duration::from_secs(60)).build().unwrap();
        Server { process, base, client }
    }

    pub(crate) fn get(&self, path: &str) -> Value {
        self.client.get(format!("{}{path}", self.base)).send().unwrap().json().unwrap()
    }

    /// Submits a match that does not end by itself.
    pub(crate) fn submit_endless(&self, source: &[u8], target: &[u8]) -> String {
        self.submit_with(source, target, ENDLESS)
    }

    pub(crate) fn submit_with(&self, source: &[u8], target: &[u8], parameters: &str) -> String {
        let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("a.ply");
        let form = Form::new()
            .part("source", file(source))
            .part("target", file(target))
            .text("parameters", parameters.to_owned());
        let response = self.client.post(format!("{}/v1/jobs", self.base)).multipart(form).send().unwrap();
        assert_eq!(response.status(), 202, "{}", response.text().unwrap());
        response.json::<Value>().unwrap()["id"].as_str().unwrap().to_owned()
    }

    /// As [`Server::submit_with`], without the cached result of an equal job.
    pub(crate) fn submit_anew(&self, source: &[u8], target: &[u8], parameters: &str) -> String {
        let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("a.ply");
        let form = Form::new().part("source", file(source)).part("target", file(target));
        let form = form.text("parameters", parameters.to_owned()).text("use_cache", "false");
        let response = self.client.post(format!("{}/v1/jobs", self.base)).multipart(form).send().unwrap();
        assert_eq!(response.status(), 202, "{}", response.text().unwrap());
        response.json::<Value>().unwrap()["id"].as_str().unwrap().to_owned()
    }

    pub(crate) fn until(&self, id: &str, done: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let job = self.get(&format!("/v1/jobs/{id}"));
            if done(&job) {
                return job;
            }
            assert!(began.elapsed() < PATIENCE, "still {job}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// SIGKILL.
    pub(crate) fn kill(mut self) {
        self.process.kill().unwrap();
        self.process.wait().unwrap();
    }

    /// SIGTERM; returns the exit code.
    fn terminate(mut self) -> Option<i32> {
        let sent = std::process::Command::new("kill").arg(self.process.id().to_string()).status().unwrap();
        assert!(sent.success());
        self.process.wait().unwrap().code()
    }

    /// The process.
    pub(crate) fn pid(&self) -> u32 {
        self.process.id()
    }

    /// Peak resident memory, MiB.
    pub(crate) fn peak_memory_mib(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.process.id())).unwrap();
        let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:")).unwrap();
        line.trim().trim_end_matches("kB").trim().parse::<u64>().unwrap() / 1024
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A pair of phantom surfaces large enough that a match takes a while.
pub(crate) fn pair(folder: &Path) -> [Vec<u8>; 2] {
    let arguments = ["phantom", "--kind", "surface", "--edge", "1.2", "--rotate-seed", "4", "--out"];
    assert!(homolog().args(arguments).arg(folder).output().unwrap().status.success());
    ["source.ply", "target.ply"].map(|name| std::fs::read(folder.join(name)).unwrap())
}

#[test]
fn a_job_survives_the_death_of_its_process() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let data_dir = folder.path().join("data");
    let server = Server::start(&data_dir, &["--workers", "1"]);
    let running = server.submit_with(&source, &target, SLOW);
    let waiting = server.submit_with(&target, &source, SLOW);
    // Killed when a part of the trace is on disk, so that duplicates would be detected.
    server.until(&running, |job| {
        assert_ne!(job["state"], "succeeded", "too fast to be killed");
        job["state"] == "running" && job["progress"]["iteration"].as_u64() > Some(1)
    });
    let traced = server.get(&format!("/v1/jobs/{running}/trace"))["points"].as_array().unwrap().len();
    assert!(traced > 0);
    server.kill();

    let server = Server::start(&data_dir, &[]);
    let jobs = [&running, &waiting].map(|id| server.until(id, |job| job["finished_at"].is_string()));
    for (job, attempts) in jobs.iter().zip([2, 1]) {
        assert_eq!((&job["state"], job["attempt"].as_u64()), (&"succeeded".into(), Some(attempts)), "{job}");
        let id = job["id"].as_str().unwrap();
        let trace = server.get(&format!("/v1/jobs/{id}/trace?limit=10000"));
        let seqs: Vec<_> = trace["points"].as_array().unwrap().iter().map(|p| p["seq"].as_u64().unwrap()).collect();
        assert!(seqs.len() >= traced);
        assert_eq!(seqs, (1..=seqs.len() as u64).collect::<Vec<_>>(), "no point twice, none missing");
        assert_eq!(trace["complete"], true);
        let result = server.get(&format!("/v1/jobs/{id}/result"));
        assert_eq!(result["transform"]["matrix"].as_array().unwrap().len(), 4);
        let brief = server.get(&format!("/v1/jobs/{id}/result?correspondences=false"));
        let n_vertices = brief["provenance"]["source"]["n_vertices"].as_u64().unwrap();
        assert_eq!(result["correspondences"]["source"].as_array().unwrap().len() as u64, n_vertices);
    }
    assert_eq!(server.terminate(), Some(0));
}

#[test]
fn a_running_job_is_cancelled_long_before_its_end() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &[]);
    let id = server.submit_endless(&source, &target);
    server.until(&id, |job| job["progress"]["iteration"].as_u64() > Some(0));
    let response = server.client.post(format!("{}/v1/jobs/{id}/cancel", server.base)).send().unwrap();
    assert_eq!(response.status(), 202);
    let job = server.until(&id, |job| job["finished_at"].is_string());
    assert_eq!(job["state"], "cancelled");
    assert_eq!(server.terminate(), Some(0));
}

#[test]
fn sigterm_during_a_job_exits_with_0_and_requeues_it() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let data_dir = folder.path().join("data");
    let server = Server::start(&data_dir, &["--shutdown-grace-ms", "0"]);
    let id = server.submit_endless(&source, &target);
    server.until(&id, |job| job["state"] == "running");
    assert_eq!(server.terminate(), Some(0));
    let server = Server::start(&data_dir, &["--workers", "0"]);
    let job = server.get(&format!("/v1/jobs/{id}"));
    assert_eq!((&job["state"], &job["attempt"]), (&"queued".into(), &0.into()));
}

#[test]
fn a_public_address_requires_a_flag_and_a_folder_is_served_once() {
    let folder = tempfile::tempdir().unwrap();
    let serve = |listen: &str| {
        let done = homolog()
            .args(["serve", "--listen", listen, "--auth", "none", "--data-dir"])
            .arg(folder.path())
            .output()
            .unwrap();
        assert!(!done.status.success());
        String::from_utf8(done.stderr).unwrap()
    };
    assert!(serve("0.0.0.0:0").contains("--insecure"));
    let _server = Server::start(folder.path(), &[]);
    assert!(serve("127.0.0.1:0").contains("another `homolog serve`"));
}

/// A small closed surface.
fn tetrahedron() -> SurfaceMesh {
    let corners = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 9.0]];
    let vertices = corners.map(|[x, y, z]| Point3::new(x, y, z)).to_vec();
    SurfaceMesh::new(vertices, FaceArity::Triangle, vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]).unwrap()
}

/// Well-formed files of every format, small enough that most flipped bits are in their headers.
fn well_formed() -> Vec<(&'static str, Vec<u8>)> {
    let mesh = tetrahedron();
    let labels = (0..125).map(|i| u32::from(i % 25 % 7 == 3)).collect();
    let volume = LabelVolume::new([5, 5, 5], labels, Matrix4::identity()).unwrap();
    let ascii = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    vec![
        ("a.ply", write_ply(&mesh)),
        ("b.ply", ascii.to_vec()),
        ("c.stl", write_stl(&mesh)),
        ("d.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n".to_vec()),
        ("e.vtk", write_vtk(&mesh)),
        ("f.nii", write_nifti(&volume)),
        ("g.nii.gz", write_nifti_gz(&volume)),
    ]
}

/// A malformed submission of kind `n`.
fn malformed(
    client: &Client,
    url: &str,
    n: usize,
    rng: &mut Xoshiro256PlusPlus,
    files: &[(&str, Vec<u8>)],
) -> Response {
    let post = || client.post(url);
    let mut below = |bound: usize| (rng.next_u64() % bound as u64) as usize;
    let (name, whole) = &files[below(files.len())];
    let mut bytes = whole.clone();
    let file = |bytes: Vec<u8>, name: &str| Part::bytes(bytes).file_name(name.to_owned());
    // The target is always invalid, so that the submission is refused even if the source is still valid.
    let with_source = |bytes: Vec<u8>, name: &str| {
        Form::new().part("source", file(bytes, name)).part("target", file(b"nonsense".to_vec(), "t.ply"))
    };
    let request = match n % 8 {
        0 => {
            let random = (0..below(3000)).map(|_| below(256) as u8).collect();
            post().multipart(with_source(random, name))
        }
        1 => {
            bytes.truncate(below(whole.len()));
            post().multipart(with_source(bytes, name))
        }
        2 | 3 => {
            for _ in 0..=below(8) {
                let at = below(bytes.len().min(if n % 8 == 2 { 400 } else { usize::MAX }));
                bytes[at] ^= 1 << below(8);
            }
            post().multipart(with_source(bytes, name))
        }
        4 => {
            let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
            if !digits.is_empty() {
                let at = digits[below(digits.len())];
                bytes.splice(at..at, b"99999999".iter().copied());
            }
            post().multipart(with_source(bytes, name))
        }
        5 => {
            let mut body =
                b"--x\r\nContent-Disposition: form-data; name=\"source\"; filename=\"a.ply\"\r\n\r\n".to_vec();
            body.extend_from_slice(whole);
            body.extend_from_slice(b"\r\n--x--\r\n");
            let cut = below(body.len() - 8);
            body.truncate(cut);
            post().header("content-type", "multipart/form-data; boundary=x").body(body)
        }
        6 => {
            let kinds =
                ["application/json", "text/plain", "multipart/mixed; boundary=x", "multipart/form-data", "", "\u{e9}"];
            post().header("content-type", kinds[below(kinds.len())].as_bytes()).body(bytes)
        }
        _ => {
            let texts = [
                "{",
                "[1,2",
                "{\"seed\": -1}",
                "{\"seed\": 1e999}",
                "{\"energy\": {\"alpha\": \"x\"}}",
                "nul",
                "{\"features\": []}",
                "{\"input\": {\"labels\": [0]}}",
                "\u{0}",
                "{\"method\": {}}",
            ];
            let nested = "[".repeat(100_000);
            let text = texts.get(below(texts.len() + 1)).map_or(nested, |text| (*text).to_owned());
            post().multipart(with_source(bytes, name).text("parameters", text))
        }
    };
    request.send().unwrap()
}

#[test]
fn a_thousand_malformed_submissions_are_each_refused() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(folder.path(), &[]);
    let url = format!("{}/v1/jobs", server.base);
    let files = well_formed();
    std::thread::scope(|scope| {
        for thread in 0..4 {
            let (client, url, files) = (&server.client, &url, &files);
            scope.spawn(move || {
                let mut rng = Xoshiro256PlusPlus::seed_from_u64(thread);
                for n in 0..250 {
                    let response = malformed(client, url, n, &mut rng, files);
                    let status = response.status();
                    let media_type = response.headers().get("content-type").cloned();
                    let text = response.text().unwrap();
                    assert!(status.is_client_error(), "thread {thread}, submission {n}: {status} {text}");
                    assert_eq!(media_type.unwrap(), "application/problem+json", "{text}");
                }
            });
        }
    });
    assert!(server.get("/v1/jobs")["jobs"].as_array().unwrap().is_empty());
    assert_eq!(server.get("/healthz")["status"], "alive");
    let peak = server.peak_memory_mib();
    assert!(peak < 256, "{peak} MiB");
    assert_eq!(server.terminate(), Some(0));
}

#[test]
fn a_pair_too_large_to_match_is_refused_before_it_is_queued() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &["--max-match-bytes", "1000000"]);
    let form = Form::new().part("source", Part::bytes(source)).part("target", Part::bytes(target));
    let response = server.client.post(format!("{}/v1/jobs", server.base)).multipart(form).send().unwrap();
    assert_eq!(response.status(), 413);
    let problem: Value = response.json().unwrap();
    assert_eq!(problem["type"], "/problems/too-large");
    assert!(problem["detail"].as_str().unwrap().contains("1000000 are allowed"), "{problem}");
    assert!(server.get("/v1/jobs")["jobs"].as_array().unwrap().is_empty());
}

#[test]
fn an_unknown_query_parameter_submits_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &[]);
    let form = Form::new().part("source", Part::bytes(source)).part("target", Part::bytes(target));
    let url = format!("{}/v1/jobs?dry_run=true", server.base);
    let response = server.client.post(url).multipart(form).send().unwrap();
    assert_eq!(response.status(), 400);
    assert_eq!(response.json::<Value>().unwrap()["type"], "/problems/invalid-query");
    assert!(server.get("/v1/jobs")["jobs"].as_array().unwrap().is_empty());
}

#[test]
fn a_body_that_does_not_arrive_is_answered_with_408() {
    use std::io::{Read, Write};
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(&folder.path().join("data"), &["--upload-timeout-s", "1"]);
    let mut stream = std::net::TcpStream::connect(server.base.trim_start_matches("http://")).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    let head = "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; boundary=b\r\n\
                Content-Length: 1000\r\n\r\n--b\r\nContent-Disposition: form-data; name=\"source\"; filename=\"a.ply\"\r\n\r\nply";
    stream.write_all(head.as_bytes()).unwrap();
    let mut answer = [0u8; 4096];
    let n = stream.read(&mut answer).unwrap();
    let answer = String::from_utf8_lossy(&answer[..n]);
    assert!(answer.starts_with("HTTP/1.1 408"), "{answer}");
    assert!(answer.contains("application/problem+json") && answer.contains("/problems/upload-timeout"), "{answer}");
}
