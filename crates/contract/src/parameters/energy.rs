//! Parameters of the energy: vertex features, unary and pairwise potentials.

/// One vertex feature of the unary potential.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct FeatureParameters {
    /// The measured quantity.
    pub kind: FeatureKind,
    /// The estimator of curvature.
    #[cfg_attr(feature = "serde", serde(default = "angle_defect"))]
    pub estimator: CurvatureEstimator,
    /// Radius of the neighborhood that the estimators `covariance` and `quadric` use, mm; `null`: three mean edge lengths.
    #[cfg_attr(feature = "serde", serde(default))]
    pub radius_mm: Option<f64>,
    /// Scales `σ` of the heat flow that smooths the surface before curvature, or what is made of it, is measured, in square roots
    /// of the surface's area (the geometric mean of both surfaces).
    #[cfg_attr(feature = "serde", serde(default = "default_scales"))]
    pub scales: Vec<f64>,
    /// The same scales in mm, in place of `scales`; `null`: those of `scales`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub scales_mm: Option<Vec<f64>>,
    /// Radius of the ball that `spin_image`, `shape_context`, `fpfh` and `shot` describe, in square roots of the surface's area
    /// (the geometric mean of both surfaces).
    #[cfg_attr(feature = "serde", serde(default = "default_support"))]
    pub support: f64,
    /// Weight `w_f` in the unary potential.
    #[cfg_attr(feature = "serde", serde(default = "one"))]
    pub weight: f64,
}

#[cfg(feature = "serde")]
fn angle_defect() -> CurvatureEstimator {
    CurvatureEstimator::AngleDefect
}

pub(super) fn default_scales() -> Vec<f64> {
    vec![0.035, 0.07, 0.11]
}

pub(super) fn default_support() -> f64 {
    0.25
}

impl FeatureParameters {
    /// The scales, mm, for surfaces whose area has the square root `root_mm`.
    pub fn scales(&self, root_mm: f64) -> Vec<f64> {
        match &self.scales_mm {
            Some(scales_mm) => scales_mm.clone(),
            None => self.scales.iter().map(|scale| scale * root_mm).collect(),
        }
    }
}

#[cfg(feature = "serde")]
fn one() -> f64 {
    1.0
}

/// Quantity that a feature measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum FeatureKind {
    /// Gaussian curvature `K`, 1/mm².
    GaussianCurvature,
    /// Mean curvature `H`, 1/mm.
    MeanCurvature,
    /// Shape index (Koenderink, van Doorn 1992): which shape the surface has, from cup (−1) to dome (1).
    ShapeIndex,
    /// Curvedness `√((k₁² + k₂²) / 2)`, 1/mm.
    Curvedness,
    /// Heat kernel signature (Sun, Ovsjanikov, Guibas 2009) of the surface scaled to area 1; as up to 8 principal components, like
    /// all kinds below.
    HeatKernelSignature,
    /// Wave kernel signature (Aubry, Schlickewei, Cremers 2011) of the surface scaled to area 1.
    WaveKernelSignature,
    /// Spin image (Johnson, Hebert 1999).
    SpinImage,
    /// Shape context on the surface (Belongie et al. 2002; Frome et al. 2004), harmonics of the azimuth.
    ShapeContext,
    /// Fast point feature histogram (Rusu, Blodow, Beetz 2009).
    Fpfh,
    /// Signature of histograms of orientations (Tombari, Salti, Di Stefano 2010).
    Shot,
}

impl FeatureKind {
    /// All kinds.
    pub const ALL: [FeatureKind; 10] = [
        FeatureKind::GaussianCurvature,
        FeatureKind::MeanCurvature,
        FeatureKind::ShapeIndex,
        FeatureKind::Curvedness,
        FeatureKind::HeatKernelSignature,
        FeatureKind::WaveKernelSignature,
        FeatureKind::SpinImage,
        FeatureKind::ShapeContext,
        FeatureKind::Fpfh,
        FeatureKind::Shot,
    ];

    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            FeatureKind::GaussianCurvature => "gaussian_curvature",
            FeatureKind::MeanCurvature => "mean_curvature",
            FeatureKind::ShapeIndex => "shape_index",
            FeatureKind::Curvedness => "curvedness",
            FeatureKind::HeatKernelSignature => "heat_kernel_signature",
            FeatureKind::WaveKernelSignature => "wave_kernel_signature",
            FeatureKind::SpinImage => "spin_image",
            FeatureKind::ShapeContext => "shape_context",
            FeatureKind::Fpfh => "fpfh",
            FeatureKind::Shot => "shot",
        }
    }
}

/// Estimator of curvature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum CurvatureEstimator {
    /// Angle defect over mixed Voronoi area (Gaussian), cotangent Laplacian of the positions (mean).
    AngleDefect,
    /// Covariance of the normals in a neighborhood (Berkmann, Caelli 1994).
    Covariance,
    /// Least-squares paraboloid in the tangent frame.
    Quadric,
}

/// The energy `E(x) = Σ θ_i(x_i) + Σ θ_ij(x_i, x_j)`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct EnergyParameters {
    /// Weight `α` of the unary potentials.
    pub alpha: f64,
    /// Weight `β` of the difference of distances in the pairwise potentials.
    pub beta: f64,
    /// How the distance `d'` of two target vertices is measured.
    pub pairwise_distance: PairwiseDistance,
    /// Truncation `T` of a pairwise potential: the cost of an edge whose two target vertices are not within the neighborhood radius.
    /// `null`: `T → ∞`, a hard neighborhood constraint; such an edge then counts as 60 in every reported energy.
    pub truncation: Option<f64>,
    /// Neighborhood radius `r` in edges.
    #[cfg_attr(feature = "openapi", schema(minimum = 1, maximum = 4))]
    pub neighborhood_rings: u32,
    /// Order `p` of the Minkowski distance of features.
    pub minkowski_p: f64,
    /// Cap `τ` on the difference of one feature, in robust standard deviations.
    pub feature_cap: f64,
    /// Whether features count as their weights say, or also as precisely as they tell corresponding points of this pair apart.
    #[cfg_attr(feature = "serde", serde(default = "equal"))]
    pub precisions: Precisions,
}

#[cfg(feature = "serde")]
fn equal() -> Precisions {
    Precisions::Equal
}

/// How precise features are taken to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Precisions {
    /// All alike; only `features[].weight` tells them apart.
    Equal,
    /// Learned from the pair, without known correspondences; the sum of the weights stays the same.
    Learned,
}

/// How the distance `d'` of two target vertices is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PairwiseDistance {
    /// Along the straight line.
    Euclidean,
    /// Along edges.
    Graph,
    /// Along the surface.
    Geodesic,
}
