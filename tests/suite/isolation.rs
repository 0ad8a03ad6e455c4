//! Computations in separate processes: the result has the same bytes, nothing else is harmed, and nothing is left
//! behind.
//!
//! The service is the built program where a test needs real computations. A child is a process whose parent is the
//! service; a computing child has threads with the name of computations.

use super::faults::length;
use super::jobs_support::TestService;
use super::process::{ENDLESS, SLOW, Server, pair};
use crate::patience::PATIENCE;
use homolog::jobs::engine::{MethodDescription, Resolved};
use homolog::jobs::{
    Computation, ComputeError, ComputeInputs, Demand, Engine, Failure, InputBytes, InputRefusal, InputSummary,
    InputView, OutOfProcess, ParameterFault, SurfaceSize,
};
use homolog::worker::isolation::{IsolatedEngine, IsolationSettings};
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes;
use homolog_primitives::observe::Observer;
use homolog_run::intake::IntakeLimits;
use reqwest::blocking::multipart::{Form, Part};
use serde_json::{Value, json};
use std::fs;
use std::sync::Arc;
use std::time::{Duration, Instant};

const ISOLATED: [&str; 2] = ["--isolation", "process"];
/// Processes whose parent is this one.
fn children(parent: u32) -> Vec<u32> {
    let of = |entry: fs::DirEntry| {
        let pid: u32 = entry.file_name().to_str()?.parse().ok()?;
        let stat = fs::read_to_string(entry.path().join("stat")).ok()?;
        let (_, fields) = stat.rsplit_once(')')?;
        let mut fields = fields.split_whitespace();
        let (state, of) = (fields.next()?, fields.next()?.parse::<u32>().ok()?);
        (of == parent && state != "Z").then_some(pid)
    };
    fs::read_dir("/proc").unwrap().filter_map(|entry| of(entry.ok()?)).collect()
}

fn exists(pid: u32) -> bool {
    let stat = fs::read_to_string(format!("/proc/{pid}/stat"));
    stat.is_ok_and(|stat| stat.rsplit_once(')').is_some_and(|(_, fields)| !fields.trim_start().starts_with('Z')))
}

/// Whether a process has threads of a computation.
fn computes(pid: u32) -> bool {
    let Ok(tasks) = fs::read_dir(format!("/proc/{pid}/task")) else { return false };
    let name = |task: fs::DirEntry| fs::read_to_string(task.path().join("comm")).unwrap_or_default();
    tasks.flatten().any(|task| name(task).starts_with("compute-"))
}

/// The children that compute.
fn computing(parent: u32) -> Vec<u32> {
    children(parent).into_iter().filter(|&pid| computes(pid)).collect()
}

/// A pair of phantom surfaces whose match takes a fraction of a second.
fn small_pair(folder: &std::path::Path, edge_mm: &str) -> [Vec<u8>; 2] {
    let arguments = ["phantom", "--kind", "surface", "--edge", edge_mm, "--rotate-seed", "4", "--out"];
    assert!(super::cli::homolog().args(arguments).arg(folder).output().unwrap().status.success());
    ["source.ply", "target.ply"].map(|name| fs::read(folder.join(name)).unwrap())
}

