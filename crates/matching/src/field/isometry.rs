//! The fit from near isometries: between surfaces with limbs, and where no rigid start leads to agreement.
//!
//! The labelings of lowest energy of near isometries ([`crate::energy`]), from no start and from extremities
//! ([`crate::starts::extremities`]), are correspondences. Each bends the source onto the target before a field is
//! fitted; the prior of the field applies only to the remaining displacement, so bending has no cost. The functions of
//! the field are smooth along the surface instead of in space ([`super::unbending`]), so that a limb moves
//! independently of a region that it is close to. The stages are those of a rigid start. The correspondences of lowest
//! energy go through all stages, and the one of lowest misfit at the scale of the sampling is kept.

use super::agreement::are_alike;
use super::base::{InitialMap, State};
use super::coarse::coarse_from;
use super::displacement::FitContext;
use super::fine_misfit::fine_misfit;
use super::fitted::FinalField;
use super::functions::Functions;
use super::refine::run_remaining_stages;
use super::rivals::{Unexplained, is_distinct, unexplained};
use super::settings::IsometryFitSettings;
use super::unbending::Unbending;
use crate::energy::inference::InferenceSettings;
use crate::energy::lead::{DISTINCT_LABELINGS, VariableClusters};
use crate::energy::minimize::NearIsometry;
use crate::energy::model::{Isometry, SiteMeasurements};
use crate::energy::settings::IsometrySettings;
use crate::error::MatchError;
use crate::poses::compared::{ComparedPose, ComparisonOutcome, Origin};
use crate::surface::form::BendingInvariantForm;
use crate::surface::side::SurfaceLevel;
use crate::surface::smooth::Subsample;
use faer::Mat;
use homolog_mrf::Labeling;
use homolog_primitives::observe::{Observer, Phase, checkpoint};
use homolog_registration::alignment::AssignmentTarget;
use homolog_registration::deformation::{GaussianKernel, Observation, fit_field};
use homolog_registration::{RigidTransform, absolute_orientation};
use nalgebra::Point3;
use rayon::prelude::*;
use std::sync::Arc;

/// Mean distance of points of the same index, mm; 0 for empty lists.
fn mean_distance(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
    a.iter().zip(b).map(|(p, q)| (p - q).norm()).sum::<f64>() / a.len().max(1) as f64
}

/// Correspondences of low energy, including that of the present answer.
pub(crate) struct LowEnergies<'a> {
    isometry: Isometry<'a>,
    groups: VariableClusters,
    /// Distinct correspondences by increasing energy.
    starts: Vec<NearIsometry>,
    /// Whether no correspondence has a lower energy than that of the present answer.
    pub is_answer_lowest: bool,
}

impl LowEnergies<'_> {
    /// Whether `start` costs significantly more than the lowest.
    fn is_clearly_above_lowest(&self, start: &NearIsometry) -> bool {
        self.starts.first().is_some_and(|lowest| self.groups.lead(&lowest.shares, &start.shares) > DISTINCT_LABELINGS)
    }

    /// Whether the labels of the mirrored source do not cost significantly less. This also holds for a body whose left
    /// and right are alike.
    pub(crate) fn are_of_same_handedness(&self) -> bool {
        match (self.starts.first(), self.isometry.lowest_mirrored()) {
            (Some(lowest), Some(mirrored)) => self.groups.lead(&lowest.shares, &mirrored) > -DISTINCT_LABELINGS,
            (_, None) => true,
            (None, _) => false,
        }
    }
}

/// The correspondences of low energy between `source` and `target`, the surfaces of `displacement`: from no start, from
/// extremities, and from an answer that moves the vertices of the source to `moved`, mm.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn low_energies<'a>(
    displacement: &FitContext<'_>,
    source: &'a SurfaceLevel,
    target: &'a SurfaceLevel,
    moved: &[Point3<f64>],
) -> Result<LowEnergies<'a>, MatchError> {
    let observer = displacement.observer;
    let settings = &displacement.options.isometry;
    checkpoint(observer)?;
    observer.phase(Phase::Inference);
    let of_energy = IsometrySettings::default();
    let (of_source, of_target) = (
        SiteMeasurements::of(&displacement.source, source.sites(), &of_energy),
        SiteMeasurements::of(&displacement.target, target.sites(), &of_energy),
    );
    let isometry = Isometry::new(&of_source, &of_target, of_energy);
    let groups = VariableClusters::new(source.sites(), isometry.variables);
    let image = |&site: &u32| moved[source.sites().vertices[site as usize] as usize];
    let images: Vec<Point3<f64>> = isometry.variables.iter().map(image).collect();
    let own = isometry.of_images(&images);
    let candidates = isometry.candidates(&own);
    let energy = |labeling: &Labeling| isometry.model.energy(labeling).total();
    let is_answer_lowest = candidates.iter().all(|other| energy(other) >= energy(&own));
    let starts: Vec<NearIsometry> =
        candidates.iter().chain([&own]).map(|labeling| isometry.correspondence(labeling)).collect();
    let mut fit = observer.begin();
    starts.iter().for_each(|start| observer.trace_labels(&mut fit, start.mean_energy()));
    let starts = distinct(starts, displacement.lengths.root_mm, settings);
    observer.phase(Phase::Displacement);
    checkpoint(observer)?;
    Ok(LowEnergies { isometry, groups, starts, is_answer_lowest })
}

