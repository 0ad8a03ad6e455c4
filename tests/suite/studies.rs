//! `homolog study`: killed and continued, computed again from its document, and messages about wrong tables.

use super::cli::{homolog, read_json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::time::{Duration, Instant};

/// Writes small surfaces of different phantoms, and their table.
pub(super) fn cohort(folder: &Path, n: usize) -> PathBuf {
    let mut text = "id,file,group\n".to_owned();
    for k in 0..n {
        let made = homolog()
            .args(["phantom", "--kind", "surface", "--edge", "3", "--rotate-seed", "4"])
            .args(["--subject", &(k + 1).to_string(), "--out"])
            .arg(folder.join(format!("p{k}")))
            .output()
            .unwrap();
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        text.push_str(&format!("s{k},p{k}/source.ply,{}\n", ["a", "b"][k % 2]));
    }
    let table = folder.join("table.csv");
    fs::write(&table, text).unwrap();
    table
}

pub(super) const OPTIONS: [&str; 10] = [
    "--effect",
    "group",
    "--permutations",
    "50",
    "--template-subjects",
    "3",
    "--template-rounds",
    "2",
    "--threads",
    "2",
];

pub(super) fn study(table: &Path, out: &Path) -> Output {
    homolog().arg("study").arg(table).args(OPTIONS).arg("--out").arg(out).output().unwrap()
}

pub(super) fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let (mut files, mut folders) = (BTreeMap::new(), vec![folder.to_owned()]);
    while let Some(at) = folders.pop() {
        for entry in fs::read_dir(at).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                files.insert(path.strip_prefix(folder).unwrap().to_owned(), fs::read(path).unwrap());
            }
        }
    }
    files
}

/// The code block of a language after a heading of docs/studies.md.
fn block(heading: &str, language: &str) -> String {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/studies.md")).unwrap();
    let section = page.split_once(&format!("\n{heading}\n")).unwrap().1.split("\n## ").next().unwrap().to_owned();
    let block = section.split_once(&format!("```{language}\n")).unwrap().1;
    block.split_once("```").unwrap().0.to_owned()
}

/// The example of docs/studies.md as written. Label volumes of phantoms, each with its mirror image as the right side.
#[test]
fn the_study_of_asymmetry_in_the_documentation_does_what_it_says() {
    let place = tempfile::tempdir().unwrap();
    let table = block("## Left against right", "csv");
    fs::create_dir(place.path().join("scans")).unwrap();
    fs::write(place.path().join("sides.csv"), &table).unwrap();
    let mut written = 0;
    for row in table.lines().skip(1) {
        let [_, file, person, side] = row.split(',').collect::<Vec<_>>().try_into().unwrap();
        let folder = place.path().join(person);
        if !folder.exists() {
            let number = person.trim_start_matches(|c: char| !c.is_ascii_digit() || c == '0');
            let made =
                homolog().args(["phantom", "--spacing", "2", "--subject", number, "--out"]).arg(&folder).output();
            assert!(made.unwrap().status.success());
        }
        let bytes = fs::read(folder.join("source.nii.gz")).unwrap();
        let read = homolog_formats::read(&bytes, None, &homolog_formats::ReadLimits::default()).unwrap();
        let homolog_formats::FileContent::Labels(volume) = read.content else { panic!("no volume") };
        let mut to_ras = *volume.affine();
        if side == "right" {
            to_ras.row_mut(0).scale_mut(-1.0);
        }
        let mirrored = homolog_mesh::volume::LabelVolume::new(volume.dims(), volume.labels().to_vec(), to_ras).unwrap();
        fs::write(place.path().join(file), homolog_formats::write_nifti_gz(&mirrored)).unwrap();
        written += 1;
    }
    assert_eq!(written, 8);
    let command = block("## Left against right", "sh");
    let words: Vec<&str> = command.split_whitespace().collect();
    let done = homolog().current_dir(place.path()).args(&words[1..]).output().unwrap();
    assert!(words[0] == "homolog" && done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let document = read_json(&place.path().join("asymmetry/study.json"));
    assert_eq!(document["settings"]["template_side"], "left");
    assert_eq!(document["found"]["subjects"]["model"], 8, "{}", document["found"]);
    let maps = contents(&place.path().join("asymmetry/maps"));
    assert!(
        maps.keys().any(|name| name.to_string_lossy() == "normal_displacement.right-left.vtk"),
        "{:?}",
        maps.keys()
    );
    // Mirror images have no asymmetry.
    let said = String::from_utf8(done.stdout).unwrap();
    let smallest = said.lines().filter(|line| line.contains("right-left") && line.contains("normal_displacement"));
    let q: Vec<f64> = smallest.map(|line| line.rsplit(' ').next().unwrap().parse().unwrap()).collect();
    assert!(q.len() == 1 && q[0] > 0.05, "{said}");
    // A missing side of the template is reported at once.
    let given = ["study", "sides.csv", "--out", "other", "--template", "scans/s01-left.nii.gz"];
    let refused = homolog().current_dir(place.path()).args(given).output().unwrap();
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(2) && said.contains("--template-side left or right"), "{said}");
}

