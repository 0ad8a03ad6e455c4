//! Curvature of the least-squares paraboloid in a ball.
//!
//! In the tangent frame of a vertex, with heights `z` along the outward normal, the paraboloid
//!
//! ```text
//! z = a u² + b u v + c v² + d u + e v + f
//! ```
//!
//! minimizes `Σ A (z − z_i)²` over the points of the ball, where `A` is the area of a vertex. The slopes `d`, `e`
//! absorb an error of the normal, the offset `f` an error of the position. The curvature over the vertex follows
//! exactly from the two fundamental forms of a graph (Gauss; do Carmo, "Differential geometry of curves and surfaces",
//! 1976, 3-3). The mean curvature is negated, since the normal points outwards:
//!
//! ```text
//! W² = 1 + d² + e²,   K = (4 a c − b²) / W⁴,   H = −(a (1 + e²) − b d e + c (1 + d²)) / W³
//! ```

use super::ball::Patches;
use nalgebra::{Cholesky, Matrix6, Vector6};

/// Smallest pivot of the normal equations, relative to the largest, from which the points determine a paraboloid. In
/// units of the ball a regular neighborhood has about 1e-2; a zero pivot becomes less than 1e-15 by rounding.
const PIVOT_RTOL: f64 = 1e-10;

/// Gaussian and mean curvature at `center`, or `None` if `members` do not determine a paraboloid.
pub(super) fn curvature_of(patches: &Patches, center: usize, members: &[u32]) -> Option<(f64, f64)> {
    if members.len() < 6 {
        return None;
    }
    let plane = patches.tangent_plane(center);
    let points = members.iter().map(|&v| (patches.areas[v as usize], patches.in_frame(&plane, center, v as usize)));
    // In units of the extent of the points, so that the pivots can be compared.
    let unit = points.clone().fold(0.0f64, |largest, (_, (u, _))| largest.max(u.norm()));
    let total: f64 = points.clone().map(|(area, _)| area).sum();
    let mut normal_matrix = Matrix6::zeros();
    let mut right_side = Vector6::zeros();
    for (area, (at, height)) in points {
        let (u, v) = (at.x / unit, at.y / unit);
        let row = Vector6::new(u * u, u * v, v * v, u, v, 1.0);
        normal_matrix += row * row.transpose() * (area / total);
        right_side += row * (area / total * height / unit);
    }
    let factor = Cholesky::new(normal_matrix)?;
    let pivots = factor.l_dirty().diagonal().map(|d| d * d);
    // Written so that NaN pivots fail as well.
    let determined = pivots.min() > PIVOT_RTOL * pivots.max();
    if !determined {
        return None;
    }
    let fit = factor.solve(&right_side);
    Some(of_graph([fit[0] / unit, fit[1] / unit, fit[2] / unit], [fit[3], fit[4]]))
}

/// Gaussian and mean curvature over the origin of the graph with these coefficients of second and first degree.
pub(super) fn of_graph([a, b, c]: [f64; 3], [d, e]: [f64; 2]) -> (f64, f64) {
    let w_squared = 1.0 + d * d + e * e;
    let gaussian = (4.0 * a * c - b * b) / (w_squared * w_squared);
    let mean = -(a * (1.0 + e * e) - b * d * e + c * (1.0 + d * d)) / (w_squared * w_squared.sqrt());
    (gaussian, mean)
}
