//! An order of the variables in which many can be processed side by side and paths are nevertheless long.
//!
//! Sequential dual ascent carries information along paths that ascend in its order. A coloring of the whole graph would
//! give wide steps but paths of a few edges. Here the order follows the distance from an end of the graph, and only
//! variables at the same distance are colored; a step is one color at one distance.

use homolog_primitives::graph::EdgeGraph;

/// Steps of variables; no two variables of a step are neighbors.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SweepOrder {
    /// Variables of every step, ascending.
    pub steps: Vec<Vec<u32>>,
    /// The step of every variable.
    pub step_of: Vec<u32>,
}

impl SweepOrder {
    /// Cost `O(|E→|)`.
    pub(super) fn new(graph: &EdgeGraph) -> Self {
        let n = graph.n_vertices();
        let (_, depth) = from_far_ends(graph);
        let mut color = vec![u32::MAX; n];
        let mut keys: Vec<(u32, u32)> = Vec::with_capacity(n);
        let mut used = Vec::new();
        for i in 0..n {
            used.clear();
            let level = graph.neighbors(i).iter().filter(|&&j| depth[j as usize] == depth[i]);
            used.extend(level.map(|&j| color[j as usize]).filter(|&c| c != u32::MAX));
            color[i] = (0..).find(|c| !used.contains(c)).unwrap_or_default();
            keys.push((depth[i], color[i]));
        }
        let mut distinct = keys.clone();
        distinct.sort_unstable();
        distinct.dedup();
        let mut steps = vec![Vec::new(); distinct.len()];
        let mut step_of = vec![0; n];
        for (i, key) in keys.iter().enumerate() {
            let step = distinct.partition_point(|k| k < key);
            steps[step].push(i as u32);
            step_of[i] = step as u32;
        }
        SweepOrder { steps, step_of }
    }
}

/// All vertices by breadth-first search, component after component, each from a far end: the vertex that a first search
/// reaches last. Also the number of edges from there to each vertex. Cost `O(|E→|)`.
pub(super) fn from_far_ends(graph: &EdgeGraph) -> (Vec<u32>, Vec<u32>) {
    let n = graph.n_vertices();
    let mut order = Vec::with_capacity(n);
    let mut depth = vec![u32::MAX; n];
    let mut found = vec![u32::MAX; n];
    for start in 0..n {
        if found[start] == u32::MAX {
            let far = search(graph, start as u32, &mut found).last().copied().unwrap_or(start as u32);
            order.extend(search(graph, far, &mut depth));
        }
    }
    (order, depth)
}

/// Breadth-first search from `start` over vertices without a depth; returns them in the order of discovery.
fn search(graph: &EdgeGraph, start: u32, depth: &mut [u32]) -> Vec<u32> {
    let mut queue = vec![start];
    depth[start as usize] = 0;
    let mut at = 0;
    while at < queue.len() {
        let i = queue[at] as usize;
        at += 1;
        for &j in graph.neighbors(i) {
            if depth[j as usize] == u32::MAX {
                depth[j as usize] = depth[i] + 1;
                queue.push(j);
            }
        }
    }
    queue
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_variable_has_a_step_without_its_neighbors(
            edges in prop::collection::btree_set((0u32..30, 0u32..30), 0..90)
        ) {
            let edges: Vec<[u32; 2]> = edges.into_iter().filter(|(a, b)| a < b).map(|(a, b)| [a, b]).collect();
            let graph = EdgeGraph::from_edges(30, &edges);
            let order = SweepOrder::new(&graph);
            prop_assert!(edges.iter().all(|[a, b]| order.step_of[*a as usize] != order.step_of[*b as usize]));
            let mut all: Vec<u32> = order.steps.concat();
            all.sort_unstable();
            prop_assert_eq!(all, (0..30).collect::<Vec<u32>>());
            for (step, variables) in order.steps.iter().enumerate() {
                prop_assert!(variables.iter().all(|&i| order.step_of[i as usize] == step as u32));
            }
        }
    }

    #[test]
    fn a_path_is_walked_from_end_to_end() {
        let graph = EdgeGraph::from_edges(5, &[[0, 1], [1, 2], [2, 3], [3, 4]]);
        assert_eq!(SweepOrder::new(&graph).steps, [[4], [3], [2], [1], [0]]);
    }
}
