//! Soft assignment of one oriented point set to another: the expectation step of coherent point drift, with normals
//! and features beside positions.
//!
//! `g_ij = exp(−‖p_i − q_j‖² / 2σ² − ν (1 − ⟨n_i, n_j⟩) − ½ Σ_f π_f (f_i − f_j)²)`, 0 beyond `3σ` or where normals
//! oppose; every target point `j` is one of the source's, or of a uniform background: `w_ij = a_i g_ij / (b + Σ_i a_i
//! g_ij)`, `a` the areas, so that the density of vertices on either side does not matter.
//!
//! Source: Myronenko, Song, IEEE PAMI 32(12), 2010.

use super::affinity::{Affinities, Means};
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

/// Assigns `target` to the moved `source`. Affinities are 32-bit numbers, relative errors about 1e-6; sums in order of
/// the points, so the same bits on any number of threads.
///
/// # Cost
/// `O(pairs within reach)`, and as much memory, for a target whose neighbours have numbers close to each other (see
/// [`homolog_mesh::canonicalize`]); `O(pairs)` for any other.
pub fn assign(source: &Samples<'_>, target: &Samples<'_>, likeness: &Likeness) -> Assignment {
    let n = source.points.len();
    let affinities = Affinities::new(target, likeness, REACH * likeness.sigma_mm);
    let rows: Vec<_> = (0..n).into_par_iter().map(|i| affinities.row(source, i)).collect();
    // A flat matching surface sums to this.
    let whole = TAU * likeness.sigma_mm * likeness.sigma_mm;
    let background = likeness.outlier * whole;
    let explained = affinities.explained(&rows, source.areas, background);
    let shares = affinities.shares(&explained);
    let means: Vec<Means> = (0..n).into_par_iter().map(|i| affinities.means(source, i, &rows[i], &shares)).collect();
    let mut feature_variance = vec![0.0; likeness.feature_precision.len()];
    let mut total = 0.0;
    for (found, area) in means.iter().zip(source.areas) {
        total += found.mass * area;
        for (sum, variance) in feature_variance.iter_mut().zip(&found.feature_variance) {
            *sum += variance * area;
        }
    }
    for variance in &mut feature_variance {
        *variance /= total.max(f64::MIN_POSITIVE);
    }
    let mean_misfit = |sums: &[f64], areas: &[f64]| {
        let weighted: f64 = sums.iter().zip(areas).map(|(s, a)| -a * (s / whole).ln()).sum();
        weighted / areas.iter().sum::<f64>()
    };
    let seen: Vec<f64> = rows.iter().map(|row| background + row.seen).collect();
    let explained: Vec<f64> = explained.as_flattened()[..target.points.len()].iter().map(|&s| f64::from(s)).collect();
    Assignment {
        targets: source.points.iter().zip(&means).map(|(p, found)| p + found.offset).collect(),
        mass: means.iter().map(|found| found.mass).collect(),
        feature_variance,
        misfit: 0.5 * (mean_misfit(&seen, source.areas) + mean_misfit(&explained, target.areas)),
    }
}
