//! The pose of a subject that its own match leaves open, decided by the group.
//!
//! Several poses explain a nearly symmetric surface equally well (`ambiguous_pose`), and which of them is right cannot be seen in
//! one pair. In a group it can: with the right pose a vertex of the template lies at the same place of the anatomy in all
//! subjects, so that shapes differ by what differs between subjects; with a wrong pose they also differ by the asymmetry.
//!
//! 1. Every subject whose only doubt is its pose is a variable. Its labels are the map of its match and the maps in the rival
//!    poses that its record and those of other ambiguous subjects show, each a match of its own ([`crate::plan`]). Reliable subjects are observed.
//! 2. *Model.* The shapes of all subjects are draws from one Gaussian distribution around an unknown mean. With a flat prior of
//!    the mean, the negative logarithm of their likelihood is `Σ_i<j D²_ij / (2 n v)`: `D_ij` is the distance of two shapes
//!    along their normals ([`shapes`]), that is how far the map from one subject to the template and on to the other displaces
//!    the surface, after a rigid motion and a change of size; `n` the number of subjects, and `v` the variance in each independent direction. The sum over all pairs,
//!    divided by `n`, is the sum over subjects of the squared distance from their mean. So all pairs are used, and each subject
//!    counts once, whatever their number. For one variable it is the predictive distribution from the others.
//! 3. *Scale.* `v` comes from the reliable subjects ([`scale`]): their variance, divided by the effective number of directions in
//!    which they vary. Vertices of a surface do not vary by themselves. This number is below that of the reliable subjects, so a
//!    small group is never sure.
//! 4. *Unary potentials* of the pair are 0: the matcher has tested the difference of the poses patch by patch and found it within
//!    chance, or has not followed a pose, and neither is evidence.
//! 5. Sum-product belief propagation gives the marginal of each candidate ([`marginals`]).
//!
//! A subject takes its candidate of largest marginal if this is at least [`GroupSettings::level`]. Marginals compare candidates:
//! where none of them is right, the least wrong has a marginal near 1. So the candidate must also be in the range of the reliable
//! subjects, by its mean squared distance from these, and every other candidate must be farther from them by more than the width
//! of this range. Otherwise the subject stays as it was, left out as ambiguous. Where all poses are right, all candidates are about
//! as near to the group, and nothing is decided.
//!
//! Covariates, and groups of subjects in them, are never read. Decisions of people come first: a subject that is kept is observed
//! with the map of its match, and one that is dropped takes no part. Subjects of the role `score` are decided one by one and
//! change nothing for the others. Above [`GroupSettings::together`] variables, these are decided in parts of this number.
//!
//! Source: Pearl 1988 (belief propagation); Nguyen et al., *An optimization approach to improving collections of shape maps*,
//! Computer Graphics Forum 30(5), 2011 (consistency of cycles of maps as evidence for each of them).

mod marginals;
mod scale;
mod settings;
mod shapes;
mod surfaces;

pub(crate) use settings::GroupSettings;
pub(crate) use surfaces::rival_surfaces;

use crate::cohort::Role;
use crate::error::StudyError;
use crate::folder::{Decision, Folder, Verdict};
use crate::plan::{Matched, Records, Study, SubjectRivals};
use crate::record::{Record, hash_of_texts};
use crate::settings::FEWEST_RELIABLE;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use marginals::GroupEnergy;
use rayon::prelude::*;
use scale::Scale;
use serde::Serialize;
use shapes::{Frame, Shape};
use std::collections::{BTreeMap, BTreeSet};

/// Subfolder of the records of decided subjects among those of matches.
const PART: &str = "rivals";
/// Version of these records in their names.
const VERSION: &str = "decided rival 1";

/// What the group says about the pose of a subject.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GroupDecision {
    /// Number of candidate maps.
    pub candidates: usize,
    /// The candidate of largest marginal: 0 for the map of its match, `k` for its rival pose number `k`.
    pub candidate: usize,
    /// Its marginal probability under the other subjects.
    pub marginal: f64,
    /// Whether the subject takes this candidate; otherwise its pose stays ambiguous.
    pub decided: bool,
    /// Number of reliable subjects it was compared with.
    pub reliable: usize,
}

