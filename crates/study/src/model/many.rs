//! The model of a large group: its first components alone, by subspace iteration over shapes that are read one after the
//! other, so that memory does not grow with the square of the number of subjects.
//!
//! Every direction but the first components counts by its mean variance, as in probabilistic principal components.
//! Models without some of the subjects are sought in the span of the components of all.
//!
//! Sources: Halko, Martinsson, Tropp, *Finding structure with randomness*, SIAM Review 53, 2011; Tipping, Bishop 1999.

use super::{DISTANCE_VARIANCE, KEPT_VARIANCE, LeftOut, MAX_MODES, ModelQuality, ShapeModel, Validation, Watched};
use super::{explaining, n_folds, normal_draw, specificity, validation};
use crate::align::points;
use crate::error::StudyError;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, Side};
use homolog_primitives::observe::checkpoint;
use nalgebra::Vector3;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use rayon::prelude::*;
use statrs::distribution::Normal;
use std::ops::Range;

/// Number of directions that are iterated.
pub(crate) const COMPONENTS: usize = 256;
/// Shapes in memory at a time, those of a task, and coordinates of a task.
pub(crate) const AT_A_TIME: usize = 256;
const SHAPES_OF_TASK: usize = 32;
const COORDINATES_OF_TASK: usize = 1536;
/// Reads of the group at most.
pub(crate) const MAX_PASSES: usize = 12;
/// Relative change of a variance in a pass below which it is final.
const TOLERANCE: f64 = 1e-6;

/// The group in the span of its first components.
struct Reduced {
    /// Scores of all shapes, mm: a row for each.
    scores: Mat<f64>,
    /// Squared distance of each shape from the mean, mm².
    squares: Vec<f64>,
    /// Sum of the squared scores of the members on each component, mm², descending.
    values: Vec<f64>,
    /// Component of each coordinate, as columns.
    directions: Mat<f64>,
}

/// The model of the first `n` shapes from `components` directions, and p-values of the others.
///
/// # Errors
/// As [`ShapeModel::new`].
///
/// # Cost
/// `O(n V components)` and a read of all shapes for each pass, at most 12; memory `O((n + V) components)`.
pub(super) fn model(group: &Watched<'_>, n: usize, components: usize, seed: u64) -> Result<ShapeModel, StudyError> {
    let coordinates = 3 * group.shapes.n_vertices();
    let reduced = Reduced::new(group, n, components.min(n - 1).min(coordinates), seed)?;
    let found = reduced.values.len();
    let variances = with_rest(&reduced.values, reduced.squares[..n].iter().sum(), n, coordinates);
    let kept = explaining(&variances, KEPT_VARIANCE).min(MAX_MODES).min(found);
    let distance_modes = explaining(&variances, DISTANCE_VARIANCE).clamp(1, (n / 4).min(found.div_ceil(2)).max(1));
    let n_folds = n_folds(n);
    let folds: Vec<LeftOut> = (0..n_folds)
        .into_par_iter()
        .map(|fold| {
            checkpoint(group.observer)?;
            reduced.leave_out(n, &|i| i % n_folds == fold, coordinates)
        })
        .collect::<Result<_, StudyError>>()?;
    let Validation { left_out, generalization_mm, others_p } =
        validation(&folds, n, reduced.squares.len() - n, kept, distance_modes);
    let scores: Vec<Vec<f64>> = (0..n).map(|i| reduced.row(i)).collect();
    let whole: f64 = variances.iter().sum();
    let compactness = (1..=kept).map(|k| variances[..k].iter().sum::<f64>() / whole).collect();
    let specificity_mm = specificity(&scores, &reduced.squares[..n], &variances, kept, seed, group.observer)?;
    let modes = (0..kept).map(|k| reduced.mode(k, &group.alignment.weights)).collect();
    let quality = ModelQuality { compactness, generalization_mm, specificity_mm };
    Ok(ShapeModel { variances, modes, scores, quality, left_out, others_p, distance_modes })
}

/// Variances of the components, and for each further one the mean of what they leave of the squares `whole` of `n` shapes.
fn with_rest(values: &[f64], whole: f64, n: usize, coordinates: usize) -> Vec<f64> {
    let further = (n - 1).min(coordinates).saturating_sub(values.len());
    let rest = (whole - values.iter().sum::<f64>()).max(0.0) / further.max(1) as f64;
    let all = values.iter().copied().chain(std::iter::repeat_n(rest, further));
    all.map(|value| value / (n - 1) as f64).collect()
}

