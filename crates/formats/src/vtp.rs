//! VTK XML poly data (`.vtp`): ASCII, inline base64 and appended (raw or base64), plain or zlib, read and written.
//!
//! Source: "VTK XML Formats", VTK documentation, and the output of VTK 9. The points, the polygons and the strips of
//! all pieces are read; vertices, lines and fields are skipped. A field `SPACE` with the value `LPS`, written by 3D
//! Slicer, is taken as the space of the coordinates. A unit of length is applied if a field such as `Units` or the key
//! `UNITS_LABEL` of the points names it. The counts of each piece must equal those of its arrays.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons, strip_triangles};
use super::text::{real, words};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::xml::{Node, Tag, Xml, base64, inflate};
use super::{FormatError, ReadLimits, lps, units};
use ::base64::Engine;
use ::base64::engine::general_purpose::STANDARD;
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise strips and polygons are split into triangles.
///
/// # Errors
/// [`FormatError`]; data sets other than `PolyData` and compressors other than zlib are not supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_vtp(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut xml = Xml::new(bytes, "VTP");
    let budget = Budget::of(limits);
    let mut file = VtpFile::new(&budget);
    let mut open: Vec<String> = Vec::new();
    while let Some(node) = xml.next()? {
        match node {
            Node::Start(tag) => {
                match tag.name.as_str() {
                    "VTKFile" => file.header = Header::new(&tag)?,
                    "Piece" => budget.push(&mut file.pieces, Piece::new(&tag))?,
                    "InformationKey" => {
                        file.is_unit = tag.get("name") == "UNITS_LABEL" && open.iter().any(|name| name == "Points");
                    }
                    "DataArray" | "Array" => {
                        file.array = StoredArray::new(&tag, open.last().map_or("", String::as_str))
                    }
                    "AppendedData" => {
                        // Raw data are not XML, so reading of elements ends here.
                        let rest = &bytes[xml.position()..];
                        let start = rest.iter().position(|&b| b == b'_').ok_or_else(|| xml.damaged())? + 1;
                        file.appended = Some((&rest[start..], tag.get("encoding") == "base64"));
                        return file.mesh(&xml, limits);
                    }
                    _ => {}
                }
                open.push(tag.name);
            }
            Node::Text(text) => {
                if file.is_unit && open.last().is_some_and(|name| name == "InformationKey") {
                    budget.extend(&mut file.unit_label, &text)?;
                }
                if let Some(array) =
                    file.array.as_mut().filter(|_| open.last().is_some_and(|n| n == "DataArray" || n == "Array"))
                {
                    budget.extend(&mut array.text, &text)?;
                }
            }
            Node::End => {
                if open.pop().is_some_and(|name| name == "DataArray" || name == "Array") {
                    file.close_array();
                }
            }
        }
    }
    file.mesh(&xml, limits)
}

/// Attributes of the root that apply to all arrays.
#[derive(Clone, Copy)]
struct Header {
    order: ByteOrder,
    /// Type of the lengths that precede the data.
    lengths: Element,
    compressed: bool,
}

impl Default for Header {
    fn default() -> Self {
        Header { order: ByteOrder::Little, lengths: Element::U32, compressed: false }
    }
}

impl Header {
    fn new(tag: &Tag) -> Result<Self, FormatError> {
        if tag.get("type") != "PolyData" {
            return Err(FormatError::Unsupported {
                what: "a VTK XML data set other than PolyData",
                advice: "extract its surface and save that as PolyData (.vtp)",
            });
        }
        if !["", "vtkZLibDataCompressor"].contains(&tag.get("compressor")) {
            return Err(FormatError::Unsupported {
                what: "LZ4 or LZMA compression of a VTP file",
                advice: "save it with zlib compression or none",
            });
        }
        Ok(Header {
            order: if tag.get("byte_order") == "BigEndian" { ByteOrder::Big } else { ByteOrder::Little },
            lengths: if tag.get("header_type") == "UInt64" { Element::U64 } else { Element::U32 },
            compressed: !tag.get("compressor").is_empty(),
        })
    }
}

struct VtpFile<'a> {
    header: Header,
    pieces: Vec<Piece>,
    /// The open array.
    array: Option<StoredArray>,
    /// The field `SPACE`.
    space: Option<StoredArray>,
    /// The field that names a unit.
    unit: Option<StoredArray>,
    /// Whether the open key is the unit of the points, and its text.
    is_unit: bool,
    unit_label: Vec<u8>,
    /// Appended data, and whether they are in base64.
    appended: Option<(&'a [u8], bool)>,
    budget: &'a Budget,
}

