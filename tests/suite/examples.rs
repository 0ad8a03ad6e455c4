//! The numbered examples of `examples/` run as docs/rust.md says, on a pair and a group of phantoms.

use super::cli::homolog;
use super::faults::site::{Backend, Site};
use super::studies::cohort;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// An example, which cargo builds beside the program.
fn example(name: &str) -> Command {
    let folder = Path::new(env!("CARGO_BIN_EXE_homolog")).with_file_name("examples");
    Command::new(folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX)))
}

/// What an example prints.
fn said(mut command: Command) -> String {
    let done = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(done.status.success(), "{command:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// Two label volumes of one phantom, of which the second is bent and rotated.
fn pair(folder: &Path) -> [PathBuf; 2] {
    let more = ["--subject", "1", "--target-subject", "1", "--deform", "0.04", "--rotate-seed", "7"];
    let made = homolog().arg("phantom").args(more).arg("--out").arg(folder.join("pair")).output().unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    ["source", "target"].map(|side| folder.join(format!("pair/{side}.nii.gz")))
}

#[test]
fn every_example_is_listed_and_numbered() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/rust.md")).unwrap();
    let mut names: Vec<String> = fs::read_dir(root.join("examples"))
        .unwrap()
        .map(|entry| entry.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    for (k, name) in names.iter().enumerate() {
        assert!(name.starts_with(&format!("{:02}_", k + 1)), "{name} is not number {}", k + 1);
        assert!(page.contains(&format!("[{name}](../examples/{name}.rs)")), "docs/rust.md does not list {name}");
    }
    assert_eq!(names.len(), 5);
}

#[test]
fn examples_of_a_pair_say_the_verdict_the_energy_and_the_labels() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(folder.path());
    let run = |name: &str, more: &[&Path]| {
        let mut command = example(name);
        command.arg(&source).arg(&target).args(more);
        said(command)
    };
    let printed = run("01_match_two_files", &[]);
    assert!(printed.starts_with("reliable: Some(true)") && printed.contains("target from source"), "{printed}");

    let printed = run("02_follow_the_energy", &[]);
    let last =
        |text: &str| printed.lines().rfind(|line| line.contains(text)).unwrap().rsplit(": ").next().unwrap().to_owned();
    let chosen = last("the energy of the result");
    assert_eq!(chosen.split(',').next().unwrap(), last("energy of the result: "), "{printed}");
    assert!(printed.contains("phase inference") && printed.contains("FieldEnergy"), "{printed}");

    let carried = folder.path().join("carried.nii.gz");
    let printed = run("03_displacement_to_labels", &[&carried]);
    let dices: Vec<f64> = printed.lines().map(|line| line.rsplit(' ').next().unwrap().parse().unwrap()).collect();
    assert!(dices.len() == 2 && dices.iter().all(|dice| *dice > 0.9), "{printed}");
    let inspected = homolog().arg("inspect").arg(&carried).output().unwrap();
    assert!(inspected.status.success(), "{}", String::from_utf8_lossy(&inspected.stderr));
}

#[test]
fn the_example_of_a_study_writes_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let (table, out) = (cohort(folder.path(), 6), folder.path().join("out"));
    let mut command = example("04_study");
    command.arg(table).arg("group").arg(&out);
    let printed = said(command);
    assert!(printed.contains("of 6 subjects are in the shape model"), "{printed}");
    assert!(out.join("report.html").exists() && out.join("study.json").exists());
}

#[tokio::test]
async fn the_example_of_a_client_follows_a_job() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(folder.path());
    let site = Site::open(Backend::Sqlite);
    let program = site.program(&["--auth", "none"]);
    let run = |files: [PathBuf; 2]| {
        let mut command = example("05_client");
        command.arg(&program.base).args(files);
        command
    };
    let (right, wrong) = (run([source.clone(), target]), run([source, folder.path().join("pair/truth.json")]));
    let printed = tokio::task::spawn_blocking(|| said(right)).await.unwrap();
    assert!(
        printed.starts_with("\"succeeded\", reliable: true") && printed.contains("target from source"),
        "{printed}"
    );
    let mut wrong = wrong;
    let refused = tokio::task::spawn_blocking(move || wrong.output().unwrap()).await.unwrap();
    assert!(!refused.status.success());
}
