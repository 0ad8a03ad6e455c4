//! Measurements at the places of a surface, and the unary potentials of two surfaces.

use super::settings::IsometrySettings;
use crate::surface::sites::Sites;
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use rayon::prelude::*;

/// Pairs of features whose plane gives a chirality; `N_FEATURES` stands for the eccentricity.
const PLANES: [[usize; 2]; 7] = [[0, 2], [2, 4], [1, 3], [3, 5], [2, N_FEATURES], [4, N_FEATURES], [3, N_FEATURES]];
/// Distance beyond which a triangle does not count for chirality, in standard deviations of its Gaussian.
const CHIRALITY_REACH: f64 = 3.0;

/// Measurements at the places of one surface, `places × …` each.
pub(crate) struct SiteDescriptors {
    features: Vec<Vec<f64>>,
    chirality: Vec<Vec<f64>>,
    eccentricity: Vec<Vec<f64>>,
}

impl SiteDescriptors {
    /// The measurements of the mirror image.
    pub(crate) fn mirrored(&self) -> SiteDescriptors {
        let negated = |values: &Vec<f64>| values.iter().map(|x| -x).collect();
        SiteDescriptors {
            features: self.features.clone(),
            chirality: self.chirality.iter().map(negated).collect(),
            eccentricity: self.eccentricity.clone(),
        }
    }

    /// Measurements at all `sites` of `surface`: features are means over cells, and chirality is summed over the
    /// triangles between sites.
    ///
    /// Cost `O(n + sites · triangles)`.
    pub(crate) fn at_sites(surface: &SmoothSurface, sites: &Sites, settings: &IsometrySettings) -> SiteDescriptors {
        let n = sites.len();
        let (mut features, mut weights) = (vec![vec![0.0; N_FEATURES]; n], vec![0.0; n]);
        for ((&cell, area), own) in
            sites.cells.iter().zip(&surface.areas).zip(surface.features.chunks_exact(N_FEATURES))
        {
            let cell = cell as usize;
            weights[cell] += area;
            features[cell].iter_mut().zip(own).for_each(|(sum, f)| *sum += area * f);
        }
        for (sums, weight) in features.iter_mut().zip(&weights) {
            sums.iter_mut().for_each(|sum| *sum /= weight.max(f64::MIN_POSITIVE));
        }
        let value =
            |v: u32, f: usize| if f == N_FEATURES { sites.eccentricity[v as usize] } else { features[v as usize][f] };
        // Twice the signed area that each triangle covers in each plane.
        let covered = |t: &[u32; 3]| {
            PLANES.map(|[f, g]| {
                let [a, b, c] = t.map(|v| [value(v, f), value(v, g)]);
                (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
            })
        };
        let covered: Vec<[f64; PLANES.len()]> = sites.triangles.iter().map(covered).collect();
        let width = 3.0 * settings.chirality_width;
        let chirality = |site: usize| {
            let row = sites.row(site);
            let mut sums = [0.0; PLANES.len()];
            for (t, covered) in sites.triangles.iter().zip(&covered) {
                let distance = t.iter().map(|&v| f64::from(row[v as usize])).sum::<f64>() / width;
                if distance < CHIRALITY_REACH {
                    let weight = (-0.5 * distance * distance).exp();
                    sums.iter_mut().zip(covered).for_each(|(sum, covered)| *sum += weight * covered);
                }
            }
            // Chirality is a product of two features; its root has the scale of a feature.
            sums.iter().map(|x| x.signum() * x.abs().sqrt()).collect()
        };
        SiteDescriptors {
            chirality: (0..n).into_par_iter().map(chirality).collect(),
            eccentricity: sites.eccentricity.iter().map(|&e| vec![e]).collect(),
            features,
        }
    }

    /// The measurements of some of the places.
    pub(crate) fn picked(&self, which: &[u32]) -> SiteDescriptors {
        let picked = |values: &[Vec<f64>]| which.iter().map(|&k| values[k as usize].clone()).collect();
        SiteDescriptors {
            features: picked(&self.features),
            chirality: picked(&self.chirality),
            eccentricity: picked(&self.eccentricity),
        }
    }
}

/// The unary potential of every variable and label: the sum of the means over features, chirality and eccentricity.
pub(crate) fn unary_potentials(
    source: &SiteDescriptors,
    target: &SiteDescriptors,
    settings: &IsometrySettings,
) -> Vec<f32> {
    let mut unary = vec![0.0f32; source.features.len() * target.features.len()];
    for (a, b) in [
        (&source.features, &target.features),
        (&source.chirality, &target.chirality),
        (&source.eccentricity, &target.eccentricity),
    ] {
        let n = a[0].len();
        for f in 0..n {
            let noise = settings.feature_noise * pooled_deviation(a.iter().map(|x| x[f]), b.iter().map(|x| x[f]));
            let (share, limit) = (1.0 / n as f32, settings.unary_truncation as f32);
            let column: Vec<f32> = b.iter().map(|y| (y[f] / noise) as f32).collect();
            for (x, row) in a.iter().zip(unary.chunks_exact_mut(column.len())) {
                let x = (x[f] / noise) as f32;
                for (u, y) in row.iter_mut().zip(&column) {
                    let squared = (x - y) * (x - y);
                    *u += share * (0.5 * squared).min(limit);
                }
            }
        }
    }
    unary
}

/// Standard deviation of the values of both surfaces within each surface, and between their means.
fn pooled_deviation(a: impl Iterator<Item = f64> + Clone, b: impl Iterator<Item = f64> + Clone) -> f64 {
    let moments = |values: &mut dyn Iterator<Item = f64>| {
        let (mut n, mut sum, mut squares) = (0.0, 0.0, 0.0);
        for x in values {
            n += 1.0;
            sum += x;
            squares += x * x;
        }
        (sum / n, squares / n - (sum / n).powi(2))
    };
    let ((mean_a, var_a), (mean_b, var_b)) = (moments(&mut a.clone()), moments(&mut b.clone()));
    // A constant feature has no deviation; the floor avoids a division by 0.
    ((var_a.max(0.0) + var_b.max(0.0) + (mean_a - mean_b).powi(2)) / 2.0).sqrt().max(f64::MIN_POSITIVE.sqrt())
}
