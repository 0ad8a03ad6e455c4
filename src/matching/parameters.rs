//! The parameters of a match: named presets, what overrides them, and every check with the place of the fault.
//!
//! A request states a part; [`resolve`] lays it over the preset that `method` names and returns the whole, the
//! *effective* parameters, which are stored with the job and returned with its result.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

/// Effective parameters of a match: every value stated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct MatchParameters {
    /// The preset that the other values started from.
    pub method: Method,
    /// How surfaces are made of the two inputs.
    pub input: InputParameters,
    /// Vertex features of the unary potential.
    pub features: Vec<FeatureParameters>,
    /// The energy.
    pub energy: EnergyParameters,
    /// Who minimises it.
    pub inference: InferenceParameters,
    /// Feedback from registration to the energy.
    pub clamping: ClampingParameters,
    /// The rigid transform.
    pub registration: RegistrationParameters,
    /// Seed of everything that is drawn at random.
    pub seed: u64,
}

/// A named preset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Gaussian and mean curvature, soft clamping, ICP refinement: the default.
    Balanced,
    /// Gaussian curvature only, hard clamping, no refinement.
    Thesis,
}

impl Method {
    /// All presets, the default first.
    pub const ALL: [Method; 2] = [Method::Balanced, Method::Thesis];

    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Method::Balanced => "balanced",
            Method::Thesis => "thesis",
        }
    }

    /// One sentence for people.
    pub fn description(self) -> &'static str {
        match self {
            Method::Balanced => {
                "Max-product belief propagation on Gaussian and mean curvature, soft clamping rounds, ICP refinement."
            }
            Method::Thesis => "Max-product belief propagation on Gaussian curvature, hard clamping, RANSAC only.",
        }
    }
}

/// How a file becomes a closed surface of genus 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InputParameters {
    /// Labels of a volume that make the structure; `null`: every label but 0. Meshes ignore it.
    pub labels: Option<Vec<u32>>,
    /// Which surface is made of a label volume.
    pub surface: SurfaceKind,
    /// Standard deviation of the Gaussian filter before the smooth surface is cut out, mm.
    #[schema(minimum = 0, maximum = 10)]
    pub smoothing_mm: f64,
    /// Repairs allowed; `null`: `largest_component` and `fill` for label volumes, none for meshes.
    pub repair: Option<Vec<Repair>>,
}

/// Which surface is made of a label volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceKind {
    /// Iso-surface of the Gaussian-filtered mask, triangles.
    Smooth,
    /// Boundary faces of the voxel set, quads.
    Voxel,
}

/// A repair of the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Repair {
    /// Vertices at the same place become one. Meshes only.
    Weld,
    /// Only the largest connected piece is kept.
    LargestComponent,
    /// Tunnels and cavities are closed by the smallest change. Label volumes only.
    Fill,
}

/// One vertex feature of the unary potential.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct FeatureParameters {
    /// What is measured.
    pub kind: FeatureKind,
    /// How it is measured.
    #[serde(default = "angle_defect")]
    pub estimator: CurvatureEstimator,
    /// Scales `σ` of the heat flow before it is measured, mm.
    #[serde(default = "default_scales")]
    pub scales_mm: Vec<f64>,
    /// Weight `w_f` in the unary potential.
    #[serde(default = "one")]
    pub weight: f64,
}

fn angle_defect() -> CurvatureEstimator {
    CurvatureEstimator::AngleDefect
}

fn default_scales() -> Vec<f64> {
    vec![1.4, 2.8, 4.5]
}

fn one() -> f64 {
    1.0
}

/// What a feature measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum FeatureKind {
    /// Gaussian curvature `K`, 1/mm².
    GaussianCurvature,
    /// Mean curvature `H`, 1/mm.
    MeanCurvature,
}

/// How curvature is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum CurvatureEstimator {
    /// Angle defect over mixed Voronoi area (Gaussian), cotangent Laplacian of the positions (mean).
    AngleDefect,
}

