//! How surfaces are made of the inputs.

/// How a file becomes a surface.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InputParameters {
    /// Labels of a volume that make the structure; `null`: every label but 0. Meshes ignore it.
    pub labels: Option<Vec<u32>>,
    /// Which surface is made of a label volume.
    pub surface: SurfaceKind,
    /// Standard deviation of the Gaussian filter before the smooth surface is cut out, mm.
    #[cfg_attr(feature = "openapi", schema(minimum = 0, maximum = 10))]
    pub smoothing_mm: f64,
    /// Repairs allowed; `null`: `largest_component` and `fill` for label volumes, none for meshes.
    pub repair: Option<Vec<Repair>>,
    /// Whether a mesh may have a boundary: a piece of a structure, or one that is cut open. Tunnels then are no fault.
    pub allow_boundary: bool,
}

/// Which surface is made of a label volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum SurfaceKind {
    /// Iso-surface of the Gaussian-filtered mask, triangles.
    Smooth,
    /// Boundary faces of the voxel set, quads.
    Voxel,
}

/// A repair of the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Repair {
    /// Vertices at the same place become one. Meshes only.
    Weld,
    /// Only the largest connected piece is kept.
    LargestComponent,
    /// Tunnels and cavities are closed by the smallest change. Label volumes only.
    Fill,
}
