//! What the stages of a displacement share.

use super::DisplacementOptions;
use super::guides::Guides;
use super::surface::{N_FEATURES, SmoothSurface};
use crate::lengths::Lengths;
use crate::surface_index::SurfaceIndex;
use faer::Mat;
use homolog_primitives::observe::Observer;
use homolog_registration::alignment::{Assignment, AssignmentKernel, OUTLIER_SHARE, annealed};
use homolog_registration::deformation::{FieldBasis, FittedField, Observation};
use nalgebra::Point3;

/// `ν` in the assignment's `ν (1 − ⟨n, n'⟩)`.
const NORMAL_WEIGHT: f64 = 2.0;
/// Curvatures at several scales are highly correlated: together they count as half an observation.
const FEATURE_SHARE: f64 = 0.5;
/// Feature variances are taken to be at least this, in squared robust standard deviations.
const MIN_FEATURE_VARIANCE: f64 = 0.02;

/// A field, and the precisions of the features that were estimated with it.
pub(super) struct State {
    pub field: FittedField,
    pub feature_precision: Vec<f64>,
}

pub(super) fn kernel(sigma_mm: f64, feature_precision: Vec<f64>) -> AssignmentKernel {
    AssignmentKernel { sigma_mm, normal_weight: NORMAL_WEIGHT, feature_precision, outlier_share: OUTLIER_SHARE }
}

pub(super) fn precision_of_features(variance: &[f64]) -> Vec<f64> {
    variance.iter().map(|v| FEATURE_SHARE / (N_FEATURES as f64 * v.max(MIN_FEATURE_VARIANCE))).collect()
}

pub(super) fn displaced(base: &[Point3<f64>], field: &FittedField, values: &Mat<f64>) -> Vec<Point3<f64>> {
    base.iter().zip(field.displacements(values.as_ref())).map(|(p, u)| p + u).collect()
}

/// Isotropic observations of the displacements to the assigned means.
pub(super) fn observed_means(
    found: &Assignment,
    base: &[Point3<f64>],
    areas: &[f64],
    precision: f64,
) -> Vec<Observation> {
    (0..base.len())
        .map(|i| Observation::isotropic(found.targets[i] - base[i], precision * found.mass[i] * areas[i]))
        .collect()
}

/// What all stages of a displacement share.
pub(super) struct Displacement<'a> {
    pub source: SmoothSurface,
    pub target: SmoothSurface,
    /// Closest points of the target, with its normals.
    pub closest: SurfaceIndex,
    pub basis: FieldBasis,
    pub guides: Guides,
    pub diagonal_mm: f64,
    /// Whether a part of either surface may be missing.
    pub open: bool,
    pub lengths: Lengths,
    pub options: &'a DisplacementOptions,
    pub observer: &'a dyn Observer,
}

impl Displacement<'_> {
    /// Independent observations for a unit of area, at `progress` between two stages.
    pub(super) fn density(&self, from: usize, to: usize, progress: f64) -> f64 {
        annealed(self.options.density[from], self.options.density[to], progress) / self.lengths.root_mm.powi(2)
    }
}