/// A variable: the subjects that share a match, their candidates, and the shapes of these.
struct Variable<'a> {
    rows: Vec<usize>,
    rivals: &'a SubjectRivals,
    /// Records and shapes; the map of the match first. Rivals without a reliable match are no candidates.
    candidates: Vec<(usize, Shape)>,
}

/// The observed subjects: their shapes, the scale of their differences, and the range of the mean squared distance of one of
/// them from the others.
struct Observed {
    frame: Frame,
    shapes: Vec<Shape>,
    scale: Scale,
    nearest: f64,
    farthest: f64,
}

/// Decides between the candidates of subjects whose pose is ambiguous, by the group. Decided subjects get the records of their
/// candidates as maps in `matched`. Returns what was found for each subject of the cohort; `None` for those that are no variables.
///
/// # Errors
/// Errors of reading and writing records; [`StudyError::Interrupted`].
///
/// # Cost
/// For `r` observed subjects (at most [`GroupSettings::most_observed`]) and `m` candidates of a part `O((r + m)²)` distances of
/// [`GroupSettings::patches`] points. Nothing where no subject is ambiguous.
pub(crate) fn decide(
    study: &Study,
    matched: &mut Matched,
    folder: &Folder,
    decisions: &[Decision],
    observer: &dyn Observer,
) -> Result<Vec<Option<GroupDecision>>, StudyError> {
    let (settings, mut found) = (GroupSettings::default(), vec![None; study.cohort.subjects.len()]);
    let part = study.cohort.subfolder(PART);
    if matched.rivals.is_empty() {
        folder.keep_records(&part, &[], &[]);
        return Ok(found);
    }
    let reader = Reader { study, matched, folder, decisions, observer, settings: &settings };
    let (mut keys, mut decided) = (Vec::new(), Vec::new());
    if let Some(observed) = reader.observed()? {
        let (of_model, of_score): (Vec<_>, Vec<_>) =
            reader.variables(&observed.frame)?.into_iter().partition(|variable| reader.is_of_model(variable));
        for together in of_model.chunks(settings.together).chain(of_score.chunks(1)) {
            checkpoint(observer)?;
            for (variable, decision) in together.iter().zip(decisions_of(together, &observed, &settings, observer)?) {
                if decision.decided {
                    let key = reader.keep(variable, decision.candidate, &part)?;
                    decided.extend(variable.rows.iter().map(|&row| (row, key.clone())));
                    keys.push(key);
                }
                variable.rows.iter().for_each(|&row| found[row] = Some(decision));
            }
        }
    }
    folder.keep_records(&part, &keys, &[]);
    decided.into_iter().for_each(|(row, key)| matched.keys[row] = key);
    Ok(found)
}

