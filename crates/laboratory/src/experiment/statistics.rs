//! Mean, spread and quartiles of a few numbers.

use serde::{Deserialize, Serialize};

/// Six statistics of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Sample size.
    pub n: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation, with `n − 1`; 0 for a single number.
    pub sd: f64,
    /// Lower quartile.
    pub q1: f64,
    /// Median.
    pub median: f64,
    /// Upper quartile.
    pub q3: f64,
}

/// Mean and standard deviation.
impl From<&Summary> for (f64, f64) {
    fn from(summary: &Summary) -> Self {
        (summary.mean, summary.sd)
    }
}

impl Summary {
    /// Statistics of the finite numbers among `values`; `None` if there are none. Cost `O(n log n)`.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let n = sorted.len();
        if n == 0 {
            return None;
        }
        let mean = sorted.iter().sum::<f64>() / n as f64;
        let squares: f64 = sorted.iter().map(|v| (v - mean).powi(2)).sum();
        let sd = if n > 1 { (squares / (n - 1) as f64).sqrt() } else { 0.0 };
        let at = |share| quantile(&sorted, share);
        Some(Summary { n, mean, sd, q1: at(0.25), median: at(0.5), q3: at(0.75) })
    }

    /// The summary in another unit: all values times `factor > 0`, for example 100 for percent.
    pub fn scaled(&self, factor: f64) -> Self {
        Summary {
            n: self.n,
            mean: factor * self.mean,
            sd: factor * self.sd,
            q1: factor * self.q1,
            median: factor * self.median,
            q3: factor * self.q3,
        }
    }
}

/// Quantile by linear interpolation between sorted values (definition 7 of Hyndman, Fan 1996).
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let (low, high) = (place.floor() as usize, place.ceil() as usize);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn five_numbers_have_the_summary_of_the_textbook() {
        let s = Summary::of([4.0, 1.0, 3.0, 2.0, 10.0]).unwrap();
        assert_eq!((s.n, s.mean, s.q1, s.median, s.q3), (5, 4.0, 2.0, 3.0, 4.0));
        assert!((s.sd - 12.5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn an_empty_sample_has_no_summary_and_one_number_no_spread() {
        assert_eq!(Summary::of([f64::NAN]), None);
        let one = Summary::of([2.5]).unwrap();
        assert_eq!((one.mean, one.sd, one.median), (2.5, 0.0, 2.5));
    }
}
