//! From rigid poses to a smooth displacement field, and from it to sub-vertex correspondences.
//!
//! The source is moved by `T(p) = R p + t + u(p)`, `u` a field of [`crate::deformation`]: a translation, a linear part
//! and a Gaussian process of width 0.3 diagonals. Expectation and maximisation alternate as in coherent point drift:
//! target vertices are assigned softly to moved source vertices by distance, normals and curvature features, whose
//! variances are estimated anew each time; then the field is fitted to the means of what was assigned.
//!
//! 1. **Coarse**, from every pose, on thinned surfaces, `σ` from 5 % to 4 % of the diagonal; the pose of the lowest
//!    misfit is kept, so a pose that is turned head to tail is judged after it had its chance to bend.
//! 2. **Middle**, on all vertices, to 2.5 % of the diagonal.
//! 3. **Fine**: the pull along the normal is towards the closest point of the surface, with the small variance of
//!    points on surfaces; across the normal a tenth of the assignment's weight is left. The surface slides, and what
//!    slides it is the field's smoothness against normals all around. Without that freedom the assignment, which
//!    prefers where a vertex already is, holds every vertex back: on 8 % warps 0.47-0.89 of the vertices of three hard
//!    cases were within one edge, with it 0.94-0.96.
//! 4. **Settling**: copies of one anatomy come within the sampling noise of each other; two subjects do not, and what
//!    is left is anatomy of their own that is correlated over millimetres. The residual along the normals, which lay at
//!    0.08-0.10 mm in the one case and at 0.24-0.29 mm in the other, says how much each square millimetre tells.
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010; Hirose, "A
//! Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021 (prior, weights); Chen, Medioni 1992 (distance
//! from the tangent plane).

use super::MatchError;
use super::displacement_answer::{Image, images};
use super::displacement_rigid::rigid_part;
use super::displacement_surface::{N_FEATURES, SmoothSurface, Thinned, median, prepare};
use crate::deformation::{
    Assignment, FieldBasis, FittedField, GaussianKernel, Likeness, Pull, Samples, SmoothPrior, assign, fit,
};
use crate::mesh::{ClosestPointIndex, SurfaceMesh};
use crate::observe::{Observer, checkpoint};
use crate::registration::RigidTransform;
use faer::Mat;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// How displacement runs. The defaults are round numbers; neighbours of each gave the same within the spread.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplacementOptions {
    /// Width of the field's Gaussian process in diagonals of the source.
    pub width: f64,
    /// Its standard deviation, and that of the translation, in diagonals.
    pub amplitude: f64,
    /// Standard deviation of the entries of the linear part.
    pub linear: f64,
    /// Inducing points of the field.
    pub n_inducing: usize,
    /// Vertices of the thinned surfaces.
    pub n_coarse: usize,
    /// Steps of the four stages.
    pub steps: [u32; 4],
    /// `σ` in diagonals at the start and after each of the first three stages.
    pub sigma: [f64; 4],
    /// Independent observations a square millimetre at the start and after each of the first three stages: from stiff
    /// to soft.
    pub density: [f64; 4],
}

impl Default for DisplacementOptions {
    fn default() -> Self {
        DisplacementOptions {
            width: 0.3,
            amplitude: 0.1,
            linear: 0.2,
            n_inducing: 150,
            n_coarse: 700,
            steps: [20, 15, 15, 8],
            sigma: [0.05, 0.04, 0.025, 0.02],
            density: [0.03, 0.03, 0.1, 0.3],
        }
    }
}

/// What displacement found.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplacementAnswer {
    /// Where each source vertex goes.
    pub images: Vec<Image>,
    /// The rigid transform of these correspondences.
    pub transform: RigidTransform,
    /// Index of the pose that was kept.
    pub best: usize,
    /// Misfit of each pose after the coarse stage, lower is better: how clearly the best was.
    pub misfits: Vec<f64>,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
}

