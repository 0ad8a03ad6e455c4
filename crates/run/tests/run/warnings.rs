//! Nothing vanishes, is joined or is too coarse in silence: thin parts, dropped pieces, joined labels, filled cavities, large
//! voxels and images, each in the report on the input, in the result document, in the verdict and on the page.

use crate::fixtures::fixture;
use homolog_contract::input::InputWarning;
use homolog_contract::parameters::{InputParameters, LabelChoice, MatchParameters, Method, Repair, preset, resolve};
use homolog_contract::result::{ResultDocument, UnreliableReason};
use homolog_formats::write_nifti;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::topology::analyze;
use homolog_mesh::volume::LabelVolume;
use homolog_primitives::observe::Silent;
use homolog_run::intake::{IntakeError, IntakeLimits, PreparedSurface, inspect, prepare_surface};
use homolog_run::{InputFile, ReportInputs, run_match, write_report};
use nalgebra::{Matrix4, Point3, Rotation3};
use proptest::prelude::*;
use serde_json::json;

fn defaults() -> InputParameters {
    preset(Method::Balanced).input
}

fn prepare(bytes: &[u8], parameters: &InputParameters) -> Result<PreparedSurface, IntakeError> {
    prepare_surface(bytes, None, parameters, &IntakeLimits::default())
}

fn field(name: &str) -> Vec<u8> {
    fixture(&format!("field/{name}"))
}

fn labels(numbers: &[u32]) -> InputParameters {
    let labels = Some(numbers.iter().copied().map(LabelChoice::Number).collect());
    InputParameters { labels, ..defaults() }
}

fn reasons(warnings: &[InputWarning]) -> Vec<UnreliableReason> {
    warnings.iter().filter_map(|warning| warning.reason).collect()
}

/// The result and its page.
fn matched(source: &[u8], target: &[u8], parameters: &MatchParameters) -> (ResultDocument, String) {
    let [source, target] = [source, target].map(|bytes| InputFile { bytes, name: None });
    let output = run_match(source, target, parameters, &IntakeLimits::default(), &Silent).unwrap();
    let inputs = ReportInputs {
        document: &output.document,
        correspondences: output.document.correspondences.as_ref().unwrap(),
        source: &output.source,
        target: &output.target,
        trace: &[],
    };
    let page = write_report(&inputs).unwrap();
    (output.document, page)
}

/// The reason is in the document, in the verdict and on the page, and the answer is not reliable.
fn check_doubted(source: &[u8], target: &[u8], request: serde_json::Value, reason: UnreliableReason) {
    let (document, page) = matched(source, target, &resolve(&request).unwrap());
    let verdict = document.verdict();
    assert_eq!(verdict.reliable, Some(false), "{reason:?}: {verdict:?}");
    assert!(verdict.reasons.contains(&reason), "{verdict:?}");
    let warning = document.warnings.iter().find(|warning| warning.reason == Some(reason)).unwrap();
    assert!(verdict.warnings.contains(&warning.detail) && page.contains(&warning.detail), "{warning:?}");
    assert!(page.contains(reason.meaning()));
    if let Some(found) = &document.reliability {
        assert!(found.reasons.contains(&reason) && !found.reliable);
        let confidence = &document.correspondences.as_ref().unwrap().confidence;
        assert!(confidence.iter().all(|c| *c <= 0.1), "{:?}", confidence.iter().copied().fold(0.0, f64::max));
    }
}

/// A volume of 1 mm in a box of `n` voxels a side.
fn volume(n: usize, label: impl Fn([f64; 3]) -> u32) -> Vec<u8> {
    let place = |k: usize| [k % n, k / n % n, k / (n * n)].map(|c| c as f64 - (n as f64 - 1.0) / 2.0);
    let labels = (0..n * n * n).map(|k| label(place(k))).collect();
    write_nifti(&LabelVolume::new([n; 3], labels, Matrix4::identity()).unwrap())
}

fn farthest(mesh: &SurfaceMesh, from: &Point3<f64>) -> f64 {
    mesh.vertices().iter().map(|p| (p - from).norm()).fold(0.0, f64::max)
}

