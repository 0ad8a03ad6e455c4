//! The energy of two surfaces: features in scale space, and the MRF.

use super::MatchError;
use super::lengths::Lengths;
use super::side::Side;
use homolog_contract::parameters::{
    CurvatureEstimator, FeatureKind, FeatureParameters, Landmark, MatchParameters, PairwiseDistance,
};
use homolog_geometry::curvature::{Curvatures, Estimator, ScaleSpace, curvatures};
use homolog_geometry::geodesic::{LabelDistance, label_neighborhoods};
use homolog_mrf::{Feature, MrfModel, PairwisePotential, unary_potentials};
use nalgebra::Point3;

impl Side {
    /// Every feature that `parameters` ask for at every scale, one list of values each, in order. `root_mm` is the size that
    /// relative scales are multiples of; `radius_mm` is for estimators whose radius is not stated.
    pub(crate) fn features(
        &self,
        parameters: &MatchParameters,
        root_mm: f64,
        radius_mm: f64,
    ) -> Result<Vec<Vec<f64>>, MatchError> {
        if let Some((finer, sites)) = self.measured_on() {
            let at_sites = |values: &Vec<f64>| sites.iter().map(|&k| values[k as usize]).collect();
            return Ok(finer.features(parameters, root_mm, radius_mm)?.iter().map(at_sites).collect());
        }
        let flow = ScaleSpace::new(self.mesh());
        // Several features share a scale and an estimator; each pair is measured once.
        let mut measured: Vec<(f64, Estimator, Curvatures)> = Vec::new();
        let mut values = Vec::new();
        for feature in &parameters.features {
            let estimator = estimator(feature, radius_mm);
            for scale_mm in feature.scales(root_mm) {
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

/// Most that a landmark adds to a unary potential, so that a wrong one can be outvoted.
const LANDMARK_CAP: f64 = 10.0;

/// Adds `min(‖p'_x − q‖² / 2σ², cap)` to the unary potentials of the variable nearest to each landmark, `σ` no smaller
/// than half an edge: labels lie no closer.
fn add_landmarks(unary: &mut [f32], source: &Side, target: &Side, landmarks: &[Landmark]) {
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

/// Cost of a broken edge under the hard constraint `T → ∞`: no unary potentials outweigh it, energies stay finite, and
/// `exp(−60)` is still a 32-bit number.
const HARD_TRUNCATION: f64 = 60.0;

/// The energy of matching `source` to `target`.
pub(super) fn build_model(source: &Side, target: &Side, parameters: &MatchParameters) -> Result<MrfModel, MatchError> {
    // One radius for both, or the coarser surface would appear smoother.
    let radius_mm = source.feature_radius_mm().max(target.feature_radius_mm());
    let root_mm = Lengths::of(source, target).root_mm;
    let (source_values, target_values) = rayon::join(
        || source.features(parameters, root_mm, radius_mm),
        || target.features(parameters, root_mm, radius_mm),
    );
    let weights = parameters.features.iter().flat_map(|f| f.scales(root_mm).into_iter().map(|_| f.weight));
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
    let mut unary = unary_potentials(&features, energy.alpha, energy.feature_cap, energy.minkowski_p);
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
