//! The first stage of a displacement: the choice of the pose, and the field from it.

use super::pace::Pace;
use super::stages::{
    Base, Displacement, State, comparison_kernel, displaced, kernel, observed_means, precision_of_features,
};
use super::surface::{N_FEATURES, Thinned};
use crate::MatchError;
use faer::Mat;
use homolog_primitives::observe::checkpoint;
use homolog_registration::alignment::{AssignmentTarget, OrientedPoints, annealed, assign, misfit};
use homolog_registration::deformation::fit_field;
use homolog_registration::{RigidTransform, SAME_POSE_ANGLE, SamePose, absolute_orientation_of};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Vertices and steps of the first screening of all poses.
const SCREENING_SAMPLES: usize = 250;
const SCREENING_STEPS: u32 = 6;
/// Of poses of one handedness that are the same within this angle, radians, only the better one is followed: later
/// stages would lead both to the same pose.
const SAME_POSE: f64 = std::f64::consts::FRAC_PI_4;
/// Poses of one handedness that are followed after the screening.
const FOLLOWED: usize = 2;

/// A rotation about the axis about which the source is most nearly round is better than none only if its misfit is lower by this: of
/// nearly round copies with noise it was lower by up to 0.006 by chance, and answers were off by 10° to 15°; of 13 beans with warps of 8 %
/// for which a rotation was followed it was lower by 0.007 to 0.036 in ten.
const LEAST_GAIN_OF_ROTATION: f64 = 0.01;

/// Steps from a pose that an earlier fit has found.
const STEPS_FROM_KNOWN_POSE: u32 = 6;

/// A rigid pose to start from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StartPose {
    /// `target_from_source`.
    pub pose: RigidTransform,
    /// How much worse than the best it is known to be beforehand; added to its misfit.
    pub excess: f64,
    /// The index of the start that was rotated about the axis about which the source is most nearly round to give this one.
    pub rotation_of: Option<usize>,
}

impl StartPose {
    /// A start that is as good as any and was found as it is.
    pub(super) fn of(pose: RigidTransform) -> StartPose {
        StartPose { pose, excess: 0.0, rotation_of: None }
    }
}

/// The first stage's verdict on one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComparedPose {
    /// Index of the pose.
    pub pose: usize,
    /// The rigid part of a start from bending-invariant forms, which is none of the poses.
    pub of_form: Option<RigidTransform>,
    /// The energy of near isometries of that start, a mean over its variables; none of straightened surfaces.
    pub energy: Option<f64>,
    /// Whether it mirrors.
    pub mirrored: bool,
    /// Misfit after the deformation: mean of `−ln` of the likelihood of the other surface at each point. Lower is better.
    pub misfit: f64,
    /// What is known of it beyond this misfit.
    pub finer: Finer,
}

/// What a closer look at a start says than the misfit of the first stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Finer {
    /// There was none: the misfit of the first stage has to tell.
    None,
    /// It ended where a better one did, in the first stage.
    Same,
    /// The energy of near isometries, or the misfit at the scale of the sampling, has decided against it.
    Outdone,
    /// It went through all stages, and ends elsewhere with as low a misfit at the scale of the sampling.
    AsGood,
}

