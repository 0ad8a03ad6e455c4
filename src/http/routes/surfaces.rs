//! `/v1/jobs/{id}/surfaces/{which}`, `/volumes/{which}`, `/aligned` and `/warped`: surfaces and volumes as files.

use super::job_id;
use super::result::direction;
use crate::http::auth::Reader;
use crate::http::compression::Gains;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::content::Counted;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::representation::{Asking, answer};
use crate::http::router::HttpState;
use crate::http::shares::Origin;
use crate::jobs::{ResultPart, WarpDirection, WarpSpace};
use axum::body::Body;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, Method};
use axum::response::Response;
use serde_json::Value;

/// Get a matched surface
///
/// The surface whose vertices the correspondences refer to. Binary PLY, legacy VTK and VTP are exact and keep quads. GIFTI and
/// STL have single precision and triangles only, so quads are split. STL has no shared vertices, so the vertex indices of
/// the correspondences do not apply to it.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/surfaces/{which}", tag = "results", operation_id = "get_surface",
    params(
        ("id" = String, Path, description = "The job"),
        ("which" = String, Path, description = "`source` or `target`"),
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `vtp`, `gifti`, `stl` or `glb`; takes precedence over `Accept`; PLY if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface, mm", content(
            (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"), (String = "application/vnd.vtk.vtp"),
            (String = "application/gifti+xml"), (Vec<u8> = "model/stl"), (Vec<u8> = "model/gltf-binary"),
        ), headers(
            ("ETag" = String, description = "Of this representation"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "Suggested file name"),
        )),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job or surface", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "`Accept` allows none of the formats; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn surface(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path((id, which)): Path<(String, String)>,
    method: Method,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    let part = match which.as_str() {
        "source" => ResultPart::SourceSurface,
        "target" => ResultPart::TargetSurface,
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("the surface must be source or target")),
    };
    answer(&state, &tenant, job_id(&id)?, part, Asking { method: &method, headers: &headers, origin }, query).await
}

/// Get the label volume of an input
///
/// The volume from which a matched surface was made, as NIfTI whatever the format that was sent (MGZ, NRRD, MetaImage, DICOM SEG):
/// all its labels as the service reads them, in the coordinates of the surface. There as long as the inputs of the job.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/volumes/{which}", tag = "results", operation_id = "get_volume",
    params(
        ("id" = String, Path, description = "The job"),
        ("which" = String, Path, description = "`source` or `target`"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The volume, NIfTI compressed with gzip", content_type = "application/octet-stream", body = Vec<u8>, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 410, description = "The inputs were deleted at the end of their retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job, or its input is a surface", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn volume(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path((id, which)): Path<(String, String)>,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let job = state.service.get(&tenant, job_id(&id)?).await?;
    let (side, input) = match which.as_str() {
        "source" => ("source", &job.source),
        "target" => ("target", &job.target),
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("the volume must be that of source or target")),
    };
    // Only volumes have a size of voxels.
    if input.report.get("sampling").is_none_or(Value::is_null) {
        return Err(Problem::new(ProblemKind::RouteNotFound).detail("the input is a surface and has no volume"));
    }
    let etag = format!("\"{}-{side}-{}-volume\"", job.id, env!("CARGO_PKG_VERSION"));
    if is_fresh(&headers, &etag) && job.purged_at.is_none() {
        return Ok(not_modified(&etag));
    }
    let bytes = state.service.job_volume(&job, side).await?;
    let memory = state.answer_memory(&tenant, origin, bytes.len()).await?;
    let body = Body::new(Counted::new(bytes.into(), memory));
    let mut response = respond(&headers, &etag, "application/octet-stream", body);
    response.extensions_mut().insert(Gains(false));
    Ok(response)
}

