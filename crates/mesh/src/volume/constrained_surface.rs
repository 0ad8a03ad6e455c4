//! A smooth surface that loses no voxel: every vertex stays on a lattice edge between a voxel of the set and one outside.
//!
//! The surface is computed by marching cubes (`cubes`) on the set itself, so it has the topology of the set
//! (6-connected foreground, 26-connected background), however thin a part is. It has one vertex for each boundary face
//! of the set, on the segment between the centers of the two voxels that share the face. Only the position on that
//! segment is chosen:
//!
//! 1. **Start.** The vertex starts where the mask, filtered by a Gaussian of 0.7 voxels, crosses 0.5 on the segment, or
//!    at the nearer end. The filter removes more than noise could from a part less than two voxels thick: a plate of
//!    one voxel loses 0.42 voxels on either side. The missing volume is known for each cube of the lattice. Averaged
//!    over a neighborhood it shows where parts are thin, and there vertices move along their normals until the volume
//!    is restored.
//! 2. **Fairing.** A smooth surface that was sampled by voxels passes through all segments. The positions minimize the
//!    squared distances, along the normals, of vertices from the mean of their neighbors, plus a weight on the squared
//!    distances from the start, within the segments. This is the method of constrained elastic surface nets (Gibson,
//!    MICCAI 1998) with a bending energy in place of area, so that convex parts do not shrink. Thin parts, which bend
//!    most, have the larger weight, and their lost volume is restored once more.
//! 3. **Volume.** All vertices move along their normals, within the segments, by one common distance, chosen so that
//!    the surface encloses the volume of the voxels.
//!
//! The last step always succeeds, as a check of finitely many cases shows: in a cube of the lattice with any of the 256
//! patterns, the surface encloses less than the eighths of voxels there if all its vertices are at the inner ends of
//! their segments, and more if all are at the outer ends (a test counts them).

mod cells;
mod fairing;

use super::VoxelMask;
use super::cubes::{Contour, MARGIN, Origin, cut};
use super::smooth_surface::gaussian_filter;
use crate::{MeshError, SurfaceMesh};
use cells::deficits;
use fairing::Fairing;
use nalgebra::{Matrix3, Vector3};

/// Largest distance of a vertex from its voxel face, in voxels along the axis. The surface keeps clear of voxel
/// centers, so that no triangle degenerates.
const REACH: f64 = 0.5 - MARGIN;

/// Standard deviation of the filter for the start, in voxels: the smallest that removes the steps between voxels.
const FILTER_VOXELS: f64 = 0.7;

/// Rounds in which thin parts regain their volume: the first ones overshoot.
const THIN_ROUNDS: usize = 3;

/// Rounds of averaging over neighbors that spread a volume difference, over about three voxels.
const SPREADING: usize = 8;

/// Distance, in voxels, by which the surface would have to move to restore its local volume, above which a part counts
/// as thin. It lies between the standard deviation of that distance for a surface cut by voxels at random (0.29 voxels,
/// averaged over the 20 independent ones of a neighborhood) and the loss on one side of a plate of one voxel.
const THIN_VOXELS: f64 = 0.3;

/// Rounds of fairing, each with the normals from the previous round.
const FAIRING_ROUNDS: usize = 3;

/// Weight of the squared distance from the start in fairing, and the additional weight of a thin part: 0.02 leaves
/// waves of eight or more voxels unchanged, 1 only removes steps between neighbors.
const START_WEIGHT: f64 = 0.02;
const THIN_WEIGHT: f64 = 1.0;

/// Limit of the movement of a vertex along its segment, in multiples of the movement along its normal. Where the
/// surface is nearly parallel to a segment, the segments of other vertices determine it.
const STEEPEST: f64 = 4.0;

/// Relative volume difference at which the last correction ends.
const VOLUME_TOLERANCE: f64 = 1e-6;

