//! The rounds of a match: inference, registration, feedback, until the support stops growing.

use super::clamping::{SoftClamp, SoftWeights, clamp_hard};
use super::parameters::{Algorithm, ClampingMode, MatchParameters, Refinement};
use super::prepare::{Side, build_model};
use super::report::{consistency, surface_distance, transform_document};
use super::result::{Correspondences, EnergyDocument, StopReason, SupportDocument};
use super::rivals::rival_pose;
use super::surface_index::SurfaceIndex;
use super::{MatchError, MatchOutcome};
use crate::inference::{BeliefPropagation, BpOptions, BpOutcome, BpStop, Product};
use crate::mesh::SurfaceMesh;
use crate::mrf::MrfModel;
use crate::observe::{Observer, Phase, TracePoint, checkpoint};
use crate::registration::{IcpMetric, IcpOptions, RansacOptions, RansacReport, RigidTransform, ransac, refine_icp};
use nalgebra::Point3;

/// Smallest value of a message; far below `exp(−T)` at the default truncation, so that it only keeps products finite.
const MESSAGE_FLOOR: f32 = 1e-5;
/// Inlier tolerance in mean target edge lengths where the request states none.
const TOLERANCE_EDGES: f64 = 3.0;
/// `σ_g` of soft clamping in mean target edge lengths. Together with a weight of 2, a cap of 10 and 3 for normals it
/// gave the best agreement of anterior and posterior labels between subjects of five settings tried.
const SOFT_SIGMA_EDGES: f64 = 2.0;
/// Share of the source vertices that ICP keeps: the rest may have no counterpart.
const ICP_KEEP: f64 = 0.9;
const ICP_ITERATIONS: u32 = 100;
const ICP_TOLERANCE: f64 = 1e-6;

/// Iterations of a round that starts warm.
fn later_iterations(first: u32) -> u32 {
    first.div_ceil(4).max(2)
}

/// Counts rounds and iterations, and how much of the planned work they are.
struct Schedule {
    rounds: u32,
    iterations: u32,
    planned: u32,
}

impl Schedule {
    fn new(first: u32, n_rounds: u32) -> Self {
        Schedule { rounds: 0, iterations: 0, planned: first + n_rounds * later_iterations(first) }
    }

    /// The number of the round that begins.
    fn next_round(&mut self) -> u32 {
        self.rounds += 1;
        self.rounds - 1
    }

    /// One more iteration is done; the share of the whole work.
    fn progress(&mut self) -> f64 {
        self.iterations += 1;
        0.05 + 0.9 * (f64::from(self.iterations) / f64::from(self.planned)).min(1.0)
    }
}

/// A labeling with the registration it supports.
struct Round {
    bp: BpOutcome,
    registration: RansacReport,
    transform: RigidTransform,
}

pub(super) fn run(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let source_side = Side::new(source);
    let target_side = Side::new(target);
    let model = build_model(&source_side, &target_side, parameters)?;
    checkpoint(observer)?;
    observer.progress(0.05);
    let edge_mm = target_side.mesh().mean_edge_length();
    let matcher = Matcher {
        source: &source_side,
        target: &target_side,
        closest: SurfaceIndex::new(target_side.mesh()),
        model: &model,
        parameters,
        edge_mm,
        tolerance_mm: parameters.registration.tolerance_mm.unwrap_or(TOLERANCE_EDGES * edge_mm),
        observer,
    };
    let (round, trials) = matcher.rounds()?;
    observer.phase(Phase::Reporting);
    Ok(matcher.outcome(round, trials))
}

/// Everything that the rounds share.
struct Matcher<'a> {
    source: &'a Side,
    target: &'a Side,
    closest: SurfaceIndex,
    model: &'a MrfModel,
    parameters: &'a MatchParameters,
    /// Mean target edge length.
    edge_mm: f64,
    tolerance_mm: f64,
    observer: &'a dyn Observer,
}

