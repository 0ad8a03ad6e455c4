//! One map from two fits: source to target, and target to source.
//!
//! The prior pulls a field towards zero displacement, and little else determines its component along the surface. So
//! each fit is biased towards its start, and the forward map and the inverse of the backward map differ. The mean of
//! one fit and the inverse of the other is, to second order, the same map in both directions if both fits start from
//! one pose.
//!
//! Source: Christensen, Johnson, "Consistent image registration", IEEE TMI 20(7), 2001. They constrain the two fits to
//! be inverse to each other during optimization; here two independent fits are averaged once.

use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// The inverse of a map from the target to the source.
pub(crate) struct BackwardMap<'a> {
    target: &'a SurfaceMesh,
    /// Closest points of the target.
    closest: &'a ClosestPointIndex,
    /// Closest points of the target after it was moved onto the source.
    returned: ClosestPointIndex,
}

impl<'a> BackwardMap<'a> {
    /// `backward_positions` are the vertices of `target` moved onto the source, mm. `None` if a coordinate is not finite. Cost
    /// `O(n' log n')`.
    pub(crate) fn new(
        target: &'a SurfaceMesh,
        closest: &'a ClosestPointIndex,
        returned: Vec<Point3<f64>>,
    ) -> Option<BackwardMap<'a>> {
        let returned = ClosestPointIndex::new(&target.with_vertices(returned).ok()?);
        Some(BackwardMap { target, closest, returned })
    }

    /// Shifts each of `moved`, the images of `points` of the source, halfway along the target towards the place that
    /// the backward map takes to the point. The distance from the target is kept. Cost `O(n log n')`.
    pub(crate) fn symmetrized(&self, points: &[Point3<f64>], moved: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let vertices = self.target.vertices();
        points
            .par_iter()
            .zip(moved)
            .map(|(p, image)| {
                let inverse: Vector3<f64> = self.returned.closest(p).blend(|k| vertices[k].coords);
                image + 0.5 * (inverse - self.closest.closest(image).point.coords)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;

    /// Rotations about the long axis of an ellipsoid of revolution slide it along itself.
    fn rotated(mesh: &SurfaceMesh, angle: f64) -> Vec<Point3<f64>> {
        let rotation = nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), angle);
        mesh.vertices().iter().map(|p| rotation * p).collect()
    }

    #[test]
    fn the_mean_of_a_map_and_its_inverse_is_the_map() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 5.0), 4);
        let closest = ClosestPointIndex::new(&mesh);
        let back = BackwardMap::new(&mesh, &closest, rotated(&mesh, -0.1)).unwrap();
        let forward = rotated(&mesh, 0.1);
        for (met, image) in back.symmetrized(mesh.vertices(), &forward).iter().zip(&forward) {
            assert!((met - image).norm() < 0.02, "{met} {image}");
        }
    }

    #[test]
    fn the_mean_of_two_maps_lies_halfway() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 5.0), 4);
        let closest = ClosestPointIndex::new(&mesh);
        let back = BackwardMap::new(&mesh, &closest, rotated(&mesh, -0.14)).unwrap();
        let (forward, middle) = (rotated(&mesh, 0.1), rotated(&mesh, 0.12));
        for (met, expected) in back.symmetrized(mesh.vertices(), &forward).iter().zip(&middle) {
            assert!((met - expected).norm() < 0.02, "{met} {expected}");
        }
    }

    #[test]
    fn the_distance_from_the_target_stays() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 5.0), 4);
        let closest = ClosestPointIndex::new(&mesh);
        let back = BackwardMap::new(&mesh, &closest, mesh.vertices().to_vec()).unwrap();
        let outside: Vec<Point3<f64>> =
            mesh.vertices().iter().zip(mesh.vertex_normals()).map(|(p, n)| p + 0.3 * n).collect();
        for (met, image) in back.symmetrized(mesh.vertices(), &outside).iter().zip(&outside) {
            assert!((met - image).norm() < 0.02, "{met} {image}");
        }
    }
}
