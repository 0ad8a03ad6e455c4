//! Digital topology on voxels: 6-connected foreground, 26-connected background.
//!
//! Simple points by the local criterion of Bertrand and Malandain (Pattern Recognition Letters 15, 1994): a voxel may
//! change sides without changing the topology if its neighbors form one foreground component and one background
//! component around it. Well-composed sets (Latecki, Eckhardt, Rosenfeld, CVIU 61, 1995) have no two voxels that touch
//! along an edge or at a corner only; their boundary is a 2-manifold. Betti numbers follow from the Euler number of the
//! complex of voxel centers, face-adjacent pairs, squares and cubes.

use super::VoxelMask;

/// The 3×3×3 block around a voxel: bit `x + 3y + 9z`, the middle has bit 13.
type Neighborhood = u32;

const CENTER: Neighborhood = 1 << 13;
const ALL: Neighborhood = (1 << 27) - 1;

/// Tables for the local tests: adjacencies within a 3×3×3 block, and well-composed 2×2×2 blocks.
pub(super) struct LocalTopology {
    six: [Neighborhood; 27],
    all: [Neighborhood; 27],
    /// The 6 face neighbors of the middle.
    faces: Neighborhood,
    /// The 18 neighbors that share a face or an edge with it.
    near: Neighborhood,
    /// The bits of each of the eight 2×2×2 blocks around the middle, in the order of [`WELL_COMPOSED`].
    octants: [[u8; 8]; 8],
}

/// Bit `b` says whether a 2×2×2 block with foreground bits `b` (bit `x + 2y + 4z`) is well-composed.
const WELL_COMPOSED: [bool; 256] = {
    let mut table = [true; 256];
    let mut b = 0;
    while b < 256 {
        let mut k = 0;
        while k < 8 {
            // Pairs across the diagonal of a face: alone on their face.
            let mut axis = 0;
            while axis < 3 {
                let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
                let (this, across) = (b >> k & 1, b >> (k ^ u ^ v) & 1);
                if this == across && this != b >> (k ^ u) & 1 && this != b >> (k ^ v) & 1 {
                    table[b] = false;
                }
                axis += 1;
            }
            // Pairs across the diagonal of the block: alone in it.
            let alone = (1 << k) | (1 << (k ^ 7));
            if b == alone || b == 255 - alone {
                table[b] = false;
            }
            k += 1;
        }
        b += 1;
    }
    table
};

impl LocalTopology {
    pub(super) fn new() -> Self {
        let place = |k: usize| [k % 3, k / 3 % 3, k / 9].map(|c| c as i32);
        let apart = |a: usize, b: usize| -> (i32, i32) {
            let (a, b) = (place(a), place(b));
            let d = [0, 1, 2].map(|k| (a[k] - b[k]).abs());
            (d.iter().sum(), d.iter().copied().max().unwrap_or(0))
        };
        let mask = |a: usize, near: &dyn Fn((i32, i32)) -> bool| {
            (0..27).filter(|&b| b != a && near(apart(a, b))).fold(0, |m: u32, b| m | 1 << b)
        };
        let mut octants = [[0; 8]; 8];
        for (o, octant) in octants.iter_mut().enumerate() {
            for (k, bit) in octant.iter_mut().enumerate() {
                let c = [0, 1, 2].map(|a| (o >> a & 1) + (k >> a & 1));
                *bit = (c[0] + 3 * c[1] + 9 * c[2]) as u8;
            }
        }
        LocalTopology {
            six: std::array::from_fn(|a| mask(a, &|(sum, _)| sum == 1)),
            all: std::array::from_fn(|a| mask(a, &|(_, max)| max == 1)),
            faces: mask(13, &|(sum, _)| sum == 1),
            near: mask(13, &|(sum, _)| sum <= 2),
            octants,
        }
    }

    /// Whether the middle voxel can change sides without changing the topology of foreground or background.
    pub(super) fn is_simple(&self, block: Neighborhood) -> bool {
        let foreground = block & self.near;
        let seeds = foreground & self.faces;
        let background = !block & ALL & !CENTER;
        seeds != 0
            && background != 0
            && spread(seeds & seeds.wrapping_neg(), foreground, &self.six) & seeds == seeds
            && spread(background & background.wrapping_neg(), background, &self.all) == background
    }

    /// Whether the eight 2×2×2 blocks around the middle are all well-composed.
    pub(super) fn is_well_composed(&self, block: Neighborhood) -> bool {
        self.octants.iter().all(|octant| {
            let bits = octant.iter().enumerate().fold(0, |b, (k, &at)| b | (block >> at & 1) << k);
            WELL_COMPOSED[bits as usize]
        })
    }
}

/// The block with its middle voxel flipped.
pub(super) fn flipped(block: Neighborhood) -> Neighborhood {
    block ^ CENTER
}

/// The part of `within` that is connected to `seed`.
fn spread(seed: Neighborhood, within: Neighborhood, adjacent: &[Neighborhood; 27]) -> Neighborhood {
    let (mut reached, mut front) = (seed, seed);
    while front != 0 {
        let k = front.trailing_zeros() as usize;
        front &= front - 1;
        let new = adjacent[k] & within & !reached;
        reached |= new;
        front |= new;
    }
    reached
}

