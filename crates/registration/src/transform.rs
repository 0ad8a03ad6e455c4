//! Rigid transforms, with or without a reflection.

use nalgebra::{Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};

/// `p' = R p + t`, mm, with `R` orthogonal: `det R = +1`, or `−1` if a reflection was allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidTransform {
    /// `R`.
    pub rotation: Matrix3<f64>,
    /// `t`, mm.
    pub translation: Vector3<f64>,
}

impl RigidTransform {
    /// The identity.
    pub fn identity() -> Self {
        RigidTransform { rotation: Matrix3::identity(), translation: Vector3::zeros() }
    }

    /// The transform of a 4×4 matrix, row by row; the inverse of [`Self::matrix`].
    pub fn of_matrix(matrix: &[[f64; 4]; 4]) -> Self {
        RigidTransform {
            rotation: Matrix3::from_fn(|i, j| matrix[i][j]),
            translation: Vector3::from_fn(|i, _| matrix[i][3]),
        }
    }

    /// `R p + t`.
    pub fn apply(&self, p: &Point3<f64>) -> Point3<f64> {
        Point3::from(self.rotation * p.coords + self.translation)
    }

    /// The composition that applies `first`, then `self`.
    pub fn after(&self, first: &RigidTransform) -> RigidTransform {
        RigidTransform {
            rotation: self.rotation * first.rotation,
            translation: self.rotation * first.translation + self.translation,
        }
    }

    /// `source_from_target`.
    pub fn inverse(&self) -> RigidTransform {
        let rotation = self.rotation.transpose();
        RigidTransform { rotation, translation: -(rotation * self.translation) }
    }

    /// Whether `det R < 0`.
    pub fn is_reflection(&self) -> bool {
        self.rotation.determinant() < 0.0
    }

    /// The rotation as a unit quaternion with non-negative scalar part; for a reflection, the quaternion of `−R`.
    pub fn quaternion(&self) -> UnitQuaternion<f64> {
        let proper = if self.is_reflection() { -self.rotation } else { self.rotation };
        let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(proper));
        if q.w < 0.0 { UnitQuaternion::new_unchecked(-q.into_inner()) } else { q }
    }

    /// Angle of the rotation of [`Self::quaternion`], radians, in `[0, π]`.
    pub fn angle_rad(&self) -> f64 {
        let q = self.quaternion();
        2.0 * q.vector().norm().atan2(q.w)
    }

    /// Angle between the rotations of two transforms, radians.
    pub fn angle_to(&self, other: &RigidTransform) -> f64 {
        let between =
            RigidTransform { rotation: other.rotation * self.rotation.transpose(), translation: Vector3::zeros() };
        between.angle_rad()
    }

    /// 4×4 matrix, row by row.
    pub fn matrix(&self) -> [[f64; 4]; 4] {
        let (r, t) = (&self.rotation, &self.translation);
        let row = |i: usize| [r[(i, 0)], r[(i, 1)], r[(i, 2)], t[i]];
        [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
    }
}
