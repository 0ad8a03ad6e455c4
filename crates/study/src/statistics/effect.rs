//! Effect sizes with intervals, and power.
//!
//! A contrast with weights `a` of the observations has `t = d / ‖a‖`, where `d` is the effect over the standard
//! deviation of the residuals (Cohen's d). With normal residuals `t` has a noncentral t distribution with noncentrality
//! `δ / ‖a‖` for a true `δ`: its quantiles give exact intervals of `δ`, and its tails give power.
//!
//! Sources: Hedges, Olkin, *Statistical methods for meta-analysis*, 1985; Cumming, Finch 2001 (intervals); Cohen 1988
//! (power).

use super::linear::hedges;
use statrs::distribution::{Continuous, ContinuousCDF, Gamma, Normal, StudentsT};

/// Steps of an integral over the standard deviation.
const STEPS: usize = 2000;

/// A standardized effect.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Effect {
    /// The effect in its own unit.
    pub value: f64,
    /// Its robust standard error (HC3).
    pub robust_se: f64,
    /// The ends of the 95 % interval of the effect, from the robust standard error.
    pub interval: [f64; 2],
    /// t, with the robust standard error.
    pub t: f64,
    /// Two-sided p of the robust t.
    pub p: f64,
    /// The effect over the standard deviation of the residuals, corrected for small samples.
    pub g: f64,
    /// The ends of the exact 95 % interval of `g`.
    pub g_interval: [f64; 2],
}

/// `P(T ≤ t)` of the noncentral t distribution: the integral of a normal distribution over the distribution of the
/// standard deviation.
pub fn noncentral_t_cdf(t: f64, degrees: f64, noncentrality: f64) -> f64 {
    let (normal, Ok(gamma)) = (Normal::standard(), Gamma::new(degrees / 2.0, degrees / 2.0)) else { return f64::NAN };
    // s² is gamma distributed; the density beyond 12 of its deviations is negligible.
    let width = 12.0 / (2.0 * degrees).sqrt();
    let (low, high) = ((1.0 - width).max(0.0), 1.0 + width);
    let at =
        |s: f64| if s > 0.0 { 2.0 * s * gamma.ln_pdf(s * s).exp() * normal.cdf(t * s - noncentrality) } else { 0.0 };
    let step = (high - low) / STEPS as f64;
    let inner: f64 = (1..STEPS).map(|k| [2.0, 4.0][k % 2] * at(low + step * k as f64)).sum();
    (step / 3.0 * (at(low) + inner + at(high))).clamp(0.0, 1.0)
}

/// The noncentrality at which `t` is the quantile `share`.
fn noncentrality(t: f64, degrees: f64, share: f64) -> f64 {
    // The distribution function falls as the noncentrality rises.
    let reach = 10.0 + 2.0 * t.abs();
    let (mut low, mut high) = (t - reach, t + reach);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if noncentral_t_cdf(t, degrees, middle) > share {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// The 95 % interval of a standardized effect (Cohen's d): `length` is `‖a‖`, `t` the classical t.
pub fn interval_of_d(t: f64, degrees: f64, length: f64) -> [f64; 2] {
    [0.975, 0.025].map(|share| length * noncentrality(t, degrees, share))
}

/// Power of a two-sided test at `alpha` of a true standardized effect `d`.
pub fn power(d: f64, degrees: f64, length: f64, alpha: f64) -> f64 {
    let Ok(student) = StudentsT::new(0.0, 1.0, degrees) else { return f64::NAN };
    let critical = student.inverse_cdf(1.0 - alpha / 2.0);
    let noncentrality = d / length;
    1.0 - noncentral_t_cdf(critical, degrees, noncentrality) + noncentral_t_cdf(-critical, degrees, noncentrality)
}

/// The smallest number of subjects, in the proportions of this design of `n` subjects and `p` columns, at which a true
/// effect `d` is found with the given power; `None` above a hundred thousand.
pub fn subjects_needed(d: f64, n: usize, p: usize, length: f64, alpha: f64, wanted: f64) -> Option<usize> {
    // The weights of m subjects in the same proportions have the length of those of n, times √(n / m).
    let enough = |m: usize| power(d, (m - p) as f64, length * (n as f64 / m as f64).sqrt(), alpha) >= wanted;
    let mut high = p + 2;
    while !enough(high) {
        high *= 2;
        if high > 200_000 {
            return None;
        }
    }
    let mut low = (high / 2).max(p + 1);
    while high - low > 1 {
        let middle = usize::midpoint(low, high);
        if enough(middle) { high = middle } else { low = middle }
    }
    Some(high).filter(|&m| m <= 100_000)
}

/// The effect of a contrast in one variable: its value, robust error, classical t, robust t and p, from a map of one vertex.
pub(crate) fn effect(map: &super::linear::ContrastMap, degrees: f64, length: f64) -> Effect {
    let quantile = StudentsT::new(0.0, 1.0, degrees).map_or(f64::NAN, |student| student.inverse_cdf(0.975));
    let (value, robust_se) = (map.effect[0], map.robust_se[0]);
    let interval = [value - quantile * robust_se, value + quantile * robust_se];
    let g_interval = interval_of_d(map.t[0], degrees, length).map(|d| d * hedges(degrees));
    Effect { value, robust_se, interval, t: map.robust_t[0], p: map.robust_p[0], g: map.g[0], g_interval }
}