#[test]
fn thin_parts_of_volumes_keep_their_volume_and_their_length() {
    for (name, n_voxels) in
        [("plate1.nii.gz", Some(375.0)), ("hip_thin_tail.nii.gz", None), ("hip_thick_tail.nii.gz", None)]
    {
        let bytes = field(name);
        let prepared = prepare(&bytes, &defaults()).unwrap();
        let seen = inspect(&bytes, None, &defaults(), &IntakeLimits::default()).unwrap().volume.unwrap();
        let voxels: u64 = seen.labels.iter().map(|label| label.n_voxels).sum();
        assert!(n_voxels.is_none_or(|n| n == voxels as f64));
        // Where parts of the plate touch along edges only, voxels that join them are added.
        let joined = prepared.report.repairs.iter().find(|note| note.detail.starts_with("joined"));
        let added = joined.map_or(0.0, |note| {
            note.detail.split("; ").nth(1).unwrap().split(' ').next().unwrap().parse::<f64>().unwrap()
        });
        assert!(added <= 0.02 * voxels as f64, "{name}: {added}");
        let volume = prepared.mesh.signed_volume();
        assert!((volume / (voxels as f64 + added) - 1.0).abs() < 1e-3, "{name}: {volume}");
        assert!(reasons(&prepared.report.warnings).is_empty(), "{name}: {:?}", prepared.report.warnings);
    }
    let reach = |name: &str| {
        let mesh = prepare(&field(name), &defaults()).unwrap().mesh;
        let sum = mesh.vertices().iter().fold(nalgebra::Vector3::zeros(), |s, p| s + p.coords);
        farthest(&mesh, &Point3::from(sum / mesh.n_vertices() as f64))
    };
    let (thin, thick) = (reach("hip_thin_tail.nii.gz"), reach("hip_thick_tail.nii.gz"));
    assert!((thin - thick).abs() < 3.0, "{thin} {thick}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A body with a tail of one voxel in any direction: every voxel of the tail is within a voxel of the surface's reach.
    #[test]
    fn a_thin_tail_in_any_direction_is_kept(angles in proptest::array::uniform3(-3.1..3.1f64), length in 8.0..18.0f64) {
        let direction = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]) * nalgebra::Vector3::x();
        // Every voxel through which the line passes within half a voxel: corners may be all that touches.
        let bytes = volume(47, |p| {
            let p = nalgebra::Vector3::from(p);
            let along = p.dot(&direction);
            let near = (p - direction * along).amax() <= 0.5;
            u32::from(p.norm() < 5.0 || near && along > 0.0 && along < 5.0 + length)
        });
        let prepared = prepare(&bytes, &defaults()).unwrap();
        // The affine is the identity, so the middle of the box is at 23 mm.
        let reach = farthest(&prepared.mesh, &Point3::new(23.0, 23.0, 23.0));
        prop_assert!(reach > 5.0 + length - 1.5, "{} of {}", reach, 5.0 + length);
        prop_assert_eq!(analyze(&prepared.mesh).fault, None);
        prop_assert!(reasons(&prepared.report.warnings).is_empty());
    }
}

#[test]
fn smoothing_that_is_asked_for_is_reported_with_what_it_takes() {
    let parameters = InputParameters { smoothing_mm: Some(0.7), ..defaults() };
    let prepared = prepare(&field("plate1.nii.gz"), &parameters).unwrap();
    let [warning] = &prepared.report.warnings[..] else { panic!("{:?}", prepared.report.warnings) };
    let lost = 100.0 * (1.0 - prepared.mesh.signed_volume() / 375.0);
    assert!(
        lost > 50.0 && warning.detail.starts_with(&format!("smoothing by 0.7 mm took {lost:.0} % of the volume")),
        "{warning:?}"
    );
}

#[test]
fn half_a_structure_is_not_dropped_in_silence() {
    let (both, right) = (field("n_both.nii.gz"), field("right_only.nii.gz"));
    check_doubted(&both, &right, json!({}), UnreliableReason::PieceDropped);
    // Methods that check nothing are told the same.
    check_doubted(&both, &right, json!({"method": "rigid"}), UnreliableReason::PieceDropped);
    let warned = prepare(&both, &defaults()).unwrap().report.warnings;
    assert!(warned[0].detail.contains("2 pieces") && warned[0].detail.contains("47 %"), "{warned:?}");
    // A repair that is named is meant.
    let named = InputParameters { repair: Some(vec![Repair::LargestComponent, Repair::Fill]), ..defaults() };
    let report = prepare(&both, &named).unwrap().report;
    assert_eq!((report.warnings.len(), reasons(&report.warnings).len()), (1, 0));
}

