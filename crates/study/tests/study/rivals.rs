//! A study in which matches leave the pose of some subjects open: the steps to their other poses, what the group decides, who may
//! overrule it, and that nothing else changes it. Matches are made up: a wrong pose is the true map after a half turn of the template.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::{Decision, Folder, Verdict, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::output::write;
use homolog_study::plan::{Purpose, Records, Step, Study, Task, Template};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use homolog_study::subjects::{Flag, SubjectOutcome};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::LazyLock;

const SUBJECTS: usize = 12;
/// The half turns of the template, the identity first.
const TURNS: [[f64; 3]; 4] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];

struct Quiet;
impl StudyObserver for Quiet {}

/// Repeatable numbers between -1 and 1.
fn number(of: usize, which: usize) -> f64 {
    let bytes = *blake3::hash(format!("rival {of} {which}").as_bytes()).as_bytes();
    let [a, b, c, d, ..] = bytes;
    2.0 * f64::from(u32::from_le_bytes([a, b, c, d])) / f64::from(u32::MAX) - 1.0
}

static TEMPLATE: LazyLock<SurfaceMesh> = LazyLock::new(|| ellipsoid(Vector3::new(12.0, 7.0, 5.0), 2));

/// The vertex to which each vertex goes by a half turn.
static IMAGES: LazyLock<[Vec<usize>; 4]> = LazyLock::new(|| {
    let vertices = TEMPLATE.vertices();
    TURNS.map(|signs| {
        let nearest = |p: &Point3<f64>| {
            let apart =
                |k: &usize| (vertices[*k].coords - p.coords.component_mul(&Vector3::from(signs))).norm_squared();
            (0..vertices.len()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap()
        };
        vertices.iter().map(nearest).collect()
    })
});

fn motion(k: usize) -> Isometry3<f64> {
    let of = |which: usize| number(k, 100 + which);
    Isometry3::new(20.0 * Vector3::new(of(0), of(1), of(2)), 2.0 * Vector3::new(of(3), of(4), of(5)))
}

/// Subject `k`: bumps that all have, besides those in which subjects differ, turned and shifted.
fn surface(k: usize, bump_mm: f64) -> SurfaceMesh {
    let normals = TEMPLATE.vertex_normals();
    let height = |p: &Point3<f64>, center: &Point3<f64>| (-(p - center).norm_squared() / 18.0).exp();
    let at = |(p, n): (&Point3<f64>, &Vector3<f64>)| {
        let varied = TEMPLATE.vertices().iter().step_by(9).enumerate();
        let varied: f64 = varied.map(|(which, center)| 0.2 * number(k, which) * height(p, center)).sum();
        let common = bump_mm * height(p, &Point3::new(8.0, 4.0, 3.0));
        motion(k) * (p + (varied + common) * n)
    };
    TEMPLATE.with_vertices(TEMPLATE.vertices().iter().zip(&normals).map(at).collect()).unwrap()
}

/// The rotation of subject `k` after a half turn of the template.
fn rotation(k: usize, turn: usize) -> Matrix3<f64> {
    motion(k).rotation.to_rotation_matrix().matrix() * Matrix3::from_diagonal(&Vector3::from(TURNS[turn]))
}

fn rows(m: &Matrix3<f64>) -> [[f64; 3]; 3] {
    std::array::from_fn(|r| std::array::from_fn(|c| m[(r, c)]))
}

/// A study, of which the first `ambiguous` subjects have an open pose.
#[derive(Debug, Clone)]
struct Made {
    ambiguous: usize,
    bump_mm: f64,
    rivals: Rivals,
    columns: bool,
    order: Vec<usize>,
    /// The subjects among which consistency is measured.
    ring: Vec<usize>,
}

impl Default for Made {
    fn default() -> Self {
        let order = (0..SUBJECTS).collect();
        Made { ambiguous: 4, bump_mm: 3.0, rivals: Rivals::Decide, columns: false, order, ring: Vec::new() }
    }
}

#[derive(Debug)]
struct Files(f64);

fn number_of(name: &str) -> usize {
    name.trim_start_matches('s').parse().unwrap()
}

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap();
        Ok(write_ply(&if name == "template" { TEMPLATE.clone() } else { surface(number_of(name), self.0) }))
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(&self.read(file)?).to_hex().to_string())
    }
}

