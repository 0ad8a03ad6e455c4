//! Results of a real match in every format: chosen by query or `Accept`, named, valid, and with the same numbers.

use super::jobs_support::{TestService, problem};
use homolog::worker::match_engine::MatchEngine;
use homolog_formats::{FileContent, ReadLimits, read, write_nifti_gz};
use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_run::intake::IntakeLimits;
use nalgebra::{Matrix4, Point3};
use reqwest::multipart::{Form, Part};
use reqwest::{Response, header::HeaderMap};
use serde_json::{Value, json};
use std::sync::Arc;

/// Two small label volumes of one shape in different poses, as files.
pub(super) fn small_volumes() -> [Vec<u8>; 2] {
    let recipe = PairRecipe {
        subject: 1,
        target_subject: 1,
        deform_share: 0.0,
        deform_seed: 0,
        pose_seed: Some(4),
        permute_seed: None,
    };
    let pair = PhantomPair::new(recipe).unwrap();
    let volumes = [pair.source_volume(2.0).unwrap(), pair.target_volume(2.0).unwrap()];
    volumes.map(|volume| write_nifti_gz(&volume.into_label_volume().unwrap()))
}

/// A service with a finished match of two small voxel surfaces; the path of the job.
pub(super) async fn matched() -> (TestService, String) {
    matched_with(json!({"input": {"surface": "voxel"}})).await
}

/// As [`matched`], with these parameters.
pub(super) async fn matched_with(parameters: Value) -> (TestService, String) {
    let [source, target] = small_volumes().map(Part::bytes);
    let form = Form::new()
        .part("source", source.file_name("Doe^Jane.nii.gz"))
        .part("target", target.file_name("b.nii.gz"))
        .text("parameters", parameters.to_string());
    let folder = Arc::new(tempfile::tempdir().unwrap());
    let engine = Arc::new(MatchEngine::new(IntakeLimits::default(), 0));
    let service = TestService::start_with(folder, &[], Some(engine)).await;
    let response = service.send(form).await;
    assert_eq!(response.status(), 202, "{}", response.text().await.unwrap());
    let job: Value = response.json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    let job = service.until_final(id).await;
    assert_eq!(job["state"], "succeeded", "{job}");
    (service, format!("/v1/jobs/{id}"))
}

async fn accepting(service: &TestService, path: &str, accept: &str) -> Response {
    service.client.get(format!("{}{path}", service.base)).header("accept", accept).send().await.unwrap()
}

pub(super) async fn bytes(service: &TestService, path: &str) -> Vec<u8> {
    let response = service.get(path).await;
    assert_eq!(response.status(), 200, "{path}");
    response.bytes().await.unwrap().to_vec()
}

fn mesh_of(bytes: &[u8]) -> SurfaceMesh {
    match read(bytes, None, &ReadLimits::default()).unwrap().content {
        FileContent::Mesh(file) => file.mesh,
        FileContent::Labels(_) => panic!("a mesh is expected"),
    }
}

