//! The shape model of a group: principal components of aligned shapes, and measures of the model's quality.
//!
//! With `n` subjects and many more coordinates, the components follow from the `n × n` matrix of inner products (Gram
//! matrix) of the centered shapes: its eigenvectors times the shapes are the modes. The matrix is summed over blocks of
//! vertices, so that only one block of all subjects is in memory; modes are summed over subjects. Leaving a subject out
//! removes a row and a column, so every leave-one-out validation needs the matrix alone. Singular values below about
//! 1e-8 of the largest are lost, which is below the precision of any surface. Of groups above 1,000 only the first
//! components are computed ([`many`]).
//!
//! Sources: Cootes et al., *Active shape models*, 1995; Turk, Pentland 1991 (the small matrix); Davies 2002, Styner et al.
//! 2003 (compactness, generalization, specificity); Tipping, Bishop 1999 (the distance outside the modes).

use crate::align::{Alignment, Shapes, WatchedShapes, points};
use crate::error::StudyError;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, Side};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::{Point3, Vector3};
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal};
use std::ops::Range;

/// Vertices per block: 10,000 subjects take 123 MB.
const BLOCK: usize = 512;
/// Rows of the Gram matrix per task.
const ROWS: usize = 64;
/// Largest group whose components are all computed; above it, [`many`] computes the first ones.
pub(crate) const COMPLETE: usize = 1000;
/// Number of subjects up to which each is left out alone; above it, a twentieth is left out at a time, and above
/// [`COMPLETE`] a fifth.
const LEAVE_ONE_OUT: usize = 200;
const FOLDS: usize = 20;
/// Number of random shapes for specificity.
const RANDOM_SHAPES: usize = 1000;
/// Share of the variance explained by the kept modes.
const KEPT_VARIANCE: f64 = 0.98;
const MAX_MODES: usize = 60;
/// Share of the variance of the modes whose scores a distance weighs individually.
const DISTANCE_VARIANCE: f64 = 0.9;

/// Aligned shapes, and who may stop their model.
struct Group<'a> {
    shapes: &'a dyn Shapes,
    alignment: &'a Alignment,
    observer: &'a dyn Observer,
}

/// Principal components of a group of aligned shapes, in the metric of [`crate::align`].
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeModel {
    /// Variance of each component, mm², descending; all `n − 1`. Above 1,000 subjects the first 256, and the mean of the
    /// others in place of each.
    pub variances: Vec<f64>,
    /// The first modes: a displacement of each vertex, orthonormal in the metric, dimensionless.
    pub modes: Vec<Vec<Vector3<f64>>>,
    /// Score of each subject on each computed component, mm, by subject.
    pub scores: Vec<Vec<f64>>,
    /// Quality of the model.
    pub quality: ModelQuality,
    /// Squared Mahalanobis distance of each subject from the model of the others: how unusual its shape is.
    pub left_out: Vec<f64>,
    /// For each further shape of [`ShapeModel::with_others`], the p-value of a shape as unusual.
    pub others_p: Vec<f64>,
    /// Number of components that the distance weighs individually.
    pub distance_modes: usize,
}

/// Quality of a model with 1, 2, … modes.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ModelQuality {
    /// Share of the variance explained by the modes.
    pub compactness: Vec<f64>,
    /// RMS distance of a subject from the nearest shape of a model of the others, mm, mean over subjects.
    pub generalization_mm: Vec<f64>,
    /// RMS distance of a random shape of the model from the nearest subject, mm, mean of 1,000.
    pub specificity_mm: Vec<f64>,
}

/// The coordinates of some vertices of a shape about the mean, in the metric of the alignment.
fn coordinates(
    shapes: &dyn Shapes,
    alignment: &Alignment,
    shape: usize,
    vertices: Range<usize>,
) -> Result<Vec<f64>, StudyError> {
    let read = points(&shapes.read(shape, vertices.clone())?);
    let place = &alignment.onto_mean[shape];
    let at = |(vertex, p): (usize, &Point3<f64>)| {
        (place.apply(p) - alignment.mean[vertex]) * alignment.weights[vertex].sqrt()
    };
    Ok(vertices.zip(&read).flat_map(|each| <[f64; 3]>::from(at(each))).collect())
}