fn eventually<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let began = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(began.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn kill(pid: u32) {
    let pid = rustix::process::Pid::from_raw(pid as i32).unwrap();
    rustix::process::kill_process(pid, rustix::process::Signal::KILL).unwrap();
}

/// A document without times and without the addresses of its job.
fn timeless(mut document: Value) -> Value {
    for member in ["timings_ms", "links"] {
        assert!(document.as_object_mut().unwrap().remove(member).is_some());
    }
    document
}

/// All results of a job, as bytes.
fn everything(server: &Server, id: &str) -> Vec<(String, Vec<u8>)> {
    let bytes = |path: &str, accept: &str| {
        let request = server.client.get(format!("{}/v1/jobs/{id}/{path}", server.base)).header("accept", accept);
        let response = request.send().unwrap();
        assert_eq!(response.status(), 200, "{path}");
        response.bytes().unwrap().to_vec()
    };
    let mut parts: Vec<(String, Vec<u8>)> =
        ["correspondences", "transform", "surfaces/source", "surfaces/target", "aligned", "warped"]
            .map(|path| (path.to_owned(), bytes(path, "*/*")))
            .to_vec();
    parts.push(("correspondences as CSV".to_owned(), bytes("correspondences", "text/csv")));
    let result = timeless(server.get(&format!("/v1/jobs/{id}/result")));
    parts.push(("result".to_owned(), result.to_string().into_bytes()));
    let mut trace = server.get(&format!("/v1/jobs/{id}/trace?limit=10000"));
    for point in trace["points"].as_array_mut().unwrap() {
        assert!(point.as_object_mut().unwrap().remove("elapsed_ms").is_some());
    }
    parts.push(("trace".to_owned(), trace["points"].to_string().into_bytes()));
    let job = server.get(&format!("/v1/jobs/{id}"));
    parts.push(("inputs".to_owned(), json!([job["source"], job["target"]]).to_string().into_bytes()));
    parts
}

#[test]
fn a_match_has_the_same_bytes_isolated_and_in_threads() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = small_pair(&folder.path().join("pair"), "2");
    let outcomes = ["process", "none"].map(|isolation| {
        let server = Server::start(&folder.path().join(isolation), &["--isolation", isolation]);
        assert_eq!(children(server.pid()).is_empty(), isolation == "none");
        ["{}", SLOW].map(|parameters| {
            let id = server.submit_with(&source, &target, parameters);
            let job = server.until(&id, |job| job["finished_at"].is_string());
            assert_eq!(job["state"], "succeeded", "{job}");
            everything(&server, &id)
        })
    });
    for (isolated, threads) in outcomes[0].iter().zip(&outcomes[1]) {
        for ((part, isolated), (_, threads)) in isolated.iter().zip(threads) {
            assert!(isolated == threads, "{part} differs");
        }
    }
}

#[test]
fn refusals_are_the_same_isolated_and_in_threads() {
    let folder = tempfile::tempdir().unwrap();
    let whole = write_ply(&shapes::ellipsoid([9.0, 6.0, 4.0].into(), 2));
    let cut = whole[..whole.len() - 7].to_vec();
    let files: [&[u8]; 4] = [b"nonsense", &cut, b"solid x\nendsolid x\n", b""];
    let refusals = ["process", "none"].map(|isolation| {
        let server = Server::start(&folder.path().join(isolation), &["--isolation", isolation]);
        files.map(|bytes| {
            let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("a.ply");
            let form = Form::new().part("source", file(bytes)).part("target", file(&whole));
            let response = server.client.post(format!("{}/v1/jobs", server.base)).multipart(form).send().unwrap();
            assert!(response.status().is_client_error());
            let mut problem: Value = response.json().unwrap();
            problem.as_object_mut().unwrap().remove("request_id");
            problem.as_object_mut().unwrap().remove("instance");
            problem
        })
    });
    assert_eq!(refusals[0], refusals[1]);
}

