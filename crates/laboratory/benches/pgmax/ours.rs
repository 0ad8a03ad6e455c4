//! The homolog side of the comparison with PGMax: exports the energy that both minimize, and times its minimization.
//!
//! `export DIR` writes the energy as `.npy`; `measure sparse|full THREADS ITERATIONS` minimizes it and prints a row.
//! `benches/pgmax/run` calls both and then `peer.py`. No test depends on this benchmark.
#![allow(clippy::unwrap_used, clippy::print_stdout, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;

use common::{pair, peak_mib, with_threads};
use homolog_contract::parameters::resolve;
use homolog_matching::energy_model;
use homolog_mrf::MrfModel;
use homolog_mrf::inference::{BeliefPropagation, BpOptions, Product, Update};
use homolog_primitives::observe::Silent;
use serde_json::json;
use std::path::Path;
use std::time::Instant;

/// Edge of the phantoms' triangles, mm: about 200 vertices.
const EDGE_MM: f64 = 2.7;
/// Number of runs, of which the median is reported.
const RUNS: usize = 5;

fn model() -> MrfModel {
    let (source, target) = pair(EDGE_MM);
    // A distance term, so that the potential differs between pairs of neighbors.
    energy_model(&source, &target, &resolve(&json!({"energy": {"beta": 0.5}})).unwrap()).unwrap()
}

/// A file of NumPy's format 1.0: `bytes` are little-endian values of type `kind`, in C order.
fn write_npy(path: &Path, kind: &str, shape: &[usize], bytes: &[u8]) {
    let shape: String = shape.iter().map(|n| format!("{n},")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    // The data begin at a multiple of 64 bytes.
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.as_bytes());
    file.extend(bytes);
    std::fs::write(path, file).unwrap();
}

/// Writes `unary.npy` (variables × labels), `edges.npy` (edges × 2) and `tables.npy` (edges × labels × labels): `θ_i(x)`,
/// the edges once each, and `θ_ij(x, y)`.
fn export(folder: &Path) {
    let model = model();
    let (n, labels) = (model.n_variables(), model.n_labels());
    let directed = (0..n).flat_map(|i| model.variables.row(i).map(move |edge| (i, edge)));
    let edges: Vec<(usize, usize, usize)> =
        directed.map(|(i, edge)| (i, model.variables.head(edge), edge)).filter(|(i, j, _)| i < j).collect();
    let floats = |values: &[f32]| -> Vec<u8> { values.iter().flat_map(|v| v.to_le_bytes()).collect() };
    std::fs::create_dir_all(folder).unwrap();
    write_npy(&folder.join("unary.npy"), "<f4", &[n, labels], &floats(&model.unary));
    let ends: Vec<u8> = edges.iter().flat_map(|&(i, j, _)| [i as u32, j as u32]).flat_map(u32::to_le_bytes).collect();
    write_npy(&folder.join("edges.npy"), "<u4", &[edges.len(), 2], &ends);
    let mut tables = Vec::with_capacity(edges.len() * labels * labels);
    for &(_, _, edge) in &edges {
        for x in 0..labels as u32 {
            tables.extend((0..labels as u32).map(|y| model.pairwise_potential(edge, x, y) as f32));
        }
    }
    write_npy(&folder.join("tables.npy"), "<f4", &[edges.len(), labels, labels], &floats(&tables));
    println!("{n} variables, {labels} labels, {} edges, neighborhoods of {:.1}", edges.len(), model.labels.mean_size());
}

fn measure(name: &str, threads: usize, iterations: u32) {
    let model = model();
    let update = match name {
        "sparse" => Update::Sparse,
        "full" => Update::Full,
        other => panic!("no update {other}"),
    };
    // With a tolerance of 0 no run ends early.
    let options = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
    let mut taken = Vec::new();
    let mut energy = f64::NAN;
    with_threads(threads, || {
        for _ in 0..RUNS {
            let mut propagation = BeliefPropagation::with_update(&model, options, update);
            let began = Instant::now();
            let outcome = propagation.run(iterations, &Silent, |_| ()).unwrap();
            taken.push(began.elapsed().as_secs_f64() / f64::from(iterations));
            energy = outcome.energy.total();
        }
    });
    taken.sort_by(f64::total_cmp);
    println!(
        "| homolog, {name} update | {threads} | {:.3} | {:.3} to {:.3} | {:.0} | {energy:.1} |",
        taken[RUNS / 2] * 1e3,
        taken[0] * 1e3,
        taken[RUNS - 1] * 1e3,
        peak_mib().unwrap()
    );
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["export", folder] => export(Path::new(folder)),
        ["measure", update, threads, iterations] => {
            measure(update, threads.parse().unwrap(), iterations.parse().unwrap());
        }
        _ => panic!("export DIR, or measure sparse|full THREADS ITERATIONS"),
    }
}
