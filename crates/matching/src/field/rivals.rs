//! Rivals: whether another start explains both surfaces as well as the best start, or better.
//!
//! Two starts are compared patch by patch. After the wide field of each, the surfaces are divided into patches about as
//! wide as the correlation of residuals. The mean over a patch of `−ln` of the likelihood is one observation, and the
//! differences between the two starts over all patches are tested against zero. Where both poses are right, the
//! differences have either sign and the size of sampling noise; a wrong pose is worse in many patches. Both surfaces
//! show the same residual, so their standard errors are added as those of one number. Evidence is thus measured in
//! standard errors, independent of shape, noise and deformation.
//!
//! Residuals of one kind are not independent everywhere: the edges of a cube are chamfered alike by the grid from which
//! it was extracted, whichever of its poses is right. So another start is worse only if the deformation that it needs
//! agrees with what it leaves unexplained.
//!
//! Source: Student's paired t test; Vuong, "Likelihood ratio tests for model selection and non-nested hypotheses",
//! 1989.

use super::agreement::are_alike;
use super::base::State;
use super::coarse::CoarseStage;
use super::deformation_evidence::{deformation_evidence, lead, resolution_mm};
use super::displacement::FitContext;
use super::fine::fine_aside;
use super::fine_misfit::{COMPARISON_SAMPLES, COMPARISON_SCALE};
use super::fitted::{FineStageFit, pose_of};
use super::trace::TracedFit;
use super::track::{Placed, placed};
use crate::error::MatchError;
use crate::pair::assignment::comparison_kernel;
use crate::poses::compared::{ComparedPose, ComparisonOutcome};
use crate::surface::robust::mean_and_standard_error;
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

/// Standard errors from which a start, or a bent answer, is preferred to the one before it: the usual two, because a
/// wrong choice between answers of nearly equal likelihood costs little.
pub(crate) const PREFERRED: f64 = 2.0;

/// Standard errors from which a start is ruled out by residuals alone: what comes later changes less.
const RULED_OUT: f64 = 8.0;

/// Unexplained residual of a start: the mean of `−ln` of the likelihood over each patch of both surfaces.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unexplained {
    of_source: Vec<f64>,
    of_target: Vec<f64>,
}

impl Unexplained {
    /// Mean difference from `other` in standard errors; positive if `other` explains more.
    pub(crate) fn excess_over(&self, other: &Unexplained) -> f64 {
        let differences = |own: &[f64], other: &[f64]| {
            mean_and_standard_error(&own.iter().zip(other).map(|(a, b)| a - b).collect::<Vec<f64>>())
        };
        let (of_source, error_of_source) = differences(&self.of_source, &other.of_source);
        let (of_target, error_of_target) = differences(&self.of_target, &other.of_target);
        (of_source + of_target) / (error_of_source + error_of_target).max(f64::MIN_POSITIVE)
    }

    /// Whether `better` explains significantly more.
    pub(crate) fn is_worse_than(&self, better: &Unexplained) -> bool {
        self.excess_over(better) > DISTINCT_STARTS
    }
}

/// Whether the first of two correspondences is better than the second, which leaves more unexplained by `excess`
/// standard errors and falls behind by `lead` in another measure: the energy of labels, or the deformation that is
/// needed. Both count as independent numbers of variance 1.
pub(crate) fn is_distinct(excess: f64, lead: f64) -> bool {
    (excess + lead) / std::f64::consts::SQRT_2 > DISTINCT_STARTS
}

/// The outcome of a comparison, given that of what two ends explain, and whether the shapes are alike at the chosen end
/// alone, which is asked only if the other end is an alternative.
fn unless_unlike(explained: ComparisonOutcome, is_alone: impl FnOnce() -> bool) -> ComparisonOutcome {
    let is_alternative = matches!(explained, ComparisonOutcome::AsGood | ComparisonOutcome::Better);
    if is_alternative && is_alone() { ComparisonOutcome::Outdone } else { explained }
}

/// A start with its field after the coarse stage.
pub(crate) struct Candidate {
    pub compared: ComparedPose,
    pub state: State,
    /// Where it ends after the fine stage, if it was compared there.
    pub fit: Option<ComparedFit>,
}

/// Candidates after their comparison.
pub(crate) struct Comparison {
    /// The candidates, the winner first.
    pub candidates: Vec<Candidate>,
    /// Rigid parts of the ends of the winner and of those that explain both surfaces about as well, of either
    /// handedness; empty if no other pose of the winner's handedness does.
    pub as_good: Vec<RigidTransform>,
}