#[test]
fn labels_are_not_joined_in_silence() {
    let egg = |p: [f64; 3]| (p[0] / 9.0).powi(2) + (p[1] / 5.0).powi(2) + (p[2] / 3.5).powi(2) < 1.0;
    let two = volume(24, |p| if egg(p) { 17 + u32::from(p[0] > 2.0) } else { 0 });
    let one = volume(24, |p| if egg(p) { 17 } else { 0 });
    check_doubted(&two, &one, json!({}), UnreliableReason::LabelsJoined);
    // The same labels on both sides are said, and no reason.
    let (document, page) = matched(&two, &two, &resolve(&json!({})).unwrap());
    assert_eq!(document.warnings.len(), 2);
    assert!(
        document
            .warnings
            .iter()
            .all(|w| w.reason.is_none() && w.detail.contains("(17, 18)") && page.contains(&w.detail))
    );
    assert_eq!(document.verdict().reliable, Some(true), "{:?}", document.verdict());
    // Chosen labels are meant, also all of them.
    assert!(prepare(&two, &labels(&[17, 18])).unwrap().report.warnings.is_empty());
}

#[test]
fn a_cavity_is_not_filled_in_silence() {
    let radius = |p: [f64; 3]| p.iter().map(|c| c * c).sum::<f64>().sqrt();
    let shell = volume(20, |p| u32::from(radius(p) < 8.0 && radius(p) > 5.0));
    let warnings = prepare(&shell, &defaults()).unwrap().report.warnings;
    assert_eq!(reasons(&warnings), [UnreliableReason::CavityFilled]);
    let speck = volume(20, |p| u32::from(radius(p) < 8.0 && radius(p) > 1.0));
    let warnings = prepare(&speck, &defaults()).unwrap().report.warnings;
    assert!(
        warnings.len() == 1 && reasons(&warnings).is_empty() && warnings[0].detail.starts_with("1 cavity with 0.37 %"),
        "{warnings:?}"
    );
}

#[test]
fn coarse_voxels_are_doubted_and_fine_ones_are_not() {
    let (fine, coarse) = (field("hip1mm.nii.gz"), field("hip3mm.nii.gz"));
    check_doubted(&fine, &coarse, json!({}), UnreliableReason::TooCoarse);
    let verdict = matched(&fine, &fine, &resolve(&json!({})).unwrap()).0.verdict();
    assert_eq!((verdict.reliable, verdict.warnings), (Some(true), Vec::new()));
}

#[test]
fn an_image_is_refused_unless_its_values_are_confirmed() {
    let image = field("t1_like_uint8.nii.gz");
    let error = prepare(&image, &defaults()).unwrap_err();
    assert_eq!(error.code(), "not-labels");
    let said = error.to_string();
    assert!(said.starts_with("the file looks like an image") && said.contains("208 values"), "{said}");
    let seen = inspect(&image, None, &defaults(), &IntakeLimits::default()).unwrap();
    assert_eq!((seen.suitable, seen.refusal.unwrap().code.as_str()), (false, "not-labels"));
    let confirmed = InputParameters { image_is_labels: true, ..defaults() };
    assert_ne!(prepare(&image, &confirmed).err().map(|e| e.code()), Some("not-labels"));
    assert_ne!(prepare(&image, &labels(&[100])).err().map(|e| e.code()), Some("not-labels"));
}

mod real_data {
    use super::*;
    use crate::fixtures::{real, real_files};

    #[test]
    #[ignore = "needs real data (hippocampus, formats)"]
    fn of_real_volumes_the_image_is_told_from_the_labels() {
        let mut files = real_files("hippocampus");
        for folder in ["formats/mgz", "formats/nifti", "formats/nrrd", "formats/dicom_seg"] {
            files.extend(real_files(folder));
        }
        let _ = real("hippocampus");
        for path in files {
            let bytes = std::fs::read(&path).unwrap();
            let code = prepare(&bytes, &defaults()).err().map(|error| error.code());
            // An average of 27 scans of a head.
            let is_image = path.ends_with("vol27int.nii.gz");
            assert_eq!(code == Some("not-labels"), is_image, "{}", path.display());
        }
    }
}
