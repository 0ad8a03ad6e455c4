//! DICOM data sets: files of part 10 in the explicit, implicit and deflated little-endian encodings, also without their
//! preamble, and bare data sets as stored by old programs, whose first elements tell the encoding.
//!
//! Source: DICOM PS3.5, sections 7 and A, and PS3.10, section 7. The parser is hand-written because the length of a
//! value must be checked against the available bytes before memory is allocated. Values stay slices of the file; names
//! of attributes are not known.

use super::budget::Budget;
use super::xml::read_charged;
use super::{FormatError, ReadLimits};

/// Largest nesting depth of sequences.
const MAX_DEPTH: usize = 16;

const UNDEFINED: u32 = u32::MAX;
const ITEM: u32 = 0xfffe_e000;
const ITEM_END: u32 = 0xfffe_e00d;
const SEQUENCE_END: u32 = 0xfffe_e0dd;

pub(super) const PIXEL_DATA: u32 = 0x7fe0_0010;
pub(super) const SHARED_GROUPS: u32 = 0x5200_9229;
pub(super) const FRAME_GROUPS: u32 = 0x5200_9230;
pub(super) const PIXEL_MEASURES: u32 = 0x0028_9110;
pub(super) const PLANE_ORIENTATION: u32 = 0x0020_9116;
pub(super) const PLANE_POSITION: u32 = 0x0020_9113;
pub(super) const SLIDE_POSITION: u32 = 0x0048_021a;
pub(super) const SEGMENT_IDENTIFICATION: u32 = 0x0062_000a;
pub(super) const SEGMENTS: u32 = 0x0062_0002;
/// Sequences that are read, for files that do not state which values are sequences.
const SEQUENCES: [u32; 8] = [
    SHARED_GROUPS,
    FRAME_GROUPS,
    PIXEL_MEASURES,
    PLANE_ORIENTATION,
    PLANE_POSITION,
    SLIDE_POSITION,
    SEGMENT_IDENTIFICATION,
    SEGMENTS,
];

pub(super) const SOP_CLASS: u32 = 0x0008_0016;
pub(super) const SOP_INSTANCE: u32 = 0x0008_0018;
const TRANSFER_SYNTAX: u32 = 0x0002_0010;
pub(super) const N_FRAMES: u32 = 0x0028_0008;
pub(super) const ROWS: u32 = 0x0028_0010;
pub(super) const COLUMNS: u32 = 0x0028_0011;
pub(super) const BITS_ALLOCATED: u32 = 0x0028_0100;

/// Whether `bytes` begin like a DICOM object: a file of part 10, with or without its preamble, or a bare data set.
pub(super) fn is_dicom(bytes: &[u8]) -> bool {
    bytes.get(128..132) == Some(MAGIC) || bytes.starts_with(MAGIC) || begins_with_elements(bytes)
}

const MAGIC: &[u8] = b"DICM";
/// Number of elements inspected if nothing else identifies a file as DICOM.
const MIN_ELEMENTS: usize = 4;
/// Memory for inspecting the first elements.
const LOOK_BYTES: usize = 1 << 20;
/// Bytes of a data set that are searched for the size of its pixel data, which is stated before them.
pub(super) const HEAD_BYTES: usize = 1 << 20;

/// Whether the first elements belong to a file without preamble: groups 2 and 8, ascending, with plausible lengths.
fn begins_with_elements(bytes: &[u8]) -> bool {
    // A sender of four elements with millions of items is not asked for more.
    let budget = Budget::new(LOOK_BYTES);
    let mut reader = Reader { bytes, at: 0, explicit: is_explicit(bytes), budget: &budget };
    let mut last = 0;
    for k in 0..MIN_ELEMENTS {
        let Some(tag) = reader.peek_tag() else { return false };
        let group = tag >> 16;
        let begins = k > 0 || group == 2 || group == 8;
        if !begins || ![2, 8, 0x10, 0x18, 0x20, 0x28, 0x62].contains(&group) || tag <= last && k > 0 {
            return false;
        }
        // Elements of the meta information group are always explicit.
        reader.explicit = group == 2 || is_explicit(&reader.bytes[reader.at..]);
        if reader.element(0).is_err() {
            return false;
        }
        last = tag;
    }
    true
}

