//! Precision with which distances along two surfaces correspond.

use super::settings::IsometrySettings;

/// Variance of the distance between the labels of two variables that are `distance` apart, for `n_labels` labels.
pub(crate) fn variance_of_distance(distance: f64, n_labels: usize, settings: &IsometrySettings) -> f64 {
    // Lengths in roots of the area: an area of 1.
    let spacing = 1.0 / (n_labels as f64).sqrt();
    2.0 * (settings.label_noise * spacing).powi(2) + (settings.stretch * distance).powi(2)
}
