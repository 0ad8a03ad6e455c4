//! Numbers side by side, aligned so that no vector of them straddles two cache lines.

use super::block_plan::BLOCK_LANES;
use std::ops::{Deref, DerefMut};

/// Labels processed together: with all lanes of a block they fill 4 KiB, part of the fastest cache.
pub(super) const CHUNK: usize = 64;

/// Scale of the products of messages in each of two chains, from the first message on and from the last on: a dozen
/// messages at the floor do not underflow 32 bits. A power of two, so that no rounding depends on it. The choice of the
/// [unary factors](super::unary_factors) keeps the product of both chains below 2¹²⁸.
pub(super) const CHAIN_SCALE: f32 = (1u64 << 60) as f32;

/// Size of a cache line, bytes.
pub(super) const LINE_BYTES: usize = 64;

/// One number for each lane of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(super) struct Lanes(pub [f32; BLOCK_LANES]);

/// A chunk of labels of one message.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(super) struct ChunkRow(pub [f32; CHUNK]);

/// A chunk of labels of every lane.
pub(super) type ChunkRows = [ChunkRow; BLOCK_LANES];

impl Lanes {
    /// The same number in every lane.
    pub(super) const fn splat(value: f32) -> Self {
        Lanes([value; BLOCK_LANES])
    }
}

impl ChunkRow {
    /// The same number for every label.
    pub(super) const fn splat(value: f32) -> Self {
        ChunkRow([value; CHUNK])
    }
}

impl Deref for Lanes {
    type Target = [f32; BLOCK_LANES];
    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl DerefMut for Lanes {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

impl Deref for ChunkRow {
    type Target = [f32; CHUNK];
    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl DerefMut for ChunkRow {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}
