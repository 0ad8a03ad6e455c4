//! From a field to moved vertices: the fit in the other direction for two subjects, the rigid part, and variances.

use super::agreement::agreement;
use super::along;
use super::both_ways::BackwardMap;
use super::deformed::Deformed;
use super::displacement::FitContext;
use super::fitted::pose_of;
use super::relaxation::{PointSet, RelaxationModel, relax};
use super::reverse::{BothWays, ReverseFit, refined_both_ways};
use super::roundness::spread_of_fits;
use super::strain::distortion;
use super::uncertainty;
use crate::error::MatchError;
use crate::pair::role::Role;
use crate::pair::surfaces::{Surfaces, swapped};
use crate::starts::limbs::may_branch;
use homolog_contract::parameters::{Landmark, Uncertainty};
use homolog_mesh::SurfaceMesh;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

/// The source moved by the mean of both fits; `pose` is close to its rigid part.
pub(crate) fn finish_fit(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    BothWays { refined, returned }: BothWays,
    pose: &RigidTransform,
) -> Result<Option<Deformed>, MatchError> {
    let Surfaces { source, target, full_source, full_target, target_closest, lengths, .. } = *surfaces;
    // The mean of two fits agrees with a surface better than either fit, so agreement is measured on this fit alone.
    let own = refined.moved(source);
    let agreement = agreement(displacement, &own);
    let residual_mm = refined.residual_mm;
    let reached = pose_of(displacement, &own, pose);
    let back = returned.and_then(|returned| BackwardMap::new(full_target, target_closest, returned));
    let met = |mesh: &SurfaceMesh, points: Vec<Point3<f64>>| match &back {
        Some(back) => back.symmetrized(mesh.vertices(), &points),
        None => points,
    };
    let smooth = &displacement.source.mesh;
    let (mut fitted, mut at_smooth) = (met(source, own), met(smooth, refined.moved(smooth)));
    // A small surface is not thinned: its field is fitted at all its vertices.
    let mut of_full = (source != full_source).then(|| met(full_source, refined.moved(full_source)));
    let of_two_subjects = lengths.are_of_two_subjects(residual_mm);
    let mut model = None;
    let started = if refined.base.bend.is_some() {
        // The displacement of a bent base is no part of the field.
        refined.started(smooth)
    } else {
        // Limbs that move against each other are no displacement that is smooth in space.
        if !may_branch(surfaces) {
            let rigid = pose_of(displacement, &at_smooth, &reached);
            model = RelaxationModel::of(displacement, &rigid, &at_smooth);
            // Shapes of two subjects differ along the normals without a displacement as well, which a relaxation would
            // take for one, so their answer is left where both fits meet.
            if !of_two_subjects && let Some(model) = &model {
                let mut sets = vec![PointSet { points: source.vertices(), moved: &mut fitted }];
                sets.extend(of_full.as_mut().map(|moved| PointSet { points: full_source.vertices(), moved }));
                relax(displacement, model, &rigid, &mut at_smooth, &mut sets)?;
            }
        }
        let rigid = pose_of(displacement, &at_smooth, &reached);
        smooth.vertices().iter().map(|p| rigid.apply(p)).collect()
    };
    let distortion = distortion(source, &fitted);
    // Only bending-invariant forms give a bent base.
    let is_of_forms = refined.base.bend.is_some();
    let error = is_of_forms.then(|| along::squared_error(source, &fitted, &agreement, &lengths));
    // A field keeps the handedness of its pose.
    let (mirrored, edge_mm) = (refined.base.pose.is_reflection(), target.mean_edge_length());
    let Some(rigid) = displacement.alignment(edge_mm).rigid_part(source, &fitted, mirrored, false)? else {
        return Ok(None);
    };
    let moved = of_full.unwrap_or(fitted);
    let transform = rigid.transform;
    if displacement.options.uncertainty == Uncertainty::Residual {
        let variances = vec![residual_mm * residual_mm; moved.len()];
        return Ok(Some(Deformed { moved, variances, transform, residual_mm, agreement, distortion }));
    }
    let process = model.as_ref().map(|model| model.process.clone());
    let points = full_source.vertices();
    let posterior = || uncertainty::posterior(displacement, (&started, &at_smooth), points, process);
    // Copies start from their own pose: rotations have no part in their variance.
    let of_fits = || match &model {
        Some(model) if !rigid.copies => {
            let unrelaxed = of_two_subjects.then_some(at_smooth.as_slice());
            spread_of_fits(displacement, model, points, (&refined.wide, &reached), unrelaxed)
        }
        _ => Ok(None),
    };
    let (variances, of_fits) = rayon::join(posterior, of_fits);
    let Some(mut variances) = variances else { return Ok(None) };
    if let Some(of_fits) = of_fits? {
        variances.iter_mut().zip(of_fits).for_each(|(variance, of_fits)| *variance += of_fits);
    }
    if let Some(error) = error {
        along::raise_variances(&mut variances, error, &lengths);
    }
    Ok(Some(Deformed { moved, variances, transform, residual_mm, agreement, distortion }))
}

/// The source moved rigidly onto its copy. A field would pull the region without counterpart, and its surroundings,
/// towards the rim.
pub(crate) fn moved_rigidly(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    transform: RigidTransform,
    residual_mm: f64,
) -> Deformed {
    let posed = |mesh: &SurfaceMesh| mesh.vertices().iter().map(|p| transform.apply(p)).collect::<Vec<_>>();
    let moved = posed(surfaces.full_source);
    let agreement = agreement(displacement, &posed(surfaces.source));
    Deformed { variances: vec![0.0; moved.len()], moved, transform, residual_mm, agreement, distortion: 0.0 }
}

/// The source moved by the inverse of the map from the target to the source. `None` if a number is not finite.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn finish_backward_fit(
    reverse: ReverseFit<'_>,
    surfaces: &Surfaces<'_>,
) -> Result<Option<Deformed>, MatchError> {
    let landmarks: Vec<Landmark> = surfaces.landmarks.iter().map(swapped).collect();
    let side_of = |role: Role| (surfaces.side_of)(role.other());
    let ReverseFit { displacement, pose, fine } = reverse;
    let swapped = surfaces.swapped(&landmarks, &side_of);
    let refined = refined_both_ways(&displacement, &swapped, fine)?;
    let found = finish_fit(&displacement, &swapped, refined, &pose)?;
    Ok(found.and_then(|found| found.inverse(surfaces.full_target, surfaces.full_source)))
}
