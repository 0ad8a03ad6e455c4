//! Inputs as other programs write them, from their bytes to what is said of them: soup, sizes beyond the limit, transforms, and
//! contradictions, which are in the report, the verdict and on the page.

use crate::fixtures::fixture;
use homolog_contract::parameters::{InputParameters, Method, Repair, preset, resolve};
use homolog_contract::result::UnreliableReason;
use homolog_formats::{write_ply, write_stl};
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::topology::SurfaceFault;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_run::intake::{IntakeError, IntakeLimits, PreparedSurface, inspect, prepare_surface};
use homolog_run::{InputFile, ReportInputs, RunOutput, run_match, write_report};
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use serde_json::{Value, json};

fn input(change: Value) -> InputParameters {
    resolve(&json!({ "input": change })).unwrap().input
}

fn prepare(bytes: &[u8], parameters: &InputParameters) -> Result<PreparedSurface, IntakeError> {
    prepare_surface(bytes, None, parameters, &IntakeLimits::default())
}

fn matched(source: &[u8], target: &[u8], parameters: &Value) -> RunOutput {
    let [source, target] = [source, target].map(|bytes| InputFile { bytes, name: None });
    run_match(source, target, &resolve(parameters).unwrap(), &IntakeLimits::default(), &Silent).unwrap()
}

fn page(output: &RunOutput) -> String {
    write_report(&ReportInputs {
        document: &output.document,
        correspondences: output.document.correspondences.as_ref().unwrap(),
        source: &output.source,
        target: &output.target,
        trace: &[],
    })
    .unwrap()
}

/// Every face with vertices of its own, each moved by up to `jitter_mm` in each direction.
fn soup(mesh: &SurfaceMesh, jitter_mm: f64, seed: u64) -> SurfaceMesh {
    let mut state = seed | 1;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    let corners = mesh.indices().iter().map(|&v| mesh.vertices()[v as usize]);
    let vertices: Vec<Point3<f64>> = corners.map(|p| p + Vector3::new(next(), next(), next()) * jitter_mm).collect();
    let indices = (0..vertices.len() as u32).collect();
    SurfaceMesh::new(vertices, FaceArity::Triangle, indices).unwrap()
}

#[test]
fn soup_of_another_program_is_joined_and_reported() {
    let found = prepare(&fixture("field/soup.stl"), &input(json!({}))).unwrap();
    let of = |mesh: &SurfaceMesh| (mesh.n_vertices(), mesh.n_faces());
    assert_eq!(of(&found.mesh), (246, 488));
    assert_eq!(found.mesh.boundary_vertices(), None);
    let note = &found.report.repairs.iter().find(|note| note.detail.contains("1 % of the median edge")).unwrap().detail;
    assert!(note.contains("edges with one face: ") && note.contains("0 after"), "{note}");
    let volume = prepare(&fixture("field/reference.ply"), &input(json!({}))).unwrap().mesh.signed_volume();
    assert!((found.mesh.signed_volume() / volume - 1.0).abs() < 1e-3);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn soup_is_joined_below_the_tolerance_and_refused_as_soup_above(
        radii in prop::array::uniform3(2.0..40.0f64), share in -6.0..-0.7f64, seed: u64, stl: bool,
    ) {
        let whole = ellipsoid(Vector3::from(radii), 2);
        let mean = (whole.area() / whole.n_faces() as f64).sqrt() * 1.5;
        let jitter = 10f64.powf(share) * mean;
        let loose = soup(&whole, jitter, seed);
        let bytes = if stl { write_stl(&loose) } else { write_ply(&loose) };
        match prepare(&bytes, &input(json!({}))) {
            Ok(found) => {
                prop_assert_eq!(found.mesh.boundary_vertices(), None);
                prop_assert_eq!((found.mesh.n_vertices(), found.mesh.n_faces()), (whole.n_vertices(), whole.n_faces()));
                prop_assert!((found.mesh.signed_volume() / whole.signed_volume() - 1.0).abs() < 0.05);
                prop_assert!(found.report.repairs.iter().all(|note| note.repair != Repair::Split));
            }
            Err(IntakeError::UnsuitableSurface { fault, .. }) => {
                // Where a part of the corners is joined, what is left is open.
                prop_assert!(matches!(fault, SurfaceFault::Soup { .. }), "{}", fault);
                prop_assert!(jitter > 1e-3 * mean, "refused at a jitter of {jitter} mm, edges of {mean} mm");
            }
            Err(error) => prop_assert!(false, "{error}"),
        }
    }

    #[test]
    fn an_open_surface_whose_vertices_are_apart_keeps_all_of_them(radii in prop::array::uniform3(2.0..40.0f64), part in 0.2..0.9f64) {
        let whole = ellipsoid(Vector3::from(radii), 2);
        let n = (whole.n_faces() as f64 * part) as usize;
        let open = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, whole.indices()[..3 * n].to_vec()).unwrap();
        let found = prepare(&write_ply(&open), &input(json!({}))).unwrap();
        prop_assert_eq!(found.mesh.n_faces(), n);
        prop_assert!(found.report.repairs.iter().all(|note| note.repair != Repair::Weld), "{:?}", found.report.repairs);
    }
}