#[derive(Default)]
struct Piece {
    n_points: u64,
    /// Numbers of polygons and strips stated by the piece, if any.
    n_cells: [Option<u64>; 2],
    points: Option<StoredArray>,
    /// Connectivity and offsets.
    polygons: [Option<StoredArray>; 2],
    strips: [Option<StoredArray>; 2],
}

impl Piece {
    fn new(tag: &Tag) -> Self {
        let n_cells = ["NumberOfPolys", "NumberOfStrips"].map(|name| tag.number(name));
        Piece { n_points: tag.number("NumberOfPoints").unwrap_or(0), n_cells, ..Piece::default() }
    }
}

/// An array with undecoded data.
struct StoredArray {
    place: Place,
    /// `None` for types without numbers.
    element: Option<Element>,
    storage: Storage,
    is_string: bool,
    /// Text of the element.
    text: Vec<u8>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Points,
    Polygons(usize),
    Strips(usize),
    Space,
    Unit,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Storage {
    Ascii,
    Inline,
    /// Position in the appended data.
    Appended(usize),
}

impl StoredArray {
    /// The array, if it is one of the used ones.
    fn new(tag: &Tag, parent: &str) -> Option<Self> {
        let name = tag.get("Name");
        let list = ["connectivity", "offsets"].iter().position(|known| name.eq_ignore_ascii_case(known));
        let place = match parent {
            "Points" => Place::Points,
            "Polys" => Place::Polygons(list?),
            "Strips" => Place::Strips(list?),
            "FieldData" if name == "SPACE" => Place::Space,
            "FieldData" if units::is_field(name) => Place::Unit,
            _ => return None,
        };
        let element = match tag.get("type") {
            "Int8" | "String" => Some(Element::I8),
            "UInt8" => Some(Element::U8),
            "Int16" => Some(Element::I16),
            "UInt16" => Some(Element::U16),
            "Int32" => Some(Element::I32),
            "UInt32" => Some(Element::U32),
            "Int64" => Some(Element::I64),
            "UInt64" => Some(Element::U64),
            "Float32" => Some(Element::F32),
            "Float64" => Some(Element::F64),
            _ => None,
        };
        let storage = match tag.get("format") {
            "appended" => Storage::Appended(tag.number("offset").unwrap_or(usize::MAX)),
            "ascii" => Storage::Ascii,
            _ => Storage::Inline,
        };
        Some(StoredArray { place, element, storage, is_string: tag.get("type") == "String", text: Vec::new() })
    }
}

impl<'a> VtpFile<'a> {
    fn new(budget: &'a Budget) -> Self {
        let (header, pieces, unit_label) = (Header::default(), Vec::new(), Vec::new());
        let (array, space, unit, is_unit, appended) = (None, None, None, false, None);
        VtpFile { header, pieces, array, space, unit, is_unit, unit_label, appended, budget }
    }

    fn close_array(&mut self) {
        let Some(array) = self.array.take() else { return };
        let piece = self.pieces.last_mut();
        match (array.place, piece) {
            (Place::Space, _) => self.space = Some(array),
            (Place::Unit, _) => self.unit = Some(array),
            (Place::Points, Some(piece)) => piece.points = Some(array),
            (Place::Polygons(k), Some(piece)) => piece.polygons[k] = Some(array),
            (Place::Strips(k), Some(piece)) => piece.strips[k] = Some(array),
            _ => {}
        }
    }

    fn mesh(&self, xml: &Xml<'_>, limits: &ReadLimits) -> Result<MeshFile, FormatError> {
        let total = self.pieces.iter().fold(0u64, |sum, piece| sum.saturating_add(piece.n_points));
        Polygons::check_count(total, limits)?;
        let mut polygons = Polygons::new(self.budget);
        for piece in &self.pieces {
            let first = polygons.vertices.len() as i64;
            let numbers = self.numbers(piece.points.as_ref(), xml, limits)?;
            if numbers.len() as u64 != piece.n_points.saturating_mul(3) {
                let (what, found) = ("points of a piece", numbers.len() as u64 / 3);
                return Err(FormatError::CountMismatch { what, stated: piece.n_points, found });
            }
            numbers.chunks_exact(3).try_for_each(|p| polygons.vertex(Point3::new(p[0], p[1], p[2])))?;
            for cell in self.cells(&piece.polygons, piece.n_cells[0], xml, limits)?.iter() {
                polygons.push(cell.iter().map(|v| v.saturating_add(first)))?;
            }
            for cell in self.cells(&piece.strips, piece.n_cells[1], xml, limits)?.iter() {
                for triangle in strip_triangles(cell) {
                    polygons.push(triangle.map(|v| v.saturating_add(first)))?;
                }
            }
        }
        let string = |array: Option<&StoredArray>| -> Result<String, FormatError> {
            let letters = self.numbers(array, xml, limits)?;
            let text: Vec<u8> = letters.iter().map(|&c| c as u8).take_while(|&c| c != 0).collect();
            Ok(String::from_utf8_lossy(&text).into_owned())
        };
        let mut file = polygons.into_mesh()?;
        if string(self.space.as_ref())? == "LPS" {
            lps::to_ras(&mut file)?;
        }
        let unit = units::named(&String::from_utf8_lossy(&self.unit_label));
        let of_field = || Ok(units::named(&string(self.unit.as_ref().filter(|array| array.is_string))?));
        if let Some(unit) = unit.map_or_else(of_field, |unit| Ok::<_, FormatError>(Some(unit)))? {
            file.scale(unit)?;
        }
        Ok(file)
    }

