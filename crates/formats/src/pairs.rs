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
    /// Spread of the belief on the target, mm.
    pub spread_mm: &'a [f64],
    /// Why it is an outlier: 0 it is none, 1 its residual, 2 its neighbourhood, 3 both, 4 it has no counterpart.
    pub outlier: &'a [u8],
    /// The target triangle on which the image lies, by its vertices.
    pub triangle: &'a [[u32; 3]],
    /// Where on it: the weights of its vertices, of sum 1.
    pub barycentric: &'a [[f64; 3]],
}

/// One row of [`PairColumns`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PairRow {
    pub source: u32,
    pub target: u32,
    pub confidence: f64,
    pub inlier: bool,
    pub spread_mm: f64,
    pub outlier: u8,
    pub triangle: [u32; 3],
    pub barycentric: [f64; 3],
}

impl PairColumns<'_> {
    /// Number of pairs: that of the shortest column.
    pub fn len(&self) -> usize {
        let vertices = self.source.len().min(self.target.len());
        let values = self.confidence.len().min(self.inlier.len()).min(self.spread_mm.len()).min(self.outlier.len());
        vertices.min(values).min(self.triangle.len()).min(self.barycentric.len())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The pairs one by one.
    pub(super) fn rows(&self) -> impl Iterator<Item = PairRow> {
        (0..self.len()).map(|k| PairRow {
            source: self.source[k],
            target: self.target[k],
            confidence: self.confidence[k],
            inlier: self.inlier[k],
            spread_mm: self.spread_mm[k],
            outlier: self.outlier[k],
            triangle: self.triangle[k],
            barycentric: self.barycentric[k],
        })
    }
}
