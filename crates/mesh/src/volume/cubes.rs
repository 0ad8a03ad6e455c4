//! Marching cubes with traced contours instead of a published case table, so that the surface is closed and 2-manifold.
//!
//! Every lattice edge that crosses the level carries one vertex. On each face of a cube the crossings are joined so
//! that corners above the level are kept apart where the face is ambiguous. The rule uses only the face, so the two
//! cubes that share it agree. The segments of a cube close to loops. A loop is cut into triangles by the shortest
//! diagonals that do not lie in a face of the cube, because the neighboring cube could use such a diagonal too and make
//! it a non-manifold edge. Where that is impossible the loop gets a vertex in its middle. Two corners below the level
//! at opposite ends of a cube are joined by a tube between their loops. The part above the level is therefore connected
//! through faces of voxels, and the part below through faces, edges and corners.
//!
//! Corners `0..8` have bit 0, 1, 2 for x, y, z. Edge `4·axis + k` runs along `axis`; `k` holds the other two bits.

use super::VoxelMask;
use crate::{FaceArity, MeshError, SurfaceMesh};
use nalgebra::Vector3;

/// Least distance of vertices from the ends of an edge, as a share of the edge: no triangle degenerates where the field
/// equals the level at a lattice point.
pub(super) const MARGIN: f64 = 0.05;

/// Relative difference below which two lengths are equal, so that rounding does not decide between diagonals.
const TIE: f64 = 1e-9;

/// The corners of each face, counter-clockwise seen from outside the cube.
pub(super) const FACES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// The edge between two corners that differ in one bit.
pub(super) fn edge_between(a: usize, b: usize) -> usize {
    let axis = (a ^ b).trailing_zeros() as usize;
    let low = a & b;
    let others = match axis {
        0 => low >> 1,
        1 => (low & 1) | (low >> 2) << 1,
        _ => low & 3,
    };
    4 * axis + others
}

/// The lower corner of an edge.
fn edge_corner(edge: usize) -> usize {
    let k = edge % 4;
    match edge / 4 {
        0 => k << 1,
        1 => (k & 1) | (k >> 1) << 2,
        _ => k,
    }
}

/// The contour loops of all 256 sign patterns, and the pairs of edges that share a face.
struct Cases {
    loops: Vec<Vec<Vec<usize>>>,
    share_face: [[bool; 12]; 12],
}

impl Cases {
    fn new() -> Self {
        let mut share_face = [[false; 12]; 12];
        for face in FACES {
            let edges = [0, 1, 2, 3].map(|k| edge_between(face[k], face[(k + 1) % 4]));
            for a in edges {
                for b in edges {
                    share_face[a][b] = true;
                }
            }
        }
        Cases { loops: (0..256).map(trace_loops).collect(), share_face }
    }
}

/// Whether all corners of a cube are above the level except two at opposite ends.
fn below_at_opposite_ends(pattern: usize) -> bool {
    (0..4).any(|corner| pattern == 255 & !(1 << corner | 1 << (7 - corner)))
}

/// The loops of one sign pattern (bit = corner at or above the level), as edges, counter-clockwise seen from below
/// the level.
fn trace_loops(pattern: usize) -> Vec<Vec<usize>> {
    let above = |corner: usize| pattern >> corner & 1 == 1;
    let mut next = [usize::MAX; 12];
    for face in FACES {
        let edge = |k: usize| edge_between(face[k % 4], face[(k + 1) % 4]);
        for k in 0..4 {
            // A contour that leaves the corners above the level entered at the start of the same run of corners.
            if above(face[k]) && !above(face[(k + 1) % 4]) {
                let mut first = k + 4;
                while above(face[(first - 1) % 4]) {
                    first -= 1;
                }
                // Against the direction of the run: the loop is then counter-clockwise seen from below the level.
                next[edge(first + 3)] = edge(k);
            }
        }
    }
    let mut loops = Vec::new();
    for start in 0..12 {
        let mut ring = Vec::new();
        let mut at = start;
        while next[at] != usize::MAX {
            ring.push(at);
            at = std::mem::replace(&mut next[at], usize::MAX);
        }
        if !ring.is_empty() {
            loops.push(ring);
        }
    }
    loops
}

/// The surface where `field` (on the lattice of `mask`, below `level` on its border) crosses `level`, in world mm,
/// facing the side where the field is below.
///
/// # Errors
/// [`MeshError::Empty`] if the field crosses the level nowhere.
///
/// # Cost
/// `O(voxels)`.
pub(super) fn iso_surface(mask: &VoxelMask, field: &[f64], level: f64) -> Result<SurfaceMesh, MeshError> {
    let steps = mask.strides();
    let share = |_: usize, low: usize, axis: usize| {
        let (a, b) = (field[low], field[low + steps[axis]]);
        ((level - a) / (b - a)).clamp(MARGIN, 1.0 - MARGIN)
    };
    cut(mask, |k| field[k] >= level, share).mesh(mask)
}

