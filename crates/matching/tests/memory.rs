//! What a match is predicted to take, beside what an allocator counts, at the ends of every size.
#![allow(clippy::unwrap_used)]
#![allow(unsafe_code, reason = "an allocator that counts can only be written so")]

#[path = "../../../tests/counting/mod.rs"]
mod counting;

use counting::{HELD, MOST};
use homolog_contract::parameters::resolve;
use homolog_matching::{match_memory_bytes, match_surfaces};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use nalgebra::{Point3, Vector3};
use serde_json::{Value, json};
use std::sync::atomic::Ordering;

const THREADS: usize = 2;
/// Below this the tables that every match may have decide, and not what depends on its size.
const SMALL: u64 = 256 << 20;

/// A bent and tapered ellipsoid without symmetry, of `10 · 4^level + 2` vertices.
fn bean(level: u32) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap()
}

/// What a match takes at most, by the estimate and by the allocator, bytes.
fn taken(levels: [u32; 2], request: &Value) -> (u64, u64) {
    let [source, target] = levels.map(bean);
    let parameters = resolve(request).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().unwrap();
    let before = HELD.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    drop(pool.install(|| match_surfaces(&source, &target, &parameters, &Silent)));
    let counted = MOST.load(Ordering::Relaxed) - before;
    (match_memory_bytes((source.n_vertices(), source.n_faces()), target.n_vertices(), &parameters), counted as u64)
}

#[test]
fn no_match_takes_more_than_it_is_predicted_to() {
    let once = |more: Value| {
        let mut request = json!({"method": "thesis", "inference": {"max_iterations": 1}});
        for (name, value) in more.as_object().unwrap() {
            request[name.as_str()] = value.clone();
        }
        request
    };
    // Descriptors, and an energy on coarse levels that takes little.
    let described = |kind: &str| {
        once(
            json!({"inference": {"max_iterations": 1, "coarse_vertices": 200}, "features": [{"kind": kind, "support": 0.05}]}),
        )
    };
    let cases = [
        ([4, 4], once(json!({}))),
        ([2, 5], once(json!({}))),
        ([5, 2], once(json!({}))),
        ([3, 5], once(json!({}))),
        ([5, 3], once(json!({}))),
        ([4, 4], described("shot")),
        ([5, 5], described("shot")),
        ([5, 5], described("spin_image")),
        ([5, 5], described("shape_context")),
        ([5, 5], described("fpfh")),
        ([4, 4], described("heat_kernel_signature")),
        ([5, 5], described("heat_kernel_signature")),
        ([5, 3], described("wave_kernel_signature")),
        ([1, 1], json!({"method": "balanced"})),
        ([5, 5], json!({"method": "balanced"})),
        ([5, 2], json!({"method": "rigid"})),
        ([4, 4], json!({"method": "diffeomorphic"})),
    ];
    let mut lines = Vec::new();
    let mut is_fine = true;
    for (levels, request) in cases {
        let (predicted, counted) = taken(levels, &request);
        let share = predicted as f64 / counted as f64;
        is_fine &= share >= 1.0 && (share <= 2.0 || predicted < SMALL);
        lines.push(format!("{levels:?} {request}: predicted {predicted}, counted {counted}, {share:.2}"));
    }
    assert!(is_fine, "\n{}", lines.join("\n"));
}
