//! Number types of binary arrays, and their values as real numbers, whole numbers or labels.

use super::FormatError;
use super::budget::Budget;

/// Largest distance of a label from an integer: covers the rounding of scaled single-precision values.
const LABEL_TOLERANCE: f64 = 1e-3;

/// Type of the numbers of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Element {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

/// Byte order of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ByteOrder {
    Little,
    Big,
}

impl Element {
    /// Bytes of one number.
    pub(super) fn size(self) -> usize {
        match self {
            Element::I8 | Element::U8 => 1,
            Element::I16 | Element::U16 => 2,
            Element::I32 | Element::U32 | Element::F32 => 4,
            Element::I64 | Element::U64 | Element::F64 => 8,
        }
    }

    /// The value of one number; `b` has its bytes in little-endian order, padded with zeros. 64-bit integers are rounded.
    fn real(self, b: [u8; 8]) -> f64 {
        match self {
            Element::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Element::F64 => f64::from_le_bytes(b),
            Element::U64 => u64::from_le_bytes(b) as f64,
            _ => self.whole(b) as f64,
        }
    }

    /// One number as a whole number: reals are truncated, and numbers beyond `i64` saturate.
    fn whole(self, b: [u8; 8]) -> i64 {
        let low = u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
        match self {
            Element::I8 => (b[0] as i8).into(),
            Element::U8 => b[0].into(),
            Element::I16 => (low as u16 as i16).into(),
            Element::U16 => (low as u16).into(),
            Element::I32 => (low as i32).into(),
            Element::U32 => low.into(),
            Element::I64 => i64::from_le_bytes(b),
            Element::U64 => i64::try_from(u64::from_le_bytes(b)).unwrap_or(i64::MAX),
            Element::F32 | Element::F64 => self.real(b) as i64,
        }
    }

    /// One number as a real number; `raw` has its bytes.
    pub(super) fn real_of(self, raw: &[u8], order: ByteOrder) -> f64 {
        self.real(little(raw, order))
    }

    /// One number as a whole number; `raw` has its bytes.
    pub(super) fn whole_of(self, raw: &[u8], order: ByteOrder) -> i64 {
        self.whole(little(raw, order))
    }

    /// The numbers of `raw` as real numbers; bytes after the last whole number are ignored.
    pub(super) fn reals(self, raw: &[u8], order: ByteOrder) -> Vec<f64> {
        raw.chunks_exact(self.size()).map(|b| self.real(little(b, order))).collect()
    }

    /// [`Element::reals`] within a budget.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    pub(super) fn charged_reals(self, raw: &[u8], order: ByteOrder, budget: &Budget) -> Result<Vec<f64>, FormatError> {
        budget.charge_of::<f64>(raw.len() / self.size())?;
        Ok(self.reals(raw, order))
    }

    /// [`Element::wholes`] within a budget.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    pub(super) fn charged_wholes(self, raw: &[u8], order: ByteOrder, budget: &Budget) -> Result<Vec<i64>, FormatError> {
        budget.charge_of::<i64>(raw.len() / self.size())?;
        Ok(self.wholes(raw, order))
    }

    /// The numbers of `raw` as whole numbers; bytes after the last whole number are ignored.
    pub(super) fn wholes(self, raw: &[u8], order: ByteOrder) -> Vec<i64> {
        raw.chunks_exact(self.size()).map(|b| self.whole(little(b, order))).collect()
    }
}

fn little(raw: &[u8], order: ByteOrder) -> [u8; 8] {
    let mut b = [0; 8];
    b[..raw.len()].copy_from_slice(raw);
    if order == ByteOrder::Big {
        b[..raw.len()].reverse();
    }
    b
}

/// The bytes after the part of a file that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rest {
    pub(super) n_bytes: usize,
    /// Whether all of these bytes are zeros, like padding.
    pub(super) is_zero: bool,
}

impl Rest {
    pub(super) fn of(bytes: &[u8]) -> Self {
        Rest { n_bytes: bytes.len(), is_zero: bytes.iter().all(|&byte| byte == 0) }
    }
}

