//! Studies of several structures of each person, their pose relative to one another kept.
//!
//! Such a study is a study of each structure, with a template, matches and joint maps of its own, and one study of the
//! persons: the record of a person is that of its structures, one after the other, in the coordinates of the person, and
//! its template is made of theirs. All later steps take these records like those of one structure. The records follow
//! from those of the structures, stand beside them in `matches/complex`, and are made again if one is lost.

use crate::align::{area_weights, fit_onto, points};
use crate::cohort::{Cohort, Subject};
use crate::complex::{Complex, Structure, concatenated};
use crate::error::StudyError;
use crate::findings::{Findings, find, find_with, placed};
use crate::folder::{Decision, Folder, Verdict};
use crate::joint::JointFindings;
use crate::matching::{Interruption, StudyObserver};
use crate::plan::{Cycles, Matched, Records, Step, Study, Template, TemplateHistory};
use crate::record::{Facts, Record, hash_of_texts};
use crate::rivals::decide;
use crate::settings::{Correspondence, MadeTemplate, Settings, TemplateChoice, Visits};
use crate::subjects::{StructureFindings, SubjectFindings, SubjectOutcome};
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::{Point3, Vector3};
use std::collections::{BTreeMap, BTreeSet};

/// Subfolder of the records of persons among those of matches.
const PART: &str = "complex";
/// Version of these records in their names.
const VERSION: &str = "complex 1";

/// A study of one structure of each subject, or of several together.
#[derive(Debug)]
pub enum GroupStudy {
    /// Of one.
    One(Box<Study>),
    /// Of several.
    Several(Box<ComplexStudy>),
}

/// A study of several structures of each person.
#[derive(Debug)]
pub struct ComplexStudy {
    /// The rows, by person and structure.
    rows: Cohort,
    hashes: Vec<String>,
    settings: Settings,
    /// The structures, in alphabetical order.
    parts: Vec<Part>,
}

/// The study of one structure.
#[derive(Debug)]
struct Part {
    name: String,
    study: Study,
    /// The rows as they were given.
    given: Vec<usize>,
}

/// Next step of a study of one structure or of several: the matches that are missing of one structure, whose subjects are rows
/// as they were given, or those of each structure in alphabetical order. Several structures have no templates of persons.
pub type GroupStep = Step<Vec<Matched>>;

/// A structure with the outcomes of its rows.
struct PlacedPart<'a> {
    part: &'a Part,
    matched: Matched,
    rows: Vec<SubjectFindings>,
    joint: Option<JointFindings>,
}

impl PlacedPart<'_> {
    /// The vertices of the template mapped to a row; none without a row or a record.
    fn points(&self, row: Option<usize>, folder: &Folder) -> Result<Vec<[f32; 3]>, StudyError> {
        let record = row.map_or(Ok(None), |row| folder.get(&self.matched.keys[row]))?;
        Ok(record.map(|record| record.points).unwrap_or_default())
    }
}

impl GroupStudy {
    /// A study over files, of all structures that the rows name; see [`Study::open`].
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn open(
        cohort: Cohort,
        settings: Settings,
        hashes: &[String],
        folder: &Folder,
        watcher: &dyn StudyObserver,
    ) -> Result<Self, StudyError> {
        if cohort.structures().is_empty() {
            return Ok(GroupStudy::One(Box::new(Study::open(cohort, settings, hashes, folder, watcher)?)));
        }
        let complex = ComplexStudy::open(&cohort, settings, hashes, folder, watcher)?;
        Ok(GroupStudy::Several(Box::new(complex)))
    }

