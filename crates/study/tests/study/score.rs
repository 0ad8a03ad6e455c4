//! A new subject against synthetic Gaussian groups: its p-values are uniform if it comes from the group's population, and
//! a planted bump is found where it is, and nothing elsewhere.

use crate::population::{DEVIATION_MM, Population, WIDTH_MM, bump, template};
use homolog_contract::input::BodySide;
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::score::{NewSubject, Reference, Subgroup, SubjectScore, add, score};
use homolog_study::settings::{Analysis, Correspondence, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use nalgebra::Point3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

/// Vertex at which the bump is planted.
const PLACE: usize = 100;

struct Quiet;
impl StudyObserver for Quiet {}

#[derive(Debug)]
struct Files;

impl Inputs for Files {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Ok(write_ply(&template()))
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(file.to_string_lossy().as_bytes()).to_hex().to_string())
    }
}

fn settings() -> Settings {
    Settings {
        template: TemplateChoice::Given { file: "template.ply".into() },
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis::default(),
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    }
}

fn new_subject() -> NewSubject {
    NewSubject { file: "new.ply".into(), side: None, labels: None }
}

/// The score of the last of these shapes against the others; the first half of the group is called `a`, the other `b`.
fn scored(shapes: &[Vec<[f32; 3]>], within: Option<&Subgroup>) -> Result<SubjectScore, StudyError> {
    let n = shapes.len() - 1;
    let rows: String = (0..n).map(|k| format!("s{k},s{k}.ply,{},{k}\n", if 2 * k < n { "a" } else { "b" })).collect();
    let reference = Reference { within: within.cloned(), ..Reference::default() };
    compared(shapes, &format!("id,file,group,age\n{rows}"), &reference)
}

/// The score of the last of these shapes against the others, whose table is given.
pub(crate) fn compared(
    shapes: &[Vec<[f32; 3]>],
    table: &str,
    reference: &Reference,
) -> Result<SubjectScore, StudyError> {
    let mut cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
    let mut settings = settings();
    let k = add(&mut cohort, &mut settings, new_subject()).unwrap();
    let open = |files: &BTreeMap<String, Vec<u8>>| {
        let folder = Folder::in_memory(files.clone(), Box::new(Files));
        (Study::open(cohort.clone(), settings.clone(), &[], &folder, &Quiet).unwrap(), folder)
    };
    let (mut files, (mut study, folder)) = (BTreeMap::new(), open(&BTreeMap::new()));
    if let Step::Match { tasks, .. } = study.advance(&folder, &Quiet).unwrap() {
        for task in tasks {
            let record = Record { facts: Facts::default(), points: shapes[task.target.unwrap()].clone() };
            files.insert(record_name(&task.key), record.to_bytes());
        }
    }
    let (mut study, folder) = open(&files);
    let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
    score(&study, &matched, &folder, &[], (k, reference), &Quiet)
}

fn drawn(n: usize, seed: u64, further: &dyn Fn(usize) -> f64) -> Vec<Vec<[f32; 3]>> {
    let mut population = Population::new(seed);
    let mut shapes: Vec<_> = (0..n).map(|_| population.shape(&|_| 0.0)).collect();
    shapes.push(population.shape(further));
    shapes
}

/// The largest difference between the distribution of numbers and the uniform one.
pub(crate) fn from_uniform(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let n = numbers.len() as f64;
    numbers.iter().enumerate().map(|(k, p)| (p - (k as f64 + 0.5) / n).abs()).fold(0.0, f64::max)
}

#[test]
fn p_values_of_a_subject_of_the_population_are_uniform() {
    for (n, tries) in [(8, 300), (20, 200), (60, 120)] {
        let found: Vec<SubjectScore> =
            (0..tries).into_par_iter().map(|seed| scored(&drawn(n, seed, &|_| 0.0), None).unwrap()).collect();
        // Ranks of n + 1 subjects are steps of 1 / (n + 1), and 1.63 / √tries is exceeded in one case of a hundred.
        let most = 1.0 / (n as f64 + 1.0) + 1.63 / (tries as f64).sqrt();
        let of = |p: fn(&SubjectScore) -> f64| from_uniform(found.iter().map(p).collect());
        let (unusual, largest) = (of(|s| s.summary.unusual_p), of(|s| s.summary.largest_score_p));
        assert!(unusual < most, "{n}: {unusual} {most}");
        assert!(largest < most, "{n}: {largest} {most}");
        let rms = found.iter().map(|s| s.summary.calibration.rms).sum::<f64>() / tries as f64;
        assert!((rms - 1.0).abs() < 0.05, "{n}: {rms}");
        let above = found.iter().filter(|s| !s.summary.regions.is_empty()).count() as f64 / tries as f64;
        assert!(above < 0.05 + 3.0 * (0.05 * 0.95 / tries as f64).sqrt(), "{n}: {above}");
    }
}

