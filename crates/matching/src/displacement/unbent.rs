//! The second attempt: from bending-invariant forms and from extremities, where no rigid start leads to surfaces that agree, and between
//! surfaces with limbs.
//!
//! Correspondences of the forms ([`super::forms`]) and of extremities ([`super::extremities`]) are corrected and ordered by the energy
//! of near isometries ([`super::isometry`]). Each bends the source onto the target before a field is fitted: bending costs nothing, and the prior of
//! the field is that of what remains. Its functions are smooth along the surface instead of through space
//! ([`super::unbending`]), so that a limb moves apart from what it happens to be close to. The stages are those of a rigid
//! start. Those of the lowest energies go through all stages; of them, that with the lowest misfit at the scale of the
//! sampling is kept.

use super::coarse::{ComparedPose, Finer};
use super::fine::Refined;
use super::forms::{Form, form_matches};
use super::functions::Functions;
use super::isometry::{Isometry, NearIsometry};
use super::prior;
use super::stages::{Base, Displacement, State, comparison_kernel};
use super::unbending::Unbending;
use crate::MatchError;
use homolog_primitives::observe::{Observer, Phase, checkpoint};
use homolog_registration::alignment::{OrientedPoints, misfit};
use homolog_registration::deformation::{GaussianKernel, Observation, fit_field};
use homolog_registration::{RigidTransform, absolute_orientation};
use nalgebra::Point3;
use rayon::prelude::*;
use std::sync::Arc;

/// Correspondences that are followed, those of the lowest energies.
const FOLLOWED: usize = 8;
/// Of them, those that go through all stages at most.
const REFINED: usize = 3;
/// Share by which the energy of such a one may be above the lowest. Of bodies in two poses the truth had the lowest energy (40 pairs);
/// with noise of 0.3 edges or a hole of 2 % of the vertices its energy was up to 0.12 above that of limbs exchanged. Of 106 such
/// pairs seven were off by 6 to 26 % of the diagonal with 0.03 and six of them by less than 4 % with 0.2; one, off by 1 %, then by 6.5 %.
const LOW_ENERGY: f64 = 0.2;
/// Mean distance up to which two correspondences count as one, in roots of the area: less than the distance between sites.
const SAME: f64 = 0.03;
/// An energy that is higher by less than this share speaks neither against another answer nor for the mirror image.
const EQUAL_ENERGY: f64 = 0.03;
/// Misfits at the scale of the sampling that differ by less than this do not tell two answers apart; nor do they by less than the
/// second if their energies do not. Answers of hippocampi on ellipsoids, whose symmetries give four, are up to 0.035 apart (12 pairs, all
/// ambiguous); the right answers on bodies and people stay reliable (66 pairs).
const EQUAL_MISFIT: f64 = 0.01;
const EQUAL_MISFIT_OF_EQUAL_ENERGIES: f64 = 0.05;
/// Width and standard deviation of a second kernel, in diagonals: joints are narrower than the bends of one structure.
const JOINT_WIDTH: f64 = 0.12;
const JOINT_AMPLITUDE: f64 = 0.05;
const N_INDUCING: usize = 250;
/// Times that all stages are run again from where they ended, at most.
const PASSES: usize = 6;
/// Fall of the misfit at the scale of the sampling for which they are run once more.
const LEAST_GAIN: f64 = 0.005;
const REBASED_SIGMA: f64 = 0.01;
/// Standard deviation of a correspondence of the forms, in diagonals of the source.
const FORM_SIGMA: f64 = 0.02;
/// Width of the assignment by which the ends of two attempts are compared, in roots of the area: that of the sampling of a
/// surface of about two thousand vertices.
const COMPARISON_SCALE: f64 = 0.02;
/// Vertices of the source that are compared.
const COMPARISON_SAMPLES: usize = 1200;

/// Mean distance of points of the same index, mm; 0 of none.
fn mean_distance(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
    a.iter().zip(b).map(|(p, q)| (p - q).norm()).sum::<f64>() / a.len().max(1) as f64
}

