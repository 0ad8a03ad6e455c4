//! Studies of any size without a match, for tests of what their steps take.
#![allow(dead_code, reason = "each test binary uses a part")]

use homolog_contract::parameters::{Method, preset};
use homolog_contract::study::StudySize;
use homolog_formats::ply::write_ply;
use homolog_formats::write_zip;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::output::write;
use homolog_study::plan::{Step, Study, Template};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

struct Quiet;
impl StudyObserver for Quiet {}

/// What a study does besides matches of its template, a model and statistics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extra {
    None,
    /// Maps are revised together.
    Joint,
    /// Half of the subjects are ambiguous, with as many other poses as are followed.
    Rivals,
    /// Every person has two visits and a template of its own.
    OwnTemplates,
}

/// Files of the template and of the subjects: surfaces with the faces of the template, if they are read.
#[derive(Debug, Clone)]
struct Files {
    template: SurfaceMesh,
    has_surfaces: bool,
}

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        if file.ends_with("template.ply") {
            return Ok(write_ply(&self.template));
        }
        let subject = file.file_stem().and_then(|name| name.to_str()?.strip_prefix('s')?.parse().ok());
        Ok(match subject {
            Some(k) if self.has_surfaces => write_ply(&surface(&self.template, k)),
            _ => b"no volume".to_vec(),
        })
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        // Without surfaces all files of subjects are equal.
        let bytes = if self.has_surfaces { self.read(file)? } else { file.to_string_lossy().as_bytes().to_vec() };
        Ok(blake3::hash(&bytes).to_hex().to_string())
    }
}

/// A study whose matches have been made.
pub(crate) struct Made {
    /// Its size.
    pub size: StudySize,
    /// Records of its matches.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Names of those of matches in rival poses.
    pub rivals: Vec<String>,
    table: String,
    settings: Settings,
    inputs: Files,
}

/// The surface of subject `k`.
fn surface(template: &SurfaceMesh, k: f64) -> SurfaceMesh {
    let ripple = |p: &Point3<f64>| Point3::new(p.x * (1.0 + 0.01 * (k * 0.7).sin()), p.y, p.z + 0.1 * (p.x + k).sin());
    template.with_vertices(template.vertices().iter().map(ripple).collect()).unwrap()
}

/// A study of this many subjects with a template of `10 · 4^levels + 2` vertices.
pub(crate) fn made(subjects: usize, levels: u32, contrasts: usize, covariates: usize, permutations: usize) -> Made {
    made_with(Extra::None, subjects, levels, contrasts, covariates, permutations)
}

