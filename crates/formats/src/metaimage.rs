//! MetaImage of ITK: header and voxels in one file (`.mha`, or `.mhd` with `ElementDataFile = LOCAL`).
//!
//! Source: MetaIO documentation and `metaImage.cxx`. Fields may have any order; `ElementDataFile` is the last. Coordinates are
//! LPS, as in ITK, and are converted to RAS and from `DistanceUnits` to millimeters; `AnatomicalOrientation` is a comment on
//! them and is not used. Rows of `TransformMatrix` are the directions of the axes. Axes of size 1 beyond three may be anywhere.

use super::budget::Budget;
use super::element::{ByteOrder, Element, Rest, Voxels};
use super::label_file::LabelFile;
use super::text::{Scanner, real, words};
use super::xml::inflate_up_to;
use super::{FormatError, ReadLimits, lps, units};
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix3, Matrix4, Vector3};
use std::borrow::Cow;
use std::collections::HashMap;

/// Largest number of header lines.
const MAX_HEADER_LINES: usize = 1000;
/// Bytes held for each byte of a header line.
const LINE_BYTES_PER_BYTE: usize = 48;

/// Whether `bytes` begin like a MetaImage header.
pub(super) fn is_metaimage(bytes: &[u8]) -> bool {
    let head = bytes.get(..2048).unwrap_or(bytes);
    let key = |line: &[u8], names: &[&[u8]]| {
        let name = line.split(|&byte| byte == b'=' || byte == b':').next().unwrap_or_default().trim_ascii();
        names.contains(&name) && name.len() < line.len()
    };
    let mut lines = head.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty());
    let first = lines.clone().next().unwrap_or_default();
    let is_field = first.iter().take(64).all(|byte| (b' '..0x7f).contains(byte) || byte.is_ascii_whitespace())
        && first.contains(&b'=');
    is_field && lines.any(|line| key(line, &[b"NDims", b"DimSize", b"ElementType"]))
}

