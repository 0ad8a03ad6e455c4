//! Labels by number and by name on the command line, their display by `inspect`, and a left structure matched with a
//! right one.

use super::cli::{homolog, read_json};
use homolog_formats::{FileContent, ReadLimits, read, write_nifti_gz};
use homolog_mesh::volume::LabelVolume;
use std::fs;
use std::path::Path;

/// A volume with numbers that only FreeSurfer uses: a left hippocampus (17), its mirror image as the right one (53),
/// and a sheet of corpus callosum (251).
fn brain(folder: &Path) {
    let made = homolog().args(["phantom", "--spacing", "2", "--subject", "3", "--out"]).arg(folder.join("p")).output();
    assert!(made.unwrap().status.success());
    let bytes = fs::read(folder.join("p/source.nii.gz")).unwrap();
    let FileContent::Labels(volume) = read(&bytes, None, &ReadLimits::default()).unwrap().content else {
        panic!("no volume")
    };
    let [nx, ny, nz] = volume.dims();
    let wide = 2 * nx + 2;
    let mut labels = vec![0; wide * ny * nz];
    for (k, &label) in volume.labels().iter().enumerate() {
        let (x, row) = (k % nx, k / nx);
        if label > 0 {
            labels[row * wide + x] = 17;
            labels[row * wide + wide - 1 - x] = 53;
        }
    }
    for row in 0..ny * nz {
        labels[row * wide + nx] = 251;
    }
    let brain = LabelVolume::new([wide, ny, nz], labels, *volume.affine()).unwrap();
    fs::write(folder.join("aseg.nii.gz"), write_nifti_gz(&brain)).unwrap();
}

/// Exit code, standard output and standard error in this folder.
fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let done = homolog().current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code(), text(done.stdout), text(done.stderr))
}

#[test]
fn inspect_is_a_table_that_fits_a_screen() {
    let folder = tempfile::tempdir().unwrap();
    brain(folder.path());
    let (code, shown, _) = run(folder.path(), &["inspect", "aseg.nii.gz"]);
    assert_eq!(code, Some(0));
    assert!(shown.lines().count() <= 24, "{shown}");
    let table: Vec<&str> = shown.lines().filter(|line| line.trim_start().starts_with(char::is_numeric)).collect();
    assert!(table.iter().all(|line| line.chars().count() <= 80), "{shown}");
    let cells: Vec<Vec<&str>> = table.iter().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(cells.iter().map(|row| row[0]).collect::<Vec<_>>(), ["17", "53", "251"], "{shown}");
    assert_eq!((cells[0][1], cells[1][1]), ("Left-Hippocampus", "Right-Hippocampus"));
    // Voxels of 8 mm³; one piece.
    let (voxels, volume): (f64, f64) = (cells[0][2].parse().unwrap(), cells[0][3].parse().unwrap());
    assert!((volume - 8.0 * voxels).abs() < 0.1 && cells[0][4] == "1", "{shown}");
    let header = shown.lines().find(|line| line.contains("tunnels")).unwrap();
    assert_eq!(
        header.split_whitespace().collect::<Vec<_>>(),
        ["label", "name", "voxels", "volume,", "mm³", "pieces", "tunnels"]
    );
    assert!(shown.contains("--label chooses some, by number or name") && !shown.contains("input.labels"), "{shown}");
    // The JSON has every part, in the terms of a request.
    let (_, json, _) = run(folder.path(), &["inspect", "aseg.nii.gz", "--json"]);
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(report["volume"]["labels"][0]["name"], "Left-Hippocampus");
    assert!(report["warnings"][0]["detail"].as_str().unwrap().contains("17 Left-Hippocampus"), "{report}");
    assert!(json.contains("input.labels chooses some"), "{json}");
}

#[test]
fn labels_are_chosen_by_name_and_refusals_repeat_the_name_with_the_nearest_ones() {
    let folder = tempfile::tempdir().unwrap();
    brain(folder.path());
    let matched = |label: &str| {
        run(folder.path(), &["match", "aseg.nii.gz", "aseg.nii.gz", "--label", label, "--method", "rigid"])
    };
    let (code, by_name, _) = matched("hippocampus-left");
    assert_eq!(code, Some(0));
    let note = "note on the source: \"hippocampus-left\" was taken for label 17 by the table of FreeSurfer";
    assert!(by_name.contains(note), "{by_name}");
    let vertices = |text: &str| text.lines().find(|line| line.starts_with("vertices")).unwrap().to_owned();
    assert_eq!(vertices(&by_name), vertices(&matched("17").1));
    let (code, _, said) = matched("hipocampus-left");
    assert_eq!(code, Some(2));
    assert!(said.contains("\"hipocampus-left\"") && said.contains("Left-Hippocampus (17 in FreeSurfer)"), "{said}");
    let (code, _, said) = matched("99");
    assert_eq!(code, Some(2));
    assert!(
        said.contains("17 Left-Hippocampus") && said.contains("--label N") && !said.contains("input.labels"),
        "{said}"
    );

    // The names in a file beside the volume take precedence.
    fs::write(folder.path().join("aseg.ctbl"), "# Color table file\n53 the_other_one 220 216 20 255\n").unwrap();
    let (code, shown, said) = matched("the other one");
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(vertices(&shown), vertices(&matched("53").1));
    assert!(said.contains("label 53 by") && said.contains("aseg.ctbl"), "{said}");
    let (_, shown, _) = run(folder.path(), &["inspect", "aseg.nii.gz"]);
    assert!(shown.contains("the_other_one"), "{shown}");
}

#[test]
fn left_against_right_names_the_step_and_is_right_with_it() {
    let folder = tempfile::tempdir().unwrap();
    brain(folder.path());
    let sides = ["match", "aseg.nii.gz", "aseg.nii.gz", "--source-label", "17", "--target-label", "53"];
    let (code, shown, _) = run(folder.path(), &[&sides[..], &["--html", "plain.html"]].concat());
    assert_eq!(code, Some(0));
    assert!(shown.starts_with("NOT RELIABLE") && shown.contains("--mirror source"), "{shown}");
    let page = fs::read_to_string(folder.path().join("plain.html")).unwrap();
    assert!(page.contains("--mirror source") && page.contains("input.source.mirror: true"));
    let more = ["--mirror", "source", "--out", "out", "--html", "mirrored.html"];
    let (code, shown, said) = run(folder.path(), &[&sides[..], &more].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(shown.starts_with("RELIABLE") && shown.contains("\nmirrored          yes"), "{shown}");
    assert!(shown.contains("note on the source: it was mirrored from left to right"), "{shown}");
    let result = read_json(&folder.path().join("out/result.json"));
    assert_eq!(result["transform"]["mirrored"], true);
    assert_eq!(result["transform"]["reflection"][0][0], -1.0);
    assert!(
        result["surface_distance"]["mean_mm"].as_f64().unwrap() < 0.05,
        "mirror images: {}",
        result["surface_distance"]
    );
    assert!(fs::read_to_string(folder.path().join("mirrored.html")).unwrap().contains("mirrored"));
    // With several targets, the reasons are explained below the table.
    let several = ["match", "aseg.nii.gz", "aseg.nii.gz", "p/source.nii.gz", "--source-label", "17"];
    let (_, shown, _) = run(folder.path(), &[&several[..], &["--set", "input.target.labels=53"]].concat());
    assert!(shown.contains("FAILED"), "the phantom has no label 53: {shown}");
    assert!(shown.contains("other_handedness: ") && shown.contains("--mirror source"), "{shown}");
}
