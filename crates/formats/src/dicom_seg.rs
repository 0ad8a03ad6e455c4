//! DICOM segmentations (SEG) in one file or several: binary, fractional and label maps, of one or many segments.
//!
//! Source: DICOM PS3.3, sections A.51 and C.8.20. The functional groups of the frames define the geometry. Writers may
//! leave out empty frames: the frames lie on a regular stack, and where the stack has no frame of a segment, the
//! segment is absent. A note states how many slices between the frames of the chosen segments have none, since a lost
//! frame looks the same. Frames of other segments that lie off the stack are left out. Segments may overlap.
//! Coordinates are LPS and are converted to RAS.

use super::budget::Budget;
use super::dicom::{
    BITS_ALLOCATED, COLUMNS, DataSet, FRAME_GROUPS, N_FRAMES, PIXEL_DATA, PIXEL_MEASURES, PLANE_ORIENTATION,
    PLANE_POSITION, PixelEncoding, ROWS, SEGMENT_IDENTIFICATION, SEGMENTS, SHARED_GROUPS, SLIDE_POSITION, SOP_CLASS,
    SOP_INSTANCE, read_file, rle_frame,
};
use super::label_file::{LabelFile, Overlay};
use super::{FormatError, ReadLimits, ReadOptions, lps};
use homolog_contract::input::InputSpace;
use nalgebra::{Matrix4, Vector3};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Bytes held for each frame besides its pixels.
const FRAME_BYTES: usize = 160;
/// Largest distance of a frame from its place in the stack, in frames.
const PLACE_TOLERANCE: f64 = 0.05;

/// Reads a label volume whose labels are the segment numbers, from one instance or from several on one grid, such as
/// the parts of a series. If instances use the same number for different segments, the segments of later instances get
/// new numbers, and a note says so; parts of one concatenation share their numbers.
///
/// # Errors
/// [`FormatError`]. Other DICOM objects, segmentations of slides, and frames of the chosen segments that are not
/// parallel or not on a regular stack are refused.
///
/// # Cost
/// Linear in the number of voxels of all frames.
pub fn read_dicom_seg(files: &[&[u8]], limits: &ReadLimits, options: &ReadOptions) -> Result<LabelFile, FormatError> {
    let fraction = options.fraction;
    let mut inflated = vec![Vec::new(); files.len()];
    let budget = Budget::of(limits);
    let each = ReadLimits { max_inflated_bytes: limits.max_inflated_bytes / files.len().max(1), ..*limits };
    let mut instances = Vec::with_capacity(files.len());
    for (bytes, inflated) in files.iter().zip(&mut inflated) {
        instances.push(Instance::new(read_file(bytes, inflated, &each, &budget)?, fraction, &budget)?);
    }
    instances.sort_by_cached_key(Instance::order);
    let size = instances.first().map_or((0, 0), |first| (first.rows, first.columns));
    let (rows, columns) = size;
    if instances.iter().any(|instance| (instance.rows, instance.columns) != size) {
        return Err(of_different("sizes of frames"));
    }
    let frame_of_reference = |instance: &Instance<'_>| instance.set.text(0x0020_0052);
    if instances.windows(2).any(|pair| frame_of_reference(&pair[0]) != frame_of_reference(&pair[1])) {
        return Err(of_different("frames of reference"));
    }
    let mut notes = vec![lps::NOTE.to_owned()];
    let n_trailing: usize = instances.iter().map(|instance| instance.set.n_trailing).sum();
    if n_trailing > 0 {
        notes.push(super::trailing_note(n_trailing));
    }
    if instances.iter().any(|instance| matches!(instance.frames.kind, Kind::Fractional { .. })) {
        notes.push(format!(
            "the segmentation is fractional: voxels with at least {fraction} of the largest value belong to a segment"
        ));
    }
    let mut numbers = Numbers::default();
    for instance in &mut instances {
        let concatenation = instance.set.text(0x0020_9161);
        let of_own = || instance.set.text(SOP_INSTANCE);
        instance.owner = numbers.owner(if concatenation.is_empty() { of_own() } else { concatenation });
    }
    let mut names = BTreeMap::new();
    for instance in &instances {
        for segment in instance.set.items(SEGMENTS) {
            let (number, name) = (segment.short(0x0062_0004).unwrap_or(0), segment.text(0x0062_0005));
            if number > 0 {
                let label = numbers.label(instance.owner, number.into());
                if !name.is_empty() {
                    names.insert(label, name);
                }
            }
        }
    }
    let mut placed = Vec::new();
    for instance in &instances {
        let shared = instance.set.item(SHARED_GROUPS);
        for frame in instance.set.items(FRAME_GROUPS) {
            let groups = Groups { shared, frame };
            let segment = groups.segment();
            if segment.is_none() && instance.frames.kind != Kind::LabelMap {
                return Err(fault("segment of a frame", "missing".to_owned(), "each frame must name its segment"));
            }
            budget.push(&mut placed, (groups, segment.map(|number| numbers.label(instance.owner, number))))?;
        }
    }
    let is_chosen = |label: Option<u32>| label.is_none_or(|label| options.asks_for(label, names.get(&label)));
    let stack = stack_of(&placed, &is_chosen, &mut notes)?;
    let dims = [columns, rows, stack.n_frames];
    let n_voxels = dims.iter().fold(1u64, |n, &d| n.saturating_mul(d as u64));
    let limit = limits.max_inflated_bytes as u64;
    if n_voxels.saturating_mul(4) > limit {
        return Err(FormatError::TooLarge { what: "bytes of voxels", found: n_voxels.saturating_mul(4), limit });
    }
    budget.grant_voxels(4 * n_voxels as usize);
    let mut overlay = Overlay::new(n_voxels as usize, &budget)?;
    let mut places = stack.place.iter().zip(&placed);
    for instance in &instances {
        for k in 0..instance.set.items(FRAME_GROUPS).len() {
            let Some((Some(slice), (_, label))) = places.next() else { continue };
            let first = slice * rows * columns;
            // Pixels of one label are consecutive.
            let mut last = (0, 0);
            instance.frames.visit(k, &mut |at, value| {
                let label = label.unwrap_or_else(|| {
                    if last.0 != value {
                        last = (value, numbers.label(instance.owner, value));
                    }
                    last.1
                });
                overlay.add(first + at, label)
            })?;
        }
    }
    if numbers.n_changed > 0 {
        notes.push(format!(
            "{} of instances that number different segments alike got a new number, above those of the others",
            if numbers.n_changed == 1 { "1 segment".to_owned() } else { format!("{} segments", numbers.n_changed) }
        ));
    }
    let volume = overlay.volume(dims, lps::affine_to_ras(&stack.affine))?;
    Ok(LabelFile { volume, space: InputSpace::Lps, names, notes, warnings: Vec::new() })
}

