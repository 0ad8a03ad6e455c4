//! Surfaces with limbs.
//!
//! From a rigid start such surfaces can agree over most of their area although a limb does not correspond: a tail on a
//! leg, or a head on a shoulder, is brought close by the field. So correspondences of near isometries and of
//! extremities are tried for them even if an answer agrees.

use super::extremities::number_of_limbs;
use crate::pair::role::Role;
use crate::pair::surfaces::Surfaces;
use homolog_contract::parameters::Bending;

/// Number of remote extremities from which a surface has limbs, and the least remoteness of each: root mean square
/// distance along the surface from all places, in roots of the area (0.48 on a ball).
const FEWEST_LIMBS: usize = 4;
const FAR_OUT: f64 = 0.64;

/// Whether both surfaces are closed and have limbs. False with landmarks, which already determine which limb is which.
///
/// Cost that of the distances between the sites of both, if they are not known.
pub(crate) fn may_branch(surfaces: &Surfaces<'_>) -> bool {
    let branches = |which: Role| {
        (surfaces.side_of)(which).is_some_and(|side| number_of_limbs(&side.sites().all(), FAR_OUT) >= FEWEST_LIMBS)
    };
    surfaces.bending == Bending::NearIsometry
        && !surfaces.open
        && surfaces.landmarks.is_empty()
        && branches(Role::Source)
        && branches(Role::Target)
}
