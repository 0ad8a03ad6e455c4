//! Time and memory of a match on generated surfaces.
//!
//! `make bench` runs this and `kernel.rs` and stores their output as a dated record under `benches/records/`. Every
//! figure is a median over runs with its range; thread counts are compared within one run, since machines differ and
//! drift. An argument (`large`, `whole`, `template`) runs one part. No test depends on this benchmark.
#![allow(clippy::unwrap_used, clippy::print_stdout, missing_docs)]

mod common;
#[path = "matching/template.rs"]
mod template;

use common::{pair, peak_mib, with_threads};
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_formats::ply::write_ply;
use homolog_matching::match_surfaces;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use serde_json::json;
use std::collections::{BTreeMap, HashMap};
use std::time::Instant;

/// The stages of a match that the result document times, in order.
const STAGES: [&str; 7] =
    ["reading", "features", "inference", "registration", "refinement", "displacement", "reporting"];

/// Median, minimum and maximum of `runs` timings, seconds.
fn timed(runs: usize, mut work: impl FnMut()) -> [f64; 3] {
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    [times[runs / 2], times[0], times[runs - 1]]
}

fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|l| l.strip_prefix("model name"))
        .map_or("unknown processor", |m| m.trim_matches([':', ' ', '\t']));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {cores} cores")
}

fn main() {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    println!("machine: {}", machine());
    println!("commit: {}", common::commit());
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|w| w == name);
    if wanted("large") {
        large_matches(cores);
    }
    if wanted("whole") {
        whole_match(cores);
    }
    if wanted("template") {
        template::template();
    }
}

fn whole_match(cores: usize) {
    println!("\n## A pair of phantoms, defaults, from surfaces to outcome (median, minimum, maximum of 5)\n");
    println!("| method | vertices | threads | seconds | | |\n|---|---|---|---|---|---|");
    let (source, target) = pair(0.8);
    for method in ["balanced", "rigid", "thesis"] {
        let parameters: MatchParameters = resolve(&json!({"method": method})).unwrap();
        let mut threads = vec![1, cores];
        threads.dedup();
        for threads in threads {
            let [median, least, most] = with_threads(threads, || {
                timed(5, || drop(match_surfaces(&source, &target, &parameters, &Silent).unwrap()))
            });
            println!(
                "| {method} | {} + {} | {threads} | {median:.2} | {least:.2} | {most:.2} |",
                source.n_vertices(),
                target.n_vertices()
            );
        }
    }
    if let Some(mib) = peak_mib() {
        println!("\npeak memory of the process: {mib:.0} MiB");
    }
}

/// `mesh` with every triangle split into four.
pub(crate) fn split_triangles(mesh: &SurfaceMesh) -> SurfaceMesh {
    let mut vertices = mesh.vertices().to_vec();
    let mut middles = HashMap::new();
    let mut faces = Vec::new();
    for t in mesh.triangles() {
        let m: [u32; 3] = std::array::from_fn(|k| {
            let (a, b) = (t[k].min(t[(k + 1) % 3]), t[k].max(t[(k + 1) % 3]));
            *middles.entry((a, b)).or_insert_with(|| {
                vertices.push(nalgebra::center(&vertices[a as usize], &vertices[b as usize]));
                vertices.len() as u32 - 1
            })
        });
        faces.extend([t[0], m[0], m[2], m[0], t[1], m[1], m[2], m[1], t[2], m[0], m[1], m[2]]);
    }
    SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap()
}

/// The default method on one shape with an increasing number of vertices, and the share of each stage. Small surfaces
/// come first, because the reported peak memory never decreases.
fn large_matches(cores: usize) {
    println!("\n## The default on increasingly fine surfaces, {cores} threads (median, minimum, maximum of 3)\n");
    println!("From files in memory to the result document.\n");
    println!("| vertices | seconds | | | peak memory, MiB | slope on a log-log plot |\n|---|---|---|---|---|---|");
    let parameters: MatchParameters = resolve(&json!({})).unwrap();
    let (mut source, mut target) = pair(0.8);
    let mut before: Option<(f64, f64)> = None;
    let mut stages = Vec::new();
    for level in 0..4 {
        if level > 0 {
            (source, target) = (split_triangles(&source), split_triangles(&target));
        }
        let files = [write_ply(&source), write_ply(&target)];
        let [of_source, of_target] = files.each_ref().map(|bytes| InputFile { bytes, name: None });
        let mut runs = Vec::new();
        let [median, least, most] = with_threads(cores, || {
            timed(3, || {
                let output = run_match(of_source, of_target, &parameters, &IntakeLimits::default(), &Silent);
                runs.push(output.unwrap().document.timings_ms);
            })
        });
        let n = source.n_vertices() as f64;
        let slope = before.map_or(String::new(), |(m, t)| format!("{:.2}", (median / t).ln() / (n / m).ln()));
        before = Some((n, median));
        println!(
            "| {} + {} | {median:.2} | {least:.2} | {most:.2} | {:.0} | {slope} |",
            source.n_vertices(),
            target.n_vertices(),
            peak_mib().unwrap_or(f64::NAN)
        );
        stages.push((source.n_vertices(), shares(&runs)));
    }
    println!("\n## Where the time of these matches goes, % (median of 3)\n");
    println!("| vertices | {} | the rest |\n|{}", STAGES.join(" | "), "---|".repeat(STAGES.len() + 2));
    for (n_vertices, shares) in stages {
        let rest = 100.0 - shares.iter().sum::<f64>();
        let cells: Vec<String> = shares.iter().chain([&rest]).map(|share| format!("{share:.1}")).collect();
        println!("| {n_vertices} | {} |", cells.join(" | "));
    }
}

/// The share of each stage in the total time, median over the runs, %.
fn shares(runs: &[BTreeMap<String, f64>]) -> [f64; STAGES.len()] {
    STAGES.map(|stage| {
        let mut of_runs: Vec<f64> =
            runs.iter().map(|ms| 100.0 * ms.get(stage).copied().unwrap_or(0.0) / ms["total"]).collect();
        of_runs.sort_by(f64::total_cmp);
        of_runs[of_runs.len() / 2]
    })
}
