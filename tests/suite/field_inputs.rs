//! What is said of inputs as other programs write them, on all three interfaces: the printed summary, the result document and the
//! page.

use super::cli::{homolog, read_json};
use super::fixtures;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

fn field(name: &str) -> std::path::PathBuf {
    fixtures::folder().join("field").join(name)
}

fn matching(source: &str, target: &str) -> Command {
    let mut command = homolog();
    command.arg("match").args([field(source), field(target)]).args(["--method", "rigid"]);
    command
}

/// The printed summary, the result document and the page of a match.
fn matched(source: &str, target: &str, folder: &Path) -> (String, Value, String) {
    let page = folder.join("page.html");
    let done = matching(source, target).arg("--out").arg(folder.join("out")).arg("--html").arg(&page).output().unwrap();
    assert!(done.status.success(), "{source}: {}", String::from_utf8_lossy(&done.stderr));
    let printed = String::from_utf8(done.stdout).unwrap();
    (printed, read_json(&folder.join("out/result.json")), fs::read_to_string(page).unwrap())
}

/// The sentence is on all three interfaces, and so is the reason, by which the answer is not reliable.
fn check_said(source: &str, target: &str, sentence: &str, reason: Option<&str>) {
    let folder = tempfile::tempdir().unwrap();
    let (printed, document, page) = matched(source, target, folder.path());
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
    let done = matching("t1_like_uint8.nii.gz", "hip1mm.nii.gz").output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("looks like an image") && said.contains("image_is_labels"), "{said}");
}
