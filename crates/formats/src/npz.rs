//! NumPy's `.npz`: an uncompressed zip archive with a `.npy` array for each column. `numpy.load(file)["target"]` is a
//! column.
//!
//! Equal columns give equal bytes: entries carry no time.

use super::PairColumns;
use super::npy::npy_array;
use super::vertex_arrays::{VertexArray, VertexValues};
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The columns of [`super::npy::write_npy`], an array for each; `triangle` and `barycentric` have three numbers per
/// row.
///
/// # Errors
/// Errors of the archive, such as more than 4 GiB.
pub fn write_npz(pairs: &PairColumns<'_>) -> std::io::Result<Vec<u8>> {
    let n = pairs.len();
    let four = |v: &[u32]| v.iter().flat_map(|x| x.to_le_bytes()).collect();
    let eight = |v: &[f64]| v.iter().flat_map(|x| x.to_le_bytes()).collect();
    archive(&[
        ("source", npy_array("<u4", &[n], four(&pairs.source[..n]))),
        ("target", npy_array("<u4", &[n], four(&pairs.target[..n]))),
        ("confidence", npy_array("<f8", &[n], eight(&pairs.confidence[..n]))),
        ("inlier", npy_array("|b1", &[n], pairs.inlier[..n].iter().map(|&bit| bit.into()).collect())),
        ("spread_mm", npy_array("<f8", &[n], eight(&pairs.spread_mm[..n]))),
        ("outlier", npy_array("|u1", &[n], pairs.outlier[..n].to_vec())),
        ("triangle", npy_array("<u4", &[n, 3], four(pairs.triangle[..n].as_flattened()))),
        ("barycentric", npy_array("<f8", &[n, 3], eight(pairs.barycentric[..n].as_flattened()))),
    ])
}

/// Per-vertex arrays, row `k` is vertex `k`.
///
/// # Errors
/// The errors of [`write_npz`].
pub fn write_npz_table(arrays: &[VertexArray]) -> std::io::Result<Vec<u8>> {
    let columns: Vec<(&str, Vec<u8>)> = arrays
        .iter()
        .map(|VertexArray { name, values }| {
            let shape = [values.len()];
            let array = match values {
                VertexValues::Int(v) => npy_array("<i4", &shape, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                VertexValues::Real(v) => npy_array("<f8", &shape, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                VertexValues::Byte(v) => npy_array("|u1", &shape, v.clone()),
            };
            (*name, array)
        })
        .collect();
    archive(&columns)
}

fn archive(arrays: &[(&str, Vec<u8>)]) -> std::io::Result<Vec<u8>> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default());
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, array) in arrays {
        archive.start_file(format!("{name}.npy"), options)?;
        archive.write_all(array)?;
    }
    Ok(archive.finish()?.into_inner())
}
