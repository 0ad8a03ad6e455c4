//! Points of known correspondence.

/// A point of the source and the point of the target that it corresponds to, in the coordinates of the inputs.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Landmark {
    /// Point of the source, mm.
    pub source_mm: [f64; 3],
    /// Point of the target, mm.
    pub target_mm: [f64; 3],
    /// Uncertainty of the pair: standard deviation along each axis, mm. The smaller it is, the more closely the answer
    /// follows the landmark.
    #[cfg_attr(feature = "serde", serde(default = "default_sigma_mm"))]
    #[cfg_attr(feature = "openapi", schema(minimum = 0.01, maximum = 100))]
    pub sigma_mm: f64,
}

#[cfg(feature = "serde")]
fn default_sigma_mm() -> f64 {
    0.5
}
