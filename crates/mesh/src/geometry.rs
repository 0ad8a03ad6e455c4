//! Areas, normals, lengths and volume of a mesh. Lengths mm.

use super::{FaceArity, SurfaceMesh};
use nalgebra::{Point3, Vector3};

impl SurfaceMesh {
    /// Vector area of every face (normal times area, mm²). That of a quad is the sum over its two triangles, which does
    /// not depend on the diagonal.
    pub fn face_vector_areas(&self) -> Vec<Vector3<f64>> {
        let v = self.vertices();
        let at = |k: u32| v[k as usize];
        self.faces()
            .map(|f| match self.arity() {
                FaceArity::Triangle => (at(f[1]) - at(f[0])).cross(&(at(f[2]) - at(f[0]))) / 2.0,
                FaceArity::Quad => (at(f[2]) - at(f[0])).cross(&(at(f[3]) - at(f[1]))) / 2.0,
            })
            .collect()
    }

    /// Surface area, mm².
    pub fn area(&self) -> f64 {
        self.face_vector_areas().iter().map(|a| a.norm()).sum()
    }

    /// Enclosed volume, mm³, by the divergence theorem; positive if the faces face outwards. Only
    /// meaningful for closed surfaces.
    pub fn signed_volume(&self) -> f64 {
        // Relative to the centroid, so that a surface far from the origin keeps its precision.
        let c = self.centroid();
        let v = self.vertices();
        self.triangles()
            .iter()
            .map(|&[a, b, d]| {
                let (a, b, d) = (v[a as usize] - c, v[b as usize] - c, v[d as usize] - c);
                a.dot(&b.cross(&d)) / 6.0
            })
            .sum()
    }

    /// Mean of the vertices, mm.
    pub fn centroid(&self) -> Point3<f64> {
        let sum = self.vertices().iter().fold(Vector3::zeros(), |s, p| s + p.coords);
        Point3::from(sum / self.n_vertices() as f64)
    }

    /// Unit normal of every vertex, the direction of the area-weighted sum over its faces; zero where that vanishes.
    pub fn vertex_normals(&self) -> Vec<Vector3<f64>> {
        let mut normals = vec![Vector3::zeros(); self.n_vertices()];
        for (face, area) in self.faces().zip(self.face_vector_areas()) {
            for &v in face {
                normals[v as usize] += area;
            }
        }
        for n in &mut normals {
            *n = n.try_normalize(1e-300).unwrap_or_default();
        }
        normals
    }

    /// Mean length of the edges, mm.
    pub fn mean_edge_length(&self) -> f64 {
        let edges = self.edges();
        let v = self.vertices();
        let sum: f64 = edges.iter().map(|&[a, b]| (v[a as usize] - v[b as usize]).norm()).sum();
        sum / edges.len() as f64
    }

    /// Lowest and highest corner of the axis-aligned box around the vertices, mm.
    pub fn bounding_box(&self) -> (Point3<f64>, Point3<f64>) {
        self.vertices()
            .iter()
            .fold((Point3::from([f64::INFINITY; 3]), Point3::from([f64::NEG_INFINITY; 3])), |(low, high), p| {
                (low.inf(p), high.sup(p))
            })
    }
}
