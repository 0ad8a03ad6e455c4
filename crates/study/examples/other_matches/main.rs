//! A study with the correspondences of another method: the subjects, template, decisions and statistics of a finished study, so that
//! correspondence is all that differs. `benches/study/others.py` runs it.
//!
//! Usage:
//! - `other_matches spharm STUDY OTHER`: by spherical harmonics (`spharm`), computed here;
//! - `other_matches tasks STUDY OTHER`: writes to `OTHER/tasks` the surfaces of the template and the subjects (PLY), and `tasks.csv`
//!   with a row for each match that is wanted: key, source, target;
//! - `other_matches images STUDY OTHER`: reads `OTHER/tasks/KEY.f32`, the positions on the target of the source's vertices, three
//!   little-endian floats each, mm; a match without such a file is one that failed.
//!
//! The report in OTHER says that this program matched; that is not so.
#![allow(clippy::print_stdout)]

mod spharm;

use homolog_formats::ply::write_ply;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_registration::{ProcrustesOptions, procrustes};
use homolog_run::intake::{IntakeLimits, prepare_surface};
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::output::{read_document, write};
use homolog_study::plan::{Step, Study, Task, Template};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::TemplateChoice;
use nalgebra::Point3;
use rayon::prelude::*;
use spharm::Expansion;
use std::error::Error;
use std::fs;
use std::path::Path;

struct Quiet;
impl StudyObserver for Quiet {}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, mode, original, other] = arguments.as_slice() else {
        return Err("usage: other_matches spharm|tasks|images STUDY OTHER".into());
    };
    let (original, other) = (Path::new(original), Path::new(other));
    let document = read_document(&fs::read(original.join("study.json"))?)?;
    let mut settings = document.settings;
    settings.template = TemplateChoice::Given { file: original.join("template/template.ply") };
    let folder = Folder::create(other)?;
    let mut study = Study::open(document.cohort, settings, &document.hashes, &folder, &Quiet)?;
    let (template, tasks) = match study.next(&folder, &Silent)? {
        Step::Match { template, tasks, .. } => (*template, tasks),
        Step::Matched(matched) => (matched.making.template, Vec::new()),
    };
    let surfaces = Surfaces::new(&study, template);
    match mode.as_str() {
        "tasks" => return list(&study, &surfaces, &tasks, other),
        "images" => {
            for task in &tasks {
                let path = other.join("tasks").join(format!("{}.f32", task.key));
                let images = fs::read(&path).map(|bytes| points(&bytes)).map_err(|_| "there are no images".to_owned());
                folder.keep(&task.key, &surfaces.record(task, images))?;
            }
        }
        "spharm" => by_harmonics(&surfaces, &tasks, &folder)?,
        other => return Err(format!("{other} is none of spharm, tasks and images").into()),
    }
    let matched = study.match_all(&folder, 1, &Quiet)?;
    let found = find(&study, &matched, &folder, &document.decisions, &Quiet)?;
    write(&study, &found, &document.decisions, &folder, "none: correspondences of another method", &Quiet)?;
    println!("{} subjects in the model, {} without a match", found.members.len(), failed(&study, &found));
    Ok(())
}

fn failed(study: &Study, found: &homolog_study::findings::Findings) -> usize {
    let subjects = found.subjects.iter().zip(&study.cohort.subjects);
    subjects.filter(|(found, _)| found.facts.error.is_some()).count()
}

/// The surfaces of a study as they would be matched; `Err` where a file is refused. Records count the vertices of uploads, which are
/// the same unless a repair drops some.
struct Surfaces {
    template: Template,
    subjects: Vec<Result<SurfaceMesh, String>>,
}

impl Surfaces {
    fn new(study: &Study, template: Template) -> Self {
        let parameters = study.settings.parameters.input.of_target();
        let of = |file: &std::path::PathBuf| {
            let bytes = fs::read(file).map_err(|error| error.to_string())?;
            let name = file.file_name().and_then(|name| name.to_str());
            let prepared = prepare_surface(&bytes, name, &parameters, &IntakeLimits::default());
            prepared.map(|prepared| prepared.mesh).map_err(|error| error.for_command_line())
        };
        Surfaces { template, subjects: study.cohort.subjects.par_iter().map(|subject| of(&subject.file)).collect() }
    }

    fn side(&self, side: Option<usize>) -> Result<&SurfaceMesh, String> {
        side.map_or(Ok(&self.template.mesh), |k| self.subjects[k].as_ref().map_err(Clone::clone))
    }

