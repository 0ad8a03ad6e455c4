//! Soft assignment to neighboring bins, so that a histogram changes continuously with the counted values.

/// The two bins of `n` on `[0, 1]` whose centers enclose `x`, with the share of each. Shares are linear between the
/// centers; beyond the outermost center the outermost bin gets everything.
pub(super) fn between(x: f64, n: usize) -> [(usize, f64); 2] {
    let at = (x * n as f64 - 0.5).clamp(0.0, (n - 1) as f64);
    let low = (at as usize).min(n.saturating_sub(2));
    let share = at - low as f64;
    [(low, 1.0 - share), ((low + 1).min(n - 1), share)]
}

/// Like [`between`], on a circle of length 1.
pub(super) fn around(x: f64, n: usize) -> [(usize, f64); 2] {
    let at = (x - x.floor()) * n as f64 - 0.5;
    let share = at - at.floor();
    let low = (at.floor() + n as f64) as usize % n;
    [(low, 1.0 - share), ((low + 1) % n, share)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_sum_to_one_and_keep_the_mean() {
        for k in 0..=100 {
            let x = f64::from(k) / 100.0;
            let found = between(x, 5);
            let mean: f64 = found.iter().map(|(bin, share)| share * (*bin as f64 + 0.5) / 5.0).sum();
            assert!(
                (mean - x.clamp(0.1, 0.9)).abs() < 1e-12 && found.iter().all(|(bin, share)| *bin < 5 && *share >= 0.0)
            );
            let found = around(x + 3.0, 4);
            assert!((found.iter().map(|f| f.1).sum::<f64>() - 1.0).abs() < 1e-12 && found.iter().all(|f| f.0 < 4));
        }
        // Across the seam: halfway between the centers of the last and the first bin.
        assert_eq!(around(1.0, 4), [(3, 0.5), (0, 0.5)]);
        assert_eq!(between(0.3, 1), [(0, 1.0), (0, 0.0)]);
    }
}
