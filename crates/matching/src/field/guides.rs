//! Landmarks as observations of a displacement field.

use super::base::InitialMap;
use super::functions::Functions;
use faer::Mat;
use homolog_contract::parameters::Landmark;
use homolog_registration::deformation::{FittedField, Observation};
use nalgebra::Point3;

/// Most that one landmark adds to the misfit of a pose, so that one wrong landmark does not decide.
const CAP: f64 = 10.0;
/// Least standard deviation of a landmark in the comparison of poses, which precedes the fine stage, in roots of the
/// area.
const COARSE: f64 = 0.05;

/// Source points and the target points they should be moved to.
pub(crate) struct LandmarkObservations {
    source: Vec<Point3<f64>>,
    target: Vec<Point3<f64>>,
    sigma_mm: Vec<f64>,
    /// Least standard deviation in the comparison of poses, mm.
    coarse_mm: f64,
    /// Functions of the field at the source points, one row each.
    values: Mat<f64>,
}

impl LandmarkObservations {
    pub(crate) fn new(landmarks: &[Landmark], functions: &Functions, root_mm: f64) -> Self {
        let source: Vec<Point3<f64>> = landmarks.iter().map(|l| Point3::from(l.source_mm)).collect();
        LandmarkObservations {
            values: functions.values(&source),
            source,
            target: landmarks.iter().map(|l| Point3::from(l.target_mm)).collect(),
            sigma_mm: landmarks.iter().map(|l| l.sigma_mm).collect(),
            coarse_mm: COARSE * root_mm,
        }
    }

    /// The same points for a field with other functions.
    pub(crate) fn with_functions(&self, functions: &Functions) -> Self {
        LandmarkObservations {
            values: functions.values(&self.source),
            source: self.source.clone(),
            target: self.target.clone(),
            sigma_mm: self.sigma_mm.clone(),
            coarse_mm: self.coarse_mm,
        }
    }

    /// The same points for the field from target to source, whose functions are `functions`.
    pub(crate) fn swapped(&self, functions: &Functions) -> Self {
        LandmarkObservations {
            values: functions.values(&self.target),
            source: self.target.clone(),
            target: self.source.clone(),
            sigma_mm: self.sigma_mm.clone(),
            coarse_mm: self.coarse_mm,
        }
    }

    /// `values` with the rows of the guides appended.
    pub(crate) fn below(&self, values: Mat<f64>) -> Mat<f64> {
        if self.source.is_empty() {
            return values;
        }
        let n = values.nrows();
        Mat::from_fn(n + self.source.len(), values.ncols(), |i, k| {
            if i < n { values[(i, k)] } else { self.values[(i - n, k)] }
        })
    }

    /// The displacement from `base` to each landmark.
    pub(crate) fn observations(&self, base: &InitialMap) -> Vec<Observation> {
        let moved = base.moved(&self.source, &self.values);
        let observation = |((p, q), sigma): ((&Point3<f64>, &Point3<f64>), &f64)| {
            Observation::isotropic(q - p, 1.0 / (sigma * sigma))
        };
        moved.iter().zip(&self.target).zip(&self.sigma_mm).map(observation).collect()
    }

    /// Misfit of the guides under `base` and `field`: half the mean squared distance in standard deviations.
    pub(crate) fn misfit(&self, base: &InitialMap, field: &FittedField) -> f64 {
        if self.source.is_empty() {
            return 0.0;
        }
        let moved = base.moved(&self.source, &self.values);
        let displaced = field.displacements(self.values.as_ref());
        let missed = moved.iter().zip(&self.target).zip(&self.sigma_mm).zip(&displaced).map(|(((p, q), sigma), u)| {
            let sigma = sigma.max(self.coarse_mm);
            (0.5 * (p + u - q).norm_squared() / (sigma * sigma)).min(CAP)
        });
        missed.sum::<f64>() / self.source.len() as f64
    }
}
