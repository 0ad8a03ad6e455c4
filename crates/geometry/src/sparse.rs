//! Sparse symmetric positive definite systems, by Cholesky factorization.
//!
//! Only this module of the workspace uses faer's generic solvers, so that they are compiled once.

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{Argsort, Pair, SparseColMat, SymbolicSparseColMat};
use faer::{Mat, Side};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};

/// Row and column of an entry of the lower triangle, diagonal included.
pub type Place = Pair<usize, usize>;

/// The pattern of a matrix and the order in which its rows are eliminated, shared by all matrices of that pattern.
pub struct CholeskyPattern {
    places: SymbolicSparseColMat<usize>,
    /// Permutation from the given order of the entries to the order in the matrix.
    order: Argsort<usize>,
    factor: SymbolicLlt<usize>,
}

/// A factorized matrix.
pub struct Cholesky(Llt<usize, f64>);

impl CholeskyPattern {
    /// The pattern of an `n × n` matrix with entries at `places`; entries at the same place add up. `None` if the
    /// entries are too many to be counted. Cost `O(places log places)`.
    pub fn new(n: usize, places: &[Place]) -> Option<Self> {
        let (places, order) = SymbolicSparseColMat::try_new_from_indices(n, n, places).ok()?;
        let factor = SymbolicLlt::try_new(places.as_ref(), Side::Lower).ok()?;
        Some(CholeskyPattern { places, order, factor })
    }

    /// Factorizes the matrix with `values` at the places of the pattern. `None` if it is not positive definite. Cost
    /// about `O(n^1.5)` on surfaces, on one thread.
    pub fn factorize(&self, values: &[f64]) -> Option<Cholesky> {
        let matrix = SparseColMat::new_from_argsort(self.places.clone(), &self.order, values).ok()?;
        Llt::try_new_with_symbolic(self.factor.clone(), matrix.as_ref(), Side::Lower).ok().map(Cholesky)
    }
}

/// The `n × n` matrix with `values` at `places`, factorized. `None` if it is not positive definite.
///
/// # Errors
/// [`Cancelled`]; the observer is asked before and after the order of elimination is found, and after the factorization.
pub fn factorized(
    n: usize,
    places: &[Place],
    values: &[f64],
    observer: &dyn Observer,
) -> Result<Option<Cholesky>, Cancelled> {
    checkpoint_within(observer)?;
    let pattern = CholeskyPattern::new(n, places);
    checkpoint_within(observer)?;
    let factor = pattern.and_then(|pattern| pattern.factorize(values));
    checkpoint_within(observer)?;
    Ok(factor)
}

impl Cholesky {
    /// The solution for `n_columns` right-hand sides, `n × n_columns`; `right_side` gives the value at a row and
    /// column.
    pub fn solve(&self, n: usize, n_columns: usize, right_side: &dyn Fn(usize, usize) -> f64) -> Mat<f64> {
        self.0.solve(&Mat::from_fn(n, n_columns, right_side))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_at_the_same_place_add_up_and_the_solution_solves_the_system() {
        // [[4, -1, 0], [-1, 3, -1], [0, -1, 2]], its first diagonal entry in two parts.
        let places = [(0, 0), (0, 0), (1, 0), (1, 1), (2, 1), (2, 2)].map(|(row, column)| Place::new(row, column));
        let pattern = CholeskyPattern::new(3, &places).unwrap();
        let x =
            pattern.factorize(&[1.0, 3.0, -1.0, 3.0, -1.0, 2.0]).unwrap().solve(3, 1, &|row, _| [2.0, 2.0, 4.0][row]);
        for (row, expected) in [1.0, 2.0, 3.0].into_iter().enumerate() {
            assert!((x[(row, 0)] - expected).abs() < 1e-12);
        }
        assert!(pattern.factorize(&[1.0, 3.0, -5.0, 3.0, -1.0, 2.0]).is_none(), "an indefinite matrix");
    }
}
