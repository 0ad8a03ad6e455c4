//! The surfaces of a result as files.

use crate::jobs::Failure;
use crate::mesh::SurfaceMesh;
use nalgebra::{Matrix3, Point3, Vector3};
use std::io::Write;

/// The mesh as binary little-endian PLY with double coordinates, vertices and faces in order.
pub(super) fn write_ply(mesh: &SurfaceMesh) -> Vec<u8> {
    let n_corners = mesh.arity().n_corners();
    let mut out = Vec::with_capacity(256 + 24 * mesh.n_vertices() + (1 + 4 * n_corners) * mesh.n_faces());
    // Writing to memory cannot fail.
    let _ = write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment units mm\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.n_vertices(),
        mesh.n_faces()
    );
    for p in mesh.vertices() {
        for c in p.iter() {
            out.extend_from_slice(&c.to_le_bytes());
        }
    }
    for face in mesh.faces() {
        out.push(n_corners as u8);
        for v in face {
            out.extend_from_slice(&v.to_le_bytes());
        }
    }
    out
}

/// `mesh` moved by the 4×4 matrix of a result, its faces still looking outwards if the matrix reflects.
pub(super) fn moved(mesh: &SurfaceMesh, matrix: &[[f64; 4]; 4]) -> Result<SurfaceMesh, Failure> {
    let linear = Matrix3::from_fn(|r, c| matrix[r][c]);
    let translation = Vector3::from_fn(|r, _| matrix[r][3]);
    let vertices: Vec<Point3<f64>> =
        mesh.vertices().iter().map(|p| Point3::from(linear * p.coords + translation)).collect();
    let mut indices = mesh.indices().to_vec();
    if linear.determinant() < 0.0 {
        indices.chunks_exact_mut(mesh.arity().n_corners()).for_each(<[u32]>::reverse);
    }
    SurfaceMesh::new(vertices, mesh.arity(), indices)
        .map_err(|_| Failure::new("internal-error", "the moved surface has coordinates that are not finite"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::FaceArity;

    fn tetrahedron() -> SurfaceMesh {
        let p = |x, y, z| Point3::new(x, y, z);
        let vertices = vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0), p(0.0, 0.0, 1.0)];
        SurfaceMesh::new(vertices, FaceArity::Triangle, vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]).unwrap()
    }

    #[test]
    fn a_file_has_the_size_its_header_says() {
        let bytes = write_ply(&tetrahedron());
        let header = b"end_header\n";
        let body = bytes.windows(header.len()).position(|w| w == header).unwrap() + header.len();
        assert_eq!(bytes.len() - body, 4 * 24 + 4 * 13);
    }

    #[test]
    fn a_reflection_turns_the_faces() {
        let mirror = [[-1.0, 0.0, 0.0, 5.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let image = moved(&tetrahedron(), &mirror).unwrap();
        assert_eq!(image.vertices()[1], Point3::new(4.0, 0.0, 0.0));
        assert_eq!(&image.indices()[..3], [1, 2, 0]);
    }
}
