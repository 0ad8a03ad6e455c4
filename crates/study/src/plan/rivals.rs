//! The matches in the rival poses of subjects whose pose is ambiguous, as a pure function of the finished matches.
//!
//! A match in a rival pose is that of the template with the surface of the subject, turned back by the rotation of the pose
//! about the origin, so that the pose becomes a translation. The field then begins from the centroids alone
//! ([`RIVAL_PARAMETERS`]), and no other pose competes.

use crate::cohort::Role;
use crate::error::StudyError;
use crate::plan::{Purpose, Records, Step, Study, Task, Template};
use crate::record::{Facts, hash_of_texts};
use crate::rivals::FEWEST_RELIABLE;
use crate::settings::Rivals;
use homolog_contract::parameters::{
    Algorithm, Bending, DisplacementMode, FieldStarts, InitialPose, MatchParameters, Refinement,
};
use homolog_contract::result::UnreliableReason;
use homolog_primitives::observe::{Observer, checkpoint};
use rayon::prelude::*;
use std::collections::{BTreeSet, HashSet};

/// Version of these matches in the names of their records.
const VERSION: &str = "rival 1";
/// Most rival poses of a subject. The poses of a box are four; a shape of more poses has no feature that a group could see.
const MOST: usize = 4;
/// Matches of a step, whose surfaces are in memory at a time.
const AT_A_TIME: usize = 64;

/// Where the parameters of a match in a rival pose differ from those of the study: JSON pointers and values.
pub const RIVAL_PARAMETERS: [(&str, &str); 4] = [
    ("/registration/initial", "centroids"),
    ("/registration/refine", "none"),
    ("/displacement/starts", "initial"),
    ("/displacement/bending", "none"),
];

/// A rival pose of a subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rival {
    /// The subject, as an index into the cohort.
    pub subject: usize,
    /// The pose, as an index into those of the record of its match.
    pub pose: usize,
}

/// A subject of ambiguous pose, and its maps in the rival poses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SubjectRivals {
    /// The subject, as an index into the cohort.
    pub subject: usize,
    /// Keys of the records in the rival poses, in the order of the poses in the record of its match. Their points are those of
    /// the surface turned back.
    pub keys: Vec<String>,
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

/// Names the match in a rival pose by the match that found the pose, which depends on everything else.
fn key_of(own: &str, rotation: &[[f64; 3]; 3]) -> String {
    hash_of_texts([VERSION, env!("CARGO_PKG_VERSION"), own, &format!("{rotation:?}")])
}

impl Study {
    /// The next matches in rival poses, or all of them. `keys`: of the subjects' matches, which exist, with `template`; rows that
    /// are `composed` have none.
    ///
    /// Groups of fewer than three reliable subjects decide nothing and need none.
    ///
    /// # Errors
    /// Errors of reading records; [`StudyError::Interrupted`].
    ///
    /// # Cost
    /// Reads the record of every subject.
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
        let n_vertices = template.mesh.n_vertices();
        let found: Vec<Option<Facts>> = keys
            .par_iter()
            .enumerate()
            .map(|(k, key)| {
                checkpoint(observer)?;
                let record = if composed.contains(&k) { None } else { records.get(key)? };
                Ok(record.filter(|record| record.is_map_of(n_vertices)).map(|record| record.facts))
            })
            .collect::<Result<_, StudyError>>()?;
        let reliable: BTreeSet<&String> = found
            .iter()
            .zip(keys)
            .zip(&self.cohort.subjects)
            .filter(|(_, subject)| subject.role == Role::Model)
            .filter(|((facts, _), _)| facts.as_ref().is_some_and(|facts| facts.reliable != Some(false)))
            .map(|((_, key), _)| key)
            .collect();
        if reliable.len() < FEWEST_RELIABLE {
            return Ok(RivalsState::Ready(Vec::new()));
        }
        let (mut tasks, mut all) = (Vec::new(), Vec::new());
        for (subject, facts) in found.iter().enumerate() {
            let Some(facts) = facts.as_ref().filter(|facts| is_ambiguous(facts)) else { continue };
            let poses = facts.rivals.iter().take(MOST);
            let of: Vec<String> = poses.map(|rotation| key_of(&keys[subject], rotation)).collect();
            tasks.extend(of.iter().enumerate().map(|(pose, key)| Task {
                key: key.clone(),
                rival: Some(Rival { subject, pose }),
                ..Task::between_templates(0)
            }));
            all.push(SubjectRivals { subject, keys: of });
        }
        match Step::missing(Purpose::Rivals, template, tasks, Vec::new(), records) {
            None => Ok(RivalsState::Ready(all)),
            Some(Step::Match { purpose, template, mut tasks, finished, own }) => {
                tasks.truncate(AT_A_TIME);
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
    fn poses_of_methods_that_are_not_compared_have_no_rivals() {
        assert!(are_compared(&preset(Method::Balanced)));
        for method in [Method::Cpd, Method::Thesis, Method::Icp] {
            assert!(!are_compared(&preset(method)), "{}", method.name());
        }
    }
}