/// A crossing of the surface with a lattice edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    /// The lower end of the edge, an index of [`VoxelMask::voxels`].
    pub low: usize,
    /// The axis along which the edge runs.
    pub axis: usize,
    /// Whether the lower end is inside.
    pub low_is_inside: bool,
    /// Distance from the lower end, in voxels.
    pub share: f64,
}

/// The origin of a vertex.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Origin {
    /// The crossing of a lattice edge.
    Edge(Crossing),
    /// The mean of these vertices, whose loop could not be cut into triangles.
    Middle(Vec<u32>),
}

/// A cube of the lattice that the surface passes through.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    /// Its lowest corner.
    pub place: [usize; 3],
    /// Its inner corners, a bit each.
    pub pattern: u8,
    /// The vertices on its edges; `u32::MAX` where an edge is not crossed.
    pub edges: [u32; 12],
    /// Its triangles, as a range of [`Contour::triangles`].
    pub triangles: std::ops::Range<usize>,
}

/// A closed surface between the lattice points inside and those outside.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contour {
    /// The origin of each vertex.
    pub origins: Vec<Origin>,
    /// Positions in voxels, whole numbers at lattice points.
    pub voxels: Vec<Vector3<f64>>,
    /// Triangles, counter-clockwise seen from outside in these coordinates.
    pub triangles: Vec<[u32; 3]>,
    /// The cubes that have triangles.
    pub cells: Vec<Cell>,
}

impl Contour {
    /// The surface in world mm, facing outwards.
    ///
    /// # Errors
    /// [`MeshError::Empty`] if there is none.
    pub(super) fn mesh(&self, mask: &VoxelMask) -> Result<SurfaceMesh, MeshError> {
        let vertices = self.voxels.iter().map(|&v| mask.world(v.into())).collect();
        let mirrors = mask.mirrors();
        let turned = |&[a, b, c]: &[u32; 3]| if mirrors { [a, c, b] } else { [a, b, c] };
        SurfaceMesh::new(vertices, FaceArity::Triangle, self.triangles.iter().flat_map(turned).collect())
    }
}

/// The surface between the lattice points for which `inside` holds (none on the border of the box) and the others.
/// `share(number, low, axis)` positions vertex `number` on its edge, in voxels from its lower end, strictly between 0
/// and 1. Numbers depend on `inside` alone.
///
/// # Cost
/// `O(voxels)`.
pub(super) fn cut(
    mask: &VoxelMask,
    inside: impl Fn(usize) -> bool,
    share: impl Fn(usize, usize, usize) -> f64,
) -> Contour {
    let mut cutter = Cutter::new(mask, inside, share);
    let [nx, ny, nz] = mask.dims();
    for z in 0..nz - 1 {
        for y in 0..ny - 1 {
            for x in 0..nx - 1 {
                cutter.cube([x, y, z]);
            }
        }
        cutter.next_layer();
    }
    cutter.contour
}

struct Cutter<'a, I, S> {
    mask: &'a VoxelMask,
    inside: I,
    share: S,
    cases: Cases,
    corner_steps: [usize; 8],
    contour: Contour,
    /// Vertices on the x, y and z edges from the lattice points of this layer, and on the x and y edges of the next
    /// layer.
    layer: [Vec<u32>; 3],
    next_layer: [Vec<u32>; 2],
}

impl<'a, I: Fn(usize) -> bool, S: Fn(usize, usize, usize) -> f64> Cutter<'a, I, S> {
    fn new(mask: &'a VoxelMask, inside: I, share: S) -> Self {
        let s = mask.strides();
        let corner_steps = std::array::from_fn(|c| (c & 1) * s[0] + (c >> 1 & 1) * s[1] + (c >> 2) * s[2]);
        let none = || vec![u32::MAX; s[2]];
        Cutter {
            mask,
            inside,
            share,
            cases: Cases::new(),
            corner_steps,
            contour: Contour { origins: Vec::new(), voxels: Vec::new(), triangles: Vec::new(), cells: Vec::new() },
            layer: [none(), none(), none()],
            next_layer: [none(), none()],
        }
    }

    fn next_layer(&mut self) {
        for axis in 0..2 {
            std::mem::swap(&mut self.layer[axis], &mut self.next_layer[axis]);
            self.next_layer[axis].fill(u32::MAX);
        }
        self.layer[2].fill(u32::MAX);
    }

    fn cube(&mut self, place: [usize; 3]) {
        let base = self.mask.index(place);
        let pattern = (0..8).fold(0, |p, c| p | usize::from((self.inside)(base + self.corner_steps[c])) << c);
        if pattern == 0 || pattern == 255 {
            return;
        }
        let first = self.contour.triangles.len();
        let mut numbers = [u32::MAX; 12];
        let is_tube = below_at_opposite_ends(pattern);
        let mut rings: Vec<Vec<u32>> = Vec::new();
        for k in 0..self.cases.loops[pattern].len() {
            let edges = self.cases.loops[pattern][k].clone();
            let ring: Vec<u32> = edges.iter().map(|&e| self.vertex(place, e, pattern)).collect();
            edges.iter().zip(&ring).for_each(|(&edge, &vertex)| numbers[edge] = vertex);
            if !is_tube {
                self.triangulate(&edges, &ring);
            }
            rings.push(ring);
        }
        if let ([a, b], true) = (&rings[..], is_tube) {
            self.tube(a, b);
        }
        let triangles = first..self.contour.triangles.len();
        self.contour.cells.push(Cell { place, pattern: pattern as u8, edges: numbers, triangles });
    }

