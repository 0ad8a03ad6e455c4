//! Groups the outgoing messages that are updated together: up to [`BLOCK_LANES`] directed edges side by side.
//!
//! Edges are taken in the order of their variables, so that only lanes of the last block stay empty. A variable whose
//! edges do not fit continues in the next block, where the products of its messages are computed again. The plan also
//! fixes the memory layout: the messages of a block are contiguous, so that a block owns one piece of the output.

use homolog_primitives::graph::EdgeGraph;

/// Numbers of 32 bits in the widest vector, 512 bits; row lengths over the labels are multiples of this.
pub(super) const LANES: usize = 16;

/// Directed edges updated side by side. Their cavity products over all labels (150 KB at 2,300 labels) stay in the
/// cache of a core while the messages that are read and written pass through it. More lanes would share the search for
/// the neighbors of a label among more messages, but evict each other from that cache.
pub(super) const BLOCK_LANES: usize = 16;

/// A run of outgoing edges of one variable within a block.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BlockVariable {
    /// The variable `i`.
    pub variable: usize,
    /// Directed edges `k → i` for all neighbors `k`, in the order of the graph.
    pub incoming: Vec<u32>,
    /// The neighbors to which this block sends: all of them, except for the first and the last variable of a block.
    pub slots: std::ops::Range<usize>,
    /// First lane in the block.
    pub lane: usize,
}

/// Up to [`BLOCK_LANES`] outgoing messages: lane `l` of block `b` belongs to directed edge `b · BLOCK_LANES + l`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    /// The variables that send them.
    pub variables: Vec<BlockVariable>,
    /// Lanes in use.
    pub n_edges: usize,
}

/// Blocks that cover every directed edge once.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BlockPlan {
    pub blocks: Vec<Block>,
}

impl BlockPlan {
    /// Cuts the outgoing edges of all variables of `graph` into blocks. Cost `O(|E→|)`.
    pub(super) fn new(graph: &EdgeGraph) -> Self {
        let reverse = graph.reverse_edges();
        let mut blocks: Vec<Block> = Vec::with_capacity(graph.n_directed_edges().div_ceil(BLOCK_LANES));
        for variable in 0..graph.n_vertices() {
            let row = graph.row(variable);
            let mut start = 0;
            while start < row.len() {
                let edge = row.start + start;
                let lane = edge % BLOCK_LANES;
                if lane == 0 {
                    blocks.push(Block { variables: Vec::new(), n_edges: 0 });
                }
                let end = row.len().min(start + BLOCK_LANES - lane);
                if let Some(block) = blocks.last_mut() {
                    let incoming = row.clone().map(|e| reverse[e]).collect();
                    block.variables.push(BlockVariable { variable, incoming, slots: start..end, lane });
                    block.n_edges += end - start;
                }
                start = end;
            }
        }
        BlockPlan { blocks }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_directed_edge_has_one_lane(edges in proptest::collection::btree_set((0u32..40, 0u32..40), 1..200)) {
            let mut undirected: Vec<[u32; 2]> =
                edges.into_iter().filter(|(a, b)| a != b).map(|(a, b)| [a.min(b), a.max(b)]).collect();
            undirected.sort_unstable();
            undirected.dedup();
            let graph = EdgeGraph::from_edges(40, &undirected);
            let plan = BlockPlan::new(&graph);
            let (reverse, mut next) = (graph.reverse_edges(), 0);
            for (number, block) in plan.blocks.iter().enumerate() {
                prop_assert_eq!(next, number * BLOCK_LANES);
                prop_assert!(block.n_edges == BLOCK_LANES || number + 1 == plan.blocks.len());
                for of in &block.variables {
                    let row = graph.row(of.variable);
                    prop_assert_eq!(of.incoming.clone(), reverse[row.clone()].to_vec());
                    // Whole, but where a block begins or ends.
                    prop_assert!(of.slots.start == 0 || of.lane == 0);
                    prop_assert!(of.slots.end == row.len() || of.lane + of.slots.len() == BLOCK_LANES);
                    prop_assert_eq!(row.start + of.slots.start, next);
                    prop_assert_eq!(number * BLOCK_LANES + of.lane, next);
                    next += of.slots.len();
                }
                prop_assert_eq!(number * BLOCK_LANES + block.n_edges, next);
            }
            prop_assert_eq!(next, graph.n_directed_edges());
        }
    }
}
