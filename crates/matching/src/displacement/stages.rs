//! What the stages of a displacement share.

use super::DisplacementOptions;
use super::fits::Fits;
use super::functions::Functions;
use super::guides::Guides;
use super::surface::{N_FEATURES, SmoothSurface};
use crate::lengths::Lengths;
use faer::Mat;
use homolog_registration::alignment::{Assignment, AssignmentKernel, OUTLIER_SHARE, annealed};
use homolog_registration::deformation::{FittedField, Observation};
use homolog_registration::{RigidTransform, SamePose};
use nalgebra::{Point3, Vector3};
use std::sync::Arc;

/// `ν` in the assignment's `ν (1 − ⟨n, n'⟩)`.
pub(super) const NORMAL_WEIGHT: f64 = 2.0;
/// Curvatures at several scales are highly correlated: together they count as half an observation.
const FEATURE_SHARE: f64 = 0.5;
/// Feature variances are taken to be at least this, in squared robust standard deviations.
const MIN_FEATURE_VARIANCE: f64 = 0.02;

/// Where a surface is before the field moves it: after a rigid pose, or bent as well.
#[derive(Clone)]
pub(super) struct Base {
    pub pose: RigidTransform,
    /// Coefficients of a field, `M × 3`.
    pub bend: Option<Mat<f64>>,
}

impl Base {
    pub(super) fn rigid(pose: RigidTransform) -> Self {
        Base { pose, bend: None }
    }

    /// `points` of the source, at which the functions of the field have these `values` (more rows may follow).
    pub(super) fn moved(&self, points: &[Point3<f64>], values: &Mat<f64>) -> Vec<Point3<f64>> {
        let posed = points.iter().map(|p| self.pose.apply(p));
        match &self.bend {
            None => posed.collect(),
            Some(bend) => {
                let u = values * bend;
                posed.enumerate().map(|(i, p)| p + Vector3::new(u[(i, 0)], u[(i, 1)], u[(i, 2)])).collect()
            }
        }
    }

    /// This base with the displacement of `field` added.
    pub(super) fn bent_by(&self, field: &FittedField) -> Self {
        let bend = match &self.bend {
            None => field.coefficients.clone(),
            Some(bend) => bend + &field.coefficients,
        };
        Base { pose: self.pose, bend: Some(bend) }
    }
}

/// A field over its base, and the precisions of the features that were estimated with it.
pub(super) struct State {
    pub base: Base,
    pub field: FittedField,
    pub feature_precision: Vec<f64>,
}

pub(super) fn kernel(sigma_mm: f64, feature_precision: Vec<f64>) -> AssignmentKernel {
    AssignmentKernel { sigma_mm, normal_weight: NORMAL_WEIGHT, feature_precision, outlier_share: OUTLIER_SHARE }
}

/// The kernel by which starts are compared: with the same precisions for all, so that a wrong one that has come to distrust
/// features does not gain by that.
pub(super) fn comparison_kernel(sigma_mm: f64) -> AssignmentKernel {
    kernel(sigma_mm, vec![4.0 / N_FEATURES as f64; N_FEATURES])
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
    pub source: Arc<SmoothSurface>,
    pub target: Arc<SmoothSurface>,
    pub functions: Functions,
    pub guides: Guides,
    pub diagonal_mm: f64,
    pub lengths: Lengths,
    /// When two poses of a source that is a part are the same: it may fit at several places in one orientation.
    pub same_place: Option<SamePose>,
    pub options: &'a DisplacementOptions,
    pub observer: &'a Fits<'a>,
}

impl Displacement<'_> {
    /// Independent observations for a unit of area, at `progress` between two stages.
    pub(super) fn density(&self, from: usize, to: usize, progress: f64) -> f64 {
        annealed(self.options.density[from], self.options.density[to], progress) / self.lengths.root_mm.powi(2)
    }
}