/// The surface of `mask` in world mm: triangles, facing outwards. It has the topology of the set, encloses its volume, and lies
/// between the centers of the voxels inside and outside its boundary.
///
/// # Errors
/// [`MeshError::Empty`] for an empty mask.
///
/// # Cost
/// `O(voxels)`; about 2 µs for each boundary face.
pub fn constrained_surface(mask: &VoxelMask) -> Result<SurfaceMesh, MeshError> {
    let inside = |k: usize| mask.voxels()[k];
    let field = gaussian_filter(mask, FILTER_VOXELS * mask.voxel_size_mm());
    let steps = mask.strides();
    let start = |_: usize, low: usize, axis: usize| {
        let (a, b) = (field[low], field[low + steps[axis]]);
        // The filtered mask falls from the voxel inside to the voxel outside, except for rare patterns.
        if (a > b) == mask.voxels()[low] && a != b { ((0.5 - a) / (b - a)).clamp(MARGIN, 1.0 - MARGIN) } else { 0.5 }
    };
    let mut net = Net::new(mask, cut(mask, inside, start));
    let neighbors = Neighbors::of(net.offset.len(), &net.contour.triangles);
    let thinness = net.thinness(&neighbors, THIN_VOXELS * mask.voxel_size_mm());
    net.fill_thin_parts(&neighbors, &thinness);
    net.fair(&neighbors, &thinness);
    net.fill_thin_parts(&neighbors, &thinness);
    // The diagonals that are shortest after the vertices have moved.
    let voxels = std::mem::take(&mut net.contour.voxels);
    let contour = cut(mask, inside, |number, _, axis| voxels[number][axis].fract());
    net = Net { contour, ..net };
    net.restore_volume(mask.n_voxels() as f64);
    net.contour.mesh(mask)
}

/// The surface while its vertices are being moved.
struct Net {
    contour: Contour,
    /// Voxels to mm, without a reflection.
    frame: Matrix3<f64>,
    /// For each vertex the outward direction along its segment, voxels; zero for the middle of a loop.
    outward: Vec<Vector3<f64>>,
    /// Distance of each vertex from the voxel face along that direction, in `[−REACH, REACH]`.
    offset: Vec<f64>,
}

impl Net {
    fn new(mask: &VoxelMask, contour: Contour) -> Self {
        let mut frame: Matrix3<f64> = mask.affine().fixed_view::<3, 3>(0, 0).into_owned();
        if mask.mirrors() {
            frame.row_mut(0).neg_mut();
        }
        let outward = contour.origins.iter().map(|origin| match origin {
            Origin::Edge(edge) => {
                let mut direction = Vector3::zeros();
                direction[edge.axis] = if edge.low_is_inside { 1.0 } else { -1.0 };
                direction
            }
            Origin::Middle(_) => Vector3::zeros(),
        });
        let outward = outward.collect();
        let offset = contour.origins.iter().map(|origin| match origin {
            Origin::Edge(edge) if edge.low_is_inside => edge.share - 0.5,
            Origin::Edge(edge) => 0.5 - edge.share,
            Origin::Middle(_) => 0.0,
        });
        let offset = offset.collect();
        Net { contour, frame, outward, offset }
    }

    /// Moves vertex `v` along its segment.
    fn place(&mut self, v: usize, offset: f64) {
        let offset = offset.clamp(-REACH, REACH);
        let change = offset - self.offset[v];
        self.offset[v] = offset;
        self.contour.voxels[v] += self.outward[v] * change;
    }

    /// Moves the middle vertices to their loops.
    fn place_middles(&mut self) {
        for v in 0..self.contour.origins.len() {
            if let Origin::Middle(ring) = &self.contour.origins[v] {
                let sum = ring.iter().fold(Vector3::zeros(), |s, &k| s + self.contour.voxels[k as usize]);
                self.contour.voxels[v] = sum / ring.len() as f64;
            }
        }
    }

    /// Area vectors of the triangles around each vertex, mm².
    fn area_vectors(&self) -> Vec<Vector3<f64>> {
        let points: Vec<Vector3<f64>> = self.contour.voxels.iter().map(|p| self.frame * p).collect();
        let mut areas = vec![Vector3::zeros(); points.len()];
        for t in &self.contour.triangles {
            let [a, b, c] = t.map(|v| points[v as usize]);
            let area = (b - a).cross(&(c - a)) / 2.0;
            t.iter().for_each(|&v| areas[v as usize] += area);
        }
        areas
    }

