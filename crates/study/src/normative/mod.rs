//! Compares one subject with a group at every vertex: normative scores, a screening for lesions, and what both give for
//! subjects that were left out of the group.
//!
//! The score of a value `y` against `n` values of mean `m` is `(y − m) / (s √(1 + 1/n))`, which accounts for the error of
//! the mean, as a quantile of the standard normal distribution with the same tail probability under Student's t. The
//! variance `s²` is moderated: each vertex has few values, so its variance is drawn towards the variance of all vertices
//! by as much as the variances differ from each other less than their sampling error allows ([`variance`]).
//!
//! Adjusted for covariates, the mean is the prediction of a regression on them at the covariates of the subject
//! ([`regression`]).
//!
//! Every member of the group is scored against the others in the same way. The largest absolute scores of the members
//! bound the largest score of a further subject; their rank among them is its family-wise p-value.
//!
//! Sources: Geisser 1993, *Predictive inference* (the prediction of one further value); Smyth, Statistical Applications in
//! Genetics and Molecular Biology 3, 2004 (moderated t); Vovk et al. 2005, *Algorithmic learning in a random world* (ranks
//! as p-values).

mod regression;
mod variance;

use crate::statistics::linear::LinearModel;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;
use regression::Regression;
use serde::{Deserialize, Serialize};
use statrs::distribution::{Continuous, ContinuousCDF, Normal, StudentsT};
use variance::Moderation;

/// Largest absolute score: tail probabilities beyond it are below the smallest number.
const LARGEST: f64 = 37.0;
/// Degrees of freedom from which Student's t is taken as normal.
const NORMAL_FROM: f64 = 1e5;

/// The values of a group at every vertex.
#[derive(Debug, Clone)]
pub struct Norm {
    /// Weight of each vertex, its share of the area.
    weights: Vec<f64>,
    /// Values of each member, by vertex; with covariates, the residuals of its values.
    values: Vec<Vec<f64>>,
    expected: Expected,
}

/// The values that are expected of a further subject.
#[derive(Debug, Clone)]
enum Expected {
    /// The mean of the members.
    Mean(Moments),
    /// The prediction at the covariates of the subject.
    Prediction(Regression),
}

/// Mean and sum of squares about it, at each vertex.
#[derive(Debug, Clone)]
struct Moments {
    n: usize,
    mean: Vec<f64>,
    squares: Vec<f64>,
}

/// How far the scores of left-out members are standard normal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Calibration {
    /// Members, each scored against the others.
    pub subjects: usize,
    /// Mean of their scores over members and area; 0 if calibrated.
    pub mean: f64,
    /// Root mean square of their scores; 1 if calibrated.
    pub rms: f64,
    /// Share of the area, over all members, with an absolute score above 1.96; 0.05 if calibrated.
    pub beyond_1_96: f64,
    /// Share above 2.576; 0.01 if calibrated.
    pub beyond_2_576: f64,
}

/// Origin of a bound of the largest score.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BoundOrigin {
    /// A largest score of a left-out member, by rank: needs no distribution.
    Rank,
    /// Fitted to the largest scores of all left-out members, because there are too few members for a rank.
    Fitted,
}

/// A bound that the largest absolute score of a further subject exceeds with a given probability.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Bound {
    /// The bound.
    pub score: f64,
    /// Probability that a subject of the group's population exceeds it anywhere.
    pub level: f64,
    /// Its origin.
    pub origin: BoundOrigin,
}

/// The members, each scored against the others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeaveOneOut {
    /// How far the scores are standard.
    pub calibration: Calibration,
    /// The largest absolute score of each member.
    pub largest: Vec<f64>,
}

impl Norm {
    /// The group whose members have these values at every vertex; `weights`: the share of the area at each vertex.
    /// `None` for fewer than four members, or if no two differ.
    pub fn new(values: Vec<Vec<f64>>, weights: Vec<f64>) -> Option<Self> {
        let moments = Moments::of(&values, weights.len());
        // Equal values leave a sum of rounding errors.
        let varies = moments.squares.iter().zip(&moments.mean).any(|(sum, mean)| *sum > 1e-20 * (mean * mean));
        (values.len() >= 4 && varies).then_some(Norm { weights, values, expected: Expected::Mean(moments) })
    }

