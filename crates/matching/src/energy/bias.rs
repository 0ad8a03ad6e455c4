//! Biases: initial additions to the unary potentials from which belief propagation starts.

use super::settings::IsometrySettings;
use super::variance::variance_of_distance;
use crate::surface::sites::{SiteSubset, Sites};
use homolog_mrf::Labeling;

/// The bias of `pairs` of a variable and a label that correspond, for all `places` and `labels`: a label costs more the
/// more its distances from the labels of the pairs differ from the place's distances from their variables.
pub(crate) fn bias_of_pairs(
    pairs: &[(usize, usize)],
    places: &SiteSubset<'_>,
    labels: &SiteSubset<'_>,
    settings: &IsometrySettings,
) -> Vec<f32> {
    let (n, n_labels) = (places.len(), labels.len());
    let bias = |(i, x): (usize, usize)| {
        let squared = pairs.iter().map(|&(j, y)| {
            let distance = places.distance(i, j);
            (labels.distance(x, y) - distance).powi(2) / variance_of_distance(distance, n_labels, settings)
        });
        (settings.bias_weight * (0.5 * squared.sum::<f64>()).min(settings.bias_truncation)) as f32
    };
    (0..n).flat_map(|i| (0..n_labels).map(move |x| (i, x))).map(bias).collect()
}

/// A bias away from `labelings`: the initial cost of each label near the label of a variable in one of them, at most
/// `repulsion`, falling off over `width`, a distance along the surface in roots of its area.
pub(crate) fn bias_away_from(labelings: &[&Labeling], labels: &Sites, repulsion: f64, width: f64) -> Vec<f32> {
    let scale = -0.5 / (width * width);
    let cost = |d: f32| (repulsion * (scale * f64::from(d) * f64::from(d)).exp()) as f32;
    let n_variables = labelings.first().map_or(0, |labeling| labeling.len());
    let mut bias = vec![0.0f32; n_variables * labels.len()];
    for labeling in labelings {
        for (own, row) in labeling.iter().zip(bias.chunks_exact_mut(labels.len())) {
            row.iter_mut().zip(labels.row(*own as usize)).for_each(|(sum, &d)| *sum += cost(d));
        }
    }
    bias
}
