//! Soft assignment of one oriented point set to another: the expectation step of coherent point drift, with normals
//! and features beside positions.
//!
//! `g_ij = exp(−‖p_i − q_j‖² / 2σ² − ν (1 − ⟨n_i, n_j⟩) − ½ Σ_f π_f (f_i − f_j)²)`, 0 beyond `3σ` or where normals
//! oppose; every target point `j` is one of the source's, or of a uniform background: `w_ij = a_i g_ij / (b + Σ_i a_i
//! g_ij)`, `a` the areas, so that the density of vertices on either side does not matter.
//!
//! Source: Myronenko, Song, IEEE PAMI 32(12), 2010.

use super::neighbors::NeighborGrid;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Farther than this many standard deviations nothing is assigned; what is left out weighs about 1 %.
const REACH: f64 = 3.0;

/// Points of a surface with what is known at each; slices of equal length.
#[derive(Debug, Clone, Copy)]
pub struct Samples<'a> {
    /// Positions, mm.
    pub points: &'a [Point3<f64>],
    /// Unit normals.
    pub normals: &'a [Vector3<f64>],
    /// Area that each stands for, mm².
    pub areas: &'a [f64],
    /// Features, `n × n_features`, a row a point.
    pub features: &'a [f64],
}

/// How alike two points must be.
#[derive(Debug, Clone, PartialEq)]
pub struct Likeness {
    /// `σ`, mm.
    pub sigma_mm: f64,
    /// `ν`.
    pub normal_weight: f64,
    /// `π_f`, the precision of each feature.
    pub feature_precision: Vec<f64>,
    /// The background, as a share of what a matching surface gives.
    pub outlier: f64,
}

/// Where each source point should go.
#[derive(Debug, Clone, PartialEq)]
pub struct Assignment {
    /// Mean of its target points, mm; where the mass is 0, where it is.
    pub targets: Vec<Point3<f64>>,
    /// Area of the target that is assigned to it over its own.
    pub mass: Vec<f64>,
    /// Mean squared difference of each feature between assigned points.
    pub feature_variance: Vec<f64>,
    /// Mean over both surfaces of `−ln` of how much of a matching surface each point sees; lower is better.
    pub misfit: f64,
}

/// Assigns `target` to the moved `source`. Sums in order of the points: the same bits on any number of threads.
///
/// # Cost
/// `O(pairs within reach)`, and as much memory.
pub fn assign(source: &Samples<'_>, target: &Samples<'_>, likeness: &Likeness) -> Assignment {
    let n_features = likeness.feature_precision.len();
    let features =
        |side: &Samples<'_>, i: usize| -> Vec<f64> { side.features[i * n_features..][..n_features].to_vec() };
    let radius = REACH * likeness.sigma_mm;
    let grid = NeighborGrid::new(target.points, radius);
    let scale = 0.5 / (likeness.sigma_mm * likeness.sigma_mm);
    let rows: Vec<Vec<(u32, f64)>> = (0..source.points.len())
        .into_par_iter()
        .map(|i| {
            let own = features(source, i);
            let mut row = Vec::new();
            grid.within(&source.points[i], radius, |j, squared| {
                let k = j as usize;
                let agreement = source.normals[i].dot(&target.normals[k]);
                if agreement <= 0.0 {
                    return;
                }
                let others = &target.features[k * n_features..][..n_features];
                let unlike: f64 = own
                    .iter()
                    .zip(others)
                    .zip(&likeness.feature_precision)
                    .map(|((a, b), precision)| precision * (a - b) * (a - b))
                    .sum();
                let energy = scale * squared + likeness.normal_weight * (1.0 - agreement) + 0.5 * unlike;
                row.push((j, (-energy).exp()));
            });
            row
        })
        .collect();
    // A flat matching surface sums to this.
    let whole = TAU * likeness.sigma_mm * likeness.sigma_mm;
    let background = likeness.outlier * whole;
    let seen: Vec<f64> = rows
        .iter()
        .map(|row| background + row.iter().map(|&(j, g)| target.areas[j as usize] * g).sum::<f64>())
        .collect();
    let mut explained = vec![background; target.points.len()];
    for (row, area) in rows.iter().zip(source.areas) {
        for &(j, g) in row {
            explained[j as usize] += area * g;
        }
    }
    let n = source.points.len();
    let (mut targets, mut masses) = (Vec::with_capacity(n), Vec::with_capacity(n));
    let mut feature_variance = vec![0.0; n_features];
    let mut total = 0.0;
    for (i, row) in rows.iter().enumerate() {
        let own = features(source, i);
        let (mut mass, mut sum) = (0.0, Vector3::zeros());
        for &(j, g) in row {
            let k = j as usize;
            let weight = target.areas[k] * g / explained[k];
            mass += weight;
            sum += weight * (target.points[k] - source.points[i]);
            for (f, variance) in feature_variance.iter_mut().enumerate() {
                *variance += weight * source.areas[i] * (own[f] - target.features[k * n_features + f]).powi(2);
            }
        }
        total += mass * source.areas[i];
        targets.push(source.points[i] + if mass > 0.0 { sum / mass } else { Vector3::zeros() });
        masses.push(mass);
    }
    for variance in &mut feature_variance {
        *variance /= total.max(f64::MIN_POSITIVE);
    }
    let mean_misfit = |sums: &[f64], areas: &[f64]| {
        let weighted: f64 = sums.iter().zip(areas).map(|(s, a)| -a * (s / whole).ln()).sum();
        weighted / areas.iter().sum::<f64>()
    };
    let misfit = 0.5 * (mean_misfit(&seen, source.areas) + mean_misfit(&explained, target.areas));
    Assignment { targets, mass: masses, feature_variance, misfit }
}
