//! Laws over random volumes, and shapes of known volume, area and curvature.

use super::*;
use crate::topology::{analyze, topology_report};
use crate::volume::{BettiNumbers, Contacts, LabelVolume, fill, largest_component};
use nalgebra::{Matrix4, Point3, Rotation3};
use proptest::prelude::*;

fn mask_of(dims: [usize; 3], affine: Matrix4<f64>, inside: impl Fn(Vector3<f64>) -> bool) -> VoxelMask {
    let n = dims.iter().product();
    let place = |k: usize| Vector3::new(k % dims[0], k / dims[0] % dims[1], k / (dims[0] * dims[1])).map(|c| c as f64);
    let labels = (0..n).map(|k| u32::from(inside(place(k)))).collect();
    LabelVolume::new(dims, labels, affine).unwrap().mask(None).unwrap()
}

/// A solid box of voxels.
fn slab(dims: [usize; 3]) -> VoxelMask {
    mask_of(dims, Matrix4::identity(), |_| true)
}

fn surface(mask: &VoxelMask) -> SurfaceMesh {
    constrained_surface(mask).unwrap()
}

/// A net whose vertices are all at this distance from their voxel faces.
fn net_at(mask: &VoxelMask, offset: f64) -> Net {
    let mut net = Net::new(mask, cut(mask, |k| mask.voxels()[k], |_, _, _| 0.5));
    (0..net.offset.len()).for_each(|v| net.place(v, offset));
    net.place_middles();
    net
}

/// With all vertices at the inner ends of their segments the surface encloses too little in a cube of any pattern, and
/// at the outer ends too much. Therefore some distance gives the right volume for any set.
#[test]
fn in_every_pattern_the_segments_reach_on_both_sides_of_the_right_volume() {
    for pattern in 1..255usize {
        let mask = mask_of([2; 3], Matrix4::identity(), |p| {
            pattern >> (p.x as usize + 2 * p.y as usize + 4 * p.z as usize) & 1 == 1
        });
        for (offset, sign) in [(-REACH, 1.0), (REACH, -1.0)] {
            let net = net_at(&mask, offset);
            for (cell, deficit) in net.contour.cells.iter().zip(deficits(&net.contour)) {
                assert!(sign * deficit > 0.0, "{pattern:#b} at {offset}: {deficit} in {cell:?}");
            }
        }
    }
}

fn sets() -> impl Strategy<Value = VoxelMask> {
    let affine = (
        proptest::array::uniform3(0.3..3.0f64),
        proptest::array::uniform3(-3.0..3.0f64),
        proptest::array::uniform3(-0.3..0.3f64),
        any::<bool>(),
    );
    let voxels =
        (0.1..0.9f64).prop_flat_map(|share| proptest::collection::vec(proptest::bool::weighted(share), 7 * 6 * 5));
    (voxels, affine).prop_filter_map("no voxel", |(voxels, (spacing, angles, shear, mirrored))| {
        let rotation = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).to_homogeneous();
        let mut own = Matrix4::new_nonuniform_scaling(&Vector3::from(spacing));
        (own[(0, 1)], own[(1, 2)], own[(0, 2)]) = (shear[0], shear[1], shear[2]);
        let mirror = Matrix4::new_nonuniform_scaling(&Vector3::new(if mirrored { -1.0 } else { 1.0 }, 1.0, 1.0));
        voxels.contains(&true).then(|| {
            mask_of([7, 6, 5], rotation * own * mirror, |p| voxels[p.x as usize + 7 * p.y as usize + 42 * p.z as usize])
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_set_keeps_its_volume_its_topology_and_its_voxels(mask in sets()) {
        let mesh = surface(&mask);
        let (report, betti) = (topology_report(&mesh), BettiNumbers::of(&mask));
        prop_assert_eq!(report.n_components, betti.n_pieces + betti.n_cavities);
        prop_assert_eq!(report.genus, Some(betti.n_tunnels));
        prop_assert!((mesh.signed_volume() / mask.volume_mm3() - 1.0).abs() < 1e-5, "{}", mesh.signed_volume());
        // No triangle degenerates: its height is a share of a voxel.
        let smallest = mask.affine.fixed_view::<3, 3>(0, 0).singular_values().min();
        for [a, b, c] in mesh.triangles() {
            let [a, b, c] = [a, b, c].map(|v| mesh.vertices()[v as usize]);
            let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
            prop_assert!((b - a).cross(&(c - a)).norm() / longest > 1e-3 * smallest);
        }
        // Every boundary face has its vertex, between the centers of its two voxels.
        let to_voxel = mask.affine.try_inverse().unwrap();
        let mut found = std::collections::BTreeSet::new();
        for p in mesh.vertices() {
            let voxel = to_voxel.transform_point(p);
            let axes: Vec<usize> = (0..3).filter(|&k| (voxel[k] - voxel[k].round()).abs() > 1e-6).collect();
            if let [axis] = axes[..] {
                let mut low = [0, 1, 2].map(|k| voxel[k].round() as usize);
                low[axis] = voxel[axis].floor() as usize;
                let at = mask.index(low);
                prop_assert!(mask.voxels()[at] != mask.voxels()[at + mask.strides()[axis]]);
                found.insert((at, axis));
            }
        }
        prop_assert_eq!(found.len(), mask.n_boundary_faces());
    }

    #[test]
    fn what_is_missing_in_all_cubes_is_what_is_missing(mask in sets(), offsets in proptest::collection::vec(-0.45..0.45f64, 64)) {
        let mut net = net_at(&mask, 0.0);
        (0..net.offset.len()).for_each(|v| net.place(v, offsets[v % 64]));
        net.place_middles();
        let sum: f64 = deficits(&net.contour).iter().sum();
        prop_assert!((sum - (mask.n_voxels() as f64 - net.volume())).abs() < 1e-9);
    }

    #[test]
    fn a_filled_set_has_the_surface_of_a_ball(mask in sets()) {
        let filled = fill(&largest_component(&mask).0, Contacts::Allow).mask;
        prop_assert_eq!(analyze(&surface(&filled)).fault, None);
    }

    /// Smoothing acts in millimeters, so a rigid motion or a mirror image of the volume moves the surface with it.
    #[test]
    fn moving_the_volume_moves_the_surface(mask in sets(), angles in proptest::array::uniform3(-3.0..3.0f64), mirrored: bool) {
        let mut motion = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).to_homogeneous();
        if mirrored {
            motion *= Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, -1.0, 1.0));
        }
        let moved = VoxelMask { affine: motion * mask.affine, ..mask.clone() };
        let (here, there) = (surface(&mask), surface(&moved));
        prop_assert!((there.signed_volume() - here.signed_volume()).abs() < 1e-6 * here.signed_volume());
        for (p, q) in here.vertices().iter().zip(there.vertices()) {
            prop_assert!((motion.transform_point(p) - q).norm() < 1e-6);
        }
    }
}

