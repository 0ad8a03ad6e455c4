//! A scanner of words, lines and binary blocks that counts lines for error messages.

use super::FormatError;

/// A position in a file, and the number of its line.
#[derive(Debug, Clone)]
pub(super) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
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

    /// The rest of this line without its end; `None` at the end of the file.
    pub(super) fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        let length = rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
        self.at += (length + 1).min(rest.len());
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    /// The next word; `None` at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        while let Some(b) = self.bytes.get(self.at).filter(|b| b.is_ascii_whitespace() || **b == 0x0b) {
            self.line += usize::from(*b == b'\n');
            self.at += 1;
        }
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        let length = rest.iter().position(|b| b.is_ascii_whitespace()).unwrap_or(rest.len());
        self.at += length;
        Some(&rest[..length])
    }

    /// The next word, without consuming it.
    pub(super) fn peek(&self) -> Option<&'a [u8]> {
        self.clone().word()
    }

    /// The next word as a number.
    ///
    /// # Errors
    /// `Syntax` if it is not one.
    pub(super) fn number<T: std::str::FromStr>(&mut self, expected: &'static str) -> Result<T, FormatError> {
        let word = self.word().and_then(|w| std::str::from_utf8(w).ok());
        word.and_then(|w| w.parse().ok()).ok_or_else(|| self.expected(expected))
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