#[test]
fn a_bump_of_six_deviations_is_found_at_its_place_and_nothing_elsewhere() {
    let mesh = template();
    let (height, place) = (bump(&mesh, PLACE), mesh.vertices()[PLACE]);
    let near = |v: usize| (mesh.vertices()[v] - place).norm() < 3.0 * WIDTH_MM;
    for n in [8, 20, 60] {
        let tries = 100;
        let outcomes: Vec<(bool, bool)> = (0..tries)
            .into_par_iter()
            .map(|seed| {
                let further = |v: usize| 6.0 * DEVIATION_MM * height[v];
                let found = scored(&drawn(n, 5000 + seed, &further), None).unwrap();
                let bound = found.summary.bound.score;
                let is_found =
                    found.summary.regions.first().is_some_and(|region| region.score > 0.0 && near(region.peak));
                let elsewhere = (0..mesh.n_vertices()).any(|v| !near(v) && found.scores[v].abs() > bound);
                (is_found, elsewhere)
            })
            .collect();
        let found = outcomes.iter().filter(|of| of.0).count();
        let elsewhere = outcomes.iter().filter(|of| of.1).count();
        println!("n = {n}: found in {found} of {tries}, something elsewhere in {elsewhere}");
        assert!(100 * found >= 95 * tries as usize, "{n}: {found}");
        // Two standard errors above the level of the bound.
        assert!(elsewhere <= 9, "{n}: {elsewhere}");
    }
}

#[test]
fn the_group_may_be_a_level_of_a_covariate() {
    let shapes = drawn(12, 3, &|_| 0.0);
    let within = |covariate: &str, level: &str| Subgroup { covariate: covariate.into(), level: level.into() };
    let part = scored(&shapes, Some(&within("group", "b"))).unwrap();
    assert_eq!(part.summary.members, 6);
    let mut others: Vec<_> = shapes[6..].to_vec();
    let alone = scored(&std::mem::take(&mut others), None).unwrap();
    assert!(part.scores.iter().zip(&alone.scores).all(|(a, b)| (a - b).abs() < 1e-6));
    assert_eq!(part.summary.unusual_p, alone.summary.unusual_p);
    for (covariate, level) in [("group", "c"), ("age", "3"), ("sex", "f")] {
        let refused = scored(&shapes, Some(&within(covariate, level)));
        assert!(matches!(refused, Err(StudyError::Settings(_))), "{covariate}");
    }
    let few = scored(&drawn(3, 1, &|_| 0.0), None);
    assert!(matches!(few, Err(StudyError::TooFewMatches { matched: 3, .. })));
}

#[test]
fn the_surface_is_in_the_coordinates_of_the_subject() {
    let shapes = drawn(10, 4, &|_| 0.0);
    let found = scored(&shapes, None).unwrap();
    let own = |p: &[f32; 3]| Point3::from(p.map(f64::from));
    assert!(found.surface.vertices().iter().zip(&shapes[10]).all(|(p, q)| *p == own(q)));
    let of_table = "id,file,side\na,a.ply,left\nb,b.ply,right\nc,c.ply,left\n";
    let mut sided = Cohort::from_csv(of_table.as_bytes(), Path::new("")).unwrap();
    let mut left = Settings { template_side: Some(BodySide::Left), ..settings() };
    assert!(add(&mut sided, &mut left, new_subject()).is_err(), "without a side");
    let right = NewSubject { side: Some(BodySide::Right), ..new_subject() };
    assert_eq!(add(&mut sided, &mut left, right.clone()).unwrap(), 3);
    let mut plain = Cohort::from_csv(b"id,file\na,a.ply\nb,b.ply\nc,c.ply\n", Path::new("")).unwrap();
    assert!(add(&mut plain, &mut settings(), right).is_err(), "a study without sides");
}
