//! The coarse stage of a displacement: a field over a base, on thinned surfaces.
//!
//! A field is smallest from the pose at which it has no rigid part, and assignments slide slowly along a smooth surface, so
//! where a fit ends depends on the pose from which it starts. Poses of a search differ by several degrees, and by others
//! if source and target are exchanged. So the stage starts from the rigid part of the screening, and is repeated from its
//! own. Both directions of a match then start from nearly one pose.

use super::base::{InitialMap, State};
use super::displacement::FitContext;
use super::fitted::rigid_part_of;
use super::schedule::Schedule;
use crate::error::MatchError;
use crate::pair::assignment::{comparison_kernel, displaced, kernel, observed_means, precision_of_features};
use crate::surface::smooth::{N_FEATURES, Subsample};
use faer::Mat;
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use homolog_registration::alignment::{AssignmentTarget, OrientedPoints, assign, misfit};
use homolog_registration::deformation::fit_field;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// The field after the coarse stage from a single pose that an earlier fit has found.
pub(crate) fn coarse_alone(displacement: &FitContext<'_>, pose: &RigidTransform) -> Option<State> {
    CoarseStage::new(displacement).fit(pose).map(|(_, state)| state)
}

/// The coarse stage from any pose.
pub(crate) struct CoarseStage<'a> {
    pub displacement: &'a FitContext<'a>,
    pub source: Subsample,
    pub target: Subsample,
    pub assignment_target: AssignmentTarget,
    /// The functions of the field at the points of `source`.
    pub values: Mat<f64>,
}

impl<'a> CoarseStage<'a> {
    pub(crate) fn new(displacement: &'a FitContext<'a>) -> Self {
        let n = displacement.options.coarse.n_samples;
        let (source, target) = (displacement.source.thinned(n), displacement.target.thinned(n));
        let values = displacement.guides.below(displacement.functions.values(&source.points));
        CoarseStage { displacement, source, assignment_target: target.assignment_target(), target, values }
    }

    /// The misfit and the field from the rigid part that the stage reaches from each of `poses`; `None` where a number is
    /// not finite. One task per pose: a single step is too short to share between cores.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(crate) fn fit_all(&self, poses: &[RigidTransform]) -> Result<Vec<Option<(f64, State)>>, MatchError> {
        let displacement = self.displacement;
        let from = |pose: &RigidTransform| {
            checkpoint(displacement.observer)?;
            Ok(self.fit(pose).and_then(|(_, state)| self.fit(&self.rigid_part(&state))))
        };
        poses.par_iter().map(from).collect()
    }

    /// The rigid part of the map of `state`, or its pose if that fails.
    pub(crate) fn rigid_part(&self, state: &State) -> RigidTransform {
        let (pose, points) = (state.base.pose, &self.source.points);
        let moved = state.moved(points, &self.values);
        rigid_part_of((points, &self.source.counted), &moved, &pose)
    }

    fn fit(&self, pose: &RigidTransform) -> Option<(f64, State)> {
        let schedule = self.displacement.schedule(&self.displacement.options.coarse);
        let base = InitialMap::rigid(*pose);
        coarse_from(self.displacement, &base, &self.source, &self.assignment_target, &self.values, schedule)
    }
}

/// Returns a function that gives the misfit and the field of a pose after a few steps on few vertices; `None` if a
/// number is not finite.
pub(crate) fn screening(displacement: &FitContext<'_>) -> impl Fn(&RigidTransform) -> Option<(f64, State)> + Sync {
    let source = displacement.source.thinned(displacement.options.choice.screening_samples);
    let target = displacement.target.thinned(displacement.options.choice.screening_samples).assignment_target();
    let values = displacement.guides.below(displacement.functions.values(&source.points));
    move |pose| {
        // Ranking the poses needs no converged field, so no step is repeated.
        let schedule = Schedule::new(displacement.options.choice.screening_steps, 0, displacement.lengths.root_mm);
        coarse_from(displacement, &InitialMap::rigid(*pose), &source, &target, &values, schedule)
    }
}

/// Misfit and field over `base_of` after the steps of `schedule`.
pub(crate) fn coarse_from(
    displacement: &FitContext<'_>,
    base_of: &InitialMap,
    source: &Subsample,
    target: &AssignmentTarget,
    values: &Mat<f64>,
    mut schedule: Schedule,
) -> Option<(f64, State)> {
    let base = base_of.moved(&source.points, values);
    let guided = displacement.guides.observations(base_of);
    let mut normals: Vec<Vector3<f64>> = source.normals.iter().map(|n| base_of.pose.rotation * n).collect();
    // A rigid base keeps normals, and the field over it hardly rotates them. For a bent base normals are those of the
    // whole deformed surface.
    let mut whole = None;
    if base_of.bend.is_some() {
        let values = displacement.functions.values(displacement.source.mesh.vertices());
        let moved = base_of.moved(displacement.source.mesh.vertices(), &values);
        normals = normals_at(displacement, moved.clone(), source)?;
        whole = Some((values, moved));
    }
    let mut moved = base.clone();
    let settings = &displacement.options.coarse;
    let mut precision = precision_of_features(&[1.0; N_FEATURES]);
    let mut field = None;
    while let Some(at) = schedule.next() {
        let sigma = settings.sigma_at(at);
        let samples = OrientedPoints { points: &moved, normals: &normals, ..source.samples() };
        let found = assign(&samples, target, &kernel(sigma * displacement.diagonal_mm, precision));
        let weight = displacement.density(settings, at) / (sigma * displacement.diagonal_mm).powi(2);
        let observed = [observed_means(&found, &base, &source.counted, weight), guided.clone()].concat();
        let fitted = fit_field(values.as_ref(), &observed)?;
        let after = displaced(&base, &fitted, values);
        schedule.note(&moved, &after);
        moved = after;
        if let Some((values, base)) = &whole {
            normals = normals_at(displacement, displaced(base, &fitted, values), source)?;
        }
        precision = precision_of_features(&found.feature_variance);
        field = Some(fitted);
    }
    // All poses are compared with the same precisions: a wrong pose would otherwise lower its misfit by lowering the
    // precision of features.
    let samples = OrientedPoints { points: &moved, normals: &normals, ..source.samples() };
    let misfit = misfit(&samples, target, &comparison_kernel(settings.sigma[1] * displacement.diagonal_mm))
        + field.as_ref().map_or(0.0, |field| displacement.guides.misfit(base_of, field));
    field.map(|field| (misfit, State { base: base_of.clone(), field, feature_precision: precision }))
}

/// Normals, at `thinned`, of the surface whose vertices are at `moved`. `None` if a number is not finite.
fn normals_at(
    displacement: &FitContext<'_>,
    moved: Vec<Point3<f64>>,
    thinned: &Subsample,
) -> Option<Vec<Vector3<f64>>> {
    let normals = displacement.source.mesh.with_vertices(moved).ok()?.vertex_normals();
    Some(thinned.vertices.iter().map(|&i| normals[i]).collect())
}
