//! Neighborhoods of labels as rows of equal length, for loops without a branch that depends on the label.
//!
//! With rows of different lengths the processor mispredicts the end of most of them, which costs as much as half a row.
//! Here all rows have the same width: shorter rows are padded with a label that adds nothing, and the excess of longer
//! rows is listed separately, chunk by chunk.

use super::lanes::CHUNK;

/// Rows of labels.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LabelRows {
    width: usize,
    /// Members, row after row.
    members: Vec<u32>,
    /// One more than the largest member.
    limit: usize,
    /// Excess of rows beyond the width: label and member.
    more: Vec<[u32; 2]>,
    /// Start of each chunk's part of `more`, followed by the end of the last.
    more_starts: Vec<u32>,
}

impl LabelRows {
    /// The rows of labels `0..n`; `filler(y)` pads the row of `y`. Cost `O(members)`.
    pub(super) fn new<'a>(n: usize, row: impl Fn(usize) -> &'a [u32], filler: impl Fn(usize) -> u32) -> Self {
        let width = best_width((0..n).map(|y| row(y).len()));
        let mut rows = LabelRows {
            width,
            members: Vec::with_capacity(n * width),
            limit: 0,
            more: Vec::new(),
            more_starts: vec![0],
        };
        for y in 0..n {
            let (fixed, more) = row(y).split_at(width.min(row(y).len()));
            rows.members.extend_from_slice(fixed);
            rows.members.resize((y + 1) * width, filler(y));
            rows.more.extend(more.iter().map(|&x| [y as u32, x]));
            if (y + 1) % CHUNK == 0 || y + 1 == n {
                rows.more_starts.push(rows.more.len() as u32);
            }
        }
        rows.limit = rows.members.iter().max().map_or(0, |&largest| largest as usize + 1);
        rows
    }

    /// One more than the largest label that [`LabelRows::members`] gives.
    pub(super) fn limit(&self) -> usize {
        self.limit
    }

    /// Number of members of a row in [`LabelRows::members`].
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// The rows of a chunk of [`CHUNK`] labels, one after the other; the last chunk may be shorter.
    pub(super) fn members(&self, chunk: usize) -> &[u32] {
        let end = ((chunk + 1) * CHUNK * self.width).min(self.members.len());
        &self.members[(chunk * CHUNK * self.width).min(end)..end]
    }

    /// Excess of the rows of the chunk beyond the width: label and member.
    pub(super) fn more(&self, chunk: usize) -> &[[u32; 2]] {
        match self.more_starts.get(chunk..chunk + 2) {
            Some(&[start, end]) => &self.more[start as usize..end as usize],
            _ => &[],
        }
    }
}

/// The width of lowest cost: a place in a row costs one, a separately listed member costs two, because the partial
/// result of its row has to be read and written again.
fn best_width(lengths: impl Iterator<Item = usize>) -> usize {
    let mut count = Vec::new();
    for length in lengths {
        if count.len() <= length {
            count.resize(length + 1, 0usize);
        }
        count[length] += 1;
    }
    let n: usize = count.iter().sum();
    let cost = |width: usize| {
        let apart: usize = count.iter().enumerate().map(|(length, n)| n * length.saturating_sub(width)).sum();
        n * width + 2 * apart
    };
    (1..count.len().max(2)).min_by_key(|&width| cost(width)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rows_contain_their_members_and_are_padded(
            rows in prop::collection::vec(prop::collection::vec(0u32..999, 1..30), 1..300),
        ) {
            let made = LabelRows::new(rows.len(), |y| &rows[y], |y| 1000 + y as u32);
            for (y, row) in rows.iter().enumerate() {
                let (chunk, at) = (y / CHUNK, y % CHUNK);
                let fixed = &made.members(chunk)[at * made.width()..][..made.width()];
                let more = made.more(chunk).iter().filter(|[label, _]| *label == y as u32).map(|&[_, x]| x);
                let found: Vec<u32> = fixed.iter().copied().filter(|&x| x != 1000 + y as u32).chain(more).collect();
                prop_assert_eq!(&found, row);
            }
            prop_assert_eq!(made.members(rows.len().div_ceil(CHUNK)).len(), 0);
            prop_assert_eq!(made.more(rows.len().div_ceil(CHUNK)).len(), 0);
        }
    }
}
