//! Decompresses gzip under a hard cap and verifies every checksum.
//!
//! Source: RFC 1952. A file is a sequence of members (one from `gzip`, many from `bgzip` or `cat a.gz b.gz`), each a
//! header, a deflate stream and a trailer with the CRC-32 and the length of the uncompressed data. Only the trailer
//! distinguishes a complete file from a damaged or truncated one, so [`inflate`] and [`inflate_prefix`] always read to
//! the last trailer.
//!
//! Zero bytes after the last member are padding, as for `gzip` and Python. Any other bytes there are refused: they are
//! either a member with a damaged header, or not part of the compressed data.

use super::budget::Budget;
use super::element::Rest;
use super::{FormatError, GzipFault, Plain};
use flate2::{Crc, Decompress, FlushDecompress, Status};
use std::borrow::Cow;
use std::ops::ControlFlow;

const MAGIC: [u8; 2] = [0x1f, 0x8b];
/// Length of a member's header without its optional fields.
const HEADER_BYTES: usize = 10;
const TRAILER_BYTES: usize = 8;

/// Whether `bytes` begin like a gzip stream.
pub(super) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC)
}

/// Decompresses `bytes` if they are a gzip stream; returns other bytes unchanged.
///
/// # Errors
/// `TooLarge` beyond `limit` bytes (detected after inflating little more) or beyond the budget, `Gzip` if the stream is
/// damaged.
pub(super) fn inflate<'a>(bytes: &'a [u8], limit: usize, budget: &Budget) -> Result<Plain<'a>, FormatError> {
    if !is_gzip(bytes) {
        let found = bytes.len();
        return if found > limit { Err(too_large(found, limit)) } else { Ok(Cow::Borrowed(bytes)) };
    }
    // The last bytes state the length; they only affect how often memory is moved.
    let stated = bytes.last_chunk::<4>().map_or(0, |b| u32::from_le_bytes(*b) as usize);
    let mut plain = budget.for_inflated(bytes.len(), stated.min(limit))?;
    let end = inflate_members(bytes, |piece| {
        if plain.len() + piece.len() > limit {
            return Err(too_large(plain.len() + piece.len(), limit));
        }
        budget.extend(&mut plain, piece)?;
        Ok(ControlFlow::Continue(()))
    })?;
    debug_assert!(end.is_continue(), "nothing breaks");
    Ok(Cow::Owned(plain))
}

/// Decompresses a gzip stream inside a file, of which `expected` bytes are used; also returns whether nonzero bytes
/// follow it.
///
/// # Errors
/// `TooLarge` beyond `limit` bytes or beyond the budget, `Gzip` if the stream is damaged.
pub(super) fn inflate_embedded(
    bytes: &[u8],
    limit: usize,
    expected: usize,
    budget: &Budget,
) -> Result<(Vec<u8>, bool), FormatError> {
    let mut plain = budget.for_inflated(bytes.len(), expected)?;
    let end = inflate_members(bytes, |piece| {
        if plain.len() + piece.len() > limit {
            return Err(too_large(plain.len() + piece.len(), limit));
        }
        budget.extend(&mut plain, piece)?;
        Ok(ControlFlow::Continue(()))
    });
    match end {
        Ok(_) => Ok((plain, false)),
        Err(FormatError::Gzip { fault: GzipFault::TrailingData, .. }) => Ok((plain, true)),
        Err(error) => Err(error),
    }
}

/// The first `n` bytes after decompression, or as many as there are, and a summary of the rest. The rest of a gzip
/// stream is inflated too, up to `limit` bytes in all, and dropped: only its trailer confirms the first bytes.
///
/// # Errors
/// `TooLarge` if a gzip stream inflates to more than `limit` bytes, `Gzip` if it is damaged.
pub(super) fn inflate_prefix<'a>(
    bytes: &'a [u8],
    n: usize,
    limit: usize,
    budget: &Budget,
) -> Result<(Plain<'a>, Rest), FormatError> {
    if !is_gzip(bytes) {
        let (first, rest) = bytes.split_at(n.min(bytes.len()));
        return Ok((Cow::Borrowed(first), Rest::of(rest)));
    }
    let (mut kept, mut found, mut is_zero) = (budget.for_inflated(bytes.len(), n)?, 0usize, true);
    let end = inflate_members(bytes, |piece| {
        found = found.saturating_add(piece.len());
        let (first, rest) = piece.split_at(piece.len().min(n - kept.len()));
        budget.extend(&mut kept, first)?;
        is_zero &= rest.iter().all(|&byte| byte == 0);
        if found > limit { Err(too_large(found, limit)) } else { Ok(ControlFlow::Continue(())) }
    })?;
    debug_assert!(end.is_continue(), "nothing breaks");
    let n_bytes = found - kept.len();
    Ok((Cow::Owned(kept), Rest { n_bytes, is_zero }))
}

