//! Soft assignment with a Gaussian kernel, between points within reach of each other; see [`super`].
//!
//! `g_ij = exp(−‖p_i − q_j‖² / 2σ² − ν (1 − ⟨n_i, n_j⟩) − ½ Σ_f π_f (f_i − f_j)²)`, 0 beyond `3σ` or where normals
//! oppose. Every target point is assigned to the source points or to the background: `w_ij = a_j g_ij / (b + Σ_i a_i
//! g_ij)`.
//!
//! Consecutive target points form a block; a source point visits only the blocks whose bounding box is within its reach
//! and whose normals do not all oppose its own.

use super::{Block, LANES, LanePoint, Lanes, OrientedPoints, PackedPoints};
use super::{flat_density, mean_misfit, normal_agreements, squared_distances};
use homolog_primitives::exponential::exp_negative;
use multiversion::multiversion;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::ops::Range;

/// Cutoff of the kernel, standard deviations; the rest weighs about 1 %.
const REACH: f64 = 3.0;

/// Decrease of the affinity with distance, angle of normals and difference of features.
#[derive(Debug, Clone, PartialEq)]
pub struct AssignmentKernel {
    /// Width `σ`, mm.
    pub sigma_mm: f64,
    /// Weight `ν` of the normals.
    pub normal_weight: f64,
    /// Precision `π_f` of each feature.
    pub feature_precision: Vec<f64>,
    /// Outlier share `ω`, see [`super::OUTLIER_SHARE`].
    pub outlier_share: f64,
}

/// Result of an assignment for every source point.
#[derive(Debug, Clone, PartialEq)]
pub struct Assignment {
    /// Mean of the assigned target points, weighted by responsibility, mm; the source point itself where the mass is 0.
    pub targets: Vec<Point3<f64>>,
    /// Sum of the responsibilities: assigned target area over the area of the source point.
    pub mass: Vec<f64>,
    /// Mean squared difference of each feature between assigned points.
    pub feature_variance: Vec<f64>,
    /// [`misfit`] of the source with this kernel.
    pub misfit: f64,
}

/// A target, packed for repeated assignments.
pub struct AssignmentTarget {
    packed: PackedPoints,
    boxes: Boxes,
    /// Ranges of the normals of each block.
    normals: Boxes,
    areas: Vec<f64>,
}

impl AssignmentTarget {
    /// `target`, whose points have as many features as the kernels of the assignments.
    pub fn new(target: &OrientedPoints<'_>) -> Self {
        let n = target.points.len();
        let n_features = target.features.len() / n.max(1);
        let origin = target.points.first().map_or(Vector3::zeros(), |p| p.coords);
        let packed = PackedPoints::new(n, n_features, origin, |j| target.point(j, n_features));
        let corner = |lanes: fn(&Block) -> &[Lanes; 3], fold: fn(f32, f32) -> f32, start: f32| {
            let of_block = |block: &Block, axis: usize| block.actual(&lanes(block)[axis]).fold(start, fold);
            std::array::from_fn(|axis| packed.blocks.iter().map(|block| of_block(block, axis)).collect())
        };
        let range = |lanes| Boxes {
            low: corner(lanes, f32::min, f32::INFINITY),
            high: corner(lanes, f32::max, f32::NEG_INFINITY),
        };
        let boxes = range(|block| &block.position);
        let normals = range(|block| &block.normal);
        AssignmentTarget { packed, boxes, normals, areas: target.areas.to_vec() }
    }
}

