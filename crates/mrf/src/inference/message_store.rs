//! The messages of the flooding schedule: one copy plus a few blocks.
//!
//! Flooding computes every message from those of the previous iteration, so an old message must be kept until all its
//! readers are done: the variable that receives it, and its own block, which damps with it. Blocks are processed in
//! batches, in an order in which neighbors are near, and an updated block is written over one whose last reader is
//! done. The position of a block therefore changes between iterations. Nothing is copied, and blocks are written to
//! memory that has just been read and is still in the cache.

use super::block_plan::{BLOCK_LANES, BlockPlan};
use super::lanes::LINE_BYTES;
use homolog_primitives::observe::Observer;
use std::ops::Range;

/// Blocks per batch, after which old blocks are released: enough to keep many cores busy, few compared with the
/// thousands of a surface.
const BATCH_BLOCKS: usize = 24;

/// Blocks that are updated together, and old blocks that are released after each batch.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Batches {
    /// In order: the blocks of the batch, and the blocks whose last reader is in it.
    pub batches: Vec<(Range<usize>, Vec<usize>)>,
    /// Number of blocks stored in addition to the old ones.
    pub n_spare: usize,
}

impl Batches {
    /// Cost `O(|E→|)`.
    pub(super) fn new(plan: &BlockPlan) -> Self {
        let n = plan.blocks.len();
        let mut last_reader: Vec<usize> = (0..n).collect();
        for (reader, block) in plan.blocks.iter().enumerate() {
            for &edge in block.variables.iter().flat_map(|of| &of.incoming) {
                let of = edge as usize / BLOCK_LANES;
                last_reader[of] = last_reader[of].max(reader);
            }
        }
        let mut batches: Vec<(Range<usize>, Vec<usize>)> =
            (0..n).step_by(BATCH_BLOCKS).map(|start| (start..(start + BATCH_BLOCKS).min(n), Vec::new())).collect();
        for (block, reader) in last_reader.into_iter().enumerate() {
            batches[reader / BATCH_BLOCKS].1.push(block);
        }
        let (mut in_use, mut n_spare) = (0, 0);
        for (blocks, released) in &batches {
            in_use += blocks.len();
            n_spare = n_spare.max(in_use);
            in_use -= released.len();
        }
        Batches { batches, n_spare }
    }
}

/// All messages, block by block.
pub(super) struct MessageStore {
    values: Vec<f32>,
    /// Start of the first piece, aligned to a cache line.
    start: usize,
    stride: usize,
    n_edges: usize,
    /// The piece of `values` in which each block lies.
    piece_of_block: Vec<usize>,
    /// Unused pieces; the last one freed is used first.
    spare: Vec<usize>,
}

impl MessageStore {
    /// Room for the messages of `plan`, in rows of length `stride`, and for `n_spare` further blocks. All 0.
    pub(super) fn new(plan: &BlockPlan, stride: usize, n_spare: usize) -> Self {
        let n = plan.blocks.len();
        // A vector that straddles two cache lines takes twice as long. Rows are whole vectors, so aligning the first
        // one is enough. Results do not depend on it: 0 would do.
        let line = LINE_BYTES / size_of::<f32>();
        let values = vec![0.0; (n + n_spare) * BLOCK_LANES * stride + line];
        let start = values.as_ptr().align_offset(LINE_BYTES).min(line);
        MessageStore {
            values,
            start,
            stride,
            n_edges: plan.blocks.iter().map(|block| block.n_edges).sum(),
            piece_of_block: (0..n).collect(),
            spare: (n..n + n_spare).rev().collect(),
        }
    }

    /// The message of a directed edge.
    pub(super) fn message(&self, edge: usize) -> &[f32] {
        let start = self.start(edge);
        &self.values[start..start + self.stride]
    }

    /// Sets every message to `message`, unless `observer`, who is asked at each, wants it to stop.
    pub(super) fn fill(&mut self, message: &[f32], observer: &dyn Observer) {
        for edge in 0..self.n_edges {
            if observer.is_cancelled() {
                return;
            }
            let start = self.start(edge);
            self.values[start..start + self.stride].copy_from_slice(message);
        }
    }

    fn start(&self, edge: usize) -> usize {
        let (block, lane) = (edge / BLOCK_LANES, edge % BLOCK_LANES);
        self.start + (self.piece_of_block[block] * BLOCK_LANES + lane) * self.stride
    }

    /// The messages for one iteration.
    pub(super) fn open(&mut self) -> OpenStore<'_> {
        let MessageStore { values, start, stride, piece_of_block, spare, .. } = self;
        OpenStore {
            pieces: values[*start..].chunks_exact_mut((BLOCK_LANES * *stride).max(1)).collect(),
            new_piece: vec![usize::MAX; piece_of_block.len()],
            stride: *stride,
            piece_of_block,
            spare,
        }
    }
}