    /// The next step, given the existing records; see [`Study::advance`].
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn advance(&mut self, folder: &Folder, watcher: &dyn StudyObserver) -> Result<GroupStep, StudyError> {
        let mut all = Vec::new();
        match self {
            GroupStudy::One(study) => match study.advance(folder, watcher)? {
                Step::Matched(matched) => all.push(*matched),
                Step::Match { purpose, template, tasks, finished, own } => {
                    return Ok(Step::Match { purpose, template, tasks, finished, own });
                }
            },
            GroupStudy::Several(complex) => {
                for part in &mut complex.parts {
                    match part.study.advance(folder, watcher).map_err(of_structure(&part.name))? {
                        Step::Matched(matched) => all.push(*matched),
                        Step::Match { purpose, template, mut tasks, finished, own } => {
                            for task in &mut tasks {
                                let given = |row: Option<usize>| row.map(|row| part.given[row]);
                                (task.source, task.target) = (given(task.source), given(task.target));
                                if let Some(rival) = &mut task.rival {
                                    rival.subject = part.given[rival.subject];
                                }
                            }
                            return Ok(Step::Match { purpose, template, tasks, finished, own });
                        }
                    }
                }
            }
        }
        Ok(Step::Matched(all))
    }

    /// The settings, with what was decided at the opening.
    pub fn settings(&self) -> &Settings {
        match self {
            GroupStudy::One(study) => &study.settings,
            GroupStudy::Several(complex) => &complex.settings,
        }
    }

    /// Computes every missing match, of one structure after the other; see [`Study::match_all`]. Returns the matches of each
    /// structure, in alphabetical order.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn match_all(
        &mut self,
        folder: &Folder,
        threads: usize,
        watcher: &dyn StudyObserver,
    ) -> Result<Vec<Matched>, StudyError> {
        match self {
            GroupStudy::One(study) => Ok(vec![study.match_all(folder, threads, watcher)?]),
            GroupStudy::Several(complex) => {
                let of = |part: &mut Part| {
                    let named = Named { structure: &part.name, watcher };
                    part.study.match_all(folder, threads, &named).map_err(of_structure(&part.name))
                };
                complex.parts.iter_mut().map(of).collect()
            }
        }
    }

    /// Computes all findings from the matches of each structure; see [`find`]. The study that is returned has the subjects to
    /// which the findings refer: the rows, or persons with several structures.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn find(
        self,
        matched: &[Matched],
        folder: &Folder,
        decisions: &[Decision],
        watcher: &dyn StudyObserver,
    ) -> Result<(Study, Findings), StudyError> {
        match self {
            GroupStudy::One(study) => {
                let matched = matched.first().ok_or_else(|| StudyError::Internal("no matches".to_owned()))?;
                let found = find(&study, matched, folder, decisions, watcher)?;
                Ok((*study, found))
            }
            GroupStudy::Several(complex) => complex.find(matched, folder, decisions, watcher),
        }
    }
}

/// Puts the structure before the name of an activity.
struct Named<'a> {
    structure: &'a str,
    watcher: &'a dyn StudyObserver,
}

impl StudyObserver for Named<'_> {
    fn progress(&self, what: &str, done: usize, of: usize) {
        self.watcher.progress(&format!("{}: {what}", self.structure), done, of);
    }
    fn is_interrupted(&self) -> bool {
        self.watcher.is_interrupted()
    }
}

/// Names the structure in errors that concern its subjects or its template.
fn of_structure(name: &str) -> impl Fn(StudyError) -> StudyError {
    move |error| match error {
        StudyError::TooFewMatches { .. } | StudyError::Start { .. } | StudyError::Alignment { .. } => {
            StudyError::Structure { structure: name.to_owned(), error: Box::new(error) }
        }
        error => error,
    }
}

/// The settings of the study of one structure.
fn settings_of(name: &str, rows: &Cohort, settings: &Settings) -> Result<Settings, StudyError> {
    let is_own = |id: &&String| rows.subjects.iter().any(|row| row.id == **id);
    let template = match &settings.template {
        TemplateChoice::Given { .. } => {
            let why =
                "one template is given for all structures; give each its own (--template STRUCTURE=FILE), or none";
            return Err(StudyError::Settings(why.to_owned()));
        }
        TemplateChoice::Made(how) => match how.given.get(name) {
            Some(file) => TemplateChoice::Given { file: file.clone() },
            None => TemplateChoice::Made(MadeTemplate {
                start: how.start.as_ref().and_then(|id| row_of(rows, id)).map(|row| row.id.clone()),
                from: how.from.iter().filter(is_own).cloned().collect(),
                given: BTreeMap::new(),
                ..how.clone()
            }),
        },
    };
    Ok(Settings { template, ..settings.clone() })
}