impl Matcher<'_> {
    /// All rounds; the one with the largest support, and the RANSAC trials of all.
    fn rounds(&self) -> Result<(Round, u64), MatchError> {
        let p = self.parameters;
        let options = BpOptions {
            product: match p.inference.algorithm {
                Algorithm::MaxProduct => Product::Max,
                Algorithm::SumProduct => Product::Sum,
            },
            damping: p.inference.damping as f32,
            floor: MESSAGE_FLOOR,
            tolerance: p.inference.tolerance as f32,
        };
        let mode = p.clamping.mode;
        let n_rounds = if mode == ClampingMode::None { 0 } else { p.clamping.max_rounds };
        let mut schedule = Schedule::new(p.inference.max_iterations, n_rounds);
        let mut bp = BeliefPropagation::new(self.model, options);
        let mut best = self.round(&mut bp, &mut schedule, p.inference.max_iterations)?;
        let mut trials = best.registration.trials;
        // Later rounds start from the messages of the round before and need fewer iterations.
        let later = later_iterations(p.inference.max_iterations);
        for round in 1..=n_rounds {
            self.set_bias(&mut bp, &best);
            let mut next = self.round(&mut bp, &mut schedule, later)?;
            trials += next.registration.trials;
            let first_feedback = round == 1 && mode == ClampingMode::Soft;
            let vertices = (self.source.mesh().vertices(), self.target.mesh().vertices());
            if first_feedback
                && let Some(pose) = rival_pose(vertices.0, vertices.1, &self.closest, &next.transform, self.observer)?
            {
                let challenger = self.round_from(&mut bp, &mut schedule, &pose)?;
                trials += challenger.registration.trials;
                if challenger.bp.energy.total() < next.bp.energy.total() {
                    next = challenger;
                }
            }
            // The first soft feedback is always taken: it is what the rivals were judged by.
            let (support, before) = (next.registration.support, best.registration.support);
            let lower = next.bp.energy.total() < best.bp.energy.total();
            if first_feedback || support > before || support == before && lower {
                best = next;
            }
            if !first_feedback && support <= before {
                break;
            }
        }
        Ok((best, trials))
    }

    /// A whole round with cold messages and the feedback of `pose`.
    fn round_from(
        &self,
        bp: &mut BeliefPropagation<'_>,
        schedule: &mut Schedule,
        pose: &RigidTransform,
    ) -> Result<Round, MatchError> {
        bp.forget();
        self.set_soft_bias(bp, pose);
        self.round(bp, schedule, self.parameters.inference.max_iterations)
    }

    fn set_bias(&self, bp: &mut BeliefPropagation<'_>, last: &Round) {
        match self.parameters.clamping.mode {
            ClampingMode::None => {}
            ClampingMode::Hard => bp.set_bias(|i, row| {
                if last.registration.inlier_mask[i] {
                    clamp_hard(last.bp.labeling[i], self.parameters.energy.truncation, row);
                }
            }),
            ClampingMode::Soft => self.set_soft_bias(bp, &last.transform),
        }
    }

    fn set_soft_bias(&self, bp: &mut BeliefPropagation<'_>, transform: &RigidTransform) {
        let weights = SoftWeights { distance: 2.0, sigma_mm: SOFT_SIGMA_EDGES * self.edge_mm, cap: 10.0, normal: 3.0 };
        let clamp = SoftClamp::new(
            weights,
            transform,
            (self.source.mesh().vertices(), &self.source.normals),
            (self.target.mesh().vertices(), &self.target.normals),
        );
        bp.set_bias(|i, row| clamp.add(i, row));
    }

    /// Belief propagation, then RANSAC over its pairs, then refinement.
    fn round(&self, bp: &mut BeliefPropagation<'_>, schedule: &mut Schedule, budget: u32) -> Result<Round, MatchError> {
        let p = self.parameters;
        let round = schedule.next_round();
        self.observer.phase(Phase::Inference);
        let bp = bp.run(budget, self.observer, |iteration| {
            self.observer.trace(&TracePoint {
                energy: Some(iteration.energy.total()),
                energy_unary: Some(iteration.energy.unary),
                energy_pairwise: Some(iteration.energy.pairwise),
                message_delta_max: Some(iteration.message_delta_max.into()),
                labels_changed: Some(iteration.labels_changed),
                ..TracePoint::new(round, Phase::Inference, iteration.iteration)
            });
            self.observer.progress(schedule.progress());
        })?;
        self.observer.phase(Phase::Registration);
        let images = self.images(&bp.labeling);
        let options = RansacOptions {
            tolerance_mm: self.tolerance_mm,
            confidence: p.registration.confidence,
            max_trials: p.registration.max_trials.into(),
            allow_reflection: p.registration.allow_reflection,
            seed: p.seed.wrapping_add(u64::from(round)),
        };
        let registration = ransac(self.source.mesh().vertices(), &images, &options, self.observer)?
            .ok_or(MatchError::NoRegistration { tolerance_mm: self.tolerance_mm })?;
        self.observer.trace(&TracePoint {
            energy: Some(bp.energy.total()),
            energy_unary: Some(bp.energy.unary),
            energy_pairwise: Some(bp.energy.pairwise),
            support: Some(registration.support as u32),
            ..TracePoint::new(round, Phase::Registration, 1)
        });
        let transform = self.refine(&registration.target_from_source)?;
        Ok(Round { bp, registration, transform })
    }

    fn images(&self, labeling: &[u32]) -> Vec<Point3<f64>> {
        labeling.iter().map(|&x| self.target.mesh().vertices()[x as usize]).collect()
    }

    fn refine(&self, start: &RigidTransform) -> Result<RigidTransform, MatchError> {
        let metric = match self.parameters.registration.refine {
            Refinement::None => return Ok(*start),
            Refinement::PointToPoint => IcpMetric::PointToPoint,
            Refinement::PointToPlane => IcpMetric::PointToPlane,
        };
        self.observer.phase(Phase::Refinement);
        let options = IcpOptions { metric, keep: ICP_KEEP, max_iterations: ICP_ITERATIONS, tolerance: ICP_TOLERANCE };
        let report = refine_icp(self.source.mesh().vertices(), &self.closest, start, &options, self.observer)?;
        Ok(report.target_from_source)
    }

    fn outcome(&self, round: Round, trials: u64) -> MatchOutcome {
        let Round { bp, registration, transform } = round;
        let n = bp.labeling.len();
        let images = self.images(&bp.labeling);
        let residual = |i: usize| (transform.apply(&self.source.mesh().vertices()[i]) - images[i]).norm();
        let residuals: Vec<f64> = (0..n).map(residual).collect();
        let inlier: Vec<bool> = residuals.iter().map(|&r| r <= self.tolerance_mm).collect();
        let inliers = inlier.iter().filter(|&&m| m).count();
        let squares: f64 = (0..n).filter(|&i| inlier[i]).map(|i| residuals[i] * residuals[i]).sum();
        // Back to the numbering of the inputs, in its order.
        let mut rows: Vec<(u32, usize)> = self.source.surface.original.iter().copied().zip(0..n).collect();
        rows.sort_unstable();
        let correspondences = Correspondences {
            source: rows.iter().map(|&(original, _)| original).collect(),
            target: rows.iter().map(|&(_, i)| self.target.surface.original[bp.labeling[i] as usize]).collect(),
            confidence: rows.iter().map(|&(_, i)| bp.confidence[i]).collect(),
            inlier: rows.iter().map(|&(_, i)| inlier[i]).collect(),
        };
        MatchOutcome {
            transform: transform_document(&transform),
            support: SupportDocument {
                inliers: inliers as u32,
                ratio: inliers as f64 / n as f64,
                rms_mm: if inliers > 0 { (squares / inliers as f64).sqrt() } else { 0.0 },
                tolerance_mm: self.tolerance_mm,
                trials,
                confidence_reached: registration.confidence_reached,
            },
            surface_distance: surface_distance(self.source, self.target.mesh(), &self.closest.index, &transform),
            energy: EnergyDocument {
                initial: self.model.energy(&self.model.unary_minimum()).total(),
                r#final: bp.energy.total(),
                unary: bp.energy.unary,
                pairwise: bp.energy.pairwise,
            },
            topology: consistency(self.model, &bp.labeling),
            correspondences,
            stop_reason: match bp.stop {
                BpStop::Converged => StopReason::Converged,
                BpStop::MaxIterations => StopReason::MaxIterations,
            },
        }
    }
}
