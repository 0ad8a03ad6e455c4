//! A numbering of vertices and faces that depends on their positions alone, not on their order in the input.
//!
//! Every later step sees the same bytes for any numbering of the uploaded vertices, so renumbering an input permutes
//! the answer exactly, rounding included. Vertices are ordered along a Morton (Z-order) curve: close vertices get close
//! numbers, which keeps neighboring labels near each other in memory.

use super::{FaceArity, Numbering, SurfaceMesh};
use std::cmp::Ordering;

/// A mesh in canonical numbering.
#[derive(Debug, Clone, PartialEq)]
pub struct CanonicalMesh {
    /// The renumbered mesh.
    pub mesh: SurfaceMesh,
    /// For each vertex of the mesh, its vertex in the input.
    pub numbering: Numbering,
}

/// `mesh` renumbered by position. Vertices at exactly the same position keep the order of the input.
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
    let mut order: Vec<(u64, u32)> = keys.into_iter().zip(0..).collect();
    // No two keys are equal, so the result does not depend on the sorting algorithm.
    order.sort_unstable_by(|&(key_a, a), &(key_b, b)| {
        key_a.cmp(&key_b).then_with(|| by_position(a as usize, b as usize)).then(a.cmp(&b))
    });
    let original: Vec<u32> = order.into_iter().map(|(_, old)| old).collect();
    let mut canonical = vec![0u32; original.len()];
    for (new, &old) in original.iter().enumerate() {
        canonical[old as usize] = new as u32;
    }
    let indices = match mesh.arity {
        FaceArity::Triangle => sorted_faces::<3>(&mesh.indices, &canonical),
        FaceArity::Quad => sorted_faces::<4>(&mesh.indices, &canonical),
    };
    let vertices = original.iter().map(|&k| v[k as usize]).collect();
    let mesh = SurfaceMesh { vertices, arity: mesh.arity, indices };
    CanonicalMesh { mesh, numbering: Numbering::new(original) }
}

/// Faces of `N` corners with each vertex `v` replaced by `canonical[v]`, in ascending order; each begins with its lowest
/// corner.
fn sorted_faces<const N: usize>(indices: &[u32], canonical: &[u32]) -> Vec<u32> {
    let (faces, _) = indices.as_chunks::<N>();
    let renumbered = |face: &[u32; N]| {
        let mut face = face.map(|k| canonical[k as usize]);
        let first = (0..N).min_by_key(|&k| face[k]).unwrap_or(0);
        face.rotate_left(first);
        face
    };
    let mut faces: Vec<[u32; N]> = faces.iter().map(renumbered).collect();
    faces.sort_unstable();
    faces.concat()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{ellipsoid, torus};
    use nalgebra::Vector3;

    /// The same as `sorted_faces`, on faces of any number of corners.
    fn sorted_lists(mesh: &SurfaceMesh, canonical: &[u32]) -> Vec<u32> {
        let renumbered = |f: &[u32]| {
            let mut face: Vec<u32> = f.iter().map(|&k| canonical[k as usize]).collect();
            let first = (0..face.len()).min_by_key(|&k| face[k]).unwrap();
            face.rotate_left(first);
            face
        };
        let mut faces: Vec<Vec<u32>> = mesh.faces().map(renumbered).collect();
        faces.sort();
        faces.concat()
    }

    #[test]
    fn the_numbering_is_a_permutation_and_the_faces_are_the_same_ascending() {
        let torus = |arity| torus(10.0, 4.0, 16, 9, arity);
        let shapes = [ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3), torus(FaceArity::Triangle), torus(FaceArity::Quad)];
        for mesh in shapes {
            let CanonicalMesh { mesh: renumbered, numbering } = canonicalize(&mesh);
            let mut number = vec![u32::MAX; numbering.n_vertices()];
            for (new, &old) in numbering.originals().iter().enumerate() {
                assert_eq!(renumbered.vertices()[new], mesh.vertices()[old as usize]);
                number[old as usize] = new as u32;
            }
            assert!(!number.contains(&u32::MAX));
            assert_eq!(renumbered.indices(), sorted_lists(&mesh, &number));
        }
    }
}
