//! Relaxation: an answer slides along the target to the posterior mean of its field.
//!
//! A fit to assigned points converges slowly along a smooth surface: the assignments of a point slide with it, so they
//! pull it back to where it is, and it keeps most of the slide that it had when the stages became precise. Copies of a
//! smooth solid were off by half an edge in this way. Here each observation states only what it determines: the
//! component along the normal, and those along the gradients of the features, each with its noise
//! ([`super::uncertainty`]). Their posterior mean under the process that is most probable for this pair is found by
//! Gauss-Newton steps, and confidence is the posterior variance of the same model. Points slide along the target; their
//! distance from it is left as it was fitted.
//!
//! Shapes of two subjects differ along the normals without a displacement as well. A relaxation takes this for one and
//! slides after it: maps of a group vary more, labels and landmarks are met less often. Their answer is left where both
//! fits meet, and only its spread is found with a relaxation ([`super::roundness`]).
//!
//! An answer on a bent base has no rigid start, relative to which a displacement would be small; it is left as it is.

use super::base::InitialMap;
use super::displacement::FitContext;
use super::uncertainty::{MOST_VARIANCES, Noise, ObservationSample, Process, gradient};
use crate::error::MatchError;
use crate::pair::assignment::FEATURE_SHARE;
use crate::surface::smooth::{N_FEATURES, Subsample};
use crate::surface::surface_index::ClosestInSteps;
use faer::Mat;
use homolog_mesh::{ClosestPoint, SurfaceMesh};
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use homolog_registration::deformation::{FittedField, Information, fit_field_to};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Inducing points of the field.
const N_INDUCING: usize = 100;
/// Most Gauss-Newton steps.
const MOST_STEPS: usize = 10;
/// Root mean square movement in a step below which it is the last, in sampling distances.
const CONVERGED_STEP_SAMPLINGS: f64 = 0.02;
/// Slides of all points towards their places under the last field: each follows the tangent plane where a point is, so a
/// single one would leave curved surfaces.
const SLIDES: usize = 2;
/// Weight of each feature: as much in all as that of those that uncertainty observes, as they are highly correlated.
const WEIGHT_OF_FEATURE: f64 = 2.0 * FEATURE_SHARE / N_FEATURES as f64;

/// Points of the source and where they are moved, mm.
pub(super) struct PointSet<'a> {
    pub points: &'a [Point3<f64>],
    pub moved: &'a mut Vec<Point3<f64>>,
}

/// The noise of heights and features, estimated from the pair.
struct NoiseModel {
    of_heights: Noise,
    of_features: Vec<Option<Noise>>,
}

/// The process of a displacement and the noise of what is observed of it, both estimated from the pair.
pub(super) struct RelaxationModel {
    pub process: Process,
    noises: NoiseModel,
    /// Gradients of the features at the vertices of the target.
    slopes: Vec<[Vector3<f64>; N_FEATURES]>,
}

impl RelaxationModel {
    /// Those of the displacement of the smooth source from the pose `rigid` to `moved`; `None` without a displacement.
    pub(super) fn of(
        displacement: &FitContext<'_>,
        rigid: &RigidTransform,
        moved: &[Point3<f64>],
    ) -> Option<RelaxationModel> {
        let start: Vec<Point3<f64>> = displacement.source.mesh.vertices().iter().map(|p| rigid.apply(p)).collect();
        let sample = ObservationSample::of(displacement, (&start, moved), MOST_VARIANCES);
        let process = sample.process(displacement)?;
        let root_mm = displacement.lengths.root_mm;
        let noises = NoiseModel {
            of_heights: sample.noise_of_heights(process.noise_mm, root_mm),
            of_features: (0..N_FEATURES).map(|feature| sample.noise_of_feature(feature, root_mm)).collect(),
        };
        let target = &displacement.target;
        Some(RelaxationModel { process, noises, slopes: slopes(&target.mesh, &target.features) })
    }
}

/// The end of a relaxation.
pub(super) struct Relaxed {
    /// Where the points of the subsample are moved, mm.
    pub places: Vec<Point3<f64>>,
    /// The last field, relative to the rigid pose.
    field: FittedField,
}

/// What all steps of a relaxation share: the observations of the source at a subsample, and a field under the process.
pub(super) struct Relaxation<'a> {
    joint: FitContext<'a>,
    model: &'a RelaxationModel,
    thinned: Subsample,
    /// Each function of the field at the points of the subsample, and below these at the landmarks.
    values: Mat<f64>,
    /// Variance along an axis, mm², that the functions cannot express at each point.
    unexpressed: Vec<f64>,
}

