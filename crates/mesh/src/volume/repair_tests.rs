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

#[test]
fn an_oblique_line_of_voxels_is_one_piece_after_joining() {
    let oblique = set([8, 8, 8], |[x, y, z]| x == y && z == x / 2);
    assert_eq!(BettiNumbers::of(&oblique).n_pieces, 8);
    let joined = join_touching(&oblique).unwrap();
    assert_eq!((joined.n_joined, joined.n_added), (7, 4 + 2 * 3));
    assert_eq!(BettiNumbers::of(&joined.mask), BettiNumbers { n_pieces: 1, n_tunnels: 0, n_cavities: 0 });
    assert!(join_touching(&joined.mask).is_none());
    let apart = set([5, 1, 1], |p| p[0] != 2);
    assert!(join_touching(&apart).is_none());
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

    /// Joining adds voxels until no two pieces touch, at most two for each piece less.
    #[test]
    fn pieces_that_touch_are_joined(voxels in proptest::collection::vec(proptest::bool::weighted(0.2), 7 * 6 * 6)) {
        prop_assume!(voxels.contains(&true));
        let mask = set([7, 6, 6], |[x, y, z]| voxels[x as usize + 7 * y as usize + 42 * z as usize]);
        // Pieces that touch anywhere are one piece of a background.
        let inverse = mask.with_voxels(mask.voxels.iter().map(|v| !v).collect());
        let n_apart = components(&inverse, false).1.len();
        let n_pieces = components(&mask, true).1.len();
        match join_touching(&mask) {
            None => prop_assert_eq!(n_pieces, n_apart),
            Some(joined) => {
                prop_assert_eq!(components(&joined.mask, true).1.len(), n_pieces - joined.n_joined);
                prop_assert!(joined.n_added <= 2 * joined.n_joined);
                prop_assert!(mask.voxels.iter().zip(&joined.mask.voxels).all(|(was, is)| *is || !was));
                prop_assert!(n_pieces - joined.n_joined <= n_apart);
            }
        }
    }

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