impl Made {
    fn open(&self, folder: &Folder) -> Study {
        let settings = Settings {
            template: TemplateChoice::Given { file: "template.ply".into() },
            template_side: None,
            size: Size::Kept,
            correspondence: Correspondence::Pairs,
            visits: Visits::default(),
            rivals: self.rivals,
            analysis: Analysis::default(),
            cycle_subjects: self.ring.len(),
            cycle_ring: self.ring.iter().map(|k| format!("s{k}")).collect(),
            parameters: preset(Method::Balanced),
        };
        // Covariates that would say which pose is right, and the opposite.
        let row = |k: &usize| match self.columns {
            false => format!("s{k},s{k}.ply\n"),
            true => format!("s{k},s{k}.ply,{},{}\n", ["a", "b"][usize::from(*k < self.ambiguous)], *k % 3),
        };
        let header = if self.columns { "id,file,group,score" } else { "id,file" };
        let text = format!("{header}\n{}", self.order.iter().map(row).collect::<String>());
        let cohort = Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
        Study::open(cohort, settings, &[], folder, &Quiet).unwrap()
    }

    fn folder(&self, files: BTreeMap<String, Vec<u8>>) -> Folder {
        Folder::in_memory(files, Box::new(Files(self.bump_mm)))
    }

    fn is_ambiguous(&self, k: usize) -> bool {
        k < self.ambiguous
    }

    /// The pose of the match of a subject, which is right for every other one that is open.
    fn own_turn(&self, k: usize) -> usize {
        if self.is_ambiguous(k) { [0, 1, 2, 0][k % 4] } else { 0 }
    }

    /// A match of the ring: to the template in the pose of the subject's own match, or to another subject in those of both.
    fn of_ring(&self, [source, target]: [Option<usize>; 2]) -> Record {
        let turn = |of: Option<usize>| of.map_or(0, |k| self.own_turn(k));
        let onto = target.map_or_else(|| TEMPLATE.clone(), |k| surface(k, self.bump_mm));
        let image = |v: usize| onto.vertices()[IMAGES[turn(target)][IMAGES[turn(source)][v]]];
        let points = (0..onto.n_vertices()).map(|v| image(v).coords.map(|x| x as f32).into()).collect();
        Record { facts: Facts { reliable: Some(true), ..Facts::default() }, points }
    }

    fn record(&self, study: &Study, task: &Task, own: &[Template]) -> Record {
        if let Some(source) = task.source {
            let number = |row: usize| number_of(&study.cohort.subjects[row].id);
            return self.of_ring([Some(number(source)), task.target.map(number)]);
        }
        let row = task.target.or(task.rival.map(|rival| rival.subject)).unwrap();
        let k = number_of(&study.cohort.subjects[row].id);
        let whole = surface(k, self.bump_mm);
        let map = |turn: usize| IMAGES[turn].iter().map(|&v| whole.vertices()[v]).collect::<Vec<_>>();
        let stored = |points: Vec<Point3<f64>>| -> Vec<[f32; 3]> {
            points.iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect()
        };
        let Some(rival) = task.rival else {
            let turn = self.own_turn(k);
            let facts = match self.is_ambiguous(k) {
                false => Facts { reliable: Some(true), ..Facts::default() },
                // One of three rivals is named, which is not always right.
                true => Facts {
                    reliable: Some(false),
                    reasons: vec!["ambiguous_pose".to_owned()],
                    rivals: vec![rows(&rotation(k, (turn + 1 + k % 2) % 4))],
                    volume_mm3: Some(7.0),
                    ..Facts::default()
                },
            };
            return Record { facts, points: stored(map(turn)) };
        };
        let back = Matrix3::from_fn(|r, c| rival.rotation[c][r]);
        // The surface of the task is that of the subject, turned back.
        let target = &own[task.own.unwrap()].mesh;
        for (p, q) in target.vertices().iter().zip(whole.vertices()) {
            assert!((p - back * q).norm() < 1e-9);
        }
        let near = |turn: &usize| (back * rotation(k, *turn)).trace();
        let turn = (0..4).max_by(|a, b| near(a).total_cmp(&near(b))).unwrap();
        let facts = Facts { reliable: Some(true), residual_mm: 0.5, ..Facts::default() };
        Record { facts, points: stored(map(turn).iter().map(|p| back * p).collect()) }
    }