impl<'a> Relaxation<'a> {
    /// At most `n_points` are observed, and the field has `n_inducing` inducing points. `None` if a number is not finite.
    pub(super) fn new(
        displacement: &'a FitContext<'_>,
        model: &'a RelaxationModel,
        (n_points, n_inducing): (usize, usize),
    ) -> Option<Relaxation<'a>> {
        let vertices = displacement.source.mesh.vertices();
        let joint = displacement.with_functions(displacement.functions.with_prior(
            vertices,
            model.process.prior.clone(),
            n_inducing,
        )?);
        let thinned = joint.source.thinned(n_points);
        let of_points = joint.functions.values(&thinned.points);
        let unexpressed = joint.functions.unexpressed(&of_points);
        let values = joint.guides.below(of_points);
        Some(Relaxation { joint, model, thinned, values, unexpressed })
    }

    /// The points of the subsample, mm.
    pub(super) fn points(&self) -> &[Point3<f64>] {
        &self.thinned.points
    }

    /// The vertices of the smooth source that are these points.
    pub(super) fn vertices(&self) -> &[usize] {
        &self.thinned.vertices
    }

    /// The relaxation of the displacement from the pose `rigid` of the vertices of the smooth source to `moved`. `None` if a
    /// number is not finite.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(super) fn relaxed(&self, rigid: &RigidTransform, moved: &[Point3<f64>]) -> Result<Option<Relaxed>, MatchError> {
        let Relaxation { joint, model: RelaxationModel { noises, slopes, .. }, thinned, values, unexpressed } = self;
        let guided: Vec<Information> =
            joint.guides.observations(&InitialMap::rigid(*rigid)).iter().map(Information::from).collect();
        let starts: Vec<Point3<f64>> = thinned.points.iter().map(|p| rigid.apply(p)).collect();
        let mut places: Vec<Point3<f64>> = thinned.vertices.iter().map(|&i| moved[i]).collect();
        let (mut last, mut closest) = (None, ClosestInSteps::default());
        for _ in 0..MOST_STEPS {
            checkpoint(joint.observer)?;
            let at = closest.of(&joint.target.closest().index, &places);
            let mut known = observed(joint, (thinned, unexpressed), (&starts, &places, at), (noises, slopes));
            known.extend_from_slice(&guided);
            let Some(field) = fit_field_to(values.as_ref(), &known) else { return Ok(None) };
            let wanted = field.displacements(values.as_ref());
            let next = slid(joint, rigid, (&thinned.points, &places, at), &wanted);
            let squares: f64 = next.iter().zip(&places).map(|(p, q)| (p - q).norm_squared()).sum();
            if !squares.is_finite() {
                return Ok(None);
            }
            places = next;
            last = Some(field);
            if squares <= places.len() as f64 * (CONVERGED_STEP_SAMPLINGS * joint.lengths.sampling_mm).powi(2) {
                break;
            }
        }
        Ok(last.map(|field| Relaxed { places, field }))
    }

    /// Slides `points` of the source at `moved` to their places under `field`.
    fn slide(&self, rigid: &RigidTransform, field: &FittedField, PointSet { points, moved }: &mut PointSet<'_>) {
        let wanted = field.displacements(self.joint.functions.values(points).as_ref());
        let mut closest = ClosestInSteps::default();
        for _ in 0..SLIDES {
            let at = closest.of(&self.joint.target.closest().index, moved);
            **moved = slid(&self.joint, rigid, (points, moved, at), &wanted);
        }
    }
}

/// Slides the vertices of the smooth source at `moved`, and those of the other `sets`, to the posterior mean of the
/// displacement from the pose `rigid`. They stay where a number is not finite.
///
/// # Cost
/// For each step `O(n M² + M³)` for at most 1,200 points and `M` functions.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(super) fn relax(
    displacement: &FitContext<'_>,
    model: &RelaxationModel,
    rigid: &RigidTransform,
    moved: &mut Vec<Point3<f64>>,
    sets: &mut [PointSet<'_>],
) -> Result<(), MatchError> {
    let Some(relaxation) = Relaxation::new(displacement, model, (displacement.options.fine.n_samples, N_INDUCING))
    else {
        return Ok(());
    };
    let Some(Relaxed { field, .. }) = relaxation.relaxed(rigid, moved)? else { return Ok(()) };
    relaxation.slide(rigid, &field, &mut PointSet { points: displacement.source.mesh.vertices(), moved });
    sets.iter_mut().for_each(|set| relaxation.slide(rigid, &field, set));
    Ok(())
}

