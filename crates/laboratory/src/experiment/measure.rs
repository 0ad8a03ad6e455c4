//! One match of one pair, and the metrics computed from it.

use super::Clock;
use super::pairs::Pair;
use super::units::Measurement;
use homolog_contract::parameters::{DisplacementMode, MatchParameters, ParameterError, resolve};
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use homolog_registration::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};
use parking_lot::Mutex;
use rayon::prelude::*;
use serde_json::Value;

/// Maximum number of points of a curve; a trace of thousands of sweeps is thinned to this.
const CURVE_POINTS: usize = 200;
/// A registration within this angle of the reference counts as successful, degrees.
const SUCCESS_DEG: f64 = 10.0;

/// Records the trace with times.
struct Recorder<'a> {
    clock: &'a Clock,
    seen: Mutex<Recorded>,
}

#[derive(Default)]
struct Recorded {
    points: Vec<(f64, TracePoint)>,
    phases: Vec<(f64, Phase)>,
}

impl Recorder<'_> {
    fn record(&self, write: impl FnOnce(&mut Recorded, f64)) {
        let now = (self.clock)().as_secs_f64();
        write(&mut self.seen.lock(), now);
    }
}

impl Observer for Recorder<'_> {
    fn phase(&self, phase: Phase) {
        self.record(|seen, now| seen.phases.push((now, phase)));
    }

    fn trace(&self, point: &TracePoint) {
        self.record(|seen, now| seen.points.push((now, point.clone())));
    }
}

/// Matches the pair with the parameters of `request`. Shares are in `[0, 1]`; other quantities have their unit in the
/// name.
///
/// # Errors
/// One line with the reason if the match fails.
pub(super) fn measure_match(pair: &Pair, request: &Value, clock: &Clock) -> Result<Measurement, String> {
    observed_match(pair, request, clock).map(|(measurement, _)| measurement)
}

/// The effective parameters of `request`. A request without a method is an experiment on the energy itself: every
/// vertex is a variable, and the labeling is the result.
pub(super) fn studied(request: &Value) -> Result<MatchParameters, String> {
    let named = |faults: Vec<ParameterError>| {
        let faults: Vec<_> = faults.iter().map(|f| format!("{}: {}", f.pointer, f.detail)).collect();
        faults.join("; ")
    };
    let is_of_energy = request.get("method").is_none();
    let mut request = request.clone();
    if is_of_energy && request.pointer("/inference/algorithm").is_none() {
        request["inference"]["algorithm"] = "max_product".into();
    }
    let mut parameters = resolve(&request).map_err(named)?;
    if is_of_energy {
        parameters.inference.coarse_vertices = None;
        parameters.displacement.mode = DisplacementMode::None;
    }
    Ok(parameters)
}

/// Like [`measure_match`]; also returns the outcome.
pub(super) fn observed_match(
    pair: &Pair,
    request: &Value,
    clock: &Clock,
) -> Result<(Measurement, MatchOutcome), String> {
    let parameters = studied(request)?;
    let recorder = Recorder { clock, seen: Mutex::default() };
    let begin = clock().as_secs_f64();
    let outcome = match_surfaces(&pair.source, &pair.target, &parameters, &recorder).map_err(|e| e.to_string())?;
    let mut m = Measurement::default().with("seconds", clock().as_secs_f64() - begin);
    let seen = recorder.seen.into_inner();
    trace(&mut m, &seen);
    documents(&mut m, &outcome);
    ground_truth_errors(&mut m, pair, &outcome);
    m.set("n_source", pair.source.n_vertices() as f64);
    m.set("n_target", pair.target.n_vertices() as f64);
    Ok((m, outcome))
}

