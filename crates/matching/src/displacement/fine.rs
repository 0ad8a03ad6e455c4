//! The stages after the pose is chosen: middle, fine and settling.

use super::TWO_SUBJECTS;
use super::functions::Functions;
use super::stages::{Base, Displacement, State, displaced, kernel, observed_means, precision_of_features};
use crate::MatchError;
use crate::robust::{STD_OF_MAD, median};
use faer::Mat;
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use homolog_registration::alignment::{Assignment, OrientedPoints, annealed, assign, progress_to_end};
use homolog_registration::deformation::{FittedField, Observation, fit_field};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Standard deviation of a point along the normal of the other surface in the fine stage, in sampling distances.
const ALONG: f64 = 0.34;
/// Share of the assignment's weight that is kept across the normal in the fine stage; 0.03 to 0.3 gave the same accuracy.
const ACROSS_SHARE: f64 = 0.1;
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
    /// Whether the local stage took part: the covariance of the field is then that of all its displacement.
    pub is_local: bool,
}

/// The sign of the normals after `pose`: the faces of a mirrored surface are oriented inwards.
pub(super) fn outwards(pose: &RigidTransform) -> f64 {
    if pose.is_reflection() { -1.0 } else { 1.0 }
}

impl Displacement<'_> {
    /// The field after all stages.
    pub(super) fn refined(&self, start: State) -> Result<Option<Refined>, MatchError> {
        let State { base: base_of, mut field, mut feature_precision } = start;
        let pose = &base_of.pose;
        let all_values = self.functions.values(self.source.mesh.vertices());
        let all_base = base_of.moved(self.source.mesh.vertices(), &all_values);
        let outwards = outwards(pose);
        let mut residual_mm = 0.0;
        let guided = self.guides.observations(&base_of);
        for (stage, &steps) in self.options.steps.iter().enumerate().skip(1) {
            let thinned = self.source.thinned(self.options.n_samples[stage]);
            let thinned_target = self.target.thinned(self.options.n_samples[stage]);
            let target = if stage == 1 { thinned_target.samples() } else { self.target.samples() };
            let values =
                Mat::from_fn(thinned.vertices.len(), all_values.ncols(), |i, k| all_values[(thinned.vertices[i], k)]);
            let values = self.guides.below(&values);
            let base: Vec<Point3<f64>> = thinned.vertices.iter().map(|&i| all_base[i]).collect();
            // Settling stays where the fine stage ended.
            let (from, to) = (stage.min(3), (stage + 1).min(3));
            if stage == 3
                && (self.open || residual_mm < TWO_SUBJECTS * self.lengths.sampling_mm)
                && let Some(refined) = self.local(
                    &base_of,
                    &all_base,
                    displaced(&all_base, &field, &all_values),
                    feature_precision.clone(),
                    residual_mm,
                )?
            {
                return Ok(Some(refined));
            }
            let weight = if stage == 3 {
                (NOISE * self.lengths.sampling_mm / residual_mm).powf(NOISE_POWER).min(1.0)
            } else {
                1.0
            };
            for step in 0..steps {
                checkpoint(self.observer)?;
                let at = progress_to_end(step, steps);
                let sigma_mm = self.diagonal_mm * annealed(self.options.sigma[from], self.options.sigma[to], at);
                let density = weight * self.density(from, to, at);
                // Normals are those of the whole deformed surface.
                let Ok(mesh) = self.source.mesh.with_vertices(displaced(&all_base, &field, &all_values)) else {
                    return Ok(None);
                };
                let normals = mesh.vertex_normals();
                let normals: Vec<Vector3<f64>> = thinned.vertices.iter().map(|&i| normals[i] * outwards).collect();
                let points: Vec<Point3<f64>> = thinned.vertices.iter().map(|&i| mesh.vertices()[i]).collect();
                let samples = OrientedPoints { points: &points, normals: &normals, ..thinned.samples() };
                let found = assign(&samples, &target, &kernel(sigma_mm, feature_precision));
                let across = density / (sigma_mm * sigma_mm);
                let observed = if stage == 1 {
                    observed_means(&found, &base, &thinned.areas, across)
                } else {
                    let along = density / self.along_mm().powi(2);
                    let (observed, residual) = self.sliding(&found, &samples, &base, along, across);
                    if stage == 2 {
                        residual_mm = residual;
                    }
                    observed
                };
                let observed = [observed, guided.clone()].concat();
                let Some(fitted) = fit_field(values.as_ref(), &observed) else { return Ok(None) };
                field = fitted;
                feature_precision = precision_of_features(&found.feature_variance);
            }
        }
        Ok(Some(Refined {
            base: base_of,
            base_functions: self.functions.clone(),
            field,
            functions: self.functions.clone(),
            residual_mm,
            is_local: false,
        }))
    }

    fn along_mm(&self) -> f64 {
        ALONG * self.lengths.sampling_mm
    }

    /// Observations of the closest point of the surface along its normals, and weakly of the assigned means across
    /// them.
    pub(super) fn sliding(
        &self,
        found: &Assignment,
        moved: &OrientedPoints<'_>,
        base: &[Point3<f64>],
        along: f64,
        across: f64,
    ) -> (Vec<Observation>, f64) {
        let along_mm = self.along_mm();
        let pairs: Vec<(Observation, f64)> = (0..base.len())
            .into_par_iter()
            .map(|i| {
                let p = moved.points[i];
                let at = self.closest.index.closest(&p);
                let blended = at.blend(|k| self.target.normals[k]);
                let normal = blended.try_normalize(1e-9).unwrap_or(moved.normals[i]);
                let to_surface = at.point - p;
                let to_mean = found.targets[i] - p;
                let height = normal.dot(&to_surface);
                let displacement = (p - base[i]) + to_mean + normal * (height - normal.dot(&to_mean));
                // A point that is far away or on the opposite side has no counterpart there (Cauchy's weight).
                let trust =
                    normal.dot(&moved.normals[i]).max(0.0) / (1.0 + (to_surface.norm() / (3.0 * along_mm)).powi(2));
                let area = moved.areas[i];
                let across = ACROSS_SHARE * across * area * found.mass[i];
                (Observation { displacement, normal, along: along * area * trust, across }, height.abs())
            })
            .collect();
        let mut heights: Vec<f64> = pairs.iter().map(|p| p.1).collect();
        (pairs.into_iter().map(|p| p.0).collect(), STD_OF_MAD * median(&mut heights))
    }
}
