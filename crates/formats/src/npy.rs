//! NumPy's `.npy`, version 1.0: one structured array.
//!
//! Source: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays". The array is read by
//! `numpy.load(file)` without pickling; `array["target"]` is a column.

use super::PairColumns;

const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
/// The header is padded to a multiple of this, so that the data are aligned.
const ALIGNMENT: usize = 64;

/// The columns as a one-dimensional structured array with the fields `source` and `target` (`<u4`), `confidence` (`<f8`),
/// `inlier` (`|b1`), `spread_mm` (`<f8`), `outlier` (`|u1`), and three each of `triangle` (`<u4`) and `barycentric`
/// (`<f8`), 62 bytes a row.
pub fn write_npy(pairs: &PairColumns<'_>) -> Vec<u8> {
    let n = pairs.len();
    let fields = "('source', '<u4'), ('target', '<u4'), ('confidence', '<f8'), ('inlier', '|b1'), \
         ('spread_mm', '<f8'), ('outlier', '|u1'), ('triangle', '<u4', (3,)), ('barycentric', '<f8', (3,))";
    let mut file = npy_file(fields, n);
    file.reserve(62 * n);
    for row in pairs.rows() {
        file.extend(row.source.to_le_bytes());
        file.extend(row.target.to_le_bytes());
        file.extend(row.confidence.to_le_bytes());
        file.push(row.inlier.into());
        file.extend(row.spread_mm.to_le_bytes());
        file.push(row.outlier);
        file.extend(row.triangle.iter().flat_map(|v| v.to_le_bytes()));
        file.extend(row.barycentric.iter().flat_map(|v| v.to_le_bytes()));
    }
    file
}

/// A file up to its data: the header of a one-dimensional structured array of `n` rows with these fields.
pub(super) fn npy_file(fields: &str, n: usize) -> Vec<u8> {
    with_header(&format!("[{fields}]"), &format!("({n},)"))
}

/// A file with numbers of one type, row by row.
pub(super) fn npy_array(kind: &str, shape: &[usize], data: Vec<u8>) -> Vec<u8> {
    let shape: String = shape.iter().map(|n| format!("{n},")).collect();
    let mut file = with_header(&format!("'{kind}'"), &format!("({shape})"));
    file.extend(data);
    file
}

fn with_header(kind: &str, shape: &str) -> Vec<u8> {
    let mut header = format!("{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}");
    let begin = MAGIC.len() + 2;
    let padded = (begin + header.len() + 1).next_multiple_of(ALIGNMENT);
    header.extend(std::iter::repeat_n(' ', padded - begin - header.len() - 1));
    header.push('\n');
    let mut file = MAGIC.to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.into_bytes());
    file
}
