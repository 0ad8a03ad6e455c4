//! Closest points on the triangles of a surface.
//!
//! The tree of bounding boxes is parry's, and the answers equal parry's to the bit: boxes and triangles are visited in
//! the order of parry's own search. Parry's search takes a square root per box, and descends below deferred boxes even
//! if a closer point has been found since. This search compares squared distances and skips those boxes.

use super::SurfaceMesh;
use nalgebra::Point3;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh, TraversalAction};
use parry3d_f64::query::PointQueryWithLocation;
use parry3d_f64::shape::{TriMesh, Triangle, TrianglePointLocation};
use std::ops::{Add, Mul};

/// Closest-point queries against the triangles of one surface (quads are split along a diagonal).
pub struct ClosestPointIndex {
    nodes: Vec<Node>,
    vertices: Vec<Vector>,
    triangles: Vec<[u32; 3]>,
}

/// Two sibling boxes, stored coordinate by coordinate.
struct Node {
    low: [[f64; 2]; 3],
    high: [[f64; 2]; 3],
    /// The child in each box: a triangle if [`LEAF`] is set, otherwise a node.
    children: [u32; 2],
}

/// Capacity for deferred nodes in a search of a tree of usual depth.
const MAX_WAITING: usize = 32;
/// Marks a child that is a triangle.
const LEAF: u32 = 1 << 31;

/// The point of a surface that is closest to a query point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosestPoint {
    /// The point, mm.
    pub point: Point3<f64>,
    /// The triangle it lies on, by its corners.
    pub triangle: [u32; 3],
    /// Its barycentric coordinates there, in the order of the corners.
    pub barycentric: [f64; 3],
}

impl ClosestPoint {
    /// `value` at the three corners, interpolated with the barycentric coordinates.
    pub fn blend<T: Mul<f64, Output = T> + Add<Output = T>>(&self, value: impl Fn(usize) -> T) -> T {
        let [a, b, c] = std::array::from_fn(|k| value(self.triangle[k] as usize) * self.barycentric[k]);
        a + b + c
    }

    /// Whether the point lies on an edge or corner whose ends all satisfy `is_marked`, such as a rim beyond which the surface is
    /// missing.
    pub fn is_between(&self, is_marked: impl Fn(usize) -> bool) -> bool {
        let takes_part = |k: &usize| self.barycentric[*k] >= 1e-6;
        (0..3).filter(takes_part).count() < 3 && (0..3).filter(takes_part).all(|k| is_marked(self.triangle[k] as usize))
    }

    /// The corner of the triangle with the largest barycentric coordinate; ties go to the lowest index.
    pub fn nearest_corner(&self) -> u32 {
        let mut best = 0;
        for k in 1..3 {
            let more = self.barycentric[k] > self.barycentric[best];
            let tie = self.barycentric[k] == self.barycentric[best] && self.triangle[k] < self.triangle[best];
            if more || tie {
                best = k;
            }
        }
        self.triangle[best]
    }
}

impl Node {
    /// A node whose boxes are infinitely far away.
    fn empty() -> Self {
        Node { low: [[f64::INFINITY; 2]; 3], high: [[f64::NEG_INFINITY; 2]; 3], children: [LEAF; 2] }
    }

    /// Squared distances of `at` from both boxes.
    #[inline(always)]
    fn squared_distances(&self, at: &[f64; 3]) -> [f64; 2] {
        let mut squared = [0.0; 2];
        for ((low, high), at) in self.low.iter().zip(&self.high).zip(at) {
            for side in 0..2 {
                let (below, above) = (low[side] - at, at - high[side]);
                let outside = if below > above { below } else { above };
                let outside = if outside > 0.0 { outside } else { 0.0 };
                squared[side] += outside * outside;
            }
        }
        squared
    }
}

/// The nodes of a tree in depth-first order, left child first.
fn nodes_of(tree: &Bvh) -> Vec<Node> {
    let mut nodes: Vec<Node> = Vec::with_capacity(tree.leaf_count() as usize);
    // Slots for the next nodes: (parent, child).
    let mut open: Vec<(usize, usize)> = Vec::new();
    tree.traverse_indexed(None, |entry, place| {
        let (_, is_right) = place.decompose();
        let side = usize::from(is_right);
        if !is_right {
            if let Some((parent, side)) = open.pop() {
                nodes[parent].children[side] = nodes.len() as u32;
            }
            nodes.push(Node::empty());
        }
        let at = nodes.len() - 1;
        let node = &mut nodes[at];
        for axis in 0..3 {
            node.low[axis][side] = entry.mins()[axis];
            node.high[axis][side] = entry.maxs()[axis];
        }
        if let Some(triangle) = entry.leaf_data() {
            node.children[side] = LEAF | triangle;
        } else if is_right && node.children[0] & LEAF == 0 {
            // The left child comes next.
            let left = open.len() - 1;
            open.insert(left, (at, 1));
        } else {
            node.children[side] = 0;
            open.push((at, side));
        }
        TraversalAction::Continue
    });
    nodes
}

