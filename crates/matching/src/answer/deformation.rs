//! Deformation of the source by a map to corresponding points: folds, areas and enclosed volume.

use super::consistency::DEGENERATE_AREA_SHARE;
use homolog_contract::result::DeformationDocument;
use homolog_mesh::{ClosestPoint, SurfaceMesh};
use nalgebra::{Point3, Vector3};

/// Deformation of the source surface by the map that takes vertex `i` of `source` to `images[i]`, a point on `target`.
///
/// The image of a triangle (a quad counts as two) is the triangle between the images of its corners, in their order. It
/// is *folded* if its normal has a negative product with the sum of the target's normals at its corners, each of which
/// is interpolated from unit vertex normals. An image of less than [`DEGENERATE_AREA_SHARE`] of the mean area of the
/// target's triangles has no orientation and is not counted. Both surfaces face outwards; with `mirrored`, the map is
/// that of the mirrored source. Triangles with a corner for which `has_counterpart` is false are left out of all
/// measures but the volume.
///
/// `None` if no triangle with an area is left.
///
/// # Cost
/// `O(vertices + faces)`, and a sort of the source's vertices; sums have a fixed order.
///
/// # Source
/// The area ratio at a vertex is the determinant of the Jacobian of the piecewise linear map along the surface,
/// averaged over the triangles around the vertex.
pub(crate) fn deformation(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    images: &[ClosestPoint],
    has_counterpart: impl Fn(usize) -> bool,
    mirrored: bool,
) -> Option<DeformationDocument> {
    let target_normals = target.vertex_normals();
    let normals: Vec<Vector3<f64>> = images.iter().map(|image| image.blend(|k| target_normals[k])).collect();
    let smallest = DEGENERATE_AREA_SHARE * target.area() / target.triangles().len() as f64;
    let sign = if mirrored { -1.0 } else { 1.0 };
    let (mut n_folded, mut folded, mut before, mut after) = (0_u32, 0.0, 0.0, 0.0);
    let mut at_vertices = vec![[0.0; 2]; source.n_vertices()];
    let triangles = source.triangles();
    for corners in triangles.iter().map(|triangle| triangle.map(|v| v as usize)) {
        if !corners.iter().all(|&v| has_counterpart(v)) {
            continue;
        }
        let own = vector_area(corners.map(|v| source.vertices()[v])).norm();
        let image = vector_area(corners.map(|v| images[v].point));
        let outwards: Vector3<f64> = corners.iter().map(|&v| normals[v]).sum();
        if image.norm() >= smallest && sign * image.dot(&outwards) < 0.0 {
            n_folded += 1;
            folded += own;
        }
        before += own;
        after += image.norm();
        for v in corners {
            at_vertices[v][0] += own;
            at_vertices[v][1] += image.norm();
        }
    }
    if before <= 0.0 {
        return None;
    }
    let mut ratios: Vec<f64> =
        at_vertices.iter().filter(|[own, _]| *own > 0.0).map(|[own, image]| image / own).collect();
    // Equal ratios are indistinguishable, so the result does not depend on the order of an unstable sort.
    ratios.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| ratios[((ratios.len() - 1) as f64 * share).round() as usize];
    let are_closed = source.boundary_vertices().is_none() && target.boundary_vertices().is_none();
    let volumes = are_closed.then(|| {
        let moved: Vec<Point3<f64>> = images.iter().map(|image| image.point).collect();
        [volume(&triangles, source.vertices()), sign * volume(&triangles, &moved)]
    });
    Some(DeformationDocument {
        folded_triangles: n_folded,
        folded_area_share: folded / before,
        area_ratio: after / before,
        area_ratio_p05: at(0.05),
        area_ratio_p95: at(0.95),
        volume_ratio: volumes.filter(|[own, _]| *own > 0.0).map(|[own, image]| image / own),
    })
}

fn vector_area([a, b, c]: [Point3<f64>; 3]) -> Vector3<f64> {
    (b - a).cross(&(c - a)) / 2.0
}

