//! The edges of a surface with their conductances, and the cyclic order of the neighbors of a vertex.

use super::HarmonicsError;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::graph::EdgeGraph;
use nalgebra::Point3;
use std::collections::BTreeMap;

/// Smallest conductance as a share of the mean: the maximum principle needs positive weights, and cotangents of obtuse
/// angles are negative.
const FLOOR: f64 = 0.05;
/// Largest conductance as a multiple of the mean: needle triangles then do not merge their vertices.
const CEILING: f64 = 20.0;

/// An edge graph with one weight per directed edge, symmetric.
pub(super) struct WeightedEdges {
    pub graph: EdgeGraph,
    /// Weights by directed edge.
    pub weights: Vec<f64>,
    /// `(a, b) → c`: around `a`, counter-clockwise seen from outside, `c` follows `b`.
    following: BTreeMap<(u32, u32), u32>,
}

impl WeightedEdges {
    /// Cotangent weights (Pinkall, Polthier 1993), clamped between the two limits. On quads the weights are the mean
    /// over both triangulations without the diagonals, which gives every edge of a square grid the same weight, as in
    /// Brechbühler et al.
    pub(super) fn new(mesh: &SurfaceMesh) -> Result<Self, HarmonicsError> {
        let graph = mesh.edge_graph();
        if let Some(vertex) = (0..graph.n_vertices()).find(|&v| graph.neighbors(v).is_empty()) {
            return Err(HarmonicsError::UnusedVertex { vertex: vertex as u32 });
        }
        let mut weights = vec![0.0; graph.n_directed_edges()];
        let mut following = BTreeMap::new();
        let v = mesh.vertices();
        for face in mesh.faces() {
            let n = face.len();
            for k in 0..n {
                let [a, b, before] = [face[k], face[(k + 1) % n], face[(k + n - 1) % n]];
                following.insert((a, b), before);
                let opposite = |at: u32| half_cotangent(&v[at as usize], &v[a as usize], &v[b as usize]);
                let weight = match mesh.arity() {
                    FaceArity::Triangle => opposite(before),
                    // Each edge lies in one triangle of each of the two triangulations.
                    FaceArity::Quad => (opposite(before) + opposite(face[(k + 2) % n])) / 2.0,
                };
                for (from, to) in [(a, b), (b, a)] {
                    let row = graph.row(from as usize);
                    // Rows are sorted and hold every edge of a face, so the search cannot miss.
                    let at = graph.neighbors(from as usize).binary_search(&to).unwrap_or_default();
                    weights[row.start + at] += weight;
                }
            }
        }
        let mean = weights.iter().map(|w| w.max(0.0)).sum::<f64>() / weights.len() as f64;
        for w in &mut weights {
            *w = w.clamp(FLOOR * mean, CEILING * mean);
        }
        Ok(WeightedEdges { graph, weights, following })
    }

    /// Number of vertices.
    pub(super) fn n_vertices(&self) -> usize {
        self.graph.n_vertices()
    }

    /// The neighbors of `vertex` with their weights.
    pub(super) fn neighbors(&self, vertex: usize) -> impl Iterator<Item = (usize, f64)> {
        self.graph.row(vertex).map(|e| (self.graph.head(e), self.weights[e]))
    }

    /// The neighbors of `at` strictly between `from` and `to`, counter-clockwise seen from outside.
    pub(super) fn between(&self, at: u32, from: u32, to: u32) -> Vec<u32> {
        let mut found = Vec::new();
        let mut neighbor = from;
        // A closed manifold gives every vertex one cycle of neighbors; the bound ends the walk on anything else.
        for _ in 0..self.graph.neighbors(at as usize).len() {
            match self.following.get(&(at, neighbor)) {
                Some(&next) if next != to => {
                    found.push(next);
                    neighbor = next;
                }
                _ => break,
            }
        }
        found
    }
}

/// Half the cotangent of the angle at `at` between the directions to `a` and `b`; 0 where the triangle has no area.
fn half_cotangent(at: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let (u, v) = (a - at, b - at);
    let twice_area = u.cross(&v).norm();
    if twice_area > 0.0 { u.dot(&v) / (2.0 * twice_area) } else { 0.0 }
}