/// The best result of a search so far: its distance, and bounds of the squared distance.
struct Best {
    distance: f64,
    certainly_less: f64,
    certainly_not_less: f64,
}

impl Best {
    fn at(distance: f64) -> Self {
        let squared = distance * distance;
        // Wider than the rounding error of a product and a square root.
        let slack = 8.0 * f64::EPSILON * squared + f64::MIN_POSITIVE;
        Best { distance, certainly_less: squared - slack, certainly_not_less: squared + slack }
    }

    /// Whether the square root of `squared` is less than the distance, rounding included.
    #[inline(always)]
    fn is_farther_than(&self, squared: f64) -> bool {
        squared < self.certainly_less || (squared <= self.certainly_not_less && squared.sqrt() < self.distance)
    }
}

impl ClosestPointIndex {
    /// A bounding-volume tree over the triangles of `mesh`; `O(n log n)`.
    pub fn new(mesh: &SurfaceMesh) -> Self {
        let vertices: Vec<Vector> = mesh.vertices().iter().map(|p| Vector::new(p.x, p.y, p.z)).collect();
        let triangles = mesh.triangles();
        // The tree rejects only an empty list of triangles, and a `SurfaceMesh` has at least one face.
        let tree =
            TriMesh::new(vertices.clone(), triangles.clone()).unwrap_or_else(|_| unreachable!("a mesh without faces"));
        ClosestPointIndex { nodes: nodes_of(tree.bvh()), vertices, triangles }
    }

    /// Upper bound of the memory of an index over `mesh`, bytes.
    pub fn heap_bytes_over(mesh: &SurfaceMesh) -> usize {
        let n_triangles = mesh.n_faces() * (mesh.arity().n_corners() - 2);
        n_triangles * (size_of::<Node>() + size_of::<[u32; 3]>()) + size_of_val(mesh.vertices())
    }

