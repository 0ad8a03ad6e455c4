//! Surfaces with limbs: where a rigid start can end with surfaces that agree and a part that does not correspond.
//!
//! A tail that ends on a leg, a head that ends on a shoulder: the field brings them close, and normals and curvatures agree over most of
//! the surface. What such surfaces have in common is that they branch. For them an answer that agrees is no reason not to try
//! correspondences of bending-invariant forms and of extremities.

use super::extremities::number_of_limbs;
use crate::pair::role::Role;
use crate::pair::surfaces::Surfaces;
use homolog_contract::parameters::Bending;
use homolog_mesh::SurfaceMesh;
use std::f64::consts::PI;

/// Isoperimetric quotient below which a surface may branch: 1 of a ball, 0.21 to 0.32 of hippocampi, 0.33 to 0.45 of beans, 0.07 to 0.16 of
/// people and animals. It saves the forms of compact surfaces.
const MOST_COMPACT: f64 = 0.18;
/// Extremities from which it does, and how far out they are: root mean square distance along the surface from all places, in roots of the
/// area. Any point of a ball is at 0.48, the processes of vertebrae at 0.47 to 0.60, four limbs of people and animals at 0.68 and more.
const FEWEST_LIMBS: usize = 4;
const FAR_OUT: f64 = 0.64;

/// Whether both surfaces are whole and have limbs. Landmarks say already which limb is which.
///
/// Cost `O(n)` for compact surfaces, otherwise that of their forms.
pub(crate) fn may_branch(surfaces: &Surfaces<'_>) -> bool {
    let branches = |which: Role| {
        (surfaces.form_of)(which).is_some_and(|form| number_of_limbs(&form.measured.labels, FAR_OUT) >= FEWEST_LIMBS)
    };
    surfaces.bending == Bending::NearIsometry
        && !surfaces.open
        && surfaces.landmarks.is_empty()
        && [surfaces.source, surfaces.target].into_iter().all(|mesh| isoperimetric_quotient(mesh) < MOST_COMPACT)
        && branches(Role::Source)
        && branches(Role::Target)
}

/// `36 π V² / A³` for a volume `V` and an area `A`: at most 1.
fn isoperimetric_quotient(mesh: &SurfaceMesh) -> f64 {
    36.0 * PI * mesh.signed_volume().powi(2) / mesh.area().powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn a_ball_is_the_most_compact_and_size_does_not_matter() {
        let quotient = |axes: [f64; 3]| isoperimetric_quotient(&ellipsoid(Vector3::from(axes), 4));
        assert!((quotient([5.0; 3]) - 1.0).abs() < 0.01);
        assert!(quotient([20.0, 5.0, 5.0]) < 0.8);
        assert_eq!(quotient([20.0, 5.0, 5.0]), quotient([80.0, 20.0, 20.0]));
    }
}
