//! Makes the next template from the mean of a group: measures its distance from the last one as a *surface*, and keeps
//! the vertices in place along the surface.
//!
//! A round of matching and averaging moves vertices for two reasons. Across the surface they move because the mean has
//! another shape, which is the purpose of a template. Along the surface they slide, because a match places vertices on
//! a subject with an error that is not zero on average. No round reverses that, so vertices wander and triangles
//! degenerate although the surface stands still. The movement of a round is therefore the distance of two surfaces,
//! independent of their vertices ([`surface_distance`]), and the mean gets the vertices of the last template back, as
//! far as it is the same surface ([`next_template`]). The remaining map is one from surfaces to surfaces, and its
//! rounds have a fixed point.
//!
//! Between vertices, a surface is taken to be curved according to its normals. Otherwise a vertex in the middle of a
//! flat triangle would lie inside the surface by an eighth of its curvature times the square of an edge, 2 % of an edge
//! on a hippocampus. Source: Boubekeur, Alexa, *Phong tessellation*, ACM Transactions on Graphics 27(5), 2008.

use crate::align::area_weights;
use crate::error::StudyError;
use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Observer, Silent, checkpoint};
use homolog_registration::{
    ClosestSurfacePoint, IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, align_both_ways,
};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Candidate shares of the way by which vertices are put back; the largest that preserves the shape is chosen.
const PUT_BACK: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
/// Largest RMS distance, in mean edges, between the mean and its surface after vertices are put back. It is below the
/// tolerance that ends the rounds ([`crate::settings::MadeTemplate::tolerance`]), so that it cannot hide a movement.
const LOST_SHARE: f64 = 0.02;
/// Share of the way from a triangle to the planes through its corners at which a quadric lies.
const PHONG: f64 = 0.5;
const ALIGNMENT_STEPS: u32 = 60;
/// Step below which the alignment ends: radians, and diagonals of the surface.
const ALIGNMENT_TOLERANCE: f64 = 1e-7;

/// Distance between two surfaces, mm, over both of them, weighted by area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceDistance {
    /// Root mean square.
    pub rms_mm: f64,
    /// Mean.
    pub mean_mm: f64,
    /// Largest, over the vertices of both.
    pub largest_mm: f64,
}

/// The next template, and how it was made from a mean.
#[derive(Debug, Clone, PartialEq)]
pub struct NextTemplate {
    /// The surface of the mean, with the vertices of the last template as far as they were put back.
    pub mesh: SurfaceMesh,
    /// Distance from the last template to the mean, as surfaces.
    pub moved: SurfaceDistance,
    /// RMS distance, weighted by area, by which averaging moved vertices along the surface, mm.
    pub slid_mm: f64,
    /// Share of that distance which was reversed: 1 if the mean and the last template are nearly the same surface.
    pub put_back: f64,
}

/// A surface that is curved between its vertices.
struct CurvedSurface<'a> {
    mesh: &'a SurfaceMesh,
    index: ClosestPointIndex,
    normals: Vec<Vector3<f64>>,
    weights: Vec<f64>,
}

impl<'a> CurvedSurface<'a> {
    fn new(mesh: &'a SurfaceMesh) -> Self {
        let (index, normals) = (ClosestPointIndex::new(mesh), mesh.vertex_normals());
        CurvedSurface { mesh, index, normals, weights: area_weights(mesh) }
    }

    /// The point of the curved surface above a point of its triangles.
    fn above(&self, flat: &ClosestPoint) -> Point3<f64> {
        let to_plane = |k: usize| self.normals[k] * self.normals[k].dot(&(self.mesh.vertices()[k] - flat.point));
        flat.point + PHONG * flat.blend(to_plane)
    }

    fn side(&self) -> SurfaceSide<'_> {
        SurfaceSide { points: self.mesh.vertices(), areas: &self.weights, closest: self }
    }

    /// Distance of each point from the surface, mm.
    fn distances(&self, points: &[Point3<f64>]) -> Vec<f64> {
        points.par_iter().map(|p| (self.above(&self.index.closest(p)) - p).norm()).collect()
    }
}