    /// Memory that this index takes, bytes.
    pub fn heap_bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>()
            + size_of_val(self.vertices.as_slice())
            + size_of_val(self.triangles.as_slice())
    }

    /// The closest point of the surface; `O(log n)` on surfaces.
    pub fn closest(&self, query: &Point3<f64>) -> ClosestPoint {
        self.closest_within(query, f64::MAX)
    }

    /// [`ClosestPointIndex::closest`] to the bit, faster if `near` is a closest point of a query nearby: boxes that are
    /// farther away than its triangle are skipped from the start.
    pub fn closest_from(&self, query: &Point3<f64>, near: &ClosestPoint) -> ClosestPoint {
        let point = Vector::new(query.x, query.y, query.z);
        let distance = (self.projected(near.triangle, point).0 - point).length();
        // The distance of the triangle itself is below this bound.
        self.closest_within(query, distance * (1.0 + 1e-9) + f64::MIN_POSITIVE)
    }

    /// The closest point of a surface that has points closer than `bound`, mm.
    fn closest_within(&self, query: &Point3<f64>, bound: f64) -> ClosestPoint {
        let at = [query.x, query.y, query.z];
        let point = Vector::new(query.x, query.y, query.z);
        let mut best = Best::at(bound);
        // Result where no distance is a number.
        let mut found = (0, point, TrianglePointLocation::OnVertex(0));
        // Deferred nodes with their squared distances.
        let mut waiting = [(0, 0.0); MAX_WAITING];
        let mut n_waiting = 0;
        let mut more_waiting: Vec<(u32, f64)> = Vec::new();
        let mut next = Some(0);
        while let Some(at_node) = next.take() {
            let node = &self.nodes[at_node as usize];
            let squared = node.squared_distances(&at);
            // The nearer box first; ties go to the left one.
            let is_right_nearer = squared[0] > squared[1]
                && (squared[0] > (1.0 + 8.0 * f64::EPSILON) * squared[1] || squared[0].sqrt() > squared[1].sqrt());
            let first = usize::from(is_right_nearer);
            for side in [first, 1 - first] {
                if !best.is_farther_than(squared[side]) {
                    continue;
                }
                let child = node.children[side];
                if child & LEAF != 0 {
                    let triangle = child & !LEAF;
                    let (place, location) = self.projected(self.triangles[triangle as usize], point);
                    let distance = (place - point).length();
                    if distance < best.distance {
                        best = Best::at(distance);
                        found = (triangle, place, location);
                    }
                } else if next.is_none() {
                    next = Some(child);
                } else if n_waiting < MAX_WAITING {
                    waiting[n_waiting] = (child, squared[side]);
                    n_waiting += 1;
                } else {
                    more_waiting.push((child, squared[side]));
                }
            }
            while next.is_none() {
                let (node, squared) = match more_waiting.pop() {
                    Some(entry) => entry,
                    None if n_waiting > 0 => {
                        n_waiting -= 1;
                        waiting[n_waiting]
                    }
                    None => break,
                };
                if best.is_farther_than(squared) {
                    next = Some(node);
                }
            }
        }
        let (triangle, place, location) = found;
        ClosestPoint {
            point: Point3::new(place.x, place.y, place.z),
            triangle: self.triangles[triangle as usize],
            barycentric: location.barycentric_coordinates().unwrap_or([1.0, 0.0, 0.0]),
        }
    }

    fn projected(&self, triangle: [u32; 3], point: Vector) -> (Vector, TrianglePointLocation) {
        let [a, b, c] = triangle.map(|k| self.vertices[k as usize]);
        let (projection, location) = Triangle::new(a, b, c).project_local_point_and_get_location(point, false);
        (projection.point, location)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::ellipsoid;
    use nalgebra::Vector3;
    use proptest::prelude::*;

    fn tree_of(mesh: &SurfaceMesh) -> TriMesh {
        let vertices = mesh.vertices().iter().map(|p| Vector::new(p.x, p.y, p.z)).collect();
        TriMesh::new(vertices, mesh.triangles()).unwrap()
    }

    /// The result of parry's own search.
    fn by_parry(tree: &TriMesh, query: &Point3<f64>) -> ClosestPoint {
        let at = Vector::new(query.x, query.y, query.z);
        let (projection, (triangle, location)) = tree.project_local_point_and_get_location(at, false);
        ClosestPoint {
            point: Point3::new(projection.point.x, projection.point.y, projection.point.z),
            triangle: tree.indices()[triangle as usize],
            barycentric: location.barycentric_coordinates().unwrap_or([1.0, 0.0, 0.0]),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn the_answer_is_that_of_parry_to_the_bit(
            at in prop::array::uniform3(-12.0..12.0f64),
            scale in -30i32..30,
            rounded in any::<bool>(),
        ) {
            let scale = 2f64.powi(scale);
            let mesh = ellipsoid(Vector3::new(9.0, 6.0, 4.0) * scale, 3);
            let (index, tree) = (ClosestPointIndex::new(&mesh), tree_of(&mesh));
            // Round coordinates lie on planes of symmetry, where several triangles are equally close.
            let query = Point3::from(at.map(|x| scale * if rounded { x.round() } else { x }));
            prop_assert_eq!(index.closest(&query), by_parry(&tree, &query));
            let near = index.closest(&query);
            for vertex in mesh.vertices().iter().step_by(17) {
                let outside = Point3::from(vertex.coords * 1.01);
                for query in [*vertex, outside] {
                    prop_assert_eq!(index.closest(&query), by_parry(&tree, &query));
                    prop_assert_eq!(index.closest_from(&query, &near), by_parry(&tree, &query));
                }
            }
        }
    }

    #[test]
    fn one_triangle_is_closest_to_everything_and_a_query_that_is_no_number_has_an_answer() {
        let vertices = vec![Point3::origin(), Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
        let mesh = SurfaceMesh::new(vertices, crate::FaceArity::Triangle, vec![0, 1, 2]).unwrap();
        let (index, tree) = (ClosestPointIndex::new(&mesh), tree_of(&mesh));
        for query in [Point3::new(0.2, 0.3, 1.0), Point3::new(-5.0, 0.1, 0.0)] {
            assert_eq!(index.closest(&query), by_parry(&tree, &query));
        }
        assert_eq!(index.closest(&Point3::new(f64::NAN, 0.0, 0.0)).triangle, [0, 1, 2]);
    }

    #[test]
    fn a_point_is_between_vertices_if_only_they_have_a_share_of_it() {
        let at = |barycentric| ClosestPoint { point: Point3::origin(), triangle: [4, 7, 9], barycentric };
        let is_marked = |v: usize| v != 9;
        assert!(at([0.3, 0.7, 0.0]).is_between(is_marked) && at([1.0, 0.0, 0.0]).is_between(is_marked));
        assert!(
            !at([0.3, 0.6, 0.1]).is_between(|_| true)
                && !at([0.3, 0.6, 0.1]).is_between(is_marked)
                && !at([0.0, 0.0, 1.0]).is_between(is_marked)
        );
    }
}
