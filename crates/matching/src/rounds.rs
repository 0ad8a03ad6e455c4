//! The rounds of a match: inference, registration, feedback, until the support stops growing.

use super::MatchError;
use super::clamping::{SoftClamp, SoftWeights, clamp_hard};
use super::minimiser::{Labeled, Minimiser, minimiser};
use super::report::{Answer, solver};
use super::rivals::rival_pose;
use super::scene::Scene;
use homolog_contract::parameters::{ClampingMode, DisplacementMode, MatchParameters, MinimalEstimator};
use homolog_contract::result::{Feedback, RoundDocument};
use homolog_mrf::MrfModel;
use homolog_primitives::observe::{Phase, TracePoint};
use homolog_registration::{self, RansacMethods, RansacOptions, RansacReport, RigidTransform, ransac_with};

/// `σ_g` of soft clamping in mean target edge lengths. Together with a weight of 2, a cap of 10 and 3 for normals it
/// gave the best agreement of anterior and posterior labels between subjects of five settings tried.
const SOFT_SIGMA_EDGES: f64 = 2.0;

/// Iterations of a round that starts warm.
fn later_iterations(first: u32) -> u32 {
    first.div_ceil(4).max(2)
}

/// The share of a match that is done when its rounds are.
pub(super) fn progress_after_rounds(parameters: &MatchParameters) -> f64 {
    match parameters.displacement.mode {
        DisplacementMode::None => PROGRESS_AT_END,
        DisplacementMode::Smooth => 0.4,
    }
}

/// The share of a match that is done when only the report is to be made.
pub(super) const PROGRESS_AT_END: f64 = 0.95;

/// Counts rounds and iterations, and how much of the planned work they are.
struct Schedule {
    rounds: u32,
    iterations: u32,
    planned: u32,
    /// The share of a whole match that is done after the rounds.
    until: f64,
}

impl Schedule {
    fn new(first: u32, n_rounds: u32, until: f64) -> Self {
        Schedule { rounds: 0, iterations: 0, planned: first + n_rounds * later_iterations(first), until }
    }

    /// The number of the round that begins.
    fn next_round(&mut self) -> u32 {
        self.rounds += 1;
        self.rounds - 1
    }

    /// One more iteration is done; the share of the whole work.
    fn progress(&mut self) -> f64 {
        self.iterations += 1;
        0.05 + (self.until - 0.05) * (f64::from(self.iterations) / f64::from(self.planned)).min(1.0)
    }
}

/// A labeling with the registration it supports.
struct Round {
    number: u32,
    labeled: Labeled,
    registration: RansacReport,
    transform: RigidTransform,
}

/// What one match's rounds share.
pub(super) struct Matcher<'a> {
    pub scene: &'a Scene<'a>,
    pub model: &'a MrfModel,
    /// No labeling has an energy below this.
    pub lower_bound: Option<f64>,
}

