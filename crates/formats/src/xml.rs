//! The elements of an XML file, one by one, and the binary data of XML formats: base64 and zlib.

use super::FormatError;
use super::budget::Budget;
use super::gzip;
use base64::Engine;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;
use std::io::Read;

/// Base64 with or without padding at its end.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// Largest nesting depth of elements, and largest size of a start tag: both are held during reading.
const MAX_DEPTH: usize = 256;
const MAX_TAG_BYTES: usize = 1 << 16;

/// A start tag, text, or an end tag. Comments, declarations and processing instructions are skipped.
#[derive(Debug)]
pub(super) enum Node<'a> {
    Start(Tag),
    Text(Cow<'a, [u8]>),
    End,
}

/// A start tag with its attributes.
#[derive(Debug)]
pub(super) struct Tag {
    pub(super) name: String,
    attributes: Vec<(String, String)>,
}

impl Tag {
    fn new(tag: &BytesStart<'_>) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        // Checking for repeated names takes quadratic time in the number of attributes.
        let mut attributes = tag.attributes();
        let attributes =
            attributes.with_checks(false).flatten().map(|a| (text(a.key.as_ref()), text(&a.value))).collect();
        Tag { name: text(tag.name().as_ref()), attributes }
    }

    /// The value of an attribute, trimmed; empty if it is absent.
    pub(super) fn get(&self, name: &str) -> &str {
        self.attributes.iter().find(|(key, _)| key == name).map_or("", |(_, value)| value.trim())
    }

    /// The value of an attribute as a number.
    pub(super) fn number<T: std::str::FromStr>(&self, name: &str) -> Option<T> {
        self.get(name).parse().ok()
    }
}

/// A position in an XML file.
pub(super) struct Xml<'a> {
    bytes: &'a [u8],
    reader: Reader<&'a [u8]>,
    format: &'static str,
    depth: usize,
}

impl<'a> Xml<'a> {
    pub(super) fn new(bytes: &'a [u8], format: &'static str) -> Self {
        let mut reader = Reader::from_reader(bytes);
        reader.config_mut().expand_empty_elements = true;
        Xml { bytes, reader, format, depth: 0 }
    }

    /// The next node; `None` at the end of the file.
    ///
    /// # Errors
    /// `Payload` if this is not well-formed XML, or is nested deeper than any file of these formats.
    pub(super) fn next(&mut self) -> Result<Option<Node<'a>>, FormatError> {
        loop {
            return match self.reader.read_event() {
                Ok(Event::Start(tag) | Event::Empty(tag)) => {
                    self.depth += 1;
                    if self.depth > MAX_DEPTH || tag.len() > MAX_TAG_BYTES {
                        return Err(self.damaged());
                    }
                    Ok(Some(Node::Start(Tag::new(&tag))))
                }
                Ok(Event::Text(text)) => Ok(Some(Node::Text(text.into_inner()))),
                Ok(Event::CData(text)) => Ok(Some(Node::Text(text.into_inner()))),
                Ok(Event::End(_)) => {
                    self.depth = self.depth.saturating_sub(1);
                    Ok(Some(Node::End))
                }
                Ok(Event::Eof) => Ok(None),
                Ok(_) => continue,
                Err(_) => Err(self.damaged()),
            };
        }
    }

    /// An error at this position.
    pub(super) fn damaged(&self) -> FormatError {
        let before = &self.bytes[..self.position()];
        FormatError::Payload { format: self.format, line: Some(1 + before.iter().filter(|&&b| b == b'\n').count()) }
    }

    /// Number of bytes before the next node.
    pub(super) fn position(&self) -> usize {
        usize::try_from(self.reader.buffer_position()).map_or(self.bytes.len(), |at| at.min(self.bytes.len()))
    }
}

/// The decoded bytes of base64 text; blanks and line ends are skipped. `Ok(None)` if it is not base64.
///
/// # Errors
/// `TooLarge` beyond the budget.
pub(super) fn base64(text: &[u8], budget: &Budget) -> Result<Option<Vec<u8>>, FormatError> {
    budget.charge(2 * text.len())?;
    let mut dense = Vec::with_capacity(text.len());
    dense.extend(text.iter().copied().filter(|b| !b.is_ascii_whitespace()));
    let decoded = BASE64.decode(dense).ok();
    budget.release(text.len());
    Ok(decoded)
}

/// The bytes of a zlib or gzip stream, which must be exactly `n_bytes`. `Ok(None)` if it is damaged or its length
/// differs.
///
/// # Errors
/// `TooLarge` beyond the budget.
pub(super) fn inflate(stream: &[u8], n_bytes: usize, budget: &Budget) -> Result<Option<Vec<u8>>, FormatError> {
    Ok(inflate_up_to(stream, n_bytes, n_bytes, budget)?.filter(|plain| plain.len() == n_bytes))
}

/// The first bytes of a zlib or gzip stream, of which `expected` are used: at most one more than `limit`. `Ok(None)` if
/// it is damaged.
///
/// # Errors
/// `TooLarge` beyond the budget.
pub(super) fn inflate_up_to(
    stream: &[u8],
    limit: usize,
    expected: usize,
    budget: &Budget,
) -> Result<Option<Vec<u8>>, FormatError> {
    if gzip::is_gzip(stream) {
        return match gzip::inflate(stream, limit, budget) {
            Ok(plain) => Ok(Some(plain.into_owned())),
            Err(FormatError::TooLarge { what, found, limit: most }) if most != limit as u64 => {
                Err(FormatError::TooLarge { what, found, limit: most })
            }
            Err(_) => Ok(None),
        };
    }
    let plain = budget.for_inflated(stream.len(), expected.saturating_add(1).min(limit.saturating_add(1)))?;
    read_charged(flate2::read::ZlibDecoder::new(stream).take(limit as u64 + 1), plain, budget)
}

/// Appends the output of a decoder. `Ok(None)` if it is damaged.
///
/// # Errors
/// `TooLarge` beyond the budget.
pub(super) fn read_charged(
    mut decoder: impl Read,
    mut plain: Vec<u8>,
    budget: &Budget,
) -> Result<Option<Vec<u8>>, FormatError> {
    let mut buffer = vec![0u8; 1 << 16];
    loop {
        match decoder.read(&mut buffer) {
            Ok(0) => return Ok(Some(plain)),
            Ok(n) => budget.extend(&mut plain, &buffer[..n])?,
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(_) => return Ok(None),
        }
    }
}
