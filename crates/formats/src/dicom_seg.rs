//! DICOM segmentations (SEG) in one file: binary, fractional and label maps, of one or many segments.
//!
//! Source: DICOM PS3.3, sections A.51 and C.8.20. The geometry is that of the functional groups of the frames. A frame that
//! is missing for one segment but present for another is empty for it, as the standard allows; where the stack of all
//! frames has a gap, the file is refused, because nothing says whether the structure is absent there or the frame was lost.
//! Segments may overlap. Coordinates are LPS and are converted to RAS.

use super::dicom::{DataSet, PixelEncoding, SOP_CLASS, read_file, rle_frame};
use super::label_file::{LabelFile, Overlay};
use super::{FormatError, ReadLimits, lps};
use nalgebra::{Matrix4, Vector3};
use std::borrow::Cow;
use std::collections::BTreeMap;

pub(super) const PIXEL_DATA: u32 = 0x7fe0_0010;
const SHARED_GROUPS: u32 = 0x5200_9229;
const FRAME_GROUPS: u32 = 0x5200_9230;
const PIXEL_MEASURES: u32 = 0x0028_9110;
const PLANE_ORIENTATION: u32 = 0x0020_9116;
const PLANE_POSITION: u32 = 0x0020_9113;
const SLIDE_POSITION: u32 = 0x0048_021a;
const SEGMENT_IDENTIFICATION: u32 = 0x0062_000a;
const SEGMENTS: u32 = 0x0062_0002;
/// Sequences that are read, for files that do not say which values are sequences.
pub(super) const SEQUENCES: [u32; 8] = [
    SHARED_GROUPS,
    FRAME_GROUPS,
    PIXEL_MEASURES,
    PLANE_ORIENTATION,
    PLANE_POSITION,
    SLIDE_POSITION,
    SEGMENT_IDENTIFICATION,
    SEGMENTS,
];

/// Share of the largest value from which a voxel of a fractional segmentation belongs to a segment.
const FRACTION: f64 = 0.5;
/// How far a frame may be from its place in the stack, in frames.
const PLACE_TOLERANCE: f64 = 0.05;

/// Reads a label volume whose labels are the numbers of the segments.
///
/// # Errors
/// [`FormatError`]; other DICOM objects, segmentations of slides, frames that are not parallel or not equally spaced, and
/// stacks with gaps are refused.
///
/// # Cost
/// Linear in the number of voxels of all frames.
pub fn read_dicom_seg(bytes: &[u8], limits: &ReadLimits) -> Result<LabelFile, FormatError> {
    let mut inflated = Vec::new();
    let (set, encoding) = read_file(bytes, &mut inflated, limits.max_inflated_bytes)?;
    check_class(&set)?;
    let size = |tag| set.short(tag).map_or(0, usize::from);
    let (rows, columns) = (size(0x0028_0010), size(0x0028_0011));
    let groups = set.items(FRAME_GROUPS);
    let stated: usize = set.text(0x0028_0008).parse().unwrap_or(1);
    if rows == 0 || columns == 0 || groups.is_empty() || stated != groups.len() {
        let value = format!("{rows} rows, {columns} columns, {stated} frames, functional groups of {}", groups.len());
        return Err(fault("size", value, "each frame needs functional groups; export the segmentation again"));
    }
    let stack = Stack::new(&set, groups)?;
    let dims = [columns, rows, stack.n_frames];
    let n_voxels = dims.iter().fold(1u64, |n, &d| n.saturating_mul(d as u64));
    let limit = limits.max_inflated_bytes as u64;
    if n_voxels.saturating_mul(4) > limit {
        return Err(FormatError::TooLarge { what: "bytes of voxels", found: n_voxels.saturating_mul(4), limit });
    }
    let frames = Frames::new(&set, encoding, rows * columns, groups.len())?;
    let mut notes = vec![lps::NOTE.to_owned()];
    if let Kind::Fractional { .. } = frames.kind {
        notes.push(
            "the segmentation is fractional: voxels with at least half the largest value belong to a segment"
                .to_owned(),
        );
    }
    let mut overlay = Overlay::new(n_voxels as usize);
    for (k, group) in groups.iter().enumerate() {
        let first = stack.place[k] * rows * columns;
        let segment = group.item(SEGMENT_IDENTIFICATION).and_then(|s| s.short(0x0062_000b)).map(u32::from);
        let segment = segment.filter(|&n| n > 0);
        if segment.is_none() && frames.kind != Kind::LabelMap {
            return Err(fault("segment of a frame", "missing".to_owned(), "each frame must name its segment"));
        }
        frames.visit(k, &mut |at, label| overlay.add(first + at, segment.unwrap_or(label)))?;
    }
    let mut names = BTreeMap::new();
    for segment in set.items(SEGMENTS) {
        let (number, name) = (segment.short(0x0062_0004).unwrap_or(0), segment.text(0x0062_0005));
        if number > 0 && !name.is_empty() {
            names.insert(number.into(), name);
        }
    }
    Ok(LabelFile { volume: overlay.volume(dims, lps::affine_to_ras(&stack.affine))?, names, notes })
}

