//! An input that is mirrored before it is matched: what the result states holds in the coordinates of the files.

use crate::fixtures::fixture;
use homolog_contract::parameters::resolve;
use homolog_contract::result::{Correspondences, TransformDocument, WarpDirection};
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::PhantomPair;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use homolog_registration::RigidTransform;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, RunOutput, run_match};
use nalgebra::{Matrix3, Matrix4, Point3, Quaternion, Unit, UnitQuaternion, Vector3};
use proptest::prelude::*;
use serde_json::{Value, json};

fn run(source: &[u8], target: &[u8], parameters: &Value) -> RunOutput {
    let file = |bytes| InputFile { bytes, name: None };
    let parameters = resolve(parameters).unwrap();
    run_match(file(source), file(target), &parameters, &IntakeLimits::default(), &Silent).unwrap()
}

fn matrix(rows: &[[f64; 4]; 4]) -> Matrix4<f64> {
    Matrix4::from_fn(|r, c| rows[r][c])
}

/// The stated parts, put together as the document says: the reflection first, then rotation and translation.
fn composed(transform: &TransformDocument) -> Matrix4<f64> {
    let [w, x, y, z] = transform.rotation_quaternion_wxyz;
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    let mut motion = rotation.to_homogeneous();
    motion.fixed_view_mut::<3, 1>(0, 3).copy_from(&Vector3::from(transform.translation_mm));
    motion * transform.reflection.as_ref().map_or_else(Matrix4::identity, matrix)
}

/// Whether the parts agree with the matrix, and with whether it mirrors.
fn is_consistent(transform: &TransformDocument) -> bool {
    let whole = matrix(&transform.matrix);
    let mirrors = whole.determinant() < 0.0;
    let own_inverse = transform.reflection.as_ref().is_none_or(|rows| {
        let reflection = matrix(rows);
        reflection.determinant() < 0.0 && (reflection * reflection - Matrix4::identity()).norm() < 1e-9
    });
    let [w, ..] = transform.rotation_quaternion_wxyz;
    let angle = 2.0 * w.min(1.0).acos().to_degrees();
    mirrors == transform.mirrored
        && mirrors == transform.reflection.is_some()
        && own_inverse
        && (composed(transform) - whole).norm() < 1e-9 * whole.norm()
        && (angle - transform.rotation_angle_deg).abs() < 1e-4
}

/// The corresponding points, on the target as it is.
fn images(target: &SurfaceMesh, pairs: &Correspondences) -> Vec<Point3<f64>> {
    let image = |row: usize| {
        let corners = pairs.triangle[row].iter().zip(pairs.barycentric[row]);
        corners.map(|(&v, weight)| target.vertices()[v as usize].coords * weight).sum::<Vector3<f64>>().into()
    };
    (0..pairs.source.len()).map(image).collect()
}

/// How far the stated transform takes the vertices of the source as uploaded from their corresponding points, RMS, mm.
fn rms_mm(output: &RunOutput) -> f64 {
    let pairs = output.document.correspondences.as_ref().unwrap();
    let whole = matrix(&output.document.transform.matrix);
    let apart = images(&output.target, pairs).into_iter().zip(&pairs.source).map(|(image, &vertex)| {
        (whole.transform_point(&output.source.vertices()[vertex as usize]) - image).norm_squared()
    });
    (apart.sum::<f64>() / pairs.source.len() as f64).sqrt()
}

fn reflection(normal: [f64; 3], offset: f64) -> RigidTransform {
    let normal = Unit::new_normalize(Vector3::from(normal));
    RigidTransform {
        rotation: Matrix3::identity() - 2.0 * normal.into_inner() * normal.transpose(),
        translation: 2.0 * offset * normal.into_inner(),
    }
}

