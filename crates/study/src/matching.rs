//! Runs a study from its files to all its matches, on the threads of this process.

use crate::cohort::Cohort;
use crate::error::StudyError;
use crate::folder::{Folder, Kept};
use crate::plan::{Matched, Purpose, Step, Study, Task, Template, TemplateHistory, hash, input_of, spread, surface};
use crate::record::{Record, compute};
use crate::rivals::rival_surfaces;
use crate::settings::{Settings, TemplateChoice};
use homolog_contract::parameters::LabelChoice;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_run::{InputFile, SurfaceCache};
use parking_lot::Mutex;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Memory for prepared surfaces, bytes; the template is prepared only once.
const PREPARED_BYTES: u64 = 256 << 20;
/// Subfolder of the kept template.
const TEMPLATE: &str = "template";

/// Receives the progress of a study, from one thread at a time, and may interrupt it.
pub trait StudyObserver: Sync {
    /// The current activity, and its progress.
    fn progress(&self, what: &str, done: usize, of: usize) {
        let _ = (what, done, of);
    }
    /// Whether to stop. Finished results are kept.
    fn is_interrupted(&self) -> bool {
        false
    }
}

/// Passes an interruption on to a computation.
pub(crate) struct Interruption<'a>(pub(crate) &'a dyn StudyObserver);

impl Observer for Interruption<'_> {
    fn is_cancelled(&self) -> bool {
        self.0.is_interrupted()
    }
}

fn name(path: &Path) -> Option<&str> {
    path.file_name().and_then(|name| name.to_str())
}

impl Study {
    /// A study over files. Hashes every subject, and takes the given template, or the surface from which a template is
    /// made, or the template kept in the folder.
    ///
    /// `hashes`: hashes of the files in an earlier `study.json`; empty if there is none.
    ///
    /// # Errors
    /// [`StudyError`]; [`StudyError::Interrupted`] if the watcher asked to stop.
    pub fn open(
        cohort: Cohort,
        mut settings: Settings,
        hashes: &[String],
        folder: &Folder,
        watcher: &dyn StudyObserver,
    ) -> Result<Self, StudyError> {
        let found: Vec<String> =
            cohort.subjects.par_iter().map(|subject| folder.input_hash(&subject.file)).collect::<Result<_, _>>()?;
        for (subject, (found, stated)) in cohort.subjects.iter().zip(found.iter().zip(hashes)) {
            if found != stated {
                return Err(StudyError::Changed { path: subject.file.clone() });
            }
        }
        let structures = cohort.structures();
        if structures.len() > 1 {
            let why = format!("this is for one structure, and the table has {}", structures.join(", "));
            return Err(StudyError::Settings(why));
        }
        settings.template_side = crate::sides::template_side(&cohort, &settings)?;
        let asked = asked(&settings);
        // Other labels of the subjects that it was made from are another template.
        let kept = folder
            .kept(&cohort.subfolder(TEMPLATE), &asked)?
            .filter(|(kept, _)| kept.labels == stated_labels(&cohort, &kept.from));
        let by_id = |id: &String| {
            let place = cohort.subjects.iter().position(|subject| subject.id == *id);
            place
                .ok_or_else(|| StudyError::Settings(format!("the study has no subject {id}; its ids are in the table")))
        };
        let places = |ids: &[String]| ids.iter().map(by_id).collect::<Result<Vec<usize>, _>>();
        let known = |ids: &[String]| ids.iter().all(|id| cohort.subjects.iter().any(|subject| subject.id == *id));
        let recorded = kept.as_ref().map(|(kept, _)| kept);
        let ring = match (recorded.filter(|kept| known(&kept.ring)), settings.cycle_ring.as_slice()) {
            (Some(kept), _) => places(&kept.ring)?,
            (None, []) if settings.cycle_subjects < 3 => Vec::new(),
            (None, []) => spread(&cohort, settings.cycle_subjects),
            (None, ids) => places(ids)?,
        };
        let ids = |places: &[usize]| places.iter().map(|&k| cohort.subjects[k].id.clone()).collect::<Vec<_>>();
        settings.cycle_ring = ids(&ring);
        let parameters = settings.parameters.clone();
        let (first, making, makers) = match &mut settings.template {
            TemplateChoice::Given { file } => {
                let refused = |why| StudyError::Start { what: file.display().to_string(), why };
                let first = surface(&folder.input(file)?, name(file), &parameters.input.of_target());
                let first = first.map_err(refused)?;
                (first, None, Vec::new())
            }
            TemplateChoice::Made(how) => {
                if let Some((kept, template)) = kept {
                    how.from.clone_from(&kept.from);
                    let making = TemplateHistory { template: template.clone(), rounds: kept.rounds };
                    (template, Some(making), Vec::new())
                } else {
                    let makers = if how.from.is_empty() { spread(&cohort, how.subjects) } else { places(&how.from)? };
                    how.from = ids(&makers);
                    let start = how.start.as_ref().map(by_id).transpose()?;
                    let side = settings.template_side;
                    (start_surface((&cohort, side), &parameters, start, &makers, folder, watcher)?, None, makers)
                }
            }
        };
        let persons = Vec::new();
        let mut study = Study { cohort, settings, hashes: found, first, kept: making, makers, ring, persons };
        study.find_persons(folder, watcher)?;
        Ok(study)
    }

