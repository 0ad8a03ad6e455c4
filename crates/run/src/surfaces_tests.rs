//! A kept surface equals a newly prepared one, is prepared once, and no more bytes are kept than allowed.

use super::{InputFile, ReadySurface, RunError, RunOutput, Side, SurfaceCache, run_match, run_match_with};
use crate::intake::IntakeLimits;
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::PhantomPair;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use serde_json::{Value, json};
use std::sync::{Arc, Barrier};

/// A subject and the template, as files.
fn subject(number: u64) -> [Vec<u8>; 2] {
    let meshes = PhantomPair::against_template(number).unwrap().meshes(2.0).unwrap();
    meshes.map(|mesh| write_ply(&mesh))
}

fn parameters(request: Value) -> MatchParameters {
    resolve(&request).unwrap()
}

fn file(bytes: &[u8]) -> InputFile<'_> {
    InputFile { bytes, name: Some("input.ply") }
}

fn ready(
    cache: &SurfaceCache,
    [source, target]: [&[u8]; 2],
    request: Value,
) -> Result<[Arc<ReadySurface>; 2], RunError> {
    cache.ready([file(source), file(target)], &parameters(request), &IntakeLimits::default(), &Silent)
}

/// The surface of `bytes`, requested as both source and target.
fn one(cache: &SurfaceCache, bytes: &[u8]) -> Arc<ReadySurface> {
    let [source, target] = ready(cache, [bytes, bytes], json!({})).unwrap();
    assert!(Arc::ptr_eq(&source, &target), "one file is prepared once");
    source
}

fn untimed(mut output: RunOutput) -> RunOutput {
    output.document.timings_ms.clear();
    output
}

#[test]
fn matches_to_a_template_have_the_same_results_with_and_without_the_cache() {
    let cache = SurfaceCache::new(64 << 20);
    let limits = IntakeLimits::default();
    for request in [
        json!({"method": "rigid"}),
        json!({"method": "balanced"}),
        json!({"method": "balanced", "inference": {"coarse_vertices": 150}}),
    ] {
        let parameters = parameters(request);
        // The first subject is matched again, then with source and target exchanged.
        for (number, exchanged) in [(0, false), (1, false), (0, false), (0, true)] {
            let [source, target] = subject(number);
            let [source, target] = if exchanged { [&target, &source] } else { [&source, &target] };
            let with = run_match_with(&cache, file(source), file(target), &parameters, &limits, &Silent);
            let without = run_match(file(source), file(target), &parameters, &limits, &Silent);
            assert!(
                untimed(with.unwrap()) == untimed(without.unwrap()),
                "{:?} {number} {exchanged}",
                parameters.method
            );
        }
    }
}

#[test]
fn only_parameters_that_a_surface_depends_on_make_another_surface() {
    let cache = SurfaceCache::new(64 << 20);
    let [source, target] = subject(0);
    let of = |request: Value| ready(&cache, [&source, &target], request).unwrap();
    let first = of(json!({}));
    for same in [json!({}), json!({"seed": 7}), json!({"energy": {"alpha": 3.0}})] {
        assert!(first.iter().zip(&of(same.clone())).all(|(a, b)| Arc::ptr_eq(a, b)), "{same}");
    }
    let other = [
        json!({"input": {"smoothing_mm": 0.9}}),
        json!({"input": {"allow_boundary": false}}),
        json!({"input": {"repair": ["weld"]}}),
        json!({"input": {"labels": [17]}}),
        json!({"input": {"surface": "voxel"}}),
        json!({"inference": {"coarse_vertices": 150}}),
    ];
    for request in other {
        assert!(first.iter().zip(&of(request.clone())).all(|(a, b)| !Arc::ptr_eq(a, b)), "{request}");
    }
    let parameters = parameters(json!({}));
    let by = |name, limits: &IntakeLimits| {
        let files = [&source, &target].map(|bytes| InputFile { bytes, name });
        cache.ready(files, &parameters, limits, &Silent).unwrap()
    };
    let stricter = IntakeLimits { max_vertices: 10_000, ..IntakeLimits::default() };
    for again in [by(None, &IntakeLimits::default()), by(Some("input.ply"), &stricter)] {
        assert!(!Arc::ptr_eq(&first[0], &again[0]));
    }
}

