//! NIfTI-1 label volumes: single files (`n+1`), either byte order, plain or gzip.
//!
//! Source: nifti1.h of the NIfTI data format working group (2007). The header is checked against the length of the
//! file before anything is allocated. The affine is the sform if its code is positive, else the qform, else the
//! voxel sizes alone ("method 1"), scaled to millimetres.

use super::gzip::{inflate_prefix, unverified_prefix};
use super::{FormatError, ReadLimits};
use flate2::{Compression, GzBuilder};
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector4};
use std::io::Write;

/// Length of the header with the extension flag.
pub(super) const HEADER_BYTES: usize = 352;

/// How far a value may be from an integer and still count as a label: rounding of scaled single-precision values.
const LABEL_TOLERANCE: f64 = 1e-3;

/// Whether these are the first bytes of a NIfTI file of either version or of its predecessor ANALYZE.
pub(super) fn is_nifti(head: &[u8]) -> bool {
    let size = head.first_chunk::<4>().map_or(0, |b| i32::from_le_bytes(*b));
    let sizes = [size, size.swap_bytes()];
    head.len() >= 348 && sizes.iter().any(|s| [348, 540].contains(s)) || head.get(344..347) == Some(b"n+1".as_slice())
}

/// Reads a label volume; `bytes` may be compressed.
///
/// # Errors
/// [`FormatError`]: two-file or NIfTI-2 variants, more than three dimensions, an element type that is not a number,
/// values that are not labels, a file shorter than its header says, an affine that is singular or not finite, a gzip
/// stream that is damaged or incomplete, even after the last voxel.
///
/// # Cost
/// Linear in the inflated size, which `limits` bound; keeps no more of it than the header asks for.
pub fn read_nifti(bytes: &[u8], limits: &ReadLimits) -> Result<LabelVolume, FormatError> {
    let head = unverified_prefix(bytes, HEADER_BYTES)?;
    let header = Header::parse(&head)?;
    let n_voxels = header.n_voxels();
    let limit = limits.max_inflated_bytes as u64;
    let needed = n_voxels.saturating_mul(header.element.size() as u64).saturating_add(header.offset);
    // Labels are kept in four bytes, whatever the file has.
    let kept = n_voxels.saturating_mul(4);
    if needed.max(kept) > limit {
        return Err(FormatError::TooLarge { what: "bytes of voxels", found: needed.max(kept), limit });
    }
    let plain = inflate_prefix(bytes, needed as usize, limits.max_inflated_bytes)?;
    if (plain.len() as u64) < needed {
        return Err(FormatError::Truncated { part: "the voxel array", needed, available: plain.len() as u64 });
    }
    let voxels = &plain[header.offset as usize..needed as usize];
    let labels = header.labels(voxels)?;
    Ok(LabelVolume::new(header.dims, labels, header.affine)?)
}

/// The fields of the header that are used, validated.
#[derive(Debug)]
struct Header {
    dims: [usize; 3],
    element: Element,
    big_endian: bool,
    offset: u64,
    slope: f64,
    intercept: f64,
    affine: Matrix4<f64>,
}

/// Type of a voxel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Element {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    U64,
    I64,
    F32,
    F64,
}

impl Element {
    fn from_code(code: i16) -> Option<Self> {
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

    fn size(self) -> usize {
        match self {
            Element::U8 | Element::I8 => 1,
            Element::U16 | Element::I16 => 2,
            Element::U32 | Element::I32 | Element::F32 => 4,
            Element::U64 | Element::I64 | Element::F64 => 8,
        }
    }

    /// The value of one voxel; `b` has the bytes in little-endian order, padded with zeros. 64-bit integers are rounded,
    /// but labels are small enough to be exact.
    fn value(self, b: [u8; 8]) -> f64 {
        let low = u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
        match self {
            Element::U8 => f64::from(b[0]),
            Element::I8 => f64::from(b[0] as i8),
            Element::U16 => f64::from(low as u16),
            Element::I16 => f64::from(low as u16 as i16),
            Element::U32 => f64::from(low),
            Element::I32 => f64::from(low as i32),
            Element::F32 => f64::from(f32::from_bits(low)),
            Element::U64 => u64::from_le_bytes(b) as f64,
            Element::I64 => i64::from_le_bytes(b) as f64,
            Element::F64 => f64::from_le_bytes(b),
        }
    }
}

impl Header {
    fn parse(head: &[u8]) -> Result<Self, FormatError> {
        if head.len() < 348 {
            let available = head.len() as u64;
            return Err(FormatError::Truncated { part: "the NIfTI header", needed: 348, available });
        }
        let f = Fields { bytes: head, big_endian: i32::from_le_bytes([head[0], head[1], head[2], head[3]]) != 348 };
        match (f.i32(0), &head[344..347]) {
            (348, b"n+1") => {}
            (348, b"ni1") => {
                let advice = "save the volume as one .nii or .nii.gz file";
                return Err(FormatError::Unsupported {
                    what: "a NIfTI header without its voxels (.hdr and .img)",
                    advice,
                });
            }
            (540, _) => {
                return Err(FormatError::Unsupported { what: "NIfTI-2", advice: "save the volume as NIfTI-1" });
            }
            _ => {
                let advice = "save the volume as NIfTI-1 (.nii or .nii.gz)";
                return Err(FormatError::Unsupported { what: "this variant of ANALYZE or NIfTI", advice });
            }
        }
        let dims = f.dims()?;
        let code = f.i16(70);
        let element = Element::from_code(code).ok_or_else(|| FormatError::Header {
            field: "data type code",
            value: code.to_string(),
            advice: "save the labels as integers or real numbers",
        })?;
        let offset = f.f32(108);
        if offset.is_nan() || !(offset == 0.0 || (348.0..=1e9).contains(&offset)) || offset.fract() != 0.0 {
            let advice = "it must be an integer of at least 348, as a rule 352; write the file again";
            return Err(FormatError::Header { field: "voxel offset", value: offset.to_string(), advice });
        }
        let offset = if offset == 0.0 { HEADER_BYTES as u64 } else { offset as u64 };
        let (slope, intercept) = (f.f32(112), f.f32(116));
        // A slope of 0 means that values are not scaled.
        let scaled = slope != 0.0 && slope.is_finite() && intercept.is_finite();
        let (slope, intercept) = if scaled { (slope, intercept) } else { (1.0, 0.0) };
        Ok(Header { dims, element, big_endian: f.big_endian, offset, slope, intercept, affine: f.affine()? })
    }

