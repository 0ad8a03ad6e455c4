//! Zip archives of DICOM instances, or of a single file: entries are found, inflated under hard caps, and chosen.
//!
//! Source: PKWARE, APPNOTE.TXT 6.3.10. The parser is hand-written because libraries reserve memory for as many entries
//! as an archive claims to have. Entries are stored or deflated; ZIP64 and encryption are refused by name.

use super::budget::Budget;
use super::dicom::is_dicom;
use super::{FormatError, ReadLimits, dicom_seg, gzip};
use flate2::{Crc, Decompress, FlushDecompress, Status};
use std::borrow::Cow;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Largest number of files in an archive.
const MAX_FILES: u64 = 20_000;
const END_BYTES: usize = 22;
const ENTRY_BYTES: usize = 46;
const LOCAL_BYTES: usize = 30;

/// Whether `bytes` begin like a zip archive.
pub(super) fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

/// Readable content of an archive.
pub(super) enum Content<'a> {
    /// Instances of DICOM segmentations, and the number of other files.
    Instances(Vec<Cow<'a, [u8]>>, usize),
    /// A single file, with its name.
    File(Cow<'a, [u8]>, String),
}

/// Chooses the segmentations of an archive, or its only file.
///
/// # Errors
/// `TooLarge` if the total exceeds [`ReadLimits::max_inflated_bytes`] or the budget; `Zip` if the archive is damaged;
/// `Unsupported` if it holds neither.
pub(super) fn content<'a>(bytes: &'a [u8], limits: &ReadLimits, budget: &Budget) -> Result<Content<'a>, FormatError> {
    let mut left = limits.max_inflated_bytes;
    let (mut instances, mut others) = (Vec::new(), Vec::new());
    let (mut n_others, mut n_dicom) = (0, 0);
    let mut document = None;
    for entry in entries(bytes)? {
        let entry = entry?;
        if !entry.is_file() {
            continue;
        }
        // Formats that are archives themselves are recognized by their required entries.
        document = document.or_else(|| packed_format(entry.name));
        let inflated = entry.inflated(bytes, left, limits.max_inflated_bytes, budget)?;
        left -= inflated.len();
        let whole = is_dicom(&inflated);
        n_dicom += usize::from(whole);
        if whole && dicom_seg::is_segmentation(&inflated, budget.left()) {
            budget.push(&mut instances, inflated)?;
        } else {
            n_others += 1;
            // One other file is enough to name the content, or to be read.
            if others.is_empty() {
                others.push((inflated, entry.name()));
            } else if let Cow::Owned(dropped) = inflated {
                budget.release(dropped.capacity());
            }
        }
    }
    if !instances.is_empty() {
        return Ok(Content::Instances(instances, n_others));
    }
    if let Some((what, advice)) = document {
        return Err(FormatError::Unsupported { what, advice });
    }
    match others.pop() {
        Some((file, name)) if n_others == 1 => Ok(Content::File(file, name)),
        Some(_) if n_dicom > 0 => Err(FormatError::Unsupported {
            what: "a zip archive of DICOM objects without a segmentation",
            advice: "add the segmentation of the structure (DICOM SEG); images alone do not say where it is",
        }),
        Some(_) => Err(FormatError::Unsupported {
            what: "a zip archive of several files",
            advice: "send one of the files, or an archive of DICOM segmentations",
        }),
        None => Err(FormatError::Unsupported { what: "a zip archive without files", advice: "send a file" }),
    }
}

/// The format of an archive with an entry of this name, and what to send instead.
fn packed_format(name: &[u8]) -> Option<(&'static str, &'static str)> {
    const IN_MILLIMETERS: &str =
        "export the surface as STL, PLY or OBJ in millimeters, whatever the unit of the model is";
    let name = String::from_utf8_lossy(name).to_ascii_lowercase();
    let ends = |ending: &str| name.ends_with(ending);
    Some(match name.as_str() {
        _ if ends(".model") && name.contains("3d/") => ("3MF", IN_MILLIMETERS),
        _ if ends(".usdc") || ends(".usda") => ("USD", IN_MILLIMETERS),
        _ if ends(".mrml") => {
            ("a scene of 3D Slicer (.mrb)", "save the segmentation as .seg.nrrd or the model as .vtp, and send that")
        }
        "word/document.xml" | "xl/workbook.xml" | "ppt/presentation.xml" => {
            ("an office document", "send a surface or a label volume")
        }
        _ if ends(".npy") => ("an archive of NumPy (.npz)", "save the labels as NIfTI, with their affine (nibabel)"),
        ".zattrs" | ".zgroup" => ("Zarr", "save the labels as NIfTI or NRRD"),
        _ => return None,
    })
}

