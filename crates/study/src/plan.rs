//! The next matches of a study, as a pure function of the finished matches.
//!
//! [`Study::next`] replays the study from the start each time: the template, the round, and the matches that exist. No
//! state can therefore be lost: a killed study continues from the records of its matches, and a caller may compute them
//! in any order, on any machine, through any queue. Records are named by their inputs ([`Task::key`]), so that nothing
//! is computed twice.

mod rivals;
mod visits;

pub(crate) use rivals::{PER_SUBJECT as RIVALS_PER_SUBJECT, at_a_time as rivals_at_a_time};
pub use rivals::{PoseEvidence, RIVAL_PARAMETERS, Rival, SubjectRivals};
pub use visits::{OwnMaps, Person};

use crate::align::{WatchedShapes, align, fit_onto};
use crate::average::{next_template, triangle_quality};
use crate::cohort::{Cohort, Role};
use crate::error::StudyError;
use crate::record::Record;
use crate::settings::{MadeTemplate, Settings, Size, TemplateChoice};
use homolog_contract::parameters::{InputParameters, LabelChoice, MatchParameters};
use homolog_formats::ply::write_ply;
use homolog_mesh::{SurfaceMesh, repair};
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_run::intake::{IntakeLimits, prepare_surface};
use nalgebra::Point3;
use rivals::RivalsState;
use serde::{Deserialize, Serialize};
use std::collections::HashSet;
use visits::PersonsState;

/// A surface to which subjects are matched.
#[derive(Debug, Clone, PartialEq)]
pub struct Template {
    /// The surface, triangles, mm.
    pub mesh: SurfaceMesh,
    /// The surface as a PLY file, the source of every match.
    pub ply: Vec<u8>,
    /// Hash of that file.
    pub hash: String,
}

impl Template {
    /// A template from a surface: its triangles, without unused vertices.
    pub fn new(mesh: &SurfaceMesh) -> Self {
        let mesh = repair::drop_unused(&repair::triangulated(mesh)).mesh;
        let ply = write_ply(&mesh);
        Template { mesh, hash: hash(&ply), ply }
    }
}

/// A template with the history of its making; kept in the study's folder, so that a subject added later costs one
/// match.
#[derive(Debug, Clone, PartialEq)]
pub struct TemplateHistory {
    /// The template.
    pub template: Template,
    /// The rounds in which it was made.
    pub rounds: Vec<Round>,
}

/// A round of matching and averaging.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Round {
    /// Number of subjects whose shapes were averaged.
    pub subjects: usize,
    /// RMS distance of the mean from the template it replaces, over both surfaces, independent of their vertices, mm.
    pub moved_mm: f64,
    /// This distance as a share of the mean edge length.
    pub moved_share: f64,
    /// RMS distance by which averaging moved vertices along the surface, over the surface, mm.
    #[serde(default)]
    pub slid_mm: f64,
    /// Share of that distance which was reversed.
    #[serde(default)]
    pub put_back: f64,
    /// Quality of the triangles of the next template, 1 for equilateral ones: mean, and lowest 5th percentile.
    #[serde(default)]
    pub triangle_quality: [f64; 2],
    /// Volume of the mean, mm³.
    pub volume_mm3: f64,
}

/// A match that a study needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// Name of the record: a hash of both files, the parameters and the version of the program, 64 hexadecimal digits.
    pub key: String,
    /// The subject whose surface moves; `None` for a template.
    pub source: Option<usize>,
    /// The subject that stays; `None` for a template.
    pub target: Option<usize>,
    /// The template of a person, as an index into those of the step, that takes part: it moves onto a subject, or the
    /// template of the group onto it. `None` if the template of the group is the only one. For a rival pose, the surface of
    /// the subject in that pose.
    pub own: Option<usize>,
    /// The rival pose that the match keeps, if it is for one.
    pub rival: Option<Rival>,
}

impl Task {
    /// The match of the template of the group to one of a person, without its key.
    pub(crate) fn between_templates(own: usize) -> Self {
        Task { key: String::new(), source: None, target: None, own: Some(own), rival: None }
    }
}

/// Next step of a study; `M` is what there is at the end.
#[derive(Debug, Clone, PartialEq)]
pub enum Step<M = Box<Matched>> {
    /// These matches are missing; no other step is possible before they exist.
    Match {
        /// Their purpose.
        purpose: Purpose,
        /// The template of the tasks.
        template: Box<Template>,
        /// The matches, in the order of the cohort.
        tasks: Vec<Task>,
        /// Number of existing matches for this purpose; of persons, for those whose templates are in `own`.
        finished: usize,
        /// The templates of persons of the tasks, or the surfaces of subjects in rival poses.
        own: Vec<Template>,
    },
    /// All matches exist.
    Matched(M),
}