/// A format, its media type, and its file extension.
pub(super) type Offered = (&'static str, &'static str, Option<&'static str>);

/// Parts and their formats; the first format is the default.
pub(super) const PARTS: [(&str, &[Offered]); 7] = [
    ("report", &[("html", "text/html", None)]),
    (
        "correspondences",
        &[
            ("json", "application/json", None),
            ("csv", "text/csv", Some("csv")),
            ("npy", "application/x-npy", Some("npy")),
            ("npz", "application/x-npz", Some("npz")),
            ("arrow", "application/vnd.apache.arrow.file", Some("arrow")),
            ("parquet", "application/vnd.apache.parquet", Some("parquet")),
            ("ply", "model/ply", Some("ply")),
            ("vtk", "model/vtk", Some("vtk")),
            ("vtp", "application/vnd.vtk.vtp", Some("vtp")),
            ("gifti", "application/gifti+xml", Some("surf.gii")),
            ("glb", "model/gltf-binary", Some("glb")),
        ],
    ),
    (
        "transform",
        &[
            ("json", "application/json", None),
            ("text", "text/plain", None),
            ("tfm", "application/x-itk-transform", Some("tfm")),
            ("lta", "application/x-freesurfer-lta", Some("lta")),
            ("dicom", "application/dicom", Some("dcm")),
        ],
    ),
    ("surfaces/source", SURFACE),
    ("surfaces/target", SURFACE),
    ("aligned", SURFACE),
    (
        "warped",
        &[
            ("ply", "model/ply", Some("ply")),
            ("vtk", "model/vtk", Some("vtk")),
            ("vtp", "application/vnd.vtk.vtp", Some("vtp")),
            ("gifti", "application/gifti+xml", Some("surf.gii")),
            ("stl", "model/stl", Some("stl")),
            ("glb", "model/gltf-binary", Some("glb")),
            ("json", "application/json", None),
            ("csv", "text/csv", Some("csv")),
            ("npy", "application/x-npy", Some("npy")),
            ("npz", "application/x-npz", Some("npz")),
            ("arrow", "application/vnd.apache.arrow.file", Some("arrow")),
            ("parquet", "application/vnd.apache.parquet", Some("parquet")),
            ("dicom", "application/dicom", Some("dcm")),
        ],
    ),
];

const SURFACE: &[Offered] = &[
    ("ply", "model/ply", Some("ply")),
    ("vtk", "model/vtk", Some("vtk")),
    ("vtp", "application/vnd.vtk.vtp", Some("vtp")),
    ("gifti", "application/gifti+xml", Some("surf.gii")),
    ("stl", "model/stl", Some("stl")),
    ("glb", "model/gltf-binary", Some("glb")),
];

fn text(headers: &HeaderMap, name: &str) -> Option<String> {
    headers.get(name).map(|value| value.to_str().unwrap().to_owned())
}

#[tokio::test]
async fn every_part_comes_in_every_format_it_has() {
    let (service, job) = matched().await;
    let id = job.rsplit('/').next().unwrap();
    let mut etags = Vec::new();
    for (part, formats) in PARTS {
        let path = format!("{job}/{part}");
        let default = service.get(&path).await;
        assert!(text(default.headers(), "content-type").unwrap().starts_with(formats[0].1), "{path}");
        for &(format, media_type, ending) in formats {
            let by_query = accepting(&service, &format!("{path}?format={format}"), "image/png").await;
            if format == "dicom" {
                let body = problem(by_query, 406, "not-acceptable").await;
                assert!(body["detail"].as_str().unwrap().contains("name one with study_uid"), "{body}");
                continue;
            }
            assert_eq!(by_query.status(), 200, "{path} {format}: the query goes before Accept");
            let headers = by_query.headers().clone();
            assert!(text(&headers, "content-type").unwrap().starts_with(media_type), "{path} {format}");
            assert_eq!(text(&headers, "vary").as_deref(), Some("accept"));
            assert_eq!(text(&headers, "cache-control").as_deref(), Some("private, no-cache"));
            let name = part.trim_start_matches("surfaces/");
            let disposition = ending.map(|e| format!("attachment; filename=\"homolog-{id}-{name}.{e}\""));
            assert_eq!(text(&headers, "content-disposition"), disposition);
            let etag = text(&headers, "etag").unwrap();
            let body = by_query.bytes().await.unwrap();
            let by_accept = accepting(&service, &path, &format!("image/png, {media_type};q=0.4")).await;
            assert_eq!(text(by_accept.headers(), "etag").unwrap(), etag);
            assert_eq!(by_accept.bytes().await.unwrap(), body);
            let again = service.client.get(format!("{}{path}?format={format}", service.base));
            let again = again.header("if-none-match", &etag).send().await.unwrap();
            assert_eq!((again.status().as_u16(), text(again.headers(), "vary").as_deref()), (304, Some("accept")));
            etags.push(etag);
        }
        let refused = accepting(&service, &path, "image/png, */*;q=0").await;
        assert_eq!(text(refused.headers(), "vary").as_deref(), Some("accept"));
        let body = problem(refused, 406, "not-acceptable").await;
        let available: Vec<_> =
            body["available"].as_array().unwrap().iter().map(|a| a["format"].as_str().unwrap()).collect();
        assert_eq!(available, formats.iter().map(|f| f.0).collect::<Vec<_>>());
        problem(service.get(&format!("{path}?format=docx")).await, 400, "invalid-query").await;
        problem(service.get(&format!("{path}?format=ply&format=vtk")).await, 400, "invalid-query").await;
    }
    let n_etags = etags.len();
    etags.sort();
    etags.dedup();
    assert_eq!(etags.len(), n_etags, "each representation has a validator of its own");
    let unknown = accepting(&service, "/v1/jobs/00000000-0000-0000-0000-000000000000/aligned", "image/png").await;
    problem(unknown, 404, "job-not-found").await;

    // The page runs only its own script, and without the rights of the service's origin.
    let page = service.get(&format!("{job}/report")).await;
    assert_eq!(
        text(page.headers(), "content-security-policy").unwrap(),
        "sandbox allow-scripts allow-downloads; frame-ancestors 'none'"
    );
    let page = page.text().await.unwrap();
    assert!(page.contains("RELIABLE") && page.contains("dashed: a new round") && !page.contains("Doe^Jane"));

    // All formats have the numbers of the JSON.
    let columns = service.json(&format!("{job}/correspondences")).await;
    let column = |name: &str| columns[name].as_array().unwrap().clone();
    let n = column("source").len();
    assert!(n > 400, "{n}");
    let csv = String::from_utf8(bytes(&service, &format!("{job}/correspondences?format=csv")).await).unwrap();
    assert_eq!(csv.lines().count(), n + 1);
    let npy = bytes(&service, &format!("{job}/correspondences?format=npy")).await;
    for (row, record) in npy[npy.len() - 62 * n..].chunks_exact(62).enumerate() {
        let number = |at: usize| u64::from(u32::from_le_bytes(*record[at..].first_chunk().unwrap()));
        assert_eq!((number(0), number(4)), (column_u64(&columns, "source", row), column_u64(&columns, "target", row)));
        let confidence = f64::from_le_bytes(*record[8..].first_chunk().unwrap());
        assert_eq!(
            (columns["confidence"][row].as_f64(), columns["inlier"][row].as_bool()),
            (Some(confidence), Some(record[16] == 1))
        );
        let spread = f64::from_le_bytes(*record[17..].first_chunk().unwrap());
        let reasons = ["none", "residual", "neighborhood", "both"];
        assert_eq!(
            (columns["spread_mm"][row].as_f64(), columns["outlier"][row].as_str()),
            (Some(spread), Some(reasons[usize::from(record[25])]))
        );
    }
    let source = mesh_of(&bytes(&service, &format!("{job}/surfaces/source")).await);
    assert_eq!(source.arity(), FaceArity::Quad, "faces of voxels");
    for format in ["ply", "vtk", "vtp"] {
        assert_eq!(mesh_of(&bytes(&service, &format!("{job}/correspondences?format={format}")).await), source);
        assert_eq!(mesh_of(&bytes(&service, &format!("{job}/surfaces/source?format={format}")).await), source);
    }
    let stl = mesh_of(&bytes(&service, &format!("{job}/surfaces/source?format=stl")).await);
    assert_eq!((stl.n_faces(), stl.n_vertices()), (2 * source.n_faces(), source.n_vertices()));

    // All formats of the transform describe the same transform.
    let transform = service.json(&format!("{job}/transform")).await;
    assert_eq!(transform, service.json(&format!("{job}/result?correspondences=false")).await["transform"]);
    let matrix = Matrix4::from_fn(|r, c| transform["matrix"][r][c].as_f64().unwrap());
    let aligned = mesh_of(&bytes(&service, &format!("{job}/aligned")).await);
    let moved = matrix.transform_point(&source.vertices()[7]);
    assert!((moved - aligned.vertices()[7]).norm() < 1e-9);
    let table = String::from_utf8(bytes(&service, &format!("{job}/transform?format=text")).await).unwrap();
    let numbers: Vec<f64> = table.split_whitespace().map(|w| w.parse().unwrap()).collect();
    assert_eq!(Matrix4::from_row_slice(&numbers), matrix);
    let tfm = String::from_utf8(bytes(&service, &format!("{job}/transform?format=tfm")).await).unwrap();
    let line = tfm.lines().find_map(|l| l.strip_prefix("Parameters: ")).unwrap();
    let p: Vec<f64> = line.split_whitespace().map(|w| w.parse().unwrap()).collect();
    let itk =
        Matrix4::new(p[0], p[1], p[2], p[9], p[3], p[4], p[5], p[10], p[6], p[7], p[8], p[11], 0.0, 0.0, 0.0, 1.0);
    let lps = |q: &Point3<f64>| Point3::new(-q.x, -q.y, q.z);
    let back = itk.transform_point(&lps(&aligned.vertices()[7]));
    assert!((back - lps(&source.vertices()[7])).norm() < 1e-9, "a point of the target is taken to the source");
    service.end().await;
}

#[tokio::test]
async fn the_source_bent_onto_the_target_lies_on_the_target() {
    let (service, job) = matched().await;
    let columns = service.json(&format!("{job}/correspondences")).await;
    let [source, target] = ["source", "target"].map(|which| format!("{job}/surfaces/{which}"));
    let (source, target) = (mesh_of(&bytes(&service, &source).await), mesh_of(&bytes(&service, &target).await));
    let warped = mesh_of(&bytes(&service, &format!("{job}/warped")).await);
    assert_eq!(warped.indices(), source.indices());
    let number = |name: &str, row: usize, k: usize| columns[name][row][k].as_f64().unwrap();
    for row in (0..columns["source"].as_array().unwrap().len()).step_by(17) {
        let image = (0..3).fold(Point3::origin(), |sum, k| {
            let corner = target.vertices()[number("triangle", row, k) as usize];
            sum + corner.coords * number("barycentric", row, k)
        });
        let vertex = column_u64(&columns, "source", row) as usize;
        assert!((warped.vertices()[vertex] - image).norm() < 1e-9);
    }
    // Every format that keeps vertices holds the same surface; GIFTI has single precision and triangles.
    for format in ["vtk", "vtp"] {
        assert_eq!(mesh_of(&bytes(&service, &format!("{job}/warped?format={format}")).await), warped);
    }
    let gifti = mesh_of(&bytes(&service, &format!("{job}/warped?format=gifti")).await);
    assert!(gifti.vertices().iter().zip(warped.vertices()).all(|(a, b)| (a - b).norm() < 1e-4));
    // Back in the space of the source, the same surface is moved by the inverse of the transform.
    let transform = service.json(&format!("{job}/transform")).await;
    let matrix = Matrix4::from_fn(|r, c| transform["matrix"][r][c].as_f64().unwrap());
    let back = mesh_of(&bytes(&service, &format!("{job}/warped?space=source")).await);
    for (a, b) in back.vertices().iter().zip(warped.vertices()) {
        assert!((matrix.transform_point(a) - b).norm() < 1e-9);
    }
    let table = service.json(&format!("{job}/warped?format=json")).await;
    let residual = table["residual_mm"].as_array().unwrap();
    assert_eq!(residual.len(), source.n_vertices());
    for (k, residual) in residual.iter().enumerate().step_by(29) {
        let length = (matrix.transform_point(&source.vertices()[k]) - warped.vertices()[k]).norm();
        assert!((length - residual.as_f64().unwrap()).abs() < 1e-9);
    }
    assert_eq!(mesh_of(&bytes(&service, &format!("{job}/warped?space=aligned")).await), warped);
    for path in [
        "warped?direction=inverse",
        "correspondences?direction=inverse",
        "correspondences?direction=inverse&format=glb",
    ] {
        let body = problem(service.get(&format!("{job}/{path}")).await, 404, "route-not-found").await;
        assert!(body["detail"].as_str().unwrap().contains("both_directions"), "{body}");
    }
    problem(service.get(&format!("{job}/warped?space=moon")).await, 400, "invalid-query").await;
    service.end().await;
}

fn column_u64(columns: &Value, name: &str, row: usize) -> u64 {
    columns[name][row].as_u64().unwrap()
}

#[tokio::test]
async fn a_stored_part_that_cannot_be_read_is_an_internal_error() {
    // The scripted engine stores text instead of surfaces.
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    for path in ["aligned?format=vtk", "correspondences?format=ply", "transform?format=tfm"] {
        let body = problem(service.get(&format!("/v1/jobs/{id}/{path}")).await, 500, "internal-error").await;
        assert!(body.get("detail").is_none());
    }
    service.end().await;
}
