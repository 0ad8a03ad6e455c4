//! Persons with three visits whose structure thins by a known amount in a patch: with a template of each person's own, changes
//! within a person have a fraction of the noise, and the thinning is neither lost nor added to, whatever the order of visits.
//!
//! Matches are made up. Between different anatomies they slide by a millimeter along the surface, anew in each match; between
//! surfaces of one anatomy by a tenth of that.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::measures::measured;
use homolog_study::plan::{Purpose, Records, Step, Study, Task, Template};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use nalgebra::{Point3, Rotation3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::LazyLock;

const AXES: [f64; 3] = [12.0, 6.0, 4.0];
const VISITS: usize = 3;
/// Thinning from each visit to the next in the middle of the patch, mm, and width of the patch, mm.
const THINNING_MM: f64 = 0.25;
const WIDTH_MM: f64 = 2.5;
/// Vertex of the template in the middle of the patch.
const PLACE: usize = 100;
/// Slides of matches of different anatomies, and of one anatomy, mm.
const BETWEEN_MM: f64 = 0.7;
const WITHIN_MM: f64 = 0.07;

struct Quiet;
impl StudyObserver for Quiet {}

/// Repeatable numbers between -1 and 1.
fn number(of: u64, which: u64) -> f64 {
    let bytes = *blake3::hash(format!("{of} {which}").as_bytes()).as_bytes();
    let [a, b, c, d, ..] = bytes;
    2.0 * f64::from(u32::from_le_bytes([a, b, c, d])) / f64::from(u32::MAX) - 1.0
}

fn on_ellipsoid(p: &Point3<f64>) -> Point3<f64> {
    let [a, b, c] = AXES;
    p / Vector3::new(p.x / a, p.y / b, p.z / c).norm()
}

fn normal(p: &Point3<f64>) -> Vector3<f64> {
    let [a, b, c] = AXES;
    Vector3::new(p.x / (a * a), p.y / (b * b), p.z / (c * c)).normalize()
}

fn height(p: &Point3<f64>, center: &Point3<f64>) -> f64 {
    (-(p - center).norm_squared() / (2.0 * WIDTH_MM * WIDTH_MM)).exp()
}

/// The template, and the places of bumps in which persons differ.
static TEMPLATE: LazyLock<SurfaceMesh> = LazyLock::new(|| ellipsoid(Vector3::from(AXES), 3));
static BUMPS: LazyLock<SurfaceMesh> = LazyLock::new(|| ellipsoid(Vector3::from(AXES), 1));

/// The vertices of every file, as points of the ellipsoid: not those of the template, and dense beside the patch.
fn sampling() -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::from(AXES), 4);
    let turned = Rotation3::from_euler_angles(0.3, 0.2, 0.1);
    let at = |p: &Point3<f64>| on_ellipsoid(&(turned * p));
    mesh.with_vertices(mesh.vertices().iter().map(at).collect()).unwrap()
}

/// Where the point `p` of the ellipsoid is in a visit: moved along the normal as in this person, thinned, turned and shifted.
fn truth([person, visit]: [usize; 2], p: &Point3<f64>) -> Point3<f64> {
    let of = person as u64;
    let anatomy = BUMPS.vertices().iter().zip(0..).map(|(c, k)| 0.5 * number(of, k) * height(p, c)).sum::<f64>();
    let patch = height(p, &TEMPLATE.vertices()[PLACE]);
    let shape = p + (anatomy - THINNING_MM * visit as f64 * patch) * normal(p);
    let pose = |which: u64| number(1000 + (VISITS * person + visit) as u64, which);
    Rotation3::from_euler_angles(0.3 * pose(0), 0.2 * pose(1), 0.4 * pose(2)) * shape
        + 9.0 * Vector3::new(pose(3), pose(4), pose(5))
}