impl Matcher<'_> {
    /// All rounds; the answer is that of the largest support.
    pub fn rounds(&self) -> Result<Answer, MatchError> {
        let p = self.scene.parameters;
        let mode = p.clamping.mode;
        let n_rounds = if mode == ClampingMode::None { 0 } else { p.clamping.max_rounds };
        let mut schedule = Schedule::new(p.inference.max_iterations, n_rounds, progress_after_rounds(p));
        let mut minimiser = minimiser(self.model, p, self.lower_bound);
        let mut log = Vec::new();
        let mut best =
            self.round(&mut *minimiser, &mut schedule, p.inference.max_iterations, Feedback::None, &mut log)?;
        let mut trials = best.registration.trials;
        // Later rounds start from where the round before ended and need fewer iterations.
        let later = later_iterations(p.inference.max_iterations);
        for round in 1..=n_rounds {
            let feedback = self.set_bias(&mut *minimiser, &best);
            let mut next = self.round(&mut *minimiser, &mut schedule, later, feedback, &mut log)?;
            trials += next.registration.trials;
            let first_feedback = round == 1 && mode == ClampingMode::Soft;
            if first_feedback && let Some(pose) = self.rival(&next.transform)? {
                let challenger = self.round_from(&mut *minimiser, &mut schedule, &pose, &mut log)?;
                trials += challenger.registration.trials;
                if challenger.labeled.energy.total() < next.labeled.energy.total() {
                    next = challenger;
                }
            }
            // The first soft feedback is always taken: it is what the rivals were judged by.
            let (support, before) = (next.registration.support, best.registration.support);
            let lower = next.labeled.energy.total() < best.labeled.energy.total();
            if first_feedback || support > before || support == before && lower {
                best = next;
            }
            if !first_feedback && support <= before {
                break;
            }
        }
        for round in &mut log {
            round.chosen = round.round == best.number;
        }
        Ok(Answer {
            labeling: best.labeled.labeling,
            confidence: best.labeled.confidence,
            spread_mm: best.labeled.spread_mm,
            points: None,
            moved: None,
            no_counterpart: Vec::new(),
            reliability: None,
            anatomy: None,
            transform: best.transform,
            confidence_reached: best.registration.confidence_reached,
            trials,
            stop_reason: best.labeled.stop_reason,
            rounds: log,
            poses: Vec::new(),
            ambiguous_axes: false,
            lower_bound: self.lower_bound,
        })
    }

    fn rival(&self, present: &RigidTransform) -> Result<Option<RigidTransform>, MatchError> {
        let (source, target) = (self.scene.source.mesh().vertices(), self.scene.target.mesh().vertices());
        Ok(rival_pose(source, target, self.scene.closest, present, self.scene.observer)?)
    }

    /// A whole round from a cold start with the feedback of `pose`.
    fn round_from(
        &self,
        minimiser: &mut dyn Minimiser,
        schedule: &mut Schedule,
        pose: &RigidTransform,
        log: &mut Vec<RoundDocument>,
    ) -> Result<Round, MatchError> {
        minimiser.forget();
        self.set_soft_bias(minimiser, pose);
        self.round(minimiser, schedule, self.scene.parameters.inference.max_iterations, Feedback::RivalPose, log)
    }

    fn set_bias(&self, minimiser: &mut dyn Minimiser, last: &Round) -> Feedback {
        match self.scene.parameters.clamping.mode {
            ClampingMode::None => Feedback::None,
            ClampingMode::Hard => {
                let truncation = self.model.pairwise.truncation;
                minimiser.set_bias(&|i, row| {
                    if last.registration.inlier_mask[i] {
                        clamp_hard(last.labeled.labeling[i], truncation, row);
                    }
                });
                Feedback::Hard
            }
            ClampingMode::Soft => {
                self.set_soft_bias(minimiser, &last.transform);
                Feedback::Soft
            }
        }
    }

    fn set_soft_bias(&self, minimiser: &mut dyn Minimiser, transform: &RigidTransform) {
        let (source, target) = (self.scene.source, self.scene.target);
        let sigma_mm = SOFT_SIGMA_EDGES * self.scene.edge_mm;
        let clamp = SoftClamp::new(
            SoftWeights { distance: 2.0, sigma_mm, cap: 10.0, normal: 3.0 },
            transform,
            (source.mesh().vertices(), &source.normals),
            (target.mesh().vertices(), &target.normals),
        );
        minimiser.set_bias(&|i, row| clamp.add(i, row));
    }

    /// Inference, then RANSAC over its pairs, then refinement.
    fn round(
        &self,
        minimiser: &mut dyn Minimiser,
        schedule: &mut Schedule,
        budget: u32,
        feedback: Feedback,
        log: &mut Vec<RoundDocument>,
    ) -> Result<Round, MatchError> {
        let (p, observer) = (self.scene.parameters, self.scene.observer);
        let number = schedule.next_round();
        observer.phase(Phase::Inference);
        let positions = self.scene.target.mesh().vertices();
        let labeled = minimiser.run(number, budget, positions, observer, &mut |point| {
            observer.trace(&TracePoint { lower_bound: point.lower_bound.or(self.lower_bound), ..point });
            observer.progress(schedule.progress());
        })?;
        observer.phase(Phase::Registration);
        let images = self.scene.images(&labeled.labeling);
        let options = RansacOptions {
            tolerance_mm: self.scene.tolerance_mm,
            confidence: p.registration.confidence,
            max_trials: p.registration.max_trials.into(),
            allow_reflection: p.registration.allow_reflection,
            seed: p.seed.wrapping_add(u64::from(number)),
        };
        let methods = RansacMethods {
            estimator: match p.registration.estimator {
                MinimalEstimator::Frame => homolog_registration::MinimalEstimator::Frame,
                MinimalEstimator::RotationAxis => homolog_registration::MinimalEstimator::RotationAxis,
            },
            solver: solver(p.registration.solver),
        };
        let registration = ransac_with(self.scene.source.mesh().vertices(), &images, &options, methods, observer)?
            .ok_or(MatchError::NoRegistration { tolerance_mm: self.scene.tolerance_mm })?;
        observer.trace(&TracePoint {
            energy: Some(labeled.energy.total()),
            energy_unary: Some(labeled.energy.unary),
            energy_pairwise: Some(labeled.energy.pairwise),
            lower_bound: self.lower_bound,
            support: Some(registration.support as u32),
            ..TracePoint::new(number, Phase::Registration, 1)
        });
        log.push(RoundDocument {
            round: number,
            feedback,
            iterations: labeled.iterations,
            stop_reason: labeled.stop_reason,
            convergence: labeled.convergence.clone(),
            energy: labeled.energy.total(),
            support: registration.support as u32,
            chosen: false,
        });
        let transform = self.scene.refine(&registration.target_from_source)?;
        Ok(Round { number, labeled, registration, transform })
    }
}
