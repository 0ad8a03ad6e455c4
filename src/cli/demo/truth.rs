//! The answer of the demo, compared with the known truth of its phantom.

use crate::cli::error::CliError;
use homolog_contract::result::TransformDocument;
use homolog_laboratory::phantom::{DEFAULT_EDGE_MM, PairRecipe, PhantomPair};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Errors of an answer, in one paragraph. `source` is the matched source, `warped` the source deformed onto the target.
///
/// The answer maps points of the true source surface; their images are compared with the phantom's.
///
/// # Errors
/// [`CliError`] if the phantom cannot be made.
pub(super) fn compared_with_truth(
    recipe: &PairRecipe,
    source: &SurfaceMesh,
    warped: &SurfaceMesh,
    transform: &TransformDocument,
) -> Result<String, CliError> {
    let failed = |error| CliError::Failed(format!("the phantom cannot be made: {error}"));
    let pair = PhantomPair::new(recipe.clone()).map_err(failed)?;
    let points = pair.source_surface(DEFAULT_EDGE_MM).map_err(failed)?;
    let index = ClosestPointIndex::new(source);
    let mut errors: Vec<f64> = Vec::with_capacity(points.mesh.n_vertices());
    let mut untouched: Vec<f64> = Vec::with_capacity(points.mesh.n_vertices());
    let mut pairs = Vec::with_capacity(points.mesh.n_vertices());
    for point in points.mesh.vertices() {
        let image = index.closest(point).blend(|vertex| warped.vertices()[vertex].coords);
        let truth = pair.place(point).coords;
        errors.push((image - truth).norm());
        untouched.push((point.coords - truth).norm());
        pairs.push([point.coords, truth]);
    }
    let rotation = Matrix3::from_fn(|r, c| transform.matrix[r][c]);
    let turned = Rotation3::from_matrix_unchecked(rotation).angle_to(&best_rotation(&pairs));
    let bent = pair.deformation().map_or_else(String::new, |d| format!(", bent by {:.2} mm RMS", d.rms_mm()));
    Ok(format!(
        "Compared with the truth, which the demo knows: the target is the source rotated by {:.1}°{bent} and made of voxels of \
         1 mm.\n  rotation          {:.2}° from the one that fits the true corresponding points best\n  corresponding points  {:.2} mm (median) and {:.2} mm (95th \
         percentile) from the true ones; {:.1} mm before the match",
        pair.pose().rotation.angle().to_degrees(),
        turned.to_degrees(),
        percentile(&mut errors, 0.5),
        percentile(&mut errors, 0.95),
        percentile(&mut untouched, 0.5),
    ))
}

/// The rotation of the rigid transform that best fits pairs of points (Kabsch 1976), because bending also rotates.
fn best_rotation(pairs: &[[Vector3<f64>; 2]]) -> Rotation3<f64> {
    let n = pairs.len().max(1) as f64;
    let mean = |k: usize| pairs.iter().map(|pair| pair[k]).sum::<Vector3<f64>>() / n;
    let (from, to) = (mean(0), mean(1));
    let covariance: Matrix3<f64> = pairs.iter().map(|[a, b]| (b - to) * (a - from).transpose()).sum();
    Rotation3::from_matrix_unchecked(nearest_rotation(&covariance))
}

/// The rotation `U diag(1, 1, det U Vᵀ) Vᵀ` of the singular value decomposition of `covariance`.
fn nearest_rotation(covariance: &Matrix3<f64>) -> Matrix3<f64> {
    let found = covariance.svd(true, true);
    let (Some(u), Some(v)) = (found.u, found.v_t) else { return Matrix3::identity() };
    let sign = (u * v).determinant().signum();
    u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * v
}

/// A percentile of `values`, which are sorted; `share` from 0 to 1.
fn percentile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let at = (share * values.len().saturating_sub(1) as f64).round() as usize;
    values.get(at).copied().unwrap_or(f64::NAN)
}