/// A point of the ellipsoid slid along it by a smooth field, which `seed` names.
fn slid(p: &Point3<f64>, size_mm: f64, seed: u64) -> Point3<f64> {
    let slide = |axis: u64| {
        let [a, b, c] = [0, 1, 2].map(|which| number(seed, 10 + 3 * axis + which));
        size_mm * ((0.25 * p.x + 3.0 * a).sin() + (0.4 * p.y + 3.0 * b).cos() * c)
    };
    on_ellipsoid(&(p + Vector3::new(slide(0), slide(1), slide(2))))
}

fn surface(of: [usize; 2]) -> SurfaceMesh {
    let mesh = sampling();
    mesh.with_vertices(mesh.vertices().iter().map(|p| truth(of, p)).collect()).unwrap()
}

#[derive(Debug)]
struct Files;

/// Person and visit of a file or an id, such as p4-2.
fn of_name(name: &str) -> [usize; 2] {
    let (person, visit) = name.split_once('-').unwrap();
    [person[1..].parse().unwrap(), visit.parse().unwrap()]
}

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap();
        Ok(if name == "template" { write_ply(&TEMPLATE) } else { write_ply(&surface(of_name(name))) })
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(&self.read(file)?).to_hex().to_string())
    }
}

/// A study of this many persons, and what its matches are like.
#[derive(Clone, Copy)]
struct Made {
    persons: usize,
    visits: Visits,
    correspondence: Correspondence,
    /// Slides of matches of different anatomies, and of one.
    between_mm: f64,
    within_mm: f64,
    /// Whether matches of the template slide alike in all visits of a person.
    is_shared: bool,
    is_reversed: bool,
}

impl Made {
    fn of(persons: usize, visits: Visits) -> Self {
        let correspondence = Correspondence::Pairs;
        let (between_mm, within_mm) = (BETWEEN_MM, WITHIN_MM);
        Made { persons, visits, correspondence, between_mm, within_mm, is_shared: false, is_reversed: false }
    }

    fn table(&self) -> String {
        let row = |k: usize| format!("p{0}-{1},p{0}-{1}.ply,p{0},{1}\n", k / VISITS, k % VISITS);
        let mut rows: Vec<String> = (0..VISITS * self.persons).map(row).collect();
        if self.is_reversed {
            rows.reverse();
        }
        format!("id,file,subject,visit\n{}", rows.concat())
    }

    fn open(&self, folder: &Folder) -> Study {
        let settings = Settings {
            template: TemplateChoice::Given { file: "template.ply".into() },
            template_side: None,
            size: Size::Kept,
            correspondence: self.correspondence,
            visits: self.visits,
            rivals: Rivals::Decide,
            analysis: Analysis::default(),
            cycle_subjects: 0,
            cycle_ring: Vec::new(),
            parameters: preset(Method::Rigid),
        };
        let cohort = Cohort::from_csv(self.table().as_bytes(), Path::new("")).unwrap();
        Study::open(cohort, settings, &[], folder, &Quiet).unwrap()
    }

    /// The record of a match, with a slide that its key names, or its person.
    fn record(&self, study: &Study, task: &Task, own: &[Template]) -> Record {
        let seed = u64::from_str_radix(&task.key[..12], 16).unwrap();
        let of = |row: usize| of_name(&study.cohort.subjects[row].id);
        let of_person = |row: usize| 5000 + of(row)[0] as u64;
        let base = sampling();
        let points: Vec<Point3<f64>> = match (task.source, task.target, task.own) {
            (Some(_), Some(visit), None) | (None, Some(visit), Some(_)) => {
                base.vertices().iter().map(|p| truth(of(visit), &slid(p, self.within_mm, seed))).collect()
            }
            (None, Some(visit), None) => {
                let seed = if self.is_shared { of_person(visit) } else { seed };
                TEMPLATE.vertices().iter().map(|p| truth(of(visit), &slid(p, self.between_mm, seed))).collect()
            }
            (None, None, Some(k)) => {
                let seed = study.persons.get(k).map_or(seed, |person| of_person(person.start));
                let (index, to) = (ClosestPointIndex::new(&base), own[k].mesh.vertices());
                let at = |p: &Point3<f64>| {
                    Point3::from(index.closest(&slid(p, self.between_mm, seed)).blend(|v| to[v].coords))
                };
                TEMPLATE.vertices().iter().map(at).collect()
            }
            other => panic!("{other:?}"),
        };
        let points = points.iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect();
        Record { facts: Facts { reliable: Some(true), ..Facts::default() }, points }
    }

