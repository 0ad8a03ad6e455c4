//! The affinities `g_ij` of [`super::assign`] and the sums over them, in 32 bits, [`LANES`] target points side by side.
//!
//! Target points that follow each other make a block with a box around it; a source point looks only at blocks whose
//! box is within its reach. Every operation is the same on every instruction set (no fused multiply-add, fixed order),
//! so the dispatched versions give equal bits.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::assignment::{Likeness, Samples};
use homolog_primitives::exponential::exp_negative;
use multiversion::multiversion;
use nalgebra::Vector3;

/// Points of a block.
const LANES: usize = 16;
/// Where lanes without a point lie, mm: out of everybody's reach.
const NOWHERE: f32 = 1e15;

/// One number for each point of a block.
pub(super) type Lanes = [f32; LANES];

/// Target points side by side.
#[derive(Clone)]
struct Block {
    position: [Lanes; 3],
    normal: [Lanes; 3],
    area: Lanes,
}

/// Corners of the boxes around the blocks, coordinate by coordinate.
struct Boxes {
    low: [Vec<f32>; 3],
    high: [Vec<f32>; 3],
}

/// `1/2σ²`, the squared reach and `ν`.
#[derive(Clone, Copy)]
struct Scales {
    distance: f32,
    reach: f32,
    normal: f32,
}

/// A source point as blocks have theirs.
struct Query {
    position: [f32; 3],
    normal: [f32; 3],
    features: Vec<f32>,
}

/// Target points in blocks, and how alike they must be.
pub(super) struct Affinities {
    blocks: Vec<Block>,
    /// Block by block, feature by feature.
    features: Vec<Lanes>,
    boxes: Boxes,
    /// Positions count from here, so that 32 bits carry the differences of far-off coordinates.
    origin: Vector3<f64>,
    scales: Scales,
    /// `π_f/2` of each feature.
    precision: Vec<f32>,
}

/// The affinities of one source point.
pub(super) struct Row {
    /// Blocks within reach.
    blocks: Vec<u32>,
    affinity: Vec<Lanes>,
    /// The sum of all, each times its area.
    pub seen: f64,
}

/// What a source point is assigned.
pub(super) struct Means {
    pub mass: f64,
    /// From where it is to the mean of its target points, mm.
    pub offset: Vector3<f64>,
    /// Of each feature, times the mass.
    pub feature_variance: Vec<f64>,
}

impl Affinities {
    pub fn new(target: &Samples<'_>, likeness: &Likeness, radius_mm: f64) -> Self {
        let n = target.points.len();
        let n_features = likeness.feature_precision.len();
        let origin = target.points.first().map_or(Vector3::zeros(), |p| p.coords);
        let n_blocks = n.div_ceil(LANES);
        let lanes = |block: usize, empty: f32, value: &dyn Fn(usize) -> f64| -> Lanes {
            std::array::from_fn(|k| match block * LANES + k {
                j if j < n => value(j) as f32,
                _ => empty,
            })
        };
        let blocks: Vec<Block> = (0..n_blocks)
            .map(|b| Block {
                position: std::array::from_fn(|k| lanes(b, NOWHERE, &|j| target.points[j][k] - origin[k])),
                normal: std::array::from_fn(|k| lanes(b, 0.0, &|j| target.normals[j][k])),
                area: lanes(b, 0.0, &|j| target.areas[j]),
            })
            .collect();
        let features = (0..n_blocks * n_features)
            .map(|at| lanes(at / n_features, 0.0, &|j| target.features[j * n_features + at % n_features]))
            .collect();
        let real = |b: &Block, k: usize| b.position[k].into_iter().filter(|&x| x < NOWHERE);
        let corner = |fold: fn(f32, f32) -> f32, start: f32| {
            std::array::from_fn(|k| blocks.iter().map(|b| real(b, k).fold(start, fold)).collect())
        };
        Affinities {
            boxes: Boxes { low: corner(f32::min, f32::INFINITY), high: corner(f32::max, f32::NEG_INFINITY) },
            blocks,
            features,
            origin,
            scales: Scales {
                distance: (0.5 / (likeness.sigma_mm * likeness.sigma_mm)) as f32,
                reach: (radius_mm * radius_mm) as f32,
                normal: likeness.normal_weight as f32,
            },
            precision: likeness.feature_precision.iter().map(|p| (0.5 * p) as f32).collect(),
        }
    }

    fn query(&self, source: &Samples<'_>, i: usize) -> Query {
        let n_features = self.precision.len();
        let position = source.points[i].coords - self.origin;
        Query {
            position: std::array::from_fn(|k| position[k] as f32),
            normal: std::array::from_fn(|k| source.normals[i][k] as f32),
            features: source.features[i * n_features..][..n_features].iter().map(|&v| v as f32).collect(),
        }
    }

    /// The affinities of source point `i` with all points within reach.
    pub fn row(&self, source: &Samples<'_>, i: usize) -> Row {
        let query = self.query(source, i);
        let mut squared = vec![0.0; self.blocks.len()];
        distances_from_boxes(&self.boxes, query.position, &mut squared);
        let within = squared.iter().enumerate().filter(|(_, d)| **d <= self.scales.reach);
        let blocks: Vec<u32> = within.map(|(b, _)| b as u32).collect();
        let mut affinity = vec![[0.0; LANES]; blocks.len()];
        let seen = block_affinities(self, &query, &blocks, &mut affinity);
        Row { blocks, affinity, seen }
    }

