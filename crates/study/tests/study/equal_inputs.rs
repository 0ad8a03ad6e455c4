//! Subjects whose files are equal share a match: it is planned, counted and computed once.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::cohort::Cohort;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, MadeTemplate, Rivals, Settings, Size, TemplateChoice, Visits};
use nalgebra::Vector3;
use std::collections::HashSet;

/// Asks for nothing.
struct Quiet;

impl StudyObserver for Quiet {
    fn is_interrupted(&self) -> bool {
        false
    }
}

/// Nine subjects with the files of five.
fn study(place: &std::path::Path, template: TemplateChoice) -> (Study, Folder) {
    let mut text = "id,file,group\n".to_owned();
    for k in 0..9 {
        let size = 8.0 + f64::from(k % 5);
        std::fs::write(place.join(format!("s{k}.ply")), write_ply(&ellipsoid(Vector3::new(size, 6.0, 4.0), 2)))
            .unwrap();
        text.push_str(&format!("s{k},s{k}.ply,{}\n", ["a", "b"][k as usize % 2]));
    }
    std::fs::write(place.join("template.ply"), write_ply(&ellipsoid(Vector3::new(9.5, 6.0, 4.0), 2))).unwrap();
    let settings = Settings {
        template,
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis { effect: Some("group".to_owned()), ..Analysis::default() },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let folder = Folder::create(&place.join("out")).unwrap();
    let cohort = Cohort::from_csv(text.as_bytes(), place).unwrap();
    (Study::open(cohort, settings, &[], &folder, &Quiet).unwrap(), folder)
}

#[test]
fn equal_files_are_matched_once_and_every_subject_has_the_match() {
    let place = tempfile::tempdir().unwrap();
    let (mut study, folder) = study(place.path(), TemplateChoice::Given { file: place.path().join("template.ply") });
    let Step::Match { tasks, template, finished, .. } = study.advance(&folder, &Quiet).unwrap() else {
        panic!("matches are missing")
    };
    let keys: HashSet<&str> = tasks.iter().map(|task| task.key.as_str()).collect();
    assert_eq!((tasks.len(), keys.len(), finished), (5, 5, 0));
    let points: Vec<[f32; 3]> = template.mesh.vertices().iter().map(|p| [p.x, p.y, p.z].map(|c| c as f32)).collect();
    for task in &tasks[..4] {
        folder.keep(&task.key, &Record { facts: Facts::default(), points: points.clone() }).unwrap();
    }
    let Step::Match { tasks: left, finished, .. } = study.advance(&folder, &Quiet).unwrap() else {
        panic!("one is missing")
    };
    assert_eq!((left.len(), finished), (1, 4));
    folder.keep(&left[0].key, &Record { facts: Facts::default(), points }).unwrap();
    let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("all are there") };
    assert_eq!(matched.keys.len(), 9);
    assert!((0..9).all(|k| matched.keys[k] == matched.keys[k % 5]), "{:?}", matched.keys);
}

#[test]
fn a_template_is_made_from_each_file_once() {
    let place = tempfile::tempdir().unwrap();
    let (mut study, folder) = study(place.path(), TemplateChoice::Made(MadeTemplate::default()));
    let Step::Match { tasks, .. } = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
    let keys: HashSet<&str> = tasks.iter().map(|task| task.key.as_str()).collect();
    assert_eq!(tasks.len(), keys.len());
}
