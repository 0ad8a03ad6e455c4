//! NIfTI label volumes, versions 1 and 2: single files (`n+1`, `n+2`), either byte order, plain or gzip.
//!
//! Source: nifti1.h and nifti2.h of the NIfTI data format working group (2007, 2011). The header is checked against the
//! length of the file before anything is allocated, and the bytes after the voxels against the header. The affine is
//! the sform if its code is positive, else the qform, else the voxel sizes alone ("method 1"), scaled to millimeters.
//! If a file states two affines that disagree, a note says which was taken and how they differ
//! ([`super::two_affines`]). (The `nifti` crate also reads headers and voxels, but reads all voxels before the header
//! can be checked; tests use it as an independent reader.)

use super::budget::Budget;
use super::element::{ByteOrder, Element, Voxels};
use super::gzip::{inflate_prefix, unverified_prefix};
use super::label_file::LabelFile;
use super::nifti_labels::label_names;
use super::two_affines::{self, Disagreement};
use super::units::Unit;
use super::{FormatError, ReadLimits};
use flate2::{Compression, GzBuilder};
use homolog_contract::input::{InputSpace, InputWarning};
use homolog_contract::result::UnreliableReason;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector4};
use std::io::Write;

/// Length of the header of version 1 with the extension flag.
const HEADER_1_BYTES: usize = 352;
/// Length of the header of version 2 with the extension flag: the part of a file that [`is_nifti`] and the header need.
pub(super) const HEADER_BYTES: usize = 544;

/// Whether `head` begins a NIfTI file of either version or of its predecessor ANALYZE.
pub(super) fn is_nifti(head: &[u8]) -> bool {
    let size = head.first_chunk::<4>().map_or(0, |b| i32::from_le_bytes(*b));
    let sizes = [size, size.swap_bytes()];
    head.len() >= 348 && sizes.iter().any(|s| [348, 540].contains(s)) || head.get(344..347) == Some(b"n+1".as_slice())
}

/// Reads a label volume; `bytes` may be compressed.
///
/// # Errors
/// [`FormatError`]: two-file variants, CIFTI, more than three dimensions, an element type that is not a number, values that
/// are not labels, a file shorter than its header says, an affine that is singular or not finite, a gzip stream that is
/// damaged or incomplete, even after the last voxel.
///
/// # Cost
/// Linear in the inflated size, which `limits` bound; keeps no more of it than the header requires.
pub fn read_nifti(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let head = unverified_prefix(bytes, HEADER_BYTES)?;
    let Header { voxels, end, offset, affine, space, disagreement, unit } = Header::parse(&head)?;
    let needed = offset.saturating_add(voxels.bytes_needed(limits.max_inflated_bytes)? as u64);
    let limit = limits.max_inflated_bytes as u64;
    if needed > limit {
        return Err(FormatError::TooLarge { what: "bytes of voxels", found: needed, limit });
    }
    let budget = Budget::of(limits);
    budget.grant_voxels(voxels.declared());
    let (plain, rest) = inflate_prefix(bytes, needed as usize, limits.max_inflated_bytes, &budget)?;
    if (plain.len() as u64) < needed {
        return Err(FormatError::Truncated { part: "the voxel array", needed, available: plain.len() as u64 });
    }
    let labels = voxels.labels(&plain[offset as usize..needed as usize], &budget)?;
    // The extension flag is the first of the last four bytes of the header.
    let extensions = plain.get(end..offset as usize).filter(|_| plain[end - 4] != 0).unwrap_or_default();
    let names = label_names(extensions, voxels.order, &budget)?;
    let mut file = LabelFile { space, names, ..LabelFile::unnamed(LabelVolume::new(voxels.dims, labels, affine)?) };
    file.notes.extend(unit.note());
    if let Some(Disagreement { note, sides }) = disagreement {
        match sides {
            true => file.warnings.push(InputWarning { reason: Some(UnreliableReason::UncertainSide), detail: note }),
            false => file.notes.push(note),
        }
    }
    file.notes.extend(voxels.check_rest((needed - offset) as usize, rest)?);
    Ok(file)
}