/// Assigns `target` to `source`, which has been moved close to it. Affinities are 32-bit numbers with relative errors
/// of about 1e-6. Sums follow the order of the points, so any number of threads gives the same bits.
///
/// # Cost
/// `O(pairs within reach)` in time and memory if target points that are close in space have close indices, as in
/// canonical numbering; at most `O(pairs)` in time.
pub fn assign(source: &OrientedPoints<'_>, target: &AssignmentTarget, kernel: &AssignmentKernel) -> Assignment {
    let affinities = Affinities::new(target, kernel);
    let rows = affinities.all_rows(source);
    let background = kernel.outlier_share * flat_density(kernel.sigma_mm);
    let densities = affinities.target_densities(&rows, source.areas, background);
    let shares = affinities.area_over_density(&densities);
    let means: Vec<Means> = rows.par_iter().map(|rows| affinities.means(source, rows, &shares)).collect();
    let mass: Vec<f64> = means.iter().flat_map(|means| &means.mass).copied().collect();
    let offsets = means.iter().flat_map(|means| &means.offsets);
    let n_features = target.packed.n_features;
    let mut feature_variance = vec![0.0; n_features];
    let mut total = 0.0;
    let variances = means.iter().flat_map(|means| means.feature_variance.chunks_exact(n_features.max(1)));
    for (variances, area) in variances.zip(source.areas) {
        for (sum, variance) in feature_variance.iter_mut().zip(variances) {
            *sum += variance * area;
        }
    }
    for (mass, area) in mass.iter().zip(source.areas) {
        total += mass * area;
    }
    for variance in &mut feature_variance {
        *variance /= total.max(f64::MIN_POSITIVE);
    }
    Assignment {
        targets: source.points.iter().zip(offsets).map(|(p, offset)| p + offset).collect(),
        mass,
        feature_variance,
        misfit: misfit_of(source, target, kernel, (&rows, &densities)),
    }
}

/// Misfit of `source`, which has been moved close to `target`: the mean over both surfaces of `−ln` of the density
/// relative to a flat match; lower is better. Any number of threads gives the same bits; costs as much as [`assign`].
pub fn misfit(source: &OrientedPoints<'_>, target: &AssignmentTarget, kernel: &AssignmentKernel) -> f64 {
    let affinities = Affinities::new(target, kernel);
    let rows = affinities.all_rows(source);
    let background = kernel.outlier_share * flat_density(kernel.sigma_mm);
    let densities = affinities.target_densities(&rows, source.areas, background);
    misfit_of(source, target, kernel, (&rows, &densities))
}

/// The terms of [`misfit`]: `−ln` of the density relative to a flat match at each point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointMisfits {
    /// Terms at the points of the source.
    pub of_source: Vec<f64>,
    /// Terms at the points of the target.
    pub of_target: Vec<f64>,
}

/// The terms whose means over the areas of both surfaces are [`misfit`]. Costs as much as [`assign`].
pub fn point_misfits(
    source: &OrientedPoints<'_>,
    target: &AssignmentTarget,
    kernel: &AssignmentKernel,
) -> PointMisfits {
    let affinities = Affinities::new(target, kernel);
    let rows = affinities.all_rows(source);
    let flat = flat_density(kernel.sigma_mm);
    let background = kernel.outlier_share * flat;
    let densities = affinities.target_densities(&rows, source.areas, background);
    let of_source = rows.iter().flat_map(|rows| &rows.densities).map(|density| (background + density) / flat);
    let of_target = densities.as_flattened()[..target.areas.len()].iter().map(|&s| f64::from(s) / flat);
    PointMisfits { of_source: of_source.map(|d| -d.ln()).collect(), of_target: of_target.map(|d| -d.ln()).collect() }
}

/// The terms from the affinities of the source points and the densities of the target points.
fn misfit_of(
    source: &OrientedPoints<'_>,
    target: &AssignmentTarget,
    kernel: &AssignmentKernel,
    (rows, target_densities): (&[Rows], &[Lanes]),
) -> f64 {
    let flat = flat_density(kernel.sigma_mm);
    let background = kernel.outlier_share * flat;
    let of_source = rows.iter().flat_map(|rows| &rows.densities).map(|density| (background + density) / flat);
    let of_target = target_densities.as_flattened()[..target.areas.len()].iter().map(|&s| f64::from(s) / flat);
    0.5 * (mean_misfit(of_source, source.areas.iter().copied()) + mean_misfit(of_target, target.areas.iter().copied()))
}

