//! Oriented points, and their layout for vector loops.

use nalgebra::{Point3, Vector3};

/// Points of a surface with their attributes, as slices of equal length.
#[derive(Debug, Clone, Copy)]
pub struct OrientedPoints<'a> {
    /// Positions, mm.
    pub points: &'a [Point3<f64>],
    /// Unit normals, all outwards or all inwards.
    pub normals: &'a [Vector3<f64>],
    /// Area that each point represents, mm².
    pub areas: &'a [f64],
    /// Features, `n × n_features`, one row per point. May be empty for [`crate::pose_search()`], which then computes
    /// its own features.
    pub features: &'a [f64],
}

impl<'a> OrientedPoints<'a> {
    pub(super) fn point(&self, i: usize, n_features: usize) -> OrientedPoint<'a> {
        OrientedPoint {
            position: self.points[i].coords,
            normal: self.normals[i],
            area: self.areas[i],
            features: &self.features[i * n_features..][..n_features],
        }
    }
}

/// One point of a surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OrientedPoint<'a> {
    pub position: Vector3<f64>,
    pub normal: Vector3<f64>,
    pub area: f64,
    pub features: &'a [f64],
}

/// Points per block; they are computed side by side.
pub(super) const LANES: usize = 16;
/// Position of empty lanes, mm: out of reach of every point, and its square is finite in 32 bits.
const NOWHERE: f32 = 1e15;

/// One number for each point of a block.
pub(super) type Lanes = [f32; LANES];

/// [`LANES`] points side by side.
#[derive(Clone)]
pub(super) struct Block {
    pub position: [Lanes; 3],
    pub normal: [Lanes; 3],
    pub area: Lanes,
}

impl Block {
    /// Those of `values` that belong to actual points.
    pub(super) fn actual(&self, values: &Lanes) -> impl Iterator<Item = f32> {
        let n = self.position[0].iter().filter(|&&x| x < NOWHERE).count();
        values.iter().take(n).copied()
    }
}

/// Points in blocks. The last block is padded with points at [`NOWHERE`] without area.
pub(crate) struct PackedPoints {
    pub(super) blocks: Vec<Block>,
    /// Features, block by block.
    pub(super) features: Vec<Lanes>,
    pub(super) n_features: usize,
    /// Origin of the positions, chosen so that 32 bits resolve differences of coordinates far from 0.
    origin: Vector3<f64>,
}

impl PackedPoints {
    pub(super) fn new<'p>(
        n: usize,
        n_features: usize,
        origin: Vector3<f64>,
        point: impl Fn(usize) -> OrientedPoint<'p>,
    ) -> Self {
        let n_blocks = n.div_ceil(LANES);
        let empty = Block { position: [[NOWHERE; LANES]; 3], normal: [[0.0; LANES]; 3], area: [0.0; LANES] };
        let (mut blocks, mut features) = (vec![empty; n_blocks], vec![[0.0; LANES]; n_blocks * n_features]);
        for j in 0..n {
            let (b, k) = (j / LANES, j % LANES);
            let p = point(j);
            for axis in 0..3 {
                blocks[b].position[axis][k] = (p.position[axis] - origin[axis]) as f32;
                blocks[b].normal[axis][k] = p.normal[axis] as f32;
            }
            blocks[b].area[k] = p.area as f32;
            for (lanes, &value) in features[b * n_features..].iter_mut().zip(p.features) {
                lanes[k] = value as f32;
            }
        }
        PackedPoints { blocks, features, n_features, origin }
    }

    /// The features of the points of block `b`.
    #[inline(always)]
    pub(super) fn features(&self, b: usize) -> &[Lanes] {
        &self.features[b * self.n_features..][..self.n_features]
    }
}

/// One point of the other surface, in the number format of the blocks it is compared with.
pub(super) struct LanePoint<'a> {
    pub position: [f32; 3],
    pub normal: [f32; 3],
    pub area: f32,
    pub features: &'a [f32],
}

impl<'a> LanePoint<'a> {
    /// `features` is scratch memory for the features.
    pub(super) fn new(point: &OrientedPoint<'_>, target: &PackedPoints, features: &'a mut Vec<f32>) -> Self {
        let position = point.position - target.origin;
        features.clear();
        features.extend(point.features.iter().map(|&v| v as f32));
        LanePoint {
            position: std::array::from_fn(|k| position[k] as f32),
            normal: std::array::from_fn(|k| point.normal[k] as f32),
            area: point.area as f32,
            features,
        }
    }
}

/// Squared distance of each point of `block` from `at`.
// Each quantity has its own loop: in one loop the compiler would pair the components of a point instead of the points.
#[inline(always)]
pub(super) fn squared_distances(block: &Block, at: &[f32; 3]) -> Lanes {
    let [x, y, z] = &block.position;
    let mut squared = [0.0; LANES];
    for k in 0..LANES {
        let (dx, dy, dz) = (x[k] - at[0], y[k] - at[1], z[k] - at[2]);
        squared[k] = dx * dx + dy * dy + dz * dz;
    }
    squared
}

/// `⟨n, n'⟩` of each point of `block` with `normal`.
#[inline(always)]
pub(super) fn normal_agreements(block: &Block, normal: &[f32; 3]) -> Lanes {
    let [x, y, z] = &block.normal;
    let mut agreement = [0.0; LANES];
    for k in 0..LANES {
        agreement[k] = x[k] * normal[0] + y[k] * normal[1] + z[k] * normal[2];
    }
    agreement
}