/// Whether the subject farthest along a mode is on its negative side. The sign of a mode is arbitrary, and so chosen that
/// this subject is on the positive side.
fn is_reversed(scores: impl Iterator<Item = f64>) -> bool {
    scores.fold(0.0_f64, |farthest, score| if score.abs() > farthest.abs() { score } else { farthest }) < 0.0
}

/// Eigenvalues of a symmetric matrix, descending and at least 0, and eigenvectors.
fn eigen(matrix: MatRef<'_, f64>) -> Result<(Vec<f64>, Mat<f64>), StudyError> {
    let n = matrix.nrows();
    let found = matrix.self_adjoint_eigen(Side::Lower).map_err(|_| StudyError::Decomposition("its Gram matrix"))?;
    let (values, vectors) = (found.S().column_vector(), found.U());
    let values = (1..=n).map(|k| values[n - k].max(0.0)).collect();
    Ok((values, Mat::from_fn(n, n, |i, k| vectors[(i, n - 1 - k)])))
}

/// Inner products of all shapes with the first `n_members` about the mean, mm², a row for each shape, and the squared
/// norm of each shape.
///
/// # Errors
/// Errors of reading.
///
/// # Cost
/// `O(n · n_members · V)` for `n` shapes, and one read of every vertex.
fn gram(shapes: &dyn Shapes, alignment: &Alignment, n_members: usize) -> Result<(Mat<f64>, Vec<f64>), StudyError> {
    let (n, v) = (shapes.len(), shapes.n_vertices());
    let mut gram = Mat::<f64>::zeros(n, n_members);
    let mut norms = vec![0.0; n];
    for first in (0..v).step_by(BLOCK) {
        let vertices = first..v.min(first + BLOCK);
        let columns = 3 * vertices.len();
        let rows: Vec<Vec<f64>> = (0..n)
            .into_par_iter()
            .map(|shape| coordinates(shapes, alignment, shape, vertices.clone()))
            .collect::<Result<_, StudyError>>()?;
        norms.iter_mut().zip(&rows).for_each(|(norm, row)| *norm += row.iter().map(|x| x * x).sum::<f64>());
        // A shape is a column, so products run over contiguous numbers.
        let block = Mat::from_fn(columns, n, |k, shape| rows[shape][k]);
        drop(rows);
        let parts: Vec<Mat<f64>> = (0..n)
            .step_by(ROWS)
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|row| {
                let some = block.subcols(row, ROWS.min(n - row));
                let mut part = Mat::zeros(some.ncols(), n_members);
                let members = block.subcols(0, n_members);
                matmul(part.as_mut(), Accum::Replace, some.transpose(), members, 1.0, Par::Seq);
                part
            })
            .collect();
        for (k, part) in parts.iter().enumerate() {
            let mut rows = gram.subrows_mut(ROWS * k, part.nrows());
            rows += part;
        }
    }
    Ok((gram, norms))
}

/// Eigenvalues, descending, and eigenvectors of the centered matrix over some subjects.
pub(crate) fn components(gram: MatRef<'_, f64>, of: &[usize]) -> Result<(Vec<f64>, Mat<f64>), StudyError> {
    let n = of.len();
    let mean: Vec<f64> = of.iter().map(|&i| of.iter().map(|&j| gram[(i, j)]).sum::<f64>() / n as f64).collect();
    let whole = mean.iter().sum::<f64>() / n as f64;
    let centered = Mat::from_fn(n, n, |i, j| gram[(of[i], of[j])] - mean[i] - mean[j] + whole);
    let (mut values, mut vectors) = eigen(centered.as_ref())?;
    // The last eigenvalue belongs to the mean and is 0.
    values.truncate(n - 1);
    vectors.truncate(n, n - 1);
    Ok((values, vectors))
}

/// Scores of subjects that are not part of a model, and their squared distance from its mean.
struct LeftOut {
    variances: Vec<f64>,
    /// For each left-out subject: its index, its scores, its squared distance from the mean.
    subjects: Vec<(usize, Vec<f64>, f64)>,
}

