//! Left against right within 60 persons with a known effect: what a study of asymmetry finds, and what its report says.

use crate::population::{Population, WIDTH_MM, bump, template};
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::output::write;
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

const PEOPLE: usize = 60;
/// Vertex at which the right side is thinner, and by how much, mm.
const PLACE: usize = 100;
const DEPTH_MM: f64 = 0.15;

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

/// Both sides of everybody, as mirrored onto the left: they share most of their shape, and differ by a tenth of the variance.
fn sides(seed: u64, depth_mm: f64) -> Vec<Vec<[f32; 3]>> {
    let mut population = Population::new(seed);
    let dent = bump(&population.mesh, PLACE);
    let mut shapes = Vec::new();
    for _ in 0..PEOPLE {
        let person = population.weights();
        for depth in [0.0, depth_mm] {
            let own = population.weights();
            let weights: Vec<f64> =
                person.iter().zip(&own).map(|(a, b)| 0.9f64.sqrt() * a + 0.1f64.sqrt() * b).collect();
            shapes.push(population.shape_of(&weights, &|v| -depth * dent[v]));
        }
    }
    shapes
}

/// A study of asymmetry of these shapes, and its report if it is `shown`; unless `within`, the rows are taken as persons.
fn studied(shapes: &[Vec<[f32; 3]>], permutations: usize, within: bool, shown: bool) -> (Findings, String) {
    let mut table = "id,file,subject,side,age\n".to_owned();
    for k in 0..shapes.len() {
        let person = if within { k / 2 } else { k };
        table.push_str(&format!("s{k},s{k}.ply,p{person},{},{}\n", ["left", "right"][k % 2], 60 + (k / 2) % 20));
    }
    let settings = Settings {
        template: TemplateChoice::Given { file: "template.ply".into() },
        template_side: Some(homolog_contract::input::BodySide::Left),
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis {
            effect: Some("side".to_owned()),
            adjust: vec!["age".to_owned()],
            measures: vec![Measure::NormalDisplacement],
            permutations,
            ..Analysis::default()
        },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let open = |files: &BTreeMap<String, Vec<u8>>| {
        let folder = Folder::in_memory(files.clone(), Box::new(Files));
        let cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
        (Study::open(cohort, settings.clone(), &[], &folder, &Quiet).unwrap(), folder)
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
    let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
    if !shown {
        return (found, String::new());
    }
    write(&study, &found, &[], &folder, "none", &Quiet).unwrap();
    let page = String::from_utf8(folder.read("report.html").unwrap().unwrap()).unwrap();
    (found, page)
}

#[test]
fn a_known_asymmetry_is_found_within_persons_and_not_between_them() {
    let (mesh, dent) = (template(), bump(&template(), PLACE));
    let (found, page) = studied(&sides(1, DEPTH_MM), 1000, true, true);
    let statistics = found.statistics.as_ref().unwrap();
    assert_eq!(statistics.pairs.as_ref().unwrap().pairs.len(), PEOPLE);
    assert_eq!((statistics.degrees, statistics.longitudinal), (59.0, false));
    let (linear, permuted) = statistics.maps[0].linear.as_ref().unwrap();
    assert!(permuted.p_tfce[PLACE] <= 0.002, "{}", permuted.p_tfce[PLACE]);
    let (effect, error) = (linear.effect[PLACE], linear.robust_se[PLACE]);
    assert!((effect + DEPTH_MM).abs() < 3.0 * error + 0.1 * DEPTH_MM, "{effect} ± {error}");
    let place = mesh.vertices()[PLACE];
    let far = |v: &usize| (mesh.vertices()[*v] - place).norm() > 4.0 * WIDTH_MM;
    let beside = (0..dent.len()).filter(far).filter(|&v| permuted.p_fwe[v] <= 0.05).count();
    assert_eq!(beside, 0);
    // Volumes of both sides are compared within persons too.
    assert!(statistics.whole.iter().all(|of| of.effect.value.is_finite()) && !statistics.whole.is_empty());
    assert!(page.contains("Differences within 60 subjects were tested against zero (0 without a pair)"));
    assert!(page.contains("1000 sign flips of these differences") && page.contains("<p>120 surfaces of 60 subjects, "));
    // The same surfaces as if of 120 persons: their differences hide an effect of half a standard deviation.
    let (between, _) = studied(&sides(1, DEPTH_MM), 1000, false, false);
    let (apart, _) = between.statistics.as_ref().unwrap().maps[0].linear.as_ref().unwrap();
    assert!(apart.robust_se[PLACE] > 2.0 * error, "{} {error}", apart.robust_se[PLACE]);
}

#[test]
fn without_an_asymmetry_corrected_p_values_are_rarely_small() {
    let tries = 30;
    let any = (0..tries).filter(|&seed| {
        let (found, _) = studied(&sides(100 + seed, 0.0), 60, true, false);
        let permuted = &found.statistics.as_ref().unwrap().maps[0].linear.as_ref().unwrap().1;
        permuted.p_fwe.iter().any(|&p| p <= 0.05)
    });
    // Expected 1.5; 7 or more in one case of a thousand.
    assert!(any.count() <= 6);
}

#[test]
fn beside_a_strong_effect_few_vertices_are_significant() {
    let (mesh, tries) = (template(), 6);
    let place = mesh.vertices()[PLACE];
    let far = |v: usize| (mesh.vertices()[v] - place).norm() > 4.0 * WIDTH_MM;
    let (mut by_clusters, mut significant) = (0.0, 0.0);
    for seed in 0..tries {
        let (found, _) = studied(&sides(200 + seed, 4.0 * DEPTH_MM), 200, true, false);
        let map = &found.statistics.as_ref().unwrap().maps[0];
        let falsely = |p: &[f64]| {
            let claimed: Vec<usize> = (0..p.len()).filter(|&v| p[v] <= 0.05).collect();
            claimed.iter().filter(|&&v| far(v)).count() as f64 / claimed.len().max(1) as f64
        };
        let local = map.p_local();
        assert!(local[PLACE] <= 0.01, "{}", local[PLACE]);
        by_clusters += falsely(map.p_corrected());
        significant += falsely(&local);
    }
    assert!(significant <= 0.05 * tries as f64 && significant < by_clusters, "{significant} {by_clusters}");
}
