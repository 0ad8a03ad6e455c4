//! Several structures of each person in one study: what is found of their relative pose and how it is written.

use crate::population::{Population, template};
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::Findings;
use homolog_study::folder::{Decision, Folder, Verdict, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::output::{read_document, write};
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::storage::Inputs;
use homolog_study::structures::GroupStudy;
use homolog_study::subjects::{Flag, SubjectOutcome};
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

const PERSONS: usize = 40;
/// How far the second structure of patients lies from that of controls, mm, along y: away from the first.
const SHIFT_MM: f64 = 1.0;
/// The first structure is named so, because the other one moves relative to it.
const FIRST: &str = "hippocampus";
const SECOND: &str = "putamen";

struct Quiet;
impl StudyObserver for Quiet {}

/// The surface of the second structure, about its own center.
fn small() -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(5.0, 4.0, 3.0), 2);
    let bump = |p: &Point3<f64>| p + p.coords * 0.2 * (-(p - Point3::new(3.0, 2.0, 1.0)).norm_squared() / 4.0).exp();
    mesh.with_vertices(mesh.vertices().iter().map(bump).collect()).unwrap()
}

/// Where it lies beside the first one.
fn beside() -> Vector3<f64> {
    Vector3::new(3.0, 11.0, 2.0)
}

/// The files of a study whose records are made up. None of the files of subjects is read.
#[derive(Debug)]
struct Files;

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        Ok(write_ply(&if file.ends_with("second.ply") { small() } else { template() }))
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(file.to_string_lossy().as_bytes()).to_hex().to_string())
    }
}

/// Both structures of everybody, by id of the person and name. Their shapes vary as much in patients as in controls; the
/// second structure of patients, every other person, is shifted.
fn shapes(seed: u64) -> BTreeMap<(String, &'static str), Vec<[f32; 3]>> {
    let mut population = Population::new(seed);
    let small = small();
    let (rest, normals) = (small.vertices().to_vec(), small.vertex_normals());
    let mut shapes = BTreeMap::new();
    for k in 0..PERSONS {
        let mut draw = |deviation: f64| [0; 3].map(|_| deviation * population.draw());
        let field = [draw(0.15), draw(0.15), draw(0.1)];
        let [turn, shift] = [draw(0.02), draw(0.2)].map(Vector3::from);
        let motion = Isometry3::new(Vector3::from(draw(5.0)), Vector3::from(draw(0.3)));
        let shift = beside() + shift + if k % 2 == 0 { SHIFT_MM * Vector3::y() } else { Vector3::zeros() };
        let turn = UnitQuaternion::from_scaled_axis(turn);
        let own = rest.iter().zip(&normals).map(|(p, normal)| {
            let wave = |axis: usize| field[0][axis] * (p[axis] / 2.0).sin() + field[1][axis] * (p[axis] / 3.0).cos();
            motion * Point3::from(turn * (p.coords + normal * (0..3).map(wave).sum::<f64>()) + shift)
        });
        let stored = |p: Point3<f64>| [p.x, p.y, p.z].map(|x| x as f32);
        let own = own.map(stored).collect();
        // The population moves every shape; this person's first structure lies in the pose of its second.
        let first = population.shape(&|_| 0.0);
        let mesh = template();
        let at: Vec<Point3<f64>> = first.iter().map(|p| Point3::from(p.map(f64::from))).collect();
        let back = homolog_registration::procrustes(&at, mesh.vertices(), None, &Default::default()).unwrap();
        let first = at.iter().map(|p| stored(motion * back.target_from_source.apply(p))).collect();
        shapes.insert((format!("p{k}"), FIRST), first);
        shapes.insert((format!("p{k}"), SECOND), own);
    }
    shapes
}

fn row(k: usize, structure: &str) -> String {
    format!("p{k},{structure},p{k}-{structure}.ply,{},{}\n", ["patient", "control"][k % 2], 60 + k * 7 % 20)
}

fn table(structures: &[&str]) -> String {
    let rows = (0..PERSONS).flat_map(|k| structures.iter().map(move |of| row(k, of)));
    "subject,structure,file,group,age\n".to_owned() + &rows.collect::<String>()
}