    /// What `rows`, each times its area, and the `background` explain of each target point.
    pub fn explained(&self, rows: &[Row], areas: &[f64], background: f64) -> Vec<Lanes> {
        let mut explained = vec![[background as f32; LANES]; self.blocks.len()];
        for (row, &area) in rows.iter().zip(areas) {
            add_scaled(&row.blocks, &row.affinity, area as f32, &mut explained);
        }
        explained
    }

    /// For every target point its area over what is `explained` of it.
    pub fn shares(&self, explained: &[Lanes]) -> Vec<Lanes> {
        let share = |(block, sums): (&Block, &Lanes)| std::array::from_fn(|k| block.area[k] / sums[k]);
        self.blocks.iter().zip(explained).map(share).collect()
    }

    /// The mass and the means of source point `i`.
    pub fn means(&self, source: &Samples<'_>, i: usize, row: &Row, shares: &[Lanes]) -> Means {
        let query = self.query(source, i);
        let mut sums = vec![[0.0; LANES]; 4 + self.precision.len()];
        weighted_sums(self, &query, row, shares, &mut vec![[0.0; LANES]; row.blocks.len()], &mut sums);
        let total = |lanes: &Lanes| f64::from(lanes.iter().sum::<f32>());
        let mass = total(&sums[0]);
        let offset = Vector3::new(total(&sums[1]), total(&sums[2]), total(&sums[3]));
        Means {
            mass,
            offset: if mass > 0.0 { offset / mass } else { Vector3::zeros() },
            feature_variance: sums[4..].iter().map(total).collect(),
        }
    }
}

/// Squared distance of `query` from every box.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn distances_from_boxes(boxes: &Boxes, query: [f32; 3], squared: &mut [f32]) {
    squared.fill(0.0);
    for (k, &at) in query.iter().enumerate() {
        for ((sum, low), high) in squared.iter_mut().zip(&boxes.low[k]).zip(&boxes.high[k]) {
            let (below, above) = (low - at, at - high);
            let outside = if below > above { below } else { above };
            let outside = if outside > 0.0 { outside } else { 0.0 };
            *sum += outside * outside;
        }
    }
}

/// The affinities of `query` with the points of `blocks`; returns their sum, each times its area.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn block_affinities(all: &Affinities, query: &Query, blocks: &[u32], affinity: &mut [Lanes]) -> f64 {
    let n_features = all.precision.len();
    let Scales { distance, reach, normal } = all.scales;
    let mut seen = [0.0f32; LANES];
    for (&b, found) in blocks.iter().zip(affinity) {
        let block = &all.blocks[b as usize];
        let mut unlike = [0.0f32; LANES];
        let features = &all.features[b as usize * n_features..][..n_features];
        for ((others, own), precision) in features.iter().zip(&query.features).zip(&all.precision) {
            for k in 0..LANES {
                let difference = others[k] - own;
                unlike[k] += precision * difference * difference;
            }
        }
        for k in 0..LANES {
            let [dx, dy, dz]: [f32; 3] = std::array::from_fn(|a| block.position[a][k] - query.position[a]);
            let squared = dx * dx + dy * dy + dz * dz;
            let [nx, ny, nz]: [f32; 3] = std::array::from_fn(|a| block.normal[a][k] * query.normal[a]);
            let agreement = nx + ny + nz;
            let energy = distance * squared + normal * (1.0 - agreement) + unlike[k];
            // Rounding may take the energy of a point that is met exactly below 0.
            let weight = exp_negative(if energy > 0.0 { -energy } else { 0.0 });
            let counts = (squared <= reach) & (agreement > 0.0);
            found[k] = if counts { weight } else { 0.0 };
            seen[k] += block.area[k] * found[k];
        }
    }
    f64::from(seen.iter().sum::<f32>())
}

/// Adds the affinities, times `area`, to the sums of their points.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn add_scaled(blocks: &[u32], affinity: &[Lanes], area: f32, sums: &mut [Lanes]) {
    for (&b, found) in blocks.iter().zip(affinity) {
        let sum = &mut sums[b as usize];
        for k in 0..LANES {
            sum[k] += area * found[k];
        }
    }
}

/// Sums over the points of `row`, each weighing its affinity times its share: of 1, of the offset from `query` along each
/// axis, and of the squared difference of each feature. `weights` is room for the blocks of the row.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn weighted_sums(
    all: &Affinities,
    query: &Query,
    row: &Row,
    shares: &[Lanes],
    weights: &mut [Lanes],
    sums: &mut [Lanes],
) {
    let n_features = all.precision.len();
    let mut moments = [[0.0f32; LANES]; 4];
    for ((&b, affinity), weight) in row.blocks.iter().zip(&row.affinity).zip(weights.iter_mut()) {
        let (block, share) = (&all.blocks[b as usize], &shares[b as usize]);
        for k in 0..LANES {
            weight[k] = affinity[k] * share[k];
            moments[0][k] += weight[k];
        }
        for a in 0..3 {
            for k in 0..LANES {
                moments[a + 1][k] += weight[k] * (block.position[a][k] - query.position[a]);
            }
        }
    }
    sums[..4].copy_from_slice(&moments);
    // One feature after the other, so that its sum stays in registers.
    for (f, &own) in query.features.iter().enumerate() {
        let mut sum = [0.0f32; LANES];
        for (&b, weight) in row.blocks.iter().zip(weights.iter()) {
            let others = &all.features[b as usize * n_features + f];
            for k in 0..LANES {
                let difference = others[k] - own;
                sum[k] += weight[k] * difference * difference;
            }
        }
        sums[4 + f] = sum;
    }
}