impl Step {
    /// The step to the missing ones of these matches; `None` if all exist.
    fn missing(
        purpose: Purpose,
        template: &Template,
        tasks: Vec<Task>,
        own: Vec<Template>,
        records: &dyn Records,
    ) -> Option<Self> {
        // Subjects with equal files share a record.
        let mut seen = HashSet::new();
        let mut tasks: Vec<Task> = tasks.into_iter().filter(|task| seen.insert(task.key.clone())).collect();
        tasks.retain(|task| !records.has(&task.key));
        let finished = seen.len() - tasks.len();
        (!tasks.is_empty()).then(|| Step::Match { purpose, template: Box::new(template.clone()), tasks, finished, own })
    }
}

/// Purpose of matches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// A round of the template, from 1.
    Template(usize),
    /// Templates of persons with several visits: one visit with the others (1), their first means with all visits (2), the
    /// template of the group with their last means (3).
    Visits(usize),
    /// Every subject with the template, and the matches that measure consistency.
    Subjects,
    /// The template with subjects of ambiguous pose, in each rival pose.
    Rivals,
}

/// A study with all its matches.
#[derive(Debug, Clone, PartialEq)]
pub struct Matched {
    /// The template, and its making.
    pub making: TemplateHistory,
    /// Key of the map of the template to each subject: its match, or for visits of a person with its own template the
    /// composition that [`Study::advance`] makes.
    pub keys: Vec<String>,
    /// The maps of persons with templates of their own.
    pub own: Vec<OwnMaps>,
    /// Keys of the matches that measure consistency.
    pub cycles: Cycles,
    /// The subjects of ambiguous pose with the maps in their other poses.
    pub rivals: Vec<SubjectRivals>,
}

/// The matches that measure consistency.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cycles {
    /// A ring of subjects, as indices into the cohort; each is followed by the next.
    pub ring: Vec<usize>,
    /// Key of the match of each of them to the template.
    pub to_template: Vec<String>,
    /// Key of the match of each to the next.
    pub forward: Vec<String>,
    /// Key of the match of the next to each.
    pub backward: Vec<String>,
}

/// Storage of records.
pub trait Records: Sync {
    /// The record with a key, if it exists.
    ///
    /// # Errors
    /// [`StudyError`] if it exists and cannot be read.
    fn get(&self, key: &str) -> Result<Option<Record>, StudyError>;
    /// Whether a record exists.
    fn has(&self, key: &str) -> bool;
    /// What the record with a key says about the pose of its subject, by `read`, which depends on the key alone; `None` without
    /// a record. A planner asks before every step, so storage may keep the answer.
    ///
    /// # Errors
    /// [`StudyError`] if the record exists and cannot be read.
    fn pose(&self, key: &str, read: &dyn Fn(&Record) -> PoseEvidence) -> Result<Option<PoseEvidence>, StudyError> {
        Ok(self.get(key)?.as_ref().map(read))
    }
}

/// A study: its subjects, its settings, and the first surface of the template.
#[derive(Debug, Clone)]
pub struct Study {
    /// The subjects and their covariates.
    pub cohort: Cohort,
    /// The settings.
    pub settings: Settings,
    /// Hash of each subject's file.
    pub hashes: Vec<String>,
    /// The given template, or the surface from which a template is made.
    pub first: Template,
    /// The template that was made earlier and kept.
    pub kept: Option<TemplateHistory>,
    /// The subjects from which a template is made, as indices into the cohort.
    pub makers: Vec<usize>,
    /// The subjects used to measure consistency; it is not measured with fewer than 3.
    pub ring: Vec<usize>,
    /// The persons with several visits, if these get templates of their own.
    pub persons: Vec<Person>,
}

/// The parameters by which the file of a subject with these labels is read.
pub(crate) fn input_of(labels: Option<&[LabelChoice]>, parameters: &MatchParameters) -> InputParameters {
    let input = parameters.input.of_target();
    InputParameters { labels: labels.map(<[LabelChoice]>::to_vec).or(input.labels), ..input }
}

/// Hash of a file's content.
pub fn hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// The subjects from which a template is made, as indices: at most `most`, spread evenly; 0 for all.
pub fn spread(cohort: &Cohort, most: usize) -> Vec<usize> {
    let model: Vec<usize> = (0..cohort.subjects.len()).filter(|&k| cohort.subjects[k].role == Role::Model).collect();
    if most == 0 || model.len() <= most {
        return model;
    }
    (0..most).map(|k| model[(2 * k + 1) * model.len() / (2 * most)]).collect()
}