/// The voxels of a volume as a file stores them: the first index fastest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Voxels {
    pub(super) dims: [usize; 3],
    pub(super) element: Element,
    pub(super) order: ByteOrder,
    /// A value is `slope` times the stored number plus `intercept`.
    pub(super) slope: f64,
    pub(super) intercept: f64,
}

impl Voxels {
    /// Voxels whose stored numbers are their values.
    pub(super) fn plain(dims: [usize; 3], element: Element, order: ByteOrder) -> Self {
        Voxels { dims, element, order, slope: 1.0, intercept: 0.0 }
    }

    /// Number of voxels.
    pub(super) fn count(&self) -> u64 {
        self.dims.iter().fold(1u64, |n, &d| n.saturating_mul(d as u64))
    }

    /// Bytes of all voxels in the file.
    ///
    /// # Errors
    /// `TooLarge` if the stored voxels, or their labels at four bytes each, exceed `limit`.
    pub(super) fn bytes_needed(&self, limit: usize) -> Result<usize, FormatError> {
        let found = self.count().saturating_mul(self.element.size().max(4) as u64);
        if found > limit as u64 {
            return Err(FormatError::TooLarge { what: "bytes of voxels", found, limit: limit as u64 });
        }
        Ok(self.count() as usize * self.element.size())
    }

    /// Checks that the bytes after the voxels may be dropped: there are none, they are zeros, or they are fewer than a
    /// slice. Otherwise the sizes in the header are wrong.
    ///
    /// Returns a note if bytes other than zeros are dropped.
    ///
    /// # Errors
    /// `Overlong`.
    pub(super) fn check_rest(&self, stated: usize, rest: Rest) -> Result<Option<String>, FormatError> {
        let slice = self.dims[0].saturating_mul(self.dims[1]).saturating_mul(self.element.size());
        match rest.n_bytes {
            _ if rest.is_zero => Ok(None),
            n if n < slice => Ok(Some(super::trailing_note(n))),
            n => Err(FormatError::Overlong { what: "voxels", stated: stated as u64, found: (stated + n) as u64 }),
        }
    }

    /// Size of all voxels as stored, bytes.
    pub(super) fn stored(&self) -> usize {
        usize::try_from(self.count().saturating_mul(self.element.size() as u64)).unwrap_or(usize::MAX)
    }

    /// Declared size of a volume: all voxels at four bytes each, or at more if they are stored as more.
    pub(super) fn declared(&self) -> usize {
        usize::try_from(self.count().saturating_mul(self.element.size().max(4) as u64)).unwrap_or(usize::MAX)
    }

    /// The labels of all voxels.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget; `NotALabel` if a value is not a whole number from 0 to 4294967295.
    pub(super) fn labels(&self, raw: &[u8], budget: &Budget) -> Result<Vec<u32>, FormatError> {
        let size = self.element.size();
        budget.charge_of::<u32>(raw.len() / size)?;
        let mut labels = Vec::with_capacity(raw.len() / size);
        let mut previous: Option<(&[u8], u32)> = None;
        for voxel in raw.chunks_exact(size) {
            let label = match previous {
                // Neighboring voxels usually have the same label.
                Some((same, label)) if same == voxel => label,
                _ => {
                    let value = self.element.real(little(voxel, self.order)) * self.slope + self.intercept;
                    self.label(value, labels.len())?
                }
            };
            previous = Some((voxel, label));
            labels.push(label);
        }
        Ok(labels)
    }

    /// The label for the value at position `at`.
    pub(super) fn label(&self, value: f64, at: usize) -> Result<u32, FormatError> {
        let whole = value.round();
        if (value - whole).abs() <= LABEL_TOLERANCE && (0.0..=f64::from(u32::MAX)).contains(&whole) {
            return Ok(whole as u32);
        }
        let [nx, ny, _] = self.dims.map(|d| d.max(1));
        Err(FormatError::NotALabel { voxel: [at % nx, at / nx % ny, at / (nx * ny)], value })
    }
}
