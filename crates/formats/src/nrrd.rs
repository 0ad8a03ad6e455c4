//! NRRD label volumes in one file (`.nrrd`), and segmentations of 3D Slicer (`.seg.nrrd`) with the names of their segments.
//!
//! Source: "Definition of NRRD File Format", Teem; 3D Slicer developer guide, "Segmentation file format". Encodings: raw,
//! gzip, ASCII. Coordinates are converted from LPS, LAS or RAS to RAS; a file without a space is taken as RAS. Segments of a
//! `.seg.nrrd` may overlap: then they are in layers, an axis of the kind `list`.

use super::element::{ByteOrder, Element, Voxels};
use super::label_file::{LabelFile, Overlay};
use super::text::Scanner;
use super::{FormatError, ReadLimits, gzip, lps};
use homolog_contract::input::InputSpace;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Vector4};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Longest header that is looked at.
const MAX_HEADER_LINES: usize = 100_000;

/// Whether these are the first bytes of a NRRD file.
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
    let header = Header::read(&mut scanner)?;
    let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
    if ["data file", "datafile"].iter().any(|key| header.has(key)) {
        return unsupported("a NRRD header without its voxels (.nhdr)", "save header and voxels in one .nrrd file");
    }
    let grid = Grid::new(&header)?;
    let element = element(header.get("type"))?;
    let order = if header.get("endian").eq_ignore_ascii_case("big") { ByteOrder::Big } else { ByteOrder::Little };
    let voxels = Voxels::plain(grid.dims, element, order);
    let needed = voxels.bytes_needed(limits.max_inflated_bytes / grid.n_layers)? * grid.n_layers;
    let stored = scanner.take(scanner.remaining() as u64, 1, "the voxel array")?;
    let whole: Result<u64, _> = header.get("byte skip").parse();
    let stored = stored.get(whole.unwrap_or(0).min(stored.len() as u64) as usize..).unwrap_or_default();
    let values = match header.get("encoding").to_ascii_lowercase().as_str() {
        "raw" => labels(stored, needed, &voxels)?,
        "gzip" | "gz" => labels(&gzip::inflate(stored, limits.max_inflated_bytes)?, needed, &voxels)?,
        "ascii" | "text" | "txt" => {
            let n = needed / element.size();
            if n as u64 > stored.len() as u64 {
                let (needed, available) = (2 * n as u64, stored.len() as u64);
                return Err(FormatError::Truncated { part: "the voxel array", needed, available });
            }
            let mut text = Scanner::new(stored);
            (0..n).map(|at| voxels.label(text.number("a voxel")?, at)).collect::<Result<_, _>>()?
        }
        _ => return unsupported("this encoding of a NRRD file", "save it with the encoding raw or gzip"),
    };
    let segments = segments(&header, grid.n_layers);
    let mut file = if grid.n_layers > 1 {
        let (volume, names) = layered(&values, &grid, &segments)?;
        LabelFile { volume, space: grid.space, names, notes: Vec::new() }
    } else {
        let names = segments.iter().map(|s| (s.value, s.name.clone())).filter(|(_, name)| !name.is_empty()).collect();
        let volume = LabelVolume::new(grid.dims, values, grid.affine)?;
        LabelFile { volume, space: grid.space, names, notes: Vec::new() }
    };
    file.notes.extend(grid.note);
    Ok(file)
}

fn labels(stored: &[u8], needed: usize, voxels: &Voxels) -> Result<Vec<u32>, FormatError> {
    let available = stored.len() as u64;
    let stored: Cow<'_, [u8]> = Cow::Borrowed(stored);
    let Some(raw) = stored.get(..needed) else {
        return Err(FormatError::Truncated { part: "the voxel array", needed: needed as u64, available });
    };
    voxels.labels(raw)
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
}