/// The first `n` bytes after decompression, or as many as there are, for inspecting the header. Nothing after them is
/// read, so the checksum is **not** verified.
///
/// # Errors
/// `Gzip` if the stream is damaged within these bytes.
pub(super) fn unverified_prefix(bytes: &[u8], n: usize) -> Result<Plain<'_>, FormatError> {
    if !is_gzip(bytes) {
        return Ok(Cow::Borrowed(&bytes[..n.min(bytes.len())]));
    }
    let mut kept = Vec::new();
    let _ = inflate_members(bytes, |piece| {
        kept.extend_from_slice(&piece[..piece.len().min(n - kept.len())]);
        Ok(if kept.len() < n { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })
    })?;
    Ok(Cow::Owned(kept))
}

fn too_large(found: usize, limit: usize) -> FormatError {
    FormatError::TooLarge { what: "bytes", found: found as u64, limit: limit as u64 }
}

/// Passes the inflated bytes to `take` piece by piece, in order, until it breaks or fails, or every member has been
/// verified.
fn inflate_members(
    mut rest: &[u8],
    mut take: impl FnMut(&[u8]) -> Result<ControlFlow<()>, FormatError>,
) -> Result<ControlFlow<()>, FormatError> {
    let mut n_bytes = 0usize;
    let mut buffer = vec![0u8; 1 << 16];
    loop {
        let fault = |fault, n_bytes| FormatError::Gzip { fault, n_bytes };
        rest = after_header(rest).map_err(|f| fault(f, n_bytes))?;
        let (mut deflate, mut crc) = (Decompress::new(false), Crc::new());
        loop {
            let (read, written) = (deflate.total_in(), deflate.total_out());
            let status = deflate
                .decompress(rest, &mut buffer, FlushDecompress::None)
                .map_err(|_| fault(GzipFault::Data, n_bytes))?;
            rest = &rest[(deflate.total_in() - read) as usize..];
            let piece = &buffer[..(deflate.total_out() - written) as usize];
            crc.update(piece);
            n_bytes += piece.len();
            if take(piece)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
            if status == Status::StreamEnd {
                break;
            }
            // The buffer has room, so a lack of progress means missing input.
            if piece.is_empty() && deflate.total_in() == read {
                return Err(fault(GzipFault::EndsInData, n_bytes));
            }
        }
        let Some((trailer, after)) = rest.split_first_chunk::<TRAILER_BYTES>() else {
            return Err(fault(GzipFault::EndsBeforeTrailer, n_bytes));
        };
        let [c0, c1, c2, c3, l0, l1, l2, l3] = *trailer;
        if u32::from_le_bytes([c0, c1, c2, c3]) != crc.sum() {
            return Err(fault(GzipFault::Checksum, n_bytes));
        }
        if u32::from_le_bytes([l0, l1, l2, l3]) != crc.amount() {
            return Err(fault(GzipFault::Length, n_bytes));
        }
        if after.iter().all(|&b| b == 0) {
            return Ok(ControlFlow::Continue(()));
        }
        if !is_gzip(after) {
            return Err(fault(GzipFault::TrailingData, n_bytes));
        }
        rest = after;
    }
}

/// The bytes after the header of a member.
fn after_header(bytes: &[u8]) -> Result<&[u8], GzipFault> {
    const DEFLATE: u8 = 8;
    const CHECKSUM: u8 = 0x02;
    const EXTRA: u8 = 0x04;
    const NAME: u8 = 0x08;
    const COMMENT: u8 = 0x10;
    const RESERVED: u8 = 0xe0;
    let (header, mut rest) = bytes.split_at_checked(HEADER_BYTES).ok_or(GzipFault::EndsInHeader)?;
    let flags = header[3];
    if header[2] != DEFLATE || flags & RESERVED != 0 {
        return Err(GzipFault::Header);
    }
    if flags & EXTRA != 0 {
        let (length, after) = rest.split_first_chunk::<2>().ok_or(GzipFault::EndsInHeader)?;
        rest = after.get(usize::from(u16::from_le_bytes(*length))..).ok_or(GzipFault::EndsInHeader)?;
    }
    for text in [NAME, COMMENT] {
        if flags & text != 0 {
            let end = rest.iter().position(|&b| b == 0).ok_or(GzipFault::EndsInHeader)?;
            rest = &rest[end + 1..];
        }
    }
    if flags & CHECKSUM != 0 {
        let (stored, after) = rest.split_first_chunk::<2>().ok_or(GzipFault::EndsInHeader)?;
        let mut crc = Crc::new();
        crc.update(&bytes[..bytes.len() - rest.len()]);
        // The header's checksum is the lower half of the CRC-32.
        if u16::from_le_bytes(*stored) != crc.sum() as u16 {
            return Err(GzipFault::Header);
        }
        rest = after;
    }
    Ok(rest)
}
