//! Correspondences of a bent, folded or articulated surface from bending-invariant forms, before any pose is known.
//!
//! The forms of both surfaces ([`crate::surface::form`]) are registered as any two surfaces are: a search over all
//! orientations of either handedness, then a smooth field from each pose. Curvatures are those of the surfaces themselves.
//! What a form leaves open is its handedness, and which of several limbs of equal length is which; each pose is kept as a
//! start of its own, and the energy of near isometries ([`crate::energy`]) says which is right.

use crate::pair::assignment::{
    NORMAL_WEIGHT, comparison_kernel, displaced, kernel, observed_means, precision_of_features,
};
use crate::pair::prior::PriorOptions;
use crate::surface::form::BendingInvariantForm;
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use faer::Mat;
use homolog_registration::alignment::{AssignmentTarget, OrientedPoints, annealed, assign, misfit, progress_to_end};
use homolog_registration::deformation::{FieldBasis, fit_field};
use homolog_registration::{PoseSearchOptions, RigidTransform, pose_search};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Settings of the search and of the field between two forms.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FormMatchSettings {
    /// Poses of either handedness that are tried.
    pub n_poses: usize,
    /// Steps of the field.
    pub steps: u32,
    /// `σ` at the start and at the end of the field, in diagonals of the form.
    pub sigma: [f64; 2],
    /// Independent observations over the form.
    pub density: f64,
    /// The prior of the field, in diagonals of the form.
    pub prior: PriorOptions,
}

impl Default for FormMatchSettings {
    fn default() -> Self {
        FormMatchSettings { n_poses: 8, steps: 20, sigma: [0.06, 0.03], density: 48.0, prior: PriorOptions::default() }
    }
}

/// Correspondences of the sites of a form.
#[derive(Debug, Clone)]
pub(crate) struct FormMatch {
    /// The point of the target that each site of the source corresponds to, mm.
    pub images: Vec<Point3<f64>>,
    /// How much target area is assigned to each site, relative to its own.
    pub mass: Vec<f64>,
    /// Misfit of the forms; lower is better.
    pub misfit: f64,
}

/// A form with what is known of the surface at its sites.
struct FormSide<'a> {
    form: &'a BendingInvariantForm,
    /// The sites on the surface itself.
    points: Vec<Point3<f64>>,
    /// Curvature features of the surface itself.
    features: Vec<f64>,
}

impl<'a> FormSide<'a> {
    fn new(surface: &SmoothSurface, form: &'a BendingInvariantForm) -> Self {
        FormSide {
            form,
            points: form.places(&surface.mesh),
            features: form
                .sites
                .iter()
                .flat_map(|&k| surface.features[k as usize * N_FEATURES..][..N_FEATURES].to_vec())
                .collect(),
        }
    }

    fn oriented(&self) -> OrientedPoints<'_> {
        OrientedPoints { features: &self.features, ..self.form.oriented() }
    }
}

/// Correspondences between two surfaces by their forms, the best first.
///
/// # Cost
/// `O(poses · (steps · sites² + sites · M²))` for `M` functions of a field.
pub(crate) fn form_matches(
    (source, source_form): (&SmoothSurface, &BendingInvariantForm),
    (target, target_form): (&SmoothSurface, &BendingInvariantForm),
    settings: &FormMatchSettings,
) -> Vec<FormMatch> {
    let search =
        PoseSearchOptions { allow_reflection: true, n_settled: settings.n_poses, ..PoseSearchOptions::default() };
    let poses = pose_search(&source_form.oriented(), &target_form.oriented(), &search);
    let (source, target) = (FormSide::new(source, source_form), FormSide::new(target, target_form));
    let diagonal_mm = source_form.diagonal_mm();
    let prior = settings.prior.of(diagonal_mm);
    let Some(basis) = FieldBasis::new(&source_form.points, prior, settings.prior.n_inducing) else {
        return Vec::new();
    };
    let between = Between { values: basis.values(&source_form.points), source, target, diagonal_mm, settings };
    let mut found: Vec<FormMatch> =
        poses.par_iter().filter_map(|pose| between.matched(&pose.target_from_source)).collect();
    found.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
    found
}

/// Two forms, and the functions of a field over that of the source.
struct Between<'a> {
    source: FormSide<'a>,
    target: FormSide<'a>,
    values: Mat<f64>,
    diagonal_mm: f64,
    settings: &'a FormMatchSettings,
}

impl Between<'_> {
    /// The correspondence after a field from `pose`; `None` where no field can be fitted.
    fn matched(&self, pose: &RigidTransform) -> Option<FormMatch> {
        let form = self.source.form;
        let base: Vec<Point3<f64>> = form.points.iter().map(|p| pose.apply(p)).collect();
        let normals: Vec<Vector3<f64>> = form.normals.iter().map(|n| pose.rotation * n).collect();
        let area: f64 = form.areas.iter().sum();
        let target = AssignmentTarget::new(&self.target.oriented());
        let [first, last] = self.settings.sigma.map(|sigma| sigma * self.diagonal_mm);
        let mut moved = base.clone();
        let mut precision = precision_of_features(&[1.0; N_FEATURES]);
        for step in 0..self.settings.steps {
            let sigma_mm = annealed(first, last, progress_to_end(step, self.settings.steps));
            let source = OrientedPoints { points: &moved, normals: &normals, ..self.source.oriented() };
            let assigned = assign(&source, &target, &kernel(sigma_mm, precision));
            let weight = self.settings.density / (area * sigma_mm * sigma_mm);
            let fitted = fit_field(self.values.as_ref(), &observed_means(&assigned, &base, &form.areas, weight))?;
            moved = displaced(&base, &fitted, &self.values);
            precision = precision_of_features(&assigned.feature_variance);
        }
        let source = OrientedPoints { points: &moved, normals: &normals, ..self.source.oriented() };
        let misfit = misfit(&source, &target, &comparison_kernel(last));
        let (images, mass) = self.images(&source, last, &precision);
        Some(FormMatch { images, mass, misfit })
    }

    /// For each site of `source`, which is where the form was moved to, the mean of the target's points, weighted by how well
    /// their sites agree on the form; and that weight relative to the site's own area.
    fn images(&self, source: &OrientedPoints<'_>, sigma_mm: f64, precision: &[f64]) -> (Vec<Point3<f64>>, Vec<f64>) {
        let target = self.target.oriented();
        let features = |side: &OrientedPoints<'_>, i: usize| -> Vec<f64> {
            side.features[i * N_FEATURES..][..N_FEATURES].to_vec()
        };
        let image = |i: usize| {
            let own = features(source, i);
            let (mut total, mut sum) = (0.0, Vector3::zeros());
            for (j, q) in self.target.points.iter().enumerate() {
                let squared = (source.points[i] - target.points[j]).norm_squared();
                let others = features(&target, j);
                let unlike: f64 = (0..N_FEATURES).map(|f| precision[f] * (own[f] - others[f]).powi(2)).sum();
                let turned = 1.0 - source.normals[i].dot(&target.normals[j]);
                let exponent = 0.5 * (squared / (sigma_mm * sigma_mm) + unlike) + NORMAL_WEIGHT * turned;
                let weight = target.areas[j] * (-exponent).exp();
                total += weight;
                sum += q.coords * weight;
            }
            // Without a weight the image does not count.
            (Point3::from(sum / total.max(f64::MIN_POSITIVE)), total / (TAU * sigma_mm * sigma_mm))
        };
        (0..source.points.len()).map(image).unzip()
    }
}
