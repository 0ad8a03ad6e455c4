//! Per-vertex arrays as a table without a mesh: CSV, NumPy and Arrow. Row `k` is vertex `k`.

use super::npy::npy_file;
use super::vertex_arrays::{VertexArray, VertexValues};
use std::fmt::Write;

/// Number of rows that every array has.
fn n_rows(arrays: &[VertexArray]) -> usize {
    arrays.iter().map(|array| array.values.len()).min().unwrap_or(0)
}

/// The arrays as CSV (RFC 4180): a header, then a line for each vertex; the first column, `vertex`, counts from 0.
pub fn write_csv(arrays: &[VertexArray]) -> Vec<u8> {
    let mut text = "vertex".to_owned();
    arrays.iter().for_each(|array| {
        let _ = write!(text, ",{}", array.name);
    });
    text.push_str("\r\n");
    for row in 0..n_rows(arrays) {
        let _ = write!(text, "{row}");
        for array in arrays {
            let _ = match &array.values {
                VertexValues::Int(v) => write!(text, ",{}", v[row]),
                VertexValues::Real(v) => write!(text, ",{}", v[row]),
                VertexValues::Byte(v) => write!(text, ",{}", v[row]),
            };
        }
        text.push_str("\r\n");
    }
    text.into_bytes()
}

/// The arrays as a one-dimensional structured NumPy array (`<i4`, `<f8`, `|u1`), a field for each.
pub fn write_npy_table(arrays: &[VertexArray]) -> Vec<u8> {
    let kinds = arrays.iter().map(|VertexArray { name, values }| {
        let kind = match values {
            VertexValues::Int(_) => "<i4",
            VertexValues::Real(_) => "<f8",
            VertexValues::Byte(_) => "|u1",
        };
        format!("('{name}', '{kind}')")
    });
    let n = n_rows(arrays);
    let mut file = npy_file(&kinds.collect::<Vec<_>>().join(", "), n);
    for row in 0..n {
        for array in arrays {
            match &array.values {
                VertexValues::Int(v) => file.extend(v[row].to_le_bytes()),
                VertexValues::Real(v) => file.extend(v[row].to_le_bytes()),
                VertexValues::Byte(v) => file.push(v[row]),
            }
        }
    }
    file
}