/// `ν` in the assignment's `ν (1 − ⟨n, n'⟩)`.
const NORMAL_WEIGHT: f64 = 2.0;
/// Share of a surface without counterpart.
const OUTLIER: f64 = 0.1;
/// Curvatures of one place at several scales say nearly the same: together they count as half an observation.
const FEATURE_SHARE: f64 = 0.5;
/// Feature variances are taken to be at least this, in squared robust standard deviations.
const MIN_FEATURE_VARIANCE: f64 = 0.02;
/// Standard deviation of a point along the normal of the other surface in the fine stage, mm.
const ALONG_MM: f64 = 0.3;
/// Share of the assignment's weight that is left across the normal in the fine stage; 0.03 to 0.3 did alike.
const ACROSS_SHARE: f64 = 0.1;
/// Residual along the normals, mm, below which two surfaces of 1 mm voxels are copies of one anatomy.
const NOISE_MM: f64 = 0.12;
/// Each square millimetre tells `(NOISE_MM / residual)` to this power of what it tells between copies: two for the
/// variance, the rest because larger residuals are correlated over larger areas.
const NOISE_POWER: f64 = 6.0;

/// Geometric interpolation.
fn between(from: f64, to: f64, share: f64) -> f64 {
    from * (to / from).powf(share)
}

fn share(step: u32, steps: u32) -> f64 {
    f64::from(step) / f64::from(steps.saturating_sub(1).max(1))
}

/// A field with what the assignment has learned.
struct State {
    field: FittedField,
    feature_precision: Vec<f64>,
}

fn likeness(sigma_mm: f64, feature_precision: Vec<f64>) -> Likeness {
    Likeness { sigma_mm, normal_weight: NORMAL_WEIGHT, feature_precision, outlier: OUTLIER }
}

fn precision_of_features(variance: &[f64]) -> Vec<f64> {
    variance.iter().map(|v| FEATURE_SHARE / (N_FEATURES as f64 * v.max(MIN_FEATURE_VARIANCE))).collect()
}

fn displaced(base: &[Point3<f64>], field: &FittedField, values: &Mat<f64>) -> Vec<Point3<f64>> {
    base.iter().zip(field.displacements(values.as_ref())).map(|(p, u)| p + u).collect()
}

/// Pulls towards the assigned means, the same in every direction.
fn pulls_to_means(found: &Assignment, base: &[Point3<f64>], areas: &[f64], precision: f64) -> Vec<Pull> {
    (0..base.len())
        .map(|i| {
            let weight = precision * found.mass[i] * areas[i];
            let displacement = found.targets[i] - base[i];
            Pull { displacement, normal: Vector3::x(), along: weight, across: weight }
        })
        .collect()
}

/// What all stages share.
struct Displacement<'a> {
    source: SmoothSurface,
    target: SmoothSurface,
    basis: FieldBasis,
    diagonal_mm: f64,
    options: &'a DisplacementOptions,
    observer: &'a dyn Observer,
}