/// Whether an element states its value representation: two capital letters after its tag.
fn is_explicit(bytes: &[u8]) -> bool {
    bytes.get(4..6).is_some_and(|letters| letters.iter().all(u8::is_ascii_uppercase))
}

/// Storage of pixel data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PixelEncoding {
    /// Uncompressed.
    Native,
    /// Run lengths, with a fragment for each frame.
    Rle,
}

/// Size of the pixel data of a segmentation, in memory or in the file, as stated by the first elements of a data set; 0
/// if they do not state it.
fn declared_by(bytes: &[u8], explicit: bool) -> usize {
    let budget = Budget::new(LOOK_BYTES);
    let mut reader = Reader { bytes, at: 0, explicit, budget: &budget };
    let mut set = DataSet::default();
    let wanted = [N_FRAMES, ROWS, COLUMNS, BITS_ALLOCATED];
    while reader.peek_tag().is_some_and(|tag| tag <= BITS_ALLOCATED) {
        let Ok(element) = reader.element(0) else { break };
        if wanted.contains(&element.tag) && budget.push(&mut set.elements, element).is_err() {
            break;
        }
        budget.release(LOOK_BYTES);
    }
    set.elements.sort_by_key(|element| element.tag);
    let [rows, columns, bits] = [ROWS, COLUMNS, BITS_ALLOCATED].map(|tag| set.short(tag).map_or(0, u64::from));
    let n_frames: u64 = set.text(N_FRAMES).parse().unwrap_or(1);
    let n_bits = (rows * columns).saturating_mul(n_frames).saturating_mul(bits);
    usize::try_from(n_bits.div_ceil(8)).unwrap_or(usize::MAX)
}

/// Size of the pixel data as stated by the first bytes of a file; 0 if they do not state it, or if the file itself is
/// deflated.
pub(super) fn declared_pixels(head: &[u8]) -> usize {
    let budget = Budget::new(LOOK_BYTES);
    match after_meta(head, &budget) {
        Ok((_, DEFLATED)) | Err(_) => 0,
        Ok((rest, syntax)) => declared_by(rest, syntax != IMPLICIT && is_explicit(rest)),
    }
}

const IMPLICIT: &str = "1.2.840.10008.1.2";
const DEFLATED: &str = "1.2.840.10008.1.2.1.99";

/// The bytes after the meta information, and the transfer syntax, which is empty if it is not stated.
fn after_meta<'a>(bytes: &'a [u8], budget: &Budget) -> Result<(&'a [u8], &'a str), FormatError> {
    let start = match bytes.get(128..132) == Some(MAGIC) {
        true => &bytes[132..],
        false => bytes.strip_prefix(MAGIC).unwrap_or(bytes),
    };
    let mut meta = Reader { bytes: start, at: 0, explicit: true, budget };
    let mut syntax = "";
    // The meta information group, always explicit and little-endian.
    while meta.peek_tag().is_some_and(|tag| tag >> 16 == 2) {
        let element = meta.element(0)?;
        if element.tag == TRANSFER_SYNTAX {
            syntax = element.text();
        }
    }
    Ok((&start[meta.at..], syntax))
}

