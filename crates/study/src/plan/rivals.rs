//! The matches in the rival poses of subjects whose pose is ambiguous, as a pure function of the finished matches.
//!
//! A match in a rival pose is that of the template with the surface of the subject, turned back by the rotation of the pose
//! about the origin, so that the pose becomes a translation. The field then begins from the centroids alone
//! ([`RIVAL_PARAMETERS`]), and no other pose competes.
//!
//! A match follows few poses, so the right one may not be among the rivals that it names. But a rival of one subject is an
//! approximate symmetry of the template, which all subjects share: the poses of a subject are those that its own match names, and
//! the pose of its match after the symmetries that the matches of others have shown, the most frequent first, and products of these.

use crate::align::{area_weights, fit_onto, points};
use crate::cohort::Role;
use crate::error::StudyError;
use crate::plan::{Purpose, Records, Step, Study, Task, Template};
use crate::record::{Facts, Record, hash_of_texts};
use crate::rotation::{angle, of_rows, rows};
use crate::settings::{FEWEST_RELIABLE, Rivals};
use homolog_contract::parameters::{
    Algorithm, Bending, DisplacementMode, FieldStarts, InitialPose, MatchParameters, Refinement,
};
use homolog_contract::result::UnreliableReason;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::SAME_POSE_ANGLE;
use nalgebra::{Matrix3, Point3};
use rayon::prelude::*;
use std::collections::{BTreeSet, HashSet};

/// Version of these matches in the names of their records.
const VERSION: &str = "rival 1";
/// Most rival poses of a subject; a box and an ellipsoid have three.
const MOST: usize = 4;
/// Matches in rival poses for each subject of a study at most, on average: if all subjects were ambiguous, the structure itself would
/// be symmetric.
pub(crate) const PER_SUBJECT: usize = 2;
/// Matches of a step, whose surfaces are in memory at a time: at least so many, and this share of the subjects. Every step of the
/// service opens the study anew, and the share bounds how often.
const AT_A_TIME: usize = 64;
const SHARE_AT_A_TIME: usize = 32;

/// Most matches in rival poses of a step of a study of `n` subjects.
pub(crate) fn at_a_time(n: usize) -> usize {
    AT_A_TIME.max(n / SHARE_AT_A_TIME)
}

/// Where the parameters of a match in a rival pose differ from those of the study: JSON pointers and values.
pub const RIVAL_PARAMETERS: [(&str, &str); 4] = [
    ("/registration/initial", "centroids"),
    ("/registration/refine", "none"),
    ("/displacement/starts", "initial"),
    ("/displacement/bending", "none"),
];

/// A rival pose of a subject.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rival {
    /// The subject, as an index into the cohort.
    pub subject: usize,
    /// The rotation from the template to the surface of its records.
    pub rotation: [[f64; 3]; 3],
}

/// A subject of ambiguous pose, and its maps in the rival poses.
#[derive(Debug, Clone, PartialEq)]
pub struct SubjectRivals {
    /// The subject, as an index into the cohort.
    pub subject: usize,
    /// The rotations of the poses.
    pub rotations: Vec<[[f64; 3]; 3]>,
    /// Keys of the records in these poses. Their points are those of the surface turned back.
    pub keys: Vec<String>,
}

/// What the record of a match of the template says about the pose of its subject.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseEvidence {
    /// Whether it is a map that is not known to be unreliable.
    is_reliable: bool,
    /// The open pose, if only the pose is in doubt.
    open: Option<OpenPose>,
}

/// A pose that is ambiguous: the rotation of the match, and those of the rivals that this names.
#[derive(Debug, Clone, PartialEq)]
struct OpenPose {
    own: Matrix3<f64>,
    rivals: Vec<Matrix3<f64>>,
}

impl PoseEvidence {
    /// What a record of a match of a surface with these vertices and area weights says.
    fn of(record: &Record, vertices: &[Point3<f64>], weights: &[f64]) -> Self {
        if !record.is_map_of(vertices.len()) {
            return PoseEvidence { is_reliable: false, open: None };
        }
        let fitted = is_ambiguous(&record.facts)
            .then(|| fit_onto(vertices, &points(&record.points), weights, false).ok())
            .flatten();
        let open = fitted.map(|fitted| OpenPose {
            own: fitted.rotation,
            rivals: record.facts.rivals.iter().take(MOST).map(of_rows).collect(),
        });
        PoseEvidence { is_reliable: record.facts.reliable != Some(false), open }
    }
}

/// Missing matches in rival poses, or all of them.
pub(crate) enum RivalsState {
    /// All matches exist.
    Ready(Vec<SubjectRivals>),
    /// A step that comes first.
    Missing(Step),
}

/// Makes a match keep the pose in which the surfaces are; the values of [`RIVAL_PARAMETERS`].
pub(crate) fn keep_pose(parameters: &mut MatchParameters) {
    parameters.registration.initial = InitialPose::Centroids;
    parameters.registration.refine = Refinement::None;
    parameters.displacement.starts = FieldStarts::Initial;
    parameters.displacement.bending = Bending::None;
}

