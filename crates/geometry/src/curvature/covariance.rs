//! Curvature from the covariance of normals and positions in a ball.
//!
//! Source: Berkmann, Caelli, "Computation of surface geometry and segmentation using covariance techniques", IEEE PAMI
//! 16(11), 1994. In the tangent plane of a vertex, let `u` be the projected position of a point of the ball and `ν` its
//! projected unit normal. A smooth surface has `ν = S u + O(|u|²)` with the symmetric shape operator `S`, whose
//! eigenvalues are the principal curvatures (positive where the surface is convex, since normals look outwards). The
//! covariance of the projected normals alone, `C_νν ≈ S C_uu S`, has squares of principal curvatures as eigenvalues and
//! loses their signs. The covariance of normals with positions, `C_νu ≈ S C_uu`, keeps the signs. The symmetric `S`
//! that minimizes `Σ a |ν − S u|²` about the means (`a` the area of a vertex) solves
//!
//! ```text
//! S C_uu + C_uu S = C_νu + C_νuᵀ
//! ```
//!
//! In the axes of `C_uu`, with eigenvalues `λ`, the solution is `S_kl = (C_νu + C_νuᵀ)_kl / (λ_k + λ_l)`. Then `K = det
//! S` and `H = tr S / 2`. On a sphere with exact normals `ν = u / r` holds exactly, for any ball.

use super::ball::Patches;
use nalgebra::{Matrix2, SymmetricEigen, Vector2};

/// Smallest ratio of the two variances of the positions that determines `S` in both directions.
const COLLINEAR_RTOL: f64 = 1e-6;

/// Gaussian and mean curvature at `center`, or `None` if `members` lie on a line or have no area.
pub(super) fn curvature_of(patches: &Patches, center: usize, members: &[u32]) -> Option<(f64, f64)> {
    let plane = patches.tangent_plane(center);
    let total: f64 = members.iter().map(|&v| patches.areas[v as usize]).sum();
    let pairs = members.iter().map(|&v| {
        let (position, _) = patches.in_frame(&plane, center, v as usize);
        (patches.areas[v as usize] / total, position, plane * patches.normals[v as usize])
    });
    let (mean_position, mean_normal) = pairs
        .clone()
        .fold((Vector2::zeros(), Vector2::zeros()), |(p, n), (weight, u, nu)| (p + u * weight, n + nu * weight));
    let mut of_positions = Matrix2::zeros();
    let mut of_both = Matrix2::zeros();
    for (weight, u, nu) in pairs {
        let u = u - mean_position;
        of_positions += u * u.transpose() * weight;
        of_both += (nu - mean_normal) * u.transpose() * weight;
    }
    if !of_positions.iter().all(|c| c.is_finite()) {
        return None;
    }
    let SymmetricEigen { eigenvalues: spread, eigenvectors: axes } = of_positions.symmetric_eigen();
    if spread.min() <= COLLINEAR_RTOL * spread.max() {
        return None;
    }
    let right_side = axes.transpose() * (of_both + of_both.transpose()) * axes;
    let shape = right_side.component_div(&Matrix2::from_fn(|k, l| spread[k] + spread[l]));
    Some((shape.determinant(), shape.trace() / 2.0))
}