    /// The record of a match from the positions of the source's vertices on the target.
    fn record(&self, task: &Task, images: Result<Vec<Point3<f64>>, String>) -> Record {
        self.judged(task, images).unwrap_or_else(|error| Record {
            facts: Facts { error: Some(error), ..Facts::default() },
            points: Vec::new(),
        })
    }

    fn judged(&self, task: &Task, images: Result<Vec<Point3<f64>>, String>) -> Result<Record, String> {
        let (source, target, images) = (self.side(task.source)?, self.side(task.target)?, images?);
        if images.len() != source.n_vertices() {
            return Err(format!("{} images of {} vertices", images.len(), source.n_vertices()));
        }
        let bent = source.with_vertices(images).map_err(|error| error.to_string())?;
        let options = ProcrustesOptions::default();
        let pose = procrustes(source.vertices(), bent.vertices(), None, &options).map_err(|error| error.to_string())?;
        let pose = pose.target_from_source;
        let distances = |from: &SurfaceMesh, onto: &SurfaceMesh| {
            let index = ClosestPointIndex::new(onto);
            let mut all: Vec<f64> = from.vertices().iter().map(|p| (index.closest(p).point - p).norm()).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len().max(1) as f64;
        let rigid = source
            .with_vertices(source.vertices().iter().map(|p| pose.apply(p)).collect())
            .map_err(|error| error.to_string())?;
        let residuals = distances(target, &bent);
        let faces = source.face_vector_areas().into_iter().zip(bent.face_vector_areas());
        let folded = faces.filter(|(before, after)| (pose.rotation * before).dot(after) <= 0.0).count();
        let facts = Facts {
            rigid_distance_mm: mean(&distances(target, &rigid)),
            residual_mm: mean(&residuals),
            residual_p95_mm: residuals.get(residuals.len() * 19 / 20).copied().unwrap_or(0.0),
            folded: folded as f64 / source.n_faces() as f64,
            volume_mm3: target.boundary_vertices().is_none().then(|| target.signed_volume()),
            area_mm2: target.area(),
            n_vertices: target.n_vertices() as u32,
            ..Facts::default()
        };
        let points = bent.vertices().iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        Ok(Record { facts, points })
    }
}

fn points(bytes: &[u8]) -> Vec<Point3<f64>> {
    let (numbers, _) = bytes.as_chunks::<4>();
    let numbers: Vec<f64> = numbers.iter().map(|four| f64::from(f32::from_le_bytes(*four))).collect();
    numbers.chunks_exact(3).map(Point3::from_slice).collect()
}

fn list(study: &Study, surfaces: &Surfaces, tasks: &[Task], other: &Path) -> Result<(), Box<dyn Error>> {
    let place = other.join("tasks");
    fs::create_dir_all(&place)?;
    fs::write(place.join("template.ply"), &surfaces.template.ply)?;
    for (subject, surface) in study.cohort.subjects.iter().zip(&surfaces.subjects) {
        if let Ok(surface) = surface {
            fs::write(place.join(format!("subject-{}.ply", subject.id)), write_ply(surface))?;
        }
    }
    let name = |side: Option<usize>| match side {
        None => "template".to_owned(),
        Some(k) => format!("subject-{}", study.cohort.subjects[k].id),
    };
    let rows = tasks.iter().map(|task| format!("{},{},{}\n", task.key, name(task.source), name(task.target)));
    fs::write(place.join("tasks.csv"), format!("key,source,target\n{}", rows.collect::<String>()))?;
    println!("{} matches are wanted", tasks.len());
    Ok(())
}

fn by_harmonics(surfaces: &Surfaces, tasks: &[Task], folder: &Folder) -> Result<(), Box<dyn Error>> {
    let template = Expansion::new(&surfaces.template.mesh)?;
    let subjects: Vec<Result<Expansion, String>> =
        surfaces.subjects.par_iter().map(|mesh| Expansion::new(mesh.as_ref().map_err(Clone::clone)?)).collect();
    let of = |side: Option<usize>| side.map_or(Ok(&template), |k| subjects[k].as_ref().map_err(Clone::clone));
    let records: Vec<Record> = tasks
        .par_iter()
        .map(|task| {
            let images = || {
                let (own, other) = (of(task.source)?, of(task.target)?);
                Ok(own.images(surfaces.side(task.source)?.vertices(), other))
            };
            surfaces.record(task, images())
        })
        .collect();
    for (task, record) in tasks.iter().zip(&records) {
        folder.keep(&task.key, record)?;
    }
    Ok(())
}