/// The messages during an iteration, while some are read and others written.
pub(super) struct OpenStore<'a> {
    /// Pieces of memory; empty while lent out.
    pieces: Vec<&'a mut [f32]>,
    /// The piece of each block of the next iteration, once it is computed.
    new_piece: Vec<usize>,
    stride: usize,
    piece_of_block: &'a mut [usize],
    spare: &'a mut Vec<usize>,
}

/// A piece that is lent out for writing.
pub(super) struct Lent<'a> {
    piece: usize,
    /// Values of the block, row after row.
    pub values: &'a mut [f32],
}

impl<'a> OpenStore<'a> {
    /// The old message of a directed edge.
    pub(super) fn message(&self, edge: u32) -> &[f32] {
        let (block, lane) = (edge as usize / BLOCK_LANES, edge as usize % BLOCK_LANES);
        &self.block(block)[lane * self.stride..][..self.stride]
    }

    /// All old messages of a block.
    pub(super) fn block(&self, block: usize) -> &[f32] {
        &*self.pieces[self.piece_of_block[block]]
    }

    /// Lends spare pieces for `count` blocks, or as many as are available.
    pub(super) fn lend(&mut self, count: usize) -> Vec<Lent<'a>> {
        let first = self.spare.len().saturating_sub(count);
        let lent = self.spare.split_off(first).into_iter().rev();
        lent.map(|piece| Lent { piece, values: std::mem::take(&mut self.pieces[piece]) }).collect()
    }

    /// Takes back a lent piece: from the next iteration on it is `block`.
    pub(super) fn give_back(&mut self, block: usize, lent: Lent<'a>) {
        self.new_piece[block] = lent.piece;
        self.pieces[lent.piece] = lent.values;
    }

    /// Replaces the old messages of `block`, which are no longer read, by the new ones; their piece becomes spare.
    pub(super) fn release(&mut self, block: usize) {
        let new = std::mem::replace(&mut self.new_piece[block], usize::MAX);
        if new != usize::MAX {
            self.spare.push(std::mem::replace(&mut self.piece_of_block[block], new));
        }
    }

    /// Releases all blocks that are computed but not released, as after an interrupted iteration.
    pub(super) fn close(mut self) {
        for block in 0..self.new_piece.len() {
            self.release(block);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_primitives::graph::EdgeGraph;
    use homolog_primitives::observe::Silent;
    use proptest::prelude::*;

    proptest! {
        /// Every block is written with its number times the iteration; meanwhile readers must find the number of the
        /// previous iteration.
        #[test]
        fn old_messages_last_until_their_last_reader_is_done(
            edges in prop::collection::btree_set((0u32..400, 1u32..9), 1..900),
            cut in prop::option::of(0usize..12),
        ) {
            let mut edges: Vec<[u32; 2]> = edges.into_iter().map(|(a, step)| [a, (a + step * step) % 400]).collect();
            edges.retain(|[a, b]| a < b);
            edges.dedup();
            let plan = BlockPlan::new(&EdgeGraph::from_edges(400, &edges));
            let batches = Batches::new(&plan);
            let mut store = MessageStore::new(&plan, 1, batches.n_spare);
            store.fill(&[0.0], &Silent);
            let mut made = vec![0.0; plan.blocks.len()];
            for iteration in 1..4u8 {
                let mut open = store.open();
                let before = made.clone();
                for (at, (blocks, released)) in batches.batches.iter().enumerate() {
                    if iteration == 2 && cut == Some(at) {
                        break;
                    }
                    let mut lent = open.lend(blocks.len());
                    prop_assert_eq!(lent.len(), blocks.len());
                    for (block, lent) in blocks.clone().zip(&mut lent) {
                        lent.values.fill(f32::from(iteration));
                        prop_assert_eq!(open.block(block)[0], before[block]);
                        for &edge in plan.blocks[block].variables.iter().flat_map(|of| &of.incoming) {
                            prop_assert_eq!(open.message(edge)[0], before[edge as usize / BLOCK_LANES]);
                        }
                        made[block] = f32::from(iteration);
                    }
                    for (block, lent) in blocks.clone().zip(lent) {
                        open.give_back(block, lent);
                    }
                    for &block in released {
                        open.release(block);
                    }
                }
                open.close();
                for edge in 0..store.n_edges {
                    prop_assert_eq!(store.message(edge)[0], made[edge / BLOCK_LANES]);
                }
                prop_assert_eq!(store.spare.len(), batches.n_spare);
            }
        }
    }
}
