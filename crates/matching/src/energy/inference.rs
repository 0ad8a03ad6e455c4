//! Inference: belief propagation without a start over the energy of near isometries, of the source and of its mirror
//! image, and RANSAC over the labels, weighted by beliefs.

use super::bias::bias_away_from;
use super::lead::{DISTINCT_LABELINGS, VariableClusters};
use super::model::{Isometry, SiteMeasurements};
use super::settings::IsometrySettings;
use homolog_contract::result::{
    ConvergenceDocument, ConvergenceStatus, EnergyDocument, Feedback, RoundDocument, StopReason,
};
use homolog_mrf::metric::{ActiveBeliefs, ActiveOptions, MetricModel, Semiring};
use homolog_mrf::{Energy, Labeling};
use homolog_primitives::observe::{Cancelled, Observer, Phase, Quantity, Silent, TracePoint, checkpoint};
use homolog_registration::{RansacOptions, RansacReport, RigidTransform, ransac_weighted};
use nalgebra::{Matrix3, Point3, Vector3};

/// Share of the labels that must support a pose for it to be clear.
const CLEAR_SUPPORT: f64 = 0.9;

/// Settings of the minimization of the energy and of the support of a pose.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InferenceSettings {
    /// The energy, and the settings that its minimizers share.
    pub energy: IsometrySettings,
    /// Most iterations of belief propagation.
    pub iterations: u32,
    /// Most sweeps of conditional modes over all labels afterwards.
    pub sweeps: usize,
    /// Largest residual of an inlier, in roots of the area: two spacings of the labels, plus the difference between two
    /// subjects.
    pub inlier: f64,
    /// Confidence and most trials of RANSAC.
    pub confidence: f64,
    pub max_trials: u64,
}

impl Default for InferenceSettings {
    fn default() -> Self {
        InferenceSettings {
            energy: IsometrySettings::default(),
            iterations: 12,
            sweeps: 8,
            inlier: 0.1,
            confidence: 0.999,
            max_trials: 4096,
        }
    }
}

/// A labeling, and the pose that it supports.
#[derive(Debug, Clone)]
pub(crate) struct PosedLabeling {
    pub labeling: Labeling,
    pub energy: Energy,
    pub iterations: u32,
    pub converged: bool,
    /// Energy and change of messages after each iteration.
    pub trace: Vec<(Energy, f32)>,
    /// `None` where no three labels support a pose.
    pub ransac: Option<RansacReport>,
}

impl PosedLabeling {
    /// The share of the labels that support the pose.
    pub(crate) fn support(&self) -> f64 {
        self.ransac.as_ref().map_or(0.0, |found| found.support as f64 / self.labeling.len().max(1) as f64)
    }
}

/// The labelings that inference without a start found.
pub(crate) struct IsometryInference {
    model: MetricModel,
    /// The energy of the mirrored source.
    of_mirror: MetricModel,
    groups: VariableClusters,
    /// The labels, mm.
    places: Vec<Point3<f64>>,
    tolerance_mm: f64,
    /// Most sweeps of conditional modes.
    sweeps: usize,
    /// The variables, mm.
    points: Vec<Point3<f64>>,
    /// Energy of the labels of lowest unary potential.
    initial: Energy,
    pub proper: PosedLabeling,
    /// The labeling of lowest energy away from `proper`.
    pub elsewhere: PosedLabeling,
    /// The labeling of the mirrored source, whose places have chirality of the opposite sign.
    pub mirrored: PosedLabeling,
}

/// The part of the result about inference.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InferenceOutcome {
    pub energy: EnergyDocument,
    /// Inference without a start; then from the answer: clamping by feedback of registration.
    pub rounds: Vec<RoundDocument>,
    pub stop_reason: StopReason,
    /// Trials of RANSAC over the labels of the first round.
    pub trials: u64,
    pub confidence_reached: bool,
}

impl IsometryInference {
    /// The poses that the labelings support; among those of one handedness the pose of lowest energy first.
    pub(crate) fn poses(&self) -> impl Iterator<Item = RigidTransform> {
        let found = [&self.proper, &self.elsewhere, &self.mirrored];
        found.into_iter().filter_map(|labeled| Some(labeled.ransac.as_ref()?.target_from_source))
    }

    /// Whether the labels determine the pose: nearly all of them support it, and labels elsewhere, or of the mirror
    /// image, cost significantly more. Otherwise further starts are needed.
    pub(crate) fn is_clear(&self) -> bool {
        self.proper.support() >= CLEAR_SUPPORT
            && self.excess(&self.model, &self.elsewhere) > DISTINCT_LABELINGS
            && self.excess(&self.of_mirror, &self.mirrored) > DISTINCT_LABELINGS
    }

