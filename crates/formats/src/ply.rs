//! Stanford PLY: ASCII, binary little- and big-endian; faces and triangle strips.
//!
//! Source: G. Turk, "The PLY Polygon File Format", 1994, and the output of VTK, MeshLab and Blender. Elements other
//! than `vertex`, `face` and `tristrips`, and properties other than positions and vertex lists, are skipped. Rows of an
//! ASCII file are lines; if there are fewer lines than rows, values are taken word by word. The bytes after the last
//! row are checked against the counts: further rows mean that a count is wrong.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons, strip_triangles};
use super::text::{Scanner, real, whole, words};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::{FormatError, ReadLimits, units};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Names of the property with the vertices of a face or strip.
const FACE_LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];
/// Largest number of header lines, and of properties of all elements.
const MAX_HEADER_LINES: usize = 10_000;

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise all polygons are split into triangles.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_ply(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let budget = Budget::of(limits);
    let header = Header::read(&mut scanner, &budget)?;
    header.check(scanner.remaining(), limits)?;
    let mut rows = match header.order {
        Some(order) => Rows::Binary(scanner, order),
        None => Rows::of_text(scanner, header.n_rows()),
    };
    let mut content = Content::default();
    for element in &header.elements {
        for _ in 0..element.count {
            rows.next(element, &mut content.row, &budget)?;
            content.keep(element, &budget)?;
        }
    }
    let trailing = rows.check_end(&header, &content, &budget)?;
    let mut polygons = Polygons::of(content.vertices, &budget);
    let (mut corners, mut start) = (content.corners.as_slice(), 0);
    for &(end, is_strip) in &content.ends {
        let (list, rest) = corners.split_at(end - start);
        (corners, start) = (rest, end);
        if is_strip {
            // A negative index ends a strip within a list.
            for strip in list.split(|&v| v < 0) {
                strip_triangles(strip).try_for_each(|triangle| polygons.push(triangle))?;
            }
        } else {
            polygons.push(list.iter().copied())?;
        }
    }
    let mut file = polygons.into_mesh()?;
    file.notes.extend(trailing);
    if let Some(unit) = header.comments.iter().find_map(|comment| units::stated(comment)) {
        file.scale(unit)?;
    }
    Ok(file)
}

struct Header {
    /// `None` for ASCII.
    order: Option<ByteOrder>,
    elements: Vec<ElementRows>,
    comments: Vec<String>,
}

/// An element of the header: a table of the file.
struct ElementRows {
    name: String,
    count: u64,
    columns: Vec<Column>,
}

/// A property: a number, or a list that begins with its length.
struct Column {
    name: String,
    element: Element,
    length: Option<Element>,
    role: Role,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Skipped,
    /// Coordinate of a vertex.
    Coordinate(usize),
    /// Vertices of a face or strip.
    Corners,
}

fn element_of_name(name: &[u8]) -> Option<Element> {
    Some(match name.to_ascii_lowercase().as_slice() {
        b"char" | b"int8" => Element::I8,
        b"uchar" | b"uint8" => Element::U8,
        b"short" | b"int16" => Element::I16,
        b"ushort" | b"uint16" => Element::U16,
        b"int" | b"int32" => Element::I32,
        b"uint" | b"uint32" => Element::U32,
        b"int64" => Element::I64,
        b"uint64" => Element::U64,
        b"float" | b"float32" => Element::F32,
        b"double" | b"float64" => Element::F64,
        _ => return None,
    })
}

