//! The answer of a displacement field: images with their confidence, and measures of the fit.

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
    /// The rigid transform of the correspondences.
    pub transform: RigidTransform,
    /// The starts that were compared, the one kept first.
    pub compared: Vec<ComparedPose>,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
    /// How well the surfaces agree after the deformation.
    pub agreement: Agreement,
    /// Mean angular distortion of the deformation, mean of `ln(σ₁/σ₂)` over the triangles.
    pub distortion: f64,
}

impl DisplacementAnswer {
    /// The answer from `fitted`, a fit of `surfaces`. Cost `O(n log n')`.
    pub(crate) fn of(fitted: Fitted, surfaces: &Surfaces<'_>) -> DisplacementAnswer {
        let Fitted { deformed, compared } = fitted;
        let Deformed { moved, variances, transform, residual_mm, agreement, distortion } = deformed;
        let (target, closest) = (surfaces.full_target, surfaces.target_closest);
        let images = images(target, closest, &moved, &variances, surfaces.lengths.sampling_mm);
        DisplacementAnswer { images, transform, compared, residual_mm, agreement, distortion }
    }
}