/// Whether a file of part 10 is a segmentation, using at most `n_bytes` of memory.
pub(super) fn is_segmentation(bytes: &[u8], n_bytes: usize) -> bool {
    let mut inflated = Vec::new();
    // Bytes inflated here are inflated once more when the file is read.
    let limits = ReadLimits { max_inflated_bytes: bytes.len().saturating_mul(32), ..ReadLimits::default() };
    read_file(bytes, &mut inflated, &limits, &Budget::new(n_bytes)).is_ok_and(|(set, _)| is_class(&set))
}

fn of_different(what: &'static str) -> FormatError {
    let advice = "the instances must be segmentations on one grid; send them one by one";
    fault("instances", format!("of different {what}"), advice)
}

/// A file that forms part of the volume.
struct Instance<'a> {
    set: DataSet<'a>,
    rows: usize,
    columns: usize,
    frames: Frames<'a>,
    /// Owner of the segment numbers, which parts of one concatenation share.
    owner: usize,
}

impl<'a> Instance<'a> {
    fn new((set, encoding): (DataSet<'a>, PixelEncoding), fraction: f64, budget: &Budget) -> Result<Self, FormatError> {
        check_class(&set)?;
        let size = |tag| set.short(tag).map_or(0, usize::from);
        let (rows, columns) = (size(ROWS), size(COLUMNS));
        let n_frames = set.items(FRAME_GROUPS).len();
        let stated: usize = set.text(N_FRAMES).parse().unwrap_or(1);
        if rows == 0 || columns == 0 || n_frames == 0 || stated != n_frames {
            let value = format!("{rows} rows, {columns} columns, {stated} frames, functional groups of {n_frames}");
            return Err(fault("size", value, "each frame needs functional groups; export the segmentation again"));
        }
        // The list of fragments, and the places and numbers of each frame during the comparison.
        budget.charge(n_frames.saturating_mul(FRAME_BYTES))?;
        let frames = Frames::new(&set, encoding, rows * columns, n_frames, fraction)?;
        Ok(Instance { set, rows, columns, frames, owner: 0 })
    }

    /// Sort key among instances: instance number, number in the concatenation, and identifier.
    fn order(&self) -> (u32, u16, String) {
        let number = self.set.text(0x0020_0013).parse().unwrap_or(u32::MAX);
        (number, self.set.short(0x0020_9162).unwrap_or(0), self.set.text(SOP_INSTANCE))
    }
}

/// Labels for the segments of all instances.
#[derive(Default)]
struct Numbers {
    /// Owners of numbers, each once: an identifier may be long, and labels many.
    owners: Vec<String>,
    labels: BTreeMap<(usize, u32), u32>,
    taken: BTreeSet<u32>,
    n_changed: usize,
}

impl Numbers {
    fn owner(&mut self, name: String) -> usize {
        self.owners.iter().position(|known| *known == name).unwrap_or_else(|| {
            self.owners.push(name);
            self.owners.len() - 1
        })
    }