/// The uncompressed bytes of an input. For an archive of segmentations: one instance, always the same.
///
/// # Errors
/// The errors of [`content`], and of gzip.
pub(super) fn dicom_or_plain<'a>(bytes: &'a [u8], limits: &ReadLimits) -> Result<Cow<'a, [u8]>, FormatError> {
    let budget = Budget::new(super::budget::for_file(bytes.len()));
    if !is_zip(bytes) {
        budget.grant(super::declared_voxels(bytes)?.min(limits.max_inflated_bytes));
        return gzip::inflate(bytes, limits.max_inflated_bytes, &budget);
    }
    match content(bytes, limits, &budget)? {
        Content::Instances(instances, _) => {
            // The order of files in an archive is arbitrary.
            let first = instances.into_iter().min_by(|a, b| a.cmp(b));
            first.ok_or(FormatError::Empty)
        }
        Content::File(file, _) => Ok(file),
    }
}

/// An uncompressed archive of files, in which a folder of DICOM instances is sent. Equal files give equal bytes.
///
/// # Errors
/// Errors of the archive, such as more than 4 GiB.
pub fn write_zip<B: AsRef<[u8]>>(files: &[(String, B)]) -> std::io::Result<Vec<u8>> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default());
    // Two headers per file; reserving them keeps the archive in place while it grows.
    let n_bytes = files.iter().map(|(name, bytes)| bytes.as_ref().len() + 2 * name.len() + 128).sum();
    let mut archive = ZipWriter::new(Cursor::new(Vec::with_capacity(n_bytes)));
    for (name, bytes) in files {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(bytes.as_ref())?;
    }
    Ok(archive.finish()?.into_inner())
}

fn damaged(what: &'static str) -> FormatError {
    FormatError::Zip { what }
}

fn u16_at(bytes: &[u8], at: usize) -> u16 {
    bytes.get(at..at + 2).map_or(0, |b| u16::from_le_bytes([b[0], b[1]]))
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    bytes.get(at..at + 4).map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
}

/// A file as described by the directory of the archive.
struct Entry<'a> {
    name: &'a [u8],
    flags: u16,
    method: u16,
    checksum: u32,
    packed: u32,
    size: u32,
    /// Offset of the entry's own header.
    offset: u32,
}

/// The entries of the directory, one after the other.
fn entries(bytes: &[u8]) -> Result<impl Iterator<Item = Result<Entry<'_>, FormatError>>, FormatError> {
    // A comment of up to 65,535 bytes may follow the end of the directory.
    let last = bytes.len().checked_sub(END_BYTES).ok_or_else(|| damaged("has no directory"))?;
    let first = last.saturating_sub(usize::from(u16::MAX));
    let end = (first..=last).rev().find(|&at| bytes[at..].starts_with(b"PK\x05\x06"));
    let end = end.ok_or_else(|| damaged("has no directory, as if it was cut off"))?;
    let (n_entries, offset) = (u16_at(bytes, end + 10), u32_at(bytes, end + 16));
    if n_entries == u16::MAX || offset == u32::MAX {
        let advice = "send fewer files in one archive";
        return Err(FormatError::Unsupported { what: "a zip archive of 65,535 files or 4 GiB (ZIP64)", advice });
    }
    if u64::from(n_entries) > MAX_FILES {
        return Err(FormatError::TooLarge { what: "files in the archive", found: n_entries.into(), limit: MAX_FILES });
    }
    let mut at = offset as usize;
    Ok((0..n_entries).map(move |_| {
        let head = bytes.get(at..).and_then(|rest| rest.get(..ENTRY_BYTES));
        let head =
            head.filter(|head| head.starts_with(b"PK\x01\x02")).ok_or_else(|| damaged("has a damaged directory"))?;
        let length = |k: usize| usize::from(u16_at(head, k));
        let name = bytes[at + ENTRY_BYTES..].get(..length(28)).ok_or_else(|| damaged("has a damaged directory"))?;
        at += ENTRY_BYTES + length(28) + length(30) + length(32);
        Ok(Entry {
            name,
            flags: u16_at(head, 8),
            method: u16_at(head, 10),
            checksum: u32_at(head, 16),
            packed: u32_at(head, 20),
            size: u32_at(head, 24),
            offset: u32_at(head, 42),
        })
    }))
}