fn settings(measures: Vec<Measure>) -> Settings {
    let given = BTreeMap::from([(FIRST.to_owned(), "first.ply".into()), (SECOND.to_owned(), "second.ply".into())]);
    Settings {
        template: TemplateChoice::Made(MadeTemplate { given, ..MadeTemplate::default() }),
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::GroupTemplate,
        rivals: Rivals::Decide,
        analysis: Analysis {
            effect: Some("group".to_owned()),
            adjust: vec!["age".to_owned()],
            measures,
            permutations: 400,
            ..Analysis::default()
        },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Rigid),
    }
}

/// The records of the matches of one structure, by the study of its rows alone.
fn records(
    text: &str,
    settings: &Settings,
    structure: &str,
    shape: &dyn Fn(&str) -> Record,
) -> BTreeMap<String, Vec<u8>> {
    let cohort = Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
    let TemplateChoice::Made(how) = &settings.template else { panic!("given") };
    let template = TemplateChoice::Given { file: how.given[structure].clone() };
    let mut own = cohort.clone();
    let rows: Vec<usize> =
        (0..cohort.subjects.len()).filter(|&k| cohort.subjects[k].structure_name() == Some(structure)).collect();
    own.subjects = rows.iter().map(|&k| cohort.subjects[k].clone()).collect();
    own.covariates.clear();
    let folder = Folder::in_memory(BTreeMap::new(), Box::new(Files));
    let mut study = Study::open(own, Settings { template, ..settings.clone() }, &[], &folder, &Quiet).unwrap();
    let Step::Match { tasks, .. } = study.advance(&folder, &Quiet).unwrap() else { panic!("no matches") };
    let person = |k: Option<usize>| study.cohort.subjects[k.unwrap()].subject.clone();
    tasks.iter().map(|task| (record_name(&task.key), shape(&person(task.target)).to_bytes())).collect()
}

fn facts(volume: f64) -> Facts {
    Facts { reliable: Some(true), volume_mm3: Some(volume), area_mm2: 1.0, residual_mm: 0.1, ..Facts::default() }
}

/// The records of both structures, with facts that `changed` may change.
fn all_records(
    text: &str,
    settings: &Settings,
    shapes: &BTreeMap<(String, &'static str), Vec<[f32; 3]>>,
    changed: &dyn Fn(&str, &str, &mut Facts),
) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for structure in [FIRST, SECOND] {
        if !text.contains(&format!(",{structure},")) {
            continue;
        }
        let shape = |person: &str| {
            let number: f64 = person[1..].parse().unwrap();
            let mut facts = facts(1000.0 + (number * 7.0) % 11.0);
            changed(person, structure, &mut facts);
            Record { facts, points: shapes[&(person.to_owned(), structure)].clone() }
        };
        files.extend(records(text, settings, structure, &shape));
    }
    files
}

type Done = (Study, Findings, BTreeMap<String, Vec<u8>>);