/// The first [`FOLLOWED`] of `starts` by their energy, the lowest first, without those that are the same correspondence as one before
/// them.
fn distinct(mut starts: Vec<NearIsometry>, root_mm: f64) -> Vec<NearIsometry> {
    starts.sort_by(|a, b| a.energy.total_cmp(&b.energy));
    let mut kept: Vec<NearIsometry> = Vec::new();
    for start in starts {
        if kept.len() < FOLLOWED
            && kept.iter().all(|other| mean_distance(&start.images, &other.images) > SAME * root_mm)
        {
            kept.push(start);
        }
    }
    kept
}

/// The best answer from the forms.
pub(super) struct Unbent {
    pub refined: Refined,
    /// The correspondences that were compared, the one that was kept first.
    pub compared: Vec<ComparedPose>,
    /// Whether the energy is no higher than with the source mirrored; so it is for a body whose left and right are alike.
    pub is_of_same_handedness: bool,
}

impl Displacement<'_> {
    /// The best answer from the forms of both surfaces; `None` where they give none whose misfit at the scale of the sampling is lower
    /// than `to_beat`.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(super) fn unbent(&self, source: &Form, target: &Form, to_beat: f64) -> Result<Option<Unbent>, MatchError> {
        checkpoint(self.observer)?;
        let matches = form_matches((&self.source, source), (&self.target, target), self.options);
        checkpoint(self.observer)?;
        self.observer.phase(Phase::Inference);
        let isometry = Isometry::new((&self.source, source), (&self.target, target));
        let starts = isometry.correspondences(&matches);
        let mut fit = self.observer.begin();
        starts.iter().for_each(|start| self.observer.trace_labels(&mut fit, start.mean_energy()));
        let starts = distinct(starts, self.lengths.root_mm);
        self.observer.phase(Phase::Displacement);
        checkpoint(self.observer)?;
        let lowest = starts.first().map_or(f64::INFINITY, |lowest| lowest.energy);
        let Some(on_form) = self.on_form(source) else { return Ok(None) };
        let n = self.options.n_samples[0];
        let (thinned, thinned_target) = (on_form.source.thinned(n), on_form.target.thinned(n).packed());
        let values = on_form.guides.below(on_form.functions.values(&thinned.points));
        let found: Vec<(NearIsometry, f64, State)> = starts
            .into_par_iter()
            .map(|start| {
                checkpoint(self.observer)?;
                let Some(base) = on_form.bent(&start) else { return Ok(None) };
                let coarse = on_form.coarse_from(
                    &base,
                    &thinned,
                    &thinned_target,
                    &values,
                    on_form.pace(0, self.options.steps[0]),
                );
                Ok(coarse.map(|(misfit, state)| (start, misfit, state)))
            })
            .collect::<Result<Vec<_>, MatchError>>()?
            .into_iter()
            .flatten()
            .collect();
        let mut compared: Vec<ComparedPose> = found
            .iter()
            .map(|(start, misfit, state)| ComparedPose {
                pose: usize::MAX,
                of_form: Some(state.base.pose),
                energy: Some(start.mean_energy()),
                mirrored: false,
                misfit: *misfit,
                finer: Finer::Outdone,
            })
            .collect();
        let mut best: Option<(f64, usize, Refined)> = None;
        let mut ends: Vec<(f64, Vec<Point3<f64>>)> = Vec::new();
        let low = found.first().map_or(0.0, |(lowest, ..)| (1.0 + LOW_ENERGY) * lowest.energy);
        for (k, (_, _, state)) in found.into_iter().filter(|(start, ..)| start.energy <= low).take(REFINED).enumerate()
        {
            let Some(refined) = on_form.refined(state)? else {
                ends.push((f64::INFINITY, Vec::new()));
                continue;
            };
            let moved = refined.moved(&self.source.mesh).0;
            let misfit = on_form.fine_misfit(moved.clone(), false);
            ends.push((misfit, moved));
            if best.as_ref().is_none_or(|b| misfit < b.0) {
                best = Some((misfit, k, refined));
            }
        }
        let Some((mut fine_misfit, chosen, mut refined)) = best else { return Ok(None) };
        let energy_of_chosen = compared[chosen].energy;
        for (start, (misfit, moved)) in compared.iter_mut().zip(&ends) {
            let is_elsewhere = mean_distance(moved, &ends[chosen].1) > SAME * self.lengths.root_mm;
            let has_equal_energy =
                start.energy.zip(energy_of_chosen).is_some_and(|(a, b)| a < (1.0 + EQUAL_ENERGY) * b);
            let equal = if has_equal_energy { EQUAL_MISFIT_OF_EQUAL_ENERGIES } else { EQUAL_MISFIT };
            if is_elsewhere && *misfit <= fine_misfit + equal {
                start.finer = Finer::AsGood;
            }
        }
        compared[chosen].finer = Finer::None;
        for _ in 0..PASSES {
            let Some(base) = on_form.rebased(&refined) else { break };
            let Some((_, state)) =
                on_form.coarse_from(&base, &thinned, &thinned_target, &values, on_form.pace(0, self.options.steps[0]))
            else {
                break;
            };
            let Some(next) = on_form.refined(state)? else { break };
            let misfit = on_form.fine_misfit(next.moved(&self.source.mesh).0, false);
            let gain = fine_misfit - misfit;
            if gain > 0.0 {
                (fine_misfit, refined) = (misfit, next);
            }
            if gain < LEAST_GAIN {
                break;
            }
        }
        if fine_misfit >= to_beat {
            return Ok(None);
        }
        compared[..=chosen].rotate_right(1);
        let is_of_same_handedness = lowest <= (1.0 + EQUAL_ENERGY) * isometry.lowest_mirrored(&matches);
        Ok(Some(Unbent { refined, compared, is_of_same_handedness }))
    }

    /// This displacement with functions that are smooth over the form of the source.
    fn on_form(&self, form: &Form) -> Option<Displacement<'_>> {
        let cells = (self.source.mesh.vertices(), &form.site_of[..]);
        let unbending = Unbending::new(&form.places(&self.source), &form.points, &form.neighbors, cells);
        let unbending = Arc::new(unbending);
        let mut prior = prior(self.diagonal_mm, self.options);
        prior.kernels.push(GaussianKernel {
            width_mm: JOINT_WIDTH * self.diagonal_mm,
            amplitude_mm: JOINT_AMPLITUDE * self.diagonal_mm,
        });
        let functions = Functions::new(self.source.mesh.vertices(), prior, N_INDUCING, Some(unbending))?;
        Some(Displacement {
            source: self.source.clone(),
            target: self.target.clone(),
            guides: self.guides.with_functions(&functions),
            functions,
            ..*self
        })
    }

    /// The source bent by correspondences, over their rigid part.
    fn bent(&self, start: &NearIsometry) -> Option<Base> {
        let pose = absolute_orientation(&start.points, &start.images, None, false).ok()?;
        let precision = (FORM_SIGMA * self.diagonal_mm).powi(-2);
        self.base_through(pose, &start.points, &start.images, |_| precision)
    }

    /// The source where `refined` moves it, as a base.
    fn rebased(&self, refined: &Refined) -> Option<Base> {
        let moved = refined.moved(&self.source.mesh).0;
        let precision = (REBASED_SIGMA * self.diagonal_mm).powi(-2);
        self.base_through(refined.base.pose, self.source.mesh.vertices(), &moved, |_| precision)
    }

    /// The base over `pose` that moves `points` to their `images` (mm), each with a precision, 1/mm².
    fn base_through(
        &self,
        pose: RigidTransform,
        points: &[Point3<f64>],
        images: &[Point3<f64>],
        precision: impl Fn(usize) -> f64,
    ) -> Option<Base> {
        let observed: Vec<Observation> = points
            .iter()
            .zip(images)
            .enumerate()
            .map(|(i, (p, q))| Observation::isotropic(q - pose.apply(p), precision(i)))
            .collect();
        let field = fit_field(self.functions.values(points).as_ref(), &observed)?;
        Some(Base::rigid(pose).bent_by(&field))
    }

    /// Misfit at the scale of the sampling of the source with its vertices at `moved`, by a pose that may have mirrored it: mean
    /// of `−ln` of the likelihood of the other surface at each point; lower is better.
    pub(super) fn fine_misfit(&self, moved: Vec<Point3<f64>>, mirrored: bool) -> f64 {
        let thinned = self.source.thinned(COMPARISON_SAMPLES);
        let kernel = comparison_kernel(COMPARISON_SCALE * self.lengths.root_mm);
        self.placed(&moved, mirrored, &thinned).map_or(f64::INFINITY, |placed| {
            let samples = OrientedPoints { points: &placed.points, normals: &placed.normals, ..thinned.samples() };
            misfit(&samples, &self.target.packed(), &kernel)
        })
    }
}
