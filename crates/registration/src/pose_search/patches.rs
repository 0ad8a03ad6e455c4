//! A surface as a small number of patches, each with a mean position, a mean normal and an area.
//!
//! The mean over a patch reduces the noise of single vertices by the square root of their number. The sum of the vector
//! areas of faces that share edges depends only on the rim of the patch, so noise that tilts single normals at random
//! leaves the normal of the patch nearly unchanged. The number of vertices in a patch is irrelevant.

use crate::alignment::compact::N_FEATURES;
use crate::alignment::{OrientedPoint, OrientedPoints};
use crate::weighted_moments;
use homolog_primitives::points::FarthestPoints;
use nalgebra::{Matrix3, Point3, Vector3};

/// One piece of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Patch {
    /// Area-weighted mean of its points.
    pub center: Vector3<f64>,
    /// Area-weighted mean of its unit normals: shorter where they disagree.
    pub normal: Vector3<f64>,
    /// Area.
    pub area: f64,
    /// Shape descriptors of its surroundings, see [`super::features`].
    pub features: [f64; N_FEATURES],
}

impl Patch {
    /// The patch moved by `p' = R p + t`.
    pub(super) fn moved(&self, rotation: &Matrix3<f64>, shift: &Vector3<f64>) -> Patch {
        Patch { center: rotation * self.center + shift, normal: rotation * self.normal, ..*self }
    }

    pub(super) fn as_point(&self) -> OrientedPoint<'_> {
        OrientedPoint { position: self.center, normal: self.normal, area: self.area, features: &self.features }
    }
}

/// A surface at two resolutions, about its centroid and in the frame of its principal axes, mm.
pub(super) struct Patches {
    pub coarse: Vec<Patch>,
    pub fine: Vec<Patch>,
    /// Origin of the frame in the coordinates of the surface, mm.
    pub center: Vector3<f64>,
    /// Axes of the frame, as columns.
    pub axes: Matrix3<f64>,
    /// Diagonal of the box around the patches along the axes, mm.
    pub diagonal_mm: f64,
    /// Whether the points came with features.
    pub have_features: bool,
}

impl Patches {
    /// `None` if there are fewer than three points, no area, or a number is not finite. Cost `O(fine · points)`.
    pub(super) fn new(surface: &OrientedPoints<'_>, n_coarse: usize, n_fine: usize) -> Option<Self> {
        let total: f64 = surface.areas.iter().sum();
        if surface.points.len() < 3 || !(total > 0.0 && total.is_finite()) {
            return None;
        }
        let (center, axes) = frame(surface, total)?;
        let local = |p: &Point3<f64>| Point3::from(axes.transpose() * (p.coords - center));
        let points: Vec<Point3<f64>> = surface.points.iter().map(local).collect();
        let normals: Vec<Vector3<f64>> = surface.normals.iter().map(|n| axes.transpose() * n).collect();
        // The first samples of a large sample form a small, evenly spread sample.
        let mut sampling = FarthestPoints::new(&points, Point3::origin());
        let [coarse, fine] = [n_coarse.max(1), n_fine].map(|n| {
            sampling.extend_to(n);
            cut(&points, &sampling, &normals, surface.areas, surface.features)
        });
        let start = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        let (low, high) = fine.iter().fold(start, |(low, high), p| (low.inf(&p.center), high.sup(&p.center)));
        let have_features = !surface.features.is_empty();
        Some(Patches { coarse, fine, center, axes, diagonal_mm: (high - low).norm(), have_features })
    }
}

/// The mirror image, with the first coordinate negated.
pub(super) fn mirrored(patches: &[Patch]) -> Vec<Patch> {
    let reflected = |v: &Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
    patches.iter().map(|p| Patch { center: reflected(&p.center), normal: reflected(&p.normal), ..*p }).collect()
}

/// The centroids of `n` pieces of `whole`. Each piece lies around one of the first patches, which are spread evenly,
/// and consists of the nearest patches whose total area is `area`. Cost `O(n · patches log patches)`.
pub(super) fn pieces(whole: &[Patch], area: f64, n: usize) -> Vec<Vector3<f64>> {
    let around = |at: &Patch| {
        let mut nearest: Vec<&Patch> = whole.iter().collect();
        nearest.sort_by(|a, b| (a.center - at.center).norm_squared().total_cmp(&(b.center - at.center).norm_squared()));
        let (mut sum, mut mass) = (Vector3::zeros(), 0.0);
        for patch in nearest {
            if mass >= area {
                break;
            }
            sum += patch.center * patch.area;
            mass += patch.area;
        }
        sum / mass
    };
    whole.iter().take(n).map(around).collect()
}

/// Centroid of the surface, and its principal axes as columns of a rotation, longest first. The signs of the first two
/// make the skewness along them positive, so that the frame moves with the surface. `None` if a number is not finite.
fn frame(surface: &OrientedPoints<'_>, total: f64) -> Option<(Vector3<f64>, Matrix3<f64>)> {
    let weighted = || surface.points.iter().zip(surface.areas);
    let (center, scatter) = weighted_moments(surface.points, surface.areas, total)?;
    let eigen = scatter.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let [first, second] = [0, 1].map(|k| {
        let axis: Vector3<f64> = eigen.eigenvectors.column(order[k]).into();
        let skewness: f64 = weighted().map(|(p, &a)| a * axis.dot(&(p.coords - center)).powi(3)).sum();
        if skewness < 0.0 { -axis } else { axis }
    });
    Some((center, Matrix3::from_columns(&[first, second, first.cross(&second)])))
}

/// One patch per sample, made of the points nearest to it. Patches without area are left out.
fn cut(
    points: &[Point3<f64>],
    sampling: &FarthestPoints<'_>,
    normals: &[Vector3<f64>],
    areas: &[f64],
    features: &[f64],
) -> Vec<Patch> {
    let none = Patch { center: Vector3::zeros(), normal: Vector3::zeros(), area: 0.0, features: [0.0; N_FEATURES] };
    let mut patches = vec![none; sampling.samples().len()];
    for (i, (((p, n), &area), k)) in points.iter().zip(normals).zip(areas).zip(sampling.nearest_samples()).enumerate() {
        let patch = &mut patches[k];
        let own = features.chunks_exact(N_FEATURES).nth(i).unwrap_or(&[0.0; N_FEATURES]);
        patch.features.iter_mut().zip(own).for_each(|(sum, f)| *sum += area * f);
        patch.center += p.coords * area;
        patch.normal += n * area;
        patch.area += area;
    }
    patches.retain(|p| p.area > 0.0);
    for patch in &mut patches {
        patch.center /= patch.area;
        patch.normal /= patch.area;
        patch.features.iter_mut().for_each(|f| *f /= patch.area);
    }
    patches
}
