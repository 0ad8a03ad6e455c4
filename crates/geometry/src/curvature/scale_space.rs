//! Scale space of a surface by heat flow of its vertex positions.
//!
//! Source: implicit fairing, Desbrun, Meyer, Schröder, Barr 1999: one implicit step `(A + tL) p_σ = A p`, with the
//! cotangent Laplacian `L` and the vertex areas `A` of the original surface and `t = σ²/2`. The step is solved by
//! sparse Cholesky factorization of a symmetric positive definite matrix.

use super::angle_defect::vertex_areas;
use super::laplacian::cotangent_weights;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{Argsort, Pair, SparseColMat, SymbolicSparseColMat};
use faer::{Mat, Side};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// The heat-flow operator of one surface, from which smoothed copies at any scale are made.
pub struct ScaleSpace<'a> {
    mesh: &'a SurfaceMesh,
    areas: Vec<f64>,
    /// Lower-triangle entries of `L`, diagonal included, which is the last `n`.
    laplacian: Vec<f64>,
    /// `None` where there are more entries than can be counted.
    pattern: Option<Pattern>,
}

/// Where the entries of `A + tL` stand, which is the same at every scale, and in which order its rows are eliminated.
struct Pattern {
    places: SymbolicSparseColMat<usize>,
    /// From the entries of `L` and then those of `A` to the places.
    order: Argsort<usize>,
    factor: SymbolicLlt<usize>,
}

impl Pattern {
    fn new(entries: &[Pair<usize, usize>], n: usize) -> Option<Self> {
        let (places, order) = SymbolicSparseColMat::try_new_from_indices(n, n, entries).ok()?;
        let factor = SymbolicLlt::try_new(places.as_ref(), Side::Lower).ok()?;
        Some(Pattern { places, order, factor })
    }
}

/// Why a smoothed surface could not be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ScaleSpaceError {
    /// The linear system could not be factorized, because of degenerate faces.
    #[error("the heat-flow system at scale {scale_mm} mm is not positive definite")]
    NotPositiveDefinite {
        /// Scale, mm.
        scale_mm: f64,
    },
}

impl<'a> ScaleSpace<'a> {
    /// Prepares the operator of `mesh` and the elimination order of its factorizations. Cost `O(faces log faces)`.
    pub fn new(mesh: &'a SurfaceMesh) -> Self {
        let n = mesh.n_vertices();
        let mut places = Vec::with_capacity(2 * mesh.indices().len() + 2 * n);
        let mut laplacian = Vec::with_capacity(2 * mesh.indices().len() + n);
        let mut diagonal = vec![0.0; n];
        for w in cotangent_weights(mesh) {
            diagonal[w.i] += w.weight;
            diagonal[w.j] += w.weight;
            places.push(Pair::new(w.i.max(w.j), w.i.min(w.j)));
            laplacian.push(-w.weight);
        }
        laplacian.extend(diagonal);
        // Once for the diagonal of `L`, once for the areas.
        places.extend((0..n).chain(0..n).map(|i| Pair::new(i, i)));
        // A vertex between faces without area would make the mass matrix singular; a millionth of the mean keeps
        // it solvable and does not move any other vertex measurably.
        let mut areas = vertex_areas(mesh);
        let floor = 1e-6 * areas.iter().sum::<f64>() / n as f64;
        for area in &mut areas {
            *area = area.max(floor);
        }
        ScaleSpace { mesh, areas, laplacian, pattern: Pattern::new(&places, n) }
    }

    /// The surface at scale `scale_mm` (`σ`, mm): same faces, smoothed positions. `0` gives the surface itself.
    ///
    /// # Errors
    /// [`ScaleSpaceError::NotPositiveDefinite`].
    ///
    /// # Cost
    /// One numeric sparse Cholesky factorization, about `O(n^1.5)` on surfaces; on one thread.
    pub fn smoothed(&self, scale_mm: f64) -> Result<SurfaceMesh, ScaleSpaceError> {
        if scale_mm == 0.0 {
            return Ok(self.mesh.clone());
        }
        let failed = ScaleSpaceError::NotPositiveDefinite { scale_mm };
        let n = self.mesh.n_vertices();
        let t = scale_mm * scale_mm / 2.0;
        let Pattern { places, order, factor } = self.pattern.as_ref().ok_or(failed)?;
        let entries: Vec<f64> = self.laplacian.iter().map(|l| t * l).chain(self.areas.iter().copied()).collect();
        let matrix = SparseColMat::new_from_argsort(places.clone(), order, &entries).map_err(|_| failed)?;
        let factor = Llt::try_new_with_symbolic(factor.clone(), matrix.as_ref(), Side::Lower).map_err(|_| failed)?;
        // About the centroid, so that a surface far from the origin loses no digits.
        let center = self.mesh.centroid();
        let v = self.mesh.vertices();
        let right_side = Mat::from_fn(n, 3, |i, k| self.areas[i] * (v[i][k] - center[k]));
        let smoothed = factor.solve(&right_side);
        let vertices = (0..n).map(|i| Point3::from(std::array::from_fn(|k| smoothed[(i, k)] + center[k]))).collect();
        self.mesh.with_vertices(vertices).map_err(|_| failed)
    }
}
