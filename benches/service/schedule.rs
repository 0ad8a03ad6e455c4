//! Throughput by how a process divides its cores among jobs, compared with both extremes, and for a template with many
//! subjects.

use crate::http::Client;
use crate::node::Node;
use crate::pairs::{self, Times, makespan_s, parameters, run_batch, upload, upload_file};
use crate::place::Place;
use crate::{Latencies, Scale};
use serde_json::{Value, json};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Vertices of each surface.
const SMALL: usize = 600;
const MIDDLE: usize = 2_500;
const LARGE: usize = 10_000;

/// The parts of this comparison, one for each workload.
pub(crate) const PARTS: [&str; 3] = ["schedule-small", "schedule-middle", "schedule-mixed"];

/// Jobs to run, by the vertices of their surfaces, in the order of the queue.
pub(crate) struct Workload {
    name: &'static str,
    jobs: Vec<usize>,
}

/// The number of jobs: `full`, a few in a quick run, or the number set in the environment.
fn count(scale: Scale, full: usize) -> usize {
    let told = std::env::var("SERVICE_BENCH_JOBS").ok().map(|n| n.parse().unwrap());
    told.unwrap_or(scale.pick(4, full))
}

/// The workload of a part.
pub(crate) fn workload(part: &str, scale: Scale) -> Workload {
    match part {
        "schedule-small" => Workload { name: "small pairs", jobs: vec![SMALL; count(scale, 40)] },
        "schedule-middle" => {
            Workload { name: "pairs of 2,500", jobs: vec![scale.pick(SMALL, MIDDLE); count(scale, 20)] }
        }
        "schedule-mixed" => {
            let mut jobs = vec![SMALL; count(scale, 20)];
            jobs.insert(jobs.len() / 2, scale.pick(MIDDLE, LARGE));
            Workload { name: "one of 10,000 among small pairs", jobs }
        }
        other => panic!("no workload {other}"),
    }
}

/// Speedup of a single match by a further core, on which the prediction of cores is based.
pub(crate) fn gains(scale: Scale) {
    println!("\n## One match on one core and on all\n");
    println!("`homolog match`, median of the runs, reading and writing included.");
    pairs::say_parameters();
    println!("| vertices | runs | one core s | all cores s | gain |\n|---|---|---|---|---|");
    for (n_vertices, n_runs) in [(SMALL, 5), (MIDDLE, 3), (scale.pick(MIDDLE, LARGE), 1)] {
        let folder = tempfile::tempdir().unwrap();
        let files = write_pair(folder.path(), pairs::pair(n_vertices));
        let mut taken = [Vec::new(), Vec::new()];
        for _ in 0..n_runs {
            for (threads, taken) in ["1", "0"].iter().zip(&mut taken) {
                taken.push(timed_match(&files, &folder.path().join("out"), threads));
            }
        }
        let [one, all] = taken.map(|taken| Latencies::new(taken).ms(0.5) / 1e3);
        println!("| {n_vertices} | {n_runs} | {one:.2} | {all:.2} | {:.2} |", one / all);
    }
}

/// Files of a pair in a folder.
pub(crate) fn write_pair(folder: &std::path::Path, pair: [Vec<u8>; 2]) -> [std::path::PathBuf; 2] {
    let files = ["source.ply", "target.ply"].map(|name| folder.join(name));
    for (file, ply) in files.iter().zip(pair) {
        std::fs::write(file, ply).unwrap();
    }
    files
}

/// Seconds of a `homolog match`; "0" threads means all cores.
pub(crate) fn timed_match(files: &[std::path::PathBuf; 2], out: &std::path::Path, threads: &str) -> f64 {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homolog"));
    let stated = out.with_extension("json");
    std::fs::write(&stated, parameters().to_string()).unwrap();
    command.arg("match").args(files).arg("--out").arg(out).arg("--params").arg(stated);
    command.env("RAYON_NUM_THREADS", threads);
    let began = Instant::now();
    let status = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    assert!(status.success());
    began.elapsed().as_secs_f64()
}

/// Prints the meaning of the rows of the workloads.
pub(crate) fn explain() {
    println!("\n## Jobs per hour by how cores are divided\n");
    println!(
        "A batch of uploaded surfaces, from its acceptance to the end of its last job. \"One after another\": one"
    );
    println!(
        "worker, each job on all cores. \"Side by side\": as many workers as cores, each job on one core, including"
    );
    println!("the large one. \"By prediction\": the default.");
    pairs::say_parameters();
    println!(
        "| jobs | cores | seconds | jobs per hour | large waited s | large ran s | small waited s, mean | max MiB |"
    );
    println!("|---|---|---|---|---|---|---|---|");
}

