//! Random numbers of the experiments: xoshiro256++ from an explicit seed.

use nalgebra::{Point3, Vector3};
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// A seeded stream.
pub(super) struct Draws(Xoshiro256PlusPlus);

impl Draws {
    pub(super) fn new(seed: u64) -> Self {
        Draws(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    /// Uniform in `[0, 1)`.
    pub(super) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in `0..n`.
    pub(super) fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }

    /// Three independent standard normals, by Box and Muller.
    pub(super) fn normals(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| {
            let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
            radius * (std::f64::consts::TAU * self.unit()).cos()
        })
    }

    /// The points with isotropic Gaussian noise of standard deviation `sigma_mm` per axis.
    pub(super) fn jitter(&mut self, points: &[Point3<f64>], sigma_mm: f64) -> Vec<Point3<f64>> {
        points.iter().map(|p| p + sigma_mm * self.normals()).collect()
    }
}
