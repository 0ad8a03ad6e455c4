//! Three closed-form solvers of absolute orientation behind one function.
//!
//! All three start from the same covariance and return the same errors; on well-posed pairs they agree to rounding.
//! They differ in the matrix they decompose: the covariance itself, a symmetric 4×4 matrix, or a symmetric 3×3 matrix.
//!
//! Source: Arun, Huang, Blostein 1987 (SVD); Horn, J. Opt. Soc. Am. A 4(4), 1987 (unit quaternion); Horn, Hilden,
//! Negahdaripour, J. Opt. Soc. Am. A 5(7), 1988 (orthonormal matrices).

use super::RigidTransform;
use super::absolute_orientation::{COLLINEAR_RTOL, Moments, OrientationError, svd_rotation};
use nalgebra::{Matrix3, Matrix4, Point3, Quaternion, SymmetricEigen, UnitQuaternion, Vector3};

/// Method of computing the rotation from the covariance of the pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OrientationSolver {
    /// Singular value decomposition of the covariance.
    #[default]
    Svd,
    /// The unit quaternion that is the largest eigenvector of a symmetric 4×4 matrix.
    Quaternion,
    /// `R = M (MᵀM)^(−1/2)` by the eigenvalue decomposition of `MᵀM`; its rounding grows with the square of the
    /// ratio of the first to the second singular value.
    OrthonormalMatrix,
}

impl OrientationSolver {
    /// All solvers, in the order of the variants.
    pub const ALL: [Self; 3] =
        [OrientationSolver::Svd, OrientationSolver::Quaternion, OrientationSolver::OrthonormalMatrix];

    /// The orthogonal `R` with the largest `tr(Rᵀ C)`.
    pub(super) fn rotation(
        self,
        covariance: &Matrix3<f64>,
        allow_reflection: bool,
    ) -> Result<Matrix3<f64>, OrientationError> {
        match self {
            OrientationSolver::Svd => svd_rotation(covariance, allow_reflection),
            OrientationSolver::Quaternion => {
                Ok(quaternion_rotation(covariance, mirrors(covariance, allow_reflection)?))
            }
            OrientationSolver::OrthonormalMatrix => {
                Ok(orthonormal_rotation(covariance, mirrors(covariance, allow_reflection)?))
            }
        }
    }
}

/// [`absolute_orientation()`](super::absolute_orientation()) with a choice of solver: same arguments, same errors, and
/// for [`OrientationSolver::Svd`] the same bits.
///
/// # Errors
/// [`OrientationError`], the same for every solver.
///
/// # Cost
/// `O(n)`, no allocation.
pub fn solve_orientation(
    solver: OrientationSolver,
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    weights: Option<&[f64]>,
    allow_reflection: bool,
) -> Result<RigidTransform, OrientationError> {
    let moments = Moments::of(source, target, weights)?;
    Ok(moments.transform(solver.rotation(&moments.covariance, allow_reflection)?))
}

/// Whether the best orthogonal matrix is a reflection; `Degenerate` if the rotation is undetermined.
///
/// Uses the singular values of the covariance, so that every solver returns the same errors. As eigenvalues of `MᵀM`
/// they would be squared, and the threshold would be below rounding.
fn mirrors(covariance: &Matrix3<f64>, allow_reflection: bool) -> Result<bool, OrientationError> {
    let mut values: [f64; 3] = covariance.singular_values().into();
    values.sort_by(|a, b| b.total_cmp(a));
    let [first, second, last] = values;
    if second <= COLLINEAR_RTOL * first || first == 0.0 {
        return Err(OrientationError::Degenerate);
    }
    // In a plane a rotation fits as well as its mirror image; the rotation is chosen.
    let planar = last <= COLLINEAR_RTOL * first;
    Ok(allow_reflection && !planar && covariance.determinant() < 0.0)
}

/// The rotation of the unit quaternion `q` with the largest `qᵀ N q` (Horn 1987); if `mirrored`, the negated rotation
/// of `−C`.
fn quaternion_rotation(covariance: &Matrix3<f64>, mirrored: bool) -> Matrix3<f64> {
    // A reflection is a rotation after the inversion of space, so its best one is the best rotation for −C.
    let sign = if mirrored { -1.0 } else { 1.0 };
    // Horn sums source times target; the covariance here is target times source.
    let s = sign * covariance.transpose();
    let [xx, yy, zz] = [s[(0, 0)], s[(1, 1)], s[(2, 2)]];
    let (yz, zx, xy) = (s[(1, 2)] - s[(2, 1)], s[(2, 0)] - s[(0, 2)], s[(0, 1)] - s[(1, 0)]);
    let (sum_xy, sum_zx, sum_yz) = (s[(0, 1)] + s[(1, 0)], s[(2, 0)] + s[(0, 2)], s[(1, 2)] + s[(2, 1)]);
    #[rustfmt::skip]
    let n = Matrix4::new(
        xx + yy + zz, yz,           zx,            xy,
        yz,           xx - yy - zz, sum_xy,        sum_zx,
        zx,           sum_xy,       -xx + yy - zz, sum_yz,
        xy,           sum_zx,       sum_yz,        -xx - yy + zz,
    );
    let eigen = SymmetricEigen::new(n);
    let q = eigen.eigenvectors.column(eigen.eigenvalues.imax());
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]));
    sign * rotation.to_rotation_matrix().into_inner()
}

/// `M (MᵀM)^(−1/2)` by the eigenvectors `vᵢ` of `MᵀM` (Horn, Hilden, Negahdaripour 1988): `R = Σ uᵢ vᵢᵀ` with
/// `uᵢ = M vᵢ / ‖M vᵢ‖`.
///
/// The last `uᵢ` is not computed by division but completes the others to a frame of the wanted sign. The result is the
/// same if `M` has full rank and the wanted sign. It also covers planar pairs, whose `MᵀM` has no inverse, and reverses
/// the weakest direction where the data prefer the other sign.
fn orthonormal_rotation(m: &Matrix3<f64>, mirrored: bool) -> Matrix3<f64> {
    let eigen = SymmetricEigen::new(m.transpose() * m);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let v: [Vector3<f64>; 2] = [0, 1].map(|k| eigen.eigenvectors.column(order[k]).into_owned());
    let first = (m * v[0]).normalize();
    let second = m * v[1];
    // `MᵀM` blurs its smaller eigenvectors by rounding in the largest; the component along the first is removed again.
    let second = (second - first * first.dot(&second)).normalize();
    let third = if mirrored { -first.cross(&second) } else { first.cross(&second) };
    first * v[0].transpose() + second * v[1].transpose() + third * v[0].cross(&v[1]).transpose()
}

#[cfg(test)]
#[path = "orientation_solvers_tests.rs"]
mod tests;