    /// All matches; the study is closed and opened again after each `at_a_time` of them. Returns the files of the folder, and
    /// the purposes of the steps.
    fn matches(&self, at_a_time: usize) -> (BTreeMap<String, Vec<u8>>, Vec<Purpose>) {
        let (mut files, mut purposes) = (BTreeMap::new(), Vec::new());
        loop {
            let folder = Folder::in_memory(files, Box::new(Files));
            let mut study = self.open(&folder);
            let Step::Match { purpose, tasks, own, .. } = study.advance(&folder, &Quiet).unwrap() else {
                return (folder.into_files(), purposes);
            };
            purposes.push(purpose);
            for task in tasks.iter().take(at_a_time) {
                folder.keep(&task.key, &self.record(&study, task, &own)).unwrap();
            }
            files = folder.into_files();
        }
    }

    fn found(&self) -> Done {
        let folder = Folder::in_memory(self.matches(usize::MAX).0, Box::new(Files));
        let mut study = self.open(&folder);
        let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
        let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
        Done { study, found, folder }
    }
}

struct Done {
    study: Study,
    found: Findings,
    folder: Folder,
}

impl Done {
    fn record(&self, of: [usize; 2]) -> Record {
        let id = format!("p{}-{}", of[0], of[1]);
        let row = self.study.cohort.subjects.iter().position(|subject| subject.id == id).unwrap();
        self.folder.get(&self.found.matched.keys[row]).unwrap().unwrap()
    }

    /// A measure of each person and visit at each vertex.
    fn values(&self, measure: Measure) -> Vec<[Vec<f64>; VISITS]> {
        let (alignment, mean) = (&self.found.alignment, &self.found.mean);
        let of = |person: usize, visit: usize| {
            let id = format!("p{person}-{visit}");
            let is_it = |row: &usize| self.study.cohort.subjects[*row].id == id;
            let place = self.found.members.iter().position(is_it).unwrap();
            let own = self.record([person, visit]).points;
            let moved = own.iter().map(|p| alignment.onto_mean[place].apply(&Point3::from(p.map(f64::from))));
            let own = mean.with_vertices(moved.collect()).unwrap();
            measured(measure, mean, &own, &Silent).unwrap().unwrap()
        };
        let persons = self.found.members.len() / VISITS;
        (0..persons).map(|person| std::array::from_fn(|visit| of(person, visit))).collect()
    }

    /// Changes of each person from a visit to another at each vertex.
    fn changes(&self, measure: Measure, from: usize, to: usize) -> Vec<Vec<f64>> {
        let change = |of: &[Vec<f64>; VISITS]| of[to].iter().zip(&of[from]).map(|(b, a)| b - a).collect();
        self.values(measure).iter().map(change).collect()
    }
}

fn mean(of: &[f64]) -> f64 {
    of.iter().sum::<f64>() / of.len() as f64
}

fn deviation(of: &[f64]) -> f64 {
    (of.iter().map(|x| (x - mean(of)).powi(2)).sum::<f64>() / (of.len() - 1) as f64).sqrt()
}

/// Root mean square over the vertices without change of the standard deviation over persons.
fn noise(changes: &[Vec<f64>]) -> f64 {
    let mesh = &*TEMPLATE;
    let place = mesh.vertices()[PLACE];
    let far: Vec<usize> =
        (0..mesh.n_vertices()).filter(|&v| (mesh.vertices()[v] - place).norm() > 3.5 * WIDTH_MM).collect();
    let at = |v: &usize| deviation(&changes.iter().map(|of| of[*v]).collect::<Vec<_>>()).powi(2);
    mean(&far.iter().map(at).collect::<Vec<_>>()).sqrt()
}

