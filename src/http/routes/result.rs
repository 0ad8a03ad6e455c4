//! `/v1/jobs/{id}/result`, `/correspondences` and `/transform`.

use super::job_id;
use crate::http::auth::Reader;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::query::QueryString;
use crate::http::representation::answer;
use crate::http::router::HttpState;
use crate::http::wire::{JobResultDocument, ResultLinks};
use crate::jobs::documents::{Correspondences, TransformDocument};
use crate::jobs::{ArtifactKind, JobError, ResultPart};
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;

/// Read the result
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", operation_id = "get_result",
    params(
        ("id" = String, Path, description = "The job"),
        ("correspondences" = Option<bool>, Query, description = "`false` leaves the correspondences out"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The result", body = JobResultDocument, headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn result(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let with_correspondences = query.word("correspondences", &[("true", true), ("false", false)]).unwrap_or(true);
    query.finish()?;
    let id = job_id(&id)?;
    let document = state.service.result_part(&tenant, id, ArtifactKind::Result).await?;
    // Results never change, so the address of the blob is the validator.
    let form = if with_correspondences { "full" } else { "brief" };
    let etag = format!("\"{}-{form}\"", &document.key.hash()[..32]);
    if is_fresh(&headers, &etag) {
        return Ok(not_modified(&etag));
    }
    // Stored JSON objects are joined as they are: numbers come out to the digit as they were written.
    let stored = state.service.read(&document).await?;
    let mut body = stored.strip_suffix(b"}").ok_or_else(unreadable)?.to_vec();
    if with_correspondences {
        let part = state.service.result_part(&tenant, id, ArtifactKind::Correspondences).await?;
        body.extend_from_slice(b",\"correspondences\":");
        body.extend_from_slice(&state.service.read(&part).await?);
    }
    body.extend_from_slice(b",\"links\":");
    body.extend(serde_json::to_vec(&ResultLinks::of(id)).map_err(|e| Problem::internal(&e))?);
    body.push(b'}');
    Ok(respond(&headers, &etag, "application/json", body))
}

/// Read the dense correspondence
///
/// As a table with a row for each pair: JSON in columns, CSV, NumPy (`.npy`, one structured array) or Arrow (IPC file,
/// also known as Feather 2), each with `source`, `target`, `confidence`, `inlier`,
/// `spread_mm` and `outlier`, a word in JSON and CSV, else 0 none, 1 residual, 2 neighborhood, 3 both, 4 no_counterpart; and the point of
/// the target that is the image, between vertices: its `triangle` and `barycentric` weights, three numbers each.
///
/// Or as the source surface with these values for each vertex: PLY (properties), legacy VTK (`POINT_DATA`) or GIFTI
/// (further data arrays; single precision, quads cut in two). A vertex without a correspondence has `target` −1,
/// `confidence` 0 and `inlier` 0.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/correspondences", tag = "results", operation_id = "get_correspondences",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`json`, `csv`, `npy`, `arrow`, `ply`, `vtk` or `gifti`; goes before `Accept`, JSON if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The correspondence", content(
            (Correspondences = "application/json"), (String = "text/csv"), (Vec<u8> = "application/x-npy"),
            (Vec<u8> = "application/vnd.apache.arrow.file"), (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"),
            (String = "application/gifti+xml"),
        ), headers(
            ("ETag" = String, description = "Of this format"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "A name for the file; not with JSON"),
        )),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "No format that `Accept` allows; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn correspondences(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    answer(&state, &tenant, job_id(&id)?, ResultPart::Correspondences, &headers, query).await
}

/// Read the rigid transform
///
/// It moves points of the source onto the target: `p' = R p + t`, in millimetres and the coordinates of the inputs.
///
/// JSON as in the result; plain text, four lines of four numbers (`numpy.loadtxt`); an ITK transform file (`tfm`) or a
/// FreeSurfer linear transform array (`lta`). The last two take the inputs' coordinates for RAS, as in NIfTI.
///
/// The ITK file holds what ITK, ANTs and 3D Slicer expect: LPS coordinates, and the map from points of the target
/// (fixed) to points of the source (moving), which is the inverse of the JSON's matrix. Use it as it is to resample the
/// source image onto the target's grid; in 3D Slicer apply it to the source. The FreeSurfer file is of type 1 (RAS to
/// RAS), source to target, with both volume geometries marked invalid, as they are not known.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/transform", tag = "results", operation_id = "get_transform",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`json`, `text`, `tfm` or `lta`; goes before `Accept`, JSON if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The transform", content(
            (TransformDocument = "application/json"), (String = "text/plain"), (String = "application/x-itk-transform"),
            (String = "application/x-freesurfer-lta"),
        ), headers(
            ("ETag" = String, description = "Of this format"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "A name for the file; not with JSON and text"),
        )),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "No format that `Accept` allows; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn transform(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    answer(&state, &tenant, job_id(&id)?, ResultPart::Transform, &headers, query).await
}

fn unreadable() -> Problem {
    Problem::internal(&JobError::Corrupt { what: "a stored result", source: None })
}
