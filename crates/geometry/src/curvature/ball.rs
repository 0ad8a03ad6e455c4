//! The part of a surface that lies in a ball around a vertex and forms a graph over the tangent plane.

use homolog_mesh::SurfaceMesh;
use homolog_primitives::graph::EdgeGraph;
use nalgebra::{Matrix2x3, Vector2, Vector3};

/// A surface, prepared for balls around its vertices.
pub(super) struct Patches<'a> {
    pub mesh: &'a SurfaceMesh,
    graph: EdgeGraph,
    pub normals: Vec<Vector3<f64>>,
    /// Weight of each vertex: its area, so that the more finely sampled side of a ball does not outweigh the other.
    pub areas: Vec<f64>,
    radius_mm: f64,
}

/// Scratch memory of [`Patches::collect`], one entry per vertex.
pub(super) struct Visited {
    by: Vec<u32>,
    /// The vertices found, in the order of the search.
    pub members: Vec<u32>,
}

impl Visited {
    pub(super) fn new(n_vertices: usize) -> Self {
        Visited { by: vec![u32::MAX; n_vertices], members: Vec::new() }
    }
}

impl<'a> Patches<'a> {
    pub(super) fn new(mesh: &'a SurfaceMesh, areas: Vec<f64>, radius_mm: f64) -> Self {
        // The area of a vertex between degenerate faces may be NaN, which becomes 0.
        let areas = areas.into_iter().map(|area| area.max(0.0)).collect();
        Patches { mesh, graph: mesh.edge_graph(), normals: mesh.vertex_normals(), areas, radius_mm }
    }

    /// Collects in `visited.members` the vertices connected to `center` by edges within the ball around it. Paths end
    /// where the normal differs by 90° or more: beyond, the surface would overlap itself in the tangent plane. The
    /// opposite side of a thin part is therefore excluded.
    pub(super) fn collect(&self, center: usize, visited: &mut Visited) {
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
    pub(super) fn tangent_plane(&self, vertex: usize) -> Matrix2x3<f64> {
        let n = self.normals[vertex];
        // The axis farthest from the normal, so that the cross product is well away from zero.
        let u = n.cross(&Vector3::ith(n.iamin(), 1.0)).normalize();
        Matrix2x3::from_rows(&[u.transpose(), n.cross(&u).transpose()])
    }

    /// Position of `vertex` in the tangent plane of `center`, and its height above it, mm.
    pub(super) fn in_frame(&self, plane: &Matrix2x3<f64>, center: usize, vertex: usize) -> (Vector2<f64>, f64) {
        let offset = self.mesh.vertices()[vertex] - self.mesh.vertices()[center];
        (plane * offset, self.normals[center].dot(&offset))
    }
}
