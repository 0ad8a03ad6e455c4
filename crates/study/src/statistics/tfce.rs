//! Threshold-free cluster enhancement on a mesh: the support of a vertex is the size of the region around it as the
//! threshold rises.
//!
//! The formula is `TFCE(v) = ∫₀^{h(v)} e(v, h)^E h^H dh`, where `e(v, h)` is the area, mm², of the connected region at
//! or above `h` that contains `v`. On surfaces `H = 2`, `E = 1`. The integral is exact: no region changes between the
//! values of two vertices, so the regions form a tree, which is built from the highest vertex down.
//!
//! Sources: Smith, Nichols, *Threshold-free cluster enhancement*, NeuroImage 44, 2009; exponents for surfaces as in PALM
//! (Winkler et al., NeuroImage 92, 2014).

use homolog_primitives::graph::EdgeGraph;

/// The exponent of the height.
const HEIGHT: i32 = 2;

/// Enhances maps over one mesh; scratch memory is kept between calls.
#[derive(Debug, Clone)]
pub struct Enhancer<'a> {
    graph: &'a EdgeGraph,
    areas: &'a [f64],
    order: Vec<u32>,
    parent: Vec<u32>,
    /// For a root: the total collected by every vertex of its region. For other vertices: the total minus that of the
    /// parent.
    sum: Vec<f64>,
    area: Vec<f64>,
    level: Vec<f64>,
    size: Vec<u32>,
}

const OUTSIDE: u32 = u32::MAX;

impl<'a> Enhancer<'a> {
    /// For maps over vertices that are neighbors in `graph` and have these areas, mm².
    pub fn new(graph: &'a EdgeGraph, areas: &'a [f64]) -> Self {
        let n = areas.len();
        let (order, parent) = ((0..n as u32).collect(), vec![OUTSIDE; n]);
        Enhancer {
            graph,
            areas,
            order,
            parent,
            sum: vec![0.0; n],
            area: vec![0.0; n],
            level: vec![0.0; n],
            size: vec![0; n],
        }
    }

    /// The enhanced map; negative values are enhanced like those of the opposite map, and stay negative.
    pub fn enhance(&mut self, map: &[f64]) -> Vec<f64> {
        let mut enhanced = vec![0.0; map.len()];
        for sign in [1.0, -1.0] {
            self.positive(map, sign, &mut enhanced);
        }
        enhanced
    }

    fn positive(&mut self, map: &[f64], sign: f64, into: &mut [f64]) {
        self.order.clear();
        self.order.extend((0..map.len() as u32).filter(|&v| sign * map[v as usize] > 0.0));
        // Equal values keep the order of vertices, so that sums have a fixed order.
        self.order
            .sort_unstable_by(|&a, &b| (sign * map[b as usize]).total_cmp(&(sign * map[a as usize])).then(a.cmp(&b)));
        self.parent.fill(OUTSIDE);
        for k in 0..self.order.len() {
            let v = self.order[k];
            let i = v as usize;
            let height = sign * map[i];
            (self.parent[i], self.sum[i], self.area[i], self.level[i], self.size[i]) =
                (v, 0.0, self.areas[i], height, 1);
            for at in 0..self.graph.neighbors(i).len() {
                let neighbor = self.graph.neighbors(i)[at];
                if self.parent[neighbor as usize] == OUTSIDE {
                    continue;
                }
                let (a, b) = (self.root(v), self.root(neighbor));
                if a != b {
                    self.settle(a, height);
                    self.settle(b, height);
                    self.join(a, b);
                }
            }
        }
        for k in 0..self.order.len() {
            let root = self.root(self.order[k]);
            self.settle(root, 0.0);
        }
        for k in 0..self.order.len() {
            let v = self.order[k];
            let root = self.root(v);
            // After halving, a vertex is a root or at most two steps away from one; its sum is collected along the way.
            let (mut total, mut at) = (self.sum[root as usize], v);
            while at != root {
                total += self.sum[at as usize];
                at = self.parent[at as usize];
            }
            into[v as usize] += sign * total;
        }
    }

    /// The region of a vertex, with path halving that keeps sums along the way.
    fn root(&mut self, mut v: u32) -> u32 {
        loop {
            let parent = self.parent[v as usize];
            let above = self.parent[parent as usize];
            if parent == above {
                return parent;
            }
            self.sum[v as usize] += self.sum[parent as usize];
            self.parent[v as usize] = above;
            v = above;
        }
    }

    /// Adds to a region the amount collected from its level down to `height`.
    fn settle(&mut self, root: u32, height: f64) {
        let r = root as usize;
        let power = |h: f64| h.powi(HEIGHT + 1) / f64::from(HEIGHT + 1);
        self.sum[r] += self.area[r] * (power(self.level[r]) - power(height));
        self.level[r] = height;
    }

    fn join(&mut self, a: u32, b: u32) {
        let (low, high) = if self.size[a as usize] < self.size[b as usize] { (a, b) } else { (b, a) };
        let (l, h) = (low as usize, high as usize);
        self.parent[l] = high;
        self.sum[l] -= self.sum[h];
        self.area[h] += self.area[l];
        self.size[h] += self.size[l];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use proptest::prelude::*;

    /// Reference by thresholds: at each of many heights the region of each vertex is found again.
    fn slow(graph: &EdgeGraph, areas: &[f64], map: &[f64], steps: usize) -> Vec<f64> {
        let mut enhanced = vec![0.0; map.len()];
        for sign in [1.0, -1.0] {
            let top = map.iter().fold(0.0f64, |top, x| top.max(sign * x));
            let step = top / steps as f64;
            for k in 0..steps {
                let height = (k as f64 + 0.5) * step;
                let mut seen = vec![false; map.len()];
                for v in 0..map.len() {
                    if seen[v] || sign * map[v] < height {
                        continue;
                    }
                    let mut region = vec![v];
                    seen[v] = true;
                    let mut at = 0;
                    while at < region.len() {
                        for &u in graph.neighbors(region[at]) {
                            if !seen[u as usize] && sign * map[u as usize] >= height {
                                seen[u as usize] = true;
                                region.push(u as usize);
                            }
                        }
                        at += 1;
                    }
                    let area: f64 = region.iter().map(|&v| areas[v]).sum();
                    region.iter().for_each(|&v| enhanced[v] += sign * area * height * height * step);
                }
            }
        }
        enhanced
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn the_integral_is_that_of_many_thresholds(values in prop::collection::vec(-4.0f64..4.0, 42), flat in 0usize..42) {
            let mesh = ellipsoid([3.0, 2.0, 1.0].into(), 1);
            let (graph, areas) = (mesh.edge_graph(), crate::align::vertex_areas(&mesh));
            let mut map = values[..mesh.n_vertices()].to_vec();
            // Equal values and zeros occur in real maps.
            map.iter_mut().take(flat).for_each(|x| *x = x.round());
            let mut enhancer = Enhancer::new(&graph, &areas);
            let fast = enhancer.enhance(&map);
            let again = enhancer.enhance(&map);
            prop_assert_eq!(&fast, &again);
            let slow = slow(&graph, &areas, &map, 4000);
            let top = slow.iter().fold(0.0f64, |top, x| top.max(x.abs()));
            for (a, b) in fast.iter().zip(&slow) {
                prop_assert!((a - b).abs() < 3e-3 * top, "{} {}", a, b);
            }
        }
    }
}
