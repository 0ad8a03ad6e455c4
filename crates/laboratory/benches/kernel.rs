//! Time of an iteration of belief propagation, beside a lower bound on that time for this machine.
//!
//! The lower bound is the longer of two times, both from rates measured in the same run with as many threads:
//! - memory traffic: every message is read once and written once, 8 bytes per value, at the rate at which a plain loop reads, changes and writes an array in place that is far larger than the caches;
//! - arithmetic on data in the first-level cache: the maxima, minima and sums of a value at the rate of maxima, its
//!   products (those of the incoming messages included) at the rate of products, or all of them at the rate of both
//!   together; the longest of the three. Not counted: transposing between rows and lanes, and normalizing, flooring and
//!   damping a message and comparing it with the one before (seven operations per value).
//!
//! For comparison, the table also has the time of an iteration that does not wait for memory: the iteration is run on a
//! patch of the source whose messages fit into the caches, and its time per value is multiplied by the number of values.
//!
//! `cargo bench -p homolog-laboratory --bench kernel` prints a table for surfaces of 2,300 and 10,000 vertices and needs
//! 3 GiB of memory.
#![allow(clippy::unwrap_used, clippy::print_stdout, unsafe_code)]

mod common;

use common::{pair, peak_mib, with_threads};
use homolog_geometry::curvature::{ScaleSpace, gaussian_curvature};
use homolog_mesh::{SurfaceMesh, canonicalize};
use homolog_mrf::inference::{
    ActiveModel, ActivePropagation, ActiveSets, BeliefPropagation, BpOptions, Product, UnaryInput, Update,
};
use homolog_mrf::{Feature, FeaturePotentials, MrfModel, PairwisePotential, unary_potentials};
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};
use homolog_primitives::observe::Silent;
use multiversion::multiversion;
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Surfaces of a table and how its rows are measured. Edge length in mm.
struct Size {
    edge_mm: f64,
    iterations: u32,
    runs: usize,
}

fn surfaces(edge_mm: f64) -> [SurfaceMesh; 2] {
    <[SurfaceMesh; 2]>::from(pair(edge_mm)).map(|mesh| canonicalize(&mesh).mesh)
}

/// The parts of an energy of two surfaces.
struct Parts {
    feature: Feature,
    variables: EdgeGraph,
    lengths: Vec<f32>,
    labels: LabelNeighborhoods,
    length_scale: f64,
}

impl Parts {
    fn new([source, target]: &[SurfaceMesh; 2], rings: usize) -> Self {
        let curvature = |mesh: &SurfaceMesh| gaussian_curvature(&ScaleSpace::new(mesh).smoothed(2.8).unwrap());
        let variables = source.edge_graph();
        let length = |i: usize, j: u32| (source.vertices()[i] - source.vertices()[j as usize]).norm() as f32;
        let lengths = (0..variables.n_vertices())
            .flat_map(|i| variables.neighbors(i).iter().map(move |&j| (i, j)))
            .map(|(i, j)| length(i, j))
            .collect();
        let distance = |x: usize, y: usize| (target.vertices()[x] - target.vertices()[y]).norm();
        Parts {
            feature: Feature { weight: 1.0, source: curvature(source), target: curvature(target) },
            lengths,
            labels: LabelNeighborhoods::new(&target.edge_graph(), rings, distance),
            length_scale: target.mean_edge_length(),
            variables,
        }
    }

    fn pairwise(&self, beta: f64) -> PairwisePotential {
        PairwisePotential { beta, length_scale: self.length_scale, truncation: 9.2 }
    }
}

fn model(surfaces: &[SurfaceMesh; 2], rings: usize, beta: f64) -> MrfModel {
    let parts = Parts::new(surfaces, rings);
    MrfModel {
        pairwise: parts.pairwise(beta),
        unary: unary_potentials(&[parts.feature], 2.0, 3.0, 1.0, &Silent).unwrap(),
        lengths: parts.lengths,
        labels: parts.labels,
        variables: parts.variables,
    }
}

