//! Turns updated messages into the next ones: scaled to maximum 1, floored, transposed back into rows, damped.

use super::block_plan::BLOCK_LANES;
use super::lanes::{CHUNK, LINE_BYTES, Lanes};
use super::vector::{Simd, Vector, WIDTH, dispatch};

/// Parameters that turn an updated message into the new one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Finish {
    /// Smallest value of a message, if its storage format distinguishes it from 0.
    pub floor: f32,
    /// Share of the old message that is kept.
    pub damping: f32,
}

/// The rows of one block while its messages are written.
pub(super) struct BlockRows<'a> {
    /// The previous messages, row after row; as many as `new` has.
    pub old: &'a [f32],
    /// Destination of the next messages.
    pub new: &'a mut [f32],
    /// Length of a row.
    pub stride: usize,
}

/// `share / largest`, the factor that scales a message to a maximum of `share`. 0 where its products all vanished, or
/// nearly so: the factor would then leave the range, and the remaining products have few digits.
#[inline(always)]
pub(super) fn inverse_of(largest: f32, share: f32) -> f32 {
    let scale = share / largest;
    if largest > 0.0 && scale < f32::INFINITY { scale } else { 0.0 }
}

dispatch! {
    /// Writes the messages of one chunk of labels. `updated` has the unscaled messages of the labels from `start` on, a
    /// multiple of [`WIDTH`] and at most [`CHUNK`]; `largest` has the largest value of each lane over all labels.
    /// Returns the largest change.
    pub(super) fn write_chunk(
        updated: &[Lanes],
        start: usize,
        largest: &Lanes,
        finish: Finish,
        rows: &mut BlockRows<'_>,
    ) -> f32 = write
}

#[inline(always)]
fn write<S: Simd>(
    simd: S,
    updated: &[Lanes],
    start: usize,
    largest: &Lanes,
    finish: Finish,
    rows: &mut BlockRows<'_>,
) -> f32 {
    let BlockRows { old, new, stride } = rows;
    let piece = WIDTH * *stride;
    let share = 1.0 - finish.damping;
    let mut scales: [f32; BLOCK_LANES] = std::array::from_fn(|lane| inverse_of(largest[lane], share));
    let flattened;
    let updated = if scales.contains(&0.0) {
        flattened = with_flat_lanes(updated, &mut scales, share);
        &flattened[..updated.len()]
    } else {
        updated
    };
    let mut change = simd.splat(0.0);
    for (group, (old, new)) in old.chunks(piece).zip(new.chunks_mut(piece)).enumerate() {
        let labels = start..start + updated.len();
        let group = Group {
            lane: group * WIDTH,
            scale: std::array::from_fn(|k| scales[group * WIDTH + k]),
            floor: share * finish.floor,
            damping: finish.damping,
            labels,
            stride: *stride,
        };
        change = if old.len() == piece {
            group.write::<S, true>(simd, updated, old, new, change)
        } else {
            group.write::<S, false>(simd, updated, old, new, change)
        };
    }
    let mut changes = [0.0; WIDTH];
    change.store(&mut changes);
    changes.iter().fold(0.0, |a, &b| if b > a { b } else { a })
}

/// A chunk of messages in which lanes whose products all vanished are flat, since they carry no information; their
/// scales become `share`. Empty lanes may be among them.
#[cold]
#[inline(never)]
fn with_flat_lanes(updated: &[Lanes], scales: &mut [f32; BLOCK_LANES], share: f32) -> [Lanes; CHUNK] {
    let mut flattened = [Lanes::splat(0.0); CHUNK];
    for (to, from) in flattened.iter_mut().zip(updated) {
        *to = Lanes(std::array::from_fn(|lane| if scales[lane] > 0.0 { from[lane] } else { 1.0 }));
    }
    scales.iter_mut().filter(|scale| **scale == 0.0).for_each(|scale| *scale = share);
    flattened
}

/// Four numbers of a label from `lane` on.
#[inline(always)]
fn quad(label: &Lanes, lane: usize) -> &[f32; 4] {
    label[lane..].first_chunk().unwrap_or(&[0.0; 4])
}

/// [`WIDTH`] lanes of a block.
struct Group {
    /// The first lane of the group.
    lane: usize,
    /// Factor of each lane, with the share of the new message in it.
    scale: [f32; WIDTH],
    /// Floor times the share of the new message.
    floor: f32,
    damping: f32,
    labels: std::ops::Range<usize>,
    stride: usize,
}