/// Reads a label volume.
///
/// # Errors
/// [`FormatError`]; voxels in another file, several channels and numbers of dimensions other than three are not
/// supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_metaimage(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let budget = Budget::of(limits);
    let mut scanner = Scanner::new(bytes);
    let fields = fields_of(&mut scanner, &budget)?;
    let header = Header { fields: &fields };
    if !["", "Image"].contains(&header.get("ObjectType")) {
        return Err(FormatError::Unsupported {
            what: "an object of MetaIO other than an image",
            advice: "save a label volume as .mha, or a surface as PLY, STL or VTK",
        });
    }
    if !header.get("ElementDataFile").eq_ignore_ascii_case("LOCAL") {
        return Err(without_voxels("a MetaImage header whose voxels are in another file (.mhd)"));
    }
    if !["", "1"].contains(&header.get("ElementNumberOfChannels")) {
        return Err(FormatError::Unsupported {
            what: "a MetaImage of several channels",
            advice: "save one three-dimensional label volume",
        });
    }
    let element = element_of_name(header.get("ElementType")).ok_or(FormatError::Unsupported {
        what: "this ElementType of a MetaImage",
        advice: "save the labels as integers or real numbers",
    })?;
    let sizes = header.list("DimSize")?;
    let valid = sizes.iter().all(|d| (1.0..=32_767.0).contains(d) && d.fract() == 0.0);
    let axes = axes_of_space(&sizes).filter(|_| valid && header.list("NDims").is_ok_and(|n| n == [sizes.len() as f64]));
    let axes = axes.ok_or_else(|| FormatError::Header {
        field: "DimSize",
        value: format!("{sizes:?}"),
        advice: "it must be as many whole numbers as NDims says, from 1 to 32767, of which three may be above 1; send one \
                 volume of a series",
    })?;
    let is_true = |key: &str| header.get(key).eq_ignore_ascii_case("true");
    let big = is_true("BinaryDataByteOrderMSB") || is_true("ElementByteOrderMSB");
    let order = if big { ByteOrder::Big } else { ByteOrder::Little };
    let dims = axes.map(|k| sizes[k] as usize);
    let number =
        |key: &'static str, default: f64| Ok::<_, FormatError>(header.list(key)?.first().copied().unwrap_or(default));
    let slope = number("ElementToIntensityFunctionSlope", 1.0)?;
    let intercept = number("ElementToIntensityFunctionOffset", 0.0)?;
    let voxels = Voxels { slope, intercept, ..Voxels::plain(dims, element, order) };
    let mut notes = Vec::new();
    let needed = voxels.bytes_needed(limits.max_inflated_bytes)?;
    budget.grant_voxels(voxels.declared());
    let labels = if header.get("BinaryData").eq_ignore_ascii_case("false") {
        text_labels(&mut scanner, &voxels, &budget, &mut notes)?
    } else {
        let stored = scanner.rest();
        let plain: Cow<'_, [u8]> = if is_true("CompressedData") {
            let damaged = FormatError::Payload { format: "MetaImage", line: None };
            let length: usize = header.get("CompressedDataSize").parse().unwrap_or(stored.len());
            let truncated = FormatError::Truncated {
                part: "the compressed voxel array",
                needed: length as u64,
                available: stored.len() as u64,
            };
            let compressed = stored.get(..length).ok_or(truncated)?;
            // Enough bytes to detect a surplus.
            Cow::Owned(inflate_up_to(compressed, needed.saturating_mul(2), needed, &budget)?.ok_or(damaged)?)
        } else {
            // Counted from the start of the file; negative if the voxels are at its end.
            let skipped: i64 = header.get("HeaderSize").parse().unwrap_or(0);
            let start = match usize::try_from(skipped) {
                Err(_) => stored.len().saturating_sub(needed),
                Ok(skipped) => skipped.saturating_sub(bytes.len() - stored.len()).min(stored.len()),
            };
            Cow::Borrowed(&stored[start..])
        };
        let Some((raw, rest)) = plain.split_at_checked(needed) else {
            let (needed, available) = (needed as u64, plain.len() as u64);
            return Err(FormatError::Truncated { part: "the voxel array", needed, available });
        };
        notes.extend(voxels.check_rest(needed, Rest::of(rest))?);
        voxels.labels(raw, &budget)?
    };
    let mut affine = header.affine(axes, sizes.len())?;
    if let Some(unit) = units::named(header.get("DistanceUnits")) {
        affine.fixed_view_mut::<3, 4>(0, 0).scale_mut(unit.mm);
        notes.extend(unit.note());
    }
    let affine = lps::affine_to_ras(&affine);
    let mut file = LabelFile::unnamed(LabelVolume::new(voxels.dims, labels, affine)?);
    file.space = homolog_contract::input::InputSpace::Lps;
    file.notes.push(lps::NOTE.to_owned());
    file.notes.extend(notes);
    Ok(file)
}

/// The fields of a header, up to the last, which locates the voxels.
fn fields_of(scanner: &mut Scanner<'_>, budget: &Budget) -> Result<HashMap<String, String>, FormatError> {
    let mut fields: HashMap<String, String> = HashMap::new();
    loop {
        let Some(line) = scanner.line().filter(|_| fields.len() < MAX_HEADER_LINES) else {
            return Err(without_voxels("a MetaImage header without its voxels"));
        };
        if line.is_empty() {
            continue;
        }
        // Keys and values are kept, and lists of numbers are made from them.
        budget.charge(line.len().saturating_mul(LINE_BYTES_PER_BYTE))?;
        let text = String::from_utf8_lossy(line);
        let Some((key, value)) = text.split_once(['=', ':']) else {
            return Err(scanner.expected_before("a line of the form key = value"));
        };
        let is_last = key.trim() == "ElementDataFile";
        fields.insert(key.trim().to_owned(), value.trim().to_owned());
        if is_last {
            return Ok(fields);
        }
    }
}

/// Size of the voxels that a header declares, bytes; 0 if it is invalid.
pub(super) fn declared(head: &[u8]) -> usize {
    let mut scanner = Scanner::new(head);
    let Ok(fields) = fields_of(&mut scanner, &Budget::new(2 * super::HEAD_BYTES)) else { return 0 };
    let header = Header { fields: &fields };
    let Ok(sizes) = header.list("DimSize") else { return 0 };
    let Some(element) = element_of_name(header.get("ElementType")) else { return 0 };
    let n_bytes = sizes.iter().product::<f64>() * element.size() as f64;
    // The cast turns NaN and negative numbers into 0.
    n_bytes as usize
}

