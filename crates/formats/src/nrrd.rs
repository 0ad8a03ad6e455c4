//! NRRD label volumes in one file (`.nrrd`), and segmentations of 3D Slicer (`.seg.nrrd`) with the names of their segments.
//!
//! Source: "Definition of NRRD File Format", Teem; 3D Slicer developer guide, "Segmentation file format". Encodings:
//! raw, gzip, ASCII, hexadecimal. `line skip` counts lines before the stored data, `byte skip` counts bytes of the
//! stored or inflated voxels; a negative value counts from the end. Coordinates are converted from LPS, LAS or RAS to
//! RAS, and from `space units` to millimeters; a file without a space is taken as RAS. Axes of size 1 beyond the three
//! of space may be anywhere. Segments of a `.seg.nrrd` may overlap: they are then stored in layers, an axis of the kind
//! `list`.

use super::budget::Budget;
use super::element::{ByteOrder, Element, Rest, Voxels};
use super::label_file::{LabelFile, Overlay};
use super::text::{Scanner, real, words};
use super::units::{self, Unit};
use super::xml::inflate_up_to;
use super::{FormatError, ReadLimits, gzip, lps};
use homolog_contract::input::InputSpace;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Vector4};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Largest number of header lines.
const MAX_HEADER_LINES: usize = 100_000;
/// Bytes held for each byte of a header line, and for each line.
const LINE_BYTES_PER_BYTE: usize = 40;
const LINE_BYTES: usize = 200;

/// Whether `bytes` begin like a NRRD file.
pub(super) fn is_nrrd(bytes: &[u8]) -> bool {
    bytes.starts_with(b"NRRD000")
}

/// Reads a label volume.
///
/// # Errors
/// [`FormatError`]; voxels in another file, other encodings and time series are not supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_nrrd(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let budget = Budget::of(limits);
    let header = Header::read(&mut scanner, &budget)?;
    let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
    if header.has("data file") {
        let advice = "send header and voxels in one .nrrd file, for example with unu save -f nrrd";
        return unsupported("a NRRD header whose voxels are in another file (.nhdr)", advice);
    }
    if !header.has_end {
        let advice = "the file ends within its header; export it again or repeat the upload";
        return unsupported("a NRRD header without voxels", advice);
    }
    let grid = Grid::new(&header)?;
    let element = element(header.get("type"))?;
    let order = if header.get("endian").eq_ignore_ascii_case("big") { ByteOrder::Big } else { ByteOrder::Little };
    let voxels = Voxels::plain(grid.dims, element, order);
    let needed = voxels.bytes_needed(limits.max_inflated_bytes / grid.n_layers)? * grid.n_layers;
    budget.grant_voxels(voxels.declared() * grid.n_layers);
    let mut stored = scanner.rest();
    for _ in 0..header.skip("line skip")?.max(0) {
        let Some(end) = stored.iter().position(|&byte| byte == b'\n') else {
            let value = header.get("line skip").to_owned();
            return Err(bad("line skip", value, "there are fewer lines after the header"));
        };
        stored = &stored[end + 1..];
    }
    let byte_skip = header.skip("byte skip")?;
    let mut notes = Vec::new();
    let text = |stored: &[u8], n: usize, notes: &mut Vec<String>| -> Result<Vec<u32>, FormatError> {
        let skipped = usize::try_from(byte_skip).unwrap_or(0);
        let stored = stored.get(skipped..).unwrap_or_default();
        let (needed, available) = (2 * n as u64, stored.len() as u64);
        if n as u64 > available {
            return Err(FormatError::Truncated { part: "the voxel array", needed, available });
        }
        let mut text = Scanner::new(stored);
        let labels = budget.collect((0..n).map(|at| voxels.label(text.real("a voxel")?, at)))?;
        notes.extend(text.check_end("voxels", n as u64, 1)?);
        Ok(labels)
    };
    let values = match header.get("encoding").to_ascii_lowercase().as_str() {
        "raw" => labels(stored, byte_skip, needed, &voxels, &budget, &mut notes)?,
        "gzip" | "gz" => {
            // Some writers store a bare zlib stream; anything else is damaged.
            let damaged = FormatError::Payload { format: "NRRD", line: None };
            let (plain, is_followed) = if gzip::is_gzip(stored) {
                gzip::inflate_embedded(stored, limits.max_inflated_bytes, needed, &budget)?
            } else {
                (inflate_up_to(stored, limits.max_inflated_bytes, needed, &budget)?.ok_or(damaged)?, false)
            };
            if is_followed {
                notes.push("bytes after the end of the compressed voxels were not read".to_owned());
            }
            labels(&plain, byte_skip, needed, &voxels, &budget, &mut notes)?
        }
        "hex" => {
            budget.charge(4 * stored.len())?;
            let plain = hexadecimal(stored).ok_or_else(|| scanner.expected("pairs of hexadecimal digits"))?;
            labels(&plain, byte_skip, needed, &voxels, &budget, &mut notes)?
        }
        "ascii" | "text" | "txt" => text(stored, needed / element.size(), &mut notes)?,
        _ => return unsupported("this encoding of a NRRD file", "save it with the encoding raw or gzip"),
    };
    let segments = segments(&header, grid.n_layers);
    let (volume, names) = if grid.n_layers > 1 {
        layered(&values, &grid, &segments, &budget)?
    } else {
        let names = segments.iter().map(|s| (s.value, s.name.clone())).filter(|(_, name)| !name.is_empty()).collect();
        (LabelVolume::new(grid.dims, values, grid.affine)?, names)
    };
    notes.splice(0..0, grid.notes);
    Ok(LabelFile { volume, space: grid.space, names, notes, warnings: Vec::new() })
}