    fn n_voxels(&self) -> u64 {
        self.dims.iter().map(|&d| d as u64).product()
    }

    fn labels(&self, voxels: &[u8]) -> Result<Vec<u32>, FormatError> {
        let size = self.element.size();
        let mut labels = Vec::with_capacity(voxels.len() / size);
        let mut previous: Option<(&[u8], u32)> = None;
        for raw in voxels.chunks_exact(size) {
            let label = match previous {
                // Neighbouring voxels mostly have the same label.
                Some((same, label)) if same == raw => label,
                _ => self.label(raw, labels.len())?,
            };
            previous = Some((raw, label));
            labels.push(label);
        }
        Ok(labels)
    }

    fn label(&self, raw: &[u8], at: usize) -> Result<u32, FormatError> {
        let mut b = [0; 8];
        b[..raw.len()].copy_from_slice(raw);
        if self.big_endian {
            b[..raw.len()].reverse();
        }
        let value = self.element.value(b) * self.slope + self.intercept;
        let whole = value.round();
        if (value - whole).abs() <= LABEL_TOLERANCE && (0.0..=f64::from(u32::MAX)).contains(&whole) {
            return Ok(whole as u32);
        }
        let [nx, ny, _] = self.dims;
        Err(FormatError::NotALabel { voxel: [at % nx, at / nx % ny, at / (nx * ny)], value })
    }
}

/// Numbers at byte offsets of the header.
struct Fields<'a> {
    bytes: &'a [u8],
    big_endian: bool,
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

    fn f32(&self, at: usize) -> f64 {
        f64::from(f32::from_le_bytes(self.array(at)))
    }

    fn dims(&self) -> Result<[usize; 3], FormatError> {
        let dim: [i16; 8] = std::array::from_fn(|k| self.i16(40 + 2 * k));
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

    fn affine(&self) -> Result<Matrix4<f64>, FormatError> {
        let mut affine = if self.i16(254) > 0 {
            let row = |r: usize| [0, 1, 2, 3].map(|c| self.f32(280 + 16 * r + 4 * c));
            let rows = [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]];
            Matrix4::from_fn(|r, c| rows[r][c])
        } else if self.i16(252) > 0 {
            self.qform()
        } else {
            Matrix4::from_diagonal(&self.spacing().push(1.0))
        };
        // Bits 0 to 2: 1 metre, 2 millimetre, 3 micrometre; 0 is unknown, in practice millimetre.
        let to_mm = match self.bytes[123] & 7 {
            1 => 1000.0,
            3 => 0.001,
            _ => 1.0,
        };
        affine.fixed_view_mut::<3, 4>(0, 0).scale_mut(to_mm);
        Ok(affine)
    }

    fn spacing(&self) -> nalgebra::Vector3<f64> {
        nalgebra::Vector3::from_fn(|k, _| self.f32(80 + 4 * k).abs())
    }

    fn qform(&self) -> Matrix4<f64> {
        let [b, c, d] = [256, 260, 264].map(|at| self.f32(at));
        // The file holds only the vector part of a unit quaternion with scalar part a ≥ 0.
        let a = (1.0 - b * b - c * c - d * d).max(0.0).sqrt();
        let rotation = UnitQuaternion::from_quaternion(Quaternion::new(a, b, c, d)).to_homogeneous();
        let handedness = if self.f32(76) < 0.0 { -1.0 } else { 1.0 };
        let s = self.spacing();
        let mut affine = rotation * Matrix4::from_diagonal(&Vector4::new(s.x, s.y, s.z * handedness, 1.0));
        affine.set_column(3, &Vector4::new(self.f32(268), self.f32(272), self.f32(276), 1.0));
        affine
    }
}

/// A NIfTI-1 file, little-endian, with the affine as sform (single precision, mm); labels in the narrowest of 8, 16
/// and 32 bits that holds them all.
pub fn write_nifti(volume: &LabelVolume) -> Vec<u8> {
    let largest = volume.labels().iter().copied().max().unwrap_or(0);
    let (code, size): (i16, usize) = match largest {
        0..=0xff => (2, 1),
        0x100..=0xffff => (512, 2),
        _ => (768, 4),
    };
    let mut file = vec![0; HEADER_BYTES];
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
    put(108, &(HEADER_BYTES as f32).to_le_bytes());
    put(112, &1f32.to_le_bytes());
    put(123, &[2]); // millimetres
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