/// The study of a table whose matches are these, and all its files.
fn studied(
    text: &str,
    settings: &Settings,
    files: &BTreeMap<String, Vec<u8>>,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<Done, StudyError> {
    let cohort = Cohort::from_csv(text.as_bytes(), Path::new(""))?;
    let folder = Folder::in_memory(files.clone(), Box::new(Files));
    let mut study = GroupStudy::open(cohort, settings.clone(), &[], &folder, watcher)?;
    let matched = study.match_all(&folder, 1, watcher)?;
    let (study, found) = study.find(&matched, &folder, decisions, watcher)?;
    write(&study, &found, decisions, &folder, "test", watcher)?;
    Ok((study, found, folder.into_files()))
}

fn smallest(p: &[f64]) -> f64 {
    p.iter().copied().fold(1.0, f64::min)
}

#[test]
fn a_shift_of_a_structure_is_found_in_the_complex_and_in_no_structure_alone() {
    let (shapes, settings) = (shapes(3), settings(vec![Measure::NormalDisplacement, Measure::Thickness]));
    let unchanged = |_: &str, _: &str, _: &mut Facts| {};
    for structure in [FIRST, SECOND] {
        let (text, given) = (table(&[structure]), Measure::NormalDisplacement);
        let mut settings = settings.clone();
        settings.analysis.measures = vec![given];
        let TemplateChoice::Made(how) = &mut settings.template else { panic!("given") };
        how.given.retain(|name, _| name == structure);
        let files = all_records(&text, &settings, &shapes, &unchanged);
        let (_, found, _) = studied(&text, &settings, &files, &[], &Quiet).unwrap();
        let p = smallest(found.statistics.as_ref().unwrap().maps[0].p_corrected());
        assert!(p > 0.05, "{structure} alone: {p}");
    }
    let text = table(&[FIRST, SECOND]);
    let files = all_records(&text, &settings, &shapes, &unchanged);
    let (study, found, files) = studied(&text, &settings, &files, &[], &Quiet).unwrap();
    let structures = &found.complex.as_ref().unwrap().structures;
    let (first, second) = (structures[0].vertices.clone(), structures[1].vertices.clone());
    assert_eq!((first.len(), second.len(), found.members.len()), (642, 162, PERSONS));
    let statistics = found.statistics.as_ref().unwrap();
    assert_eq!(statistics.design.contrasts[0].name, "patient-control");
    let (displacement, thickness) = (&statistics.maps[0], &statistics.maps[1]);
    let (effect, p, normals) = (displacement.effect(), displacement.p_corrected(), found.mean.vertex_normals());
    // Where the normal is that of the shift, the surface of the second structure moved by it, less what the alignment takes.
    for v in second.clone().filter(|&v| normals[v].y.abs() > 0.8) {
        assert!(p[v] <= 0.01, "vertex {v}: {}", p[v]);
        let along = effect[v] / normals[v].y;
        assert!((0.5..1.2).contains(&along), "vertex {v}: {along} mm of {SHIFT_MM}");
    }
    let strongest = (0..p.len()).max_by(|&a, &b| effect[a].abs().total_cmp(&effect[b].abs())).unwrap();
    assert!(second.contains(&strongest), "vertex {strongest}");
    let significant = first.clone().filter(|&v| p[v] <= 0.05).count();
    assert!(significant < first.len() / 10, "{significant} vertices of the first structure");
    assert!(smallest(thickness.p_corrected()) > 0.05, "nothing is thinner");

    // The shift has its size within its interval, and there is no other.
    let whole = |name: &str| statistics.whole.iter().find(|of| of.variable == name).map(|of| &of.effect).unwrap();
    let shift = whole(&format!("shift of {SECOND} along y, mm"));
    assert!(shift.interval[0] < SHIFT_MM && SHIFT_MM < shift.interval[1] && shift.p < 1e-6, "{shift:?}");
    assert!(shift.interval[1] - shift.interval[0] < 0.5, "{shift:?}");
    for other in ["along x, mm", "along z, mm"] {
        let effect = whole(&format!("shift of {SECOND} {other}"));
        assert!(effect.p > 0.01, "{other}: {effect:?}");
    }
    assert!(whole(&format!("rotation of {SECOND}, degrees")).p > 0.01);
    assert!(whole(&format!("volume of {FIRST}, mm³")).value.is_finite());

    // Sizes of each structure, and their sum; the mean has both.
    let csv = String::from_utf8(files["subjects.csv"].clone()).unwrap();
    let header: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    let cell = |name: &str| {
        let at = header.iter().position(|column| *column == name).unwrap_or_else(|| panic!("no {name} in {header:?}"));
        csv.lines().nth(1).unwrap().split(',').nth(at).unwrap().to_owned()
    };
    let number = |name: &str| cell(name).parse::<f64>().unwrap();
    assert_eq!((cell("id"), number("volume_mm3")), ("p0".to_owned(), 2000.0));
    assert_eq!(number(&format!("volume_mm3.{SECOND}")), 1000.0);
    assert_eq!((number("area_mm2"), number(&format!("area_mm2.{FIRST}"))), (2.0, 1.0));
    assert!(number(&format!("shift_y_mm.{SECOND}")) > 0.0 && !header.contains(&"shift_x_mm.hippocampus"));
    assert_eq!(study.cohort.subjects.len(), PERSONS);
    let page = String::from_utf8(files["report.html"].clone()).unwrap();
    for part in
        ["Study of 40 subjects", "putamen: given", "shift of putamen along x, mm", "<p>hippocampus: 642 vertices"]
    {
        assert!(page.contains(part), "{part}");
    }

    // From its document alone: the same figures.
    let document = read_document(&files["study.json"]).unwrap();
    assert_eq!(document.cohort.subjects.len(), 2 * PERSONS);
    let folder = Folder::in_memory(files.clone(), Box::new(Files));
    let again = GroupStudy::open(document.cohort, document.settings, &document.hashes, &folder, &Quiet);
    let mut again = again.unwrap();
    let matched = again.match_all(&folder, 1, &Quiet).unwrap();
    let (study, found) = again.find(&matched, &folder, &[], &Quiet).unwrap();
    write(&study, &found, &[], &folder, "test", &Quiet).unwrap();
    same(&files, &folder.into_files());
}

fn same(a: &BTreeMap<String, Vec<u8>>, b: &BTreeMap<String, Vec<u8>>) {
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in a {
        assert!(*bytes == b[name], "{name} differs");
    }
}

/// Interrupts after a number of questions.
struct Impatient(AtomicUsize);

impl StudyObserver for Impatient {
    fn is_interrupted(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| Some(left.saturating_sub(1))) == Ok(0)
    }
}

