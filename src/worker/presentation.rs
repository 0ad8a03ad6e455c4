//! Conversion of stored parts of a result to other file formats. Vertex indices are copied as stored: they count the
//! vertices of the uploads (see [`homolog_run`]), which the stored surfaces have.

use crate::jobs::{PartFormat, PresentError, ResultPart};
use homolog_contract::result::{Correspondences, ResultDocument, TransformDocument};
use homolog_formats::arrow::{write_arrow, write_arrow_table};
use homolog_formats::gifti::write_gifti;
use homolog_formats::npy::write_npy;
use homolog_formats::ply::{read_ply, write_ply_with};
use homolog_formats::transform::{write_itk_transform, write_lta, write_matrix_text};
use homolog_formats::vertex_table::{write_csv, write_npy_table};
use homolog_formats::vtk::write_vtk_with;
use homolog_formats::vtp::write_vtp_with;
use homolog_formats::{PairColumns, ReadLimits, VertexArray, VertexValues, write_stl};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::TracePoint;
use homolog_run::{ReportInputs, WarpError, WarpedSurface, warp, write_report};
use serde::Deserialize;

/// Value of `target` for a source vertex without a correspondence; its other values are 0.
pub const NO_TARGET: i32 = -1;

/// A part of a result in `format`, made from the stored blobs of the part: the correspondences (JSON), with the source
/// surface (PLY) for surface formats; the result document (JSON); a surface (PLY); all of these for a bent surface; or these
/// and the energy trace (JSON) for a report.
///
/// # Errors
/// [`PresentError`].
pub fn present(part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
    match (part, stored) {
        (ResultPart::Correspondences, [columns]) => table(&correspondences(columns)?, format),
        (ResultPart::Correspondences, [columns, surface]) => {
            let mesh = surface_mesh(surface)?;
            let arrays = vertex_arrays(&correspondences(columns)?, mesh.n_vertices());
            surface_file(&mesh, &arrays, format)
        }
        (ResultPart::Transform, [result]) => transform(result, format)?,
        (ResultPart::Warped { direction, space }, [result, columns, source, target]) => {
            let surfaces = [surface_mesh(source)?, surface_mesh(target)?];
            let matrix = stored_transform(result)?.matrix;
            let pairs = correspondences(columns)?;
            let warped = warp([&surfaces[0], &surfaces[1]], &pairs, &matrix, direction, space);
            let WarpedSurface { mesh, arrays } = warped.map_err(|error| match error {
                WarpError::NoInverse => PresentError::NoInverse,
                error => unreadable("a bent surface", error),
            })?;
            match format {
                PartFormat::Stl => surface_file(&mesh, &[], format),
                PartFormat::Json => Some(json_table(&arrays).to_string().into_bytes()),
                PartFormat::Csv => Some(write_csv(&arrays)),
                PartFormat::Npy => Some(write_npy_table(&arrays)),
                PartFormat::Arrow => Some(write_arrow_table(&arrays)),
                _ => surface_file(&mesh, &arrays, format),
            }
        }
        (ResultPart::Report, [result, columns, source, target, trace]) => {
            let document: ResultDocument =
                serde_json::from_slice(result).map_err(|error| unreadable("a stored result", error))?;
            let trace: Vec<TracePoint> =
                serde_json::from_slice(trace).map_err(|error| unreadable("a stored energy trace", error))?;
            let (source, target) = (surface_mesh(source)?, surface_mesh(target)?);
            let correspondences = correspondences(columns)?;
            let inputs = ReportInputs {
                document: &document,
                correspondences: &correspondences,
                source: &source,
                target: &target,
                trace: &trace,
            };
            let page = write_report(&inputs).map_err(|error| unreadable("a report", error))?;
            (format == PartFormat::Html).then(|| page.into_bytes())
        }
        (_, [surface]) => surface_file(&surface_mesh(surface)?, &[], format),
        _ => None,
    }
    .ok_or(PresentError::NotOffered { part, format })
}

fn table(pairs: &Correspondences, format: PartFormat) -> Option<Vec<u8>> {
    let Correspondences { source, target, confidence, inlier, spread_mm, outlier, triangle, barycentric, .. } = pairs;
    let outlier: Vec<u8> = outlier.iter().map(|reason| reason.code()).collect();
    let columns =
        PairColumns { source, target, confidence, inlier, spread_mm, outlier: &outlier, triangle, barycentric };
    match format {
        PartFormat::Csv => Some(pairs.to_csv().into_bytes()),
        PartFormat::Npy => Some(write_npy(&columns)),
        PartFormat::Arrow => Some(write_arrow(&columns)),
        _ => None,
    }
}

fn surface_file(mesh: &SurfaceMesh, arrays: &[VertexArray], format: PartFormat) -> Option<Vec<u8>> {
    match format {
        PartFormat::Ply => Some(write_ply_with(mesh, arrays)),
        PartFormat::Vtk => Some(write_vtk_with(mesh, arrays)),
        PartFormat::Vtp => Some(write_vtp_with(mesh, arrays)),
        PartFormat::Gifti => Some(write_gifti(mesh, arrays)),
        // STL cannot hold arrays.
        PartFormat::Stl if arrays.is_empty() => Some(write_stl(mesh)),
        _ => None,
    }
}

