#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

mod boundary;
mod canonical;
mod closest;
mod distance;
mod elements;
mod geometry;
mod numbering;
pub mod orientation;
pub mod shapes;
pub mod simplify;

pub mod repair;
pub mod topology;
pub mod tunnels;
pub mod volume;

pub use canonical::{CanonicalMesh, canonicalize};
pub use closest::{ClosestPoint, ClosestPointIndex};
pub use distance::SurfaceDistances;
pub use numbering::Numbering;

use homolog_primitives::graph::EdgeGraph;
use nalgebra::{Matrix3, Point3, Vector3};

/// A surface: `n` vertices in millimeters and faces of one arity (3 or 4), counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMesh {
    vertices: Vec<Point3<f64>>,
    arity: FaceArity,
    indices: Vec<u32>,
}

/// Number of corners of every face of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FaceArity {
    /// Triangles.
    Triangle,
    /// Quads, such as the boundary faces of voxels.
    Quad,
}

impl FaceArity {
    /// 3 or 4.
    pub fn n_corners(self) -> usize {
        match self {
            FaceArity::Triangle => 3,
            FaceArity::Quad => 4,
        }
    }
}

/// Why vertices and faces do not form a mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// No vertices or no faces.
    #[error("the mesh has {n_vertices} vertices and {n_faces} faces; both must be positive")]
    Empty {
        /// Vertices found.
        n_vertices: usize,
        /// Faces found.
        n_faces: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NonFinite {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {vertex}, but there are only {n_vertices}")]
    IndexOutOfRange {
        /// Index of the face.
        face: usize,
        /// The vertex index in the face.
        vertex: u64,
        /// Number of vertices of the mesh.
        n_vertices: usize,
    },
    /// A face uses one vertex twice.
    #[error("face {face} uses vertex {vertex} more than once")]
    RepeatedCorner {
        /// Index of the face.
        face: usize,
        /// The repeated vertex.
        vertex: u32,
    },
    /// The number of indices is not a multiple of the number of corners of a face.
    #[error("{n_indices} face indices do not divide into faces of {n_corners} corners")]
    RaggedFaces {
        /// Indices given.
        n_indices: usize,
        /// Corners of a face.
        n_corners: usize,
    },
}

impl SurfaceMesh {
    /// A mesh from vertices (mm) and a flat list of face corners, `arity` indices per face.
    ///
    /// # Errors
    /// [`MeshError`]: empty, a coordinate that is not finite, an index out of range, a face that uses a vertex twice.
    ///
    /// # Cost
    /// `O(vertices + faces)`.
    pub fn new(vertices: Vec<Point3<f64>>, arity: FaceArity, indices: Vec<u32>) -> Result<Self, MeshError> {
        let n_corners = arity.n_corners();
        if !indices.len().is_multiple_of(n_corners) {
            return Err(MeshError::RaggedFaces { n_indices: indices.len(), n_corners });
        }
        if vertices.is_empty() || indices.is_empty() {
            return Err(MeshError::Empty { n_vertices: vertices.len(), n_faces: indices.len() / n_corners });
        }
        if let Some(vertex) = vertices.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
            return Err(MeshError::NonFinite { vertex });
        }
        for (face, corners) in indices.chunks_exact(n_corners).enumerate() {
            for (k, &v) in corners.iter().enumerate() {
                if v as usize >= vertices.len() {
                    return Err(MeshError::IndexOutOfRange { face, vertex: v.into(), n_vertices: vertices.len() });
                }
                if corners[..k].contains(&v) {
                    return Err(MeshError::RepeatedCorner { face, vertex: v });
                }
            }
        }
        Ok(SurfaceMesh { vertices, arity, indices })
    }

    /// Vertex positions, mm.
    pub fn vertices(&self) -> &[Point3<f64>] {
        &self.vertices
    }

    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.vertices.len()
    }

    /// Number of faces.
    pub fn n_faces(&self) -> usize {
        self.indices.len() / self.arity.n_corners()
    }

    /// Corners of every face.
    pub fn arity(&self) -> FaceArity {
        self.arity
    }

    /// All face corners in one list, [`FaceArity::n_corners`] per face.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// The faces, each a slice of 3 or 4 vertex indices.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> + Clone {
        self.indices.chunks_exact(self.arity.n_corners())
    }

    /// Memory of vertices and faces, bytes.
    pub fn heap_bytes(&self) -> usize {
        size_of_val(self.vertices.as_slice()) + size_of_val(self.indices.as_slice())
    }

    /// The same faces with new vertex positions, one per vertex.
    ///
    /// # Errors
    /// [`MeshError::NonFinite`]; [`MeshError::IndexOutOfRange`] if there are fewer positions than vertices.
    pub fn with_vertices(&self, vertices: Vec<Point3<f64>>) -> Result<Self, MeshError> {
        SurfaceMesh::new(vertices, self.arity, self.indices.clone())
    }

    /// The mesh moved by `p' = R p + t`.
    pub fn transformed(&self, motion: &nalgebra::Isometry3<f64>) -> Self {
        let vertices = self.vertices.iter().map(|p| motion * p).collect();
        SurfaceMesh { vertices, arity: self.arity, indices: self.indices.clone() }
    }

    /// The mesh moved by a 4×4 matrix, row by row, whose last row is `0 0 0 1`. A reflection
    /// also reverses the faces, so that they keep facing outwards.
    ///
    /// # Errors
    /// [`MeshError::NonFinite`].
    pub fn moved(&self, matrix: &[[f64; 4]; 4]) -> Result<Self, MeshError> {
        let linear = Matrix3::from_fn(|r, c| matrix[r][c]);
        let translation = Vector3::from_fn(|r, _| matrix[r][3]);
        let vertices = self.vertices.iter().map(|p| Point3::from(linear * p.coords + translation)).collect();
        let mut indices = self.indices.clone();
        if linear.determinant() < 0.0 {
            indices.chunks_exact_mut(self.arity.n_corners()).for_each(<[u32]>::reverse);
        }
        SurfaceMesh::new(vertices, self.arity, indices)
    }

    /// The faces as triangles; every quad is split along its first diagonal.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        match self.arity {
            FaceArity::Triangle => self.faces().map(|f| [f[0], f[1], f[2]]).collect(),
            FaceArity::Quad => self.faces().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect(),
        }
    }

    /// The edge graph; a quad mesh keeps its 4-neighborhoods. Costs as much as [`SurfaceMesh::edges`].
    pub fn edge_graph(&self) -> EdgeGraph {
        EdgeGraph::from_edges(self.n_vertices(), &self.edges())
    }

    /// Every undirected edge once, as `[low, high]`, in ascending order. Cost `O(faces)` if few faces meet at each
    /// vertex.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let sides = || self.faces().flat_map(|f| (0..f.len()).map(move |k| (f[k], f[(k + 1) % f.len()])));
        // Edges are grouped by their lower vertex, so that only a few need sorting at a time.
        let mut ends = vec![0u32; self.n_vertices() + 1];
        for (a, b) in sides() {
            ends[a.min(b) as usize + 1] += 1;
        }
        for low in 0..self.n_vertices() {
            ends[low + 1] += ends[low];
        }
        let mut highs = vec![0u32; self.indices.len()];
        // While the rows are filled, the row of `low` ends at `ends[low]`; when all are full, the next row begins
        // there.
        for (a, b) in sides() {
            let end = &mut ends[a.min(b) as usize];
            highs[*end as usize] = a.max(b);
            *end += 1;
        }
        let mut edges = Vec::with_capacity(self.indices.len() / 2 + 1);
        let mut start = 0;
        for low in 0..self.n_vertices() {
            let row = &mut highs[start..ends[low] as usize];
            row.sort_unstable();
            for (k, &high) in row.iter().enumerate() {
                if k == 0 || row[k - 1] != high {
                    edges.push([low as u32, high]);
                }
            }
            start = ends[low] as usize;
        }
        edges
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_the_sides_of_the_faces_each_once_ascending() {
        let torus = |arity| shapes::torus(5.0, 2.0, 9, 7, arity);
        let mut meshes = vec![shapes::ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3)];
        meshes.extend([FaceArity::Triangle, FaceArity::Quad].map(torus));
        // A rim, an edge of three faces, and vertices that no face uses.
        let v = (0..8).map(|k| Point3::new(f64::from(k), f64::from(k * k), 0.0)).collect();
        meshes.push(SurfaceMesh::new(v, FaceArity::Triangle, vec![5, 1, 2, 2, 1, 6, 4, 1, 2]).unwrap());
        for mesh in meshes {
            let sides = mesh.faces().flat_map(|f| (0..f.len()).map(move |k| (f[k], f[(k + 1) % f.len()])));
            let set: std::collections::BTreeSet<[u32; 2]> = sides.map(|(a, b)| [a.min(b), a.max(b)]).collect();
            assert_eq!(mesh.edges(), set.into_iter().collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_reflection_reverses_the_faces() {
        let ball = shapes::ellipsoid(Vector3::new(3.0, 2.0, 1.0), 2);
        let mirror = [[-1.0, 0.0, 0.0, 5.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let image = ball.moved(&mirror).unwrap();
        assert_eq!(image.vertices()[1].x, 5.0 - ball.vertices()[1].x);
        assert!((image.signed_volume() - ball.signed_volume()).abs() < 1e-9 && ball.signed_volume() > 0.0);
    }

    #[test]
    fn invalid_meshes_are_rejected_with_their_fault() {
        let p = |x: f64| Point3::new(x, 0.0, 1.0);
        let new = |vertices, indices| SurfaceMesh::new(vertices, FaceArity::Triangle, indices).unwrap_err();
        assert_eq!(new(vec![], vec![]), MeshError::Empty { n_vertices: 0, n_faces: 0 });
        assert_eq!(new(vec![p(0.0), p(f64::NAN), p(1.0)], vec![0, 1, 2]), MeshError::NonFinite { vertex: 1 });
        let out = MeshError::IndexOutOfRange { face: 0, vertex: 7, n_vertices: 3 };
        assert_eq!(new(vec![p(0.0), p(2.0), p(1.0)], vec![0, 1, 7]), out);
        assert_eq!(new(vec![p(0.0), p(2.0), p(1.0)], vec![0, 1, 1]), MeshError::RepeatedCorner { face: 0, vertex: 1 });
        assert_eq!(new(vec![p(0.0)], vec![0, 1]), MeshError::RaggedFaces { n_indices: 2, n_corners: 3 });
    }
}