#[test]
fn neither_the_order_of_rows_nor_an_interruption_nor_a_lost_record_changes_a_byte() {
    let (shapes, mut settings) = (shapes(5), settings(vec![Measure::LogArea]));
    settings.analysis.permutations = 20;
    let text = table(&[FIRST, SECOND]);
    let files = all_records(&text, &settings, &shapes, &|_, _, _| {});
    let (_, _, whole) = studied(&text, &settings, &files, &[], &Quiet).unwrap();
    // The rows in another order, structures apart.
    let mut rows: Vec<&str> = text.lines().skip(1).collect();
    rows.sort_by_key(|row| blake3::hash(row.as_bytes()).to_hex().to_string());
    let permuted = format!("subject,structure,file,group,age\n{}\n", rows.join("\n"));
    let (_, _, found) = studied(&permuted, &settings, &files, &[], &Quiet).unwrap();
    same(&whole, &found);
    // Interrupted at several places, then continued.
    for left in [1, 200, 1000] {
        let folder = Folder::in_memory(files.clone(), Box::new(Files));
        let run = |folder: &Folder, watcher: &dyn StudyObserver| -> Result<(), StudyError> {
            let cohort = Cohort::from_csv(text.as_bytes(), Path::new(""))?;
            let mut study = GroupStudy::open(cohort, settings.clone(), &[], folder, watcher)?;
            let matched = study.match_all(folder, 1, watcher)?;
            let (study, found) = study.find(&matched, folder, &[], watcher)?;
            write(&study, &found, &[], folder, "test", watcher)
        };
        let stopped = run(&folder, &Impatient(AtomicUsize::new(left)));
        assert!(matches!(stopped, Err(StudyError::Interrupted)), "after {left}");
        let mut left_behind = folder.into_files();
        // A record of a person that is damaged is made again.
        if let Some(name) = left_behind.keys().find(|name| name.starts_with("matches/complex/")).cloned() {
            left_behind.insert(name, b"half".to_vec());
        }
        let folder = Folder::in_memory(left_behind, Box::new(Files));
        run(&folder, &Quiet).unwrap();
        same(&whole, &folder.into_files());
    }
}