    /// All matches, in steps of `at_a_time` after which the study is opened again, the last of each step first if `reversed`.
    fn matches(&self, at_a_time: usize, reversed: bool) -> (BTreeMap<String, Vec<u8>>, Vec<Purpose>) {
        let (mut files, mut purposes) = (BTreeMap::new(), Vec::new());
        loop {
            let folder = self.folder(files);
            let mut study = self.open(&folder);
            let Step::Match { purpose, mut tasks, own, .. } = study.advance(&folder, &Quiet).unwrap() else {
                return (folder.into_files(), purposes);
            };
            if purposes.last() != Some(&purpose) {
                purposes.push(purpose);
            }
            if reversed {
                tasks.reverse();
            }
            for task in tasks.iter().take(at_a_time) {
                folder.keep(&task.key, &self.record(&study, task, &own)).unwrap();
            }
            files = folder.into_files();
        }
    }

    fn found(&self, decisions: &[Decision]) -> Done {
        let folder = self.folder(self.matches(usize::MAX, false).0);
        let mut study = self.open(&folder);
        let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
        let found = find(&study, &matched, &folder, decisions, &Quiet).unwrap();
        Done { bump_mm: self.bump_mm, study, found, folder }
    }
}

struct Done {
    bump_mm: f64,
    study: Study,
    found: Findings,
    folder: Folder,
}

impl Done {
    fn row(&self, k: usize) -> usize {
        self.study.cohort.subjects.iter().position(|subject| subject.id == format!("s{k}")).unwrap()
    }

    fn map(&self, k: usize) -> Record {
        self.folder.get(&self.found.matched.keys[self.row(k)]).unwrap().unwrap()
    }

    /// Largest distance of the map of a subject from the true one, mm.
    fn error(&self, k: usize) -> f64 {
        let whole = surface(k, self.bump_mm);
        let apart = |(p, q): (&[f32; 3], &Point3<f64>)| (Point3::from(p.map(f64::from)) - q).norm();
        self.map(k).points.iter().zip(whole.vertices()).map(apart).fold(0.0, f64::max)
    }
}

#[test]
fn open_poses_are_decided_and_the_right_map_takes_its_place() {
    let done = Made::default().found(&[]);
    // The shape of the first subject is unusual: nearest in the right pose, and yet out of the range of the others.
    let left_out = &done.found.subjects[done.row(0)];
    let on = left_out.group.unwrap();
    assert!(left_out.place == SubjectOutcome::Unreliable && !on.decided && on.candidate == 0 && on.marginal > 0.95);
    for k in 1..SUBJECTS {
        let subject = &done.found.subjects[done.row(k)];
        assert_eq!(subject.place, SubjectOutcome::Model, "s{k}: {:?}", subject.group);
        assert!(done.error(k) < 1e-4, "s{k}: {}", done.error(k));
        assert_eq!(subject.group.is_some(), k < 4);
    }
    let of = |k: usize| done.found.subjects[done.row(k)].clone();
    let third = of(3).group.unwrap();
    assert!(third.decided && third.marginal >= 0.95 && (third.candidates, third.reliable) == (4, 8));
    assert!(third.candidate == 0 && of(1).group.unwrap().candidate > 0);
    assert!(of(1).flags.contains(&Flag::PoseByGroup) && !of(1).flags.contains(&Flag::UnreliableMatch));
    // What the match says about the surface stays; what it says about the map is that of the candidate.
    let facts = done.map(1).facts;
    assert_eq!((facts.volume_mm3, facts.residual_mm, facts.reliable), (Some(7.0), 0.5, Some(true)));
    assert_eq!(facts.reasons, ["ambiguous_pose"]);
    // Outputs say so.
    write(&done.study, &done.found, &[], &done.folder, "test", &Quiet).unwrap();
    let text = |name: &str| String::from_utf8(done.folder.read(name).unwrap().unwrap()).unwrap();
    let document: serde_json::Value = serde_json::from_str(&text("study.json")).unwrap();
    let poses = document["found"]["ambiguous_poses"].as_array().unwrap();
    assert!(poses.len() == 4 && poses[1]["id"] == "s1" && poses[1]["decided"] == true, "{poses:?}");
    assert!(text("subjects.csv").lines().next().unwrap().contains("pose_candidates,pose_candidate,pose_marginal"));
    assert!(text("report.html").contains("pose decided by 8 reliable subjects"));
    assert!(text("quality.csv").contains("pose decided by the group"));
}