/// Reads a file; a deflated data set is inflated into `inflated` first. Inflated bytes, and every element, item and
/// fragment, are charged to the budget; pixel data are granted by the size that the data set states for them.
pub(super) fn read_file<'a>(
    bytes: &'a [u8],
    inflated: &'a mut Vec<u8>,
    limits: &ReadLimits,
    budget: &Budget,
) -> Result<(DataSet<'a>, PixelEncoding), FormatError> {
    let (rest, syntax) = after_meta(bytes, budget)?;
    let unsupported = |what, advice| Err(FormatError::Unsupported { what, advice });
    let (bytes, explicit, pixels) = match syntax {
        // Transfer syntax not stated.
        "" => (rest, is_explicit(rest), PixelEncoding::Native),
        IMPLICIT => (rest, false, PixelEncoding::Native),
        "1.2.840.10008.1.2.1" => (rest, true, PixelEncoding::Native),
        "1.2.840.10008.1.2.5" => (rest, true, PixelEncoding::Rle),
        DEFLATED => {
            use std::io::Read;
            let stream = || flate2::read::DeflateDecoder::new(rest);
            let mut head = Vec::with_capacity(HEAD_BYTES);
            // A damaged stream is reported below.
            let _ = stream().take(HEAD_BYTES as u64).read_to_end(&mut head);
            let declared = declared_by(&head, true).min(limits.max_inflated_bytes);
            drop(head);
            budget.grant(declared);
            let room = budget.for_inflated(rest.len(), declared)?;
            let limit = limits.max_inflated_bytes;
            let plain = read_charged(stream().take(limit as u64 + 1), room, budget)?;
            *inflated = plain.ok_or_else(damaged)?;
            if inflated.len() > limit {
                let found = inflated.len() as u64;
                return Err(FormatError::TooLarge { what: "bytes", found, limit: limit as u64 });
            }
            (inflated.as_slice(), true, PixelEncoding::Native)
        }
        "1.2.840.10008.1.2.2" => {
            let advice = "it is retired; save the object as explicit VR little endian (dcmconv +te)";
            return unsupported("the big-endian transfer syntax of DICOM", advice);
        }
        _ => {
            let advice = "save the object as explicit VR little endian, not compressed (dcmdjpeg or gdcmconv --raw)";
            return unsupported("this DICOM transfer syntax", advice);
        }
    };
    let mut reader = Reader { bytes, at: 0, explicit, budget };
    let mut set = DataSet::default();
    let mut has_pixels = false;
    while reader.at < bytes.len() {
        if has_pixels && reader.peek_tag().is_none_or(|tag| tag <= PIXEL_DATA) {
            let rest = &bytes[reader.at..];
            set.n_trailing = if rest.iter().all(|&byte| byte == 0) { 0 } else { rest.len() };
            break;
        }
        let element = reader.element(0)?;
        has_pixels |= element.tag == PIXEL_DATA;
        budget.push(&mut set.elements, element)?;
    }
    set.sort(budget)?;
    Ok((set, pixels))
}

fn damaged() -> FormatError {
    FormatError::Payload { format: "DICOM", line: None }
}

/// Data elements in order.
#[derive(Debug, Default)]
pub(super) struct DataSet<'a> {
    elements: Vec<DataElement<'a>>,
    /// Bytes after the pixel data that are neither an element, since tags ascend, nor zeros.
    pub(super) n_trailing: usize,
}

#[derive(Debug)]
pub(super) struct DataElement<'a> {
    tag: u32,
    value: Value<'a>,
}

#[derive(Debug)]
enum Value<'a> {
    Bytes(&'a [u8]),
    Items(Vec<DataSet<'a>>),
    /// Encapsulated pixel data; the first is the table of offsets.
    Fragments(Vec<&'a [u8]>),
}

impl<'a> DataElement<'a> {
    fn bytes(&self) -> &'a [u8] {
        match self.value {
            Value::Bytes(bytes) => bytes,
            _ => &[],
        }
    }

    /// The value without its padding; empty if it is not text.
    fn text(&self) -> &'a str {
        std::str::from_utf8(self.bytes()).unwrap_or_default().trim_matches([' ', '\0'])
    }
}

impl<'a> DataSet<'a> {
    /// Sorts the elements by tag, the order in standard files; elements with equal tags keep their order. Searching
    /// stays fast even in a set of millions.
    fn sort(&mut self, budget: &Budget) -> Result<(), FormatError> {
        if !self.elements.is_sorted_by_key(|element| element.tag) {
            let n_bytes = size_of_val(self.elements.as_slice());
            budget.charge(n_bytes)?;
            self.elements.sort_by_key(|element| element.tag);
            budget.release(n_bytes);
        }
        Ok(())
    }

