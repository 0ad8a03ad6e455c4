//! The model of a large group: its first components alone, by subspace iteration over shapes that are read one after the
//! other, so that memory does not grow with the square of the number of subjects.
//!
//! Every direction but the first components counts by its mean variance, as in probabilistic principal components.
//! Models without some of the subjects are computed anew, from random directions, so that they have not seen these.
//!
//! Sources: Halko, Martinsson, Tropp, *Finding structure with randomness*, SIAM Review 53, 2011; Tipping, Bishop 1999.

use super::{DISTANCE_VARIANCE, Group, KEPT_VARIANCE, LeftOut, MAX_MODES, ModelQuality, ShapeModel, Validation};
use super::{coordinates, eigen, explaining, is_reversed, normal_draw, specificity, validation};
use crate::error::StudyError;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use nalgebra::Vector3;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use rayon::prelude::*;
use statrs::distribution::Normal;

/// Number of directions that are iterated.
pub(crate) const COMPONENTS: usize = 256;
/// Number of models without some of the shapes.
pub(crate) const FOLDS: usize = 5;
/// Shapes in memory at a time, those of a task, and coordinates of a task.
pub(crate) const AT_A_TIME: usize = 256;
const SHAPES_OF_TASK: usize = 32;
const COORDINATES_OF_TASK: usize = 1536;
/// Reads of the shapes at most, for the first components of a model.
pub(crate) const MAX_PASSES: usize = 12;
/// Relative change of a variance in a pass below which it is final.
const TOLERANCE: f64 = 1e-6;

/// All shapes in the span of the first components of some of them, the members.
struct Reduced {
    /// Scores of all shapes, mm: a row for each.
    scores: Mat<f64>,
    /// Squared distance of each shape from the mean of the members, mm².
    squares: Vec<f64>,
    /// Sum of the squared scores of the members on each component, mm², descending.
    values: Vec<f64>,
    /// Component of each coordinate, as columns.
    directions: Mat<f64>,
}

/// The model of the first `n` shapes from `components` directions, and p-values of the others. `n_folds`: number of
/// models without some of the shapes.
///
/// # Errors
/// As [`ShapeModel::new`].
///
/// # Cost
/// `O(n V components)` and a read of all shapes for each pass, at most 14, of each model; memory `O((n + V) components)`.
pub(super) fn model(
    group: &Group<'_>,
    n: usize,
    components: usize,
    n_folds: usize,
    seed: u64,
) -> Result<ShapeModel, StudyError> {
    let all: Vec<usize> = (0..n).collect();
    let reduced = Reduced::new(group, &all, components, seed)?;
    let found = reduced.values.len();
    let variances = reduced.variances(&all);
    let kept = explaining(&variances, KEPT_VARIANCE).min(MAX_MODES).min(found);
    let distance_modes = explaining(&variances, DISTANCE_VARIANCE).clamp(1, (n / 4).min(found.div_ceil(2)).max(1));
    let without = |fold: usize| {
        let (left, others): (Vec<usize>, Vec<usize>) = (0..n).partition(|i| i % n_folds == fold);
        let reduced = Reduced::new(group, &others, components, seed)?;
        let asked = left.into_iter().chain(n..group.shapes.len());
        let subjects = asked.map(|i| (i, reduced.row(i), reduced.squares[i])).collect();
        Ok(LeftOut { variances: reduced.variances(&others), subjects })
    };
    let folds: Vec<LeftOut> = (0..n_folds).map(without).collect::<Result<_, StudyError>>()?;
    let Validation { left_out, generalization_mm, others_p } =
        validation(&folds, n, group.shapes.len() - n, kept, distance_modes);
    let scores: Vec<Vec<f64>> = (0..n).map(|i| reduced.row(i)).collect();
    let whole: f64 = variances.iter().sum();
    let compactness = (1..=kept).map(|k| variances[..k].iter().sum::<f64>() / whole).collect();
    let specificity_mm = specificity(&scores, &reduced.squares[..n], &variances, kept, seed, group.observer)?;
    let modes = (0..kept).map(|k| reduced.mode(k, &group.alignment.weights)).collect();
    let quality = ModelQuality { compactness, generalization_mm, specificity_mm };
    Ok(ShapeModel { variances, modes, scores, quality, left_out, others_p, distance_modes })
}

