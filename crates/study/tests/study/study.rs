//! A whole study of small surfaces: what it finds, what it writes, and that nothing depends on threads or is done twice.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes::ellipsoid;
use homolog_run::page::escaped;
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::{Decision, Folder, Verdict};
use homolog_study::matching::StudyObserver;
use homolog_study::output::{read_document, write};
use homolog_study::plan::Study;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::subjects::{Flag, SubjectOutcome};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Surfaces that are bent and long in different degrees; those of patients are thinner on top.
fn subject(k: usize, patient: bool) -> Vec<u8> {
    let mesh = ellipsoid(Vector3::new(12.0, 6.0, 4.0), 2);
    let [long, bend] = [(k * 7 % 5) as f64 / 5.0 - 0.4, (k * 3 % 7) as f64 / 7.0 - 0.4];
    let shape = mesh.vertices().iter().map(|p| {
        let dent = if patient && p.z > 0.0 { 0.8 * (-(p.x * p.x + p.y * p.y) / 20.0).exp() } else { 0.0 };
        // Tapered, bent and twisted, so that no other pose and no mirror image fits.
        let (taper, twist) = (1.0 + 0.03 * p.x, 0.04 * p.x);
        let (y, z) = (taper * (p.y * twist.cos() - p.z * twist.sin()), taper * (p.y * twist.sin() + p.z * twist.cos()));
        Point3::new(p.x * (1.0 + 0.1 * long), y + 0.012 * (1.0 + bend) * p.x * p.x, z - dent)
    });
    write_ply(&mesh.with_vertices(shape.collect()).unwrap())
}

/// A table of `n` subjects, every other a patient.
fn table(folder: &Path, n: usize) -> PathBuf {
    let mut text = "id,file,group,age\n".to_owned();
    for k in 0..n {
        std::fs::write(folder.join(format!("s{k}.ply")), subject(k, k % 2 == 0)).unwrap();
        text.push_str(&format!("s{k},s{k}.ply,{},{}\n", ["patient", "control"][k % 2], 60 + k * 5 % 11));
    }
    let table = folder.join("table.csv");
    std::fs::write(&table, text).unwrap();
    table
}

fn settings() -> Settings {
    Settings {
        template: TemplateChoice::Made(MadeTemplate { subjects: 4, max_rounds: 2, ..MadeTemplate::default() }),
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis {
            effect: Some("group".to_owned()),
            adjust: vec!["age".to_owned()],
            measures: vec![Measure::NormalDisplacement, Measure::Thickness],
            permutations: 200,
            ..Analysis::default()
        },
        cycle_subjects: 3,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Balanced),
    }
}

struct Quiet;
impl StudyObserver for Quiet {}

/// Asks to stop after some matches.
struct Impatient {
    left: AtomicUsize,
}

impl StudyObserver for Impatient {
    fn progress(&self, _: &str, done: usize, _: usize) {
        if done > 0 {
            let _ = self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| Some(left.saturating_sub(1)));
        }
    }
    fn is_interrupted(&self) -> bool {
        self.left.load(Ordering::Relaxed) == 0
    }
}

fn computed(
    table: &Path,
    out: &Path,
    threads: usize,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<(Study, Findings), StudyError> {
    let text = std::fs::read(table).unwrap();
    let cohort = Cohort::from_csv(&text, table.parent().unwrap())?;
    again(cohort, settings(), out, threads, decisions, watcher)
}

fn again(
    cohort: Cohort,
    settings: Settings,
    out: &Path,
    threads: usize,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<(Study, Findings), StudyError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let folder = Folder::create(out)?;
        let mut study = Study::open(cohort, settings, &[], &folder, watcher)?;
        let matched = study.match_all(&folder, threads, watcher)?;
        let found = find(&study, &matched, &folder, decisions, watcher)?;
        write(&study, &found, decisions, &folder, "test", watcher)?;
        Ok((study, found))
    })
}

/// Every file of a folder and its bytes.
pub(super) fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(at) = folders.pop() {
        for entry in std::fs::read_dir(at).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_str().unwrap().to_owned();
                files.insert(name, std::fs::read(path).unwrap());
            }
        }
    }
    files
}