/// Number of variables of a patch.
const PATCH: usize = 64;

/// The energy of the first `n` variables, which lie side by side, and of the edges between them.
fn patch(model: &MrfModel, n: usize) -> MrfModel {
    let of = |i: usize| model.variables.row(i).zip(model.variables.neighbors(i)).filter(|&(_, &j)| (j as usize) < n);
    let edges: Vec<[u32; 2]> =
        (0..n).flat_map(|i| of(i).map(move |(_, &j)| [i as u32, j])).filter(|[i, j]| i < j).collect();
    MrfModel {
        variables: EdgeGraph::from_edges(n, &edges),
        lengths: (0..n).flat_map(|i| of(i).map(|(edge, _)| model.lengths[edge])).collect(),
        labels: model.labels.clone(),
        pairwise: model.pairwise,
        unary: model.unary[..n * model.n_labels()].to_vec(),
    }
}

/// Seconds of the fastest of `runs`, since other load on the machine can only slow a run down.
fn fastest(runs: usize, mut work: impl FnMut()) -> f64 {
    let seconds = (0..runs).map(|_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    });
    seconds.fold(f64::INFINITY, f64::min)
}

/// Bytes a second, read and written, of `a = a/2 + 1/4` in place over `n_values` numbers.
fn bandwidth(n_values: usize) -> f64 {
    let mut a = vec![1.0f32; n_values];
    let piece = n_values.div_ceil(rayon::current_num_threads());
    let seconds = fastest(5, || {
        a.par_chunks_mut(piece).for_each(|a| {
            for a in a {
                *a = 0.5 * *a + 0.25;
            }
        });
    });
    8.0 * n_values as f64 / seconds
}

const LANES: usize = 16;

/// Numbers in the fastest cache, none of whose vectors straddles two lines of it.
#[repr(align(64))]
struct Rows([[f32; LANES]; 64]);

/// Maxima of rows of numbers, or of their products with a factor, in as many chains as hide their latency.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn maxima<const SCALED: bool>(rows: &Rows, factor: f32, times: usize) -> [[f32; LANES]; 4] {
    let mut best = [[0.0f32; LANES]; 4];
    for _ in 0..times {
        for rows in black_box(rows).0.as_chunks::<4>().0 {
            for (best, row) in best.iter_mut().zip(rows) {
                for k in 0..LANES {
                    let value = if SCALED { factor * row[k] } else { row[k] };
                    best[k] = if best[k] > value { best[k] } else { value };
                }
            }
        }
    }
    best
}

/// Products of rows of numbers, in as many chains as hide their latency.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn products(rows: &Rows, times: usize) -> [[f32; LANES]; 4] {
    let mut product = [[1.0f32; LANES]; 4];
    for _ in 0..times {
        for rows in black_box(rows).0.as_chunks::<4>().0 {
            for (product, row) in product.iter_mut().zip(rows) {
                for k in 0..LANES {
                    product[k] *= row[k];
                }
            }
        }
    }
    product
}

/// Numbers per second of all threads together in such a loop.
fn rate(work: impl Fn(&Rows, usize) -> [[f32; LANES]; 4] + Sync) -> f64 {
    const TIMES: usize = 40_000;
    let rows = Rows([[1.0f32; LANES]; 64]);
    let threads = rayon::current_num_threads();
    let seconds = fastest(6, || {
        (0..threads).into_par_iter().for_each(|_| {
            black_box(work(black_box(&rows), TIMES));
        });
    });
    (threads * TIMES * 64 * LANES) as f64 / seconds
}