/// The decisions on variables that are decided together.
fn decisions_of(
    variables: &[Variable<'_>],
    observed: &Observed,
    settings: &GroupSettings,
    observer: &dyn Observer,
) -> Result<Vec<GroupDecision>, StudyError> {
    let shapes: Vec<Vec<&Shape>> =
        variables.iter().map(|variable| variable.candidates.iter().map(|(_, shape)| shape).collect()).collect();
    let (energy, means) = energy(&shapes, observed, observer)?;
    let marginals = energy.marginals(settings);
    let decision = |(k, marginals): (usize, &Vec<f64>)| {
        // The map of the match is the first, and wins ties.
        let best = (0..marginals.len()).fold(0, |best, x| if marginals[x] > marginals[best] { x } else { best });
        let chosen = means[k][best];
        let is_apart = |(x, mean): (usize, &f64)| x == best || mean - chosen > observed.farthest - observed.nearest;
        let is_typical = chosen <= observed.farthest && means[k].iter().enumerate().all(is_apart);
        GroupDecision {
            candidates: marginals.len(),
            candidate: variables[k].candidates[best].0,
            marginal: marginals[best],
            decided: marginals[best] >= settings.level && is_typical,
            reliable: observed.shapes.len(),
        }
    };
    Ok(marginals.iter().enumerate().map(decision).collect())
}

/// The energy of a group, and for each candidate its mean squared distance from the observed shapes.
fn energy(
    variables: &[Vec<&Shape>],
    observed: &Observed,
    observer: &dyn Observer,
) -> Result<(GroupEnergy, Vec<Vec<f64>>), StudyError> {
    let n = (observed.shapes.len() + variables.len()) as f64;
    let weight = observed.scale.half_precision() / n;
    let means: Vec<Vec<f64>> = variables
        .par_iter()
        .map(|candidates| {
            checkpoint(observer)?;
            Ok(candidates.iter().map(|shape| shape.mean_squared_distance(observed.shapes.iter())).collect())
        })
        .collect::<Result<_, StudyError>>()?;
    let all = observed.shapes.len() as f64;
    let unary = means.iter().map(|of| of.iter().map(|mean| weight * all * mean).collect()).collect();
    let pairs: Vec<[usize; 2]> =
        (0..variables.len()).flat_map(|i| (i + 1..variables.len()).map(move |j| [i, j])).collect();
    let pairwise = pairs
        .par_iter()
        .map(|&[i, j]| {
            checkpoint(observer)?;
            let of = |a: &&Shape| variables[j].iter().map(|b| weight * a.squared_distance(b)).collect::<Vec<f64>>();
            Ok(([i, j], variables[i].iter().flat_map(of).collect()))
        })
        .collect::<Result<_, StudyError>>()?;
    Ok((GroupEnergy { unary, pairwise }, means))
}

impl Observed {
    /// From the maps of reliable subjects; `None` if these are too few, or do not differ.
    fn new(template: &SurfaceMesh, maps: &[Vec<[f32; 3]>], settings: &GroupSettings) -> Option<Self> {
        let frame = Frame::new(template, maps, settings.patches)?;
        let shapes: Vec<Shape> = maps.par_iter().filter_map(|map| frame.shape(map)).collect();
        if shapes.len() < FEWEST_RELIABLE {
            return None;
        }
        let scale = Scale::of(&shapes)?;
        let mean = |k: usize| {
            let others = shapes.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, shape)| shape);
            shapes[k].mean_squared_distance(others)
        };
        let own: Vec<f64> = (0..shapes.len()).into_par_iter().map(mean).collect();
        let nearest = own.iter().copied().fold(f64::INFINITY, f64::min);
        let farthest = own.iter().copied().fold(0.0, f64::max);
        Some(Observed { frame, shapes, scale, nearest, farthest })
    }
}

/// Reads the records that take part, in an order that does not depend on that of the cohort.
struct Reader<'a> {
    study: &'a Study,
    matched: &'a Matched,
    folder: &'a Folder,
    decisions: &'a [Decision],
    observer: &'a dyn Observer,
    settings: &'a GroupSettings,
}

impl<'a> Reader<'a> {
    fn verdict(&self, row: usize) -> Option<Verdict> {
        let id = &self.study.cohort.subjects[row].id;
        self.decisions.iter().find(|decision| decision.id == *id).map(|decision| decision.decision)
    }

    fn is_of_model(&self, variable: &Variable<'_>) -> bool {
        variable.rows.iter().any(|&row| self.study.cohort.subjects[row].role == Role::Model)
    }

    /// The points of a record that is a reliable map, or is `kept` by a person.
    fn map(&self, key: &str, kept: bool) -> Result<Option<Vec<[f32; 3]>>, StudyError> {
        checkpoint(self.observer)?;
        let n_vertices = self.matched.making.template.mesh.n_vertices();
        let is_usable = |record: &Record| {
            if kept { record.is_map_of(n_vertices) } else { record.is_reliable_map_of(n_vertices) }
        };
        Ok(self.folder.get(key)?.filter(is_usable).map(|record| record.points))
    }

