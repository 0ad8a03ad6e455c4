//! A synthetic population: an ellipsoid displaced along its normals by smooth Gaussian fields.
#![allow(dead_code, reason = "each test binary uses a part")]

use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::{Rotation3, Vector3};
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use statrs::distribution::{ContinuousCDF, Normal};

/// Standard deviation of the displacement at every vertex, mm.
pub(crate) const DEVIATION_MM: f64 = 0.3;
/// Width of the smooth parts of the displacement, and of the planted bump, mm.
pub(crate) const WIDTH_MM: f64 = 2.5;
pub(crate) fn template() -> SurfaceMesh {
    ellipsoid(Vector3::new(12.0, 6.0, 4.0), 3)
}

/// Draws shapes of one population.
pub(crate) struct Population {
    pub(crate) mesh: SurfaceMesh,
    normals: Vec<Vector3<f64>>,
    /// Smooth parts of the displacement, whose squares sum to 1 at each vertex.
    parts: Vec<Vec<f64>>,
    random: Xoshiro256PlusPlus,
}

impl Population {
    pub(crate) fn new(seed: u64) -> Self {
        let mesh = template();
        let normals = mesh.vertex_normals();
        let centers: Vec<usize> = (0..mesh.n_vertices()).step_by(4).collect();
        let mut parts: Vec<Vec<f64>> = centers.iter().map(|&center| bump(&mesh, center)).collect();
        for v in 0..mesh.n_vertices() {
            let norm = parts.iter().map(|part| part[v] * part[v]).sum::<f64>().sqrt();
            parts.iter_mut().for_each(|part| part[v] /= norm);
        }
        Population { mesh, normals, parts, random: Xoshiro256PlusPlus::seed_from_u64(seed) }
    }

    pub(crate) fn draw(&mut self) -> f64 {
        Normal::standard().inverse_cdf(((self.random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64)
    }

    /// A shape, moved along the normals by a further displacement, and in space.
    pub(crate) fn shape(&mut self, further: &dyn Fn(usize) -> f64) -> Vec<[f32; 3]> {
        let weights = self.weights();
        self.shape_of(&weights, further)
    }

    /// What a shape is made of.
    pub(crate) fn weights(&mut self) -> Vec<f64> {
        (0..self.parts.len()).map(|_| self.draw()).collect()
    }

    /// The shape of these weights, moved along the normals by a further displacement, and in space.
    pub(crate) fn shape_of(&mut self, weights: &[f64], further: &dyn Fn(usize) -> f64) -> Vec<[f32; 3]> {
        let angles = [0; 3].map(|_| 0.3 * self.draw());
        let shift = Vector3::from([0; 3].map(|_| 5.0 * self.draw()));
        let turn = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let at = |v: usize| {
            let field: f64 = self.parts.iter().zip(weights).map(|(part, weight)| part[v] * weight).sum();
            let moved = self.mesh.vertices()[v] + (DEVIATION_MM * field + further(v)) * self.normals[v];
            <[f64; 3]>::from((turn * moved + shift).coords).map(|x| x as f32)
        };
        (0..self.mesh.n_vertices()).map(at).collect()
    }
}

/// A bump of height 1 around a vertex.
pub(crate) fn bump(mesh: &SurfaceMesh, center: usize) -> Vec<f64> {
    let center = mesh.vertices()[center];
    mesh.vertices().iter().map(|p| (-(p - center).norm_squared() / (2.0 * WIDTH_MM * WIDTH_MM)).exp()).collect()
}
