//! From rigid poses to a smooth displacement field, and from it to sub-vertex correspondences.
//!
//! The source is moved by `T(p) = R p + t + u(p)` with a field `u` of [`homolog_registration::deformation`]: a
//! translation, a linear part and a Gaussian process of width 0.3 diagonals. Expectation and maximisation alternate as in
//! coherent point drift: target vertices are softly assigned to moved source vertices by distance, normals and curvature
//! features, whose variances are estimated in every step; then the field is fitted to the means of the assigned points.
//!
//! 1. **Coarse**, on thinned surfaces, `σ` from 5 % to 4 % of the diagonal, from the two best poses of each handedness
//!    after a few steps from every pose. The pose of the lowest misfit is kept, so that a pose with head and tail
//!    exchanged, or one that mirrors, is compared after its deformation.
//! 2. **Middle**, on all vertices, to 2.5 % of the diagonal.
//! 3. **Fine**: along the normal a vertex is pulled towards the closest point of the target, with the small variance of
//!    points on surfaces; across the normal a tenth of the assignment's weight is kept. So the surface can slide, driven by
//!    the smoothness of the field and the pulls along normals all around. Without that freedom the assignment, which
//!    favours the present place of a vertex, holds every vertex back: in three hard cases of 8 % warps 47 to 89 % of the
//!    vertices were within one edge of the truth, with it 94 to 96 %.
//! 4. **Local**: between closed surfaces of two subjects the field stays stiff. Otherwise, where the residual heights show
//!    displacement over shorter distances, a second kernel is added, of the width and variance under which they are most
//!    probable ([`local`]). On warps with bumps of 0.06 to 0.09 diagonals 0.97 of the vertices are within one edge with it,
//!    0.81 without. Otherwise:
//! 5. **Settling**: copies of one anatomy come within the sampling noise of each other. Two subjects do not: what remains is
//!    individual anatomy, which is correlated over millimetres. The residual along the normals (0.08 to 0.10 mm for
//!    copies, 0.24 to 0.29 mm for two subjects) sets the weight of the observations.
//! 6. **Back**: closed surfaces of two subjects are fitted in the other direction as well, and the mean of the two maps is
//!    the answer ([`both_ways`]).
//!
//! Where the surfaces do not agree after all that, or where a mirror image fits better, tubular surfaces are matched straightened
//! ([`mod@straightened`]), and the stages are run once more from correspondences of bending-invariant forms ([`unbent`]).
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010; Hirose, "A
//! Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021 (prior, weights); Chen, Medioni 1992 (distance
//! from the tangent plane).

mod agreement;
mod along;
mod answer;
mod both_ways;
mod branching;
mod coarse;
mod extremities;
mod fine;
mod finish;
mod fits;
mod forms;
mod functions;
mod guides;
mod isometry;
mod local;
mod pace;
mod rigid;
mod roundness;
mod stages;
mod straightened;
mod surface;
#[cfg(test)]
pub(super) mod tests;
mod track;
mod unbending;
mod unbent;

pub(crate) use agreement::Agreement;
pub(crate) use answer::{Image, images};
pub(crate) use coarse::{ComparedPose, Finer, StartPose};
pub(crate) use forms::Form;
pub(super) use guides::landmark_pose;
pub use isometry::{NearIsometryModel, near_isometry_model};

use super::MatchError;
use super::lengths::Lengths;
use super::side::Which;
use branching::may_branch;
use faer::Mat;
use fine::Refined;
use finish::Turned;
use fits::Fits;
use functions::Functions;
use guides::Guides;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_geometry::curvature::vertex_areas;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::deformation::{GaussianKernel, SmoothPrior};
use homolog_registration::{RigidTransform, SamePose, weighted_moments};
use nalgebra::Point3;
use rayon::prelude::*;
use rigid::RigidPart;
use stages::{Displacement, displaced};
use std::sync::Arc;
use straightened::straightened;
use surface::{SmoothSurface, prepare};

/// Residual along the normals, in sampling distances, from which surfaces count as those of two subjects and are fitted in
/// both directions: warps and copies had 0.09 to 0.11, pairs of subjects 0.20 to 0.33. For one anatomy the fit back only adds its own error:
/// on ten 8 % warps 96.2 % of the vertices were within one edge with it, 97.6 % without.
const TWO_SUBJECTS: f64 = 0.17;

/// Squared error over the trace of the posterior covariance of a wide field. Fitted with that of sampling ([`images`]) to the
/// errors on 4 % and 8 % warps and copies, by deciles of the predicted variance.
const FIELD_SHARE: f64 = 0.25;

