//! Normative scores adjusted for covariates: the group's values are regressed on them by least squares at every vertex.
//!
//! With the design `X` of the members, `n × p`, and the row `x` of the subject, the deviation from the prediction has the
//! standard deviation `σ √(1 + x (XᵀX)⁻¹ xᵀ)`, with `n − p` degrees of freedom. The fit without member `i`, whose residual
//! is `e` and whose leverage is `h`, predicts it with the deviation `e / (1 − h)` and the standard deviation `σ / √(1 − h)`,
//! and its sum of squares is smaller by `e² / (1 − h)`, so nothing is fitted again.
//!
//! Source: Cook, Weisberg 1982, *Residuals and influence in regression*, section 2.2.

use super::standardized;
use crate::statistics::linear::{LinearModel, leverage};
use rayon::prelude::*;

/// A prediction for one subject, and the fit behind it.
#[derive(Debug, Clone)]
pub(super) struct Regression {
    /// The prediction at each vertex.
    pub(super) expected: Vec<f64>,
    /// Sum of the squared residuals at each vertex.
    pub(super) squares: Vec<f64>,
    /// `n − p`.
    degrees: f64,
    /// `x (XᵀX)⁻¹ xᵀ` of the subject.
    leverage: f64,
    /// `1 − h` of each member.
    free: Vec<f64>,
}

impl Regression {
    /// The prediction for a subject with the row `own` of the design, and the residuals of each member at each vertex.
    /// `values`: those of each row of `model`, by vertex. `O(n p V)`.
    pub(super) fn new(values: &[Vec<f64>], model: &LinearModel, own: &[f64]) -> (Self, Vec<Vec<f64>>) {
        let n_vertices = values.first().map_or(0, Vec::len);
        let shares = model.observation_weights(own);
        let each: Vec<(f64, Vec<f64>)> = (0..n_vertices)
            .into_par_iter()
            .map(|v| {
                let y: Vec<f64> = values.iter().map(|of| of[v]).collect();
                (shares.iter().zip(&y).map(|(share, y)| share * y).sum(), model.residuals(&y))
            })
            .collect();
        let residuals = (0..values.len()).map(|i| each.iter().map(|(_, rest)| rest[i]).collect()).collect();
        let regression = Regression {
            expected: each.iter().map(|(expected, _)| *expected).collect(),
            squares: each.iter().map(|(_, rest)| rest.iter().map(|e| e * e).sum()).collect(),
            degrees: model.degrees(),
            leverage: leverage(&shares),
            free: model.free().to_vec(),
        };
        (regression, residuals)
    }

    /// The scores of the subject, whose values are `own`.
    pub(super) fn scores(&self, own: &[f64], weights: &[f64]) -> Vec<f64> {
        let error = (1.0 + self.leverage).sqrt();
        standardized(|v| own[v] - self.expected[v], &self.squares, self.degrees, error, weights)
    }

    /// The scores of a member, by its residuals, against a fit to the others.
    pub(super) fn left_out(&self, member: usize, residuals: &[f64], weights: &[f64]) -> Vec<f64> {
        let free = self.free[member];
        let squares: Vec<f64> =
            self.squares.iter().zip(residuals).map(|(sum, e)| (sum - e * e / free).max(0.0)).collect();
        standardized(|v| residuals[v] / free, &squares, self.degrees - 1.0, free.sqrt().recip(), weights)
    }
}