impl Header {
    fn read(scanner: &mut Scanner<'_>) -> Result<Self, FormatError> {
        scanner.line();
        let mut header = Header { fields: HashMap::new(), pairs: BTreeMap::new() };
        for _ in 0..MAX_HEADER_LINES {
            let line = scanner.line().ok_or_else(|| scanner.expected("an empty line between header and voxels"))?;
            if line.is_empty() {
                return Ok(header);
            }
            let text = String::from_utf8_lossy(line);
            if text.starts_with('#') {
            } else if let Some((key, value)) = text.split_once(":=") {
                header.pairs.insert(key.trim().to_owned(), value.trim().to_owned());
            } else if let Some((key, value)) = text.split_once(": ") {
                header.fields.insert(key.trim().to_ascii_lowercase(), value.trim().to_owned());
            } else {
                return Err(scanner.expected_before("a line of the form field: value"));
            }
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
        let numbers: Result<Vec<f64>, _> = self.get(key).split_whitespace().map(str::parse).collect();
        numbers.map_err(|_| bad(key, "no list of numbers".to_owned(), "write the file again"))
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
            let numbers: Result<Vec<f64>, _> = inside.split(',').map(|w| w.trim().parse()).collect();
            vectors.push(Some(numbers.ok()?.try_into().ok()?));
            rest = after.trim_start();
        }
    }
    Some(vectors)
}

/// Where voxels lie, and how they are stored.
struct Grid {
    dims: [usize; 3],
    n_layers: usize,
    /// Whether the layers of a voxel follow each other; else each layer is a volume.
    layers_first: bool,
    /// To RAS.
    affine: Matrix4<f64>,
    space: InputSpace,
    note: Option<String>,
}

impl Grid {
    fn new(header: &Header) -> Result<Self, FormatError> {
        let sizes = header.numbers("sizes")?;
        let valid = sizes.iter().all(|d| (1.0..=32_767.0).contains(d) && d.fract() == 0.0);
        if !(3..=4).contains(&sizes.len()) || !valid {
            let advice = "three dimensions are needed, from 1 to 32767 voxels each, or four with layers of segments";
            return Err(bad("sizes", format!("{sizes:?}"), advice));
        }
        let directions = vectors(header.get("space directions"));
        let directions =
            directions.ok_or_else(|| bad("space directions", "not readable".to_owned(), "write it again"))?;
        let kinds: Vec<&str> = header.get("kinds").split_whitespace().collect();
        let is_layer = |k: usize| {
            kinds.get(k).is_some_and(|&kind| kind == "list") || directions.get(k).is_some_and(Option::is_none)
        };
        let layers: Vec<usize> = (0..sizes.len()).filter(|&k| sizes.len() == 4 && is_layer(k)).collect();
        let layer = match (sizes.len(), layers.as_slice()) {
            (3, _) => None,
            (_, [k]) if *k == 0 || *k == 3 => Some(*k),
            _ => {
                let advice = "only layers of segments may be a fourth dimension; send one volume of the series";
                return Err(bad("sizes", format!("{sizes:?}"), advice));
            }
        };
        let axes: Vec<usize> = (0..sizes.len()).filter(|&k| Some(k) != layer).collect();
        let spacings = header.numbers("spacings").unwrap_or_default();
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
            "" => {
                let note = "the file does not state its space; its coordinates are taken as RAS".to_owned();
                (affine, InputSpace::Unknown, Some(note))
            }
            _ => {
                let advice = "it must be left-posterior-superior, left-anterior-superior or right-anterior-superior";
                return Err(bad("space", "another".to_owned(), advice));
            }
        };
        let dims = [0, 1, 2].map(|k| sizes[axes[k]] as usize);
        let n_layers = layer.map_or(1, |k| sizes[k] as usize);
        Ok(Grid { dims, n_layers, layers_first: layer == Some(0), affine, space, note })
    }
}

/// A segment of 3D Slicer.
struct Segment {
    name: String,
    value: u32,
    layer: usize,
}

/// The segments that the header lists. Before version 5 of 3D Slicer each had a layer of its own, which was not stated.
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

/// The layers as one volume. Segments keep their values if these differ; otherwise they are numbered in the order of the
/// file.
fn layered(
    values: &[u32],
    grid: &Grid,
    segments: &[Segment],
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
    let mut overlay = Overlay::new(n);
    for layer in 0..grid.n_layers {
        for at in 0..n {
            let value = values[if grid.layers_first { at * grid.n_layers + layer } else { layer * n + at }];
            if value != 0 {
                // A value that no segment names is a label of its own.
                let label = label_of.get(&(layer, value)).copied().filter(|&label| label != 0).unwrap_or(value);
                overlay.add(at, label)?;
            }
        }
    }
    Ok((overlay.volume(grid.dims, grid.affine)?, names))
}
