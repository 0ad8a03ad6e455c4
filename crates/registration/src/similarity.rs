//! Rigid transforms with a uniform scale.

use super::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};

/// `p' = s R p + t`, mm, with `s > 0` and `R` orthogonal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimilarityTransform {
    /// `s`, no unit; 1 for a rigid transform.
    pub scale: f64,
    /// `R`; `det R = −1` only where a reflection was asked for.
    pub rotation: Matrix3<f64>,
    /// `t`, mm.
    pub translation: Vector3<f64>,
}

impl SimilarityTransform {
    /// `s R p + t`.
    pub fn apply(&self, p: &Point3<f64>) -> Point3<f64> {
        Point3::from(self.scale * (self.rotation * p.coords) + self.translation)
    }

    /// `source_from_target`.
    pub fn inverse(&self) -> SimilarityTransform {
        let (scale, rotation) = (1.0 / self.scale, self.rotation.transpose());
        SimilarityTransform { scale, rotation, translation: -scale * (rotation * self.translation) }
    }

    /// The rigid transform with the same rotation that takes `center` to the same place: the similarity without its
    /// scaling about `center`, mm.
    pub fn rigid_about(&self, center: &Point3<f64>) -> RigidTransform {
        let translation = self.apply(center).coords - self.rotation * center.coords;
        RigidTransform { rotation: self.rotation, translation }
    }

    /// 4×4 matrix, row by row.
    pub fn matrix(&self) -> [[f64; 4]; 4] {
        let scaled = self.scale * self.rotation;
        RigidTransform { rotation: scaled, translation: self.translation }.matrix()
    }
}

impl From<RigidTransform> for SimilarityTransform {
    fn from(rigid: RigidTransform) -> Self {
        SimilarityTransform { scale: 1.0, rotation: rigid.rotation, translation: rigid.translation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_inverse_goes_back_and_a_center_keeps_its_image(seed in any::<u64>(), scale in 0.2f64..5.0) {
            let similarity = SimilarityTransform { scale, ..pose(seed).into() };
            for p in cloud(seed ^ 1, 5) {
                prop_assert!((similarity.inverse().apply(&similarity.apply(&p)) - p).norm() < 1e-9);
                prop_assert!((similarity.rigid_about(&p).apply(&p) - similarity.apply(&p)).norm() < 1e-9);
                let m = similarity.matrix();
                let x = m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3];
                prop_assert!((x - similarity.apply(&p).x).abs() < 1e-9);
            }
        }
    }
}