/// The energy `E(x) = Σ θ_i(x_i) + Σ θ_ij(x_i, x_j)`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EnergyParameters {
    /// Weight `α` of the unary potentials.
    pub alpha: f64,
    /// Weight `β` of the difference of distances in the pairwise potentials.
    pub beta: f64,
    /// Truncation `T` of a pairwise potential, met where the neighbourhood is broken.
    pub truncation: f64,
    /// Neighbourhood radius `r` in edges.
    #[schema(minimum = 1, maximum = 4)]
    pub neighborhood_rings: u32,
    /// Order `p` of the Minkowski distance of features.
    pub minkowski_p: f64,
    /// Largest difference of one feature that counts, `τ`, in robust standard deviations.
    pub feature_cap: f64,
}

/// The minimiser of the energy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InferenceParameters {
    /// Which message update.
    pub algorithm: Algorithm,
    /// Over which label pairs.
    pub update: Update,
    /// Iterations of the first round at most.
    pub max_iterations: u32,
    /// Share of the old message that is kept in every update.
    pub damping: f64,
    /// A round ends when no message changes by more than this.
    pub tolerance: f64,
}

/// Which message update belief propagation uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Algorithm {
    /// Max-product: heads for the labeling of lowest energy.
    MaxProduct,
    /// Sum-product: heads for the marginals.
    SumProduct,
}

/// Over which label pairs a message is updated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Update {
    /// Pairs within the neighbourhood; all others share the truncation.
    Sparse,
}

/// Feedback from registration to the energy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct ClampingParameters {
    /// How the feedback enters the unary potentials.
    pub mode: ClampingMode,
    /// Rounds of feedback at most.
    pub max_rounds: u32,
}

/// How registration feeds back into the unary potentials.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum ClampingMode {
    /// No feedback.
    None,
    /// Inlier variables are fixed to their label.
    Hard,
    /// Distance and normal disagreement after registration are added to every unary potential.
    Soft,
}

/// The rigid transform.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct RegistrationParameters {
    /// Largest residual of an inlier, mm; `null`: chosen from the mean edge length of the target.
    pub tolerance_mm: Option<f64>,
    /// Wanted probability that one trial drew only inliers.
    pub confidence: f64,
    /// Trials at most.
    pub max_trials: u32,
    /// Whether a reflection may be answered.
    pub allow_reflection: bool,
    /// Iterative closest points after RANSAC.
    pub refine: Refinement,
}

/// Iterative closest points after RANSAC.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Refinement {
    /// None.
    None,
    /// Distance of points (Besl, McKay 1992).
    PointToPoint,
    /// Distance of points to tangent planes (Chen, Medioni 1992).
    PointToPlane,
}

/// A fault in the parameters: where, which kind, what to do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct ParameterError {
    /// JSON pointer into the parameters, such as `/energy/alpha`.
    pub pointer: String,
    /// `unknown_key`, `wrong_type` or `out_of_range`.
    pub code: String,
    /// One sentence that says what is wrong and what is allowed.
    pub detail: String,
}

/// The effective parameters of a preset.
pub fn preset(method: Method) -> MatchParameters {
    let both = |kind| FeatureParameters {
        kind,
        estimator: CurvatureEstimator::AngleDefect,
        scales_mm: default_scales(),
        weight: 1.0,
    };
    let balanced = MatchParameters {
        method,
        input: InputParameters { labels: None, surface: SurfaceKind::Smooth, smoothing_mm: 0.7, repair: None },
        features: vec![both(FeatureKind::GaussianCurvature), both(FeatureKind::MeanCurvature)],
        energy: EnergyParameters {
            alpha: 1.0,
            beta: 0.0,
            truncation: 9.2,
            neighborhood_rings: 2,
            minkowski_p: 1.0,
            feature_cap: 3.0,
        },
        inference: InferenceParameters {
            algorithm: Algorithm::MaxProduct,
            update: Update::Sparse,
            max_iterations: 40,
            damping: 0.5,
            tolerance: 1e-5,
        },
        clamping: ClampingParameters { mode: ClampingMode::Soft, max_rounds: 3 },
        registration: RegistrationParameters {
            tolerance_mm: None,
            confidence: 0.999,
            max_trials: 100_000,
            allow_reflection: false,
            refine: Refinement::PointToPoint,
        },
        seed: 0,
    };
    match method {
        Method::Balanced => balanced,
        Method::Thesis => MatchParameters {
            features: vec![both(FeatureKind::GaussianCurvature)],
            clamping: ClampingParameters { mode: ClampingMode::Hard, max_rounds: 3 },
            registration: RegistrationParameters { refine: Refinement::None, ..balanced.registration },
            ..balanced
        },
    }
}