/// Correspondences of `source` on `target`, from each of the rigid `poses` (`target_from_source`).
///
/// Both meshes in canonical numbering (see [`crate::mesh::canonicalize`]), lengths mm. `None` without poses, or where
/// numbers that are not finite make a fit impossible. The same bits on any number of threads.
///
/// # Errors
/// [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
///
/// # Cost
/// `O(steps · n · (pairs + M²))` for `M` functions of the field, about 40 for the defaults.
pub fn displace(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    poses: &[RigidTransform],
    options: &DisplacementOptions,
    observer: &dyn Observer,
) -> Result<Option<DisplacementAnswer>, MatchError> {
    let (low, high) = source.bounding_box();
    let diagonal_mm = (high - low).norm();
    let (smooth_source, smooth_target) = prepare(source, target)?;
    checkpoint(observer)?;
    let prior = SmoothPrior {
        translation_mm: options.amplitude * diagonal_mm,
        linear: options.linear,
        kernels: vec![GaussianKernel {
            width_mm: options.width * diagonal_mm,
            amplitude_mm: options.amplitude * diagonal_mm,
        }],
    };
    let Some(basis) = FieldBasis::new(smooth_source.mesh.vertices(), prior, options.n_inducing) else {
        return Ok(None);
    };
    let all = Displacement { source: smooth_source, target: smooth_target, basis, diagonal_mm, options, observer };
    let Some((best, misfits, state)) = all.coarse(poses)? else { return Ok(None) };
    let Some((field, residual_mm)) = all.refined(&poses[best], state)? else { return Ok(None) };
    let values = all.basis.values(source.vertices());
    let points: Vec<Point3<f64>> = source.vertices().iter().map(|p| poses[best].apply(p)).collect();
    let points = displaced(&points, &field, &values);
    let covariances = field.covariances(values.as_ref());
    let Some(transform) = rigid_part(source, &points, (&all.source, &all.target), target.mean_edge_length()) else {
        return Ok(None);
    };
    Ok(Some(DisplacementAnswer {
        best,
        misfits,
        residual_mm,
        transform,
        images: images(target, &points, &covariances),
    }))
}

