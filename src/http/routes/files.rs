//! `/v1/jobs/{id}/files/{name}`: every part of a result in every format, as bytes.

use crate::http::call::AuthorizedRequest;
use crate::http::problem::Problem;
use crate::http::problem_table::ProblemKind;
use crate::http::representation::{answer_file, given_uids};
use crate::jobs::{JobId, PartFormat, ResultPart, WarpDirection, WarpSpace};
use axum::response::Response;

/// The parts that are files.
const PARTS: [ResultPart; 9] = [
    ResultPart::Correspondences { direction: WarpDirection::Forward },
    ResultPart::Correspondences { direction: WarpDirection::Inverse },
    ResultPart::Transform,
    ResultPart::SourceSurface,
    ResultPart::TargetSurface,
    ResultPart::Aligned,
    ResultPart::Warped { direction: WarpDirection::Forward, space: WarpSpace::Target },
    ResultPart::Warped { direction: WarpDirection::Inverse, space: WarpSpace::Source },
    ResultPart::Report,
];

/// The part and the format in a file name, such as `warped.ply`.
fn parse(name: &str) -> Option<(ResultPart, PartFormat)> {
    let (part, format) = name.split_once('.')?;
    let part = PARTS.into_iter().find(|one| one.name() == part)?;
    Some((part, part.formats().iter().copied().find(|one| one.name() == format)?))
}

/// Download a file
///
/// A part of the result in one format, as bytes. The answer is `application/octet-stream` whatever the format, so that
/// generated clients hand it over unread.
///
/// | name | formats |
/// |---|---|
/// | `correspondences`, `correspondences-inverse` | `json`, `csv`, `npy`, `npz`, `arrow`, `parquet`, `ply`, `vtk`, `vtp`, `gifti`, `glb` |
/// | `transform` | `json`, `text`, `tfm`, `lta`, `dicom` |
/// | `source`, `target`, `aligned` | `ply`, `vtk`, `vtp`, `gifti`, `stl`, `glb` |
/// | `warped`, `warped-inverse` | the same, and `json`, `csv`, `npy`, `npz`, `arrow`, `parquet`, `dicom` |
/// | `report` | `html` |
///
/// A warped surface has the coordinates of the surface onto which it is bent.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/files/{name}",
    params(("name" = String, Path, description = "A part and a format, such as `correspondences.csv` or `warped.ply`")),
    responses(
        (status = 200, description = "The file", content_type = "application/octet-stream", body = Vec<u8>, headers(("ETag" = String, description = "Of this file"), ("Content-Disposition" = String, description = "Suggested file name"))),
        (status = 206, description = "The range of the file", content_type = "application/octet-stream", body = Vec<u8>, headers(("Content-Range" = String, description = "The range, and the size of the whole"))),
    )
)]
pub(crate) async fn download(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let named = parse(call.segment(1));
    let uids = named.map_or_else(Default::default, |(part, _)| given_uids(part, &mut call.query));
    call.query.finish()?;
    let id: JobId = call.id()?;
    let Some((part, format)) = named else {
        // The job comes first, so that the answer reveals nothing about jobs of other tenants.
        call.service().get(&call.tenant, id).await?;
        let detail = "the name must be that of a part and a format, such as correspondences.csv or warped.ply";
        return Err(Problem::new(ProblemKind::RouteNotFound).detail(detail));
    };
    answer_file(&call, id, (part, format, uids)).await
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_part_has_a_name_of_its_own_in_every_format() {
        let mut names = BTreeSet::new();
        for part in PARTS {
            for &format in part.formats() {
                let name = format!("{}.{}", part.name(), format.name());
                assert_eq!(parse(&name), Some((part, format)));
                names.insert(name);
            }
        }
        assert_eq!(names.len(), PARTS.iter().map(|part| part.formats().len()).sum::<usize>());
        for none in ["", ".", "warped", "warped.", ".ply", "warped.tfm", "warped.ply.gz", "Warped.ply", "../result"] {
            assert_eq!(parse(none), None, "{none}");
        }
    }
}