/// Get the aligned source surface
///
/// The source surface moved onto the target by the rigid transform alone, in the formats of the matched surfaces: its shape
/// is unchanged. The source bent onto the target is `/warped`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/aligned", tag = "results", operation_id = "get_aligned",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `vtp`, `gifti`, `stl` or `glb`; takes precedence over `Accept`; PLY if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface, mm", content(
            (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"), (String = "application/vnd.vtk.vtp"),
            (String = "application/gifti+xml"), (Vec<u8> = "model/stl"), (Vec<u8> = "model/gltf-binary"),
        ), headers(
            ("ETag" = String, description = "Of this representation"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "Suggested file name"),
        )),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "`Accept` allows none of the formats; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn aligned(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    answer(
        &state,
        &tenant,
        job_id(&id)?,
        ResultPart::Aligned,
        Asking { method: &method, headers: &headers, origin },
        query,
    )
    .await
}

/// Get the source bent onto the target
///
/// Every vertex of the source at its corresponding point on the target, with the faces of the source: the same vertex index
/// is the same anatomical place in every source that was matched to one target and bent with `direction=inverse`, and in the
/// source itself otherwise.
///
/// Each vertex has the deformation with the rigid transform taken out: `displacement_x_mm`, `displacement_y_mm`,
/// `displacement_z_mm` (in the coordinates of `space`), `displacement_normal_mm` (along the outward normal), `residual_mm`
/// (its length), `area_ratio` (area around the vertex after bending over that before), `confidence`, `spread_mm` and
/// `outlier` (0 none, 1 residual, 2 neighborhood, 3 both, 4 no counterpart). PLY, legacy VTK, VTP and GIFTI hold them with
/// the surface; STL holds the surface alone, glTF (`glb`) the surface colored by
/// residual; JSON, CSV, NumPy, Arrow and Parquet hold the values alone, a row for each vertex, with its new place `image_x_mm`,
/// `image_y_mm`, `image_z_mm`. `dicom` is a DICOM segmentation (SEG), if an input is a DICOM object or `study_uid` is given: the
/// voxels that the bent surface encloses, on the grid and in the frame of reference of the input of `space`, in the study of
/// that input, or of the other if that is no DICOM object, or in the given one.
///
/// Described here are the answers with a surface. The tables are `warped.csv` and so on of `download_file`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/warped", tag = "results", operation_id = "get_warped",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `vtp`, `gifti`, `stl` or `glb`, or one of the tables and `dicom`; takes precedence over `Accept`; PLY if neither is given"),
        ("direction" = Option<String>, Query, description = "`forward` (default): the source is bent onto the target; `inverse`: the target onto the source, if the job had `both_directions`"),
        ("space" = Option<String>, Query, description = "Coordinates of the answer, `target` or `source`; by default those of the surface onto which the other is bent. In the other space the same shape is moved rigidly. `aligned` is another name for `target`: the space of `/aligned`"),
        ("study_uid" = Option<String>, Query, description = "`dicom`: UID of the study, used where neither input is a DICOM object; its patient is left empty", max_length = 64),
        ("source_frame_uid" = Option<String>, Query, description = "`dicom`: UID of the frame of reference of the source, used where it states none", max_length = 64),
        ("target_frame_uid" = Option<String>, Query, description = "`dicom`: UID of the frame of reference of the target, used where it states none", max_length = 64),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface, mm", content(
            (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"), (String = "application/vnd.vtk.vtp"),
            (String = "application/gifti+xml"), (Vec<u8> = "model/stl"), (Vec<u8> = "model/gltf-binary"),
        ), headers(
            ("ETag" = String, description = "Of this representation"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "Suggested file name; not with JSON"),
        )),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job, or no inverse correspondences", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "`Accept` allows none of the formats; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn warped(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    origin: Origin,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let direction = direction(&mut query);
    let own = match direction {
        WarpDirection::Forward => WarpSpace::Target,
        WarpDirection::Inverse => WarpSpace::Source,
    };
    let names = [WarpSpace::Source, WarpSpace::Target].map(|space| (space.name(), space));
    let spaces = [names[0], names[1], ("aligned", WarpSpace::Target)];
    let space = query.word("space", &spaces).unwrap_or(own);
    let asking = Asking { method: &method, headers: &headers, origin };
    answer(&state, &tenant, job_id(&id)?, ResultPart::Warped { direction, space }, asking, query).await
}
