//! GIFTI 1.0 (`.gii`): one surface, read, and written with per-vertex arrays in the same file.
//!
//! Source: "GIFTI Surface Data Format", version 1.0 (Geometry Data Format Working Group, 2011). `GZipBase64Binary` is,
//! despite its name, a zlib stream.
//!
//! **Names.** Attributes are read in the spelling of the standard (`Base64Binary`), as constants of the C library
//! (`GIFTI_ENCODING_B64BIN`) and, for intents and types, as numbers of NIfTI; case is ignored.
//!
//! **Coordinates.** A pointset may have a `CoordinateSystemTransformMatrix`. The standard defines the stored numbers as
//! coordinates in `DataSpace`, and the matrix as the map from there to `TransformedSpace`. A rigid matrix is applied on
//! reading, so that surfaces are in the file's target space, and the report says so. Other matrices, such as
//! FreeSurfer's affine map to Talairach coordinates, would change shape and size: they are applied only on request, and
//! the report describes them. The first of several matrices counts. FreeSurfer's geometry of the volume (`VolGeom...`
//! in the metadata) is not applied.
//!
//! **Writing.** The format has triangles and three number types, so quads are split along their first diagonal and real
//! numbers are written in single precision.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons, points_of};
use super::text::{real, words};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::xml::{Node, Tag, Xml, base64, inflate_up_to};
use super::{FormatError, ReadLimits};
use ::base64::Engine;
use ::base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use homolog_contract::input::InputSpace;
use homolog_mesh::SurfaceMesh;
use nalgebra::{Matrix4, Point3, Vector3};
use std::io::Write;

/// Reads a mesh of triangles. `apply_transform` selects whether to apply the coordinate transform of the file; `None`
/// applies rigid ones.
///
/// # Errors
/// [`FormatError`]; files without a surface (`.func.gii`, `.label.gii`), with several, and with data in another file are
/// not supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_gifti(bytes: &[u8], limits: &ReadLimits, apply_transform: Option<bool>) -> Result<MeshFile, FormatError> {
    let budget = Budget::of(limits);
    let mut xml = Xml::new(bytes, "GIFTI");
    // Names of the currently open elements.
    let mut open: Vec<String> = Vec::new();
    let mut array: Option<StoredArray> = None;
    let (mut points, mut triangles) = (None, None);
    let mut matrix = StoredMatrix::default();
    let (mut n_arrays, mut n_stated) = (0u64, None::<u64>);
    let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
    while let Some(node) = xml.next()? {
        match node {
            Node::Start(tag) => {
                if tag.name == "DataArray" {
                    n_arrays += 1;
                    array = Intent::of(&tag).map(|intent| StoredArray::new(&tag, intent)).transpose()?;
                } else if tag.name == "GIFTI" {
                    n_stated = tag.number("NumberOfDataArrays");
                } else if tag.name == "CoordinateSystemTransformMatrix" {
                    matrix = StoredMatrix::default();
                }
                open.push(tag.name);
            }
            Node::Text(text) => {
                let Some(array) = &mut array else { continue };
                match open.last().map(String::as_str) {
                    Some("Data") => budget.extend(&mut array.text, &text)?,
                    Some("MatrixData") => budget.extend(&mut matrix.numbers, &text)?,
                    Some("DataSpace") => budget.extend(&mut matrix.spaces[0], &text)?,
                    Some("TransformedSpace") => budget.extend(&mut matrix.spaces[1], &text)?,
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
                    let slot = if array.intent == Intent::Points { &mut points } else { &mut triangles };
                    if slot.is_some() {
                        return unsupported("a GIFTI file with several surfaces", "send one surface a file");
                    }
                    *slot = Some(array.decoded(&xml, limits, &budget)?);
                }
            }
        }
    }
    if !open.is_empty() {
        // The file ends within an element: arrays may be missing.
        return Err(xml.damaged());
    }
    if let Some(stated) = n_stated.filter(|&stated| stated > n_arrays) {
        return Err(FormatError::CountMismatch { what: "data arrays", stated, found: n_arrays });
    }
    let (Some(points), Some(triangles)) = (points, triangles) else {
        let advice = "values and labels of vertices are no surface; send the file that ends in .surf.gii";
        return unsupported("a GIFTI file without a pointset and triangles", advice);
    };
    let mut polygons = Polygons::of(points_of(&points.numbers, &budget)?, &budget);
    let (note, mut space) = (points.matrix.as_ref(), InputSpace::Unknown);
    let mut notes = Vec::new();
    if let Some(matrix) = note {
        let outcome = matrix.apply(&mut polygons.vertices, apply_transform)?;
        let named = match outcome {
            // If the matrix is the identity, both spaces are the same.
            Applied::Identity => &matrix.spaces[..],
            Applied::Yes => &matrix.spaces[1..],
            Applied::No(_) | Applied::Invalid => &matrix.spaces[..1],
        };
        if named.iter().any(|name| name.trim_ascii() == b"NIFTI_XFORM_SCANNER_ANAT") {
            space = InputSpace::ScannerRas;
        }
        notes.extend(matrix.note(outcome));
    }
    for triangle in triangles.numbers.chunks_exact(3) {
        polygons.push(triangle.iter().map(|&v| v as i64))?;
    }
    let mut file = polygons.into_mesh()?;
    file.space = space;
    file.notes.extend(notes);
    Ok(file)
}