fn fault(field: &'static str, value: String, advice: &'static str) -> FormatError {
    FormatError::Header { field, value, advice }
}

/// Refuses DICOM objects other than segmentations, by their names.
fn check_class(set: &DataSet<'_>) -> Result<(), FormatError> {
    let (what, advice) = match set.text(SOP_CLASS).as_str() {
        "1.2.840.10008.5.1.4.1.1.66.4" | "1.2.840.10008.5.1.4.1.1.66.7" => return Ok(()),
        "1.2.840.10008.5.1.4.1.1.481.3" => (
            "a DICOM RT structure set",
            "its contours are not a volume; convert it to a label volume on the grid of its images, for example with \
             plastimatch or 3D Slicer, and send that as DICOM SEG, NIfTI or NRRD",
        ),
        "1.2.840.10008.5.1.4.1.1.66.5" => {
            ("a DICOM surface segmentation", "save its surface as PLY, STL, VTK or GIFTI")
        }
        _ => (
            "a DICOM object that is not a segmentation",
            "send a segmentation of the structure (DICOM SEG, NIfTI, NRRD, MetaImage or MGZ), not an image",
        ),
    };
    Err(FormatError::Unsupported { what, advice })
}

/// Where the frames lie.
struct Stack {
    /// Slice of each frame.
    place: Vec<usize>,
    n_frames: usize,
    /// Voxels to LPS.
    affine: Matrix4<f64>,
}

