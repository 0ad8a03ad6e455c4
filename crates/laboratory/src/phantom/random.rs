//! The random stream of phantoms: xoshiro256++, seeded by an explicit `u64` and a name for the use.
//!
//! The generator is Blackman and Vigna's xoshiro256++ (ACM Trans. Math. Softw. 47(4), 2021), whose state SplitMix64
//! fills from `seed ^ stream constant`. Every use (shape, deformation, pose, permutation) has its own constant, so that
//! equal seeds give unrelated values for different uses. The order of the draws in each file is part of the format:
//! changing it changes the meaning of every seed.

use nalgebra::Vector3;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Use of a stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stream {
    /// The shape of a subject.
    Shape,
    /// A smooth deformation.
    Deformation,
    /// A rigid pose.
    Pose,
    /// A permutation of vertices.
    Permutation,
}

impl Stream {
    /// Digits of pi, e, the square roots of two and of three.
    fn constant(self) -> u64 {
        match self {
            Stream::Shape => 0x3141_5926_5358_9793,
            Stream::Deformation => 0x2718_2818_2845_9045,
            Stream::Pose => 0x1414_2135_6237_3095,
            Stream::Permutation => 0x1732_0508_0756_8877,
        }
    }
}

/// A seeded source of uniform and normal numbers.
#[derive(Debug, Clone)]
pub(crate) struct Draws(Xoshiro256PlusPlus);

impl Draws {
    pub(crate) fn new(stream: Stream, seed: u64) -> Self {
        Draws(Xoshiro256PlusPlus::seed_from_u64(seed ^ stream.constant()))
    }

    /// Uniform in `[0, 1)`, from the 53 high bits of one draw.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in `[low, high)`.
    pub(crate) fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform in `0..n` without bias, by rejection; `n > 0`.
    pub(crate) fn below(&mut self, n: u64) -> u64 {
        let limit = u64::MAX - u64::MAX % n.max(1);
        loop {
            let draw = self.0.next_u64();
            if draw < limit {
                return draw % n.max(1);
            }
        }
    }

    /// Standard normal, by Box and Muller; two draws per value.
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }

    /// Normal with the given mean and standard deviation, cut at two standard deviations.
    pub(crate) fn around(&mut self, mean: f64, deviation: f64) -> f64 {
        mean + deviation * self.normal().clamp(-2.0, 2.0)
    }

    /// Three independent standard normals.
    pub(crate) fn normal_vector(&mut self) -> Vector3<f64> {
        let x = self.normal();
        let y = self.normal();
        Vector3::new(x, y, self.normal())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_of_one_seed_differ_and_repeat() {
        let draw = |stream| Draws::new(stream, 7).unit();
        assert_ne!(draw(Stream::Shape), draw(Stream::Pose));
        assert_eq!(draw(Stream::Shape), draw(Stream::Shape));
    }

    #[test]
    fn normal_draws_have_mean_zero_and_variance_one() {
        let mut draws = Draws::new(Stream::Shape, 1);
        let values: Vec<f64> = (0..20_000).map(|_| draws.normal()).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64;
        assert!(mean.abs() < 0.03 && (variance - 1.0).abs() < 0.04, "mean {mean}, variance {variance}");
    }
}