#[test]
fn soup_without_the_repair_is_no_surface_and_the_repair_is_advised() {
    let bytes = write_ply(&soup(&ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2), 0.0, 1));
    let parameters = input(json!({"repair": []}));
    let report = inspect(&bytes, None, &parameters, &IntakeLimits::default()).unwrap();
    assert!(!report.suitable);
    let detail = report.refusal.unwrap().detail;
    assert!(detail.contains("do not hold together") && detail.contains("[\"weld\"]"), "{detail}");
}

#[test]
fn a_surface_is_simplified_before_its_vertices_are_counted() {
    let sphere = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 5);
    assert!(sphere.n_vertices() > 10_000);
    let bytes = write_ply(&sphere);
    let limits = IntakeLimits { max_vertices: 2_000, max_faces: 30_000, ..IntakeLimits::default() };
    let of = |change: Value| prepare_surface(&bytes, None, &input(change), &limits);
    let refused = of(json!({})).unwrap_err();
    assert!(refused.to_string().contains("input.max_vertices"), "{refused}");
    assert!(refused.for_command_line().contains("--simplify N"), "{}", refused.for_command_line());
    assert!(matches!(
        of(json!({"max_vertices": 3_000})),
        Err(IntakeError::TooLarge { found: 3_000, limit: 2_000, .. })
    ));
    let found = of(json!({"max_vertices": 1_500})).unwrap();
    assert_eq!((found.mesh.n_vertices(), found.uploaded().n_vertices()), (1_500, sphere.n_vertices()));
    let fewer_faces = IntakeLimits { max_faces: 10_000, ..limits };
    let too_many = prepare_surface(&bytes, None, &input(json!({"max_vertices": 1_500})), &fewer_faces);
    assert!(matches!(too_many, Err(IntakeError::TooLarge { .. })));
}

#[test]
fn what_an_input_contradicts_is_in_report_verdict_and_page() {
    let thesis = json!({"method": "rigid"});
    for parameters in [json!({}), thesis] {
        let bytes = fixture("field/two_sides.nii.gz");
        let output = matched(&bytes, &bytes, &parameters);
        let verdict = output.document.verdict();
        assert_eq!(verdict.reliable, Some(false));
        assert!(verdict.reasons.contains(&UnreliableReason::UncertainSide), "{:?}", verdict.reasons);
        assert!(verdict.warnings.iter().any(|warning| warning.starts_with("source: ") && warning.contains("qform")));
        assert_eq!(output.document.provenance.target.report.warnings.len(), 1);
        let page = page(&output);
        assert!(page.contains("left and right may be exchanged") && page.contains("the sform was taken"));
    }
}

#[test]
fn surfaces_in_different_units_are_said_to_be() {
    let meters = {
        let mesh = prepare(&fixture("field/reference.ply"), &input(json!({}))).unwrap().mesh;
        let vertices = mesh.vertices().iter().map(|p| p * 1e-3).collect();
        write_ply(&SurfaceMesh::new(vertices, FaceArity::Triangle, mesh.indices().to_vec()).unwrap())
    };
    let output = matched(&fixture("field/reference.ply"), &meters, &json!({"method": "rigid"}));
    let verdict = output.document.verdict();
    assert!(verdict.reasons.contains(&UnreliableReason::UnitsDiffer), "{:?}", verdict.reasons);
    assert!(page(&output).contains("near 1000"));
    // Stated, the unit is applied, and nothing is left to say.
    let stated = String::from_utf8_lossy(&meters).find("comment").unwrap();
    let mut bytes = meters.clone();
    bytes.splice(stated..stated, *b"comment units: m\n");
    let output = matched(&fixture("field/reference.ply"), &bytes, &json!({"method": "rigid"}));
    assert!(!output.document.verdict().reasons.contains(&UnreliableReason::UnitsDiffer));
    assert!(page(&output).contains("its unit of length is 1000 mm"));
    assert!(output.document.transform.rotation_angle_deg < 1.0);
}

#[test]
fn a_transform_that_is_not_rigid_is_applied_only_if_asked() {
    let reference = prepare(&fixture("field/reference.ply"), &input(json!({}))).unwrap().mesh.signed_volume();
    let bytes = fixture("field/talairach.surf.gii");
    for (apply, factor) in [(json!(null), 1.0), (json!(false), 1.0), (json!(true), 2.4)] {
        let found = prepare(&bytes, &input(json!({"apply_transform": apply}))).unwrap();
        let ratio = found.mesh.signed_volume() / reference;
        assert!((ratio / factor - 1.0).abs() < 0.01, "{apply}: {ratio}");
        let notes = found.report.notes.join("; ");
        assert_eq!(notes.contains("was not applied"), factor == 1.0, "{notes}");
        assert!(notes.contains("from unknown to Talairach"), "{notes}");
    }
    assert_eq!(preset(Method::Balanced).input.apply_transform, None);
}
