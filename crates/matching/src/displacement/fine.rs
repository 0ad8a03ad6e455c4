//! The stages after the pose is chosen: middle, fine and settling.

use super::fits::Fit;
use super::functions::Functions;
use super::local::LocalKernel;
use super::stages::{Base, Displacement, State, displaced, kernel, observed_means, precision_of_features};
use super::surface::SmoothSurface;
use super::track::{Assigned, Track};
use crate::MatchError;
use crate::robust::{STD_OF_MAD, median};
use homolog_primitives::observe::checkpoint;
use homolog_registration::alignment::annealed;
use homolog_registration::deformation::{FittedField, Observation, fit_field};
use homolog_registration::{RigidTransform, absolute_orientation_of};
use nalgebra::Point3;
use rayon::prelude::*;

/// Standard deviation of a point along the normal of the other surface in the fine stage, in sampling distances.
const ALONG: f64 = 0.34;
/// Share of the assignment's weight that is kept across the normal in the fine stage. With 0.3 narrow 4 % warps had 0.77 of the vertices within
/// one edge instead of 0.80, warps of 8 % 0.97 instead of 0.98; with 1 0.69 and 0.91.
pub(super) const ACROSS_SHARE: f64 = 0.1;
/// Residual along the normals, in sampling distances, below which two surfaces are copies of one anatomy.
const NOISE: f64 = 0.136;
/// Observations are weighted by `(noise / residual)` to this power: two for the variance, the rest because larger
/// residuals are correlated over larger areas.
const NOISE_POWER: f64 = 6.0;

/// A field after all stages.
pub(super) struct Refined {
    /// What the field is added to, in terms of `base_functions`.
    pub base: Base,
    pub base_functions: Functions,
    pub field: FittedField,
    /// The functions of the field.
    pub functions: Functions,
    /// Robust standard deviation of the residual along the normals after the fine stage, mm.
    pub residual_mm: f64,
    /// What the local stage found, if it took part: the covariance of the field is then that of all its displacement.
    pub local: Option<LocalKernel>,
}

/// A field after the middle and fine stages.
pub(super) struct Fine {
    pub track: Track,
    pub field: FittedField,
    pub feature_precision: Vec<f64>,
    /// Robust standard deviation of the residual along the normals, mm.
    pub residual_mm: f64,
    /// Share of the assignment's weight that is kept across the normals.
    pub across_share: f64,
    /// Its place in the energy trace, unless it is left out there.
    pub fit: Option<Fit>,
}

impl Fine {
    /// The vertices of the source where the field moves them, mm.
    pub(super) fn moved(&self) -> Vec<Point3<f64>> {
        self.track.moved(&self.field)
    }
}

