//! Rivals: whether another start explains both surfaces as well as the best start, or better.
//!
//! Two starts are compared patch by patch. After the wide field of each, the surfaces are divided into patches about as
//! wide as the correlation of residuals. The mean over a patch of `−ln` of the likelihood is one observation, and the
//! differences between the two starts over all patches are tested against zero. Where both poses are right, the
//! differences have either sign and the size of sampling noise; a wrong pose is worse in many patches. Evidence is thus
//! measured in standard errors, independent of shape, noise and deformation.
//!
//! Source: Student's paired t test; Vuong, "Likelihood ratio tests for model selection and non-nested hypotheses",
//! 1989.

use super::base::State;
use super::deformation_evidence::{deformation_evidence, lead, resolution_mm};
use super::displacement::FitContext;
use super::fine::fine_aside;
use super::fine_misfit::{COMPARISON_SAMPLES, COMPARISON_SCALE};
use super::fitted::pose_of;
use super::track::placed;
use crate::error::MatchError;
use crate::pair::assignment::{comparison_kernel, displaced};
use crate::poses::compared::{ComparedPose, ComparisonOutcome};
use crate::surface::robust::mean_over_standard_error;
use homolog_primitives::points::FarthestPoints;
use homolog_registration::alignment::{OrientedPoints, point_misfits};
use homolog_registration::deformation::HeightEvidence;
use homolog_registration::{RigidTransform, SAME_POSE_ANGLE};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::sync::OnceLock;

/// Patches per surface.
const PATCHES: usize = 64;
/// Standard errors of the mean difference from which one of two starts is better; a chance of one in two thousand.
const DISTINCT_STARTS: f64 = 3.5;

/// Standard errors from which a bent answer is preferred to the answer of a rigid start: the usual two, because a wrong
/// choice between answers of nearly equal likelihood costs little.
pub(crate) const PREFERRED: f64 = 2.0;

/// Standard errors from which a start is ruled out after the coarse stage: finer stages change less.
const RULED_OUT: f64 = 8.0;

/// Unexplained residual of a start: the mean of `−ln` of the likelihood over each patch of both surfaces.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unexplained(Vec<f64>);

/// Result of the comparison of two starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Preference {
    /// The first explains more.
    First,
    /// The second explains more.
    Second,
    /// Their difference is within chance.
    Equal,
}

impl Unexplained {
    /// Mean difference from `other` in standard errors; positive if `other` explains more.
    pub(crate) fn excess_over(&self, other: &Unexplained) -> f64 {
        let differences: Vec<f64> = self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect();
        mean_over_standard_error(&differences)
    }

    pub(crate) fn evidence(&self, other: &Unexplained) -> Preference {
        let excess = self.excess_over(other);
        if excess > DISTINCT_STARTS {
            Preference::Second
        } else if excess < -DISTINCT_STARTS {
            Preference::First
        } else {
            Preference::Equal
        }
    }
}

/// Whether the first of two correspondences is better than the second, which leaves more unexplained by `excess`
/// standard errors and falls behind by `lead` in another measure: the energy of labels, or the deformation that is
/// needed. Both count as independent numbers of variance 1.
pub(crate) fn is_distinct(excess: f64, lead: f64) -> bool {
    (excess + lead) / std::f64::consts::SQRT_2 > DISTINCT_STARTS
}

/// A start with its field after the coarse stage.
pub(crate) struct Candidate {
    pub compared: ComparedPose,
    pub pose: RigidTransform,
    pub state: State,
}

/// The pose from which the displacement continues.
pub(crate) struct Chosen {
    pub pose: RigidTransform,
    /// The field over it after the coarse stage.
    pub state: State,
    /// The starts that were compared, the chosen one first.
    pub compared: Vec<ComparedPose>,
}

