//! The local stage: narrow displacements, if the residual heights show any.
//!
//! After the fine stage the wide field has taken up displacement that is smooth over a third of the structure. The
//! remaining heights along the normals are either sampling noise or narrower displacement. Their marginal likelihood
//! decides between the two, and estimates the width and variance of a second kernel and the noise. The sum of both
//! kernels is then fitted as one field: normals of different directions within one width also determine the
//! displacement along the surface, and where they do not, the posterior covariance is large.
//!
//! The wide field alone slides along the surface to follow narrow displacements. So the field of both kernels is fitted
//! from the rigid pose, through all stages.

use super::coarse::coarse_alone;
use super::deformation_evidence::every;
use super::displacement::FitContext;
use super::fine::{Weights, fine_in, sliding};
use super::fitted::{FinalField, FineStageFit, LocalKernel, pose_of};
use super::options::DisplacementOptions;
use super::trace::TracedFit;
use super::track::{BaseEvaluation, assigned};
use crate::error::MatchError;
use crate::pair::assignment::{displaced, kernel, precision_of_features};
use crate::pair::progress::PROGRESS_BEFORE_LOCAL;
use crate::surface::surface_index::ClosestInSteps;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::RigidTransform;
use homolog_registration::deformation::{
    FittedField, GaussianKernel, KernelEvidence, ONE_KERNEL, ProcessSearch, fit_field, most_probable_kernel,
};
use nalgebra::Point3;

/// Largest ratio of the variances of the second kernel and of the noise, as a power of two: noise of less than a 64th
/// of the displacement is not plausible.
const LOCAL_MAX_LOG2_RATIO: i32 = 12;

/// The kernel to add, and the noise under it, for the kernel that was `found` on surfaces with this sampling distance.
fn local_kernel(found: &KernelEvidence, sampling_mm: f64, options: &DisplacementOptions) -> LocalKernel {
    let GaussianKernel { width_mm, amplitude_mm } = found.kernel;
    let clearness = (options.local.voxel_noise * sampling_mm / found.noise_mm.max(f64::MIN_POSITIVE)).powi(2);
    LocalKernel {
        across_share: options.sliding.across_share * clearness.clamp(1.0, 1.0 / options.sliding.across_share),
        kernel: GaussianKernel { width_mm, amplitude_mm: options.local.amplitude * amplitude_mm },
        // Shapes of two subjects differ along the normals without displacement, and nothing tells this from the
        // displacement, so the amplitude of the heights counts as noise as well.
        noise_mm: found.noise_mm.hypot(amplitude_mm),
    }
}

/// A field of both kernels.
struct Local {
    track: BaseEvaluation,
    field: FittedField,
    fit: TracedFit,
}

/// The second kernel that the residual heights of the source at `moved` over the target show; `None` if they are noise.
pub(crate) fn shown_kernel(displacement: &FitContext<'_>, moved: &[Point3<f64>]) -> Option<LocalKernel> {
    let found = evidence(displacement, moved)?;
    let is_clear = found.gain >= displacement.options.local.least_gain;
    is_clear.then(|| local_kernel(&found, displacement.lengths.sampling_mm, displacement.options))
}

/// The field with this second kernel after `fine`, which moves the vertices of the source to `moved`; `fine` itself if a
/// number is not finite.
pub(crate) fn local(
    displacement: &FitContext<'_>,
    (fine, moved): (FineStageFit, Vec<Point3<f64>>),
    local: LocalKernel,
) -> Result<FinalField, MatchError> {
    displacement.observer.progress(PROGRESS_BEFORE_LOCAL);
    checkpoint(displacement.observer)?;
    let Some(joint) = with_kernel(displacement, &local) else {
        return Ok(FinalField::of_fine_stage(displacement, fine));
    };
    let base = &fine.track.base;
    // A fit from the rigid pose drops the displacement along the surface by which the wide field followed narrow ones.
    // A bent base does not allow this.
    let found = match base.bend {
        None => {
            let pose = pose_of(displacement, &moved, &base.pose);
            fit_from_pose(&joint, &pose, joint.observer.begin(), &local)?
        }
        Some(_) => {
            let track = fine.track.with_functions_of(&joint);
            followed_locally(&joint, track, (moved, fine.feature_precision.clone()), joint.observer.begin(), &local)?
        }
    };
    Ok(match found {
        Some(kept) => FinalField {
            base: kept.track.base,
            base_functions: displacement.functions.clone(),
            field: kept.field,
            functions: joint.functions.clone(),
            residual_mm: fine.residual_mm,
            local: Some(local),
            wide: fine.state(),
        },
        None => FinalField::of_fine_stage(displacement, fine),
    })
}

/// Vertices moved by a field with a second kernel, mm, and its fit, which is not reported yet.
pub(crate) struct MovedLocally {
    moved: Vec<Point3<f64>>,
    fit: TracedFit,
}

impl MovedLocally {
    /// The vertices, once the fit is the next in the energy trace.
    pub(crate) fn reported(mut self, displacement: &FitContext<'_>) -> Vec<Point3<f64>> {
        displacement.observer.keep(&mut self.fit);
        self.moved
    }
}

/// The vertices of `mesh` moved by the field from `pose` with the kernel that the fit in the other direction showed.
pub(crate) fn moved_locally(
    displacement: &FitContext<'_>,
    pose: &RigidTransform,
    local: &LocalKernel,
    mesh: &SurfaceMesh,
) -> Result<Option<MovedLocally>, MatchError> {
    let Some(joint) = with_kernel(displacement, local) else { return Ok(None) };
    let Some(Local { track, field, fit }) = fit_from_pose(&joint, pose, TracedFit::candidate(), local)? else {
        return Ok(None);
    };
    let values = joint.functions.values(mesh.vertices());
    let moved = displaced(&track.base.moved(mesh.vertices(), &values), &field, &values);
    Ok(Some(MovedLocally { moved, fit }))
}

