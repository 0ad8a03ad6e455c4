//! Messages about inputs as other programs write them, on all three interfaces: the printed summary, the result
//! document and the page.

use super::cli::{homolog, read_json};
use super::fixtures;
use homolog_formats::write_nifti_gz;
use homolog_mesh::volume::LabelVolume;
use nalgebra::Matrix4;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn field(name: &str) -> PathBuf {
    fixtures::folder().join("field").join(name)
}

fn matching(source: &Path, target: &Path) -> Command {
    let mut command = homolog();
    command.arg("match").args([source, target]).args(["--method", "rigid"]);
    command
}

/// The printed summary, the result document and the page of a match.
fn matched(source: &Path, target: &Path, folder: &Path) -> (String, Value, String) {
    let page = folder.join("page.html");
    let done = matching(source, target).arg("--out").arg(folder.join("out")).arg("--html").arg(&page).output().unwrap();
    assert!(done.status.success(), "{}: {}", source.display(), String::from_utf8_lossy(&done.stderr));
    let printed = String::from_utf8(done.stdout).unwrap();
    (printed, read_json(&folder.join("out/result.json")), fs::read_to_string(page).unwrap())
}

/// Asserts that the sentence is on all three interfaces, and so is the reason why the answer is not reliable.
fn check_said(source: &str, target: &str, sentence: &str, reason: Option<&str>) {
    check_said_of(&field(source), &field(target), sentence, reason);
}

fn check_said_of(source: &Path, target: &Path, sentence: &str, reason: Option<&str>) {
    let folder = tempfile::tempdir().unwrap();
    let (printed, document, page) = matched(source, target, folder.path());
    let source = source.display();
    assert!(printed.contains(sentence), "{source}: {printed}");
    assert!(document.to_string().contains(sentence), "{source}: {}", document["warnings"]);
    assert!(page.contains(sentence), "{source}: not on the page");
    let reasons: Vec<&str> =
        document["warnings"].as_array().into_iter().flatten().filter_map(|w| w["reason"].as_str()).collect();
    assert_eq!(reasons.first().copied(), reason, "{source}");
    assert_eq!(printed.starts_with("NOT RELIABLE"), reason.is_some(), "{source}: {printed}");
}

#[test]
fn dropped_pieces_coarse_voxels_and_uncertain_sides_are_reasons_everywhere() {
    check_said("n_both.nii.gz", "right_only.nii.gz", "only the largest of 2 pieces was kept", Some("piece_dropped"));
    check_said("hip1mm.nii.gz", "hip3mm.nii.gz", "the voxels leave the rotation uncertain", Some("too_coarse"));
    check_said(
        "two_sides.nii.gz",
        "two_sides.nii.gz",
        "what is left by one is right by the other",
        Some("uncertain_side"),
    );
}

#[test]
fn counts_units_and_transforms_that_were_not_taken_as_stated_are_said_everywhere() {
    check_said("count_half.stl", "reference.ply", "the header states 244 facets", None);
    check_said("count_zero.stl", "reference.ply", "the header states 0 facets", None);
    check_said("talairach.surf.gii", "reference.ply", "was not applied", None);
    check_said("micrometers.nrrd.gz", "micrometers.nrrd.gz", "its unit of length is 0.001 mm", None);
}

/// A label volume of an egg in a file of this name, with voxels of this many mm.
fn egg(folder: &Path, name: &str, voxel_mm: f64, label: impl Fn(f64, f64) -> u32) -> PathBuf {
    const N: usize = 26;
    let labels = (0..N * N * N).map(|k| {
        let [x, y, z] = [k % N, k / N % N, k / (N * N)].map(|c| c as f64 - 12.5);
        label((x / 11.0).powi(2) + (y / 8.0).powi(2) + (z / (6.0 + 0.1 * x)).powi(2), x)
    });
    let affine = Matrix4::from_diagonal(&[voxel_mm, voxel_mm, voxel_mm, 1.0].into());
    let path = folder.join(name);
    fs::write(&path, write_nifti_gz(&LabelVolume::new([N; 3], labels.collect(), affine).unwrap())).unwrap();
    path
}

#[test]
fn joined_labels_filled_cavities_and_sizes_as_of_two_units_are_reasons_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let whole = |name: &str, voxel_mm: f64| egg(folder.path(), name, voxel_mm, |r, _| u32::from(r < 1.0));
    let (one, tenfold) = (whole("one.nii.gz", 1.0), whole("tenfold.nii.gz", 10.0));
    let two = egg(folder.path(), "two.nii.gz", 1.0, |r, x| if r < 1.0 { 17 + u32::from(x > 3.0) } else { 0 });
    let hollow = egg(folder.path(), "hollow.nii.gz", 1.0, |r, _| u32::from(r < 1.0 && r > 0.4));
    check_said_of(&two, &one, "(17, 18)", Some("labels_joined"));
    check_said_of(&hollow, &one, "1 cavity with", Some("cavity_filled"));
    check_said_of(&one, &tenfold, "one of them may be in", Some("units_differ"));
}

#[test]
fn nothing_is_lost_or_shifted_where_nothing_is_said() {
    for (name, n_voxels) in [("byte_skip.nrrd.gz", 3752.0), ("plate1.nii.gz", 375.0)] {
        let done = homolog().args(["inspect", "--json"]).arg(field(name)).output().unwrap();
        let report: Value = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(report["volume"]["labels"][0]["n_voxels"], n_voxels, "{name}");
        let volume = report["repaired_topology"]["volume_mm3"].as_f64().unwrap();
        assert!((volume / n_voxels - 1.0).abs() < 0.02, "{name}: {volume}");
        assert_eq!(report["warnings"], Value::Null, "{name}");
    }
}

#[test]
fn an_image_is_refused_and_the_parameter_that_takes_it_is_named() {
    let done = matching(&field("t1_like_uint8.nii.gz"), &field("hip1mm.nii.gz")).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("looks like an image") && said.contains("image_is_labels"), "{said}");
}