/// Whether the poses of such matches come from the search that the field compares. Landmarks would have to be turned too, and
/// they say which pose is right.
fn are_compared(parameters: &MatchParameters) -> bool {
    parameters.inference.algorithm == Algorithm::None
        && parameters.registration.initial == InitialPose::Search
        && parameters.displacement.mode == DisplacementMode::Smooth
        && parameters.landmarks.is_empty()
}

/// Whether the only doubt about a match is its pose, and rival poses are known.
fn is_ambiguous(facts: &Facts) -> bool {
    let is_only = facts.reasons.iter().all(|reason| reason == UnreliableReason::AmbiguousPose.name());
    facts.reliable == Some(false) && is_only && !facts.rivals.is_empty()
}

/// Adds a rotation to those that are counted; near ones are the same.
fn count(rotation: Matrix3<f64>, counted: &mut Vec<(usize, Matrix3<f64>)>) {
    match counted.iter_mut().find(|(_, known)| are_same(known, &rotation)) {
        Some((n, _)) => *n += 1,
        None => counted.push((1, rotation)),
    }
}

fn are_same(a: &Matrix3<f64>, b: &Matrix3<f64>) -> bool {
    angle(&(a.transpose() * b)) < SAME_POSE_ANGLE
}

/// The approximate symmetries of the template that the rivals of subjects show, the most frequent first, then products of two.
/// `ambiguous` in an order that does not depend on that of the cohort.
fn symmetries(ambiguous: &[&OpenPose]) -> Vec<Matrix3<f64>> {
    let mut counted = Vec::new();
    for OpenPose { own, rivals } in ambiguous {
        rivals.iter().for_each(|rival| count(own.transpose() * rival, &mut counted));
    }
    counted.sort_by_key(|(n, _)| std::cmp::Reverse(*n));
    counted.truncate(MOST);
    let mut all: Vec<Matrix3<f64>> = counted.into_iter().map(|(_, symmetry)| symmetry).collect();
    let shown = all.len();
    for (a, b) in (0..shown).flat_map(|a| (0..shown).map(move |b| (a, b))) {
        let product = all[a] * all[b];
        if !are_same(&product, &Matrix3::identity()) && !all.iter().any(|known| are_same(known, &product)) {
            all.push(product);
        }
    }
    all
}

/// The rival poses of a subject: those of its match, and that of its match after each of the symmetries.
fn poses(of: &OpenPose, symmetries: &[Matrix3<f64>]) -> Vec<[[f64; 3]; 3]> {
    let mut all = of.rivals.clone();
    for symmetry in symmetries {
        let pose = of.own * symmetry;
        if !are_same(&pose, &of.own) && !all.iter().any(|known| are_same(known, &pose)) {
            all.push(pose);
        }
    }
    all.truncate(MOST);
    all.iter().map(rows).collect()
}

/// Names the match in a rival pose by the match that found the pose, which depends on everything else.
fn key_of(own: &str, rotation: &[[f64; 3]; 3]) -> String {
    hash_of_texts([VERSION, env!("CARGO_PKG_VERSION"), own, &format!("{rotation:?}")])
}

