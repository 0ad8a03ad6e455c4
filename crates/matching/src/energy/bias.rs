//! What the starts of belief propagation add to the unary potentials at first.

use super::settings::IsometrySettings;
use super::variance::variance_of_distance;
use crate::starts::forms::FormMatch;
use crate::surface::form::Places;
use nalgebra::Point3;

/// What `pairs` of a variable and a label, which correspond, add to the unary potentials of all `places` and `labels`: corresponding places
/// have the same distances from them.
pub(crate) fn bias_of_pairs(
    pairs: &[(usize, usize)],
    places: &Places,
    labels: &Places,
    settings: &IsometrySettings,
) -> Vec<f32> {
    let (n, n_labels) = (places.vertices.len(), labels.vertices.len());
    let bias = |(i, x): (usize, usize)| {
        let squared = pairs.iter().map(|&(j, y)| {
            let distance = places.distance(i, j);
            (labels.distance(x, y) - distance).powi(2) / variance_of_distance(distance, n_labels, settings)
        });
        (settings.bias_weight * (0.5 * squared.sum::<f64>()).min(settings.bias_truncation)) as f32
    };
    (0..n).flat_map(|i| (0..n_labels).map(move |x| (i, x))).map(bias).collect()
}

/// What `guess` adds to the unary potentials of these `variables`, sites of the form, where belief propagation begins; `places` are the
/// labels, mm, and `width_mm` the standard deviation of a proposed place.
pub(crate) fn bias_of_form(
    guess: &FormMatch,
    variables: &[u32],
    places: &[Point3<f64>],
    width_mm: f64,
    settings: &IsometrySettings,
) -> Vec<f32> {
    let bias = |&k: &u32| {
        let proposed = guess.images[k as usize];
        let weight = settings.bias_weight * guess.mass[k as usize].min(1.0);
        places.iter().map(move |q| {
            let squared = (q - proposed).norm_squared() / (width_mm * width_mm);
            (weight * (0.5 * squared).min(settings.bias_truncation)) as f32
        })
    };
    variables.iter().flat_map(bias).collect()
}