/// Compares the first of `candidates` with the others: another start of its handedness may explain as much or more, and
/// a start of the other handedness may explain more.
///
/// Cost: a fine stage for each start that the coarse stage does not rule out.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn compare_candidates(
    coarse: &CoarseStage<'_>,
    mut candidates: Vec<Candidate>,
) -> Result<Comparison, MatchError> {
    let displacement = coarse.displacement;
    let chosen = chosen_of(coarse, &mut candidates)?;
    if !candidates.is_empty() {
        candidates[..=chosen].rotate_right(1);
    }
    let mut as_good = Vec::new();
    if let Some((Candidate { fit: Some(own), .. }, others)) = candidates.split_first_mut() {
        for Candidate { compared, fit, .. } in &mut *others {
            if compared.finer == ComparisonOutcome::Undecided
                && let Some(fit) = fit
            {
                compared.finer = own.compared_with(fit, displacement);
            }
        }
        if others.iter().any(|other| other.compared.finer == ComparisonOutcome::AsGood) {
            as_good.push(own.pose);
            for Candidate { compared, fit, .. } in others {
                let Some(fit) = fit else { continue };
                let is_of_other_hand = fit.pose.is_reflection() != own.pose.is_reflection();
                if compared.finer == ComparisonOutcome::AsGood
                    || is_of_other_hand && !own.is_distinct_from(fit, displacement)
                {
                    as_good.push(fit.pose);
                }
            }
        }
    }
    Ok(Comparison { candidates, as_good })
}

/// The index of the candidate that explains most. Those that it has to be compared with get a fine stage, the others are
/// outdone.
fn chosen_of(coarse: &CoarseStage<'_>, candidates: &mut [Candidate]) -> Result<usize, MatchError> {
    // A single start has no rival.
    let compared = if candidates.len() > 1 { &candidates[..] } else { &[] };
    let coarsely: Vec<Unexplained> = compared.par_iter().map(|c| unexplained_coarsely(coarse, &c.state)).collect();
    let mut chosen = 0;
    for k in 1..candidates.len() {
        let of_other_hand = candidates[k].compared.mirrored != candidates[0].compared.mirrored;
        if candidates[k].compared.finer != ComparisonOutcome::Undecided {
            continue;
        }
        // A difference this large is not undone by finer stages. A start of the other handedness counts only if it fits
        // better.
        if coarsely[k].excess_over(&coarsely[chosen]) > if of_other_hand { 0.0 } else { RULED_OUT } {
            candidates[k].compared.finer = ComparisonOutcome::Outdone;
            continue;
        }
        let missing = |k: usize| match candidates[k].fit {
            Some(_) => Ok(None),
            None => unexplained_finely(coarse, &candidates[k]),
        };
        let (of_chosen, of_other) = rayon::join(|| missing(chosen), || missing(k));
        for (k, found) in [(chosen, of_chosen?), (k, of_other?)] {
            if found.is_some() {
                candidates[k].fit = found;
            }
        }
        let (Some(own), Some(found)) = (&candidates[chosen].fit, &candidates[k].fit) else { continue };
        if !of_other_hand && own.unexplained.excess_over(&found.unexplained) > PREFERRED {
            chosen = k;
        }
    }
    Ok(chosen)
}

/// Where a start ends after a fine stage.
pub(crate) struct ComparedFit {
    pub fine: FineStageFit,
    unexplained: Unexplained,
    /// The same at the scale at which the coarse stage ends. At a fine scale all poses of two subjects or of noisy
    /// surfaces leave about the same unexplained.
    at_coarse_scale: Unexplained,
    /// The vertices of the source there, and their rigid part.
    moved: Vec<Point3<f64>>,
    pose: RigidTransform,
    /// Its deformation, once it has been compared; the chosen end is compared with several.
    deformation: OnceLock<Option<HeightEvidence>>,
    /// Whether the shapes are alike there, once that has been asked.
    alike: OnceLock<bool>,
}

impl ComparedFit {
    fn deformation(&self, displacement: &FitContext<'_>) -> Option<&HeightEvidence> {
        self.deformation.get_or_init(|| deformation_evidence(displacement, &self.moved, &self.pose)).as_ref()
    }

    fn is_alike(&self, displacement: &FitContext<'_>) -> bool {
        *self.alike.get_or_init(|| are_alike(displacement, &self.moved))
    }

    /// The result of the comparison of this end, the chosen one, with another. An end at which the shapes are not alike
    /// is no alternative to one at which they are: what a pose leaves unexplained, and the deformation along the normals,
    /// are small also where a map folds the source onto a part of the target.
    fn compared_with(&self, other: &ComparedFit, displacement: &FitContext<'_>) -> ComparisonOutcome {
        let explained = self.explained_with(other, displacement);
        unless_unlike(explained, || self.is_alike(displacement) && !other.is_alike(displacement))
    }

    /// The result of the comparison by what both ends explain.
    fn explained_with(&self, other: &ComparedFit, displacement: &FitContext<'_>) -> ComparisonOutcome {
        if self.pose.is_reflection() != other.pose.is_reflection() {
            return if self.unexplained.is_worse_than(&other.unexplained) {
                ComparisonOutcome::Better
            } else {
                ComparisonOutcome::Outdone
            };
        }
        if displacement.are_same(&self.pose, &other.pose, SAME_POSE_ANGLE) {
            ComparisonOutcome::Same
        } else if self.is_distinct_from(other, displacement) {
            ComparisonOutcome::Outdone
        } else {
            ComparisonOutcome::AsGood
        }
    }