/// Energy by iteration and by time in the first round, and the time of its inference.
fn trace(m: &mut Measurement, seen: &Recorded) {
    let mut phases = seen.phases.iter().skip_while(|(_, phase)| *phase != Phase::Inference);
    let Some((begin, _)) = phases.next() else { return };
    if let Some((end, _)) = phases.next() {
        m.set("inference_seconds", end - begin);
    }
    let first = |p: &&(f64, TracePoint)| p.1.round == 0 && p.1.phase == Phase::Inference;
    let points: Vec<_> = seen.points.iter().filter(first).collect();
    let step = points.len().div_ceil(CURVE_POINTS).max(1);
    let kept = points.iter().enumerate().filter(|(k, _)| k % step == 0 || k + 1 == points.len());
    for (_, (seconds, point)) in kept {
        let Some(energy) = point.energy.filter(|e| e.is_finite()) else { continue };
        let curve = |m: &mut Measurement, name: &str, x| m.curves.entry(name.to_owned()).or_default().push([x, energy]);
        curve(m, "energy_by_iteration", f64::from(point.iteration));
        curve(m, "energy_by_second", seconds - begin);
    }
    let rounds = seen.points.iter().map(|(_, p)| p.round + 1).max().unwrap_or(0);
    m.set("rounds", f64::from(rounds));
    m.set("iterations", seen.points.iter().filter(|(_, p)| p.phase == Phase::Inference).count() as f64);
}

/// The numbers of the result document, under the names they have in it.
fn documents(m: &mut Measurement, outcome: &MatchOutcome) {
    let parts = [
        ("", serde_json::to_value(&outcome.topology)),
        ("deformation_", serde_json::to_value(&outcome.deformation)),
        ("energy_", serde_json::to_value(&outcome.energy)),
        ("support_", serde_json::to_value(&outcome.support)),
        ("surface_", serde_json::to_value(&outcome.surface_distance)),
    ];
    for (prefix, document) in parts {
        let Ok(Value::Object(document)) = document else { continue };
        for (name, value) in document {
            if let Some(number) = value.as_f64() {
                m.set(&format!("{prefix}{name}"), number);
            }
        }
    }
    // The rounds count variables; every source vertex is one, unless a coarse level was requested.
    if let Some((first, energy)) = outcome.rounds.first().zip(outcome.energy.as_ref()) {
        m.set("first_support_ratio", f64::from(first.support) / f64::from(energy.n_variables));
    }
    if let Some(triangles) = m.values.get("n_triangles").copied().filter(|n| *n > 0.0) {
        for kind in ["flipped", "degenerate"] {
            if let Some(n) = m.values.get(&format!("{kind}_triangles")).copied() {
                m.set(&format!("{kind}_share"), n / triangles);
            }
        }
    }
}

/// The transform of an outcome.
pub(super) fn found_pose(outcome: &MatchOutcome) -> RigidTransform {
    let rows = outcome.transform.matrix;
    RigidTransform { rotation: Matrix3::from_fn(|i, j| rows[i][j]), translation: Vector3::from_fn(|i, _| rows[i][3]) }
}

/// Errors against the ground truth.
fn ground_truth_errors(m: &mut Measurement, pair: &Pair, outcome: &MatchOutcome) {
    let c = &outcome.correspondences;
    let n = c.source.len().max(1) as f64;
    let couples = || c.source.iter().zip(&c.target).map(|(&i, &x)| (i as usize, x as usize));
    let target = pair.target.vertices();
    if let Some(truth) = &pair.truth {
        let edge_mm = pair.target.mean_edge_length();
        let errors: Vec<f64> = couples().map(|(i, x)| (truth[i] - target[x]).norm()).collect();
        for edges in [1.0, 2.0, 5.0] {
            let right = errors.iter().filter(|&&e| e <= edges * edge_mm).count();
            m.set(&format!("within_{edges}_edges"), right as f64 / n);
        }
        let exact = couples().collect::<Vec<_>>().into_par_iter().filter(|&(i, x)| nearest(target, &truth[i]) == x);
        m.set("within_0_edges", exact.count() as f64 / n);
        m.set("error_mm", errors.iter().sum::<f64>() / n);
    }
    if let Some((source_parts, target_parts)) = &pair.parts {
        let agree = couples().filter(|&(i, x)| source_parts[i] == target_parts[x]).count();
        m.set("part_agreement", agree as f64 / n);
    }
    if let Some(pose) = &pair.pose {
        let angle = found_pose(outcome).angle_to(pose).to_degrees();
        m.set("rotation_error_deg", angle);
        m.set("within_10_deg", f64::from(u8::from(angle <= SUCCESS_DEG)));
    }
}

/// The vertex nearest to `p`; of several, the one with the lowest index.
fn nearest(vertices: &[Point3<f64>], p: &Point3<f64>) -> usize {
    let mut best = (f64::INFINITY, 0);
    for (k, v) in vertices.iter().enumerate() {
        let distance = (v - p).norm_squared();
        if distance < best.0 {
            best = (distance, k);
        }
    }
    best.1
}
