//! Every output of the service and of the command line, opened by programs of its users: NumPy, nibabel, VTK, meshio,
//! trimesh, pyarrow, ITK. `scripts/setup campaigns` creates their Python environment.

use super::clients::{root, said};
use super::faults::site::{Backend, Site};
use super::representations::{PARTS, bytes, matched_with};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The Python of the environment.
fn python() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("target/readers-env/bin/python")
}

/// Asserts that the script accepts the files of a folder; fails with its message.
fn assert_accepted(folder: &Path) {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/readers/check.py");
    let done = Command::new(python()).arg(script).arg(folder).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{}", said.lines().rev().take(12).collect::<Vec<_>>().join("\n"));
}

#[tokio::test]
#[ignore = "needs the Python environment that scripts/setup campaigns makes"]
async fn every_format_of_the_service_is_read_as_written() {
    for surface in ["voxel", "smooth"] {
        let parameters = json!({"input": {"surface": surface}, "both_directions": true});
        let (service, job) = matched_with(parameters).await;
        let folder = tempfile::tempdir().unwrap();
        let write = async |path: &str, name: &str| {
            std::fs::write(folder.path().join(name), bytes(&service, &format!("{job}/{path}")).await).unwrap();
        };
        for (part, formats) in PARTS {
            for (format, _, _) in formats.iter().filter(|(format, _, _)| !["html", "dicom"].contains(format)) {
                write(&format!("{part}?format={format}"), &format!("{}.{format}", part.replace('/', "-"))).await;
                if part == "correspondences" || part == "warped" {
                    write(&format!("{part}?format={format}&direction=inverse"), &format!("{part}-inverse.{format}"))
                        .await;
                }
            }
        }
        service.end().await;
        assert_accepted(folder.path());
        // The script detects a wrong number.
        let table = folder.path().join("warped.csv");
        let text = std::fs::read_to_string(&table).unwrap().replacen(",0.", ",0.5", 1);
        std::fs::write(&table, text).unwrap();
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/readers/check.py");
        let done = Command::new(python()).arg(script).arg(folder.path()).output().unwrap();
        assert!(!done.status.success());
    }
}

/// The module for 3D Slicer without its window: sends surfaces to the service, and turns answers into VTK objects.
#[tokio::test]
#[ignore = "needs the Python environment that scripts/setup campaigns makes"]
async fn the_module_for_slicer_matches_surfaces() {
    let site = Site::open(Backend::Sqlite);
    let program = site.program(&["--log", "error"]);
    let mut run = Command::new(python());
    run.args(["-W", "ignore"]).arg(root().join("clients/slicer/test_matching.py")).arg(&program.base);
    assert!(said(run).await.contains("all of it"));
}

#[test]
#[ignore = "needs the Python environment that scripts/setup campaigns makes"]
fn every_file_of_the_command_line_is_read_as_written() {
    let folder = tempfile::tempdir().unwrap();
    let homolog = || Command::new(env!("CARGO_BIN_EXE_homolog"));
    let pair = folder.path().join("pair");
    assert!(
        homolog()
            .args(["phantom", "--kind", "surface", "--edge", "2", "--rotate-seed", "7", "--out"])
            .arg(&pair)
            .status()
            .unwrap()
            .success()
    );
    let out = folder.path().join("out");
    let mut command = homolog();
    command.arg("match").args([pair.join("source.ply"), pair.join("target.ply")]);
    let done = command.args(["--set", "both_directions=true", "--out"]).arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert_accepted(&out);
}

#[test]
#[ignore = "needs the Python environment that scripts/setup campaigns makes"]
fn every_file_of_a_study_is_read_as_written() {
    let place = tempfile::tempdir().unwrap();
    let table = super::studies::cohort(place.path(), 6);
    let out = place.path().join("out");
    let done = super::studies::study(&table, &out);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let check = || {
        let script = root().join("tests/readers/check_study.py");
        Command::new(python()).arg(script).arg(&out).output().unwrap()
    };
    let done = check();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    // The script detects a wrong number.
    let table = out.join("subjects.csv");
    let text = std::fs::read_to_string(&table).unwrap().replacen(",0.", ",0.5", 1);
    std::fs::write(&table, text).unwrap();
    assert!(!check().status.success());
}
