//! First-order spherical harmonics of closed surfaces, and the registration by their ellipsoids.
//!
//! A surface of genus 0 is mapped one to one onto the unit sphere ([`parametrize`]). The spherical harmonics of degree
//! 0 and 1 that best fit its points over that sphere form an ellipsoid, the *first-order ellipsoid*
//! ([`first_order_ellipsoid`]). Two surfaces are registered by aligning the axes of their ellipsoids
//! ([`register_by_ellipsoids`]). This is the classic baseline of shape analysis: global, without an initial pose, and
//! ambiguous in the sign of the axes.
//!
//! Source: Brechbühler, Gerig, Kübler, "Parametrization of closed surfaces for 3-D shape description", Computer Vision
//! and Image Understanding 61(2), 1995. The initial map by heat conduction follows the publication. The optimization
//! has the same aims (equal areas, least distortion, no folds) but uses another method, see `relaxation`.

mod alignment;
mod first_order;
mod heat;
mod relaxation;
mod series;
mod sphere;
mod untangling;
mod weights;

pub use alignment::{EllipsoidOptions, EllipsoidPose, EllipsoidRegistration, register_by_ellipsoids};
pub use first_order::{FirstOrderEllipsoid, first_order_ellipsoid};
pub use series::HarmonicSeries;

use homolog_mesh::SurfaceMesh;
use homolog_mesh::topology::{SurfaceFault, analyze};
use homolog_primitives::observe::{Cancelled, Observer};
use nalgebra::Vector3;

/// Why a surface has no parametrization or no first-order ellipsoid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HarmonicsError {
    /// The surface is not a closed outward surface of genus 0.
    #[error(transparent)]
    Surface(#[from] SurfaceFault),
    /// A vertex belongs to no face, so its position on the sphere is undetermined.
    #[error("vertex {vertex} belongs to no face")]
    UnusedVertex {
        /// The first such vertex.
        vertex: u32,
    },
    /// The two poles of the surface are neighbors.
    #[error("{n_vertices} vertices are too few to separate the two ends of the surface")]
    TooCoarse {
        /// Number of vertices of the surface.
        n_vertices: usize,
    },
    /// The linear system of the heat conduction has no unique solution.
    #[error("heat conduction over the surface has no unique solution: parts of it are connected at two vertices only")]
    NotPositiveDefinite,
    /// The folds of the initial map could not be removed.
    #[error("{n_triangles} triangles remain folded on the sphere")]
    Folded {
        /// Number of triangles with negative area on the sphere.
        n_triangles: usize,
    },
    /// The first-order ellipsoid is flat.
    #[error("the first-order ellipsoid has no volume (half axes {half_axes_mm:?} mm)")]
    Flat {
        /// Its half axes, mm, longest first.
        half_axes_mm: [f64; 3],
    },
    /// The observer asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Options of the map onto the sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParametrizationOptions {
    /// Largest number of optimization steps.
    pub max_iterations: u32,
    /// The optimization ends when the energy falls by less than this share over ten steps.
    pub tolerance: f64,
    /// Weight of the stretching energy relative to the area energy; small and positive. At 0 all area-preserving maps
    /// would be equally good.
    pub stretching: f64,
}

impl Default for ParametrizationOptions {
    fn default() -> Self {
        ParametrizationOptions { max_iterations: 400, tolerance: 1e-6, stretching: 0.02 }
    }
}

/// A one-to-one map of a surface onto the unit sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct Parametrization {
    /// Position of every vertex on the unit sphere. All triangles (quads cut along their first diagonal) keep their
    /// orientation there and cover the sphere once.
    pub directions: Vec<Vector3<f64>>,
    /// Area-weighted root mean square of `area on the sphere / area on the surface − 1`, both scaled to sum 1; 0 for an
    /// area-preserving map.
    pub area_distortion: f64,
    /// Number of triangles that were folded in the initial map.
    pub n_unfolded: usize,
    /// Number of optimization steps.
    pub iterations: u32,
    /// Whether the optimization reached its tolerance.
    pub converged: bool,
}

/// Maps `mesh` onto the unit sphere with equal areas and little stretching, weighted by `options`.
///
/// The map does not depend on the pose: a moved copy has the same map up to a rotation of the sphere and rounding.
///
/// # Errors
/// [`HarmonicsError`]: a surface that is not closed, not of genus 0 or degenerate; [`HarmonicsError::Folded`];
/// [`HarmonicsError::Cancelled`].
///
/// # Cost
/// Three sparse Cholesky factorizations and up to `max_iterations` steps of `O(n log n)`, on one thread.
pub fn parametrize(
    mesh: &SurfaceMesh,
    options: &ParametrizationOptions,
    observer: &dyn Observer,
) -> Result<Parametrization, HarmonicsError> {
    if let Some(fault) = analyze(mesh).fault {
        return Err(fault.into());
    }
    let weighted = weights::WeightedEdges::new(mesh)?;
    let areas = sphere::TargetAreas::new(mesh);
    let mut directions = heat::initial_directions(mesh, &weighted, &areas, observer)?;
    let n_unfolded = untangling::untangle(&mut directions, &weighted, &areas, observer)?;
    let relaxed = relaxation::relax(directions, &weighted, &areas, options, observer)?;
    Ok(Parametrization {
        area_distortion: areas.distortion(&relaxed.directions),
        directions: relaxed.directions,
        n_unfolded,
        iterations: relaxed.iterations,
        converged: relaxed.converged,
    })
}

#[cfg(test)]
mod tests;
