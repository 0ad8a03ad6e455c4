//! A phantom as a closed triangle mesh: rings about the center line, joined by strips, closed by a fan at each tip.
//!
//! Rings lie at equal distances along the surface, and the number of vertices of a ring is proportional to its girth,
//! so that edges have about the same length everywhere. Two neighboring rings are joined by walking around both at
//! once. The result is a sphere by construction: every strip is an annulus, every fan a disk.

use super::shape::Phantom;
use super::{Part, PhantomError};
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::Point3;
use std::f64::consts::{PI, TAU};

/// Samples along the surface from tip to tip, and around a ring, from which equal lengths are measured.
const N_ALONG: usize = 2000;
const N_AROUND: usize = 256;

/// A phantom surface, with the part of every vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct PhantomSurface {
    /// Closed, genus 0, faces outwards, mm.
    pub mesh: SurfaceMesh,
    /// Part of every vertex.
    pub parts: Vec<Part>,
}

impl Phantom {
    /// The surface as triangles with edges of about `edge_mm` (from 0.2 to 4 mm).
    ///
    /// # Errors
    /// [`PhantomError::EdgeOutOfRange`].
    /// # Cost
    /// Linear in the number of vertices, which grows with `1 / edge_mm²`: about 2,400 at 0.8 mm.
    pub fn surface(&self, edge_mm: f64) -> Result<PhantomSurface, PhantomError> {
        if !(0.2..=4.0).contains(&edge_mm) {
            return Err(PhantomError::EdgeOutOfRange { edge_mm });
        }
        // Rows of equilateral triangles are √3/2 edges apart.
        let stations = self.stations(edge_mm * 0.75f64.sqrt());
        let mut vertices = vec![self.surface_point(0.0, 0.0)];
        let mut parts = vec![Part::Anterior];
        let mut rings: Vec<Ring> = Vec::with_capacity(stations.len());
        for (row, &s) in stations.iter().enumerate() {
            let ring = self.ring(s, edge_mm, row % 2 == 1);
            parts.extend(std::iter::repeat_n(self.part_of(s), ring.points.len()));
            rings.push(Ring { first: vertices.len() as u32, fractions: ring.fractions });
            vertices.extend(ring.points);
        }
        let tail_tip = vertices.len() as u32;
        vertices.push(self.surface_point(1.0, 0.0));
        parts.push(Part::Posterior);
        let mut indices = Vec::with_capacity(vertices.len() * 6);
        if let (Some(head), Some(tail)) = (rings.first(), rings.last()) {
            for k in 0..head.len() {
                indices.extend([0, head.vertex(k + 1), head.vertex(k)]);
            }
            for pair in rings.windows(2) {
                join(&pair[0], &pair[1], &mut indices);
            }
            for k in 0..tail.len() {
                indices.extend([tail_tip, tail.vertex(k), tail.vertex(k + 1)]);
            }
        }
        let mesh = SurfaceMesh::new(vertices, FaceArity::Triangle, indices)?;
        Ok(PhantomSurface { mesh, parts })
    }

    /// Shares `s` of the rings, about `row_mm` apart along the surface, excluding the tips.
    fn stations(&self, row_mm: f64) -> Vec<f64> {
        // The cosine places samples densely where the ends are round.
        let s_of = |k: usize| (1.0 - (PI * k as f64 / N_ALONG as f64).cos()) / 2.0;
        // Lengths along four lines from tip to tip, averaged, so that a bend does not favor one side.
        let line = |k: usize| [0.0, 0.25, 0.5, 0.75].map(|turn| self.surface_point(s_of(k), TAU * turn));
        let mut traveled = Vec::with_capacity(N_ALONG + 1);
        traveled.push(0.0);
        let mut last = line(0);
        let mut total = 0.0;
        for k in 1..=N_ALONG {
            let next = line(k);
            total += last.iter().zip(&next).map(|(a, b)| (b - a).norm()).sum::<f64>() / 4.0;
            traveled.push(total);
            last = next;
        }
        let n_rows = ((total / row_mm).round() as usize).max(4);
        (1..n_rows)
            .map(|row| {
                let wanted = total * row as f64 / n_rows as f64;
                let k = traveled.partition_point(|&t| t < wanted).clamp(1, N_ALONG);
                let span = (traveled[k] - traveled[k - 1]).max(f64::MIN_POSITIVE);
                let w = (wanted - traveled[k - 1]) / span;
                s_of(k - 1) + (s_of(k) - s_of(k - 1)) * w
            })
            .collect()
    }

    fn ring(&self, s: f64, edge_mm: f64, staggered: bool) -> RingPoints {
        let phi_of = |k: f64| TAU * k / N_AROUND as f64;
        let mut traveled = vec![0.0];
        let mut last = self.surface_point(s, 0.0);
        let mut girth = 0.0;
        for k in 1..=N_AROUND {
            let next = self.surface_point(s, phi_of(k as f64));
            girth += (next - last).norm();
            traveled.push(girth);
            last = next;
        }
        // Five is the smallest number for which a fan at a tip resembles its neighbors.
        let n = ((girth / edge_mm).round() as usize).max(5);
        let offset = if staggered { 0.5 } else { 0.0 };
        let fractions: Vec<f64> = (0..n).map(|k| (k as f64 + offset) / n as f64).collect();
        let points = fractions
            .iter()
            .map(|fraction| {
                let wanted = girth * fraction;
                let k = traveled.partition_point(|&t| t < wanted).clamp(1, N_AROUND);
                let w = (wanted - traveled[k - 1]) / (traveled[k] - traveled[k - 1]).max(f64::MIN_POSITIVE);
                self.surface_point(s, phi_of(k as f64 - 1.0 + w))
            })
            .collect();
        RingPoints { points, fractions }
    }
}

struct RingPoints {
    points: Vec<Point3<f64>>,
    fractions: Vec<f64>,
}

/// Vertices of a ring: consecutive from `first`, at ascending fractions of its girth.
struct Ring {
    first: u32,
    fractions: Vec<f64>,
}

impl Ring {
    fn len(&self) -> usize {
        self.fractions.len()
    }

    fn vertex(&self, k: usize) -> u32 {
        self.first + (k % self.len()) as u32
    }

    /// Fraction of vertex `k`, counting on past one turn.
    fn fraction(&self, k: usize) -> f64 {
        self.fractions[k % self.len()] + (k / self.len()) as f64
    }
}

/// Triangles of the strip between two rings, faces outwards where angles grow counter-clockwise seen from the tail.
fn join(a: &Ring, b: &Ring, indices: &mut Vec<u32>) {
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        // The next corner is on the ring whose next vertex comes first around the axis.
        let on_a = j == b.len() || (i < a.len() && a.fraction(i + 1) <= b.fraction(j + 1));
        if on_a {
            indices.extend([a.vertex(i), a.vertex(i + 1), b.vertex(j)]);
            i += 1;
        } else {
            indices.extend([a.vertex(i), b.vertex(j + 1), b.vertex(j)]);
            j += 1;
        }
    }
}
