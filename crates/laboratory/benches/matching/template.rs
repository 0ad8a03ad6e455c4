//! The time saved by caching prepared surfaces when one template is matched with many subjects.

use crate::common::with_threads;
use crate::split_triangles;
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_formats::nifti::write_nifti_gz;
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, SurfaceCache, run_match_with};
use serde_json::json;
use std::time::Instant;

/// The files of the subject with this seed and of the template.
type Inputs = fn(u64) -> [Vec<u8>; 2];

/// Number of subjects, for small surfaces and for large ones.
const N_SUBJECTS: [u64; 2] = [10, 4];
/// Size of the cache, bytes: the default of the service.
const KEPT_BYTES: u64 = 256 << 20;

/// Another source for each seed, and a target that is the same for all.
fn subject(seed: u64) -> PhantomPair {
    let recipe = PairRecipe {
        subject: seed + 1,
        target_subject: 0,
        deform_share: 0.0,
        deform_seed: 0,
        pose_seed: Some(3),
        permute_seed: Some(4),
    };
    PhantomPair::new(recipe).unwrap()
}

/// Source and target as PLY, every triangle split into four `n_cuts` times.
fn surfaces(seed: u64, n_cuts: u32) -> [Vec<u8>; 2] {
    let pair = subject(seed);
    let [source, target] = [pair.source_surface(0.8).unwrap().mesh, pair.target_surface(0.8).unwrap().0.mesh];
    [source, target].map(|mesh| write_ply(&(0..n_cuts).fold(mesh, |mesh, _| split_triangles(&mesh))))
}

/// Source and target as label volumes with voxels of this size.
fn volumes(seed: u64, voxel_mm: f64) -> [Vec<u8>; 2] {
    let pair = subject(seed);
    let volumes = [pair.source_volume(voxel_mm).unwrap(), pair.target_volume(voxel_mm).unwrap()];
    volumes.map(|volume| write_nifti_gz(&volume.into_label_volume().unwrap()))
}

/// On one thread, as the service runs the matches of a batch; with two, both surfaces would be prepared in parallel.
pub(crate) fn template() {
    println!(
        "\n## A template against {} subjects ({} of the largest), with and without a cache of prepared surfaces, one thread\n",
        N_SUBJECTS[0], N_SUBJECTS[1]
    );
    println!(
        "From files in memory to the result document. Every match runs without and with the cache; totals, their ratio,"
    );
    println!("and the minimum, median and maximum of the ratios of single matches.\n");
    println!(
        "| inputs | vertices | method | uncached s | cached s | cached / uncached | min | median | max | cache MiB |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let sets: [(&str, u64, Inputs); 4] = [
        ("meshes", N_SUBJECTS[0], |seed| surfaces(seed, 0)),
        ("label volumes, 1 mm", N_SUBJECTS[0], |seed| volumes(seed, 1.0)),
        ("label volumes, 0.5 mm", N_SUBJECTS[0], |seed| volumes(seed, 0.5)),
        ("meshes", N_SUBJECTS[1], |seed| surfaces(seed, 2)),
    ];
    // One set at a time: large surfaces take much memory.
    for (inputs, n_subjects, of) in sets {
        let files: Vec<_> = (0..n_subjects).map(of).collect();
        for method in ["rigid", "balanced"] {
            row(inputs, &files, method);
        }
    }
}

fn row(inputs: &str, files: &[[Vec<u8>; 2]], method: &str) {
    let parameters: MatchParameters = resolve(&json!({"method": method})).unwrap();
    let (cached, uncached) = (SurfaceCache::new(KEPT_BYTES), SurfaceCache::none());
    let mut seconds = [0.0, 0.0];
    let mut ratios = Vec::new();
    let mut n_vertices = 0;
    for pair in files {
        let [source, target] = pair.each_ref().map(|bytes| InputFile { bytes, name: None });
        let taken = [&uncached, &cached].map(|surfaces| {
            let began = Instant::now();
            let run = || run_match_with(surfaces, source, target, &parameters, &IntakeLimits::default(), &Silent);
            n_vertices = with_threads(1, run).unwrap().document.provenance.target.n_vertices;
            began.elapsed().as_secs_f64()
        });
        seconds = [seconds[0] + taken[0], seconds[1] + taken[1]];
        ratios.push(taken[1] / taken[0]);
    }
    ratios.sort_by(f64::total_cmp);
    println!(
        "| {inputs} | {n_vertices} | {method} | {:.2} | {:.2} | {:.3} | {:.3} | {:.3} | {:.3} | {:.0} |",
        seconds[0],
        seconds[1],
        seconds[1] / seconds[0],
        ratios[0],
        ratios[ratios.len() / 2],
        ratios[ratios.len() - 1],
        cached.bytes() as f64 / (1 << 20) as f64
    );
}
