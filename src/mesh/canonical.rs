//! A numbering of vertices and faces that depends on where they are, not on how they came.
//!
//! Everything after this step sees the same bytes however the uploaded vertices were numbered, so renumbering
//! an input permutes the answer exactly, rounding included. The order is along a Morton (Z-order) curve: close
//! vertices get close numbers, which keeps neighbouring labels near each other in memory.

use super::SurfaceMesh;
use std::cmp::Ordering;

/// A mesh in canonical numbering, with the way back.
#[derive(Debug, Clone, PartialEq)]
pub struct CanonicalMesh {
    /// The renumbered mesh.
    pub mesh: SurfaceMesh,
    /// For every canonical vertex the vertex of the original mesh.
    pub original: Vec<u32>,
}

/// `mesh` renumbered by position. Vertices at exactly the same place keep their original order.
///
/// Cost `O(n log n)`.
pub fn canonicalize(mesh: &SurfaceMesh) -> CanonicalMesh {
    let (low, high) = mesh.bounding_box();
    let extent = (high - low).max().max(f64::MIN_POSITIVE);
    // 21 bits an axis fill 63 bits.
    let cell = |value: f64, low: f64| (((value - low) / extent) * 2_097_151.0) as u64;
    let keys: Vec<u64> = mesh
        .vertices()
        .iter()
        .map(|p| spread(cell(p.x, low.x)) | spread(cell(p.y, low.y)) << 1 | spread(cell(p.z, low.z)) << 2)
        .collect();
    let v = mesh.vertices();
    let by_position = |a: usize, b: usize| -> Ordering {
        v[a].x.total_cmp(&v[b].x).then(v[a].y.total_cmp(&v[b].y)).then(v[a].z.total_cmp(&v[b].z))
    };
    let mut original: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
    original.sort_by(|&a, &b| {
        let (a, b) = (a as usize, b as usize);
        keys[a].cmp(&keys[b]).then_with(|| by_position(a, b)).then(a.cmp(&b))
    });
    let mut canonical = vec![0u32; original.len()];
    for (new, &old) in original.iter().enumerate() {
        canonical[old as usize] = new as u32;
    }
    let mut faces: Vec<Vec<u32>> = mesh
        .faces()
        .map(|f| {
            let mut face: Vec<u32> = f.iter().map(|&k| canonical[k as usize]).collect();
            let first = (0..face.len()).min_by_key(|&k| face[k]).unwrap_or(0);
            face.rotate_left(first);
            face
        })
        .collect();
    faces.sort_unstable();
    let vertices = original.iter().map(|&k| v[k as usize]).collect();
    let mesh = SurfaceMesh { vertices, arity: mesh.arity, indices: faces.concat() };
    CanonicalMesh { mesh, original }
}

/// The low 21 bits of `x`, two zero bits between each.
fn spread(x: u64) -> u64 {
    let mut x = x & 0x1f_ffff;
    x = (x | x << 32) & 0x001f_0000_0000_ffff;
    x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}
