//! The map from places on a surface to its bending-invariant form.

use homolog_primitives::points::NeighborGrid;
use homolog_registration::absolute_orientation;
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Sites whose rigid motions are blended at a place.
const BLENDED: usize = 6;
/// Sites farther than this from the nearest one on the form, in spacings, belong to another limb that is close by.
const SAME_LIMB: f64 = 3.0;

/// A blend of the rigid motions that take the surroundings of each site to the form.
pub(super) struct Unbending {
    sites: Vec<Point3<f64>>,
    /// Rotation of each site's surroundings and the site on the form.
    motions: Vec<(Matrix3<f64>, Point3<f64>)>,
    /// Mean distance between neighboring sites, mm.
    spacing_mm: f64,
}

impl Unbending {
    /// The map that takes `sites` of a surface to `form`, mm, whose `neighbors` along the surface are listed for each site, itself
    /// first.
    pub(super) fn new(sites: &[Point3<f64>], form: &[Point3<f64>], neighbors: &[Vec<u32>]) -> Unbending {
        let motions = neighbors
            .par_iter()
            .enumerate()
            .map(|(i, near)| {
                let at = |p: &[Point3<f64>]| -> Vec<Point3<f64>> { near.iter().map(|&k| p[k as usize]).collect() };
                let fitted = absolute_orientation(&at(sites), &at(form), None, true);
                (fitted.map_or(Matrix3::identity(), |t| t.rotation), form[i])
            })
            .collect();
        let nearest =
            |(p, near): (&Point3<f64>, &Vec<u32>)| near.get(1).map_or(0.0, |&k| (sites[k as usize] - p).norm());
        let spacing_mm = sites.iter().zip(neighbors).map(nearest).sum::<f64>() / sites.len() as f64;
        Unbending { sites: sites.to_vec(), motions, spacing_mm }
    }

    /// `points` of the surface on the form, mm. Cost `O(n)`.
    pub(super) fn of(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let grid = NeighborGrid::new(&self.sites, 2.0 * self.spacing_mm);
        points
            .par_iter()
            .map(|p| {
                let mut near: Vec<(f64, u32)> = Vec::new();
                let mut radius_mm = 2.0 * self.spacing_mm;
                while near.is_empty() {
                    grid.within(p, radius_mm, |k, squared| near.push((squared, k)));
                    radius_mm *= 2.0;
                }
                near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                let (_, first) = near[0];
                let home = self.motions[first as usize].1;
                near.retain(|&(_, k)| (self.motions[k as usize].1 - home).norm() < SAME_LIMB * self.spacing_mm);
                near.truncate(BLENDED);
                let (mut total, mut sum) = (0.0, Vector3::zeros());
                for (squared, k) in near {
                    let (rotation, at) = &self.motions[k as usize];
                    let weight = (-squared / (self.spacing_mm * self.spacing_mm)).exp().max(f64::MIN_POSITIVE);
                    sum += (at.coords + rotation * (p - self.sites[k as usize])) * weight;
                    total += weight;
                }
                Point3::from(sum / total)
            })
            .collect()
    }
}