fn pose(angles: [f64; 3], translation: [f64; 3]) -> RigidTransform {
    let rotation = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
    RigidTransform { rotation: *rotation.matrix(), translation: translation.into() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// Whichever input is mirrored, and wherever the copy lies, the stated matrix takes the source as uploaded onto its mirrored copy,
    /// and the answer is reliable; with both mirrored, onto a copy that is not.
    #[test]
    fn what_is_stated_takes_the_source_as_uploaded_onto_its_mirrored_copy(
        subject in 0u64..6,
        normal in proptest::array::uniform3(-1.0..1.0f64).prop_filter("no direction", |n| n.iter().any(|x| x.abs() > 0.1)),
        offset in -40.0..40.0f64,
        angles in proptest::array::uniform3(-3.0..3.0f64),
        translation in proptest::array::uniform3(-60.0..60.0f64),
        sides in proptest::sample::select(vec![[true, false], [false, true], [true, true]]),
        landmarks in any::<bool>(),
    ) {
        let [source, _] = PhantomPair::against_template(subject).unwrap().meshes(2.0).unwrap();
        let mirrors = sides[0] != sides[1];
        let motion = pose(angles, translation);
        let truth = if mirrors { motion.after(&reflection(normal, offset)) } else { motion };
        let target = source.moved(&truth.matrix()).unwrap();
        let mut parameters = json!({
            "input": {"source": {"mirror": sides[0]}, "target": {"mirror": sides[1]}},
            "registration": {"similarity": true},
        });
        if landmarks {
            let pair = |p: &Point3<f64>| json!({"source_mm": [p.x, p.y, p.z], "target_mm": truth.apply(p).coords.as_slice()});
            let n = source.n_vertices();
            parameters["landmarks"] = [0, n / 3, n / 2, n - 1].map(|k| pair(&source.vertices()[k])).to_vec().into();
        }
        let output = run(&write_ply(&source), &write_ply(&target), &parameters);
        let transform = &output.document.transform;
        prop_assert!(is_consistent(transform), "{transform:?}");
        prop_assert_eq!(transform.mirrored, mirrors);
        prop_assert_eq!(output.source.vertices(), source.vertices());
        prop_assert!(output.document.verdict().reliable == Some(true), "{:?}", output.document.verdict());
        let apart = rms_mm(&output);
        prop_assert!(apart < 0.05, "{apart} mm");
        let found = RigidTransform::of_matrix(&transform.matrix);
        prop_assert!(found.angle_to(&truth).to_degrees() < 0.2);
        prop_assert!(source.vertices().iter().all(|p| (found.apply(p) - truth.apply(p)).norm() < 0.1));
        let similarity = transform.similarity.as_ref().unwrap();
        prop_assert!((matrix(&similarity.matrix) - matrix(&transform.matrix)).norm() < 0.3);
        prop_assert!(output.document.poses.iter().all(|pose| pose.mirrored == (matrix(&pose.matrix).determinant() < 0.0)));
        // Faces look outwards still.
        prop_assert!(output.aligned().unwrap().signed_volume() > 0.0);
        prop_assert!(output.warped(WarpDirection::Forward).unwrap().mesh.signed_volume() > 0.0);
        prop_assert!(output.target.signed_volume() > 0.0 && output.source.signed_volume() > 0.0);
    }
}

#[test]
fn a_volume_with_a_space_is_mirrored_from_left_to_right() {
    let volume = fixture("subject-1.nii.gz");
    let surface = run(&volume, &volume, &json!({})).source;
    let other_side = surface.moved(&reflection([1.0, 0.0, 0.0], 0.0).matrix()).unwrap();
    let output = run(&volume, &write_ply(&other_side), &json!({"input": {"source": {"mirror": true}}}));
    let transform = &output.document.transform;
    assert!(is_consistent(transform), "{transform:?}");
    let from_left_to_right = Matrix4::from_diagonal(&nalgebra::Vector4::new(-1.0, 1.0, 1.0, 1.0));
    assert_eq!(matrix(transform.reflection.as_ref().unwrap()), from_left_to_right);
    assert!(transform.rotation_angle_deg < 0.1 && rms_mm(&output) < 0.01, "{transform:?}");
    let notes = &output.document.provenance.source.report.notes;
    assert!(notes.iter().any(|note| note.contains("from left to right")), "{notes:?}");
    // Without it, the verdict names the step.
    let plain = run(&volume, &write_ply(&other_side), &json!({})).document;
    let advice: Vec<&str> = plain.verdict().reasons.iter().map(|reason| reason.advice()).collect();
    let names_it = |advice: &&str| advice.contains("--mirror source") && advice.contains("input.source.mirror: true");
    assert!(advice.iter().any(names_it), "{advice:?}");
}

#[test]
fn a_reflection_that_was_allowed_is_stated_in_the_same_way() {
    let [source, _] = PhantomPair::against_template(1).unwrap().meshes(2.0).unwrap();
    let truth = pose([0.4, -1.0, 2.0], [3.0, 8.0, -20.0]).after(&reflection([0.3, 1.0, 0.2], 11.0));
    let target = source.moved(&truth.matrix()).unwrap();
    let files = [&source, &target].map(write_ply);
    let output = run(&files[0], &files[1], &json!({"registration": {"allow_reflection": true}}));
    assert!(output.document.transform.mirrored && is_consistent(&output.document.transform));
    assert!(rms_mm(&output) < 0.05);
    // A reflection of a mirrored source is none.
    let both = json!({"registration": {"allow_reflection": true}, "input": {"source": {"mirror": true}}});
    let again = run(&files[0], &write_ply(&source), &both);
    assert!(!again.document.transform.mirrored && is_consistent(&again.document.transform));
    assert!(rms_mm(&again) < 0.05);
}