/// Role of an array in a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Intent {
    Points,
    Triangles,
}

impl Intent {
    fn of(tag: &Tag) -> Option<Self> {
        match constant(tag, "Intent", "NIFTI_INTENT_").as_str() {
            "POINTSET" | "1008" => Some(Intent::Points),
            "TRIANGLE" | "1009" => Some(Intent::Triangles),
            _ => None,
        }
    }
}

/// The value of an attribute that names a constant, in upper case, without the prefix of its kind of constants.
fn constant(tag: &Tag, name: &str, prefix: &str) -> String {
    let value = tag.get(name).to_ascii_uppercase();
    value.strip_prefix(prefix).map_or_else(|| value.clone(), str::to_owned)
}

/// A data array with undecoded text.
struct StoredArray {
    intent: Intent,
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

impl StoredArray {
    fn new(tag: &Tag, intent: Intent) -> Result<Self, FormatError> {
        let fault = |field, value: String, advice| Err(FormatError::Header { field, value, advice });
        let element = match constant(tag, "DataType", "NIFTI_TYPE_").as_str() {
            "FLOAT32" | "16" => Element::F32,
            "FLOAT64" | "64" => Element::F64,
            "INT32" | "8" => Element::I32,
            "UINT32" | "768" => Element::U32,
            "INT64" | "1024" => Element::I64,
            "UINT64" | "1280" => Element::U64,
            "INT16" | "4" => Element::I16,
            "UINT16" | "512" => Element::U16,
            "INT8" | "256" => Element::I8,
            "UINT8" | "2" => Element::U8,
            _ => {
                let advice = "coordinates must be of type NIFTI_TYPE_FLOAT32, triangles of type NIFTI_TYPE_INT32";
                return Err(FormatError::Unsupported { what: "this DataType of a GIFTI array", advice });
            }
        };
        let encoding = match constant(tag, "Encoding", "GIFTI_ENCODING_").as_str() {
            "ASCII" | "1" => ArrayEncoding::Ascii,
            "BASE64BINARY" | "B64BIN" | "2" => ArrayEncoding::Base64,
            "GZIPBASE64BINARY" | "B64GZ" | "3" => ArrayEncoding::Zlib,
            "EXTERNALFILEBINARY" | "EXTERNAL" | "EXTBIN" | "4" => {
                let advice = "save the file with its data inside, for example with gifti_tool -mod_gim_atr";
                return Err(FormatError::Unsupported { what: "a GIFTI array with its data in another file", advice });
            }
            _ => {
                let advice = "the standard knows ASCII, Base64Binary, GZipBase64Binary and ExternalFileBinary";
                return Err(FormatError::Unsupported { what: "this Encoding of a GIFTI array", advice });
            }
        };
        let dims: Vec<u64> = ["Dim0", "Dim1"].iter().map(|name| tag.number(name).unwrap_or(0)).collect();
        if tag.get("Dimensionality") != "2" || dims[1] != 3 {
            let field = if intent == Intent::Points { "size of the pointset" } else { "size of the list of triangles" };
            return fault(field, format!("{dims:?}"), "it must have two dimensions, the second of size 3");
        }
        Ok(StoredArray {
            intent,
            element,
            order: match constant(tag, "Endian", "GIFTI_ENDIAN_").as_str() {
                "BIGENDIAN" | "BIG" | "1" => ByteOrder::Big,
                _ => ByteOrder::Little,
            },
            column_major: matches!(
                constant(tag, "ArrayIndexingOrder", "GIFTI_IND_ORD_").as_str(),
                "COLUMNMAJORORDER" | "COL_MAJOR" | "2"
            ),
            encoding,
            rows: dims[0],
            matrix: None,
            text: Vec::new(),
        })
    }

