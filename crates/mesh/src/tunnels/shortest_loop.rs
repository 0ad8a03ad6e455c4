//! The shortest loop of edges that does not separate a closed surface.
//!
//! A spanning tree of the vertices, and a spanning tree of the faces that crosses none of its edges, leave `2·genus`
//! edges (tree-cotree decomposition). Each of these edges closes a loop in the tree of the faces. The numbers, modulo
//! 2, of crossings between a loop of edges and these `2·genus` loops form the homology class of the loop of edges. A
//! simple loop separates the surface exactly if its class is zero.
//!
//! Every edge therefore gets a signature, and the signatures along a loop add up to its class. A loop that does not
//! separate has an edge with a nonzero signature, so a search from one end of each such edge finds the shortest. A
//! search from a vertex ends at half the length of the shortest loop so far.
//!
//! Random words of 64 bits replace the `2·genus` bits of a signature: a nonzero class is missed with a probability of
//! 2⁻⁶⁴.
//!
//! # Source
//! Eppstein, "Dynamic generators of topologically embedded graphs", SODA 2003 (tree-cotree); Erickson and Whittlesey, "Greedy
//! optimal homotopy and homology generators", SODA 2005; Cabello and Mohar, "Finding shortest non-separating and
//! non-contractible cycles for topologically embedded graphs", Discrete & Computational Geometry 37, 2007 (the search from a
//! vertex).

use nalgebra::Point3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// A simple loop of edges.
pub(super) struct Loop {
    /// Its vertices in order.
    pub(super) vertices: Vec<u32>,
    /// Its length, mm.
    pub(super) length_mm: f64,
}

const NONE: u32 = u32::MAX;

/// The shortest loop that does not separate the surface, a closed oriented manifold of `triangles`; `None` if every
/// loop separates it. The vertices `caps` are the middles of fans that cover boundaries: no loop goes through them,
/// unless `effort` is used up.
///
/// `effort` limits the number of vertices reached; when it is used up, the shortest loop so far is returned.
///
/// # Cost
/// `O(n log n)`, and a bounded search around each of `O(genus · √n)` vertices.
pub(super) fn shortest_loop(
    vertices: &[Point3<f64>],
    triangles: &[[u32; 3]],
    caps: &Range<u32>,
    effort: &mut u64,
) -> Option<Loop> {
    let net = Net::new(vertices, triangles, caps);
    let mut search = Search::new(vertices.len());
    let whole = Tree::spanning(&net, &mut search);
    *effort = effort.saturating_sub(vertices.len() as u64);
    let signatures = signatures(&net, &whole, triangles.len());
    let signed: Vec<u32> = (0..net.edges.len() as u32).filter(|&e| signatures[e as usize] != 0).collect();

    // Each signed edge closes a loop with the tree, which gives a first bound.
    let mut best: Option<Loop> = None;
    for &e in &signed {
        shorter(&mut best, whole.closed_by(&net, e));
    }
    let mut bases: Vec<u32> = signed.iter().map(|&e| net.edges[e as usize].ends[0]).collect();
    bases.sort_unstable();
    bases.dedup();
    for base in bases {
        if *effort == 0 {
            break;
        }
        let reached = search.around(&net, &signatures, base, &mut best);
        *effort = effort.saturating_sub(reached);
    }
    best
}

fn shorter(best: &mut Option<Loop>, found: Loop) {
    if best.as_ref().is_none_or(|best| found.length_mm < best.length_mm) {
        *best = Some(found);
    }
}

struct Edge {
    ends: [u32; 2],
    faces: [u32; 2],
    length: f64,
}

/// The edges of a surface, and the edges at each vertex.
struct Net {
    edges: Vec<Edge>,
    starts: Vec<u32>,
    at_vertex: Vec<u32>,
}