/// The surface of a file that is read with `parameters`, as a template.
///
/// # Errors
/// The reason for its refusal, for people.
pub fn surface(bytes: &[u8], name: Option<&str>, parameters: &InputParameters) -> Result<Template, String> {
    let prepared = prepare_surface(bytes, name, parameters, &IntakeLimits::default());
    prepared.map(|prepared| Template::new(&prepared.mesh)).map_err(|error| error.for_command_line())
}

impl Study {
    pub(crate) fn key(&self, [source, target]: [&str; 2], task: &Task) -> String {
        let mut hasher = blake3::Hasher::new();
        let parameters = serde_json::to_string(&self.settings.parameters).unwrap_or_default();
        for part in [env!("CARGO_PKG_VERSION"), source, target, &parameters] {
            hasher.update(part.as_bytes()).update(&[0]);
        }
        let mirrored = self.mirrored(task);
        if mirrored != [false; 2] {
            hasher.update(&mirrored.map(u8::from));
        }
        let labels = [task.source, task.target].map(|side| side.and_then(|k| self.labels(k)));
        if labels != [None; 2] {
            hasher.update(serde_json::to_string(&labels).unwrap_or_default().as_bytes());
        }
        hasher.finalize().to_hex().to_string()
    }

    /// The match of two subjects, or of one with the template that has this hash.
    pub(crate) fn task(&self, template: &str, source: Option<usize>, target: Option<usize>) -> Task {
        let hash = |side: Option<usize>| side.map_or(template, |k| self.hashes[k].as_str());
        let task = Task { key: String::new(), source, target, own: None, rival: None };
        Task { key: self.key([hash(source), hash(target)], &task), ..task }
    }

    /// Whether source and target of a match are mirrored.
    pub fn mirrored(&self, task: &Task) -> [bool; 2] {
        [task.source, task.target].map(|side| side.is_some_and(|k| self.is_mirrored(k)))
    }

    /// The parameters of a match.
    pub(crate) fn parameters(&self, task: &Task) -> MatchParameters {
        let mut parameters = self.settings.parameters.clone();
        let input = &mut parameters.input;
        [input.source.mirror, input.target.mirror] = self.mirrored(task);
        for (side, subject) in [(&mut input.source, task.source), (&mut input.target, task.target)] {
            if let Some(labels) = subject.and_then(|k| self.labels(k)) {
                side.labels = Some(labels.to_vec());
            }
        }
        if task.rival.is_some() {
            rivals::keep_pose(&mut parameters);
        }
        parameters
    }

    /// The labels that a subject states for its volume.
    fn labels(&self, subject: usize) -> Option<&[LabelChoice]> {
        self.cohort.subjects.get(subject)?.labels.as_deref()
    }

    /// The parameters by which the file of a subject is read.
    pub(crate) fn input_of(&self, subject: usize) -> InputParameters {
        input_of(self.labels(subject), &self.settings.parameters)
    }

    /// The next step, given the existing records.
    ///
    /// # Errors
    /// [`StudyError::TooFewMatches`] if a template cannot be made; errors of reading records;
    /// [`StudyError::Interrupted`].
    pub fn next(&self, records: &dyn Records, observer: &dyn Observer) -> Result<Step, StudyError> {
        let making = match (&self.settings.template, &self.kept) {
            (TemplateChoice::Given { .. }, _) => TemplateHistory { template: self.first.clone(), rounds: Vec::new() },
            (TemplateChoice::Made(_), Some(kept)) => kept.clone(),
            (TemplateChoice::Made(how), None) => match self.make(how, records, observer)? {
                TemplateState::Ready(history) => history,
                TemplateState::Missing(step) => return Ok(step),
            },
        };
        let template = &making.template;
        let own = match self.own_maps(template, records, observer)? {
            PersonsState::Ready(own) => own,
            PersonsState::Missing(step) => return Ok(step),
        };
        let mut tasks: Vec<Task> =
            (0..self.cohort.subjects.len()).map(|k| self.task(&template.hash, None, Some(k))).collect();
        let keys: Vec<String> = tasks.iter().map(|task| task.key.clone()).collect();
        let composed: HashSet<usize> = own.iter().flat_map(|of| self.persons[of.person].visits.clone()).collect();
        tasks.retain(|task| task.target.is_none_or(|k| !composed.contains(&k)));
        let cycles = self.cycles(template, &mut tasks);
        if let Some(step) = Step::missing(Purpose::Subjects, template, tasks, Vec::new(), records) {
            return Ok(step);
        }
        let rivals = match self.rivals(template, (&keys, &composed), records, observer)? {
            RivalsState::Ready(rivals) => rivals,
            RivalsState::Missing(step) => return Ok(step),
        };
        Ok(Step::Matched(Box::new(Matched { making, keys, own, cycles, rivals })))
    }