/// Compares the first of `candidates` with the others: another start of its handedness may explain as much or more, and
/// a start of the other handedness may explain more. The winner comes first. `None` for an empty list.
///
/// Cost: a fine stage for each start that the coarse stage does not rule out.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn compare_candidates(
    displacement: &FitContext<'_>,
    mut candidates: Vec<Candidate>,
) -> Result<Option<Chosen>, MatchError> {
    // A fit with one start, such as the fit in the other direction, has no rival.
    let compared = if candidates.len() > 1 { &candidates[..] } else { &[] };
    let coarse: Vec<Option<Unexplained>> =
        compared.par_iter().map(|candidate| unexplained_coarsely(displacement, candidate)).collect();
    let mut chosen = 0;
    let mut of_chosen: Option<ComparedFit> = None;
    for k in 1..candidates.len() {
        let of_other_hand = candidates[k].compared.mirrored != candidates[0].compared.mirrored;
        if candidates[k].compared.finer != ComparisonOutcome::Undecided {
            continue;
        }
        let (Some(own), Some(other)) = (&coarse[chosen], &coarse[k]) else { continue };
        // A difference this large is not undone by finer stages. A start of the other handedness counts only if it fits
        // better.
        let coarse_excess = other.excess_over(own);
        if coarse_excess > if of_other_hand { 0.0 } else { RULED_OUT } {
            candidates[k].compared.finer = ComparisonOutcome::Outdone;
            continue;
        }
        if of_chosen.is_none() {
            of_chosen = unexplained_finely(displacement, &candidates[chosen])?;
        }
        let (Some(own), Some(found)) = (&of_chosen, unexplained_finely(displacement, &candidates[k])?) else {
            continue;
        };
        let fate = match (own.unexplained.evidence(&found.unexplained), of_other_hand) {
            (_, false) if displacement.are_same(&own.pose, &found.pose, SAME_POSE_ANGLE) => ComparisonOutcome::Same,
            (Preference::First, _) | (Preference::Equal, true) => ComparisonOutcome::Outdone,
            // At a fine scale all poses of two subjects or of noisy surfaces explain about the same; at the coarse scale
            // one may explain less, or it needs the larger deformation.
            (Preference::Equal, false)
                if coarse_excess > DISTINCT_STARTS || own.is_distinct_from(&found, displacement) =>
            {
                ComparisonOutcome::Outdone
            }
            (Preference::Equal, false) => ComparisonOutcome::AsGood,
            (Preference::Second, true) => ComparisonOutcome::Better,
            (Preference::Second, false) => {
                // Starts as good as the previous winner are outdone with it.
                for candidate in &mut candidates[..k] {
                    if matches!(candidate.compared.finer, ComparisonOutcome::Undecided | ComparisonOutcome::AsGood) {
                        candidate.compared.finer = ComparisonOutcome::Outdone;
                    }
                }
                (chosen, of_chosen) = (k, Some(found));
                ComparisonOutcome::Undecided
            }
        };
        candidates[k].compared.finer = fate;
    }
    if candidates.is_empty() {
        return Ok(None);
    }
    candidates[..=chosen].rotate_right(1);
    let compared = candidates.iter().map(|candidate| candidate.compared).collect();
    Ok(candidates.into_iter().next().map(|Candidate { pose, state, .. }| Chosen { pose, state, compared }))
}

/// Where a start ends after a fine stage.
struct ComparedFit {
    unexplained: Unexplained,
    /// The vertices of the source there, and their rigid part.
    moved: Vec<Point3<f64>>,
    pose: RigidTransform,
    /// Its deformation, once it has been compared; the chosen end is compared with several.
    deformation: OnceLock<Option<HeightEvidence>>,
}

impl ComparedFit {
    fn deformation(&self, displacement: &FitContext<'_>) -> Option<&HeightEvidence> {
        self.deformation.get_or_init(|| deformation_evidence(displacement, &self.moved, &self.pose)).as_ref()
    }

    /// Whether this end is better than `other` by what both leave unexplained and by their deformations together.
    fn is_distinct_from(&self, other: &ComparedFit, displacement: &FitContext<'_>) -> bool {
        let lead = match rayon::join(|| self.deformation(displacement), || other.deformation(displacement)) {
            (Some(own), Some(other)) => lead(own, other, resolution_mm(displacement)),
            _ => 0.0,
        };
        is_distinct(other.unexplained.excess_over(&self.unexplained), lead)
    }
}

/// Unexplained residual of the field of the coarse stage, at the scale at which that stage ends.
fn unexplained_coarsely(displacement: &FitContext<'_>, candidate: &Candidate) -> Option<Unexplained> {
    let n = displacement.options.coarse.n_samples;
    let (thinned, target) = (displacement.source.thinned(n), displacement.target.thinned(n));
    let values = displacement.functions.values(&thinned.points);
    let State { base, field, .. } = &candidate.state;
    let moved = displaced(&base.moved(&thinned.points, &values), field, &values);
    let normals: Vec<Vector3<f64>> = thinned.normals.iter().map(|n| candidate.pose.rotation * n).collect();
    let kernel = comparison_kernel(displacement.options.coarse.sigma[1] * displacement.diagonal_mm);
    let samples = OrientedPoints { points: &moved, normals: &normals, ..thinned.samples() };
    let found = point_misfits(&samples, &target.assignment_target(), &kernel);
    let mut patches = patch_means(&thinned.points, &thinned.areas, &found.of_source);
    patches.extend(patch_means(&target.points, &target.areas, &found.of_target));
    Some(Unexplained(patches))
}

