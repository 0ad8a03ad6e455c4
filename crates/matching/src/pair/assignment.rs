//! The soft assignment between two prepared surfaces: its kernels, and the observations of a field from it.

use crate::surface::smooth::N_FEATURES;
use faer::Mat;
use homolog_registration::alignment::{Assignment, AssignmentKernel, OUTLIER_SHARE};
use homolog_registration::deformation::{FittedField, Observation};
use nalgebra::Point3;

/// `ν` in the assignment's `ν (1 − ⟨n, n'⟩)`.
pub(crate) const NORMAL_WEIGHT: f64 = 2.0;
/// Weight of the curvatures at all scales together, in observations: they are highly correlated.
pub(crate) const FEATURE_SHARE: f64 = 0.5;
/// Least variance of a feature, in squared robust standard deviations.
const MIN_FEATURE_VARIANCE: f64 = 0.02;

/// The kernel of an assignment of this width, mm.
pub(crate) fn kernel(sigma_mm: f64, feature_precision: Vec<f64>) -> AssignmentKernel {
    AssignmentKernel { sigma_mm, normal_weight: NORMAL_WEIGHT, feature_precision, outlier_share: OUTLIER_SHARE }
}

/// The kernel by which starts are compared, with equal precisions for all: a wrong start would otherwise lower its
/// misfit by lowering the precision of features.
pub(crate) fn comparison_kernel(sigma_mm: f64) -> AssignmentKernel {
    kernel(sigma_mm, vec![4.0 / N_FEATURES as f64; N_FEATURES])
}

/// The precisions of features with these variances.
pub(crate) fn precision_of_features(variance: &[f64]) -> Vec<f64> {
    variance.iter().map(|v| FEATURE_SHARE / (N_FEATURES as f64 * v.max(MIN_FEATURE_VARIANCE))).collect()
}

/// `base` moved by `field`, whose functions have these `values` at `base`.
pub(crate) fn displaced(base: &[Point3<f64>], field: &FittedField, values: &Mat<f64>) -> Vec<Point3<f64>> {
    base.iter().zip(field.displacements(values.as_ref())).map(|(p, u)| p + u).collect()
}

/// Isotropic observations of the displacements to the means of the assigned points.
pub(crate) fn observed_means(
    found: &Assignment,
    base: &[Point3<f64>],
    areas: &[f64],
    precision: f64,
) -> Vec<Observation> {
    (0..base.len())
        .map(|i| Observation::isotropic(found.targets[i] - base[i], precision * found.mass[i] * areas[i]))
        .collect()
}
