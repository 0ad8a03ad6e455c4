//! From updated messages to the next ones: scaled to maximum 1, floored, turned back into rows, damped.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::lanes::{CHUNK, Lanes};
#[cfg(target_arch = "x86_64")]
use super::vector::Avx2;
use super::vector::{Plain, Vector, WIDTH};
use multiversion::multiversion;
use multiversion::target::match_target;

/// How an updated message becomes the new one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Finish {
    /// Smallest value of a message.
    pub floor: f32,
    /// Share of the old message that is kept.
    pub damping: f32,
}

/// The rows of one block while its messages are written.
pub(super) struct BlockRows<'a> {
    /// The messages before, row after row; as many as `new` has.
    pub old: &'a [f32],
    /// Where the next ones go.
    pub new: &'a mut [f32],
    /// Values of a row.
    pub stride: usize,
}

/// Writes the messages of one chunk of labels: `updated` has those of the labels from `start` on before scaling,
/// a multiple of [`WIDTH`], and `largest` the largest value of each lane over all labels. Returns the largest change.
#[multiversion(targets("x86_64+avx2"))]
pub(super) fn write_chunk(
    updated: &[Lanes],
    start: usize,
    largest: &Lanes,
    finish: Finish,
    rows: &mut BlockRows<'_>,
) -> f32 {
    match_target! {
        "x86_64+avx2" => write::<Avx2>(updated, start, largest, finish, rows),
        _ => write::<Plain>(updated, start, largest, finish, rows),
    }
}

#[inline(always)]
fn write<V: Vector>(updated: &[Lanes], start: usize, largest: &Lanes, finish: Finish, rows: &mut BlockRows<'_>) -> f32 {
    let BlockRows { old, new, stride } = rows;
    let piece = WIDTH * *stride;
    let share = 1.0 - finish.damping;
    let mut change = V::splat(0.0);
    for (group, (old, new)) in old.chunks(piece).zip(new.chunks_mut(piece)).enumerate() {
        let labels = start..start + updated.len();
        let group = Group {
            lane: group * WIDTH,
            // A lane whose products all vanished carries no information: a flat message.
            scale: std::array::from_fn(|k| match largest[group * WIDTH + k] {
                top if top > 0.0 => share / top,
                _ => 0.0,
            }),
            floor: share * finish.floor,
            damping: finish.damping,
            labels,
            stride: *stride,
        };
        change = if old.len() == piece {
            group.write::<V, true>(updated, old, new, change)
        } else {
            group.write::<V, false>(updated, old, new, change)
        };
    }
    let mut changes = [0.0; WIDTH];
    change.store(&mut changes);
    changes.iter().fold(0.0, |a, &b| if b > a { b } else { a })
}

/// [`WIDTH`] lanes of a block.
struct Group {
    /// The first of them.
    lane: usize,
    /// Factor of each lane, with the share of the new message in it.
    scale: [f32; WIDTH],
    /// Times the same share.
    floor: f32,
    damping: f32,
    labels: std::ops::Range<usize>,
    stride: usize,
}

impl Group {
    /// Writes the rows of the group, `FULL` of them or fewer, and returns the changes.
    #[inline(always)]
    fn write<V: Vector, const FULL: bool>(&self, updated: &[Lanes], old: &[f32], new: &mut [f32], change: V) -> V {
        let n_rows = if FULL { WIDTH } else { old.len() / self.stride };
        let n = updated.len() / WIDTH;
        let mut before = old.chunks_exact(self.stride);
        let old: [&[[f32; WIDTH]]; WIDTH] = std::array::from_fn(|_| match before.next() {
            Some(row) => &row[self.labels.clone()].as_chunks().0[..n],
            None => &[],
        });
        let mut after = new.chunks_exact_mut(self.stride);
        let new: [&mut [[f32; WIDTH]]; WIDTH] = std::array::from_fn(|_| match after.next() {
            Some(row) => &mut row[self.labels.clone()].as_chunks_mut().0[..n],
            None => &mut [],
        });
        let (floor, damping) = (V::splat(self.floor), V::splat(self.damping));
        let mut most = change;
        for (tile, lanes) in updated.as_chunks::<WIDTH>().0.iter().enumerate() {
            // What the next chunk needs of these rows is asked for now, a line of the cache every second tile: the rows
            // are too many, and their pieces too short, for the processor to see what comes next.
            if tile % 2 == 0 {
                let at = tile * WIDTH;
                for k in 0..n_rows {
                    V::prefetch_far(old[k].as_flattened(), at + CHUNK);
                    V::prefetch_far(new[k].as_flattened(), at + CHUNK);
                }
            }
            let rows: [&[f32; WIDTH]; WIDTH] =
                std::array::from_fn(|x| lanes[x][self.lane..].first_chunk().unwrap_or(&[0.0; WIDTH]));
            let rows = V::load_turned(rows);
            for k in 0..WIDTH {
                if FULL || k < n_rows {
                    let old = V::load(&old[k][tile]);
                    let value = rows[k].mul(V::splat(self.scale[k])).max(floor).add(damping.mul(old));
                    most = value.sub(old).abs().max(most);
                    value.store(&mut new[k][tile]);
                }
            }
        }
        most
    }
}