/// The end of a start after a fine stage; `None` if a number is not finite.
fn unexplained_finely(displacement: &FitContext<'_>, candidate: &Candidate) -> Result<Option<ComparedFit>, MatchError> {
    let Some(fine) = fine_aside(displacement, candidate.state.clone())? else { return Ok(None) };
    let moved = fine.moved();
    let pose = pose_of(displacement, &moved, &candidate.pose);
    let unexplained = unexplained(displacement, &moved, candidate.compared.mirrored);
    Ok(unexplained.map(|unexplained| ComparedFit { unexplained, moved, pose, deformation: OnceLock::new() }))
}

/// Unexplained residual with the vertices of the source at `moved`; `mirrored`: whether the pose mirrors the source.
pub(crate) fn unexplained(displacement: &FitContext<'_>, moved: &[Point3<f64>], mirrored: bool) -> Option<Unexplained> {
    let thinned = displacement.source.thinned(COMPARISON_SAMPLES);
    // At the scale of the sampling, or of the noise if that is larger.
    let scale_mm = COMPARISON_SCALE * displacement.lengths.root_mm * displacement.source.coarsening;
    let kernel = comparison_kernel(scale_mm);
    let placed = placed(displacement, moved, mirrored, &thinned)?;
    let samples = OrientedPoints { points: &placed.points, normals: &placed.normals, ..thinned.samples() };
    let found = point_misfits(&samples, &displacement.target.assignment_target(), &kernel);
    let (mut of_source, of_target) = rayon::join(
        || patch_means(&thinned.points, &thinned.areas, &found.of_source),
        || patch_means(displacement.target.mesh.vertices(), &displacement.target.areas, &found.of_target),
    );
    of_source.extend(of_target);
    Some(Unexplained(of_source))
}

/// Means of `values` over patches of a surface with these points, weighted by area.
fn patch_means(points: &[Point3<f64>], areas: &[f64], values: &[f64]) -> Vec<f64> {
    let center = points.iter().fold(Vector3::zeros(), |sum, p| sum + p.coords) / points.len() as f64;
    let mut sampling = FarthestPoints::new(points, Point3::from(center));
    sampling.extend_to(PATCHES);
    let mut sums = vec![[0.0; 2]; PATCHES];
    for ((patch, area), value) in sampling.nearest_samples().zip(areas).zip(values) {
        sums[patch][0] += area * value;
        sums[patch][1] += area;
    }
    sums.iter().filter(|[_, area]| *area > 0.0).map(|[sum, area]| sum / area).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::numbers;

    #[test]
    fn differences_of_either_sign_are_no_evidence_and_differences_of_one_sign_are() {
        let mut number = numbers(3);
        let mut drawn = |shift: f64| Unexplained((0..128).map(|_| number() + shift).collect());
        let mut wrong = 0;
        for _ in 0..300 {
            wrong += u32::from(drawn(0.0).evidence(&drawn(0.0)) != Preference::Equal);
        }
        assert!(wrong <= 3, "{wrong} of 300");
        assert_eq!(drawn(0.5).evidence(&drawn(0.0)), Preference::Second);
        assert_eq!(drawn(0.0).evidence(&drawn(0.5)), Preference::First);
        // A start has no excess over itself.
        let same = drawn(0.0);
        assert_eq!(same.evidence(&same), Preference::Equal);
    }

    #[test]
    fn means_over_patches_weight_by_area() {
        let points: Vec<Point3<f64>> = (0..640).map(|k| Point3::new(f64::from(k), 0.0, 0.0)).collect();
        let values: Vec<f64> = (0..640).map(f64::from).collect();
        let means = patch_means(&points, &vec![2.0; 640], &values);
        assert_eq!(means.len(), PATCHES);
        assert!(means.iter().all(|m| (0.0..640.0).contains(m)));
        let constant = patch_means(&points, &values, &vec![0.7; 640]);
        assert!(constant.iter().all(|m| (m - 0.7).abs() < 1e-12));
    }
}
