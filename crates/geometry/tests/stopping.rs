//! Measures whose balls may hold the whole surface stop within the work of one vertex, and spectra within that of one block: the
//! observer is asked at each, and none of it counts as a step.
#![allow(clippy::unwrap_used)]

use homolog_geometry::curvature::{Estimator, curvatures, vertex_areas};
use homolog_geometry::descriptors::{fpfh, principal_components, shape_contexts, shot, spin_images};
use homolog_geometry::harmonics::{HarmonicsError, ParametrizationOptions, parametrize};
use homolog_geometry::hierarchy::coarsen_observed;
use homolog_geometry::spectrum::spectrum;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::{Cancelled, Observer, Silent};
use nalgebra::Vector3;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Asks to stop after some checks, and counts checks and steps.
struct StopAfter {
    checks: usize,
    asked: AtomicUsize,
    counted: AtomicUsize,
}

impl StopAfter {
    fn new(checks: usize) -> Self {
        StopAfter { checks, asked: AtomicUsize::new(0), counted: AtomicUsize::new(0) }
    }
}

impl Observer for StopAfter {
    fn step(&self) {
        self.counted.fetch_add(1, Ordering::Relaxed);
    }
    fn is_cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.checks
    }
}

#[test]
fn the_map_onto_a_sphere_is_asked_around_each_of_its_factorizations() {
    let mesh = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
    // No step of the optimization, which asks too.
    let options = ParametrizationOptions { max_iterations: 0, ..ParametrizationOptions::default() };
    let whole = StopAfter::new(usize::MAX);
    parametrize(&mesh, &options, &whole).unwrap();
    // Before and after the order of elimination, and after the factorization, of three systems.
    let asked = whole.asked.load(Ordering::Relaxed);
    assert!(asked >= 9, "{asked} checks");
    for checks in 0..9 {
        let stopped = parametrize(&mesh, &options, &StopAfter::new(checks));
        assert_eq!(stopped.err(), Some(HarmonicsError::Cancelled(Cancelled)), "after {checks}");
    }
}

#[test]
fn coarsening_stops_within_some_thousand_vertices() {
    let mesh = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 6);
    let whole = StopAfter::new(usize::MAX);
    let coarse = coarsen_observed(&mesh, 3_000, &whole).unwrap().unwrap();
    let asked = whole.asked.load(Ordering::Relaxed);
    assert!(coarse.sites.len() > 2_900 && asked >= mesh.n_vertices() / 4_096, "{asked} checks");
    assert_eq!(whole.counted.load(Ordering::Relaxed), 0, "a piece is no step");
    for checks in [0, asked / 2, asked - 1] {
        assert_eq!(
            coarsen_observed(&mesh, 3_000, &StopAfter::new(checks)),
            Err(Cancelled),
            "after {checks} of {asked}"
        );
    }
}

type Measure<'a> = &'a dyn Fn(&dyn Observer) -> Result<(), Cancelled>;

#[test]
fn no_more_than_a_vertex_or_a_block_is_measured_between_two_checks() {
    let mesh = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
    let (n, all, k) = (mesh.n_vertices(), 100.0, 20);
    let areas = vertex_areas(&mesh);
    let described = shot(&mesh, 4.0, &Silent).unwrap();
    let side = || (&described, areas.as_slice());
    let measures: [(&str, usize, Measure<'_>); 8] = [
        ("shot", n, &|o| shot(&mesh, all, o).map(drop)),
        ("spin images", n, &|o| spin_images(&mesh, all, o).map(drop)),
        ("shape contexts", n, &|o| shape_contexts(&mesh, all, o).map(drop)),
        ("fpfh", 2 * n, &|o| fpfh(&mesh, all, o).map(drop)),
        ("quadric", n, &|o| curvatures(&mesh, Estimator::Quadric { radius_mm: all }, o).map(drop)),
        ("covariance", n, &|o| curvatures(&mesh, Estimator::Covariance { radius_mm: all }, o).map(drop)),
        // A column of the covariance of all channels, once for each surface.
        ("components", 2 * described.n_channels, &|o| principal_components(side(), side(), false, o).map(drop)),
        // Blocks of six vectors, of which twice as many are needed as pairs are wanted.
        ("spectrum", 2 * k / 6, &|o| spectrum(&mesh, k, o).map(drop)),
    ];
    for (name, pieces, measure) in measures {
        let whole = StopAfter::new(usize::MAX);
        assert_eq!(measure(&whole), Ok(()), "{name}");
        let asked = whole.asked.load(Ordering::Relaxed);
        assert!(asked >= pieces, "{name}: {asked} checks of {pieces} pieces");
        assert_eq!(whole.counted.load(Ordering::Relaxed), 0, "{name}: a piece is no step");
        for checks in [0, 1, asked / 2, asked - 1] {
            assert_eq!(measure(&StopAfter::new(checks)), Err(Cancelled), "{name} after {checks} of {asked}");
        }
    }
}
