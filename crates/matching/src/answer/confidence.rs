//! The probability that an image is close to the truth.
//!
//! The amplitude and noise behind the variance of an image are estimated from the pair, so the variance is known only
//! up to a factor. Errors then follow Student's t, which has more small and more large errors than a normal
//! distribution of the same variance.
//!
//! Source: Gelman et al., "Bayesian Data Analysis", 3rd edition, 2013, section 3.2 (t as a mixture of normal
//! distributions).

use std::f64::consts::TAU;

/// Degrees of freedom of the errors, and their scale in standard deviations of the estimated variance.
const DEGREES_OF_FREEDOM: f64 = 8.0;
const ERROR_SCALE: f64 = 0.925;
/// Radii and angles of the quadrature over an error in the tangent plane.
const RADII: usize = 16;
const ANGLES: usize = 24;

/// The scale along each axis of an error in the tangent plane with this variance, mm².
pub(crate) fn error_scale(variance: f64) -> f64 {
    ERROR_SCALE * (variance / 2.0).sqrt()
}

/// Root mean square length, mm, of an error of this scale.
pub(crate) fn spread_of_scale(scale: f64) -> f64 {
    scale * (2.0 * DEGREES_OF_FREEDOM / (DEGREES_OF_FREEDOM - 2.0)).sqrt()
}

/// Lengths of a Student's t error in a plane with scale 1 along each axis, at the midpoints of intervals of equal
/// probability.
pub(crate) fn equally_probable_radii() -> [f64; RADII] {
    std::array::from_fn(|k| {
        // The length `r` that is exceeded with probability `q` satisfies (1 + r²/ν)^(−ν/2) = q.
        let exceeded = (k as f64 + 0.5) / RADII as f64;
        (DEGREES_OF_FREEDOM * (exceeded.powf(-2.0 / DEGREES_OF_FREEDOM) - 1.0)).sqrt()
    })
}

/// Probability that a Student's t error in a plane, of this `scale` along each axis, ends within `radius` of a point at
/// distance `offset`; by quadrature at these `radii` and equally spaced angles.
pub(crate) fn within(radius: f64, offset: f64, scale: f64, radii: &[f64; RADII]) -> f64 {
    let mut hits = 0.0;
    for r in radii.map(|r| scale * r) {
        for a in 0..ANGLES {
            let angle = TAU * (a as f64 + 0.5) / ANGLES as f64;
            let squared = offset * offset + r * r + 2.0 * offset * r * angle.cos();
            hits += f64::from(u8::from(squared <= radius * radius));
        }
    }
    hits / (RADII * ANGLES) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::numbers;

    /// A normal error in a plane whose variance is drawn from an inverse gamma distribution; the mixture is Student's t
    /// with this scale.
    fn drawn(number: &mut impl FnMut() -> f64, scale: f64) -> [f64; 2] {
        let mut normal = || (0..12).map(|_| number()).sum::<f64>() - 6.0;
        let chi_squared: f64 = (0..DEGREES_OF_FREEDOM as usize).map(|_| normal().powi(2)).sum();
        let sigma = scale * (DEGREES_OF_FREEDOM / chi_squared).sqrt();
        [sigma * normal(), sigma * normal()]
    }

    #[test]
    fn the_probability_is_that_of_normal_errors_of_uncertain_variance() {
        let mut number = numbers(5);
        let radii = equally_probable_radii();
        let probability = |radius: f64, offset: f64, scale: f64| within(radius, offset, scale, &radii);
        for (offset, scale) in [(0.0, 0.2f64), (0.0, 0.5), (0.4, 0.5), (0.3, 1.0), (0.7, 0.3)] {
            let n = 20_000;
            let is_hit = |[x, y]: [f64; 2]| (x + offset).powi(2) + y * y <= 1.0;
            let hits = (0..n).filter(|_| is_hit(drawn(&mut number, scale))).count() as f64 / f64::from(n);
            assert!((probability(1.0, offset, scale) - hits).abs() < 0.03, "{offset} {scale}: {hits}");
        }
        // A small error at the edge of a wide disc falls inside with probability one half.
        assert!((probability(100.0, 100.0, 0.1) - 0.5).abs() < 0.05);
        assert!(probability(1.0, 0.2, 0.3) > probability(1.0, 0.6, 0.3));
        assert!(probability(1.0, 0.2, 0.3) > probability(1.0, 0.2, 0.6));
    }
}