impl Study {
    /// The next matches in rival poses, or all of them. `keys`: of the subjects' matches, which exist, with `template`; rows that
    /// are `composed` have none.
    ///
    /// Groups of fewer than three reliable subjects decide nothing and need none. There are at most twice as many matches as subjects
    /// ([`PER_SUBJECT`]): beyond them, subjects stay open.
    ///
    /// # Errors
    /// Errors of reading records; [`StudyError::Interrupted`].
    ///
    /// # Cost
    /// Reads the record of every subject once, whatever the number of steps.
    pub(crate) fn rivals(
        &self,
        template: &Template,
        (keys, composed): (&[String], &HashSet<usize>),
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<RivalsState, StudyError> {
        if self.settings.rivals == Rivals::LeaveOut || !are_compared(&self.settings.parameters) {
            return Ok(RivalsState::Ready(Vec::new()));
        }
        let (vertices, weights) = (template.mesh.vertices(), area_weights(&template.mesh));
        let read = |record: &Record| PoseEvidence::of(record, vertices, &weights);
        let found: Vec<Option<PoseEvidence>> = keys
            .par_iter()
            .enumerate()
            .map(|(subject, key)| {
                checkpoint(observer)?;
                if composed.contains(&subject) { Ok(None) } else { records.pose(key, &read) }
            })
            .collect::<Result<_, StudyError>>()?;
        let is_observed = |subject: &usize| {
            let is_of_model = self.cohort.subjects[*subject].role == Role::Model;
            is_of_model && found[*subject].as_ref().is_some_and(|said| said.is_reliable)
        };
        let reliable: BTreeSet<&String> = (0..keys.len()).filter(is_observed).map(|subject| &keys[subject]).collect();
        if reliable.len() < FEWEST_RELIABLE {
            return Ok(RivalsState::Ready(Vec::new()));
        }
        let open = || found.iter().enumerate().filter_map(|(k, said)| Some((k, said.as_ref()?.open.as_ref()?)));
        let mut by_key: Vec<(usize, &OpenPose)> = open().collect();
        by_key.sort_by_key(|(subject, _)| &keys[*subject]);
        let symmetries = symmetries(&by_key.iter().map(|(_, pose)| *pose).collect::<Vec<_>>());
        let mut left = PER_SUBJECT * keys.len();
        let mut followed: Vec<(usize, Vec<[[f64; 3]; 3]>)> = Vec::new();
        for (subject, pose) in by_key {
            let rotations = poses(pose, &symmetries);
            if rotations.len() <= left {
                left -= rotations.len();
                followed.push((subject, rotations));
            }
        }
        followed.sort_by_key(|(subject, _)| *subject);
        let (mut tasks, mut all) = (Vec::new(), Vec::new());
        for (subject, rotations) in followed {
            let of: Vec<String> = rotations.iter().map(|rotation| key_of(&keys[subject], rotation)).collect();
            tasks.extend(of.iter().zip(&rotations).map(|(key, &rotation)| Task {
                key: key.clone(),
                rival: Some(Rival { subject, rotation }),
                ..Task::between_templates(0)
            }));
            all.push(SubjectRivals { subject, rotations, keys: of });
        }
        match Step::missing(Purpose::Rivals, template, tasks, Vec::new(), records) {
            None => Ok(RivalsState::Ready(all)),
            Some(Step::Match { purpose, template, mut tasks, finished, own }) => {
                tasks.truncate(at_a_time(keys.len()));
                (0..).zip(&mut tasks).for_each(|(at, task)| task.own = Some(at));
                Ok(RivalsState::Missing(Step::Match { purpose, template, tasks, finished, own }))
            }
            Some(step) => Ok(RivalsState::Missing(step)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_contract::parameters::{Method, preset, resolve};

    #[test]
    fn the_pointers_say_what_the_parameters_do() {
        let before = preset(Method::Balanced);
        let mut typed = before.clone();
        keep_pose(&mut typed);
        let mut stated = serde_json::to_value(&before).unwrap();
        for (pointer, value) in RIVAL_PARAMETERS {
            *stated.pointer_mut(pointer).unwrap() = value.into();
        }
        assert_eq!(serde_json::to_value(&typed).unwrap(), stated);
        assert_eq!(resolve(&stated).unwrap(), typed);
    }

    #[test]
    fn only_a_doubt_about_the_pose_alone_has_rivals() {
        let facts = |reasons: &[&str], rivals: usize| Facts {
            reliable: Some(reasons.is_empty()),
            reasons: reasons.iter().map(|reason| (*reason).to_owned()).collect(),
            rivals: vec![[[0.0; 3]; 3]; rivals],
            ..Facts::default()
        };
        assert!(is_ambiguous(&facts(&["ambiguous_pose"], 1)));
        assert!(!is_ambiguous(&facts(&["ambiguous_pose"], 0)), "records of earlier builds name none");
        assert!(!is_ambiguous(&facts(&["ambiguous_pose", "unlike_shape"], 1)));
        assert!(!is_ambiguous(&facts(&[], 1)));
    }

    #[test]
    fn symmetries_that_others_show_complete_the_poses() {
        let half = |axis: nalgebra::Unit<nalgebra::Vector3<f64>>| {
            *nalgebra::Rotation3::from_axis_angle(&axis, std::f64::consts::PI).matrix()
        };
        use nalgebra::Vector3;
        let (x, y, z) = (half(Vector3::x_axis()), half(Vector3::y_axis()), half(Vector3::z_axis()));
        let turned = |k: f64| *nalgebra::Rotation3::from_euler_angles(0.3 * k, 0.9 * k, -0.4 * k).matrix();
        let ambiguous = |k: f64, rivals: &[Matrix3<f64>]| OpenPose {
            own: turned(k),
            rivals: rivals.iter().map(|of| turned(k) * of).collect(),
        };
        let near = *nalgebra::Rotation3::from_euler_angles(0.1, 0.05, -0.1).matrix();
        let all = [ambiguous(1.0, &[x]), ambiguous(2.0, &[y * near]), ambiguous(3.0, &[x * near])];
        let found = symmetries(&all.iter().collect::<Vec<_>>());
        assert!(found.len() == 3 && are_same(&found[0], &x) && are_same(&found[1], &y) && are_same(&found[2], &z));
        for of in &all {
            let poses: Vec<Matrix3<f64>> = poses(of, &found).iter().map(of_rows).collect();
            let has = |symmetry: &Matrix3<f64>| poses.iter().any(|pose| are_same(pose, &(of.own * symmetry)));
            assert!(poses.len() == 3 && has(&x) && has(&y) && has(&z));
            assert_eq!(poses[0], of.rivals[0], "first that of the match, as it is");
        }
        assert!(symmetries(&[]).is_empty());
    }

    #[test]
    fn poses_of_methods_that_are_not_compared_have_no_rivals() {
        assert!(are_compared(&preset(Method::Balanced)));
        for method in [Method::Cpd, Method::Thesis, Method::Icp] {
            assert!(!are_compared(&preset(method)), "{}", method.name());
        }
    }
}