impl Net {
    fn new(vertices: &[Point3<f64>], triangles: &[[u32; 3]], caps: &Range<u32>) -> Self {
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (f, t) in (0u32..).zip(triangles) {
            for k in 0..3 {
                let (a, b) = (t[k], t[(k + 1) % 3]);
                sides.push(([a.min(b), a.max(b)], f));
            }
        }
        sides.sort_unstable();
        let length = |[a, b]: [u32; 2]| (vertices[a as usize] - vertices[b as usize]).norm();
        let pairs = sides.chunk_by(|a, b| a.0 == b.0).filter(|uses| uses.len() == 2);
        let mut edges: Vec<Edge> = pairs
            .map(|uses| Edge { ends: uses[0].0, faces: [uses[0].1, uses[1].1], length: length(uses[0].0) })
            .collect();
        if !caps.is_empty() {
            // Longer than any loop without caps. Every class has such a loop, because the covered parts are disks.
            let longer = 1.0 + edges.iter().map(|edge| edge.length).sum::<f64>();
            let of_caps = edges.iter_mut().filter(|edge| edge.ends.iter().any(|v| caps.contains(v)));
            of_caps.for_each(|edge| edge.length = longer);
        }
        let mut starts = vec![0u32; vertices.len() + 1];
        edges.iter().flat_map(|e| e.ends).for_each(|v| starts[v as usize + 1] += 1);
        for v in 0..vertices.len() {
            starts[v + 1] += starts[v];
        }
        let mut filled = starts.clone();
        let mut at_vertex = vec![0; 2 * edges.len()];
        for (e, edge) in (0u32..).zip(&edges) {
            for v in edge.ends {
                at_vertex[filled[v as usize] as usize] = e;
                filled[v as usize] += 1;
            }
        }
        Net { edges, starts, at_vertex }
    }

    fn edges_at(&self, v: u32) -> &[u32] {
        &self.at_vertex[self.starts[v as usize] as usize..self.starts[v as usize + 1] as usize]
    }

    fn other_end(&self, e: u32, v: u32) -> u32 {
        let [a, b] = self.edges[e as usize].ends;
        if a == v { b } else { a }
    }
}

/// Shortest paths from one root per piece.
struct Tree {
    /// The edge towards the root; [`NONE`] for roots.
    parent: Vec<u32>,
    /// Number of edges to the root.
    depth: Vec<u32>,
}

impl Tree {
    fn spanning(net: &Net, search: &mut Search) -> Self {
        let n = net.starts.len() - 1;
        let mut tree = Tree { parent: vec![NONE; n], depth: vec![0; n] };
        let mut settled = vec![false; n];
        for root in 0..n as u32 {
            if settled[root as usize] {
                continue;
            }
            search.start(root);
            while let Some((v, _)) = search.settle(f64::INFINITY, net) {
                settled[v as usize] = true;
                let e = search.parent[v as usize];
                if e != NONE {
                    tree.parent[v as usize] = e;
                    tree.depth[v as usize] = tree.depth[net.other_end(e, v) as usize] + 1;
                }
            }
        }
        tree
    }

    /// The simple loop closed by an edge outside the tree.
    fn closed_by(&self, net: &Net, e: u32) -> Loop {
        let [a, b] = net.edges[e as usize].ends;
        closed(net, e, [a, b], |v| self.depth[v as usize], |v| self.parent[v as usize])
    }
}

/// The simple loop of the edge `e` and the paths from its ends to their first common vertex.
fn closed(net: &Net, e: u32, ends: [u32; 2], depth: impl Fn(u32) -> u32, parent: impl Fn(u32) -> u32) -> Loop {
    let [mut a, mut b] = ends;
    let (mut left, mut right) = (vec![a], vec![b]);
    let mut length_mm = net.edges[e as usize].length;
    while a != b {
        let (v, path) = if depth(a) >= depth(b) { (&mut a, &mut left) } else { (&mut b, &mut right) };
        let up = parent(*v);
        length_mm += net.edges[up as usize].length;
        *v = net.other_end(up, *v);
        path.push(*v);
    }
    // Both paths end at the common vertex.
    right.pop();
    left.extend(right.into_iter().rev());
    Loop { vertices: left, length_mm }
}