/// The row with an id, or of the person with that id.
fn row_of<'a>(rows: &'a Cohort, id: &str) -> Option<&'a Subject> {
    rows.subjects.iter().find(|row| row.id == id || row.structure.as_ref().is_some_and(|of| of.of == id))
}

impl ComplexStudy {
    fn open(
        cohort: &Cohort,
        mut settings: Settings,
        hashes: &[String],
        folder: &Folder,
        watcher: &dyn StudyObserver,
    ) -> Result<Self, StudyError> {
        let fault = |why: String| Err(StudyError::Settings(why));
        if settings.cycle_subjects > 0 {
            return fault(
                "the consistency of maps is measured in a study of one structure; leave cycles out".to_owned(),
            );
        }
        if settings.visits == Visits::OwnTemplate {
            return fault("templates of persons are made in a study of one structure; leave visits out".to_owned());
        }
        // Neither the order of rows nor that of structures changes anything.
        let order: Vec<usize> = cohort.rows_of_persons().into_values().flatten().collect();
        let (rows, structures) = (cohort.of_rows(&order), cohort.structures());
        let stated: Vec<String> = order.iter().filter_map(|&k| hashes.get(k).cloned()).collect();
        if let TemplateChoice::Made(how) = &settings.template {
            if let Some(unknown) = how.given.keys().find(|name| !structures.contains(name)) {
                let known = structures.join(", ");
                return fault(format!("a template is given for {unknown}; the structures of the table are: {known}"));
            }
            if let Some(unknown) = how.start.as_ref().filter(|id| row_of(&rows, id).is_none()) {
                return fault(format!("the study has no subject {unknown}; its ids are in the table"));
            }
        }
        let mut cohorts: Vec<(String, Vec<usize>, Cohort)> = Vec::new();
        for name in structures {
            let own = |k: &usize| rows.subjects[*k].structure_name() == Some(&name);
            let own: Vec<usize> = (0..rows.subjects.len()).filter(own).collect();
            let cohort = rows.of_rows(&own);
            cohorts.push((name, own, cohort));
        }
        // One side for all structures; a given template decides that it has to be stated.
        let sides = cohorts
            .iter()
            .map(|(name, _, cohort)| crate::sides::template_side(&rows, &settings_of(name, cohort, &settings)?));
        let sides = sides.collect::<Result<Vec<_>, StudyError>>()?;
        settings.template_side = sides.first().copied().flatten();
        let (mut parts, mut found, mut from) = (Vec::new(), vec![String::new(); rows.subjects.len()], Vec::new());
        for (name, own, cohort) in cohorts {
            let stated: Vec<String> = own.iter().filter_map(|&k| stated.get(k).cloned()).collect();
            let settings = settings_of(&name, &cohort, &settings)?;
            let study = Study::open(cohort, settings, &stated, folder, watcher).map_err(of_structure(&name))?;
            own.iter().zip(&study.hashes).for_each(|(&k, hash)| found[k].clone_from(hash));
            if let TemplateChoice::Made(how) = &study.settings.template {
                from.extend_from_slice(&how.from);
            }
            parts.push(Part { name, study, given: own.iter().map(|&k| order[k]).collect() });
        }
        if let TemplateChoice::Made(how) = &mut settings.template {
            how.from = from;
        }
        Ok(ComplexStudy { rows, hashes: found, settings, parts })
    }

