//! Parameters of the inputs.

/// How a surface is made from an input file.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InputParameters {
    /// Labels of a volume that belong to the structure; `null`: every label except 0. Ignored for meshes.
    pub labels: Option<Vec<u32>>,
    /// Kind of surface that is made from a label volume.
    pub surface: SurfaceKind,
    /// Standard deviation of the Gaussian filter that is applied before the smooth surface is extracted, mm; `null`: 0.7
    /// times the side of a cube with the volume of a voxel.
    #[cfg_attr(feature = "openapi", schema(minimum = 0, maximum = 1000))]
    pub smoothing_mm: Option<f64>,
    /// Repairs that are allowed; `null`: `largest_component` and `fill` for label volumes, `weld` and `orient` for meshes.
    pub repair: Option<Vec<Repair>>,
    /// Whether a mesh may have a boundary, as a part of a structure has.
    pub allow_boundary: bool,
}

/// Kind of surface that is made from a label volume.
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
    /// Vertices with equal coordinates are merged, and faces that use a vertex twice are dropped. Meshes only.
    Weld,
    /// Faces are reversed so that neighboring faces agree in orientation. Meshes only.
    Orient,
    /// Only the largest connected component is kept.
    LargestComponent,
    /// Tunnels and cavities are closed by the smallest change of voxels. Label volumes only.
    Fill,
}
