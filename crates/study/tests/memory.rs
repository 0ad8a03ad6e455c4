//! What a step of a study is predicted to take, beside what an allocator counts, at the ends of every size.
#![allow(clippy::unwrap_used, clippy::panic)]
#![allow(unsafe_code, reason = "an allocator that counts can only be written so")]

#[path = "../../../tests/counting/mod.rs"]
mod counting;

use counting::{HELD, MOST};
use homolog_contract::parameters::{Method, preset};
use homolog_contract::study::StudySize;
use homolog_formats::ply::write_ply;
use homolog_formats::write_zip;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::Watcher;
use homolog_study::memory::step_bytes;
use homolog_study::output::write;
use homolog_study::place::Inputs;
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Measure, Settings, Size, TemplateChoice};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::atomic::Ordering;

struct Quiet;
impl Watcher for Quiet {}

/// Files of subjects, which statistics do not read; the template is one.
#[derive(Debug)]
struct Files(Vec<u8>);

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        Ok(if file.ends_with("template.ply") { self.0.clone() } else { b"no volume".to_vec() })
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(file.to_string_lossy().as_bytes()).to_hex().to_string())
    }
}

const THREADS: usize = 2;

/// A study and what its step takes at most, by the estimate and by the allocator, bytes.
fn step(subjects: usize, levels: u32, contrasts: usize, covariates: usize, permutations: usize) -> (u64, u64) {
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
        file_bytes: 64,
        has_volumes: false,
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
        analysis,
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let inputs = || Box::new(Files(write_ply(&template)));
    let cohort = || Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
    // As the service does: the records that were read, and a folder with copies of them.
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let folder = Folder::in_memory(files.clone(), inputs());
    let mut study = Study::open(cohort(), settings.clone(), &[], &folder, &Quiet).unwrap();
    let Step::Match { tasks, template: found, .. } = study.advance(&folder, &Quiet).unwrap() else {
        panic!("no matches")
    };
    for task in tasks {
        let k = task.target.unwrap() as f64;
        let ripple = |p: &Point3<f64>| {
            [p.x * (1.0 + 0.01 * (k * 0.7).sin()), p.y, p.z + 0.1 * (p.x + k).sin()].map(|x| x as f32)
        };
        let points = found.mesh.vertices().iter().map(ripple).collect();
        files.insert(record_name(&task.key), Record { facts: Facts::default(), points }.to_bytes());
    }
    drop((study, folder, found));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().unwrap();
    let records: usize = files.values().map(Vec::len).sum();
    let before = HELD.load(Ordering::Relaxed) - records;
    MOST.store(HELD.load(Ordering::Relaxed), Ordering::Relaxed);
    let archive = pool.install(|| {
        let folder = Folder::in_memory(files.clone(), inputs());
        let mut study = Study::open(cohort(), settings, &[], &folder, &Quiet).unwrap();
        let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
        let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
        write(&study, &found, &[], &folder, "test", &Quiet).unwrap();
        drop(found);
        let files: Vec<(String, Vec<u8>)> = folder.into_files().into_iter().collect();
        write_zip(&files).unwrap()
    });
    let most = MOST.load(Ordering::Relaxed) - before;
    drop(archive);
    (step_bytes(&size, THREADS), most as u64)
}

#[test]
fn no_step_of_a_study_takes_more_than_it_is_predicted_to() {
    let mut lines = Vec::new();
    let mut is_fine = true;
    for (subjects, levels, contrasts, covariates, permutations) in [
        (4, 1, 1, 0, 1),
        (5, 6, 1, 0, 2),
        (12, 5, 1, 0, 70),
        (6, 4, 20, 0, 2),
        (6, 1, 40, 0, 10),
        (5, 1, 1, 0, 200_000),
        (150, 4, 1, 0, 2),
        (400, 1, 1, 60, 20),
        (60, 3, 8, 10, 64),
    ] {
        let (predicted, counted) = step(subjects, levels, contrasts, covariates, permutations);
        let share = predicted as f64 / counted as f64;
        is_fine &= share >= 1.0;
        // Where arrays decide, and not what is said of each subject, the estimate is not far too high either.
        is_fine &= share <= 4.0 || predicted < 64 << 20;
        lines.push(format!(
            "{subjects} subjects, level {levels}, {contrasts} contrasts, {covariates} covariates: predicted {predicted}, \
             counted {counted}, {share:.2}"
        ));
    }
    assert!(is_fine, "\n{}", lines.join("\n"));
}