    /// The template made from the existing records; `None` if matches for it are missing, or if it is given.
    pub(crate) fn making(
        &self,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<Option<TemplateHistory>, StudyError> {
        match &self.settings.template {
            TemplateChoice::Given { .. } => Ok(None),
            TemplateChoice::Made(how) => match self.make(how, records, observer)? {
                TemplateState::Ready(history) => Ok(Some(history)),
                TemplateState::Missing(_) => Ok(None),
            },
        }
    }

    /// The template, or the matches missing for it.
    fn make(
        &self,
        how: &MadeTemplate,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<TemplateState, StudyError> {
        let (mut template, mut rounds) = (self.first.clone(), Vec::new());
        while rounds.len() < how.max_rounds.max(1) {
            let all: Vec<Task> = self.makers.iter().map(|&k| self.task(&template.hash, None, Some(k))).collect();
            let purpose = Purpose::Template(rounds.len() + 1);
            if let Some(step) = Step::missing(purpose, &template, all.clone(), Vec::new(), records) {
                return Ok(TemplateState::Missing(step));
            }
            let (next, round) = averaged(&template, &all, records, observer)?;
            let is_last = round.moved_share < how.tolerance;
            rounds.push(round);
            template = next;
            if is_last {
                break;
            }
        }
        Ok(TemplateState::Ready(TemplateHistory { template, rounds }))
    }

    /// A ring of subjects, spread over the cohort, with the matches around it.
    fn cycles(&self, template: &Template, tasks: &mut Vec<Task>) -> Cycles {
        if self.ring.len() < 3 {
            return Cycles::default();
        }
        let ring = self.ring.clone();
        let next = |k: usize| ring[(k + 1) % ring.len()];
        let mut add = |source: Option<usize>, target: Option<usize>| {
            let task = self.task(&template.hash, source, target);
            if !tasks.contains(&task) {
                tasks.push(task.clone());
            }
            task.key
        };
        let to_template = ring.iter().map(|&a| add(Some(a), None)).collect();
        let forward = (0..ring.len()).map(|k| add(Some(ring[k]), Some(next(k)))).collect();
        let backward = (0..ring.len()).map(|k| add(Some(next(k)), Some(ring[k]))).collect();
        Cycles { ring, to_template, forward, backward }
    }
}

/// A template that is made from the group, or the step that it still needs.
enum TemplateState {
    Ready(TemplateHistory),
    Missing(Step),
}

/// The mean of shapes on a mesh, placed where the mesh lies, mm; `whose` names it in errors.
fn mean_on(
    mesh: &SurfaceMesh,
    shapes: &Vec<Vec<[f32; 3]>>,
    whose: &str,
    observer: &dyn Observer,
) -> Result<Vec<Point3<f64>>, StudyError> {
    let found = align(&WatchedShapes { shapes, observer }, mesh, Size::Kept)?;
    let back = fit_onto(&found.mean, mesh.vertices(), &found.weights, false)
        .map_err(|error| StudyError::Alignment { id: whose.to_owned(), error })?;
    Ok(found.mean.iter().map(|p| back.apply(p)).collect())
}

/// The next template: the mean of the shapes of a round, in the place of the template. Shapes whose match failed or is
/// unreliable are excluded.
fn averaged(
    template: &Template,
    tasks: &[Task],
    records: &dyn Records,
    observer: &dyn Observer,
) -> Result<(Template, Round), StudyError> {
    let (mut shapes, mut reason): (Vec<Vec<[f32; 3]>>, Option<String>) = (Vec::new(), None);
    for task in tasks {
        checkpoint(observer)?;
        let Some(record) = records.get(&task.key)? else { continue };
        if record.is_reliable_map_of(template.mesh.n_vertices()) {
            shapes.push(record.points);
        } else if reason.is_none() {
            reason = Some(record.facts.error.unwrap_or_else(|| "the match is not reliable".to_owned()));
        }
    }
    if shapes.len() < 3 {
        let (matched, all, reason) = (shapes.len(), tasks.len(), reason.unwrap_or_default());
        return Err(StudyError::TooFewMatches { matched, all, purpose: "to make a template", reason });
    }
    let mean = mean_on(&template.mesh, &shapes, "mean", observer)?;
    let next = next_template(&template.mesh, mean, observer)?;
    let round = Round {
        subjects: shapes.len(),
        moved_mm: next.moved.rms_mm,
        moved_share: next.moved.rms_mm / template.mesh.mean_edge_length(),
        slid_mm: next.slid_mm,
        put_back: next.put_back,
        triangle_quality: triangle_quality(&next.mesh),
        volume_mm3: next.mesh.signed_volume(),
    };
    Ok((Template::new(&next.mesh), round))
}
