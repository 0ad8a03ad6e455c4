//! Shortest paths on weighted graphs from many sources, with reused scratch memory.
//!
//! Source: Dijkstra, "A note on two problems in connexion with graphs", 1959, stopped as soon as all targets are
//! reached.

use homolog_primitives::graph::EdgeGraph;
use nalgebra::Point3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// An edge graph with the lengths of its edges.
pub(super) struct WeightedGraph {
    graph: EdgeGraph,
    lengths: Vec<f64>,
}

impl WeightedGraph {
    /// `graph` over `vertices`, mm.
    pub(super) fn new(graph: EdgeGraph, vertices: &[Point3<f64>]) -> Self {
        let mut lengths = Vec::with_capacity(graph.n_directed_edges());
        for (i, p) in vertices.iter().enumerate() {
            lengths.extend(graph.neighbors(i).iter().map(|&j| (vertices[j as usize] - p).norm()));
        }
        WeightedGraph { graph, lengths }
    }

    /// Appends the neighbors of `vertex`, with the lengths of the edges to them.
    pub(super) fn append_neighbors(&self, vertex: u32, next: &mut Vec<(u32, f64)>) {
        let lengths = &self.lengths[self.graph.row(vertex as usize)];
        next.extend(self.graph.neighbors(vertex as usize).iter().copied().zip(lengths.iter().copied()));
    }
}

/// Scratch memory of a search, as large as the graph; reset between searches.
pub(super) struct Dijkstra {
    distance: Vec<f64>,
    settled: Vec<bool>,
    reached: Vec<u32>,
    // Non-negative distances compare like their bit patterns.
    queue: BinaryHeap<Reverse<(u64, u32)>>,
    next: Vec<(u32, f64)>,
}

impl Dijkstra {
    pub(super) fn new(n_vertices: usize) -> Self {
        Dijkstra {
            distance: vec![f64::INFINITY; n_vertices],
            settled: vec![false; n_vertices],
            reached: Vec::new(),
            queue: BinaryHeap::new(),
            next: Vec::new(),
        }
    }

    /// Calls `settled(vertex, distance)` in ascending order of distance from `source`, until it returns `false` or no
    /// vertex is left. `neighbors(vertex, distance, next)` appends the neighbors of a vertex and their distances from
    /// it.
    pub(super) fn visit(
        &mut self,
        source: u32,
        mut neighbors: impl FnMut(u32, f64, &mut Vec<(u32, f64)>),
        mut settled: impl FnMut(u32, f64) -> bool,
    ) {
        self.reach(source, 0.0);
        while let Some(Reverse((bits, vertex))) = self.queue.pop() {
            if self.settled[vertex as usize] {
                continue;
            }
            self.settled[vertex as usize] = true;
            let distance = f64::from_bits(bits);
            if !settled(vertex, distance) {
                break;
            }
            let mut next = std::mem::take(&mut self.next);
            neighbors(vertex, distance, &mut next);
            for (neighbor, length) in next.drain(..) {
                self.reach(neighbor, distance + length);
            }
            self.next = next;
        }
        self.queue.clear();
        for vertex in self.reached.drain(..) {
            self.distance[vertex as usize] = f64::INFINITY;
            self.settled[vertex as usize] = false;
        }
    }

    /// Distances from `source` to `targets` (ascending); infinite for unreachable targets.
    pub(super) fn distances_to(
        &mut self,
        source: u32,
        targets: &[u32],
        neighbors: impl FnMut(u32, f64, &mut Vec<(u32, f64)>),
    ) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; targets.len()];
        let mut n_missing = targets.len();
        self.visit(source, neighbors, |vertex, distance| {
            if let Ok(at) = targets.binary_search(&vertex) {
                distances[at] = distance;
                n_missing -= 1;
            }
            n_missing > 0
        });
        distances
    }

    fn reach(&mut self, vertex: u32, distance: f64) {
        let known = &mut self.distance[vertex as usize];
        if distance < *known {
            if *known == f64::INFINITY {
                self.reached.push(vertex);
            }
            *known = distance;
            self.queue.push(Reverse((distance.to_bits(), vertex)));
        }
    }
}