    fn decoded(self, xml: &Xml<'_>, limits: &ReadLimits, budget: &Budget) -> Result<DecodedArray, FormatError> {
        if self.intent == Intent::Points {
            Polygons::check_count(self.rows, limits)?;
        }
        Polygons::check_faces(self.rows, limits)?;
        let n = self.rows as usize * 3;
        let bytes = n * self.element.size();
        let part = if self.intent == Intent::Points { "the pointset" } else { "the list of triangles" };
        let what = if self.intent == Intent::Points { "coordinates" } else { "vertex indices of triangles" };
        let numbers = if self.encoding == ArrayEncoding::Ascii {
            // Reading one more number than expected detects a surplus.
            budget.collect(words(&self.text).take(n + 1).map(|word| real(word).ok_or_else(|| xml.damaged())))?
        } else {
            let raw = base64(&self.text, budget)?.ok_or_else(|| xml.damaged())?;
            let raw = match self.encoding {
                // Enough bytes to detect a surplus.
                ArrayEncoding::Zlib => {
                    let most = bytes.saturating_mul(2);
                    inflate_up_to(&raw, most, bytes, budget)?.ok_or_else(|| xml.damaged())?
                }
                _ => raw,
            };
            if raw.len() != bytes {
                if raw.len() > bytes {
                    let found = (raw.len() / self.element.size()) as u64;
                    return Err(FormatError::CountMismatch { what, stated: n as u64, found });
                }
                return Err(FormatError::Truncated { part, needed: bytes as u64, available: raw.len() as u64 });
            }
            self.element.charged_reals(&raw, self.order, budget)?
        };
        if numbers.len() != n {
            let found = words(&self.text).count() as u64;
            return Err(FormatError::CountMismatch { what, stated: n as u64, found });
        }
        let rows = self.rows as usize;
        budget.charge_of::<f64>(if self.column_major { n } else { 0 })?;
        let numbers = if self.column_major { (0..n).map(|k| numbers[k % 3 * rows + k / 3]).collect() } else { numbers };
        Ok(DecodedArray { numbers, matrix: self.matrix })
    }
}

/// A `CoordinateSystemTransformMatrix` as text.
#[derive(Default)]
struct StoredMatrix {
    /// Source and target space.
    spaces: [Vec<u8>; 2],
    numbers: Vec<u8>,
}

/// Largest deviation of the scales of a rigid matrix from 1: most programs write text with four decimals, which is no
/// closer.
const RIGID_TOLERANCE: f64 = 1e-3;

/// Treatment of the matrix of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Applied {
    Identity,
    Yes,
    /// Not applied; the smallest and the largest factor by which it changes lengths.
    No([f64; 2]),
    /// Not an affine matrix.
    Invalid,
}

impl StoredMatrix {
    /// Maps the points, unless the matrix is the identity, or is not rigid and was not requested.
    fn apply(&self, points: &mut [Point3<f64>], asked: Option<bool>) -> Result<Applied, FormatError> {
        let numbers: Vec<f64> = words(&self.numbers).filter_map(real).filter(|v| v.is_finite()).collect();
        let matrix = if numbers.is_empty() { Matrix4::identity() } else { Matrix4::zeros() };
        let matrix = if numbers.len() == 16 { Matrix4::from_row_slice(&numbers) } else { matrix };
        if matrix == Matrix4::identity() {
            return Ok(Applied::Identity);
        }
        let linear = matrix.fixed_view::<3, 3>(0, 0).into_owned();
        let is_affine = matrix.row(3) == Matrix4::<f64>::identity().row(3) && linear.determinant().abs() >= 1e-12;
        let factors = if is_affine { linear.singular_values() } else { Vector3::zeros() };
        let factors = [factors.min(), factors.max()];
        let is_rigid = factors.iter().all(|f| (f - 1.0).abs() <= RIGID_TOLERANCE) && linear.determinant() > 0.0;
        if !asked.unwrap_or(is_rigid) {
            return Ok(if is_affine { Applied::No(factors) } else { Applied::Invalid });
        }
        if !is_affine {
            let advice = "it must be 16 numbers, the last four 0 0 0 1, that can be inverted";
            return Err(FormatError::Header { field: "coordinate transform", value: format!("{numbers:?}"), advice });
        }
        points.iter_mut().for_each(|p| *p = matrix.transform_point(p));
        Ok(Applied::Yes)
    }

    /// A sentence on the treatment.
    fn note(&self, outcome: Applied) -> Option<String> {
        let [from, to] = [0, 1].map(|k| space_name(&self.spaces[k]));
        match outcome {
            Applied::Identity => None,
            Applied::Yes => {
                Some(format!("the file's transform from {from} to {to} coordinates was applied to the vertices"))
            }
            Applied::No([least, most]) => Some(format!(
                "the file's transform from {from} to {to} coordinates, which changes lengths by factors from {least:.3} to \
                 {most:.3}, was not applied: coordinates are as stored; input.apply_transform applies it"
            )),
            Applied::Invalid => Some(
                "the file's coordinate transform is not 16 numbers that map points to points; coordinates are as stored"
                    .to_owned(),
            ),
        }
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
/// The coordinate system is declared as unknown: coordinates are the unchanged input coordinates, in millimeters.
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

/// Arrays without a surface, as a `.shape.gii` for a surface in another file.
pub fn write_gifti_shape(arrays: &[VertexArray]) -> Vec<u8> {
    let mut text = header(arrays.len());
    for VertexArray { name, values } in arrays {
        let (kind, bytes) = encoded(values);
        DataArray { intent: "SHAPE", kind, dims: [values.len(), 1], name: Some(name) }.write(&mut text, "", bytes);
    }
    text.push_str("</GIFTI>\n");
    text.into_bytes()
}

/// The part of a file before the arrays.
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
    /// Rows and columns; a single column is written as one dimension.
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