#[test]
fn a_study_that_is_stopped_after_every_match_ends_with_the_same_bytes() {
    let made = Made::default();
    let (whole, purposes) = made.matches(usize::MAX, false);
    assert_eq!(purposes, [Purpose::Subjects, Purpose::Rivals]);
    assert_eq!(whole.keys().filter(|name| name.ends_with(".match")).count(), SUBJECTS + 4 * 3);
    for (at_a_time, reversed) in [(1, false), (5, true)] {
        assert!(made.matches(at_a_time, reversed).0 == whole, "{at_a_time}");
    }
    // What was decided can be lost.
    let done = made.found(&[]);
    let records = |folder: Folder| -> BTreeMap<String, Vec<u8>> { folder.into_files() };
    let (study, mut found) = (done.study, records(done.folder));
    let all = found.clone();
    found.retain(|name, _| !name.starts_with("matches/rivals/"));
    assert_eq!(all.len(), found.len() + 3);
    let folder = made.folder(found);
    let mut again = made.open(&folder);
    let Step::Matched(matched) = again.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
    find(&study, &matched, &folder, &[], &Quiet).unwrap();
    assert!(records(folder) == all);
}

#[test]
fn a_record_says_once_which_poses_are_open() {
    let made = Made::default();
    let folder = made.folder(BTreeMap::new());
    let mut study = made.open(&folder);
    let mut step = || match study.advance(&folder, &Quiet).unwrap() {
        Step::Match { purpose, tasks, own, .. } => (purpose, tasks, own),
        Step::Matched(_) => panic!("no match is missing"),
    };
    let (_, tasks, own) = step();
    let subjects: Vec<String> = tasks.iter().map(|task| task.key.clone()).collect();
    let keep = |tasks: &[Task], own: &[Template]| {
        let study = made.open(&folder);
        tasks.iter().for_each(|task| folder.keep(&task.key, &made.record(&study, task, own)).unwrap());
    };
    keep(&tasks, &own);
    let (purpose, first, own) = step();
    assert_eq!((purpose, first.len()), (Purpose::Rivals, 4 * 3));
    // No further step depends on the matches of subjects: a damaged record would be an error.
    subjects.iter().for_each(|key| folder.write(&record_name(key), b"damaged").unwrap());
    keep(&first[..5], &own);
    let (purpose, rest, _) = step();
    let keys = |of: &[Task]| of.iter().map(|task| task.key.clone()).collect::<Vec<_>>();
    assert_eq!((purpose, keys(&rest)), (Purpose::Rivals, keys(&first[5..])));
}

#[test]
fn decisions_of_people_come_first() {
    let decision = |k: usize, decision: Verdict| Decision { id: format!("s{k}"), decision, reason: String::new() };
    let done = Made::default().found(&[decision(1, Verdict::Kept), decision(2, Verdict::Dropped)]);
    let of = |k: usize| &done.found.subjects[done.row(k)];
    // Kept with the map of its match, which is not right here, and an observation for the others; dropped, it takes no part.
    assert!(of(1).place == SubjectOutcome::Model && of(1).group.is_none() && done.error(1) > 1.0);
    assert!(of(2).place == SubjectOutcome::Dropped && of(2).group.is_none());
    assert_eq!(of(0).group.unwrap().reliable, 9);
}