fn same(a: &Path, b: &Path) {
    let (a, b) = (contents(a), contents(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in &a {
        assert!(*bytes == b[name], "{name} differs");
    }
}

fn records(out: &Path) -> BTreeMap<String, std::time::SystemTime> {
    let files = std::fs::read_dir(out.join("matches")).unwrap().map(|entry| entry.unwrap());
    let one = |entry: std::fs::DirEntry| {
        (entry.file_name().into_string().unwrap(), entry.metadata().unwrap().modified().unwrap())
    };
    files.map(one).collect()
}

#[test]
fn a_study_finds_the_effect_and_is_the_same_whatever_happens_to_it() {
    let place = tempfile::tempdir().unwrap();
    let table_of_ten = table(place.path(), 10);
    let out = place.path().join("out");
    let (study, found) = computed(&table_of_ten, &out, 2, &[], &Quiet).unwrap();

    // The dent: patients are thinner on top, nobody elsewhere.
    let statistics = found.statistics.as_ref().unwrap();
    assert_eq!(statistics.design.contrasts[0].name, "patient-control");
    let map = statistics.maps.iter().find(|map| map.measure == Measure::NormalDisplacement).unwrap();
    let mean = found.mean.vertices();
    let top = (0..mean.len()).max_by(|&a, &b| {
        let height = |v: usize| mean[v].z - 0.1 * (mean[v].x.powi(2) + mean[v].y.powi(2));
        height(a).total_cmp(&height(b))
    });
    let effect = map.effect()[top.unwrap()];
    assert!((-0.85..-0.4).contains(&effect), "{effect} at the dent of 0.8 mm");
    assert!(map.p_corrected()[top.unwrap()] < 0.05);
    // Alignment moves the whole shape a little towards the dent, and no more.
    let below = (0..mean.len()).filter(|&v| mean[v].z < -1.0).map(|v| map.effect()[v].abs()).fold(0.0, f64::max);
    assert!(below < 0.35, "{below} below");
    assert_eq!(found.members.len(), 10);
    assert!(found.consistency.as_ref().unwrap().template_and_back.mean_mm < 1.0);

    // Everything is there.
    let files = contents(&out);
    for name in [
        "study.json",
        "report.html",
        "subjects.csv",
        "subjects.parquet",
        "model.csv",
        "quality.csv",
        "effects.csv",
        "figures/model.svg",
        "figures/effects.svg",
        "mean.surf.gii",
        "template/template.ply",
        "modes/mode-1-plus-2sd.vtk",
        "subjects/s3.surf.gii",
        "maps/thickness.patient-control.shape.gii",
        "decisions.csv",
    ] {
        assert!(files.contains_key(name), "{name}");
    }
    let page = String::from_utf8(files["report.html"].clone()).unwrap();
    for reference in ["http://", "https://", "src=", "href=", "style=", "url(", "@import", "onclick="] {
        assert!(!page.contains(reference), "{reference}");
    }
    // Ten subjects and three columns; residuals also differ by age, so more than the 252 splits are possible.
    assert!(page.contains("10 subjects, 3 columns") && page.contains("7 degrees of freedom"));
    assert!(page.contains("no corrected p is below 0.0050") && !page.contains("252 ways"));
    let members = page.split_once("Subjects of the model").unwrap().1.split_once("</table>").unwrap().0;
    for cell in ["<th scope=\"col\">group patient</th>", "<td>group</td>", "control 5, patient 5", "volume, mm³", " ± "]
    {
        assert!(members.contains(cell), "{cell} in {members}");
    }
    assert!(page.contains("class=\"bar\""), "a color bar");
    // One name for a contrast, on the page as in the tables and the names of files; what it compares is said once.
    assert!(page.contains("<td>patient-control</td><td>patient minus control, group</td>"));
    assert!(
        page.contains("patient-control: ") && page.matches("patient minus control").count() == 2,
        "and in the methods"
    );
    assert!(page.contains("Benjamini, Y.") && page.contains("Smith, S. M., Nichols") && !page.contains("Patterson"));
    for name in ["figures/model.svg", "figures/effects.svg"] {
        let svg = String::from_utf8(files[name].clone()).unwrap();
        assert!(
            svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=") && svg.trim_end().ends_with("</svg>")
        );
        assert_eq!(svg.matches("<text").count(), svg.matches("</text>").count());
    }
    // As a word: the numbers of surfaces are in base64, where these letters can stand beside others.
    assert!(!page.split(|c: char| !c.is_ascii_alphanumeric() && c != '+').any(|word| word == "NaN"));

    // One thread, interrupted again and again: the same bytes.
    let other = place.path().join("other");
    let mut stops = 0;
    loop {
        match computed(&table_of_ten, &other, 1, &[], &Impatient { left: AtomicUsize::new(4) }) {
            Err(StudyError::Interrupted) => stops += 1,
            Ok(_) => break,
            Err(error) => panic!("{error}"),
        }
        if stops > 3 {
            computed(&table_of_ten, &other, 1, &[], &Quiet).unwrap();
            break;
        }
    }
    assert!(stops > 2, "{stops}");
    same(&out, &other);

    // From study.json alone: the same again, but for the folder.
    let document = read_document(&files["study.json"]).unwrap();
    let third = place.path().join("third");
    again(document.cohort, document.settings, &third, 2, &document.decisions, &Quiet).unwrap();
    same(&out, &third);

    // A decision needs no match, and nothing is matched twice.
    let before = records(&out);
    let dropped = [Decision { id: "s4".to_owned(), decision: Verdict::Dropped, reason: "motion".to_owned() }];
    let (_, found) = computed(&table_of_ten, &out, 2, &dropped, &Quiet).unwrap();
    assert_eq!((found.members.len(), found.subjects[4].place), (9, SubjectOutcome::Dropped));
    assert!(found.subjects[4].distance.is_some(), "it is still compared with the model");
    assert_eq!(records(&out), before);

    // One subject more: one match more.
    let table_of_eleven = table(place.path(), 11);
    let (_, found) = computed(&table_of_eleven, &out, 2, &[], &Quiet).unwrap();
    assert_eq!(found.members.len(), 11);
    let after = records(&out);
    assert_eq!(after.len(), before.len() + 1);
    assert!(before.iter().all(|(name, time)| after[name] == *time));

    // A file that changed under a recorded study is noticed.
    std::fs::write(place.path().join("s2.ply"), subject(9, false)).unwrap();
    let folder = Folder::create(&place.path().join("fourth")).unwrap();
    let opened = Study::open(study.cohort.clone(), study.settings.clone(), &study.hashes, &folder, &Quiet);
    assert!(matches!(opened, Err(StudyError::Changed { path }) if path.ends_with("s2.ply")));
}

#[test]
fn a_subject_without_a_surface_is_listed_first_and_a_scored_one_enters_no_model() {
    let place = tempfile::tempdir().unwrap();
    table(place.path(), 6);
    std::fs::write(place.path().join("broken.ply"), "ply, but no more").unwrap();
    let mut text = "id,file,role,subject,years\n".to_owned();
    (0..6).for_each(|k| {
        text.push_str(&format!("s{k},s{k}.ply,{},p{},{}\n", if k == 5 { "score" } else { "" }, k / 2, k % 3))
    });
    text.push_str("broken,broken.ply,,x,0\n");
    let cohort = Cohort::from_csv(text.as_bytes(), place.path()).unwrap();
    let measures = vec![Measure::LogArea];
    let analysis = Analysis { effect: Some("years".to_owned()), measures, ..Analysis::default() };
    let settings = Settings { analysis, cycle_subjects: 0, ..settings() };
    let out = place.path().join("out");
    let (_, found) = again(cohort, settings, &out, 2, &[], &Quiet).unwrap();
    assert_eq!(found.members, [0, 1, 2, 3, 4]);
    assert_eq!(found.subjects[5].place, SubjectOutcome::Scored);
    assert!(found.subjects[5].unusual_p.is_some_and(|p| p > 0.0) && !found.subjects[5].scores.is_empty());
    assert_eq!(found.subjects[6].flags, [Flag::NoMatch]);
    // Two visits each of p0 and p1: a mixed model.
    let statistics = found.statistics.as_ref().unwrap();
    assert!(statistics.longitudinal && statistics.maps[0].mixed.is_some() && statistics.whole.is_empty());
    assert!(std::fs::metadata(out.join("maps/log_area.years.shape.gii")).is_ok());
    let listed = std::fs::read_to_string(out.join("quality.csv")).unwrap();
    assert!(listed.lines().nth(1).unwrap().starts_with("broken,failed,no match"), "{listed}");
}

#[test]
fn a_study_without_a_model_says_why() {
    let place = tempfile::tempdir().unwrap();
    let table = table(place.path(), 3);
    let text = std::fs::read(&table).unwrap();
    let cohort = Cohort::from_csv(&text, place.path()).unwrap();
    let made = MadeTemplate { subjects: 3, max_rounds: 1, ..MadeTemplate::default() };
    let (template, analysis) = (TemplateChoice::Made(made), Analysis::default());
    let settings = Settings { template, analysis, cycle_subjects: 0, ..settings() };
    let dropped = [Decision { id: "s1".to_owned(), decision: Verdict::Dropped, reason: "motion".to_owned() }];
    let error = again(cohort, settings, &place.path().join("out"), 2, &dropped, &Quiet).unwrap_err().to_string();
    assert!(error.contains("only 2 of 3 subjects") && error.contains("1 are left out by a decision"), "{error}");
}

/// A text that ends a script, and opens another page where it is read as HTML.
const MARKUP: &str = "</script><meta/http-equiv=refresh/content=0;url=about:blank>";

/// Texts that a spreadsheet would compute.
const FORMULAS: [&str; 6] = ["=HYPERLINK(\"//x\")", "+1", "-x", "@SUM(A1)", "\u{ff1d}1", "=1"];

/// A study in which every text that a user can set has markup or is a formula; the folder of its results.
fn study_with_odd_texts(place: &Path) -> (PathBuf, Findings) {
    table(place, 6);
    let mut text = format!("id,file,subject,group{MARKUP},=note\n");
    for k in 0..6 {
        let file = format!("s{k}<svg onload=x>&amp;.ply");
        std::fs::rename(place.join(format!("s{k}.ply")), place.join(&file)).unwrap();
        let (group, note) = (["patient", "control"][k % 2], FORMULAS[k].replace('"', "\"\""));
        text.push_str(&format!("s{k},{file},p{k}{MARKUP},{group}{MARKUP},\"{note}\"\n"));
    }
    std::fs::write(place.join("broken<svg onload=x>.ply"), "ply, but no more").unwrap();
    text.push_str(&format!("broken,broken<svg onload=x>.ply,,control{MARKUP},\n"));
    let cohort = Cohort::from_csv(text.as_bytes(), place).unwrap();
    let name = format!("group{MARKUP}");
    let sum = format!("{name}:patient{MARKUP}");
    let analysis = Analysis {
        effect: Some(name.clone()),
        reference: vec![(name, format!("control{MARKUP}"))],
        contrasts: vec![(format!("contrast {MARKUP}"), sum)],
        measures: vec![Measure::LogArea],
        permutations: 20,
        ..Analysis::default()
    };
    let made = MadeTemplate { start: Some("s0".to_owned()), subjects: 3, max_rounds: 1, ..MadeTemplate::default() };
    let settings = Settings { template: TemplateChoice::Made(made), analysis, cycle_subjects: 0, ..settings() };
    let kept = |id: &str, reason: String| Decision { id: id.to_owned(), decision: Verdict::Kept, reason };
    let decisions = [kept("s1", format!("seen {MARKUP}\u{2028}")), kept("s2", FORMULAS[0].to_owned())];
    let out = place.join("out");
    let (_, found) = again(cohort, settings, &out, 2, &decisions, &Quiet).unwrap();
    (out, found)
}

#[test]
fn texts_of_users_are_no_formulas_of_the_tables() {
    let place = tempfile::tempdir().unwrap();
    let (out, _) = study_with_odd_texts(place.path());
    let mut seen = String::new();
    for table in ["subjects.csv", "quality.csv", "effects.csv", "model.csv", "decisions.csv"] {
        let bytes = std::fs::read(out.join(table)).unwrap();
        let mut rows = csv::ReaderBuilder::new().has_headers(false).from_reader(bytes.as_slice());
        for row in rows.records().map(Result::unwrap) {
            for cell in &row {
                let is_number = cell.parse::<f64>().is_ok();
                assert!(is_number || !cell.starts_with(['=', '+', '-', '@', '\t', '\u{ff1d}']), "{table}: {cell}");
                seen.push_str(&format!("{cell}\n"));
            }
        }
    }
    let formulas = FORMULAS.iter().chain(&["=note"]);
    formulas.for_each(|formula| assert!(seen.contains(&format!("'{formula}\n")), "{formula} is there as text"));
    assert_eq!(seen.matches(FORMULAS[0]).count(), 2, "the note, and the reason in quality.csv");
}

#[test]
fn texts_of_users_are_no_markup_of_the_report() {
    let place = tempfile::tempdir().unwrap();
    let (out, found) = study_with_odd_texts(place.path());
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    // Its own data and script; nothing that was written by a user begins an element.
    assert_eq!(page.matches("</script").count(), 2);
    assert!(!page.contains("<meta/") && !page.contains("<svg onload"));
    assert_eq!(page.matches("<meta ").count(), 4, "its own");
    // The texts are there, and the data are what they were.
    let (_, rest) = page.split_once("id=\"data\">").unwrap();
    let data: serde_json::Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    let contrasts = &found.statistics.as_ref().unwrap().design.contrasts;
    assert_eq!(contrasts.len(), 2);
    for (map, contrast) in data["maps"].as_array().unwrap().iter().zip(contrasts) {
        assert!(map["legend"].as_str().unwrap().starts_with(&contrast.name));
        assert!(contrast.meaning.contains(MARKUP) && page.contains(&escaped(&contrast.meaning)));
    }
    assert!(page.contains("decided: seen &lt;/script&gt;&lt;meta/http-equiv"), "the reason of the decision");
}

mod reports {
    use super::*;

    #[test]
    #[ignore = "needs Chromium"]
    fn chromium_stays_on_a_report_whose_texts_are_markup() {
        let place = tempfile::tempdir().unwrap();
        let (out, _) = study_with_odd_texts(place.path());
        let mut browser = std::process::Command::new("chromium");
        browser.args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=3000", "--dump-dom"]);
        browser.arg(format!("--user-data-dir={}", place.path().join("profile").display()));
        let shown = browser.arg(format!("file://{}", out.join("report.html").display())).output().unwrap();
        let shown = String::from_utf8_lossy(&shown.stdout);
        assert!(shown.contains("<h1>Study of 7 subjects</h1>"), "another page: {shown}");
        assert!(!shown.contains("<meta http-equiv=\"refresh\"") && !shown.contains("<svg onload"));
    }
}

#[test]
fn a_template_from_another_start_is_nearly_the_same() {
    let place = tempfile::tempdir().unwrap();
    let table = table(place.path(), 6);
    let text = std::fs::read(&table).unwrap();
    let mean = |start: &str| {
        let cohort = Cohort::from_csv(&text, place.path()).unwrap();
        let made =
            MadeTemplate { start: Some(start.to_owned()), subjects: 0, max_rounds: 4, ..MadeTemplate::default() };
        let settings = Settings {
            template: TemplateChoice::Made(made),
            analysis: Analysis::default(),
            cycle_subjects: 0,
            ..settings()
        };
        let (_, found) = again(cohort, settings, &place.path().join(start), 2, &[], &Quiet).unwrap();
        let rounds = &found.matched.making.rounds;
        assert!(rounds.last().unwrap().moved_share < 0.1, "{rounds:?}");
        found.mean
    };
    let (a, b) = (mean("s0"), mean("s3"));
    let starts = [0, 3].map(|k| {
        let bytes = subject(k, k % 2 == 0);
        homolog_formats::ply::read_ply(&bytes, &homolog_formats::ReadLimits::default()).unwrap().mesh
    });
    let (means, subjects) = (apart(&a, &b), apart(&starts[0], &starts[1]));
    let edge = a.mean_edge_length();
    assert!(means < 0.15 * edge && means < subjects / 4.0, "means {means} mm, subjects {subjects} mm, edges {edge} mm");
}

/// Mean distance of two surfaces, mm, the first moved onto the second by closest points.
fn apart(a: &homolog_mesh::SurfaceMesh, b: &homolog_mesh::SurfaceMesh) -> f64 {
    use homolog_registration::{ProcrustesOptions, procrustes};
    let index = homolog_mesh::ClosestPointIndex::new(b);
    let mut moved = a.vertices().to_vec();
    for _ in 0..100 {
        let images: Vec<_> = moved.iter().map(|p| index.closest(p).point).collect();
        let onto = procrustes(&moved, &images, None, &ProcrustesOptions::default()).unwrap().target_from_source;
        moved.iter_mut().for_each(|p| *p = onto.apply(p));
    }
    moved.iter().map(|p| (index.closest(p).point - p).norm()).sum::<f64>() / moved.len() as f64
}