/// Corners of the bounding boxes of the blocks, or of their normals, coordinate by coordinate.
struct Boxes {
    low: [Vec<f32>; 3],
    high: [Vec<f32>; 3],
}

/// The target in blocks, and the kernel.
struct Affinities<'t> {
    target: &'t PackedPoints,
    boxes: &'t Boxes,
    normals: &'t Boxes,
    /// `1/2σ²`.
    inverse_width: f32,
    /// Squared reach, mm².
    reach_squared: f32,
    /// `ν`.
    normal_weight: f32,
    /// `π_f/2` of each feature.
    half_precision: Vec<f32>,
}

/// Source points per chunk of affinities: few allocations, and enough chunks for many threads.
const ROWS: usize = 32;

/// The affinities of some consecutive source points.
struct Rows {
    /// The source points.
    points: Range<usize>,
    /// End of the blocks of each source point.
    ends: Vec<usize>,
    /// Blocks within reach, point by point.
    blocks: Vec<u32>,
    affinity: Vec<Lanes>,
    /// `Σ_j a_j g_ij` of each point.
    densities: Vec<f64>,
}

/// The affinities of one source point.
struct Row<'a> {
    /// Blocks within reach.
    blocks: &'a [u32],
    affinity: &'a [Lanes],
}

impl Rows {
    /// The rows, point by point.
    fn iter(&self) -> impl Iterator<Item = Row<'_>> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let within = std::mem::replace(&mut start, end)..end;
            Row { blocks: &self.blocks[within.clone()], affinity: &self.affinity[within] }
        })
    }
}

/// Assignments of consecutive source points.
struct Means {
    mass: Vec<f64>,
    /// From each source point to the mean of its target points, mm.
    offsets: Vec<Vector3<f64>>,
    /// Variance of each feature times the mass, point by point.
    feature_variance: Vec<f64>,
}

impl<'t> Affinities<'t> {
    fn new(target: &'t AssignmentTarget, kernel: &AssignmentKernel) -> Self {
        let reach_mm = REACH * kernel.sigma_mm;
        Affinities {
            target: &target.packed,
            boxes: &target.boxes,
            normals: &target.normals,
            inverse_width: (0.5 / (kernel.sigma_mm * kernel.sigma_mm)) as f32,
            reach_squared: (reach_mm * reach_mm) as f32,
            normal_weight: kernel.normal_weight as f32,
            half_precision: kernel.feature_precision.iter().map(|p| (0.5 * p) as f32).collect(),
        }
    }

    fn lane_point<'f>(&self, source: &OrientedPoints<'_>, i: usize, features: &'f mut Vec<f32>) -> LanePoint<'f> {
        LanePoint::new(&source.point(i, self.target.n_features), self.target, features)
    }

    /// The affinities of all source points, in chunks.
    fn all_rows(&self, source: &OrientedPoints<'_>) -> Vec<Rows> {
        let n = source.points.len();
        let chunks: Vec<Range<usize>> = (0..n).step_by(ROWS).map(|first| first..n.min(first + ROWS)).collect();
        chunks.par_iter().map(|chunk| self.rows(source, chunk.clone())).collect()
    }

