//! Several structures of each person, on both sides, from their files on disk: templates, matches, joint maps and everything
//! that is written, with an interruption.

use super::study::contents;
use homolog_contract::input::BodySide;
use homolog_contract::parameters::{LabelChoice, Method, preset};
use homolog_formats::ply::write_ply;
use homolog_formats::{FileContent, ReadLimits};
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::Findings;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::output::{read_document, write};
use homolog_study::plan::Study;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::structures::GroupStudy;
use nalgebra::{Isometry3, Point3, Vector3};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

const PERSONS: usize = 3;
const MIRROR: [[f64; 4]; 4] = [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

struct Quiet;
impl StudyObserver for Quiet {}

/// Asks to stop after some matches.
struct Impatient(AtomicUsize);

impl StudyObserver for Impatient {
    fn progress(&self, what: &str, done: usize, _: usize) {
        if done > 0 && (what.contains("matching") || what.contains("template")) {
            let _ = self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| Some(left.saturating_sub(1)));
        }
    }
    fn is_interrupted(&self) -> bool {
        self.0.load(Ordering::Relaxed) == 0
    }
}

/// A tapered, bent and twisted body, so that neither another pose nor a mirror image fits; persons differ a little.
fn body(radii: Vector3<f64>, k: usize) -> SurfaceMesh {
    let mesh = ellipsoid(radii, 2);
    let [long, bend] = [(k * 7 % 5) as f64 / 5.0 - 0.4, (k * 3 % 7) as f64 / 7.0 - 0.4];
    let unit = 12.0 / radii.x;
    let shape = mesh.vertices().iter().map(|p| {
        let (x, taper, twist) = (p.x * unit, 1.0 + 0.03 * p.x * unit, 0.04 * p.x * unit);
        let (y, z) = (taper * (p.y * twist.cos() - p.z * twist.sin()), taper * (p.y * twist.sin() + p.z * twist.cos()));
        Point3::new(p.x * (1.0 + 0.1 * long), y + 0.012 * (1.0 + bend) * x * x / unit, z)
    });
    mesh.with_vertices(shape.collect()).unwrap()
}

/// A structure of a person on a side. Right ones are the mirror image, in another pose.
fn structure(name: &str, side: &str, k: usize) -> SurfaceMesh {
    let left = match name {
        "amygdala" => body(Vector3::new(6.0, 4.0, 2.5), k + 1).transformed(&Isometry3::translation(4.0, 13.0, 2.0)),
        _ => body(Vector3::new(12.0, 6.0, 4.0), k),
    };
    if side == "left" {
        return left;
    }
    let motion = Isometry3::new(Vector3::new(30.0, -4.0, 2.0), Vector3::new(0.3, -0.2 * k as f64, 0.5));
    left.moved(&MIRROR).unwrap().transformed(&motion)
}

const NAMES: [&str; 2] = ["amygdala", "hippocampus"];
const SIDES: [&str; 2] = ["left", "right"];

fn cohort(folder: &Path) -> Cohort {
    let mut text = "subject,side,structure,file\n".to_owned();
    for k in 0..PERSONS {
        for (side, name) in SIDES.into_iter().flat_map(|side| NAMES.map(|name| (side, name))) {
            let file = format!("{k}-{side}-{name}.ply");
            std::fs::write(folder.join(&file), write_ply(&structure(name, side, k))).unwrap();
            text.push_str(&format!("p{k},{side},{name},{file}\n"));
        }
    }
    Cohort::from_csv(text.as_bytes(), folder).unwrap()
}

fn settings(correspondence: Correspondence) -> Settings {
    let made =
        MadeTemplate { start: Some("p1_left".to_owned()), subjects: 4, max_rounds: 1, ..MadeTemplate::default() };
    Settings {
        template: TemplateChoice::Made(made),
        template_side: None,
        size: Size::Kept,
        correspondence,
        visits: Visits::GroupTemplate,
        rivals: Rivals::Decide,
        analysis: Analysis {
            effect: Some("side".to_owned()),
            measures: vec![Measure::NormalDisplacement],
            permutations: 20,
            ..Analysis::default()
        },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Balanced),
    }
}

