//! Images of source vertices on the target surface, with the probability that they are close to the truth.

use super::confidence::{equally_probable_radii, error_scale, spread_of_scale, within};
use crate::pair::lengths::sampling_variance;
use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use homolog_primitives::points::NeighborGrid;
use nalgebra::Point3;
use rayon::prelude::*;

/// The image of a source vertex on the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Image {
    /// The moved vertex, mm; off the target by the distance of the two surfaces along the normal.
    pub moved: Point3<f64>,
    /// The closest point of the target: triangle, barycentric coordinates and position, mm.
    pub closest: ClosestPoint,
    /// The target vertex nearest to `moved`.
    pub label: u32,
    /// Probability that `label` is within a mean target edge length of the true image.
    pub confidence: f64,
    /// Expected root mean square error of `moved`, mm.
    pub spread_mm: f64,
}

/// The images of source vertices moved to `moved`, with the variance of each, mm², and the sampling distance
/// `sampling_mm` of the surfaces, mm.
///
/// Cost `O(n log n')`.
pub(crate) fn images(
    target: &SurfaceMesh,
    index: &ClosestPointIndex,
    moved: &[Point3<f64>],
    variances: &[f64],
    sampling_mm: f64,
) -> Vec<Image> {
    let edge_mm = target.mean_edge_length();
    let grid = NeighborGrid::new(target.vertices(), 2.0 * edge_mm);
    let radii = equally_probable_radii();
    moved
        .par_iter()
        .zip(variances)
        .map(|(p, variance)| {
            let closest = index.closest(p);
            // The nearest corner, unless a vertex around it is nearer still: triangles can be obtuse.
            let corner = closest.nearest_corner();
            let mut best = ((target.vertices()[corner as usize] - p).norm_squared(), corner);
            grid.within(p, best.0.sqrt().min(2.0 * edge_mm), |j, squared| {
                if squared < best.0 {
                    best = (squared, j);
                }
            });
            let variance = sampling_variance(sampling_mm) + variance;
            let scale = error_scale(variance);
            let confidence = within(edge_mm, best.0.sqrt(), scale, &radii);
            let spread_mm = spread_of_scale(scale);
            Image { moved: *p, closest, label: best.1, confidence, spread_mm }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn vertices_of_the_target_are_their_own_images() {
        let target = ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3);
        let none = vec![0.0; target.n_vertices()];
        for (i, image) in
            images(&target, &ClosestPointIndex::new(&target), target.vertices(), &none, 1.0).iter().enumerate()
        {
            assert_eq!(image.label as usize, i);
            assert!((image.closest.point - target.vertices()[i]).norm() < 1e-9);
            assert!(image.confidence > 0.99);
        }
    }

    #[test]
    fn an_image_between_vertices_has_the_nearest_as_label() {
        let target = ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3);
        let points: Vec<Point3<f64>> = target
            .triangles()
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|k| target.vertices()[k as usize].coords);
                Point3::from(0.3 * a + 0.45 * b + 0.25 * c)
            })
            .collect();
        for (p, image) in points.iter().zip(images(
            &target,
            &ClosestPointIndex::new(&target),
            &points,
            &vec![0.75; points.len()],
            1.0,
        )) {
            let nearest = target.vertices().iter().map(|q| (q - p).norm()).fold(f64::INFINITY, f64::min);
            assert_eq!((target.vertices()[image.label as usize] - p).norm(), nearest);
            assert!((image.closest.point - p).norm() < 1e-9 && image.confidence < 0.99);
        }
    }
}