/// Operations per value of a message: `[maxima, minima and sums, products]`. Three of the products are those of the
/// incoming messages: of those before, of those after, and of both.
fn operations(model: &MrfModel, product: Product) -> [f64; 2] {
    let neighbors = model.labels.mean_size();
    let degree = model.labels.graph().n_directed_edges() as f64 / model.n_labels() as f64;
    match (product, model.pairwise.beta == 0.0) {
        (Product::Max, true) => [model.labels.rings() as f64 * (1.0 + degree), 3.0],
        (Product::Sum, true) => [neighbors, 3.0],
        // The minimum of two products, a product with the cavity, and the maximum.
        (Product::Max, false) => [2.0 * neighbors, 3.0 * neighbors + 3.0],
        // As above, plus a maximum with the truncation, a subtraction and a sum.
        (Product::Sum, false) => [4.0 * neighbors, 3.0 * neighbors + 3.0],
    }
}

fn measure(surfaces: &[SurfaceMesh; 2], rings: &[usize], threads: usize, size: &Size) {
    let energies = [0.0, 0.5].into_iter().flat_map(|beta| rings.iter().map(move |&r| (r, beta)));
    for (rings, beta) in energies {
        let model = model(surfaces, rings, beta);
        let patch = patch(&model, PATCH);
        let [values, patch_values] =
            [&model, &patch].map(|model| (model.variables.n_directed_edges() * model.n_labels()) as f64);
        for product in [Product::Max, Product::Sum] {
            let bandwidth = bandwidth(1 << 25);
            let maxima_alone = rate(|rows, times| maxima::<false>(rows, black_box(0.5), times));
            let maxima_of_products = rate(|rows, times| maxima::<true>(rows, black_box(0.5), times));
            let rates = [maxima_alone, rate(products), 2.0 * maxima_of_products];
            let [single, products] = operations(&model, product);
            let seconds = [single / rates[0], products / rates[1], (single + products) / rates[2]];
            let operations_floor = seconds.into_iter().fold(0.0, f64::max) * values;
            let measured = iteration(&model, product, size.runs, size.iterations);
            let in_cache = iteration(&patch, product, size.runs, 50).seconds * values / patch_values;
            let bytes = 8.0 * values;
            let bytes_floor = bytes / bandwidth;
            println!(
                "| {product:?} | {beta} | {rings} | {} x {} | {threads} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {:.2} | {:.1} | {:.2} | {:.0} |",
                model.n_variables(),
                model.n_labels(),
                bandwidth / 1e9,
                rates[0] / 1e9,
                rates[1] / 1e9,
                rates[2] / 1e9,
                bytes_floor * 1e3,
                operations_floor * 1e3,
                in_cache * 1e3,
                measured.seconds * 1e3,
                bytes_floor.max(operations_floor) / measured.seconds,
                bytes / measured.seconds / 1e9,
                values * model.labels.mean_size() / measured.seconds / 1e9 / threads as f64,
                measured.peak_mib,
            );
        }
    }
}

