//! A smooth surface that loses no voxel: every vertex stays on a lattice edge between a voxel of the set and one outside.
//!
//! The surface is that of marching cubes (`cubes`) on the set itself, so its topology is that of the set (6-connected
//! foreground, 26-connected background) however thin a part is. It has one vertex for each boundary face of the set, on the
//! segment between the centers of the two voxels that share the face. Only the place on that segment is chosen:
//!
//! 1. **Start.** Where the mask, filtered by a Gaussian of 0.7 voxels, crosses 0.5 on the segment, or else its nearer end. The
//!    filter takes from a part less than two voxels thick more than noise could: a plate of one voxel loses 0.42 voxels on
//!    either side. The volume of the voxels that is missing is known for each cube of the lattice; averaged over a neighborhood
//!    it says where parts are thin, and there vertices move along their normals until it is made up for.
//! 2. **Fairing.** A smooth surface that was sampled by voxels passes through all segments, somewhere. The places minimize the
//!    squared distances, along the normals, of vertices from the mean of their neighbors, plus a weight on the squared distances
//!    from the start, within the segments: constrained elastic surface nets (Gibson, MICCAI 1998) with an energy of bending in
//!    place of area, so that convex parts do not shrink. Thin parts, which bend most, have the larger weight, and get back once
//!    more what they lose.
//! 3. **Volume.** All vertices move along their normals, within the segments, by the one distance with which the surface encloses
//!    the volume of the voxels.
//!
//! That the last step always succeeds is a matter of finitely many cases: in a cube of the lattice with any of the 256 patterns,
//! the surface encloses less than the eighths of voxels there if all its vertices are at the inner ends of their segments, and
//! more if all are at the outer ends (a test counts them).

mod cells;
mod fairing;

use super::VoxelMask;
use super::cubes::{Contour, MARGIN, Origin, cut};
use super::smooth_surface::gaussian_filter;
use crate::{MeshError, SurfaceMesh};
use cells::deficits;
use fairing::Fairing;
use nalgebra::{Matrix3, Vector3};

/// Largest distance of a vertex from its voxel face, in voxels along the axis: the surface keeps clear of voxel centers, so that
/// no triangle degenerates.
const REACH: f64 = 0.5 - MARGIN;

/// Standard deviation of the filter by which the surface starts, in voxels: the least that removes the steps between voxels.
const FILTER_VOXELS: f64 = 0.7;

/// Rounds in which thin parts get their volume: the first ones overshoot.
const THIN_ROUNDS: usize = 3;

/// Rounds of averaging over neighbors that spread a difference of volumes: over about three voxels.
const SPREADING: usize = 8;

/// Distance by which the surface would have to move for its local volume, from which a part is thin, in voxels: between the
/// standard deviation of that distance for a surface cut by voxels at random (0.29 voxels, averaged over the 20 independent ones
/// of a neighborhood) and what the filter takes from one side of a plate of one voxel.
const THIN_VOXELS: f64 = 0.3;

/// Rounds of fairing, each with the normals that the one before left.
const FAIRING_ROUNDS: usize = 3;

/// Weight of the squared distance from the start in fairing, and what a thin part adds to it: 0.02 leaves waves of eight voxels
/// and more as they are, 1 only removes steps between neighbors.
const START_WEIGHT: f64 = 0.02;
const THIN_WEIGHT: f64 = 1.0;

/// A vertex moves along its segment by at most this many times the distance that its normal has to move: the segments of the
/// others determine the surface where it is nearly parallel to this one.
const STEEPEST: f64 = 4.0;

/// Relative difference of volumes at which the last correction ends.
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
        // The filter falls from the voxel inside to the one outside, but for rare patterns.
        if (a > b) == mask.voxels()[low] && a != b { ((0.5 - a) / (b - a)).clamp(MARGIN, 1.0 - MARGIN) } else { 0.5 }
    };
    let mut net = Net::new(mask, cut(mask, inside, start));
    let neighbors = Neighbors::of(net.offset.len(), &net.contour.triangles);
    let thinness = net.thinness(&neighbors, THIN_VOXELS * mask.voxel_size_mm());
    net.fill_thin_parts(&neighbors, &thinness);
    net.fair(&neighbors, &thinness);
    net.fill_thin_parts(&neighbors, &thinness);
    // The diagonals that are shortest now.
    let voxels = std::mem::take(&mut net.contour.voxels);
    let contour = cut(mask, inside, |number, _, axis| voxels[number][axis].fract());
    net = Net { contour, ..net };
    net.restore_volume(mask.n_voxels() as f64);
    net.contour.mesh(mask)
}

/// The surface while its vertices move.
struct Net {
    contour: Contour,
    /// Voxels to mm, without a reflection.
    frame: Matrix3<f64>,
    /// For each vertex the outward direction along its segment, voxels; zero for the middle of a loop.
    outward: Vec<Vector3<f64>>,
    /// For each vertex its distance from the voxel face along that direction, in `[−REACH, REACH]`.
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

    /// Puts the middles of loops where their loops are.
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

    /// For each vertex the distance along the normal by which the surface around it would have to move to enclose the volume of
    /// the voxels there, mm, and the steps of [`Net::steps`].
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
        // Volume for each mm along the normals, in voxels.
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

    /// For each vertex whether the part around it is thin, from 0 to 1: a half where the surface would have to move by
    /// `limit_mm` for its local volume.
    fn thinness(&self, neighbors: &Neighbors, limit_mm: f64) -> Vec<f64> {
        let (distances, _) = self.missing_mm(neighbors);
        distances.iter().map(|d| 1.0 - 1.0 / (1.0 + (d / limit_mm).powi(4))).collect()
    }

    /// Moves thin parts along their normals until they have the volume of their voxels.
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

    /// For each vertex how far, in voxels, it moves outwards along its segment to move the surface by 1 mm along the normal.
    fn steps(&self, normals: &[Vector3<f64>]) -> Vec<f64> {
        let step = |v: usize| {
            let along = self.frame * self.outward[v];
            let length = along.norm();
            if length > 0.0 { 1.0 / normals[v].dot(&along).max(length / STEEPEST) } else { 0.0 }
        };
        (0..self.offset.len()).map(step).collect()
    }

    /// Moves all vertices along the normals by the one distance with which the surface encloses `target` voxels.
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
        // Regula falsi, with the weight of an end that stays halved (Illinois).
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
        // About a point of the surface, so that its distance from the corner of the volume costs no digits.
        let center = self.contour.voxels.first().copied().unwrap_or_else(Vector3::zeros);
        let parts = self.contour.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| self.contour.voxels[v as usize] - center);
            a.dot(&b.cross(&c))
        });
        parts.sum::<f64>() / 6.0
    }
}

/// Unit normals, of the areas around a vertex and its neighbors: those of single triangles between voxels are steps.
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

    /// Half of each value given to the neighbors, in equal parts.
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
