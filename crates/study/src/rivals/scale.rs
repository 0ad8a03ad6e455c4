//! The scale on which the shapes of reliable subjects differ: the variance in each independent direction.
//!
//! The squared distances of all pairs give, doubly centered, the inner products of the shapes around their mean (classical
//! scaling). Their trace is the variance `s²` times `n − 1`. Variances `λ` of unequal directions count as the number
//! `(Σ λ)² / Σ λ²` of equal ones (Satterthwaite), estimated from the same products: at most `n − 1`, and below the true number
//! where subjects are few, so that evidence is understated rather than overstated.
//!
//! Sources: Torgerson, *Multidimensional scaling*, Psychometrika 17, 1952; Satterthwaite, *An approximate distribution of estimates of
//! variance components*, Biometrics Bulletin 2, 1946.

use super::shapes::Shape;
use rayon::prelude::*;

/// Variance, mm², below which shapes are copies of each other: positions in 32 bits are exact to about 1e-5 mm.
const ROUNDING: f64 = 1e-9;

/// The scale of differences.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    /// Variance of all directions together, mm².
    pub(super) variance: f64,
    /// Effective number of independent directions.
    pub(super) directions: f64,
}

impl Scale {
    /// From at least two shapes; `None` if these do not differ.
    pub(super) fn of(shapes: &[Shape]) -> Option<Self> {
        let n = shapes.len();
        let squared: Vec<f64> =
            (0..n * n).into_par_iter().map(|k| shapes[k / n].squared_distance(&shapes[k % n])).collect();
        let means: Vec<f64> = squared.chunks_exact(n).map(|row| row.iter().sum::<f64>() / n as f64).collect();
        let whole = means.iter().sum::<f64>() / n as f64;
        let product = |k: usize| -0.5 * (squared[k] - means[k / n] - means[k % n] + whole);
        let trace: f64 = (0..n).map(|k| product(k * n + k)).sum();
        let of_squares: f64 = (0..n * n).map(|k| product(k).powi(2)).sum();
        let variance = trace / (n as f64 - 1.0);
        (variance > ROUNDING).then(|| Scale { variance, directions: (trace * trace / of_squares).max(1.0) })
    }

    /// Half the inverse variance in one direction: the factor of a squared distance in a Gaussian log-likelihood.
    pub(super) fn half_precision(&self) -> f64 {
        self.directions / (2.0 * self.variance)
    }
}
