//! Classes of variables without neighbors among each other, which can change at the same time.
//!
//! Source: chromatic Gibbs sampling, Gonzalez, Low, Gretton, Guestrin, AISTATS 2011. Every variable of a class sees
//! only variables of other classes, so changing a whole class at once equals changing its variables one after the
//! other.

use homolog_primitives::graph::EdgeGraph;

/// Color classes: variables in order of color, within a color ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ColorClasses {
    pub order: Vec<u32>,
    /// Start of each class in `order`, followed by the end of the last.
    pub starts: Vec<usize>,
}

impl ColorClasses {
    /// Greedy coloring in the order of the vertices: at most one color more than the largest degree.
    /// Cost `O(|E→|)`.
    pub(super) fn new(graph: &EdgeGraph) -> Self {
        let n = graph.n_vertices();
        let mut colors: Vec<usize> = Vec::with_capacity(n);
        // `taken[c] == i` says that a neighbor of `i` has color `c`.
        let mut taken: Vec<usize> = Vec::new();
        for i in 0..n {
            for &j in graph.neighbors(i) {
                if let Some(&color) = colors.get(j as usize) {
                    taken[color] = i;
                }
            }
            let color = (0..taken.len()).find(|&c| taken[c] != i).unwrap_or(taken.len());
            if color == taken.len() {
                taken.push(usize::MAX);
            }
            colors.push(color);
        }
        let mut order: Vec<u32> = (0..n as u32).collect();
        order.sort_by_key(|&i| colors[i as usize]);
        let mut starts = vec![0; taken.len() + 1];
        for &color in &colors {
            starts[color + 1] += 1;
        }
        for c in 0..taken.len() {
            starts[c + 1] += starts[c];
        }
        ColorClasses { order, starts }
    }

    /// The ranges of `order` that hold one class each.
    pub(super) fn ranges(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.starts.windows(2).map(|w| w[0]..w[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn classes_hold_every_variable_once_and_no_two_neighbors(
            n in 1usize..40,
            pairs in prop::collection::btree_set((0u32..40, 0u32..40), 0..120),
        ) {
            let edges: Vec<[u32; 2]> =
                pairs.iter().filter(|(a, b)| a < b && (*b as usize) < n).map(|&(a, b)| [a, b]).collect();
            let graph = EdgeGraph::from_edges(n, &edges);
            let classes = ColorClasses::new(&graph);
            let mut all = classes.order.clone();
            all.sort_unstable();
            prop_assert_eq!(all, (0..n as u32).collect::<Vec<_>>());
            let degree = (0..n).map(|i| graph.row(i).len()).max().unwrap_or(0);
            prop_assert!(classes.ranges().count() <= degree + 1);
            prop_assert_eq!(classes.starts.last(), Some(&n));
            for range in classes.ranges() {
                let class = &classes.order[range];
                prop_assert!(!class.is_empty());
                for &i in class {
                    prop_assert!(graph.neighbors(i as usize).iter().all(|j| !class.contains(j)));
                }
            }
        }
    }
}