/// A start from forms is taken if its misfit at the scale of the sampling is lower by this: on bodies in two poses it was lower
/// by 0.11 to 0.6 than that of a rigid start without the local stage.
const CLEARLY_BETTER: f64 = 0.1;
/// The same between surfaces with limbs ([`branching`]). Where a rigid start ended, local stage and all, with surfaces that agree and a limb
/// that did not correspond, it was lower by 0.04 to 0.2. Where they did not agree, three of twelve realistic people in two poses had 0.06 to
/// 0.08, and with 0.1 all twelve were off by 1.54 % of the diagonal instead of 1.44 %. Other shapes gain as much by chance: cubes, which end on one
/// of their symmetries, 0.034.
const BETTER_WITH_LIMBS: f64 = 0.03;

/// Difference in the straightness of two center lines from which tubular surfaces that agree are straightened too: bends by 90° are
/// at 0.18 and more, pairs of hippocampi at 0.14 and less. This saves time; the misfit decides.
const BENT: f64 = 0.15;
/// Ratio of the variances of the places of two surfaces from which this is looked at.
const UNLIKE_SPREAD: f64 = 1.1;

/// An answer by straightened surfaces is taken if one of its starts, mirrored or not, has a misfit that is lower by this than those of
/// all rigid starts: for bent capsules it is lower by 0.38 to 0.72, for hippocampi with warps and of two subjects by 0.06 at most.
const STRAIGHT: f64 = 0.2;

/// Settings of the displacement. The defaults are round numbers; nearby values gave the same accuracy within its spread. Twice
/// the steps and half again as many inducing points took 1.5 times as long and changed the share of vertices within one edge,
/// and of labels that agree, by 0.003 at most (37 pairs).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DisplacementOptions {
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
    /// Independent observations over a surface at the start and after each of the first three stages; more of them make the
    /// field less stiff.
    pub density: [f64; 4],
}

impl Default for DisplacementOptions {
    fn default() -> Self {
        DisplacementOptions {
            width: 0.3,
            amplitude: 0.1,
            linear: 0.2,
            n_inducing: 100,
            n_samples: [700, 1200, 1200, 1200],
            steps: [10, 8, 8, 4],
            sigma: [0.05, 0.04, 0.025, 0.02],
            density: [48.0, 48.0, 160.0, 480.0],
        }
    }
}

/// The surfaces of a displacement, in canonical numbering, mm.
#[derive(Clone, Copy)]
pub(crate) struct Surfaces<'a> {
    /// The surface that the field is fitted on.
    pub source: &'a SurfaceMesh,
    /// The surface that it is fitted to.
    pub target: &'a SurfaceMesh,
    /// The source whose vertices get images.
    pub full_source: &'a SurfaceMesh,
    /// The target on which the images lie.
    pub full_target: &'a SurfaceMesh,
    /// Closest points of `full_source`.
    pub source_closest: &'a ClosestPointIndex,
    /// Closest points of `full_target`.
    pub target_closest: &'a ClosestPointIndex,
    /// Pairs of points that are known to correspond.
    pub landmarks: &'a [Landmark],
    /// Whether a part of either surface may be missing.
    pub open: bool,
    /// Which of them shows a part of what the other shows, if one does.
    pub part: Option<Which>,
    pub lengths: Lengths,
    /// How surfaces that no rigid motion brings together are matched.
    pub bending: Bending,
    /// The bending-invariant form of a surface that the fields are fitted on, made when it is asked for.
    pub form_of: &'a (dyn Fn(Which) -> Option<&'a Form> + Sync),
}

impl Surfaces<'_> {
    /// Whether the pair is fitted from the target to the source: from the surface that is more spread out for its area. Places
    /// that lie far apart along it lie far apart in space as well, and a field can move them differently; on a bent surface
    /// they may be neighbors.
    fn is_fitted_backwards(&self) -> bool {
        spread(self.full_target) > spread(self.full_source)
    }

    /// The pair in the other direction.
    fn swapped<'b>(
        &'b self,
        landmarks: &'b [Landmark],
        form_of: &'b (dyn Fn(Which) -> Option<&'b Form> + Sync),
    ) -> Surfaces<'b> {
        Surfaces {
            source: self.target,
            target: self.source,
            full_source: self.full_target,
            full_target: self.full_source,
            source_closest: self.target_closest,
            target_closest: self.source_closest,
            landmarks,
            form_of,
            open: self.open,
            part: self.part.map(Which::other),
            lengths: self.lengths,
            bending: self.bending,
        }
    }
}

