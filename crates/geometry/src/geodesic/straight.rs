//! Straight lines over a polyhedron: the vertices visible from a vertex, and their distances.
//!
//! The triangles around a vertex are unfolded into the plane with the vertex at the origin. A cone of lines passes
//! through the far side of each into the next triangle, which is unfolded beside it; if the apex lies in the cone, it
//! is visible and splits the cone in two. Sources: Chen, Han, "Shortest paths on a polyhedron", 1990, for the
//! unfolding; Xin, Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem", 2009, for discarding
//! cones in which a path through an end of the edge is shorter to every point.

use super::dijkstra::Dijkstra;
use super::polyhedron::{NOWHERE, Polyhedron};
use nalgebra::Vector2;

/// Share by which a path must be longer than another to be discarded: far above rounding, so that two paths of equal
/// length never exclude each other.
const SLACK: f64 = 1e-9;

/// Largest number of cones per vertex: a hundred times the need of four rings of a regular mesh. Lines wind almost
/// endlessly around the tip of a needle; there, distances remain upper bounds.
const MAX_CONES: usize = 1 << 16;

/// Scratch memory of [`StraightLines::from`].
pub(super) struct StraightLines {
    search: Dijkstra,
    /// Length of the shortest known path to every vertex, straight or not.
    upper: Vec<f64>,
    /// Length of the shortest straight line to every vertex.
    straight: Vec<f64>,
    near: Vec<u32>,
    seen: Vec<u32>,
    cones: Vec<Cone>,
}

/// Lines from the origin that enter a triangle through one of its sides.
struct Cone {
    /// The side through which the lines enter the triangle.
    side: u32,
    /// The end of that side that is on the right as seen from the origin.
    right_vertex: u32,
    /// Positions of the ends of the side.
    right: Vector2<f64>,
    left: Vector2<f64>,
    /// Directions between which the lines lie.
    right_ray: Vector2<f64>,
    left_ray: Vector2<f64>,
}

impl StraightLines {
    pub(super) fn new(polyhedron: &Polyhedron) -> Self {
        let n = polyhedron.vertices.len();
        StraightLines {
            search: Dijkstra::new(n),
            upper: vec![f64::INFINITY; n],
            straight: vec![f64::INFINITY; n],
            near: Vec::new(),
            seen: Vec::new(),
            cones: Vec::new(),
        }
    }

    /// The end vertices and lengths of the straight lines from `vertex` no longer than `bound` mm that may be shortest
    /// paths. Every straight shortest path within the bound is among them.
    pub(super) fn from(&mut self, polyhedron: &Polyhedron, vertex: u32, bound: f64) -> Vec<(u32, f64)> {
        let (upper, near) = (&mut self.upper, &mut self.near);
        self.search.visit(
            vertex,
            |v, _, next| polyhedron.edges.append_neighbors(v, next),
            |v, d| {
                if d <= bound {
                    upper[v as usize] = d;
                    near.push(v);
                }
                d <= bound
            },
        );
        self.open_fan(polyhedron, vertex, bound);
        let mut n_cones = 0;
        while let Some(cone) = self.cones.pop() {
            n_cones += 1;
            if n_cones > MAX_CONES {
                self.cones.clear();
                break;
            }
            self.cross(polyhedron, &cone, bound);
        }
        let mut row = Vec::with_capacity(self.seen.len());
        for v in self.seen.drain(..) {
            let v_at = v as usize;
            if self.straight[v_at] <= self.upper[v_at] * (1.0 + SLACK) {
                row.push((v, self.straight[v_at]));
            }
            self.straight[v_at] = f64::INFINITY;
            self.upper[v_at] = f64::INFINITY;
        }
        for v in self.near.drain(..) {
            self.upper[v as usize] = f64::INFINITY;
        }
        row
    }

