//! The step of a study that revises its maps: from the records of matches to the records of joint maps.
//!
//! Joint maps follow from the matches, so that they can be lost: a study that is continued elsewhere computes them
//! again, with equal bytes. Their records are named by the matches of all subjects of the model, and stand beside those
//! of the matches, so that all later steps read them alike.

use super::{Group, JointRound, JointSettings, Slidable, Surfaces};
use crate::error::StudyError;
use crate::folder::{Folder, json};
use crate::plan::{Matched, Records, Study};
use crate::record::{Facts, Record, folded};
use crate::subjects::{SubjectFindings, SubjectOutcome};
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_run::intake::{IntakeLimits, prepare_surface};
use parking_lot::Mutex;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Memory for the surfaces of subjects, bytes; those beyond it are read again in each round.
pub(crate) const SURFACES_BYTES: usize = 256 << 20;
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
    // In the order of keys, so that the order of the table does not matter.
    let ordered = |is_wanted: &dyn Fn(SubjectOutcome) -> bool| {
        let mut of: Vec<usize> = (0..subjects.len()).filter(|&k| is_wanted(subjects[k].place)).collect();
        of.sort_by(|&a, &b| matched.keys[a].cmp(&matched.keys[b]).then(a.cmp(&b)));
        of
    };
    let members = ordered(&|place| place == SubjectOutcome::Model);
    // Keys are hashes: the first of them are a random choice.
    let n_core = members.len().min(settings.most_in_model);
    let mut order = members;
    order.extend(ordered(&|place| !matches!(place, SubjectOutcome::Model | SubjectOutcome::Failed)));
    let mut hasher = blake3::Hasher::new();
    let how = format!("{:?} {settings:?}", study.settings.size);
    let keys = order[..n_core].iter().map(|&k| matched.keys[k].as_str());
    for part in [VERSION, env!("CARGO_PKG_VERSION"), &template.hash, &how].into_iter().chain(keys) {
        hasher.update(part.as_bytes()).update(&[0]);
    }
    if study.cohort.subjects.iter().any(|subject| subject.labels.is_some()) {
        // Earlier builds took every label of such volumes.
        hasher.update(b"labels of rows");
    }
    let group = hasher.finalize().to_hex().to_string();
    let part = study.cohort.subfolder(PART);
    let key = |row: usize| {
        let row_in_model = if row < n_core { row.to_string() } else { "another".to_owned() };
        let text = [group.as_str(), &row_in_model, &matched.keys[order[row]]].join(" ");
        format!("{part}/{}", blake3::hash(text.as_bytes()).to_hex())
    };
    let about_at = format!("matches/{part}/{ABOUT}");
    let keys: Vec<String> = (0..order.len()).map(key).collect();
    let about = folder.read(&about_at)?.and_then(|text| serde_json::from_slice::<JointFindings>(&text).ok());
    let known = about.filter(|about| about.group == group && keys.iter().all(|key| folder.has(key)));
    let findings = match known {
        Some(findings) => findings,
        None => {
            let surfaces = Prepared::new(study, folder, &order);
            let map = |k: usize| -> Result<Vec<[f32; 3]>, StudyError> {
                checkpoint(observer)?;
                Ok(folder.get(&matched.keys[k])?.map(|record| record.points).unwrap_or_default())
            };
            let maps = order[..n_core].iter().map(|&k| map(k)).collect::<Result<Vec<_>, _>>()?;
            let mesh = &template.mesh;
            let work =
                Group { template: mesh, surfaces: &surfaces, size: study.settings.size, settings: &settings, observer };
            let found = work.revise(&maps)?;
            drop(maps);
            let keep = |row: usize, points: Vec<[f32; 3]>| -> Result<(), StudyError> {
                let facts = facts(&subjects[order[row]].facts, &work, row, &points)?;
                folder.keep(&keys[row], &Record { facts, points })
            };
            for (row, points) in found.maps.iter().enumerate() {
                keep(row, points.clone())?;
            }
            for (row, &k) in order.iter().enumerate().skip(n_core) {
                keep(row, work.revise_another(row, &map(k)?, &found)?)?;
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
    for (&k, key) in order.iter().zip(keys) {
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
    order: &'a [usize],
    held: Vec<Mutex<Option<Arc<Slidable>>>>,
    bytes: Mutex<usize>,
}

impl<'a> Prepared<'a> {
    fn new(study: &'a Study, folder: &'a Folder, order: &'a [usize]) -> Self {
        let held = order.iter().map(|_| Mutex::default()).collect();
        Prepared { study, folder, order, held, bytes: Mutex::default() }
    }
}

impl Surfaces for Prepared<'_> {
    fn surface(&self, subject: usize) -> Result<Option<Arc<Slidable>>, StudyError> {
        let mut held = self.held[subject].lock();
        if let Some(surface) = held.as_ref() {
            return Ok(Some(Arc::clone(surface)));
        }
        let k = self.order[subject];
        let file = &self.study.cohort.subjects[k].file;
        let parameters = self.study.input_of(k);
        let name = file.file_name().and_then(|name| name.to_str());
        let Ok(prepared) = prepare_surface(&self.folder.input(file)?, name, &parameters, &IntakeLimits::default())
        else {
            return Ok(None);
        };
        let mesh = if self.study.is_mirrored(k) {
            crate::mirror::mirrored(prepared.uploaded())?
        } else {
            prepared.uploaded().clone()
        };
        let surface = Arc::new(Slidable::new(mesh));
        let mut bytes = self.bytes.lock();
        if *bytes + surface.heap_bytes() <= SURFACES_BYTES {
            *bytes += surface.heap_bytes();
            *held = Some(Arc::clone(&surface));
        }
        Ok(Some(surface))
    }
}
