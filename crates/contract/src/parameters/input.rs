//! Parameters of the inputs.

/// How a surface is made from an input file.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InputParameters {
    /// Labels of a volume that belong to the structure, by number, or by name in the file or in the table of a well-known segmentation; `null`: every
    /// label except 0. A single one may stand without brackets. Ignored for meshes.
    #[cfg_attr(feature = "serde", serde(default, deserialize_with = "one_or_many::deserialize"))]
    pub labels: Option<Vec<LabelChoice>>,
    /// Parameters of the source alone.
    #[cfg_attr(feature = "serde", serde(default))]
    pub source: SideParameters,
    /// Parameters of the target alone.
    #[cfg_attr(feature = "serde", serde(default))]
    pub target: SideParameters,
    /// Kind of surface that is made from a label volume.
    pub surface: SurfaceKind,
    /// Standard deviation of a Gaussian filter over the mask, mm, whose iso-surface is taken for the smooth surface; it takes away
    /// what is thinner than it is wide. `null`: no filter; the surface keeps every part and the volume of the voxels.
    #[cfg_attr(feature = "openapi", schema(minimum = 0, maximum = 1000))]
    pub smoothing_mm: Option<f64>,
    /// Repairs that are allowed; `null`: `largest_component` and `fill` for label volumes, `weld` and `orient` for meshes.
    /// A single one may stand without brackets.
    #[cfg_attr(feature = "serde", serde(default, deserialize_with = "one_or_many::deserialize"))]
    pub repair: Option<Vec<Repair>>,
    /// Whether a mesh may have a boundary, as a part of a structure has.
    pub allow_boundary: bool,
    /// Share of the largest value from which a voxel of a fractional DICOM segmentation belongs to a segment. Ignored for
    /// other inputs.
    #[cfg_attr(feature = "serde", serde(default = "half"))]
    #[cfg_attr(feature = "openapi", schema(exclusive_minimum = 0, maximum = 1))]
    pub fraction: f64,
    /// Whether the coordinate transform that a GIFTI file states is applied to its vertices; `null`: only if it is rigid. An
    /// affine one, as to Talairach coordinates, changes shape and size. Ignored for other inputs.
    #[cfg_attr(feature = "serde", serde(default))]
    pub apply_transform: Option<bool>,
    /// Whether a volume whose values look like intensities, probabilities or distances is taken for labels all the same. Without
    /// it such a volume is refused, unless `labels` chooses some of its values.
    #[cfg_attr(feature = "serde", serde(default))]
    pub image_is_labels: bool,
    /// A surface of more vertices is simplified to this many before it is matched; `null`: none is. The answer has a row for
    /// every vertex of the upload as ever: that of a dropped vertex is the weighted mean of those around it.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "openapi", schema(minimum = 100, maximum = 1_000_000))]
    pub max_vertices: Option<u32>,
}

/// Default of [`InputParameters::fraction`].
#[cfg(feature = "serde")]
fn half() -> f64 {
    0.5
}

/// Parameters of one of the two inputs.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SideParameters {
    /// Labels of this volume that belong to the structure, as in `input.labels`; `null`: those of `input.labels`.
    #[cfg_attr(feature = "serde", serde(default, deserialize_with = "one_or_many::deserialize"))]
    pub labels: Option<Vec<LabelChoice>>,
    /// Whether this surface is mirrored before it is matched, as to compare left with right: in the left-right axis (x) of the
    /// space that its file declares, else in the best of three planes through its centroid. Vertices, corresponding points and the
    /// stated matrix stay in the coordinates of the file.
    #[cfg_attr(feature = "serde", serde(default))]
    pub mirror: bool,
}

/// A label of a volume.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(untagged, expecting = "a label is a whole number from 1 on, or a name"))]
pub enum LabelChoice {
    /// Its number.
    Number(u32),
    /// Its name, by its words in any order and case: in the file (a segment of DICOM SEG or of a `.seg.nrrd` of 3D Slicer), or in the
    /// table of FreeSurfer, TotalSegmentator or AAL, as `hippocampus-left` or `freesurfer:hippocampus-left`.
    Name(String),
}

impl InputParameters {
    /// The parameters of the source: its own labels, if any, replace the labels of both.
    pub fn of_source(&self) -> Self {
        self.of_side(&self.source)
    }

    /// The parameters of the target.
    pub fn of_target(&self) -> Self {
        self.of_side(&self.target)
    }

    fn of_side(&self, side: &SideParameters) -> Self {
        let labels = side.labels.clone().or_else(|| self.labels.clone());
        let (source, target) = (SideParameters::default(), SideParameters::default());
        InputParameters { labels, source, target, ..self.clone() }
    }
}

/// A list whose single entry may be written without brackets.
#[cfg(feature = "serde")]
mod one_or_many {
    use serde::{Deserialize, Deserializer};

    pub(super) fn deserialize<'de, D, T>(deserializer: D) -> Result<Option<Vec<T>>, D::Error>
    where
        D: Deserializer<'de>,
        T: serde::de::DeserializeOwned,
    {
        let value = serde_json::Value::deserialize(deserializer)?;
        let list = match value {
            serde_json::Value::Null => return Ok(None),
            serde_json::Value::Array(list) => list,
            one => vec![one],
        };
        let entries: Result<Vec<T>, _> = list.into_iter().map(serde_json::from_value).collect();
        entries.map(Some).map_err(serde::de::Error::custom)
    }
}

/// Kind of surface that is made from a label volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum SurfaceKind {
    /// Triangles between the centers of the voxels on both sides of each boundary face, as smooth as these allow.
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
    /// Parts that touch at an edge with more than two faces, or at one vertex only, get vertices of their own; the copies
    /// are numbered after the vertices of the file. Meshes only.
    Split,
    /// Only the largest connected component is kept.
    LargestComponent,
    /// Tunnels and cavities are closed: in label volumes by the smallest change of voxels; in meshes by cutting along the
    /// shortest handles and capping the rims, and by dropping pieces that lie inside others. New vertices are numbered after
    /// those of the file.
    Fill,
    /// Quads are split into triangles. Larger polygons of a file always are.
    Triangulate,
    /// Edges are collapsed until the surface has `input.max_vertices` vertices. Made where that is set, also if it is not named.
    Simplify,
}