    fn get(&self, tag: u32) -> Option<&DataElement<'a>> {
        let first = self.elements.partition_point(|element| element.tag < tag);
        self.elements.get(first).filter(|element| element.tag == tag)
    }

    pub(super) fn bytes(&self, tag: u32) -> &'a [u8] {
        self.get(tag).map_or(&[], DataElement::bytes)
    }

    /// Text in UTF-8 or ASCII; for other character sets, its ASCII characters.
    pub(super) fn text(&self, tag: u32) -> String {
        String::from_utf8_lossy(self.bytes(tag)).trim_matches([' ', '\0']).to_owned()
    }

    /// A number with value representation US.
    pub(super) fn short(&self, tag: u32) -> Option<u16> {
        self.bytes(tag).first_chunk::<2>().map(|b| u16::from_le_bytes(*b))
    }

    /// Numbers in text, separated by backslashes; empty if one is damaged.
    pub(super) fn numbers(&self, tag: u32) -> Vec<f64> {
        let text = self.text(tag);
        let numbers: Result<Vec<f64>, _> = text.split('\\').map(|w| w.trim().parse()).collect();
        numbers.unwrap_or_default().into_iter().filter(|v: &f64| v.is_finite()).collect()
    }

    pub(super) fn items(&self, tag: u32) -> &[DataSet<'a>] {
        match self.get(tag).map(|element| &element.value) {
            Some(Value::Items(items)) => items,
            _ => &[],
        }
    }

    /// The first item of a sequence.
    pub(super) fn item(&self, tag: u32) -> Option<&DataSet<'a>> {
        self.items(tag).first()
    }

    /// Fragments of encapsulated pixel data, without the table of offsets.
    pub(super) fn fragments(&self, tag: u32) -> &[&'a [u8]] {
        match self.get(tag).map(|element| &element.value) {
            Some(Value::Fragments(fragments)) => fragments.get(1..).unwrap_or_default(),
            _ => &[],
        }
    }
}

struct Reader<'a, 'b> {
    bytes: &'a [u8],
    at: usize,
    explicit: bool,
    budget: &'b Budget,
}

