//! Smooth surfaces of shapes whose area, volume and topology are known, and of random sets.

use super::*;
use crate::topology::topology_report;
use crate::volume::LabelVolume;
use nalgebra::{Matrix4, Vector3};
use proptest::prelude::*;

fn mask_of(dims: [usize; 3], affine: Matrix4<f64>, inside: impl Fn(Vector3<f64>) -> bool) -> VoxelMask {
    let n = dims.iter().product();
    let place = |k: usize| Vector3::new(k % dims[0], k / dims[0] % dims[1], k / (dims[0] * dims[1])).map(|c| c as f64);
    let labels = (0..n).map(|k| u32::from(inside(place(k)))).collect();
    LabelVolume::new(dims, labels, affine).unwrap().mask(None).unwrap()
}

fn ball(radius: f64) -> VoxelMask {
    let c = radius.ceil() + 1.0;
    let n = 2 * c as usize + 1;
    mask_of([n; 3], Matrix4::identity(), |p| (p - Vector3::repeat(c)).norm() <= radius)
}

#[test]
fn a_ball_converges_to_its_area_and_volume() {
    let mut errors = Vec::new();
    for radius in [5.0, 10.0, 20.0] {
        let mesh = smooth_surface(&ball(radius), 1.0, FieldRepair::default()).unwrap().mesh;
        let report = topology_report(&mesh);
        assert_eq!((report.genus, report.n_components), (Some(0), 1));
        // The filter moves a boundary of mean curvature 1/r inwards by σ²/r.
        let radius: f64 = radius - 1.0 / radius;
        let volume = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let area = 4.0 * std::f64::consts::PI * radius.powi(2);
        errors.push([report.volume_mm3.unwrap() / volume - 1.0, report.area_mm2 / area - 1.0].map(f64::abs));
    }
    assert!(errors[0][0] < 0.05 && errors[1][0] < 0.015 && errors[2][0] < 0.006, "{errors:?}");
    assert!(errors[0][1] < 0.05 && errors[1][1] < 0.015 && errors[2][1] < 0.006, "{errors:?}");
}

#[test]
fn an_affine_map_of_the_voxels_maps_the_surface() {
    let base = ball(6.0);
    for mirror in [1.0, -1.0] {
        let affine = Matrix4::new(
            0.0, -1.0, 0.0, 5.0, //
            mirror, 0.0, 0.0, -7.0, //
            0.0, 0.0, 1.0, 90.0, //
            0.0, 0.0, 0.0, 1.0,
        );
        let moved = VoxelMask { affine: affine * base.affine, ..base.clone() };
        let (a, b) = (
            smooth_surface(&base, 0.7, FieldRepair::default()).unwrap().mesh,
            smooth_surface(&moved, 0.7, FieldRepair::default()).unwrap().mesh,
        );
        for (p, q) in a.vertices().iter().zip(b.vertices()) {
            assert!((affine.transform_point(p) - q).norm() < 1e-12);
        }
        assert!((a.signed_volume() - b.signed_volume()).abs() < 1e-9);
    }
}

#[test]
fn the_filter_acts_in_millimeters_on_anisotropic_voxels() {
    let affine = Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, 1.0, 2.0));
    let at = |p: Vector3<f64>| Vector3::new(p.x - 12.0, p.y - 12.0, 2.0 * p.z - 12.0);
    let mask = mask_of([25, 25, 13], affine, |p| at(p).norm() <= 10.0);
    let report = topology_report(&smooth_surface(&mask, 1.0, FieldRepair::default()).unwrap().mesh);
    let volume = 4.0 / 3.0 * std::f64::consts::PI * 9.9f64.powi(3);
    let error = report.volume_mm3.unwrap() / volume - 1.0;
    assert!(error.abs() < 0.05, "{error}");
}

#[test]
fn no_triangle_is_a_sliver() {
    let mesh = smooth_surface(&ball(8.0), 0.7, FieldRepair::default()).unwrap().mesh;
    let smallest = mesh.face_vector_areas().iter().map(|a| a.norm()).fold(f64::INFINITY, f64::min);
    assert!(smallest > 1e-3, "{smallest}");
}

/// All 256 patterns of one cube, and every pair of neighboring cubes of random sets, close to 2-manifolds.
#[test]
fn every_sign_pattern_gives_closed_loops() {
    for pattern in 1..256usize {
        let mask = mask_of([2; 3], Matrix4::identity(), |p| {
            pattern >> (p.x as usize + 2 * p.y as usize + 4 * p.z as usize) & 1 == 1
        });
        let report = topology_report(&smooth_surface(&mask, 0.0, FieldRepair::default()).unwrap().mesh);
        assert!(report.genus.is_some() && report.volume_mm3.unwrap() > 0.0, "{pattern}: {report:?}");
    }
}

fn random_set() -> impl Strategy<Value = (Vec<bool>, f64)> {
    (proptest::collection::vec(proptest::bool::weighted(0.6), 6 * 5 * 6), 0.0..1.2f64)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_set_gives_a_closed_manifold((voxels, sigma) in random_set()) {
        prop_assume!(voxels.contains(&true));
        let mask = mask_of([6, 5, 6], Matrix4::identity(), |p| voxels[p.x as usize + 6 * p.y as usize + 30 * p.z as usize]);
        if let Ok(surface) = smooth_surface(&mask, sigma, FieldRepair::default()) {
            let report = topology_report(&surface.mesh);
            prop_assert!(report.genus.is_some(), "{:?}", report);
            prop_assert!(report.volume_mm3.unwrap() > 0.0);
        }
    }

    #[test]
    fn any_set_repairs_to_a_sphere((voxels, sigma) in random_set()) {
        prop_assume!(voxels.contains(&true));
        let mask = mask_of([6, 5, 6], Matrix4::identity(), |p| voxels[p.x as usize + 6 * p.y as usize + 30 * p.z as usize]);
        let repair = FieldRepair { largest_component: true, fill: true };
        if let Ok(surface) = smooth_surface(&mask, sigma, repair) {
            let a = analyze(&surface.mesh);
            prop_assert_eq!(a.fault, None);
        }
    }
}