impl Header {
    fn read(scanner: &mut Scanner<'_>, budget: &Budget) -> Result<Self, FormatError> {
        // The line ends of old Macintosh programs; data that begin with any byte may follow.
        let end =
            if scanner.rest().get(3) == Some(&b'\r') && scanner.rest().get(4) != Some(&b'\n') { b'\r' } else { b'\n' };
        scanner.line_ended_by(end);
        let mut header = Header { order: None, elements: Vec::new(), comments: Vec::new() };
        let mut has_format = false;
        for _ in 0..MAX_HEADER_LINES {
            let line = scanner.line_ended_by(end).ok_or_else(|| scanner.expected("end_header"))?;
            // A comment or a name is kept as it is; an element and its list of properties take more memory than their
            // line.
            budget.charge(4 * line.len() + 512)?;
            let mut words = words(line);
            match words.next() {
                None => {}
                Some(b"format") => {
                    has_format = true;
                    header.order = match words.next() {
                        Some(b"ascii") => None,
                        Some(b"binary_little_endian") => Some(ByteOrder::Little),
                        Some(b"binary_big_endian") => Some(ByteOrder::Big),
                        _ => return Err(scanner.expected_before("ascii, binary_little_endian or binary_big_endian")),
                    };
                }
                Some(b"comment" | b"obj_info") => header.comments.push(String::from_utf8_lossy(line).into_owned()),
                Some(b"element") => {
                    let name = words.next().ok_or_else(|| scanner.expected_before("the name of an element"))?;
                    let count = words.next().and_then(whole);
                    let count = count.ok_or_else(|| scanner.expected_before("the number of rows of an element"))?;
                    let name = String::from_utf8_lossy(name).into_owned();
                    header.elements.push(ElementRows { name, count, columns: Vec::new() });
                }
                Some(b"property") => {
                    let expected = "a property: its type and its name, or list, two types and its name";
                    let column = Column::of(&mut words).ok_or_else(|| scanner.expected_before(expected))?;
                    let element = header.elements.last_mut();
                    element
                        .ok_or_else(|| scanner.expected_before("an element before its properties"))?
                        .columns
                        .push(column);
                }
                Some(b"end_header") if has_format => {
                    header.elements.iter_mut().for_each(ElementRows::find_roles);
                    return Ok(header);
                }
                Some(b"end_header") => return Err(scanner.expected_before("a line that begins with format")),
                Some(_) => return Err(scanner.expected_before("format, comment, element, property or end_header")),
            }
        }
        Err(scanner.expected("end_header"))
    }

    fn n_rows(&self) -> u64 {
        self.elements.iter().fold(0u64, |sum, element| sum.saturating_add(element.count))
    }

    fn get(&self, name: &str) -> Option<&ElementRows> {
        self.elements.iter().find(|element| element.name == name)
    }

    /// Rejects headers without positions or faces, and counts that exceed the length of the file.
    fn check(&self, available: usize, limits: &ReadLimits) -> Result<(), FormatError> {
        let needs = |what: &'static str| FormatError::Unsupported {
            what,
            advice: "export a surface with vertices x, y, z and faces",
        };
        let vertex = self.get("vertex").ok_or_else(|| needs("a PLY file without vertices"))?;
        let has = |element: &ElementRows, role| element.columns.iter().any(|column| column.role == role);
        if !(0..3).all(|k| has(vertex, Role::Coordinate(k))) {
            return Err(needs("a PLY file whose vertices have no x, y or z"));
        }
        let mut faces = [self.get("face"), self.get("tristrips")].into_iter().flatten().peekable();
        if faces.peek().is_none() {
            return Err(needs("a PLY file without faces"));
        }
        if !faces.any(|element| has(element, Role::Corners)) {
            return Err(needs("a PLY file whose faces have no list of vertex indices"));
        }
        Polygons::check_count(vertex.count, limits)?;
        let n_faces = self.get("face").map_or(0, |face| face.count);
        Polygons::check_faces(n_faces, limits)?;
        for element in &self.elements {
            let least = match self.order {
                // A digit and a blank for each value; for a row without values, at least a line end.
                None => 2 * element.columns.len(),
                Some(_) => element.columns.iter().map(|column| column.length.unwrap_or(column.element).size()).sum(),
            };
            let needed = element.count.saturating_mul(least.max(1) as u64);
            // The last value needs no blank after it.
            if needed > available as u64 + 1 {
                return Err(FormatError::Truncated { part: "a PLY element", needed, available: available as u64 });
            }
        }
        Ok(())
    }
}

impl Column {
    fn of<'w>(words: &mut impl Iterator<Item = &'w [u8]>) -> Option<Self> {
        let is_real = |element: &Element| matches!(element, Element::F32 | Element::F64);
        let (length, element) = match words.next()? {
            b"list" => {
                // A length that is a real number is invalid.
                let length = element_of_name(words.next()?).filter(|length| !is_real(length))?;
                (Some(length), element_of_name(words.next()?)?)
            }
            name => (None, element_of_name(name)?),
        };
        let name = String::from_utf8_lossy(words.next()?).into_owned();
        Some(Column { name, element, length, role: Role::Skipped })
    }
}

