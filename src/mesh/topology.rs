//! The topology report of a surface.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// What kind of surface a mesh is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct TopologyReport {
    /// Vertices.
    pub n_vertices: u32,
    /// Edges.
    pub n_edges: u32,
    /// Faces.
    pub n_faces: u32,
    /// Connected components (by shared vertices).
    pub n_components: u32,
    /// Edges with one face.
    pub n_boundary_edges: u32,
    /// Edges with more than two faces.
    pub n_nonmanifold_edges: u32,
    /// Vertices whose faces form more than one fan.
    pub n_nonmanifold_vertices: u32,
    /// `V − E + F`.
    pub euler_characteristic: i64,
    /// Genus summed over components; `None` where the surface is not a closed oriented manifold.
    pub genus: Option<u32>,
    /// Whether neighbouring faces agree in orientation everywhere.
    pub oriented: bool,
    /// Area, mm².
    pub area_mm2: f64,
    /// Enclosed volume, mm³, positive if faces look outwards; `None` for open surfaces.
    pub volume_mm3: Option<f64>,
}