#[test]
fn a_person_without_a_structure_or_with_an_unreliable_one_is_left_out_and_the_structure_is_named() {
    let (shapes, mut settings) = (shapes(7), settings(vec![Measure::LogArea]));
    settings.analysis.permutations = 20;
    let text = table(&[FIRST, SECOND]);
    let text: String =
        text.lines().filter(|line| !line.starts_with("p4,putamen")).map(|line| format!("{line}\n")).collect();
    let changed = |person: &str, structure: &str, facts: &mut Facts| match (person, structure) {
        ("p6", SECOND) => {
            facts.reliable = Some(false);
            facts.reasons = vec!["other_handedness".to_owned()];
        }
        ("p8", FIRST) => facts.error = Some("the file is empty".to_owned()),
        ("p9", SECOND) => facts.residual_mm = 0.9,
        (_, FIRST) => facts.residual_mm = 1.0 + 0.01 * facts.volume_mm3.unwrap(),
        _ => facts.residual_mm = 0.1 + 1e-4 * facts.volume_mm3.unwrap(),
    };
    let files = all_records(&text, &settings, &shapes, &changed);
    let dropped = |id: &str| Decision { id: id.to_owned(), decision: Verdict::Dropped, reason: "motion".to_owned() };
    let decisions = [dropped("p10.putamen"), dropped("p11")];
    let (study, found, written) = studied(&text, &settings, &files, &decisions, &Quiet).unwrap();
    let of = |id: &str| {
        let k = study.cohort.subjects.iter().position(|subject| subject.id == id).unwrap();
        &found.subjects[k]
    };
    assert_eq!(found.members.len(), PERSONS - 5);
    assert_eq!((of("p4").place, of("p4").flags.as_slice()), (SubjectOutcome::Failed, &[Flag::NoMatch][..]));
    assert_eq!(of("p4").facts.error.as_deref(), Some("no structure putamen"));
    assert_eq!(of("p8").facts.error.as_deref(), Some("hippocampus: the file is empty"));
    assert_eq!(
        (of("p6").place, of("p6").facts.reasons.as_slice()),
        (SubjectOutcome::Unreliable, &["putamen: other_handedness".to_owned()][..])
    );
    assert_eq!([of("p10").place, of("p11").place], [SubjectOutcome::Dropped; 2]);
    // The residual of a small structure is compared with the same structure of the others.
    assert!(of("p9").flags.contains(&Flag::UnusualResidual), "{:?}", of("p9"));
    assert!(of("p9").facts.reasons.contains(&"putamen: unusual residual".to_owned()));
    let quality = String::from_utf8(written["quality.csv"].clone()).unwrap();
    assert!(
        quality.lines().any(|line| line.starts_with("p4,failed,no match") && line.ends_with("no structure putamen")),
        "{quality}"
    );
    let page = String::from_utf8(written["report.html"].clone()).unwrap();
    assert!(page.contains("putamen: other handedness: if it lies on the other side"));
    // A decision on the row keeps the person.
    let kept = Decision { decision: Verdict::Kept, ..dropped("p6.putamen") };
    let (_, found, _) = studied(&text, &settings, &files, &[kept], &Quiet).unwrap();
    assert_eq!(found.members.len(), PERSONS - 2);
}

#[test]
fn what_cannot_be_studied_is_refused_and_the_structure_named() {
    let (shapes, settings) = (shapes(9), settings(vec![Measure::LogArea]));
    let text = table(&[FIRST, SECOND]);
    let said = |text: &str, settings: &Settings, files: &BTreeMap<String, Vec<u8>>| {
        studied(text, settings, files, &[], &Quiet).map(|_| ()).unwrap_err().to_string()
    };
    let with = |change: &dyn Fn(&mut MadeTemplate)| {
        let mut how = MadeTemplate::default();
        change(&mut how);
        Settings { template: TemplateChoice::Made(how), ..settings.clone() }
    };
    let none = BTreeMap::new();
    let unknown = with(&|how| drop(how.given.insert("thalamus".to_owned(), "x.ply".into())));
    assert!(said(&text, &unknown, &none).contains("hippocampus, putamen"));
    let start = with(&|how| how.start = Some("p99".to_owned()));
    assert!(said(&text, &start, &none).contains("no subject p99"));
    let one = Settings { template: TemplateChoice::Given { file: "first.ply".into() }, ..settings.clone() };
    assert!(said(&text, &one, &none).contains("STRUCTURE=FILE"));
    let cycles = Settings { cycle_subjects: 3, ..settings.clone() };
    assert!(said(&text, &cycles, &none).contains("cycles"));
    // Too few matches of one structure, and too few persons with both.
    let few = all_records(&text, &settings, &shapes, &|person, structure, facts| {
        if structure == SECOND && person != "p1" {
            facts.reliable = Some(false);
        }
    });
    let error = said(&text, &settings, &few);
    assert!(error.starts_with("structure putamen: only 1 of 40 subjects"), "{error}");
    let rows: String = (0..6).map(|k| row(k, if k < 3 { FIRST } else { SECOND })).collect();
    let apart = format!("subject,structure,file,group,age\n{rows}");
    let files = all_records(&apart, &settings, &shapes, &|_, _, _| {});
    let error = said(&apart, &settings, &files);
    assert!(error.contains("only 0 of 6") && error.contains("no structure hippocampus"), "{error}");
    // A table of several is no table of one.
    let cohort = Cohort::from_csv(text.as_bytes(), Path::new("")).unwrap();
    let folder = Folder::in_memory(BTreeMap::new(), Box::new(Files));
    let error = Study::open(cohort, settings, &[], &folder, &Quiet).unwrap_err().to_string();
    assert!(error.contains("hippocampus, putamen"), "{error}");
}