    /// Computes every missing match on `threads` threads, and stores each when it is finished. Returns when all matches
    /// exist.
    ///
    /// # Errors
    /// [`StudyError`]; [`StudyError::Interrupted`] if the watcher asked to stop.
    pub fn match_all(
        &mut self,
        folder: &Folder,
        threads: usize,
        watcher: &dyn StudyObserver,
    ) -> Result<Matched, StudyError> {
        let surfaces = SurfaceCache::new(PREPARED_BYTES);
        loop {
            match self.advance(folder, watcher)? {
                Step::Matched(matched) => return Ok(*matched),
                Step::Match { purpose, template, tasks, finished, own } => {
                    let what = match purpose {
                        Purpose::Template(round) => format!("template, round {round}"),
                        Purpose::Visits(round) => format!("templates of persons, step {round} of 3"),
                        Purpose::Subjects => "matching".to_owned(),
                        Purpose::Rivals => "rival poses".to_owned(),
                    };
                    let all = finished + tasks.len();
                    let at = Mutex::new(finished);
                    let done = || {
                        let mut at = at.lock();
                        *at += 1;
                        watcher.progress(&what, *at, all);
                    };
                    watcher.progress(&what, finished, all);
                    each(&tasks, threads, &|task| {
                        let record = self.compute(task, (&template, &own), &surfaces, folder, watcher)?;
                        folder.keep(&task.key, &record)?;
                        done();
                        Ok(())
                    })?;
                }
            }
        }
    }

    /// The next step, given the existing records. A finished template is stored, so that a subject added later costs
    /// one match. With all matches, the maps of visits whose person has its own template are composed and stored. A step to
    /// rival poses gets the surfaces of its subjects in these poses.
    ///
    /// # Errors
    /// Errors of [`Study::next`], and [`StudyError::File`].
    pub fn advance(&mut self, folder: &Folder, watcher: &dyn StudyObserver) -> Result<Step, StudyError> {
        let observer = Interruption(watcher);
        let mut step = self.next(folder, &observer)?;
        match &mut step {
            Step::Matched(matched) => self.compose(matched, folder, &observer)?,
            Step::Match { purpose: Purpose::Rivals, tasks, own, .. } => {
                *own = rival_surfaces(self, tasks, folder, &observer)?;
            }
            Step::Match { .. } => {}
        }
        if self.kept.is_some() {
            return Ok(step);
        }
        let making = match &step {
            Step::Matched(matched) => matched.making.clone(),
            Step::Match { purpose: Purpose::Template(_), .. } => return Ok(step),
            Step::Match { purpose: Purpose::Subjects | Purpose::Visits(_) | Purpose::Rivals, template, .. } => {
                let given = || TemplateHistory { template: (**template).clone(), rounds: Vec::new() };
                self.making(folder, &observer)?.unwrap_or_else(given)
            }
        };
        self.keep_making(folder, &making)?;
        Ok(step)
    }

    fn keep_making(&mut self, folder: &Folder, making: &TemplateHistory) -> Result<(), StudyError> {
        let kept = Kept {
            asked: asked(&self.settings),
            hash: making.template.hash.clone(),
            from: match &self.settings.template {
                TemplateChoice::Made(how) => how.from.clone(),
                TemplateChoice::Given { .. } => Vec::new(),
            },
            labels: match &self.settings.template {
                TemplateChoice::Made(how) => stated_labels(&self.cohort, &how.from),
                TemplateChoice::Given { .. } => BTreeMap::new(),
            },
            ring: self.settings.cycle_ring.clone(),
            rounds: making.rounds.clone(),
        };
        folder.keep_template(&self.cohort.subfolder(TEMPLATE), &kept, making)?;
        self.kept = Some(making.clone());
        Ok(())
    }

