//! A phantom as a label volume: the voxels whose centers lie inside, with their parts.

use super::PhantomError;
use super::shape::{Part, Phantom};
use homolog_mesh::volume::{LabelVolume, VolumeError};
use nalgebra::{Matrix4, Point3, Vector3};
use rayon::prelude::*;

/// Largest number of voxels of a phantom volume.
const MAX_VOXELS: usize = 1 << 28;
/// Number of empty voxels on every side, which keeps filters of the mask away from the border.
const MARGIN: usize = 4;

/// An axis-aligned label volume in world millimeters (x right, y front, z up).
#[derive(Debug, Clone, PartialEq)]
pub struct PhantomVolume {
    /// Voxels along x, y, z.
    pub shape: [usize; 3],
    /// Edge of a voxel, mm.
    pub spacing_mm: f64,
    /// Center of voxel (0, 0, 0), mm.
    pub origin_mm: Point3<f64>,
    /// Label of every voxel, x fastest: 0 outside, 1 anterior, 2 posterior.
    pub labels: Vec<u8>,
}

impl PhantomVolume {
    /// The volume over the box of `extent` (points on the surface) at `spacing_mm` (0.2 to 3 mm); `part_at` returns the
    /// part of a world point.
    ///
    /// # Errors
    /// [`PhantomError::SpacingOutOfRange`], [`PhantomError::NoVertices`], [`PhantomError::TooManyVoxels`].
    pub fn rasterize(
        extent: &[Point3<f64>],
        spacing_mm: f64,
        part_at: impl Fn(&Point3<f64>) -> Option<Part> + Sync,
    ) -> Result<Self, PhantomError> {
        if !(0.2..=3.0).contains(&spacing_mm) {
            return Err(PhantomError::SpacingOutOfRange { spacing_mm });
        }
        let Some(&first) = extent.first() else { return Err(PhantomError::NoVertices) };
        let (low, high) = extent.iter().fold((first, first), |(l, h), p| (l.inf(p), h.sup(p)));
        let margin = MARGIN as f64 * spacing_mm;
        // Centers lie on multiples of the spacing, as in scanners, for any pose.
        let origin = low.map(|c| ((c - margin) / spacing_mm).floor() * spacing_mm);
        let shape: [usize; 3] =
            std::array::from_fn(|k| ((high[k] + margin - origin[k]) / spacing_mm).ceil() as usize + 1);
        let n_voxels = shape.iter().try_fold(1usize, |n, &m| n.checked_mul(m)).unwrap_or(usize::MAX);
        if n_voxels > MAX_VOXELS {
            return Err(PhantomError::TooManyVoxels { n_voxels, max: MAX_VOXELS });
        }
        let slice = shape[0] * shape[1];
        let mut labels = vec![0u8; n_voxels];
        labels.par_chunks_mut(slice).enumerate().for_each(|(z, plane)| {
            for (at, label) in plane.iter_mut().enumerate() {
                let cell = Vector3::new((at % shape[0]) as f64, (at / shape[0]) as f64, z as f64);
                *label = part_at(&(origin + cell * spacing_mm)).map_or(0, Part::label);
            }
        });
        Ok(PhantomVolume { shape, spacing_mm, origin_mm: origin, labels })
    }

    /// The volume in the form for writing files and making surfaces.
    ///
    /// # Errors
    /// The errors of [`LabelVolume::new`]; none for a volume made here.
    pub fn into_label_volume(self) -> Result<LabelVolume, VolumeError> {
        let mut affine = Matrix4::new_scaling(self.spacing_mm);
        affine.fixed_view_mut::<3, 1>(0, 3).copy_from(&self.origin_mm.coords);
        LabelVolume::new(self.shape, self.labels.into_iter().map(u32::from).collect(), affine)
    }

    /// Voxels that are not background.
    pub fn n_foreground(&self) -> usize {
        self.labels.iter().filter(|&&l| l != 0).count()
    }
}

impl Phantom {
    /// The label volume of the subject in its own pose, at `spacing_mm`.
    ///
    /// # Errors
    /// The errors of [`PhantomVolume::rasterize`].
    pub fn volume(&self, spacing_mm: f64) -> Result<PhantomVolume, PhantomError> {
        let extent = self.surface(1.0)?;
        PhantomVolume::rasterize(extent.mesh.vertices(), spacing_mm, |p| self.part_at(p))
    }
}