    /// Whether this end is better than `other` by what both leave unexplained, at the scale at which they differ most,
    /// and by their deformations together.
    fn is_distinct_from(&self, other: &ComparedFit, displacement: &FitContext<'_>) -> bool {
        let excess = other.unexplained.excess_over(&self.unexplained);
        let excess = excess.max(other.at_coarse_scale.excess_over(&self.at_coarse_scale));
        if excess > RULED_OUT {
            return true;
        }
        let lead = match rayon::join(|| self.deformation(displacement), || other.deformation(displacement)) {
            (Some(own), Some(other)) => lead(own, other, resolution_mm(displacement)),
            _ => 0.0,
        };
        is_distinct(excess, lead)
    }
}

/// Unexplained residual of a field over a rigid pose, at the scale at which the coarse stage ends.
pub(crate) fn unexplained_coarsely(coarse: &CoarseStage<'_>, state: &State) -> Unexplained {
    let points = state.moved(&coarse.source.points, &coarse.values);
    let normals = coarse.source.normals.iter().map(|n| state.base.pose.rotation * n).collect();
    at_coarse_scale(coarse, &Placed { points, normals })
}

/// Unexplained residual of the source of the coarse stage at `placed`, at the scale at which that stage ends.
fn at_coarse_scale(coarse: &CoarseStage<'_>, placed: &Placed) -> Unexplained {
    let CoarseStage { displacement, source, target, assignment_target, .. } = coarse;
    let kernel = comparison_kernel(displacement.options.coarse.sigma[1] * displacement.diagonal_mm);
    let samples = OrientedPoints { points: &placed.points, normals: &placed.normals, ..source.samples() };
    let found = point_misfits(&samples, assignment_target, &kernel);
    Unexplained {
        of_source: patch_means(&source.points, &source.areas, &found.of_source),
        of_target: patch_means(&target.points, &target.areas, &found.of_target),
    }
}

/// The end of a start after a fine stage; `None` if a number is not finite.
fn unexplained_finely(coarse: &CoarseStage<'_>, candidate: &Candidate) -> Result<Option<ComparedFit>, MatchError> {
    let displacement = coarse.displacement;
    let fit = Some(TracedFit::candidate());
    let Some(fine) = fine_aside(displacement, candidate.state.clone(), fit)? else { return Ok(None) };
    let moved = fine.moved();
    let mirrored = candidate.compared.mirrored;
    let Some(placed) = placed(displacement, &moved, mirrored, &coarse.source) else { return Ok(None) };
    let Some(unexplained) = unexplained(displacement, &moved, mirrored) else { return Ok(None) };
    Ok(Some(ComparedFit {
        fine,
        unexplained,
        at_coarse_scale: at_coarse_scale(coarse, &placed),
        pose: pose_of(displacement, &moved, &candidate.state.base.pose),
        moved,
        deformation: OnceLock::new(),
        alike: OnceLock::new(),
    }))
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
    let (of_source, of_target) = rayon::join(
        || patch_means(&thinned.points, &thinned.areas, &found.of_source),
        || patch_means(displacement.target.mesh.vertices(), &displacement.target.areas, &found.of_target),
    );
    Some(Unexplained { of_source, of_target })
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
        let mut patches = |shift: f64| (0..PATCHES).map(|_| number() + shift).collect::<Vec<f64>>();
        let mut drawn = |shift: f64| Unexplained { of_source: patches(shift), of_target: patches(shift) };
        let mut wrong = 0;
        for _ in 0..300 {
            wrong += u32::from(drawn(0.0).excess_over(&drawn(0.0)).abs() > DISTINCT_STARTS);
        }
        assert!(wrong <= 3, "{wrong} of 300");
        assert!(drawn(0.5).excess_over(&drawn(0.0)) > DISTINCT_STARTS);
        assert!(drawn(0.0).excess_over(&drawn(0.5)) < -DISTINCT_STARTS);
        // A start has no excess over itself.
        let same = drawn(0.0);
        assert_eq!(same.excess_over(&same), 0.0);
    }

    #[test]
    fn what_a_start_leaves_unexplained_counts_only_as_far_as_its_deformation_agrees() {
        assert!(is_distinct(4.0, 3.0) && is_distinct(0.0, 6.0));
        assert!(!is_distinct(4.5, -0.8) && !is_distinct(2.8, 0.7));
    }

    #[test]
    fn an_end_at_which_the_shapes_are_not_alike_is_no_alternative() {
        use ComparisonOutcome::{AsGood, Better, Outdone, Same};
        for explained in [AsGood, Better] {
            assert_eq!(unless_unlike(explained, || true), Outdone);
            assert_eq!(unless_unlike(explained, || false), explained);
        }
        for explained in [Outdone, Same] {
            assert_eq!(unless_unlike(explained, || unreachable!("asked only of alternatives")), explained);
        }
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