    fn label(&mut self, owner: usize, number: u32) -> u32 {
        let key = (owner, number);
        if let Some(&label) = self.labels.get(&key) {
            return label;
        }
        let is_new = self.taken.insert(number);
        let label = if is_new { number } else { self.taken.last().map_or(1, |last| last + 1) };
        self.n_changed += usize::from(!is_new);
        self.taken.insert(label);
        self.labels.insert(key, label);
        label
    }
}

/// The functional groups of a frame: its own and the shared ones.
#[derive(Clone, Copy)]
struct Groups<'s, 'a> {
    shared: Option<&'s DataSet<'a>>,
    frame: &'s DataSet<'a>,
}

impl Groups<'_, '_> {
    /// The segment number of the frame.
    fn segment(&self) -> Option<u32> {
        let identification = [Some(self.frame), self.shared].map(|set| set?.item(SEGMENT_IDENTIFICATION));
        let number = identification.into_iter().flatten().find_map(|s| s.short(0x0062_000b));
        number.map(u32::from).filter(|&n| n > 0)
    }

    fn numbers(&self, sequence: u32, tag: u32) -> Vec<f64> {
        let own = self.frame.item(sequence).map(|item| item.numbers(tag)).filter(|v| !v.is_empty());
        own.or_else(|| self.shared?.item(sequence).map(|item| item.numbers(tag))).unwrap_or_default()
    }