/// The gradients of the features at each vertex: means over the triangles around it, weighted by area. Between vertices
/// they are interpolated, so that they change smoothly as a point slides. `features`: [`N_FEATURES`] of each vertex.
fn slopes(mesh: &SurfaceMesh, features: &[f64]) -> Vec<[Vector3<f64>; N_FEATURES]> {
    let vertices = mesh.vertices();
    let mut sums = vec![([Vector3::zeros(); N_FEATURES], 0.0); vertices.len()];
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|k| vertices[k as usize]);
        let doubled_area = (b - a).cross(&(c - a)).norm();
        let of_feature = |feature| gradient(vertices, &triangle, |k| features[k * N_FEATURES + feature]) * doubled_area;
        let gradients: [Vector3<f64>; N_FEATURES] = std::array::from_fn(of_feature);
        for corner in triangle {
            let (sum, total) = &mut sums[corner as usize];
            for (sum, gradient) in sum.iter_mut().zip(&gradients) {
                *sum += gradient;
            }
            *total += doubled_area;
        }
    }
    let mean = |(sum, total): ([Vector3<f64>; N_FEATURES], f64)| {
        if total > 0.0 { sum.map(|gradient| gradient / total) } else { sum }
    };
    sums.into_iter().map(mean).collect()
}

/// Observations of the displacement at each point of `thinned`, which is displaced from `starts` to `places`, with the
/// closest points of the target there. Nothing is known beyond the rim of the target. `unexpressed`: the variance along an axis,
/// mm², that the functions cannot express at each point, which is noise of what is observed there.
fn observed(
    displacement: &FitContext<'_>,
    (thinned, unexpressed): (&Subsample, &[f64]),
    (starts, places, closest): (&[Point3<f64>], &[Point3<f64>], &[ClosestPoint]),
    (noises, slopes): (&NoiseModel, &[[Vector3<f64>; N_FEATURES]]),
) -> Vec<Information> {
    let (source, target) = (&displacement.source, &displacement.target);
    let of_point = |k: usize| {
        let (i, area, unexpressed) = (thinned.vertices[k], thinned.areas[k], unexpressed[k]);
        let mut known = Information::none();
        let at = &closest[k];
        let Some(normal) = at.blend(|k| target.normals[k]).try_normalize(1e-9) else { return known };
        if target.closest().is_at_rim(at) {
            return known;
        }
        let displaced = places[k] - starts[k];
        let height = normal.dot(&(at.point - places[k]));
        let variance = noises.of_heights.at(area) + unexpressed;
        known.add(&normal, normal.dot(&displaced) + height, 1.0 / variance);
        for (feature, noise) in noises.of_features.iter().enumerate() {
            let Some(noise) = noise else { continue };
            let of_target = |k: usize| target.features[k * N_FEATURES + feature];
            let difference = source.features[i * N_FEATURES + feature] - at.blend(of_target);
            let slope = at.blend(|k| slopes[k][feature]);
            let variance = noise.at(area) / WEIGHT_OF_FEATURE + slope.norm_squared() * unexpressed;
            known.add(&slope, slope.dot(&displaced) + difference, 1.0 / variance);
        }
        known
    };
    (0..places.len()).into_par_iter().map(of_point).collect()
}

/// `moved`, the places of `points` of the source, slid along the target towards the `wanted` displacements from `rigid`,
/// mm, at their distance from it. Given are also the closest points of the target before.
fn slid(
    displacement: &FitContext<'_>,
    rigid: &RigidTransform,
    (points, moved, closest): (&[Point3<f64>], &[Point3<f64>], &[ClosestPoint]),
    wanted: &[Vector3<f64>],
) -> Vec<Point3<f64>> {
    let target = &displacement.target;
    let index = &target.closest().index;
    let of_point = |k: usize| {
        let (q, at) = (&moved[k], &closest[k]);
        let Some(normal) = at.blend(|k| target.normals[k]).try_normalize(1e-9) else { return *q };
        let height = normal.dot(&(q - at.point));
        let step = rigid.apply(&points[k]) + wanted[k] - q;
        let along = q + step - normal * normal.dot(&step);
        let there = index.closest_from(&along, at);
        let Some(normal) = there.blend(|k| target.normals[k]).try_normalize(1e-9) else { return along };
        along + normal * (height - normal.dot(&(along - there.point)))
    };
    (0..moved.len()).into_par_iter().map(of_point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;

    #[test]
    fn slopes_of_linear_functions_are_their_components_along_the_surface() {
        let mesh = ellipsoid(Vector3::new(9.0, 7.0, 5.0), 4);
        let normals: Vec<Vector3<f64>> =
            mesh.vertices().iter().map(|p| Vector3::new(p.x / 81.0, p.y / 49.0, p.z / 25.0).normalize()).collect();
        let directions: Vec<Vector3<f64>> =
            (0..N_FEATURES).map(|k| Vector3::new((k as f64).cos(), (2.0 * k as f64).sin(), 1.0 - k as f64)).collect();
        let features: Vec<f64> =
            mesh.vertices().iter().flat_map(|p| directions.iter().map(|d| d.dot(&p.coords))).collect();
        for (slopes, normal) in slopes(&mesh, &features).iter().zip(&normals) {
            for (slope, direction) in slopes.iter().zip(&directions) {
                let along = direction - normal * normal.dot(direction);
                assert!((slope - along).norm() < 0.05 * direction.norm(), "{slope} {along}");
            }
        }
    }
}