impl Stack {
    fn new(set: &DataSet<'_>, groups: &[DataSet<'_>]) -> Result<Self, FormatError> {
        let shared = set.item(SHARED_GROUPS);
        // A functional group is shared by all frames, or stated for each.
        let group = |frame: &DataSet<'_>, sequence, tag| -> Vec<f64> {
            let own = frame.item(sequence).map(|item| item.numbers(tag)).filter(|v| !v.is_empty());
            own.or_else(|| shared?.item(sequence).map(|item| item.numbers(tag))).unwrap_or_default()
        };
        let of_slide = |set: &DataSet<'_>| set.item(SLIDE_POSITION).is_some();
        if groups.iter().any(of_slide) || shared.is_some_and(of_slide) {
            return Err(FormatError::Unsupported {
                what: "a segmentation of a microscope slide",
                advice: "send a segmentation of a three-dimensional image",
            });
        }
        let orientation = group(&groups[0], PLANE_ORIENTATION, 0x0020_0037);
        let [xr, yr, zr, xc, yc, zc] = orientation[..] else {
            return Err(fault("plane orientation", format!("{orientation:?}"), "six direction cosines are needed"));
        };
        let (along_row, along_column) = (Vector3::new(xr, yr, zr), Vector3::new(xc, yc, zc));
        let normal = along_row.cross(&along_column);
        if !(0.99..1.01).contains(&normal.norm()) {
            return Err(fault(
                "plane orientation",
                format!("{orientation:?}"),
                "two orthogonal unit vectors are needed",
            ));
        }
        let spacing = group(&groups[0], PIXEL_MEASURES, 0x0028_0030);
        let [between_rows, between_columns] = spacing[..] else {
            return Err(fault("pixel spacing", format!("{spacing:?}"), "two numbers are needed"));
        };
        let mut positions = Vec::with_capacity(groups.len());
        for frame in groups {
            let position = group(frame, PLANE_POSITION, 0x0020_0032);
            let [x, y, z] = position[..] else {
                let advice = "every frame needs the position of its first pixel";
                return Err(fault("plane position of a frame", format!("{position:?}"), advice));
            };
            let same = [(PLANE_ORIENTATION, 0x0020_0037, &orientation), (PIXEL_MEASURES, 0x0028_0030, &spacing)];
            if same.iter().any(|&(sequence, tag, first)| group(frame, sequence, tag) != *first) {
                let advice = "all frames must have the same orientation and pixel spacing";
                return Err(FormatError::Unsupported { what: "a segmentation of several stacks", advice });
            }
            positions.push(Vector3::new(x, y, z));
        }
        let depth: Vec<f64> = positions.iter().map(|p| p.dot(&normal)).collect();
        let mut order: Vec<usize> = (0..depth.len()).collect();
        order.sort_by(|&a, &b| depth[a].total_cmp(&depth[b]));
        let measured = |tag| group(&groups[0], PIXEL_MEASURES, tag).first().copied().filter(|&v| v > 0.0);
        let (between, thickness) = (measured(0x0018_0088), measured(0x0018_0050));
        let nominal = between.or(thickness).unwrap_or(1.0);
        // Positions are rounded when they are written, so equal ones differ a little.
        let steps = order.windows(2).map(|w| depth[w[1]] - depth[w[0]]).filter(|&s| s > PLACE_TOLERANCE * nominal);
        let least = steps.fold(f64::INFINITY, f64::min);
        let step = between.or(Some(least).filter(|s| s.is_finite())).or(thickness).unwrap_or(1.0);
        let (first, last) = (order[0], order[order.len() - 1]);
        let mut place = vec![0; depth.len()];
        let mut previous = 0;
        for &k in &order {
            let slices = (depth[k] - depth[first]) / step;
            let slice = slices.round();
            if (slices - slice).abs() > PLACE_TOLERANCE.max(1e-4 * slice) {
                let value = format!("{slices:.2} slices of {step} mm from the first");
                return Err(fault(
                    "position of a frame",
                    value,
                    "frames must be equally spaced; resample the segmentation",
                ));
            }
            if slice > f64::from(previous) + 1.0 {
                let missing = slice - f64::from(previous) - 1.0;
                let from = positions[order[place_index(&order, k) - 1]];
                let to = positions[k];
                let value = format!(
                    "{missing} missing slices of {step} mm between the frames at ({}, {}, {}) and ({}, {}, {}) mm LPS",
                    from.x, from.y, from.z, to.x, to.y, to.z
                );
                let advice = "the stack of frames must have no gap; write empty frames too (dcmqi: --skip 0, highdicom: \
                              omit_empty_frames=False), or send each piece of the stack by itself";
                return Err(fault("stack of frames", value, advice));
            }
            previous = slice as u32;
            place[k] = slice as usize;
        }
        // Frames may be sheared against each other, as with a tilted gantry.
        let n_frames = previous as usize + 1;
        let along_stack =
            if n_frames > 1 { (positions[last] - positions[first]) / f64::from(previous) } else { normal * step };
        let mut affine = Matrix4::identity();
        let columns = [along_row * between_columns, along_column * between_rows, along_stack, positions[first]];
        for (k, column) in columns.iter().enumerate() {
            affine.fixed_view_mut::<3, 1>(0, k).copy_from(column);
        }
        let strays = (0..positions.len()).any(|k| {
            let expected = positions[first] + along_stack * place[k] as f64;
            (positions[k] - expected).norm() > 0.1 * between_rows.min(between_columns).max(step)
        });
        if strays {
            let advice = "frames must lie exactly above each other; resample the segmentation";
            return Err(FormatError::Unsupported {
                what: "a segmentation whose frames are shifted against each other",
                advice,
            });
        }
        Ok(Stack { place, n_frames, affine })
    }
}