    /// For each vertex the distance, mm, by which the surface around it would have to move along the normal to enclose
    /// the volume of the voxels there; and the steps of [`Net::steps`].
    fn missing_mm(&self, neighbors: &Neighbors) -> (Vec<f64>, Vec<f64>) {
        let n = self.offset.len();
        let areas = self.area_vectors();
        let steps = self.steps(&normals(&areas, neighbors));
        let mut missing = vec![0.0; n];
        for (cell, deficit) in self.contour.cells.iter().zip(deficits(&self.contour)) {
            let triangles = &self.contour.triangles[cell.triangles.clone()];
            let part = deficit / (3 * triangles.len()) as f64;
            triangles.iter().flatten().for_each(|&v| missing[v as usize] += part);
        }
        // Volume, in voxels, per mm along the normals.
        let per_mm3 = 1.0 / self.frame.determinant();
        let gain = |v: usize| areas[v].dot(&(self.frame * self.outward[v])).max(0.0) / 3.0 * steps[v] * per_mm3;
        let mut gain: Vec<f64> = (0..n).map(gain).collect();
        for _ in 0..SPREADING {
            missing = neighbors.spread(&missing);
            gain = neighbors.spread(&gain);
        }
        let distances = missing.iter().zip(&gain).map(|(m, g)| if *g > 0.0 { m / g } else { 0.0 }).collect();
        (distances, steps)
    }

    /// Thinness of the part around each vertex, from 0 to 1; it is 0.5 where the surface would have to move by
    /// `limit_mm` to restore its local volume.
    fn thinness(&self, neighbors: &Neighbors, limit_mm: f64) -> Vec<f64> {
        let (distances, _) = self.missing_mm(neighbors);
        distances.iter().map(|d| 1.0 - 1.0 / (1.0 + (d / limit_mm).powi(4))).collect()
    }

    /// Moves thin parts along their normals until they enclose the volume of their voxels.
    fn fill_thin_parts(&mut self, neighbors: &Neighbors, thinness: &[f64]) {
        for _ in 0..THIN_ROUNDS {
            let (distances, steps) = self.missing_mm(neighbors);
            for v in 0..self.offset.len() {
                self.place(v, self.offset[v] + thinness[v] * distances[v] * steps[v]);
            }
            self.place_middles();
        }
    }

    fn fair(&mut self, neighbors: &Neighbors, thinness: &[f64]) {
        let anchor = self.offset.clone();
        let weights: Vec<f64> = thinness.iter().map(|t| START_WEIGHT + THIN_WEIGHT * t).collect();
        for _ in 0..FAIRING_ROUNDS {
            let normals = normals(&self.area_vectors(), neighbors);
            let mut fairing = Fairing::new(self, neighbors, &normals);
            fairing.minimize(neighbors, &anchor, &weights, &mut self.offset);
            for v in 0..self.offset.len() {
                let offset = std::mem::replace(&mut self.offset[v], fairing.initial[v]);
                self.place(v, offset);
            }
            self.place_middles();
        }
    }

    /// Moves all vertices along the normals until the surface encloses `target` voxels.
    fn restore_volume(&mut self, target: f64) {
        let neighbors = Neighbors::of(self.offset.len(), &self.contour.triangles);
        let steps = self.steps(&normals(&self.area_vectors(), &neighbors));
        self.move_all_until(target, &steps);
    }

    /// For each vertex the distance, in voxels, that it moves outward along its segment to move the surface by 1 mm
    /// along the normal.
    fn steps(&self, normals: &[Vector3<f64>]) -> Vec<f64> {
        let step = |v: usize| {
            let along = self.frame * self.outward[v];
            let length = along.norm();
            if length > 0.0 { 1.0 / normals[v].dot(&along).max(length / STEEPEST) } else { 0.0 }
        };
        (0..self.offset.len()).map(step).collect()
    }