    /// The vertex on an edge of a cube, created at the first visit.
    fn vertex(&mut self, place: [usize; 3], edge: usize, pattern: usize) -> u32 {
        let (axis, corner) = (edge / 4, edge_corner(edge));
        let low = [0, 1, 2].map(|k| place[k] + (corner >> k & 1));
        let slot = low[1] * self.mask.dims()[0] + low[0];
        let numbers = if corner >> 2 == 1 { &mut self.next_layer[axis] } else { &mut self.layer[axis] };
        if numbers[slot] == u32::MAX {
            let number = self.contour.voxels.len();
            numbers[slot] = number as u32;
            let at = self.mask.index(low);
            let share = (self.share)(number, at, axis);
            let mut voxel = Vector3::from(low.map(|c| c as f64));
            voxel[axis] += share;
            self.contour.voxels.push(voxel);
            let low_is_inside = pattern >> corner & 1 == 1;
            self.contour.origins.push(Origin::Edge(Crossing { low: at, axis, low_is_inside, share }));
        }
        numbers[slot]
    }

    /// The band between two loops of three vertices, along the shortest connections.
    fn tube(&mut self, a: &[u32], b: &[u32]) {
        let at = |v: u32| self.mask.world(self.contour.voxels[v as usize].into());
        // The loops run in opposite directions as seen along the tube, so one index rises while the other falls.
        let length2 = |turn: usize| {
            let sides = (0..3).flat_map(|k| [(a[k], b[(turn + 3 - k) % 3]), (a[(k + 1) % 3], b[(turn + 3 - k) % 3])]);
            sides.map(|(v, w)| (at(v) - at(w)).norm_squared()).sum::<f64>()
        };
        let turn = (1..3).fold(0, |best, turn| if length2(turn) < length2(best) * (1.0 - TIE) { turn } else { best });
        for k in 0..3 {
            let (here, next) = (b[(turn + 3 - k) % 3], b[(turn + 5 - k) % 3]);
            self.contour.triangles.push([a[k], a[(k + 1) % 3], here]);
            self.contour.triangles.push([next, here, a[(k + 1) % 3]]);
        }
    }

    fn triangulate(&mut self, edges: &[usize], ring: &[u32]) {
        let at = |k: usize| self.mask.world(self.contour.voxels[ring[k] as usize].into());
        let allowed = |a: usize, b: usize| !self.cases.share_face[edges[a]][edges[b]];
        match shortest_triangulation(ring.len(), allowed, |a, b| (at(a) - at(b)).norm_squared()) {
            Some(triangles) => self.contour.triangles.extend(triangles.iter().map(|t| t.map(|k| ring[k]))),
            None => {
                let sum = ring.iter().fold(Vector3::zeros(), |s, &v| s + self.contour.voxels[v as usize]);
                let middle = self.contour.voxels.len() as u32;
                self.contour.voxels.push(sum / ring.len() as f64);
                self.contour.origins.push(Origin::Middle(ring.to_vec()));
                for k in 0..ring.len() {
                    self.contour.triangles.push([ring[k], ring[(k + 1) % ring.len()], middle]);
                }
            }
        }
    }
}

/// Triangulates a polygon of `n` corners (at most 12) with allowed diagonals only, minimizing the sum of their squared
/// lengths by dynamic programming over spans; `None` if there is no such triangulation.
fn shortest_triangulation(
    n: usize,
    allowed: impl Fn(usize, usize) -> bool,
    length2: impl Fn(usize, usize) -> f64,
) -> Option<Vec<[usize; 3]>> {
    if n == 3 {
        return Some(vec![[0, 1, 2]]);
    }
    let mut cost = [[0.0; 12]; 12];
    let mut split = [[0; 12]; 12];
    for span in 2..n {
        for a in 0..n - span {
            let b = a + span;
            let own = match span {
                _ if span == n - 1 => 0.0,
                _ if allowed(a, b) => length2(a, b),
                _ => f64::INFINITY,
            };
            let halves = (a + 1..b).map(|m| (cost[a][m] + cost[m][b], m));
            let (best, m) =
                halves.reduce(|x, y| if y.0 < x.0 * (1.0 - TIE) { y } else { x }).unwrap_or((f64::INFINITY, a));
            split[a][b] = m;
            cost[a][b] = best + own;
        }
    }
    if cost[0][n - 1].is_infinite() {
        return None;
    }
    let mut triangles = Vec::with_capacity(n - 2);
    let mut spans = vec![(0, n - 1)];
    while let Some((a, b)) = spans.pop() {
        if b - a >= 2 {
            let m = split[a][b];
            triangles.push([a, m, b]);
            spans.extend([(m, b), (a, m)]);
        }
    }
    Some(triangles)
}