impl Displacement<'_> {
    /// The rigid part of what moves the vertices of the source to `moved`: a start that forgets from where it was reached, `pose`, but
    /// has its handedness. `pose` where there is none.
    pub(super) fn pose_of(&self, moved: &[Point3<f64>], pose: &RigidTransform) -> RigidTransform {
        let SmoothSurface { mesh, areas, .. } = &*self.source;
        absolute_orientation_of(mesh.vertices(), moved, Some(areas), pose.is_reflection()).unwrap_or(*pose)
    }

    /// The field after all stages.
    pub(super) fn refined(&self, start: State) -> Result<Option<Refined>, MatchError> {
        match self.fine(start)? {
            Some(fine) => self.refined_from(fine),
            None => Ok(None),
        }
    }

    /// The field after the stages that follow `fine`.
    pub(super) fn refined_from(&self, fine: Fine) -> Result<Option<Refined>, MatchError> {
        match self.local(&fine)? {
            Some(refined) => Ok(Some(refined)),
            None => self.settled(fine),
        }
    }

    /// The field after the middle and fine stages.
    pub(super) fn fine(&self, start: State) -> Result<Option<Fine>, MatchError> {
        self.fine_in(start, [self.options.steps[1], self.options.steps[2]], ACROSS_SHARE, Some(self.observer.begin()))
    }

    /// The same, left out of the energy trace: for fits side by side that are no answer.
    pub(super) fn fine_aside(&self, start: State) -> Result<Option<Fine>, MatchError> {
        self.fine_in(start, [self.options.steps[1], self.options.steps[2]], ACROSS_SHARE, None)
    }

    /// The same in so many steps of each, with this share of the assignment's weight across the normals.
    pub(super) fn fine_in(
        &self,
        start: State,
        steps: [u32; 2],
        across_share: f64,
        fit: Option<Fit>,
    ) -> Result<Option<Fine>, MatchError> {
        let State { base, field, feature_precision } = start;
        let track = Track::new(self, base);
        let mut fine = Fine { track, field, feature_precision, residual_mm: 0.0, across_share, fit };
        for (stage, steps) in [1, 2].into_iter().zip(steps) {
            if !self.followed(&mut fine, stage, steps, 1.0)? {
                return Ok(None);
            }
        }
        Ok(Some(fine))
    }

    /// The field after the settling stage.
    fn settled(&self, mut fine: Fine) -> Result<Option<Refined>, MatchError> {
        let residual_mm = fine.residual_mm;
        let weight = (NOISE * self.lengths.sampling_mm / residual_mm).powf(NOISE_POWER).min(1.0);
        if !self.followed(&mut fine, 3, self.options.steps[3], weight)? {
            return Ok(None);
        }
        Ok(Some(Refined {
            base: fine.track.base,
            base_functions: self.functions.clone(),
            field: fine.field,
            functions: self.functions.clone(),
            residual_mm,
            local: None,
        }))
    }

    /// Follows the field through the steps of a stage, with observations weighted by `weight`. Whether all numbers stayed
    /// finite.
    fn followed(&self, fine: &mut Fine, stage: usize, steps: u32, weight: f64) -> Result<bool, MatchError> {
        let Fine { track, field, feature_precision, residual_mm, across_share, fit } = fine;
        let thinned = self.source.thinned(self.options.n_samples[stage]);
        let target =
            if stage == 1 { self.target.thinned(self.options.n_samples[stage]).packed() } else { self.target.packed() };
        let values = self.guides.below(track.values(&thinned));
        let starts = track.starts(&thinned);
        let mirrored = track.base.pose.is_reflection();
        // Settling stays where the fine stage ended.
        let (from, to) = (stage.min(3), (stage + 1).min(3));
        let mut pace = self.pace(stage, steps);
        while let Some(at) = pace.next() {
            checkpoint(self.observer)?;
            let sigma_mm = self.diagonal_mm * annealed(self.options.sigma[from], self.options.sigma[to], at);
            let density = weight * self.density(from, to, at);
            let kernel = kernel(sigma_mm, feature_precision.clone());
            let Some(assigned) = self.assigned(&track.moved(field), mirrored, &thinned, &target, &kernel) else {
                return Ok(false);
            };
            let across = density / (sigma_mm * sigma_mm);
            let observed = if stage == 1 {
                observed_means(&assigned.found, &starts, &thinned.counted, across)
            } else {
                let along = density / self.along_mm().powi(2);
                let (observed, residual) =
                    self.sliding(&assigned, &thinned.counted, &starts, along, *across_share * across);
                if stage == 2 {
                    *residual_mm = residual;
                }
                observed
            };
            let Some(fitted) = fit_field(values.as_ref(), &track.with_guides(observed)) else { return Ok(false) };
            if let Some(fit) = fit {
                let observations = annealed(self.options.density[from], self.options.density[to], at);
                self.observer.trace(fit, assigned.found.misfit, field, observations);
            }
            pace.note(&assigned.points, &displaced(&starts, &fitted, &values));
            *field = fitted;
            *feature_precision = precision_of_features(&assigned.found.feature_variance);
        }
        Ok(true)
    }

    fn along_mm(&self) -> f64 {
        ALONG * self.lengths.sampling_mm
    }

    /// Observations of the closest point of the surface along its normals, and weakly of the assigned means across
    /// them.
    pub(super) fn sliding(
        &self,
        assigned: &Assigned,
        areas: &[f64],
        starts: &[Point3<f64>],
        along: f64,
        across: f64,
    ) -> (Vec<Observation>, f64) {
        let along_mm = self.along_mm();
        let closest = &self.target.closest().index;
        let pairs: Vec<(Observation, f64)> = (0..starts.len())
            .into_par_iter()
            .map(|i| {
                let p = assigned.points[i];
                let at = closest.closest(&p);
                let blended = at.blend(|k| self.target.normals[k]);
                let normal = blended.try_normalize(1e-9).unwrap_or(assigned.normals[i]);
                let to_surface = at.point - p;
                let to_mean = assigned.found.targets[i] - p;
                let height = normal.dot(&to_surface);
                let displacement = (p - starts[i]) + to_mean + normal * (height - normal.dot(&to_mean));
                // A point that is far away or on the opposite side has no counterpart there (Cauchy's weight).
                let trust =
                    normal.dot(&assigned.normals[i]).max(0.0) / (1.0 + (to_surface.norm() / (3.0 * along_mm)).powi(2));
                let area = areas[i];
                let across = across * area * assigned.found.mass[i];
                (Observation { displacement, normal, along: along * area * trust, across }, height.abs())
            })
            .collect();
        let mut heights: Vec<f64> = pairs.iter().map(|p| p.1).collect();
        (pairs.into_iter().map(|p| p.0).collect(), STD_OF_MAD * median(&mut heights))
    }
}
