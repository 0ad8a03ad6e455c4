//! The cotangent Laplacian of a surface.
//!
//! Source: Pinkall, Polthier, "Computing discrete minimal surfaces and their conjugates", 1993. A quad counts as
//! the mean of its two triangulations, so that no diagonal is preferred.

use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::Vector3;

/// A contribution to the weight `w_ij = w_ji` of the Laplacian; contributions to the same pair add up.
pub struct Weight {
    /// One vertex.
    pub i: usize,
    /// The other vertex.
    pub j: usize,
    /// The contribution, without unit.
    pub weight: f64,
}

/// The four triangles made by the two diagonals of a quad.
pub(super) fn both_triangulations(quad: &[u32]) -> [[u32; 3]; 4] {
    [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]], [quad[1], quad[2], quad[3]], [quad[1], quad[3], quad[0]]]
}

/// Lower bound of twice the area of a face, as a share of the sum of its squared edges. Below it the cotangents are so
/// large that their sums lose all digits. One bound for the three angles of a face scales its part of the Laplacian as
/// a whole, which stays positive semidefinite.
const LEAST_AREA: f64 = 1e-5;

/// All contributions to the cotangent weights: half the cotangent of each angle, for the edge opposite to it.
pub fn cotangent_weights(mesh: &SurfaceMesh) -> Vec<Weight> {
    let mut weights = Vec::with_capacity(mesh.indices().len());
    let mut add = |corners: [u32; 3], share: f64| {
        for k in 0..3 {
            let [at, i, j] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]].map(|c| c as usize);
            let v = mesh.vertices();
            let (a, b) = (v[i] - v[at], v[j] - v[at]);
            let squares = a.norm_squared() + b.norm_squared() + (v[i] - v[j]).norm_squared();
            // A face that is a single point contributes nothing.
            if squares > 0.0 {
                let twice_area = a.cross(&b).norm().max(LEAST_AREA * squares);
                weights.push(Weight { i, j, weight: share * a.dot(&b) / (2.0 * twice_area) });
            }
        }
    };
    for f in mesh.faces() {
        match mesh.arity() {
            FaceArity::Triangle => add([f[0], f[1], f[2]], 1.0),
            FaceArity::Quad => both_triangulations(f).into_iter().for_each(|corners| add(corners, 0.5)),
        }
    }
    weights
}

/// `(L p)_i = Σ_j w_ij (p_i − p_j)` for every vertex, mm; points outwards where the surface is convex.
pub(super) fn laplacian_of_positions(mesh: &SurfaceMesh) -> Vec<Vector3<f64>> {
    let mut laplacian = vec![Vector3::zeros(); mesh.n_vertices()];
    for Weight { i, j, weight } in cotangent_weights(mesh) {
        let difference = (mesh.vertices()[i] - mesh.vertices()[j]) * weight;
        laplacian[i] += difference;
        laplacian[j] -= difference;
    }
    laplacian
}
