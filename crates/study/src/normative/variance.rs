//! Variances of many vertices, each from few values, drawn towards a common one.
//!
//! True variances are taken to be scaled inverse chi-squared with `d₀` degrees of freedom about `s₀²`. Both follow from
//! mean and variance of the logarithms of the sample variances; the moderated variance is the posterior mean of the
//! precision, inverted.
//!
//! Source: Smyth, *Linear models and empirical Bayes methods*, Statistical Applications in Genetics and Molecular Biology
//! 3, 2004, section 6.2.

use statrs::function::gamma::digamma;

/// Prior degrees of freedom that stand for infinitely many: all true variances are equal.
const ALL_EQUAL: f64 = 1e10;

/// The common distribution of the true variances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moderation {
    /// Its degrees of freedom, `d₀`; 0 if the variances have nothing in common.
    pub(super) degrees: f64,
    /// Its variance, `s₀²`.
    pub(super) variance: f64,
}

impl Moderation {
    /// The distribution behind sample variances of `degrees` degrees of freedom, weighted.
    pub(super) fn of(variances: &[f64], weights: &[f64], degrees: f64) -> Self {
        let largest = variances.iter().copied().fold(0.0, f64::max);
        let usable = || variances.iter().zip(weights).filter(|(variance, _)| **variance > 1e-12 * largest);
        let whole: f64 = usable().map(|(_, weight)| weight).sum();
        if !(whole > 0.0 && degrees > 0.0) {
            return Moderation { degrees: 0.0, variance: 0.0 };
        }
        let half = degrees / 2.0;
        let log = |variance: f64| variance.ln() - digamma(half) + half.ln();
        let mean = usable().map(|(variance, weight)| weight * log(*variance)).sum::<f64>() / whole;
        let spread = usable().map(|(variance, weight)| weight * (log(*variance) - mean).powi(2)).sum::<f64>() / whole;
        let beyond_sampling = spread - trigamma(half);
        if beyond_sampling <= trigamma(ALL_EQUAL / 2.0) {
            return Moderation { degrees: ALL_EQUAL, variance: mean.exp() };
        }
        let prior = 2.0 * inverse_trigamma(beyond_sampling);
        Moderation { degrees: prior, variance: (mean + digamma(prior / 2.0) - (prior / 2.0).ln()).exp() }
    }

    /// The moderated variance of a vertex.
    pub(super) fn moderated(&self, variance: f64, degrees: f64) -> f64 {
        (self.degrees * self.variance + degrees * variance) / (self.degrees + degrees)
    }
}

/// The derivative of the digamma function, for positive numbers; relative error below 1e-10.
fn trigamma(mut x: f64) -> f64 {
    let mut sum = 0.0;
    while x < 12.0 {
        sum += 1.0 / (x * x);
        x += 1.0;
    }
    // Asymptotic series: Abramowitz, Stegun 1964, 6.4.12.
    let y = 1.0 / (x * x);
    sum + 1.0 / x + y / 2.0 + y / x * (1.0 / 6.0 - y * (1.0 / 30.0 - y * (1.0 / 42.0 - y / 30.0)))
}

/// The number whose trigamma is `y`, by bisection on a logarithmic scale: trigamma decreases.
fn inverse_trigamma(y: f64) -> f64 {
    let (mut low, mut high) = (1e-6_f64.ln(), ALL_EQUAL.ln());
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if trigamma(middle.exp()) > y { low = middle } else { high = middle }
    }
    f64::midpoint(low, high).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trigamma_has_its_known_values() {
        let pi = std::f64::consts::PI;
        assert!((trigamma(1.0) - pi * pi / 6.0).abs() < 1e-10);
        assert!((trigamma(0.5) - pi * pi / 2.0).abs() < 1e-10);
        for x in [0.3, 2.0, 77.0] {
            assert!((inverse_trigamma(trigamma(x)) / x - 1.0).abs() < 1e-8, "{x}");
        }
    }

    #[test]
    fn variances_of_one_scale_are_pooled_and_others_are_kept_apart() {
        let weights = vec![0.01; 100];
        let equal = Moderation::of(&[2.0; 100], &weights, 10.0);
        assert_eq!(equal.degrees, ALL_EQUAL);
        assert!((equal.moderated(1.0, 10.0) / equal.variance - 1.0).abs() < 1e-6);
        let apart: Vec<f64> = (0..100).map(|k| f64::from(k % 10 - 5).exp()).collect();
        let found = Moderation::of(&apart, &weights, 1000.0);
        assert!(found.degrees < 2.0, "{found:?}");
        assert!((found.moderated(3.0, 1000.0) / 3.0 - 1.0).abs() < 0.01);
    }
}