#[test]
fn thin_parts_keep_their_volume_where_they_are() {
    // A body of 12³ voxels with a tail one voxel thick: the tail has its own volume, not a share of the body's.
    let mask = mask_of([40, 12, 12], Matrix4::identity(), |p| p.x < 12.0 || p.y == 6.0 && p.z == 6.0);
    let mesh = surface(&mask);
    let farthest = mesh.vertices().iter().map(|p| p.x).fold(0.0, f64::max);
    assert!((39.0..40.0).contains(&farthest), "{farthest}");
    // Cross-section of the tail in its middle: the enclosed volume between two planes of voxel centers, by the area vectors.
    let tail = |from: f64, to: f64| -> f64 {
        let inner = |p: &Point3<f64>| p.x > from && p.x < to;
        let faces = mesh.triangles();
        let sides = faces.iter().map(|t| t.map(|v| mesh.vertices()[v as usize])).filter(|t| t.iter().all(inner));
        // The divergence theorem about the axis leaves the two ends out, which contain the direction of the axis.
        let about = |p: Point3<f64>| Vector3::new(0.0, p.y - 6.0, p.z - 6.0);
        sides
            .map(|[a, b, c]| {
                let area = (b - a).cross(&(c - a)) / 2.0;
                (about(a) + about(b) + about(c)).dot(&area) / 3.0
            })
            .sum::<f64>()
            / 2.0
    };
    let per_voxel = tail(16.0, 36.0) / 19.0;
    assert!((0.9..1.1).contains(&per_voxel), "{per_voxel}");
    for (dims, n) in [([25, 15, 1], 375), ([3, 3, 3], 27), ([1, 1, 1], 1), ([30, 1, 1], 30), ([7, 1, 1], 7)] {
        let volume = surface(&slab(dims)).signed_volume();
        assert!((volume / f64::from(n) - 1.0).abs() < 1e-5, "{dims:?}: {volume}");
    }
}

#[test]
fn a_plate_is_as_thick_as_a_voxel_in_its_middle() {
    let mesh = surface(&slab([25, 15, 1]));
    let middle = mesh.vertices().iter().filter(|p| (p.x - 12.0).abs() < 8.0 && (p.y - 7.0).abs() < 4.0);
    for p in middle {
        assert!((0.4..0.6).contains(&(p.z.abs())), "{p}");
    }
}

/// A ball at any place between the voxels: position, area and volume of its surface.
#[test]
fn a_ball_converges_to_its_place_area_and_volume() {
    let mut errors = Vec::new();
    for radius in [5.0, 10.0, 20.0] {
        let n = 2 * (radius as usize + 2) + 1;
        let center = Vector3::new(0.31, -0.17, 0.43).add_scalar((n / 2) as f64);
        let mask = mask_of([n; 3], Matrix4::identity(), |p| (p - center).norm() <= radius);
        let mesh = surface(&mask);
        let distances: Vec<f64> = mesh.vertices().iter().map(|p| (p.coords - center).norm() - radius).collect();
        let rms = (distances.iter().map(|d| d * d).sum::<f64>() / distances.len() as f64).sqrt();
        let area = topology_report(&mesh).area_mm2 / (4.0 * std::f64::consts::PI * radius.powi(2));
        errors.push([rms, (area - 1.0).abs()]);
    }
    // The filter alone leaves 0.12 voxels at any radius.
    assert!(errors[0][0] < 0.13 && errors[1][0] < 0.09 && errors[2][0] < 0.07, "{errors:?}");
    assert!(errors[0][1] < 0.025 && errors[1][1] < 0.01 && errors[2][1] < 0.005, "{errors:?}");
}

#[test]
fn an_empty_set_has_no_surface() {
    assert!(matches!(
        constrained_surface(&VoxelMask::empty([4; 3], Matrix4::identity())),
        Err(MeshError::Empty { .. })
    ));
}
