//! From a field to the moved vertices: a fit back for two subjects, the rigid part, variances.

use super::agreement::distortion;
use super::along;
use super::both_ways::WayBack;
use super::fine::{Fine, Refined};
use super::local::LocalKernel;
use super::stages::Displacement;
use super::{Deformed, FIELD_SHARE, StartPose, Surfaces, TWO_SUBJECTS, diagonal_mm, functions, swapped};
use crate::MatchError;
use crate::side::Which;
use homolog_contract::parameters::Landmark;
use homolog_mesh::SurfaceMesh;
use homolog_registration::RigidTransform;
use nalgebra::Point3;
use std::sync::Arc;

/// The pair in the other direction, after the fine stage.
pub(super) struct Turned<'a> {
    back: Displacement<'a>,
    /// Where it began.
    pose: RigidTransform,
    fine: Fine,
}

impl Turned<'_> {
    /// Whether these are two subjects.
    pub(super) fn is_of_two_subjects(&self) -> bool {
        self.fine.residual_mm >= TWO_SUBJECTS * self.back.lengths.sampling_mm
    }

    /// Whether the surfaces may agree better from another start.
    pub(super) fn is_doubtful(&self) -> bool {
        self.back.agreement(&self.fine.moved()).is_doubtful()
    }

    /// The inverse of the map from the target to the source.
    pub(super) fn finished(self, surfaces: &Surfaces<'_>) -> Result<Option<Deformed>, MatchError> {
        let landmarks: Vec<Landmark> = surfaces.landmarks.iter().map(swapped).collect();
        let form_of = |which: Which| (surfaces.form_of)(which.other());
        let Some(refined) = self.back.refined_from(self.fine)? else { return Ok(None) };
        let found = self.back.finished(&surfaces.swapped(&landmarks, &form_of), refined, &self.pose)?;
        Ok(found.and_then(|found| found.inverse(surfaces.full_target, surfaces.full_source)))
    }
}

impl<'a> Displacement<'a> {
    /// The source moved by `refined`, of which `pose` is near the rigid part.
    pub(super) fn finished(
        &self,
        surfaces: &Surfaces<'_>,
        refined: Refined,
        pose: &RigidTransform,
    ) -> Result<Option<Deformed>, MatchError> {
        let Surfaces { source, target, full_source, full_target, target_closest, open, lengths, .. } = *surfaces;
        // The mean of two fits agrees with any surface better than either does, so agreement is measured before.
        let (own, own_values) = refined.moved(source);
        let agreement = self.agreement(&own);
        let residual_mm = refined.residual_mm;
        let reached = self.pose_of(&own, pose);
        // A part that is missing on one surface has no counterpart in a fit back.
        let returned = if open || refined.base.bend.is_some() || residual_mm < TWO_SUBJECTS * lengths.sampling_mm {
            None
        } else {
            self.returned(surfaces, &reached, refined.local)?
        };
        let back = returned.and_then(|returned| WayBack::new(full_target, target_closest, returned));
        let met = |mesh: &SurfaceMesh, points: Vec<Point3<f64>>| match &back {
            Some(back) => back.met(mesh.vertices(), &points),
            None => points,
        };
        let fitted = met(source, own);
        let distortion = distortion(source, &fitted);
        // A bent base comes from forms alone.
        let is_of_forms = refined.base.bend.is_some();
        let error = is_of_forms.then(|| along::squared_error(source, &fitted, &agreement, &lengths));
        // A field keeps the handedness of its pose.
        let (mirrored, edge_mm) = (refined.base.pose.is_reflection(), target.mean_edge_length());
        let Some(rigid) = self.rigid_part(source, &fitted, mirrored, edge_mm, false)? else { return Ok(None) };
        // The field of a small surface is fitted on all its vertices.
        let (moved, values) = if source == full_source {
            (fitted, own_values)
        } else {
            let (points, values) = refined.moved(full_source);
            (met(full_source, points), values)
        };
        // The covariance of a wide field takes correlated residuals for independent ones of a low density.
        let share = if refined.local.is_some() { 1.0 } else { FIELD_SHARE };
        let mut variances: Vec<f64> =
            refined.field.variances(values.as_ref()).iter().map(|variance| share * variance).collect();
        // Copies need no deformation from their own pose, and much from others. Bent surfaces have no axis.
        if !rigid.copies
            && !is_of_forms
            && let Some(of_starts) = self.spread_of_rotations(full_source.vertices(), &reached)?
        {
            variances.iter_mut().zip(of_starts).for_each(|(variance, of_starts)| *variance += of_starts);
        }
        if let Some(error) = error {
            along::raise(&mut variances, error, &lengths);
        }
        let transform = rigid.transform;
        Ok(Some(Deformed { moved, variances, transform, residual_mm, agreement, distortion }))
    }

    /// The source moved rigidly onto its copy. A field would pull the part without counterpart towards the rim, and its surroundings
    /// with it.
    pub(super) fn posed(&self, surfaces: &Surfaces<'_>, transform: RigidTransform, residual_mm: f64) -> Deformed {
        let posed = |mesh: &SurfaceMesh| mesh.vertices().iter().map(|p| transform.apply(p)).collect::<Vec<_>>();
        let moved = posed(surfaces.full_source);
        let agreement = self.agreement(&posed(surfaces.source));
        Deformed { variances: vec![0.0; moved.len()], moved, transform, residual_mm, agreement, distortion: 0.0 }
    }

    /// The target moved towards the source from the inverse of `pose`. `None` where a number is not finite.
    pub(super) fn turned(
        &self,
        surfaces: &Surfaces<'_>,
        pose: &RigidTransform,
    ) -> Result<Option<Turned<'a>>, MatchError> {
        let Some(back) = self.backwards(surfaces) else { return Ok(None) };
        let pose = pose.inverse();
        let Some((_, state)) = back.coarse(&[StartPose::of(pose)], |_| true)? else { return Ok(None) };
        let fine = back.fine(state)?;
        Ok(fine.map(|fine| Turned { back, pose, fine }))
    }

    /// The displacement of the target onto the source. `None` where a number is not finite.
    fn backwards(&self, surfaces: &Surfaces<'_>) -> Option<Displacement<'a>> {
        let functions = functions(surfaces.target, &self.target, self.options)?;
        Some(Displacement {
            source: Arc::clone(&self.target),
            target: Arc::clone(&self.source),
            guides: self.guides.swapped(&functions),
            functions,
            diagonal_mm: diagonal_mm(surfaces.target),
            ..*self
        })
    }

    /// The vertices of the full target moved onto the source by a fit in that direction, from the inverse of `pose`.
    fn returned(
        &self,
        surfaces: &Surfaces<'_>,
        pose: &RigidTransform,
        local: Option<LocalKernel>,
    ) -> Result<Option<Vec<Point3<f64>>>, MatchError> {
        let Some(back) = self.backwards(surfaces) else { return Ok(None) };
        let inverse = pose.inverse();
        let refined = match local {
            Some(local) => back.locally_from(&inverse, &local)?,
            None => match back.coarse_alone(&inverse) {
                Some(state) => back.refined(state)?,
                None => None,
            },
        };
        Ok(refined.map(|refined| refined.moved(surfaces.full_target).0))
    }
}