    /// The observed subjects: one row of each person, spread over all if there are many.
    fn observed(&self) -> Result<Option<Observed>, StudyError> {
        let mut rows: Vec<(&String, bool, &String)> = Vec::new();
        for (row, subject) in self.study.cohort.subjects.iter().enumerate() {
            let verdict = self.verdict(row);
            if subject.role == Role::Model && verdict != Some(Verdict::Dropped) {
                rows.push((&self.matched.keys[row], verdict == Some(Verdict::Kept), &subject.subject));
            }
        }
        // Keys are hashes: the first of them are a random choice.
        rows.sort_unstable();
        let (mut persons, mut keys) = (BTreeSet::new(), BTreeSet::new());
        let mut maps = Vec::new();
        for (key, kept, person) in rows {
            if maps.len() == self.settings.most_observed {
                break;
            }
            if persons.contains(person) || keys.contains(key) {
                continue;
            }
            if let Some(map) = self.map(key, kept)? {
                maps.push(map);
                persons.insert(person);
                keys.insert(key);
            }
        }
        Ok(Observed::new(&self.matched.making.template.mesh, &maps, self.settings))
    }

    /// The variables, by the key of their match.
    fn variables(&self, frame: &Frame) -> Result<Vec<Variable<'a>>, StudyError> {
        let mut of_match: BTreeMap<&String, (Vec<usize>, &'a SubjectRivals)> = BTreeMap::new();
        for rivals in &self.matched.rivals {
            if self.verdict(rivals.subject).is_none() {
                let key = &self.matched.keys[rivals.subject];
                of_match.entry(key).or_insert_with(|| (Vec::new(), rivals)).0.push(rivals.subject);
            }
        }
        let of_match: Vec<_> = of_match.into_iter().collect();
        let found: Vec<Option<Variable<'a>>> = of_match
            .into_par_iter()
            .map(|(key, (rows, rivals))| {
                let shape =
                    |key: &str, kept: bool| Ok::<_, StudyError>(self.map(key, kept)?.and_then(|map| frame.shape(&map)));
                let own = shape(key, true)?;
                let mut candidates: Vec<(usize, Shape)> = own.into_iter().map(|own| (0, own)).collect();
                for (place, key) in (1..).zip(&rivals.keys) {
                    candidates.extend(shape(key, false)?.map(|shape| (place, shape)));
                }
                let is_open = candidates.len() > 1 && candidates.first().is_some_and(|(place, _)| *place == 0);
                Ok(is_open.then_some(Variable { rows, rivals, candidates }))
            })
            .collect::<Result<_, StudyError>>()?;
        Ok(found.into_iter().flatten().collect())
    }

    /// Keeps the record of a decided subject: the map of the candidate in the coordinates of the subject, without the doubt
    /// about its pose. Returns its key.
    fn keep(&self, variable: &Variable<'_>, candidate: usize, part: &str) -> Result<String, StudyError> {
        let gone = || StudyError::Internal("a record of a candidate was removed meanwhile".to_owned());
        let own_key = variable.rows.first().map(|&row| &self.matched.keys[row]).ok_or_else(gone)?;
        let rival = candidate.checked_sub(1).and_then(|place| Some((place, variable.rivals.keys.get(place)?)));
        let chosen = rival.map_or(own_key, |(_, key)| key);
        let key = format!("{part}/{}", hash_of_texts([VERSION, env!("CARGO_PKG_VERSION"), own_key, chosen]));
        if !self.folder.has(&key) {
            let own = self.folder.get(own_key)?.ok_or_else(gone)?;
            let record = match rival {
                None => own.clone(),
                Some((place, chosen)) => {
                    let rotation = variable.rivals.rotations.get(place).ok_or_else(gone)?;
                    let Record { facts, points } = self.folder.get(chosen)?.ok_or_else(gone)?;
                    Record { facts, points: surfaces::turned(&points, rotation) }
                }
            };
            self.folder.keep(&key, &decided_record(record, own))?;
        }
        Ok(key)
    }
}

/// The record of a candidate with what the match says about the surface and the doubt that was resolved.
fn decided_record(mut candidate: Record, own: Record) -> Record {
    let facts = &mut candidate.facts;
    facts.reliable = Some(true);
    (facts.volume_mm3, facts.area_mm2, facts.n_vertices) =
        (own.facts.volume_mm3, own.facts.area_mm2, own.facts.n_vertices);
    (facts.repairs, facts.reasons, facts.rivals) = (own.facts.repairs, own.facts.reasons, Vec::new());
    candidate
}

#[cfg(test)]
mod tests;