#[test]
fn a_killed_child_takes_nothing_with_it_and_its_job_ends_right() {
    let folder = tempfile::tempdir().unwrap();
    let data_dir = folder.path().join("data");
    let [source, target] = pair(&folder.path().join("pair"));
    let server =
        Server::start(&data_dir, &["--isolation", "process", "--cores", "2", "--workers", "2", "--auth", "keys"]);
    let key = |tenant: &str| {
        let mut command = super::cli::homolog();
        command.args(["keys", "create", "--tenant", tenant, "--scope", "submit", "--scope", "read", "--data-dir"]);
        let done = command.arg(&data_dir).output().unwrap();
        assert!(done.status.success(), "{done:?}");
        String::from_utf8(done.stdout).unwrap().split_whitespace().last().unwrap().to_owned()
    };
    let keys = [key("victim"), key("neighbor")];
    let small = small_pair(&folder.path().join("small"), "3");
    let submit = |key: &str, parameters: &str| {
        let [source, target] = if parameters == SLOW { [&source, &target] } else { [&small[0], &small[1]] };
        let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("a.ply");
        let form = Form::new().part("source", file(source)).part("target", file(target));
        // Computed again each time, although the requests are equal.
        let form = form.text("parameters", parameters.to_owned()).text("use_cache", "false");
        let request = server.client.post(format!("{}/v1/jobs", server.base)).bearer_auth(key).multipart(form);
        request.send().unwrap().json::<Value>().unwrap()["id"].as_str().unwrap().to_owned()
    };
    let get = |key: &str, path: &str| {
        server.client.get(format!("{}{path}", server.base)).bearer_auth(key).send().unwrap().json::<Value>().unwrap()
    };
    let finished = |key: &str, id: &str| {
        let began = Instant::now();
        loop {
            let job = get(key, &format!("/v1/jobs/{id}"));
            if job["finished_at"].is_string() {
                return job;
            }
            assert!(began.elapsed() < PATIENCE, "{job}");
            std::thread::sleep(Duration::from_millis(5));
        }
    };
    let right = |job: &Value| assert_eq!((&job["state"], &job["attempt"]), (&json!("succeeded"), &json!(1)), "{job}");
    let expected = {
        let id = submit(&keys[0], "{}");
        right(&finished(&keys[0], &id));
        timeless(get(&keys[0], &format!("/v1/jobs/{id}/result")))
    };
    let mut neighbor: Option<(String, u32)> = None;
    let (mut n_killed, mut n_jobs, mut n_ended) = (0, 0, 0);
    while n_killed < length(20, 200) {
        if let Some((id, pid)) = neighbor.take() {
            match exists(pid) && computes(pid) {
                true => neighbor = Some((id, pid)),
                false => {
                    right(&finished(&keys[1], &id));
                    n_ended += 1;
                }
            }
        }
        let (_, pid) = neighbor.get_or_insert_with(|| {
            let id = submit(&keys[1], SLOW);
            (id, eventually("the neighbor's job runs", || computing(server.pid()).pop()))
        });
        let pid = *pid;
        let id = submit(&keys[0], "{}");
        n_jobs += 1;
        let victim = eventually("the job runs or has ended", || {
            let other = computing(server.pid()).into_iter().find(|&child| child != pid);
            match get(&keys[0], &format!("/v1/jobs/{id}"))["finished_at"].is_string() {
                true => Some(None),
                false => other.map(Some),
            }
        });
        if let Some(victim) = victim
            && exists(victim)
        {
            kill(victim);
            n_killed += 1;
        }
        right(&finished(&keys[0], &id));
        let result = timeless(get(&keys[0], &format!("/v1/jobs/{id}/result")));
        assert!(result == expected, "the result of kill {n_killed} differs");
        let trace = get(&keys[0], &format!("/v1/jobs/{id}/trace?limit=10000"));
        let seqs: Vec<u64> = trace["points"].as_array().unwrap().iter().map(|p| p["seq"].as_u64().unwrap()).collect();
        assert_eq!(seqs, (1..=seqs.len() as u64).collect::<Vec<_>>(), "no point twice, none missing");
    }
    if let Some((id, _)) = neighbor {
        right(&finished(&keys[1], &id));
        n_ended += 1;
    }
    assert!(n_ended > 0);
    println!(
        "{n_killed} children killed; {n_jobs} jobs and {n_ended} of the neighbor ended right, in one attempt each"
    );
}

#[test]
fn a_job_whose_child_is_killed_twice_fails_alone() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &["--isolation", "process", "--workers", "1"]);
    let id = server.submit_endless(&source, &target);
    let first = eventually("the job runs", || computing(server.pid()).pop());
    kill(first);
    let second = eventually("it runs again", || computing(server.pid()).into_iter().find(|&pid| pid != first));
    kill(second);
    let job = server.until(&id, |job| job["finished_at"].is_string());
    assert_eq!((&job["state"], &job["attempt"]), (&json!("failed"), &json!(1)), "{job}");
    assert_eq!(job["error"]["type"], "/problems/computation-crashed");
    assert!(job["error"]["detail"].as_str().unwrap().contains("nothing else was affected"), "{job}");
    let [source, target] = small_pair(&folder.path().join("small"), "3");
    let id = server.submit_with(&source, &target, "{}");
    assert_eq!(server.until(&id, |job| job["finished_at"].is_string())["state"], "succeeded");
    let metrics = server.client.get(format!("{}/metrics", server.base)).send().unwrap().text().unwrap();
    assert!(metrics.contains("homolog_children_ended_total{reason=\"killed\"} 2"), "{metrics}");
}

