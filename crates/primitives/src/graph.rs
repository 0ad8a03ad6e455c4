//! Edge graphs and the neighborhoods `N_r` on them, in compressed rows. Knows no geometry.

/// Neighbors of every vertex; rows ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeGraph {
    offsets: Vec<u32>,
    neighbors: Vec<u32>,
}

impl EdgeGraph {
    /// The graph of `n` vertices with the given undirected edges, each named once.
    pub fn from_edges(n: usize, edges: &[[u32; 2]]) -> Self {
        let mut offsets = vec![0u32; n + 1];
        for &[a, b] in edges {
            offsets[a as usize + 1] += 1;
            offsets[b as usize + 1] += 1;
        }
        for i in 0..n {
            offsets[i + 1] += offsets[i];
        }
        let mut neighbors = vec![0u32; 2 * edges.len()];
        let mut ends = offsets.clone();
        for &[a, b] in edges {
            for (from, to) in [(a, b), (b, a)] {
                let end = &mut ends[from as usize];
                neighbors[*end as usize] = to;
                *end += 1;
            }
        }
        for i in 0..n {
            neighbors[offsets[i] as usize..offsets[i + 1] as usize].sort_unstable();
        }
        EdgeGraph { offsets, neighbors }
    }

    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of directed edges `|E→|`, twice the undirected ones.
    pub fn n_directed_edges(&self) -> usize {
        self.neighbors.len()
    }

    /// Neighbors of `vertex`, ascending.
    pub fn neighbors(&self, vertex: usize) -> &[u32] {
        &self.neighbors[self.row(vertex)]
    }

    /// The directed edges that leave `vertex`, as a range of edge ids; edge `e` ends at [`EdgeGraph::head`]`(e)`.
    pub fn row(&self, vertex: usize) -> std::ops::Range<usize> {
        self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize
    }

    /// The vertex at which directed edge `edge` ends.
    pub fn head(&self, edge: usize) -> usize {
        self.neighbors[edge] as usize
    }

    /// For every directed edge `i → j` the id of `j → i`.
    pub fn reverse_edges(&self) -> Vec<u32> {
        let mut reverse = vec![0; self.neighbors.len()];
        for i in 0..self.n_vertices() {
            for e in self.row(i) {
                let row = self.row(self.head(e));
                // Rows are sorted and every edge has its reverse, so the search cannot miss.
                let at = self.neighbors[row.clone()].binary_search(&(i as u32)).unwrap_or_default();
                reverse[e] = (row.start + at) as u32;
            }
        }
        reverse
    }
}

/// Tells whether two vertices lie within `r` edges of each other by searching the graph. It needs no memory and suits
/// callers that test a few pairs; [`LabelNeighborhoods`] stores the answers for many tests.
#[derive(Debug, Clone, Copy)]
pub struct Reach<'a> {
    /// The graph that is searched.
    pub graph: &'a EdgeGraph,
    /// Radius `r`, edges.
    pub rings: usize,
}

impl Reach<'_> {
    /// Whether `y` is in `N_r(x)`. Cost `O(k^(r−1))` for `k` neighbors per vertex; less if the two are close.
    pub fn within(&self, x: u32, y: u32) -> bool {
        let Reach { graph, rings } = *self;
        let of_x = graph.neighbors(x as usize);
        match rings {
            _ if x == y => true,
            0 => false,
            1 => of_x.contains(&y),
            2 => of_x.contains(&y) || share_a_member(of_x, graph.neighbors(y as usize)),
            _ => of_x.iter().any(|&z| Reach { graph, rings: rings - 1 }.within(z, y)),
        }
    }
}

/// Whether two ascending lists have a member in common.
fn share_a_member(a: &[u32], b: &[u32]) -> bool {
    let mut rest = b.iter().peekable();
    a.iter().any(|x| {
        while rest.next_if(|y| *y < x).is_some() {}
        rest.peek() == Some(&x)
    })
}

/// `N_r(x)` for every vertex `x`: the vertices within `r` edges of it, itself included, with a distance for each.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelNeighborhoods {
    graph: EdgeGraph,
    rings: usize,
    offsets: Vec<u32>,
    members: Vec<u32>,
    distances: Vec<f32>,
}