/// Whether one surface is more spread out than the other, for its area.
fn differ_in_spread(surfaces: &Surfaces<'_>) -> bool {
    let (a, b) = (spread(surfaces.source), spread(surfaces.target));
    a.max(b) > UNLIKE_SPREAD * a.min(b)
}

/// Variance of the places on a surface, over its area.
fn spread(mesh: &SurfaceMesh) -> f64 {
    let areas = vertex_areas(mesh);
    let total: f64 = areas.iter().sum();
    weighted_moments(mesh.vertices(), &areas, total).map_or(0.0, |(_, scatter)| scatter.trace() / (total * total))
}

/// The result of a displacement.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DisplacementAnswer {
    /// The image of each source vertex.
    pub images: Vec<Image>,
    /// The rigid transform of these correspondences.
    pub transform: RigidTransform,
    /// Poses that were compared in the coarse stage, the one that was kept first.
    pub compared: Vec<ComparedPose>,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
    /// How well the surfaces agree after the deformation.
    pub agreement: Agreement,
    /// How far the deformation is from one that keeps angles, [`agreement::distortion`].
    pub distortion: f64,
}

/// Corresponding points of the source on the target, from the best of the rigid `poses`. A pose that mirrors takes part in
/// the comparison, but is kept only with `allow_reflection`.
///
/// Closed surfaces of two subjects are fitted from the one that is more spread out, and the map in the other direction is the
/// inverse of it: there and back is the same place.
///
/// `None` if no pose may be kept, or where numbers that are not finite make a fit impossible. The same bits on any number of
/// threads.
///
/// # Errors
/// [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
///
/// # Cost
/// `O(steps · n · (pairs + M²))` for `M` functions of the field, about 30 for the defaults and 140 with a second kernel; twice
/// that for two subjects.
pub(crate) fn displace(
    surfaces: &Surfaces<'_>,
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &dyn Observer,
) -> Result<Option<DisplacementAnswer>, MatchError> {
    let observer = Fits::new(observer);
    let found = if surfaces.part == Some(Which::Target) {
        from_part(surfaces, poses, allow_reflection, options, &observer)?
    } else {
        from_source(surfaces, poses, allow_reflection, options, &observer)?
    };
    Ok(found.map(|(found, compared)| {
        let Deformed { moved, variances, transform, residual_mm, agreement, distortion } = found;
        let (target, closest) = (surfaces.full_target, surfaces.target_closest);
        let images = images(target, closest, &moved, &variances, surfaces.lengths.sampling_mm);
        DisplacementAnswer { images, transform, compared, residual_mm, agreement, distortion }
    }))
}

/// [`deformed`], with the surfaces prepared.
fn from_source(
    surfaces: &Surfaces<'_>,
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &Fits<'_>,
) -> Result<Option<(Deformed, Vec<ComparedPose>)>, MatchError> {
    let Surfaces { source, target, lengths, part, .. } = *surfaces;
    let prepared = prepare(source, target, lengths.root_mm, part == Some(Which::Source))?;
    checkpoint(observer)?;
    deformed(surfaces, prepared, poses, allow_reflection, options, observer)
}

/// The same for a target that is a part of the source: the part is deformed onto the whole, of which a field would have to press the rest into
/// the part, and the answer is the inverse map.
fn from_part(
    surfaces: &Surfaces<'_>,
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &Fits<'_>,
) -> Result<Option<(Deformed, Vec<ComparedPose>)>, MatchError> {
    let landmarks: Vec<Landmark> = surfaces.landmarks.iter().map(swapped).collect();
    let form_of = |which: Which| (surfaces.form_of)(which.other());
    let poses: Vec<StartPose> = poses.iter().map(|start| StartPose { pose: start.pose.inverse(), ..*start }).collect();
    let turned = surfaces.swapped(&landmarks, &form_of);
    let found = from_source(&turned, &poses, allow_reflection, options, observer)?;
    Ok(found.and_then(|(found, mut compared)| {
        for start in &mut compared {
            start.of_form = start.of_form.map(|pose| pose.inverse());
        }
        Some((found.inverse(surfaces.full_target, surfaces.full_source)?, compared))
    }))
}

