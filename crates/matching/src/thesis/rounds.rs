//! The rounds of a match: inference, registration, feedback, until the support stops growing.

use super::clamping::{SoftClamp, SoftWeights, clamp_hard};
use super::closer_pose::closer_pose;
use super::minimizer::{InferenceRun, Minimizer, MinimizerResult};
use super::minimizers::minimizer;
use crate::error::MatchError;
use crate::pair::problem::EnergyProblem;
use crate::pair::progress::{PROGRESS_AT_END, PROGRESS_BEFORE_DISPLACEMENT, PROGRESS_BEFORE_ROUNDS};
use crate::pair::solver::solver;
use crate::poses::posed::{InferredPose, RoundsResult};
use homolog_contract::parameters::{ClampingMode, DisplacementMode, MatchParameters, MinimalEstimator};
use homolog_contract::result::{Feedback, RoundDocument};
use homolog_primitives::observe::{Phase, Quantity, TracePoint};
use homolog_registration::{self, RansacMethods, RansacOptions, RansacReport, RigidTransform, ransac_with};

/// `σ_g` of soft clamping, in mean target edge lengths; chosen with weights of 2 (distance) and 3 (normals) and a cap
/// of 10.
const SOFT_SIGMA_EDGES: f64 = 2.0;

/// Iterations of a round that starts from the messages or labels of the previous one.
fn later_iterations(first: u32) -> u32 {
    first.div_ceil(4).max(2)
}

/// Progress of a match after its rounds.
fn progress_after_rounds(parameters: &MatchParameters) -> f64 {
    match parameters.displacement.mode {
        DisplacementMode::None => PROGRESS_AT_END,
        _ => PROGRESS_BEFORE_DISPLACEMENT,
    }
}

/// Counts rounds and iterations, and their share of the planned work.
struct Plan {
    rounds: u32,
    iterations: u32,
    planned: u32,
    /// Progress of the match after the rounds.
    until: f64,
}

impl Plan {
    fn new(first: u32, n_rounds: u32, until: f64) -> Self {
        Plan { rounds: 0, iterations: 0, planned: first + n_rounds * later_iterations(first), until }
    }

    /// The number of the next round.
    fn next_round(&mut self) -> u32 {
        self.rounds += 1;
        self.rounds - 1
    }

    /// Counts an iteration; returns the progress of the match.
    fn progress(&mut self) -> f64 {
        self.iterations += 1;
        PROGRESS_BEFORE_ROUNDS
            + (self.until - PROGRESS_BEFORE_ROUNDS) * (f64::from(self.iterations) / f64::from(self.planned)).min(1.0)
    }
}

/// The outcome of one round.
#[expect(clippy::large_enum_variant, reason = "there are few in a match, and the labeling behind it is far larger")]
enum Round {
    Supported(SupportedRound),
    /// No rigid transform has three inliers in its labeling.
    Unsupported(MinimizerResult),
}

/// A labeling and the registration that it supports.
struct SupportedRound {
    number: u32,
    labeled: MinimizerResult,
    registration: RansacReport,
    /// The transform of `registration`, refined.
    transform: RigidTransform,
}

impl Round {
    fn supported(self) -> Option<SupportedRound> {
        match self {
            Round::Supported(round) => Some(round),
            Round::Unsupported(_) => None,
        }
    }
}

/// Inputs of the rounds of a match.
pub(crate) struct Rounds<'a> {
    pub problem: &'a EnergyProblem<'a>,
}

/// State that is kept from round to round.
struct Course<'m> {
    minimizer: Box<dyn Minimizer + 'm>,
    plan: Plan,
    documents: Vec<RoundDocument>,
}

