//! Scale space of a surface by heat flow of its vertex positions.
//!
//! Source: implicit fairing, Desbrun, Meyer, Schröder, Barr 1999: one implicit step `(A + tL) p_σ = A p`, with the
//! cotangent Laplacian `L` and the vertex areas `A` of the original surface and `t = σ²/2`. The step is solved by
//! sparse Cholesky factorization of a symmetric positive definite matrix.

use super::angle_defect::vertex_areas;
use super::laplacian::cotangent_weights;
use crate::sparse::{CholeskyPattern, Place};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// The heat-flow operator of a surface; smooths it at any scale.
pub struct ScaleSpace<'a> {
    mesh: &'a SurfaceMesh,
    areas: Vec<f64>,
    /// Entries of the lower triangle of `L`; the last `n` are the diagonal.
    laplacian: Vec<f64>,
    /// Pattern of `A + tL`, which is the same at every scale; `None` if the entries are too many to be counted.
    pattern: Option<CholeskyPattern>,
}

/// Why a surface could not be smoothed.
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
            places.push(Place::new(w.i.max(w.j), w.i.min(w.j)));
            laplacian.push(-w.weight);
        }
        laplacian.extend(diagonal);
        // The diagonal occurs twice: for `L` and for the areas.
        places.extend((0..n).chain(0..n).map(|i| Place::new(i, i)));
        // A vertex between faces without area would make the mass matrix singular. A millionth of the mean area keeps
        // the matrix regular and moves no other vertex measurably.
        let mut areas = vertex_areas(mesh);
        let floor = 1e-6 * areas.iter().sum::<f64>() / n as f64;
        for area in &mut areas {
            *area = area.max(floor);
        }
        ScaleSpace { mesh, areas, laplacian, pattern: CholeskyPattern::new(n, &places) }
    }

    /// The surface at scale `scale_mm` (`σ`, mm): same faces, smoothed positions. Scale `0` returns the surface
    /// unchanged.
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
        let entries: Vec<f64> = self.laplacian.iter().map(|l| t * l).chain(self.areas.iter().copied()).collect();
        let factor = self.pattern.as_ref().and_then(|pattern| pattern.factorize(&entries)).ok_or(failed)?;
        // Relative to the centroid, which keeps the precision of a surface far from the origin.
        let center = self.mesh.centroid();
        let v = self.mesh.vertices();
        let smoothed = factor.solve(n, 3, &|i, k| self.areas[i] * (v[i][k] - center[k]));
        let vertices = (0..n).map(|i| Point3::from(std::array::from_fn(|k| smoothed[(i, k)] + center[k]))).collect();
        self.mesh.with_vertices(vertices).map_err(|_| failed)
    }
}
