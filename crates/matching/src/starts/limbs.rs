//! Surfaces with limbs.
//!
//! From a rigid start such surfaces can agree over most of their area although a limb does not correspond: a tail on a
//! leg, or a head on a shoulder, is brought close by the field. So correspondences of near isometries and of
//! extremities are tried for them even if an answer agrees.

use super::extremities::number_of_limbs;
use crate::pair::role::Role;
use crate::pair::surfaces::Surfaces;
use homolog_contract::parameters::Bending;
use homolog_mesh::SurfaceMesh;
use std::f64::consts::PI;

/// Isoperimetric quotient below which a surface may have limbs; 1 for a ball. This test only avoids computing the forms
/// of compact surfaces.
const MOST_COMPACT: f64 = 0.18;
/// Number of remote extremities from which a surface has limbs, and the least remoteness of each: root mean square
/// distance along the surface from all places, in roots of the area (0.48 on a ball).
const FEWEST_LIMBS: usize = 4;
const FAR_OUT: f64 = 0.64;

/// Whether both surfaces are closed and have limbs. False with landmarks, which already determine which limb is which.
///
/// Cost `O(n)` for compact surfaces, otherwise that of their forms.
pub(crate) fn may_branch(surfaces: &Surfaces<'_>) -> bool {
    let branches = |which: Role| {
        (surfaces.side_of)(which).is_some_and(|side| number_of_limbs(&side.sites().all(), FAR_OUT) >= FEWEST_LIMBS)
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