    fn find(
        self,
        matched: &[Matched],
        folder: &Folder,
        decisions: &[Decision],
        watcher: &dyn StudyObserver,
    ) -> Result<(Study, Findings), StudyError> {
        let observer = &Interruption(watcher);
        let mut placed_parts = Vec::new();
        for (part, matched) in self.parts.iter().zip(matched) {
            let (mut matched, named) = (matched.clone(), Named { structure: &part.name, watcher });
            let own = decisions_on_rows(&part.study.cohort, decisions);
            let group = decide(&part.study, &mut matched, folder, &own, observer)?;
            let (rows, _, joint) =
                placed(&part.study, (&mut matched, &group), folder, &own, &named).map_err(of_structure(&part.name))?;
            placed_parts.push(PlacedPart { part, matched, rows, joint });
        }
        let persons = self.rows.persons();
        let ids: Vec<&str> = persons.subjects.iter().map(|person| person.id.as_str()).collect();
        let rows_of_persons = rows_of(&placed_parts, &ids);
        let template = template(&placed_parts, &rows_of_persons, folder, observer)?;
        let decided = decisions_on_persons(&placed_parts, &rows_of_persons, &ids, decisions);
        let (mut keys, mut of_persons) = (Vec::new(), Vec::new());
        for rows in &rows_of_persons {
            checkpoint(observer)?;
            let structures = structures_of(&placed_parts, rows);
            let key = key(&template, &placed_parts, rows);
            if !folder.has(&key) {
                folder.keep(&key, &record(&placed_parts, rows, &structures, folder)?)?;
            }
            keys.push(key);
            of_persons.push(structures);
        }
        folder.keep_records(PART, &keys, &[]);
        let (mut structures, mut first) = (Vec::new(), 0);
        for PlacedPart { part, matched, joint, .. } in &placed_parts {
            let TemplateHistory { template, rounds } = &matched.making;
            let vertices = first..first + template.mesh.n_vertices();
            first = vertices.end;
            let (name, template) = (part.name.clone(), template.hash.clone());
            structures.push(Structure { name, vertices, template, rounds: rounds.clone(), joint: joint.clone() });
        }
        drop(placed_parts);
        let study = Study {
            hashes: vec![String::new(); persons.subjects.len()],
            cohort: persons,
            // The records of persons are made of joint maps already.
            settings: Settings { correspondence: Correspondence::Pairs, ..self.settings.clone() },
            first: template.clone(),
            kept: None,
            makers: Vec::new(),
            ring: Vec::new(),
            persons: Vec::new(),
        };
        let making = TemplateHistory { template, rounds: Vec::new() };
        let matched = Matched { making, keys, cycles: Cycles::default(), own: Vec::new(), rivals: Vec::new() };
        let ComplexStudy { rows, hashes, settings, .. } = self;
        let complex = Complex { structures, rows, hashes, settings, of_persons };
        let found = find_with((&study, &matched, Some(complex)), folder, &decided, watcher)?;
        Ok((study, found))
    }
}

/// The decisions on the rows of a structure: those on a row, else those on its person.
fn decisions_on_rows(rows: &Cohort, decisions: &[Decision]) -> Vec<Decision> {
    let of = |row: &Subject| {
        let on = |id: &str| decisions.iter().find(|decision| decision.id == id);
        let decision = on(&row.id).or_else(|| on(&row.structure.as_ref()?.of))?;
        Some(Decision { id: row.id.clone(), ..decision.clone() })
    };
    rows.subjects.iter().filter_map(of).collect()
}

/// The row of each person in each structure.
fn rows_of(parts: &[PlacedPart<'_>], ids: &[&str]) -> Vec<Vec<Option<usize>>> {
    let of_part = |part: &PlacedPart<'_>| -> BTreeMap<String, usize> {
        let rows = part.part.study.cohort.subjects.iter().enumerate();
        rows.filter_map(|(k, row)| Some((row.structure.as_ref()?.of.clone(), k))).collect()
    };
    let of_parts: Vec<_> = parts.iter().map(of_part).collect();
    ids.iter().map(|id| of_parts.iter().map(|rows| rows.get(*id).copied()).collect()).collect()
}

