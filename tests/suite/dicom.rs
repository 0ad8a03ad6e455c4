//! DICOM over HTTP and on the command line: series in several parts of a form, and objects for studies that a request names.

use super::cli::homolog;
use super::jobs_support::{TestService, problem};
use super::representations::{bytes, matched};
use homolog::worker::match_engine::MatchEngine;
use homolog_formats::segmentation::{SegmentedFiles, write_segmentation};
use homolog_formats::{FileContent, ReadLimits, read, write_nifti, write_ply, write_zip};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::volume::LabelVolume;
use homolog_run::intake::IntakeLimits;
use nalgebra::{Matrix4, Vector3};
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};
use std::sync::Arc;

/// A ball around `x`, mm.
fn ball(x: f64, radius: f64) -> SurfaceMesh {
    let ball = ellipsoid(Vector3::new(radius, 0.9 * radius, 0.8 * radius), 3);
    ball.with_vertices(ball.vertices().iter().map(|p| p + Vector3::new(x, 0.0, 0.0)).collect()).unwrap()
}

/// Two instances of one series, each with the segment of a ball, on one grid.
fn series() -> [Vec<u8>; 2] {
    let affine = Matrix4::new_translation(&Vector3::new(-16.0, -16.0, -16.0));
    let grid = LabelVolume::new([40, 32, 32], vec![1; 40 * 32 * 32], affine).unwrap();
    let grid = write_nifti(&grid);
    [(0.0, 9.0, "front"), (10.0, 8.0, "back")].map(|(x, radius, label)| {
        let (study_uid, frame_uid) = (Some("1.2.3"), Some("1.2.5"));
        let files = SegmentedFiles { own: &grid, other: b"ply", study_uid, frame_uid, max_inflated_bytes: 1 << 30 };
        write_segmentation(&ball(x, radius), label, &files, "20261122201500").unwrap()
    })
}

async fn service() -> TestService {
    let engine = Arc::new(MatchEngine::new(IntakeLimits::default(), 0));
    TestService::start_with(Arc::new(tempfile::tempdir().unwrap()), &["--workers", "0"], Some(engine)).await
}

fn form(sources: &[&[u8]]) -> Form {
    let part = |bytes: &[u8]| Part::bytes(bytes.to_vec()).file_name("Doe^Jane.dcm");
    let form = sources.iter().fold(Form::new(), |form, bytes| form.part("source", part(bytes)));
    form.part("target", part(&write_ply(&ball(0.0, 9.0))))
}

#[tokio::test]
async fn the_instances_of_a_series_may_be_sent_as_parts_of_their_own() {
    let service = service().await;
    let [first, second] = series();
    let submitted = async |sources: &[&[u8]], key: &str| -> Value {
        let request = service.client.post(format!("{}/v1/jobs", service.base)).header("idempotency-key", key);
        let answer = request.multipart(form(sources)).send().await.unwrap();
        assert_eq!(answer.status(), 202, "{}", answer.text().await.unwrap());
        answer.json().await.unwrap()
    };
    let both = submitted(&[&first, &second], "one").await;
    // The order of the parts does not matter, also in a repeated request.
    assert_eq!(submitted(&[&second, &first], "one").await["id"], both["id"]);
    let other = submitted(&[&second, &first], "two").await;
    assert_eq!(other["source"]["hash"], both["source"]["hash"]);
    assert_ne!(submitted(&[&first], "three").await["source"]["hash"], both["source"]["hash"]);

    // A zip of the instances is the same structure with both segments.
    let zip = write_zip(&[("a.dcm".to_owned(), &first), ("b.dcm".to_owned(), &second)]).unwrap();
    let checked = async |sources: &[&[u8]]| -> Value {
        let request =
            service.client.post(format!("{}/v1/jobs?validate_only=true", service.base)).multipart(form(sources));
        let answer = request.send().await.unwrap();
        assert_eq!(answer.status(), 200, "{}", answer.text().await.unwrap());
        answer.json::<Value>().await.unwrap()["source"].take()
    };
    let report = checked(&[&first, &second]).await;
    assert_eq!(report, checked(&[&zip]).await);
    assert_ne!(report, checked(&[&first]).await);

    // Other formats are sent as one part.
    let ply = write_ply(&ball(0.0, 5.0));
    for sources in [[&first, &ply], [&ply, &first], [&ply, &ply], [&zip, &first], [&first, &zip]] {
        let sources = sources.map(Vec::as_slice);
        let refused = problem(service.send(form(&sources)).await, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], "/source", "{refused}");
        assert!(refused["errors"][0]["detail"].as_str().unwrap().contains("instance of a DICOM series"), "{refused}");
    }
    service.end().await;

    // The size limit of a file applies to all parts of an input together.
    let limit = (first.len() + second.len() - 1).to_string();
    let service = TestService::start(&["--workers", "0", "--max-file-bytes", &limit]).await;
    let refused = problem(service.send(form(&[&first, &second])).await, 413, "too-large").await;
    assert_eq!((&refused["input"], refused["limit_bytes"].to_string()), (&json!("source"), limit));
    service.end().await;
}