    /// The same group, for a subject with the row `own` of the members' design `model`. `None` if no residuals differ.
    pub(crate) fn adjusted(values: &[Vec<f64>], weights: Vec<f64>, model: &LinearModel, own: &[f64]) -> Option<Self> {
        let (regression, residuals) = Regression::new(values, model, own);
        let size = values.iter().flatten().fold(0.0, |most, y: &f64| f64::max(most, y.abs()));
        let varies = regression.squares.iter().any(|sum| *sum > 1e-20 * size * size);
        let expected = Expected::Prediction(regression);
        varies.then_some(Norm { weights, values: residuals, expected })
    }

    /// Number of members.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there are no members, which [`Norm::new`] excludes.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The values that are expected of the subject, at each vertex: the mean of the members, or the prediction at its
    /// covariates.
    pub fn expected(&self) -> &[f64] {
        match &self.expected {
            Expected::Mean(moments) => &moments.mean,
            Expected::Prediction(regression) => &regression.expected,
        }
    }

    /// The scores of a subject that is no member, at each vertex.
    pub fn scores(&self, own: &[f64]) -> Vec<f64> {
        match &self.expected {
            Expected::Mean(moments) => moments.scores(own, &self.weights),
            Expected::Prediction(regression) => regression.scores(own, &self.weights),
        }
    }

    /// Scores every member against the others.
    ///
    /// # Errors
    /// [`Cancelled`].
    ///
    /// # Cost
    /// For `n` members and `V` vertices `O(n V)` quantiles of Student's t.
    pub fn leave_one_out(&self, observer: &dyn Observer) -> Result<LeaveOneOut, Cancelled> {
        let each: Vec<[f64; 5]> = self
            .values
            .par_iter()
            .enumerate()
            .map(|(member, own)| {
                checkpoint(observer)?;
                let scores = match &self.expected {
                    Expected::Mean(moments) => moments.without(own).scores(own, &self.weights),
                    Expected::Prediction(regression) => regression.left_out(member, own, &self.weights),
                };
                let mean = |of: &dyn Fn(f64) -> f64| {
                    scores.iter().zip(&self.weights).map(|(&z, weight)| weight * of(z)).sum::<f64>()
                };
                let beyond = |bound: f64| mean(&|z| f64::from(z.abs() > bound));
                Ok([mean(&|z| z), mean(&|z| z * z), beyond(1.96), beyond(2.576), largest(&scores)])
            })
            .collect::<Result<_, Cancelled>>()?;
        let mean = |k: usize| each.iter().map(|of| of[k]).sum::<f64>() / each.len() as f64;
        let calibration = Calibration {
            subjects: each.len(),
            mean: mean(0),
            rms: mean(1).sqrt(),
            beyond_1_96: mean(2),
            beyond_2_576: mean(3),
        };
        Ok(LeaveOneOut { calibration, largest: each.iter().map(|of| of[4]).collect() })
    }
}

/// The largest absolute score.
pub fn largest(scores: &[f64]) -> f64 {
    scores.iter().fold(0.0, |most, z| f64::max(most, z.abs()))
}

impl LeaveOneOut {
    /// The p-value of a largest absolute score: its rank among those of the members.
    pub fn p_of_largest(&self, score: f64) -> f64 {
        let more = self.largest.iter().filter(|&&of| of >= score).count();
        (more + 1) as f64 / (self.largest.len() + 1) as f64
    }

