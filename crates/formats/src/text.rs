//! A scanner of words, lines and binary blocks that counts lines for error messages.

use super::FormatError;

/// A position in a file, with its line number.
#[derive(Debug, Clone)]
pub(super) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

/// White space as defined by C.
fn is_blank(byte: u8) -> bool {
    byte.is_ascii_whitespace() || byte == 0x0b
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|b| is_blank(*b)).filter(|word| !word.is_empty())
}

/// A real number in the notation of `strtod` in C and of C libraries: `.5`, `5.`, `+1`, `1e5`, `-inf`, `nan`, and the
/// `1.#QNAN` and `-1.#IND` of older Windows programs. `None` if it is invalid.
pub(super) fn real(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    if let Ok(value) = text.parse() {
        return Some(value);
    }
    let unsigned = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
    let (is_negative, is_single) = (text.starts_with('-'), text.len() <= unsigned.len() + 1);
    if !is_single {
        return None;
    }
    let is_nan = unsigned.starts_with("nan(") && unsigned.ends_with(')');
    match unsigned.strip_prefix("1.#") {
        Some(kind) if kind.starts_with("inf") => Some(if is_negative { f64::NEG_INFINITY } else { f64::INFINITY }),
        Some(kind) if ["qnan", "snan", "ind"].iter().any(|name| kind.starts_with(name)) => Some(f64::NAN),
        _ => is_nan.then_some(f64::NAN),
    }
}

/// A whole number; `None` if it is invalid.
pub(super) fn whole<T: std::str::FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Bytes that are searched for the root of an XML document.
const XML_HEAD_BYTES: usize = 1 << 16;

/// Whether `bytes` are XML whose root element begins with `root`.
pub(super) fn has_root(bytes: &[u8], root: &[u8]) -> bool {
    let bytes = without_preamble(bytes);
    let head = &bytes[..bytes.len().min(XML_HEAD_BYTES)];
    head.starts_with(b"<") && head.windows(root.len()).any(|w| w == root)
}

/// The text of a file without a meaningless preamble: a byte order mark of UTF-8, blanks and empty lines.
pub(super) fn without_preamble(bytes: &[u8]) -> &[u8] {
    let blanks = |bytes: &[u8]| bytes.iter().take_while(|b| is_blank(**b)).count();
    let bytes = &bytes[blanks(bytes)..];
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    &bytes[blanks(bytes)..]
}

impl<'a> Scanner<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Scanner { bytes, at: 0, line: 1 }
    }

    /// Bytes after the position.
    pub(super) fn remaining(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// An error at this line.
    pub(super) fn expected(&self, expected: &'static str) -> FormatError {
        FormatError::Syntax { line: self.line, expected }
    }

    /// An error in the line that was just read.
    pub(super) fn expected_before(&self, expected: &'static str) -> FormatError {
        FormatError::Syntax { line: self.line.saturating_sub(1).max(1), expected }
    }

    /// The rest of this line, without consuming it; empty at the end of the file.
    pub(super) fn peek_line(&self) -> &'a [u8] {
        self.clone().line().unwrap_or_default()
    }

    /// The rest of this line without its end, which is LF, CR LF or a lone CR, as in files of old Macintosh programs;
    /// `None` at the end of the file. Use it for files that are entirely text.
    pub(super) fn text_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        let length = rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
        let end = if rest[length..].starts_with(b"\r\n") { 2 } else { 1 };
        self.at += (length + end).min(rest.len());
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    /// The rest of this line without its end; `None` at the end of the file.
    pub(super) fn line(&mut self) -> Option<&'a [u8]> {
        self.line_ended_by(b'\n')
    }

    /// Like [`Self::line`], for lines that end with another byte.
    pub(super) fn line_ended_by(&mut self, end: u8) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        let length = rest.iter().position(|&b| b == end).unwrap_or(rest.len());
        self.at += (length + 1).min(rest.len());
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    /// The next word; `None` at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        let length = rest.iter().position(|b| is_blank(*b)).unwrap_or(rest.len());
        self.at += length;
        Some(&rest[..length])
    }

    /// The next word, without consuming it.
    pub(super) fn peek(&self) -> Option<&'a [u8]> {
        self.clone().word()
    }

    /// Skips blanks and line ends.
    pub(super) fn skip_blanks(&mut self) {
        while let Some(b) = self.bytes.get(self.at).filter(|b| is_blank(**b)) {
            self.line += usize::from(*b == b'\n');
            self.at += 1;
        }
    }

    /// The bytes after the position.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// The next word as a real number in C notation.
    ///
    /// # Errors
    /// `Syntax` if it is invalid.
    pub(super) fn real(&mut self, expected: &'static str) -> Result<f64, FormatError> {
        self.word().and_then(real).ok_or_else(|| self.expected(expected))
    }

    /// The next word as a whole number.
    ///
    /// # Errors
    /// `Syntax` if it is invalid.
    pub(super) fn number<T: std::str::FromStr>(&mut self, expected: &'static str) -> Result<T, FormatError> {
        let word = self.word().and_then(|w| std::str::from_utf8(w).ok());
        word.and_then(|w| w.parse().ok()).ok_or_else(|| self.expected(expected))
    }

    /// Checks the text after the last of `stated` rows of `width` numbers. Blanks and zeros are accepted; other words
    /// are accepted with a note.
    ///
    /// # Errors
    /// `CountMismatch` if further numbers follow, which means that the count of rows is wrong.
    pub(super) fn check_end(
        &mut self,
        what: &'static str,
        stated: u64,
        width: u64,
    ) -> Result<Option<String>, FormatError> {
        let n_bytes = self.rest().iter().filter(|byte| **byte != 0 && !is_blank(**byte)).count();
        let mut n_numbers = 0;
        while self.word().and_then(real).is_some() {
            n_numbers += 1;
        }
        if n_numbers > 0 {
            let found = stated + (n_numbers / width).max(1);
            return Err(FormatError::CountMismatch { what, stated, found });
        }
        Ok((n_bytes > 0).then(|| super::trailing_note(n_bytes)))
    }

    /// The next `n · size` bytes.
    ///
    /// # Errors
    /// `Truncated` if there are fewer.
    pub(super) fn take(&mut self, n: u64, size: usize, part: &'static str) -> Result<&'a [u8], FormatError> {
        let needed = n.saturating_mul(size as u64);
        let available = self.remaining() as u64;
        if needed > available {
            return Err(FormatError::Truncated { part, needed, available });
        }
        let block = &self.bytes[self.at..self.at + needed as usize];
        self.at += needed as usize;
        Ok(block)
    }
}
