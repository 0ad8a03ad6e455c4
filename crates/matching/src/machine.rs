//! What the numerics ask of the machine, once in a process.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

/// Rows and columns of the matrices that are multiplied: large enough that the product is computed in blocks.
const SIZE: usize = 160;

/// Makes the numerics read the sizes of the processor's caches now, which they otherwise do when they first multiply large
/// matrices. The sizes decide in which blocks products are summed and, on some processors, are read from files of the system:
/// a process that gives up the right to open files calls this before, so that its answers have the same bits as those of others.
///
/// # Cost
/// About a millisecond.
pub fn read_caches() {
    let factor = Mat::from_fn(SIZE, SIZE, |i, j| (i + 2 * j) as f64);
    let mut product = Mat::<f64>::zeros(SIZE, SIZE);
    matmul(product.as_mut(), Accum::Replace, &factor, &factor, 1.0, Par::Seq);
    std::hint::black_box(&product);
}
