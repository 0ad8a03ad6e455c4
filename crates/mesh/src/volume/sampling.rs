//! The uncertainty that voxel size leaves in a surface made of voxels, and in its orientation.
//!
//! A voxel records whether its center is inside, so the boundary lies anywhere between two centers. Along a normal `n`
//! its position has the variance of a point anywhere in a voxel, `Σ (hₐ·n)² / 12` over the three edge vectors `hₐ` of a
//! voxel. Positions about a voxel's width apart are independent. One position represents an area equal to the volume of
//! a voxel divided by its width along the normal, `|det h| / Σ |hₐ·n|`.
//!
//! An orientation is estimated from these positions. A rotation by `ω` and a translation by `t` change the position of
//! a point `p` along its normal by `ω·(p × n) + t·n`. The normal equations of fitting a plane to each point (Chen,
//! Medioni 1992) with these variances therefore give the least covariance that any estimate of `ω` and `t` from these
//! voxels can have.

use crate::SurfaceMesh;
use nalgebra::{Matrix3, Matrix4, Matrix6, Vector3, Vector6};

/// Uncertainty of a surface due to voxel size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Standard deviation of the position of the surface along its normal, root mean square over the area, mm.
    pub noise_mm: f64,
    /// Standard deviation of the least certain rotation, rad; infinite if the surface does not determine the rotation
    /// about some axis.
    pub rotation_rad: f64,
}

impl Sampling {
    /// The uncertainty of a surface made of voxels with `affine` from voxel index to mm. Cost `O(faces)`.
    pub fn of(mesh: &SurfaceMesh, affine: &Matrix4<f64>) -> Self {
        let edges: [Vector3<f64>; 3] = [0, 1, 2].map(|k| affine.fixed_view::<3, 1>(0, k).into_owned());
        let volume = edges[0].cross(&edges[1]).dot(&edges[2]).abs();
        let points = mesh.vertices();
        let triangles: Vec<(Vector3<f64>, Vector3<f64>)> = mesh
            .triangles()
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|v| points[v as usize].coords);
                ((a + b + c) / 3.0, (b - a).cross(&(c - a)) / 2.0)
            })
            .collect();
        let area: f64 = triangles.iter().map(|(_, a)| a.norm()).sum();
        let center = triangles.iter().map(|(p, a)| p * a.norm()).sum::<Vector3<f64>>() / area;
        // In units of the size of the surface, which gives rotations and translations the same order of magnitude.
        let size = area.sqrt();
        let mut information = Matrix6::zeros();
        let mut variances = 0.0;
        for (point, vector) in &triangles {
            let Some(normal) = vector.try_normalize(0.0) else { continue };
            let widths = edges.map(|edge| edge.dot(&normal).abs());
            let variance = widths.iter().map(|w| w * w).sum::<f64>() / 12.0;
            let independent_area = volume / widths.iter().sum::<f64>();
            let arm = (point - center).cross(&normal) / size;
            let row = Vector6::new(arm.x, arm.y, arm.z, normal.x, normal.y, normal.z);
            information += row * row.transpose() * (vector.norm() / (independent_area * variance));
            variances += variance * vector.norm();
        }
        Sampling { noise_mm: (variances / area).sqrt(), rotation_rad: rotation_rad(&information, size) }
    }
}

/// The largest standard deviation of a rotation, given the information on rotations (times `size`) and translations.
fn rotation_rad(information: &Matrix6<f64>, size: f64) -> f64 {
    let block =
        |row: usize, column: usize| -> Matrix3<f64> { information.fixed_view::<3, 3>(row, column).into_owned() };
    let Some(of_translation) = block(3, 3).try_inverse() else { return f64::INFINITY };
    // The information on rotations when the translation is unknown too.
    let of_rotation = block(0, 0) - block(0, 3) * of_translation * block(3, 0);
    let least = of_rotation.symmetric_eigenvalues().min();
    if least > 0.0 { 1.0 / (least.sqrt() * size) } else { f64::INFINITY }
}

#[cfg(test)]
#[path = "sampling_tests.rs"]
mod tests;
