//! Values passed between the stages of a match.

use super::{bean, motion};
use crate::answer::displaced::{Images, VertexImages, labeling_of_energy};
use crate::answer::report::build_outcome;
use crate::pair::problem::{MatchProblem, Problem};
use crate::pipeline::images::find_images;
use crate::pipeline::pose::find_pose;
use crate::poses::posed::{InferredPose, PoseResult};
use crate::surface::levels::Levels;
use crate::thesis::coarse::prepare_problem;
use crate::{MatchError, MatchOutcome, Observer, Phase, Silent, SurfaceMesh, TracePoint, match_surfaces};
use homolog_contract::parameters::{MatchParameters, Method, resolve};
use homolog_contract::result::{Feedback, PoseOrigin, RoundDocument, StopReason};
use homolog_registration::RigidTransform;
use nalgebra::Point3;
use serde_json::{Value, json};
use std::sync::Mutex;

/// The bean, and the bean slightly deformed and moved. No three distances are equal on both.
fn pair() -> (SurfaceMesh, SurfaceMesh) {
    let source = bean();
    let deformed = source.vertices().iter().map(|p| Point3::new(p.x, p.y * (1.0 + 0.003 * p.x), 1.01 * p.z));
    let target = source.with_vertices(deformed.collect()).unwrap().transformed(&motion());
    (source, target)
}

fn parameters(request: Value) -> MatchParameters {
    resolve(&request).unwrap()
}

/// Calls `see` with the results of each stage for the pair.
fn stages(
    request: Value,
    see: impl FnOnce(&MatchProblem<'_>, &PoseResult<'_>, Result<&VertexImages, MatchError>),
) -> Result<MatchOutcome, MatchError> {
    let ((source, target), p) = (pair(), parameters(request));
    let levels = [&source, &target].map(|mesh| Levels::new(mesh, p.inference.coarse_vertices));
    let coarse = prepare_problem(&levels[0], &levels[1], &p, &Silent)?;
    let posed = find_pose(&coarse)?;
    let displaced = find_images(&coarse, &posed, None);
    see(&coarse, &posed, displaced.as_ref().map_err(Clone::clone));
    displaced.map(|displaced| build_outcome(&coarse, &posed, &displaced))
}

/// Rotation between `found` and the motion of the pair, degrees.
fn off(found: &RigidTransform) -> f64 {
    let truth = RigidTransform {
        rotation: *motion().rotation.to_rotation_matrix().matrix(),
        translation: motion().translation.vector,
    };
    found.angle_to(&truth).to_degrees()
}

/// An allowed tolerance that no three labels meet.
const TINY_MM: f64 = 1e-12;

fn tiny_tolerance(mut request: Value) -> Value {
    request["registration"]["tolerance_mm"] = json!(TINY_MM);
    request
}

#[test]
fn the_coarse_stage_builds_the_energy_on_the_level_that_is_asked_for() {
    for (n_sites, is_direct) in [(json!(200), false), (Value::Null, true)] {
        let request = json!({"inference": {"coarse_vertices": n_sites, "max_iterations": 2}});
        stages(request, |coarse, _, _| {
            let Problem::Energy(problem) = &coarse.problem else { panic!("an energy was asked for") };
            let n = problem.scene.source.mesh().n_vertices();
            assert_eq!(problem.model.variables.n_vertices(), n);
            assert_eq!(problem.model.n_labels(), problem.scene.target.mesh().n_vertices());
            assert_eq!((coarse.is_direct(), n == 642), (is_direct, is_direct), "{n} variables");
            assert_eq!(coarse.full.source.mesh().n_vertices(), 642);
            assert_eq!(problem.lower_bound, None);
        })
        .unwrap();
    }
    stages(json!({"method": "rigid"}), |coarse, _, _| assert!(matches!(coarse.problem, Problem::Registration)))
        .unwrap();
}

#[test]
fn the_rounds_choose_one_of_those_that_they_report() {
    let outcome = stages(json!({"clamping": {"mode": "soft"}}), |coarse, posed, _| {
        let PoseResult::Inference { problem, inferred } = posed else { panic!("an energy was asked for") };
        assert_eq!(inferred.map.labeling.len(), problem.model.variables.n_vertices());
        assert!(inferred.map.labeling.len() < coarse.full.source.mesh().n_vertices() + 1);
        assert_eq!(inferred.rounds.iter().filter(|r| r.chosen).count(), 1);
        assert!(inferred.rounds.iter().enumerate().all(|(k, r)| r.round == k as u32 && r.support >= 3));
        let feedback: Vec<Feedback> = inferred.rounds.iter().map(|r| r.feedback).collect();
        assert_eq!(feedback[..2], [Feedback::None, Feedback::Soft]);
        let InferredPose::Supported { transform, trials, .. } = &inferred.pose else {
            panic!("the labels support a pose")
        };
        assert!(off(transform) < 5.0 && *trials > 0, "{} degrees", off(transform));
    })
    .unwrap();
    assert!(outcome.support.trials > 0);
}

#[test]
fn registration_alone_poses_all_vertices_and_the_next_stage_answers_them_with_vertices() {
    let outcome = stages(json!({"method": "rigid"}), |coarse, posed, displaced| {
        let PoseResult::Registration(registered) = posed else { panic!("no energy was asked for") };
        assert!(off(&registered.transform) < 3.0 && !registered.ambiguous_axes);
        let displaced = displaced.unwrap();
        assert!(matches!(displaced.images, Images::OnVertices));
        assert_eq!(displaced.transform, registered.transform);
        assert_eq!(displaced.poses, registered.poses);
        assert_eq!(displaced.labeling.len(), coarse.full.source.mesh().n_vertices());
    })
    .unwrap();
    assert_eq!((outcome.stop_reason, outcome.energy), (StopReason::RegistrationOnly, None));
}

