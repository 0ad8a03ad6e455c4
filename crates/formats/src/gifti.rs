//! GIFTI 1.0 (`.gii`): one surface, read, and written with per-vertex arrays in the same file.
//!
//! Source: "GIFTI Surface Data Format", version 1.0 (Geometry Data Format Working Group, 2011). `GZipBase64Binary` is,
//! despite its name, a zlib stream.
//!
//! **Coordinates.** A pointset may have a `CoordinateSystemTransformMatrix`. The standard defines the stored numbers as
//! coordinates in `DataSpace`, and the matrix as the map from there to `TransformedSpace`. A matrix that is not the identity
//! is applied on reading, so that surfaces are in the space that the file names as its goal, and the report says so. Of
//! several matrices the first counts. FreeSurfer's geometry of the volume (`VolGeom...` in the metadata) is not applied.
//!
//! **Writing.** The format has triangles and three number types, so quads are split along their first diagonal and real
//! numbers are written in single precision.

use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::xml::{Node, Tag, Xml, base64, inflate};
use super::{FormatError, ReadLimits};
use ::base64::Engine;
use ::base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use homolog_contract::input::InputSpace;
use homolog_mesh::SurfaceMesh;
use nalgebra::{Matrix4, Point3};
use std::io::Write;

/// Reads a mesh of triangles.
///
/// # Errors
/// [`FormatError`]; files without a surface (`.func.gii`, `.label.gii`), with several, and with data in another file are
/// not supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_gifti(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut xml = Xml::new(bytes, "GIFTI");
    // Names of the open elements.
    let mut open: Vec<String> = Vec::new();
    let mut array: Option<StoredArray> = None;
    let (mut points, mut triangles) = (None, None);
    let mut matrix = StoredMatrix::default();
    let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
    while let Some(node) = xml.next()? {
        match node {
            Node::Start(tag) => {
                if tag.name == "DataArray" {
                    let of_surface = ["NIFTI_INTENT_POINTSET", "NIFTI_INTENT_TRIANGLE"].contains(&tag.get("Intent"));
                    array = of_surface.then(|| StoredArray::new(&tag)).transpose()?;
                } else if tag.name == "CoordinateSystemTransformMatrix" {
                    matrix = StoredMatrix::default();
                }
                open.push(tag.name);
            }
            Node::Text(text) => {
                let Some(array) = &mut array else { continue };
                match open.last().map(String::as_str) {
                    Some("Data") => array.text.extend_from_slice(&text),
                    Some("MatrixData") => matrix.numbers.extend_from_slice(&text),
                    Some("DataSpace") => matrix.spaces[0].extend_from_slice(&text),
                    Some("TransformedSpace") => matrix.spaces[1].extend_from_slice(&text),
                    _ => {}
                }
            }
            Node::End => {
                let name = open.pop().unwrap_or_default();
                if name == "CoordinateSystemTransformMatrix" {
                    if let Some(array) = array.as_mut().filter(|a| a.matrix.is_none()) {
                        array.matrix = Some(std::mem::take(&mut matrix));
                    }
                } else if name == "DataArray"
                    && let Some(array) = array.take()
                {
                    let slot = if array.is_points { &mut points } else { &mut triangles };
                    if slot.is_some() {
                        return unsupported("a GIFTI file with several surfaces", "send one surface a file");
                    }
                    *slot = Some(array.decoded(&xml, limits)?);
                }
            }
        }
    }
    let (Some(points), Some(triangles)) = (points, triangles) else {
        let advice = "values and labels of vertices are no surface; send the file that ends in .surf.gii";
        return unsupported("a GIFTI file without a pointset and triangles", advice);
    };
    let mut polygons = Polygons::of(points.rows());
    let (mut note, mut space) = (None, InputSpace::Unknown);
    if let Some(matrix) = &points.matrix {
        note = matrix.apply(&mut polygons.vertices)?;
        // Where the matrix is the identity, both spaces are the same.
        let named = if note.is_some() { &matrix.spaces[1..] } else { &matrix.spaces[..] };
        if named.iter().any(|name| name.trim_ascii() == b"NIFTI_XFORM_SCANNER_ANAT") {
            space = InputSpace::ScannerRas;
        }
    }
    for triangle in triangles.numbers.chunks_exact(3) {
        polygons.push(triangle.iter().map(|&v| v as i64))?;
    }
    let mut file = polygons.into_mesh()?;
    file.space = space;
    file.notes.extend(note);
    Ok(file)
}

