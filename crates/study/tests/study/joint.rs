//! Joint maps of a group whose true correspondence is known: nearer to it than the matches, and no worse in anything
//! else.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Records, Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use homolog_study::subjects::SubjectOutcome;
use nalgebra::{Point3, Rotation3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

const AXES: [f64; 3] = [12.0, 6.0, 4.0];
const SUBJECTS: usize = 16;

struct Quiet;
impl StudyObserver for Quiet {}

/// Repeatable numbers between -1 and 1.
fn number(k: usize, which: usize) -> f64 {
    (12.9898 * k as f64 + 78.233 * (which + 1) as f64).sin() * 43758.547 % 1.0
}

/// The true map of subject `k`: lengthened, bent and tapered, turned in space.
fn truth(k: usize, p: &Point3<f64>) -> Point3<f64> {
    let [long, bend, taper] = [0, 1, 2].map(|which| number(k, which));
    let taper = 1.0 + 0.02 * taper * p.x;
    let shape = Point3::new(p.x * (1.0 + 0.08 * long), taper * p.y + 0.008 * (1.0 + bend) * p.x * p.x, taper * p.z);
    Rotation3::from_euler_angles(0.3 * number(k, 3), 0.2 * number(k, 4), 0.4 * number(k, 5)) * shape
}

/// A match of subject `k`: each point slid along the template before it is mapped.
fn matched(k: usize, p: &Point3<f64>) -> Point3<f64> {
    let slide = |axis: usize| {
        let [a, b, c] = [0, 1, 2].map(|which| number(k, 10 + 3 * axis + which));
        0.7 * (0.25 * p.x + 3.0 * a).sin() + 0.7 * (0.4 * p.y + 3.0 * b).cos() * c
    };
    let slid = p + Vector3::new(slide(0), slide(1), slide(2));
    // Back to the ellipsoid along the line to its center.
    let [a, b, c] = AXES;
    truth(k, &(slid / Vector3::new(slid.x / a, slid.y / b, slid.z / c).norm()))
}

fn template() -> SurfaceMesh {
    ellipsoid(Vector3::from(AXES), 3)
}

fn surface(k: usize) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::from(AXES), 4);
    mesh.with_vertices(mesh.vertices().iter().map(|p| truth(k, p)).collect()).unwrap()
}

#[derive(Debug)]
struct Files;

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap();
        Ok(write_ply(&if name == "template" { template() } else { surface(name[1..].parse().unwrap()) }))
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(file.to_string_lossy().as_bytes()).to_hex().to_string())
    }
}

struct Done {
    study: Study,
    found: Findings,
    files: BTreeMap<String, Vec<u8>>,
}

/// A study of subjects in this order, from files that exist; those with `scored` are not part of the model.
fn studied(
    order: &[usize],
    scored: &[usize],
    size: Size,
    how: Correspondence,
    mut files: BTreeMap<String, Vec<u8>>,
) -> Done {
    let mut table = "id,file,role\n".to_owned();
    for k in order {
        table.push_str(&format!("s{k},s{k}.ply,{}\n", if scored.contains(k) { "score" } else { "model" }));
    }
    let settings = Settings {
        template: TemplateChoice::Given { file: "template.ply".into() },
        template_side: None,
        size,
        correspondence: how,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis::default(),
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    };
    let open = |files: &BTreeMap<String, Vec<u8>>| {
        let folder = Folder::in_memory(files.clone(), Box::new(Files));
        let cohort = Cohort::from_csv(table.as_bytes(), Path::new("")).unwrap();
        (Study::open(cohort, settings.clone(), &[], &folder, &Quiet).unwrap(), folder)
    };
    let (mut study, folder) = open(&files);
    if let Step::Match { tasks, template, .. } = study.advance(&folder, &Quiet).unwrap() {
        for task in tasks {
            let k = order[task.target.unwrap()];
            let points =
                template.mesh.vertices().iter().map(|p| matched(k, p)).map(|p| [p.x, p.y, p.z].map(|x| x as f32));
            let facts = Facts::default();
            files.insert(record_name(&task.key), Record { facts, points: points.collect() }.to_bytes());
        }
    }
    let (mut study, folder) = open(&files);
    let Step::Matched(matched) = study.advance(&folder, &Quiet).unwrap() else { panic!("matches are missing") };
    let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
    let done = |folder: Folder| Done { study, found, files: folder.into_files() };
    done(folder)
}