impl Reduced {
    fn new(group: &Group<'_>, members: &[usize], components: usize, seed: u64) -> Result<Self, StudyError> {
        let coordinates = 3 * group.shapes.n_vertices();
        let components = components.min(members.len() - 1).min(coordinates);
        let center = center(group, members)?;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let normal = Normal::standard();
        let start = Mat::from_fn(coordinates, components, |_, _| normal_draw(&normal, &mut random));
        let mut directions = start.qr().compute_thin_Q();
        let mut before: Vec<f64> = Vec::new();
        for _ in 0..MAX_PASSES {
            let (image, inner) = pass(group, members, &center, directions.as_ref())?;
            let (values, _) = eigen(inner.as_ref())?;
            directions = image.qr().compute_thin_Q();
            let rests = |k: usize| (values[k] - before[k]).abs() <= TOLERANCE * values[k];
            if !before.is_empty() && (0..components.div_ceil(2)).all(rests) {
                break;
            }
            before = values;
        }
        let all: Vec<usize> = (0..group.shapes.len()).collect();
        let mut is_member = vec![0.0; all.len()];
        members.iter().for_each(|&i| is_member[i] = 1.0);
        let mut scores = Mat::zeros(all.len(), components);
        let mut squares = Vec::with_capacity(all.len());
        let mut inner = Mat::zeros(components, components);
        for some in all.chunks(AT_A_TIME) {
            let columns = columns(group, &center, some)?;
            let products = products(columns.as_ref(), directions.as_ref());
            squares.extend((0..some.len()).map(|k| columns.col(k).squared_norm_l2()));
            let of_members = Mat::from_fn(some.len(), components, |k, c| is_member[some[k]] * products[(k, c)]);
            matmul(inner.as_mut(), Accum::Add, of_members.transpose(), of_members.as_ref(), 1.0, Par::Seq);
            scores.subrows_mut(some[0], some.len()).copy_from(&products);
        }
        let (values, mut turn) = eigen(inner.as_ref())?;
        let mut scores = &scores * &turn;
        for k in 0..components {
            if is_reversed(members.iter().map(|&i| scores[(i, k)])) {
                scores.col_mut(k).iter_mut().for_each(|score| *score = -*score);
                turn.col_mut(k).iter_mut().for_each(|x| *x = -*x);
            }
        }
        Ok(Reduced { scores, squares, values, directions: &directions * &turn })
    }

    fn row(&self, shape: usize) -> Vec<f64> {
        self.scores.row(shape).iter().copied().collect()
    }

    /// The displacement of each vertex by a component.
    fn mode(&self, k: usize, weights: &[f64]) -> Vec<Vector3<f64>> {
        let of = |v: usize| Vector3::from_fn(|axis, _| self.directions[(3 * v + axis, k)]);
        weights.iter().enumerate().map(|(v, w)| if *w > 0.0 { of(v) / w.sqrt() } else { Vector3::zeros() }).collect()
    }

    /// Variances of the components, and for each further one the mean of what they leave of the members' squares.
    fn variances(&self, members: &[usize]) -> Vec<f64> {
        let further = (members.len() - 1).min(self.directions.nrows()).saturating_sub(self.values.len());
        let whole: f64 = members.iter().map(|&i| self.squares[i]).sum();
        let rest = (whole - self.values.iter().sum::<f64>()).max(0.0) / further.max(1) as f64;
        let all = self.values.iter().copied().chain(std::iter::repeat_n(rest, further));
        all.map(|value| value / (members.len() - 1) as f64).collect()
    }
}

/// The mean of some shapes, as coordinates about the mean of the alignment.
fn center(group: &Group<'_>, of: &[usize]) -> Result<Vec<f64>, StudyError> {
    let zero = vec![0.0; 3 * group.shapes.n_vertices()];
    let mut sum = zero.clone();
    for some in of.chunks(AT_A_TIME) {
        let columns = columns(group, &zero, some)?;
        for column in columns.col_iter() {
            sum.iter_mut().zip(column.iter()).for_each(|(sum, x)| *sum += x);
        }
    }
    sum.iter_mut().for_each(|sum| *sum /= of.len() as f64);
    Ok(sum)
}

/// The coordinates of some shapes about a center in the metric of the alignment, each as a column.
fn columns(group: &Group<'_>, center: &[f64], some: &[usize]) -> Result<Mat<f64>, StudyError> {
    let v = group.shapes.n_vertices();
    let rows: Vec<Vec<f64>> = some
        .par_iter()
        .map(|&shape| {
            let about_mean = coordinates(group.shapes, group.alignment, shape, 0..v)?;
            Ok(about_mean.iter().zip(center).map(|(x, center)| x - center).collect())
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

/// The sum of squares and products of some shapes about their mean applied to directions, and its products with them.
fn pass(
    group: &Group<'_>,
    of: &[usize],
    center: &[f64],
    directions: MatRef<'_, f64>,
) -> Result<(Mat<f64>, Mat<f64>), StudyError> {
    let (coordinates, r) = (directions.nrows(), directions.ncols());
    let of_task = |first: usize| COORDINATES_OF_TASK.min(coordinates - first);
    let mut parts: Vec<(usize, Mat<f64>)> =
        (0..coordinates).step_by(COORDINATES_OF_TASK).map(|first| (first, Mat::zeros(of_task(first), r))).collect();
    let mut inner = Mat::zeros(r, r);
    for some in of.chunks(AT_A_TIME) {
        let columns = columns(group, center, some)?;
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