/// Size of the voxels that a header declares, bytes; 0 if it is invalid.
pub(super) fn declared(head: &[u8]) -> usize {
    Header::parse(head).map_or(0, |header| header.voxels.stored())
}

/// The validated header fields that are used.
#[derive(Debug)]
struct Header {
    voxels: Voxels,
    /// End of the header, where extensions may begin, bytes.
    end: usize,
    /// Offset of the voxels, bytes.
    offset: u64,
    affine: Matrix4<f64>,
    space: InputSpace,
    disagreement: Option<Disagreement>,
    unit: Unit,
}

/// The voxel type for a code in the header.
fn element_of_code(code: i16) -> Option<Element> {
    Some(match code {
        2 => Element::U8,
        4 => Element::I16,
        8 => Element::I32,
        16 => Element::F32,
        64 => Element::F64,
        256 => Element::I8,
        512 => Element::U16,
        768 => Element::U32,
        1024 => Element::I64,
        1280 => Element::U64,
        _ => return None,
    })
}

impl Header {
    fn parse(head: &[u8]) -> Result<Self, FormatError> {
        let available = head.len() as u64;
        if head.len() < 348 {
            return Err(FormatError::Truncated { part: "the NIfTI header", needed: 348, available });
        }
        let size = i32::from_le_bytes([head[0], head[1], head[2], head[3]]);
        let big_endian = ![348, 540].contains(&size);
        let f = Fields { bytes: head, big_endian, second: size == 540 || size.swap_bytes() == 540 };
        let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
        let one_file = "save the volume as one .nii or .nii.gz file";
        match (f.i32(0), &head[344..347], &head[4..7]) {
            (348, b"n+1", _) | (540, _, b"n+2") => {}
            (348, b"ni1", _) | (540, _, b"ni2") => {
                return unsupported("a NIfTI header without its voxels (.hdr and .img)", one_file);
            }
            (348, ..) => return unsupported("ANALYZE 7.5", "it does not store which side is left; save as NIfTI"),
            _ => return unsupported("this variant of NIfTI", "save the volume as NIfTI-1 (.nii or .nii.gz)"),
        }
        if f.second && available < 540 {
            return Err(FormatError::Truncated { part: "the NIfTI-2 header", needed: 540, available });
        }
        if f.second && (3000..3100).contains(&f.i32(504)) {
            let advice = "it holds values for grayordinates and no surface; send the GIFTI surface (.surf.gii) or the label \
                          volume to which it belongs";
            return unsupported("CIFTI", advice);
        }
        let dims = f.dims()?;
        let code = f.i16(if f.second { 12 } else { 70 });
        let element = element_of_code(code).ok_or_else(|| FormatError::Header {
            field: "data type code",
            value: code.to_string(),
            advice: "save the labels as integers or real numbers",
        })?;
        let (least, offset) = if f.second { (540.0, f.i64(168) as f64) } else { (348.0, f.f32(108)) };
        if offset.is_nan() || !(offset == 0.0 || (least..=1e9).contains(&offset)) || offset.fract() != 0.0 {
            let advice = "it must be a whole number not less than the header's length, as a rule 352 (NIfTI-1) or 544 \
                          (NIfTI-2); write the file again";
            return Err(FormatError::Header { field: "voxel offset", value: offset.to_string(), advice });
        }
        let default = if f.second { HEADER_BYTES } else { HEADER_1_BYTES };
        let offset = if offset == 0.0 { default as u64 } else { offset as u64 };
        let (slope, intercept) = if f.second { (f.f64(176), f.f64(184)) } else { (f.f32(112), f.f32(116)) };
        // A slope of 0 means that values are not scaled.
        let scaled = slope != 0.0 && slope.is_finite() && intercept.is_finite();
        let (slope, intercept) = if scaled { (slope, intercept) } else { (1.0, 0.0) };
        let order = if big_endian { ByteOrder::Big } else { ByteOrder::Little };
        let unit = f.unit();
        let (affine, disagreement) = f.affine(dims);
        // A code of 0 means that the form is not set; negative codes are invalid.
        let space = if f.codes().iter().any(|&code| code != 0) { InputSpace::ScannerRas } else { InputSpace::Unknown };
        let voxels = Voxels { dims, element, order, slope, intercept };
        Ok(Header { voxels, end: default, offset, affine, space, disagreement, unit })
    }
}

