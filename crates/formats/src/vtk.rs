//! Legacy VTK poly data, versions 1.0 to 5.1, ASCII and binary (big-endian).
//!
//! Source: "VTK File Formats", The VTK User's Guide, and the output of VTK 9. `POINTS`, `POLYGONS` (each face with its
//! count, or since 5.1 `OFFSETS` and `CONNECTIVITY`) and `TRIANGLE_STRIPS` are read. Vertices, lines, fields and
//! metadata are skipped, except for a unit of length stated by a field of strings, the metadata of the points
//! (`UNITS_LABEL`) or the title. Reading ends at `POINT_DATA` or `CELL_DATA`, whose counts must equal those of the
//! points and cells.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons, points_of, strip_triangles};
use super::text::{Scanner, real};
use super::units::{self, Unit};
use super::vertex_arrays::{VertexArray, VertexValues, fitting};
use super::{FormatError, ReadLimits};
use homolog_mesh::SurfaceMesh;

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise strips and polygons are split into triangles.
///
/// # Errors
/// [`FormatError`]; data sets other than `POLYDATA` are not supported.
///
/// # Cost
/// Linear in the file's length.
pub fn read_vtk(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    // Version, then a title of free text, then the encoding.
    scanner.line();
    let title = scanner.line().unwrap_or_default();
    let encoding = scanner.word().unwrap_or_default();
    let binary = encoding.eq_ignore_ascii_case(b"BINARY");
    if !binary && !encoding.eq_ignore_ascii_case(b"ASCII") {
        return Err(scanner.expected("ASCII or BINARY"));
    }
    if !scanner.word().unwrap_or_default().eq_ignore_ascii_case(b"DATASET") {
        return Err(scanner.expected("DATASET"));
    }
    if !scanner.word().unwrap_or_default().eq_ignore_ascii_case(b"POLYDATA") {
        return Err(FormatError::Unsupported {
            what: "a VTK data set other than POLYDATA",
            advice: "extract its surface and save that as POLYDATA",
        });
    }
    let unit = units::stated_in(title);
    let budget = Budget::of(limits);
    let polygons = Polygons::new(&budget);
    let mut reader = VtkReader { scanner, binary, polygons, n_cells: 0, unit, limits, budget: &budget };
    let mut trailing = None;
    while let Some(keyword) = reader.scanner.word() {
        match keyword.to_ascii_uppercase().as_slice() {
            b"POINTS" => reader.points()?,
            b"POLYGONS" => reader.cells(Cells::Polygons)?,
            b"TRIANGLE_STRIPS" => reader.cells(Cells::Strips)?,
            b"VERTICES" | b"LINES" => reader.cells(Cells::Skipped)?,
            b"FIELD" => reader.field()?,
            b"METADATA" => reader.metadata(),
            b"POINT_DATA" => {
                let n_points = reader.polygons.vertices.len() as u64;
                reader.check_data("points, in the section POINT_DATA", n_points)?;
                break;
            }
            b"CELL_DATA" => {
                reader.check_data("cells, in the section CELL_DATA", reader.n_cells)?;
                break;
            }
            word if word.iter().chain(reader.scanner.rest()).all(|&byte| byte == 0) => break,
            // Numbers and bytes that are not text mean that a count is too small.
            word if reader.n_cells > 0 && real(word).is_none() && word.iter().all(u8::is_ascii_graphic) => {
                trailing = Some(super::trailing_note(word.len() + reader.scanner.remaining()));
                break;
            }
            _ => {
                let expected =
                    "a section of POLYDATA; if numbers are here, the count of the section before is too small";
                return Err(reader.scanner.expected(expected));
            }
        }
    }
    let mut file = reader.polygons.into_mesh()?;
    file.notes.extend(trailing);
    if let Some(unit) = reader.unit {
        file.scale(unit)?;
    }
    Ok(file)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cells {
    Polygons,
    Strips,
    Skipped,
}

/// The number type for a name in the file.
fn element_of_name(name: &[u8]) -> Option<Element> {
    Some(match name.to_ascii_lowercase().as_slice() {
        b"char" | b"signed_char" | b"vtktypeint8" => Element::I8,
        b"unsigned_char" | b"vtktypeuint8" => Element::U8,
        b"short" | b"vtktypeint16" => Element::I16,
        b"unsigned_short" | b"vtktypeuint16" => Element::U16,
        b"int" | b"vtkidtype" | b"vtktypeint32" => Element::I32,
        b"unsigned_int" | b"vtktypeuint32" => Element::U32,
        b"long" | b"vtktypeint64" => Element::I64,
        b"unsigned_long" | b"vtktypeuint64" => Element::U64,
        b"float" | b"vtktypefloat32" => Element::F32,
        b"double" | b"vtktypefloat64" => Element::F64,
        _ => return None,
    })
}

struct VtkReader<'a> {
    scanner: Scanner<'a>,
    binary: bool,
    polygons: Polygons<'a>,
    /// Number of cells of all kinds.
    n_cells: u64,
    unit: Option<Unit>,
    limits: &'a ReadLimits,
    budget: &'a Budget,
}

