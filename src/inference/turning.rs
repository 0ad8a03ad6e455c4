//! Turning message rows into lanes and back: 4 × 4 numbers at a time, in registers.
//!
//! Messages lie in memory as rows over the labels, which is how they are multiplied; they are updated with the lanes of
//! a block side by side, which is how one neighbourhood serves all of them. Moving number by number between the two
//! costs more than all arithmetic; through registers it is half a shuffle a number.

use super::block_plan::BLOCK_LANES;
use super::lanes::{CHUNK, ChunkRow, ChunkRows, Lanes};
use wide::f32x4;

/// `lanes[x][l] = rows[l][x]` for the labels that `lanes` has, a multiple of 4, at most [`CHUNK`].
#[inline(always)]
pub(super) fn rows_to_lanes(rows: &ChunkRows, lanes: &mut [Lanes]) {
    let rows: [&[[f32; 4]; CHUNK / 4]; BLOCK_LANES] = std::array::from_fn(|l| quads(&rows[l]));
    for (at, [a, b, c, d]) in lanes.as_chunks_mut::<4>().0.iter_mut().enumerate().take(CHUNK / 4) {
        for l in (0..BLOCK_LANES).step_by(4) {
            let turned = turn(rows[l][at], rows[l + 1][at], rows[l + 2][at], rows[l + 3][at]);
            a[l..l + 4].copy_from_slice(&turned[0]);
            b[l..l + 4].copy_from_slice(&turned[1]);
            c[l..l + 4].copy_from_slice(&turned[2]);
            d[l..l + 4].copy_from_slice(&turned[3]);
        }
    }
}

/// `rows[l][x] = lanes[x][l]`, likewise.
#[inline(always)]
pub(super) fn lanes_to_rows(lanes: &[Lanes], rows: &mut ChunkRows) {
    for (at, [a, b, c, d]) in lanes.as_chunks::<4>().0.iter().enumerate().take(CHUNK / 4) {
        let (a, b, c, d) = (a.as_chunks::<4>().0, b.as_chunks::<4>().0, c.as_chunks::<4>().0, d.as_chunks::<4>().0);
        for (group, [p, q, r, s]) in rows.as_chunks_mut::<4>().0.iter_mut().enumerate() {
            let turned = turn(a[group], b[group], c[group], d[group]);
            p[4 * at..4 * at + 4].copy_from_slice(&turned[0]);
            q[4 * at..4 * at + 4].copy_from_slice(&turned[1]);
            r[4 * at..4 * at + 4].copy_from_slice(&turned[2]);
            s[4 * at..4 * at + 4].copy_from_slice(&turned[3]);
        }
    }
}

/// The transpose of four rows. No loops and no iterators over arrays here and where it is called: what the compiler
/// leaves of them goes through memory and takes ten times as long.
#[inline(always)]
fn turn(a: [f32; 4], b: [f32; 4], c: [f32; 4], d: [f32; 4]) -> [[f32; 4]; 4] {
    let [a, b, c, d] = f32x4::transpose([f32x4::from(a), f32x4::from(b), f32x4::from(c), f32x4::from(d)]);
    [a.to_array(), b.to_array(), c.to_array(), d.to_array()]
}

#[inline(always)]
fn quads(row: &ChunkRow) -> &[[f32; 4]; CHUNK / 4] {
    // The length divides, so the first part is all of it.
    row.as_chunks::<4>().0.try_into().unwrap_or(&[[0.0; 4]; CHUNK / 4])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_turn_into_lanes_and_back() {
        let mut rows = [ChunkRow::splat(0.0); BLOCK_LANES];
        for (l, row) in rows.iter_mut().enumerate() {
            for (x, value) in row.iter_mut().enumerate() {
                *value = (1000 * l + x) as f32;
            }
        }
        for length in [16, 48, CHUNK] {
            let mut lanes = vec![Lanes::splat(0.0); length];
            rows_to_lanes(&rows, &mut lanes);
            for (x, lanes) in lanes.iter().enumerate() {
                assert!((0..BLOCK_LANES).all(|l| lanes[l] == rows[l][x]));
            }
            let mut back = [ChunkRow::splat(-1.0); BLOCK_LANES];
            lanes_to_rows(&lanes, &mut back);
            for (row, back) in rows.iter().zip(&back) {
                assert_eq!(row[..length], back[..length]);
                assert!(back[length..].iter().all(|&value| value == -1.0));
            }
        }
    }
}
