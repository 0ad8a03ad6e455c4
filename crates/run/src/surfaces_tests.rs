//! What is kept is what would be made anew, once for all, and no more of it than allowed.

use super::{InputFile, ReadySurface, RunError, RunOutput, Side, SurfaceCache, run_match, run_match_with};
use crate::intake::IntakeLimits;
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use serde_json::{Value, json};
use std::sync::{Arc, Barrier};

/// A subject and the template, as files.
fn subject(seed: u64) -> [Vec<u8>; 2] {
    let pair = PhantomPair::new(PairRecipe {
        subject: seed + 1,
        target_subject: 0,
        deform_share: 0.0,
        deform_seed: 0,
        pose_seed: Some(3),
        permute_seed: Some(4),
    });
    let (pair, edge_mm) = (pair.unwrap(), 2.0);
    let (source, target) = (pair.source_surface(edge_mm).unwrap().mesh, pair.target_surface(edge_mm).unwrap().0.mesh);
    [source, target].map(|mesh| write_ply(&mesh))
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

/// What `bytes` become when matched with themselves.
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
fn a_template_against_subjects_gets_the_same_answers_with_and_without_the_cache() {
    let cache = SurfaceCache::new(64 << 20);
    let limits = IntakeLimits::default();
    for request in [
        json!({"method": "rigid"}),
        json!({"method": "balanced"}),
        json!({"method": "balanced", "inference": {"coarse_vertices": 150}}),
    ] {
        let parameters = parameters(request);
        // The first subject comes back, then with both sides exchanged.
        for (seed, turned) in [(0, false), (1, false), (0, false), (0, true)] {
            let [source, target] = subject(seed);
            let [source, target] = if turned { [&target, &source] } else { [&source, &target] };
            let with = run_match_with(&cache, file(source), file(target), &parameters, &limits, &Silent);
            let without = run_match(file(source), file(target), &parameters, &limits, &Silent);
            assert!(untimed(with.unwrap()) == untimed(without.unwrap()), "{:?} {seed} {turned}", parameters.method);
        }
    }
}

#[test]
fn what_a_surface_depends_on_makes_another_and_nothing_else_does() {
    let cache = SurfaceCache::new(64 << 20);
    let [source, target] = subject(0);
    let of = |request: Value| ready(&cache, [&source, &target], request).unwrap();
    let first = of(json!({}));
    for same in [json!({}), json!({"seed": 7}), json!({"energy": {"alpha": 3.0}})] {
        assert!(first.iter().zip(&of(same.clone())).all(|(a, b)| Arc::ptr_eq(a, b)), "{same}");
    }
    let other = [
        json!({"input": {"smoothing_mm": 0.9}}),
        json!({"input": {"allow_boundary": true}}),
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
fn matches_that_need_a_surface_at_once_prepare_it_once() {
    let cache = SurfaceCache::new(64 << 20);
    let files: Vec<_> = (0..3).map(subject).collect();
    let n = 12;
    let start = Barrier::new(n);
    // Subjects on either side of the template's key, and exchanged with it, so that claims cross.
    let found: Vec<[Arc<ReadySurface>; 2]> = std::thread::scope(|scope| {
        let (files, cache, start) = (&files, &cache, &start);
        let of = |k: usize| {
            move || {
                let [source, template] = &files[k % files.len()];
                let pool = rayon::ThreadPoolBuilder::new().num_threads(1 + k % 2).build().unwrap();
                start.wait();
                let turned = k % 4 > 1;
                let sides: [&[u8]; 2] = if turned { [template, source] } else { [source, template] };
                let [a, b] = pool.install(|| ready(cache, sides, json!({}))).unwrap();
                if turned { [b, a] } else { [a, b] }
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
fn no_more_bytes_are_kept_than_allowed_and_the_template_is_among_them() {
    let [_, template] = subject(0);
    let each = {
        let cache = SurfaceCache::new(64 << 20);
        one(&cache, &template);
        cache.bytes()
    };
    let allowed = 5 * each;
    let cache = SurfaceCache::new(allowed);
    let first = one(&cache, &template);
    for seed in 0..12 {
        let [source, template] = subject(seed);
        let [_, again] = ready(&cache, [&source, &template], json!({})).unwrap();
        assert!(Arc::ptr_eq(&first, &again), "it had left before subject {seed}");
        assert!(cache.bytes() <= allowed, "{} bytes of {allowed}", cache.bytes());
    }
    assert!(cache.bytes() > allowed / 2, "subjects are kept while there is room");
}

#[test]
fn a_surface_that_is_too_large_to_be_kept_is_matched_all_the_same() {
    let [source, template] = subject(0);
    for cache in [SurfaceCache::new(10_000), SurfaceCache::new(0), SurfaceCache::none()] {
        let [first, again] = [0, 1].map(|_| ready(&cache, [&source, &template], json!({})).unwrap());
        assert!(first.iter().zip(&again).all(|(a, b)| !Arc::ptr_eq(a, b) && a.prepared == b.prepared));
        assert_eq!(cache.bytes(), 0);
    }
}

#[test]
fn what_is_refused_is_not_kept_and_hands_its_place_on() {
    let cache = SurfaceCache::new(64 << 20);
    let [source, _] = subject(0);
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(nalgebra::Point3::from).to_vec();
    let open = write_ply(&SurfaceMesh::new(vertices, FaceArity::Triangle, vec![0, 1, 2]).unwrap());
    for _ in 0..2 {
        for (sides, refused) in [([&open, &source], Side::Source), ([&source, &open], Side::Target)] {
            let error = ready(&cache, sides.map(Vec::as_slice), json!({})).err().unwrap();
            assert!(matches!(error, RunError::Input { side, .. } if side == refused), "{error}");
        }
    }
    assert_eq!(cache.bytes(), 0, "a match that fails keeps neither side");
    let kept = one(&cache, &source);
    assert!(Arc::ptr_eq(&kept, &one(&cache, &source)) && cache.bytes() > 0);
}

#[test]
fn hits_and_misses_are_counted_and_nothing_says_of_what() {
    let recorder = metrics_exporter_prometheus::PrometheusBuilder::new().build_recorder();
    let cache = SurfaceCache::new(64 << 20);
    let template = subject(0)[1].clone();
    metrics::with_local_recorder(&recorder, || {
        for seed in 0..3 {
            ready(&cache, [&subject(seed)[0], &template], json!({})).unwrap();
        }
        // Switched off, it looks nowhere.
        one(&SurfaceCache::none(), &template);
    });
    let text = recorder.handle().render();
    let mut lines: Vec<&str> = text.lines().filter(|l| l.starts_with("homolog_prepared_surfaces_total")).collect();
    lines.sort_unstable();
    let counted = |end: &str, n: u32| format!("homolog_prepared_surfaces_total{{lookup=\"{end}\"}} {n}");
    assert_eq!(lines, [counted("hit", 2), counted("miss", 4)]);
}