impl Displacement<'_> {
    /// The first stage: the pose of the lowest misfit, the misfit of each, and the field of the best.
    fn coarse(&self, poses: &[RigidTransform]) -> Result<Option<(usize, Vec<f64>, State)>, MatchError> {
        let (source, target) = (self.source.thinned(self.options.n_coarse), self.target.thinned(self.options.n_coarse));
        let values = self.basis.values(&source.points);
        let mut best: Option<(usize, State)> = None;
        let mut misfits: Vec<f64> = Vec::new();
        for (k, pose) in poses.iter().enumerate() {
            checkpoint(self.observer)?;
            let Some((misfit, state)) = self.coarse_from(pose, &source, &target, &values) else { return Ok(None) };
            if misfits.iter().all(|&m| misfit < m) {
                best = Some((k, state));
            }
            misfits.push(misfit);
        }
        Ok(best.map(|(k, state)| (k, misfits, state)))
    }

    fn coarse_from(
        &self,
        pose: &RigidTransform,
        source: &Thinned,
        target: &Thinned,
        values: &Mat<f64>,
    ) -> Option<(f64, State)> {
        let base: Vec<Point3<f64>> = source.points.iter().map(|p| pose.apply(p)).collect();
        let normals: Vec<Vector3<f64>> = source.normals.iter().map(|n| pose.rotation * n).collect();
        let mut moved = base.clone();
        let assigned = |moved: &[Point3<f64>], sigma: f64, precision: Vec<f64>| {
            let samples = Samples { points: moved, normals: &normals, ..source.samples() };
            assign(&samples, &target.samples(), &likeness(sigma * self.diagonal_mm, precision))
        };
        let [sigma, last_sigma, ..] = self.options.sigma;
        let [density, last_density, ..] = self.options.density;
        let mut precision = precision_of_features(&[1.0; N_FEATURES]);
        let mut field = None;
        for step in 0..self.options.steps[0].max(1) {
            let at = share(step, self.options.steps[0]);
            let sigma = between(sigma, last_sigma, at);
            let found = assigned(&moved, sigma, precision);
            let weight = between(density, last_density, at) / (sigma * self.diagonal_mm).powi(2);
            let fitted = fit(values.as_ref(), &pulls_to_means(&found, &base, &source.areas, weight))?;
            moved = displaced(&base, &fitted, values);
            precision = precision_of_features(&found.feature_variance);
            field = Some(fitted);
        }
        // All poses by one yardstick: a wrong pose that has learned to distrust features must not gain by it.
        let misfit = assigned(&moved, last_sigma, vec![4.0 / N_FEATURES as f64; N_FEATURES]).misfit;
        field.map(|field| (misfit, State { field, feature_precision: precision }))
    }

    /// The other stages; the field and the residual along the normals (robust standard deviation, mm).
    fn refined(&self, pose: &RigidTransform, start: State) -> Result<Option<(FittedField, f64)>, MatchError> {
        let State { mut field, mut feature_precision } = start;
        let (source, target) = (self.source.samples(), self.target.samples());
        let values = self.basis.values(source.points);
        let base: Vec<Point3<f64>> = source.points.iter().map(|p| pose.apply(p)).collect();
        let closest = ClosestPointIndex::new(&self.target.mesh);
        // The faces of a mirrored surface look inwards.
        let turn = if pose.is_reflection() { -1.0 } else { 1.0 };
        let mut residual_mm = 0.0;
        for (stage, &steps) in self.options.steps.iter().enumerate().skip(1) {
            // Settling stays where the fine stage ended.
            let (from, to) = (stage.min(3), (stage + 1).min(3));
            let told = if stage == 3 { (NOISE_MM / residual_mm).powf(NOISE_POWER).min(1.0) } else { 1.0 };
            for step in 0..steps {
                checkpoint(self.observer)?;
                let at = share(step, steps);
                let sigma_mm = self.diagonal_mm * between(self.options.sigma[from], self.options.sigma[to], at);
                let density = told * between(self.options.density[from], self.options.density[to], at);
                let moved = displaced(&base, &field, &values);
                let Ok(mesh) = self.source.mesh.with_vertices(moved) else { return Ok(None) };
                let normals: Vec<Vector3<f64>> = mesh.vertex_normals().iter().map(|n| n * turn).collect();
                let samples = Samples { points: mesh.vertices(), normals: &normals, ..source };
                let found = assign(&samples, &target, &likeness(sigma_mm, feature_precision));
                let across = density / (sigma_mm * sigma_mm);
                let pulls = if stage == 1 {
                    pulls_to_means(&found, &base, source.areas, across)
                } else {
                    let along = density / (ALONG_MM * ALONG_MM);
                    let (pulls, residual) = self.sliding(&found, &samples, &base, &closest, along, across);
                    if stage == 2 {
                        residual_mm = residual;
                    }
                    pulls
                };
                let Some(fitted) = fit(values.as_ref(), &pulls) else { return Ok(None) };
                field = fitted;
                feature_precision = precision_of_features(&found.feature_variance);
            }
        }
        Ok(Some((field, residual_mm)))
    }

    /// Pulls towards the surface along its normals, and weakly towards the assigned means across them.
    fn sliding(
        &self,
        found: &Assignment,
        moved: &Samples<'_>,
        base: &[Point3<f64>],
        closest: &ClosestPointIndex,
        along: f64,
        across: f64,
    ) -> (Vec<Pull>, f64) {
        let pairs: Vec<(Pull, f64)> = (0..base.len())
            .into_par_iter()
            .map(|i| {
                let p = moved.points[i];
                let at = closest.closest(&p);
                let blended = (0..3).fold(Vector3::zeros(), |sum, k| {
                    sum + self.target.normals[at.triangle[k] as usize] * at.barycentric[k]
                });
                let normal = blended.try_normalize(1e-9).unwrap_or(moved.normals[i]);
                let to_surface = at.point - p;
                let to_mean = found.targets[i] - p;
                let height = normal.dot(&to_surface);
                let displacement = (p - base[i]) + to_mean + normal * (height - normal.dot(&to_mean));
                // A point far off, or on the other side, has no counterpart there (Cauchy's weight).
                let trust =
                    normal.dot(&moved.normals[i]).max(0.0) / (1.0 + (to_surface.norm() / (3.0 * ALONG_MM)).powi(2));
                let area = moved.areas[i];
                let across = ACROSS_SHARE * across * area * found.mass[i];
                (Pull { displacement, normal, along: along * area * trust, across }, height.abs())
            })
            .collect();
        let mut heights: Vec<f64> = pairs.iter().map(|p| p.1).collect();
        (pairs.into_iter().map(|p| p.0).collect(), 1.4826 * median(&mut heights))
    }
}