    fn is_of_slide(&self) -> bool {
        [Some(self.frame), self.shared].into_iter().flatten().any(|set| set.item(SLIDE_POSITION).is_some())
    }
}

fn fault(field: &'static str, value: String, advice: &'static str) -> FormatError {
    FormatError::Header { field, value, advice }
}

fn is_class(set: &DataSet<'_>) -> bool {
    ["1.2.840.10008.5.1.4.1.1.66.4", "1.2.840.10008.5.1.4.1.1.66.7"].contains(&set.text(SOP_CLASS).as_str())
}

/// Refuses DICOM objects other than segmentations, naming their class.
fn check_class(set: &DataSet<'_>) -> Result<(), FormatError> {
    if is_class(set) {
        return Ok(());
    }
    let (what, advice) = match set.text(SOP_CLASS).as_str() {
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

/// The stack of all frames or, if they lie on none, of the frames of the chosen segments, for whose labels `is_chosen`
/// holds.
fn stack_of(
    placed: &[(Groups<'_, '_>, Option<u32>)],
    is_chosen: &dyn Fn(Option<u32>) -> bool,
    notes: &mut Vec<String>,
) -> Result<Stack, FormatError> {
    let groups = |only_chosen: bool| -> Vec<_> {
        placed.iter().filter(|(_, label)| !only_chosen || is_chosen(*label)).map(|(groups, _)| *groups).collect()
    };
    let n_chosen = placed.iter().filter(|(_, label)| is_chosen(*label)).count();
    let stack = match Stack::new(&groups(false)) {
        Err(_) if (1..placed.len()).contains(&n_chosen) => {
            let found = Stack::new(&groups(true))?;
            let n_left_out = placed.len() - n_chosen;
            notes.push(format!(
                "the frames of other segments do not lie on the stack of the chosen ones, and were left out: {n_left_out} frames"
            ));
            let mut of_chosen = found.place.iter().copied();
            let place =
                placed.iter().map(|(_, label)| if is_chosen(*label) { of_chosen.next()? } else { None }).collect();
            Stack { place, ..found }
        }
        found => found?,
    };
    let chosen = stack.place.iter().zip(placed).filter(|(_, (_, label))| is_chosen(*label));
    let slices: BTreeSet<usize> = chosen.filter_map(|(slice, _)| *slice).collect();
    if let (Some(first), Some(last)) = (slices.first(), slices.last()) {
        let n_between = last - first + 1;
        let n_missing = n_between - slices.len();
        if n_missing > 0 {
            notes.push(format!(
                "{n_missing} of the {n_between} slices from the first frame of the chosen segments to the last have no frame; \
                 they are taken as empty"
            ));
        }
    }
    Ok(stack)
}

/// Positions of the frames.
struct Stack {
    /// Slice of each frame; `None` for frames that are left out.
    place: Vec<Option<usize>>,
    n_frames: usize,
    /// Voxels to LPS.
    affine: Matrix4<f64>,
}

impl Stack {
    fn new(groups: &[Groups<'_, '_>]) -> Result<Self, FormatError> {
        // A functional group is either shared by all frames or stated for each.
        let group = |frame: &Groups<'_, '_>, sequence, tag| frame.numbers(sequence, tag);
        if groups.iter().any(Groups::is_of_slide) {
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
        let (first, last) = (order[0], order[order.len() - 1]);
        // Positions are rounded when they are written, so equal positions differ slightly.
        let gaps = order.windows(2).map(|w| depth[w[1]] - depth[w[0]]).filter(|&s| s > PLACE_TOLERANCE * nominal);
        let gaps: Vec<f64> = gaps.collect();
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let slice = |step: f64, frame: usize| (depth[frame] - depth[first]) / step;
        let stray = |step: f64| {
            let slices = (0..depth.len()).map(|frame| slice(step, frame));
            slices.into_iter().find(|s| (s - s.round()).abs() > PLACE_TOLERANCE.max(1e-4 * s.round()))
        };
        // The stated distance, else the smallest distance between frames, else their thickness.
        let measured = [between, Some(least).filter(|s| s.is_finite()), thickness];
        let fitting = measured.iter().flatten().copied().find(|&step| stray(step).is_none());
        let Some(step) = fitting.or(gaps.is_empty().then_some(nominal)) else {
            let step = measured.iter().flatten().copied().next().unwrap_or(nominal);
            let value = format!("{:.2} slices of {step} mm from the first", stray(step).unwrap_or(0.0));
            let advice = "frames must lie on a regular stack; resample the segmentation, or choose segments whose frames do \
                          (input.labels)";
            return Err(fault("position of a frame", value, advice));
        };
        let place: Vec<usize> = (0..depth.len()).map(|frame| slice(step, frame).round() as usize).collect();
        let previous = place[last];
        let n_frames = previous.saturating_add(1);
        // Frames may be sheared against each other, for example with a tilted gantry.
        let along_stack =
            if n_frames > 1 { (positions[last] - positions[first]) / previous as f64 } else { normal * step };
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
        Ok(Stack { place: place.into_iter().map(Some).collect(), n_frames, affine })
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Binary,
    Fractional {
        /// Least value of a voxel in the segment.
        threshold: f64,
    },
    LabelMap,
}

/// The pixels of all frames.
struct Frames<'a> {
    kind: Kind,
    bits: u16,
    /// Pixels per frame.
    n_pixels: usize,
    frames: FrameData<'a>,
}

enum FrameData<'a> {
    Native(&'a [u8]),
    Rle(Vec<&'a [u8]>),
}

impl<'a> Frames<'a> {
    fn new(
        set: &DataSet<'a>,
        encoding: PixelEncoding,
        n_pixels: usize,
        n_frames: usize,
        fraction: f64,
    ) -> Result<Self, FormatError> {
        let bits = set.short(BITS_ALLOCATED).unwrap_or(0);
        let kind = match set.text(0x0062_0001).as_str() {
            "BINARY" => Kind::Binary,
            "FRACTIONAL" => {
                let largest = set.short(0x0062_000e).filter(|&v| v > 0).unwrap_or(255);
                Kind::Fractional { threshold: fraction * f64::from(largest) }
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
        if !valid || encoding == PixelEncoding::Rle && bits == 1 {
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

    /// Passes every pixel of a frame that belongs to a segment, with its value, to `take`.
    fn visit(
        &self,
        frame: usize,
        take: &mut dyn FnMut(usize, u32) -> Result<(), FormatError>,
    ) -> Result<(), FormatError> {
        let n = self.n_pixels;
        if let (FrameData::Native(bytes), 1) = (&self.frames, self.bits) {
            // The lowest bit comes first, and frames are not padded.
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
                Cow::Owned(rle_frame(fragments[frame], n, size).ok_or(damaged)?)
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
