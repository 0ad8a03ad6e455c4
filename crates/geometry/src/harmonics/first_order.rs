//! The first-order ellipsoid: the spherical harmonics of degree 0 and 1 of a surface.

use super::sphere::{spherical_area, vertex_shares};
use super::{HarmonicsError, Parametrization};
use homolog_mesh::SurfaceMesh;
use nalgebra::{Matrix3, Matrix4, Matrix4x3, Point3, Vector3, Vector4};
use std::f64::consts::PI;

/// Ellipsoids whose shortest half axis is below this share of the longest count as flat.
const FLAT_RTOL: f64 = 1e-6;

/// `p(n) = center + A n` for unit vectors `n` of the parameter sphere, with the singular value decomposition of `A`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstOrderEllipsoid {
    /// The coefficient of degree 0 as a point, mm: the mean of the surface over the sphere.
    pub center: Point3<f64>,
    /// Least-squares coefficients, mm, of the real spherical harmonics `Y₀⁰, Y₁⁻¹, Y₁⁰, Y₁¹` (orthonormal on the
    /// sphere), a row each, for x, y and z.
    pub coefficients_mm: [[f64; 3]; 4],
    /// Singular values of `A`, mm, longest first.
    pub half_axes_mm: [f64; 3],
    /// Directions of the half axes in space, as columns in the same order; `det = +1`. The signs of any two are
    /// arbitrary.
    pub axes: Matrix3<f64>,
    /// The unit vectors of the parameter sphere that map to the half axes, as columns: `A = axes · diag(half axes) ·
    /// thisᵀ`.
    pub parameter_axes: Matrix3<f64>,
}

impl FirstOrderEllipsoid {
    /// First over second half axis and second over third, each `≥ 1`; if one is near 1, the rotation about the
    /// remaining axis is ambiguous.
    pub fn axis_ratios(&self) -> [f64; 2] {
        let [a, b, c] = self.half_axes_mm;
        [a / b, b / c]
    }

    /// `A`, mm.
    pub fn matrix(&self) -> Matrix3<f64> {
        self.axes * Matrix3::from_diagonal(&Vector3::from(self.half_axes_mm)) * self.parameter_axes.transpose()
    }
}

/// Fits `Y₀⁰, Y₁⁻¹, Y₁⁰, Y₁¹` to the vertices of `mesh` at their positions on the sphere.
///
/// Vertices are weighted by their areas on the sphere. The sums then approximate integrals over the sphere, where the
/// harmonics are orthonormal, and the coefficients do not depend on the density of the mesh.
///
/// # Errors
/// [`HarmonicsError::Flat`].
///
/// # Cost
/// `O(n)`.
pub fn first_order_ellipsoid(
    mesh: &SurfaceMesh,
    parametrization: &Parametrization,
) -> Result<FirstOrderEllipsoid, HarmonicsError> {
    let directions = &parametrization.directions;
    let triangles: Vec<[usize; 3]> = mesh.triangles().iter().map(|t| t.map(|k| k as usize)).collect();
    let areas: Vec<f64> = triangles.iter().map(|t| spherical_area(t.map(|k| directions[k]))).collect();
    let weights = vertex_shares(&triangles, &areas, mesh.n_vertices());
    // Relative to the centroid, which keeps the precision of a surface far from the origin.
    let origin = mesh.centroid();
    let (mut normal_matrix, mut right_side) = (Matrix4::<f64>::zeros(), Matrix4x3::<f64>::zeros());
    for ((p, n), &w) in mesh.vertices().iter().zip(directions).zip(&weights) {
        let basis = harmonics(n);
        normal_matrix += w * basis * basis.transpose();
        right_side += w * basis * (p - origin).transpose();
    }
    // For directions that cover the sphere the matrix is nearly the identity.
    let Some(factor) = normal_matrix.cholesky() else {
        return Err(HarmonicsError::Flat { half_axes_mm: [0.0; 3] });
    };
    let fitted = factor.solve(&right_side);
    let linear = (3.0 / (4.0 * PI)).sqrt();
    // Y₁⁻¹, Y₁⁰ and Y₁¹ are proportional to y, z and x.
    let a = linear * Matrix3::from_columns(&[3, 1, 2].map(|row| fitted.row(row).transpose()));
    let center = origin + fitted.row(0).transpose() / (4.0 * PI).sqrt();
    let svd = a.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else {
        return Err(HarmonicsError::Flat { half_axes_mm: svd.singular_values.into() });
    };
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
    let half_axes_mm = order.map(|k| svd.singular_values[k]);
    if half_axes_mm[2] <= FLAT_RTOL * half_axes_mm[0] {
        return Err(HarmonicsError::Flat { half_axes_mm });
    }
    let mut axes = Matrix3::from_columns(&order.map(|k| u.column(k).into_owned()));
    let mut parameter_axes = Matrix3::from_columns(&order.map(|k| v_t.row(k).transpose()));
    if axes.determinant() < 0.0 {
        axes.set_column(2, &-axes.column(2));
        parameter_axes.set_column(2, &-parameter_axes.column(2));
    }
    let row = |k: usize| {
        let shift = if k == 0 { origin.coords * (4.0 * PI).sqrt() } else { Vector3::zeros() };
        (fitted.row(k).transpose() + shift).into()
    };
    Ok(FirstOrderEllipsoid { center, coefficients_mm: [0, 1, 2, 3].map(row), half_axes_mm, axes, parameter_axes })
}

/// `Y₀⁰, Y₁⁻¹, Y₁⁰, Y₁¹` at the unit vector `n`.
fn harmonics(n: &Vector3<f64>) -> Vector4<f64> {
    let (constant, linear) = ((1.0 / (4.0 * PI)).sqrt(), (3.0 / (4.0 * PI)).sqrt());
    Vector4::new(constant, linear * n.y, linear * n.z, linear * n.x)
}