/// The columns as arrays over all vertices of the source surface.
fn vertex_arrays(pairs: &Correspondences, n_vertices: usize) -> Vec<VertexArray> {
    let mut target = vec![NO_TARGET; n_vertices];
    let mut confidence = vec![0.0; n_vertices];
    let mut inlier = vec![0; n_vertices];
    let mut spread_mm = vec![0.0; n_vertices];
    let mut outlier = vec![0; n_vertices];
    for row in 0..pairs.source.len() {
        let vertex = pairs.source[row] as usize;
        if vertex < n_vertices {
            target[vertex] = i32::try_from(pairs.target[row]).unwrap_or(NO_TARGET);
            confidence[vertex] = pairs.confidence[row];
            inlier[vertex] = u8::from(pairs.inlier[row]);
            spread_mm[vertex] = pairs.spread_mm[row];
            outlier[vertex] = pairs.outlier[row].code();
        }
    }
    vec![
        VertexArray { name: "target", values: VertexValues::Int(target) },
        VertexArray { name: "confidence", values: VertexValues::Real(confidence) },
        VertexArray { name: "inlier", values: VertexValues::Byte(inlier) },
        VertexArray { name: "spread_mm", values: VertexValues::Real(spread_mm) },
        VertexArray { name: "outlier", values: VertexValues::Byte(outlier) },
    ]
}

fn transform(result: &[u8], format: PartFormat) -> Result<Option<Vec<u8>>, PresentError> {
    let transform = stored_transform(result)?;
    Ok(match format {
        PartFormat::Json => Some(serde_json::to_vec(&transform).map_err(|e| unreadable("a transform as JSON", e))?),
        PartFormat::Text => Some(write_matrix_text(&transform.matrix).into_bytes()),
        PartFormat::Itk => {
            let text = write_itk_transform(&transform.matrix);
            Some(text.ok_or(PresentError::Unreadable { what: "a matrix without inverse", source: None })?.into_bytes())
        }
        PartFormat::Lta => Some(write_lta(&transform.matrix).into_bytes()),
        _ => None,
    })
}

fn stored_transform(result: &[u8]) -> Result<TransformDocument, PresentError> {
    /// The only member of the result document that is needed here.
    #[derive(Deserialize)]
    struct Stored {
        transform: TransformDocument,
    }
    let stored: Stored = serde_json::from_slice(result).map_err(|error| unreadable("a stored transform", error))?;
    Ok(stored.transform)
}

/// The arrays as an object of columns.
fn json_table(arrays: &[VertexArray]) -> serde_json::Value {
    let column = |values: &VertexValues| match values {
        VertexValues::Int(v) => serde_json::json!(v),
        VertexValues::Real(v) => serde_json::json!(v),
        VertexValues::Byte(v) => serde_json::json!(v),
    };
    arrays.iter().map(|array| (array.name.to_owned(), column(&array.values))).collect::<serde_json::Map<_, _>>().into()
}

fn correspondences(stored: &[u8]) -> Result<Correspondences, PresentError> {
    let pairs: Correspondences =
        serde_json::from_slice(stored).map_err(|error| unreadable("stored correspondences", error))?;
    pairs.completed().ok_or(PresentError::Unreadable { what: "columns of unequal length", source: None })
}

/// A surface that this program wrote. The limits for uploads do not apply: they may have been lowered since.
fn surface_mesh(stored: &[u8]) -> Result<SurfaceMesh, PresentError> {
    let limits = ReadLimits { max_vertices: usize::MAX, ..ReadLimits::default() };
    read_ply(stored, &limits).map(|file| file.mesh).map_err(|error| unreadable("a stored surface", error))
}

fn unreadable(what: &'static str, error: impl std::error::Error + Send + Sync + 'static) -> PresentError {
    PresentError::Unreadable { what, source: Some(Box::new(error)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_contract::result::OutlierReason;

    #[test]
    fn vertices_without_a_correspondence_are_filled_as_documented() {
        let pairs = Correspondences {
            source: vec![3, 1, 9],
            target: vec![7, 0, 2],
            confidence: vec![0.5, 0.25, 1.0],
            inlier: vec![true, false, true],
            spread_mm: vec![0.5, 3.0, 1.0],
            outlier: vec![OutlierReason::None, OutlierReason::Both, OutlierReason::Residual],
            ..Correspondences::default()
        };
        let arrays = vertex_arrays(&pairs, 5);
        let values: Vec<_> = arrays.into_iter().map(|array| (array.name, array.values)).collect();
        let expected = [
            ("target", VertexValues::Int(vec![NO_TARGET, 0, NO_TARGET, 7, NO_TARGET])),
            ("confidence", VertexValues::Real(vec![0.0, 0.25, 0.0, 0.5, 0.0])),
            ("inlier", VertexValues::Byte(vec![0, 0, 0, 1, 0])),
            ("spread_mm", VertexValues::Real(vec![0.0, 3.0, 0.0, 0.5, 0.0])),
            ("outlier", VertexValues::Byte(vec![0, 3, 0, 0, 0])),
        ];
        assert_eq!(values, expected, "a row of a vertex that the surface does not have is skipped");
    }

    #[test]
    fn a_format_that_a_part_does_not_have_is_refused() {
        let columns = br#"{"source": [], "target": [], "confidence": [], "inlier": []}"#.as_slice();
        for (part, format) in [(ResultPart::Correspondences, PartFormat::Lta), (ResultPart::Aligned, PartFormat::Stl)] {
            let error = present(part, format, &[columns]).unwrap_err();
            let refused = matches!(error, PresentError::NotOffered { .. });
            assert_eq!(refused, part == ResultPart::Correspondences, "{error}");
        }
    }
}