/// The mean change in the middle of the patch, for each person.
fn in_patch(changes: &[Vec<f64>]) -> Vec<f64> {
    let mesh = &*TEMPLATE;
    let middle: Vec<usize> =
        (0..mesh.n_vertices()).filter(|&v| height(&mesh.vertices()[v], &mesh.vertices()[PLACE]) > 0.5).collect();
    changes.iter().map(|of| mean(&middle.iter().map(|&v| of[v]).collect::<Vec<_>>())).collect()
}

#[test]
fn changes_within_persons_have_less_noise_and_the_thinning_is_unbiased() {
    const PERSONS: usize = 20;
    let plain = Made::of(PERSONS, Visits::GroupTemplate).found();
    let own = Made::of(PERSONS, Visits::OwnTemplate).found();
    // Matches with the template without errors, and matches whose error is the same in all visits of a person.
    let exact = Made { between_mm: 0.0, ..Made::of(PERSONS, Visits::GroupTemplate) }.found();
    let oracle = Made { is_shared: true, ..Made::of(PERSONS, Visits::GroupTemplate) }.found();
    for (measure, most) in [(Measure::NormalDisplacement, 0.3), (Measure::LogArea, 0.3)] {
        let of = |done: &Done| noise(&done.changes(measure, 0, 2));
        let (with, without) = (of(&own), of(&plain));
        println!(
            "{}: SD of change {with:.4} with and {without:.4} without, ratio {:.3}",
            measure.name(),
            with / without
        );
        assert!(with < most * without, "{}: {with} {without}", measure.name());
    }
    for (from, to) in [(0, 1), (1, 2), (0, 2), (2, 0)] {
        let of = |done: &Done| in_patch(&done.changes(Measure::NormalDisplacement, from, to));
        let (truth, found, plain) = (of(&oracle), of(&own), of(&plain));
        let error = |of: &[f64]| deviation(of) / (PERSONS as f64).sqrt();
        let off: Vec<f64> = found.iter().zip(&truth).map(|(a, b)| a - b).collect();
        println!(
            "visit {from} to {to}: {:.4} (SE {:.4}), where the vertices are {:.4}, off by {:.4} (SE {:.4}); without errors \
             {:.4}; by the group template {:.4} (SE {:.4})",
            mean(&found),
            error(&found),
            mean(&truth),
            mean(&off),
            error(&off),
            mean(&of(&exact)),
            mean(&plain),
            error(&plain)
        );
        assert!(mean(&truth).abs() > 0.1 && mean(&off).abs() < 3.0 * error(&off), "{from} {to}: {off:?}");
        // Narrow enough to tell.
        assert!(error(&off) < 0.1 * mean(&truth).abs(), "{from} {to}: {off:?}");
    }
    let noise_of = |from, to| noise(&own.changes(Measure::NormalDisplacement, from, to));
    let each = [noise_of(0, 1), noise_of(1, 2), noise_of(0, 2)];
    println!("SD of change between visits 0 and 1, 1 and 2, 0 and 2: {each:.4?}");
    assert!(each.iter().all(|a| each.iter().all(|b| *a < 1.3 * b)), "a visit is preferred: {each:?}");
}

#[test]
fn the_order_of_visits_only_changes_the_sign_of_changes() {
    let made = Made::of(4, Visits::OwnTemplate);
    let (forward, back) = (made.found(), Made { is_reversed: true, ..made }.found());
    for of in (0..4).flat_map(|person| (0..VISITS).map(move |visit| [person, visit])) {
        assert_eq!(forward.record(of).to_bytes(), back.record(of).to_bytes(), "{of:?}");
    }
    let (changes, reversed) =
        (forward.changes(Measure::NormalDisplacement, 0, 2), back.changes(Measure::NormalDisplacement, 2, 0));
    let apart = changes.iter().flatten().zip(reversed.iter().flatten()).map(|(a, b)| (a + b).abs());
    assert!(apart.fold(0.0, f64::max) < 1e-6);
}

