//! The answer of a displacement field: images with their confidence, and what is known of the fit.

use super::images::{Image, images};
use crate::field::agreement::Agreement;
use crate::field::deformed::Deformed;
use crate::field::route::Fitted;
use crate::pair::surfaces::Surfaces;
use crate::poses::compared::ComparedPose;
use homolog_registration::RigidTransform;

/// The result of a displacement.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DisplacementAnswer {
    /// The image of each source vertex.
    pub images: Vec<Image>,
    /// The rigid transform of these correspondences.
    pub transform: RigidTransform,
    /// Starts that were compared, the one that was kept first.
    pub compared: Vec<ComparedPose>,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
    /// How well the surfaces agree after the deformation.
    pub agreement: Agreement,
    /// How far the deformation is from one that keeps angles, [`crate::field::strain::distortion`].
    pub distortion: f64,
}

impl DisplacementAnswer {
    /// The answer for `surfaces` that were `fitted`. Cost `O(n log n')`.
    pub(crate) fn of(fitted: Fitted, surfaces: &Surfaces<'_>) -> DisplacementAnswer {
        let Fitted { deformed, compared } = fitted;
        let Deformed { moved, variances, transform, residual_mm, agreement, distortion } = deformed;
        let (target, closest) = (surfaces.full_target, surfaces.target_closest);
        let images = images(target, closest, &moved, &variances, surfaces.lengths.sampling_mm);
        DisplacementAnswer { images, transform, compared, residual_mm, agreement, distortion }
    }
}