/// Size of the voxels that a header declares, bytes; 0 if it is invalid.
pub(super) fn declared(head: &[u8]) -> usize {
    let mut scanner = Scanner::new(head);
    let Ok(header) = Header::read(&mut scanner, &Budget::new(2 * super::HEAD_BYTES)) else { return 0 };
    let Ok(element) = element(header.get("type")) else { return 0 };
    let Ok(grid) = Grid::new(&header) else { return 0 };
    Voxels::plain(grid.dims, element, ByteOrder::Little).stored().saturating_mul(grid.n_layers)
}

/// The voxels in the stored data. They follow the bytes to skip; a negative skip places them at the end, before as many
/// bytes as it lies below −1.
fn labels(
    stored: &[u8],
    byte_skip: i64,
    needed: usize,
    voxels: &Voxels,
    budget: &Budget,
    notes: &mut Vec<String>,
) -> Result<Vec<u32>, FormatError> {
    let truncated = |available: usize| FormatError::Truncated {
        part: "the voxel array",
        needed: needed as u64,
        available: available as u64,
    };
    let start = if byte_skip >= 0 {
        usize::try_from(byte_skip).unwrap_or(usize::MAX).min(stored.len())
    } else {
        let after = usize::try_from(byte_skip.unsigned_abs() - 1).unwrap_or(usize::MAX);
        let end = stored.len().saturating_sub(after);
        end.checked_sub(needed).ok_or_else(|| truncated(end))?
    };
    let (raw, rest) = stored[start..].split_at_checked(needed).ok_or_else(|| truncated(stored.len() - start))?;
    if byte_skip >= 0 {
        notes.extend(voxels.check_rest(needed, Rest::of(rest))?);
    }
    voxels.labels(raw, budget)
}

fn hexadecimal(text: &[u8]) -> Option<Vec<u8>> {
    let digits: Option<Vec<u8>> = text
        .iter()
        .filter(|byte| !byte.is_ascii_whitespace())
        .map(|&byte| char::from(byte).to_digit(16).map(|digit| digit as u8))
        .collect();
    Some(digits?.chunks_exact(2).map(|pair| pair[0] << 4 | pair[1]).collect())
}

fn element(name: &str) -> Result<Element, FormatError> {
    Ok(match name {
        "signed char" | "int8" | "int8_t" => Element::I8,
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Element::U8,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Element::I16,
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Element::U16,
        "int" | "signed int" | "int32" | "int32_t" => Element::I32,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Element::U32,
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Element::I64,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => Element::U64,
        "float" => Element::F32,
        "double" => Element::F64,
        _ => {
            let advice = "save the labels as integers or real numbers";
            return Err(FormatError::Unsupported { what: "this type of a NRRD file", advice });
        }
    })
}

/// Fields and key/value pairs.
struct Header {
    fields: HashMap<String, String>,
    pairs: BTreeMap<String, String>,
    /// Whether an empty line ends the header before the voxels.
    has_end: bool,
}

