//! What is measured at the places of a surface, and the unary potentials of two surfaces.

use super::settings::IsometrySettings;
use crate::surface::form::{Measured, Places};
use crate::surface::sites::Sites;
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use rayon::prelude::*;

/// Pairs of features whose plane gives a chirality; `N_FEATURES` stands for the eccentricity.
const PLANES: [[usize; 2]; 7] = [[0, 2], [2, 4], [1, 3], [3, 5], [2, N_FEATURES], [4, N_FEATURES], [3, N_FEATURES]];
/// Standard deviations of the Gaussian over which chirality is summed beyond which nothing counts.
const CHIRALITY_REACH: f64 = 3.0;

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

impl Signs {
    /// At all `sites` of `surface`: features are means over cells, and chirality is summed over the triangles between sites.
    ///
    /// Cost `O(n + sites · triangles)`.
    pub(crate) fn at_sites(surface: &SmoothSurface, sites: &Sites, settings: &IsometrySettings) -> Signs {
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
            // A product of two features: the root has their spread.
            sums.iter().map(|x| x.signum() * x.abs().sqrt()).collect()
        };
        Signs {
            chirality: (0..n).into_par_iter().map(chirality).collect(),
            eccentricity: sites.eccentricity.iter().map(|&e| vec![e]).collect(),
            features,
        }
    }

    /// Those of some of the places.
    pub(crate) fn picked(&self, which: &[u32]) -> Signs {
        let picked = |values: &[Vec<f64>]| which.iter().map(|&k| values[k as usize].clone()).collect();
        Signs {
            features: picked(&self.features),
            chirality: picked(&self.chirality),
            eccentricity: picked(&self.eccentricity),
        }
    }
}

/// For every variable and label the sum of the means over features, chirality and eccentricity.
pub(crate) fn unary_potentials(source: &Signs, target: &Signs, settings: &IsometrySettings) -> Vec<f32> {
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