/// One surface deformed onto another.
struct Deformed {
    /// The vertices of the source, mm.
    moved: Vec<Point3<f64>>,
    /// Posterior variance of each, mm².
    variances: Vec<f64>,
    transform: RigidTransform,
    residual_mm: f64,
    agreement: Agreement,
    distortion: f64,
}

impl Deformed {
    /// The vertices of `target` moved to `source`, the surface that was deformed. `None` where a number is not finite.
    ///
    /// Cost `O(n' log n)`.
    fn inverse(self, source: &SurfaceMesh, target: &SurfaceMesh) -> Option<Deformed> {
        let outwards = if self.transform.is_reflection() { -1.0 } else { 1.0 };
        let deformed = source.with_vertices(self.moved).ok()?;
        let (before, after) = (source.vertex_normals(), deformed.vertex_normals());
        let index = ClosestPointIndex::new(&deformed);
        let on_rim = deformed.boundary_vertices();
        let back = self.transform.inverse();
        let inverse = |q: &Point3<f64>| {
            let at = index.closest(q);
            if on_rim.as_ref().is_some_and(|ends| at.is_between(|k| ends[k])) {
                // Beyond the rim there is nothing to stand on: as far from it as `q` is from the deformed one.
                let image = at.blend(|k| source.vertices()[k].coords) + back.rotation * (q - at.point);
                return (Point3::from(image), at.blend(|k| self.variances[k]));
            }
            let height = outwards * at.blend(|k| after[k]).normalize().dot(&(q - at.point));
            let image = at.blend(|k| source.vertices()[k].coords) + at.blend(|k| before[k]).normalize() * height;
            (Point3::from(image), at.blend(|k| self.variances[k]))
        };
        let (moved, variances) = target.vertices().par_iter().map(inverse).unzip();
        Some(Deformed { moved, variances, transform: self.transform.inverse(), ..self })
    }
}

fn swapped(landmark: &Landmark) -> Landmark {
    Landmark { source_mm: landmark.target_mm, target_mm: landmark.source_mm, ..landmark.clone() }
}

