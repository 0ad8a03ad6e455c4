//! Repeatability of measurements on a noisy surface: the largest correlation that two measurements of one shape can
//! reach.
//!
//! The noise of two samplings of one shape limits the correlation of their curvatures, even at true corresponding
//! points, to the geometric mean of their repeatabilities. The noise of a surface is estimated as the part that
//! smoothing removes. Reassigned to other vertices it gives another sampling of the same shape, whose curvatures are
//! compared with the first.
//!
//! Source: Spearman, "The proof and measurement of association between two things", 1904 (attenuation); Efron,
//! "Bootstrap methods", 1979 (reassigned residuals).

use super::robust::{Standard, correlation};
use super::smooth::{LARGEST_SCALE, SmoothSurface};
use homolog_geometry::curvature::{ScaleSpace, mean_curvature};
use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Seed of the reassignment of residuals.
const SEED: u64 = 1;

/// Correlation of the mean curvatures at the largest scale of `raw`, whose smoothed surface is `smooth`, with those of
/// another sampling of equal noise, in `[0, 1]`; 1 if it cannot be measured. `root_mm` is the root of the area, the
/// unit of scales.
///
/// # Cost
/// `O(n)`, plus the scale space of one surface.
pub(crate) fn repeatability(raw: &SurfaceMesh, smooth: &SmoothSurface, root_mm: f64) -> f64 {
    let points = smooth.mesh.vertices();
    let mut heights: Vec<f64> =
        raw.vertices().iter().zip(points).zip(&smooth.normals).map(|((p, q), n)| (p - q).dot(n)).collect();
    shuffle(&mut heights);
    let again: Vec<Point3<f64>> =
        points.iter().zip(&smooth.normals).zip(&heights).map(|((p, n), h)| p + n * *h).collect();
    let scale_mm = smooth.coarsening * LARGEST_SCALE * root_mm;
    let curvature = |mesh: &SurfaceMesh| {
        let smoothed = ScaleSpace::new(mesh).smoothed(scale_mm).ok()?;
        Some(mean_curvature(&smoothed))
    };
    let again = raw.with_vertices(again).ok().and_then(|mesh| curvature(&mesh));
    let (Some(first), Some(second)) = (curvature(raw), again) else { return 1.0 };
    let standard = Standard::of_both(&first, &second);
    let scored: Vec<(f64, f64)> =
        first.iter().zip(&second).map(|(a, b)| (standard.score(*a), standard.score(*b))).collect();
    let found = correlation(&scored);
    if found.is_finite() { found.clamp(0.0, 1.0) } else { 1.0 }
}

/// Fisher–Yates shuffle.
fn shuffle(values: &mut [f64]) {
    let mut draws = Xoshiro256PlusPlus::seed_from_u64(SEED);
    for i in (1..values.len()).rev() {
        let j = (u64::from(draws.next_u32()) * (i as u64 + 1)) >> 32;
        values.swap(i, j as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair::smooth_pair::smooth_pair;
    use crate::testing::numbers;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    /// A surface with bumps. Every vertex is moved by noise of this standard deviation, mm, along each axis.
    fn noisy(seed: u64, noise_mm: f64) -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(18.0, 9.0, 7.0), 4);
        let mut number = numbers(seed);
        let moved = mesh.vertices().iter().map(|p| {
            let bumps = 1.0 + 0.06 * (p.x * 0.7).sin() + 0.06 * (p.y * 0.9 + p.z * 0.5).cos();
            // Uniform numbers of this range have a standard deviation of 1.
            Point3::from(p.coords * bumps + Vector3::from_fn(|_, _| noise_mm * 12f64.sqrt() * (number() - 0.5)))
        });
        mesh.with_vertices(moved.collect()).unwrap()
    }

    #[test]
    fn a_surface_tells_how_well_another_sampling_with_as_much_noise_repeats_it() {
        for noise_mm in [0.2, 0.5, 0.9] {
            let (a, b) = (noisy(1, noise_mm), noisy(2, noise_mm));
            let root_mm = a.area().sqrt();
            let (smooth_a, smooth_b) = smooth_pair(&a, &b, root_mm, false).unwrap();
            // The first of the two features at the largest scale is mean curvature.
            let n = super::super::smooth::N_FEATURES;
            let of = |side: &SmoothSurface, i: usize| side.features[(i + 1) * n - 2];
            let both: Vec<(f64, f64)> = (0..a.n_vertices()).map(|i| (of(&smooth_a, i), of(&smooth_b, i))).collect();
            let (true_one, found) = (correlation(&both), repeatability(&a, &smooth_a, root_mm));
            assert!((found - true_one).abs() < 0.12, "{noise_mm} mm: {found} for {true_one}");
        }
    }
}
