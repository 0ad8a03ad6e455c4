//! GIFTI 1.0 (`.gii`): a surface with per-vertex arrays in the same file.
//!
//! Source: "GIFTI Surface Data Format", version 1.0 (Geometry Data Format Working Group, 2011). The format has
//! triangles and three number types, so quads are split along their first diagonal and real numbers are written in
//! single precision. `GZipBase64Binary` is, despite its name, a zlib stream.

use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use homolog_mesh::SurfaceMesh;
use std::io::Write;

/// The surface, then the arrays, each under its name. Vertices keep their indices.
///
/// The coordinate system is declared as unknown: coordinates are those of the input, unchanged, in millimetres.
pub fn write_gifti(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let arrays: Vec<_> = fitting(mesh, arrays).collect();
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n\
         <GIFTI Version=\"1.0\" NumberOfDataArrays=\"{}\">\n<MetaData/>\n<LabelTable/>\n",
        2 + arrays.len()
    );
    let coordinates = mesh.vertices().iter().flat_map(|p| p.iter()).flat_map(|&c| (c as f32).to_le_bytes());
    let space = "<CoordinateSystemTransformMatrix>\n<DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\n\
                 <TransformedSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></TransformedSpace>\n\
                 <MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
    let points = DataArray { intent: "POINTSET", kind: "FLOAT32", dims: [mesh.n_vertices(), 3], name: None };
    points.write(&mut text, space, coordinates.collect());
    let triangles = mesh.triangles();
    let faces = DataArray { intent: "TRIANGLE", kind: "INT32", dims: [triangles.len(), 3], name: None };
    faces.write(&mut text, "", triangles.iter().flatten().flat_map(|v| v.to_le_bytes()).collect());
    for VertexArray { name, values } in arrays {
        let (kind, bytes) = match values {
            VertexValues::Int(v) => ("INT32", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            VertexValues::Real(v) => ("FLOAT32", v.iter().flat_map(|&x| (x as f32).to_le_bytes()).collect()),
            VertexValues::Byte(v) => ("UINT8", v.clone()),
        };
        DataArray { intent: "NONE", kind, dims: [values.len(), 1], name: Some(name) }.write(&mut text, "", bytes);
    }
    text.push_str("</GIFTI>\n");
    text.into_bytes()
}

struct DataArray {
    intent: &'static str,
    kind: &'static str,
    /// Rows and columns; one column is written as one dimension.
    dims: [usize; 2],
    name: Option<&'static str>,
}

impl DataArray {
    fn write(&self, text: &mut String, space: &str, bytes: Vec<u8>) {
        let DataArray { intent, kind, dims: [rows, columns], name } = self;
        let dimensions = match columns {
            1 => format!("Dimensionality=\"1\" Dim0=\"{rows}\""),
            _ => format!("Dimensionality=\"2\" Dim0=\"{rows}\" Dim1=\"{columns}\""),
        };
        text.push_str(&format!(
            "<DataArray Intent=\"NIFTI_INTENT_{intent}\" DataType=\"NIFTI_TYPE_{kind}\" \
             ArrayIndexingOrder=\"RowMajorOrder\" {dimensions} Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" \
             ExternalFileName=\"\" ExternalFileOffset=\"\">\n"
        ));
        match name {
            Some(name) => text.push_str(&format!(
                "<MetaData>\n<MD><Name><![CDATA[Name]]></Name><Value><![CDATA[{name}]]></Value></MD>\n</MetaData>\n"
            )),
            None => text.push_str("<MetaData/>\n"),
        }
        text.push_str(space);
        text.push_str("<Data>");
        text.push_str(&STANDARD.encode(compressed(&bytes)));
        text.push_str("</Data>\n</DataArray>\n");
    }
}

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // Writing into memory cannot fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}