/// The voxel type for a name in the header.
fn element_of_name(name: &str) -> Option<Element> {
    Some(match name {
        "MET_CHAR" => Element::I8,
        "MET_UCHAR" => Element::U8,
        "MET_SHORT" => Element::I16,
        "MET_USHORT" => Element::U16,
        "MET_INT" | "MET_LONG" => Element::I32,
        "MET_UINT" | "MET_ULONG" => Element::U32,
        "MET_LONG_LONG" => Element::I64,
        "MET_ULONG_LONG" => Element::U64,
        "MET_FLOAT" => Element::F32,
        "MET_DOUBLE" => Element::F64,
        _ => return None,
    })
}

fn without_voxels(what: &'static str) -> FormatError {
    FormatError::Unsupported { what, advice: "save header and voxels in one .mha file" }
}

/// The three axes of space: all axes except those of size 1; the last of these are left out. `None` if more than three
/// axes are larger.
fn axes_of_space(sizes: &[f64]) -> Option<[usize; 3]> {
    let mut axes: Vec<usize> = (0..sizes.len()).collect();
    while axes.len() > 3 {
        let at = axes.iter().rposition(|&k| sizes[k] == 1.0)?;
        axes.remove(at);
    }
    axes.try_into().ok()
}

/// Voxels written as text.
fn text_labels(
    scanner: &mut Scanner<'_>,
    voxels: &Voxels,
    budget: &Budget,
    notes: &mut Vec<String>,
) -> Result<Vec<u32>, FormatError> {
    let (needed, available) = (voxels.count().saturating_mul(2), scanner.remaining() as u64 + 1);
    if needed > available {
        return Err(FormatError::Truncated { part: "the voxel array", needed, available });
    }
    let n = voxels.count() as usize;
    let labels = budget.collect((0..n).map(|at| voxels.label(scanner.real("a voxel")?, at)))?;
    notes.extend(scanner.check_end("voxels", n as u64, 1)?);
    Ok(labels)
}

struct Header<'a> {
    fields: &'a HashMap<String, String>,
}

impl Header<'_> {
    fn get(&self, key: &str) -> &str {
        self.fields.get(key).map_or("", String::as_str)
    }

    /// The numbers of a field; empty if it is absent.
    fn list(&self, key: &'static str) -> Result<Vec<f64>, FormatError> {
        let numbers: Option<Vec<f64>> = words(self.get(key).as_bytes()).map(real).collect();
        numbers.ok_or_else(|| FormatError::Header {
            field: key,
            value: "no number".to_owned(),
            advice: "write it again",
        })
    }

    /// The numbers for the axes of space, from the first of these fields with a number for each axis.
    fn three(
        &self,
        keys: &[&'static str],
        axes: [usize; 3],
        n: usize,
        default: f64,
    ) -> Result<Vector3<f64>, FormatError> {
        for key in keys {
            let numbers = self.list(key)?;
            if numbers.len() == n {
                return Ok(axes.map(|k| numbers[k]).into());
            }
        }
        Ok(Vector3::repeat(default))
    }

    /// Maps voxels of these three of `n` axes to positions in the same three dimensions of space.
    fn affine(&self, axes: [usize; 3], n: usize) -> Result<Matrix4<f64>, FormatError> {
        let mut directions = Matrix3::identity();
        for key in ["TransformMatrix", "Rotation", "Orientation"] {
            let numbers = self.list(key)?;
            if numbers.len() == n * n {
                directions = Matrix3::from_fn(|r, c| numbers[axes[c] * n + axes[r]]);
                break;
            }
        }
        let spacing = self.three(&["ElementSpacing", "ElementSize"], axes, n, 1.0)?;
        let mut affine = Matrix4::identity();
        affine.fixed_view_mut::<3, 3>(0, 0).copy_from(&(directions * Matrix3::from_diagonal(&spacing)));
        let offset = self.three(&["Offset", "Position", "Origin"], axes, n, 0.0)?;
        affine.fixed_view_mut::<3, 1>(0, 3).copy_from(&offset);
        Ok(affine)
    }
}
