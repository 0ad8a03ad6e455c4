//! Conversion of stored parts of a result to other file formats. Vertex indices are copied as stored: they number the
//! vertices of the uploads (see [`homolog_run`]), which are also those of the stored surfaces.

use crate::jobs::{DicomDetails, PartFormat, PresentError, ResultPart};
use homolog_contract::result::{Correspondences, ResultDocument, TransformDocument, WarpDirection, WarpSpace};
use homolog_formats::arrow::{write_arrow, write_arrow_table};
use homolog_formats::gifti::write_gifti;
use homolog_formats::glb::{ColoredSurface, write_glb};
use homolog_formats::npy::write_npy;
use homolog_formats::npz::{write_npz, write_npz_table};
use homolog_formats::parquet::{write_parquet, write_parquet_table};
use homolog_formats::ply::{read_ply, write_ply_with};
use homolog_formats::segmentation::{SegmentationError, SegmentedFiles, write_segmentation};
use homolog_formats::spatial_registration::{RegisteredFiles, write_spatial_registration};
use homolog_formats::transform::{write_itk_transform, write_matrix_text};
use homolog_formats::vertex_table::{write_csv, write_npy_table};
use homolog_formats::vtk::write_vtk_with;
use homolog_formats::vtp::write_vtp_with;
use homolog_formats::{PairColumns, ReadLimits, VertexArray, VertexValues, write_stl};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::TracePoint;
use homolog_run::{
    Colors, ReportInputs, WarpError, WarpedSurface, lta, segment_label, value_colors, warp, write_report,
};
use serde::Deserialize;

/// Value of `target` and of the corners of the triangle for a source vertex without a correspondence; its other values
/// are 0.
pub const NO_TARGET: i32 = -1;