/// A data array before its text is decoded.
struct StoredArray {
    is_points: bool,
    element: Element,
    order: ByteOrder,
    column_major: bool,
    encoding: ArrayEncoding,
    rows: u64,
    matrix: Option<StoredMatrix>,
    text: Vec<u8>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ArrayEncoding {
    Ascii,
    Base64,
    Zlib,
}

/// The numbers of an array of three columns, row by row.
struct DecodedArray {
    numbers: Vec<f64>,
    matrix: Option<StoredMatrix>,
}

impl DecodedArray {
    fn rows(&self) -> Vec<Point3<f64>> {
        self.numbers.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect()
    }
}

impl StoredArray {
    fn new(tag: &Tag) -> Result<Self, FormatError> {
        let fault = |field, value: String, advice| Err(FormatError::Header { field, value, advice });
        let is_points = tag.get("Intent") == "NIFTI_INTENT_POINTSET";
        let element = match tag.get("DataType") {
            "NIFTI_TYPE_FLOAT32" => Element::F32,
            "NIFTI_TYPE_FLOAT64" => Element::F64,
            "NIFTI_TYPE_INT32" => Element::I32,
            "NIFTI_TYPE_UINT32" => Element::U32,
            "NIFTI_TYPE_INT64" => Element::I64,
            "NIFTI_TYPE_UINT64" => Element::U64,
            "NIFTI_TYPE_INT16" => Element::I16,
            "NIFTI_TYPE_UINT16" => Element::U16,
            "NIFTI_TYPE_INT8" => Element::I8,
            "NIFTI_TYPE_UINT8" => Element::U8,
            _ => {
                let advice = "coordinates must be of type NIFTI_TYPE_FLOAT32, triangles of type NIFTI_TYPE_INT32";
                return Err(FormatError::Unsupported { what: "this DataType of a GIFTI array", advice });
            }
        };
        let encoding = match tag.get("Encoding") {
            "ASCII" => ArrayEncoding::Ascii,
            "Base64Binary" => ArrayEncoding::Base64,
            "GZipBase64Binary" => ArrayEncoding::Zlib,
            _ => {
                let advice = "save the file with its data inside, for example with gifti_tool -mod_gim_atr";
                return Err(FormatError::Unsupported { what: "this Encoding of a GIFTI array", advice });
            }
        };
        let dims: Vec<u64> = ["Dim0", "Dim1"].iter().map(|name| tag.number(name).unwrap_or(0)).collect();
        if tag.get("Dimensionality") != "2" || dims[1] != 3 {
            let field = if is_points { "size of the pointset" } else { "size of the list of triangles" };
            return fault(field, format!("{dims:?}"), "it must have two dimensions, the second of size 3");
        }
        Ok(StoredArray {
            is_points,
            element,
            order: if tag.get("Endian") == "BigEndian" { ByteOrder::Big } else { ByteOrder::Little },
            column_major: tag.get("ArrayIndexingOrder") == "ColumnMajorOrder",
            encoding,
            rows: dims[0],
            matrix: None,
            text: Vec::new(),
        })
    }

