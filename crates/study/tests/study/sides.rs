//! Left and right in one study: subjects of the other side than the template are mirrored, and what is written for them is not.

use homolog_contract::input::BodySide;
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_formats::{FileContent, ReadLimits};
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::output::{read_document, write};
use homolog_study::plan::Study;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use nalgebra::{Isometry3, Point3, Vector3};
use std::path::Path;

const PEOPLE: usize = 4;
const MIRROR: [[f64; 4]; 4] = [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

struct Quiet;
impl StudyObserver for Quiet {}

/// The left structure of a person: tapered, bent and twisted, so that no mirror image fits. With `dent`, thinner on top.
fn left(k: usize, dent: f64) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(12.0, 6.0, 4.0), 2);
    let [long, bend] = [(k * 7 % 5) as f64 / 5.0 - 0.4, (k * 3 % 7) as f64 / 7.0 - 0.4];
    let shape = mesh.vertices().iter().map(|p| {
        let dent = if p.z > 0.0 { dent * (-(p.x * p.x + p.y * p.y) / 20.0).exp() } else { 0.0 };
        let (taper, twist) = (1.0 + 0.03 * p.x, 0.04 * p.x);
        let (y, z) = (taper * (p.y * twist.cos() - p.z * twist.sin()), taper * (p.y * twist.sin() + p.z * twist.cos()));
        Point3::new(p.x * (1.0 + 0.1 * long), y + 0.012 * (1.0 + bend) * p.x * p.x, z - dent)
    });
    mesh.with_vertices(shape.collect()).unwrap()
}

/// The right one: the mirror image, in another pose, with a dent that the left one has not.
fn right(k: usize) -> SurfaceMesh {
    let motion = Isometry3::new(Vector3::new(30.0, -4.0, 2.0), Vector3::new(0.3, -0.2 * k as f64, 0.5));
    left(k, 0.8).moved(&MIRROR).unwrap().transformed(&motion)
}

/// The table of both structures of everybody; the files are beside it.
fn table(folder: &Path, with_sides: bool) -> Cohort {
    let mut text = if with_sides { "id,file,subject,side\n" } else { "id,file,subject,hand\n" }.to_owned();
    for k in 0..PEOPLE {
        std::fs::write(folder.join(format!("l{k}.ply")), write_ply(&left(k, 0.0))).unwrap();
        std::fs::write(folder.join(format!("r{k}.ply")), write_ply(&right(k))).unwrap();
        text.push_str(&format!("l{k},l{k}.ply,p{k},left\nr{k},r{k}.ply,p{k},right\n"));
    }
    Cohort::from_csv(text.as_bytes(), folder).unwrap()
}

fn settings(effect: &str) -> Settings {
    let made = MadeTemplate { start: Some("l1".to_owned()), subjects: 4, max_rounds: 1, ..MadeTemplate::default() };
    Settings {
        template: TemplateChoice::Made(made),
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis {
            effect: Some(effect.to_owned()),
            measures: vec![Measure::NormalDisplacement],
            permutations: 20,
            ..Analysis::default()
        },
        cycle_subjects: 3,
        cycle_ring: ["l0", "r1", "l2"].map(str::to_owned).to_vec(),
        parameters: preset(Method::Balanced),
    }
}

fn computed(cohort: Cohort, settings: Settings, out: &Path) -> Result<(Study, Findings), StudyError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    pool.install(|| {
        let folder = Folder::create(out)?;
        let mut study = Study::open(cohort, settings, &[], &folder, &Quiet)?;
        let matched = study.match_all(&folder, 2, &Quiet)?;
        let found = find(&study, &matched, &folder, &[], &Quiet)?;
        write(&study, &found, &[], &folder, "test", &Quiet)?;
        Ok((study, found))
    })
}