impl Done {
    /// Map of subject `k`.
    fn map(&self, k: usize) -> Vec<Point3<f64>> {
        let row = self.study.cohort.subjects.iter().position(|subject| subject.id == format!("s{k}")).unwrap();
        let folder = Folder::in_memory(self.files.clone(), Box::new(Files));
        let record = folder.get(&self.found.matched.keys[row]).unwrap().unwrap();
        record.points.iter().map(|p| Point3::from(p.map(f64::from))).collect()
    }

    /// RMS distance of the map of subject `k` from the truth, mm.
    fn error_mm(&self, k: usize) -> f64 {
        let (template, map) = (template(), self.map(k));
        let squares = template.vertices().iter().zip(&map).map(|(p, q)| (truth(k, p) - q).norm_squared());
        (squares.sum::<f64>() / map.len() as f64).sqrt()
    }

    /// Mean distance of the vertices of subject `k` from the mapped template, mm.
    fn residual_mm(&self, k: usize) -> f64 {
        let index = ClosestPointIndex::new(&template().with_vertices(self.map(k)).unwrap());
        let surface = surface(k);
        surface.vertices().iter().map(|p| (index.closest(p).point - p).norm()).sum::<f64>()
            / surface.n_vertices() as f64
    }

    /// Share of turned triangles, and the least and largest ratio of areas to those of the truth.
    fn triangles(&self, k: usize) -> (usize, f64, f64) {
        let template = template();
        let true_map = template.with_vertices(template.vertices().iter().map(|p| truth(k, p)).collect()).unwrap();
        let map = template.with_vertices(self.map(k)).unwrap();
        let (mut turned, mut least, mut most) = (0, f64::INFINITY, 0.0f64);
        for (a, b) in true_map.face_vector_areas().iter().zip(map.face_vector_areas()) {
            turned += usize::from(a.dot(&b) <= 0.0);
            least = least.min(b.norm() / a.norm());
            most = most.max(b.norm() / a.norm());
        }
        (turned, least, most)
    }
}

fn all() -> Vec<usize> {
    (0..SUBJECTS).collect()
}

#[test]
fn joint_maps_are_nearer_to_the_truth_than_matches() {
    let pairs = studied(&all(), &[], Size::Kept, Correspondence::Pairs, BTreeMap::new());
    let joint = studied(&all(), &[], Size::Kept, Correspondence::Joint, BTreeMap::new());
    let mean = |of: &dyn Fn(usize) -> f64| (0..SUBJECTS).map(of).sum::<f64>() / SUBJECTS as f64;
    let (before, after) = (mean(&|k| pairs.error_mm(k)), mean(&|k| joint.error_mm(k)));
    assert!(after < 0.75 * before, "{after} {before}");
    for k in 0..SUBJECTS {
        assert!(joint.residual_mm(k) <= pairs.residual_mm(k) + 1e-6, "subject {k}");
        let stated = joint.found.subjects[k].facts.residual_mm;
        assert!((stated - joint.residual_mm(k)).abs() < 1e-4, "{stated}");
        let (turned, least, most) = joint.triangles(k);
        assert!(turned == 0 && least > 0.2 && most < 5.0, "subject {k}: {turned} {least} {most}");
    }
    let quality = |done: &Done| done.found.model.quality.clone();
    let (before, after) = (quality(&pairs), quality(&joint));
    let modes = 2;
    assert!(after.compactness[modes] > before.compactness[modes]);
    assert!(after.generalization_mm[modes] < 0.7 * before.generalization_mm[modes]);
    assert!(joint.found.joint.as_ref().unwrap().rounds.len() > 1 && pairs.found.joint.is_none());
}