impl Rounds<'_> {
    /// Runs all rounds; the answer is the round of largest support. Feedback needs a transform: the first round without
    /// one is the last, and is chosen only if it is the only one.
    pub(crate) fn run(&self) -> Result<RoundsResult, MatchError> {
        let p = self.problem.scene.parameters;
        let mode = p.clamping.mode;
        let n_rounds = if mode == ClampingMode::None { 0 } else { p.clamping.max_rounds };
        let mut course = Course {
            minimizer: minimizer(&self.problem.model, p, self.problem.lower_bound, self.problem.scene.observer),
            plan: Plan::new(p.inference.max_iterations, n_rounds, progress_after_rounds(p)),
            documents: Vec::new(),
        };
        let mut best = match self.round(&mut course, p.inference.max_iterations, Feedback::None)? {
            Round::Supported(round) => round,
            Round::Unsupported(labeled) => {
                return Ok(RoundsResult {
                    map: labeled.map,
                    stop_reason: labeled.stop_reason,
                    rounds: course.documents,
                    pose: InferredPose::Unsupported,
                });
            }
        };
        let mut trials = best.registration.trials;
        // Later rounds start where the previous one ended, so they need fewer iterations.
        let later = later_iterations(p.inference.max_iterations);
        for round in 1..=n_rounds {
            let feedback = self.set_bias(&mut *course.minimizer, &best);
            let mut next = self.round(&mut course, later, feedback)?.supported();
            trials += next.as_ref().map_or(0, |next| next.registration.trials);
            let first_feedback = round == 1 && mode == ClampingMode::Soft;
            if first_feedback && let Some(pose) = self.candidate(&next.as_ref().unwrap_or(&best).transform)? {
                let contender = self.round_from(&mut course, &pose)?.supported();
                trials += contender.as_ref().map_or(0, |contender| contender.registration.trials);
                let energy = |round: &Option<SupportedRound>| {
                    round.as_ref().map_or(f64::INFINITY, |round| round.labeled.energy.total())
                };
                if energy(&contender) < energy(&next) {
                    next = contender;
                }
            }
            let Some(next) = next else { break };
            // The first soft feedback is always taken: candidate poses were compared with it.
            let (support, before) = (next.registration.support, best.registration.support);
            let lower = next.labeled.energy.total() < best.labeled.energy.total();
            if first_feedback || support > before || support == before && lower {
                best = next;
            }
            if !first_feedback && support <= before {
                break;
            }
        }
        for document in &mut course.documents {
            document.chosen = document.round == best.number;
        }
        Ok(RoundsResult {
            map: best.labeled.map,
            stop_reason: best.labeled.stop_reason,
            rounds: course.documents,
            pose: InferredPose::Supported {
                transform: best.transform,
                trials,
                confidence_reached: best.registration.confidence_reached,
            },
        })
    }

    /// A pose on the principal axes that fits clearly better than `present`.
    fn candidate(&self, present: &RigidTransform) -> Result<Option<RigidTransform>, MatchError> {
        let scene = &self.problem.scene;
        let (source, target) = (scene.source.mesh().vertices(), scene.target.mesh().vertices());
        Ok(closer_pose(source, target, scene.closest, present, scene.observer)?)
    }

    /// A full round from a cold start with the feedback of `pose`.
    fn round_from(&self, course: &mut Course<'_>, pose: &RigidTransform) -> Result<Round, MatchError> {
        course.minimizer.reset();
        self.set_soft_bias(&mut *course.minimizer, pose);
        self.round(course, self.problem.scene.parameters.inference.max_iterations, Feedback::CandidatePose)
    }

    fn set_bias(&self, minimizer: &mut dyn Minimizer, last: &SupportedRound) -> Feedback {
        match self.problem.scene.parameters.clamping.mode {
            ClampingMode::None => Feedback::None,
            ClampingMode::Hard => {
                let truncation = self.problem.model.pairwise.truncation;
                minimizer.set_bias(&|i, row| {
                    if last.registration.inlier_mask[i] {
                        clamp_hard(last.labeled.map.labeling[i], truncation, row);
                    }
                });
                Feedback::Hard
            }
            ClampingMode::Soft => {
                self.set_soft_bias(minimizer, &last.transform);
                Feedback::Soft
            }
        }
    }

    fn set_soft_bias(&self, minimizer: &mut dyn Minimizer, transform: &RigidTransform) {
        let scene = &self.problem.scene;
        let (source, target) = (scene.source, scene.target);
        let sigma_mm = SOFT_SIGMA_EDGES * scene.edge_mm;
        let clamp = SoftClamp::new(
            SoftWeights { distance: 2.0, sigma_mm, cap: 10.0, normal: 3.0 },
            transform,
            (source.mesh().vertices(), &source.normals),
            (target.mesh().vertices(), &target.normals),
        );
        minimizer.set_bias(&|i, row| clamp.add(i, row));
    }

    /// Inference, RANSAC over its pairs, and refinement.
    fn round(&self, course: &mut Course<'_>, budget: u32, feedback: Feedback) -> Result<Round, MatchError> {
        let EnergyProblem { scene, lower_bound, .. } = self.problem;
        let (p, observer) = (scene.parameters, scene.observer);
        let Course { minimizer, plan, documents } = course;
        let number = plan.next_round();
        observer.phase(Phase::Inference);
        let run = InferenceRun { round: number, budget, positions: scene.target.mesh().vertices(), observer };
        let labeled = minimizer.run(&run, &mut |point| {
            observer.trace(&TracePoint { lower_bound: point.lower_bound.or(*lower_bound), ..point });
            observer.progress(plan.progress());
        })?;
        observer.phase(Phase::Registration);
        let images = scene.images(&labeled.map.labeling);
        let options = RansacOptions {
            tolerance_mm: scene.tolerance_mm,
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
        let registration = ransac_with(scene.source.mesh().vertices(), &images, &options, methods, observer)?;
        let support = registration.as_ref().map_or(0, |found| found.support as u32);
        observer.trace(&TracePoint {
            quantity: Some(Quantity::CurvatureEnergy),
            energy: Some(labeled.energy.total()),
            energy_unary: Some(labeled.energy.unary),
            energy_pairwise: Some(labeled.energy.pairwise),
            lower_bound: *lower_bound,
            support: Some(support),
            ..TracePoint::new(number, Phase::Registration, 1)
        });
        documents.push(RoundDocument {
            round: number,
            feedback,
            iterations: labeled.iterations,
            stop_reason: labeled.stop_reason,
            convergence: labeled.convergence.clone(),
            energy: labeled.energy.total(),
            support,
            chosen: false,
        });
        let Some(registration) = registration else { return Ok(Round::Unsupported(labeled)) };
        let transform = scene.refine(&registration.target_from_source)?;
        Ok(Round::Supported(SupportedRound { number, labeled, registration, transform }))
    }
}
