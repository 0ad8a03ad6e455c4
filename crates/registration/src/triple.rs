//! Three points, and when they are too nearly on a line.

use nalgebra::{Point3, Vector3};

/// Reasons why three pairs determine no transform.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TripleError {
    /// The three points of one side lie nearly on a line.
    #[error("the three points lie nearly on a line")]
    Collinear,
}

/// Ratio of height to longest edge below which a triangle is too thin to determine an orientation.
const MIN_HEIGHT_RATIO: f64 = 0.05;

/// Normal of a triple; its length is twice the area, mm².
pub(super) fn triangle_normal(p: &[Point3<f64>; 3]) -> Result<Vector3<f64>, TripleError> {
    let (a, b) = (p[1] - p[0], p[2] - p[0]);
    let longest = a.norm_squared().max(b.norm_squared()).max((p[2] - p[1]).norm_squared());
    let normal = a.cross(&b);
    // Twice the area is base times height.
    if normal.norm() <= MIN_HEIGHT_RATIO * longest || longest == 0.0 {
        return Err(TripleError::Collinear);
    }
    Ok(normal)
}
