//! The boundary of an open surface.

use super::SurfaceMesh;
use super::elements::DisjointSets;

impl SurfaceMesh {
    /// For every vertex whether it lies on the boundary, that is, on an edge with only one face; `None` for a surface
    /// without boundary.
    ///
    /// Cost `O(faces)` for closed surfaces, `O(faces log faces)` for open ones.
    pub fn boundary_vertices(&self) -> Option<Vec<bool>> {
        let edges = self.boundary_edges();
        let mut on_boundary = vec![false; self.n_vertices()];
        edges.iter().for_each(|edge| edge.iter().for_each(|&v| on_boundary[v as usize] = true));
        (!edges.is_empty()).then_some(on_boundary)
    }

    /// Lengths of the rims (connected pieces of the boundary), mm, longest first; empty without a boundary.
    ///
    /// Cost `O(faces)` for closed surfaces, `O(faces log faces)` for open ones.
    pub fn rim_lengths(&self) -> Vec<f64> {
        let edges = self.boundary_edges();
        if edges.is_empty() {
            return Vec::new();
        }
        let mut rims = DisjointSets::new(self.n_vertices());
        edges.iter().for_each(|&[a, b]| rims.join(a, b));
        let mut length_of = vec![0.0; self.n_vertices()];
        for [a, b] in edges {
            length_of[rims.root(a) as usize] += (self.vertices()[a as usize] - self.vertices()[b as usize]).norm();
        }
        length_of.retain(|length| *length > 0.0);
        length_of.sort_by(|a, b| b.total_cmp(a));
        length_of
    }

    /// The edges with only one face, ascending.
    fn boundary_edges(&self) -> Vec<[u32; 2]> {
        let directed = || self.faces().flat_map(|f| (0..f.len()).map(move |k| (f[k], f[(k + 1) % f.len()])));
        // On a closed oriented surface every edge is traversed once in each direction, so these sums are equal.
        // Otherwise they differ, except with a probability of 2⁻⁶⁴.
        let difference = directed().fold(0u64, |sum, (a, b)| sum.wrapping_add(mixed(a, b)).wrapping_sub(mixed(b, a)));
        if difference == 0 {
            return Vec::new();
        }
        let mut edges: Vec<[u32; 2]> = directed().map(|(a, b)| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.chunk_by(|a, b| a == b).filter(|uses| uses.len() == 1).map(|uses| uses[0]).collect()
    }
}

/// A hash of a directed edge (the finalizer of SplitMix64).
fn mixed(a: u32, b: u32) -> u64 {
    let mut x = (u64::from(a) << 32 | u64::from(b)).wrapping_add(0x9e37_79b9_7f4a_7c15);
    x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

#[cfg(test)]
mod tests {
    use crate::SurfaceMesh;
    use crate::shapes::{ellipsoid, torus};
    use crate::{FaceArity, repair};
    use nalgebra::{Point3, Vector3};

    #[test]
    fn a_closed_surface_has_no_boundary() {
        assert_eq!(ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3).boundary_vertices(), None);
        assert_eq!(torus(5.0, 2.0, 9, 7, FaceArity::Quad).boundary_vertices(), None);
        assert!(ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3).rim_lengths().is_empty());
    }

    #[test]
    fn every_hole_has_a_rim_of_its_own() {
        // A sheet of 9 x 9 unit squares without a square and without two beside each other.
        let vertices = (0..100).map(|k| Point3::new(f64::from(k % 10), f64::from(k / 10), 0.0)).collect();
        let at = |x: u32, y: u32| 10 * y + x;
        let missing = [(2, 2), (5, 6), (6, 6)];
        let squares = (0..81).map(|k| (k % 9, k / 9)).filter(|square| !missing.contains(square));
        let indices = squares.flat_map(|(x, y)| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]).collect();
        let sheet = SurfaceMesh::new(vertices, FaceArity::Quad, indices).unwrap();
        assert_eq!(sheet.rim_lengths(), [36.0, 6.0, 4.0]);
    }

    #[test]
    fn the_rim_of_half_an_ellipsoid_is_its_boundary() {
        let whole = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3);
        let kept: Vec<u32> = whole
            .triangles()
            .into_iter()
            .filter(|t| t.iter().all(|&k| whole.vertices()[k as usize].x < 0.5))
            .flatten()
            .collect();
        let half = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, kept).unwrap();
        let half = repair::drop_unused(&half).mesh;
        let on_boundary = half.boundary_vertices().unwrap();
        let rim = on_boundary.iter().filter(|&&b| b).count();
        assert!(rim > 10 && rim < half.n_vertices() / 4, "{rim}");
        // The rim lies where the surface was cut.
        assert!(half.vertices().iter().zip(&on_boundary).filter(|(_, b)| **b).all(|(p, _)| p.x > 0.0));
    }
}
