//! Exact geodesic distances on a polyhedron between nearby vertices.
//!
//! A shortest path bends only at vertices (Mitchell, Mount, Papadimitriou, "The discrete geodesic problem", 1987), so
//! it is a chain of straight lines between vertices, each itself a shortest path. The straight lines from every vertex
//! are computed once ([`StraightLines`]); geodesics are shortest paths on the graph of these lines.

use super::dijkstra::Dijkstra;
use super::for_every_source;
use super::polyhedron::Polyhedron;
use super::straight::StraightLines;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::graph::LabelNeighborhoods;

/// Share by which lines are followed beyond a bound, so that rounding excludes no line that is needed.
const MARGIN: f64 = 1e-9;

/// For every label the geodesic distances, mm, to the members of its row. `bounds` holds an upper bound for each, such
/// as the length of a path along edges.
pub(super) fn geodesic_distances(
    mesh: &SurfaceMesh,
    labels: &LabelNeighborhoods,
    bounds: &[Vec<f64>],
) -> Vec<Vec<f64>> {
    let polyhedron = Polyhedron::new(mesh);
    let mut reach: Vec<f64> =
        bounds.iter().map(|row| (1.0 + MARGIN) * row.iter().fold(0.0f64, |a, &b| a.max(b))).collect();
    if mesh.arity() == FaceArity::Quad {
        let of_centers = mesh.faces().map(|f| f.iter().fold(0.0f64, |a, &v| a.max(reach[v as usize])));
        reach.append(&mut of_centers.collect());
    }
    let lines = for_every_source(
        polyhedron.vertices.len(),
        || StraightLines::new(&polyhedron),
        |straight, v| straight.from(&polyhedron, v as u32, reach[v]),
    );
    for_every_source(
        labels.n_labels(),
        || (Dijkstra::new(polyhedron.vertices.len()), StraightLines::new(&polyhedron)),
        |(search, straight), x| {
            search.distances_to(x as u32, labels.members(x), |v, distance, next| {
                let left = reach[x] - distance;
                // The bound of a vertex with shorter edges than x may be smaller than x needs.
                if left > reach[v as usize] {
                    next.append(&mut straight.from(&polyhedron, v, left));
                } else {
                    next.extend(lines[v as usize].iter().filter(|(_, length)| *length <= left));
                }
            })
        },
    )
}