fn n_records(out: &Path) -> usize {
    let entries = fs::read_dir(out.join("matches")).into_iter().flatten().flatten();
    entries.filter(|entry| entry.path().extension().is_some_and(|ending| ending == "match")).count()
}

#[test]
fn a_study_that_is_killed_goes_on_and_ends_with_the_same_bytes() {
    let place = tempfile::tempdir().unwrap();
    let table = cohort(place.path(), 6);
    let [whole, killed, again] = ["whole", "killed", "again"].map(|name| place.path().join(name));
    let done = study(&table, &whole);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));

    let mut kills = 0;
    while kills < 10 {
        let before = n_records(&killed);
        let mut run = homolog();
        run.arg("study").arg(&table).args(OPTIONS).arg("--out").arg(&killed);
        let mut process = run.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // Killed once one more match is stored, or while the outputs after the matches are being written.
        let begun = Instant::now();
        let ended = loop {
            if let Some(status) = process.try_wait().unwrap() {
                break Some(status);
            }
            if n_records(&killed) > before || begun.elapsed() > Duration::from_secs(60) {
                break None;
            }
            std::thread::sleep(Duration::from_millis(2));
        };
        if let Some(status) = ended {
            assert!(status.success());
            break;
        }
        process.kill().unwrap();
        process.wait().unwrap();
        kills += 1;
        assert!(n_records(&killed) >= before, "a finished match was lost");
    }
    assert!(kills >= 5, "{kills} times");
    let done = study(&table, &killed);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let (a, b) = (contents(&whole), contents(&killed));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in &a {
        assert!(*bytes == b[name], "{} differs", name.display());
    }

    // From its document, in another folder.
    let done = homolog().arg("study").arg(whole.join("study.json")).arg("--out").arg(&again).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(contents(&again) == a);
    assert_eq!(read_json(&again.join("study.json"))["found"]["subjects"]["model"], 6);
}

#[test]
fn a_study_in_which_a_subject_failed_is_written_and_exits_with_1() {
    let place = tempfile::tempdir().unwrap();
    let table = cohort(place.path(), 4);
    let rows = fs::read_to_string(&table).unwrap();
    fs::write(&table, format!("{rows}broken,broken.ply,a\n")).unwrap();
    fs::write(place.path().join("broken.ply"), "ply, but no more").unwrap();
    let out = place.path().join("out");
    let done = homolog().arg("study").arg(&table).args(["--template-rounds", "1", "--out"]).arg(&out).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.contains("1 of 5 subjects have no match; quality.csv says why"), "{said}");
    assert!(fs::read_to_string(out.join("quality.csv")).unwrap().contains("broken,failed"));
    assert!(out.join("report.html").exists() && out.join("study.json").exists());
}

#[test]
fn a_wrong_table_or_covariate_is_said_before_the_first_match() {
    let place = tempfile::tempdir().unwrap();
    let said = |text: &str, options: &[&str]| {
        let table = place.path().join("table.csv");
        fs::write(&table, text).unwrap();
        let out = place.path().join("out");
        let done = homolog().arg("study").arg(&table).args(options).arg("--out").arg(&out).output().unwrap();
        assert_eq!(done.status.code(), Some(2));
        assert_eq!(n_records(&out), 0);
        String::from_utf8(done.stderr).unwrap()
    };
    for name in ["a.ply", "b.ply", "c.ply", "d.ply", "e.ply"] {
        fs::write(place.path().join(name), "ply").unwrap();
    }
    let rows = "a,a.ply,x\nb,b.ply,y\nc,c.ply,x\nd,d.ply,y\ne,e.ply,x\n";
    let text = said(&format!("id,file,group\n{rows}a,a.ply,x\n"), &[]);
    assert!(text.contains("line 7") && text.contains("same id"), "{text}");
    let text = said(&format!("id,file,group\n{rows}"), &["--effect", "grup"]);
    assert!(text.contains("no covariate grup") && text.contains("group"), "{text}");
    let text = said(&format!("id,file,group\n{rows}"), &["--effect", "group", "--reference", "group=z"]);
    assert!(text.contains("no level z") && text.contains("x, y"), "{text}");
    let text = said("id,file\na,a.ply\nb,missing.ply\nc,c.ply\n", &[]);
    assert!(text.contains("missing.ply"), "{text}");
}
