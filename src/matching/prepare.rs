//! From two surfaces to the energy: canonical numbering, features in scale space, and the MRF.

use super::MatchError;
use super::parameters::{FeatureKind, MatchParameters};
use crate::curvature::{ScaleSpace, gaussian_curvature, mean_curvature};
use crate::graph::LabelNeighborhoods;
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

    /// Every feature that `parameters` ask for at every scale, one list of values each, in order.
    pub fn features(&self, parameters: &MatchParameters) -> Result<Vec<Vec<f64>>, MatchError> {
        let flow = ScaleSpace::new(self.mesh());
        // Several features share a scale; each smoothed surface is made once.
        let mut smoothed: Vec<(f64, SurfaceMesh)> = Vec::new();
        let mut values = Vec::new();
        for feature in &parameters.features {
            for &scale_mm in &feature.scales_mm {
                if !smoothed.iter().any(|(s, _)| *s == scale_mm) {
                    let surface = flow.smoothed(scale_mm).map_err(|_| MatchError::ScaleSpace { scale_mm })?;
                    smoothed.push((scale_mm, surface));
                }
                let Some((_, surface)) = smoothed.iter().find(|(s, _)| *s == scale_mm) else { continue };
                values.push(match feature.kind {
                    FeatureKind::GaussianCurvature => gaussian_curvature(surface),
                    FeatureKind::MeanCurvature => mean_curvature(surface),
                });
            }
        }
        Ok(values)
    }
}

/// The energy of matching `source` to `target`.
pub(super) fn build_model(source: &Side, target: &Side, parameters: &MatchParameters) -> Result<MrfModel, MatchError> {
    let (source_values, target_values) = rayon::join(|| source.features(parameters), || target.features(parameters));
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
    let p = target.mesh().vertices();
    let labels = LabelNeighborhoods::new(&target.mesh().edge_graph(), energy.neighborhood_rings as usize, |x, y| {
        (p[x] - p[y]).norm()
    });
    Ok(MrfModel {
        variables,
        lengths,
        labels,
        unary: unary_potentials(&features, energy.alpha, energy.feature_cap, energy.minkowski_p),
        pairwise: PairwisePotential {
            beta: energy.beta,
            length_scale: target.mesh().mean_edge_length(),
            truncation: energy.truncation,
        },
    })
}