/// Resets the peak that [`peak_mib`] reports, on Linux; elsewhere that stays the peak since the start of the process.
fn reset_peak() {
    // See proc(5): writing 5 resets the peak to the current size.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// Cost of an iteration.
struct Iteration {
    seconds: f64,
    /// Peak memory of the process, including the model, MiB.
    peak_mib: f64,
}

fn iteration(model: &MrfModel, product: Product, runs: usize, iterations: u32) -> Iteration {
    reset_peak();
    // A tolerance that is never reached: on small energies messages become constant to the bit, which would end the run.
    let options = BpOptions { product, damping: 0.5, floor: 1e-5, tolerance: -1.0 };
    let mut bp = BeliefPropagation::new(model, options);
    bp.run(1, &Silent, |_| ()).unwrap();
    // Every run ends with a pass that only decodes; the difference of two runs contains only iterations.
    let mut run = |iterations| fastest(runs, || drop(bp.run(iterations, &Silent, |_| ()).unwrap()));
    let seconds = (run(1 + iterations) - run(1)) / f64::from(iterations);
    Iteration { seconds, peak_mib: peak_mib().unwrap_or(f64::NAN) }
}

/// A sweep over all label pairs, as in general engines, compared with one over the pairs below the truncation.
fn every_pair() {
    println!("\n## A sweep over every pair of labels, one thread, max-product with a distance term, r = 2\n");
    println!(
        "| variables x labels | full update, ms | label pairs, 1e9/s | sparse update, ms | peak memory of the process, MiB |\n\
         |---|---|---|---|---|"
    );
    for edge_mm in [2.2, 1.21] {
        reset_peak();
        let model = model(&surfaces(edge_mm), 2, 0.5);
        let options = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
        let sweep = |update| {
            let mut bp = BeliefPropagation::with_update(&model, options, update);
            bp.run(1, &Silent, |_| ()).unwrap();
            let mut run = |iterations| fastest(3, || drop(bp.run(iterations, &Silent, |_| ()).unwrap()));
            (run(4) - run(1)) / 3.0
        };
        let (full, sparse) = with_threads(1, || (sweep(Update::Full), sweep(Update::Sparse)));
        let pairs = model.variables.n_directed_edges() as f64 * (model.n_labels() as f64).powi(2);
        println!(
            "| {} x {} | {:.1} | {:.2} | {:.2} | {:.0} |",
            model.n_variables(),
            model.n_labels(),
            full * 1e3,
            pairs / full / 1e9,
            sparse * 1e3,
            peak_mib().unwrap_or(f64::NAN)
        );
    }
}

/// An iteration in which every variable has its best labels by feature as candidates, on surfaces of about 10,000
/// vertices.
fn active_labels() {
    println!("\n## An iteration over active labels, one thread, max-product, r = 2\n");
    println!("| variables x labels | active labels | ms | peak memory of the process, MiB |\n|---|---|---|---|");
    let parts = Parts::new(&surfaces(0.39), 2);
    let potentials = FeaturePotentials::new(std::slice::from_ref(&parts.feature), 2.0, 3.0, 1.0);
    let evidence = UnaryInput { unary: &potentials, bias: None };
    let (n, n_labels) = (parts.variables.n_vertices(), parts.labels.n_labels());
    for active in [64, 128, 256] {
        reset_peak();
        let sets = ActiveSets {
            initial: active,
            kept: active,
            largest: active,
            margin: f32::MAX,
            every: 100,
            best_of_neighbors: 0,
        };
        let options = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
        let seconds = with_threads(1, || {
            let candidates = sets.propose(n, n_labels, evidence, &Silent).unwrap();
            let model =
                ActiveModel::new(&parts.variables, &parts.lengths, &parts.labels, parts.pairwise(0.0), candidates)
                    .unwrap();
            let mut bp = ActivePropagation::new(model, options);
            bp.run(1, &Silent, |_| ()).unwrap();
            let mut run = |iterations| fastest(3, || drop(bp.run(iterations, &Silent, |_| ()).unwrap()));
            (run(4) - run(1)) / 3.0
        });
        println!("| {n} x {n_labels} | {active} | {:.1} | {:.0} |", seconds * 1e3, peak_mib().unwrap_or(f64::NAN));
    }
}

fn main() {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    every_pair();
    active_labels();
    let sizes = [Size { edge_mm: 0.8, iterations: 6, runs: 3 }, Size { edge_mm: 0.39, iterations: 1, runs: 3 }];
    println!("\n## An iteration over all labels and its lower bound (fastest of {})\n", sizes[0].runs);
    println!(
        "| algorithm | beta | r | vertices | threads | memory, GB/s | maxima, 1e9/s | products, 1e9/s | both, 1e9/s | bound by bytes, ms \
         | by operations, ms | all in cache, ms | iteration, ms | bound / iteration | messages, GB/s | label pairs, 1e9/s per core | peak memory, MiB |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for size in &sizes {
        let surfaces = surfaces(size.edge_mm);
        let mut threads = vec![1, cores];
        threads.dedup();
        for threads in threads {
            with_threads(threads, || measure(&surfaces, &[1, 2, 3], threads, size));
        }
    }
}