/// The source deformed onto the target, and the poses that were compared, the one that was kept first.
fn deformed(
    surfaces: &Surfaces<'_>,
    (smooth_source, smooth_target): (Arc<SmoothSurface>, Arc<SmoothSurface>),
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &Fits<'_>,
) -> Result<Option<(Deformed, Vec<ComparedPose>)>, MatchError> {
    let Surfaces { source, landmarks, open, part, lengths, .. } = *surfaces;
    let Some(functions) = functions(source, &smooth_source, options) else { return Ok(None) };
    let guides = Guides::new(landmarks, &functions, lengths.root_mm);
    let forward = Displacement {
        source: smooth_source,
        target: smooth_target,
        functions,
        guides,
        diagonal_mm: diagonal_mm(source),
        lengths,
        same_place: part.is_some().then(|| SamePose::of_place(source.vertices(), &vertex_areas(source))),
        options,
        observer,
    };
    let may_answer = |pose: &RigidTransform| allow_reflection || !pose.is_reflection();
    let Some((mut compared, state)) = forward.coarse(poses, may_answer)? else { return Ok(None) };
    let pose = poses[compared[0].pose].pose;
    let fits_worse_than_its_mirror_image = compared.iter().any(|c| c.mirrored && c.misfit < compared[0].misfit);
    let mut turned = None;
    if !open && surfaces.is_fitted_backwards() {
        turned = forward.turned(surfaces, &pose)?.filter(Turned::is_of_two_subjects);
    }
    let branching = !compared[0].mirrored && may_branch(surfaces);
    // Whether another start is needed shows before a field is narrow enough to hide that it does not lead to the truth.
    if !fits_worse_than_its_mirror_image
        && !branching
        && let Some(turned) = turned.take_if(|turned| !turned.is_doubtful())
    {
        let found = turned.finished(surfaces)?;
        return Ok(found.map(|found| (found, compared)));
    }
    let Some(fine) = forward.fine(state)? else { return Ok(None) };
    let wide = fine.moved();
    // Copies of which a part is missing need no other start and no field, whatever one does to them at their rim.
    let edge_mm = surfaces.target.mean_edge_length();
    if open
        && let Some(RigidPart { transform, copies: true }) =
            forward.rigid_part(source, &wide, pose.is_reflection(), edge_mm, open)?
    {
        // Another pose is as good if it makes them copies too.
        for other in &mut compared[1..] {
            let is_other = forward.copies_elsewhere(&poses[other.pose].pose, &transform, edge_mm)?;
            other.finer = if is_other { Finer::AsGood } else { Finer::Outdone };
        }
        return Ok(Some((forward.posed(surfaces, transform, fine.residual_mm), compared)));
    }
    compared.retain(|start| start.finer != Finer::Same);
    let mut unbent = None;
    // Neither straightened surfaces nor correspondences of the forms are tried for a pose that mirrors.
    let doubtful = fits_worse_than_its_mirror_image || forward.agreement(&wide).is_doubtful();
    let of_one_shape = fine.residual_mm < TWO_SUBJECTS * lengths.sampling_mm;
    let if_bent_by = match surfaces.bending {
        Bending::None => None,
        _ if doubtful => Some(0.0),
        // Of one shape, surfaces that agree may still be bent against each other.
        _ if of_one_shape && differ_in_spread(surfaces) => Some(BENT),
        _ => None,
    };
    if !compared[0].mirrored
        && let Some(if_bent_by) = if_bent_by
        && let Some(found) = straightened(surfaces, if_bent_by, allow_reflection, options, observer)?
        && least_misfit(&found.1) < least_misfit(&compared) - STRAIGHT
    {
        return Ok(Some(found));
    }
    let (mut fine, mut refined) = (Some(fine), None);
    if !compared[0].mirrored
        && (doubtful || branching)
        && let (Some(of_source), Some(of_target)) =
            ((surfaces.form_of)(Which::Source), (surfaces.form_of)(Which::Target))
    {
        // Surfaces that agree are as close as they come only after the local stage.
        if !doubtful && let Some(fine) = fine.take() {
            refined = forward.refined_from(fine)?;
        }
        let reached = refined.as_ref().map_or(wide, |found| found.moved(&forward.source.mesh).0);
        let better = if branching { BETTER_WITH_LIMBS } else { CLEARLY_BETTER };
        let to_beat = forward.fine_misfit(reached, false) - better;
        unbent = forward.unbent(of_source, of_target, to_beat)?;
    }
    let refined = match unbent {
        Some(unbent) => {
            // Rigid poses say nothing of the handedness of a surface that bends.
            compared.retain(|rigid| !(rigid.mirrored && unbent.is_of_same_handedness));
            // They were outdone by the misfit at the scale of the sampling.
            compared.iter_mut().for_each(|rigid| rigid.finer = Finer::Outdone);
            compared = unbent.compared.into_iter().chain(compared).collect();
            Some(unbent.refined)
        }
        None => {
            if let Some(turned) = turned {
                let found = turned.finished(surfaces)?;
                return Ok(found.map(|found| (found, compared)));
            }
            match fine {
                Some(fine) => forward.refined_from(fine)?,
                None => refined,
            }
        }
    };
    let Some(refined) = refined else { return Ok(None) };
    let found = forward.finished(surfaces, refined, &pose)?;
    Ok(found.map(|found| (found, compared)))
}

fn least_misfit(compared: &[ComparedPose]) -> f64 {
    compared.iter().map(|start| start.misfit).fold(f64::INFINITY, f64::min)
}

/// The prior of the displacement of `mesh`, on its smooth version.
fn functions(mesh: &SurfaceMesh, smooth: &SmoothSurface, options: &DisplacementOptions) -> Option<Functions> {
    Functions::new(smooth.mesh.vertices(), prior(diagonal_mm(mesh), options), options.n_inducing, None)
}

/// The prior of the displacement of a surface with this diagonal.
fn prior(diagonal_mm: f64, options: &DisplacementOptions) -> SmoothPrior {
    SmoothPrior {
        translation_mm: options.amplitude * diagonal_mm,
        linear: options.linear,
        kernels: vec![GaussianKernel {
            width_mm: options.width * diagonal_mm,
            amplitude_mm: options.amplitude * diagonal_mm,
        }],
    }
}

fn diagonal_mm(mesh: &SurfaceMesh) -> f64 {
    let (low, high) = mesh.bounding_box();
    (high - low).norm()
}

impl Refined {
    /// The vertices of `mesh` moved by the base and the field, and the functions of the field there.
    fn moved(&self, mesh: &SurfaceMesh) -> (Vec<Point3<f64>>, Mat<f64>) {
        let values = self.functions.values(mesh.vertices());
        let base = if self.local.is_some() && self.base.bend.is_some() {
            self.base.moved(mesh.vertices(), &self.base_functions.values(mesh.vertices()))
        } else {
            self.base.moved(mesh.vertices(), &values)
        };
        (displaced(&base, &self.field, &values), values)
    }
}