impl Entry<'_> {
    /// The last part of the name.
    fn name(&self) -> String {
        String::from_utf8_lossy(self.name.rsplit(|&b| b == b'/').next().unwrap_or_default()).into_owned()
    }

    /// Whether the sender meant to send this file: not a folder, an index or an addition of an operating system.
    fn is_file(&self) -> bool {
        let name = self.name();
        let is_added = self.name.starts_with(b"__MACOSX/") || name.starts_with('.') || name == "Thumbs.db";
        !name.is_empty() && !is_added && name != "DICOMDIR" && self.size > 0
    }

    /// The bytes of the file: at most `left` of a total of `limit`.
    fn inflated<'a>(
        &self,
        archive: &'a [u8],
        left: usize,
        limit: usize,
        budget: &Budget,
    ) -> Result<Cow<'a, [u8]>, FormatError> {
        let advice = "pack the files again, with the usual compression and without a password";
        if self.flags & 1 != 0 {
            return Err(FormatError::Unsupported { what: "an encrypted zip archive", advice });
        }
        if [self.packed, self.size, self.offset].contains(&u32::MAX) {
            return Err(FormatError::Unsupported { what: "a file of 4 GiB in a zip archive (ZIP64)", advice });
        }
        let size = self.size as usize;
        if size > left {
            let found = (limit - left).saturating_add(size) as u64;
            return Err(FormatError::TooLarge { what: "bytes in the archive", found, limit: limit as u64 });
        }
        let local = archive.get(self.offset as usize..).filter(|rest| rest.starts_with(b"PK\x03\x04"));
        let local = local.ok_or_else(|| damaged("has a damaged header of a file"))?;
        let start = LOCAL_BYTES + usize::from(u16_at(local, 26)) + usize::from(u16_at(local, 28));
        let packed = local.get(start..).and_then(|rest| rest.get(..self.packed as usize));
        let packed = packed.ok_or_else(|| damaged("ends within a file"))?;
        let inflated = match self.method {
            0 => Cow::Borrowed(packed),
            8 => {
                let head = deflated(packed, super::HEAD_BYTES, true, &Budget::new(4 * super::HEAD_BYTES))?;
                let head = head.ok_or_else(|| damaged("has damaged compressed data"))?;
                budget.grant(super::declared_voxels(&head)?.min(size));
                drop(head);
                let plain = deflated(packed, size, false, budget)?;
                Cow::Owned(plain.ok_or_else(|| damaged("has damaged compressed data"))?)
            }
            _ => return Err(FormatError::Unsupported { what: "this compression of a zip archive", advice }),
        };
        let mut crc = Crc::new();
        crc.update(&inflated);
        if inflated.len() != size || crc.sum() != self.checksum {
            return Err(damaged("has a file whose checksum does not match"));
        }
        Ok(inflated)
    }
}

