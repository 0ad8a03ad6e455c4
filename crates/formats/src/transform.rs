//! Writers of rigid and affine transforms in the conventions of other programs.
//!
//! The input is `target_from_source`, 4×4, row by row: it maps points of the source, in RAS millimeters as in NIfTI,
//! onto the target. The written matrix may differ, if the reading program expects another convention.

use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Vector4};

/// The matrix itself as text: four lines of four numbers, readable by `numpy.loadtxt` and most registration programs.
pub fn write_matrix_text(target_from_source: &[[f64; 4]; 4]) -> String {
    target_from_source.iter().map(|row| row.map(|v| format!("{v:?}")).join(" ") + "\n").collect()
}

/// An ITK transform file (`.tfm`) for ITK, ANTs and 3D Slicer. `None` if the matrix has no inverse.
///
/// ITK uses LPS coordinates and maps points of the fixed image to the moving one, because resampling looks up each
/// fixed voxel in the moving image. With the target fixed and the source moving, the file therefore holds `F ·
/// target_from_source⁻¹ · F`, where `F = diag(−1, −1, 1, 1)` swaps RAS and LPS. It resamples the source image onto the
/// grid of the target without changes; in 3D Slicer it is applied to the source node.
///
/// # Source
/// ITK Software Guide, "Transforms"; 3D Slicer developer guide, "Transforms" (file convention LPS, fixed to moving).
pub fn write_itk_transform(target_from_source: &[[f64; 4]; 4]) -> Option<String> {
    let forward = Matrix4::from_fn(|r, c| target_from_source[r][c]);
    let inverse = forward.try_inverse().filter(|m| m.iter().all(|v| v.is_finite()))?;
    let flip = Matrix4::from_diagonal(&nalgebra::Vector4::new(-1.0, -1.0, 1.0, 1.0));
    let lps = flip * inverse * flip;
    // The linear part row by row, then the translation; the center stays at the origin. Adding zero makes −0 a 0.
    let linear = (0..9).map(|k| lps[(k / 3, k % 3)]);
    let parameters: Vec<String> = linear.chain((0..3).map(|r| lps[(r, 3)])).map(|v| format!("{:?}", v + 0.0)).collect();
    Some(format!(
        "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\nParameters: {}\n\
         FixedParameters: 0 0 0\n",
        parameters.join(" ")
    ))
}

/// A FreeSurfer linear transform array (`.lta`) of type 1 (RAS to RAS), source to target: the unchanged matrix.
///
/// `volumes` are the label volumes of source and target, whose geometry the file states. The geometry of a mesh input
/// is written as invalid, with FreeSurfer's values for an unknown volume; programs that need it take `--src` and
/// `--trg` (`lta_convert`) or `--mov` and `--targ`.
///
/// # Source
/// FreeSurfer, `LTAwrite` and `VOL_GEOM::write`.
pub fn write_lta(target_from_source: &[[f64; 4]; 4], volumes: [Option<&LabelVolume>; 2]) -> String {
    let row = |row: &[f64; 4]| row.map(|v| format!("{v:.15e}")).join(" ") + "\n";
    let matrix: String = target_from_source.iter().map(row).collect();
    let unknown = "valid = 0  # volume info invalid\nfilename = unknown\nvolume = 256 256 256\nvoxelsize = 1 1 1\n\
                    xras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\ncras   = 0 0 0\n";
    let geometry = volumes.map(|volume| volume.map_or_else(|| unknown.to_owned(), volume_geometry));
    format!(
        "type      = 1 # LINEAR_RAS_TO_RAS\nnxforms   = 1\nmean      = 0.0000 0.0000 0.0000\nsigma     = 1.0000\n1 4 4\n\
         {matrix}src volume info\n{}dst volume info\n{}",
        geometry[0], geometry[1]
    )
}

/// Size, spacing, directions of the axes and position of the middle, in FreeSurfer's form.
fn volume_geometry(volume: &LabelVolume) -> String {
    let (affine, size, spacing) = (volume.affine(), volume.dims(), volume.spacing_mm());
    let row = |v: [f64; 3]| v.map(|v| format!("{v:.15e}")).join(" ");
    let axis = |k: usize| row([0, 1, 2].map(|r| affine[(r, k)] / spacing[k]));
    let middle = affine * Vector4::new(size[0] as f64 / 2.0, size[1] as f64 / 2.0, size[2] as f64 / 2.0, 1.0);
    format!(
        "valid = 1  # volume info valid\nfilename = unknown\nvolume = {} {} {}\nvoxelsize = {}\nxras   = {}\nyras   = {}\n\
         zras   = {}\ncras   = {}\n",
        size[0],
        size[1],
        size[2],
        row(spacing),
        axis(0),
        axis(1),
        axis(2),
        row([middle.x, middle.y, middle.z])
    )
}