    /// Whether the labels of the mirror image cost significantly less and nearly all support one pose: the target is
    /// then the mirrored source, not only bent.
    pub(crate) fn is_of_other_handedness(&self) -> bool {
        self.mirrored.support() >= CLEAR_SUPPORT && self.excess(&self.of_mirror, &self.mirrored) < -DISTINCT_LABELINGS
    }

    /// Excess cost of `other`, a labeling of `model`, over `proper`, in standard errors: see [`VariableClusters::lead`].
    fn excess(&self, model: &MetricModel, other: &PosedLabeling) -> f64 {
        self.groups.lead(&self.model.shares(&self.proper.labeling), &model.shares(&other.labeling))
    }

    /// Reports the energy after each iteration, and the support of the labels.
    pub(crate) fn trace(&self, observer: &dyn Observer) {
        for (k, (energy, change)) in self.proper.trace.iter().enumerate() {
            observer.trace(&TracePoint {
                quantity: Some(Quantity::IsometryEnergy),
                energy: Some(energy.total()),
                energy_unary: Some(energy.unary),
                energy_pairwise: Some(energy.pairwise),
                message_delta_max: Some(f64::from(*change)),
                ..TracePoint::new(0, Phase::Inference, k as u32 + 1)
            });
        }
        observer.phase(Phase::Registration);
        observer.trace(&TracePoint {
            quantity: Some(Quantity::IsometryEnergy),
            energy: Some(self.proper.energy.total()),
            energy_unary: Some(self.proper.energy.unary),
            energy_pairwise: Some(self.proper.energy.pairwise),
            support: Some(self.proper.ransac.as_ref().map_or(0, |found| found.support as u32)),
            ..TracePoint::new(0, Phase::Registration, 1)
        });
    }

    /// The outcome for an answer with the rigid part `transform`, whose images are at `labels`.
    pub(crate) fn clamped(&self, labels: Labeling, transform: &RigidTransform) -> InferenceOutcome {
        let mirrors = transform.is_reflection();
        let (model, from_nothing) =
            if mirrors { (&self.of_mirror, &self.mirrored) } else { (&self.model, &self.proper) };
        let labels = model.descend(labels, self.sweeps);
        let energy = model.energy(&labels);
        let status = |converged| if converged { ConvergenceStatus::Converged } else { ConvergenceStatus::Slow };
        let stop_reason = if from_nothing.converged { StopReason::Converged } else { StopReason::MaxIterations };
        let near = |(p, q): &(&Point3<f64>, &u32)| {
            (transform.apply(p) - self.places[**q as usize]).norm() <= self.tolerance_mm
        };
        let first = RoundDocument {
            round: 0,
            feedback: Feedback::None,
            iterations: from_nothing.iterations,
            stop_reason,
            convergence: ConvergenceDocument { status: status(from_nothing.converged), period: None },
            energy: from_nothing.energy.total(),
            support: from_nothing.ransac.as_ref().map_or(0, |found| found.support as u32),
            chosen: false,
        };
        let second = RoundDocument {
            round: 1,
            feedback: Feedback::Soft,
            iterations: 1,
            stop_reason: StopReason::Converged,
            convergence: ConvergenceDocument { status: ConvergenceStatus::Converged, period: None },
            energy: energy.total(),
            support: self.points.iter().zip(&labels).filter(near).count() as u32,
            chosen: true,
        };
        let ransac = from_nothing.ransac.as_ref();
        InferenceOutcome {
            energy: EnergyDocument {
                n_variables: model.n_variables() as u32,
                n_target_vertices: model.n_labels() as u32,
                initial: self.initial.total(),
                r#final: energy.total(),
                per_variable: energy.total() / model.n_variables() as f64,
                unary: energy.unary,
                pairwise: energy.pairwise,
                lower_bound: None,
                broken_edges: model.truncated_edges(&labels) as u32,
            },
            rounds: vec![first, second],
            stop_reason,
            trials: ransac.map_or(0, |found| found.trials),
            confidence_reached: ransac.is_some_and(|found| found.confidence_reached),
        }
    }
}

