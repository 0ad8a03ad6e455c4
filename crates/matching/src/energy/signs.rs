//! What is measured at the places of a surface, and the unary potentials of two surfaces.

use super::settings::IsometrySettings;
use crate::surface::form::{Measured, Places};
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use rayon::prelude::*;

/// Pairs of features whose plane gives a chirality; `N_FEATURES` stands for the eccentricity.
const PLANES: [[usize; 2]; 7] = [[0, 2], [2, 4], [1, 3], [3, 5], [2, N_FEATURES], [4, N_FEATURES], [3, N_FEATURES]];

/// What is measured at the places of one surface, `places × …` each.
pub(crate) struct Signs {
    features: Vec<Vec<f64>>,
    chirality: Vec<Vec<f64>>,
    eccentricity: Vec<Vec<f64>>,
}

impl Signs {
    /// Those of the mirror image.
    pub(crate) fn mirrored(&self) -> Signs {
        let negated = |values: &Vec<f64>| values.iter().map(|x| -x).collect();
        Signs {
            features: self.features.clone(),
            chirality: self.chirality.iter().map(negated).collect(),
            eccentricity: self.eccentricity.clone(),
        }
    }

    /// At `places` of the measured level of `surface`.
    pub(crate) fn of(
        surface: &SmoothSurface,
        measured: &Measured,
        places: &Places,
        settings: &IsometrySettings,
    ) -> Signs {
        let n = measured.mesh.n_vertices();
        // Even samples, so that each counts alike.
        let all = &measured.labels.rows;
        let mean_square = |v: usize| all.iter().map(|row| row[v] * row[v]).sum::<f64>() / all.len() as f64;
        let eccentricity: Vec<f64> = (0..n).map(|v| mean_square(v).sqrt()).collect();
        let value = |v: u32, f: usize| {
            if f == N_FEATURES {
                eccentricity[v as usize]
            } else {
                surface.features[measured.vertices[v as usize] as usize * N_FEATURES + f]
            }
        };
        let triangles: Vec<[u32; 3]> = measured.mesh.triangles();
        let at = |(&own, row): (&u32, &Vec<f64>)| {
            let weight = |distance: f64, width: f64| (-0.5 * (distance / width).powi(2)).exp();
            let (mut total, mut features) = (0.0, vec![0.0; N_FEATURES]);
            for v in 0..n as u32 {
                let w = weight(row[v as usize], settings.feature_width);
                total += w;
                features.iter_mut().enumerate().for_each(|(f, sum)| *sum += w * value(v, f));
            }
            features.iter_mut().for_each(|sum| *sum /= total);
            let mut chirality = vec![0.0; PLANES.len()];
            for t in &triangles {
                let distance = t.iter().map(|&v| row[v as usize]).sum::<f64>() / 3.0;
                if distance > 4.0 * settings.chirality_width {
                    continue;
                }
                let w = weight(distance, settings.chirality_width);
                for (sum, [f, g]) in chirality.iter_mut().zip(PLANES) {
                    let [a, b, c] = t.map(|v| [value(v, f), value(v, g)]);
                    *sum += w * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
                }
            }
            // A product of two features: the root has their spread.
            chirality.iter_mut().for_each(|x| *x = x.signum() * x.abs().sqrt());
            (features, chirality, vec![eccentricity[own as usize]])
        };
        let found: Vec<_> = places.vertices.par_iter().zip(&places.rows).map(at).collect();
        let mut signs = Signs { features: Vec::new(), chirality: Vec::new(), eccentricity: Vec::new() };
        for (features, chirality, eccentricity) in found {
            signs.features.push(features);
            signs.chirality.push(chirality);
            signs.eccentricity.push(eccentricity);
        }
        signs
    }
}

/// For every variable and label the sum of the means over features, chirality and eccentricity.
pub(crate) fn unary_potentials(source: &Signs, target: &Signs, settings: &IsometrySettings) -> Vec<f32> {
    let mut unary = vec![0.0; source.features.len() * target.features.len()];
    for (a, b) in [
        (&source.features, &target.features),
        (&source.chirality, &target.chirality),
        (&source.eccentricity, &target.eccentricity),
    ] {
        let n = a[0].len();
        for f in 0..n {
            let noise = settings.feature_noise * pooled_deviation(a.iter().map(|x| x[f]), b.iter().map(|x| x[f]));
            for (i, x) in a.iter().enumerate() {
                for (k, y) in b.iter().enumerate() {
                    let squared = ((x[f] - y[f]) / noise).powi(2);
                    unary[i * b.len() + k] += (0.5 * squared).min(settings.unary_truncation) / n as f64;
                }
            }
        }
    }
    unary.into_iter().map(|u| u as f32).collect()
}

/// Standard deviation of the values of both surfaces about their own means, and of those means.
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
    // A feature that is the same everywhere says nothing; the floor avoids a division by 0.
    ((var_a.max(0.0) + var_b.max(0.0) + (mean_a - mean_b).powi(2)) / 2.0).sqrt().max(f64::MIN_POSITIVE.sqrt())
}