#[test]
fn a_study_that_is_stopped_after_every_match_ends_with_the_same_bytes() {
    let made = Made::of(2, Visits::OwnTemplate);
    let ((whole, purposes), (stopped, _)) = (made.matches(usize::MAX), made.matches(1));
    assert_eq!(purposes, [1, 2, 3].map(Purpose::Visits));
    assert_eq!(whole.keys().collect::<Vec<_>>(), stopped.keys().collect::<Vec<_>>());
    assert!(whole == stopped);
    let composed = whole.keys().filter(|name| name.starts_with("matches/visits/")).count();
    // For each person two matches within, three of the first mean, one of the last; the rest is the template.
    assert_eq!((composed, whole.keys().filter(|name| name.ends_with(".match")).count()), (6, 6 + 12));
    // What was composed can be lost.
    let mut less = whole.clone();
    less.retain(|name, _| !name.starts_with("matches/visits/"));
    let folder = Folder::in_memory(less, Box::new(Files));
    made.open(&folder).advance(&folder, &Quiet).unwrap();
    assert!(folder.into_files() == whole);
}

#[test]
fn without_the_option_no_person_has_a_template() {
    let (files, purposes) = Made::of(2, Visits::GroupTemplate).matches(usize::MAX);
    assert_eq!(purposes, [Purpose::Subjects]);
    assert_eq!(files.keys().filter(|name| name.ends_with(".match")).count(), 2 * VISITS);
    let of = |visits: Visits| {
        let folder = Folder::in_memory(BTreeMap::new(), Box::new(Files));
        serde_json::to_string(&Made::of(2, visits).open(&folder).settings).unwrap()
    };
    assert!(!of(Visits::GroupTemplate).contains("visits"));
    assert!(of(Visits::OwnTemplate).contains(r#""visits":"own_template""#));
}

#[test]
fn joint_maps_keep_the_precision_within_persons() {
    let joint = |visits: Visits| Made { correspondence: Correspondence::Joint, ..Made::of(8, visits) }.found();
    let (own, plain) = (joint(Visits::OwnTemplate), joint(Visits::GroupTemplate));
    assert_eq!(own.found.joint.as_ref().unwrap().subjects, 8, "a person counts once");
    let of = |done: &Done| noise(&done.changes(Measure::NormalDisplacement, 0, 2));
    println!("joint maps: SD of change {:.4} with and {:.4} without", of(&own), of(&plain));
    // Without own templates, a model has seen the other visits of the person that it predicts.
    assert!(of(&own) < 0.8 * of(&plain), "{} {}", of(&own), of(&plain));
    // They are found again, and made again to the bit if they are lost.
    let before: Vec<_> = (0..VISITS).map(|visit| own.record([3, visit])).collect();
    let again = joint(Visits::OwnTemplate);
    assert!((0..VISITS).all(|visit| again.record([3, visit]) == before[visit]));
}

#[test]
fn a_person_without_usable_matches_is_matched_directly() {
    let made = Made::of(2, Visits::OwnTemplate);
    let folder = Folder::in_memory(BTreeMap::new(), Box::new(Files));
    let mut study = made.open(&folder);
    let mut purposes = Vec::new();
    while let Step::Match { purpose, tasks, own, .. } = study.advance(&folder, &Quiet).unwrap() {
        purposes.push(purpose);
        for task in &tasks {
            // No two visits of the first person match.
            let is_first = |row: usize| study.cohort.subjects[row].subject == "p0";
            let record = match task.source {
                Some(row) if is_first(row) => Record::failed("unlike".to_owned()),
                _ => made.record(&study, task, &own),
            };
            folder.keep(&task.key, &record).unwrap();
        }
    }
    let rounds = [1, 2, 3].map(Purpose::Visits);
    assert_eq!(purposes, [rounds.as_slice(), &[Purpose::Subjects]].concat());
    let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
    let is_composed: Vec<bool> = matched.keys.iter().map(|key| key.starts_with("visits/")).collect();
    assert_eq!(is_composed, [false, false, false, true, true, true]);
    assert!(matched.keys.iter().all(|key| folder.get(key).unwrap().is_some_and(|record| record.facts.error.is_none())));
}