#[test]
fn an_asymmetry_is_found_where_it_is_and_every_file_stays_in_its_subjects_coordinates() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join("out");
    let (study, found) = computed(table(place.path(), true), settings("side"), &out).unwrap();
    assert_eq!(study.settings.template_side, Some(BodySide::Left), "that of the subject that it is made from");
    assert_eq!(found.members.len(), 2 * PEOPLE);
    let (reliable, reasons): (Vec<_>, Vec<_>) =
        found.subjects.iter().map(|subject| (subject.facts.reliable, &subject.facts.reasons)).unzip();
    assert!(reliable.iter().all(|reliable| *reliable == Some(true)), "{reasons:?}");

    // Right against left: thinner at the dent on top, and nearly nowhere else.
    let statistics = found.statistics.as_ref().unwrap();
    assert_eq!(statistics.pairs.as_ref().map(|of| of.pairs.len()), Some(PEOPLE), "two structures of one person");
    assert!(!statistics.longitudinal && statistics.degrees == (PEOPLE - 1) as f64);
    assert_eq!(statistics.design.contrasts[0].name, "right-left");
    let (effect, mean) = (statistics.maps[0].effect(), found.mean.vertices());
    let height = |v: &usize| mean[*v].z - 0.1 * (mean[*v].x.powi(2) + mean[*v].y.powi(2));
    let top = (0..mean.len()).max_by(|a, b| height(a).total_cmp(&height(b))).unwrap();
    assert!((-0.85..-0.4).contains(&effect[top]), "{} at the dent of 0.8 mm", effect[top]);
    let below = (0..mean.len()).filter(|&v| mean[v].z < -1.0).map(|v| effect[v].abs()).fold(0.0, f64::max);
    assert!(below < 0.35, "{below} below");
    // The ring goes from left to right and back.
    let cycles = found.consistency.as_ref().unwrap();
    assert!(cycles.template_and_back.mean_mm < 1.0 && cycles.pair_and_back.mean_mm < 1.0, "{cycles:?}");

    // The bent template lies on the subject's own file, and looks outwards there.
    for k in 0..PEOPLE {
        for (name, own) in [(format!("l{k}"), left(k, 0.0)), (format!("r{k}"), right(k))] {
            let bytes = std::fs::read(out.join(format!("subjects/{name}.surf.gii"))).unwrap();
            let read = homolog_formats::read(&bytes, None, &ReadLimits::default()).unwrap();
            let FileContent::Mesh(bent) = read.content else { panic!("no mesh") };
            let index = ClosestPointIndex::new(&own);
            let apart = bent.mesh.vertices().iter().map(|p| (index.closest(p).point - p).norm()).fold(0.0, f64::max);
            assert!(apart < 0.01, "{name}: {apart} mm");
            assert!(bent.mesh.signed_volume() > 0.0, "{name}");
        }
    }

    // The report counts people, not rows, and has no column that is empty for visits.
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(
        page.contains("<h1>Study of 8 surfaces of 4 subjects</h1>") && page.contains("<p>8 surfaces of 4 subjects, ")
    );
    assert!(
        page.contains("<strong>Few sign flips are possible:</strong>")
            && page.contains("Differences within 4 subjects")
    );
    assert!(page.contains("g there") && !page.contains("<td></td><td>0"), "empty cells");
    let members = page.split_once("Subjects of the model").unwrap().1.split_once("</table>").unwrap().0;
    assert!(members.contains("<td>subjects</td><td class=\"number\">4</td><td class=\"number\">4</td>"), "{members}");
    assert!(members.contains("<td>surfaces</td><td class=\"number\">8</td><td class=\"number\">4</td>"), "{members}");

    // From its document alone: the same statistics.
    let document = read_document(&std::fs::read(out.join("study.json")).unwrap()).unwrap();
    let (_, again) = computed(document.cohort, document.settings, &place.path().join("again")).unwrap();
    assert_eq!(again.statistics.unwrap().maps[0].effect(), effect);
}

#[test]
fn a_side_that_is_not_stated_is_noticed_and_the_report_names_the_column() {
    let place = tempfile::tempdir().unwrap();
    let settings = Settings { cycle_subjects: 0, cycle_ring: Vec::new(), ..settings("hand") };
    let out = place.path().join("out");
    let made = MadeTemplate { start: Some("l1".to_owned()), ..MadeTemplate::default() };
    let made = MadeTemplate { from: ["l0", "l1", "l2", "l3"].map(str::to_owned).to_vec(), max_rounds: 1, ..made };
    let (_, found) =
        computed(table(place.path(), false), Settings { template: TemplateChoice::Made(made), ..settings }, &out)
            .unwrap();
    let doubted = found.subjects.iter().filter(|s| s.facts.reasons.iter().any(|reason| reason == "other_handedness"));
    assert!(doubted.count() >= PEOPLE - 1);
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(
        page.contains("other handedness: if it lies on the other side than the template, state its side (column side)")
    );
}

#[test]
fn what_contradicts_itself_is_refused_before_the_first_match() {
    let place = tempfile::tempdir().unwrap();
    let cohort = table(place.path(), true);
    let said = |cohort: &Cohort, settings: Settings| {
        let out = place.path().join("out");
        let folder = Folder::create(&out).unwrap();
        Study::open(cohort.clone(), settings, &[], &folder, &Quiet).unwrap_err().to_string()
    };
    let given = TemplateChoice::Given { file: place.path().join("l0.ply") };
    let text = said(&cohort, Settings { template: given.clone(), ..settings("side") });
    assert!(text.contains("--template-side left or right") && text.contains("template_side"), "{text}");
    let mut mirrored = settings("side");
    mirrored.parameters.input.target.mirror = true;
    let text = said(&cohort, mirrored);
    assert!(text.contains("input.target.mirror") && text.contains("side of each subject"), "{text}");
    let without = table(place.path(), false);
    let text = said(&without, Settings { template_side: Some(BodySide::Left), ..settings("hand") });
    assert!(text.contains("no subject has"), "{text}");
}