#[test]
fn nothing_computes_after_a_cancellation_or_a_deadline() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &[&ISOLATED[..], &["--workers", "1"]].concat());
    let id = server.submit_endless(&source, &target);
    let child = eventually("the job runs", || computing(server.pid()).pop());
    let response = server.client.post(format!("{}/v1/jobs/{id}/cancel", server.base)).send().unwrap();
    assert_eq!(response.status(), 202);
    let job = server.until(&id, |job| job["finished_at"].is_string());
    assert_eq!(job["state"], "cancelled");
    assert!(!exists(child), "a job is cancelled when its child has ended, not before");
    assert!(computing(server.pid()).is_empty());

    let file = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("a.ply");
    let form = Form::new().part("source", file(&source)).part("target", file(&target));
    let form = form.text("parameters", ENDLESS).text("max_run_s", "1");
    let response = server.client.post(format!("{}/v1/jobs", server.base)).multipart(form).send().unwrap();
    let id = response.json::<Value>().unwrap()["id"].as_str().unwrap().to_owned();
    let child = eventually("the job runs", || computing(server.pid()).pop());
    let job = server.until(&id, |job| job["finished_at"].is_string());
    assert_eq!(job["error"]["type"], "/problems/run-time-exceeded", "{job}");
    assert!(!exists(child));
    assert!(computing(server.pid()).is_empty());
}

#[test]
fn no_child_survives_the_service() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(&folder.path().join("pair"));
    let server = Server::start(&folder.path().join("data"), &ISOLATED);
    server.submit_endless(&source, &target);
    eventually("the job runs", || computing(server.pid()).pop());
    let all = children(server.pid());
    assert!(all.len() >= 2, "one computes, and one is spare");
    server.kill();
    eventually("children end with their parent", || all.iter().all(|&pid| !exists(pid)).then_some(()));
}

/// The service is killed while its children compute, and started again on the same stored data.
#[test]
fn a_killed_service_loses_no_job_and_leaves_no_child() {
    let folder = tempfile::tempdir().unwrap();
    let data_dir = folder.path().join("data");
    let [source, target] = small_pair(&folder.path().join("small"), "3");
    let arguments = [&ISOLATED[..], &["--workers", "2", "--cores", "2", "--crash-pause-ms", "0"]].concat();
    let mut server = Server::start(&data_dir, &arguments);
    let mut expected: Option<Value> = None;
    for n_killed in 0..=length(4, 200) {
        let jobs = [0, 1].map(|_| server.submit_anew(&source, &target, "{}"));
        let known = children(server.pid());
        if n_killed > 0 {
            // Killed at another point of the computation each time, including before its start and after its end.
            std::thread::sleep(Duration::from_millis(n_killed * 37 % 500));
            let all = [known, children(server.pid())].concat();
            server.kill();
            eventually("children end with their parent", || all.iter().all(|&pid| !exists(pid)).then_some(()));
            server = Server::start(&data_dir, &arguments);
        }
        for id in jobs {
            let job = server.until(&id, |job| job["finished_at"].is_string());
            assert_eq!(job["state"], "succeeded", "kill {n_killed}: {job}");
            let result = timeless(server.get(&format!("/v1/jobs/{id}/result")));
            let expected = expected.get_or_insert_with(|| result.clone());
            assert!(result == *expected, "the result after kill {n_killed} differs");
        }
    }
    let listed = server.get("/v1/jobs?page_size=500&fields=state");
    let n_jobs = 2 * (length(4, 200) + 1);
    assert_eq!(listed["jobs"].as_array().unwrap().len() as u64, n_jobs.min(500), "nothing twice");
    println!("service killed {} times; {n_jobs} jobs ended right, none twice; no child was left", length(4, 200));
}

/// The engine whose children run the built program.
fn isolated_engine() -> IsolatedEngine {
    let own = IsolationSettings::of_this_program(IntakeLimits::default(), 1 << 30).unwrap();
    let program = env!("CARGO_BIN_EXE_homolog").into();
    IsolatedEngine::start(IsolationSettings { program, at_once: 2, besides: 0, ..own }).unwrap()
}

#[test]
fn a_child_opens_no_file_no_connection_and_no_program() {
    let engine = isolated_engine();
    let possible = engine.possible_in_a_child().unwrap();
    match engine.unconfined() {
        None => assert_eq!(possible, Vec::<String>::new()),
        Some(why) => eprintln!("not tested, because of this kernel: {why}; possible: {possible:?}"),
    }
}

/// An engine that predicts almost no memory for the jobs of one seed.
struct Understating(IsolatedEngine);

