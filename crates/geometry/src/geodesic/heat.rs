//! Geodesic distance from a vertex to all others by the heat method.
//!
//! Source: Crane, Weischedel, Wardetzky, "Geodesics in heat", ACM TOG 32(5), 2013. Heat flows from the source for a
//! short time `t`; its gradient points along shortest paths; the distance is the function whose gradient comes closest
//! to the unit field of the opposite directions. A quad counts as the mean of its two triangulations, as in the
//! Laplacian.

use crate::curvature::{Weight, both_triangulations, cotangent_weights, vertex_areas};
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::Llt;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use homolog_mesh::{FaceArity, SurfaceMesh};

/// The heat method on one surface: two factorized systems, shared by all sources.
pub struct HeatGeodesics<'a> {
    mesh: &'a SurfaceMesh,
    flow: Llt<usize, f64>,
    poisson: Llt<usize, f64>,
}

/// Why distances could not be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum GeodesicError {
    /// The source is no vertex of the surface.
    #[error("vertex {vertex} is no vertex of a surface of {n_vertices}")]
    NoSuchVertex {
        /// Asked for.
        vertex: usize,
        /// Vertices there are.
        n_vertices: usize,
    },
    /// Some vertex cannot be reached from another.
    #[error("vertex {vertex} is not connected with vertex 0")]
    Disconnected {
        /// The first vertex that cannot be reached from vertex 0.
        vertex: usize,
    },
    /// A linear system could not be factorized, because of degenerate faces.
    #[error("the heat-flow systems of the surface are not positive definite")]
    NotPositiveDefinite,
}

impl<'a> HeatGeodesics<'a> {
    /// Factorizes the systems of `mesh`, with `t` the square of the mean edge length, as the source recommends.
    ///
    /// # Errors
    /// [`GeodesicError::Disconnected`]; [`GeodesicError::NotPositiveDefinite`].
    ///
    /// # Cost
    /// Two sparse Cholesky factorizations, about `O(n^1.5)` on surfaces; one thread, so the same bits everywhere.
    pub fn new(mesh: &'a SurfaceMesh) -> Result<Self, GeodesicError> {
        check_connected(mesh)?;
        let n = mesh.n_vertices();
        let weights = cotangent_weights(mesh);
        let mut diagonal = vec![0.0; n];
        for Weight { i, j, weight } in &weights {
            diagonal[*i] += weight;
            diagonal[*j] += weight;
        }
        let mean_edge = mesh.mean_edge_length();
        let time = mean_edge * mean_edge;
        // `factor · L` plus `extra` on the diagonal.
        let factorized = |factor: f64, extra: &dyn Fn(usize) -> f64| {
            let entries: Vec<_> = weights
                .iter()
                .map(|w| Triplet::new(w.i.max(w.j), w.i.min(w.j), -factor * w.weight))
                .chain((0..n).map(|i| Triplet::new(i, i, factor * diagonal[i] + extra(i))))
                .collect();
            let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(n, n, &entries).ok()?;
            matrix.sp_cholesky(Side::Lower).ok()
        };
        let areas = vertex_areas(mesh);
        let flow = factorized(time, &|i| areas[i]).ok_or(GeodesicError::NotPositiveDefinite)?;
        // Constants are the kernel of `L`. A weight on one vertex removes them and changes nothing else: the right
        // sides sum to zero, so that vertex gets the value zero. Cotangents have no unit, so one is a fair weight.
        let poisson = factorized(1.0, &|i| if i == 0 { 1.0 } else { 0.0 });
        Ok(HeatGeodesics { mesh, flow, poisson: poisson.ok_or(GeodesicError::NotPositiveDefinite)? })
    }

    /// Distance of every vertex from `source`, mm; 0 at `source`.
    ///
    /// # Errors
    /// [`GeodesicError::NoSuchVertex`].
    ///
    /// # Cost
    /// Two solves by substitution, about `O(n log n)`.
    pub fn distances_from(&self, source: usize) -> Result<Vec<f64>, GeodesicError> {
        let n = self.mesh.n_vertices();
        if source >= n {
            return Err(GeodesicError::NoSuchVertex { vertex: source, n_vertices: n });
        }
        let heat = self.flow.solve(&Mat::from_fn(n, 1, |i, _| if i == source { 1.0 } else { 0.0 }));
        let mut divergence = vec![0.0; n];
        for f in self.mesh.faces() {
            match self.mesh.arity() {
                FaceArity::Triangle => self.add_divergence([f[0], f[1], f[2]], 1.0, &heat, &mut divergence),
                FaceArity::Quad => {
                    both_triangulations(f)
                        .into_iter()
                        .for_each(|t| self.add_divergence(t, 0.5, &heat, &mut divergence));
                }
            }
        }
        let potential = self.poisson.solve(&Mat::from_fn(n, 1, |i, _| divergence[i]));
        let zero = potential[(source, 0)];
        // The approximation may dip below its value at the source by a fraction of an edge; distances do not.
        Ok((0..n).map(|i| (potential[(i, 0)] - zero).max(0.0)).collect())
    }

    /// Adds `share` times the integral over one triangle of the unit field away from the heat against the gradients
    /// of the hat functions of its corners.
    fn add_divergence(&self, corners: [u32; 3], share: f64, heat: &Mat<f64>, divergence: &mut [f64]) {
        let p = corners.map(|c| self.mesh.vertices()[c as usize]);
        let normal = (p[1] - p[0]).cross(&(p[2] - p[0]));
        let Some(normal) = normal.try_normalize(0.0) else { return };
        // The gradient of a hat function is this vector over twice the area.
        let inward: [_; 3] = std::array::from_fn(|k| normal.cross(&(p[(k + 2) % 3] - p[(k + 1) % 3])));
        // Far from the source heat is tiny; taken relative to its maximum here, its gradient does not underflow.
        let values = corners.map(|c| heat[(c as usize, 0)]);
        let largest = values.iter().fold(0.0f64, |a, v| a.max(v.abs()));
        let gradient =
            inward[0] * (values[0] / largest) + inward[1] * (values[1] / largest) + inward[2] * (values[2] / largest);
        let Some(uphill) = gradient.try_normalize(0.0) else { return };
        for (corner, inward) in corners.into_iter().zip(inward) {
            divergence[corner as usize] -= share * uphill.dot(&inward) / 2.0;
        }
    }
}

/// Geodesic distance of every vertex of `mesh` from `source_vertex`, mm, by the heat method. For many sources on one
/// surface, [`HeatGeodesics`] factorizes once.
///
/// # Errors
/// [`GeodesicError`].
///
/// # Cost
/// As [`HeatGeodesics::new`].
pub fn geodesic_distances_from(mesh: &SurfaceMesh, source_vertex: usize) -> Result<Vec<f64>, GeodesicError> {
    HeatGeodesics::new(mesh)?.distances_from(source_vertex)
}

fn check_connected(mesh: &SurfaceMesh) -> Result<(), GeodesicError> {
    let graph = mesh.edge_graph();
    let mut found = vec![false; mesh.n_vertices()];
    let mut open = vec![0];
    found[0] = true;
    while let Some(v) = open.pop() {
        for &next in graph.neighbors(v) {
            if !std::mem::replace(&mut found[next as usize], true) {
                open.push(next as usize);
            }
        }
    }
    match found.iter().position(|f| !f) {
        Some(vertex) => Err(GeodesicError::Disconnected { vertex }),
        None => Ok(()),
    }
}
