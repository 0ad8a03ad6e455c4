//! The normal equations of a field whose observations have different precisions along and across a normal.
//!
//! The six products `Φᵀ diag(w) Φ`, one for each entry of a symmetric 3×3 matrix, share `Φ`. They are summed over
//! chunks of points that stay in the cache: for a few functions at a time, the values times each of the six weights are
//! packed side by side and multiplied with the values of all later functions. Passing over all points for every product
//! would wait for memory.

use faer::linalg::matmul::matmul;
use faer::{Accum, ColRef, Mat, MatMut, MatRef, Par};
use multiversion::multiversion;
use nalgebra::Matrix3;

/// Entries of a symmetric 3×3 matrix: row and column.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)];
/// Functions per panel, whose products with all others are computed at once.
const PANEL: usize = 16;
/// Points per chunk, whose values stay in the cache with and without weights.
const CHUNK: usize = 256;
/// Points transposed together: the doubles of a cache line.
const LINE: usize = 8;

/// The lower triangle of `Σ_i W_i ⊗ φ_i φ_iᵀ`, `3M × 3M`, axis by axis; numbers above the diagonal are arbitrary.
///
/// `values`: every function at every point, `n × M`; `precision`: `W_i`, symmetric, one per point. The order of
/// summation is the same in every call. Cost `O(n M²)`.
pub(super) fn weighted_gram(values: MatRef<'_, f64>, precision: &[Matrix3<f64>]) -> Mat<f64> {
    let (n, m) = (values.nrows(), values.ncols());
    let by_functions = if values.row_stride() == 1 { None } else { Some(values.to_owned()) };
    let values = by_functions.as_ref().map_or(values, Mat::as_ref);
    let weights: Vec<[f64; 6]> = precision.iter().map(|w| ENTRIES.map(|entry| w[entry])).collect();
    // Products of each panel with the functions from its first on: a row for each weight and function of the panel.
    let mut products: Vec<Mat<f64>> =
        (0..m).step_by(PANEL).map(|first| Mat::zeros(6 * PANEL.min(m - first), m - first)).collect();
    let mut packed = vec![0.0; 6 * PANEL * CHUNK.min(n)];
    for start in (0..n).step_by(CHUNK) {
        let weights = &weights[start..n.min(start + CHUNK)];
        let chunk = values.subrows(start, weights.len());
        for (first, products) in (0..m).step_by(PANEL).zip(&mut products) {
            let (n_rows, others) = (products.nrows(), chunk.subcols(first, products.ncols()));
            let functions: [&[f64]; PANEL] =
                std::array::from_fn(|k| if k < others.ncols() { contiguous(others.col(k)) } else { &[] });
            let packed = &mut packed[..n_rows * weights.len()];
            pack(&functions[..n_rows / 6], weights, packed);
            let packed = MatRef::from_column_major_slice(packed, n_rows, weights.len());
            matmul(products.as_mut(), Accum::Add, packed, others, 1.0, Par::Seq);
        }
    }
    let mut gram = Mat::zeros(3 * m, 3 * m);
    for (first, products) in (0..m).step_by(PANEL).zip(&products) {
        let size = products.nrows() / 6;
        for (w, &(a, b)) in ENTRIES.iter().enumerate() {
            let block = gram.as_mut().submatrix_mut(a * m, b * m, m, m);
            copy(products.as_ref().subrows(w * size, size), first, a != b, block);
        }
    }
    gram
}

/// Writes the products of the functions from `first` on with each other to the lower triangle of `block`, and to the
/// upper triangle if it `is_whole`.
fn copy(products: MatRef<'_, f64>, first: usize, is_whole: bool, mut block: MatMut<'_, f64>) {
    for k in 0..products.nrows() {
        for l in k..products.ncols() {
            block[(first + l, first + k)] = products[(k, l)];
        }
    }
    if is_whole {
        for l in 0..products.ncols() {
            for k in 0..products.nrows().min(l) {
                block[(first + k, first + l)] = products[(k, l)];
            }
        }
    }
}

/// The numbers of a column.
fn contiguous(column: ColRef<'_, f64>) -> &[f64] {
    column.try_as_col_major().map_or(&[], |column| column.as_slice())
}

/// Writes `w φ` of every point, function by function for each of its weights, to `packed`.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn pack(functions: &[&[f64]], weights: &[[f64; 6]], packed: &mut [f64]) {
    let size = functions.len();
    let mut points = [[0.0; PANEL]; LINE];
    let lines = weights.chunks(LINE).zip(packed.chunks_mut(6 * size * LINE)).enumerate();
    for (line, (weights, packed)) in lines {
        for (k, values) in functions.iter().enumerate() {
            for (point, value) in points.iter_mut().zip(&values[line * LINE..]) {
                point[k] = *value;
            }
        }
        for ((point, weights), packed) in points.iter().zip(weights).zip(packed.chunks_exact_mut(6 * size)) {
            if size == PANEL {
                for (weight, packed) in weights.iter().zip(packed.chunks_exact_mut(PANEL)) {
                    for k in 0..PANEL {
                        packed[k] = weight * point[k];
                    }
                }
            } else {
                for (weight, packed) in weights.iter().zip(packed.chunks_exact_mut(size)) {
                    for (packed, value) in packed.iter_mut().zip(point) {
                        *packed = weight * value;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::numbers;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_matrix_is_its_sum_over_points(seed in any::<u64>(), n in 1usize..600, m in 1usize..40) {
            let mut number = numbers(seed);
            let values = Mat::from_fn(n, m, |_, _| number() - 0.5);
            let precision: Vec<Matrix3<f64>> = (0..n)
                .map(|_| {
                    let any = Matrix3::from_fn(|_, _| number());
                    any + any.transpose()
                })
                .collect();
            let gram = weighted_gram(values.as_ref(), &precision);
            for (row, column) in (0..3 * m).flat_map(|row| (0..=row).map(move |column| (row, column))) {
                let ((a, k), (b, l)) = ((row / m, row % m), (column / m, column % m));
                let expected: f64 = (0..n).map(|i| precision[i][(a, b)] * values[(i, k)] * values[(i, l)]).sum();
                prop_assert!((gram[(row, column)] - expected).abs() < 1e-10, "{row} {column}");
            }
        }
    }
}