    /// Unfolds each triangle of `vertex` and starts a cone through its far side.
    fn open_fan(&mut self, polyhedron: &Polyhedron, vertex: u32, bound: f64) {
        let at = polyhedron.vertices[vertex as usize];
        for &far in polyhedron.fan(vertex) {
            let side = &polyhedron.sides[far as usize];
            let to_right = polyhedron.vertices[side.from as usize] - at;
            let to_left = polyhedron.vertices[side.to as usize] - at;
            let length = to_right.norm();
            self.see(side.from, length, bound);
            self.see(side.to, to_left.norm(), bound);
            let right = Vector2::new(length, 0.0);
            let left = Vector2::new(to_right.dot(&to_left), to_right.cross(&to_left).norm()) / length;
            let flat = left.iter().all(|c| c.is_finite());
            if flat && side.across != NOWHERE {
                let (right_vertex, side) = (side.from, side.across);
                self.cones.push(Cone { side, right_vertex, right, left, right_ray: right, left_ray: left });
            }
        }
    }

    /// Continues the lines of `cone` through the triangle they enter.
    fn cross(&mut self, polyhedron: &Polyhedron, cone: &Cone, bound: f64) {
        let side = &polyhedron.sides[cone.side as usize];
        let enters_at_from = side.from == cone.right_vertex;
        let left_vertex = if enters_at_from { side.to } else { side.from };
        let base = cone.left - cone.right;
        // Intersections of the outermost lines with the side.
        let cut = |ray: &Vector2<f64>, otherwise: f64| {
            let t = cone.right.perp(ray) / ray.perp(&base);
            cone.right + base * if t.is_finite() { t.clamp(0.0, 1.0) } else { otherwise }
        };
        let (first, last) = (cut(&cone.right_ray, 0.0), cut(&cone.left_ray, 1.0));
        let by_right = self.upper[cone.right_vertex as usize] + (last - cone.right).norm();
        let by_left = self.upper[left_vertex as usize] + (first - cone.left).norm();
        if by_right < last.norm() * (1.0 - SLACK) || by_left < first.norm() * (1.0 - SLACK) {
            return;
        }
        if distance_from_origin(&first, &last) > bound {
            return;
        }
        let along = if enters_at_from { side.along } else { 1.0 - side.along };
        // On the side away from the origin.
        let apex = cone.right + base * along + Vector2::new(base.y, -base.x) * side.height;
        let [beyond_right, beyond_left] = polyhedron.sides_beyond(cone.side, cone.right_vertex);
        let left_of_right_ray = cone.right_ray.perp(&apex) > 0.0;
        let right_of_left_ray = apex.perp(&cone.left_ray) > 0.0;
        let sees_apex = left_of_right_ray && right_of_left_ray;
        if sees_apex {
            self.see(side.apex, apex.norm(), bound);
        }
        if left_of_right_ray {
            let left_ray = if sees_apex { apex } else { cone.left_ray };
            let (right, right_ray) = (cone.right, cone.right_ray);
            let right_vertex = cone.right_vertex;
            self.enter(
                polyhedron,
                beyond_right,
                Cone { side: NOWHERE, right_vertex, right, left: apex, right_ray, left_ray },
            );
        }
        if right_of_left_ray {
            let right_ray = if sees_apex { apex } else { cone.right_ray };
            let (left, left_ray) = (cone.left, cone.left_ray);
            let right_vertex = side.apex;
            self.enter(
                polyhedron,
                beyond_left,
                Cone { side: NOWHERE, right_vertex, right: apex, left, right_ray, left_ray },
            );
        }
    }

    fn enter(&mut self, polyhedron: &Polyhedron, side: u32, cone: Cone) {
        let across = polyhedron.sides[side as usize].across;
        if across != NOWHERE {
            self.cones.push(Cone { side: across, ..cone });
        }
    }

    /// A straight line of `length` ends at `vertex`.
    fn see(&mut self, vertex: u32, length: f64, bound: f64) {
        if length > bound {
            return;
        }
        let v = vertex as usize;
        if self.straight[v] == f64::INFINITY {
            self.seen.push(vertex);
        }
        self.straight[v] = self.straight[v].min(length);
        self.upper[v] = self.upper[v].min(length);
    }
}

/// Distance of the segment between `a` and `b` from the origin.
fn distance_from_origin(a: &Vector2<f64>, b: &Vector2<f64>) -> f64 {
    let direction = b - a;
    let t = -a.dot(&direction) / direction.norm_squared();
    if t.is_finite() { (a + direction * t.clamp(0.0, 1.0)).norm() } else { a.norm() }
}
