//! Stanford PLY: ASCII, binary little- and big-endian, by the parser of `ply-rs-bw`.
//!
//! Elements other than `vertex` and `face`, and properties other than positions and vertex lists, are skipped.

use super::polygons::{MeshFile, Polygons};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::{FormatError, ReadLimits};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Names of the property that lists the vertices of a face.
const FACE_LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise all polygons are split into triangles.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_ply(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    // A panic of the third-party parser must only reject this file.
    catch_unwind(AssertUnwindSafe(|| parse(bytes, limits)))
        .unwrap_or(Err(FormatError::Payload { format: "PLY", line: None }))
}

fn parse(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let damaged = |e: ply_rs_bw::parser::ParseError| FormatError::Payload { format: "PLY", line: e.line() };
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = Parser::<Skipped>::new().read_header(&mut reader).map_err(damaged)?;
    check(&header, bytes.len(), limits)?;
    let mut polygons = Polygons::default();
    let mut faces = Vec::new();
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                let read = Parser::<Vertex>::new().read_payload_for_element(&mut reader, element, &header);
                polygons.vertices = read.map_err(damaged)?.into_iter().map(|v| v.0).collect();
            }
            "face" => {
                let read = Parser::<Face>::new().read_payload_for_element(&mut reader, element, &header);
                faces = read.map_err(damaged)?;
            }
            _ => {
                Parser::<Skipped>::new().read_payload_for_element(&mut reader, element, &header).map_err(damaged)?;
            }
        }
    }
    for face in faces {
        polygons.push(face.0)?;
    }
    polygons.into_mesh()
}

/// Rejects headers without positions or faces, and counts for which the file is too short.
fn check(header: &Header, file_bytes: usize, limits: &ReadLimits) -> Result<(), FormatError> {
    let needs = |what: &'static str| FormatError::Unsupported {
        what,
        advice: "export a surface with vertices x, y, z and faces",
    };
    let vertex = header.elements.get("vertex").ok_or_else(|| needs("a PLY file without vertices"))?;
    let face = header.elements.get("face").ok_or_else(|| needs("a PLY file without faces"))?;
    let scalar = |e: &ElementDef, name: &str| {
        e.properties.get(name).is_some_and(|p| matches!(p.data_type, PropertyType::Scalar(_)))
    };
    if !["x", "y", "z"].iter().all(|name| scalar(vertex, name)) {
        return Err(needs("a PLY file whose vertices have no x, y or z"));
    }
    let is_list = |name: &&str| {
        let kind = face.properties.get(*name).map(|p| &p.data_type);
        matches!(kind, Some(PropertyType::List(_, t)) if !matches!(t, ScalarType::Float | ScalarType::Double))
    };
    if !FACE_LISTS.iter().any(is_list) {
        return Err(needs("a PLY file whose faces have no list of vertex indices"));
    }
    Polygons::check_count(vertex.count as u64, limits)?;
    Polygons::check_faces(face.count as u64, limits)?;
    for element in header.elements.values() {
        let least = match header.encoding {
            // A digit and a blank for each value, a line end at least for none.
            Encoding::Ascii => (2 * element.properties.len()).max(1),
            _ => element.properties.values().map(|p| least_bytes(&p.data_type)).sum::<usize>(),
        };
        let needed = (element.count as u64).saturating_mul(least.max(1) as u64);
        // The last value needs no blank after it.
        if needed > file_bytes as u64 + 1 {
            return Err(FormatError::Truncated { part: "a PLY element", needed, available: file_bytes as u64 });
        }
    }
    Ok(())
}

fn least_bytes(kind: &PropertyType) -> usize {
    let (PropertyType::Scalar(scalar) | PropertyType::List(scalar, _)) = kind;
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// An element whose values are parsed and dropped.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Skipped
    }
}

struct Vertex(Point3<f64>);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Vertex(Point3::origin())
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let slot = match name {
            "x" => &mut self.0.x,
            "y" => &mut self.0.y,
            "z" => &mut self.0.z,
            _ => return PropertyAccessResult::Ignored,
        };
        *slot = match property {
            Property::Float(v) => v.into(),
            Property::Double(v) => v,
            Property::Char(v) => v.into(),
            Property::UChar(v) => v.into(),
            Property::Short(v) => v.into(),
            Property::UShort(v) => v.into(),
            Property::Int(v) => v.into(),
            Property::UInt(v) => v.into(),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

struct Face(Vec<i64>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Face(Vec::new())
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !FACE_LISTS.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match property {
            Property::ListChar(v) => wide(v),
            Property::ListUChar(v) => wide(v),
            Property::ListShort(v) => wide(v),
            Property::ListUShort(v) => wide(v),
            Property::ListInt(v) => wide(v),
            Property::ListUInt(v) => wide(v),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

fn wide<T: Into<i64>>(list: Vec<T>) -> Vec<i64> {
    list.into_iter().map(Into::into).collect()
}

/// A binary little-endian PLY file, positions in double precision. Reading it back gives the same mesh to the bit.
pub fn write_ply(mesh: &SurfaceMesh) -> Vec<u8> {
    write_ply_with(mesh, &[])
}

/// As [`write_ply`], with further vertex properties of type `int`, `double` and `uchar`.
pub fn write_ply_with(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let arrays: Vec<_> = fitting(mesh, arrays).collect();
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\n",
        mesh.n_vertices()
    );
    for VertexArray { name, values } in &arrays {
        let kind = match values {
            VertexValues::Int(_) => "int",
            VertexValues::Real(_) => "double",
            VertexValues::Byte(_) => "uchar",
        };
        header.push_str(&format!("property {kind} {name}\n"));
    }
    header.push_str(&format!("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.n_faces()));
    let mut file = header.into_bytes();
    file.reserve(mesh.n_vertices() * (24 + 8 * arrays.len()) + mesh.n_faces() * 17);
    for (vertex, position) in mesh.vertices().iter().enumerate() {
        file.extend(position.iter().flat_map(|c| c.to_le_bytes()));
        for array in &arrays {
            match &array.values {
                VertexValues::Int(v) => file.extend(v[vertex].to_le_bytes()),
                VertexValues::Real(v) => file.extend(v[vertex].to_le_bytes()),
                VertexValues::Byte(v) => file.push(v[vertex]),
            }
        }
    }
    for face in mesh.faces() {
        file.push(face.len() as u8);
        file.extend(face.iter().flat_map(|v| v.to_le_bytes()));
    }
    file
}