/// Eigenvalues, descending and at least 0, and eigenvectors.
fn eigen(matrix: MatRef<'_, f64>) -> Result<(Vec<f64>, Mat<f64>), StudyError> {
    let r = matrix.nrows();
    let found = matrix.self_adjoint_eigen(Side::Lower).map_err(|_| StudyError::Decomposition("its inner products"))?;
    let (values, vectors) = (found.S().column_vector(), found.U());
    let values = (1..=r).map(|k| values[r - k].max(0.0)).collect();
    Ok((values, Mat::from_fn(r, r, |i, k| vectors[(i, r - 1 - k)])))
}

impl Reduced {
    fn new(group: &Watched<'_>, n: usize, components: usize, seed: u64) -> Result<Self, StudyError> {
        let coordinates = 3 * group.shapes.n_vertices();
        let center = center(group, n)?;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let normal = Normal::standard();
        let start = Mat::from_fn(coordinates, components, |_, _| normal_draw(&normal, &mut random));
        let mut directions = start.qr().compute_thin_Q();
        let mut before: Vec<f64> = Vec::new();
        for _ in 0..MAX_PASSES {
            let (image, inner) = pass(group, n, &center, directions.as_ref())?;
            let (values, _) = eigen(inner.as_ref())?;
            directions = image.qr().compute_thin_Q();
            let rests = |k: usize| (values[k] - before[k]).abs() <= TOLERANCE * values[k];
            if !before.is_empty() && (0..components.div_ceil(2)).all(rests) {
                break;
            }
            before = values;
        }
        let mut scores = Mat::zeros(group.shapes.len(), components);
        let mut squares = Vec::with_capacity(group.shapes.len());
        let mut inner = Mat::zeros(components, components);
        for first in (0..group.shapes.len()).step_by(AT_A_TIME) {
            let some = first..(first + AT_A_TIME).min(group.shapes.len());
            let columns = columns(group, &center, some.clone())?;
            let products = products(columns.as_ref(), directions.as_ref());
            squares.extend((0..some.len()).map(|k| columns.col(k).squared_norm_l2()));
            let members = products.subrows(0, n.saturating_sub(first).min(some.len()));
            matmul(inner.as_mut(), Accum::Add, members.transpose(), members, 1.0, Par::Seq);
            scores.subrows_mut(first, some.len()).copy_from(&products);
        }
        let (values, mut turn) = eigen(inner.as_ref())?;
        // The sign of a mode is arbitrary; the subject farthest along it is placed on its positive side.
        let turned = &scores * &turn;
        for k in 0..components {
            let furthest =
                (0..n).fold(0, |best, i| if turned[(i, k)].abs() > turned[(best, k)].abs() { i } else { best });
            if turned[(furthest, k)] < 0.0 {
                (0..components).for_each(|i| turn[(i, k)] = -turn[(i, k)]);
            }
        }
        Ok(Reduced { scores: &scores * &turn, squares, values, directions: &directions * &turn })
    }

    fn row(&self, shape: usize) -> Vec<f64> {
        self.scores.row(shape).iter().copied().collect()
    }

    /// The displacement of each vertex by a component.
    fn mode(&self, k: usize, weights: &[f64]) -> Vec<Vector3<f64>> {
        let of = |v: usize| Vector3::from_fn(|axis, _| self.directions[(3 * v + axis, k)]);
        weights.iter().enumerate().map(|(v, w)| if *w > 0.0 { of(v) / w.sqrt() } else { Vector3::zeros() }).collect()
    }

    /// The model of those of the first `n` that are not `left`; these, and all others, get scores.
    fn leave_out(&self, n: usize, left: &dyn Fn(usize) -> bool, coordinates: usize) -> Result<LeftOut, StudyError> {
        let components = self.values.len();
        let of_model: Vec<usize> = (0..n).filter(|&i| !left(i)).collect();
        let m = of_model.len();
        let mean: Vec<f64> =
            (0..components).map(|k| of_model.iter().map(|&i| self.scores[(i, k)]).sum::<f64>() / m as f64).collect();
        let centered = Mat::from_fn(m, components, |row, k| self.scores[(of_model[row], k)] - mean[k]);
        let mut inner = Mat::zeros(components, components);
        matmul(inner.as_mut(), Accum::Replace, centered.transpose(), centered.as_ref(), 1.0, Par::Seq);
        let (mut values, turn) = eigen(inner.as_ref())?;
        // Fewer shapes than components span fewer.
        values.truncate(m - 1);
        let outside =
            |i: usize| (self.squares[i] - self.row(i).iter().map(|score| score * score).sum::<f64>()).max(0.0);
        let whole = values.iter().sum::<f64>() + of_model.iter().map(|&i| outside(i)).sum::<f64>();
        let subjects = (0..self.squares.len()).filter(|&i| i >= n || left(i)).map(|i| {
            let own: Vec<f64> = self.row(i).iter().zip(&mean).map(|(score, mean)| score - mean).collect();
            let squared = own.iter().map(|score| score * score).sum::<f64>() + outside(i);
            let along = |k: usize| own.iter().enumerate().map(|(j, score)| score * turn[(j, k)]).sum();
            (i, (0..values.len()).map(along).collect(), squared)
        });
        Ok(LeftOut { subjects: subjects.collect(), variances: with_rest(&values, whole, m, coordinates) })
    }
}

