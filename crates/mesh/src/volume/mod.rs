//! Label volumes and their surfaces.
//!
//! A [`LabelVolume`] holds one label per voxel and the affine from voxel indices to world millimeters. The selected
//! labels form a [`VoxelMask`] ([`LabelVolume::mask`]). [`repair`] can give a mask the topology of a ball, and
//! [`voxel_surface()`] or [`smooth_surface()`] extract a closed surface from it.

mod adjacency;
pub mod constrained_surface;
mod cubes;
mod distance;
pub mod repair;
mod sampling;
pub mod smooth_surface;
mod values;
pub mod voxel_surface;

pub use adjacency::{BettiNumbers, is_well_composed, n_enclosed};
pub use constrained_surface::constrained_surface;
pub use repair::{Contacts, FillChange, FillOutcome, JoinOutcome, fill, join_touching, largest_component};
pub use sampling::Sampling;
pub use smooth_surface::{SmoothSurface, smooth_surface};
pub use values::ValueStatistics;
pub use voxel_surface::voxel_surface;

use nalgebra::{Matrix4, Point3, Vector3, Vector4};
use std::collections::BTreeMap;

/// Voxels with one label each, and their positions in world millimeters.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelVolume {
    dims: [usize; 3],
    labels: Vec<u32>,
    affine: Matrix4<f64>,
    /// The set of labels for which a value stands, where structures overlap.
    overlaps: BTreeMap<u32, Vec<u32>>,
}

/// Why labels and an affine do not form a volume.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum VolumeError {
    /// The number of labels is not the product of the dimensions, or that is zero.
    #[error(
        "{n_labels} labels do not fill a volume of {} x {} x {} voxels (at most 32767 along each axis)",
        dims[0], dims[1], dims[2]
    )]
    WrongSize {
        /// Dimensions.
        dims: [usize; 3],
        /// Labels given.
        n_labels: usize,
    },
    /// The affine is not a valid map from voxels to world coordinates.
    #[error("the voxel-to-world affine is {fault}; store a valid one in the file")]
    Affine {
        /// `not finite`, `singular`, or the implausible size.
        fault: &'static str,
    },
}

impl LabelVolume {
    /// A volume of `dims` voxels, `labels` with the first index fastest, and `affine` from voxel index (whole numbers
    /// at voxel centers) to world mm.
    ///
    /// # Errors
    /// [`VolumeError`].
    pub fn new(dims: [usize; 3], labels: Vec<u32>, affine: Matrix4<f64>) -> Result<Self, VolumeError> {
        let n = dims.iter().try_fold(1usize, |n, &d| n.checked_mul(d));
        // No supported file format can store longer axes.
        let fits = dims.iter().all(|&d| d <= i16::MAX as usize);
        if n != Some(labels.len()) || labels.is_empty() || !fits {
            return Err(VolumeError::WrongSize { dims, n_labels: labels.len() });
        }
        check_affine(&affine)?;
        Ok(LabelVolume { dims, labels, affine, overlaps: BTreeMap::new() })
    }

    /// Adds values that stand for several labels each, in voxels where structures overlap.
    pub fn with_overlaps(self, overlaps: BTreeMap<u32, Vec<u32>>) -> Self {
        LabelVolume { overlaps, ..self }
    }

    /// Voxels along each axis.
    pub fn dims(&self) -> [usize; 3] {
        self.dims
    }

    /// The labels, first index fastest. Where structures overlap, a value stands for their set.
    pub fn labels(&self) -> &[u32] {
        &self.labels
    }

    /// Voxel index to world mm.
    pub fn affine(&self) -> &Matrix4<f64> {
        &self.affine
    }

    /// Distance of neighboring voxel centers along each axis, mm.
    pub fn spacing_mm(&self) -> [f64; 3] {
        spacing_mm(&self.affine)
    }

    /// Every label except 0 that occurs, ascending, with its number of voxels; a voxel with several labels counts for
    /// each of them. Cost `O(voxels)`.
    pub fn label_counts(&self) -> BTreeMap<u32, u64> {
        let mut counts = BTreeMap::new();
        // Labels occur in runs, so the map is accessed once per run.
        for run in self.labels.chunk_by(|a, b| a == b).filter(|run| run[0] != 0) {
            let labels = self.overlaps.get(&run[0]).map_or(&run[..1], Vec::as_slice);
            for &label in labels {
                *counts.entry(label).or_default() += run.len() as u64;
            }
        }
        counts
    }

    /// The voxels whose label is in `labels` (`None`: every label but 0), cropped to their bounding box with a border
    /// of one empty voxel. `None` if there are none. Cost `O(voxels)`.
    pub fn mask(&self, labels: Option<&[u32]>) -> Option<VoxelMask> {
        let wanted = |label: u32| match labels {
            None => label != 0,
            Some(list) => match self.overlaps.get(&label) {
                Some(set) => set.iter().any(|label| list.contains(label)),
                None => list.contains(&label),
            },
        };
        let [nx, ny, _] = self.dims;
        let mut low = [usize::MAX; 3];
        let mut high = [0; 3];
        let mut previous = (0, wanted(0));
        let mut chosen = |label: u32| {
            if previous.0 != label {
                previous = (label, wanted(label));
            }
            previous.1
        };
        for (row, line) in self.labels.chunks_exact(nx).enumerate() {
            let (y, z) = (row % ny, row / ny);
            let Some(first) = line.iter().position(|&l| chosen(l)) else { continue };
            let last = line.iter().rposition(|&l| chosen(l)).unwrap_or(first);
            low = [low[0].min(first), low[1].min(y), low[2].min(z)];
            high = [high[0].max(last), high[1].max(y), high[2].max(z)];
        }
        if low[0] == usize::MAX {
            return None;
        }
        let dims = [0, 1, 2].map(|k| high[k] - low[k] + 3);
        let mut mask = VoxelMask::empty(dims, self.affine);
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                let row = &self.labels[(z * ny + y) * nx..][low[0]..=high[0]];
                let start = mask.index([1, y - low[1] + 1, z - low[2] + 1]);
                for (voxel, &label) in mask.voxels[start..].iter_mut().zip(row) {
                    *voxel = chosen(label);
                }
            }
        }
        let corner = Vector4::new(low[0] as f64 - 1.0, low[1] as f64 - 1.0, low[2] as f64 - 1.0, 1.0);
        mask.affine.set_column(3, &(self.affine * corner));
        Some(mask)
    }
}

