//! Robust statistics of values at the vertices of a surface.

/// Factor from the median absolute deviation to the standard deviation of normally distributed values.
pub(crate) const STD_OF_MAD: f64 = 1.4826;

/// The median of `values`, of an even number the upper one of the middle two; reorders `values`, which must not be
/// empty.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Mean of `values`, and its standard error.
pub(crate) fn mean_and_standard_error(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0);
    (mean, (variance / n).sqrt())
}

/// Mean of `values` over its standard error.
pub(crate) fn mean_over_standard_error(values: &[f64]) -> f64 {
    let (mean, error) = mean_and_standard_error(values);
    mean / error.max(f64::MIN_POSITIVE)
}

/// Robust center and scale of measurements.
pub(crate) struct Standard {
    center: f64,
    scale: f64,
}

impl Standard {
    /// Measurements are clamped to this many robust standard deviations from the median.
    const CAP: f64 = 3.0;

    /// The median and the scaled median absolute deviation of the values of `a` and `b` together, which must not be
    /// empty.
    pub(crate) fn of_both(a: &[f64], b: &[f64]) -> Standard {
        let mut all: Vec<f64> = a.iter().chain(b).copied().collect();
        let center = median(&mut all);
        all.iter_mut().for_each(|x| *x = (*x - center).abs());
        // The curvature of a sphere is constant; the floor avoids a division by 0.
        let scale = (STD_OF_MAD * median(&mut all)).max(f64::MIN_POSITIVE.sqrt());
        Standard { center, scale }
    }

    /// `value` in robust standard deviations from the median, clamped.
    pub(crate) fn score(&self, value: f64) -> f64 {
        ((value - self.center) / self.scale).clamp(-Self::CAP, Self::CAP)
    }
}

/// Pearson's correlation; 0 if one side is constant.
pub(crate) fn correlation(pairs: &[(f64, f64)]) -> f64 {
    let n = pairs.len() as f64;
    let (a, b) = pairs.iter().fold((0.0, 0.0), |(a, b), p| (a + p.0 / n, b + p.1 / n));
    let (ab, aa, bb) = pairs.iter().fold((0.0, 0.0, 0.0), |(ab, aa, bb), p| {
        let (x, y) = (p.0 - a, p.1 - b);
        (ab + x * y, aa + x * x, bb + y * y)
    });
    let spread = (aa * bb).sqrt();
    if spread > 0.0 { ab / spread } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn correlation_is_that_of_pearson() {
        let line: Vec<(f64, f64)> = (0..9).map(|k| (f64::from(k), 3.0 - 2.0 * f64::from(k))).collect();
        assert!((correlation(&line) + 1.0).abs() < 1e-12);
        // Computed by hand: x 1 2 3, y 1 3 2.
        assert!((correlation(&[(1.0, 1.0), (2.0, 3.0), (3.0, 2.0)]) - 0.5).abs() < 1e-12);
        assert_eq!(correlation(&[(1.0, 2.0), (1.0, 3.0)]), 0.0);
    }

    #[test]
    fn an_outlier_moves_no_score_but_its_own() {
        let a: Vec<f64> = (0..50).map(f64::from).collect();
        let mut b = a.clone();
        b[49] = 1e9;
        let (without, with) = (Standard::of_both(&a, &a), Standard::of_both(&a, &b));
        assert_eq!(without.score(10.0), with.score(10.0));
        assert_eq!(with.score(1e9), 3.0);
        assert_eq!(Standard::of_both(&[2.0; 4], &[2.0; 3]).score(2.0), 0.0);
    }
}