    /// The bound that a further subject exceeds anywhere with probability `level`.
    ///
    /// With at least `1 / level − 1` members it is one of their largest scores. With fewer, the number of independent
    /// scores is estimated from the largest scores of all: with `N` of them, `−ln(1 − p)` of the largest score's `p` is
    /// exponential with rate `N`, and the bound is a quantile of its predictive distribution, or the largest score of all if
    /// that is higher.
    pub fn bound(&self, level: f64) -> Bound {
        let n = self.largest.len();
        // At most this share of n + 1 subjects may lie above; without rounding upwards of what is a whole number.
        let above = ((n + 1) as f64 * level * (1.0 + 1e-12)).floor() as usize;
        if above > 0 {
            let mut sorted = self.largest.clone();
            sorted.sort_by(f64::total_cmp);
            return Bound { score: sorted[n - above], level, origin: BoundOrigin::Rank };
        }
        let normal = Normal::standard();
        let sum: f64 = self.largest.iter().map(|&score| -(-2.0 * normal.sf(score)).ln_1p()).sum();
        let rest = sum * ((1.0 - level).powf(-1.0 / n as f64) - 1.0);
        let tail = -(-rest).exp_m1() / 2.0;
        // Not below any of them, which the fit of a few scores may be.
        Bound { score: quantile(tail).max(largest(&self.largest)), level, origin: BoundOrigin::Fitted }
    }
}

impl Moments {
    fn of(values: &[Vec<f64>], n_vertices: usize) -> Self {
        let n = values.len();
        let mut mean = vec![0.0; n_vertices];
        for own in values {
            mean.iter_mut().zip(own).for_each(|(sum, y)| *sum += y / n as f64);
        }
        let mut squares = vec![0.0; n_vertices];
        for own in values {
            squares.iter_mut().zip(own).zip(&mean).for_each(|((sum, y), mean)| *sum += (y - mean).powi(2));
        }
        Moments { n, mean, squares }
    }

    /// Without a member.
    fn without(&self, own: &[f64]) -> Self {
        let n = self.n as f64;
        let mean = self.mean.iter().zip(own).map(|(mean, y)| (n * mean - y) / (n - 1.0)).collect();
        let less = |((sum, mean), y): ((&f64, &f64), &f64)| (sum - n / (n - 1.0) * (y - mean).powi(2)).max(0.0);
        let squares = self.squares.iter().zip(&self.mean).zip(own).map(less).collect();
        Moments { n: self.n - 1, mean, squares }
    }

    fn scores(&self, own: &[f64], weights: &[f64]) -> Vec<f64> {
        let error = (1.0 + 1.0 / self.n as f64).sqrt();
        standardized(|v| own[v] - self.mean[v], &self.squares, (self.n - 1) as f64, error, weights)
    }
}

/// Scores of deviations from what is expected. `squares`: sums of squared residuals at each vertex, of `degrees` degrees
/// of freedom; `error`: standard deviation of a deviation over that of a residual.
fn standardized(
    deviation: impl Fn(usize) -> f64,
    squares: &[f64],
    degrees: f64,
    error: f64,
    weights: &[f64],
) -> Vec<f64> {
    let variances: Vec<f64> = squares.iter().map(|sum| sum / degrees).collect();
    let prior = Moderation::of(&variances, weights, degrees);
    let students = Students::new(degrees + prior.degrees);
    let score = |v: usize| {
        let standard = prior.moderated(variances[v], degrees).sqrt() * error;
        if standard > 0.0 { students.score(deviation(v) / standard) } else { 0.0 }
    };
    (0..squares.len()).map(score).collect()
}

/// Student's t distribution, or the normal one in its limit.
struct Students(Option<StudentsT>);

impl Students {
    fn new(degrees: f64) -> Self {
        Students((degrees < NORMAL_FROM).then(|| StudentsT::new(0.0, 1.0, degrees).ok()).flatten())
    }

    /// The standard normal quantile with the tail probability of `t`.
    fn score(&self, t: f64) -> f64 {
        match &self.0 {
            None => t.clamp(-LARGEST, LARGEST),
            // Far below any bound and exact to three digits; tails are what matters.
            Some(students) => t.signum() * quantile(students.sf(t.abs())),
        }
    }
}

/// The standard normal quantile of an upper tail probability up to ½. The library's inverse is improved by a step of
/// Newton's method, relative to the tail.
fn quantile(tail: f64) -> f64 {
    let normal = Normal::standard();
    if tail < 1e-299 {
        return LARGEST;
    }
    let z = -normal.inverse_cdf(tail.min(0.5));
    let improved = z + (normal.sf(z) - tail) / normal.pdf(z);
    if improved.is_finite() { improved.clamp(0.0, LARGEST) } else { z.clamp(0.0, LARGEST) }
}

#[cfg(test)]
mod tests;
