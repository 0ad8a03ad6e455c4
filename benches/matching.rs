//! Time and memory of a match, and of the message update alone, on generated surfaces.
//!
//! `make bench` runs this and keeps what it prints as a dated record under `benches/records/`. Every figure is a
//! median over runs with the spread beside it; thread counts are compared within the run, since machines differ and
//! drift. No test depends on it.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use homolog::inference::{BeliefPropagation, BpOptions, Product};
use homolog::matching::parameters::{MatchParameters, resolve};
use homolog::matching::{energy_model, match_surfaces};
use homolog::mesh::{FaceArity, SurfaceMesh};
use homolog::observe::Silent;
use homolog::phantom::{PairRecipe, PhantomPair};
use serde_json::json;
use std::collections::HashMap;
use std::time::Instant;

fn pair(edge_mm: f64) -> (SurfaceMesh, SurfaceMesh) {
    let pair = PhantomPair::new(PairRecipe {
        subject: 1,
        target_subject: 2,
        deform_share: 0.0,
        deform_seed: 0,
        pose_seed: Some(3),
        permute_seed: Some(4),
    })
    .unwrap();
    (pair.source_surface(edge_mm).unwrap().mesh, pair.target_surface(edge_mm).unwrap().0.mesh)
}

/// Median, least and most of `runs` timings, seconds.
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

fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

/// Most memory that this process ever held, MiB; `None` where the system does not tell.
fn peak_mib() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

/// Bytes a second that all `threads` together read from an array far larger than any cache.
fn read_bandwidth(threads: usize) -> f64 {
    use rayon::prelude::*;
    let words = vec![1u64; 48 << 20];
    let [median, ..] = with_threads(threads, || {
        timed(5, || {
            let sum: u64 = words.par_chunks(1 << 20).map(|c| c.iter().fold(0u64, |a, b| a.wrapping_add(*b))).sum();
            std::hint::black_box(sum);
        })
    });
    (words.len() * 8) as f64 / median
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
    println!("commit: {}", option_env!("HOMOLOG_COMMIT").unwrap_or("unknown"));
    large_matches(cores);
    whole_match(cores);
    message_update(cores);
}

fn whole_match(cores: usize) {
    println!("\n## A pair of phantoms, defaults, from surfaces to outcome (median, least, most of 5)\n");
    println!("| method | vertices | threads | seconds | | |\n|---|---|---|---|---|---|");
    let (source, target) = pair(0.8);
    for method in ["balanced", "fast", "rigid", "thesis"] {
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

/// `mesh` with every triangle cut in four.
fn cut_in_four(mesh: &SurfaceMesh) -> SurfaceMesh {
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

/// The default on surfaces of one shape and ever more vertices. Peak memory only grows, so small ones come first.
fn large_matches(cores: usize) {
    println!("\n## The default on ever finer surfaces, {cores} threads (median, least, most of 3)\n");
    println!("| vertices | seconds | | | peak memory, MiB | slope on a log-log plot |\n|---|---|---|---|---|---|");
    let parameters: MatchParameters = resolve(&json!({})).unwrap();
    let (mut source, mut target) = pair(0.8);
    let mut before: Option<(f64, f64)> = None;
    for level in 0..4 {
        if level > 0 {
            (source, target) = (cut_in_four(&source), cut_in_four(&target));
        }
        let [median, least, most] =
            with_threads(cores, || timed(3, || drop(match_surfaces(&source, &target, &parameters, &Silent).unwrap())));
        let n = source.n_vertices() as f64;
        let slope = before.map_or(String::new(), |(m, t)| format!("{:.2}", (median / t).ln() / (n / m).ln()));
        before = Some((n, median));
        println!(
            "| {} + {} | {median:.2} | {least:.2} | {most:.2} | {:.0} | {slope} |",
            source.n_vertices(),
            target.n_vertices(),
            peak_mib().unwrap_or(f64::NAN)
        );
    }
}

fn message_update(cores: usize) {
    println!("\n## One iteration of belief propagation (median of 9 after 3 to warm up)\n");
    let bandwidth = [read_bandwidth(1), read_bandwidth(cores)];
    println!("memory read: {:.1} GB/s on 1 thread, {:.1} GB/s on {cores}\n", bandwidth[0] / 1e9, bandwidth[1] / 1e9);
    println!(
        "| algorithm | beta | r | vertices | threads | ms | label pairs/s | message bytes/s | of memory read |\n\
         |---|---|---|---|---|---|---|---|---|"
    );
    for (edge_mm, rings) in [(0.8, 1), (0.8, 2), (0.8, 3), (0.56, 2)] {
        let (source, target) = pair(edge_mm);
        for (algorithm, product, beta) in
            [("max_product", Product::Max, 0.0), ("max_product", Product::Max, 0.5), ("sum_product", Product::Sum, 0.5)]
        {
            let request = json!({"energy": {"neighborhood_rings": rings, "beta": beta}});
            let model = energy_model(&source, &target, &resolve(&request).unwrap()).unwrap();
            let directed_edges = model.variables.n_directed_edges() as f64;
            let values = directed_edges * model.n_labels() as f64;
            let mut threads = vec![1, cores];
            threads.dedup();
            for (threads, bandwidth) in threads.into_iter().zip(bandwidth) {
                let options = BpOptions { product, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
                let per_iteration = with_threads(threads, || {
                    let mut bp = BeliefPropagation::new(&model, options);
                    bp.run(3, &Silent, |_| ()).unwrap();
                    timed(3, || drop(bp.run(3, &Silent, |_| ()).unwrap()))[0] / 3.0
                });
                // Each message is read as input, read again as the old value, and written.
                let bytes = 3.0 * 4.0 * values;
                println!(
                    "| {algorithm} | {beta} | {rings} | {} | {threads} | {:.1} | {:.2e} | {:.2e} | {:.2} |",
                    model.n_variables(),
                    per_iteration * 1e3,
                    values * model.labels.mean_size() / per_iteration,
                    bytes / per_iteration,
                    bytes / per_iteration / bandwidth,
                );
            }
        }
    }
}