/// Length of the columns of `affine`, mm.
fn spacing_mm(affine: &Matrix4<f64>) -> [f64; 3] {
    [0, 1, 2].map(|k| affine.fixed_view::<3, 1>(0, k).norm())
}

/// Plausible voxel sizes of anatomical images, mm. Other sizes indicate a damaged header or a wrong unit, and a filter
/// in millimeters would span too many voxels.
const SPACING_MM: std::ops::RangeInclusive<f64> = 1e-4..=1e5;

fn check_affine(affine: &Matrix4<f64>) -> Result<(), VolumeError> {
    if !affine.iter().all(|x| x.is_finite()) {
        return Err(VolumeError::Affine { fault: "not finite" });
    }
    let columns: [Vector3<f64>; 3] = [0, 1, 2].map(|k| affine.fixed_view::<3, 1>(0, k).into_owned());
    let determinant = columns[0].cross(&columns[1]).dot(&columns[2]);
    let product: f64 = columns.iter().map(|c| c.norm()).product();
    // Sheared axes are valid; nearly coplanar axes indicate a damaged header.
    if product.is_nan() || product <= 0.0 || !product.is_finite() || determinant.abs() <= 1e-6 * product {
        return Err(VolumeError::Affine { fault: "singular" });
    }
    if !columns.iter().all(|c| SPACING_MM.contains(&c.norm())) {
        return Err(VolumeError::Affine { fault: "of voxels smaller than 0.0001 mm or larger than 100000 mm" });
    }
    Ok(())
}

/// A set of voxels in a box with an empty outermost layer, and the affine of the box.
#[derive(Debug, Clone, PartialEq)]
pub struct VoxelMask {
    dims: [usize; 3],
    voxels: Vec<bool>,
    affine: Matrix4<f64>,
}

impl VoxelMask {
    /// A box of `dims` voxels, all empty.
    pub fn empty(dims: [usize; 3], affine: Matrix4<f64>) -> Self {
        VoxelMask { dims, voxels: vec![false; dims.iter().product()], affine }
    }

    /// Voxels along each axis, the empty border included.
    pub fn dims(&self) -> [usize; 3] {
        self.dims
    }

    /// Membership of each voxel in the set, first index fastest.
    pub fn voxels(&self) -> &[bool] {
        &self.voxels
    }

    /// Voxel index to world mm.
    pub fn affine(&self) -> &Matrix4<f64> {
        &self.affine
    }

    /// Side of a cube with the volume of a voxel, mm.
    pub fn voxel_size_mm(&self) -> f64 {
        spacing_mm(&self.affine).iter().product::<f64>().cbrt()
    }

    /// Voxels in the set.
    pub fn n_voxels(&self) -> usize {
        self.voxels.iter().filter(|&&v| v).count()
    }

    /// Volume of the voxels in the set, mm³.
    pub fn volume_mm3(&self) -> f64 {
        self.n_voxels() as f64 * self.affine.fixed_view::<3, 3>(0, 0).determinant().abs()
    }

    /// Faces between the set and its complement. Cost `O(voxels)`.
    pub fn n_boundary_faces(&self) -> usize {
        let steps = self.strides();
        let v = &self.voxels;
        // The outermost voxels are empty, so a pair that wraps around the edge of the box does not count.
        steps.iter().map(|&s| v.iter().zip(&v[s..]).filter(|(a, b)| a != b).count()).sum()
    }

    /// Position of a voxel in [`VoxelMask::voxels`].
    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.dims[1] + y) * self.dims[0] + x
    }

    /// Index of a voxel along each axis.
    fn place(&self, index: usize) -> [usize; 3] {
        let [nx, ny, _] = self.dims;
        [index % nx, index / nx % ny, index / (nx * ny)]
    }

    /// Whether a voxel has all its 26 neighbors in the box.
    fn is_inner(&self, index: usize) -> bool {
        let place = self.place(index);
        (0..3).all(|k| place[k] > 0 && place[k] + 1 < self.dims[k])
    }

    /// Whether the voxel one `step` away is in the box.
    fn has_neighbor(&self, index: usize, step: [i8; 3]) -> bool {
        let place = self.place(index);
        (0..3).all(|k| place[k].checked_add_signed(step[k].into()).is_some_and(|c| c < self.dims[k]))
    }

    /// World position of a voxel coordinate, mm.
    fn world(&self, voxel: [f64; 3]) -> Point3<f64> {
        Point3::from((self.affine * Vector4::new(voxel[0], voxel[1], voxel[2], 1.0)).xyz())
    }

    /// Whether the affine contains a reflection, so that faces must be reversed to face outwards.
    fn mirrors(&self) -> bool {
        self.affine.fixed_view::<3, 3>(0, 0).determinant() < 0.0
    }

    /// Strides of [`VoxelMask::voxels`] along each axis.
    fn strides(&self) -> [usize; 3] {
        [1, self.dims[0], self.dims[0] * self.dims[1]]
    }

    fn with_voxels(&self, voxels: Vec<bool>) -> Self {
        VoxelMask { dims: self.dims, voxels, affine: self.affine }
    }
}
