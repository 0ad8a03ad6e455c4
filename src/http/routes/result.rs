//! `/v1/jobs/{id}/result`, `/correspondences`, `/transform` and `/report`.

use crate::http::call::AuthorizedRequest;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::problem::Problem;
use crate::http::query::QueryString;
use crate::http::representation::answer;
use crate::http::wire::{JobResultDocument, ResultLinks};
use crate::jobs::documents::{Correspondences, TransformDocument};
use crate::jobs::{ArtifactKind, BlobStream, JobError, ResultPart, WarpDirection};
use axum::body::Body;
use axum::http::header;
use axum::response::Response;
use bytes::Bytes;
use futures_util::StreamExt as _;

/// Get the result
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result",
    params(("correspondences" = Option<bool>, Query, description = "`false` omits the correspondences")),
    responses((status = 200, description = "The result", body = JobResultDocument))
)]
pub(crate) async fn result(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let with_correspondences = call.query.word("correspondences", &[("true", true), ("false", false)]).unwrap_or(true);
    call.query.finish()?;
    let id = call.id()?;
    let document = call.service().result_part(&call.tenant, id, ArtifactKind::Result).await?;
    // Results never change, so the hash of the blob is the ETag.
    let form = if with_correspondences { "full" } else { "brief" };
    let etag = format!("\"{}-{form}\"", &document.key.hash()[..32]);
    if is_fresh(&call.headers, &etag) {
        return Ok(not_modified(&etag));
    }
    // Stored JSON objects are joined as text, so that every number keeps its digits. The correspondences, by far the
    // largest part, are streamed.
    let stored = call.service().read(&document).await?;
    let mut head = stored.strip_suffix(b"}").ok_or_else(unreadable)?.to_vec();
    let mut tail = b",\"links\":".to_vec();
    tail.extend(serde_json::to_vec(&ResultLinks::of(id)).map_err(|e| Problem::internal(&e))?);
    tail.push(b'}');
    let mut length = (head.len() + tail.len()) as u64;
    let mut columns: BlobStream = futures_util::stream::empty().boxed();
    if with_correspondences {
        let part = call.service().result_part(&call.tenant, id, ArtifactKind::Correspondences).await?;
        let name = b",\"correspondences\":";
        head.extend_from_slice(name);
        length += name.len() as u64 + part.n_bytes;
        columns = call.service().open(&part, None).await?;
    }
    let text = |text: Vec<u8>| futures_util::stream::iter([Ok(Bytes::from(text))]);
    let body: BlobStream = text(head).chain(columns).chain(text(tail)).boxed();
    let mut response = respond(&call.headers, &etag, "application/json", Body::from_stream(body));
    response.headers_mut().insert(header::CONTENT_LENGTH, length.into());
    Ok(response)
}

/// Get the dense correspondence
///
/// Either as a table with a row for each corresponding pair: JSON (an array for each column), CSV, NumPy (`.npy`, one
/// structured array; `.npz`, an array for each column), Arrow (IPC file, also known as Feather 2) or Parquet. The columns are `source` and `target` (vertex indices),
/// `confidence`, `inlier`, `spread_mm`, `outlier` (a word in JSON and CSV, else 0 none, 1 residual, 2 neighborhood, 3 both,
/// 4 no_counterpart), and the corresponding point on the target surface, which lies between vertices: the vertices of its
/// `triangle` and its `barycentric` coordinates, three numbers each.
///
/// Or as the source surface with these values at each vertex: PLY (properties), legacy VTK and VTP (point data) or GIFTI (further
/// data arrays; single precision, quads split into triangles). The corners and weights are
/// `triangle_0` to `triangle_2` and `barycentric_0` to `barycentric_2`. A vertex without a correspondence has `target` and corners −1,
/// `confidence` 0 and `inlier` 0. Or as glTF (`glb`), for browsers: the source moved rigidly onto the target, and the target,
/// corresponding points in one color.
///
/// Described here is the answer in JSON, the default. Generated clients get the other formats as bytes from `download_file`, as
/// `correspondences.csv` and so on.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/correspondences",
    params(
        ("format" = Option<String>, Query, description = "`json`, `csv`, `npy`, `npz`, `arrow`, `parquet`, `ply`, `vtk`, `vtp`, `gifti` or `glb`; takes precedence over `Accept`; JSON if neither is given"),
        ("direction" = Option<String>, Query, description = "`forward` (default): from source to target; `inverse`: from target to source, if the job had `both_directions`; `source` is then a vertex of the target, and `target` one of the source"),
    ),
    responses(
        (status = 200, description = "The correspondence", body = Correspondences, headers(("Content-Disposition" = String, description = "Suggested file name; not with JSON"))),
    )
)]
pub(crate) async fn correspondences(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let direction = direction(&mut call.query);
    answer(call, ResultPart::Correspondences { direction }).await
}

