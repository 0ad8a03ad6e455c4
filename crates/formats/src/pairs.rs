//! Corresponding vertices as columns of a table.

/// Correspondences as columns of equal length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairColumns<'a> {
    /// Source vertex.
    pub source: &'a [u32],
    /// The corresponding target vertex.
    pub target: &'a [u32],
    /// Confidence, in `[0, 1]`.
    pub confidence: &'a [f64],
    /// Whether the pair is an inlier of the transform.
    pub inlier: &'a [bool],
    /// Spread of the belief on the target, mm.
    pub spread_mm: &'a [f64],
    /// Outlier reason: 0 not an outlier, 1 residual, 2 neighborhood, 3 both, 4 no counterpart.
    pub outlier: &'a [u8],
    /// The vertices of the target triangle that contains the corresponding point.
    pub triangle: &'a [[u32; 3]],
    /// Barycentric coordinates of the corresponding point in that triangle; they sum to 1.
    pub barycentric: &'a [[f64; 3]],
}

/// One row of [`PairColumns`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PairRow {
    pub(super) source: u32,
    pub(super) target: u32,
    pub(super) confidence: f64,
    pub(super) inlier: bool,
    pub(super) spread_mm: f64,
    pub(super) outlier: u8,
    pub(super) triangle: [u32; 3],
    pub(super) barycentric: [f64; 3],
}

impl PairColumns<'_> {
    /// Number of pairs: the length of the shortest column.
    pub fn len(&self) -> usize {
        let vertices = self.source.len().min(self.target.len());
        let values = self.confidence.len().min(self.inlier.len()).min(self.spread_mm.len()).min(self.outlier.len());
        vertices.min(values).min(self.triangle.len()).min(self.barycentric.len())
    }

    /// Whether there are no pairs.
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
