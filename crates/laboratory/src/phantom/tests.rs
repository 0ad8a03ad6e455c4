//! Phantoms are closed, manifold, of genus 0, the same for the same seed, and known in every point.

use super::*;
use homolog_mesh::SurfaceMesh;
use std::collections::{BTreeMap, BTreeSet};

/// `V − E + F` of a mesh that is checked to be closed, oriented and with one fan at every vertex.
fn euler_of_closed_manifold(mesh: &SurfaceMesh) -> i64 {
    let mut directed = BTreeSet::new();
    let mut fans: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for f in mesh.faces() {
        for k in 0..3 {
            assert!(directed.insert((f[k], f[(k + 1) % 3])), "a directed edge has two faces");
            fans.entry(f[k]).or_default().insert(f[(k + 1) % 3], f[(k + 2) % 3]);
        }
    }
    assert!(directed.iter().all(|&(a, b)| directed.contains(&(b, a))), "an edge has one face");
    assert_eq!(fans.len(), mesh.n_vertices(), "a vertex has no face");
    for fan in fans.values() {
        let first = *fan.keys().next().unwrap();
        let mut at = fan[&first];
        let mut turns = 1;
        while at != first {
            at = fan[&at];
            turns += 1;
        }
        assert_eq!(turns, fan.len(), "a vertex has two fans");
    }
    mesh.n_vertices() as i64 - mesh.edges().len() as i64 + mesh.n_faces() as i64
}

#[test]
fn surfaces_of_many_seeds_are_spheres_of_plausible_size() {
    for seed in 0..60 {
        let phantom = Phantom::new(seed);
        let surface = phantom.surface(DEFAULT_EDGE_MM).unwrap();
        assert_eq!(euler_of_closed_manifold(&surface.mesh), 2, "seed {seed}");
        let n = surface.mesh.n_vertices();
        assert!((1900..3200).contains(&n), "seed {seed} has {n} vertices");
        let volume = surface.mesh.signed_volume();
        assert!((2200.0..4000.0).contains(&volume), "seed {seed} has a volume of {volume} mm³");
        let edge = surface.mesh.mean_edge_length();
        assert!((0.76..0.9).contains(&edge), "seed {seed} has a mean edge of {edge} mm");
        assert!((34.0..48.0).contains(&phantom.length_mm()));
    }
}

#[test]
fn edge_lengths_choose_the_number_of_vertices() {
    let phantom = Phantom::new(5);
    for edge_mm in [0.5, 1.5, 3.0] {
        let mesh = phantom.surface(edge_mm).unwrap().mesh;
        assert_eq!(euler_of_closed_manifold(&mesh), 2);
        let mean = mesh.mean_edge_length();
        assert!((mean / edge_mm - 1.0).abs() < 0.25, "asked for {edge_mm}, got {mean}");
    }
    assert_eq!(phantom.surface(0.01), Err(PhantomError::EdgeOutOfRange { edge_mm: 0.01 }));
    assert!(phantom.surface(f64::NAN).is_err());
}

#[test]
fn no_triangle_is_degenerate() {
    for seed in 0..20 {
        let mesh = Phantom::new(seed).surface(1.0).unwrap().mesh;
        let smallest = mesh.face_vector_areas().iter().map(|a| a.norm()).fold(f64::INFINITY, f64::min);
        assert!(smallest > 0.02, "seed {seed} has a triangle of {smallest} mm²");
    }
}

#[test]
fn a_seed_means_one_shape_and_another_seed_another() {
    assert_eq!(Phantom::new(3).surface(1.0), Phantom::new(3).surface(1.0));
    let tips: BTreeSet<String> =
        (0..40).map(|seed| format!("{:.6}", Phantom::new(seed).surface_point(0.3, 1.0))).collect();
    assert_eq!(tips.len(), 40);
    assert_eq!(random_permutation(100, 4), random_permutation(100, 4));
    assert_ne!(random_pose(1), random_pose(2));
}

#[test]
fn the_volume_and_the_surface_are_one_shape() {
    for seed in 0..6 {
        let phantom = Phantom::new(seed);
        let volume = phantom.volume(0.5).unwrap();
        let voxels = volume.n_foreground() as f64 * volume.spacing_mm.powi(3);
        let mesh = phantom.surface(0.5).unwrap().mesh.signed_volume();
        assert!((voxels / mesh - 1.0).abs() < 0.02, "seed {seed}: {voxels} mm³ of voxels, {mesh} mm³ of mesh");
        let anterior = volume.labels.iter().filter(|&&l| l == 1).count() as f64 / volume.n_foreground() as f64;
        assert!((0.25..0.75).contains(&anterior), "seed {seed} is {anterior} anterior");
    }
}