/// Numbers at byte offsets of the header.
struct Fields<'a> {
    bytes: &'a [u8],
    big_endian: bool,
    /// Whether this is version 2, which has the fields at other offsets and in double precision.
    second: bool,
}

impl Fields<'_> {
    fn array<const N: usize>(&self, at: usize) -> [u8; N] {
        let mut b: [u8; N] = std::array::from_fn(|k| self.bytes.get(at + k).copied().unwrap_or(0));
        if self.big_endian {
            b.reverse();
        }
        b
    }

    fn i16(&self, at: usize) -> i16 {
        i16::from_le_bytes(self.array(at))
    }

    fn i32(&self, at: usize) -> i32 {
        i32::from_le_bytes(self.array(at))
    }

    fn i64(&self, at: usize) -> i64 {
        i64::from_le_bytes(self.array(at))
    }

    fn f32(&self, at: usize) -> f64 {
        f64::from(f32::from_le_bytes(self.array(at)))
    }

    fn f64(&self, at: usize) -> f64 {
        f64::from_le_bytes(self.array(at))
    }

    /// Entry `k` of an array of real numbers that begins at `first` in version 1 and at `second` in version 2.
    fn real(&self, first: usize, second: usize, k: usize) -> f64 {
        if self.second { self.f64(second + 8 * k) } else { self.f32(first + 4 * k) }
    }

    fn dims(&self) -> Result<[usize; 3], FormatError> {
        let dim: [i64; 8] =
            std::array::from_fn(|k| if self.second { self.i64(16 + 8 * k) } else { self.i16(40 + 2 * k).into() });
        let fault =
            |advice| Err(FormatError::Header { field: "list of dimensions", value: format!("{dim:?}"), advice });
        if !(1..=7).contains(&dim[0]) {
            return fault("its first number must be from 1 to 7");
        }
        let used = &dim[1..=dim[0] as usize];
        if used.iter().any(|&d| d < 1) {
            return fault("every dimension must be at least 1");
        }
        if used.iter().skip(3).any(|&d| d != 1) {
            return fault("only three dimensions are supported; send one volume of the series");
        }
        Ok([0, 1, 2].map(|k| used.get(k).map_or(1, |&d| d as usize)))
    }

    /// Codes of qform and sform.
    fn codes(&self) -> [i32; 2] {
        if self.second { [self.i32(344), self.i32(348)] } else { [self.i16(252).into(), self.i16(254).into()] }
    }

    /// Bits 0 to 2: 1 meter, 2 millimeter, 3 micrometer; 0 is unknown, in practice millimeter.
    fn unit(&self) -> Unit {
        let units = if self.second { self.i32(500) as u8 } else { self.bytes[123] };
        let mm = match units & 7 {
            1 => 1000.0,
            3 => 0.001,
            _ => 1.0,
        };
        Unit { mm }
    }

    /// The affine from voxels to RAS, mm, and the disagreement between the affines of the header, if any.
    fn affine(&self, dims: [usize; 3]) -> (Matrix4<f64>, Option<Disagreement>) {
        let [qform, sform] = self.codes();
        let to_mm = |mut affine: Matrix4<f64>| {
            affine.fixed_view_mut::<3, 4>(0, 0).scale_mut(self.unit().mm);
            affine
        };
        let by_quaternion = (qform > 0).then(|| to_mm(self.qform()));
        let by_rows = (sform > 0).then(|| {
            let row = |r: usize| [0, 1, 2, 3].map(|c| self.real(280, 400, 4 * r + c));
            let rows = [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]];
            to_mm(Matrix4::from_fn(|r, c| rows[r][c]))
        });
        match (by_rows, by_quaternion) {
            (Some(taken), Some(other)) => (taken, two_affines::compare(&taken, &other, dims, ["sform", "qform"])),
            (Some(taken), None) => {
                let sizes = self.spacing() * self.unit().mm;
                (taken, two_affines::compare_sizes(&taken, sizes, ["sform", "pixdim"]))
            }
            (None, Some(taken)) => (taken, None),
            (None, None) => (to_mm(Matrix4::from_diagonal(&self.spacing().push(1.0))), None),
        }
    }

    fn spacing(&self) -> nalgebra::Vector3<f64> {
        nalgebra::Vector3::from_fn(|k, _| self.real(76, 104, k + 1).abs())
    }

    fn qform(&self) -> Matrix4<f64> {
        let [b, c, d] = [0, 1, 2].map(|k| self.real(256, 352, k));
        // The file holds only the vector part of a unit quaternion with scalar part a ≥ 0.
        let a = (1.0 - b * b - c * c - d * d).max(0.0).sqrt();
        let rotation = UnitQuaternion::from_quaternion(Quaternion::new(a, b, c, d)).to_homogeneous();
        let handedness = if self.real(76, 104, 0) < 0.0 { -1.0 } else { 1.0 };
        let s = self.spacing();
        let mut affine = rotation * Matrix4::from_diagonal(&Vector4::new(s.x, s.y, s.z * handedness, 1.0));
        let offset = [0, 1, 2].map(|k| self.real(268, 376, k));
        affine.set_column(3, &Vector4::new(offset[0], offset[1], offset[2], 1.0));
        affine
    }
}

