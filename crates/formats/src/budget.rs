//! Memory budget for reading a file. Every list that grows with the content of a file is charged here before it grows,
//! so a small file takes little memory, whatever it states and whatever it inflates to.
//!
//! The limit, which `tests/formats/memory.rs` measures: while a file is read, at most [`BYTES_PER_BYTE`] bytes are held for
//! each received byte, plus [`BYTES_ALWAYS`], plus four times the voxels that a header declares, at four bytes each, or
//! more if they are stored as more. Label maps of mostly background compress a thousand times, so they count by their
//! declared size, not by the received bytes; [`super::ReadLimits::max_inflated_bytes`] bounds that size.

use super::{FormatError, ReadLimits};
use std::cell::Cell;

/// Bytes that may be held per received byte, and in addition for any file.
const BYTES_PER_BYTE: usize = 64;
const BYTES_ALWAYS: usize = 16 << 20;
/// Part of these limits reserved for uncharged memory: buffers and tables of fixed size, an inspection of the header,
/// texts of errors.
const KEPT_PER_BYTE: usize = 2;
const KEPT_ALWAYS: usize = 3 << 20;
/// Largest inflation of a byte by deflate.
const MOST_INFLATION: usize = 1032;
/// Number of times that the declared voxels may be held while they are read: as stored, as labels, and while a list of
/// either grows. The file of a volume that is compressed as a whole is held once more.
const COPIES_OF_VOXELS: usize = 3;

/// Remaining memory for reading a file.
#[derive(Debug)]
pub(super) struct Budget {
    left: Cell<usize>,
    limit: Cell<usize>,
}

/// Memory for reading a file of `n_bytes` received bytes.
pub(super) fn for_file(n_bytes: usize) -> usize {
    n_bytes.saturating_mul(BYTES_PER_BYTE - KEPT_PER_BYTE).saturating_add(BYTES_ALWAYS - KEPT_ALWAYS)
}

impl Budget {
    pub(super) fn new(n_bytes: usize) -> Self {
        Budget { left: Cell::new(n_bytes), limit: Cell::new(n_bytes) }
    }

    pub(super) fn of(limits: &ReadLimits) -> Self {
        Budget::new(limits.max_memory)
    }

    pub(super) fn left(&self) -> usize {
        self.left.get()
    }

    /// Takes bytes from the budget.
    ///
    /// # Errors
    /// `TooLarge` if fewer are left.
    pub(super) fn charge(&self, n_bytes: usize) -> Result<(), FormatError> {
        let left = self.left.get().checked_sub(n_bytes).ok_or_else(|| {
            let limit = self.limit.get();
            let found = (limit - self.left.get()).saturating_add(n_bytes) as u64;
            FormatError::TooLarge { what: "bytes in memory when it is read", found, limit: limit as u64 }
        })?;
        self.left.set(left);
        Ok(())
    }

    /// [`Budget::charge`] for `n` values.
    pub(super) fn charge_of<T>(&self, n: usize) -> Result<(), FormatError> {
        self.charge(n.saturating_mul(size_of::<T>()))
    }

    /// Returns memory that is no longer held.
    pub(super) fn release(&self, n_bytes: usize) {
        self.left.set(self.left.get().saturating_add(n_bytes));
    }

    /// Adds room for the stored file of a volume that is compressed as a whole.
    pub(super) fn grant(&self, n_bytes: usize) {
        self.left.set(self.left.get().saturating_add(n_bytes));
        self.limit.set(self.limit.get().saturating_add(n_bytes));
    }

    /// Adds room for a volume whose header declares `n_bytes`, at least four per voxel.
    pub(super) fn grant_voxels(&self, n_bytes: usize) {
        self.grant(n_bytes.saturating_mul(COPIES_OF_VOXELS));
    }

    /// Reserves room for `more` values. While a list grows, its old and its new allocation are both held.
    pub(super) fn reserve<T>(&self, list: &mut Vec<T>, more: usize) -> Result<(), FormatError> {
        let (before, needed) = (list.capacity(), list.len().saturating_add(more));
        if needed > before {
            let after = needed.max(before.saturating_add(before / 2)).max(4);
            self.charge_of::<T>(after)?;
            list.reserve_exact(after - list.len());
            self.release(before.saturating_mul(size_of::<T>()));
        }
        Ok(())
    }

    pub(super) fn push<T>(&self, list: &mut Vec<T>, value: T) -> Result<(), FormatError> {
        self.reserve(list, 1)?;
        list.push(value);
        Ok(())
    }

    pub(super) fn extend<T: Copy>(&self, list: &mut Vec<T>, values: &[T]) -> Result<(), FormatError> {
        self.reserve(list, values.len())?;
        list.extend_from_slice(values);
        Ok(())
    }

    /// Collects the values of a sequence of unknown length, up to the first error.
    pub(super) fn collect<T>(
        &self,
        values: impl IntoIterator<Item = Result<T, FormatError>>,
    ) -> Result<Vec<T>, FormatError> {
        let mut list = Vec::new();
        for value in values {
            self.push(&mut list, value?)?;
        }
        Ok(list)
    }

    /// Room for the inflated form of `n_packed` compressed bytes, at most `expected`: a list that need not grow.
    pub(super) fn for_inflated(&self, n_packed: usize, expected: usize) -> Result<Vec<u8>, FormatError> {
        let mut list = Vec::new();
        let n_bytes = expected.min(n_packed.saturating_mul(MOST_INFLATION));
        if n_bytes <= self.left() {
            self.reserve(&mut list, n_bytes)?;
        }
        Ok(list)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_grows_until_the_budget_is_spent() {
        let budget = Budget::new(1000);
        let mut list: Vec<u64> = Vec::new();
        let refused = (0..).find_map(|k| budget.push(&mut list, k).err());
        assert!(matches!(refused, Some(FormatError::TooLarge { limit: 1000, .. })), "{refused:?}");
        // 63 values are 504 bytes; 94 values are 752, more than the remaining budget.
        assert_eq!((list.len(), budget.left()), (63, 496));
        drop(list);
        budget.release(504);
        assert_eq!(budget.left(), 1000);
        budget.grant_voxels(100);
        assert!(budget.charge(1300).is_ok() && budget.charge(1).is_err());
    }
}
