//! Maps each vertex of a derived surface to its vertex in the uploaded mesh.
//!
//! The vertices of a surface are numbered three times on the way from the file to the answer:
//!
//! - **uploaded**: as in the file;
//! - **prepared**: after the repairs ([`super::repair`]), which drop and merge vertices but keep their order;
//! - **canonical**: by position ([`super::canonicalize`]), the numbering in which matches are computed.
//!
//! Each step yields a [`Numbering`] back to the previous step, and [`Numbering::over`] chains them. Every vertex that
//! is named to a user goes through the chained numbering, once, where the answer leaves canonical numbering.
//!
//! No vertex maps to a vertex that repairs drop because no face uses it, because it belongs to a dropped piece, or
//! because it was merged into another: the first of the merged vertices stands for all of them. For a label volume,
//! "uploaded" is the surface made from it. STL files have no shared vertices; their vertices are numbered in the order
//! in which the file first names them.

use super::{MeshError, SurfaceMesh};
use nalgebra::Point3;

/// For every vertex of a surface, its vertex in the mesh from which the surface was made. No two vertices share an
/// original.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Numbering {
    original: Vec<u32>,
}

impl Numbering {
    /// The numbering of a surface of `n_vertices` that is its own original.
    pub fn identity(n_vertices: usize) -> Self {
        Numbering { original: (0..n_vertices as u32).collect() }
    }

    /// Vertex `v` of the surface is vertex `original[v]` of the mesh that it was made from; no value occurs twice.
    pub(crate) fn new(original: Vec<u32>) -> Self {
        Numbering { original }
    }

    /// Vertices of the surface.
    pub fn n_vertices(&self) -> usize {
        self.original.len()
    }

    /// The original of `vertex`.
    ///
    /// # Panics
    /// If the surface has no such vertex.
    pub fn original(&self, vertex: u32) -> u32 {
        self.original[vertex as usize]
    }

    /// The originals of all vertices, in the order of the surface's vertices.
    pub fn originals(&self) -> &[u32] {
        &self.original
    }

    /// The vertices of the surface with their originals, `(original, vertex)`, by ascending original: the order of rows
    /// in an answer. Cost `O(n log n)`.
    pub fn by_original(&self) -> Vec<(u32, usize)> {
        let mut rows: Vec<(u32, usize)> = self.original.iter().copied().zip(0..).collect();
        rows.sort_unstable();
        rows
    }

    /// Chains this numbering with `earlier`, the numbering of the mesh from which the surface was made. The originals
    /// of the result are the originals of `earlier`.
    ///
    /// # Panics
    /// If an original here is not a vertex of `earlier`.
    pub fn over(&self, earlier: &Numbering) -> Numbering {
        earlier.select(&self.original)
    }

    /// The numbering of a surface whose vertex `k` is vertex `vertices[k]` of this one.
    ///
    /// # Panics
    /// If this surface has no such vertex.
    pub fn select(&self, vertices: &[u32]) -> Numbering {
        Numbering { original: vertices.iter().map(|&v| self.original(v)).collect() }
    }

    /// The faces of `surface`, which has this numbering, over all vertices of the original mesh, including unused ones.
    ///
    /// # Errors
    /// [`MeshError`] if `original_vertices` do not belong to the original mesh.
    pub fn restored(&self, surface: &SurfaceMesh, original_vertices: &[Point3<f64>]) -> Result<SurfaceMesh, MeshError> {
        let indices = surface.indices().iter().map(|&v| self.original(v)).collect();
        SurfaceMesh::new(original_vertices.to_vec(), surface.arity(), indices)
    }

    /// Heap memory, bytes.
    pub fn heap_bytes(&self) -> usize {
        size_of_val(self.original.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::repair::{drop_unused, weld};
    use crate::{FaceArity, canonicalize};

    /// A tetrahedron whose vertices 3 and 5 are one corner, behind two vertices that no face uses.
    fn uploaded() -> SurfaceMesh {
        let places = [[9.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0; 3], [0.0, 1.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]];
        let faces = vec![3, 4, 2, 5, 2, 6, 3, 6, 4, 2, 4, 6];
        SurfaceMesh::new(places.map(Point3::from).to_vec(), FaceArity::Triangle, faces).unwrap()
    }

    #[test]
    fn chained_steps_lead_back_to_the_first_of_the_merged_vertices_of_the_upload() {
        let uploaded = uploaded();
        let used = drop_unused(&uploaded);
        let welded = weld(&used.mesh).unwrap();
        let prepared = welded.numbering.over(&used.numbering);
        assert_eq!(prepared.originals(), [2, 3, 4, 6]);
        let canonical = canonicalize(&welded.mesh);
        let numbering = canonical.numbering.over(&prepared);
        for (v, p) in canonical.mesh.vertices().iter().enumerate() {
            assert_eq!(&uploaded.vertices()[numbering.original(v as u32) as usize], p);
        }
        let rows = numbering.by_original();
        assert_eq!(rows.iter().map(|r| r.0).collect::<Vec<_>>(), [2, 3, 4, 6]);
        assert!(rows.iter().all(|&(original, v)| numbering.original(v as u32) == original));
    }

    #[test]
    fn restored_faces_stand_over_all_uploaded_vertices() {
        let uploaded = uploaded();
        let used = drop_unused(&uploaded);
        let welded = weld(&used.mesh).unwrap();
        let restored = welded.numbering.over(&used.numbering).restored(&welded.mesh, uploaded.vertices()).unwrap();
        assert_eq!(restored.vertices(), uploaded.vertices());
        assert_eq!(restored.indices(), [3, 4, 2, 3, 2, 6, 3, 6, 4, 2, 4, 6]);
    }

    #[test]
    fn the_identity_changes_no_numbering() {
        let canonical = canonicalize(&uploaded()).numbering;
        let identity = Numbering::identity(canonical.n_vertices());
        assert_eq!(canonical.over(&identity), canonical);
        assert_eq!(identity.over(&canonical), canonical);
        assert_eq!(identity.select(&[4, 0]).originals(), [4, 0]);
    }
}
