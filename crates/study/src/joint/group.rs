//! Gaussian models of the group without some of its subjects.
//!
//! A shape is the mean, plus modes with scores of given variances, plus an isotropic rest: probabilistic principal
//! components, whose parameters maximize the likelihood for a number of modes. Source: Tipping, Bishop, *Probabilistic
//! principal component analysis*, Journal of the Royal Statistical Society B 61, 1999.

use super::JointSettings;
use crate::error::StudyError;
use crate::model::{components, explaining};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use nalgebra::{Point3, Vector3};

/// Aligned shapes, from which models of some of them are made.
pub(super) struct Group {
    /// Coordinates of the shapes, a column each, times the roots of the weights.
    rows: Mat<f64>,
    gram: Mat<f64>,
    roots: Vec<f64>,
}

/// A Gaussian model of shapes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GroupModel {
    /// The mean shape, mm.
    pub(super) mean: Vec<Point3<f64>>,
    /// A displacement of each vertex for each mode, orthonormal in the metric, dimensionless.
    pub(super) modes: Vec<Vec<Vector3<f64>>>,
    /// Variance of the score of each mode, mm².
    pub(super) variances: Vec<f64>,
    /// Mean variance of the components beyond the modes, mm².
    pub(super) rest: f64,
}

impl Group {
    /// `weights`: shares of the area, as in [`crate::align`].
    ///
    /// # Cost
    /// `O(n² V)` for `n` shapes of `V` vertices.
    pub(super) fn new(aligned: &[Vec<Point3<f64>>], weights: &[f64]) -> Self {
        let (n, v) = (aligned.len(), weights.len());
        let roots: Vec<f64> = weights.iter().map(|w| w.max(f64::MIN_POSITIVE).sqrt()).collect();
        let rows = Mat::from_fn(3 * v, n, |k, i| aligned[i][k / 3][k % 3] * roots[k / 3]);
        let mut gram = Mat::zeros(n, n);
        matmul(gram.as_mut(), Accum::Replace, rows.transpose(), rows.as_ref(), 1.0, Par::Seq);
        Group { rows, gram, roots }
    }

    /// The model of the shapes `of`, at least two.
    ///
    /// # Errors
    /// [`StudyError::Decomposition`].
    ///
    /// # Cost
    /// `O(m³ + m V M)` for `m` shapes and `M` modes.
    pub(super) fn model(&self, of: &[usize], settings: &JointSettings) -> Result<GroupModel, StudyError> {
        let (n, m, v) = (self.gram.nrows(), of.len(), self.roots.len());
        let (values, vectors) = components(self.gram.as_ref(), of)?;
        let variances: Vec<f64> = values.iter().map(|value| value / (m - 1) as f64).collect();
        let most = ((settings.most_modes * m as f64) as usize).max(1);
        let n_modes = explaining(&variances, settings.explained).min(most).min(variances.len());
        let n_rest = (variances.len() - n_modes).max(1);
        let rest = variances[n_modes..].iter().sum::<f64>() / n_rest as f64;
        // Modes and mean are combinations of the shapes.
        let mut mixing = Mat::zeros(n, n_modes + 1);
        for (row, &i) in of.iter().enumerate() {
            for k in (0..n_modes).filter(|&k| values[k] > 0.0) {
                mixing[(i, k)] = vectors[(row, k)] / values[k].sqrt();
            }
            mixing[(i, n_modes)] = 1.0 / m as f64;
        }
        let mut mixed = Mat::zeros(3 * v, n_modes + 1);
        matmul(mixed.as_mut(), Accum::Replace, self.rows.as_ref(), mixing.as_ref(), 1.0, Par::Seq);
        let at = |k: usize, v: usize| {
            Vector3::new(mixed[(3 * v, k)], mixed[(3 * v + 1, k)], mixed[(3 * v + 2, k)]) / self.roots[v]
        };
        Ok(GroupModel {
            mean: (0..v).map(|v| Point3::from(at(n_modes, v))).collect(),
            modes: (0..n_modes).map(|k| (0..v).map(|v| at(k, v)).collect()).collect(),
            variances: variances[..n_modes].to_vec(),
            rest,
        })
    }
}

