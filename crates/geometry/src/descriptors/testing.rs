//! Properties that every descriptor must have.

use super::Descriptor;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::{Isometry3, Point3, Vector3};

/// A bent and tapered ellipsoid without symmetry.
pub(super) fn bean(level: u32) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap()
}

/// Checks `descriptor(mesh, size)` on a bean of that size: the same to the bit at a size scaled by a power of two and
/// on one thread, to `rounding` in another pose, and between a level and the next finer one to the share `sampling` of
/// its spread.
pub(super) fn check_invariance(
    descriptor: &(dyn Fn(&SurfaceMesh, f64) -> Descriptor + Sync),
    rounding: f64,
    sampling: f64,
) {
    let mesh = bean(3);
    let with = |change: &dyn Fn(&Point3<f64>) -> Point3<f64>| {
        mesh.with_vertices(mesh.vertices().iter().map(change).collect()).unwrap()
    };
    let found = descriptor(&mesh, 1.0);
    assert_eq!(found.n_vertices(), mesh.n_vertices());
    for power in [-9, 6] {
        let factor = 2f64.powi(power);
        assert_eq!(found, descriptor(&with(&|p| p * factor), factor), "size 2^{power}");
    }
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(found, alone.install(|| descriptor(&mesh, 1.0)));
    let motion = Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7));
    let moved = descriptor(&with(&|p| motion * p), 1.0);
    let largest = found.values.iter().fold(0.0f64, |most, v| most.max(v.abs()));
    for (a, b) in found.values.iter().zip(&moved.values) {
        assert!((a - b).abs() <= rounding * largest, "moved: {a} {b}");
    }
    // The vertices of a level are the first ones of the next finer.
    let finer_mesh = bean(4);
    assert_eq!(finer_mesh.vertices()[..mesh.n_vertices()], *mesh.vertices());
    let finer = descriptor(&finer_mesh, 1.0);
    let (n, c) = (mesh.n_vertices(), found.n_channels);
    let mean: Vec<f64> = (0..c).map(|k| (0..n).map(|i| found.row(i)[k]).sum::<f64>() / n as f64).collect();
    let squares = |other: &dyn Fn(usize, usize) -> f64| {
        (0..n)
            .flat_map(|i| (0..c).map(move |k| (i, k)))
            .map(|(i, k)| (found.row(i)[k] - other(i, k)).powi(2))
            .sum::<f64>()
    };
    let (apart, spread) = (squares(&|i, k| finer.row(i)[k]), squares(&|_, k| mean[k]));
    let share = (apart / spread).sqrt();
    println!("sampling changes it by {share:.3} of its spread");
    assert!(share < sampling, "sampling: {share}");
}