/// The record of a match of this surface with that of a subject, whose pose is open or not.
fn record(surface: &SurfaceMesh, is_open: bool) -> Record {
    let points = surface.vertices().iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect();
    let turns = [[1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let half = |turn: [f64; 3]| std::array::from_fn(|r| std::array::from_fn(|c| if r == c { turn[r] } else { 0.0 }));
    let quarter = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let open = || Facts {
        reliable: Some(false),
        reasons: vec!["ambiguous_pose".to_owned()],
        rivals: turns.into_iter().map(half).chain([quarter]).collect(),
        ..Facts::default()
    };
    Record { facts: if is_open { open() } else { Facts::default() }, points }
}

/// The same, with something besides.
pub(crate) fn made_with(
    extra: Extra,
    subjects: usize,
    levels: u32,
    contrasts: usize,
    covariates: usize,
    permutations: usize,
) -> Made {
    let has_surfaces = extra != Extra::None;
    let template = ellipsoid(Vector3::new(12.0, 6.0, 4.0), levels);
    let names: Vec<String> = (0..covariates).map(|k| format!("x{k}")).collect();
    let mut text =
        format!("id,file,subject,group{}\n", names.iter().map(|name| format!(",{name}")).collect::<String>());
    for k in 0..subjects {
        let row: String = (0..covariates).map(|c| format!(",{}", (k * (c + 3) * 7) % 101)).collect();
        let person = if extra == Extra::OwnTemplates { k / 2 } else { k };
        text.push_str(&format!("s{k},s{k}.ply,p{person},{}{row}\n", ["a", "b"][k % 2]));
    }
    let measures = vec![Measure::NormalDisplacement, Measure::LogArea];
    let size = StudySize {
        subjects: subjects as u64,
        vertices: template.n_vertices() as u64,
        faces: template.n_faces() as u64,
        cells: (subjects * (covariates + 1)) as u64,
        columns: 2,
        contrasts: contrasts as u64,
        measures: Some(measures.len() as u64),
        permutations: Some(permutations as u64),
        ring: 0,
        file_bytes: if has_surfaces { write_ply(&template).len() as u64 } else { 64 },
        has_volumes: false,
        joint: extra == Extra::Joint,
        own_templates: extra == Extra::OwnTemplates,
        rivals: extra == Extra::Rivals,
    };
    let analysis = Analysis {
        effect: Some("group".to_owned()),
        contrasts: (1..contrasts).map(|k| (format!("c{k}"), "group:b".to_owned())).collect(),
        measures,
        permutations,
        ..Analysis::default()
    };
    let settings = Settings {
        template: TemplateChoice::Given { file: "template.ply".into() },
        template_side: None,
        size: Size::Kept,
        correspondence: if extra == Extra::Joint { Correspondence::Joint } else { Correspondence::Pairs },
        visits: if extra == Extra::OwnTemplates { Visits::OwnTemplate } else { Visits::GroupTemplate },
        rivals: Rivals::default(),
        analysis,
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        // A rigid method has no rivals.
        parameters: preset(if extra == Extra::Rivals { Method::Balanced } else { Method::Rigid }),
    };
    let inputs = Files { template, has_surfaces };
    let cohort = || Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
    let (mut files, mut rivals) = (BTreeMap::<String, Vec<u8>>::new(), Vec::new());
    loop {
        let folder = Folder::in_memory(files.clone(), Box::new(inputs.clone()));
        let mut study = Study::open(cohort(), settings.clone(), &[], &folder, &Quiet).unwrap();
        let Step::Match { tasks, own, .. } = study.advance(&folder, &Quiet).unwrap() else { break };
        for task in tasks {
            let of_subject = |k: usize| surface(&inputs.template, k as f64);
            let onto = match (task.target, task.own) {
                (Some(k), _) => of_subject(k),
                (None, own_of) => own[own_of.unwrap()].mesh.clone(),
            };
            let is_open = extra == Extra::Rivals && task.target.is_some_and(|k| k >= subjects.div_ceil(2));
            // In another pose, the map is wrong.
            let mirrored = |p: &Point3<f64>| Point3::new(p.x, p.y, if task.rival.is_some() { -p.z } else { p.z });
            let onto = onto.with_vertices(onto.vertices().iter().map(mirrored).collect()).unwrap();
            rivals.extend(task.rival.map(|_| record_name(&task.key)));
            files.insert(record_name(&task.key), record(&onto, is_open).to_bytes());
        }
    }
    Made { size, files, rivals, table: text, settings, inputs }
}

impl Made {
    /// Plans matches, as the service does: from a folder with copies of the records that were read. Returns their surfaces.
    pub(crate) fn plan(&self) -> Vec<Template> {
        let Made { files, table, settings, inputs, .. } = self;
        let folder = Folder::in_memory(files.clone(), Box::new(inputs.clone()));
        let cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
        let mut study = Study::open(cohort, settings.clone(), &[], &folder, &Quiet).unwrap();
        let Step::Match { own, .. } = study.advance(&folder, &Quiet).unwrap() else { panic!("no match is missing") };
        own
    }

    /// Computes the last step, as the service does: from a folder with copies of the records that were read. Returns the archive.
    pub(crate) fn step(&self) -> Vec<u8> {
        let Made { files, table, settings, inputs, .. } = self;
        let folder = Folder::in_memory(files.clone(), Box::new(inputs.clone()));
        let cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
        let mut study = Study::open(cohort, settings.clone(), &[], &folder, &Quiet).unwrap();
        let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
        let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
        assert!(found.subjects.iter().filter(|subject| subject.group.is_some()).count() == matched.rivals.len());
        write(&study, &found, &[], &folder, "test", &Quiet).unwrap();
        drop(found);
        let files: Vec<(String, Vec<u8>)> = folder.into_files().into_iter().collect();
        write_zip(&files).unwrap()
    }
}