/// Enclosed volume, mm³, positive if the triangles face outwards.
fn volume(triangles: &[[u32; 3]], vertices: &[Point3<f64>]) -> f64 {
    // Relative to a vertex, so that a surface far from the origin keeps its precision.
    let origin = vertices.first().copied().unwrap_or_else(Point3::origin);
    let of = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|v| vertices[v as usize] - origin);
        a.dot(&b.cross(&c)) / 6.0
    };
    triangles.iter().map(of).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_mesh::{ClosestPointIndex, FaceArity};

    /// Images of vertices: the closest points of `target` to `points`.
    fn on(target: &SurfaceMesh, points: &[Point3<f64>]) -> Vec<ClosestPoint> {
        let index = ClosestPointIndex::new(target);
        points.iter().map(|p| index.closest(p)).collect()
    }

    fn measured(source: &SurfaceMesh, target: &SurfaceMesh, points: &[Point3<f64>]) -> DeformationDocument {
        deformation(source, target, &on(target, points), |_| true, false).unwrap()
    }

    fn assert_near(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-9, "{found} instead of {expected}");
    }

    fn shapes() -> [SurfaceMesh; 3] {
        [
            ellipsoid(Vector3::new(9.0, 6.0, 5.0), 2),
            torus(10.0, 4.0, 16, 9, FaceArity::Triangle),
            torus(10.0, 4.0, 16, 9, FaceArity::Quad),
        ]
    }

    #[test]
    fn a_copy_is_not_deformed_and_a_scaled_one_grows_by_powers_of_the_scale() {
        for source in shapes() {
            for scale in [1.0, 0.5, 3.0] {
                // Away from the origin, on which the volume must not depend.
                let points: Vec<_> =
                    source.vertices().iter().map(|p| p * scale + Vector3::new(300.0, -50.0, 9.0)).collect();
                let target = source.with_vertices(points.clone()).unwrap();
                let found = measured(&source, &target, &points);
                assert_eq!((found.folded_triangles, found.folded_area_share), (0, 0.0));
                for ratio in [found.area_ratio, found.area_ratio_p05, found.area_ratio_p95] {
                    assert_near(ratio, scale * scale);
                }
                assert_near(found.volume_ratio.unwrap(), scale.powi(3));
            }
        }
    }

    #[test]
    fn the_numbering_of_the_target_makes_no_difference() {
        let source = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 2);
        let n = source.n_vertices() as u32;
        let points: Vec<_> = source.vertices().iter().map(|p| Point3::new(p.x, 1.2 * p.y, p.z)).collect();
        let target = source.with_vertices(points.clone()).unwrap();
        let permuted = SurfaceMesh::new(
            points.iter().rev().copied().collect(),
            target.arity(),
            target.indices().iter().map(|v| n - 1 - v).collect(),
        )
        .unwrap();
        let [a, b] = [&target, &permuted].map(|target| measured(&source, target, &points));
        assert_eq!(a.folded_triangles, 0);
        assert_eq!(a.folded_triangles, b.folded_triangles);
        assert_near(a.area_ratio, b.area_ratio);
        assert_near(a.volume_ratio.unwrap(), 1.2);
        assert_near(b.volume_ratio.unwrap(), 1.2);
    }

    #[test]
    fn a_stretched_torus_has_the_area_ratios_of_its_triangles() {
        let source = torus(10.0, 4.0, 24, 12, FaceArity::Triangle);
        let points: Vec<_> = source.vertices().iter().map(|p| Point3::new(p.x, p.y, 2.0 * p.z)).collect();
        let target = source.with_vertices(points.clone()).unwrap();
        let found = measured(&source, &target, &points);
        assert_near(found.area_ratio, target.area() / source.area());
        assert_near(found.volume_ratio.unwrap(), 2.0);
        // Flat regions keep their area, upright regions double it.
        assert!(found.area_ratio_p05 >= 1.0 && found.area_ratio_p05 < 1.3, "{found:?}");
        assert!(found.area_ratio_p95 <= 2.0 && found.area_ratio_p95 > 1.8, "{found:?}");
    }

    /// A plane of squares cut along a diagonal, of edge 1.
    fn plane(n: u32) -> SurfaceMesh {
        let at = |i: u32, j: u32| j * n + i;
        let vertices = (0..n * n).map(|k| Point3::new(f64::from(k % n), f64::from(k / n), 0.0)).collect();
        let squares = (0..n - 1).flat_map(|j| (0..n - 1).map(move |i| (i, j)));
        let corners = squares
            .flat_map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        SurfaceMesh::new(vertices, FaceArity::Triangle, corners.collect()).unwrap()
    }

    #[test]
    fn a_triangle_that_is_turned_over_is_the_one_fold() {
        let mesh = plane(5);
        let mut points = mesh.vertices().to_vec();
        // The corner (4, 0), which belongs to one triangle, is moved across the opposite side to (3.4, 0.6).
        let corner = points.iter().position(|p| p.x == 4.0 && p.y == 0.0).unwrap();
        assert_eq!(mesh.triangles().iter().filter(|t| t.contains(&(corner as u32))).count(), 1);
        points[corner] = Point3::new(3.4, 0.6, 0.0);
        let found = measured(&mesh, &mesh, &points);
        assert_eq!(found.folded_triangles, 1);
        assert_near(found.folded_area_share, 1.0 / 32.0);
        // Its height changes from 1/√2 to 0.1 √2 on the other side.
        assert_near(found.area_ratio, (31.0 + 0.2) / 32.0);
        assert_eq!(found.volume_ratio, None, "an open surface encloses nothing");
        // Moved onto the side, the triangle has no area and no orientation.
        points[corner] = Point3::new(3.5, 0.5, 0.0);
        assert_eq!(measured(&mesh, &mesh, &points).folded_triangles, 0);
    }

    #[test]
    fn two_exchanged_neighbors_of_a_closed_surface_fold_the_triangles_between_them() {
        let mesh = ellipsoid(Vector3::repeat(6.0), 3);
        let [a, b] = mesh.edges()[500];
        let mut points = mesh.vertices().to_vec();
        points.swap(a as usize, b as usize);
        let found = measured(&mesh, &mesh, &points);
        assert!((2..=10).contains(&found.folded_triangles), "{found:?}");
        assert!(found.folded_area_share > 0.0 && found.folded_area_share < 0.01);
    }

    #[test]
    fn a_map_onto_the_mirror_image_folds_everything_unless_it_is_said_to_mirror() {
        let source = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 2);
        let matrix = [[-1.0, 0.0, 0.0, 4.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let target = source.moved(&matrix).unwrap();
        let points: Vec<_> = source.vertices().iter().map(|p| Point3::new(4.0 - p.x, p.y, p.z)).collect();
        let images = on(&target, &points);
        let [plain, mirrored] =
            [false, true].map(|mirrored| deformation(&source, &target, &images, |_| true, mirrored).unwrap());
        assert_eq!(plain.folded_triangles as usize, source.n_faces());
        assert_near(plain.folded_area_share, 1.0);
        assert_near(plain.volume_ratio.unwrap(), -1.0);
        assert_eq!(mirrored.folded_triangles, 0);
        assert_near(mirrored.area_ratio, 1.0);
        assert_near(mirrored.volume_ratio.unwrap(), 1.0);
    }

    #[test]
    fn what_has_no_counterpart_is_left_out() {
        let mesh = plane(5);
        let mut points = mesh.vertices().to_vec();
        points[0] = Point3::new(2.0, 2.0, 0.0);
        let images = on(&mesh, &points);
        let found = deformation(&mesh, &mesh, &images, |v| v != 0, false).unwrap();
        assert_eq!((found.folded_triangles, found.area_ratio), (0, 1.0));
        assert_eq!(deformation(&mesh, &mesh, &images, |_| false, false), None);
    }
}
