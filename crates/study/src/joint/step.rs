//! The step of a study that revises its maps: from the records of matches to the records of joint maps.
//!
//! Joint maps follow from the matches, so that they can be lost: a study that is continued elsewhere computes them
//! again, with equal bytes. Their records are named by the matches of all subjects of the model, and stand beside those
//! of the matches, so that all later steps read them alike.
//!
//! The visits of a person with a template of its own count once: the map to that template is revised, and carried to the
//! visits as the match is. Revised one by one, they would slide apart, and the model would see a person that it predicts.

use super::{Group, JointRound, JointSettings, Slidable, Surfaces};
use crate::error::StudyError;
use crate::folder::{Folder, json};
use crate::plan::{Matched, OwnMaps, Records, Study};
use crate::record::{Facts, Record, folded};
use crate::subjects::{SubjectFindings, SubjectOutcome};
use homolog_primitives::observe::{Observer, checkpoint};
use parking_lot::Mutex;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Memory for the surfaces of subjects, bytes; those beyond it are read again in each round.
pub(crate) const SURFACES_BYTES: usize = 256 << 20;
/// Fewest subjects of which a model is made.
const FEWEST: usize = 3;
/// Version of the algorithm in the names of records.
const VERSION: &str = "joint 1";
/// Subfolder of the records among those of matches.
const PART: &str = "joint";
/// The file about them.
const ABOUT: &str = "group.json";

/// The joint maps of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointFindings {
    /// Names the maps of all subjects together: a hash of what they were made from.
    pub group: String,
    /// The rounds.
    pub rounds: Vec<JointRound>,
    /// Number of subjects that made the model.
    pub subjects: usize,
    /// Number of modes of the model of all of them.
    pub modes: usize,
    /// Stiffness of what remains between shapes and predictions, from 0 to 1.
    pub stiffness: f64,
}

/// What gets a joint map: a subject, or the template of a person.
struct Unit<'a> {
    /// The subject, or the first visit of the person that has a map.
    row: usize,
    /// Key of the match of the template to it.
    key: &'a str,
    /// The person, if it is the template of one.
    own: Option<&'a OwnMaps>,
    /// The outcome that its visits share; part of the model if one of them is.
    place: SubjectOutcome,
}

/// The subjects and templates of persons of a study.
fn units<'a>(study: &Study, matched: &'a Matched, subjects: &[SubjectFindings]) -> Vec<Unit<'a>> {
    let mut is_visit = vec![false; subjects.len()];
    let mut units = Vec::new();
    for own in &matched.own {
        let visits = &study.persons[own.person].visits;
        visits.iter().for_each(|&k| is_visit[k] = true);
        let with_map = || visits.iter().copied().filter(|&k| subjects[k].place != SubjectOutcome::Failed);
        let in_model = with_map().find(|&k| subjects[k].place == SubjectOutcome::Model);
        if let Some(row) = in_model.or_else(|| with_map().next()) {
            units.push(Unit { row, key: &own.onto, own: Some(own), place: subjects[row].place });
        }
    }
    for (row, key) in matched.keys.iter().enumerate().filter(|(row, _)| !is_visit[*row]) {
        units.push(Unit { row, key, own: None, place: subjects[row].place });
    }
    units
}

