//! Vertex features of two surfaces: curvature in scale space, and descriptors of many channels reduced to a few
//! principal components.

use crate::error::MatchError;
use crate::surface::side::SurfaceLevel;
use homolog_contract::parameters::{CurvatureEstimator, FeatureKind, FeatureParameters, MatchParameters, Precisions};
use homolog_geometry::curvature::{Curvatures, Estimator, ScaleSpace, curvatures};
use homolog_geometry::descriptors::{
    Descriptor, curvedness, fpfh, heat_kernel_signature, principal_components, shape_contexts, shape_index, shot,
    spin_images, unit_spectrum, wave_kernel_signature,
};
use homolog_mrf::{Feature, learned_weights};
use homolog_primitives::observe::{Observer, checkpoint_within};
use std::cell::OnceCell;

/// The measurements of one element of the list `features` on one surface.
enum FeatureValues {
    /// A list of values for each scale.
    Scalars(Vec<Vec<f64>>),
    /// Many channels.
    Channels(Descriptor),
}

/// The features of both surfaces that `parameters` ask for, with their weights. `root_mm` is the unit of relative
/// lengths; `radius_mm` is the default radius of curvature estimators.
///
/// A descriptor of many channels becomes up to eight features, the principal components of both surfaces together. Each
/// is weighted by its variation, so that differences are those of the descriptors, and together they have the weight of
/// that many scalar features.
pub(crate) fn features(
    source: &SurfaceLevel,
    target: &SurfaceLevel,
    parameters: &MatchParameters,
    root_mm: f64,
    radius_mm: f64,
    observer: &dyn Observer,
) -> Result<Vec<Feature>, MatchError> {
    // On a coarse level features are measured on the finer surface, and read at the vertices of the coarse one.
    let finer = |side| SurfaceLevel::measured_on(side).map_or((side, None), |(finer, sites)| (finer, Some(sites)));
    let ((source, source_sites), (target, target_sites)) = (finer(source), finer(target));
    let (of_source, of_target) = rayon::join(
        || measured(source, parameters, root_mm, radius_mm, observer),
        || measured(target, parameters, root_mm, radius_mm, observer),
    );
    let at_sites = |values: Vec<f64>, sites: Option<&[u32]>| match sites {
        Some(sites) => sites.iter().map(|&k| values[k as usize]).collect(),
        None => values,
    };
    let (mut features, mut groups) = (Vec::new(), Vec::new());
    for (group, (stated, both)) in parameters.features.iter().zip(of_source?.into_iter().zip(of_target?)).enumerate() {
        let mut add = |weight, one, other| {
            let (source, target) = (at_sites(one, source_sites), at_sites(other, target_sites));
            features.push(Feature { weight, source, target });
            groups.push(group);
        };
        match both {
            (FeatureValues::Scalars(one), FeatureValues::Scalars(other)) => {
                one.into_iter().zip(other).for_each(|(one, other)| add(stated.weight, one, other));
            }
            (FeatureValues::Channels(one), FeatureValues::Channels(other)) => {
                let signature =
                    matches!(stated.kind, FeatureKind::HeatKernelSignature | FeatureKind::WaveKernelSignature);
                let (of_one, of_other) = (&source.light().areas, &target.light().areas);
                let found = principal_components((&one, of_one), (&other, of_other), signature, observer)?;
                let n = found.deviations.len() as f64;
                let sum: f64 = found.deviations.iter().sum();
                for ((one, other), deviation) in found.first.into_iter().zip(found.second).zip(found.deviations) {
                    let share = if sum > 0.0 { deviation * n / sum } else { 1.0 };
                    add(stated.weight * share, one, other);
                }
            }
            // Both surfaces have the same kinds of features.
            _ => {}
        }
    }
    if parameters.energy.precisions == Precisions::Learned {
        let learned = learned_weights(&features, &groups, parameters.energy.feature_cap);
        features.iter_mut().zip(learned).for_each(|(feature, weight)| feature.weight = weight);
    }
    Ok(features)
}

/// The measurements of every element of `parameters.features` on a surface.
fn measured(
    side: &SurfaceLevel,
    parameters: &MatchParameters,
    root_mm: f64,
    radius_mm: f64,
    observer: &dyn Observer,
) -> Result<Vec<FeatureValues>, MatchError> {
    let (flow, spectrum) = (OnceCell::new(), OnceCell::new());
    // Several features share a scale and an estimator; each such pair is measured once.
    let mut known: Vec<(f64, Estimator, Curvatures)> = Vec::new();
    let mut at_scale = |scale_mm: f64, estimator: Estimator| -> Result<Curvatures, MatchError> {
        if let Some((.., both)) = known.iter().find(|(s, e, _)| (*s, *e) == (scale_mm, estimator)) {
            return Ok(both.clone());
        }
        checkpoint_within(observer)?;
        let flow = flow.get_or_init(|| ScaleSpace::new(side.mesh()));
        checkpoint_within(observer)?;
        let surface = flow.smoothed(scale_mm).map_err(|_| MatchError::ScaleSpace { scale_mm })?;
        checkpoint_within(observer)?;
        let both = curvatures(&surface, estimator, observer)?;
        known.push((scale_mm, estimator, both.clone()));
        Ok(both)
    };
    let mut of_curvatures = |feature: &FeatureParameters, value: &dyn Fn(Curvatures) -> Vec<f64>| {
        let estimator = estimator(feature, radius_mm);
        let mut values = Vec::new();
        for scale_mm in feature.scales(root_mm) {
            values.push(value(at_scale(scale_mm, estimator)?));
        }
        Ok::<_, MatchError>(FeatureValues::Scalars(values))
    };
    let measure = |feature: &FeatureParameters| -> Result<FeatureValues, MatchError> {
        let support_mm = feature.support * root_mm;
        // Voxel steps would change the normals.
        let light = || &side.light().mesh;
        let spectrum = || match spectrum.get_or_init(|| unit_spectrum(light(), observer)) {
            Err(cancelled) => Err(MatchError::from(*cancelled)),
            Ok(found) => found.as_ref().ok_or(MatchError::Spectrum),
        };
        Ok(FeatureValues::Channels(match feature.kind {
            FeatureKind::GaussianCurvature => return of_curvatures(feature, &|both| both.gaussian),
            FeatureKind::MeanCurvature => return of_curvatures(feature, &|both| both.mean),
            FeatureKind::ShapeIndex => return of_curvatures(feature, &|both| shape_index(&both)),
            FeatureKind::Curvedness => return of_curvatures(feature, &|both| curvedness(&both)),
            FeatureKind::HeatKernelSignature => heat_kernel_signature(spectrum()?),
            FeatureKind::WaveKernelSignature => wave_kernel_signature(spectrum()?),
            FeatureKind::SpinImage => spin_images(light(), support_mm, observer)?,
            FeatureKind::ShapeContext => shape_contexts(light(), support_mm, observer)?,
            FeatureKind::Fpfh => fpfh(light(), support_mm, observer)?,
            FeatureKind::Shot => shot(light(), support_mm, observer)?,
        }))
    };
    parameters.features.iter().map(measure).collect()
}

fn estimator(feature: &FeatureParameters, radius_mm: f64) -> Estimator {
    let radius_mm = feature.radius_mm.unwrap_or(radius_mm);
    match feature.estimator {
        CurvatureEstimator::AngleDefect => Estimator::AngleDefect,
        CurvatureEstimator::Covariance => Estimator::Covariance { radius_mm },
        CurvatureEstimator::Quadric => Estimator::Quadric { radius_mm },
    }
}
