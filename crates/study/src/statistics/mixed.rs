//! The mixed model of visits: a random intercept for each subject, by restricted maximum likelihood.
//!
//! The model is `y = X β + b + ε` with a `b ~ N(0, λσ²)` for each subject and `ε ~ N(0, σ²)`. For a given `λ`
//! everything is in closed form, because the covariance of a subject with `m` visits, `σ²(I + λ 11ᵀ)`, has the inverse
//! `(I − λ/(1+λm) 11ᵀ)/σ²`. The remaining problem is a maximum over one number. Wald tests use the normal distribution,
//! so p-values are too small for few subjects.
//!
//! Sources: Laird, Ware, *Random-effects models for longitudinal data*, Biometrics 38, 1982; Lindstrom, Bates 1988 (the
//! profiled likelihood).

use super::VertexValues;
use faer::Mat;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal};

/// Steps of the search over the share of the variance that is between subjects, and of its refinement.
const COARSE: usize = 40;
const FINE: usize = 60;
/// Largest share: beyond it, visits of a subject do not differ.
const MAX_SHARE: f64 = 0.9999;

/// A contrast at each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct MixedMap {
    /// Value.
    pub effect: Vec<f64>,
    /// Standard error.
    pub se: Vec<f64>,
    /// Value over standard error.
    pub z: Vec<f64>,
    /// Two-sided p.
    pub p: Vec<f64>,
    /// Share of the variance between subjects, `λ / (1 + λ)`.
    pub between: Vec<f64>,
}

/// A design with visits of subjects.
#[derive(Debug, Clone)]
pub struct MixedModel {
    x: DMatrix<f64>,
    squares: DMatrix<f64>,
    /// Rows of each subject.
    groups: Vec<Vec<usize>>,
    /// Sum of the rows of each subject.
    sums: Vec<DVector<f64>>,
}

/// The fit of one vertex.
struct Fit {
    beta: DVector<f64>,
    covariance: DMatrix<f64>,
    criterion: f64,
}

impl MixedModel {
    /// A design; `subjects` names the subject of each row.
    pub fn new(matrix: &Mat<f64>, subjects: &[usize]) -> Self {
        let x = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| matrix[(i, k)]);
        let n_groups = subjects.iter().max().map_or(0, |last| last + 1);
        let mut groups = vec![Vec::new(); n_groups];
        subjects.iter().enumerate().for_each(|(row, &subject)| groups[subject].push(row));
        groups.retain(|rows| !rows.is_empty());
        let sum = |rows: &Vec<usize>| rows.iter().map(|&i| x.row(i).transpose()).sum();
        MixedModel { squares: x.transpose() * &x, sums: groups.iter().map(sum).collect(), groups, x }
    }

    /// The restricted likelihood and the coefficients for a share of the variance between subjects.
    fn fit(&self, y: &DVector<f64>, product: &DVector<f64>, of_y: &[f64], between: f64) -> Option<Fit> {
        let lambda = between / (1.0 - between);
        let (mut a, mut b, mut c) = (self.squares.clone(), product.clone(), y.norm_squared());
        let mut log_determinant = 0.0;
        for ((rows, sum), y) in self.groups.iter().zip(&self.sums).zip(of_y) {
            let m = rows.len() as f64;
            let weight = lambda / (1.0 + lambda * m);
            a.ger(-weight, sum, sum, 1.0);
            b.axpy(-weight * y, sum, 1.0);
            c -= weight * y * y;
            log_determinant += (1.0 + lambda * m).ln();
        }
        let decomposed = a.cholesky()?;
        let beta = decomposed.solve(&b);
        let degrees = (self.x.nrows() - self.x.ncols()) as f64;
        let variance = ((c - b.dot(&beta)) / degrees).max(f64::MIN_POSITIVE);
        let criterion = degrees * variance.ln() + log_determinant + decomposed.ln_determinant();
        Some(Fit { beta, covariance: decomposed.inverse() * variance, criterion })
    }

    /// The fit of greatest restricted likelihood.
    fn best(&self, y: &[f64], observer: &dyn Observer) -> Result<Option<(Fit, f64)>, Cancelled> {
        let y = DVector::from_column_slice(y);
        let product = self.x.transpose() * &y;
        let of_y: Vec<f64> = self.groups.iter().map(|rows| rows.iter().map(|&i| y[i]).sum()).collect();
        let criterion = |share: f64| {
            checkpoint(observer)?;
            Ok(self.fit(&y, &product, &of_y, share).map_or(f64::INFINITY, |fit| fit.criterion))
        };
        let at = |k: usize| MAX_SHARE * k as f64 / COARSE as f64;
        let values: Vec<f64> = (0..=COARSE).map(|k| criterion(at(k))).collect::<Result<_, Cancelled>>()?;
        let best = (0..=COARSE).fold(0, |best, k| if values[k] < values[best] { k } else { best });
        let (mut low, mut high) = (at(best.saturating_sub(1)), at((best + 1).min(COARSE)));
        // Golden section.
        let ratio = (5f64.sqrt() - 1.0) / 2.0;
        for _ in 0..FINE {
            let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
            if criterion(a)? <= criterion(b)? { high = b } else { low = a }
        }
        let mut share = f64::midpoint(low, high);
        // The case of no variance between subjects is an end of the interval, which the golden section only approaches.
        if criterion(0.0)? <= criterion(share)? {
            share = 0.0;
        }
        Ok(self.fit(&y, &product, &of_y, share).map(|fit| (fit, share)))
    }

    /// A contrast at every vertex; about a hundred fits each, `O(subjects · p²)`.
    ///
    /// # Errors
    /// [`Cancelled`]; the observer is asked before every fit.
    pub fn contrast(
        &self,
        values: &VertexValues,
        contrast: &[f64],
        observer: &dyn Observer,
    ) -> Result<MixedMap, Cancelled> {
        let (c, normal) = (DVector::from_column_slice(contrast), Normal::standard());
        let each: Vec<[f64; 5]> = values
            .vertices()
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|y| {
                let Some((fit, between)) = self.best(y, observer)? else { return Ok([0.0, 0.0, 0.0, 1.0, 0.0]) };
                let (effect, se) = (c.dot(&fit.beta), (c.transpose() * &fit.covariance * &c)[0].sqrt());
                let z = if se > 0.0 { effect / se } else { 0.0 };
                Ok([effect, se, z, 2.0 * normal.sf(z.abs()), between])
            })
            .collect::<Result<_, Cancelled>>()?;
        let column = |k: usize| each.iter().map(|row| row[k]).collect();
        Ok(MixedMap { effect: column(0), se: column(1), z: column(2), p: column(3), between: column(4) })
    }
}
