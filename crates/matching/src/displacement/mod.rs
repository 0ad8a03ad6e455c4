//! From rigid poses to a smooth displacement field, and from it to sub-vertex correspondences.
//!
//! The source is moved by `T(p) = R p + t + u(p)`, `u` a field of [`homolog_registration::deformation`]: a translation, a linear part
//! and a Gaussian process of width 0.3 diagonals. Expectation and maximisation alternate as in coherent point drift:
//! target vertices are assigned softly to moved source vertices by distance, normals and curvature features, whose
//! variances are estimated anew each time; then the field is fitted to the means of what was assigned.
//!
//! 1. **Coarse**, on thinned surfaces, `σ` from 5 % to 4 % of the diagonal, from the two best poses of each handedness
//!    after a glance at all; the pose of the lowest misfit is kept, so a pose that is turned head to tail, or one that
//!    mirrors, is judged after it had its chance to bend.
//! 2. **Middle**, on all vertices, to 2.5 % of the diagonal.
//! 3. **Fine**: the pull along the normal is towards the closest point of the surface, with the small variance of
//!    points on surfaces; across the normal a tenth of the assignment's weight is left. The surface slides, and what
//!    slides it is the field's smoothness against normals all around. Without that freedom the assignment, which
//!    prefers where a vertex already is, holds every vertex back: on 8 % warps 0.47-0.89 of the vertices of three hard
//!    cases were within one edge, with it 0.94-0.96.
//! 4. **Settling**: copies of one anatomy come within the sampling noise of each other; two subjects do not, and what
//!    is left is anatomy of their own that is correlated over millimetres. The residual along the normals, which lay at
//!    0.08-0.10 mm in the one case and at 0.24-0.29 mm in the other, says how much each square millimetre tells.
//! 5. **Back**: closed surfaces of two subjects are also fitted in the other direction, and the middle is answered
//!    ([`both_ways`]).
//! 6. **Anatomy**: of two hippocampi the images slide along the long axis, so that borders seen from the form meet
//!    ([`super::border`]).
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010; Hirose, "A
//! Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021 (prior, weights); Chen, Medioni 1992 (distance
//! from the tangent plane).

mod agreement;
mod answer;
mod both_ways;
mod coarse;
mod fine;
mod guides;
mod rigid;
mod stages;
mod surface;
#[cfg(test)]
pub(super) mod tests;

pub use agreement::Agreement;
pub use answer::Image;
pub use coarse::{JudgedPose, StartPose};
pub(super) use guides::landmark_pose;

use super::MatchError;
use super::border::Slide;
use super::surface_index::SurfaceIndex;
use answer::images;
use both_ways::WayBack;
use faer::Mat;
use guides::Guides;
use homolog_contract::parameters::{Anatomy, Landmark};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::RigidTransform;
use homolog_registration::deformation::{FieldBasis, FittedField, GaussianKernel, SmoothPrior};
use nalgebra::Point3;
use stages::{Displacement, displaced};
use surface::{SmoothSurface, prepare};

/// Residual along the normals, mm, from which surfaces are of two subjects and are fitted both ways: warps and copies had
/// 0.08 to 0.10, pairs of subjects 0.18 to 0.29. For one anatomy the way back adds only its own error: on ten 8 % warps
/// 0.962 of the vertices were within one edge with it, 0.976 without.
const TWO_SUBJECTS_MM: f64 = 0.15;

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
    /// Vertices of the thinned surfaces in each stage; from the fine stage on the target has all.
    pub n_samples: [usize; 4],
    /// Steps of the four stages.
    pub steps: [u32; 4],
    /// `σ` in diagonals at the start and after each of the first three stages.
    pub sigma: [f64; 4],
    /// Independent observations a square millimetre at the start and after each of the first three stages: from stiff
    /// to soft.
    pub density: [f64; 4],
    /// What is known of the structure.
    pub anatomy: Anatomy,
}

