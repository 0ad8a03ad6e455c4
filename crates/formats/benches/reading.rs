//! Time to read large inputs: what a client waits for before a submission is answered.
//!
//! `make bench` runs this with the other benchmarks. The FreeSurfer and MGZ files are those of the folder that
//! `HOMOLOG_REAL_DATA` names (`data/` of the project unless set); without it their rows are left out. Every
//! figure is the median of 9 runs with its range, file in memory, one thread. No test depends on this benchmark.
#![allow(clippy::unwrap_used, clippy::print_stdout, missing_docs)]

use homolog_formats::{FileContent, ReadLimits, read, write_stl};
use homolog_mesh::shapes::ellipsoid;
use nalgebra::Vector3;
use std::path::PathBuf;
use std::time::Instant;

const RUNS: usize = 9;

fn main() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let data = std::env::var_os("HOMOLOG_REAL_DATA").map_or_else(|| root.join("data"), PathBuf::from);
    println!("## Reading\n");
    println!("| file | MB | result | median ms | range ms | goal ms |");
    println!("|---|---|---|---|---|---|");
    let of_folder = |name: &str| std::fs::read(data.join("formats").join(name)).ok();
    if let Some(bytes) = of_folder("freesurfer/mricros_lh.pial") {
        row("FreeSurfer binary surface", &bytes, 50.0);
    }
    if let Some(bytes) = of_folder("mgz/aparc+aseg.mgz") {
        row("MGZ label volume", &bytes, 1000.0);
    }
    // Every triangle has vertices of its own in the file.
    let stl = write_stl(&ellipsoid(Vector3::new(20.0, 9.0, 7.0), 7));
    row("binary STL, vertices merged", &stl, 500.0);
}

fn row(what: &str, bytes: &[u8], goal_ms: f64) {
    let limits = ReadLimits::default();
    let mut times = Vec::new();
    let mut result = String::new();
    for _ in 0..RUNS {
        let began = Instant::now();
        let file = read(bytes, None, &limits).unwrap();
        times.push(began.elapsed().as_secs_f64() * 1e3);
        result = match &file.content {
            FileContent::Mesh(file) => format!("{} vertices, {} faces", file.mesh.n_vertices(), file.mesh.n_faces()),
            FileContent::Labels(volume) => format!("{:?} voxels", volume.dims()),
        };
    }
    times.sort_by(f64::total_cmp);
    let size = bytes.len() as f64 / 1e6;
    println!(
        "| {what} | {size:.1} | {result} | {:.1} | {:.1}-{:.1} | {goal_ms} |",
        times[RUNS / 2],
        times[0],
        times[RUNS - 1]
    );
}