impl Header {
    fn read(scanner: &mut Scanner<'_>, budget: &Budget) -> Result<Self, FormatError> {
        scanner.line();
        let mut header = Header { fields: HashMap::new(), pairs: BTreeMap::new(), has_end: false };
        for _ in 0..MAX_HEADER_LINES {
            let Some(line) = scanner.line() else { return Ok(header) };
            if line.is_empty() {
                header.has_end = true;
                return Ok(header);
            }
            // Names and values are kept, and lists of numbers and words are made from them.
            budget.charge(line.len().saturating_mul(LINE_BYTES_PER_BYTE) + LINE_BYTES)?;
            let text = String::from_utf8_lossy(line);
            if text.starts_with('#') {
                continue;
            }
            let (key, value) =
                text.split_once(':').ok_or_else(|| scanner.expected_before("a line of the form field: value"))?;
            match value.strip_prefix('=') {
                Some(value) => header.pairs.insert(key.trim().to_owned(), value.trim().to_owned()),
                None => header.fields.insert(field_name(key), value.trim().to_owned()),
            };
        }
        Err(scanner.expected("an empty line between header and voxels"))
    }

    fn get(&self, key: &str) -> &str {
        self.fields.get(key).map_or("", String::as_str)
    }

    fn has(&self, key: &str) -> bool {
        self.fields.contains_key(key)
    }

    fn numbers(&self, key: &'static str) -> Result<Vec<f64>, FormatError> {
        let numbers: Option<Vec<f64>> = words(self.get(key).as_bytes()).map(real).collect();
        numbers.ok_or_else(|| bad(key, "no list of numbers".to_owned(), "write the file again"))
    }

    /// A number of lines or bytes to skip; 0 if absent.
    fn skip(&self, key: &'static str) -> Result<i64, FormatError> {
        let text = self.get(key);
        let number = if text.is_empty() { Ok(0) } else { text.parse() };
        number.map_err(|_| bad(key, "no whole number".to_owned(), "write the file again"))
    }

    /// The units stated in a field, each in quotes, or separated by blanks.
    fn units(&self, key: &str) -> Vec<String> {
        let text = self.get(key);
        if text.contains('"') {
            return text.split('"').skip(1).step_by(2).map(str::to_owned).collect();
        }
        text.split_whitespace().map(str::to_owned).collect()
    }
}

/// The name of a field in lower case, with the blank that some writers omit.
fn field_name(key: &str) -> String {
    match key.trim().to_ascii_lowercase().as_str() {
        "datafile" => "data file".to_owned(),
        "lineskip" => "line skip".to_owned(),
        "byteskip" => "byte skip".to_owned(),
        "axismins" => "axis mins".to_owned(),
        "axismaxs" => "axis maxs".to_owned(),
        other => other.to_owned(),
    }
}

fn bad(field: &'static str, value: String, advice: &'static str) -> FormatError {
    FormatError::Header { field, value, advice }
}

/// Vectors such as `(1,0,0) none (0,1,0)`; `None` for `none`.
fn vectors(text: &str) -> Option<Vec<Option<[f64; 3]>>> {
    let mut vectors = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        if let Some(after) = rest.strip_prefix("none") {
            vectors.push(None);
            rest = after.trim_start();
        } else {
            let (inside, after) = rest.strip_prefix('(')?.split_once(')')?;
            let numbers: Option<Vec<f64>> = inside.split(',').map(|w| real(w.trim().as_bytes())).collect();
            let vector: [f64; 3] = numbers?.try_into().ok()?;
            // Some writers state a missing direction by NaN.
            vectors.push(vector.iter().all(|c| !c.is_nan()).then_some(vector));
            rest = after.trim_start();
        }
    }
    Some(vectors)
}

/// Positions and storage of voxels.
struct Grid {
    dims: [usize; 3],
    n_layers: usize,
    /// Whether the layers of a voxel are contiguous; otherwise each layer is a volume.
    layers_first: bool,
    /// Affine to RAS.
    affine: Matrix4<f64>,
    space: InputSpace,
    notes: Vec<String>,
}