impl Default for DisplacementOptions {
    fn default() -> Self {
        DisplacementOptions {
            width: 0.3,
            amplitude: 0.1,
            linear: 0.2,
            n_inducing: 150,
            n_samples: [700, 1200, 1200, 1200],
            steps: [20, 15, 15, 8],
            sigma: [0.05, 0.04, 0.025, 0.02],
            density: [0.03, 0.03, 0.1, 0.3],
            anatomy: Anatomy::Any,
        }
    }
}

/// The surfaces of a displacement, in canonical numbering, mm.
#[derive(Clone, Copy)]
pub struct Surfaces<'a> {
    /// What the field is fitted on.
    pub source: &'a SurfaceMesh,
    /// What it is fitted to.
    pub target: &'a SurfaceMesh,
    /// Whose vertices are answered.
    pub full_source: &'a SurfaceMesh,
    /// On which they are answered.
    pub full_target: &'a SurfaceMesh,
    /// Its closest points.
    pub full_closest: &'a ClosestPointIndex,
    /// Points that are known to correspond.
    pub landmarks: &'a [Landmark],
}

/// What displacement found.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplacementAnswer {
    /// Where each source vertex goes.
    pub images: Vec<Image>,
    /// The rigid transform of these correspondences.
    pub transform: RigidTransform,
    /// Poses that were followed through the coarse stage: first the one that was kept.
    pub judged: Vec<JudgedPose>,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
    /// How alike the surfaces are after the bending.
    pub agreement: Agreement,
    /// What the anatomy moved; `None` where it had no say.
    pub slide: Option<AnatomicalSlide>,
}

/// By how much images slid for what is known of the structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnatomicalSlide {
    /// How unlike the structure source and target are, in standard deviations of those it was learned from.
    pub distances: [f64; 2],
    /// Root mean square over the source vertices, mm.
    pub rms_mm: f64,
}

/// Correspondences of the source on the target, from each of the rigid `poses`. One that
/// mirrors is followed for comparison, and answered only with `allow_reflection`.
///
/// `None` without poses that may be answered, or where numbers that are not finite make a fit impossible. The same bits on any number of threads.
///
/// # Errors
/// [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
///
/// # Cost
/// `O(steps · n · (pairs + M²))` for `M` functions of the field, about 40 for the defaults;
/// twice that for two subjects.
pub fn displace(
    surfaces: &Surfaces<'_>,
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &dyn Observer,
) -> Result<Option<DisplacementAnswer>, MatchError> {
    let Surfaces { source, target, full_source, full_target, full_closest, landmarks } = *surfaces;
    let (smooth_source, smooth_target) = prepare(source, target)?;
    checkpoint(observer)?;
    let Some(basis) = basis(source, &smooth_source, options) else { return Ok(None) };
    let guides = Guides::new(landmarks, &basis);
    let forth = Displacement {
        closest: SurfaceIndex::with_normals(&smooth_target.mesh, smooth_target.normals.clone()),
        source: smooth_source,
        target: smooth_target,
        basis,
        guides,
        diagonal_mm: diagonal_mm(source),
        options,
        observer,
    };
    let may_answer = |pose: &RigidTransform| allow_reflection || !pose.is_reflection();
    let Some((judged, state)) = forth.coarse(poses, may_answer)? else { return Ok(None) };
    let pose = poses[judged[0].pose].pose;
    // What is missing on one side comes back nowhere.
    let open = [source, target].iter().any(|mesh| mesh.boundary_vertices().is_some());
    let Some((field, residual_mm)) = forth.refined(&pose, state)? else { return Ok(None) };
    let (own, _) = forth.moved(source, &pose, &field);
    // The middle of two fits agrees with anything better than either, so that likeness is judged before.
    let agreement = forth.agreement(&own);
    let returned = if open || residual_mm < TWO_SUBJECTS_MM { None } else { forth.returned(surfaces, &pose)? };
    let back = returned.and_then(|returned| WayBack::new(full_target, full_closest, returned));
    let met = |mesh: &SurfaceMesh, points: Vec<Point3<f64>>| match &back {
        Some(back) => back.met(mesh.vertices(), &points),
        None => points,
    };
    let fitted = met(source, own);
    let Some(rigid) = forth.rigid_part(source, &fitted, target.mean_edge_length(), open)? else { return Ok(None) };
    let (points, values) = forth.moved(full_source, &pose, &field);
    let mut points = met(full_source, points);
    if rigid.copies && open {
        // A field bends what has no counterpart towards the rim, and with it what has one.
        points = full_source.vertices().iter().map(|p| rigid.transform.apply(p)).collect();
    }
    // The two fits met in the middle, so that what they left to chance can be told; landmarks say more than a form does.
    let says = options.anatomy == Anatomy::Hippocampus && back.is_some() && landmarks.is_empty();
    let slide = if says { Slide::new(source, target, &fitted, &rigid.transform.rotation) } else { None };
    let report = slide.as_ref().map(|s| AnatomicalSlide { distances: s.distances, rms_mm: s.rms_mm(&points) });
    if let Some(slide) = &slide {
        points = slide.moved(full_closest, &points);
    }
    let images = images(full_target, full_closest, &points, &field.covariances(values.as_ref()));
    let transform = rigid.transform;
    Ok(Some(DisplacementAnswer { images, transform, judged, residual_mm, agreement, slide: report }))
}

