//! From two surfaces to the energy: canonical numbering, features in scale space, and the MRF.

use super::MatchError;
use super::parameters::{CurvatureEstimator, FeatureKind, FeatureParameters, MatchParameters, PairwiseDistance};
use crate::curvature::{Curvatures, Estimator, ScaleSpace, curvatures, default_radius_mm};
use crate::geodesic::{LabelDistance, label_neighborhoods};
use crate::mesh::{CanonicalMesh, SurfaceMesh, canonicalize};
use crate::mrf::{Feature, MrfModel, PairwisePotential, unary_potentials};
use nalgebra::Vector3;

/// One surface, ready for the energy.
pub(super) struct Side {
    /// In canonical numbering.
    pub surface: CanonicalMesh,
    /// Unit normals of its vertices.
    pub normals: Vec<Vector3<f64>>,
}

impl Side {
    pub fn new(mesh: &SurfaceMesh) -> Self {
        let surface = canonicalize(mesh);
        let normals = surface.mesh.vertex_normals();
        Side { surface, normals }
    }

    pub fn mesh(&self) -> &SurfaceMesh {
        &self.surface.mesh
    }

    /// Every feature that `parameters` ask for at every scale, one list of values each, in order. `radius_mm` is that of
    /// estimators whose radius is not stated.
    pub fn features(&self, parameters: &MatchParameters, radius_mm: f64) -> Result<Vec<Vec<f64>>, MatchError> {
        let flow = ScaleSpace::new(self.mesh());
        // Several features share a scale and an estimator; each pair is measured once.
        let mut measured: Vec<(f64, Estimator, Curvatures)> = Vec::new();
        let mut values = Vec::new();
        for feature in &parameters.features {
            let estimator = estimator(feature, radius_mm);
            for &scale_mm in &feature.scales_mm {
                if !measured.iter().any(|(s, e, _)| (*s, *e) == (scale_mm, estimator)) {
                    let surface = flow.smoothed(scale_mm).map_err(|_| MatchError::ScaleSpace { scale_mm })?;
                    measured.push((scale_mm, estimator, curvatures(&surface, estimator)));
                }
                let found = measured.iter().find(|(s, e, _)| (*s, *e) == (scale_mm, estimator));
                values.extend(found.map(|(_, _, both)| match feature.kind {
                    FeatureKind::GaussianCurvature => both.gaussian.clone(),
                    FeatureKind::MeanCurvature => both.mean.clone(),
                }));
            }
        }
        Ok(values)
    }
}

fn estimator(feature: &FeatureParameters, radius_mm: f64) -> Estimator {
    let radius_mm = feature.radius_mm.unwrap_or(radius_mm);
    match feature.estimator {
        CurvatureEstimator::AngleDefect => Estimator::AngleDefect,
        CurvatureEstimator::Covariance => Estimator::Covariance { radius_mm },
        CurvatureEstimator::Quadric => Estimator::Quadric { radius_mm },
    }
}

/// What a broken edge counts under the hard constraint `T → ∞`. `exp(−60)` is far below the floor of every message, so
/// that messages are those of an infinite truncation, and energies stay numbers.
const HARD_TRUNCATION: f64 = 60.0;

/// The energy of matching `source` to `target`.
pub(super) fn build_model(source: &Side, target: &Side, parameters: &MatchParameters) -> Result<MrfModel, MatchError> {
    // One radius for both, or the coarser surface would look smoother.
    let radius_mm = default_radius_mm(source.mesh()).max(default_radius_mm(target.mesh()));
    let (source_values, target_values) =
        rayon::join(|| source.features(parameters, radius_mm), || target.features(parameters, radius_mm));
    let weights = parameters.features.iter().flat_map(|f| f.scales_mm.iter().map(|_| f.weight));
    let features: Vec<Feature> = weights
        .zip(source_values?.into_iter().zip(target_values?))
        .map(|(weight, (source, target))| Feature { weight, source, target })
        .collect();
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
    Ok(MrfModel {
        variables,
        lengths,
        labels,
        unary: unary_potentials(&features, energy.alpha, energy.feature_cap, energy.minkowski_p),
        pairwise: PairwisePotential {
            beta: energy.beta,
            length_scale: target.mesh().mean_edge_length(),
            truncation: energy.truncation.unwrap_or(HARD_TRUNCATION),
        },
    })
}