#[test]
fn simultaneous_matches_prepare_a_shared_surface_once() {
    let cache = SurfaceCache::new(64 << 20);
    let files: Vec<_> = (0..3).map(subject).collect();
    let n = 12;
    let start = Barrier::new(n);
    // Keys of subjects sort before and after the template's, and sides are exchanged, so that claims overlap in any order.
    let found: Vec<[Arc<ReadySurface>; 2]> = std::thread::scope(|scope| {
        let (files, cache, start) = (&files, &cache, &start);
        let of = |k: usize| {
            move || {
                let [source, template] = &files[k % files.len()];
                let pool = rayon::ThreadPoolBuilder::new().num_threads(1 + k % 2).build().unwrap();
                start.wait();
                let exchanged = k % 4 > 1;
                let sides: [&[u8]; 2] = if exchanged { [template, source] } else { [source, template] };
                let [a, b] = pool.install(|| ready(cache, sides, json!({}))).unwrap();
                if exchanged { [b, a] } else { [a, b] }
            }
        };
        let threads: Vec<_> = (0..n).map(|k| scope.spawn(of(k))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    for (k, [subject, template]) in found.iter().enumerate() {
        assert!(Arc::ptr_eq(template, &found[0][1]), "the template was prepared twice");
        assert!(Arc::ptr_eq(subject, &found[k % files.len()][0]), "subject {k} was prepared twice");
    }
}

#[test]
fn no_more_bytes_are_kept_than_allowed_and_the_template_stays() {
    let [_, template] = subject(0);
    let each = {
        let cache = SurfaceCache::new(64 << 20);
        one(&cache, &template);
        cache.bytes()
    };
    let allowed = 5 * each;
    let cache = SurfaceCache::new(allowed);
    let first = one(&cache, &template);
    for number in 0..12 {
        let [source, template] = subject(number);
        let [_, again] = ready(&cache, [&source, &template], json!({})).unwrap();
        assert!(Arc::ptr_eq(&first, &again), "evicted before subject {number}");
        assert!(cache.bytes() <= allowed, "{} bytes of {allowed}", cache.bytes());
    }
    assert!(cache.bytes() > allowed / 2, "subjects are kept while there is room");
}

#[test]
fn a_surface_too_large_to_be_kept_is_prepared_for_each_match() {
    let [source, template] = subject(0);
    for cache in [SurfaceCache::new(10_000), SurfaceCache::new(0), SurfaceCache::none()] {
        let [first, again] = [0, 1].map(|_| ready(&cache, [&source, &template], json!({})).unwrap());
        assert!(first.iter().zip(&again).all(|(a, b)| !Arc::ptr_eq(a, b) && a.prepared == b.prepared));
        assert_eq!(cache.bytes(), 0);
    }
}

#[test]
fn a_refused_input_is_not_kept_and_does_not_block_later_matches() {
    let cache = SurfaceCache::new(64 << 20);
    let [source, _] = subject(0);
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(nalgebra::Point3::from).to_vec();
    let open = write_ply(&SurfaceMesh::new(vertices, FaceArity::Triangle, vec![0, 1, 2]).unwrap());
    for _ in 0..2 {
        for (sides, refused) in [([&open, &source], Side::Source), ([&source, &open], Side::Target)] {
            let error =
                ready(&cache, sides.map(Vec::as_slice), json!({"input": {"allow_boundary": false}})).err().unwrap();
            assert!(matches!(error, RunError::Input { side, .. } if side == refused), "{error}");
        }
    }
    assert_eq!(cache.bytes(), 0, "a match that fails keeps neither side");
    let kept = one(&cache, &source);
    assert!(Arc::ptr_eq(&kept, &one(&cache, &source)) && cache.bytes() > 0);
}

#[test]
fn hits_and_misses_are_counted_without_naming_files() {
    let recorder = metrics_exporter_prometheus::PrometheusBuilder::new().build_recorder();
    let cache = SurfaceCache::new(64 << 20);
    let template = subject(0)[1].clone();
    metrics::with_local_recorder(&recorder, || {
        for number in 0..3 {
            ready(&cache, [&subject(number)[0], &template], json!({})).unwrap();
        }
        // A cache that keeps nothing counts no lookups.
        one(&SurfaceCache::none(), &template);
    });
    let text = recorder.handle().render();
    let mut lines: Vec<&str> = text.lines().filter(|l| l.starts_with("homolog_prepared_surfaces_total")).collect();
    lines.sort_unstable();
    let counted = |lookup: &str, n: u32| format!("homolog_prepared_surfaces_total{{lookup=\"{lookup}\"}} {n}");
    assert_eq!(lines, [counted("hit", 2), counted("miss", 4)]);
}