impl ElementRows {
    fn find_roles(&mut self) {
        let coordinate = |name: &str| ["x", "y", "z"].iter().position(|known| name.eq_ignore_ascii_case(known));
        let is_list =
            |column: &Column| column.length.is_some() && !matches!(column.element, Element::F32 | Element::F64);
        match self.name.as_str() {
            "vertex" => {
                for column in self.columns.iter_mut().filter(|column| column.length.is_none()) {
                    column.role = coordinate(&column.name).map_or(Role::Skipped, Role::Coordinate);
                }
            }
            "face" | "tristrips" => {
                let named = self.columns.iter().position(|c| is_list(c) && FACE_LISTS.contains(&c.name.as_str()));
                // A single list must be this one.
                let lists: Vec<usize> = (0..self.columns.len()).filter(|&k| is_list(&self.columns[k])).collect();
                let only = match lists[..] {
                    [only] => Some(only),
                    _ => None,
                };
                if let Some(k) = named.or(only) {
                    self.columns[k].role = Role::Corners;
                }
            }
            _ => {}
        }
    }

    fn noun(&self) -> &'static str {
        match self.name.as_str() {
            "vertex" => "vertices",
            "face" => "faces",
            "tristrips" => "lists of triangle strips",
            _ => "rows of the last element",
        }
    }
}

/// The kept values of a row.
#[derive(Default)]
struct Row {
    place: [f64; 3],
    corners: Vec<i64>,
}

#[derive(Default)]
struct Content {
    row: Row,
    vertices: Vec<Point3<f64>>,
    corners: Vec<i64>,
    /// End of each list of corners, and whether it holds strips.
    ends: Vec<(usize, bool)>,
}

impl Content {
    fn keep(&mut self, element: &ElementRows, budget: &Budget) -> Result<(), FormatError> {
        match element.name.as_str() {
            "vertex" => budget.push(&mut self.vertices, self.row.place.into()),
            "face" | "tristrips" => {
                budget.extend(&mut self.corners, &self.row.corners)?;
                self.row.corners.clear();
                budget.push(&mut self.ends, (self.corners.len(), element.name == "tristrips"))
            }
            _ => Ok(()),
        }
    }
}

