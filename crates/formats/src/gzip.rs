//! Inflating under a hard cap.

use super::{FormatError, Plain};
use flate2::read::MultiGzDecoder;
use std::borrow::Cow;
use std::io::Read;

/// Whether `bytes` are a gzip stream.
pub(super) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// `bytes` inflated if they are compressed, as they are otherwise.
///
/// # Errors
/// `TooLarge` beyond `limit` bytes (found after inflating no more than that), `Gzip` if the stream is damaged.
pub(super) fn inflate(bytes: &[u8], limit: usize) -> Result<Plain<'_>, FormatError> {
    let too_large = |found: usize| FormatError::TooLarge { what: "bytes", found: found as u64, limit: limit as u64 };
    if !is_gzip(bytes) {
        return if bytes.len() > limit { Err(too_large(bytes.len())) } else { Ok(Cow::Borrowed(bytes)) };
    }
    let mut inflated = Vec::new();
    match MultiGzDecoder::new(bytes).take(limit as u64 + 1).read_to_end(&mut inflated) {
        Ok(_) if inflated.len() > limit => Err(too_large(inflated.len())),
        Ok(_) => Ok(Cow::Owned(inflated)),
        Err(_) => Err(FormatError::Gzip { n_bytes: inflated.len() }),
    }
}

/// The first `n` bytes after inflating, or as many as there are; nothing after them is looked at.
///
/// # Errors
/// `Gzip` if the stream is damaged before that.
pub(super) fn inflated_head(bytes: &[u8], n: usize) -> Result<Plain<'_>, FormatError> {
    if !is_gzip(bytes) {
        return Ok(Cow::Borrowed(&bytes[..n.min(bytes.len())]));
    }
    let mut head = Vec::new();
    match MultiGzDecoder::new(bytes).take(n as u64).read_to_end(&mut head) {
        Ok(_) => Ok(Cow::Owned(head)),
        Err(_) => Err(FormatError::Gzip { n_bytes: head.len() }),
    }
}
