//! An order of the vertices of a graph in which neighbours are near each other.
//!
//! What a kernel has read of a vertex is wanted again when it comes to the neighbours. Breadth first from one end of a
//! surface to the other, no two neighbours are farther apart than two fronts of the walk are long, about `√n`, and less
//! on surfaces that are longer than wide. Along a space-filling curve most are nearer, but some half the surface away,
//! and those then come from a slower memory.
//!
//! Source: Cuthill, McKee 1969; the start by George, Liu 1979.

use crate::graph::EdgeGraph;

/// The vertices of `graph` in an order of small bandwidth, each once. Cost `O(n + |E|)`, a few walks.
pub(super) fn narrow_order(graph: &EdgeGraph) -> Vec<u32> {
    let n = graph.n_vertices();
    let mut order = Vec::with_capacity(n);
    let mut seen = vec![false; n];
    for vertex in 0..n {
        if seen[vertex] {
            continue;
        }
        // The vertex reached last is at an end of its component, or twice so nearly.
        let mut start = vertex as u32;
        for _ in 0..2 {
            let walk = breadth_first(graph, start, &mut seen);
            for &reached in &walk {
                seen[reached as usize] = false;
            }
            start = walk.last().copied().unwrap_or(start);
        }
        order.extend(breadth_first(graph, start, &mut seen));
    }
    order
}

/// The vertices reached from `start` that are not `seen`, which they then are.
fn breadth_first(graph: &EdgeGraph, start: u32, seen: &mut [bool]) -> Vec<u32> {
    let mut walk = vec![start];
    seen[start as usize] = true;
    let mut done = 0;
    while done < walk.len() {
        let first_new = walk.len();
        for &neighbor in graph.neighbors(walk[done] as usize) {
            if !seen[neighbor as usize] {
                seen[neighbor as usize] = true;
                walk.push(neighbor);
            }
        }
        walk[first_new..].sort_by_key(|&vertex| graph.neighbors(vertex as usize).len());
        done += 1;
    }
    walk
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_order_has_every_vertex_once(edges in prop::collection::btree_set((0u32..40, 0u32..40), 0..60)) {
            let edges: Vec<[u32; 2]> = edges.into_iter().filter(|(a, b)| a < b).map(|(a, b)| [a, b]).collect();
            let mut order = narrow_order(&EdgeGraph::from_edges(40, &edges));
            order.sort_unstable();
            prop_assert!(order.iter().enumerate().all(|(k, &vertex)| k == vertex as usize));
        }
    }

    /// A band of 6 × 50 vertices, numbered the long way.
    #[test]
    fn neighbors_are_a_front_apart_at_most() {
        let at = |x: u32, y: u32| 50 * y + x;
        let along = (0..6).flat_map(|y| (0..49).map(move |x| [at(x, y), at(x + 1, y)]));
        let across = (0..5).flat_map(|y| (0..50).map(move |x| [at(x, y), at(x, y + 1)]));
        let mut edges: Vec<[u32; 2]> = along.chain(across).collect();
        edges.sort_unstable();
        let graph = EdgeGraph::from_edges(300, &edges);
        let mut rank = [0; 300];
        for (k, vertex) in narrow_order(&graph).into_iter().enumerate() {
            rank[vertex as usize] = k;
        }
        assert!(edges.iter().all(|&[a, b]| rank[a as usize].abs_diff(rank[b as usize]) <= 12));
    }
}