impl ClosestSurfacePoint for CurvedSurface<'_> {
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        let flat = self.index.closest(query);
        let normal = flat.blend(|k| self.normals[k]).try_normalize(1e-300).unwrap_or_default();
        (self.above(&flat), normal)
    }
}

/// Distance of two surfaces, independent of their vertices, after `a` was moved rigidly onto `b`. They must lie roughly
/// on each other.
///
/// Measured from every vertex of each to the nearest point of the other, weighted by the vertex's area.
///
/// # Cost
/// `O(n log n)`, up to 60 times for the alignment.
///
/// # Errors
/// [`StudyError::Mesh`] if a position is not finite.
pub fn surface_distance(a: &SurfaceMesh, b: &SurfaceMesh) -> Result<SurfaceDistance, StudyError> {
    let moved = moved_onto(a, &CurvedSurface::new(b), &Silent)?;
    Ok(between(&CurvedSurface::new(&moved), &CurvedSurface::new(b)))
}

fn moved_onto(a: &SurfaceMesh, b: &CurvedSurface<'_>, observer: &dyn Observer) -> Result<SurfaceMesh, StudyError> {
    let options = TwoSidedOptions {
        metric: IcpMetric::PointToPlane,
        max_sample: usize::MAX,
        sample_steps: 0,
        full_steps: ALIGNMENT_STEPS,
        tolerance: ALIGNMENT_TOLERANCE,
    };
    let from = CurvedSurface::new(a);
    let found = align_both_ways(&from.side(), &b.side(), &RigidTransform::identity(), &options, observer)?;
    let pose = found.target_from_source;
    let moved = a.with_vertices(a.vertices().iter().map(|p| pose.apply(p)).collect())?;
    // Any rotation about the axis of a body of revolution fits, and a step along it can be arbitrarily large.
    let nearer = between(&CurvedSurface::new(&moved), b).rms_mm < between(&from, b).rms_mm;
    Ok(if nearer { moved } else { a.clone() })
}

fn between(a: &CurvedSurface<'_>, b: &CurvedSurface<'_>) -> SurfaceDistance {
    let (mut squares, mut sum, mut largest) = (0.0, 0.0, 0.0f64);
    for (of, to) in [(a, b), (b, a)] {
        for (distance, weight) in to.distances(of.mesh.vertices()).into_iter().zip(&of.weights) {
            squares += weight * distance * distance / 2.0;
            sum += weight * distance / 2.0;
            largest = largest.max(distance);
        }
    }
    SurfaceDistance { rms_mm: squares.sqrt(), mean_mm: sum, largest_mm: largest }
}

/// The next template: the surface of `mean`, the mean position of each vertex of `template`, roughly on it. The mean is
/// moved rigidly onto the template. Its vertices are then moved all or part of the way to the points nearest to the
/// template's vertices: as far as no triangle turns over and no end of the surface is cut off. Vertices on a border
/// keep their averaged positions, or the border would recede.
///
/// # Errors
/// [`StudyError::Mesh`] if a position is not finite; [`StudyError::Interrupted`].
///
/// # Cost
/// The cost of [`surface_distance`].
pub fn next_template(
    template: &SurfaceMesh,
    mean: Vec<Point3<f64>>,
    observer: &dyn Observer,
) -> Result<NextTemplate, StudyError> {
    let last = CurvedSurface::new(template);
    let mean = moved_onto(&template.with_vertices(mean)?, &last, observer)?;
    let surface = CurvedSurface::new(&mean);
    let moved = between(&surface, &last);
    let pairs = || mean.vertices().iter().zip(template.vertices());
    let along = |(k, (m, x)): (usize, (&Point3<f64>, &Point3<f64>))| {
        let (step, normal) = (m - x, &surface.normals[k]);
        surface.weights[k] * (step - normal * normal.dot(&step)).norm_squared()
    };
    let slid_mm = pairs().enumerate().map(along).sum::<f64>().sqrt();
    let border = mean.boundary_vertices();
    let is_border = |k: usize| border.as_ref().is_some_and(|border| border[k]);
    let turned_before = turned(&mean, &surface.normals);
    let lost_mm = LOST_SHARE * mean.mean_edge_length();
    for share in PUT_BACK {
        checkpoint(observer)?;
        let placed: Vec<(Point3<f64>, Vector3<f64>)> = pairs()
            .enumerate()
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(
                |(k, (m, x))| {
                    if is_border(k) { (*m, surface.normals[k]) } else { surface.closest(&(m + share * (x - m))) }
                },
            )
            .collect();
        let (points, normals): (Vec<_>, Vec<_>) = placed.into_iter().unzip();
        let mesh = mean.with_vertices(points)?;
        let distances = CurvedSurface::new(&mesh).distances(mean.vertices());
        let lost = distances.iter().zip(&surface.weights).map(|(d, w)| w * d * d).sum::<f64>().sqrt();
        if lost <= lost_mm && turned(&mesh, &normals) <= turned_before {
            return Ok(NextTemplate { mesh, moved, slid_mm, put_back: share });
        }
    }
    Ok(NextTemplate { mesh: mean, moved, slid_mm, put_back: 0.0 })
}