    fn decoded(self, xml: &Xml<'_>, limits: &ReadLimits) -> Result<DecodedArray, FormatError> {
        if self.is_points {
            Polygons::check_count(self.rows, limits)?;
        }
        Polygons::check_faces(self.rows, limits)?;
        let n = self.rows as usize * 3;
        let bytes = n * self.element.size();
        let part = if self.is_points { "the pointset" } else { "the list of triangles" };
        let numbers = if self.encoding == ArrayEncoding::Ascii {
            let words = self.text.split(u8::is_ascii_whitespace).filter(|w| !w.is_empty());
            let numbers: Option<Vec<f64>> =
                words.take(n + 1).map(|w| std::str::from_utf8(w).ok()?.parse().ok()).collect();
            numbers.ok_or_else(|| xml.damaged())?
        } else {
            let raw = base64(&self.text).ok_or_else(|| xml.damaged())?;
            let raw = match self.encoding {
                ArrayEncoding::Zlib => inflate(&raw, bytes).ok_or_else(|| xml.damaged())?,
                _ => raw,
            };
            if raw.len() != bytes {
                return Err(FormatError::Truncated { part, needed: bytes as u64, available: raw.len() as u64 });
            }
            self.element.reals(&raw, self.order)
        };
        if numbers.len() != n {
            return Err(xml.damaged());
        }
        let rows = self.rows as usize;
        let numbers = if self.column_major { (0..n).map(|k| numbers[k % 3 * rows + k / 3]).collect() } else { numbers };
        Ok(DecodedArray { numbers, matrix: self.matrix })
    }
}

/// A `CoordinateSystemTransformMatrix` as text.
#[derive(Default)]
struct StoredMatrix {
    /// From which space to which.
    spaces: [Vec<u8>; 2],
    numbers: Vec<u8>,
}

impl StoredMatrix {
    /// Maps the points, unless the matrix is the identity; a sentence about it.
    fn apply(&self, points: &mut [Point3<f64>]) -> Result<Option<String>, FormatError> {
        let words = self.numbers.split(u8::is_ascii_whitespace).filter(|w| !w.is_empty());
        let numbers: Vec<f64> =
            words.filter_map(|w| std::str::from_utf8(w).ok()?.parse().ok()).filter(|v: &f64| v.is_finite()).collect();
        let matrix = if numbers.is_empty() { Matrix4::identity() } else { Matrix4::zeros() };
        let matrix = if numbers.len() == 16 { Matrix4::from_row_slice(&numbers) } else { matrix };
        let is_affine = matrix.row(3) == Matrix4::<f64>::identity().row(3);
        let linear = matrix.fixed_view::<3, 3>(0, 0).determinant();
        if !is_affine || linear.abs() < 1e-12 {
            let advice = "it must be 16 numbers, the last four 0 0 0 1, that can be inverted";
            return Err(FormatError::Header { field: "coordinate transform", value: format!("{numbers:?}"), advice });
        }
        if matrix == Matrix4::identity() {
            return Ok(None);
        }
        points.iter_mut().for_each(|p| *p = matrix.transform_point(p));
        let [from, to] = [0, 1].map(|k| space_name(&self.spaces[k]));
        Ok(Some(format!("the file's transform from {from} to {to} coordinates was applied to the vertices")))
    }
}

fn space_name(text: &[u8]) -> &'static str {
    match text.trim_ascii() {
        b"NIFTI_XFORM_SCANNER_ANAT" => "scanner",
        b"NIFTI_XFORM_ALIGNED_ANAT" => "aligned anatomical",
        b"NIFTI_XFORM_TALAIRACH" => "Talairach",
        b"NIFTI_XFORM_MNI_152" => "MNI 152",
        _ => "unknown",
    }
}

/// The surface, then the arrays, each under its name. Vertices keep their indices.
///
/// The coordinate system is declared as unknown: coordinates are those of the input, unchanged, in millimetres.
pub fn write_gifti(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let arrays: Vec<_> = fitting(mesh, arrays).collect();
    let mut text = header(2 + arrays.len());
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
        let (kind, bytes) = encoded(values);
        DataArray { intent: "NONE", kind, dims: [values.len(), 1], name: Some(name) }.write(&mut text, "", bytes);
    }
    text.push_str("</GIFTI>\n");
    text.into_bytes()
}

/// Arrays alone, as a `.shape.gii` that belongs to a surface of another file.
pub fn write_gifti_shape(arrays: &[VertexArray]) -> Vec<u8> {
    let mut text = header(arrays.len());
    for VertexArray { name, values } in arrays {
        let (kind, bytes) = encoded(values);
        DataArray { intent: "SHAPE", kind, dims: [values.len(), 1], name: Some(name) }.write(&mut text, "", bytes);
    }
    text.push_str("</GIFTI>\n");
    text.into_bytes()
}

/// What precedes the arrays of a file.
fn header(n_arrays: usize) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n\
         <GIFTI Version=\"1.0\" NumberOfDataArrays=\"{n_arrays}\">\n<MetaData/>\n<LabelTable/>\n"
    )
}

/// The GIFTI type of values, and their bytes.
fn encoded(values: &VertexValues) -> (&'static str, Vec<u8>) {
    match values {
        VertexValues::Int(v) => ("INT32", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
        VertexValues::Real(v) => ("FLOAT32", v.iter().flat_map(|&x| (x as f32).to_le_bytes()).collect()),
        VertexValues::Byte(v) => ("UINT8", v.clone()),
    }
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
