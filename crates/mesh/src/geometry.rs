//! Areas, normals, lengths and volume of a mesh. Lengths mm.

use super::{FaceArity, SurfaceMesh};
use nalgebra::{Point3, Vector3};

/// Vector area, mm², of a face (triangle or quad) whose corners are at positions `vertices`.
#[inline(always)] // called for every face in every step
fn vector_area(vertices: &[Point3<f64>], face: &[u32]) -> Vector3<f64> {
    let at = |corner: usize| vertices[face[corner] as usize];
    if face.len() == FaceArity::Triangle.n_corners() {
        (at(1) - at(0)).cross(&(at(2) - at(0))) / 2.0
    } else {
        (at(2) - at(0)).cross(&(at(3) - at(1))) / 2.0
    }
}

impl SurfaceMesh {
    /// Vector area of every face (normal times area, mm²). The vector area of a quad is the sum over its two triangles
    /// and does not depend on the diagonal.
    pub fn face_vector_areas(&self) -> Vec<Vector3<f64>> {
        self.faces().map(|face| vector_area(self.vertices(), face)).collect()
    }

    /// Surface area, mm².
    pub fn area(&self) -> f64 {
        self.face_vector_areas().iter().map(|a| a.norm()).sum()
    }

    /// Enclosed volume, mm³, by the divergence theorem; positive if the faces face outwards. Only
    /// meaningful for closed surfaces.
    pub fn signed_volume(&self) -> f64 {
        // Relative to the centroid, which keeps the precision of a surface far from the origin.
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

    /// Unit normal of every vertex: the direction of the area-weighted sum over its faces, or zero where the sum
    /// vanishes.
    pub fn vertex_normals(&self) -> Vec<Vector3<f64>> {
        self.vertex_normals_at(self.vertices())
    }

    /// Normals of the vertices for the positions `vertices`, one per vertex.
    pub fn vertex_normals_at(&self, vertices: &[Point3<f64>]) -> Vec<Vector3<f64>> {
        let mut normals = vec![Vector3::zeros(); vertices.len()];
        for face in self.faces() {
            let area = vector_area(vertices, face);
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
