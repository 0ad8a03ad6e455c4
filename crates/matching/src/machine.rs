//! Machine-dependent state of the numerics, read once in a process.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

/// Rows and columns of the matrices that are multiplied: large enough that the product is computed in blocks.
const SIZE: usize = 160;

/// Reads the sizes of the processor's caches, which the numerics otherwise read when they first multiply large
/// matrices. The sizes determine the blocks in which products are summed and, on some processors, come from system
/// files. A process that gives up the right to open files must call this first, so that its answers have the same bits
/// as those of other processes.
///
/// # Cost
/// About a millisecond.
pub fn read_caches() {
    let factor = Mat::from_fn(SIZE, SIZE, |i, j| (i + 2 * j) as f64);
    let mut product = Mat::<f64>::zeros(SIZE, SIZE);
    matmul(product.as_mut(), Accum::Replace, &factor, &factor, 1.0, Par::Seq);
    std::hint::black_box(&product);
}