impl Displacement<'_> {
    /// The poses that were followed, the best one that may be kept first, and the field of that one.
    pub(super) fn coarse(
        &self,
        poses: &[StartPose],
        may_answer: impl Fn(&RigidTransform) -> bool,
    ) -> Result<Option<(Vec<ComparedPose>, State)>, MatchError> {
        let Some(followed) = self.screened(poses)? else { return Ok(None) };
        let n = self.options.n_samples[0];
        let (source, target) = (self.source.thinned(n), self.target.thinned(n).packed());
        let values = self.guides.below(self.functions.values(&source.points));
        // Each pose alone, so that all cores have work where a step is too short to share.
        let found: Vec<Option<(f64, State)>> = followed
            .par_iter()
            .map(|&pose| {
                checkpoint(self.observer)?;
                Ok(self.coarse_from(
                    &Base::rigid(poses[pose].pose),
                    &source,
                    &target,
                    &values,
                    self.pace(0, self.options.steps[0]),
                ))
            })
            .collect::<Result<_, MatchError>>()?;
        let mut best: Option<State> = None;
        let mut compared: Vec<ComparedPose> = Vec::new();
        let mut ends: Vec<(usize, RigidTransform)> = Vec::new();
        for (&pose, found) in followed.iter().zip(found) {
            let Some((misfit, state)) = found else { return Ok(None) };
            let StartPose { excess, rotation_of, .. } = poses[pose];
            let misfit = misfit + excess + rotation_of.map_or(0.0, |_| LEAST_GAIN_OF_ROTATION);
            if self.same_place.is_some() {
                let moved = displaced(&state.base.moved(&source.points, &values), &state.field, &values);
                let start = poses[pose].pose;
                let (weights, mirrored) = (Some(&source.counted[..]), start.is_reflection());
                let end = absolute_orientation_of(&source.points, &moved, weights, mirrored);
                ends.push((pose, end.unwrap_or(start)));
            }
            if may_answer(&poses[pose].pose)
                && compared.iter().all(|j| misfit < j.misfit || !may_answer(&poses[j.pose].pose))
            {
                best = Some(state);
            }
            compared.push(ComparedPose {
                pose,
                of_form: None,
                energy: None,
                mirrored: poses[pose].pose.is_reflection(),
                misfit,
                finer: Finer::None,
            });
        }
        compared.sort_by(|a, b| {
            let rank = |j: &ComparedPose| !may_answer(&poses[j.pose].pose);
            rank(a).cmp(&rank(b)).then(a.misfit.total_cmp(&b.misfit)).then(a.pose.cmp(&b.pose))
        });
        // A start and its rotation are one pose, of which the better is kept.
        let is_rotation = |a: &ComparedPose, b: &ComparedPose| poses[a.pose].rotation_of == Some(b.pose);
        let mut kept: Vec<ComparedPose> = Vec::with_capacity(compared.len());
        for start in compared {
            if !kept.iter().any(|better| is_rotation(better, &start) || is_rotation(&start, better)) {
                kept.push(start);
            }
        }
        let mut compared = kept;
        let end_of = |j: &ComparedPose| ends.iter().find(|(pose, _)| *pose == j.pose).map(|(_, end)| end);
        for k in 1..compared.len() {
            let (better, others) = compared.split_at_mut(k);
            let other = &mut others[0];
            let is_reached = |better: &ComparedPose| match (end_of(better), end_of(other)) {
                (Some(a), Some(b)) => better.mirrored == other.mirrored && self.are_same(a, b, SAME_POSE_ANGLE),
                _ => false,
            };
            if better.iter().any(is_reached) {
                other.finer = Finer::Same;
            }
        }
        Ok(best.map(|state| (compared, state)))
    }

    /// Whether two poses of one handedness are the same within `angle`, radians.
    pub(super) fn are_same(&self, a: &RigidTransform, b: &RigidTransform, angle: f64) -> bool {
        self.same_place.unwrap_or_else(SamePose::of_orientation).holds(a, b, angle)
    }

    /// The field from one pose alone, which an earlier fit has found.
    pub(super) fn coarse_alone(&self, pose: &RigidTransform) -> Option<State> {
        let n = self.options.n_samples[0];
        let (source, target) = (self.source.thinned(n), self.target.thinned(n).packed());
        let values = self.guides.below(self.functions.values(&source.points));
        let found =
            self.coarse_from(&Base::rigid(*pose), &source, &target, &values, self.pace(0, STEPS_FROM_KNOWN_POSE));
        found.map(|(_, state)| state)
    }

    /// The poses to follow, after a few steps on few vertices from each: the best of each handedness, and of a rotation the pose that
    /// was rotated.
    fn screened(&self, poses: &[StartPose]) -> Result<Option<Vec<usize>>, MatchError> {
        let misfit = self.screening();
        let screened: Vec<Option<(f64, usize)>> = poses
            .par_iter()
            .enumerate()
            .map(|(k, pose)| {
                checkpoint(self.observer)?;
                Ok(misfit(&pose.pose).map(|misfit| (misfit + pose.excess, k)))
            })
            .collect::<Result<_, MatchError>>()?;
        let Some(mut screened) = screened.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
        screened.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut followed: Vec<usize> = Vec::new();
        for (_, k) in screened {
            let alike = |&&other: &&usize| poses[other].pose.is_reflection() == poses[k].pose.is_reflection();
            let near = |&&other: &&usize| self.are_same(&poses[other].pose, &poses[k].pose, SAME_POSE);
            let same_handedness: Vec<&usize> = followed.iter().filter(alike).collect();
            // Places in one orientation leave room for another orientation.
            let has_orientation_of = |other: usize| {
                move |&&a: &&usize| SamePose::of_orientation().holds(&poses[a].pose, &poses[other].pose, SAME_POSE)
            };
            let has_room = same_handedness.len() < FOLLOWED
                || same_handedness.len() == FOLLOWED
                    && same_handedness.iter().all(has_orientation_of(*same_handedness[0]))
                    && !same_handedness.iter().any(has_orientation_of(k));
            if has_room && !same_handedness.iter().any(near) {
                followed.push(k);
            }
        }
        // Few vertices do not show whether a rotation about that axis is better than none, so the pose itself is followed too.
        for k in followed.clone() {
            let own = poses[k].rotation_of;
            followed.extend(own.filter(|own| !followed.contains(own)));
        }
        Ok(Some(followed))
    }

    /// The misfit after a few steps on few vertices from a pose; `None` where a number is not finite.
    pub(super) fn screening(&self) -> impl Fn(&RigidTransform) -> Option<f64> + Sync {
        let source = self.source.thinned(SCREENING_SAMPLES);
        let target = self.target.thinned(SCREENING_SAMPLES).packed();
        let values = self.guides.below(self.functions.values(&source.points));
        move |pose| {
            // An order of the poses needs no field that has settled.
            let pace = Pace::new(SCREENING_STEPS, 0, self.lengths.root_mm);
            self.coarse_from(&Base::rigid(*pose), &source, &target, &values, pace).map(|(misfit, _)| misfit)
        }
    }

    /// The misfit and the field over `base_of` after the steps of `pace`.
    pub(super) fn coarse_from(
        &self,
        base_of: &Base,
        source: &Thinned,
        target: &AssignmentTarget,
        values: &Mat<f64>,
        mut pace: Pace,
    ) -> Option<(f64, State)> {
        let base = base_of.moved(&source.points, values);
        let guided = self.guides.observations(base_of);
        let mut normals: Vec<Vector3<f64>> = source.normals.iter().map(|n| base_of.pose.rotation * n).collect();
        // Of a bent base the normals are those of the whole deformed surface; the field over a rigid one hardly turns them.
        let mut whole = None;
        if base_of.bend.is_some() {
            let values = self.functions.values(self.source.mesh.vertices());
            let moved = base_of.moved(self.source.mesh.vertices(), &values);
            normals = self.normals_at(moved.clone(), source)?;
            whole = Some((values, moved));
        }
        let mut moved = base.clone();
        let [sigma, last_sigma, ..] = self.options.sigma;
        let mut precision = precision_of_features(&[1.0; N_FEATURES]);
        let mut field = None;
        while let Some(at) = pace.next() {
            let sigma = annealed(sigma, last_sigma, at);
            let samples = OrientedPoints { points: &moved, normals: &normals, ..source.samples() };
            let found = assign(&samples, target, &kernel(sigma * self.diagonal_mm, precision));
            let weight = self.density(0, 1, at) / (sigma * self.diagonal_mm).powi(2);
            let observed = [observed_means(&found, &base, &source.counted, weight), guided.clone()].concat();
            let fitted = fit_field(values.as_ref(), &observed)?;
            let after = displaced(&base, &fitted, values);
            pace.note(&moved, &after);
            moved = after;
            if let Some((values, base)) = &whole {
                normals = self.normals_at(displaced(base, &fitted, values), source)?;
            }
            precision = precision_of_features(&found.feature_variance);
            field = Some(fitted);
        }
        // The same precisions for all poses: a wrong pose that has come to distrust features must not gain by that.
        let samples = OrientedPoints { points: &moved, normals: &normals, ..source.samples() };
        let misfit = misfit(&samples, target, &comparison_kernel(last_sigma * self.diagonal_mm))
            + field.as_ref().map_or(0.0, |field| self.guides.misfit(base_of, field));
        field.map(|field| (misfit, State { base: base_of.clone(), field, feature_precision: precision }))
    }

    /// Normals, at `thinned`, of the surface with its vertices at `moved`. `None` where a number is not finite.
    fn normals_at(&self, moved: Vec<Point3<f64>>, thinned: &Thinned) -> Option<Vec<Vector3<f64>>> {
        let normals = self.source.mesh.with_vertices(moved).ok()?.vertex_normals();
        Some(thinned.vertices.iter().map(|&i| normals[i]).collect())
    }
}