/// The decisions on persons: one on a person, else one that drops one of its rows, else one that keeps all its rows that
/// are not reliable.
fn decisions_on_persons(
    parts: &[PlacedPart<'_>],
    rows_of_persons: &[Vec<Option<usize>>],
    ids: &[&str],
    decisions: &[Decision],
) -> Vec<Decision> {
    let of = |(id, rows): (&&str, &Vec<Option<usize>>)| {
        if let Some(own) = decisions.iter().find(|decision| decision.id == **id) {
            return Some(own.clone());
        }
        let found: Vec<(&str, &SubjectFindings)> = parts
            .iter()
            .zip(rows)
            .filter_map(|(part, row)| Some((part.part.name.as_str(), &part.rows[(*row)?])))
            .collect();
        let decided = |verdict: Verdict| {
            let is_wanted = |decision: &&Decision| decision.decision == verdict;
            let (name, decision) =
                found.iter().find_map(|(name, row)| Some((name, row.decision.as_ref().filter(is_wanted)?)))?;
            let reason = format!("{name}: {}", decision.reason);
            Some(Decision { id: (*id).to_owned(), decision: verdict, reason })
        };
        let is_doubted = found.iter().any(|(_, row)| row.place == SubjectOutcome::Unreliable);
        decided(Verdict::Dropped).or_else(|| decided(Verdict::Kept).filter(|_| !is_doubted))
    };
    ids.iter().zip(rows_of_persons).filter_map(of).collect()
}

/// Findings for the structures of a person.
fn structures_of(parts: &[PlacedPart<'_>], rows: &[Option<usize>]) -> Vec<StructureFindings> {
    let of = |(part, row): (&PlacedPart<'_>, &Option<usize>)| {
        let name = part.part.name.clone();
        let missing = || Facts { error: Some(format!("no structure {name}")), ..Facts::default() };
        let facts = row.map_or_else(missing, |row| part.rows[row].facts.clone());
        let group = row.and_then(|row| part.rows[row].group);
        StructureFindings { name, facts, group, pose: None }
    };
    parts.iter().zip(rows).map(of).collect()
}

/// The facts on a person, from those on its structures: distances are the largest, the confidence is the least, sizes are
/// sums.
fn facts(structures: &[StructureFindings], rows: &[Option<usize>]) -> Facts {
    let each = || structures.iter().map(|structure| &structure.facts);
    let named = |of: &dyn Fn(&Facts) -> Vec<String>| -> Vec<String> {
        let of_structure = |structure: &StructureFindings| {
            let name = structure.name.clone();
            of(&structure.facts).into_iter().map(move |text| format!("{name}: {text}"))
        };
        structures.iter().flat_map(of_structure).collect()
    };
    let error = structures.iter().zip(rows).find_map(|(StructureFindings { name, facts, .. }, row)| {
        let error = facts.error.as_ref()?;
        Some(if row.is_some() { format!("{name}: {error}") } else { error.clone() })
    });
    let largest = |of: &dyn Fn(&Facts) -> f64| each().map(of).fold(0.0, f64::max);
    Facts {
        error,
        reliable: if each().any(|facts| facts.reliable == Some(false)) {
            Some(false)
        } else {
            each().map(|facts| facts.reliable).collect::<Option<Vec<bool>>>().map(|_| true)
        },
        reasons: named(&|facts| facts.reasons.clone()),
        rigid_distance_mm: largest(&|facts| facts.rigid_distance_mm),
        residual_mm: largest(&|facts| facts.residual_mm),
        residual_p95_mm: largest(&|facts| facts.residual_p95_mm),
        folded: largest(&|facts| facts.folded),
        confidence: each().map(|facts| facts.confidence).fold(f64::INFINITY, f64::min),
        volume_mm3: each().map(|facts| facts.volume_mm3).sum(),
        area_mm2: each().map(|facts| facts.area_mm2).sum(),
        n_vertices: each().map(|facts| facts.n_vertices).sum(),
        repairs: named(&|facts| facts.repairs.clone()),
        rivals: Vec::new(),
    }
}

/// The name of the record of a person: a hash of what it is made of.
fn key(template: &Template, parts: &[PlacedPart<'_>], rows: &[Option<usize>]) -> String {
    let of_rows = parts.iter().zip(rows).flat_map(|(part, row)| {
        let key = row.map_or("", |row| part.matched.keys[row].as_str());
        [part.part.name.as_str(), key]
    });
    let made_of = [VERSION, env!("CARGO_PKG_VERSION"), &template.hash].into_iter().chain(of_rows);
    format!("{PART}/{}", hash_of_texts(made_of))
}

/// The record of a person; without points if a structure has none.
fn record(
    parts: &[PlacedPart<'_>],
    rows: &[Option<usize>],
    structures: &[StructureFindings],
    folder: &Folder,
) -> Result<Record, StudyError> {
    let facts = facts(structures, rows);
    if let Some(error) = facts.error {
        return Ok(Record::failed(error));
    }
    let mut all = Vec::new();
    for (part, row) in parts.iter().zip(rows) {
        all.extend(part.points(*row, folder)?);
    }
    Ok(Record { facts, points: all })
}

/// The template of persons: those of the structures, the first where it is, and each other one where it lies on average
/// once the first lies there. Averaged over the persons of the model; at least three.
fn template(
    parts: &[PlacedPart<'_>],
    rows_of_persons: &[Vec<Option<usize>>],
    folder: &Folder,
    observer: &dyn Observer,
) -> Result<Template, StudyError> {
    let is_member = |rows: &&Vec<Option<usize>>| {
        let place = |(part, row): (&PlacedPart<'_>, &Option<usize>)| row.map(|row| part.rows[row].place);
        parts.iter().zip(rows.iter()).all(|of| place(of) == Some(SubjectOutcome::Model))
    };
    let members: Vec<&Vec<Option<usize>>> = rows_of_persons.iter().filter(is_member).collect();
    if members.len() < 3 {
        return Err(StudyError::TooFewMatches {
            matched: members.len(),
            all: rows_of_persons.len(),
            purpose: "with all structures for a shape model",
            reason: lacking(parts, rows_of_persons),
        });
    }
    let meshes: Vec<_> = parts.iter().map(|part| &part.matched.making.template.mesh).collect();
    let weights: Vec<Vec<f64>> = meshes.iter().map(|mesh| area_weights(mesh)).collect();
    let mut sums: Vec<Vec<Vector3<f64>>> =
        meshes.iter().map(|mesh| vec![Vector3::zeros(); mesh.n_vertices()]).collect();
    let degenerate = |error| StudyError::Alignment { id: "of a template".to_owned(), error };
    for rows in &members {
        checkpoint(observer)?;
        let shape = |at: usize| parts[at].points(rows[at], folder).map(|found| points(&found));
        let onto = fit_onto(&shape(0)?, meshes[0].vertices(), &weights[0], false).map_err(degenerate)?;
        for (at, sum) in sums.iter_mut().enumerate().skip(1) {
            sum.iter_mut().zip(shape(at)?).for_each(|(sum, p)| *sum += onto.apply(&p).coords);
        }
    }
    let mut surfaces = vec![meshes[0].clone()];
    for at in 1..parts.len() {
        let mean: Vec<Point3<f64>> = sums[at].iter().map(|sum| Point3::from(sum / members.len() as f64)).collect();
        let onto = fit_onto(meshes[at].vertices(), &mean, &weights[at], false).map_err(degenerate)?;
        surfaces.push(meshes[at].with_vertices(meshes[at].vertices().iter().map(|p| onto.apply(p)).collect())?);
    }
    Ok(Template::new(&concatenated(&surfaces)?))
}

/// Why the first person that is not part of the model is not, in words.
fn lacking(parts: &[PlacedPart<'_>], rows_of_persons: &[Vec<Option<usize>>]) -> String {
    let reasons = rows_of_persons.iter().flat_map(|rows| {
        parts.iter().zip(rows).filter_map(|(part, row)| {
            let name = &part.part.name;
            let Some(row) = row else { return Some(format!("no structure {name}")) };
            match part.rows[*row].place {
                SubjectOutcome::Model | SubjectOutcome::Scored => None,
                place => Some(format!("{name} is {}", place.name())),
            }
        })
    });
    let distinct: BTreeSet<String> = reasons.collect();
    distinct.into_iter().next().unwrap_or_default()
}