/// The mean of the first `n` shapes, as coordinates about the mean of the alignment.
fn center(group: &Watched<'_>, n: usize) -> Result<Vec<f64>, StudyError> {
    let zero = vec![0.0; 3 * group.shapes.n_vertices()];
    let mut sum = zero.clone();
    for first in (0..n).step_by(AT_A_TIME) {
        let columns = columns(group, &zero, first..n.min(first + AT_A_TIME))?;
        for column in columns.col_iter() {
            sum.iter_mut().zip(column.iter()).for_each(|(sum, x)| *sum += x);
        }
    }
    sum.iter_mut().for_each(|sum| *sum /= n as f64);
    Ok(sum)
}

/// The coordinates of some shapes about a center in the metric of the alignment, each as a column.
fn columns(group: &Watched<'_>, center: &[f64], some: Range<usize>) -> Result<Mat<f64>, StudyError> {
    let v = group.shapes.n_vertices();
    let alignment = group.alignment;
    let rows: Vec<Vec<f64>> = some
        .into_par_iter()
        .map(|shape| {
            let place = &alignment.onto_mean[shape];
            let at = |(v, p)| (place.apply(p) - alignment.mean[v]) * f64::sqrt(alignment.weights[v]);
            let read = points(&group.shapes.read(shape, 0..v)?);
            let all = read.iter().enumerate().flat_map(|each| <[f64; 3]>::from(at(each)));
            Ok(all.zip(center).map(|(x, center)| x - center).collect())
        })
        .collect::<Result<_, StudyError>>()?;
    Ok(Mat::from_fn(3 * v, rows.len(), |k, shape| rows[shape][k]))
}

/// Inner products of shapes with directions: a row for each shape.
fn products(columns: MatRef<'_, f64>, directions: MatRef<'_, f64>) -> Mat<f64> {
    let (c, r) = (columns.ncols(), directions.ncols());
    let parts: Vec<Mat<f64>> = (0..c)
        .step_by(SHAPES_OF_TASK)
        .collect::<Vec<_>>()
        .into_par_iter()
        .map(|first| {
            let some = columns.subcols(first, SHAPES_OF_TASK.min(c - first));
            let mut part = Mat::zeros(some.ncols(), r);
            matmul(part.as_mut(), Accum::Replace, some.transpose(), directions, 1.0, Par::Seq);
            part
        })
        .collect();
    Mat::from_fn(c, r, |i, k| parts[i / SHAPES_OF_TASK][(i % SHAPES_OF_TASK, k)])
}

/// The covariance of the first `n` shapes, times `n`, applied to directions, and its products with them.
fn pass(
    group: &Watched<'_>,
    n: usize,
    center: &[f64],
    directions: MatRef<'_, f64>,
) -> Result<(Mat<f64>, Mat<f64>), StudyError> {
    let (coordinates, r) = (directions.nrows(), directions.ncols());
    let of_task = |first: usize| COORDINATES_OF_TASK.min(coordinates - first);
    let mut parts: Vec<(usize, Mat<f64>)> =
        (0..coordinates).step_by(COORDINATES_OF_TASK).map(|first| (first, Mat::zeros(of_task(first), r))).collect();
    let mut inner = Mat::zeros(r, r);
    for first in (0..n).step_by(AT_A_TIME) {
        checkpoint(group.observer)?;
        let columns = columns(group, center, first..n.min(first + AT_A_TIME))?;
        let products = products(columns.as_ref(), directions);
        matmul(inner.as_mut(), Accum::Add, products.transpose(), products.as_ref(), 1.0, Par::Seq);
        parts.par_iter_mut().for_each(|(first, part)| {
            let some = columns.subrows(*first, part.nrows());
            matmul(part.as_mut(), Accum::Add, some, products.as_ref(), 1.0, Par::Seq);
        });
    }
    let image = Mat::from_fn(coordinates, r, |i, k| parts[i / COORDINATES_OF_TASK].1[(i % COORDINATES_OF_TASK, k)]);
    Ok((image, inner))
}