/// The effective parameters of a request: its values laid over the preset that its `method` names.
///
/// # Errors
/// Every fault found, each with its JSON pointer: unknown keys, wrong types, values out of range.
pub fn resolve(request: &Value) -> Result<MatchParameters, Vec<ParameterError>> {
    let method = match request.get("method") {
        None => Method::Balanced,
        Some(name) => serde_json::from_value(name.clone()).map_err(|_| {
            let known: Vec<_> = Method::ALL.iter().map(|m| m.name()).collect();
            vec![fault("/method", "out_of_range", format!("unknown method; known are {}", known.join(", ")))]
        })?,
    };
    let mut merged = serde_json::to_value(preset(method)).unwrap_or(Value::Null);
    let mut faults = Vec::new();
    overlay(&mut merged, request, &mut String::new(), &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let parameters: MatchParameters = serde_path_to_error::deserialize(merged).map_err(|e| {
        let pointer = format!("/{}", e.path().to_string().replace(['.', '['], "/").replace(']', ""));
        vec![fault(&pointer, "wrong_type", e.inner().to_string())]
    })?;
    let faults = out_of_range(&parameters);
    if faults.is_empty() { Ok(parameters) } else { Err(faults) }
}

fn fault(pointer: &str, code: &str, detail: String) -> ParameterError {
    ParameterError { pointer: pointer.to_owned(), code: code.to_owned(), detail }
}

/// Lays `request` over `base`: objects key by key, anything else replaces. Unknown keys are faults.
fn overlay(base: &mut Value, request: &Value, pointer: &mut String, faults: &mut Vec<ParameterError>) {
    match (base, request) {
        (Value::Object(base), Value::Object(request)) => {
            for (key, value) in request {
                let length = pointer.len();
                pointer.push('/');
                pointer.push_str(&key.replace('~', "~0").replace('/', "~1"));
                match base.get_mut(key) {
                    Some(slot) => overlay(slot, value, pointer, faults),
                    None => {
                        let mut known: Vec<_> = base.keys().map(String::as_str).collect();
                        known.sort_unstable();
                        faults.push(fault(
                            pointer,
                            "unknown_key",
                            format!("unknown key; known here are {}", known.join(", ")),
                        ));
                    }
                }
                pointer.truncate(length);
            }
        }
        (Value::Object(_), _) => {
            faults.push(fault(pointer, "wrong_type", "an object is needed here".to_owned()));
        }
        (slot, value) => *slot = value.clone(),
    }
}

/// Every value outside its range.
fn out_of_range(p: &MatchParameters) -> Vec<ParameterError> {
    let mut faults = Vec::new();
    let mut check = |ok: bool, pointer: &str, detail: &str| {
        if !ok {
            faults.push(fault(pointer, "out_of_range", detail.to_owned()));
        }
    };
    check(p.input.labels.as_ref().is_none_or(|l| !l.is_empty()), "/input/labels", "name at least one label, or null");
    check(
        p.input.labels.as_ref().is_none_or(|l| !l.contains(&0)),
        "/input/labels",
        "label 0 is the background; name labels from 1 on",
    );
    check((0.0..=10.0).contains(&p.input.smoothing_mm), "/input/smoothing_mm", "must be from 0 to 10 mm");
    check((1..=8).contains(&p.features.len()), "/features", "state from 1 to 8 features");
    for (k, f) in p.features.iter().enumerate() {
        let at = format!("/features/{k}");
        check((1..=8).contains(&f.scales_mm.len()), &format!("{at}/scales_mm"), "state from 1 to 8 scales");
        for (s, scale) in f.scales_mm.iter().enumerate() {
            check((0.0..=100.0).contains(scale), &format!("{at}/scales_mm/{s}"), "must be from 0 to 100 mm");
        }
        check(f.weight > 0.0 && f.weight <= 100.0, &format!("{at}/weight"), "must be more than 0, at most 100");
    }
    let e = &p.energy;
    check((0.0..=1000.0).contains(&e.alpha), "/energy/alpha", "must be from 0 to 1000");
    check((0.0..=1000.0).contains(&e.beta), "/energy/beta", "must be from 0 to 1000");
    check(e.truncation > 0.0 && e.truncation <= 60.0, "/energy/truncation", "must be more than 0, at most 60");
    check((1..=4).contains(&e.neighborhood_rings), "/energy/neighborhood_rings", "must be from 1 to 4");
    check((0.1..=10.0).contains(&e.minkowski_p), "/energy/minkowski_p", "must be from 0.1 to 10");
    check(e.feature_cap > 0.0 && e.feature_cap <= 100.0, "/energy/feature_cap", "must be more than 0, at most 100");
    let i = &p.inference;
    check((1..=1000).contains(&i.max_iterations), "/inference/max_iterations", "must be from 1 to 1000");
    check((0.0..1.0).contains(&i.damping), "/inference/damping", "must be from 0 to below 1");
    check((0.0..=1.0).contains(&i.tolerance), "/inference/tolerance", "must be from 0 to 1");
    check(p.clamping.max_rounds <= 20, "/clamping/max_rounds", "must be at most 20");
    let r = &p.registration;
    check(
        r.tolerance_mm.is_none_or(|t| t > 0.0 && t <= 1000.0),
        "/registration/tolerance_mm",
        "must be more than 0, at most 1000 mm, or null",
    );
    check((0.0..1.0).contains(&r.confidence), "/registration/confidence", "must be from 0 to below 1");
    check((1..=10_000_000).contains(&r.max_trials), "/registration/max_trials", "must be from 1 to 10 million");
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn an_empty_request_is_the_default_preset() {
        assert_eq!(resolve(&json!({})), Ok(preset(Method::Balanced)));
    }

    #[test]
    fn every_unknown_key_is_named_with_its_place() {
        let faults = resolve(&json!({"energy": {"alfa": 1}, "sed": 3})).unwrap_err();
        let pointers: Vec<_> = faults.iter().map(|f| f.pointer.as_str()).collect();
        assert_eq!(pointers, ["/energy/alfa", "/sed"]);
    }

    #[test]
    fn ranges_and_types_name_their_place() {
        let at = |request: Value| resolve(&request).unwrap_err()[0].pointer.clone();
        assert_eq!(at(json!({"inference": {"damping": 1.0}})), "/inference/damping");
        assert_eq!(at(json!({"energy": {"alpha": "two"}})), "/energy/alpha");
        assert_eq!(
            at(json!({"features": [{"kind": "gaussian_curvature", "scales_mm": [-1.0]}]})),
            "/features/0/scales_mm/0"
        );
        assert_eq!(at(json!({"features": [{"kind": "spin", "scales_mm": [1.0]}]})), "/features/0/kind");
        assert_eq!(at(json!({"method": "magic"})), "/method");
        assert_eq!(at(json!({"energy": 3})), "/energy");
    }

    #[test]
    fn stored_parameters_resolve_to_themselves() {
        for method in Method::ALL {
            let stored = serde_json::to_value(preset(method)).unwrap();
            assert_eq!(resolve(&stored), Ok(preset(method)));
        }
    }
}