impl<'a> VtkReader<'a> {
    fn element(&mut self) -> Result<Element, FormatError> {
        let name = self.scanner.word().unwrap_or_default();
        element_of_name(name).ok_or_else(|| self.scanner.expected("a number type such as float or int"))
    }

    /// Rejects a count of numbers that exceeds the rest of the file.
    fn check(&self, n: u64, element: Element, part: &'static str) -> Result<(), FormatError> {
        // In text a number takes a digit and a blank; the last number needs no blank.
        let needed = n.saturating_mul(if self.binary { element.size() as u64 } else { 2 });
        let available = self.scanner.remaining() as u64;
        if needed > available + 1 { Err(FormatError::Truncated { part, needed, available }) } else { Ok(()) }
    }

    /// Checks the count of a data section against the number of described items.
    fn check_data(&mut self, what: &'static str, found: u64) -> Result<(), FormatError> {
        let stated: u64 = self.scanner.number("the number of values")?;
        if stated == found { Ok(()) } else { Err(FormatError::CountMismatch { what, stated, found }) }
    }

    /// Ends the line of a keyword: binary data begin directly after it.
    fn end_line(&mut self) {
        if self.binary {
            self.scanner.line();
        }
    }

    fn points(&mut self) -> Result<(), FormatError> {
        let n: u64 = self.scanner.number("the number of points")?;
        let element = self.element()?;
        Polygons::check_count(n, self.limits)?;
        self.check(n.saturating_mul(3), element, "the list of points")?;
        let numbers = self.reals(n * 3, element)?;
        self.polygons.vertices = points_of(&numbers, self.budget)?;
        Ok(())
    }

    fn reals(&mut self, n: u64, element: Element) -> Result<Vec<f64>, FormatError> {
        if !self.binary {
            return self.budget.collect((0..n).map(|_| self.scanner.real("a coordinate")));
        }
        self.end_line();
        let raw = self.scanner.take(n, element.size(), "the list of points")?;
        element.charged_reals(raw, ByteOrder::Big, self.budget)
    }

    fn whole(&mut self, n: u64, element: Element) -> Result<Vec<i64>, FormatError> {
        Polygons::check_numbers(n, self.limits)?;
        self.check(n, element, "a list of cells")?;
        if !self.binary {
            return self.budget.collect((0..n).map(|_| self.scanner.number("a vertex index")));
        }
        self.end_line();
        let raw = self.scanner.take(n, element.size(), "a list of cells")?;
        element.charged_wholes(raw, ByteOrder::Big, self.budget)
    }