#[test]
fn a_displacement_field_answers_all_vertices_whatever_level_the_pose_was_found_on() {
    stages(json!({"inference": {"coarse_vertices": 200}}), |coarse, posed, displaced| {
        let PoseResult::Inference { problem, .. } = posed else { panic!("an energy was asked for") };
        let displaced = displaced.unwrap();
        let Images::Smooth(smooth) = &displaced.images else { panic!("a field was asked for") };
        let n = coarse.full.source.mesh().n_vertices();
        assert_eq!([smooth.points.len(), smooth.moved.len(), smooth.no_counterpart.len()], [n; 3]);
        assert_eq!([displaced.labeling.len(), displaced.confidence.len(), displaced.spread_mm.len()], [n; 3]);
        assert!(displaced.reliability.as_ref().unwrap().reliable);
        assert!(displaced.poses.iter().any(|p| p.origin == PoseOrigin::Search || p.origin == PoseOrigin::Inference));
        let labeling = labeling_of_energy(coarse.source, coarse.target, &displaced.labeling);
        assert_eq!(labeling.len(), problem.model.variables.n_vertices());
        // The images of a nearly identical surface break few edges of the energy.
        assert!(problem.model.broken_edges(&labeling) * 20 < problem.model.variables.n_directed_edges());
    })
    .unwrap();
}

#[test]
fn without_a_field_a_coarse_labeling_is_answered_with_the_nearest_vertices() {
    let request = json!({"inference": {"coarse_vertices": 200}, "displacement": {"mode": "none"}});
    let outcome = stages(request, |coarse, posed, displaced| {
        let displaced = displaced.unwrap();
        assert!(matches!(displaced.images, Images::OnVertices) && displaced.poses.is_empty());
        assert_eq!(Some(displaced.transform), posed.transform());
        assert_eq!(displaced.labeling.len(), coarse.full.source.mesh().n_vertices());
    })
    .unwrap();
    // The energy is that of the labels of the chosen round.
    let chosen = outcome.rounds.iter().find(|r| r.chosen).unwrap();
    assert_eq!(outcome.energy.unwrap().r#final, chosen.energy);
}

#[test]
fn a_labeling_that_supports_no_transform_is_a_reported_round_and_the_match_goes_on() {
    let outcome = stages(tiny_tolerance(json!({"inference": {"coarse_vertices": 200}})), |_, posed, displaced| {
        let PoseResult::Inference { inferred, .. } = posed else { panic!("an energy was asked for") };
        assert!(matches!(inferred.pose, InferredPose::Unsupported) && posed.transform().is_none());
        let displaced = displaced.unwrap();
        assert!(off(&displaced.transform) < 3.0, "{} degrees", off(&displaced.transform));
        assert!(displaced.poses.iter().all(|p| p.origin == PoseOrigin::Search), "{:?}", displaced.poses);
    })
    .unwrap();
    let [RoundDocument { support: 0, chosen: false, feedback: Feedback::None, .. }] = outcome.rounds[..] else {
        panic!("{:?}", outcome.rounds)
    };
    assert_eq!((outcome.support.trials, outcome.support.confidence_reached), (0, false));
    assert!(outcome.surface_distance.max_mm < 1.0 && outcome.energy.is_some());
    assert_eq!(outcome.support.tolerance_mm, TINY_MM);
}

#[test]
fn without_a_displacement_field_only_the_rounds_of_an_energy_can_lack_a_registration() {
    let (source, target) = pair();
    for method in [Method::Thesis, Method::Gibbs, Method::Metropolis, Method::LasVegas] {
        let mut request = json!({"method": method.name(), "registration": {"max_trials": 200}});
        request["inference"]["max_iterations"] = json!(2);
        let found = match_surfaces(&source, &target, &parameters(tiny_tolerance(request)), &Silent);
        assert_eq!(found, Err(MatchError::NoRegistration { tolerance_mm: TINY_MM }), "{}", method.name());
    }
    for method in [Method::Icp, Method::Foe, Method::Rigid] {
        let request = tiny_tolerance(json!({"method": method.name()}));
        assert!(match_surfaces(&source, &target, &parameters(request), &Silent).is_ok(), "{}", method.name());
    }
}

/// Records all reports.
#[derive(Default)]
struct Record(Mutex<(Vec<Phase>, Vec<TracePoint>)>);

impl Observer for Record {
    fn phase(&self, phase: Phase) {
        self.0.lock().unwrap().0.push(phase);
    }
    fn trace(&self, point: &TracePoint) {
        self.0.lock().unwrap().1.push(point.clone());
    }
}

#[test]
fn an_unsupported_round_is_traced_with_support_0() {
    let (source, target) = pair();
    let record = Record::default();
    let p = parameters(tiny_tolerance(json!({"inference": {"coarse_vertices": 200, "max_iterations": 5}})));
    match_surfaces(&source, &target, &p, &record).unwrap();
    let (phases, trace) = record.0.into_inner().unwrap();
    use Phase::{Displacement, Features, Inference, Registration, Reporting};
    assert_eq!(phases, [Features, Features, Inference, Registration, Displacement, Reporting]);
    let of_registration: Vec<_> = trace.iter().filter(|t| t.phase == Registration).map(|t| t.support).collect();
    assert_eq!(of_registration, [Some(0)]);
    let [.., field, answer] = &trace[..] else { panic!("{trace:?}") };
    assert_eq!((field.phase, answer.phase, answer.chosen), (Displacement, Reporting, true));
}
