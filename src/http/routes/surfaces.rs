//! `/v1/jobs/{id}/surfaces/{which}`, `/volumes/{which}`, `/aligned` and `/warped`: surfaces and volumes as files.

use super::result::direction;
use crate::http::call::AuthorizedRequest;
use crate::http::compression::Gains;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::content::Counted;
use crate::http::problem::Problem;
use crate::http::problem_table::ProblemKind;
use crate::http::representation::answer;
use crate::jobs::{JobId, ResultPart, WarpDirection, WarpSpace};
use axum::body::Body;
use axum::response::Response;
use serde_json::Value;

/// Get a matched surface
///
/// The surface whose vertices the correspondences refer to. Binary PLY, legacy VTK and VTP are exact and keep quads. GIFTI and
/// STL have single precision and triangles only, so quads are split. STL has no shared vertices, so the vertex indices of
/// the correspondences do not apply to it.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/surfaces/{which}",
    params(("which" = String, Path, description = "`source` or `target`")),
    responses((status = 200, description = "The surface, mm"))
)]
pub(crate) async fn surface(call: AuthorizedRequest) -> Result<Response, Problem> {
    let part = match call.segment(1) {
        "source" => ResultPart::SourceSurface,
        "target" => ResultPart::TargetSurface,
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("the surface must be source or target")),
    };
    answer(call, part).await
}

/// Get the label volume of an input
///
/// The volume from which a matched surface was made, as NIfTI whatever the format that was sent (MGZ, NRRD, MetaImage, DICOM SEG):
/// all its labels as the service reads them, in the coordinates of the surface. There as long as the inputs of the job.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/volumes/{which}",
    params(("which" = String, Path, description = "`source` or `target`")),
    responses((status = 200, description = "The volume, NIfTI compressed with gzip", content_type = "application/octet-stream", body = Vec<u8>))
)]
pub(crate) async fn volume(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let id: JobId = call.last_id()?;
    let job = call.service().get(&call.tenant, id).await?;
    let (side, input) = match call.segment(1) {
        "source" => ("source", &job.source),
        "target" => ("target", &job.target),
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("the volume must be that of source or target")),
    };
    // Only volumes have a size of voxels.
    if input.report.get("sampling").is_none_or(Value::is_null) {
        return Err(Problem::new(ProblemKind::RouteNotFound).detail("the input is a surface and has no volume"));
    }
    let etag = format!("\"{}-{side}-{}-volume\"", job.id, env!("CARGO_PKG_VERSION"));
    if is_fresh(&call.headers, &etag) && job.purged_at.is_none() {
        return Ok(not_modified(&etag));
    }
    let bytes = call.service().job_volume(&job, side).await?;
    let memory = call.memory(bytes.len()).await?;
    let body = Body::new(Counted::new(bytes.into(), memory));
    let mut response = respond(&call.headers, &etag, "application/octet-stream", body);
    response.extensions_mut().insert(Gains(false));
    Ok(response)
}

/// Get the aligned source surface
///
/// The source surface moved onto the target by the rigid transform alone, in the formats of the matched surfaces: its shape
/// is unchanged. The source deformed onto the target is `/warped`.
#[utoipa::path(get, path = "/v1/jobs/{id}/aligned", responses((status = 200, description = "The surface, mm")))]
pub(crate) async fn aligned(call: AuthorizedRequest) -> Result<Response, Problem> {
    answer(call, ResultPart::Aligned).await
}

/// Get the source deformed onto the target
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
    get, path = "/v1/jobs/{id}/warped",
    params(
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `vtp`, `gifti`, `stl` or `glb`, or one of the tables and `dicom`; takes precedence over `Accept`; PLY if neither is given"),
        ("direction" = Option<String>, Query, description = "`forward` (default): the source is deformed onto the target; `inverse`: the target onto the source, if the job had `both_directions`"),
        ("space" = Option<String>, Query, description = "Coordinates of the answer, `target` or `source`; by default those of the surface onto which the other is bent. In the other space the same shape is moved rigidly. `aligned` is another name for `target`: the space of `/aligned`"),
    ),
    responses(
        (status = 200, description = "The surface, mm", headers(("Content-Disposition" = String, description = "Suggested file name; not with JSON"))),
    )
)]
pub(crate) async fn warped(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let direction = direction(&mut call.query);
    let own = match direction {
        WarpDirection::Forward => WarpSpace::Target,
        WarpDirection::Inverse => WarpSpace::Source,
    };
    let names = [WarpSpace::Source, WarpSpace::Target].map(|space| (space.name(), space));
    let spaces = [names[0], names[1], ("aligned", WarpSpace::Target)];
    let space = call.query.word("space", &spaces).unwrap_or(own);
    answer(call, ResultPart::Warped { direction, space }).await
}
