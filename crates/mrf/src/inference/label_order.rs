//! An order of the labels in which neighboring labels are close.
//!
//! An update reads, label after label, the values at the neighbors of a label. In the order of an arbitrary surface
//! some of them lie far away in memory. Sorted by their distance from an end of the surface, all lie within a ring or
//! two, which the nearest cache still holds: an iteration takes 0.94 of the time on a hippocampus of 2,300 vertices
//! with `r = 2`, and 0.85 on one of 700 vertices.

use super::sweep_order::from_far_ends;
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};

/// A permutation of the labels.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LabelOrder {
    /// The label at every place.
    labels: Vec<u32>,
    /// The place of every label.
    places: Vec<u32>,
    /// The label at every place, negated, padded with −∞ to the length of a row. Single precision distinguishes labels
    /// up to 2²⁴, far more than can occur.
    negated: Vec<f32>,
}

impl LabelOrder {
    /// The labels by breadth-first search, component after component, each from a far end, for rows of length `stride`.
    /// Cost `O(edges)`.
    pub(super) fn new(graph: &EdgeGraph, stride: usize) -> Self {
        let (labels, _) = from_far_ends(graph);
        let mut places = vec![0; labels.len()];
        for (place, &label) in labels.iter().enumerate() {
            places[label as usize] = place as u32;
        }
        let mut negated: Vec<f32> = labels.iter().map(|&label| -(label as f32)).collect();
        negated.resize(stride, f32::NEG_INFINITY);
        LabelOrder { labels, places, negated }
    }

    /// The labels in order.
    pub(super) fn labels(&self) -> &[u32] {
        &self.labels
    }

    /// The labels of a row in order, negated, padded with −∞.
    pub(super) fn negated(&self) -> &[f32] {
        &self.negated
    }

    /// The values of a row of places, by label.
    pub(super) fn by_label<T: Copy>(&self, row: &[T]) -> Vec<T> {
        self.places.iter().map(|&place| row[place as usize]).collect()
    }

    /// `labels` expressed in places. Cost `O(n k̄ log k̄)`.
    pub(super) fn reorder(&self, labels: &LabelNeighborhoods) -> LabelNeighborhoods {
        let graph = labels.graph();
        let places = |x: usize, y: u32| [self.places[x], self.places[y as usize]];
        let edges: Vec<[u32; 2]> = (0..graph.n_vertices())
            .flat_map(|x| graph.neighbors(x).iter().map(move |&y| places(x, y)))
            .filter(|[a, b]| a < b)
            .collect();
        let graph = EdgeGraph::from_edges(graph.n_vertices(), &edges);
        LabelNeighborhoods::new(&graph, labels.rings(), |x, y| {
            let [x, y] = [x, y].map(|place| self.labels[place] as usize);
            labels.distance_within(x, y).map_or(0.0, f64::from)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn neighborhoods_are_the_same_under_other_names(
            edges in prop::collection::btree_set((0u32..30, 0u32..30), 0..90),
            rings in 0usize..4,
        ) {
            let edges: Vec<[u32; 2]> = edges.into_iter().filter(|(a, b)| a < b).map(|(a, b)| [a, b]).collect();
            let graph = EdgeGraph::from_edges(30, &edges);
            let labels = LabelNeighborhoods::new(&graph, rings, |x, y| x.abs_diff(y) as f64);
            let order = LabelOrder::new(&graph, 32);
            let reordered = order.reorder(&labels);
            prop_assert_eq!(order.by_label(order.labels()), (0..30).collect::<Vec<u32>>());
            for (place, &x) in order.labels().iter().enumerate() {
                let x = x as usize;
                prop_assert_eq!(order.negated()[place], -(x as f32));
                let mut members: Vec<(u32, f32)> = reordered
                    .members(place)
                    .iter()
                    .map(|&place| order.labels()[place as usize])
                    .zip(reordered.distances(place).iter().copied())
                    .collect();
                members.sort_unstable_by_key(|(y, _)| *y);
                let expected: Vec<(u32, f32)> =
                    labels.members(x).iter().copied().zip(labels.distances(x).iter().copied()).collect();
                prop_assert_eq!(members, expected);
            }
        }
    }

    #[test]
    fn neighbors_on_a_long_strip_are_as_near_as_it_is_wide() {
        let (width, length) = (7u32, 90u32);
        let mut edges = Vec::new();
        for i in 0..width * length {
            if i % width + 1 < width {
                edges.push([i, i + 1]);
            }
            if i + width < width * length {
                edges.push([i, i + width]);
            }
        }
        // Labels in an order unrelated to their places.
        let n = width * length;
        let named: Vec<[u32; 2]> = edges.iter().map(|e| e.map(|i| i * 101 % n)).collect();
        let order = LabelOrder::new(&EdgeGraph::from_edges(n as usize, &named), n as usize);
        let apart = |[a, b]: [u32; 2]| order.places[a as usize].abs_diff(order.places[b as usize]);
        assert!(named.iter().all(|&edge| apart(edge) <= 2 * width));
        assert!(named.iter().any(|[a, b]| a.abs_diff(*b) > 2 * width));
    }
}