impl Grid {
    fn new(header: &Header) -> Result<Self, FormatError> {
        let sizes = header.numbers("sizes")?;
        let valid = sizes.iter().all(|d| (1.0..=32_767.0).contains(d) && d.fract() == 0.0);
        let wrong_sizes = |advice| Err(bad("sizes", format!("{sizes:?}"), advice));
        if sizes.len() < 3 || sizes.len() > 16 || !valid {
            return wrong_sizes(
                "three dimensions are needed, from 1 to 32767 voxels each, or four with layers of segments",
            );
        }
        if let Some(stated) = Some(header.skip("dimension")?).filter(|&n| n != 0 && n != sizes.len() as i64) {
            let value = format!("{stated}, but there are {} sizes", sizes.len());
            return Err(bad("dimension", value, "a size is needed for each axis"));
        }
        let directions = vectors(header.get("space directions"));
        let directions =
            directions.ok_or_else(|| bad("space directions", "not readable".to_owned(), "write it again"))?;
        let kinds: Vec<&str> = header.get("kinds").split_whitespace().collect();
        let is_outside_space = |k: usize| {
            kinds.get(k).is_some_and(|kind| !["domain", "space", "???", "none"].contains(kind))
                || directions.get(k).is_some_and(Option::is_none)
        };
        let is_layer = |k: usize| {
            kinds.get(k).is_some_and(|&kind| kind == "list") || directions.get(k).is_some_and(Option::is_none)
        };
        let mut axes: Vec<usize> = (0..sizes.len()).collect();
        while axes.len() > 3 {
            // An axis of size 1 adds nothing; axes that are not of space come first.
            let of_size_1 =
                |outside: bool| axes.iter().rposition(|&k| sizes[k] == 1.0 && (!outside || is_outside_space(k)));
            let Some(at) = of_size_1(true).or_else(|| of_size_1(false)) else { break };
            axes.remove(at);
        }
        let layer = match axes[..] {
            [_, _, _] => None,
            [first, _, _, _] if is_layer(first) => Some(axes.remove(0)),
            [_, _, _, last] if is_layer(last) => axes.pop(),
            _ => {
                return wrong_sizes("only layers of segments may be a fourth dimension; send one volume of the series");
            }
        };
        let layers_first = layer.is_some_and(|layer| layer < axes[0]);
        let spacings = spacings(header, &sizes)?;
        let mut affine = Matrix4::identity();
        for (column, &axis) in axes.iter().enumerate() {
            let mut vector = [0.0; 3];
            vector[column] = spacings.get(axis).copied().filter(|s| s.is_finite() && *s > 0.0).unwrap_or(1.0);
            if !directions.is_empty() {
                let stated = directions.get(axis).copied().flatten();
                vector = stated.ok_or_else(|| {
                    bad("space directions", format!("{} vectors", directions.len()), "one is needed for each axis")
                })?;
            }
            affine.set_column(column, &Vector4::new(vector[0], vector[1], vector[2], 0.0));
        }
        if let Some([Some([x, y, z])]) = vectors(header.get("space origin")).as_deref() {
            affine.set_column(3, &Vector4::new(*x, *y, *z, 1.0));
        }
        let mut notes = Vec::new();
        // One per direction of space, or one per axis if only spacings are stated.
        let stated = match directions.is_empty() {
            false => header.units("space units"),
            true => {
                let units = header.units("units");
                if units.is_empty() {
                    header.units("space units")
                } else {
                    axes.iter().map(|&axis| units.get(axis).cloned().unwrap_or_default()).collect()
                }
            }
        };
        to_millimeters(&mut affine, &stated, &mut notes);
        let scale = |x, y| Matrix4::from_diagonal(&Vector4::new(x, y, 1.0, 1.0));
        let (affine, space, note) = match header.get("space").to_ascii_lowercase().as_str() {
            "left-posterior-superior" | "lps" => {
                (lps::affine_to_ras(&affine), InputSpace::Lps, Some(lps::NOTE.to_owned()))
            }
            "left-anterior-superior" | "las" => {
                let note = "the file has LAS coordinates; they were converted to RAS".to_owned();
                (scale(-1.0, 1.0) * affine, InputSpace::Unknown, Some(note))
            }
            "right-anterior-superior" | "ras" => (affine, InputSpace::ScannerRas, None),
            "" | "scanner-xyz" | "3d-right-handed" => {
                let note = "the file does not state its anatomical space; its coordinates are taken as RAS".to_owned();
                (affine, InputSpace::Unknown, Some(note))
            }
            _ => {
                let advice = "it must be left-posterior-superior, left-anterior-superior or right-anterior-superior";
                return Err(bad("space", "another".to_owned(), advice));
            }
        };
        notes.splice(0..0, note);
        let dims = [0, 1, 2].map(|k| sizes[axes[k]] as usize);
        let n_layers = layer.map_or(1, |k| sizes[k] as usize);
        Ok(Grid { dims, n_layers, layers_first, affine, space, notes })
    }
}