    fn cells(&mut self, kind: Cells) -> Result<(), FormatError> {
        let first: u64 = self.scanner.number("the number of cells")?;
        let second: u64 = self.scanner.number("the length of the list of cells")?;
        if self.scanner.peek().is_some_and(|w| w.eq_ignore_ascii_case(b"OFFSETS")) {
            return self.cells_by_offset(kind, first, second);
        }
        Polygons::check_faces(first, self.limits)?;
        let list = self.whole(second, Element::I32)?;
        let mut rest = list.as_slice();
        for _ in 0..first {
            let Some((&count, after)) = rest.split_first() else {
                return Err(self.scanner.expected("as many cells as the section announces"));
            };
            let cell = usize::try_from(count).ok().and_then(|n| after.split_at_checked(n));
            let Some((cell, after)) = cell else {
                return Err(self.scanner.expected("a cell that ends within its list"));
            };
            self.cell(kind, cell)?;
            rest = after;
        }
        self.n_cells += first;
        if !rest.is_empty() {
            let (stated, found) = (second - rest.len() as u64, second);
            return Err(FormatError::CountMismatch { what: "numbers in the list of cells", stated, found });
        }
        Ok(())
    }

    fn cells_by_offset(&mut self, kind: Cells, n_offsets: u64, n_corners: u64) -> Result<(), FormatError> {
        Polygons::check_faces(n_offsets.saturating_sub(1), self.limits)?;
        self.scanner.word();
        let element = self.element()?;
        let offsets = self.whole(n_offsets, element)?;
        if !self.scanner.word().unwrap_or_default().eq_ignore_ascii_case(b"CONNECTIVITY") {
            return Err(self.scanner.expected("CONNECTIVITY"));
        }
        let element = self.element()?;
        let corners = self.whole(n_corners, element)?;
        self.n_cells += n_offsets.saturating_sub(1);
        if let Some(stated) = offsets.last().map(|&last| last as u64).filter(|&last| last < n_corners) {
            let what = "corners of cells, by the last of their offsets";
            return Err(FormatError::CountMismatch { what, stated, found: n_corners });
        }
        for pair in offsets.windows(2) {
            let range = usize::try_from(pair[0]).ok().zip(usize::try_from(pair[1]).ok());
            let cell = range.and_then(|(start, end)| corners.get(start..end));
            let Some(cell) = cell else {
                return Err(self.scanner.expected("ascending offsets within the connectivity array"));
            };
            self.cell(kind, cell)?;
        }
        Ok(())
    }

    fn cell(&mut self, kind: Cells, cell: &[i64]) -> Result<(), FormatError> {
        match kind {
            Cells::Skipped => Ok(()),
            Cells::Polygons => self.polygons.push(cell.iter().copied()),
            Cells::Strips => strip_triangles(cell).try_for_each(|triangle| self.polygons.push(triangle)),
        }
    }

    /// Skips everything up to an empty line, except the name of a unit.
    fn metadata(&mut self) {
        self.scanner.line();
        let mut is_unit = false;
        while let Some(line) = self.scanner.line().filter(|line| !line.is_empty()) {
            match line.strip_prefix(b"DATA ") {
                Some(value) if is_unit => self.unit = units::named(&String::from_utf8_lossy(value)).or(self.unit),
                _ => is_unit = line.starts_with(b"NAME UNITS_LABEL"),
            }
        }
    }

    /// Skips `FIELD name n` with `n` arrays, each of which may be followed by metadata.
    fn field(&mut self) -> Result<(), FormatError> {
        self.scanner.word();
        let n: u64 = self.scanner.number("the number of arrays")?;
        for _ in 0..n {
            let name = self.scanner.word().ok_or_else(|| self.scanner.expected("an array"))?;
            if name == b"METADATA" {
                self.metadata();
                self.scanner.word();
            }
            let width: u64 = self.scanner.number("the number of components")?;
            let length: u64 = self.scanner.number("the number of tuples")?;
            let n = width.saturating_mul(length);
            let kind = self.scanner.peek().unwrap_or_default();
            if kind.eq_ignore_ascii_case(b"string") || kind.eq_ignore_ascii_case(b"bit") {
                let is_string = kind.eq_ignore_ascii_case(b"string");
                self.scanner.word();
                self.scanner.line();
                let text = self.other(n, is_string)?;
                if units::is_field(&String::from_utf8_lossy(name)) {
                    self.unit = units::named(&String::from_utf8_lossy(text)).or(self.unit);
                }
                continue;
            }
            let element = self.element()?;
            self.check(n, element, "a field")?;
            self.end_line();
            if self.binary {
                self.scanner.take(n, element.size(), "a field")?;
            } else {
                for _ in 0..n {
                    self.scanner.word();
                }
            }
        }
        Ok(())
    }

