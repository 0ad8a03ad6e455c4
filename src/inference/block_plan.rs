//! Which outgoing messages are updated together: up to [`BLOCK_LANES`] directed edges side by side.
//!
//! Variables are packed into blocks so that few lanes stay empty; a variable with more than [`BLOCK_LANES`]
//! neighbours is spread over several blocks. The plan also fixes where a message lies in memory: messages of one
//! block are neighbours, so that a block owns one contiguous piece of the output.

use crate::graph::EdgeGraph;

/// Numbers of 32 bits in the widest vector, 512 bits; rows over the labels are a multiple of it long.
pub(super) const LANES: usize = 16;

/// Directed edges updated side by side. Nearly all vertices of a triangle mesh have six neighbours: four of them fill
/// 24 lanes, where 16 lanes would leave a quarter empty. Vertices of a quad mesh have four neighbours and fill any.
pub(super) const BLOCK_LANES: usize = 24;

/// A run of outgoing edges of one variable within a block.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BlockVariable {
    /// The variable `i`.
    pub variable: usize,
    /// Message rows `k → i` for all neighbours `k`, in the order of the graph.
    pub incoming: Vec<u32>,
    /// Which of the neighbours this block sends to.
    pub slots: std::ops::Range<usize>,
    /// First lane in the block.
    pub lane: usize,
}

/// Up to [`BLOCK_LANES`] outgoing messages.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    /// The variables that send them.
    pub variables: Vec<BlockVariable>,
    /// First message row of the block; lane `l` is row `first_row + l`.
    pub first_row: usize,
    /// Directed edge of each lane in use.
    pub edges: Vec<u32>,
}

/// Blocks that cover every directed edge once.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BlockPlan {
    pub blocks: Vec<Block>,
}

impl BlockPlan {
    /// Packs the outgoing edges of every variable of `graph`. Cost `O(|E→|)`.
    pub fn new(graph: &EdgeGraph) -> Self {
        // Pieces (variable, first slot, length), in the order of the variables.
        let mut pieces = Vec::new();
        for i in 0..graph.n_vertices() {
            let degree = graph.row(i).len();
            let mut start = 0;
            while start < degree {
                let length = (degree - start).min(BLOCK_LANES);
                pieces.push((i, start, length));
                start += length;
            }
        }
        let groups = pack(&pieces);
        let mut row_of_edge = vec![0u32; graph.n_directed_edges()];
        let mut next_row = 0u32;
        for group in &groups {
            for &(i, start, length) in group {
                for slot in start..start + length {
                    row_of_edge[graph.row(i).start + slot] = next_row;
                    next_row += 1;
                }
            }
        }
        let reverse = graph.reverse_edges();
        let mut first_row = 0;
        let blocks = groups
            .into_iter()
            .map(|group| {
                let mut block = Block { variables: Vec::with_capacity(group.len()), first_row, edges: Vec::new() };
                for (variable, start, length) in group {
                    let row = graph.row(variable);
                    block.variables.push(BlockVariable {
                        variable,
                        incoming: row.clone().map(|e| row_of_edge[reverse[e] as usize]).collect(),
                        slots: start..start + length,
                        lane: block.edges.len(),
                    });
                    block.edges.extend((row.start + start..row.start + start + length).map(|e| e as u32));
                }
                first_row += block.edges.len();
                block
            })
            .collect();
        BlockPlan { blocks }
    }
}

/// Greedy bin packing: a piece joins the first of the last few open groups that has room. Looking back only a
/// little keeps variables of a group close to each other, and costs linear time.
fn pack(pieces: &[(usize, usize, usize)]) -> Vec<Vec<(usize, usize, usize)>> {
    const OPEN: usize = 16;
    let mut groups: Vec<Vec<(usize, usize, usize)>> = Vec::new();
    let mut open: Vec<(usize, usize)> = Vec::new(); // (group, room)
    for &piece in pieces {
        let length = piece.2;
        match open.iter().position(|&(_, room)| room >= length) {
            Some(at) => {
                groups[open[at].0].push(piece);
                open[at].1 -= length;
                if open[at].1 == 0 {
                    open.remove(at);
                }
            }
            None => {
                groups.push(vec![piece]);
                if length < BLOCK_LANES {
                    open.push((groups.len() - 1, BLOCK_LANES - length));
                }
                if open.len() > OPEN {
                    open.remove(0);
                }
            }
        }
    }
    groups
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
            let mut rows = vec![usize::MAX; graph.n_directed_edges()];
            for block in &plan.blocks {
                prop_assert!(block.edges.len() <= BLOCK_LANES);
                for (lane, &e) in block.edges.iter().enumerate() {
                    prop_assert_eq!(rows[e as usize], usize::MAX);
                    rows[e as usize] = block.first_row + lane;
                }
            }
            let reverse = graph.reverse_edges();
            for block in &plan.blocks {
                for v in &block.variables {
                    for (slot, e) in graph.row(v.variable).enumerate() {
                        prop_assert_eq!(v.incoming[slot] as usize, rows[reverse[e] as usize]);
                    }
                }
            }
            let mut sorted = rows.clone();
            sorted.sort_unstable();
            prop_assert!(sorted.iter().enumerate().all(|(k, &row)| k == row));
        }
    }
}