/// A NIfTI-1 file, little-endian, with the affine as sform (single precision, mm); labels in the narrowest of 8, 16 and
/// 32 bits that can hold all of them.
pub fn write_nifti(volume: &LabelVolume) -> Vec<u8> {
    let largest = volume.labels().iter().copied().max().unwrap_or(0);
    let (code, size): (i16, usize) = match largest {
        0..=0xff => (2, 1),
        0x100..=0xffff => (512, 2),
        _ => (768, 4),
    };
    let mut file = vec![0; HEADER_1_BYTES];
    let mut put = |at: usize, bytes: &[u8]| file[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, &348i32.to_le_bytes());
    let [nx, ny, nz] = volume.dims().map(|d| d as i16);
    for (k, d) in [3, nx, ny, nz, 1, 1, 1, 1].into_iter().enumerate() {
        put(40 + 2 * k, &d.to_le_bytes());
    }
    put(70, &code.to_le_bytes());
    put(72, &(8 * size as i16).to_le_bytes());
    let [sx, sy, sz] = volume.spacing_mm();
    for (k, s) in [1.0, sx, sy, sz].into_iter().enumerate() {
        put(76 + 4 * k, &(s as f32).to_le_bytes());
    }
    put(108, &(HEADER_1_BYTES as f32).to_le_bytes());
    put(112, &1f32.to_le_bytes());
    put(123, &[2]); // millimeters
    put(254, &1i16.to_le_bytes()); // sform: scanner coordinates
    for r in 0..3 {
        for c in 0..4 {
            put(280 + 16 * r + 4 * c, &(volume.affine()[(r, c)] as f32).to_le_bytes());
        }
    }
    put(344, b"n+1\0");
    file.extend(volume.labels().iter().flat_map(|l| l.to_le_bytes().into_iter().take(size)));
    file
}

/// [`write_nifti`] compressed with gzip; the same volume gives the same bytes.
pub fn write_nifti_gz(volume: &LabelVolume) -> Vec<u8> {
    let mut encoder = GzBuilder::new().mtime(0).write(Vec::new(), Compression::default());
    // Writing to memory cannot fail.
    let written = encoder.write_all(&write_nifti(volume)).and_then(|()| encoder.finish());
    written.unwrap_or_default()
}