/// Texts of the elements with explicit representation: patient, study, frame of reference.
fn identity(object: &[u8]) -> [String; 3] {
    [(0x10, 0x10), (0x20, 0x0d), (0x20, 0x52)].map(|(group, element): (u8, u8)| {
        let tag = [group, 0, element, 0];
        let is_it = |at: &usize| object[*at..].starts_with(&tag) && matches!(&object[at + 4..at + 6], b"PN" | b"UI");
        let at = (132..object.len() - 8).find(is_it).unwrap();
        let n = usize::from(u16::from_le_bytes([object[at + 6], object[at + 7]]));
        String::from_utf8(object[at + 8..at + 8 + n].to_vec()).unwrap().trim_matches(['\0', ' ']).to_owned()
    })
}

#[tokio::test]
async fn objects_are_made_for_the_study_that_a_request_names() {
    let (service, job) = matched().await;
    let uids = "study_uid=1.2.3&source_frame_uid=1.2.5&target_frame_uid=1.2.6";
    for (path, frame) in [
        ("warped?format=dicom&", "1.2.6"),
        ("warped?format=dicom&space=source&", "1.2.5"),
        ("transform?format=dicom&", "1.2.6"),
    ] {
        let object = bytes(&service, &format!("{job}/{path}{uids}")).await;
        assert_eq!(identity(&object), ["", "1.2.3", frame], "{path}");
        assert_eq!(bytes(&service, &format!("{job}/{path}{uids}")).await, object, "equal requests, equal bytes");
        // Another study changes the ETag.
        let etag = async |study: &str| {
            let answer = service.get(&format!("{job}/{path}study_uid={study}")).await;
            assert_eq!(answer.status(), 200);
            answer.headers()["etag"].clone()
        };
        assert_ne!(etag("1.2.3").await, etag("1.2.4").await);
        let named = bytes(&service, &format!("{job}/{path}study_uid=1.2.3")).await;
        assert!(identity(&named)[2].starts_with("2.25."), "a frame of reference named by the content");
        let refused = problem(service.get(&format!("{job}/{path}")).await, 406, "not-acceptable").await;
        assert!(refused["detail"].as_str().unwrap().contains("study_uid"), "{refused}");
        for wrong in
            ["study_uid=Doe", "study_uid=1", "study_uid=1.02", "target_frame_uid=1..2", "study_uid=1.2&study_uid=1.2"]
        {
            let refused = problem(service.get(&format!("{job}/{path}{wrong}")).await, 400, "invalid-query").await;
            assert!(refused["errors"][0]["pointer"].as_str().unwrap().starts_with("/query/"), "{refused}");
        }
    }
    // The segmentation lies on the grid of the target and encloses the same region as the surface.
    let object = bytes(&service, &format!("{job}/warped?format=dicom&{uids}")).await;
    let segmentation = read(&object, None, &ReadLimits::default()).unwrap();
    let FileContent::Labels(volume) = segmentation.content else { panic!("labels are expected") };
    assert!(volume.spacing_mm().iter().all(|mm| (mm - 2.0).abs() < 1e-6), "{:?}", volume.spacing_mm());
    let warped = bytes(&service, &format!("{job}/warped")).await;
    let FileContent::Mesh(file) = read(&warped, None, &ReadLimits::default()).unwrap().content else {
        panic!("a surface is expected")
    };
    let enclosed = volume.labels().iter().filter(|label| **label != 0).count() as f64 * 8.0;
    assert!((enclosed / file.mesh.signed_volume() - 1.0).abs() < 0.1, "{enclosed} {}", file.mesh.signed_volume());
    // Other parts accept no UIDs.
    for path in ["aligned?study_uid=1.2", "correspondences?study_uid=1.2"] {
        problem(service.get(&format!("{job}/{path}")).await, 400, "invalid-query").await;
    }
    service.end().await;
}

#[test]
fn the_command_line_writes_objects_for_the_study_that_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("a.ply"), write_ply(&ball(0.0, 9.0))).unwrap();
    std::fs::write(path("b.ply"), write_ply(&ball(5.0, 9.5))).unwrap();
    let run = |arguments: &[&str]| {
        let mut command = homolog();
        command.arg("match").args([path("a.ply"), path("b.ply")]).args(arguments);
        let done = command.output().unwrap();
        (done.status.code(), String::from_utf8(done.stderr).unwrap())
    };
    let out = path("out");
    let (code, said) = run(&["--study-uid", "1.2.3", "--target-frame-uid", "1.2.6", "--out", out.to_str().unwrap()]);
    assert_eq!(code, Some(0), "{said}");
    for name in ["transform.dcm", "warped.dcm"] {
        assert_eq!(identity(&std::fs::read(out.join(name)).unwrap()), ["", "1.2.3", "1.2.6"], "{name}");
    }
    let (code, said) = run(&["--study-uid", "Doe^Jane", "--out", out.to_str().unwrap()]);
    assert!(code == Some(2) && said.contains("must be a DICOM UID"), "{said}");
    let plain = path("plain");
    assert_eq!(run(&["--out", plain.to_str().unwrap()]).0, Some(0));
    assert!(!plain.join("warped.dcm").exists() && !plain.join("transform.dcm").exists());
}