fn place_index(order: &[usize], frame: usize) -> usize {
    order.iter().position(|&k| k == frame).unwrap_or(1)
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Binary,
    Fractional {
        /// Least value of a voxel that belongs to the segment.
        threshold: f64,
    },
    LabelMap,
}

/// The pixels of all frames.
struct Frames<'a> {
    kind: Kind,
    bits: u16,
    /// Pixels of a frame.
    n_pixels: usize,
    frames: FrameData<'a>,
}

enum FrameData<'a> {
    Native(&'a [u8]),
    Rle(Vec<&'a [u8]>),
}

impl<'a> Frames<'a> {
    fn new(set: &DataSet<'a>, encoding: PixelEncoding, n_pixels: usize, n_frames: usize) -> Result<Self, FormatError> {
        let bits = set.short(0x0028_0100).unwrap_or(0);
        let kind = match set.text(0x0062_0001).as_str() {
            "BINARY" => Kind::Binary,
            "FRACTIONAL" => {
                let largest = set.short(0x0062_000e).filter(|&v| v > 0).unwrap_or(255);
                Kind::Fractional { threshold: FRACTION * f64::from(largest) }
            }
            "LABELMAP" => Kind::LabelMap,
            _ => {
                let advice = "it must be BINARY, FRACTIONAL or LABELMAP";
                return Err(FormatError::Unsupported { what: "this type of DICOM segmentation", advice });
            }
        };
        let valid = match kind {
            Kind::Binary => [1, 8].contains(&bits),
            Kind::Fractional { .. } => bits == 8,
            Kind::LabelMap => [8, 16].contains(&bits),
        };
        if !valid || encoding == PixelEncoding::Rle && bits != 8 {
            let advice = "a binary segmentation has 1 bit a pixel, a fractional one 8, a label map 8 or 16";
            return Err(fault("bits allocated", bits.to_string(), advice));
        }
        let frames = match encoding {
            PixelEncoding::Native => {
                let bytes = set.bytes(PIXEL_DATA);
                let needed = (n_pixels as u64).saturating_mul(n_frames as u64).saturating_mul(bits.into()).div_ceil(8);
                if (bytes.len() as u64) < needed {
                    let available = bytes.len() as u64;
                    return Err(FormatError::Truncated { part: "the pixel data", needed, available });
                }
                FrameData::Native(bytes)
            }
            PixelEncoding::Rle => {
                let fragments = set.fragments(PIXEL_DATA);
                if fragments.len() != n_frames {
                    let value = format!("{} for {n_frames} frames", fragments.len());
                    return Err(fault("number of fragments", value, "each frame must be one fragment"));
                }
                FrameData::Rle(fragments.to_vec())
            }
        };
        Ok(Frames { kind, bits, n_pixels, frames })
    }

    /// Hands every pixel of a frame that belongs to a segment, with its value, to `take`.
    fn visit(
        &self,
        frame: usize,
        take: &mut dyn FnMut(usize, u32) -> Result<(), FormatError>,
    ) -> Result<(), FormatError> {
        let n = self.n_pixels;
        if let (FrameData::Native(bytes), 1) = (&self.frames, self.bits) {
            // The lowest bit comes first, and frames follow each other without padding.
            for pixel in 0..n {
                let bit = frame * n + pixel;
                if bytes[bit / 8] >> (bit % 8) & 1 == 1 {
                    take(pixel, 1)?;
                }
            }
            return Ok(());
        }
        let size = usize::from(self.bits / 8);
        let pixels: Cow<'_, [u8]> = match &self.frames {
            FrameData::Native(bytes) => Cow::Borrowed(&bytes[frame * n * size..(frame + 1) * n * size]),
            FrameData::Rle(fragments) => {
                let damaged = FormatError::Payload { format: "DICOM", line: None };
                Cow::Owned(rle_frame(fragments[frame], n).ok_or(damaged)?)
            }
        };
        let least = if let Kind::Fractional { threshold } = self.kind { threshold.max(1.0) } else { 1.0 };
        for (pixel, b) in pixels.chunks_exact(size).enumerate() {
            let value = b.iter().rev().fold(0u32, |value, &byte| value << 8 | u32::from(byte));
            if f64::from(value) >= least {
                take(pixel, value)?;
            }
        }
        Ok(())
    }
}