#[test]
fn without_open_poses_or_with_too_few_others_there_is_no_step() {
    for made in [
        Made { ambiguous: 0, ..Made::default() },
        Made { rivals: Rivals::LeaveOut, ..Made::default() },
        Made { ambiguous: SUBJECTS - 2, ..Made::default() },
    ] {
        let (files, purposes) = made.matches(usize::MAX, false);
        assert_eq!(purposes, [Purpose::Subjects], "{made:?}");
        assert_eq!(files.keys().filter(|name| name.ends_with(".match")).count(), SUBJECTS);
    }
    let (decide, leave_out) =
        (Made { ambiguous: 0, ..Made::default() }, Made { rivals: Rivals::LeaveOut, ..Made::default() });
    let open = |made: &Made| serde_json::to_string(&made.open(&made.folder(BTreeMap::new())).settings).unwrap();
    assert!(!open(&decide).contains("rivals") && open(&leave_out).contains(r#""rivals":"leave_out""#));
    let left = leave_out.found(&[]);
    assert_eq!(left.found.subjects[left.row(0)].place, SubjectOutcome::Unreliable);
    write(&left.study, &left.found, &[], &left.folder, "test", &Quiet).unwrap();
    let text = |name: &str| String::from_utf8(left.folder.read(name).unwrap().unwrap()).unwrap();
    assert!(!text("subjects.csv").contains("pose_") && !text("study.json").contains("ambiguous_poses"));
}

#[test]
fn a_decided_pose_is_in_no_cycle_with_matches_of_the_pose_before() {
    let of = |ring: &[usize], rivals: Rivals| Made { ring: ring.to_vec(), rivals, ..Made::default() }.found(&[]);
    let done = of(&[1, 5, 8, 10], Rivals::Decide);
    let pose = done.found.subjects[done.row(1)].group.unwrap();
    assert!(pose.decided && pose.candidate > 0, "{pose:?}");
    let found = done.found.consistency.clone().unwrap();
    assert_eq!((found.ring.join(" ").as_str(), found.decided.join(" ").as_str()), ("s1 s5 s8 s10", "s1"));
    // All matches are exact in the poses that they have.
    let all = [
        found.template_and_back,
        found.pair_and_back,
        found.ring_by_pairs,
        found.ring_through_template,
        found.pair_to_template,
    ];
    assert!(all.iter().all(|figure| figure.mean_mm < 1e-3 && figure.p95_mm < 1e-3), "{found:?}");
    write(&done.study, &done.found, &[], &done.folder, "test", &Quiet).unwrap();
    let text = |name: &str| String::from_utf8(done.folder.read(name).unwrap().unwrap()).unwrap();
    let document: serde_json::Value = serde_json::from_str(&text("study.json")).unwrap();
    assert_eq!(document["found"]["consistency"]["decided"], serde_json::json!(["s1"]));
    assert!(text("report.html").contains("Without 1 subject whose pose the group decided"));
    // Left open, it is in all cycles with the map of its match.
    let open = of(&[1, 5, 8, 10], Rivals::LeaveOut).found.consistency.unwrap();
    assert!(open.decided.is_empty() && open.template_and_back.p95_mm < 1e-3 && open.pair_to_template.p95_mm < 1e-3);
    assert!(!serde_json::to_string(&open).unwrap().contains("decided"));
    // No two that follow each other have the poses of their matches.
    assert_eq!(of(&[1, 2, 5], Rivals::Decide).found.consistency, None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn covariates_and_the_order_of_the_table_change_nothing(
        order in Just((0..SUBJECTS).collect::<Vec<_>>()).prop_shuffle(), bump_mm in 0.0..3.0f64, ambiguous in 1..6usize,
    ) {
        let made = Made { bump_mm, ambiguous, ..Made::default() };
        let (plain, other) = (made.found(&[]), Made { columns: true, order, ..made }.found(&[]));
        for k in 0..SUBJECTS {
            prop_assert_eq!(plain.found.subjects[plain.row(k)].group, other.found.subjects[other.row(k)].group);
            prop_assert_eq!(plain.map(k), other.map(k));
        }
    }
}