/// Infers the labels of `source` on `target`; `root_mm` is the root of the area.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// `O(iterations · edges · active²)` for each handedness.
pub(crate) fn infer(
    source: &SiteMeasurements<'_>,
    target: &SiteMeasurements<'_>,
    root_mm: f64,
    seed: u64,
    settings: &InferenceSettings,
    observer: &dyn Observer,
) -> Result<IsometryInference, Cancelled> {
    let of_energy = settings.energy;
    let Isometry { model, mirrored: of_mirror, variables, points, .. } = Isometry::new(source, target, of_energy);
    checkpoint(observer)?;
    let labeled = |model: &MetricModel, bias: &[f32], mirrors: bool| {
        labeled(model, bias, (&points, mirrors), target, root_mm, seed, settings)
    };
    let (mirrored, (proper, elsewhere)) = rayon::join(
        || labeled(&of_mirror, &[], true),
        || {
            let proper = labeled(&model, &[], false);
            let away =
                bias_away_from(&[&proper.labeling], target.sites, of_energy.repulsion, of_energy.repulsion_width);
            let elsewhere = labeled(&model, &away, false);
            (proper, elsewhere)
        },
    );
    checkpoint(observer)?;
    Ok(IsometryInference {
        initial: model.energy(&model.unary_minimum()),
        groups: VariableClusters::new(source.sites, variables),
        places: target.places.clone(),
        tolerance_mm: settings.inlier * root_mm,
        sweeps: settings.sweeps,
        proper,
        elsewhere,
        mirrored,
        points,
        of_mirror,
        model,
    })
}

fn labeled(
    model: &MetricModel,
    bias: &[f32],
    (points, mirrors): (&[Point3<f64>], bool),
    target: &SiteMeasurements<'_>,
    root_mm: f64,
    seed: u64,
    settings: &InferenceSettings,
) -> PosedLabeling {
    let options = ActiveOptions {
        semiring: Semiring::Sum,
        iterations: settings.iterations,
        damping: settings.energy.damping,
        tolerance: settings.energy.tolerance,
    };
    let mut trace = Vec::new();
    let active = model.cheapest(bias, settings.energy.active_labels);
    let found = model.propagate(&active, bias, &options, |_, energy, change| trace.push((energy, change)));
    let labeling = model.descend(found.labeling(), settings.sweeps);
    let images = images(&found, &labeling, target, settings);
    let beliefs: Vec<f64> = (0..labeling.len()).map(|i| belief(&found, i, labeling[i])).collect();
    let options = RansacOptions {
        tolerance_mm: settings.inlier * root_mm,
        confidence: settings.confidence,
        max_trials: settings.max_trials,
        allow_reflection: false,
        seed,
    };
    // Labels of the mirror image support a pose of the mirrored points.
    let sign = if mirrors { -1.0 } else { 1.0 };
    let from: Vec<Point3<f64>> = points.iter().map(|p| Point3::new(sign * p.x, p.y, p.z)).collect();
    // A search among 160 points takes a millisecond, so cancellation is checked only before and after it.
    let mut ransac = ransac_weighted(&from, &images, &beliefs, &options, &Silent).ok().flatten();
    if let Some(found) = &mut ransac {
        let mirror = Matrix3::from_diagonal(&Vector3::new(sign, 1.0, 1.0));
        found.target_from_source.rotation *= mirror;
    }
    PosedLabeling {
        energy: model.energy(&labeling),
        ransac,
        converged: found.message_delta_max <= settings.energy.tolerance,
        iterations: found.iterations,
        labeling,
        trace,
    }
}

/// The belief in a label; the least positive number for a label that is not active.
fn belief(found: &ActiveBeliefs, variable: usize, label: u32) -> f64 {
    let at = found.active.of(variable).binary_search(&label);
    at.map_or(f64::from(f32::MIN_POSITIVE), |at| f64::from(found.of(variable)[at]).max(f64::from(f32::MIN_POSITIVE)))
}

/// For each variable the mean of the active labels near its own, weighted by their beliefs, mm.
fn images(
    found: &ActiveBeliefs,
    labeling: &[u32],
    target: &SiteMeasurements<'_>,
    settings: &InferenceSettings,
) -> Vec<Point3<f64>> {
    let near = (settings.energy.blended / (target.sites.len() as f64).sqrt()) as f32;
    let image = |(i, &own): (usize, &u32)| {
        let row = target.sites.row(own as usize);
        let (mut total, mut sum) = (0.0, Vector3::zeros());
        for (&label, &belief) in found.active.of(i).iter().zip(found.of(i)) {
            if row[label as usize] <= near {
                let belief = f64::from(belief).max(f64::from(f32::MIN_POSITIVE));
                total += belief;
                sum += target.places[label as usize].coords * belief;
            }
        }
        if total > 0.0 { Point3::from(sum / total) } else { target.places[own as usize] }
    };
    labeling.iter().enumerate().map(image).collect()
}