    /// The affinities of some source points with all points within reach whose normals do not oppose.
    fn rows(&self, source: &OrientedPoints<'_>, points: Range<usize>) -> Rows {
        let n_blocks = self.target.blocks.len();
        let (mut features, mut squared, mut agreement) = (Vec::new(), vec![0.0; n_blocks], vec![0.0; n_blocks]);
        let mut rows = Rows {
            points: points.clone(),
            ends: Vec::with_capacity(points.len()),
            blocks: Vec::new(),
            affinity: Vec::new(),
            densities: Vec::with_capacity(points.len()),
        };
        let mut within = vec![0; n_blocks];
        for i in points {
            let point = self.lane_point(source, i, &mut features);
            distances_from_boxes(self.boxes, &point.position, &mut squared);
            greatest_agreements(self.normals, &point.normal, &mut agreement);
            // Whether a block is within reach is hard to predict, so it is always written, and counted only if it is.
            let mut n_within = 0;
            for (b, (&squared, &agreement)) in squared.iter().zip(&agreement).enumerate() {
                within[n_within] = b as u32;
                n_within += usize::from((squared <= self.reach_squared) & (agreement > 0.0));
            }
            let start = rows.blocks.len();
            let end = start + n_within;
            if rows.affinity.capacity() < end {
                // The neighbors of the first point in a chunk estimate the number for the others.
                rows.affinity.reserve(n_within * (rows.ends.capacity() - rows.ends.len()));
            }
            rows.blocks.extend_from_slice(&within[..n_within]);
            rows.affinity.resize(end, [0.0; LANES]);
            let density = block_affinities(self, &point, &rows.blocks[start..], &mut rows.affinity[start..]);
            rows.ends.push(end);
            rows.densities.push(density);
        }
        rows
    }

    /// `b + Σ_i a_i g_ij` of every target point.
    fn target_densities(&self, rows: &[Rows], areas: &[f64], background: f64) -> Vec<Lanes> {
        let mut densities = vec![[background as f32; LANES]; self.target.blocks.len()];
        for (row, &area) in rows.iter().flat_map(Rows::iter).zip(areas) {
            add_scaled(row.blocks, row.affinity, area as f32, &mut densities);
        }
        densities
    }

    /// The area of every target point over its density.
    fn area_over_density(&self, densities: &[Lanes]) -> Vec<Lanes> {
        let share = |(block, density): (&Block, &Lanes)| std::array::from_fn(|k| block.area[k] / density[k]);
        self.target.blocks.iter().zip(densities).map(share).collect()
    }

    /// Mass and means of the source points of `rows`.
    fn means(&self, source: &OrientedPoints<'_>, rows: &Rows, shares: &[Lanes]) -> Means {
        let (mut features, mut weights) = (Vec::new(), Vec::new());
        let n_features = self.target.n_features;
        let mut sums = vec![[0.0; LANES]; 4 + n_features];
        let total = |lanes: &Lanes| f64::from(lanes.iter().sum::<f32>());
        let n = rows.ends.len();
        let mut means = Means {
            mass: Vec::with_capacity(n),
            offsets: Vec::with_capacity(n),
            feature_variance: Vec::with_capacity(n * n_features),
        };
        for (i, row) in rows.points.clone().zip(rows.iter()) {
            let point = self.lane_point(source, i, &mut features);
            // Every entry is overwritten.
            weights.resize(row.blocks.len(), [0.0; LANES]);
            weighted_sums(self, &point, &row, shares, &mut weights, &mut sums);
            let mass = total(&sums[0]);
            let offset = Vector3::new(total(&sums[1]), total(&sums[2]), total(&sums[3]));
            means.mass.push(mass);
            means.offsets.push(if mass > 0.0 { offset / mass } else { Vector3::zeros() });
            means.feature_variance.extend(sums[4..].iter().map(total));
        }
        means
    }
}

/// Squared distance of `at` from every bounding box.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn distances_from_boxes(boxes: &Boxes, at: &[f32; 3], squared: &mut [f32]) {
    squared.fill(0.0);
    for (k, &at) in at.iter().enumerate() {
        for ((sum, low), high) in squared.iter_mut().zip(&boxes.low[k]).zip(&boxes.high[k]) {
            let (below, above) = (low - at, at - high);
            let outside = if below > above { below } else { above };
            let outside = if outside > 0.0 { outside } else { 0.0 };
            *sum += outside * outside;
        }
    }
}