/// The seed whose jobs are understated.
const UNDERSTATED: u64 = 666;

#[derive(Debug)]
struct Understated(Arc<dyn Computation>);

impl Understating {
    fn of(&self, parameters: &Value, computation: Arc<dyn Computation>) -> Arc<dyn Computation> {
        if parameters["seed"] == UNDERSTATED { Arc::new(Understated(computation)) } else { computation }
    }
}

impl Engine for Understating {
    fn methods(&self) -> Vec<MethodDescription> {
        self.0.methods()
    }

    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>> {
        let resolved = self.0.resolve(request)?;
        let computation = self.of(&resolved.parameters, Arc::clone(&resolved.computation));
        Ok(Resolved { computation, ..resolved })
    }

    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure> {
        Ok(self.of(parameters, self.0.restore(parameters)?))
    }
}

impl Computation for Understated {
    fn check_input(&self, input: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        self.0.check_input(input)
    }

    fn show_input(&self, input: &InputBytes<'_>, view: InputView) -> Result<Vec<u8>, InputRefusal> {
        self.0.show_input(input, view)
    }

    fn demand(&self, _: SurfaceSize, _: SurfaceSize) -> Demand {
        Demand { cores: 1, memory_bytes: 1, ..Demand::UNKNOWN }
    }

    fn compute(
        &self,
        inputs: &ComputeInputs,
        observer: &dyn Observer,
    ) -> Result<homolog::jobs::engine::Answer, ComputeError> {
        self.0.compute(inputs, observer)
    }

    fn apart(&self) -> Option<&dyn OutOfProcess> {
        self.0.apart()
    }
}

/// Peak resident memory of this process, MiB.
fn own_peak_mib() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    line.trim().trim_end_matches("kB").trim().parse::<u64>().unwrap() / 1024
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_beyond_its_memory_fails_alone_and_says_so() {
    let engine = tokio::task::spawn_blocking(isolated_engine).await.unwrap();
    let folder = Arc::new(tempfile::tempdir().unwrap());
    let more = ["--workers", "2", "--max-attempts", "3"];
    let service = TestService::start_with(folder, &more, Some(Arc::new(Understating(engine)))).await;
    // 10,242 vertices, each a variable whose labels are all vertices of the other surface: gigabytes.
    let mesh = write_ply(&shapes::ellipsoid([16.0, 9.0, 7.0].into(), 5));
    let small = write_ply(&shapes::ellipsoid([16.0, 9.0, 7.0].into(), 3));
    let submit = async |mesh: &[u8], parameters: Value| {
        let file = |bytes: &[u8]| reqwest::multipart::Part::bytes(bytes.to_vec()).file_name("a.ply");
        let form = reqwest::multipart::Form::new().part("source", file(mesh)).part("target", file(mesh));
        let form = form.text("parameters", parameters.to_string());
        let request = service.client.post(format!("{}/v1/jobs", service.base)).multipart(form);
        let job: Value = request.send().await.unwrap().json().await.unwrap();
        job["id"].as_str().unwrap_or_else(|| panic!("{job}")).to_owned()
    };
    let finished = async |id: &str| {
        let began = Instant::now();
        loop {
            let url = format!("{}/v1/jobs/{id}", service.base);
            let job: Value = service.client.get(url).send().await.unwrap().json().await.unwrap();
            if job["finished_at"].is_string() {
                return job;
            }
            assert!(began.elapsed() < PATIENCE, "{job}");
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    };
    let parameters = json!({"method": "thesis", "seed": UNDERSTATED, "inference": {"coarse_vertices": null}});
    let greedy = submit(&mesh, parameters).await;
    let modest = submit(&small, json!({})).await;
    let job = finished(&greedy).await;
    assert_eq!((&job["state"], &job["attempt"]), (&json!("failed"), &json!(1)), "{job}");
    assert_eq!(job["error"]["type"], "/problems/out-of-memory", "{job}");
    let detail = job["error"]["detail"].as_str().unwrap();
    assert!(detail.contains("memory") && detail.contains("planned"), "{detail}");
    let job = finished(&modest).await;
    assert_eq!((&job["state"], &job["attempt"]), (&json!("succeeded"), &json!(1)), "{job}");
    assert!(own_peak_mib() < 512, "{} MiB", own_peak_mib());
}