/// The model of the members without those in `left`, which get scores, as do `scored` shapes. `gram`, `norms`: those of
/// [`gram()`].
fn leave_out(
    (gram, norms): (MatRef<'_, f64>, &[f64]),
    left: &[usize],
    scored: &[usize],
) -> Result<LeftOut, StudyError> {
    let n = gram.ncols();
    let others: Vec<usize> = (0..n).filter(|k| !left.contains(k)).collect();
    let m = others.len();
    let (values, vectors) = components(gram, &others)?;
    let mean_of = |i: usize| others.iter().map(|&j| gram[(i, j)]).sum::<f64>() / m as f64;
    let means: Vec<f64> = others.iter().map(|&j| mean_of(j)).collect();
    let whole = means.iter().sum::<f64>() / m as f64;
    let largest = values.first().copied().unwrap_or(0.0);
    let subjects = left.iter().chain(scored).map(|&i| {
        let mean = mean_of(i);
        let products: Vec<f64> = (0..m).map(|j| gram[(i, others[j])] - means[j] - mean + whole).collect();
        let scores = (0..values.len()).map(|k| {
            let along: f64 = (0..m).map(|j| vectors[(j, k)] * products[j]).sum();
            // A component without variance has no direction.
            if values[k] > 1e-14 * largest { along / values[k].sqrt() } else { 0.0 }
        });
        (i, scores.collect(), (norms[i] - 2.0 * mean + whole).max(0.0))
    });
    let subjects = subjects.collect();
    Ok(LeftOut { variances: values.iter().map(|value| value / (m - 1) as f64).collect(), subjects })
}

impl LeftOut {
    /// The squared Mahalanobis distance of each of its subjects.
    fn distances(&self, modes: usize) -> Vec<f64> {
        self.subjects.iter().map(|(_, scores, norm)| distance(scores, *norm, &self.variances, modes)).collect()
    }
}

/// Number of components that explain a given share of the variance.
pub(crate) fn explaining(variances: &[f64], share: f64) -> usize {
    let whole: f64 = variances.iter().sum();
    let mut sum = 0.0;
    let enough = variances.iter().position(|variance| {
        sum += variance;
        sum >= share * whole
    });
    enough.map_or(variances.len(), |k| k + 1)
}

/// Squared Mahalanobis distance: scores over their variances, plus the part unexplained by the first `modes` over the
/// mean variance of the rest.
fn distance(scores: &[f64], squared_norm: f64, variances: &[f64], modes: usize) -> f64 {
    let modes = modes.min(variances.len());
    let inside: f64 = (0..modes).filter(|&k| variances[k] > 0.0).map(|k| scores[k] * scores[k] / variances[k]).sum();
    let explained: f64 = scores[..modes].iter().map(|score| score * score).sum();
    let rest: Vec<f64> = variances[modes..].iter().copied().filter(|&variance| variance > 0.0).collect();
    let mean = rest.iter().sum::<f64>() / rest.len().max(1) as f64;
    let outside = if mean > 0.0 { (squared_norm - explained).max(0.0) / mean } else { 0.0 };
    inside + outside
}

impl ShapeModel {
    /// The model of aligned shapes. `seed` determines the random shapes of specificity.
    ///
    /// # Errors
    /// Errors of reading; [`StudyError::Decomposition`]; [`StudyError::Interrupted`].
    ///
    /// # Cost
    /// `O(n² V)` for inner products, `n` (at most 200; above, 20) eigenvalue decompositions of an `n × n` matrix, and
    /// one read of all shapes for the modes. Above 1,000 subjects, `O(n V)` for each of 256 components and of at most 84
    /// reads of all shapes.
    pub fn new(
        shapes: &dyn Shapes,
        alignment: &Alignment,
        seed: u64,
        observer: &dyn Observer,
    ) -> Result<Self, StudyError> {
        Self::with_others(shapes, alignment, alignment.onto_mean.len(), seed, observer)
    }

    /// The model of the first `n` of the shapes, and the p-value of an unusual shape of each of the others. `alignment`:
    /// the frame of the first `n`, with the transforms of all shapes onto its mean.
    ///
    /// # Errors
    /// As [`ShapeModel::new`].
    ///
    /// # Cost
    /// That of [`ShapeModel::new`], and for each other shape `O(n V)`, and `O(n²)` for each decomposition; above 1,000
    /// subjects, `O(V)` for each component.
    ///
    /// # Source
    /// Barber et al., *Predictive inference with the jackknife+*, Annals of Statistics 49, 2021: a member and another
    /// shape are compared by their distances from one model that has seen neither.
    pub fn with_others(
        shapes: &dyn Shapes,
        alignment: &Alignment,
        n: usize,
        seed: u64,
        observer: &dyn Observer,
    ) -> Result<Self, StudyError> {
        let shapes = &WatchedShapes { shapes, observer };
        if n > COMPLETE {
            return many::model(&Group { shapes, alignment, observer }, n, many::COMPONENTS, n_folds(n), seed);
        }
        let (gram, norms) = gram(shapes, alignment, n)?;
        let (values, mut vectors) = components(gram.as_ref(), &(0..n).collect::<Vec<_>>())?;
        for k in 0..vectors.ncols() {
            if is_reversed((0..n).map(|i| vectors[(i, k)])) {
                (0..n).for_each(|i| vectors[(i, k)] = -vectors[(i, k)]);
            }
        }
        let variances: Vec<f64> = values.iter().map(|value| value / (n - 1) as f64).collect();
        let scores: Vec<Vec<f64>> = (0..n)
            .map(|i| values.iter().enumerate().map(|(k, value)| vectors[(i, k)] * value.sqrt()).collect())
            .collect();
        let kept = explaining(&variances, KEPT_VARIANCE).min(MAX_MODES);
        let distance_modes = explaining(&variances, DISTANCE_VARIANCE).clamp(1, (n / 4).max(1));
        let n_folds = n_folds(n);
        let folds: Vec<Vec<usize>> = (0..n_folds).map(|fold| (fold..n).step_by(n_folds).collect()).collect();
        let others: Vec<usize> = (n..norms.len()).collect();
        let left_out = |left: Vec<usize>| {
            checkpoint(observer)?;
            leave_out((gram.as_ref(), &norms), &left, &others)
        };
        let folds: Vec<LeftOut> = folds.into_par_iter().map(left_out).collect::<Result<_, StudyError>>()?;
        let Validation { left_out, generalization_mm, others_p } =
            validation(&folds, n, others.len(), kept, distance_modes);
        let whole: f64 = variances.iter().sum();
        let compactness = (1..=kept).map(|k| variances[..k].iter().sum::<f64>() / whole).collect();
        let squares: Vec<f64> = scores.iter().map(|scores| scores.iter().map(|score| score * score).sum()).collect();
        let specificity_mm = specificity(&scores, &squares, &variances, kept, seed, observer)?;
        let modes = modes(shapes, alignment, &vectors, &values, kept)?;
        let quality = ModelQuality { compactness, generalization_mm, specificity_mm };
        Ok(ShapeModel { variances, modes, scores, quality, left_out, others_p, distance_modes })
    }

    /// The mean moved along a mode by a number of its standard deviations.
    pub fn along(&self, mean: &[Point3<f64>], mode: usize, deviations: f64) -> Vec<Point3<f64>> {
        let length = deviations * self.variances[mode].sqrt();
        mean.iter().zip(&self.modes[mode]).map(|(p, d)| p + length * d).collect()
    }

    /// Scores and squared Mahalanobis distance of a shape that was moved onto the mean and is not part of the model.
    pub fn score(&self, alignment: &Alignment, moved: &[Point3<f64>]) -> (Vec<f64>, f64) {
        let difference = |v: usize| moved[v] - alignment.mean[v];
        let each = |mode: &Vec<Vector3<f64>>| -> f64 {
            (0..moved.len()).map(|v| alignment.weights[v] * mode[v].dot(&difference(v))).sum()
        };
        let scores: Vec<f64> = self.modes.iter().map(each).collect();
        let squared: f64 = (0..moved.len()).map(|v| alignment.weights[v] * difference(v).norm_squared()).sum();
        let distance = distance(&scores, squared, &self.variances, self.distance_modes.min(self.modes.len()));
        (scores, distance)
    }

    /// The p-value of a shape as unusual as that of a subject of the model: the share of the subjects, itself included,
    /// that are at least as far from a model of the others. Uniform if it is one of them, whatever their distribution.
    pub fn unusual_of(&self, subject: usize) -> f64 {
        let own = self.left_out[subject];
        self.left_out.iter().filter(|&&other| other >= own).count() as f64 / self.left_out.len() as f64
    }
}

/// How subjects, and others, fare with models that have not seen them.
struct Validation {
    left_out: Vec<f64>,
    generalization_mm: Vec<f64>,
    others_p: Vec<f64>,
}

/// Distances and residuals of `n` members and p-values of others from models without some of the members.
fn validation(folds: &[LeftOut], n: usize, n_others: usize, kept: usize, distance_modes: usize) -> Validation {
    let (mut left_out, mut generalization_mm) = (vec![0.0; n], vec![0.0; kept]);
    let mut more_unusual = vec![0; n_others];
    for fold in folds {
        let distances = fold.distances(distance_modes);
        let of_others = fold.subjects.iter().zip(&distances).filter(|((i, ..), _)| *i >= n);
        for ((other, ..), own) in of_others {
            let members = fold.subjects.iter().zip(&distances).filter(|((i, ..), of)| *i < n && *of >= own);
            more_unusual[other - n] += members.count();
        }
        let members = fold.subjects.iter().zip(&distances).filter(|((i, ..), _)| *i < n);
        for ((i, scores, squared_norm), distance) in members {
            left_out[*i] = *distance;
            let mut rest = *squared_norm;
            for (k, sum) in generalization_mm.iter_mut().enumerate() {
                rest -= scores.get(k).map_or(0.0, |score| score * score);
                *sum += rest.max(0.0).sqrt() / n as f64;
            }
        }
    }
    let others_p = more_unusual.iter().map(|more| (more + 1) as f64 / (n + 1) as f64).collect();
    Validation { left_out, generalization_mm, others_p }
}

/// Number of models of `n` subjects that are computed without some of them.
pub(crate) fn n_folds(n: usize) -> usize {
    if n <= LEAVE_ONE_OUT {
        n
    } else if n <= COMPLETE {
        FOLDS
    } else {
        many::FOLDS
    }
}

/// The modes, summed over subjects in their order.
fn modes(
    shapes: &dyn Shapes,
    alignment: &Alignment,
    vectors: &Mat<f64>,
    values: &[f64],
    kept: usize,
) -> Result<Vec<Vec<Vector3<f64>>>, StudyError> {
    let v = shapes.n_vertices();
    let mut modes = vec![vec![Vector3::zeros(); v]; kept];
    for shape in 0..vectors.nrows() {
        let read = points(&shapes.read(shape, 0..v)?);
        let place = &alignment.onto_mean[shape];
        let difference: Vec<Vector3<f64>> =
            read.iter().zip(&alignment.mean).map(|(p, mean)| place.apply(p) - mean).collect();
        modes.par_iter_mut().enumerate().for_each(|(k, mode)| {
            let weight = if values[k] > 0.0 { vectors[(shape, k)] / values[k].sqrt() } else { 0.0 };
            mode.iter_mut().zip(&difference).for_each(|(mode, d)| *mode += weight * d);
        });
    }
    Ok(modes)
}

/// A draw from the standard normal distribution.
fn normal_draw(normal: &Normal, random: &mut impl Rng) -> f64 {
    normal.inverse_cdf(((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64)
}

/// RMS distance of random shapes from the nearest subject for 1, 2, … modes, mm. Distances need only the scores and the
/// squared distances from the mean.
fn specificity(
    scores: &[Vec<f64>],
    squares: &[f64],
    variances: &[f64],
    kept: usize,
    seed: u64,
    observer: &dyn Observer,
) -> Result<Vec<f64>, Cancelled> {
    let normal = Normal::standard();
    let each: Vec<Vec<f64>> = (0..RANDOM_SHAPES as u64)
        .into_par_iter()
        .map(|k| {
            checkpoint(observer)?;
            let mut random = Xoshiro256PlusPlus::seed_from_u64(seed ^ (k + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let shape: Vec<f64> = (0..kept).map(|k| variances[k].sqrt() * normal_draw(&normal, &mut random)).collect();
            let mut distances = squares.to_vec();
            let each = (0..kept)
                .map(|k| {
                    for (distance, scores) in distances.iter_mut().zip(scores) {
                        *distance += (shape[k] - scores[k]).powi(2) - scores[k] * scores[k];
                    }
                    distances.iter().copied().fold(f64::INFINITY, f64::min).max(0.0).sqrt()
                })
                .collect();
            Ok(each)
        })
        .collect::<Result<_, Cancelled>>()?;
    Ok((0..kept).map(|k| each.iter().map(|shape| shape[k]).sum::<f64>() / RANDOM_SHAPES as f64).collect())
}

pub(crate) mod many;
#[cfg(test)]
mod tests;
