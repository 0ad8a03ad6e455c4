//! Distances along a surface between nearby vertices, which are the labels of the pairwise potential.
//!
//! [`label_neighborhoods`] fills `N_r` with one of three distances `d'` ([`LabelDistance`]), for which Euclidean ≤
//! geodesic ≤ graph, with equality on every edge. The geodesic distance is exact on the polyhedron, found by unfolding
//! faces (`straight.rs`) and joining straight pieces (`local.rs`). [`distances_from`] measures from a few places to all vertices.

mod dijkstra;
mod local;
mod paths;
mod polyhedron;
mod straight;
#[cfg(test)]
mod tests;

pub use paths::{distances_among, distances_from};

use dijkstra::{Dijkstra, WeightedGraph};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};
use rayon::prelude::*;

/// The distance `d'(x, y)` on the target that the pairwise potential compares with the length of a source edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LabelDistance {
    /// Straight through space.
    #[default]
    Euclidean,
    /// The shortest path along edges of the mesh; on a quad mesh, diagonals are not edges.
    Graph,
    /// The shortest path on the surface. A quad stands for the four triangles between its corners and their mean: the
    /// quad itself where it is flat, and no preferred diagonal where it is not. Exact on these faces; relative to the
    /// smooth surface that the mesh samples, the error falls with the square of the edge length.
    Geodesic,
}

/// Sources per task. Scratch memory is allocated once per task, so tasks must not be too small.
const CHUNK: usize = 64;

/// `N_rings` over the vertices of `mesh`, with the distance `d'` in mm chosen by [`LabelDistance`]; exactly symmetric,
/// 0 between a label and itself.
///
/// # Cost
/// With `k̄` labels a neighborhood: `O(n k̄)` Euclidean, `O(n k̄ log k̄)` graph, about `O(n k̄^1.5)` geodesic, on all
/// threads. Every label is computed independently, so any number of threads gives the same bits.
pub fn label_neighborhoods(mesh: &SurfaceMesh, rings: usize, distance: LabelDistance) -> LabelNeighborhoods {
    let graph = mesh.edge_graph();
    let p = mesh.vertices();
    let euclidean = LabelNeighborhoods::new(&graph, rings, |x, y| (p[x] - p[y]).norm());
    let rows = match distance {
        LabelDistance::Euclidean => return euclidean,
        LabelDistance::Graph => graph_distances(&WeightedGraph::new(graph.clone(), p), &euclidean),
        LabelDistance::Geodesic => {
            let bounds = graph_distances(&WeightedGraph::new(graph.clone(), p), &euclidean);
            local::geodesic_distances(mesh, &euclidean, &bounds)
        }
    };
    let one_way = |x: usize, y: usize| {
        // Neighborhoods are symmetric, so y is always in the row of x.
        let at = euclidean.members(x).binary_search(&(y as u32)).unwrap_or_default();
        rows[x][at]
    };
    // The two directions differ by rounding only; their mean is the same for both.
    LabelNeighborhoods::new(&graph, rings, |x, y| (one_way(x, y) + one_way(y, x)) / 2.0)
}

/// Length of every directed edge of `graph`, the edge graph of `mesh`, mm: `ℓ_ij` of the source.
///
/// One function serves all variants of [`LabelDistance`]: an edge is straight in space and lies on the surface, on
/// quads too, so no path between its ends is shorter.
///
/// Cost `O(edges)`.
pub fn edge_lengths(mesh: &SurfaceMesh, graph: &EdgeGraph) -> Vec<f32> {
    let p = mesh.vertices();
    (0..graph.n_vertices())
        .flat_map(|i| graph.neighbors(i).iter().map(move |&j| (p[i] - p[j as usize]).norm() as f32))
        .collect()
}

/// For every label the lengths of the shortest paths along edges to the members of its row; paths may leave the row.
fn graph_distances(edges: &WeightedGraph, labels: &LabelNeighborhoods) -> Vec<Vec<f64>> {
    for_every_source(
        labels.n_labels(),
        || Dijkstra::new(labels.n_labels()),
        |search, x| search.distances_to(x as u32, labels.members(x), |v, _, next| edges.append_neighbors(v, next)),
    )
}

/// `result(scratch, source)` for every source, in order, on all threads; scratch memory is shared only within a chunk.
fn for_every_source<S, T: Send>(
    n_sources: usize,
    scratch: impl Fn() -> S + Sync,
    result: impl Fn(&mut S, usize) -> T + Sync,
) -> Vec<T> {
    (0..n_sources.div_ceil(CHUNK))
        .into_par_iter()
        .flat_map_iter(|chunk| {
            let mut scratch = scratch();
            let sources = chunk * CHUNK..n_sources.min((chunk + 1) * CHUNK);
            sources.map(|source| result(&mut scratch, source)).collect::<Vec<T>>()
        })
        .collect()
}
