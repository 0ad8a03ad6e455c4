//! Frames between a process and its children: a JSON head and a body of bytes, preceded by their lengths.
//!
//! ```text
//! length of the head (u32) | length of the body (u64) | head | body          numbers in little-endian order
//! ```
//!
//! The reader states how long head and body may be. Memory grows with the bytes that arrive, never with a length that
//! is only claimed.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::io::{self, Read, Write};

/// Bytes before the head.
const LENGTHS: usize = 12;

/// How long a frame may be, bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Longest {
    /// Longest head.
    pub(super) head: u32,
    /// Longest body.
    pub(super) body: u64,
}

impl Longest {
    /// Limits of a child for frames from its parent: none, because the parent bounds what it sends.
    pub(super) const FROM_PARENT: Longest = Longest { head: u32::MAX, body: u64::MAX };
}

/// Why no frame was read.
#[derive(Debug, thiserror::Error)]
pub(super) enum FrameError {
    /// The other side has closed the connection between two frames.
    #[error("the connection was closed")]
    Closed,
    /// The connection failed, or was closed within a frame.
    #[error("a frame cannot be read: {0}")]
    Io(#[from] io::Error),
    /// The frame is longer than allowed.
    #[error("a frame has a {part} of {length} bytes, of which {most} are allowed")]
    TooLong {
        /// `head` or `body`.
        part: &'static str,
        /// Its length.
        length: u64,
        /// The longest that is allowed.
        most: u64,
    },
    /// The head is not of the expected form.
    #[error("the head of a frame has no meaning: {0}")]
    Meaningless(#[from] serde_json::Error),
}

/// Writes a frame whose body is the parts of `body` in their order.
///
/// # Errors
/// Those of `writer`; a head of 4 GiB and more is refused.
pub(super) fn write_frame(writer: &mut impl Write, head: &impl Serialize, body: &[&[u8]]) -> io::Result<()> {
    let head = serde_json::to_vec(head)?;
    let head_length = u32::try_from(head.len()).map_err(io::Error::other)?;
    let body_length: u64 = body.iter().map(|part| part.len() as u64).sum();
    // One write for a frame without a body: a computation sends thousands of these.
    let mut start = Vec::with_capacity(LENGTHS + head.len());
    start.extend_from_slice(&head_length.to_le_bytes());
    start.extend_from_slice(&body_length.to_le_bytes());
    start.extend_from_slice(&head);
    writer.write_all(&start)?;
    for part in body {
        writer.write_all(part)?;
    }
    writer.flush()
}

/// Reads a frame.
///
/// # Errors
/// [`FrameError`].
pub(super) fn read_frame<H: DeserializeOwned>(
    reader: &mut impl Read,
    longest: Longest,
) -> Result<(H, Vec<u8>), FrameError> {
    let mut lengths = [0; LENGTHS];
    // The first byte is read alone, to see whether there is another frame.
    if reader.read(&mut lengths[..1])? == 0 {
        return Err(FrameError::Closed);
    }
    reader.read_exact(&mut lengths[1..])?;
    let [h0, h1, h2, h3, body @ ..] = lengths;
    let (head, body) = (u32::from_le_bytes([h0, h1, h2, h3]), u64::from_le_bytes(body));
    if head > longest.head {
        return Err(FrameError::TooLong { part: "head", length: head.into(), most: longest.head.into() });
    }
    if body > longest.body {
        return Err(FrameError::TooLong { part: "body", length: body, most: longest.body });
    }
    let head = read_part(reader, head.into())?;
    let body = read_part(reader, body)?;
    Ok((serde_json::from_slice(&head)?, body))
}

/// Exactly `length` bytes.
fn read_part(reader: &mut impl Read, length: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(length).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == length { Ok(bytes) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::*;
    use serde_json::{Value, json};

    const LONGEST: Longest = Longest { head: 1 << 16, body: 1 << 16 };

    fn heads() -> impl Strategy<Value = Value> {
        let number = prop_oneof![any::<f64>().prop_filter("JSON has no other numbers", |x| x.is_finite())];
        (vec(number, 0..8), ".{0,40}", any::<Option<u64>>())
            .prop_map(|(numbers, text, count)| json!({"numbers": numbers, "text": text, "count": count}))
    }

    fn written(head: &Value, body: &[&[u8]]) -> Vec<u8> {
        let mut bytes = Vec::new();
        write_frame(&mut bytes, head, body).unwrap();
        bytes
    }

    proptest! {
        #[test]
        fn frames_are_read_as_they_were_written(
            frames in vec((heads(), vec(vec(any::<u8>(), 0..300), 0..4)), 0..4),
        ) {
            let mut bytes = Vec::new();
            for (head, body) in &frames {
                let parts: Vec<&[u8]> = body.iter().map(Vec::as_slice).collect();
                write_frame(&mut bytes, head, &parts).unwrap();
            }
            let mut reader = bytes.as_slice();
            for (head, body) in &frames {
                let (found, content): (Value, Vec<u8>) = read_frame(&mut reader, LONGEST).unwrap();
                prop_assert_eq!(&found, head);
                prop_assert_eq!(content, body.concat());
            }
            prop_assert!(matches!(read_frame::<Value>(&mut reader, LONGEST), Err(FrameError::Closed)));
        }

        #[test]
        fn a_frame_that_ends_early_is_refused(head in heads(), body in vec(any::<u8>(), 0..300), at in 0.0..1.0_f64) {
            let whole = written(&head, &[&body]);
            let cut = 1 + (at * (whole.len() - 1) as f64) as usize;
            let read = read_frame::<Value>(&mut &whole[..cut], LONGEST);
            prop_assert!(matches!(read, Err(FrameError::Io(_))), "{read:?}");
        }

        #[test]
        fn what_is_too_long_is_refused_before_it_is_read(head in 0..=u32::MAX, body in any::<u64>()) {
            let longest = Longest { head: 1000, body: 1000 };
            prop_assume!(head > longest.head || body > longest.body);
            let lengths = [head.to_le_bytes().as_slice(), &body.to_le_bytes()].concat();
            let read = read_frame::<Value>(&mut lengths.as_slice(), longest);
            prop_assert!(matches!(read, Err(FrameError::TooLong { .. })), "{read:?}");
        }

        #[test]
        fn any_bytes_are_a_frame_or_refused(bytes in vec(any::<u8>(), 0..200)) {
            let _ = read_frame::<Value>(&mut bytes.as_slice(), LONGEST);
        }
    }

    #[test]
    fn a_claimed_length_takes_no_memory() {
        let lengths = [0u32.to_le_bytes().as_slice(), &u64::MAX.to_le_bytes()].concat();
        assert!(matches!(read_frame::<Value>(&mut lengths.as_slice(), Longest::FROM_PARENT), Err(FrameError::Io(_))));
    }
}
