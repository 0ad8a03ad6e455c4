//! Reduction of descriptors: the leading principal components of two surfaces together.

use super::Descriptor;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Largest number of components.
pub const MAX_COMPONENTS: usize = 8;
/// Share of the variance at which no further component is added.
const EXPLAINED: f64 = 0.95;

/// Variance of a channel, as a share of its squared mean, below which it counts as rounding and the channel is left
/// out.
const ROUNDING: f64 = 1e-24;

/// Components of two descriptors, by descending variance.
#[derive(Debug, Clone, PartialEq)]
pub struct Components {
    /// Components on the first surface, each a list with one value per vertex.
    pub first: Vec<Vec<f64>>,
    /// Components on the second surface.
    pub second: Vec<Vec<f64>>,
    /// Standard deviations of the components.
    pub deviations: Vec<f64>,
}

/// The leading principal components of `first` and `second` together: at least one, enough for 95 % of the variance, at
/// most [`MAX_COMPONENTS`]. Vertices are weighted by their `areas`, and both surfaces have the same total weight. If
/// `standardized`, channels are first scaled to variance 1, which suits channels that are not bins of one histogram.
///
/// The sign of a component makes its largest coefficient positive; ties go to the first coefficient.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// `O(n c² + c³)` for `c` channels.
pub fn principal_components(
    first: (&Descriptor, &[f64]),
    second: (&Descriptor, &[f64]),
    standardized: bool,
    observer: &dyn Observer,
) -> Result<Components, Cancelled> {
    let c = first.0.n_channels;
    let shares = |areas: &[f64]| {
        let total: f64 = areas.iter().sum();
        areas.iter().map(|a| if total > 0.0 { 0.5 * a / total } else { 0.5 / areas.len() as f64 }).collect::<Vec<_>>()
    };
    let sides = [(first.0, shares(first.1)), (second.0, shares(second.1))];
    let mut mean = DVector::<f64>::zeros(c);
    for (descriptor, shares) in &sides {
        for (i, share) in shares.iter().enumerate() {
            mean.iter_mut().zip(descriptor.row(i)).for_each(|(m, v)| *m += share * v);
        }
    }
    // Centered rows times the square roots of their weights, so that the covariance is one product.
    let mut covariance = DMatrix::<f64>::zeros(c, c);
    for (descriptor, shares) in &sides {
        let rows = DMatrix::from_fn(shares.len(), c, |i, k| shares[i].sqrt() * (descriptor.row(i)[k] - mean[k]));
        // Column by column; each column is the same to the bit as in the whole product.
        let columns: Vec<DVector<f64>> = (0..c)
            .into_par_iter()
            .map(|k| {
                checkpoint_within(observer)?;
                Ok(rows.tr_mul(&rows.column(k)))
            })
            .collect::<Result<_, Cancelled>>()?;
        covariance.column_iter_mut().zip(&columns).for_each(|(mut sum, column)| sum += column);
    }
    let scale: Vec<f64> = (0..c)
        .map(|k| match covariance[(k, k)] {
            variance if variance <= ROUNDING * mean[k] * mean[k] => 0.0,
            variance if standardized => variance.sqrt().recip(),
            _ => 1.0,
        })
        .collect();
    let covariance = DMatrix::from_fn(c, c, |i, j| scale[i] * scale[j] * covariance[(i, j)]);
    let total = covariance.trace();
    let eigen = covariance.symmetric_eigen();
    let mut order: Vec<usize> = (0..c).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]).then(a.cmp(&b)));
    let mut components = Components { first: Vec::new(), second: Vec::new(), deviations: Vec::new() };
    let mut explained = 0.0;
    checkpoint_within(observer)?;
    for k in order.into_iter().take(MAX_COMPONENTS) {
        let direction = eigen.eigenvectors.column(k);
        let largest = direction.iter().copied().fold(0.0, |most: f64, v| if v.abs() > most.abs() { v } else { most });
        let sign = if largest < 0.0 { -1.0 } else { 1.0 };
        let combined = |descriptor: &Descriptor| -> Vec<f64> {
            let value = |i: usize| {
                let row = descriptor.row(i);
                sign * (0..c).map(|k| direction[k] * scale[k] * (row[k] - mean[k])).sum::<f64>()
            };
            (0..descriptor.n_vertices()).map(value).collect()
        };
        components.first.push(combined(first.0));
        components.second.push(combined(second.0));
        components.deviations.push(eigen.eigenvalues[k].max(0.0).sqrt());
        explained += eigen.eigenvalues[k];
        if explained >= EXPLAINED * total {
            break;
        }
    }
    Ok(components)
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_primitives::observe::Silent;

    /// `n` rows along two directions of three channels, with amplitudes 3 and 1 about a mean.
    fn sheet(n: usize, shift: f64) -> (Descriptor, Vec<f64>) {
        let mut values = Vec::new();
        for i in 0..n {
            let t = i as f64 / n as f64 * std::f64::consts::TAU + shift;
            let (a, b) = (3.0 * t.cos(), t.sin());
            values.extend([5.0 + 0.6 * a - 0.8 * b, -1.0 + 0.8 * a + 0.6 * b, 2.0]);
        }
        (Descriptor { n_channels: 3, values }, vec![2.0; n])
    }

    #[test]
    fn components_are_the_axes_of_an_ellipse() {
        let (one, other) = (sheet(200, 0.0), sheet(90, 0.3));
        let found = principal_components((&one.0, &one.1), (&other.0, &other.1), false, &Silent).unwrap();
        // 4.5 of 5 is 90 %: the second is needed, the third is nothing.
        assert_eq!(found.deviations.len(), 2);
        assert!(
            (found.deviations[0] - 4.5f64.sqrt()).abs() < 1e-9 && (found.deviations[1] - 0.5f64.sqrt()).abs() < 1e-9
        );
        for (side, n, shift) in [(&found.first, 200, 0.0), (&found.second, 90, 0.3)] {
            for i in 0..n {
                let t = f64::from(i) / f64::from(n) * std::f64::consts::TAU + shift;
                // Largest coefficients 0.8 and −0.8, which becomes positive.
                assert!((side[0][i as usize] - 3.0 * t.cos()).abs() < 1e-9);
                assert!((side[1][i as usize] + t.sin()).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_finely_sampled_part_counts_for_its_area() {
        // Every row of one half of the circle twice, with half the area.
        let (plain, areas) = sheet(100, 0.0);
        let (mut values, mut weights) = (Vec::new(), Vec::new());
        for (i, area) in areas.iter().enumerate() {
            for _ in 0..=usize::from(i < 50) {
                values.extend_from_slice(plain.row(i));
                weights.push(if i < 50 { 0.5 * area } else { *area });
            }
        }
        let twice = Descriptor { n_channels: 3, values };
        let a = principal_components((&plain, &areas), (&plain, &areas), true, &Silent).unwrap();
        let b = principal_components((&twice, &weights), (&twice, &weights), true, &Silent).unwrap();
        assert!(a.deviations.iter().zip(&b.deviations).all(|(x, y)| (x - y).abs() < 1e-12));
    }

    #[test]
    fn a_constant_descriptor_has_one_component_of_zeros() {
        let constant = Descriptor { n_channels: 2, values: vec![0.25; 20] };
        let found = principal_components((&constant, &[1.0; 10]), (&constant, &[0.0; 10]), true, &Silent).unwrap();
        assert_eq!((found.first, found.deviations), (vec![vec![0.0; 10]], vec![0.0]));
    }
}