/// This displacement with a second kernel.
fn with_kernel<'a>(displacement: &'a FitContext<'_>, local: &LocalKernel) -> Option<FitContext<'a>> {
    let mut prior = displacement.options.prior.of(displacement.diagonal_mm);
    prior.kernels.push(local.kernel);
    let functions = displacement.functions.with_prior(
        displacement.source.mesh.vertices(),
        prior,
        displacement.options.local.n_inducing,
    )?;
    Some(displacement.with_functions(functions))
}

/// The field of both kernels through all stages from a rigid base.
fn fit_from_pose(
    displacement: &FitContext<'_>,
    pose: &RigidTransform,
    fit: TracedFit,
    local: &LocalKernel,
) -> Result<Option<Local>, MatchError> {
    let Some(state) = coarse_alone(displacement, pose) else { return Ok(None) };
    let Some(fine) = fine_in(displacement, state, local.across_share, Some(fit))? else { return Ok(None) };
    let moved = fine.moved();
    let fit = fine.fit.unwrap_or_else(TracedFit::candidate);
    followed_locally(displacement, fine.track, (moved, fine.feature_precision), fit, local)
}

/// The most probable kernel of the heights of the source, with its vertices at `moved`, below the target.
fn evidence(displacement: &FitContext<'_>, moved: &[Point3<f64>]) -> Option<KernelEvidence> {
    let source = displacement.source.mesh.vertices();
    let step = every(source.len(), displacement.options.local.evidence_samples);
    let picked: Vec<usize> = (0..source.len()).step_by(step).collect();
    let mut heights = Vec::with_capacity(picked.len());
    let mut normals = Vec::with_capacity(picked.len());
    for &i in &picked {
        let at = displacement.target.closest().index.closest(&moved[i]);
        let normal = at.blend(|k| displacement.target.normals[k]).try_normalize(1e-9)?;
        heights.push(normal.dot(&(at.point - moved[i])));
        normals.push(normal);
    }
    let points: Vec<Point3<f64>> = picked.iter().map(|&i| source[i]).collect();
    let points = displacement.functions.coordinates(&points);
    let widths = displacement.options.local.widths.map(|w| w * displacement.diagonal_mm);
    let search = ProcessSearch {
        widths_mm: &widths,
        shape: &ONE_KERNEL,
        largest_ratio: LOCAL_MAX_LOG2_RATIO,
        least_noise_mm: 0.0,
    };
    most_probable_kernel(&points, &normals, &heights, &search)
}

/// The field after some steps of `fit` from `moved`, with the precisions of the features there.
fn followed_locally(
    displacement: &FitContext<'_>,
    track: BaseEvaluation,
    (mut moved, mut precision): (Vec<Point3<f64>>, Vec<f64>),
    mut fit: TracedFit,
    local: &LocalKernel,
) -> Result<Option<Local>, MatchError> {
    let settings = &displacement.options.local;
    let thinned = displacement.source.thinned(settings.samples);
    let target = displacement.target.assignment_target();
    let values = displacement.guides.below(track.values(&thinned));
    let starts = track.starts(&thinned);
    let mirrored = track.base.pose.is_reflection();

    let sigma_mm = displacement.diagonal_mm * displacement.options.fine.sigma[1];
    let mean_area = thinned.areas.iter().sum::<f64>() / thinned.areas.len() as f64;
    let along = settings.point_weight / (mean_area * local.noise_mm * local.noise_mm);
    let across = displacement.density(&displacement.options.fine, 1.0) / (sigma_mm * sigma_mm);
    let weights = Weights { along, across: local.across_share * across };
    let (mut fitted, mut closest): (Option<FittedField>, _) = (None, ClosestInSteps::default());
    for _ in 0..settings.steps {
        checkpoint(displacement.observer)?;
        let kernel = kernel(sigma_mm, precision);
        let Some(assigned) = assigned(displacement, &moved, mirrored, &thinned, &target, &kernel) else {
            return Ok(None);
        };
        let (observed, _) = sliding(displacement, &assigned, (&thinned.counted, &starts), weights, &mut closest);
        if let Some(field) = &fitted {
            let observations = settings.point_weight * thinned.areas.len() as f64;
            displacement.observer.trace(&mut fit, assigned.found.misfit, field, observations);
        }
        let Some(next) = fit_field(values.as_ref(), &track.with_guides(observed)) else { return Ok(None) };
        moved = track.moved(&next);
        precision = precision_of_features(&assigned.found.feature_variance);
        fitted = Some(next);
    }
    let Some(field) = fitted else { return Ok(None) };
    Ok(Some(Local { track, field, fit }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_less_noise_the_more_counts_what_is_assigned_across_the_normals() {
        let options = DisplacementOptions::default();
        let across_share = options.sliding.across_share;
        let share = |noise_mm: f64| {
            let kernel = GaussianKernel { width_mm: 5.0, amplitude_mm: 1.0 };
            local_kernel(&KernelEvidence { kernel, noise_mm, gain: 10.0 }, 2.0, &options).across_share
        };
        assert_eq!([share(0.4), share(0.2)], [across_share; 2]);
        assert!((share(0.1) - 4.0 * across_share).abs() < 1e-12);
        // The share is 1 at most.
        assert_eq!([share(0.01), share(0.0)], [1.0; 2]);
    }
}
