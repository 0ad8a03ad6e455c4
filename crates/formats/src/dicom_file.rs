//! Writing of DICOM files: data elements, identifiers, and the attributes that an object copies from the study of an
//! input.
//!
//! Source: DICOM PS3.5, sections 7 and 9, and PS3.10, section 7. Hand-written, in explicit little endian as read by
//! [`super::dicom`]: a library would bring a dictionary of all attributes for less than a hundred of them.

use super::dicom::DataSet;

const EXPLICIT_LITTLE_ENDIAN: &str = "1.2.840.10008.1.2.1";
pub(super) const STUDY: u32 = 0x0020_000d;
pub(super) const SERIES: u32 = 0x0020_000e;
pub(super) const FRAME_OF_REFERENCE: u32 = 0x0020_0052;
const CHARACTER_SET: u32 = 0x0008_0005;

/// Copied attributes of patient and study: tag, representation, and whether the attribute is required; required ones
/// are written empty if they are missing.
const COPIED: [(u32, &[u8; 2], bool); 11] = [
    (CHARACTER_SET, b"CS", false),
    (0x0008_0020, b"DA", true),
    (0x0008_0030, b"TM", true),
    (0x0008_0050, b"SH", true),
    (0x0008_0090, b"PN", true),
    (0x0010_0010, b"PN", true),
    (0x0010_0020, b"LO", true),
    (0x0010_0030, b"DA", true),
    (0x0010_0040, b"CS", true),
    (STUDY, b"UI", true),
    (0x0020_0010, b"SH", true),
];

/// The study of an object.
pub(super) enum Study<'a> {
    /// The study of an input, with its patient.
    Of(&'a DataSet<'a>),
    /// A study known only by its UID.
    Named(&'a str),
}

impl Study<'_> {
    pub(super) fn uid(&self) -> String {
        match self {
            Study::Of(set) => set.text(STUDY),
            Study::Named(uid) => (*uid).to_owned(),
        }
    }
}

/// Adds an object to a study.
pub(super) fn add_study(body: &mut Elements, study: &Study<'_>) {
    for (tag, representation, required) in COPIED {
        let value = match study {
            Study::Of(set) => set.bytes(tag),
            Study::Named(uid) if tag == STUDY => uid.as_bytes(),
            Study::Named(_) => &[],
        };
        if required || !value.is_empty() {
            body.add(tag, representation, value);
        }
    }
}

/// The frame of reference of an input. If it states none, as for a file of another format: the given one, or a name
/// derived from its bytes.
pub(super) fn frame_of_reference(set: Option<&DataSet<'_>>, bytes: &[u8], given: Option<&str>) -> String {
    let stated = set.map(|set| set.text(FRAME_OF_REFERENCE)).filter(|uid| !uid.is_empty());
    let named = || given.map_or_else(|| uid_of(&[b"frame of reference", bytes]), str::to_owned);
    stated.unwrap_or_else(named)
}

/// A UID from a hash (PS3.5, section B.2): `2.25.` and a number of 128 bits, as in a UUID of version 8.
pub(super) fn uid_of(parts: &[&[u8]]) -> String {
    let mut hasher = blake3::Hasher::new();
    for part in parts {
        hasher.update(&(part.len() as u64).to_le_bytes());
        hasher.update(part);
    }
    let mut bytes = [0; 16];
    bytes.copy_from_slice(&hasher.finalize().as_bytes()[..16]);
    bytes[6] = bytes[6] & 0x0f | 0x80;
    bytes[8] = bytes[8] & 0x3f | 0x80;
    format!("2.25.{}", u128::from_be_bytes(bytes))
}

/// A number as a decimal string of at most 16 characters.
pub(super) fn decimal(value: f64) -> String {
    let value = value + 0.0;
    (0..=14)
        .rev()
        .map(|digits| format!("{value:.digits$}"))
        .find(|text| text.len() <= 16)
        .unwrap_or_else(|| format!("{value:.8e}"))
}

/// Data elements; [`Elements::bytes`] sorts them by tag.
#[derive(Default)]
pub(super) struct Elements {
    list: Vec<(u32, [u8; 2], Vec<u8>)>,
}

impl Elements {
    pub(super) fn add(&mut self, tag: u32, representation: &[u8; 2], value: &[u8]) {
        let mut value = value.to_vec();
        if value.len() % 2 == 1 {
            value.push(if representation == b"UI" { 0 } else { b' ' });
        }
        self.list.push((tag, *representation, value));
    }

    pub(super) fn text(&mut self, tag: u32, representation: &[u8; 2], value: &str) {
        self.add(tag, representation, value.as_bytes());
    }

    pub(super) fn items(&mut self, tag: u32, items: &[Elements]) {
        let mut value = Vec::new();
        for item in items {
            let bytes = item.bytes();
            value.extend([0xfe, 0xff, 0x00, 0xe0]);
            value.extend((bytes.len() as u32).to_le_bytes());
            value.extend(bytes);
        }
        self.add(tag, b"SQ", &value);
    }

    fn bytes(&self) -> Vec<u8> {
        let mut order: Vec<&(u32, [u8; 2], Vec<u8>)> = self.list.iter().collect();
        order.sort_by_key(|(tag, _, _)| *tag);
        let mut bytes = Vec::new();
        for (tag, representation, value) in order {
            bytes.extend(((tag >> 16) as u16).to_le_bytes());
            bytes.extend((*tag as u16).to_le_bytes());
            bytes.extend(representation);
            if matches!(representation, b"SQ" | b"OB" | b"UN") {
                bytes.extend([0, 0]);
                bytes.extend((value.len() as u32).to_le_bytes());
            } else {
                // Values with short lengths are identifiers and names, far below the limit.
                let length = value.len().min(usize::from(u16::MAX) - 1);
                bytes.extend((length as u16).to_le_bytes());
                bytes.extend(&value[..length]);
                continue;
            }
            bytes.extend(value);
        }
        bytes
    }
}

/// Preamble, meta information and data set.
pub(super) fn file(class: &str, instance: &str, body: &Elements) -> Vec<u8> {
    let mut meta = Elements::default();
    meta.add(0x0002_0001, b"OB", &[0, 1]);
    meta.text(0x0002_0002, b"UI", class);
    meta.text(0x0002_0003, b"UI", instance);
    meta.text(0x0002_0010, b"UI", EXPLICIT_LITTLE_ENDIAN);
    meta.text(0x0002_0012, b"UI", &uid_of(&[b"homolog"]));
    meta.text(0x0002_0013, b"SH", "homolog");
    let meta = meta.bytes();
    let mut group = Elements::default();
    group.add(0x0002_0000, b"UL", &(meta.len() as u32).to_le_bytes());
    let mut file = vec![0; 128];
    file.extend(b"DICM");
    file.extend(group.bytes());
    file.extend(meta);
    file.extend(body.bytes());
    file
}