/// The distance of samples along each axis: as stated, or derived from the smallest and the largest position.
fn spacings(header: &Header, sizes: &[f64]) -> Result<Vec<f64>, FormatError> {
    let spacings = header.numbers("spacings")?;
    let (least, most) = (header.numbers("axis mins")?, header.numbers("axis maxs")?);
    let is_node = |axis: usize| {
        let centers = ["centers", "centerings"].map(|key| header.get(key).split_whitespace().nth(axis));
        centers.contains(&Some("node"))
    };
    let between = |axis: usize| {
        let length = most.get(axis)? - least.get(axis)?;
        Some(length / if is_node(axis) { (sizes[axis] - 1.0).max(1.0) } else { sizes[axis] })
    };
    let valid = |s: &f64| s.is_finite() && *s > 0.0;
    let of_axis =
        |axis| spacings.get(axis).copied().filter(valid).or_else(|| between(axis).filter(valid)).unwrap_or(1.0);
    Ok((0..sizes.len()).map(of_axis).collect())
}

/// Scales each direction of space from its unit.
fn to_millimeters(affine: &mut Matrix4<f64>, stated: &[String], notes: &mut Vec<String>) {
    let mut factors = [1.0; 3];
    for (factor, name) in factors.iter_mut().zip(stated).filter(|(_, name)| !name.trim().is_empty()) {
        match units::named(name) {
            Some(Unit { mm }) => *factor = mm,
            None => {
                notes
                    .push("the file states a unit of space that is none of length; millimeters are assumed".to_owned());
                return;
            }
        }
    }
    for (row, factor) in factors.into_iter().enumerate() {
        affine.row_mut(row).scale_mut(factor);
    }
    match factors {
        [x, y, z] if x == y && y == z => notes.extend(Unit { mm: x }.note()),
        _ => notes.push(format!("the file states units of {factors:?} mm; coordinates were converted to mm")),
    }
}

/// A segment of 3D Slicer.
struct Segment {
    name: String,
    value: u32,
    layer: usize,
}

/// The segments listed in the header. Before version 5 of 3D Slicer each segment had an unstated layer of its own.
fn segments(header: &Header, n_layers: usize) -> Vec<Segment> {
    let value = |k: usize, name: &str| header.pairs.get(&format!("Segment{k}_{name}"));
    let mut found = Vec::new();
    while value(found.len(), "ID").is_some() || value(found.len(), "Name").is_some() {
        let k = found.len();
        let number = |name| value(k, name).and_then(|text| text.parse::<u32>().ok());
        let has_own_layer = n_layers > 1 && value(k, "Layer").is_none();
        found.push(Segment {
            name: value(k, "Name").cloned().unwrap_or_default(),
            value: number("LabelValue").unwrap_or(if has_own_layer { 1 } else { k as u32 + 1 }),
            layer: if has_own_layer { k } else { number("Layer").unwrap_or(0) as usize },
        });
    }
    found
}

/// The layers as one volume. Segments keep their values if these differ; otherwise they are numbered in file order.
fn layered(
    values: &[u32],
    grid: &Grid,
    segments: &[Segment],
    budget: &Budget,
) -> Result<(LabelVolume, BTreeMap<u32, String>), FormatError> {
    let different = segments.iter().map(|s| s.value).collect::<BTreeSet<_>>().len() == segments.len();
    let mut label_of = HashMap::new();
    let mut names = BTreeMap::new();
    for (k, segment) in segments.iter().enumerate() {
        let label = if different { segment.value } else { k as u32 + 1 };
        label_of.insert((segment.layer, segment.value), label);
        if !segment.name.is_empty() {
            names.insert(label, segment.name.clone());
        }
    }
    let n = grid.dims.iter().product::<usize>();
    let mut overlay = Overlay::new(n, budget)?;
    for layer in 0..grid.n_layers {
        for at in 0..n {
            let value = values[if grid.layers_first { at * grid.n_layers + layer } else { layer * n + at }];
            if value != 0 {
                // A value without a segment becomes a separate label.
                let label = label_of.get(&(layer, value)).copied().filter(|&label| label != 0).unwrap_or(value);
                overlay.add(at, label)?;
            }
        }
    }
    Ok((overlay.volume(grid.dims, grid.affine)?, names))
}