/// A deflate stream of `size` bytes, or at least `size` bytes if only its head is read; `Ok(None)` if it is damaged or
/// longer.
///
/// # Errors
/// `TooLarge` beyond the budget.
fn deflated(mut packed: &[u8], size: usize, is_head: bool, budget: &Budget) -> Result<Option<Vec<u8>>, FormatError> {
    let mut stream = Decompress::new(false);
    let mut buffer = vec![0u8; 1 << 16];
    let mut inflated = budget.for_inflated(packed.len(), size)?;
    loop {
        let (read, written) = (stream.total_in(), stream.total_out());
        let Ok(status) = stream.decompress(packed, &mut buffer, FlushDecompress::None) else { return Ok(None) };
        packed = &packed[(stream.total_in() - read) as usize..];
        let piece = &buffer[..(stream.total_out() - written) as usize];
        if is_head && inflated.len() + piece.len() > size {
            return Ok(Some(inflated));
        }
        budget.extend(&mut inflated, piece)?;
        if inflated.len() > size || piece.is_empty() && stream.total_in() == read && status != Status::StreamEnd {
            return Ok(None);
        }
        if status == Status::StreamEnd {
            return Ok(Some(inflated));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An archive whose only file is deflated.
    fn deflated_file(name: &str, bytes: &[u8]) -> Vec<u8> {
        use flate2::{Compression, write::DeflateEncoder};
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        let packed = encoder.finish().unwrap();
        let mut crc = Crc::new();
        crc.update(bytes);
        let mut common = vec![20, 0, 0, 0, 8, 0, 0, 0, 0, 0];
        for number in [crc.sum(), packed.len() as u32, bytes.len() as u32] {
            common.extend(number.to_le_bytes());
        }
        common.extend((name.len() as u16).to_le_bytes());
        common.extend([0, 0]);
        let local = [b"PK\x03\x04", common.as_slice(), name.as_bytes(), &packed].concat();
        let entry = [b"PK\x01\x02\x14\0", common.as_slice(), &[0; 14], name.as_bytes()].concat();
        let mut end = b"PK\x05\x06\0\0\0\0\x01\0\x01\0".to_vec();
        end.extend((entry.len() as u32).to_le_bytes());
        end.extend((local.len() as u32).to_le_bytes());
        [local, entry, end, vec![0, 0]].concat()
    }

    fn only_file(archive: &[u8], limit: usize) -> Result<(Vec<u8>, String), FormatError> {
        let limits = ReadLimits { max_inflated_bytes: limit, ..ReadLimits::default() };
        match content(archive, &limits, &Budget::new(1 << 30))? {
            Content::File(file, name) => Ok((file.into_owned(), name)),
            Content::Instances(..) => panic!("no instances"),
        }
    }

    #[test]
    fn the_only_file_is_found_whatever_a_system_has_added() {
        let files = ["study/", "study/.DS_Store", "__MACOSX/a.ply", "DICOMDIR", "study/a.ply"];
        let files = files.map(|name| (name.to_owned(), if name.ends_with('/') { vec![] } else { b"ply".to_vec() }));
        let stored = write_zip(&files).unwrap();
        assert_eq!(only_file(&stored, 3).unwrap(), (b"ply".to_vec(), "a.ply".to_owned()));
        let text = b"a text that is repeated ".repeat(9000);
        let archive = deflated_file("x/b.stl", &text);
        assert!(archive.len() < 2000 && is_zip(&archive));
        assert_eq!(only_file(&archive, text.len()).unwrap(), (text.clone(), "b.stl".to_owned()));
        let error = only_file(&archive, text.len() - 1).unwrap_err();
        assert!(matches!(error, FormatError::TooLarge { what: "bytes in the archive", .. }), "{error}");
    }

    #[test]
    fn a_stream_that_is_longer_than_it_claims_and_damage_are_refused() {
        let text = vec![7; 100_000];
        let archive = deflated_file("a", &text);
        // The size in the directory, 24 bytes into the entry.
        let entry = archive.windows(4).position(|w| w == b"PK\x01\x02").unwrap();
        let mut lying = archive.clone();
        lying[entry + 24..entry + 28].copy_from_slice(&1000u32.to_le_bytes());
        assert_eq!(only_file(&lying, 1 << 30), Err(damaged("has damaged compressed data")));
        let mut flipped = archive.clone();
        flipped[entry + 16] ^= 1;
        assert_eq!(only_file(&flipped, 1 << 30), Err(damaged("has a file whose checksum does not match")));
        let mut locked = archive.clone();
        locked[entry + 8] |= 1;
        assert!(matches!(only_file(&locked, 1 << 30), Err(FormatError::Unsupported { .. })));
        for length in 0..archive.len() {
            assert!(only_file(&archive[..length], 1 << 30).is_err(), "{length}");
        }
        let two = write_zip(&[("a.ply".to_owned(), b"ply".to_vec()), ("b.ply".to_owned(), b"ply".to_vec())]).unwrap();
        let error = only_file(&two, 100).unwrap_err();
        assert!(error.to_string().starts_with("a zip archive of several files is not supported"), "{error}");
    }
}
