//! `homolog phantom` writes the documented files, equal for equal seeds.

use crate::cli::{homolog, read_json};
use std::fs;

#[test]
fn a_surface_pair_has_its_ground_truth() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a");
    let arguments = ["phantom", "--kind", "surface", "--subject", "3", "--deform", "0.04", "--rotate-seed", "5"];
    let done = homolog().args(arguments).args(["--permute", "8", "--out"]).arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let truth = read_json(&out.join("truth.json"));
    assert_eq!(truth["one_subject"], true);
    assert_eq!(truth["deformation"]["rms_share"], 0.04);
    assert_eq!(truth["permute_seed"], 8);
    let source = fs::read(out.join("source.ply")).unwrap();
    assert!(source.starts_with(b"ply\n"));
    let n_vertices: usize = String::from_utf8_lossy(&source)
        .lines()
        .find_map(|l| l.strip_prefix("element vertex "))
        .and_then(|n| n.trim().parse().ok())
        .unwrap();
    let table = fs::read_to_string(out.join("truth.csv")).unwrap();
    assert_eq!(table.lines().count(), n_vertices + 1);
    let mut images: Vec<usize> = table.lines().skip(1).map(|l| l.split(',').nth(1).unwrap().parse().unwrap()).collect();
    images.sort_unstable();
    assert!(images.iter().copied().eq(0..n_vertices), "the truth is a permutation");
}

#[test]
fn the_same_seeds_write_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str| {
        let out = folder.path().join(name);
        let done =
            homolog().args(["phantom", "--rotate-seed", "2", "--spacing", "1.5", "--out"]).arg(&out).output().unwrap();
        assert!(done.status.success());
        ["source.nii.gz", "target.nii.gz", "truth.json", "truth.csv"].map(|f| fs::read(out.join(f)).unwrap())
    };
    assert_eq!(write("a"), write("b"));
}

#[test]
fn two_subjects_have_no_point_to_point_ground_truth() {
    let folder = tempfile::tempdir().unwrap();
    let done = homolog()
        .args(["phantom", "--kind", "surface", "--edge", "2", "--target-subject", "9", "--out"])
        .arg(folder.path())
        .output()
        .unwrap();
    assert!(done.status.success());
    assert!(!folder.path().join("truth.csv").exists());
    assert_eq!(read_json(&folder.path().join("truth.json"))["correspondence"], serde_json::Value::Null);
}

#[test]
fn sizes_out_of_range_are_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [
        ["--spacing", "0"],
        ["--spacing", "NaN"],
        ["--deform", "0.9"],
        ["--kind=surface", "--edge=40"],
        ["--kind=volume", "--permute"],
    ] {
        let done = homolog().arg("phantom").args(arguments).arg("--out").arg(folder.path()).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{arguments:?}");
        assert!(!done.stderr.is_empty());
    }
}
