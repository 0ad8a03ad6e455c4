//! Many tests at once: the false discovery rate.

/// Adjusted p-values: the smallest false discovery rate at which each test is a discovery.
///
/// Source: Benjamini, Hochberg, *Controlling the false discovery rate*, 1995.
pub fn false_discovery(p: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|&a, &b| p[b].total_cmp(&p[a]));
    let (mut adjusted, mut least) = (vec![1.0; p.len()], 1.0f64);
    for (k, &test) in order.iter().enumerate() {
        let rank = p.len() - k;
        least = least.min(p[test] * p.len() as f64 / rank as f64);
        adjusted[test] = least;
    }
    adjusted
}