/// An upper bound of `⟨n, n'⟩` of `normal` with the normals of every block. Products and sums are rounded in the order
/// of [`normal_agreements`], and rounding is monotonic, so no agreement is greater.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn greatest_agreements(normals: &Boxes, normal: &[f32; 3], agreement: &mut [f32]) {
    agreement.fill(0.0);
    for (k, &n) in normal.iter().enumerate() {
        for ((sum, low), high) in agreement.iter_mut().zip(&normals.low[k]).zip(&normals.high[k]) {
            let (a, b) = (low * n, high * n);
            *sum += if a > b { a } else { b };
        }
    }
}

/// Writes the affinities of `point` with the points of `blocks`; returns their sum, each times its area.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn block_affinities(all: &Affinities<'_>, point: &LanePoint<'_>, blocks: &[u32], affinity: &mut [Lanes]) -> f64 {
    let mut density = [0.0f32; LANES];
    for (&b, affinity) in blocks.iter().zip(affinity) {
        let block = &all.target.blocks[b as usize];
        let mut unlike = [0.0f32; LANES];
        let features = all.target.features(b as usize);
        for ((others, own), precision) in features.iter().zip(point.features).zip(&all.half_precision) {
            for k in 0..LANES {
                let difference = others[k] - own;
                unlike[k] += precision * difference * difference;
            }
        }
        let squared = squared_distances(block, &point.position);
        let agreement = normal_agreements(block, &point.normal);
        for k in 0..LANES {
            let energy = all.inverse_width * squared[k] + all.normal_weight * (1.0 - agreement[k]) + unlike[k];
            // Rounding can make the energy of coincident points negative.
            let weight = exp_negative(if energy > 0.0 { -energy } else { 0.0 });
            let counts = (squared[k] <= all.reach_squared) & (agreement[k] > 0.0);
            affinity[k] = if counts { weight } else { 0.0 };
            density[k] += block.area[k] * affinity[k];
        }
    }
    f64::from(density.iter().sum::<f32>())
}

/// Adds the affinities, times `area`, to the sums of their points.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn add_scaled(blocks: &[u32], affinity: &[Lanes], area: f32, sums: &mut [Lanes]) {
    for (&b, affinity) in blocks.iter().zip(affinity) {
        let sum = &mut sums[b as usize];
        for k in 0..LANES {
            sum[k] += area * affinity[k];
        }
    }
}

/// Sums over the points of `row`, each weighted by its affinity times its share. The summands are 1, the offset from
/// `point` along each axis, and the squared difference of each feature. `weights` is scratch memory, one entry per
/// block of the row.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn weighted_sums(
    all: &Affinities<'_>,
    point: &LanePoint<'_>,
    row: &Row<'_>,
    shares: &[Lanes],
    weights: &mut [Lanes],
    sums: &mut [Lanes],
) {
    let mut mass = [0.0f32; LANES];
    for ((&b, affinity), weight) in row.blocks.iter().zip(row.affinity).zip(weights.iter_mut()) {
        let share = &shares[b as usize];
        for k in 0..LANES {
            weight[k] = affinity[k] * share[k];
            mass[k] += weight[k];
        }
    }
    sums[0] = mass;
    // One quantity after the other keeps each sum in registers; all axes together would be shuffled through memory.
    for (a, &own) in point.position.iter().enumerate() {
        let mut sum = [0.0f32; LANES];
        for (&b, weight) in row.blocks.iter().zip(weights.iter()) {
            let others = &all.target.blocks[b as usize].position[a];
            for k in 0..LANES {
                sum[k] += weight[k] * (others[k] - own);
            }
        }
        sums[1 + a] = sum;
    }
    for (f, &own) in point.features.iter().enumerate() {
        let mut sum = [0.0f32; LANES];
        for (&b, weight) in row.blocks.iter().zip(weights.iter()) {
            let others = &all.target.features[b as usize * all.target.n_features + f];
            for k in 0..LANES {
                let difference = others[k] - own;
                sum[k] += weight[k] * difference * difference;
            }
        }
        sums[4 + f] = sum;
    }
}