fn computed(
    cohort: Cohort,
    settings: Settings,
    out: &Path,
    watcher: &dyn StudyObserver,
) -> Result<(Study, Findings), StudyError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    pool.install(|| {
        let folder = Folder::create(out)?;
        let mut study = GroupStudy::open(cohort, settings, &[], &folder, watcher)?;
        let matched = study.match_all(&folder, 2, watcher)?;
        let (study, found) = study.find(&matched, &folder, &[], watcher)?;
        write(&study, &found, &[], &folder, "test", watcher)?;
        Ok((study, found))
    })
}

#[test]
fn both_structures_of_a_side_are_mirrored_together_and_an_interrupted_study_ends_with_the_same_bytes() {
    let place = tempfile::tempdir().unwrap();
    let (out, again) = (place.path().join("out"), place.path().join("again"));
    let cohort = cohort(place.path());
    let joint = settings(Correspondence::Joint);
    let (study, found) = computed(cohort.clone(), joint.clone(), &out, &Quiet).unwrap();
    assert_eq!(
        study.settings.template_side,
        Some(BodySide::Left),
        "that of the person that the templates are made from"
    );
    let ids: Vec<&str> = study.cohort.subjects.iter().map(|person| person.id.as_str()).collect();
    assert_eq!(ids, ["p0_left", "p0_right", "p1_left", "p1_right", "p2_left", "p2_right"]);
    let reasons: Vec<_> = found.subjects.iter().map(|subject| &subject.facts.reasons).collect();
    assert_eq!(found.members.len(), 2 * PERSONS, "{reasons:?}");
    let structures = &found.complex.as_ref().unwrap().structures;
    assert!(
        structures.iter().all(|of| of.joint.as_ref().is_some_and(|joint| joint.subjects == 6) && of.rounds.len() == 1)
    );
    // Right is the mirror image of left, so that neither shapes nor relative poses of a person's sides differ.
    for persons in found.subjects.chunks(2) {
        let [left, right] = [0, 1].map(|k| persons[k].structures[1].pose.unwrap());
        let apart = (Vector3::from(left.shift_mm) - Vector3::from(right.shift_mm)).norm();
        assert!(apart < 0.4 && (left.rotation_degrees - right.rotation_degrees).abs() < 4.0, "{left:?} {right:?}");
    }
    let statistics = found.statistics.as_ref().unwrap();
    assert_eq!(statistics.pairs.as_ref().map(|of| of.pairs.len()), Some(PERSONS), "two sides of one person");
    // Everything written for a person lies on the person's own files, and looks outwards there.
    for (id, (k, side)) in ids.iter().zip((0..PERSONS).flat_map(|k| SIDES.map(|side| (k, side)))) {
        let bytes = std::fs::read(out.join(format!("subjects/{id}.surf.gii"))).unwrap();
        let FileContent::Mesh(bent) = homolog_formats::read(&bytes, None, &ReadLimits::default()).unwrap().content
        else {
            panic!("no mesh")
        };
        for of in structures {
            let (bent, own) = (of.of(&bent.mesh).unwrap(), structure(&of.name, side, k));
            let index = ClosestPointIndex::new(&own);
            let apart = bent.vertices().iter().map(|p| (index.closest(p).point - p).norm()).fold(0.0, f64::max);
            assert!(apart < 0.3 && bent.signed_volume() > 0.0, "{id}, {}: {apart} mm", of.name);
        }
    }
    let files = contents(&out);
    for name in
        ["template/amygdala/kept.json", "template/hippocampus/template.ply", "matches/joint/amygdala/group.json"]
    {
        assert!(files.contains_key(name), "{name}");
    }
    assert_eq!(files.keys().filter(|name| name.starts_with("matches/complex/")).count(), 6);

    // Killed after each of some matches, and continued.
    for matches in [1, 3, 6, 9] {
        let stopped = computed(cohort.clone(), joint.clone(), &again, &Impatient(AtomicUsize::new(matches)));
        assert!(matches!(stopped, Err(StudyError::Interrupted)), "after {matches}");
    }
    computed(cohort, joint, &again, &Quiet).unwrap();
    let same = |files: &BTreeMap<String, Vec<u8>>, other: &Path| {
        let other = contents(other);
        assert_eq!(files.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
        files.iter().for_each(|(name, bytes)| assert!(*bytes == other[name], "{name} differs"));
    };
    same(&files, &again);
    // From its document alone, elsewhere.
    let document = read_document(&files["study.json"]).unwrap();
    let elsewhere = place.path().join("elsewhere");
    computed(document.cohort, document.settings, &elsewhere, &Quiet).unwrap();
    same(&files, &elsewhere);
}

/// A volume of two bodies, of labels 1 and 2, whose sizes differ between persons.
fn two_bodies(k: usize) -> Vec<u8> {
    let n = 40;
    let [first, second] = [1.0 + 0.03 * k as f64, 1.0 - 0.03 * k as f64];
    let label = |at: usize| {
        let p = Point3::new((at % n) as f64, (at / n % n) as f64, (at / (n * n)) as f64);
        let is_in = |center: Point3<f64>, radii: Vector3<f64>| {
            // Tapered, bent and twisted, as the bodies above.
            let x = (p.x - center.x) * 12.0 / radii.x;
            let (taper, twist) = (1.0 + 0.03 * x, 0.04 * x);
            let (y, z) = ((p.y - center.y - 0.001 * radii.x * x * x) / taper, (p.z - center.z) / taper);
            let (y, z) = (y * twist.cos() + z * twist.sin(), z * twist.cos() - y * twist.sin());
            (x / 12.0).powi(2) + (y / radii.y).powi(2) + (z / radii.z).powi(2) < 1.0
        };
        let large = is_in(Point3::new(16.0, 10.0, 18.0), first * Vector3::new(12.0, 6.0, 4.0));
        match (large, is_in(Point3::new(20.0, 28.0, 22.0), second * Vector3::new(9.0, 5.0, 4.0))) {
            (true, _) => 1,
            (_, true) => 2,
            _ => 0,
        }
    };
    let labels = (0..n * n * n).map(label).collect();
    let volume = homolog_mesh::volume::LabelVolume::new([n; 3], labels, nalgebra::Matrix4::identity()).unwrap();
    homolog_formats::nifti::write_nifti_gz(&volume)
}

#[test]
fn structures_of_one_volume_are_told_apart_by_their_labels() {
    let place = tempfile::tempdir().unwrap();
    let mut text = "subject,structure,file,label\n".to_owned();
    for k in 0..4 {
        std::fs::write(place.path().join(format!("{k}.nii.gz")), two_bodies(k)).unwrap();
        text.push_str(&format!("p{k},large,{k}.nii.gz,1\np{k},small,{k}.nii.gz,2\n"));
    }
    let cohort = Cohort::from_csv(text.as_bytes(), place.path()).unwrap();
    assert_eq!(cohort.subjects[1].labels, Some(vec![LabelChoice::Number(2)]));
    let mut settings = settings(Correspondence::Joint);
    settings.analysis.effect = None;
    let made = MadeTemplate { subjects: 3, max_rounds: 1, ..MadeTemplate::default() };
    settings.template = TemplateChoice::Made(made);
    let (study, found) = computed(cohort, settings, &place.path().join("out"), &Quiet).unwrap();
    for (person, subject) in study.cohort.subjects.iter().zip(&found.subjects) {
        let [large, small] = [0, 1].map(|at| &subject.structures[at].facts);
        let whole = subject.facts.volume_mm3.unwrap();
        let sum = large.volume_mm3.unwrap() + small.volume_mm3.unwrap();
        assert!((whole - sum).abs() < 1e-9 && large.volume_mm3 > small.volume_mm3, "{}", person.id);
        // The joint maps stay on the surface of the labels of the row.
        assert!(large.residual_mm < 0.6 && small.residual_mm < 0.6, "{}: {large:?} {small:?}", person.id);
    }
}