/// Source of the rows.
#[derive(Clone)]
enum Rows<'a> {
    Binary(Scanner<'a>, ByteOrder),
    /// A row is a line.
    Lines(Scanner<'a>),
    /// Word by word, with the number of lines.
    Words(Scanner<'a>, u64),
}

impl<'a> Rows<'a> {
    fn of_text(scanner: Scanner<'a>, n_rows: u64) -> Self {
        let mut lines = scanner.clone();
        let mut n_lines = 0;
        while let Some(line) = lines.text_line() {
            n_lines += u64::from(!line.is_empty());
        }
        if n_lines >= n_rows { Rows::Lines(scanner) } else { Rows::Words(scanner, n_rows - n_lines) }
    }

    fn next(&mut self, element: &ElementRows, row: &mut Row, budget: &Budget) -> Result<(), FormatError> {
        row.corners.clear();
        match self {
            Rows::Binary(scanner, order) => binary_row(scanner, *order, element, row, budget),
            Rows::Words(scanner, n_missing) => {
                let (mut next, found) = (scanner.clone(), element.count.saturating_sub(*n_missing));
                let mut word = || scanner.word();
                let ended = || FormatError::CountMismatch { what: element.noun(), stated: element.count, found };
                match text_row(&mut word, element, row, budget)? {
                    Some(()) => Ok(()),
                    None if next.word().is_none() || scanner.word().is_none() => Err(ended()),
                    None => Err(next.expected("the values of a row as the header states them")),
                }
            }
            Rows::Lines(scanner) => {
                let line = loop {
                    match scanner.text_line() {
                        Some([]) => {}
                        line => break line.unwrap_or_default(),
                    }
                };
                let mut words = words(line);
                let is_read = text_row(&mut || words.next(), element, row, budget)?.is_some();
                let is_whole = is_read && words.next().is_none();
                let expected = "a row with as many values as the header states";
                if is_whole { Ok(()) } else { Err(scanner.expected_before(expected)) }
            }
        }
    }

    /// Checks the bytes after the last row: nothing but blanks and zeros; further rows, which mean that a count is too
    /// small; or other bytes, on which a note is returned.
    fn check_end(mut self, header: &Header, content: &Content, budget: &Budget) -> Result<Option<String>, FormatError> {
        let rest = match &self {
            Rows::Binary(scanner, _) | Rows::Lines(scanner) | Rows::Words(scanner, _) => scanner.rest(),
        };
        if rest.iter().all(|byte| byte.is_ascii_whitespace() || *byte == 0) {
            return Ok(None);
        }
        let Some(last) = header.elements.iter().rfind(|element| !element.columns.is_empty()) else { return Ok(None) };
        let (mut row, mut n_more) = (Row::default(), 0u64);
        let n_vertices = content.vertices.len() as i64;
        let are_rows = loop {
            let rest = match &self {
                Rows::Binary(scanner, _) | Rows::Lines(scanner) | Rows::Words(scanner, _) => scanner.rest(),
            };
            if rest.is_empty() || rest.iter().all(u8::is_ascii_whitespace) {
                break n_more > 0;
            }
            let is_row = self.next(last, &mut row, budget).is_ok();
            let fits = row.corners.iter().all(|&v| v < n_vertices) && row.place.iter().all(|c| c.is_finite());
            if !is_row || !fits {
                break false;
            }
            n_more += 1;
        };
        if are_rows {
            let found = last.count.saturating_add(n_more);
            return Err(FormatError::CountMismatch { what: last.noun(), stated: last.count, found });
        }
        Ok(Some(super::trailing_note(rest.len())))
    }
}

fn binary_row(
    scanner: &mut Scanner<'_>,
    order: ByteOrder,
    element: &ElementRows,
    row: &mut Row,
    budget: &Budget,
) -> Result<(), FormatError> {
    for column in &element.columns {
        let n = match column.length {
            None => 1,
            Some(length) => {
                let n =
                    length.whole_of(scanner.take(1, length.size(), "the length of a list of a PLY element")?, order);
                // A face without vertices has no use, and is what is read where the count of vertices is wrong.
                if n == 0 && column.role == Role::Corners && element.name == "face" {
                    return Err(scanner.expected(
                        "faces with vertices; one has none, which suggests that a count in the header is wrong",
                    ));
                }
                u64::try_from(n).map_err(|_| scanner.expected("a list that is not of negative length"))?
            }
        };
        let raw = scanner.take(n, column.element.size(), "a row of a PLY element")?;
        match column.role {
            Role::Coordinate(k) => row.place[k] = column.element.real_of(raw, order),
            Role::Corners => {
                budget.reserve(&mut row.corners, raw.len() / column.element.size())?;
                row.corners.extend(raw.chunks_exact(column.element.size()).map(|b| column.element.whole_of(b, order)));
            }
            Role::Skipped => {}
        }
    }
    Ok(())
}

/// The values of a row from words; `Ok(None)` if there are too few or one is invalid.
fn text_row<'w>(
    word: &mut dyn FnMut() -> Option<&'w [u8]>,
    element: &ElementRows,
    row: &mut Row,
    budget: &Budget,
) -> Result<Option<()>, FormatError> {
    for column in &element.columns {
        let n = match column.length {
            None => 1,
            Some(_) => match word().and_then(whole::<u64>) {
                Some(n) => n,
                None => return Ok(None),
            },
        };
        for _ in 0..n {
            let Some(word) = word() else { return Ok(None) };
            let is_read = match column.role {
                Role::Coordinate(k) => real(word).map(|value| row.place[k] = value).is_some(),
                Role::Corners => match whole(word) {
                    Some(corner) => budget.push(&mut row.corners, corner).map(|()| true)?,
                    None => false,
                },
                Role::Skipped => real(word).is_some(),
            };
            if !is_read {
                return Ok(None);
            }
        }
    }
    Ok(Some(()))
}

/// A binary little-endian PLY file, positions in double precision. Reading it back gives the same mesh to the bit.
pub fn write_ply(mesh: &SurfaceMesh) -> Vec<u8> {
    write_ply_with(mesh, &[])
}

/// [`write_ply`] with further vertex properties of type `int`, `double` and `uchar`.
pub fn write_ply_with(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let arrays: Vec<_> = fitting(mesh, arrays).collect();
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment millimeters\nelement vertex {}\nproperty double x\n\
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
