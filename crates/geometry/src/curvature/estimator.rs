//! The choice between the estimators of curvature.

use super::angle_defect::{both_curvatures, vertex_areas};
use super::ball::{Patches, Visited};
use super::{covariance, quadric};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};
use rayon::prelude::*;

/// Method of measuring curvature.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Estimator {
    /// Corner angles and cotangents over the faces around a vertex (`angle_defect.rs`): needs no radius, satisfies the
    /// Gauss-Bonnet theorem to rounding, is sensitive to noise of single faces.
    #[default]
    AngleDefect,
    /// The covariance of normals and positions in a ball (`covariance.rs`).
    Covariance {
        /// Radius of the ball, mm; see [`default_radius_mm`].
        radius_mm: f64,
    },
    /// The least-squares paraboloid in a ball (`quadric.rs`).
    Quadric {
        /// Radius of the ball, mm; see [`default_radius_mm`].
        radius_mm: f64,
    },
}

/// Gaussian and mean curvature of every vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct Curvatures {
    /// Gaussian curvature `K_i`, 1/mm².
    pub gaussian: Vec<f64>,
    /// Mean curvature `H_i`, 1/mm, positive where the surface is convex (`1/r` on a sphere).
    pub mean: Vec<f64>,
}

/// Radius of the default ball in mean edge lengths: two rings of triangles or quads with the diagonals, about 19
/// vertices for the 6 unknowns of a paraboloid.
const DEFAULT_RADIUS_EDGES: f64 = 2.5;

/// Gaussian and mean curvature at a vertex from the members of its ball, if they determine them.
type CurvatureOf = fn(&Patches, usize, &[u32]) -> Option<(f64, f64)>;

/// Vertices per task, which share scratch memory.
const CHUNK: usize = 256;

/// Radius of the ball, mm, that fits the resolution of `mesh`: 2.5 mean edge lengths. To compare two surfaces, use one
/// radius for both.
pub fn default_radius_mm(mesh: &SurfaceMesh) -> f64 {
    DEFAULT_RADIUS_EDGES * mesh.mean_edge_length()
}

/// Gaussian and mean curvature of every vertex of `mesh`, measured by `estimator`.
///
/// A vertex gets the values of [`Estimator::AngleDefect`] if its ball does not contain enough of the surface (fewer
/// than 6 vertices for a paraboloid, collinear points for the covariance), and so does every vertex if the radius is
/// not positive.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every vertex that has a ball.
///
/// # Cost
/// `O(faces)`, or `O(n k)` with `k` vertices per ball, on all threads; every vertex is computed independently, so any
/// number of threads gives the same bits.
pub fn curvatures(mesh: &SurfaceMesh, estimator: Estimator, observer: &dyn Observer) -> Result<Curvatures, Cancelled> {
    let areas = vertex_areas(mesh);
    let around = both_curvatures(mesh, &areas);
    let (radius_mm, curvature_of): (f64, CurvatureOf) = match estimator {
        Estimator::AngleDefect => return Ok(around),
        Estimator::Covariance { radius_mm } => (radius_mm, covariance::curvature_of),
        Estimator::Quadric { radius_mm } => (radius_mm, quadric::curvature_of),
    };
    let patches = Patches::new(mesh, areas, radius_mm);
    let n = mesh.n_vertices();
    let chunks: Vec<Vec<(f64, f64)>> = (0..n.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let mut visited = Visited::new(n);
            let mut values = Vec::with_capacity(CHUNK);
            for v in chunk * CHUNK..n.min((chunk + 1) * CHUNK) {
                // A ball may hold the whole surface.
                checkpoint_within(observer)?;
                patches.collect(v, &mut visited);
                let found = curvature_of(&patches, v, &visited.members).filter(|(k, h)| k.is_finite() && h.is_finite());
                values.push(found.unwrap_or((around.gaussian[v], around.mean[v])));
            }
            Ok(values)
        })
        .collect::<Result<_, Cancelled>>()?;
    let (gaussian, mean) = chunks.into_iter().flatten().unzip();
    Ok(Curvatures { gaussian, mean })
}
