//! Conversion to RAS of coordinates in LPS (left, posterior, superior), the convention of DICOM, ITK and 3D Slicer.

use super::FormatError;
use super::polygons::MeshFile;
use homolog_contract::input::InputSpace;
use homolog_mesh::SurfaceMesh;
use nalgebra::{Matrix4, Point3, Vector4};

/// Note of a report on a file whose coordinates were converted.
pub(super) const NOTE: &str = "the file has LPS coordinates; they were converted to RAS (x and y change their signs)";

/// Whether free text (title, header or comments) declares LPS in the form of 3D Slicer.
pub(super) fn is_declared(head: &[u8]) -> bool {
    head.windows(9).any(|text| text == b"SPACE=LPS")
}

/// Converts the mesh to RAS, with a note.
///
/// # Errors
/// None for a valid mesh.
pub(super) fn to_ras(file: &mut MeshFile) -> Result<(), FormatError> {
    let mesh = &file.mesh;
    let vertices = mesh.vertices().iter().map(|p| Point3::new(-p.x, -p.y, p.z)).collect();
    file.mesh = SurfaceMesh::new(vertices, mesh.arity(), mesh.indices().to_vec())?;
    file.space = InputSpace::Lps;
    file.notes.push(NOTE.to_owned());
    Ok(())
}

/// An affine to RAS, from an affine to LPS.
pub(super) fn affine_to_ras(affine: &Matrix4<f64>) -> Matrix4<f64> {
    Matrix4::from_diagonal(&Vector4::new(-1.0, -1.0, 1.0, 1.0)) * affine
}
