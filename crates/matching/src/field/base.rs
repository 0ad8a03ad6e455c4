//! The place of a surface before a field moves it, and a field over that place.

use crate::pair::assignment::displaced;
use faer::Mat;
use homolog_registration::RigidTransform;
use homolog_registration::deformation::FittedField;
use nalgebra::{Point3, Vector3};

/// The map of a surface before the field is added: a rigid pose, with or without bending.
#[derive(Clone)]
pub(crate) struct InitialMap {
    pub pose: RigidTransform,
    /// Coefficients of a field, `M × 3`.
    pub bend: Option<Mat<f64>>,
}

impl InitialMap {
    pub(crate) fn rigid(pose: RigidTransform) -> Self {
        InitialMap { pose, bend: None }
    }

    /// Moves `points` of the source, at which the functions of the field have these `values` (more rows may follow).
    pub(crate) fn moved(&self, points: &[Point3<f64>], values: &Mat<f64>) -> Vec<Point3<f64>> {
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
    pub(crate) fn with_field(&self, field: &FittedField) -> Self {
        let bend = match &self.bend {
            None => field.coefficients.clone(),
            Some(bend) => bend + &field.coefficients,
        };
        InitialMap { pose: self.pose, bend: Some(bend) }
    }
}

/// A field over its base, and the feature precisions that were estimated with it.
#[derive(Clone)]
pub(crate) struct State {
    pub base: InitialMap,
    pub field: FittedField,
    pub feature_precision: Vec<f64>,
}

impl State {
    /// `points` of the source where the field over its base moves them, mm; `values`: its functions there.
    pub(crate) fn moved(&self, points: &[Point3<f64>], values: &Mat<f64>) -> Vec<Point3<f64>> {
        displaced(&self.base.moved(points, values), &self.field, values)
    }
}
