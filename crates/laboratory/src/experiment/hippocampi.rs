//! Real hippocampi: the label volumes in a folder, as surfaces with the label of the nearest voxel at every vertex.

use homolog_contract::parameters::{Method, preset};
use homolog_formats::ReadLimits;
use homolog_formats::nifti::read_nifti;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::volume::LabelVolume;
use homolog_run::intake::{IntakeLimits, prepare_surface};
use nalgebra::Point3;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// The label volumes in a folder, sorted by name. Reports refer to subjects by number, never by file name.
pub(super) struct Hippocampi {
    files: Vec<PathBuf>,
}

/// One hippocampus.
#[derive(Debug, Clone)]
pub(super) struct Subject {
    /// Surface in scanner coordinates, mm.
    pub(super) mesh: SurfaceMesh,
    /// Label (1 anterior, 2 posterior) of the voxel nearest to every vertex.
    pub(super) parts: Vec<u32>,
}

impl Hippocampi {
    /// The label volumes in `data/hippocampus`; `None` if there are none.
    pub(super) fn open(data: &Path) -> Option<Self> {
        let is_volume = |path: &PathBuf| path.to_string_lossy().ends_with(".nii.gz");
        let entries = fs::read_dir(data.join("hippocampus")).ok()?;
        let mut files: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).filter(is_volume).collect();
        files.sort();
        (!files.is_empty()).then_some(Hippocampi { files })
    }

    pub(super) fn len(&self) -> usize {
        self.files.len()
    }

    /// Hash of a file's content, or the error on reading it.
    pub(super) fn hash(&self, index: usize) -> String {
        fs::read(&self.files[index]).map_or_else(|e| e.to_string(), |bytes| blake3::hash(&bytes).to_hex().to_string())
    }

    /// Reads a volume and extracts its smooth surface, as the service does.
    pub(super) fn subject(&self, index: usize) -> Result<Subject, String> {
        let refused = |e: String| format!("subject {index}: {e}");
        let volume = self.volume(index)?;
        let bytes = fs::read(&self.files[index]).map_err(|e| refused(e.to_string()))?;
        let mesh = surface(&bytes).map_err(refused)?;
        let parts = nearest_labels(&volume, &mesh);
        Ok(Subject { mesh, parts })
    }

    /// Reads a volume.
    pub(super) fn volume(&self, index: usize) -> Result<LabelVolume, String> {
        let bytes = fs::read(&self.files[index]).map_err(|e| format!("subject {index} cannot be read: {e}"))?;
        let file = read_nifti(&bytes, &ReadLimits::default()).map_err(|e| format!("subject {index}: {e}"))?;
        Ok(file.volume)
    }
}

/// The smooth surface of a file, as the service makes it.
pub(super) fn surface(bytes: &[u8]) -> Result<SurfaceMesh, String> {
    let input = preset(Method::Balanced).input;
    let prepared = prepare_surface(bytes, None, &input, &IntakeLimits::default());
    prepared.map(|prepared| prepared.mesh).map_err(|e| e.to_string())
}

/// The label of the voxel nearest to every vertex. Cost `O(vertices · voxels)`.
fn nearest_labels(volume: &LabelVolume, mesh: &SurfaceMesh) -> Vec<u32> {
    let [nx, ny, _] = volume.dims();
    let voxels: Vec<(Point3<f64>, u32)> = volume
        .labels()
        .iter()
        .enumerate()
        .filter(|(_, label)| **label > 0)
        .map(|(k, &label)| {
            let at = Point3::new((k % nx) as f64, (k / nx % ny) as f64, (k / (nx * ny)) as f64);
            (volume.affine().transform_point(&at), label)
        })
        .collect();
    let nearest = |p: &Point3<f64>| {
        let distance = |v: &(Point3<f64>, u32)| (v.0 - p).norm_squared();
        voxels.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map_or(0, |v| v.1)
    };
    mesh.vertices().par_iter().map(nearest).collect()
}
