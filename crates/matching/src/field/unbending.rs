//! The map from a surface to its bending-invariant form.

use crate::surface::form::rotations;
use homolog_primitives::points::NeighborGrid;
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Sites whose rigid motions are blended at a point.
const BLENDED: usize = 6;
/// Distance from the nearest site on the form, in spacings, beyond which a site belongs to another limb.
const SAME_LIMB: f64 = 3.0;

/// A blend of the rigid motions that take the surroundings of each site to the form.
///
/// Sites that are close in space may be far apart along the surface, such as those of a hand that touches the hip. So a
/// point belongs to the site whose cell contains it, and only sites of the same limb are blended.
pub(crate) struct Unbending {
    sites: Vec<Point3<f64>>,
    /// Vertices of the surface, mm, and the site of each.
    vertices: Vec<Point3<f64>>,
    site_of: Vec<u32>,
    /// Rotation of the surroundings of each site, and the site on the form.
    motions: Vec<(Matrix3<f64>, Point3<f64>)>,
    /// Mean distance between neighboring sites, mm.
    spacing_mm: f64,
}

impl Unbending {
    /// The map from `sites` of a surface to `form`, mm. `neighbors`: for each site its neighbors along the surface,
    /// itself first. `cells`: the vertices of the surface, mm, and the site of each.
    pub(crate) fn new(
        sites: &[Point3<f64>],
        form: &[Point3<f64>],
        neighbors: &[Vec<u32>],
        cells: (&[Point3<f64>], &[u32]),
    ) -> Unbending {
        let rotations = rotations(sites, form, neighbors, true);
        let motions = rotations.into_iter().zip(form.iter().copied()).collect();
        let nearest =
            |(p, near): (&Point3<f64>, &Vec<u32>)| near.get(1).map_or(0.0, |&k| (sites[k as usize] - p).norm());
        let spacing_mm = sites.iter().zip(neighbors).map(nearest).sum::<f64>() / sites.len() as f64;
        Unbending { sites: sites.to_vec(), vertices: cells.0.to_vec(), site_of: cells.1.to_vec(), motions, spacing_mm }
    }

    /// Maps `points` of the surface to the form, mm. Cost `O(n)`.
    pub(crate) fn of(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let grid = NeighborGrid::new(&self.sites, 2.0 * self.spacing_mm);
        let vertices = NeighborGrid::new(&self.vertices, 0.5 * self.spacing_mm);
        points
            .par_iter()
            .map(|p| {
                let own = nearest(&vertices, p, 0.5 * self.spacing_mm);
                let first = self.site_of[own as usize];
                let home = self.motions[first as usize].1;
                let is_of_limb = |k: u32| (self.motions[k as usize].1 - home).norm() < SAME_LIMB * self.spacing_mm;
                let mut near: Vec<(f64, u32)> = Vec::new();
                grid.within(p, 2.0 * self.spacing_mm, |k, squared| {
                    if is_of_limb(k) {
                        near.push((squared, k));
                    }
                });
                if near.is_empty() {
                    near.push(((self.sites[first as usize] - p).norm_squared(), first));
                }
                near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
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

/// The nearest of the points of `grid` to `p`, searched within `radius_mm`, which is doubled until one is found.
fn nearest(grid: &NeighborGrid, p: &Point3<f64>, mut radius_mm: f64) -> u32 {
    loop {
        let mut best: Option<(f64, u32)> = None;
        grid.within(p, radius_mm, |k, squared| {
            if best.is_none_or(|b| (squared, k) < b) {
                best = Some((squared, k));
            }
        });
        if let Some((_, k)) = best {
            return k;
        }
        radius_mm *= 2.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_goes_with_its_limb_and_not_with_one_that_is_close() {
        // Two parallel limbs, a quarter of the spacing apart. The form spreads them: the second turns away.
        let limb = |y: f64| (0..10).map(move |k| Point3::new(f64::from(k), y, 0.0));
        let sites: Vec<Point3<f64>> = limb(0.0).chain(limb(0.25)).collect();
        let form: Vec<Point3<f64>> = limb(0.0).chain((0..10).map(|k| Point3::new(-f64::from(k), 20.0, 0.0))).collect();
        let along = |k: u32| [k, if k % 10 == 9 { k - 1 } else { k + 1 }].to_vec();
        let neighbors: Vec<Vec<u32>> = (0..20).map(along).collect();
        // This vertex of the first limb is nearer to sites of the second.
        let mut vertices = sites.clone();
        vertices.push(Point3::new(4.5, 0.2, 0.0));
        let site_of: Vec<u32> = (0..20).chain([4]).collect();
        let unbending = Unbending::new(&sites, &form, &neighbors, (&vertices, &site_of));
        let found = unbending.of(&[vertices[20], sites[14]]);
        assert!(found[0].y.abs() < 1.0 && found[0].x > 3.0, "{}", found[0]);
        assert!((found[1].y - 20.0).abs() < 1.0 && found[1].x < -3.0, "{}", found[1]);
    }
}
