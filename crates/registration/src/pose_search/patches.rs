//! A surface as a few patches: where each lies on average, where it looks, how much area it has.
//!
//! The mean over a patch takes off noise of single vertices by the square root of their number. So does the sum of the
//! vector areas, which for faces that share edges depends on the rim of the patch alone: where noise turns single
//! normals at random, the patch still looks outwards. How many vertices a patch has does not matter.
//!
//! Source of the seeds: farthest-point sampling, Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985.

use super::OrientedPoints;
use crate::weighted_moments;
use nalgebra::{Matrix3, Vector3};

/// Numbers that say how the surroundings of a patch are formed.
pub(super) const N_FEATURES: usize = 4;

/// One piece of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Patch {
    /// Area-weighted mean of its points.
    pub center: Vector3<f64>,
    /// Area-weighted mean of its unit normals: shorter where they disagree.
    pub normal: Vector3<f64>,
    /// Area.
    pub area: f64,
    /// How its surroundings are formed, see [`super::features`].
    pub features: [f64; N_FEATURES],
}

impl Patch {
    /// The patch moved by `p' = R p + t`.
    pub fn moved(&self, rotation: &Matrix3<f64>, shift: &Vector3<f64>) -> Patch {
        Patch { center: rotation * self.center + shift, normal: rotation * self.normal, ..*self }
    }
}

/// A surface cut in few and in many patches, about its centroid and in the frame of its principal axes, mm.
pub(super) struct Patches {
    pub coarse: Vec<Patch>,
    pub fine: Vec<Patch>,
    /// Where the frame of the patches begins on the surface, mm.
    pub center: Vector3<f64>,
    /// Its axes, as columns.
    pub axes: Matrix3<f64>,
    /// Diagonal of the box around the patches along the axes, mm.
    pub diagonal_mm: f64,
}

impl Patches {
    /// `None` without three points, without area, or where numbers are not finite. Cost `O(fine · points)`.
    pub fn new(surface: &OrientedPoints<'_>, n_coarse: usize, n_fine: usize) -> Option<Self> {
        let total: f64 = surface.areas.iter().sum();
        if surface.points.len() < 3 || !(total > 0.0 && total.is_finite()) {
            return None;
        }
        let (center, axes) = frame(surface, total)?;
        let local: Vec<Vector3<f64>> = surface.points.iter().map(|p| axes.transpose() * (p.coords - center)).collect();
        let normals: Vec<Vector3<f64>> = surface.normals.iter().map(|n| axes.transpose() * n).collect();
        let mut owners = Owners::new(&local);
        owners.extend(n_coarse);
        let coarse = owners.patches(&normals, surface.areas);
        owners.extend(n_fine);
        let fine = owners.patches(&normals, surface.areas);
        let start = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        let (low, high) = fine.iter().fold(start, |(low, high), p| (low.inf(&p.center), high.sup(&p.center)));
        Some(Patches { coarse, fine, center, axes, diagonal_mm: (high - low).norm() })
    }
}

/// The mirror image, the first axis turned round.
pub(super) fn mirrored(patches: &[Patch]) -> Vec<Patch> {
    let turned = |v: &Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
    patches.iter().map(|p| Patch { center: turned(&p.center), normal: turned(&p.normal), ..*p }).collect()
}

/// Centroid of the surface, and its principal axes as columns of a rotation, longest first. The first two point where
/// the surface reaches farther, so that the frame goes with the surface wherever it is moved. `None` where numbers are not
/// finite.
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

/// Seeds spread evenly over points, and for every point the nearest seed.
///
/// Each seed is the point farthest from those before it, so that the first of many seeds are few seeds spread evenly.
struct Owners<'a> {
    points: &'a [Vector3<f64>],
    /// Squared distance of every point from the nearest seed, mm².
    squared: Vec<f64>,
    nearest: Vec<u32>,
    n_seeds: usize,
}

impl<'a> Owners<'a> {
    /// The first seed is the point farthest from the origin.
    fn new(points: &'a [Vector3<f64>]) -> Self {
        let squared: Vec<f64> = points.iter().map(Vector3::norm_squared).collect();
        let mut owners = Owners { points, squared, nearest: vec![0; points.len()], n_seeds: 0 };
        let first = owners.farthest();
        owners.squared.fill(f64::INFINITY);
        owners.add(first);
        owners
    }

    /// The lowest index of those farthest from all seeds.
    fn farthest(&self) -> usize {
        let mut found = 0;
        for (i, &d) in self.squared.iter().enumerate() {
            if d > self.squared[found] {
                found = i;
            }
        }
        found
    }

    fn add(&mut self, seed: usize) {
        let at = self.points[seed];
        for ((p, squared), nearest) in self.points.iter().zip(&mut self.squared).zip(&mut self.nearest) {
            let d = (p - at).norm_squared();
            if d < *squared {
                *squared = d;
                *nearest = self.n_seeds as u32;
            }
        }
        self.n_seeds += 1;
    }

    /// Adds seeds until there are `n`, or every point is one.
    fn extend(&mut self, n: usize) {
        while self.n_seeds < n {
            let next = self.farthest();
            if self.squared[next] <= 0.0 {
                return;
            }
            self.add(next);
        }
    }

    /// One patch a seed, those without area left out.
    fn patches(&self, normals: &[Vector3<f64>], areas: &[f64]) -> Vec<Patch> {
        let none = Patch { center: Vector3::zeros(), normal: Vector3::zeros(), area: 0.0, features: [0.0; N_FEATURES] };
        let mut patches = vec![none; self.n_seeds];
        for (((p, n), &area), &k) in self.points.iter().zip(normals).zip(areas).zip(&self.nearest) {
            let patch = &mut patches[k as usize];
            patch.center += p * area;
            patch.normal += n * area;
            patch.area += area;
        }
        patches.retain(|p| p.area > 0.0);
        for patch in &mut patches {
            patch.center /= patch.area;
            patch.normal /= patch.area;
        }
        patches
    }
}