impl LabelNeighborhoods {
    /// `N_rings` over `graph`, with `distance(x, y)` for every member `y` of the row of `x`.
    ///
    /// Cost `O(n k̄ log k̄)` for `k̄` members a row. `distance` must be symmetric and `0` for `x = y`.
    pub fn new(graph: &EdgeGraph, rings: usize, mut distance: impl FnMut(usize, usize) -> f64) -> Self {
        let n = graph.n_vertices();
        let mut offsets = Vec::with_capacity(n + 1);
        let mut members: Vec<u32> = Vec::new();
        let mut distances = Vec::new();
        let mut seen = vec![u32::MAX; n];
        offsets.push(0);
        for x in 0..n {
            let start = members.len();
            members.push(x as u32);
            seen[x] = x as u32;
            let mut frontier = start;
            for _ in 0..rings {
                let end = members.len();
                for at in frontier..end {
                    for &y in graph.neighbors(members[at] as usize) {
                        if seen[y as usize] != x as u32 {
                            seen[y as usize] = x as u32;
                            members.push(y);
                        }
                    }
                }
                frontier = end;
            }
            members[start..].sort_unstable();
            distances.extend(members[start..].iter().map(|&y| distance(x, y as usize) as f32));
            offsets.push(members.len() as u32);
        }
        LabelNeighborhoods { graph: graph.clone(), rings, offsets, members, distances }
    }

    /// Number of labels `n`.
    pub fn n_labels(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The graph whose edges define `N_1`; `N_r(x)` applies `N_1` `r` times.
    pub fn graph(&self) -> &EdgeGraph {
        &self.graph
    }

    /// Radius `r`, edges.
    pub fn rings(&self) -> usize {
        self.rings
    }

    /// The same neighborhoods, tested by a search of the graph.
    pub fn reach(&self) -> Reach<'_> {
        Reach { graph: &self.graph, rings: self.rings }
    }

    /// Members of `N_r(label)`, ascending.
    pub fn members(&self, label: usize) -> &[u32] {
        &self.members[self.range(label)]
    }

    /// Distances `d'(label, member)` in the order of [`LabelNeighborhoods::members`].
    pub fn distances(&self, label: usize) -> &[f32] {
        &self.distances[self.range(label)]
    }

    /// `d'(x, y)` if `y` is in `N_r(x)`.
    pub fn distance_within(&self, x: usize, y: usize) -> Option<f32> {
        let at = self.members(x).binary_search(&(y as u32)).ok()?;
        Some(self.distances(x)[at])
    }

    /// Mean number of members `k̄`.
    pub fn mean_size(&self) -> f64 {
        self.members.len() as f64 / self.n_labels().max(1) as f64
    }

    fn range(&self, label: usize) -> std::ops::Range<usize> {
        self.offsets[label] as usize..self.offsets[label + 1] as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn reach_agrees_with_the_stored_neighborhoods(
            pairs in prop::collection::btree_set((0u32..40, 0u32..40), 0..90),
            rings in 0usize..5,
        ) {
            let edges: BTreeSet<[u32; 2]> =
                pairs.into_iter().filter(|(a, b)| a != b).map(|(a, b)| [a.min(b), a.max(b)]).collect();
            let graph = EdgeGraph::from_edges(40, &edges.into_iter().collect::<Vec<_>>());
            let labels = LabelNeighborhoods::new(&graph, rings, |_, _| 0.0);
            for x in 0..40 {
                for y in 0..40 {
                    let stored = labels.distance_within(x, y).is_some();
                    prop_assert_eq!(labels.reach().within(x as u32, y as u32), stored, "{} {}", x, y);
                }
            }
        }

        #[test]
        fn rows_hold_the_other_ends_of_the_edges_ascending(
            pairs in prop::collection::btree_set((0u32..30, 0u32..30), 0..120),
            reversed: bool,
        ) {
            let once: BTreeSet<[u32; 2]> =
                pairs.into_iter().filter(|(a, b)| a != b).map(|(a, b)| [a.min(b), a.max(b)]).collect();
            let mut edges: Vec<[u32; 2]> = once.into_iter().collect();
            if reversed {
                edges.reverse();
                edges.iter_mut().step_by(2).for_each(|e| e.reverse());
            }
            let graph = EdgeGraph::from_edges(30, &edges);
            prop_assert_eq!((graph.n_vertices(), graph.n_directed_edges()), (30, 2 * edges.len()));
            for i in 0..30 {
                let mut expected: Vec<u32> = edges
                    .iter()
                    .filter(|e| e.contains(&i))
                    .map(|&[a, b]| if a == i { b } else { a })
                    .collect();
                expected.sort_unstable();
                prop_assert_eq!(graph.neighbors(i as usize), &expected);
            }
        }
    }
}