/// Rows of one workload.
pub(crate) async fn compare(workload: &Workload) {
    let cores = std::thread::available_parallelism().map_or(1, usize::from).to_string();
    let ways = [("one after another", Some("1")), ("side by side", Some(cores.as_str())), ("by prediction", None)];
    for (way, workers) in ways {
        let place = Place::sqlite();
        let mut environment = place.environment();
        environment.extend(workers.map(|n| ("HOMOLOG_WORKERS", n.to_owned())));
        let node = Node::program(&environment);
        let mut client = Client::connect(&node.address).await;
        let mut sizes = workload.jobs.clone();
        sizes.sort_unstable();
        sizes.dedup();
        let mut ids = Vec::new();
        for &n_vertices in &sizes {
            let [source, target] = pairs::pair(n_vertices);
            ids.push([upload(&mut client, &source).await, upload(&mut client, &target).await]);
        }
        let of = |n_vertices: &usize| &ids[sizes.iter().position(|size| size == n_vertices).unwrap()];
        let pair =
            |[source, target]: &[String; 2]| json!({"source": {"mesh_id": source}, "target": {"mesh_id": target}});
        let pairs: Vec<Value> = workload.jobs.iter().map(of).map(pair).collect();
        let times = run_batch(&mut client, &json!({"pairs": pairs, "parameters": parameters()})).await;
        row(workload, way, &times, node.status_mib("VmHWM"));
    }
}

fn row(workload: &Workload, way: &str, times: &[Times], most_mib: f64) {
    let seconds = makespan_s(times);
    let largest = times.iter().map(|t| t.n_vertices).max().unwrap();
    let is_mixed = times.iter().any(|t| t.n_vertices * 2 < largest);
    let (large, small): (Vec<&Times>, Vec<&Times>) = times.iter().partition(|t| is_mixed && t.n_vertices == largest);
    let large = large.first().map_or(" | ".to_owned(), |t| format!("{:.1} | {:.1}", t.waited_s(), t.ran_s()));
    let waited = small.iter().map(|t| t.waited_s()).sum::<f64>() / small.len() as f64;
    println!(
        "| {} {} | {way} | {seconds:.1} | {:.0} | {large} | {waited:.1} | {most_mib:.0} |",
        times.len(),
        workload.name,
        times.len() as f64 / seconds * 3600.0
    );
}

/// Pairs per hour of a template with many subjects, with and without a cache of prepared surfaces.
pub(crate) async fn template(scale: Scale) {
    let (n_subjects, n_vertices) = (count(scale, 100), scale.pick(SMALL, MIDDLE));
    println!("\n## A template against {n_subjects} subjects\n");
    let (template, subjects) = pairs::template_and_subjects(n_subjects, n_vertices);
    println!(
        "{} as template, uploaded with the subjects before; one batch with default settings, except that",
        template.name
    );
    println!("the cache of prepared surfaces is off in one row.");
    pairs::say_parameters();
    println!(
        "| prepared surfaces | vertices of a subject | seconds | pairs per hour | max MiB |\n|---|---|---|---|---|"
    );
    for (way, bytes) in [("not cached", Some("0")), ("cached", None)] {
        let place = Place::sqlite();
        let mut environment = place.environment();
        environment.extend(bytes.map(|n| ("HOMOLOG_PREPARED_BYTES", n.to_owned())));
        let node = Node::program(&environment);
        let mut client = Client::connect(&node.address).await;
        let template_id = upload_file(&mut client, &template.name, &template.bytes).await;
        let mut ids = Vec::with_capacity(subjects.len());
        for subject in &subjects {
            let id = upload_file(&mut client, &subject.name, &subject.bytes).await;
            ids.push(json!({"input": {"mesh_id": id}}));
        }
        let batch = json!({"template": {"mesh_id": template_id}, "subjects": ids, "parameters": parameters()});
        let times = run_batch(&mut client, &batch).await;
        let seconds = makespan_s(&times);
        let most = node.status_mib("VmHWM");
        let sizes = || times.iter().map(|t| t.n_vertices);
        let (fewest, most_vertices) = (sizes().min().unwrap(), sizes().max().unwrap());
        println!(
            "| {way} | {fewest} to {most_vertices} | {seconds:.1} | {:.0} | {most:.0} |",
            n_subjects as f64 / seconds * 3600.0
        );
    }
}
