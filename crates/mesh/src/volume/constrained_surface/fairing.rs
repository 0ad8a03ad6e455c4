//! Positions of vertices on their segments that make a surface smooth.
//!
//! With fixed normals, the distance of a vertex from the mean of its neighbors along its normal is linear in the
//! offsets of both, so the energy is a quadratic form with bounds. Coordinate descent, which is exact in one
//! coordinate, minimizes it in a fixed order. Distances are measured along the normal, not in space, because the
//! sampling of the surface is uneven: on a plane they are zero for any distribution of the vertices.

use super::super::cubes::Origin;
use super::{Neighbors, Net, REACH};
use nalgebra::Vector3;

/// Sweeps over all vertices in a round.
const SWEEPS: usize = 4;

/// The energy of one round.
pub(super) struct Fairing {
    /// The initial offsets, in voxels.
    pub initial: Vec<f64>,
    /// Distance of each vertex from the mean of its neighbors along its normal, mm.
    bend: Vec<f64>,
    /// Derivative of that distance with respect to the offset of the neighbor at the same place in [`Neighbors`], mm
    /// per voxel.
    of_neighbors: Vec<f64>,
    /// Derivative of the position of each vertex along its own normal with respect to its offset, mm per voxel.
    along: Vec<f64>,
    /// The reverse of each directed edge.
    reverse: Vec<u32>,
}

impl Fairing {
    pub(super) fn new(net: &Net, neighbors: &Neighbors, normals: &[Vector3<f64>]) -> Self {
        let n = net.offset.len();
        let points: Vec<Vector3<f64>> = net.contour.voxels.iter().map(|p| net.frame * p).collect();
        let segments: Vec<Vector3<f64>> = net.outward.iter().map(|e| net.frame * e).collect();
        let mut bend = vec![0.0; n];
        let mut of_neighbors = vec![0.0; neighbors.ends.len()];
        for v in 0..n {
            // The middle of a loop follows the loop.
            if matches!(net.contour.origins[v], Origin::Middle(_)) {
                continue;
            }
            let around = neighbors.of_vertex(v);
            let weight = 1.0 / around.len() as f64;
            let first = neighbors.starts[v] as usize;
            let mut mean = Vector3::zeros();
            for (k, &u) in around.iter().enumerate() {
                mean += points[u as usize] * weight;
                of_neighbors[first + k] = weight * normals[v].dot(&segments[u as usize]);
            }
            bend[v] = normals[v].dot(&(mean - points[v]));
        }
        let along = (0..n).map(|v| normals[v].dot(&segments[v])).collect();
        Fairing { initial: net.offset.clone(), bend, of_neighbors, along, reverse: reversed(neighbors) }
    }

    /// Moves `offset` towards the minimum of the squared bends plus `weights` times the squared distances from `anchor` along the
    /// normals.
    pub(super) fn minimize(&mut self, neighbors: &Neighbors, anchor: &[f64], weights: &[f64], offset: &mut [f64]) {
        for _ in 0..SWEEPS {
            for v in 0..offset.len() {
                let own = self.along[v];
                if own == 0.0 {
                    continue;
                }
                let weight = weights[v];
                let edges = neighbors.starts[v] as usize..neighbors.starts[v + 1] as usize;
                let mut slope = -self.bend[v] * own + weight * own * own * (offset[v] - anchor[v]);
                let mut curvature = own * own * (1.0 + weight);
                for e in edges.clone() {
                    let (u, rate) = (neighbors.ends[e] as usize, self.of_neighbors[self.reverse[e] as usize]);
                    slope += self.bend[u] * rate;
                    curvature += rate * rate;
                }
                let moved = (offset[v] - slope / curvature).clamp(-REACH, REACH);
                let change = moved - offset[v];
                offset[v] = moved;
                self.bend[v] -= own * change;
                for e in edges {
                    self.bend[neighbors.ends[e] as usize] += self.of_neighbors[self.reverse[e] as usize] * change;
                }
            }
        }
    }
}

/// For each directed edge the index of its reverse.
fn reversed(neighbors: &Neighbors) -> Vec<u32> {
    let n = neighbors.starts.len() - 1;
    let mut reverse = vec![0; neighbors.ends.len()];
    for v in 0..n {
        for e in neighbors.starts[v]..neighbors.starts[v + 1] {
            let u = neighbors.ends[e as usize] as usize;
            let back = neighbors.of_vertex(u).iter().position(|&w| w as usize == v).unwrap_or(0);
            reverse[e as usize] = neighbors.starts[u] + back as u32;
        }
    }
    reverse
}