/// A part of a result in `format`, made from the part's stored blobs. These are: for correspondences, the
/// correspondences (JSON), and the source surface (PLY) for surface formats; the result document (JSON); a surface
/// (PLY); all of these for a bent surface; all of these and the energy trace (JSON) for a report. LTA also needs both
/// uploads, DICOM both uploads and [`DicomDetails`].
///
/// # Errors
/// [`PresentError`].
pub fn present(part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
    match (part, stored) {
        (ResultPart::Correspondences { direction }, [columns]) => {
            table(&one_way(correspondences(columns)?, direction)?, format)?
        }
        (ResultPart::Correspondences { direction }, [columns, surface]) => {
            let mesh = surface_mesh(surface)?;
            let arrays = vertex_arrays(&one_way(correspondences(columns)?, direction)?, mesh.n_vertices());
            surface_file(&mesh, &arrays, format)
        }
        (ResultPart::Correspondences { direction }, [result, columns, source, target]) => {
            let surfaces = [surface_mesh(source)?, surface_mesh(target)?];
            let pairs = correspondences(columns)?;
            Some(corresponding_scene(&surfaces, &pairs, &stored_transform(result)?.matrix, direction)?)
        }
        (ResultPart::Transform, [result]) => transform(result, format)?,
        (ResultPart::Transform, [result, source, target]) => {
            let matrix = stored_transform(result)?.matrix;
            (format == PartFormat::Lta).then(|| lta(&matrix, [source, target]).into_bytes())
        }
        (ResultPart::Transform, [result, source, target, details]) => {
            let max_inflated_bytes = ReadLimits::default().max_inflated_bytes;
            let DicomDetails { ended_at, uids } = dicom_details(details)?;
            let [study_uid, source_frame, target_frame] = uids.texts();
            let frame_uids = [source_frame, target_frame];
            let files = RegisteredFiles { source, target, study_uid, frame_uids, max_inflated_bytes };
            let written = write_spatial_registration(&stored_transform(result)?.matrix, &files, &ended_at);
            Some(written.map_err(|error| unreadable("an input", error))?.ok_or(PresentError::NotDicom)?)
        }
        (ResultPart::Warped { direction, space }, [result, columns, source, target, files @ ..])
            if matches!(files.len(), 0 | 3) =>
        {
            let surfaces = [surface_mesh(source)?, surface_mesh(target)?];
            let matrix = stored_transform(result)?.matrix;
            let pairs = correspondences(columns)?;
            let warped = warp([&surfaces[0], &surfaces[1]], &pairs, &matrix, direction, space);
            let WarpedSurface { mesh, arrays } = warped.map_err(not_warped)?;
            match format {
                PartFormat::Stl => surface_file(&mesh, &[], format),
                PartFormat::Glb => {
                    let residual = arrays.iter().find(|array| array.name == "residual_mm");
                    let colors = residual.map(|array| match &array.values {
                        VertexValues::Real(values) => value_colors(values),
                        _ => Vec::new(),
                    });
                    let colors = colors.unwrap_or_default();
                    Some(write_glb(&[ColoredSurface { name: "warped", mesh: &mesh, colors: &colors }]))
                }
                PartFormat::Npz => Some(npz(write_npz_table(&arrays))?),
                PartFormat::Json => Some(json_table(&arrays).to_string().into_bytes()),
                PartFormat::Csv => Some(write_csv(&arrays)),
                PartFormat::Npy => Some(write_npy_table(&arrays)),
                PartFormat::Arrow => Some(write_arrow_table(&arrays)),
                PartFormat::Parquet => Some(write_parquet_table(&arrays)),
                PartFormat::Dicom => match files {
                    [source, target, details] => {
                        let DicomDetails { ended_at, uids } = dicom_details(details)?;
                        let [study_uid, source_frame, target_frame] = uids.texts();
                        let (own, other, frame_uid) = match space {
                            WarpSpace::Source => (source, target, source_frame),
                            WarpSpace::Target => (target, source, target_frame),
                        };
                        let max_inflated_bytes = ReadLimits::default().max_inflated_bytes;
                        let files = SegmentedFiles { own, other, study_uid, frame_uid, max_inflated_bytes };
                        let written = write_segmentation(&mesh, segment_label(direction), &files, &ended_at);
                        Some(written.map_err(not_segmented)?)
                    }
                    _ => None,
                },
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

/// The correspondences from source to target, or those from target to source.
fn one_way(pairs: Correspondences, direction: WarpDirection) -> Result<Correspondences, PresentError> {
    match (direction, pairs.inverse) {
        (WarpDirection::Forward, inverse) => Ok(Correspondences { inverse, ..pairs }),
        (WarpDirection::Inverse, None) => Err(PresentError::NoInverse),
        (WarpDirection::Inverse, Some(inverse)) => {
            inverse.checked().ok_or(PresentError::Unreadable { what: "columns of unequal length", source: None })
        }
    }
}

/// Both surfaces in one scene, in corresponding colors: one surface moved rigidly onto the other.
fn corresponding_scene(
    [source, target]: &[SurfaceMesh; 2],
    pairs: &Correspondences,
    matrix: &[[f64; 4]; 4],
    direction: WarpDirection,
) -> Result<Vec<u8>, PresentError> {
    let space = match direction {
        WarpDirection::Forward => WarpSpace::Target,
        WarpDirection::Inverse => WarpSpace::Source,
    };
    let bent = warp([source, target], pairs, matrix, direction, space).map_err(not_warped)?;
    let rigid = bent.without_deformation().map_err(not_warped)?;
    let moved = one_way(pairs.clone(), direction)?;
    let (fixed, names) = match direction {
        WarpDirection::Forward => (target, ["source", "target"]),
        WarpDirection::Inverse => (source, ["target", "source"]),
    };
    let colors = Colors::new(&moved, &rigid, &bent.mesh, fixed);
    Ok(write_glb(&[
        ColoredSurface { name: names[0], mesh: &rigid, colors: &colors.source[0] },
        ColoredSurface { name: names[1], mesh: fixed, colors: &colors.target[0] },
    ]))
}

fn dicom_details(details: &[u8]) -> Result<DicomDetails, PresentError> {
    serde_json::from_slice(details).map_err(|error| unreadable("the details of an object", error))
}

fn not_segmented(error: SegmentationError) -> PresentError {
    match error {
        SegmentationError::NotDicom => PresentError::NotDicom,
        SegmentationError::Open | SegmentationError::TooLarge => PresentError::NoSegmentation,
        SegmentationError::Input(error) => unreadable("an input", error),
    }
}

fn not_warped(error: WarpError) -> PresentError {
    match error {
        WarpError::NoInverse => PresentError::NoInverse,
        error => unreadable("a bent surface", error),
    }
}

fn npz(written: std::io::Result<Vec<u8>>) -> Result<Vec<u8>, PresentError> {
    written.map_err(|error| unreadable("columns as an archive", error))
}

fn table(pairs: &Correspondences, format: PartFormat) -> Result<Option<Vec<u8>>, PresentError> {
    let Correspondences { source, target, confidence, inlier, spread_mm, outlier, triangle, barycentric, .. } = pairs;
    let outlier: Vec<u8> = outlier.iter().map(|reason| reason.code()).collect();
    let columns =
        PairColumns { source, target, confidence, inlier, spread_mm, outlier: &outlier, triangle, barycentric };
    Ok(match format {
        // From source to target this is the stored form.
        PartFormat::Json => Some(serde_json::to_vec(pairs).map_err(|e| unreadable("correspondences as JSON", e))?),
        PartFormat::Csv => Some(pairs.to_csv().into_bytes()),
        PartFormat::Npy => Some(write_npy(&columns)),
        PartFormat::Npz => Some(npz(write_npz(&columns))?),
        PartFormat::Arrow => Some(write_arrow(&columns)),
        PartFormat::Parquet => Some(write_parquet(&columns)),
        _ => None,
    })
}

fn surface_file(mesh: &SurfaceMesh, arrays: &[VertexArray], format: PartFormat) -> Option<Vec<u8>> {
    match format {
        PartFormat::Ply => Some(write_ply_with(mesh, arrays)),
        PartFormat::Vtk => Some(write_vtk_with(mesh, arrays)),
        PartFormat::Vtp => Some(write_vtp_with(mesh, arrays)),
        PartFormat::Gifti => Some(write_gifti(mesh, arrays)),
        PartFormat::Glb if arrays.is_empty() => {
            Some(write_glb(&[ColoredSurface { name: "surface", mesh, colors: &[] }]))
        }
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
    let mut triangle = [(); 3].map(|()| vec![NO_TARGET; n_vertices]);
    let mut barycentric = [(); 3].map(|()| vec![0.0; n_vertices]);
    for row in 0..pairs.source.len() {
        let vertex = pairs.source[row] as usize;
        if vertex < n_vertices {
            target[vertex] = i32::try_from(pairs.target[row]).unwrap_or(NO_TARGET);
            confidence[vertex] = pairs.confidence[row];
            inlier[vertex] = u8::from(pairs.inlier[row]);
            spread_mm[vertex] = pairs.spread_mm[row];
            outlier[vertex] = pairs.outlier[row].code();
            for corner in 0..3 {
                triangle[corner][vertex] = i32::try_from(pairs.triangle[row][corner]).unwrap_or(NO_TARGET);
                barycentric[corner][vertex] = pairs.barycentric[row][corner];
            }
        }
    }
    let names = ["triangle_0", "triangle_1", "triangle_2"].into_iter();
    let corners = names.zip(triangle).map(|(name, values)| VertexArray { name, values: VertexValues::Int(values) });
    let names = ["barycentric_0", "barycentric_1", "barycentric_2"].into_iter();
    let weights = names.zip(barycentric).map(|(name, values)| VertexArray { name, values: VertexValues::Real(values) });
    let columns = [
        VertexArray { name: "target", values: VertexValues::Int(target) },
        VertexArray { name: "confidence", values: VertexValues::Real(confidence) },
        VertexArray { name: "inlier", values: VertexValues::Byte(inlier) },
        VertexArray { name: "spread_mm", values: VertexValues::Real(spread_mm) },
        VertexArray { name: "outlier", values: VertexValues::Byte(outlier) },
    ];
    columns.into_iter().chain(corners).chain(weights).collect()
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
    pairs.checked().ok_or(PresentError::Unreadable { what: "columns of unequal length", source: None })
}

/// A surface that this program wrote. The limits for uploads do not apply, because they may have been lowered in the
/// meantime.
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
            triangle: vec![[7, 8, 9], [0, 1, 2], [4, 5, 6]],
            barycentric: vec![[0.5, 0.25, 0.25], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
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
            ("triangle_0", VertexValues::Int(vec![NO_TARGET, 0, NO_TARGET, 7, NO_TARGET])),
            ("triangle_1", VertexValues::Int(vec![NO_TARGET, 1, NO_TARGET, 8, NO_TARGET])),
            ("triangle_2", VertexValues::Int(vec![NO_TARGET, 2, NO_TARGET, 9, NO_TARGET])),
            ("barycentric_0", VertexValues::Real(vec![0.0, 1.0, 0.0, 0.5, 0.0])),
            ("barycentric_1", VertexValues::Real(vec![0.0, 0.0, 0.0, 0.25, 0.0])),
            ("barycentric_2", VertexValues::Real(vec![0.0, 0.0, 0.0, 0.25, 0.0])),
        ];
        assert_eq!(values, expected, "a row of a vertex that the surface does not have is skipped");
    }

    #[test]
    fn a_format_that_a_part_does_not_have_is_refused() {
        let columns = br#"{"source": [], "target": [], "confidence": [], "inlier": [], "spread_mm": [], "outlier": [], "triangle": [], "barycentric": []}"#.as_slice();
        let forward = ResultPart::Correspondences { direction: WarpDirection::Forward };
        for (part, format) in [(forward, PartFormat::Lta), (ResultPart::Aligned, PartFormat::Stl)] {
            let error = present(part, format, &[columns]).unwrap_err();
            let refused = matches!(error, PresentError::NotOffered { .. });
            assert_eq!(refused, part == forward, "{error}");
        }
    }
}
