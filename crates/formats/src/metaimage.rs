//! MetaImage of ITK: header and voxels in one file (`.mha`, or `.mhd` with `ElementDataFile = LOCAL`).
//!
//! Source: MetaIO documentation and `metaImage.cxx`. Coordinates are LPS, as in ITK, and are converted to RAS;
//! `AnatomicalOrientation` is a comment on them and is not used. Rows of `TransformMatrix` are the directions of the axes.

use super::element::{ByteOrder, Element, Voxels};
use super::label_file::LabelFile;
use super::text::Scanner;
use super::xml::inflate;
use super::{FormatError, ReadLimits, lps};
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix3, Matrix4, Vector3};
use std::borrow::Cow;
use std::collections::HashMap;

/// Longest header that is looked at.
const MAX_HEADER_LINES: usize = 1000;

/// Whether this text begins as a MetaImage header does.
pub(super) fn is_metaimage(bytes: &[u8]) -> bool {
    let head = bytes.get(..2048).unwrap_or(bytes);
    let has = |key: &[u8]| head.windows(key.len()).any(|w| w == key);
    [b"ObjectType".as_slice(), b"NDims", b"Comment"].iter().any(|key| head.starts_with(key)) && has(b"NDims")
}

/// Reads a label volume.
///
/// # Errors
/// [`FormatError`]; voxels in another file, several channels and other than three dimensions are not supported.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_metaimage(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let mut fields: HashMap<String, String> = HashMap::new();
    loop {
        let line = scanner.line().filter(|_| fields.len() < MAX_HEADER_LINES);
        let line = line.ok_or_else(|| scanner.expected("ElementDataFile = LOCAL"))?;
        let text = String::from_utf8_lossy(line);
        let Some((key, value)) = text.split_once('=') else {
            return Err(scanner.expected_before("a line of the form key = value"));
        };
        let is_last = key.trim() == "ElementDataFile";
        fields.insert(key.trim().to_owned(), value.trim().to_owned());
        if is_last {
            break;
        }
    }
    let header = Header { fields: &fields };
    if !header.get("ElementDataFile").eq_ignore_ascii_case("LOCAL") {
        return Err(FormatError::Unsupported {
            what: "a MetaImage header without its voxels",
            advice: "save header and voxels in one .mha file",
        });
    }
    if header.list("NDims")? != [3.0] || !["", "1"].contains(&header.get("ElementNumberOfChannels")) {
        return Err(FormatError::Unsupported {
            what: "a MetaImage that does not have three dimensions and one channel",
            advice: "save one three-dimensional label volume",
        });
    }
    let element = match header.get("ElementType") {
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
        _ => {
            let advice = "save the labels as integers or real numbers";
            return Err(FormatError::Unsupported { what: "this ElementType of a MetaImage", advice });
        }
    };
    let sizes = header.list("DimSize")?;
    let valid = sizes.len() == 3 && sizes.iter().all(|d| (1.0..=32_767.0).contains(d) && d.fract() == 0.0);
    if !valid {
        let advice = "it must be three whole numbers from 1 to 32767";
        return Err(FormatError::Header { field: "DimSize", value: format!("{sizes:?}"), advice });
    }
    let is_true = |key: &str| header.get(key).eq_ignore_ascii_case("true");
    let big = is_true("BinaryDataByteOrderMSB") || is_true("ElementByteOrderMSB");
    let order = if big { ByteOrder::Big } else { ByteOrder::Little };
    let voxels = Voxels::plain([0, 1, 2].map(|k| sizes[k] as usize), element, order);
    let needed = voxels.bytes_needed(limits.max_inflated_bytes)?;
    let labels = if header.get("BinaryData").eq_ignore_ascii_case("false") {
        text_labels(&mut scanner, &voxels)?
    } else {
        let stored = scanner.take(scanner.remaining() as u64, 1, "the voxel array")?;
        let skipped: i64 = header.get("HeaderSize").parse().unwrap_or(0);
        let start = if skipped < 0 { stored.len().saturating_sub(needed) } else { 0 };
        let plain: Cow<'_, [u8]> = if is_true("CompressedData") {
            let damaged = FormatError::Payload { format: "MetaImage", line: None };
            let length = header.get("CompressedDataSize").parse().unwrap_or(stored.len()).min(stored.len());
            Cow::Owned(inflate(&stored[..length], needed).ok_or(damaged)?)
        } else {
            Cow::Borrowed(&stored[start..])
        };
        if plain.len() < needed {
            let (needed, available) = (needed as u64, plain.len() as u64);
            return Err(FormatError::Truncated { part: "the voxel array", needed, available });
        }
        voxels.labels(&plain[..needed])?
    };
    let affine = lps::affine_to_ras(&header.affine()?);
    let mut file = LabelFile::unnamed(LabelVolume::new(voxels.dims, labels, affine)?);
    file.space = homolog_contract::input::InputSpace::Lps;
    file.notes.push(lps::NOTE.to_owned());
    Ok(file)
}

/// Voxels written as text.
fn text_labels(scanner: &mut Scanner<'_>, voxels: &Voxels) -> Result<Vec<u32>, FormatError> {
    let (needed, available) = (voxels.count().saturating_mul(2), scanner.remaining() as u64 + 1);
    if needed > available {
        return Err(FormatError::Truncated { part: "the voxel array", needed, available });
    }
    (0..voxels.count() as usize).map(|at| voxels.label(scanner.number("a voxel")?, at)).collect()
}

struct Header<'a> {
    fields: &'a HashMap<String, String>,
}

impl Header<'_> {
    fn get(&self, key: &str) -> &str {
        self.fields.get(key).map_or("", String::as_str)
    }

    /// The numbers of a field; none if it is absent.
    fn list(&self, key: &'static str) -> Result<Vec<f64>, FormatError> {
        let numbers: Result<Vec<f64>, _> = self.get(key).split_whitespace().map(str::parse).collect();
        numbers.map_err(|_| FormatError::Header { field: key, value: "no number".to_owned(), advice: "write it again" })
    }

    /// The first of these fields that has three numbers.
    fn three(&self, keys: &[&'static str], default: f64) -> Result<Vector3<f64>, FormatError> {
        for key in keys {
            let numbers = self.list(key)?;
            if let [x, y, z] = numbers[..] {
                return Ok(Vector3::new(x, y, z));
            }
        }
        Ok(Vector3::repeat(default))
    }

    fn affine(&self) -> Result<Matrix4<f64>, FormatError> {
        let mut directions = Matrix3::identity();
        for key in ["TransformMatrix", "Rotation", "Orientation"] {
            let numbers = self.list(key)?;
            if numbers.len() == 9 {
                directions = Matrix3::from_column_slice(&numbers);
                break;
            }
        }
        let spacing = self.three(&["ElementSpacing", "ElementSize"], 1.0)?;
        let mut affine = Matrix4::identity();
        affine.fixed_view_mut::<3, 3>(0, 0).copy_from(&(directions * Matrix3::from_diagonal(&spacing)));
        affine.fixed_view_mut::<3, 1>(0, 3).copy_from(&self.three(&["Offset", "Position", "Origin"], 0.0)?);
        Ok(affine)
    }
}