    fn cells(
        &self,
        [corners, ends]: &[Option<StoredArray>; 2],
        stated: Option<u64>,
        xml: &Xml<'_>,
        limits: &ReadLimits,
    ) -> Result<Cells, FormatError> {
        let whole = |numbers: Vec<f64>| numbers.into_iter().map(|v| v as i64).collect::<Vec<_>>();
        let corners = whole(self.numbers(corners.as_ref(), xml, limits)?);
        let ends = whole(self.numbers(ends.as_ref(), xml, limits)?);
        let ascending = ends.windows(2).all(|w| w[0] <= w[1]) && ends.first().is_none_or(|&first| first >= 0);
        if !ascending || ends.last().is_some_and(|&last| last as u64 > corners.len() as u64) {
            return Err(xml.damaged());
        }
        if let Some(stated) = stated.filter(|&stated| stated != ends.len() as u64) {
            let (what, found) = ("polygons or strips of a piece", ends.len() as u64);
            return Err(FormatError::CountMismatch { what, stated, found });
        }
        let (reached, found) = (ends.last().map_or(0, |&last| last as u64), corners.len() as u64);
        if reached != found {
            let what = "corners of cells, by the last of their offsets";
            return Err(FormatError::CountMismatch { what, stated: reached, found });
        }
        Ok(Cells { corners, ends })
    }

    fn numbers(
        &self,
        array: Option<&StoredArray>,
        xml: &Xml<'_>,
        limits: &ReadLimits,
    ) -> Result<Vec<f64>, FormatError> {
        let Some(array) = array else { return Ok(Vec::new()) };
        let damaged = || xml.damaged();
        let most = Polygons::most_numbers(limits);
        if array.storage == Storage::Ascii {
            let words = words(&array.text);
            let numbers = words.take(most.saturating_add(1)).map(|word| real(word).ok_or_else(damaged));
            let numbers = self.budget.collect(numbers)?;
            Polygons::check_numbers(numbers.len() as u64, limits)?;
            return Ok(numbers);
        }
        let element = array.element.ok_or_else(damaged)?;
        let (data, is_text) = match (array.storage, self.appended) {
            (Storage::Appended(at), Some((data, is_text))) => (data.get(at..).ok_or_else(damaged)?, is_text),
            (Storage::Appended(_), None) => return Err(damaged()),
            _ => (array.text.as_slice(), true),
        };
        let most_bytes = most.saturating_mul(element.size()).min(limits.max_inflated_bytes);
        let raw = self.header.block(data, is_text, most_bytes, self.budget)?.ok_or_else(damaged)?;
        element.charged_reals(&raw, self.header.order, self.budget)
    }
}

/// Cells, given by the ends of their lists of corners.
struct Cells {
    corners: Vec<i64>,
    ends: Vec<i64>,
}

impl Cells {
    fn iter(&self) -> impl Iterator<Item = &[i64]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start as usize..end as usize])
    }
}

