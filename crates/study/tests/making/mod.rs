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
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

struct Quiet;
impl StudyObserver for Quiet {}

/// Files of the template and of the subjects. Only joint maps read those of subjects: surfaces with the faces of the template.
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
        Ok(blake3::hash(file.to_string_lossy().as_bytes()).to_hex().to_string())
    }
}

/// A study whose matches have been made.
pub(crate) struct Made {
    /// Its size.
    pub size: StudySize,
    /// Records of its matches.
    pub files: BTreeMap<String, Vec<u8>>,
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
    made_with(Correspondence::Pairs, subjects, levels, contrasts, covariates, permutations)
}

/// The same, with these maps.
pub(crate) fn made_with(
    correspondence: Correspondence,
    subjects: usize,
    levels: u32,
    contrasts: usize,
    covariates: usize,
    permutations: usize,
) -> Made {
    let joint = correspondence == Correspondence::Joint;
    let template = ellipsoid(Vector3::new(12.0, 6.0, 4.0), levels);
    let names: Vec<String> = (0..covariates).map(|k| format!("x{k}")).collect();
    let mut text = format!("id,file,group{}\n", names.iter().map(|name| format!(",{name}")).collect::<String>());
    for k in 0..subjects {
        let row: String = (0..covariates).map(|c| format!(",{}", (k * (c + 3) * 7) % 101)).collect();
        text.push_str(&format!("s{k},s{k}.ply,{}{row}\n", ["a", "b"][k % 2]));
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
        file_bytes: if joint { write_ply(&template).len() as u64 } else { 64 },
        has_volumes: false,
        joint,
        own_templates: false,
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
        correspondence,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis,
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let inputs = Files { template, has_surfaces: joint };
    let cohort = || Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let folder = Folder::in_memory(files.clone(), Box::new(inputs.clone()));
    let mut study = Study::open(cohort(), settings.clone(), &[], &folder, &Quiet).unwrap();
    let Step::Match { tasks, template: found, .. } = study.advance(&folder, &Quiet).unwrap() else {
        panic!("no matches")
    };
    for task in tasks {
        let moved = surface(&found.mesh, task.target.unwrap() as f64);
        let points = moved.vertices().iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect();
        files.insert(record_name(&task.key), Record { facts: Facts::default(), points }.to_bytes());
    }
    drop((study, folder, found));
    Made { size, files, table: text, settings, inputs }
}

impl Made {
    /// Computes the last step, as the service does: from a folder with copies of the records that were read. Returns the archive.
    pub(crate) fn step(&self) -> Vec<u8> {
        let Made { files, table, settings, inputs, .. } = self;
        let folder = Folder::in_memory(files.clone(), Box::new(inputs.clone()));
        let cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
        let mut study = Study::open(cohort, settings.clone(), &[], &folder, &Quiet).unwrap();
        let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
        let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
        write(&study, &found, &[], &folder, "test", &Quiet).unwrap();
        drop(found);
        let files: Vec<(String, Vec<u8>)> = folder.into_files().into_iter().collect();
        write_zip(&files).unwrap()
    }
}