/// The signature of each edge.
fn signatures(net: &Net, tree: &Tree, n_faces: usize) -> Vec<u64> {
    let mut in_tree = vec![false; net.edges.len()];
    tree.parent.iter().filter(|&&e| e != NONE).for_each(|&e| in_tree[e as usize] = true);
    let mut starts = vec![0u32; n_faces + 1];
    net.edges.iter().flat_map(|e| e.faces).for_each(|f| starts[f as usize + 1] += 1);
    for f in 0..n_faces {
        starts[f + 1] += starts[f];
    }
    let mut filled = starts.clone();
    let mut at_face = vec![0u32; 2 * net.edges.len()];
    for (e, edge) in (0u32..).zip(&net.edges) {
        for f in edge.faces {
            at_face[filled[f as usize] as usize] = e;
            filled[f as usize] += 1;
        }
    }
    // The tree of the faces, breadth first for short paths.
    let (mut parent, mut reached) = (vec![NONE; n_faces], vec![false; n_faces]);
    let mut used = vec![false; net.edges.len()];
    let mut queue: Vec<u32> = Vec::with_capacity(n_faces);
    for root in 0..n_faces as u32 {
        if reached[root as usize] {
            continue;
        }
        reached[root as usize] = true;
        let mut next = queue.len();
        queue.push(root);
        while let Some(&f) = queue.get(next) {
            next += 1;
            for &e in &at_face[starts[f as usize] as usize..starts[f as usize + 1] as usize] {
                let [a, b] = net.edges[e as usize].faces;
                let other = if a == f { b } else { a };
                if !in_tree[e as usize] && !reached[other as usize] {
                    reached[other as usize] = true;
                    used[e as usize] = true;
                    parent[other as usize] = e;
                    queue.push(other);
                }
            }
        }
    }
    let mut signatures = vec![0u64; net.edges.len()];
    let left_over = (0..net.edges.len()).filter(|&e| !in_tree[e] && !used[e]);
    for (k, e) in (1u64..).zip(left_over) {
        let word = mixed(k);
        signatures[e] ^= word;
        // The common part of both paths cancels out.
        for mut f in net.edges[e].faces {
            while parent[f as usize] != NONE {
                let up = parent[f as usize];
                signatures[up as usize] ^= word;
                let [a, b] = net.edges[up as usize].faces;
                f = if a == f { b } else { a };
            }
        }
    }
    signatures
}