impl Header {
    /// The data of an array: its lengths, then the data. `Ok(None)` if they are damaged.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    fn block(self, data: &[u8], is_text: bool, limit: usize, budget: &Budget) -> Result<Option<Vec<u8>>, FormatError> {
        let data = Data { bytes: if is_text { data.trim_ascii_start() } else { data }, is_text, budget };
        let size = self.lengths.size();
        if !self.compressed {
            let Some(head) = data.piece(0, size)? else { return Ok(None) };
            let n = self.lengths.wholes(&head, self.order).first().and_then(|&n| usize::try_from(n).ok());
            let Some(n_bytes) = n.and_then(|n| size.checked_add(n)) else { return Ok(None) };
            let Some(mut block) = data.piece(0, n_bytes)? else { return Ok(None) };
            block.drain(..size);
            return Ok(Some(block));
        }
        // Number of blocks, size of a block, size of the last block if it is smaller, then the compressed size of each.
        let Some(head) = data.piece(0, 3 * size)? else { return Ok(None) };
        let head = self.lengths.wholes(&head, self.order);
        let [whole, last] = [head[1], head[2]].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
        let n_blocks = usize::try_from(head[0]).ok();
        let head_bytes = n_blocks.and_then(|n| n.checked_add(3)?.checked_mul(size));
        let Some((n_blocks, head_bytes)) = n_blocks.zip(head_bytes) else { return Ok(None) };
        let Some(sizes) = data.piece(0, head_bytes)? else { return Ok(None) };
        let sizes = self.lengths.charged_wholes(&sizes[3 * size..], self.order, budget)?;
        // Lengths and data are encoded one after the other, with separate padding.
        let begin = if is_text { encoded_bytes(head_bytes) } else { Some(head_bytes) };
        let stored = sizes.iter().try_fold(0usize, |sum, &n| sum.checked_add(usize::try_from(n).ok()?));
        let Some((begin, stored)) = begin.zip(stored) else { return Ok(None) };
        let Some(blocks) = data.piece(begin, stored)? else { return Ok(None) };
        let (mut plain, mut rest) = (Vec::new(), blocks.as_slice());
        for (k, &n) in sizes.iter().enumerate() {
            let Some((block, after)) = rest.split_at_checked(n as usize) else { return Ok(None) };
            let expected = if k + 1 == n_blocks && last > 0 { last } else { whole };
            if plain.len().saturating_add(expected) > limit {
                return Ok(None);
            }
            let Some(inflated) = inflate(block, expected, budget)? else { return Ok(None) };
            budget.extend(&mut plain, &inflated)?;
            budget.release(inflated.capacity());
            rest = after;
        }
        Ok(Some(plain))
    }
}

/// Data of arrays, as bytes or as text.
struct Data<'a> {
    bytes: &'a [u8],
    is_text: bool,
    budget: &'a Budget,
}

impl Data<'_> {
    /// `n` bytes at a position, which counts characters if the data are text. `Ok(None)` if the data are too short.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    fn piece(&self, at: usize, n: usize) -> Result<Option<Vec<u8>>, FormatError> {
        let length = if self.is_text { encoded_bytes(n) } else { Some(n) };
        let found = length.and_then(|length| self.bytes.get(at..at.checked_add(length)?));
        let Some(found) = found else { return Ok(None) };
        if !self.is_text {
            let mut plain = Vec::new();
            self.budget.extend(&mut plain, found)?;
            return Ok(Some(plain));
        }
        let decoded = base64(found, self.budget)?;
        Ok(decoded.filter(|plain| plain.len() >= n).map(|mut plain| {
            plain.truncate(n);
            plain
        }))
    }
}

/// Number of base64 characters for `n` bytes.
fn encoded_bytes(n: usize) -> Option<usize> {
    n.div_ceil(3).checked_mul(4)
}

/// A VTP file with inline base64, double precision. Reading it back gives the same mesh to the bit.
pub fn write_vtp(mesh: &SurfaceMesh) -> Vec<u8> {
    write_vtp_with(mesh, &[])
}

/// [`write_vtp`] with `PointData`.
pub fn write_vtp_with(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let (n, m) = (mesh.n_vertices(), mesh.n_faces());
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n\
         <Piece NumberOfPoints=\"{n}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" \
         NumberOfPolys=\"{m}\">\n<PointData>\n"
    );
    for VertexArray { name, values } in fitting(mesh, arrays) {
        let (kind, bytes): (_, Vec<u8>) = match values {
            VertexValues::Int(v) => ("Int32", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            VertexValues::Real(v) => ("Float64", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            VertexValues::Byte(v) => ("UInt8", v.clone()),
        };
        data_array(&mut text, kind, name, "", &bytes);
    }
    text.push_str("</PointData>\n<Points>\n");
    let points: Vec<u8> = mesh.vertices().iter().flat_map(|p| p.iter()).flat_map(|c| c.to_le_bytes()).collect();
    data_array(&mut text, "Float64", "Points", " NumberOfComponents=\"3\"", &points);
    text.push_str("</Points>\n<Polys>\n");
    let corners: Vec<u8> = mesh.indices().iter().flat_map(|&v| i64::from(v).to_le_bytes()).collect();
    data_array(&mut text, "Int64", "connectivity", "", &corners);
    let corner_count = mesh.arity().n_corners() as i64;
    let ends: Vec<u8> = (1..=m as i64).flat_map(|k| (k * corner_count).to_le_bytes()).collect();
    data_array(&mut text, "Int64", "offsets", "", &ends);
    text.push_str("</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n");
    text.into_bytes()
}

fn data_array(text: &mut String, kind: &str, name: &str, shape: &str, bytes: &[u8]) {
    let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
    block.extend_from_slice(bytes);
    text.push_str(&format!("<DataArray type=\"{kind}\" Name=\"{name}\"{shape} format=\"binary\">\n"));
    text.push_str(&STANDARD.encode(block));
    text.push_str("\n</DataArray>\n");
}
