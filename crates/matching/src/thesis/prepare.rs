//! The energy of two surfaces: potentials from their features, and the MRF.

use super::features::features;
use crate::error::MatchError;
use crate::pair::lengths::Lengths;
use crate::surface::levels::Levels;
use crate::surface::side::SurfaceLevel;
use homolog_contract::parameters::{Landmark, MatchParameters, PairwiseDistance};
use homolog_geometry::geodesic::{LabelDistance, label_neighborhoods};
use homolog_mesh::SurfaceMesh;
use homolog_mrf::{MrfModel, PairwisePotential, unary_potentials};
use homolog_primitives::observe::{Observer, Silent};
use nalgebra::Point3;

/// Most that a landmark adds to a unary potential, so that a wrong landmark can be outvoted.
const LANDMARK_CAP: f64 = 10.0;

/// Adds `min(‖p'_x − q‖² / 2σ², cap)` to the unary potentials of the variable nearest to each landmark. `σ` is at least
/// half an edge, because labels are no closer.
fn add_landmarks(unary: &mut [f32], source: &SurfaceLevel, target: &SurfaceLevel, landmarks: &[Landmark]) {
    let labels = target.mesh().vertices();
    let least_mm = if landmarks.is_empty() { 0.0 } else { 0.5 * target.mesh().mean_edge_length() };
    for landmark in landmarks {
        let (p, q) = (Point3::from(landmark.source_mm), Point3::from(landmark.target_mm));
        let distance = |i: &usize| (source.mesh().vertices()[*i] - p).norm_squared();
        let nearest = (0..source.mesh().n_vertices()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(variable) = nearest else { continue };
        let scale = 0.5 / landmark.sigma_mm.max(least_mm).powi(2);
        for (theta, x) in unary[variable * labels.len()..].iter_mut().zip(labels) {
            *theta += (scale * (x - q).norm_squared()).min(LANDMARK_CAP) as f32;
        }
    }
}

/// Cost of a broken edge under the hard constraint `T → ∞`: unary potentials never outweigh it, energies stay finite,
/// and `exp(−60)` is representable in 32 bits.
const HARD_TRUNCATION: f64 = 60.0;

/// The energy of matching `source` to `target`.
pub(crate) fn build_model(
    source: &SurfaceLevel,
    target: &SurfaceLevel,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MrfModel, MatchError> {
    // Both use one radius: at different radii the coarser surface would appear smoother.
    let radius_mm = source.feature_radius_mm().max(target.feature_radius_mm());
    let root_mm = Lengths::of(source, target).root_mm;
    let features = features(source, target, parameters, root_mm, radius_mm, observer)?;
    let energy = &parameters.energy;
    let variables = source.mesh().edge_graph();
    let mut lengths = Vec::with_capacity(variables.n_directed_edges());
    for i in 0..variables.n_vertices() {
        let p = source.mesh().vertices()[i];
        lengths
            .extend(variables.neighbors(i).iter().map(|&j| (p - source.mesh().vertices()[j as usize]).norm() as f32));
    }
    let distance = match energy.pairwise_distance {
        PairwiseDistance::Euclidean => LabelDistance::Euclidean,
        PairwiseDistance::Graph => LabelDistance::Graph,
        PairwiseDistance::Geodesic => LabelDistance::Geodesic,
    };
    let labels = label_neighborhoods(target.mesh(), energy.neighborhood_rings as usize, distance);
    let mut unary = unary_potentials(&features, energy.alpha, energy.feature_cap, energy.minkowski_p, observer)?;
    add_landmarks(&mut unary, source, target, &parameters.landmarks);
    Ok(MrfModel {
        variables,
        lengths,
        labels,
        unary,
        pairwise: PairwisePotential {
            beta: energy.beta,
            length_scale: target.mesh().mean_edge_length(),
            truncation: energy.truncation.unwrap_or(HARD_TRUNCATION),
        },
    })
}

/// The energy of matching `source` to `target`, as [`crate::match_surfaces`] minimizes it in its first round. Variables
/// and labels are in canonical numbering (see [`homolog_mesh::canonicalize`]).
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn energy_model(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
) -> Result<MrfModel, MatchError> {
    build_model(&SurfaceLevel::new(source), &SurfaceLevel::new(target), parameters, &Silent)
}

/// The energy on the coarse levels of two surfaces, as [`crate::match_levels`] minimizes it in its first round.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn coarse_energy_model(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
) -> Result<MrfModel, MatchError> {
    build_model(&source.energy().side, &target.energy().side, parameters, &Silent)
}