/// Joint maps of the subjects that have a match: facts and keys of `subjects` and `matched` become those of the joint
/// maps.
///
/// # Errors
/// [`StudyError`].
pub(crate) fn revised(
    study: &Study,
    matched: &mut Matched,
    folder: &Folder,
    subjects: &mut [SubjectFindings],
    observer: &dyn Observer,
) -> Result<JointFindings, StudyError> {
    let settings = JointSettings::default();
    let template = &matched.making.template;
    let mesh = &template.mesh;
    // In the order of keys, so that the order of the table does not matter.
    let mut order = units(study, matched, subjects);
    order.retain(|unit| unit.place != SubjectOutcome::Failed);
    order.sort_by(|a, b| {
        let is_other = |unit: &Unit<'_>| unit.place != SubjectOutcome::Model;
        (is_other(a), a.key, a.row).cmp(&(is_other(b), b.key, b.row))
    });
    let members = order.iter().filter(|unit| unit.place == SubjectOutcome::Model).count();
    if members < FEWEST {
        let reason = "visits of one person count once".to_owned();
        return Err(StudyError::TooFewMatches {
            matched: members,
            all: order.len(),
            purpose: "for joint maps",
            reason,
        });
    }
    // Keys are hashes: the first of them are a random choice.
    let n_core = members.min(settings.most_in_model);
    let mut hasher = blake3::Hasher::new();
    let how = format!("{:?} {settings:?}", study.settings.size);
    let keys = order[..n_core].iter().map(|unit| unit.key);
    for part in [VERSION, env!("CARGO_PKG_VERSION"), &template.hash, &how].into_iter().chain(keys) {
        hasher.update(part.as_bytes()).update(&[0]);
    }
    if study.cohort.subjects.iter().any(|subject| subject.labels.is_some()) {
        // Earlier builds took every label of such volumes.
        hasher.update(b"labels of rows");
    }
    let group = hasher.finalize().to_hex().to_string();
    let part = study.cohort.subfolder(PART);
    let named = |texts: &[&str]| format!("{part}/{}", blake3::hash(texts.join(" ").as_bytes()).to_hex());
    let key = |row: usize| {
        let row_in_model = if row < n_core { row.to_string() } else { "another".to_owned() };
        named(&[&group, &row_in_model, order[row].key])
    };
    let of_visit = |revised: &str, visit: &str| named(&[revised, visit]);
    // The keys of all rows, and those of the templates of persons.
    let revised_keys: Vec<String> = (0..order.len()).map(key).collect();
    let mut row_keys: Vec<(usize, String)> = Vec::new();
    for (unit, key) in order.iter().zip(&revised_keys) {
        let Some(own) = unit.own else {
            row_keys.push((unit.row, key.clone()));
            continue;
        };
        let visits = study.persons[own.person].visits.iter().zip(&own.visits);
        let with_map = visits.filter(|(k, _)| subjects[**k].place != SubjectOutcome::Failed);
        row_keys.extend(with_map.map(|(&k, visit)| (k, of_visit(key, visit))));
    }
    let keys: Vec<String> = revised_keys.iter().chain(row_keys.iter().map(|(_, key)| key)).cloned().collect();
    let about_at = format!("matches/{part}/{ABOUT}");
    let about = folder.read(&about_at)?.and_then(|text| serde_json::from_slice::<JointFindings>(&text).ok());
    let known = about.filter(|about| about.group == group && keys.iter().all(|key| folder.has(key)));
    let findings = match known {
        Some(findings) => findings,
        None => {
            let surfaces = Prepared::new(study, folder, &order, observer);
            let record = |unit: &Unit<'_>| -> Result<Record, StudyError> {
                checkpoint(observer)?;
                Ok(folder.get(unit.key)?.unwrap_or_else(|| Record::failed("the match is missing".to_owned())))
            };
            let map = |unit: &Unit<'_>| record(unit).map(|record| record.points);
            let maps = order[..n_core].iter().map(map).collect::<Result<Vec<_>, _>>()?;
            let work =
                Group { template: mesh, surfaces: &surfaces, size: study.settings.size, settings: &settings, observer };
            let found = work.revise(&maps)?;
            drop(maps);
            let keep = |row: usize, points: Vec<[f32; 3]>| -> Result<(), StudyError> {
                let unit = &order[row];
                let of_match = if unit.own.is_some() { record(unit)?.facts } else { subjects[unit.row].facts.clone() };
                let revised = Record { facts: facts(&of_match, &work, row, &points)?, points };
                if let Some(own) = unit.own {
                    let key = |place: usize| of_visit(&revised_keys[row], &own.visits[place]);
                    let onto = study.own_template(own, folder, observer)?.mesh;
                    crate::visits::kept((study, folder, mesh), own, onto, &revised, &key, observer)?;
                }
                folder.keep(&revised_keys[row], &revised)
            };
            for (row, points) in found.maps.iter().enumerate() {
                keep(row, points.clone())?;
            }
            for (row, unit) in order.iter().enumerate().skip(n_core) {
                keep(row, work.revise_another(row, &map(unit)?, &found)?)?;
            }
            let findings = JointFindings {
                group,
                rounds: found.rounds,
                subjects: n_core,
                modes: found.modes,
                stiffness: found.stiffness,
            };
            // Written last: it says that the records are complete.
            folder.write(&about_at, &json(&findings))?;
            findings
        }
    };
    folder.keep_records(&part, &keys, &[ABOUT]);
    for (k, key) in row_keys {
        if let Some(record) = folder.get(&key)? {
            subjects[k].facts = record.facts;
            matched.keys[k] = key;
        }
    }
    Ok(findings)
}

/// The facts on a match with those on its joint map.
fn facts(of_match: &Facts, group: &Group<'_>, row: usize, points: &[[f32; 3]]) -> Result<Facts, StudyError> {
    let mut facts = of_match.clone();
    let points = crate::align::points(points);
    if let Some(surface) = group.surfaces.surface(row)? {
        let distances = surface.distances(group.template, &points)?;
        let n = distances.len().max(1);
        facts.residual_mm = distances.iter().sum::<f64>() / n as f64;
        facts.residual_p95_mm = distances.get(n * 19 / 20).copied().unwrap_or(0.0);
    }
    let weights = crate::align::area_weights(group.template);
    if let Ok(pose) = crate::align::fit_onto(group.template.vertices(), &points, &weights, false) {
        facts.folded = folded(group.template, &group.template.with_vertices(points)?, &pose.rotation);
    }
    Ok(facts)
}

/// The surfaces of subjects, by their place in an order; as many as fit into [`SURFACES_BYTES`] stay in memory.
struct Prepared<'a> {
    study: &'a Study,
    folder: &'a Folder,
    order: &'a [Unit<'a>],
    observer: &'a dyn Observer,
    held: Vec<Mutex<Option<Arc<Slidable>>>>,
    bytes: Mutex<usize>,
}

impl<'a> Prepared<'a> {
    fn new(study: &'a Study, folder: &'a Folder, order: &'a [Unit<'a>], observer: &'a dyn Observer) -> Self {
        let held = order.iter().map(|_| Mutex::default()).collect();
        Prepared { study, folder, order, observer, held, bytes: Mutex::default() }
    }
}

impl Surfaces for Prepared<'_> {
    fn surface(&self, subject: usize) -> Result<Option<Arc<Slidable>>, StudyError> {
        let mut held = self.held[subject].lock();
        if let Some(surface) = held.as_ref() {
            return Ok(Some(Arc::clone(surface)));
        }
        let Unit { row, own, .. } = self.order[subject];
        let mesh = match own {
            Some(own) => Some(self.study.own_template(own, self.folder, self.observer)?.mesh),
            None => self.study.surface_of(row, self.folder)?,
        };
        let Some(mesh) = mesh else { return Ok(None) };
        let surface = Arc::new(Slidable::new(mesh));
        let mut bytes = self.bytes.lock();
        if *bytes + surface.heap_bytes() <= SURFACES_BYTES {
            *bytes += surface.heap_bytes();
            *held = Some(Arc::clone(&surface));
        }
        Ok(Some(surface))
    }
}
