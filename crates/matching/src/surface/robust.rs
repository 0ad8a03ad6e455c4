//! Robust statistics.

/// Factor from the median absolute deviation to the standard deviation of normally distributed values.
pub(crate) const STD_OF_MAD: f64 = 1.4826;

/// The median of `values`, the upper one of two; reorders them. `values` must not be empty.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
