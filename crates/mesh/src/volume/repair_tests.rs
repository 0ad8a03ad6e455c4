//! Filling shapes with known tunnels and cavities, and random sets.

use super::*;
use crate::topology::{analyze, topology_report};
use crate::volume::{LabelVolume, voxel_surface};
use nalgebra::Matrix4;
use proptest::prelude::*;

fn set(dims: [usize; 3], inside: impl Fn([i32; 3]) -> bool) -> VoxelMask {
    let place = |k: usize| [k % dims[0], k / dims[0] % dims[1], k / (dims[0] * dims[1])].map(|c| c as i32);
    let labels = (0..dims.iter().product()).map(|k| u32::from(inside(place(k)))).collect();
    LabelVolume::new(dims, labels, Matrix4::identity()).unwrap().mask(None).unwrap()
}

fn genus_of_boundary(mask: &VoxelMask) -> Option<u32> {
    topology_report(&voxel_surface(mask).unwrap()).genus
}

#[test]
fn a_ring_is_closed_by_one_voxel() {
    let ring = set([3, 3, 1], |p| p != [1, 1, 0]);
    let filled = fill(&ring, Contacts::Resolve);
    assert_eq!(filled.change.before, BettiNumbers { n_pieces: 1, n_tunnels: 1, n_cavities: 0 });
    assert_eq!((filled.change.n_changed(), genus_of_boundary(&filled.mask)), (1, Some(0)));
}

#[test]
fn a_thin_wide_ring_is_cut_and_a_thick_narrow_one_is_filled() {
    let thin = set([12, 12, 1], |[x, y, _]| x == 0 || y == 0 || x == 11 || y == 11);
    let cut = fill(&thin, Contacts::Resolve);
    assert_eq!((cut.change.n_added, cut.change.n_removed), (0, 1));
    let thick = set([9, 9, 5], |[x, y, _]| x != 4 || y != 4);
    let filled = fill(&thick, Contacts::Resolve);
    assert_eq!((filled.change.n_added, filled.change.n_removed), (1, 0));
}

#[test]
fn a_cavity_is_filled() {
    let shell = set([5, 5, 5], |p| p != [2, 2, 2]);
    let filled = fill(&shell, Contacts::Allow);
    assert_eq!(filled.change.before.n_cavities, 1);
    assert!(BettiNumbers::of(&filled.mask).is_ball());
}

#[test]
fn contacts_are_resolved_only_with_resolve() {
    let edge = set([3, 2, 2], |[x, y, z]| z == 0 || (x, y) == (0, 0) || (x, y) == (1, 1));
    assert!(!is_well_composed(&edge));
    assert_eq!(fill(&edge, Contacts::Allow).change.n_changed(), 0);
    let resolved = fill(&edge, Contacts::Resolve);
    assert_eq!((resolved.change.n_changed(), genus_of_boundary(&resolved.mask)), (1, Some(0)));
}

#[test]
fn the_largest_component_is_kept() {
    let two = set([6, 1, 1], |p| p[0] != 2);
    let (mask, n, removed) = largest_component(&two);
    assert_eq!((mask.n_voxels(), n, removed), (3, 2, 2));
}

/// Well-composedness and the Euler number agree with those of the voxel surface.
fn agrees_with_the_surface(mask: &VoxelMask) -> Result<(), TestCaseError> {
    let report = topology_report(&voxel_surface(mask).unwrap());
    let manifold = report.n_nonmanifold_edges == 0 && report.n_nonmanifold_vertices == 0;
    prop_assert_eq!(manifold, is_well_composed(mask));
    if manifold {
        let b = BettiNumbers::of(mask);
        prop_assert_eq!(report.n_components, b.n_pieces + b.n_cavities);
        prop_assert_eq!(report.genus, Some(b.n_tunnels));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_set_is_filled_to_a_ball(
        voxels in proptest::collection::vec(proptest::bool::weighted(0.6), 7 * 6 * 6),
    ) {
        prop_assume!(voxels.contains(&true));
        let dims = [7, 6, 6];
        let mask = set(dims, |[x, y, z]| voxels[x as usize + 7 * y as usize + 42 * z as usize]);
        agrees_with_the_surface(&mask)?;
        let (piece, _, _) = largest_component(&mask);
        for contacts in [Contacts::Allow, Contacts::Resolve] {
            let filled = fill(&piece, contacts);
            prop_assert!(BettiNumbers::of(&filled.mask).is_ball());
            let again = fill(&filled.mask, contacts);
            prop_assert_eq!(again.change.n_changed(), 0);
            if contacts == Contacts::Resolve {
                prop_assert_eq!(analyze(&voxel_surface(&filled.mask).unwrap()).fault, None);
                agrees_with_the_surface(&filled.mask)?;
            }
        }
    }
}
