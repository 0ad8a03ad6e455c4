//! Pairs of vertices in columns, as tables hold them.

/// A correspondence in columns of equal length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairColumns<'a> {
    /// Source vertex.
    pub source: &'a [u32],
    /// Its target vertex.
    pub target: &'a [u32],
    /// Belief in it, in `[0, 1]`.
    pub confidence: &'a [f64],
    /// Whether it supports the transform.
    pub inlier: &'a [bool],
}

impl PairColumns<'_> {
    /// Number of pairs: that of the shortest column.
    pub fn len(&self) -> usize {
        self.source.len().min(self.target.len()).min(self.confidence.len()).min(self.inlier.len())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The pairs one by one.
    pub(super) fn rows(&self) -> impl Iterator<Item = (u32, u32, f64, bool)> {
        let vertices = self.source.iter().zip(self.target);
        let values = self.confidence.iter().zip(self.inlier);
        vertices.zip(values).map(|((&source, &target), (&confidence, &inlier))| (source, target, confidence, inlier))
    }
}
