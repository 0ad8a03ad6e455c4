//! Similarity transforms: rigid transforms with a uniform scale.

use super::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};

/// `p' = s R p + t`, mm, with `s > 0` and `R` orthogonal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimilarityTransform {
    /// `s`, no unit; 1 for a rigid transform.
    pub scale: f64,
    /// `R`; `det R = −1` only if a reflection was allowed.
    pub rotation: Matrix3<f64>,
    /// `t`, mm.
    pub translation: Vector3<f64>,
}

impl SimilarityTransform {
    /// `s R p + t`.
    pub fn apply(&self, p: &Point3<f64>) -> Point3<f64> {
        Point3::from(self.scale * (self.rotation * p.coords) + self.translation)
    }

    /// 4×4 matrix, row by row.
    pub fn matrix(&self) -> [[f64; 4]; 4] {
        let scaled = self.scale * self.rotation;
        RigidTransform { rotation: scaled, translation: self.translation }.matrix()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};

    #[test]
    fn the_matrix_maps_points_as_the_transform_does() {
        let RigidTransform { rotation, translation } = pose(5);
        let similarity = SimilarityTransform { scale: 1.7, rotation, translation };
        let m = similarity.matrix();
        for p in cloud(6, 5) {
            let mapped = Point3::from([0, 1, 2].map(|r| m[r][0] * p.x + m[r][1] * p.y + m[r][2] * p.z + m[r][3]));
            assert!((mapped - similarity.apply(&p)).norm() < 1e-9);
        }
    }
}