impl GroupModel {
    /// Posterior mean of the scores of an aligned shape, mm: its projections on the modes, each shrunk by the share of
    /// the rest in its variance.
    pub(super) fn scores(&self, shape: &[Point3<f64>], weights: &[f64]) -> Vec<f64> {
        let score = |mode: &Vec<Vector3<f64>>| -> f64 {
            (0..shape.len()).map(|v| weights[v] * mode[v].dot(&(shape[v] - self.mean[v]))).sum()
        };
        let shrunk = |(mode, variance): (&Vec<Vector3<f64>>, &f64)| {
            let whole = variance + self.rest;
            if whole > 0.0 { score(mode) * variance / whole } else { 0.0 }
        };
        self.modes.iter().zip(&self.variances).map(shrunk).collect()
    }

    /// The shape with these scores.
    pub(super) fn shape(&self, scores: &[f64]) -> Vec<Point3<f64>> {
        let mut shape = self.mean.clone();
        for (mode, score) in self.modes.iter().zip(scores) {
            shape.iter_mut().zip(mode).for_each(|(p, d)| *p += d * *score);
        }
        shape
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shapes(n: usize) -> (Vec<Vec<Point3<f64>>>, Vec<f64>) {
        let at = |i: usize, v: usize| {
            let (i, v) = (i as f64, v as f64);
            Point3::new(
                v + (1.3 * i).sin() * (v - 2.0),
                (0.7 * i).cos() * v * v / 5.0,
                0.3 * (i * i + 2.0 * v * (i + 1.0)).sin(),
            )
        };
        let weights = [0.1, 0.3, 0.2, 0.15, 0.25].to_vec();
        ((0..n).map(|i| (0..weights.len()).map(|v| at(i, v)).collect()).collect(), weights)
    }

    /// The posterior by the covariance of all coordinates, from the definition of the model.
    fn by_covariance(model: &GroupModel, shape: &[Point3<f64>], weights: &[f64]) -> Vec<f64> {
        let (n, m) = (3 * shape.len(), model.modes.len());
        let root = |k: usize| weights[k / 3].sqrt();
        let modes = nalgebra::DMatrix::from_fn(n, m, |r, k| root(r) * model.modes[k][r / 3][r % 3]);
        let prior = nalgebra::DMatrix::from_diagonal(&nalgebra::DVector::from_vec(model.variances.clone()));
        let whole = &modes * &prior * modes.transpose() + nalgebra::DMatrix::identity(n, n) * model.rest;
        let difference =
            nalgebra::DVector::from_fn(n, |r, _| root(r) * (shape[r / 3][r % 3] - model.mean[r / 3][r % 3]));
        (prior * modes.transpose() * whole.try_inverse().unwrap() * difference).iter().copied().collect()
    }

    #[test]
    fn scores_are_the_posterior_under_the_covariance_of_all_coordinates() {
        let (shapes, weights) = shapes(12);
        let others: Vec<usize> = (1..12).collect();
        let settings = JointSettings { explained: 0.8, ..JointSettings::default() };
        let model = Group::new(&shapes, &weights).model(&others, &settings).unwrap();
        assert!(model.rest > 0.0 && !model.modes.is_empty());
        let (fast, slow) = (model.scores(&shapes[0], &weights), by_covariance(&model, &shapes[0], &weights));
        assert_eq!(fast.len(), slow.len());
        assert!(fast.iter().zip(&slow).all(|(a, b)| (a - b).abs() < 1e-9), "{fast:?} {slow:?}");
    }

    #[test]
    fn a_model_does_not_see_who_is_left_out() {
        let (mut shapes, weights) = shapes(9);
        let others = [0, 1, 3, 4, 6, 7, 8];
        let model = |shapes: &[Vec<Point3<f64>>]| {
            Group::new(shapes, &weights).model(&others, &JointSettings::default()).unwrap()
        };
        let before = model(&shapes);
        shapes[2].iter_mut().for_each(|p| p.x += 7.0);
        shapes[5][1].z -= 3.0;
        let after = model(&shapes);
        assert!(before.mean.iter().zip(&after.mean).all(|(a, b)| (a - b).norm() < 1e-9));
        let apart = |a: &GroupModel, b: &GroupModel| {
            a.variances.iter().zip(&b.variances).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        assert!(apart(&before, &after) < 1e-9);
        shapes[0][0].x += 1.0;
        assert!(apart(&before, &model(&shapes)) > 1e-3, "but it sees the others");
    }
}