    /// Computes one match of a step, which has these templates: that of the group, and those of persons or the surfaces in
    /// rival poses.
    ///
    /// # Errors
    /// [`StudyError::File`], [`StudyError::Changed`] and [`StudyError::Interrupted`].
    pub fn compute(
        &self,
        task: &Task,
        (template, own): (&Template, &[Template]),
        surfaces: &SurfaceCache,
        folder: &Folder,
        watcher: &dyn StudyObserver,
    ) -> Result<Record, StudyError> {
        let bytes = |side: Option<usize>| match side {
            None => Ok(None),
            Some(k) => {
                let path = &self.cohort.subjects[k].file;
                let bytes = folder.input(path)?;
                if hash(&bytes) == self.hashes[k] {
                    Ok(Some(bytes))
                } else {
                    Err(StudyError::Changed { path: path.clone() })
                }
            }
        };
        let (source, target) = (bytes(task.source)?, bytes(task.target)?);
        let (source, target) = (source.as_deref(), target.as_deref());
        let own = task.own.and_then(|k| own.get(k)).unwrap_or(template);
        // The template of a person moves onto a subject, or that of the group onto it.
        let moving = if task.target.is_some() { own } else { template };
        let file = |side: Option<usize>| side.and_then(|k| name(&self.cohort.subjects[k].file));
        let source = InputFile { bytes: source.unwrap_or(&moving.ply), name: file(task.source) };
        let target = InputFile { bytes: target.unwrap_or(&own.ply), name: file(task.target) };
        compute(surfaces, source, target, &self.parameters(task), &Interruption(watcher)).ok_or(StudyError::Interrupted)
    }
}

/// The labels that these subjects state for their volumes, by id.
fn stated_labels(cohort: &Cohort, ids: &[String]) -> BTreeMap<String, Vec<LabelChoice>> {
    let of = cohort.subjects.iter().filter(|subject| ids.contains(&subject.id));
    of.filter_map(|subject| Some((subject.id.clone(), subject.labels.clone()?))).collect()
}

/// Settings on which a kept template depends, besides the files of its subjects.
fn asked(settings: &Settings) -> String {
    let mut template = settings.template.clone();
    if let TemplateChoice::Made(how) = &mut template {
        how.from.clear();
    }
    let mut text =
        serde_json::to_string(&(template, settings.cycle_subjects, &settings.parameters)).unwrap_or_default();
    if let Some(side) = settings.template_side {
        text.push_str(side.name());
    }
    hash(text.as_bytes())
}

/// The surface from which a template is made: that of the requested subject, or the one of median volume (for open
/// surfaces, median area) among the subjects it is made from. Mirrored if it lies on the other side.
fn start_surface(
    (cohort, side): (&Cohort, Option<homolog_contract::input::BodySide>),
    parameters: &homolog_contract::parameters::MatchParameters,
    start: Option<usize>,
    makers: &[usize],
    folder: &Folder,
    watcher: &dyn StudyObserver,
) -> Result<Template, StudyError> {
    let of = |k: usize| {
        checkpoint(&Interruption(watcher))?;
        let file = &cohort.subjects[k].file;
        let input = input_of(cohort.subjects[k].labels.as_deref(), parameters);
        let found = surface(&folder.input(file)?, name(file), &input);
        if cohort.subjects[k].side.is_none_or(|own| Some(own) == side) {
            return Ok(found);
        }
        Ok(found.and_then(|template| {
            let mirrored = crate::mirror::mirrored(&template.mesh).map_err(|error| error.to_string())?;
            Ok(Template::new(&mirrored))
        }))
    };
    if let Some(k) = start {
        let refused = |why| StudyError::Start { what: format!("subject {}", cohort.subjects[k].id), why };
        return of(k)?.map_err(refused);
    }
    let found: Vec<Result<Template, String>> = makers.par_iter().map(|&k| of(k)).collect::<Result<_, StudyError>>()?;
    let (mut sized, mut reason) = (Vec::new(), String::new());
    for (k, found) in found.into_iter().enumerate() {
        match found {
            Ok(template) => {
                let closed = template.mesh.boundary_vertices().is_none();
                let size = if closed { template.mesh.signed_volume() } else { template.mesh.area() };
                sized.push((size, k, template));
            }
            Err(why) => reason = why,
        }
    }
    sized.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let middle = sized.len() / 2;
    let found = sized.into_iter().nth(middle).map(|(_, _, template)| template);
    found.ok_or(StudyError::Start { what: "any subject".to_owned(), why: reason })
}

/// Runs every task on one thread of its own pool. Matches must not share a pool: a thread that waits for a part of one
/// match would start another one, and hold resources that the first needs.
fn each(
    tasks: &[Task],
    threads: usize,
    work: &(dyn Fn(&Task) -> Result<(), StudyError> + Sync),
) -> Result<(), StudyError> {
    let (next, fault) = (AtomicUsize::new(0), Mutex::new(None));
    let has_failed = || fault.lock().is_some();
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, tasks.len().max(1)) {
            scope.spawn(|| {
                let pool = match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
                    Ok(pool) => pool,
                    Err(error) => {
                        let error = StudyError::Internal(format!("a thread for matches cannot be started: {error}"));
                        fault.lock().get_or_insert(error);
                        return;
                    }
                };
                pool.install(|| {
                    while let Some(task) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
                        if has_failed() {
                            return;
                        }
                        if let Err(error) = work(task) {
                            fault.lock().get_or_insert(error);
                            return;
                        }
                    }
                });
            });
        }
    });
    match fault.into_inner() {
        Some(error) => Err(error),
        None => Ok(()),
    }
}
