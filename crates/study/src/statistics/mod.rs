//! Statistics at every vertex: a general linear model with contrasts, permutation tests with threshold-free cluster
//! enhancement, control of errors over all vertices, effect sizes and power, and a mixed model for visits.

pub mod design;
pub mod effect;
pub mod linear;
pub mod mixed;
pub mod multiple;
pub mod paired;
pub mod permutation;
pub mod tfce;

/// A value at each vertex of each subject; the values of one vertex are contiguous.
#[derive(Debug, Clone, PartialEq)]
pub struct VertexValues {
    n: usize,
    values: Vec<f64>,
}

impl VertexValues {
    /// Values given by subject, each with one value per vertex.
    pub fn from_subjects(subjects: &[Vec<f64>]) -> Self {
        let (n, v) = (subjects.len(), subjects.first().map_or(0, Vec::len));
        let values = (0..v).flat_map(|vertex| subjects.iter().map(move |subject| subject[vertex])).collect();
        VertexValues { n, values }
    }

    /// Number of subjects.
    pub fn n_subjects(&self) -> usize {
        self.n
    }

    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.values.len() / self.n.max(1)
    }

    /// The values of all subjects at each vertex.
    pub fn vertices(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.n.max(1))
    }
}
