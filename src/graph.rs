//! Edge graphs and the neighbourhoods `N_r` on them, in compressed rows. Knows no geometry.

/// Neighbours of every vertex; rows ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeGraph {
    offsets: Vec<u32>,
    neighbors: Vec<u32>,
}

impl EdgeGraph {
    /// The graph of `n` vertices with the given undirected edges, each named once.
    pub fn from_edges(n: usize, edges: &[[u32; 2]]) -> Self {
        let mut rows = vec![Vec::new(); n];
        for &[a, b] in edges {
            rows[a as usize].push(b);
            rows[b as usize].push(a);
        }
        let mut offsets = Vec::with_capacity(n + 1);
        let mut neighbors = Vec::with_capacity(2 * edges.len());
        offsets.push(0);
        for row in &mut rows {
            row.sort_unstable();
            neighbors.extend_from_slice(row);
            offsets.push(neighbors.len() as u32);
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

    /// Neighbours of `vertex`, ascending.
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

    /// The edges of which `N_r` counts `r`: `N_r(x)` is `N_1` taken `r` times.
    pub fn graph(&self) -> &EdgeGraph {
        &self.graph
    }

    /// The `r` of `N_r`.
    pub fn rings(&self) -> usize {
        self.rings
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