/// What is believed of the displacement of `mesh` before anything is seen, on its smooth version.
fn basis(mesh: &SurfaceMesh, smooth: &SmoothSurface, options: &DisplacementOptions) -> Option<FieldBasis> {
    let diagonal_mm = diagonal_mm(mesh);
    let prior = SmoothPrior {
        translation_mm: options.amplitude * diagonal_mm,
        linear: options.linear,
        kernels: vec![GaussianKernel {
            width_mm: options.width * diagonal_mm,
            amplitude_mm: options.amplitude * diagonal_mm,
        }],
    };
    FieldBasis::new(smooth.mesh.vertices(), prior, options.n_inducing)
}

fn diagonal_mm(mesh: &SurfaceMesh) -> f64 {
    let (low, high) = mesh.bounding_box();
    (high - low).norm()
}

impl Displacement<'_> {
    /// Where `pose` and `field` move the vertices of `mesh`, with the functions of the field there.
    fn moved(&self, mesh: &SurfaceMesh, pose: &RigidTransform, field: &FittedField) -> (Vec<Point3<f64>>, Mat<f64>) {
        let values = self.basis.values(mesh.vertices());
        let base: Vec<Point3<f64>> = mesh.vertices().iter().map(|p| pose.apply(p)).collect();
        (displaced(&base, field, &values), values)
    }

    /// Where the vertices of the full target go on the source by a fit in that direction, from the inverse of `pose`.
    fn returned(&self, surfaces: &Surfaces<'_>, pose: &RigidTransform) -> Result<Option<Vec<Point3<f64>>>, MatchError> {
        let Some(basis) = basis(surfaces.target, &self.target, self.options) else { return Ok(None) };
        let back = Displacement {
            source: self.target.clone(),
            target: self.source.clone(),
            closest: SurfaceIndex::with_normals(&self.source.mesh, self.source.normals.clone()),
            guides: self.guides.swapped(&basis),
            basis,
            diagonal_mm: diagonal_mm(surfaces.target),
            options: self.options,
            observer: self.observer,
        };
        let inverse = pose.inverse();
        let Some(state) = back.coarse_alone(&inverse) else { return Ok(None) };
        let Some((field, _)) = back.refined(&inverse, state)? else { return Ok(None) };
        Ok(Some(back.moved(surfaces.full_target, &inverse, &field).0))
    }
}
