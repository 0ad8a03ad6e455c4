//! Mirroring of a subject of the other side than the template, in `x = 0`.

use homolog_mesh::{MeshError, SurfaceMesh};
use nalgebra::{Matrix3, Point3};

const IN_X: [[f64; 4]; 4] = [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The linear part of the reflection in `x = 0`.
pub(crate) fn linear() -> Matrix3<f64> {
    Matrix3::from_fn(|r, c| IN_X[r][c])
}

/// The mirror image in `x = 0`, with faces that still look outwards.
///
/// # Errors
/// Errors of [`SurfaceMesh::moved`].
pub(crate) fn mirrored(mesh: &SurfaceMesh) -> Result<SurfaceMesh, MeshError> {
    mesh.moved(&IN_X)
}

/// Points of a record in the coordinates of the subject's file.
pub(crate) fn in_file(points: Vec<Point3<f64>>, is_mirrored: bool) -> Vec<Point3<f64>> {
    if is_mirrored { points.into_iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect() } else { points }
}

/// The template with the points of a record, in the coordinates of the subject's file.
///
/// # Errors
/// Errors of [`SurfaceMesh::with_vertices`].
pub(crate) fn deformed_template(
    template: &SurfaceMesh,
    points: Vec<Point3<f64>>,
    is_mirrored: bool,
) -> Result<SurfaceMesh, MeshError> {
    let deformed = template.with_vertices(points)?;
    if is_mirrored { mirrored(&deformed) } else { Ok(deformed) }
}