/// The `starts` of lowest energy, sorted, without duplicates of a correspondence of lower energy.
fn distinct(mut starts: Vec<NearIsometry>, root_mm: f64, settings: &IsometryFitSettings) -> Vec<NearIsometry> {
    starts.sort_by(|a, b| a.energy.total_cmp(&b.energy));
    let mut kept: Vec<NearIsometry> = Vec::new();
    for start in starts {
        if kept.len() < settings.followed
            && kept.iter().all(|other| mean_distance(&start.images, &other.images) > settings.same * root_mm)
        {
            kept.push(start);
        }
    }
    kept
}

/// A displacement whose functions are smooth over the form of the source, with the values that its coarse stage reads.
pub(crate) struct OverForm<'a> {
    displacement: FitContext<'a>,
    thinned: Subsample,
    thinned_target: AssignmentTarget,
    /// Every function at the thinned vertices, and at the landmarks.
    values: Mat<f64>,
}

impl<'a> OverForm<'a> {
    /// `displacement` with functions over the `form` of its source. `None` if a number is not finite.
    pub(crate) fn new(displacement: &'a FitContext<'_>, form: &BendingInvariantForm) -> Option<OverForm<'a>> {
        let mesh = &displacement.source.mesh;
        let settings = &displacement.options.isometry;
        let cells = (mesh.vertices(), &form.place_of[..]);
        let unbending = Arc::new(Unbending::new(&form.places(mesh), &form.points, &form.neighbors, cells));
        let mut prior = displacement.options.prior.of(displacement.diagonal_mm);
        prior.kernels.push(GaussianKernel {
            width_mm: settings.joint_width * displacement.diagonal_mm,
            amplitude_mm: settings.joint_amplitude * displacement.diagonal_mm,
        });
        let functions = Functions::new(mesh.vertices(), prior, settings.n_inducing, Some(unbending))?;
        let displacement = displacement.with_functions(functions);
        let n = displacement.options.coarse.n_samples;
        let (thinned, thinned_target) =
            (displacement.source.thinned(n), displacement.target.thinned(n).assignment_target());
        let values = displacement.guides.below(displacement.functions.values(&thinned.points));
        Some(OverForm { displacement, thinned, thinned_target, values })
    }

    /// The coarse stage over `base`.
    fn coarse(&self, base: &InitialMap) -> Option<(f64, State)> {
        let schedule = self.displacement.schedule(&self.displacement.options.coarse);
        coarse_from(&self.displacement, base, &self.thinned, &self.thinned_target, &self.values, schedule)
    }

    /// Where `run_remaining_stages` moves the vertices of the source, mm.
    fn moved(&self, refined: &FinalField) -> Vec<Point3<f64>> {
        refined.moved(&self.displacement.source.mesh)
    }
}

/// A correspondence that bends the source onto the target, after the coarse stage.
pub(crate) struct BentStart {
    start: NearIsometry,
    misfit: f64,
    state: State,
}

impl BentStart {
    fn compared(&self) -> ComparedPose {
        ComparedPose {
            origin: Origin::Bent(self.state.base.pose),
            mirrored: false,
            misfit: self.misfit,
            finer: ComparisonOutcome::Outdone,
        }
    }
}

/// The coarse stage from the correspondence of lowest energy, and from those that do not cost significantly more, where
/// it is possible.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn bent_starts(over_form: &OverForm<'_>, low: &LowEnergies<'_>) -> Result<Vec<BentStart>, MatchError> {
    let found = low
        .starts
        .par_iter()
        .filter(|start| !low.is_clearly_above_lowest(start))
        .map(|start| {
            checkpoint(over_form.displacement.observer)?;
            let Some(base) = bent(&over_form.displacement, start) else { return Ok(None) };
            let coarse = over_form.coarse(&base);
            Ok(coarse.map(|(misfit, state)| BentStart { start: start.clone(), misfit, state }))
        })
        .collect::<Result<Vec<_>, MatchError>>()?;
    Ok(found.into_iter().flatten().collect())
}

/// The best fit from the near isometries that were followed.
pub(crate) struct BestBent {
    pub end: RefinedIsometry,
    /// The correspondences that were compared, the one kept first.
    pub compared: Vec<ComparedPose>,
}

/// A near isometry after all stages.
pub(crate) struct RefinedIsometry {
    start: NearIsometry,
    pub refined: FinalField,
    /// The vertices of the source where they are moved, mm.
    pub moved: Vec<Point3<f64>>,
    /// The misfit at the scale of the sampling.
    pub misfit: f64,
    pub unexplained: Option<Unexplained>,
}