/// The 3×3×3 block around voxel `at`, which must not lie on the border of the box.
pub(super) fn neighborhood(voxels: &[bool], at: usize, [_, sy, sz]: [usize; 3]) -> Neighborhood {
    let mut block = 0;
    let mut bit = 0;
    for plane in [at - sz, at, at + sz] {
        for row in [plane - sy, plane, plane + sy] {
            for &voxel in &voxels[row - 1..=row + 1] {
                block |= u32::from(voxel) << bit;
                bit += 1;
            }
        }
    }
    block
}

/// Whether no two voxels of the set, nor two of its complement, touch along an edge or at a corner only.
///
/// Cost `O(voxels)`.
pub fn is_well_composed(mask: &VoxelMask) -> bool {
    let [_, sy, sz] = mask.strides();
    blocks(mask).all(|at| WELL_COMPOSED[block_bits(mask.voxels(), at, sy, sz)])
}

/// The lowest voxels of all 2×2×2 blocks.
fn blocks(mask: &VoxelMask) -> impl Iterator<Item = usize> + '_ {
    let [nx, ny, nz] = mask.dims();
    (0..nz - 1).flat_map(move |z| (0..ny - 1).flat_map(move |y| (0..nx - 1).map(move |x| mask.index([x, y, z]))))
}

fn block_bits(voxels: &[bool], at: usize, sy: usize, sz: usize) -> usize {
    let row = |start: usize| usize::from(voxels[start]) | usize::from(voxels[start + 1]) << 1;
    row(at) | row(at + sy) << 2 | row(at + sz) << 4 | row(at + sz + sy) << 6
}

/// Pieces, tunnels and cavities of a voxel set, 6-connected foreground, 26-connected background.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BettiNumbers {
    /// 6-connected pieces.
    pub n_pieces: u32,
    /// Tunnels through the pieces.
    pub n_tunnels: u32,
    /// Enclosed holes.
    pub n_cavities: u32,
}

impl BettiNumbers {
    /// Counts pieces, tunnels and cavities of `mask`. Cost `O(voxels)`.
    pub fn of(mask: &VoxelMask) -> Self {
        let (_, pieces) = components(mask, true);
        let (_, holes) = components(mask, false);
        let (n_pieces, n_cavities) = (pieces.len() as u32, (holes.len() as u32).saturating_sub(1));
        let tunnels = i64::from(n_pieces) + i64::from(n_cavities) - euler_number(mask);
        BettiNumbers { n_pieces, n_tunnels: tunnels.max(0) as u32, n_cavities }
    }

    /// One piece without tunnels and cavities.
    pub fn is_ball(self) -> bool {
        self == BettiNumbers { n_pieces: 1, n_tunnels: 0, n_cavities: 0 }
    }
}

/// Points minus face-adjacent pairs plus 2×2 squares minus 2×2×2 cubes.
fn euler_number(mask: &VoxelMask) -> i64 {
    let v = mask.voxels();
    let [sx, sy, sz] = mask.strides();
    let mut sum = 0;
    for at in blocks(mask).filter(|&at| v[at]) {
        let (x, y, z) = (v[at + sx], v[at + sy], v[at + sz]);
        let (xy, xz, yz) = (x && y && v[at + sx + sy], x && z && v[at + sx + sz], y && z && v[at + sy + sz]);
        let cube = xy && xz && yz && v[at + sx + sy + sz];
        sum += 1 - i64::from(x) - i64::from(y) - i64::from(z) + i64::from(xy) + i64::from(xz) + i64::from(yz);
        sum -= i64::from(cube);
    }
    sum
}

/// Number of voxels enclosed by the set, in all cavities together. Cost `O(voxels)`.
pub fn n_enclosed(mask: &VoxelMask) -> usize {
    // The border of the box is empty, so the first component is the outside of the set.
    components(mask, false).1.iter().skip(1).sum()
}

/// The component of every voxel of one side (`u32::MAX` on the other side), and the sizes of the components. Components
/// are numbered by their first voxel: 6-connected foreground, or 26-connected background.
pub(super) fn components(mask: &VoxelMask, foreground: bool) -> (Vec<u32>, Vec<usize>) {
    let v = mask.voxels();
    let steps = steps(mask, foreground);
    let mut number = vec![u32::MAX; v.len()];
    let mut sizes = Vec::new();
    let mut stack = Vec::new();
    for start in 0..v.len() {
        if v[start] != foreground || number[start] != u32::MAX {
            continue;
        }
        let name = sizes.len() as u32;
        let mut size = 0;
        number[start] = name;
        stack.push(start);
        while let Some(at) = stack.pop() {
            size += 1;
            let inner = mask.is_inner(at);
            for &(place, step) in &steps {
                let next = at.wrapping_add_signed(step);
                if (inner || mask.has_neighbor(at, place)) && v[next] == foreground && number[next] == u32::MAX {
                    number[next] = name;
                    stack.push(next);
                }
            }
        }
        sizes.push(size);
    }
    (number, sizes)
}

/// The steps to neighbors of the foreground (6) or of the background (26), along the axes and in the array.
fn steps(mask: &VoxelMask, foreground: bool) -> Vec<([i8; 3], isize)> {
    let strides = mask.strides().map(|s| s as isize);
    let place = |k: i8| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
    let distance = |p: &[i8; 3]| p.iter().map(|c| c.abs()).sum::<i8>();
    (0..27)
        .map(place)
        .filter(|p| distance(p) > 0 && (!foreground || distance(p) == 1))
        .map(|p| (p, (0..3).map(|k| isize::from(p[k]) * strides[k]).sum()))
        .collect()
}
