//! The part of a surface around a vertex that lies in a ball and can be seen as a graph over the tangent plane.

use homolog_mesh::SurfaceMesh;
use homolog_primitives::graph::EdgeGraph;
use nalgebra::{Matrix2x3, Vector2, Vector3};

/// A surface with what every ball on it needs.
pub(super) struct Patches<'a> {
    pub mesh: &'a SurfaceMesh,
    graph: EdgeGraph,
    pub normals: Vec<Vector3<f64>>,
    /// What each vertex counts for: its area, so that a finely sampled side of the ball does not outweigh the other.
    pub areas: Vec<f64>,
    radius_mm: f64,
}

/// Scratch memory of [`Patches::collect`], one entry a vertex.
pub(super) struct Visited {
    by: Vec<u32>,
    /// The vertices found, in the order in which they were.
    pub members: Vec<u32>,
}

impl Visited {
    pub fn new(n_vertices: usize) -> Self {
        Visited { by: vec![u32::MAX; n_vertices], members: Vec::new() }
    }
}

impl<'a> Patches<'a> {
    pub fn new(mesh: &'a SurfaceMesh, areas: Vec<f64>, radius_mm: f64) -> Self {
        // Between faces without area a vertex may have no number for its own; it then counts for nothing.
        let areas = areas.into_iter().map(|area| area.max(0.0)).collect();
        Patches { mesh, graph: mesh.edge_graph(), normals: mesh.vertex_normals(), areas, radius_mm }
    }

    /// Puts into `visited.members` `center` and whoever paths along edges lead to from it without leaving the ball
    /// about it. Paths also end where the surface has turned by a right angle: beyond, it would lie over itself in the
    /// tangent plane. So the opposite sheet of a thin part is not taken for the vicinity.
    pub fn collect(&self, center: usize, visited: &mut Visited) {
        let p = self.mesh.vertices();
        visited.members.clear();
        visited.members.push(center as u32);
        visited.by[center] = center as u32;
        let mut next = 0;
        while let Some(&from) = visited.members.get(next) {
            next += 1;
            for &v in self.graph.neighbors(from as usize) {
                let at = v as usize;
                if visited.by[at] != center as u32 {
                    visited.by[at] = center as u32;
                    let inside = (p[at] - p[center]).norm() <= self.radius_mm;
                    if inside && self.normals[at].dot(&self.normals[center]) > 0.0 {
                        visited.members.push(v);
                    }
                }
            }
        }
    }

    /// Two orthonormal directions of the tangent plane of `vertex`, in rows.
    pub fn tangent_plane(&self, vertex: usize) -> Matrix2x3<f64> {
        let n = self.normals[vertex];
        // The axis that the normal is farthest from, so that the product is well away from zero.
        let u = n.cross(&Vector3::ith(n.iamin(), 1.0)).normalize();
        Matrix2x3::from_rows(&[u.transpose(), n.cross(&u).transpose()])
    }

    /// Where `vertex` lies in the tangent plane of `center`, mm, and how high above it.
    pub fn in_frame(&self, plane: &Matrix2x3<f64>, center: usize, vertex: usize) -> (Vector2<f64>, f64) {
        let offset = self.mesh.vertices()[vertex] - self.mesh.vertices()[center];
        (plane * offset, self.normals[center].dot(&offset))
    }
}