/// The `k`-th word of a random sequence (SplitMix64).
fn mixed(k: u64) -> u64 {
    let mut x = k.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

/// Dijkstra's algorithm with memory that is reused between searches.
struct Search {
    distance: Vec<f64>,
    parent: Vec<u32>,
    depth: Vec<u32>,
    class: Vec<u64>,
    settled: Vec<bool>,
    touched: Vec<u32>,
    /// Bits of a non-negative distance, and the vertex.
    queue: BinaryHeap<Reverse<(u64, u32)>>,
}

impl Search {
    fn new(n: usize) -> Self {
        Search {
            distance: vec![f64::INFINITY; n],
            parent: vec![NONE; n],
            depth: vec![0; n],
            class: vec![0; n],
            settled: vec![false; n],
            touched: Vec::new(),
            queue: BinaryHeap::new(),
        }
    }

    fn start(&mut self, root: u32) {
        for v in self.touched.drain(..) {
            let v = v as usize;
            (self.distance[v], self.parent[v], self.settled[v]) = (f64::INFINITY, NONE, false);
        }
        self.queue.clear();
        self.distance[root as usize] = 0.0;
        (self.depth[root as usize], self.class[root as usize]) = (0, 0);
        self.touched.push(root);
        self.queue.push(Reverse((0, root)));
    }

    /// The next vertex within `radius`, and its distance.
    fn settle(&mut self, radius: f64, net: &Net) -> Option<(u32, f64)> {
        let (v, distance) = loop {
            let Reverse((bits, v)) = self.queue.pop()?;
            if !self.settled[v as usize] {
                break (v, f64::from_bits(bits));
            }
        };
        self.settled[v as usize] = true;
        for &e in net.edges_at(v) {
            let other = net.other_end(e, v);
            let through = distance + net.edges[e as usize].length;
            if through < self.distance[other as usize] && through <= radius {
                if self.distance[other as usize] == f64::INFINITY {
                    self.touched.push(other);
                }
                self.distance[other as usize] = through;
                self.parent[other as usize] = e;
                self.queue.push(Reverse((through.to_bits(), other)));
            }
        }
        Some((v, distance))
    }

    /// Looks for a shorter loop through `base`; returns the number of vertices reached.
    fn around(&mut self, net: &Net, signatures: &[u64], base: u32, best: &mut Option<Loop>) -> u64 {
        let mut reached = 0;
        self.start(base);
        loop {
            let limit = best.as_ref().map_or(f64::INFINITY, |best| best.length_mm);
            let Some((v, distance)) = self.settle(limit / 2.0, net) else { break };
            reached += 1;
            let up = self.parent[v as usize];
            if up != NONE {
                let before = net.other_end(up, v) as usize;
                self.class[v as usize] = self.class[before] ^ signatures[up as usize];
                self.depth[v as usize] = self.depth[before] + 1;
            }
            for &e in net.edges_at(v) {
                let other = net.other_end(e, v);
                if e == up || !self.settled[other as usize] || self.parent[other as usize] == e {
                    continue;
                }
                let length = distance + self.distance[other as usize] + net.edges[e as usize].length;
                let class = self.class[v as usize] ^ self.class[other as usize] ^ signatures[e as usize];
                if class != 0 && best.as_ref().is_none_or(|best| length < best.length_mm) {
                    let (depth, parent) = (&self.depth, &self.parent);
                    shorter(best, closed(net, e, [v, other], |v| depth[v as usize], |v| parent[v as usize]));
                }
            }
        }
        reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{ellipsoid, torus};
    use crate::{FaceArity, SurfaceMesh};
    use nalgebra::Vector3;
    use proptest::prelude::*;

    /// Whether cutting along a loop of edges leaves the faces connected.
    fn leaves_in_one_piece(mesh: &SurfaceMesh, around: &[u32]) -> bool {
        let n = around.len();
        let cut: std::collections::HashSet<[u32; 2]> =
            (0..n).map(|k| (around[k], around[(k + 1) % n])).map(|(a, b)| [a.min(b), a.max(b)]).collect();
        let net = Net::new(mesh.vertices(), &mesh.triangles(), &(0..0));
        let mut of: Vec<usize> = (0..mesh.n_faces()).collect();
        fn root(of: &mut [usize], mut k: usize) -> usize {
            while of[k] != k {
                of[k] = of[of[k]];
                k = of[k];
            }
            k
        }
        for e in net.edges.iter().filter(|e| !cut.contains(&e.ends)) {
            let [a, b] = e.faces.map(|f| root(&mut of, f as usize));
            of[a] = b;
        }
        let roots: Vec<usize> = (0..of.len()).map(|k| root(&mut of, k)).collect();
        roots.iter().all(|&r| r == roots[0])
    }

    /// The length of the shortest loop that does not separate, the slow way: builds a tree of shortest paths for each
    /// vertex, and cuts along the loop that each further edge closes.
    fn slow(mesh: &SurfaceMesh) -> f64 {
        let net = Net::new(mesh.vertices(), &mesh.triangles(), &(0..0));
        let mut best = f64::INFINITY;
        for base in 0..mesh.n_vertices() as u32 {
            let mut search = Search::new(mesh.n_vertices());
            search.start(base);
            let mut order = Vec::new();
            while let Some((v, _)) = search.settle(f64::INFINITY, &net) {
                order.push(v);
                let up = search.parent[v as usize];
                if up != NONE {
                    search.depth[v as usize] = search.depth[net.other_end(up, v) as usize] + 1;
                }
            }
            for e in 0..net.edges.len() as u32 {
                let [a, b] = net.edges[e as usize].ends;
                if search.parent[a as usize] == e || search.parent[b as usize] == e {
                    continue;
                }
                let found = closed(&net, e, [a, b], |v| search.depth[v as usize], |v| search.parent[v as usize]);
                if found.length_mm < best && leaves_in_one_piece(mesh, &found.vertices) {
                    best = found.length_mm;
                }
            }
        }
        best
    }

    #[test]
    fn a_sphere_has_no_such_loop() {
        let ball = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3);
        assert!(shortest_loop(ball.vertices(), &ball.triangles(), &(0..0), &mut u64::MAX.clone()).is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]
        #[test]
        fn the_loop_is_as_short_as_the_slow_search_finds_it(
            around in 5u32..9, across in 4u32..8, tube in 0.5f64..4.0, noise in prop::collection::vec(-0.3f64..0.3, 3 * 72),
        ) {
            let ring = torus(5.0, tube, around, across, FaceArity::Triangle);
            let moved = ring.vertices().iter().enumerate();
            let moved = moved.map(|(k, p)| p + Vector3::from_fn(|r, _| noise[(3 * k + r) % noise.len()])).collect();
            let ring = ring.with_vertices(moved).unwrap();
            let found = shortest_loop(ring.vertices(), &ring.triangles(), &(0..0), &mut u64::MAX.clone()).unwrap();
            prop_assert!(leaves_in_one_piece(&ring, &found.vertices));
            let mut once = found.vertices.clone();
            once.sort_unstable();
            once.dedup();
            prop_assert_eq!(once.len(), found.vertices.len(), "a simple loop");
            prop_assert!((found.length_mm - slow(&ring)).abs() < 1e-9, "{} {}", found.length_mm, slow(&ring));
        }
    }
}