#[test]
fn neither_threads_nor_the_order_of_subjects_matter() {
    let some: Vec<usize> = (0..7).collect();
    let with = |order: &[usize], threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| studied(order, &[], Size::Kept, Correspondence::Joint, BTreeMap::new()))
    };
    let one = with(&some, 1);
    assert!(one.files.keys().filter(|name| name.starts_with("matches/joint/")).count() == 8, "{:?}", one.files.keys());
    assert!(one.files == with(&some, 3).files);
    let reversed: Vec<usize> = some.iter().rev().copied().collect();
    let other = with(&reversed, 2);
    for k in some {
        assert_eq!(one.map(k), other.map(k), "subject {k}");
    }
}

#[test]
fn joint_maps_that_exist_are_used_and_those_of_another_group_are_removed() {
    let some: Vec<usize> = (0..6).collect();
    let first = studied(&some, &[], Size::Kept, Correspondence::Joint, BTreeMap::new());
    // A record that was made up shows whether it is read or computed again.
    let name = record_name(&first.found.matched.keys[2]);
    let mut files = first.files.clone();
    let mut record = Record::from_bytes(&files[&name]).unwrap();
    record.facts.residual_mm = 123.0;
    files.insert(name.clone(), record.to_bytes());
    let again = studied(&some, &[], Size::Kept, Correspondence::Joint, files.clone());
    assert_eq!(again.found.subjects[2].facts.residual_mm, 123.0);
    // A lost or damaged record, as after a crash, is computed again with the others.
    files.insert(record_name(&first.found.matched.keys[4]), b"half".to_vec());
    let repaired = studied(&some, &[], Size::Kept, Correspondence::Joint, files);
    assert!(repaired.files == first.files);
    let fewer = studied(&some[..5], &[], Size::Kept, Correspondence::Joint, first.files.clone());
    assert_ne!(fewer.found.matched.keys[2], first.found.matched.keys[2]);
    assert_eq!(fewer.files.keys().filter(|name| name.starts_with("matches/joint/")).count(), 6);
    let pairs = studied(&some, &[], Size::Kept, Correspondence::Pairs, first.files.clone());
    assert_eq!(pairs.map(3), some_match(3), "matches are kept as they are");
}

fn some_match(k: usize) -> Vec<Point3<f64>> {
    let stored = |p: Point3<f64>| Point3::from([p.x, p.y, p.z].map(|x| f64::from(x as f32)));
    template().vertices().iter().map(|p| stored(matched(k, p))).collect()
}

#[test]
fn a_subject_that_is_only_scored_is_revised_and_changes_no_other() {
    let with = |subjects: &[usize], scored: &[usize]| {
        studied(subjects, scored, Size::Kept, Correspondence::Joint, BTreeMap::new())
    };
    let without = with(&all()[..SUBJECTS - 1], &[]);
    let scored = with(&all(), &[SUBJECTS - 1]);
    assert_eq!(scored.found.subjects[SUBJECTS - 1].place, SubjectOutcome::Scored);
    assert!((0..SUBJECTS - 1).all(|k| scored.map(k) == without.map(k)));
    let pairs = studied(&all(), &[SUBJECTS - 1], Size::Kept, Correspondence::Pairs, BTreeMap::new());
    let (before, after) = (pairs.error_mm(SUBJECTS - 1), scored.error_mm(SUBJECTS - 1));
    assert!(after < 0.8 * before, "{after} {before}");
}

#[test]
fn size_can_be_left_out_of_shape() {
    let joint = studied(&all()[..8], &[], Size::Removed, Correspondence::Joint, BTreeMap::new());
    let pairs = studied(&all()[..8], &[], Size::Removed, Correspondence::Pairs, BTreeMap::new());
    let mean = |done: &Done| (0..8).map(|k| done.error_mm(k)).sum::<f64>() / 8.0;
    assert!(mean(&joint) < 0.8 * mean(&pairs), "{} {}", mean(&joint), mean(&pairs));
}
