//! Per-vertex arrays that are written to the same file as the mesh.

use homolog_mesh::SurfaceMesh;

/// A named array with one value for each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct VertexArray {
    /// One word of ASCII letters, digits and `_`, valid as a name in every format.
    pub name: &'static str,
    /// Its values.
    pub values: VertexValues,
}

/// The values of a [`VertexArray`], in types that every format supports.
#[derive(Debug, Clone, PartialEq)]
pub enum VertexValues {
    /// Whole numbers.
    Int(Vec<i32>),
    /// Real numbers.
    Real(Vec<f64>),
    /// Small whole numbers; 0 and 1 for false and true.
    Byte(Vec<u8>),
}

impl VertexValues {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            VertexValues::Int(v) => v.len(),
            VertexValues::Real(v) => v.len(),
            VertexValues::Byte(v) => v.len(),
        }
    }

    /// Whether there are no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The arrays with one value per vertex of the mesh. An array of another length would shift all later data in a binary
/// file.
pub(super) fn fitting<'a>(mesh: &SurfaceMesh, arrays: &'a [VertexArray]) -> impl Iterator<Item = &'a VertexArray> {
    let n_vertices = mesh.n_vertices();
    debug_assert!(arrays.iter().all(|a| a.values.len() == n_vertices), "an array needs a value for each vertex");
    arrays.iter().filter(move |array| array.values.len() == n_vertices)
}