    /// Moves all vertices along the normals by one common distance, so that the surface encloses `target` voxels.
    fn move_all_until(&mut self, target: f64, steps: &[f64]) {
        let start = self.offset.clone();
        let excess = |net: &mut Net, distance: f64| {
            for v in 0..start.len() {
                net.place(v, start[v] + distance * steps[v]);
            }
            net.place_middles();
            net.volume() - target
        };
        // Beyond this every vertex is at an end of its segment.
        let farthest = 2.0 * steps.iter().filter(|s| **s > 0.0).fold(0.0, |far: f64, s| far.max(1.0 / s));
        let tolerance = VOLUME_TOLERANCE * target;
        let mut here = (0.0, excess(self, 0.0));
        if here.1.abs() <= tolerance {
            return;
        }
        let end = if here.1 > 0.0 { -farthest } else { farthest };
        let mut there = (end, excess(self, end));
        if (here.1 > 0.0) == (there.1 > 0.0) {
            return;
        }
        // Regula falsi that halves the weight of an end that stays (Illinois).
        for _ in 0..200 {
            let distance = (here.0 * there.1 - there.0 * here.1) / (there.1 - here.1);
            let next = (distance, excess(self, distance));
            if next.1.abs() <= tolerance {
                return;
            }
            if (next.1 > 0.0) == (there.1 > 0.0) {
                here.1 /= 2.0;
            } else {
                here = there;
            }
            there = next;
        }
    }

    /// The enclosed volume, in voxels.
    fn volume(&self) -> f64 {
        // Relative to a point of the surface, so that its distance from the corner of the volume costs no digits.
        let center = self.contour.voxels.first().copied().unwrap_or_else(Vector3::zeros);
        let parts = self.contour.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| self.contour.voxels[v as usize] - center);
            a.dot(&b.cross(&c))
        });
        parts.sum::<f64>() / 6.0
    }
}

/// Unit normals from the areas around a vertex and its neighbors, because normals of single triangles between voxels
/// form steps.
fn normals(areas: &[Vector3<f64>], neighbors: &Neighbors) -> Vec<Vector3<f64>> {
    let around = |v: usize| neighbors.of_vertex(v).iter().fold(areas[v], |sum, &k| sum + areas[k as usize]);
    (0..areas.len()).map(|v| around(v).try_normalize(0.0).unwrap_or_else(Vector3::zeros)).collect()
}

/// The neighbors of every vertex of a closed surface.
struct Neighbors {
    starts: Vec<u32>,
    ends: Vec<u32>,
}

impl Neighbors {
    fn of(n: usize, triangles: &[[u32; 3]]) -> Self {
        let mut starts = vec![0u32; n + 1];
        triangles.iter().flatten().for_each(|&v| starts[v as usize + 1] += 1);
        for v in 0..n {
            starts[v + 1] += starts[v];
        }
        let mut next = starts.clone();
        let mut ends = vec![0; 3 * triangles.len()];
        for &[a, b, c] in triangles {
            // Every edge of a closed surface is met once in each direction.
            for (from, to) in [(a, b), (b, c), (c, a)] {
                ends[next[from as usize] as usize] = to;
                next[from as usize] += 1;
            }
        }
        Neighbors { starts, ends }
    }

    fn of_vertex(&self, v: usize) -> &[u32] {
        &self.ends[self.starts[v] as usize..self.starts[v + 1] as usize]
    }

    /// Values after every vertex gives half of its value to its neighbors, in equal parts.
    fn spread(&self, values: &[f64]) -> Vec<f64> {
        let mut spread: Vec<f64> = values.iter().map(|x| x / 2.0).collect();
        for (v, value) in values.iter().enumerate() {
            let neighbors = self.of_vertex(v);
            let part = value / (2 * neighbors.len()) as f64;
            neighbors.iter().for_each(|&k| spread[k as usize] += part);
        }
        spread
    }
}

#[cfg(test)]
#[path = "constrained_surface_tests.rs"]
mod tests;