#[test]
fn volumes_are_in_one_piece() {
    for seed in 0..6 {
        let v = Phantom::new(seed).volume(1.0).unwrap();
        let mut left: BTreeSet<usize> = (0..v.labels.len()).filter(|&k| v.labels[k] != 0).collect();
        let steps = [1, v.shape[0], v.shape[0] * v.shape[1]];
        let mut stack = vec![left.pop_first().unwrap()];
        while let Some(at) = stack.pop() {
            for step in steps {
                for next in [at + step, at - step] {
                    if left.remove(&next) {
                        stack.push(next);
                    }
                }
            }
        }
        assert!(left.is_empty(), "seed {seed}: {} voxels are apart", left.len());
    }
}

#[test]
fn deformations_have_the_stated_strength_and_keep_orientation() {
    for (seed, share) in [(1, 0.02), (2, 0.04), (3, 0.08), (4, 0.12)] {
        let mesh = Phantom::new(seed).surface(1.0).unwrap().mesh;
        let deformation = Deformation::new(mesh.vertices(), share, seed).unwrap();
        let (low, high) = mesh.bounding_box();
        let squares: f64 = mesh.vertices().iter().map(|p| (deformation.apply(p) - p).norm_squared()).sum();
        let rms = (squares / mesh.n_vertices() as f64).sqrt();
        assert!((rms / (high - low).norm() - share).abs() < 1e-12);
        for p in mesh.vertices() {
            assert!(deformation.jacobian_determinant(p) > MIN_JACOBIAN);
            let back = deformation.invert(&deformation.apply(p)).unwrap();
            assert!((back - p).norm() < 1e-6, "seed {seed}, share {share}");
        }
        let moved = mesh.with_vertices(mesh.vertices().iter().map(|p| deformation.apply(p)).collect()).unwrap();
        assert!(moved.signed_volume() > 0.0);
    }
    let p = [nalgebra::Point3::origin()];
    assert!(matches!(Deformation::new(&p, 0.5, 0), Err(PhantomError::ShareOutOfRange { .. })));
    assert_eq!(Deformation::new(&[], 0.02, 0), Err(PhantomError::NoVertices));
}

#[test]
fn the_jacobian_is_the_derivative() {
    let mesh = Phantom::new(9).surface(2.0).unwrap().mesh;
    let deformation = Deformation::new(mesh.vertices(), 0.06, 9).unwrap();
    let p = mesh.vertices()[17];
    let h = 1e-5;
    let columns = [0, 1, 2].map(|k| {
        let mut e = nalgebra::Vector3::zeros();
        e[k] = h;
        (deformation.apply(&(p + e)) - deformation.apply(&(p - e))) / (2.0 * h)
    });
    let expected = nalgebra::Matrix3::from_columns(&columns).determinant();
    assert!((deformation.jacobian_determinant(&p) - expected).abs() < 1e-7);
}

fn recipe() -> PairRecipe {
    PairRecipe {
        subject: 1,
        target_subject: 1,
        deform_share: 0.04,
        deform_seed: 2,
        pose_seed: Some(3),
        permute_seed: Some(4),
    }
}

#[test]
fn the_ground_truth_of_a_pair_locates_every_vertex() {
    let pair = PhantomPair::new(recipe()).unwrap();
    let source = pair.source_surface(1.5).unwrap();
    let (target, correspondent) = pair.target_surface(1.5).unwrap();
    assert!(pair.is_one_subject());
    assert_eq!(euler_of_closed_manifold(&target.mesh), 2);
    for (i, p) in source.mesh.vertices().iter().enumerate() {
        let j = correspondent[i] as usize;
        assert_eq!(target.mesh.vertices()[j], pair.place(p));
        assert_eq!(target.parts[j], source.parts[i]);
    }
    assert!(correspondent.iter().enumerate().any(|(i, &j)| i as u32 != j));
}

#[test]
fn a_deformed_and_posed_volume_is_that_of_the_deformed_and_posed_surface() {
    let pair = PhantomPair::new(recipe()).unwrap();
    let volume = pair.target_volume(0.7).unwrap();
    let voxels = volume.n_foreground() as f64 * volume.spacing_mm.powi(3);
    let mesh = pair.target_surface(0.7).unwrap().0.mesh.signed_volume();
    assert!((voxels / mesh - 1.0).abs() < 0.02, "{voxels} mm³ of voxels, {mesh} mm³ of mesh");
}
