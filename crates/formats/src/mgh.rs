//! FreeSurfer volumes: MGH, and MGZ, its gzip-compressed form.
//!
//! Source: FreeSurfer's description of the MGH/MGZ volume format. Big-endian; the header has 284 bytes. The trailer
//! after the voxels (scan parameters, tags) is not read but checked: further voxels mean that the sizes are wrong. The
//! affine maps voxels to scanner RAS: `Mdc · diag(voxel sizes)`, with `c_ras` at the voxel `dimensions / 2`.

use super::budget::Budget;
use super::element::{ByteOrder, Element, Rest, Voxels};
use super::label_file::LabelFile;
use super::{FormatError, ReadLimits};
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix3, Matrix4, Vector3};

const HEADER_BYTES: usize = 284;

/// Whether `bytes` begin like an MGH file: version 1 and plausible counts.
pub(super) fn is_mgh(bytes: &[u8]) -> bool {
    let Some(head) = bytes.get(..24) else { return false };
    let fields = Element::I32.wholes(head, ByteOrder::Big);
    // Newer versions of FreeSurfer store an intent above the version.
    let is_version = fields[0] & 0xff == 1 && (1..1 << 16).contains(&fields[0]);
    is_version && fields[1..5].iter().all(|&d| (1..=1 << 20).contains(&d)) && (0..=11).contains(&fields[5])
}

/// Size of the voxels that a header declares, bytes; 0 if it is invalid.
pub(super) fn declared(head: &[u8]) -> usize {
    voxels_of(head).map_or(0, |voxels| voxels.stored())
}

/// The voxels that a header declares.
fn voxels_of(bytes: &[u8]) -> Result<Voxels, FormatError> {
    let Some(head) = bytes.get(..HEADER_BYTES) else {
        let available = bytes.len() as u64;
        return Err(FormatError::Truncated { part: "the MGH header", needed: HEADER_BYTES as u64, available });
    };
    let counts = Element::I32.wholes(&head[4..24], ByteOrder::Big);
    if counts[..4].iter().any(|&d| d < 1) {
        let advice = "every dimension must be at least 1";
        return Err(FormatError::Header { field: "list of dimensions", value: format!("{:?}", &counts[..4]), advice });
    }
    if counts[3] != 1 {
        let advice = "only three dimensions are supported; send one volume of the series";
        return Err(FormatError::Header { field: "number of frames", value: counts[3].to_string(), advice });
    }
    let element = match counts[4] {
        0 => Element::U8,
        1 => Element::I32,
        3 => Element::F32,
        4 => Element::I16,
        10 => Element::U16,
        other => {
            let advice = "save the labels as integers or real numbers";
            return Err(FormatError::Header { field: "data type", value: other.to_string(), advice });
        }
    };
    let dims = [0, 1, 2].map(|k| counts[k] as usize);
    Ok(Voxels::plain(dims, element, ByteOrder::Big))
}

/// Reads a label volume.
///
/// # Errors
/// [`FormatError`]; several frames, and element types other than numbers, are not supported.
///
/// # Cost
/// Linear in the file's length.
pub fn read_mgh(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let available = bytes.len() as u64;
    let voxels = voxels_of(bytes)?;
    let (dims, head) = (voxels.dims, &bytes[..HEADER_BYTES]);
    let needed = HEADER_BYTES + voxels.bytes_needed(limits.max_inflated_bytes)?;
    if bytes.len() < needed {
        return Err(FormatError::Truncated { part: "the voxel array", needed: needed as u64, available });
    }
    let budget = Budget::of(limits);
    budget.grant_voxels(voxels.declared());
    let labels = voxels.labels(&bytes[HEADER_BYTES..needed], &budget)?;
    let rest = &bytes[needed..];
    let note = if is_footer(rest) { None } else { voxels.check_rest(needed - HEADER_BYTES, Rest::of(rest))? };
    // Without the flag, FreeSurfer assumes coronal slices of 1 mm around the origin.
    let has_geometry = Element::I16.wholes(&head[28..30], ByteOrder::Big)[0] > 0;
    let g = Element::F32.reals(&head[30..90], ByteOrder::Big);
    let (sizes, directions, center) = if has_geometry {
        (
            Vector3::from_column_slice(&g[..3]),
            Matrix3::from_column_slice(&g[3..12]),
            Vector3::from_column_slice(&g[12..15]),
        )
    } else {
        let coronal = Matrix3::new(-1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0);
        (Vector3::repeat(1.0), coronal, Vector3::zeros())
    };
    let linear = directions * Matrix3::from_diagonal(&sizes);
    let middle = Vector3::from_fn(|k, _| dims[k] as f64 / 2.0);
    let mut affine = Matrix4::identity();
    affine.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
    affine.fixed_view_mut::<3, 1>(0, 3).copy_from(&(center - linear * middle));
    let mut file = LabelFile::unnamed(LabelVolume::new(dims, labels, affine)?);
    file.notes.extend(note);
    if !has_geometry {
        file.space = homolog_contract::input::InputSpace::Unknown;
        file.notes
            .push("the file has no geometry: 1 mm voxels in coronal slices around the origin are assumed".to_owned());
    }
    Ok(file)
}

/// Whether `rest` is FreeSurfer's trailer: four or five scan parameters, then tags, each with its length.
fn is_footer(rest: &[u8]) -> bool {
    // Tags of older versions, without a length, and one with a length of four bytes.
    const WITHOUT_LENGTH: [i64; 3] = [1, 2, 20];
    const OLD_TRANSFORM: i64 = 30;
    if rest.len() <= 20 {
        return true;
    }
    [20, 16].iter().any(|&parameters| {
        let mut tags = &rest[parameters..];
        loop {
            // The end, zeros as padding, or an unknown part of a tag.
            if tags.len() < 4 || tags.iter().all(|&byte| byte == 0) {
                return true;
            }
            let tag = Element::I32.whole_of(&tags[..4], ByteOrder::Big);
            if WITHOUT_LENGTH.contains(&tag) {
                return true;
            }
            let kind = if tag == OLD_TRANSFORM { Element::I32 } else { Element::I64 };
            let begin = 4 + kind.size();
            let Some(length) = tags.get(4..begin).map(|raw| kind.whole_of(raw, ByteOrder::Big)) else { return false };
            let valid = (1..1000).contains(&tag);
            let after = usize::try_from(length).ok().and_then(|n| tags.get(n.checked_add(begin)?..));
            match after.filter(|_| valid) {
                Some(after) => tags = after,
                None => return false,
            }
        }
    })
}
