//! The middle and fine stages, after the choice of the pose.

use super::base::State;
use super::displacement::FitContext;
use super::fitted::FineStageFit;
use super::options::StageSettings;
use super::trace::TracedFit;
use super::track::{Assigned, BaseEvaluation, assigned};
use crate::error::MatchError;
use crate::pair::assignment::{displaced, kernel, observed_means, precision_of_features};
use crate::surface::robust::{STD_OF_MAD, median};
use crate::surface::surface_index::ClosestInSteps;
use homolog_primitives::observe::checkpoint;
use homolog_registration::deformation::{Observation, fit_field};
use nalgebra::Point3;
use rayon::prelude::*;

/// The field after the middle and fine stages.
pub(crate) fn fine(displacement: &FitContext<'_>, start: State) -> Result<Option<FineStageFit>, MatchError> {
    fine_aside(displacement, start, Some(displacement.observer.begin()))
}

/// [`fine`] with its part of the energy trace in `fit`; `None` for an auxiliary fit.
pub(crate) fn fine_aside(
    displacement: &FitContext<'_>,
    start: State,
    fit: Option<TracedFit>,
) -> Result<Option<FineStageFit>, MatchError> {
    fine_in(displacement, start, displacement.options.sliding.across_share, fit)
}

/// [`fine_aside`] with another share of the assignment's weight that is kept across the normals.
pub(crate) fn fine_in(
    displacement: &FitContext<'_>,
    start: State,
    across_share: f64,
    fit: Option<TracedFit>,
) -> Result<Option<FineStageFit>, MatchError> {
    let State { base, field, feature_precision } = start;
    let track = BaseEvaluation::new(displacement, base);
    let mut fitted = FineStageFit { track, field, feature_precision, residual_mm: 0.0, across_share, fit };
    let stays_finite = run_stage(displacement, &mut fitted, &displacement.options.middle, Observed::Means)?
        && run_stage(displacement, &mut fitted, &displacement.options.fine, Observed::AlongNormals)?;
    Ok(stays_finite.then_some(fitted))
}

/// What a stage observes of the displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Observed {
    /// The assigned means, on the thinned target.
    Means,
    /// Distances along the normals of the whole target, and with a low weight the assigned means across them.
    AlongNormals,
}

/// Runs the steps of a stage. Returns whether all numbers stayed finite.
pub(crate) fn run_stage(
    displacement: &FitContext<'_>,
    fine: &mut FineStageFit,
    stage: &StageSettings,
    kind: Observed,
) -> Result<bool, MatchError> {
    let FineStageFit { track, field, feature_precision, residual_mm, across_share, fit } = fine;
    let thinned = displacement.source.thinned(stage.n_samples);
    let target = match kind {
        Observed::Means => displacement.target.thinned(stage.n_samples).assignment_target(),
        Observed::AlongNormals => displacement.target.assignment_target(),
    };
    let values = displacement.guides.below(track.values(&thinned));
    let starts = track.starts(&thinned);
    let mirrored = track.base.pose.is_reflection();
    let mut schedule = displacement.schedule(stage);
    let mut closest = ClosestInSteps::default();
    while let Some(at) = schedule.next() {
        checkpoint(displacement.observer)?;
        let sigma_mm = displacement.diagonal_mm * stage.sigma_at(at);
        let kernel = kernel(sigma_mm, feature_precision.clone());
        let Some(assigned) = assigned(displacement, &track.moved(field), mirrored, &thinned, &target, &kernel) else {
            return Ok(false);
        };
        let density = displacement.density(stage, at);
        let observed = match kind {
            Observed::Means => {
                let across = density / (sigma_mm * sigma_mm);
                observed_means(&assigned.found, &starts, &thinned.counted, across)
            }
            Observed::AlongNormals => {
                let (across, along) = (density / (sigma_mm * sigma_mm), density / along_mm(displacement).powi(2));
                let weights = Weights { along, across: *across_share * across };
                let (observed, residual) =
                    sliding(displacement, &assigned, (&thinned.counted, &starts), weights, &mut closest);
                *residual_mm = residual;
                observed
            }
        };
        let Some(fitted) = fit_field(values.as_ref(), &track.with_guides(observed)) else { return Ok(false) };
        if let Some(fit) = fit {
            displacement.observer.trace(fit, assigned.found.misfit, field, stage.observations_at(at));
        }
        schedule.note(&assigned.points, &displaced(&starts, &fitted, &values));
        *field = fitted;
        *feature_precision = precision_of_features(&assigned.found.feature_variance);
    }
    Ok(true)
}

fn along_mm(displacement: &FitContext<'_>) -> f64 {
    displacement.options.sliding.along * displacement.lengths.sampling_mm
}

/// Precisions of observations per unit of area, 1/mm⁴.
#[derive(Clone, Copy)]
pub(crate) struct Weights {
    /// Along the normals of the target.
    pub along: f64,
    /// Across them.
    pub across: f64,
}

/// Observations along the normals of the closest point of the surface, and with a low weight across the normals of the
/// assigned means, of points with these `areas` that the base moves to `starts`; and the residual along the normals, mm.
pub(crate) fn sliding(
    displacement: &FitContext<'_>,
    assigned: &Assigned,
    (areas, starts): (&[f64], &[Point3<f64>]),
    Weights { along, across }: Weights,
    closest: &mut ClosestInSteps,
) -> (Vec<Observation>, f64) {
    let along_mm = along_mm(displacement);
    let closest = closest.of(&displacement.target.closest().index, &assigned.points);
    let pairs: Vec<(Observation, f64)> = (0..starts.len())
        .into_par_iter()
        .map(|i| {
            let (p, at) = (assigned.points[i], &closest[i]);
            let blended = at.blend(|k| displacement.target.normals[k]);
            let normal = blended.try_normalize(1e-9).unwrap_or(assigned.normals[i]);
            let to_surface = at.point - p;
            let to_mean = assigned.found.targets[i] - p;
            let height = normal.dot(&to_surface);
            let observed_mm = (p - starts[i]) + to_mean + normal * (height - normal.dot(&to_mean));
            // Cauchy weight: a point that is far away, or on the opposite side of a wall, is no counterpart.
            let trust =
                normal.dot(&assigned.normals[i]).max(0.0) / (1.0 + (to_surface.norm() / (3.0 * along_mm)).powi(2));
            let area = areas[i];
            let across = across * area * assigned.found.mass[i];
            (Observation { displacement: observed_mm, normal, along: along * area * trust, across }, height.abs())
        })
        .collect();
    let mut heights: Vec<f64> = pairs.iter().map(|p| p.1).collect();
    (pairs.into_iter().map(|p| p.0).collect(), STD_OF_MAD * median(&mut heights))
}
