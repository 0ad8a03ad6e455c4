//! Rotations as rows of numbers, in which records and plans state them, and their angles.

use nalgebra::Matrix3;

/// The matrix with these rows.
pub(crate) fn of_rows(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|r, c| rows[r][c])
}

/// The rows of a matrix.
pub(crate) fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    std::array::from_fn(|r| std::array::from_fn(|c| matrix[(r, c)]))
}

/// The angle of a rotation, radians, from 0 to π.
pub(crate) fn angle(rotation: &Matrix3<f64>) -> f64 {
    f64::midpoint(rotation.trace(), -1.0).clamp(-1.0, 1.0).acos()
}