    /// Skips strings or bits; returns the last string. A string in a binary file begins with its length, in 1, 2, 4 or
    /// 8 bytes, which the highest two bits of the first byte encode.
    fn other(&mut self, n: u64, is_string: bool) -> Result<&'a [u8], FormatError> {
        let part = "a field";
        if self.binary && !is_string {
            return self.scanner.take(n.div_ceil(8), 1, part);
        }
        let mut text: &'a [u8] = &[];
        for _ in 0..n {
            if !self.binary {
                // Strings take a line each, bits are words.
                let rest = if is_string { self.scanner.line() } else { self.scanner.word() };
                text = rest.ok_or_else(|| self.scanner.expected("as many values as the array announces"))?;
                continue;
            }
            let first = self.scanner.take(1, 1, part)?[0];
            let further: &[u8] = match first >> 6 {
                3 => &[],
                2 => self.scanner.take(1, 1, part)?,
                1 => self.scanner.take(3, 1, part)?,
                _ => self.scanner.take(7, 1, part)?,
            };
            let length = further.iter().fold(u64::from(first & 0x3f), |sum, &byte| sum << 8 | u64::from(byte));
            text = self.scanner.take(length, 1, part)?;
        }
        Ok(text)
    }
}

/// A binary legacy VTK file, version 5.1 (VTK 9 and later), double precision. Reading it back gives the same mesh to the bit.
pub fn write_vtk(mesh: &SurfaceMesh) -> Vec<u8> {
    write_vtk_with(mesh, &[])
}

/// [`write_vtk`] with `POINT_DATA`: a field of arrays of `int`, `double` and `unsigned_char`.
pub fn write_vtk_with(mesh: &SurfaceMesh, arrays: &[VertexArray]) -> Vec<u8> {
    let arrays: Vec<_> = fitting(mesh, arrays).collect();
    let mut file = b"# vtk DataFile Version 5.1\nsurface, millimeters\nBINARY\nDATASET POLYDATA\n".to_vec();
    file.extend(format!("POINTS {} double\n", mesh.n_vertices()).into_bytes());
    file.extend(mesh.vertices().iter().flat_map(|p| p.iter()).flat_map(|c| c.to_be_bytes()));
    // Offsets of the faces in the list of corners, one more than the number of faces.
    let (n, n_corners) = (mesh.n_faces(), mesh.arity().n_corners());
    file.extend(format!("\nPOLYGONS {} {}\nOFFSETS vtktypeint64\n", n + 1, mesh.indices().len()).into_bytes());
    file.extend((0..=n).flat_map(|face| ((face * n_corners) as i64).to_be_bytes()));
    file.extend(b"\nCONNECTIVITY vtktypeint64\n");
    file.extend(mesh.indices().iter().flat_map(|&v| i64::from(v).to_be_bytes()));
    file.push(b'\n');
    if !arrays.is_empty() {
        let head = format!("POINT_DATA {}\nFIELD FieldData {}\n", mesh.n_vertices(), arrays.len());
        file.extend(head.into_bytes());
    }
    for VertexArray { name, values } in arrays {
        let (kind, bytes): (_, Vec<u8>) = match values {
            VertexValues::Int(v) => ("int", v.iter().flat_map(|x| x.to_be_bytes()).collect()),
            VertexValues::Real(v) => ("double", v.iter().flat_map(|x| x.to_be_bytes()).collect()),
            VertexValues::Byte(v) => ("unsigned_char", v.clone()),
        };
        file.extend(format!("{name} 1 {} {kind}\n", values.len()).into_bytes());
        file.extend(bytes);
        file.push(b'\n');
    }
    file
}