impl RefinedIsometry {
    fn of(over_form: &OverForm<'_>, start: NearIsometry, refined: FinalField) -> RefinedIsometry {
        let moved = over_form.moved(&refined);
        let misfit = fine_misfit(&over_form.displacement, &moved, false);
        let unexplained = unexplained(&over_form.displacement, &moved, false);
        RefinedIsometry { start, refined, moved, misfit, unexplained }
    }

    /// Whether `other` explains the surfaces as well, though its corresponding points are more than `same_mm` away on
    /// average.
    fn has_rival(&self, other: &RefinedIsometry, groups: &VariableClusters, same_mm: f64) -> bool {
        let (Some(own), Some(others)) = (&self.unexplained, &other.unexplained) else { return false };
        let lead = groups.lead(&self.start.shares, &other.start.shares);
        !is_distinct(others.excess_over(own), lead) && mean_distance(&self.moved, &other.moved) > same_mm
    }
}

/// The best of `starts` after all stages. `None` if all of them distort the source more than curvatures agree, or if no
/// fit succeeds.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn best_of_lowest(
    over_form: &OverForm<'_>,
    starts: Vec<BentStart>,
    low: &LowEnergies<'_>,
) -> Result<Option<BestBent>, MatchError> {
    let displacement = &over_form.displacement;
    if !starts.iter().any(|start| are_alike(displacement, &displacement.source_moved_by(&start.state))) {
        return Ok(None);
    }
    let mut compared: Vec<ComparedPose> = starts.iter().map(BentStart::compared).collect();
    let mut ends: Vec<Option<RefinedIsometry>> = Vec::new();
    for BentStart { start, state, .. } in starts {
        let refined = run_remaining_stages(displacement, state)?;
        ends.push(refined.map(|refined| RefinedIsometry::of(over_form, start, refined)));
    }
    let misfits = ends.iter().enumerate().filter_map(|(k, end)| Some((k, end.as_ref()?.misfit)));
    let Some((chosen, _)) = misfits.min_by(|a, b| a.1.total_cmp(&b.1)) else { return Ok(None) };
    let Some(best) = ends[chosen].take() else { return Ok(None) };
    let same_mm = InferenceSettings::default().inlier * displacement.lengths.root_mm;
    for (start, end) in compared.iter_mut().zip(&ends) {
        if end.as_ref().is_some_and(|end| best.has_rival(end, &low.groups, same_mm)) {
            start.finer = ComparisonOutcome::AsGood;
        }
    }
    compared[chosen].finer = ComparisonOutcome::Undecided;
    compared[..=chosen].rotate_right(1);
    Ok(Some(BestBent { end: best, compared }))
}

/// Repeats all stages from their result `refined`, which has this misfit, while this lowers the misfit.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn iterate_while_improving(
    over_form: &OverForm<'_>,
    mut refined: FinalField,
    mut misfit: f64,
) -> Result<FinalField, MatchError> {
    let displacement = &over_form.displacement;
    let settings = &displacement.options.isometry;
    for _ in 0..settings.passes {
        let Some(base) = rebased(displacement, &refined) else { break };
        let Some((_, state)) = over_form.coarse(&base) else { break };
        let Some(next) = run_remaining_stages(displacement, state)? else { break };
        let of_next = fine_misfit(displacement, &over_form.moved(&next), false);
        let gain = misfit - of_next;
        if gain > 0.0 {
            (misfit, refined) = (of_next, next);
        }
        if gain < settings.least_gain {
            break;
        }
    }
    Ok(refined)
}

/// The source bent by the correspondences of `start`, over their rigid part.
fn bent(displacement: &FitContext<'_>, start: &NearIsometry) -> Option<InitialMap> {
    let pose = absolute_orientation(&start.points, &start.images, None, false).ok()?;
    let precision = (displacement.options.isometry.form_sigma * displacement.diagonal_mm).powi(-2);
    base_through(displacement, pose, &start.points, &start.images, precision)
}

/// The source moved by `run_remaining_stages`, as a base.
fn rebased(displacement: &FitContext<'_>, refined: &FinalField) -> Option<InitialMap> {
    let moved = refined.moved(&displacement.source.mesh);
    let precision = (displacement.options.isometry.rebased_sigma * displacement.diagonal_mm).powi(-2);
    base_through(displacement, refined.base.pose, displacement.source.mesh.vertices(), &moved, precision)
}

/// The base over `pose` that moves `points` to their `images` (mm), each with a precision, 1/mm².
fn base_through(
    displacement: &FitContext<'_>,
    pose: RigidTransform,
    points: &[Point3<f64>],
    images: &[Point3<f64>],
    precision: f64,
) -> Option<InitialMap> {
    let observed: Vec<Observation> =
        points.iter().zip(images).map(|(p, q)| Observation::isotropic(q - pose.apply(p), precision)).collect();
    let field = fit_field(displacement.functions.values(points).as_ref(), &observed)?;
    Some(InitialMap::rigid(pose).with_field(&field))
}