/// `?direction=`; the default is from source to target.
pub(super) fn direction(query: &mut QueryString) -> WarpDirection {
    let both = [WarpDirection::Forward, WarpDirection::Inverse].map(|direction| (direction.name(), direction));
    query.word("direction", &both).unwrap_or(WarpDirection::Forward)
}

/// Get the rigid transform
///
/// It maps points of the source to points of the target, `p' = R p + t`, in millimeters, in the coordinates of the inputs.
///
/// Formats: JSON as in the result; plain text, four lines of four numbers (`numpy.loadtxt`); an ITK transform file (`tfm`);
/// a FreeSurfer linear transform array (`lta`); a DICOM Spatial Registration (`dicom`). `tfm` and `lta` assume that the inputs
/// have RAS coordinates, as in NIfTI; LPS coordinates of DICOM, NRRD and of meshes that declare them are converted on reading.
///
/// The Spatial Registration maps the frame of reference of the source to that of the target, in LPS as DICOM has it, and belongs
/// to the patient and the study of the source, or of the target if the source is no DICOM object. An input that is none has the frame
/// of reference that the request gives, or one named by its content. 406 if neither is one and no `study_uid` is given.
///
/// The ITK file follows the convention of ITK, ANTs and 3D Slicer: LPS coordinates, and the map from points of the target
/// (fixed) to points of the source (moving), which is the inverse of the matrix in JSON. Use it unchanged to resample the
/// source image onto the grid of the target; in 3D Slicer apply it to the source. The FreeSurfer file is of type 1 (RAS to
/// RAS), from source to target, with both volume geometries marked invalid because they are unknown.
///
/// Described here is the answer in JSON, the default. Generated clients get the other formats as bytes from `download_file`, as
/// `transform.tfm` and so on.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/transform",
    params(("format" = Option<String>, Query, description = "`json`, `text`, `tfm`, `lta` or `dicom`; takes precedence over `Accept`; JSON if neither is given")),
    responses(
        (status = 200, description = "The transform", body = TransformDocument, headers(("Content-Disposition" = String, description = "Suggested file name; not with JSON and text"))),
    )
)]
pub(crate) async fn transform(call: AuthorizedRequest) -> Result<Response, Problem> {
    answer(call, ResultPart::Transform).await
}

/// Get the report
///
/// One HTML page for people, which loads nothing from anywhere: first whether the answer can be relied on and why not, then
/// both surfaces, to be turned with the mouse, in corresponding colors or colored by confidence or residual, the energy over
/// the iterations, and all numbers, parameters and hashes. It contains no file names.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/report",
    params(("format" = Option<String>, Query, description = "`html`")),
    responses(
        (status = 200, description = "The page", content((String = "text/html")), headers(("ETag" = String, description = "Of this page"))),
    )
)]
pub(crate) async fn report(call: AuthorizedRequest) -> Result<Response, Problem> {
    answer(call, ResultPart::Report).await
}

fn unreadable() -> Problem {
    Problem::internal(&JobError::Corrupt { what: "a stored result", source: None })
}
