//! A study that is told to stop stops soon, wherever it is, and keeps what is finished.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Matched, Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use nalgebra::{Point3, Vector3};
use std::path::Path;
use std::time::{Duration, Instant};

/// Asks to stop at a time.
struct Until(Instant);

impl StudyObserver for Until {
    fn is_interrupted(&self) -> bool {
        Instant::now() >= self.0
    }
}

fn never() -> Until {
    Until(Instant::now() + Duration::from_secs(3600))
}

/// A shape of its own for each subject.
fn shape(template: &SurfaceMesh, k: usize) -> Vec<[f32; 3]> {
    let (long, bend) = ((k * 7 % 5) as f64 / 5.0, (k * 3 % 7) as f64 / 7.0);
    let moved = |p: &Point3<f64>| {
        let ripple = 0.1 * (p.x * (1.0 + 0.1 * k as f64)).sin();
        [p.x * (1.0 + 0.1 * long), p.y + 0.01 * bend * p.x * p.x, p.z + ripple].map(|x| x as f32)
    };
    template.vertices().iter().map(moved).collect()
}

/// A study all of whose matches are there, so large that its statistics take minutes: 10,242 vertices, 12 subjects.
fn matched(place: &Path, longitudinal: bool, analysis: Analysis) -> (Study, Matched, Folder) {
    let template = ellipsoid(Vector3::new(12.0, 6.0, 4.0), 5);
    std::fs::write(place.join("template.ply"), write_ply(&template)).unwrap();
    let mut text = "id,file,subject,group,age\n".to_owned();
    for k in 0..12 {
        std::fs::write(place.join(format!("s{k}.ply")), format!("file {k}")).unwrap();
        let person = if longitudinal { k / 2 } else { k };
        text.push_str(&format!("s{k},s{k}.ply,p{person},{},{}\n", ["a", "b"][k / 2 % 2], 60 + k * 5 % 11));
    }
    let settings = Settings {
        template: TemplateChoice::Given { file: place.join("template.ply") },
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis { effect: Some("group".to_owned()), adjust: vec!["age".to_owned()], ..analysis },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let folder = Folder::create(&place.join("out")).unwrap();
    let cohort = Cohort::from_csv(text.as_bytes(), place).unwrap();
    let mut study = Study::open(cohort, settings, &[], &folder, &never()).unwrap();
    let Step::Match { tasks, template, .. } = study.advance(&folder, &never()).unwrap() else { panic!("no matches") };
    for task in tasks {
        let record = Record { facts: Facts::default(), points: shape(&template.mesh, task.target.unwrap()) };
        folder.keep(&task.key, &record).unwrap();
    }
    let Step::Matched(matched) = study.advance(&folder, &never()).unwrap() else { panic!("matches are missing") };
    (study, *matched, folder)
}

/// Stopped at several times, a study takes less time in all to stop than it was given before; to its end it would take minutes.
fn stops_soon(longitudinal: bool, analysis: &Analysis) {
    let place = tempfile::tempdir().unwrap();
    let (study, matched, folder) = matched(place.path(), longitudinal, analysis.clone());
    let (mut given, mut late) = (Duration::ZERO, Duration::ZERO);
    for after_ms in [0, 500, 1000, 2000, 4000] {
        let stop = Instant::now() + Duration::from_millis(after_ms);
        let found = find(&study, &matched, &folder, &[], &Until(stop));
        (given, late) = (given + Duration::from_millis(after_ms), late + stop.elapsed());
        assert!(matches!(found, Err(StudyError::Interrupted)), "after {after_ms} ms: {:?}", found.err());
    }
    assert!(late < given, "stopped {late:?} after it was asked to, of {given:?}");
}

#[test]
fn permutations_of_a_study_are_cancelled_soon() {
    let measures = vec![Measure::NormalDisplacement, Measure::LogArea];
    stops_soon(false, &Analysis { measures, permutations: 1_000_000, ..Analysis::default() });
}

#[test]
fn mixed_models_of_a_study_are_cancelled_soon() {
    // A fit takes a hundred of a few microseconds; each contrast has one at every vertex.
    let names = (0..60).map(|k| (format!("c{k}"), "group:b".to_owned())).collect();
    stops_soon(true, &Analysis { contrasts: names, ..Analysis::default() });
}

#[test]
fn thickness_of_a_study_is_cancelled_soon() {
    let measures = vec![Measure::Thickness; 40];
    stops_soon(false, &Analysis { measures, permutations: 1, ..Analysis::default() });
}
