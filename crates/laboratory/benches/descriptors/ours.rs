//! The homolog side of the comparison of descriptors: nearest neighbors in the space of each descriptor on pairs with a known truth.
//!
//! Arguments are pairs, each the beginning of three file names: `PAIR_s.txt` and `PAIR_t.txt` hold a surface (numbers of vertices
//! and triangles, vertices in mm, corners from 0), `PAIR_g.txt` the true image of every source vertex. `peers.py` prints the same
//! numbers of Open3D and pyfmaps. No test depends on this benchmark.
#![allow(clippy::unwrap_used, clippy::print_stdout, clippy::panic)]

use homolog_geometry::descriptors::{
    Descriptor, fpfh, heat_kernel_signature, shape_contexts, shot, spin_images, unit_spectrum, wave_kernel_signature,
};
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::Point3;
use rayon::prelude::*;
use std::time::Instant;

/// Radius of the support, in roots of the area of the target: the default of `features[].support`.
const SUPPORT: f64 = 0.25;

fn numbers(path: &str) -> Vec<f64> {
    std::fs::read_to_string(path).unwrap().split_whitespace().map(|word| word.parse().unwrap()).collect()
}

fn points(numbers: &[f64]) -> Vec<Point3<f64>> {
    numbers.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect()
}

fn surface(path: &str) -> SurfaceMesh {
    let all = numbers(path);
    let (n, f) = (all[0] as usize, all[1] as usize);
    let corners = all[2 + 3 * n..2 + 3 * (n + f)].iter().map(|k| *k as u32).collect();
    SurfaceMesh::new(points(&all[2..2 + 3 * n]), FaceArity::Triangle, corners).unwrap()
}

/// Share of source vertices whose nearest neighbor among all descriptors of the target is within two mean edges of the truth.
fn rate(source: &Descriptor, target: &Descriptor, labels: &[Point3<f64>], truth: &[Point3<f64>], near_mm: f64) -> f64 {
    let right = (0..truth.len()).into_par_iter().filter(|&i| {
        let away = |x: usize| source.row(i).iter().zip(target.row(x)).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        let nearest = (0..labels.len()).min_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap();
        (labels[nearest] - truth[i]).norm() <= near_mm
    });
    right.count() as f64 / truth.len() as f64
}

fn main() {
    println!("pair, descriptor, nearest neighbors within 2 edges in percent, seconds for both surfaces");
    for pair in std::env::args().skip(1).filter(|word| !word.starts_with("--")) {
        let (source, target) = (surface(&format!("{pair}_s.txt")), surface(&format!("{pair}_t.txt")));
        let truth = points(&numbers(&format!("{pair}_g.txt")));
        let (near_mm, support_mm) = (2.0 * target.mean_edge_length(), SUPPORT * target.area().sqrt());
        type Measure<'a> = (&'a str, &'a dyn Fn(&SurfaceMesh) -> Descriptor);
        let all: [Measure<'_>; 6] = [
            ("fpfh", &|mesh| fpfh(mesh, support_mm, &Silent).unwrap()),
            ("shot", &|mesh| shot(mesh, support_mm, &Silent).unwrap()),
            ("spin_image", &|mesh| spin_images(mesh, support_mm, &Silent).unwrap()),
            ("shape_context", &|mesh| shape_contexts(mesh, support_mm, &Silent).unwrap()),
            ("heat_kernel_signature", &|mesh| heat_kernel_signature(&unit_spectrum(mesh, &Silent).unwrap().unwrap())),
            ("wave_kernel_signature", &|mesh| wave_kernel_signature(&unit_spectrum(mesh, &Silent).unwrap().unwrap())),
        ];
        for (name, measure) in all {
            let begin = Instant::now();
            let (one, other) = (measure(&source), measure(&target));
            let seconds = begin.elapsed().as_secs_f64();
            let share = rate(&one, &other, target.vertices(), &truth, near_mm);
            println!("{pair}, {name}, {:.1}, {seconds:.2}", 100.0 * share);
        }
    }
}