impl<'a> Reader<'a, '_> {
    fn take(&mut self, n: usize) -> Result<&'a [u8], FormatError> {
        let taken = self.bytes.get(self.at..).and_then(|rest| rest.get(..n));
        let taken = taken.ok_or_else(|| FormatError::Truncated {
            part: "a DICOM data element",
            needed: n as u64,
            available: self.bytes.len().saturating_sub(self.at) as u64,
        })?;
        self.at += n;
        Ok(taken)
    }

    fn peek_tag(&self) -> Option<u32> {
        let b = self.bytes.get(self.at..)?.first_chunk::<4>()?;
        Some(u32::from(u16::from_le_bytes([b[0], b[1]])) << 16 | u32::from(u16::from_le_bytes([b[2], b[3]])))
    }

    fn tag(&mut self) -> Result<u32, FormatError> {
        let tag = self.peek_tag();
        self.take(4)?;
        tag.ok_or_else(damaged)
    }

    fn u32(&mut self) -> Result<u32, FormatError> {
        self.take(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
    }

    /// Elements up to `end`, or to the end of an item of undefined length.
    fn data_set(&mut self, end: usize, depth: usize) -> Result<DataSet<'a>, FormatError> {
        let mut set = DataSet::default();
        while self.at < end {
            if self.peek_tag() == Some(ITEM_END) {
                self.take(8)?;
                break;
            }
            let element = self.element(depth)?;
            self.budget.push(&mut set.elements, element)?;
        }
        set.sort(self.budget)?;
        Ok(set)
    }

    fn element(&mut self, depth: usize) -> Result<DataElement<'a>, FormatError> {
        const LONG: [&[u8]; 12] = [b"OB", b"OD", b"OF", b"OL", b"OV", b"OW", b"SQ", b"SV", b"UC", b"UN", b"UR", b"UT"];
        let tag = self.tag()?;
        let (representation, length) = if self.explicit {
            let representation = self.take(2)?;
            let is_long = LONG.contains(&representation) || representation == b"UV";
            if is_long {
                self.take(2)?;
                (representation, self.u32()?)
            } else {
                let b = self.take(2)?;
                (representation, u32::from(u16::from_le_bytes([b[0], b[1]])))
            }
        } else {
            // A dictionary would distinguish sequences from other values; the relevant ones are listed below.
            (b"??".as_slice(), self.u32()?)
        };
        let is_pixels = tag == PIXEL_DATA;
        let implicit_sequence = !self.explicit && SEQUENCES.contains(&tag);
        if representation == b"SQ" || implicit_sequence || length == UNDEFINED && !is_pixels {
            let explicit = self.explicit;
            // A sequence of unknown representation is encoded without representations.
            self.explicit &= representation != b"UN";
            let items = self.items(length, depth);
            self.explicit = explicit;
            return Ok(DataElement { tag, value: Value::Items(items?) });
        }
        let value = if length == UNDEFINED {
            Value::Fragments(self.fragments()?)
        } else {
            Value::Bytes(self.take(length as usize)?)
        };
        Ok(DataElement { tag, value })
    }

    fn items(&mut self, length: u32, depth: usize) -> Result<Vec<DataSet<'a>>, FormatError> {
        if depth >= MAX_DEPTH {
            return Err(damaged());
        }
        let end = self.end_of(length)?;
        let mut items = Vec::new();
        while self.at < end {
            let tag = self.tag()?;
            let length = self.u32()?;
            match tag {
                ITEM => {
                    let end = self.end_of(length)?;
                    let item = self.data_set(end, depth + 1)?;
                    self.budget.push(&mut items, item)?;
                }
                SEQUENCE_END => break,
                _ => return Err(damaged()),
            }
        }
        Ok(items)
    }

    /// The latest end of a value of this length.
    fn end_of(&self, length: u32) -> Result<usize, FormatError> {
        let available = (self.bytes.len() - self.at) as u64;
        match length {
            UNDEFINED => Ok(self.bytes.len()),
            n if u64::from(n) > available => {
                Err(FormatError::Truncated { part: "a DICOM sequence", needed: n.into(), available })
            }
            n => Ok(self.at + n as usize),
        }
    }

    fn fragments(&mut self) -> Result<Vec<&'a [u8]>, FormatError> {
        let mut fragments = Vec::new();
        loop {
            let tag = self.tag()?;
            let length = self.u32()?;
            match tag {
                ITEM => {
                    let fragment = self.take(length as usize)?;
                    self.budget.push(&mut fragments, fragment)?;
                }
                SEQUENCE_END => return Ok(fragments),
                _ => return Err(damaged()),
            }
        }
    }
}

/// A frame of `n` samples of `size` bytes, little-endian, from run lengths (PS3.5, annex G), with a segment for each
/// byte of the samples, the highest first. `None` if they are damaged.
pub(super) fn rle_frame(fragment: &[u8], n: usize, size: usize) -> Option<Vec<u8>> {
    let word = |at: usize| fragment.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    if word(0)? != size {
        return None;
    }
    let planes: Option<Vec<Vec<u8>>> = (0..size).map(|k| rle_segment(fragment.get(word(4 + 4 * k)?..)?, n)).collect();
    let planes = planes?;
    Some((0..n * size).map(|at| planes[size - 1 - at % size][at / size]).collect())
}

fn rle_segment(mut rest: &[u8], n_bytes: usize) -> Option<Vec<u8>> {
    // A byte is repeated at most 128 times.
    let mut plain = Vec::with_capacity(n_bytes.saturating_add(128).min(rest.len().saturating_mul(64)));
    while plain.len() < n_bytes {
        let (&control, after) = rest.split_first()?;
        let control = control as i8;
        if control >= 0 {
            let (literal, after) = after.split_at_checked(control as usize + 1)?;
            plain.extend_from_slice(literal);
            rest = after;
        } else if control != i8::MIN {
            let (&byte, after) = after.split_first()?;
            plain.extend(std::iter::repeat_n(byte, 1 + usize::from(control.unsigned_abs())));
            rest = after;
        } else {
            rest = after;
        }
    }
    plain.truncate(n_bytes);
    Some(plain)
}