/// Number of triangles that face away from the surface, given the normals at their corners.
fn turned(mesh: &SurfaceMesh, normals: &[Vector3<f64>]) -> usize {
    let along = |face: &[u32]| face.iter().map(|&v| normals[v as usize]).sum::<Vector3<f64>>();
    mesh.faces().zip(mesh.face_vector_areas()).filter(|(face, area)| along(face).dot(area) <= 0.0).count()
}

/// Quality of the triangles of a surface, `4√3 · area / (a² + b² + c²)` with edges `a`, `b`, `c`: 1 for equilateral
/// triangles, 0 for triangles without area. Returns the mean and the lowest 5th percentile.
///
/// Source: Bank, Smith, *Mesh smoothing using a posteriori error estimates*, SIAM Journal on Numerical Analysis 34(3), 1997.
pub fn triangle_quality(mesh: &SurfaceMesh) -> [f64; 2] {
    let at = |v: u32| mesh.vertices()[v as usize];
    let of = |[a, b, c]: [u32; 3]| {
        let (a, b, c) = (at(a), at(b), at(c));
        let squares = (b - a).norm_squared() + (c - b).norm_squared() + (a - c).norm_squared();
        let area = (b - a).cross(&(c - a)).norm() / 2.0;
        if squares > 0.0 { 4.0 * 3.0f64.sqrt() * area / squares } else { 0.0 }
    };
    let mut all: Vec<f64> = mesh.triangles().into_iter().map(of).collect();
    all.sort_by(f64::total_cmp);
    [all.iter().sum::<f64>() / all.len().max(1) as f64, all.get(all.len() / 20).copied().unwrap_or(0.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, Rotation3};

    /// The same ellipsoid on other vertices.
    fn turned_grid(axes: Vector3<f64>, levels: u32, angle: f64) -> SurfaceMesh {
        let turn = Rotation3::from_euler_angles(angle, -0.7 * angle, 0.4 * angle);
        let ball = ellipsoid(Vector3::repeat(1.0), levels);
        let points = ball.vertices().iter().map(|p| Point3::from((turn * p.coords).component_mul(&axes)));
        ball.with_vertices(points.collect()).unwrap()
    }

    #[test]
    fn one_surface_on_other_vertices_is_no_movement() {
        let axes = Vector3::new(9.0, 6.0, 4.0);
        let (a, b) = (turned_grid(axes, 4, 0.0), turned_grid(axes, 4, 0.6));
        let b = b.transformed(&Isometry3::new(Vector3::new(0.3, -0.2, 0.1), Vector3::new(0.02, 0.05, -0.03)));
        let found = surface_distance(&a, &b).unwrap();
        let edge = a.mean_edge_length();
        assert!(found.rms_mm < 0.003 * edge && found.largest_mm < 0.02 * edge, "{found:?}, edges {edge} mm");
        // Growth also counts: 5 % of the distance of tangent planes from the center, whose mean is 3 V / A.
        let grown = a.with_vertices(a.vertices().iter().map(|p| p * 1.05).collect()).unwrap();
        let found = surface_distance(&grown, &a).unwrap();
        let growth = 0.05 * 3.0 * a.signed_volume() / a.area();
        assert!((found.mean_mm / growth - 1.0).abs() < 0.1 && found.rms_mm > found.mean_mm, "{found:?}, {growth} mm");
    }

    #[test]
    fn vertices_that_slid_are_put_back_and_growth_stays() {
        let axes = Vector3::new(9.0, 6.0, 4.0);
        let template = turned_grid(axes, 3, 0.0);
        let edge = template.mean_edge_length();
        // The same surface, 2 % larger, on vertices that slid about the long axis by most of an edge.
        let slide = Rotation3::from_axis_angle(&Vector3::x_axis(), 0.12);
        let slid = template.vertices().iter().map(|p| {
            let on_ball = slide * p.coords.component_div(&axes);
            Point3::from(1.02 * on_ball.component_mul(&axes))
        });
        let next = next_template(&template, slid.collect(), &Silent).unwrap();
        assert_eq!(next.put_back, 1.0);
        assert!(next.slid_mm > 0.3 * edge, "{} mm, edges {edge} mm", next.slid_mm);
        let growth = 0.02 * 3.0 * template.signed_volume() / template.area();
        assert!((next.moved.mean_mm / growth - 1.0).abs() < 0.1, "{:?}, {growth} mm", next.moved);
        let along = |mesh: &SurfaceMesh| {
            let normals = template.vertex_normals();
            let pairs = mesh.vertices().iter().zip(template.vertices()).zip(normals);
            let worst = pairs.map(|((p, x), n)| ((p - x) - n * n.dot(&(p - x))).norm()).fold(0.0, f64::max);
            worst / edge
        };
        assert!(along(&next.mesh) < 0.05, "{} of an edge", along(&next.mesh));
        let grown: Vec<f64> = next.mesh.vertices().iter().map(|p| p.coords.component_div(&axes).norm()).collect();
        assert!(grown.iter().all(|r| (1.01..1.03).contains(r)), "{grown:?}");
        // Repeated with nothing left to change: it stays the same.
        let same = next_template(&next.mesh, next.mesh.vertices().to_vec(), &Silent).unwrap();
        assert!(same.moved.rms_mm < 1e-9 && same.slid_mm < 1e-9, "{same:?}");
    }

    #[test]
    fn an_end_that_grew_far_is_not_cut_off() {
        let template = turned_grid(Vector3::new(9.0, 3.0, 3.0), 3, 0.0);
        let longer: Vec<_> = template.vertices().iter().map(|p| Point3::new(1.6 * p.x, p.y, p.z)).collect();
        let next = next_template(&template, longer, &Silent).unwrap();
        let (low, high) = next.mesh.bounding_box();
        assert!(high.x - low.x > 1.6 * 18.0 - 0.4, "{} mm", high.x - low.x);
        assert!(next.put_back < 1.0, "{}", next.put_back);
    }

    #[test]
    fn a_border_does_not_recede() {
        let n = 12u32;
        let at = |i: u32, j: u32| i * (n + 1) + j;
        let (mut points, mut faces) = (Vec::new(), Vec::new());
        for i in 0..=n {
            for j in 0..=n {
                points.push(Point3::new(f64::from(i), f64::from(j), 0.0));
                if i < n && j < n {
                    faces.extend([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
        let sheet = SurfaceMesh::new(points, FaceArity::Triangle, faces).unwrap();
        let wider = sheet.vertices().iter().map(|p| Point3::new(1.05 * p.x, p.y, p.z)).collect();
        let next = next_template(&sheet, wider, &Silent).unwrap();
        let (low, high) = next.mesh.bounding_box();
        assert!((high.x - low.x - 12.6).abs() < 1e-6, "{}", high.x - low.x);
    }

    #[test]
    fn quality_is_one_for_equilateral_triangles_and_falls_for_slivers() {
        let of = |apex: Point3<f64>| {
            let points = vec![Point3::new(0.0, 0.0, 0.0), Point3::new(1.0, 0.0, 0.0), apex];
            triangle_quality(&SurfaceMesh::new(points, FaceArity::Triangle, vec![0, 1, 2]).unwrap())[0]
        };
        assert!((of(Point3::new(0.5, 0.75f64.sqrt(), 0.0)) - 1.0).abs() < 1e-12);
        assert!(of(Point3::new(0.5, 0.01, 0.0)) < 0.03);
    }
}