impl Group {
    /// Writes the rows of the group, `FULL` of them or fewer, and returns the changes.
    #[inline(always)]
    fn write<S: Simd, const FULL: bool>(
        &self,
        simd: S,
        updated: &[Lanes],
        old: &[f32],
        new: &mut [f32],
        change: S::Vector,
    ) -> S::Vector {
        let (start, stride) = (self.labels.start, self.stride);
        let n_rows = if FULL { WIDTH } else { old.len() / stride };
        assert!(self.labels.end <= stride && n_rows * stride <= old.len().min(new.len()), "labels beyond the rows");
        let (floor, damping) = (simd.splat(self.floor), simd.splat(self.damping));
        let scale = self.scale.map(|scale| simd.splat(scale));
        let mut most = change;
        for (tile, lanes) in updated.as_chunks::<WIDTH>().0.iter().enumerate() {
            let label = start + tile * WIDTH;
            // Prefetches the part of these rows that the next chunk needs, at the start of each cache line: the rows
            // are too many, and their pieces too short, for the hardware prefetcher.
            if (tile * WIDTH * size_of::<f32>()).is_multiple_of(LINE_BYTES) {
                for row in 0..n_rows {
                    simd.prefetch_far(old, row * stride + label + CHUNK);
                    simd.prefetch_far(new, row * stride + label + CHUNK);
                }
            }
            for half in 0..2 {
                let rows = std::array::from_fn(|x| quad(&lanes[x], self.lane + 4 * half));
                for (row, column) in (4 * half..).zip(simd.columns(rows)) {
                    if FULL || row < n_rows {
                        let at = row * stride + label;
                        // SAFETY: `row < n_rows`, and tiles of whole vectors within `labels`, so that the vector ends within
                        // its row, and both slices have that row: asserted above. With a slice for each row, and checks, writing
                        // took 1.6 times as long.
                        #[allow(unsafe_code)]
                        let (old, new) =
                            unsafe { (&*old.as_ptr().add(at).cast(), &mut *new.as_mut_ptr().add(at).cast()) };
                        let old = simd.load(old);
                        let value = column.mul(scale[row]).max(floor).add(damping.mul(old));
                        value.store(new);
                        most = value.sub(old).abs().max(most);
                    }
                }
            }
        }
        most
    }
}

#[cfg(test)]
mod tests {
    use super::super::vector::Plain;
    use super::*;
    use proptest::prelude::*;

    /// The new rows from the dispatched function and from the portable one, with the largest change.
    fn both(updated: &[Lanes], old: &[f32], finish: Finish) -> [(Vec<u32>, u32); 2] {
        let mut top = Lanes::splat(0.0);
        for row in updated {
            (0..BLOCK_LANES).for_each(|k| top[k] = row[k].max(top[k]));
        }
        [true, false].map(|dispatched| {
            let mut new = vec![0.0; old.len()];
            let mut rows = BlockRows { old, new: &mut new, stride: updated.len() };
            let change = match dispatched {
                true => write_chunk(updated, 0, &top, finish, &mut rows),
                false => write(Plain, updated, 0, &top, finish, &mut rows),
            };
            (new.iter().map(|value| value.to_bits()).collect(), change.to_bits())
        })
    }

    proptest! {
        #[test]
        fn messages_are_written_in_the_same_bits_on_any_machine(
            n_rows in 1usize..=BLOCK_LANES,
            vectors in 1usize..4,
            exponents in prop::collection::vec(-30.0f32..0.0, 389),
            damping in prop_oneof![Just(0.0f32), 0.0f32..0.9],
            floor in prop_oneof![Just(0.0f32), Just(1e-5)],
        ) {
            let stride = vectors * WIDTH;
            let mut numbers = exponents.iter().map(|e| e.exp2()).cycle();
            let updated: Vec<Lanes> = (0..stride).map(|_| Lanes(std::array::from_fn(|_| numbers.next().unwrap()))).collect();
            let old: Vec<f32> = numbers.take(n_rows * stride).collect();
            let finish = Finish { floor, damping };
            let [dispatched, plain] = both(&updated, &old, finish);
            prop_assert_eq!(dispatched, plain);
        }
    }
}
