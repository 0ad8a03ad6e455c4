//! A surface as flat triangles with their adjacency, for following straight lines over it.

use super::dijkstra::WeightedGraph;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::graph::EdgeGraph;
use nalgebra::Point3;

/// No triangle on the other side, or no triangle in which a line can be continued.
pub(super) const NOWHERE: u32 = u32::MAX;

/// Triangles with neighbors. A side is one edge of one triangle; triangle `t` has sides `3t`, `3t + 1`, `3t + 2`.
pub(super) struct Polyhedron {
    /// Positions, mm: the vertices of the mesh, then on quads the mean of the corners of every face.
    pub vertices: Vec<Point3<f64>>,
    pub sides: Vec<Side>,
    /// The edges, with lengths.
    pub edges: WeightedGraph,
    fan_offsets: Vec<u32>,
    fans: Vec<u32>,
}

/// A side of a triangle, and the position of its apex (the third corner) in the frame of that side.
pub(super) struct Side {
    pub from: u32,
    pub to: u32,
    pub apex: u32,
    /// The same edge as a side of the one other triangle at it, or [`NOWHERE`].
    pub across: u32,
    /// The foot of the apex along the side, 0 at `from` and 1 at `to`.
    pub along: f64,
    /// The height of the apex in lengths of the side.
    pub height: f64,
}

impl Polyhedron {
    /// Cost `O(faces log faces)`.
    pub(super) fn new(mesh: &SurfaceMesh) -> Self {
        let mut vertices = mesh.vertices().to_vec();
        let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(4 * mesh.n_faces());
        for f in mesh.faces() {
            match mesh.arity() {
                FaceArity::Triangle => triangles.push([f[0], f[1], f[2]]),
                FaceArity::Quad => {
                    let center = vertices.len() as u32;
                    let opposite = |a: u32, b: u32| nalgebra::center(&vertices[a as usize], &vertices[b as usize]);
                    vertices.push(nalgebra::center(&opposite(f[0], f[2]), &opposite(f[1], f[3])));
                    triangles.extend((0..4).map(|k| [f[k], f[(k + 1) % 4], center]));
                }
            }
        }
        let mut sides: Vec<Side> = triangles.iter().flat_map(|t| sides_of(*t, &vertices)).collect();
        let edges = join(&mut sides);
        let edges = WeightedGraph::new(EdgeGraph::from_edges(vertices.len(), &edges), &vertices);
        let mut fan_offsets = vec![0u32; vertices.len() + 1];
        for side in &sides {
            fan_offsets[side.apex as usize + 1] += 1;
        }
        for v in 0..vertices.len() {
            fan_offsets[v + 1] += fan_offsets[v];
        }
        let mut fans: Vec<u32> = (0..sides.len() as u32).collect();
        fans.sort_by_key(|&s| sides[s as usize].apex);
        Polyhedron { vertices, sides, edges, fan_offsets, fans }
    }

    /// The sides opposite to `vertex`, one for each of its triangles.
    pub(super) fn fan(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.fans[self.fan_offsets[v] as usize..self.fan_offsets[v + 1] as usize]
    }

    /// The other two sides of the triangle of `side`: first the one that contains its corner `corner`.
    pub(super) fn sides_beyond(&self, side: u32, corner: u32) -> [u32; 2] {
        let first = side - side % 3;
        let (next, last) = (first + (side + 1) % 3, first + (side + 2) % 3);
        if self.sides[side as usize].to == corner { [next, last] } else { [last, next] }
    }
}

fn sides_of(corners: [u32; 3], vertices: &[Point3<f64>]) -> [Side; 3] {
    std::array::from_fn(|k| {
        let [from, to, apex] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
        let base = vertices[to as usize] - vertices[from as usize];
        let slope = vertices[apex as usize] - vertices[from as usize];
        let square = base.norm_squared();
        let (along, height) = (base.dot(&slope) / square, base.cross(&slope).norm() / square);
        Side { from, to, apex, across: NOWHERE, along, height }
    })
}

/// Joins the sides of every edge that has exactly two, and returns the edges, ascending. A line ends at an edge
/// with one side or more than two, and at edges of length 0, which have no frame.
fn join(sides: &mut [Side]) -> Vec<[u32; 2]> {
    let mut by_edge: Vec<([u32; 2], u32)> =
        sides.iter().enumerate().map(|(k, s)| ([s.from.min(s.to), s.from.max(s.to)], k as u32)).collect();
    by_edge.sort_unstable();
    let mut edges = Vec::with_capacity(by_edge.len() / 2);
    for group in by_edge.chunk_by(|a, b| a.0 == b.0) {
        edges.push(group[0].0);
        if let &[(_, a), (_, b)] = group {
            let framed = |k: u32| sides[k as usize].along.is_finite() && sides[k as usize].height.is_finite();
            if framed(a) && framed(b) {
                sides[a as usize].across = b;
                sides[b as usize].across = a;
            }
        }
    }
    edges
}
