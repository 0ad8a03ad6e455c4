//! The result document of a match, in the form printed by the service and the command line.

use super::parameters::MatchParameters;
use crate::input::{InputReport, InputWarning};
pub use crate::reason::UnreliableReason;
use std::fmt::Write;

/// The result of a match. Lengths are in mm; angles are in degrees where the name ends in `_deg`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ResultDocument {
    /// The rigid transform that moves the source onto the target.
    pub transform: TransformDocument,
    /// The correspondences that support the transform.
    pub support: SupportDocument,
    /// Symmetric distance between the registered surfaces, from each vertex to the closest point of the other surface.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energies of the assignment (a target vertex for each variable); absent where none was minimized (`inference.algorithm` is `none`, as by default).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub energy: Option<EnergyDocument>,
    /// How well the assignment keeps neighbors together, and how much of the target it covers.
    pub topology: ConsistencyDocument,
    /// How the map to the corresponding points deforms the source surface; absent if no source triangle has a counterpart on the
    /// target, and in results of version 0.1.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub deformation: Option<DeformationDocument>,
    /// The rounds of inference, registration and feedback, in order; empty where no energy was minimized.
    pub rounds: Vec<RoundDocument>,
    /// Candidate poses that were compared, the best first; empty where there was only one.
    pub poses: Vec<PoseDocument>,
    /// Whether the answer can be relied on; absent where no smooth displacement field could be fitted to say so.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub reliability: Option<ReliabilityDocument>,
    /// Findings in the inputs and changes of them, each sentence with its input, and findings on the pair.
    /// The reasons among them are in `reliability.reasons` too.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub warnings: Vec<InputWarning>,
    /// Whether two semi-axes of a first-order ellipsoid are so nearly equal that the rotation about the third is arbitrary.
    pub ambiguous_axes: bool,
    /// The dense correspondence in columns, one entry for each source vertex.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub correspondences: Option<Correspondences>,
    /// Why inference ended.
    pub stop_reason: StopReason,
    /// Time of each phase, ms; `total` is the time of the whole match.
    pub timings_ms: std::collections::BTreeMap<String, f64>,
    /// Version, parameters, seed and inputs: all that is needed to reproduce this result.
    pub provenance: Provenance,
}

/// The rigid transform `p' = R p + t` from source to target coordinates. One that mirrors is `p' = R S p + t`, with a reflection
/// `S` first: `matrix` is the whole, and quaternion, angle and translation are `R` and `t`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TransformDocument {
    /// 4×4, row-major: four rows of four numbers, `target_from_source`, mm.
    pub matrix: [[f64; 4]; 4],
    /// Whether the matrix mirrors (its determinant is −1): one input was mirrored (`input.source.mirror`, `input.target.mirror`), or a
    /// reflection was allowed and fits better (`registration.allow_reflection`).
    pub mirrored: bool,
    /// The reflection `S` of a transform that mirrors, in source coordinates, which comes first: 4×4, row-major, mm, its own inverse.
    /// In a plane where an input was mirrored, else in the origin (`S p = −p`). `matrix` is the rotation and
    /// translation below times this.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub reflection: Option<[[f64; 4]; 4]>,
    /// The rotation `R` as a unit quaternion, scalar part first and not negative. A rotation also where the transform mirrors: that
    /// which follows `reflection`.
    pub rotation_quaternion_wxyz: [f64; 4],
    /// Angle of that rotation.
    pub rotation_angle_deg: f64,
    /// Translation `t`, mm, after reflection and rotation.
    pub translation_mm: [f64; 3],
    /// The similarity transform that fits the support best; absent unless `registration.similarity` asked for it. If the sizes of the
    /// surfaces differ so that the source was matched at the size of the target, it is there without being asked for, and
    /// fits all vertices with a counterpart.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub similarity: Option<SimilarityDocument>,
}

/// A similarity transform `p' = s R p + t` from source to target coordinates.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SimilarityDocument {
    /// Scale `s`.
    pub scale: f64,
    /// 4×4 matrix, row-major, including the scale, mm.
    pub matrix: [[f64; 4]; 4],
    /// Root mean square residual over the vertices that it fits, mm.
    pub rms_mm: f64,
}

/// One round: inference, then registration of its assignment.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RoundDocument {
    /// Number of the round, from 0.
    pub round: u32,
    /// Feedback that the energy received from an earlier registration.
    pub feedback: Feedback,
    /// Iterations of belief propagation, or sweeps of a randomized minimizer.
    pub iterations: u32,
    /// Why inference ended in this round.
    pub stop_reason: StopReason,
    /// How the assignments of this round converged.
    pub convergence: ConvergenceDocument,
    /// Energy of the assignment, without the terms of the feedback.
    pub energy: f64,
    /// Inliers of RANSAC. 0: no rigid transform is supported by three pairs of this assignment. No round follows then, and
    /// the pose is that of an earlier round, of the landmarks or of a search of all orientations.
    pub support: u32,
    /// Whether the match went on with the assignment and transform of this round. No round is chosen where none found a
    /// transform.
    pub chosen: bool,
}

/// Feedback that the energy of a round received.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Feedback {
    /// No feedback.
    None,
    /// The inliers of the round before were fixed to their target vertices.
    Hard,
    /// Distances and normals under the transform of the round before were added to the unary potentials.
    Soft,
    /// The same under a candidate pose on the principal axes that fits clearly better than that transform.
    #[cfg_attr(feature = "serde", serde(rename = "rival_pose"))]
    CandidatePose,
}

/// How the assignments of a round converged.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ConvergenceDocument {
    /// Whether they converged.
    pub status: ConvergenceStatus,
    /// Number of iterations after which assignments repeat; absent unless they oscillate.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub period: Option<u32>,
}

/// Convergence of a series of assignments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ConvergenceStatus {
    /// The assignment no longer changes.
    Converged,
    /// The assignment still changes, less and less.
    Slow,
    /// The same assignments recur periodically.
    Oscillating,
    /// The minimizer draws at random and does not converge in this sense.
    Sampled,
}

/// A candidate pose.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PoseDocument {
    /// Where the pose comes from.
    pub origin: PoseOrigin,
    /// 4×4, row-major, `target_from_source`, mm.
    pub matrix: [[f64; 4]; 4],
    /// Angle between its rotation and that of the answer.
    pub angle_deg: f64,
    /// Root mean square distance of the moved source from the target, over a sample of source vertices, mm.
    pub rms_mm: f64,
    /// Misfit after a coarse deformation from this pose, lower is better; absent without a displacement field.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Whether the pose mirrors the source.
    pub mirrored: bool,
    /// Whether this pose, of the handedness of the answer, explains both surfaces as well as the answer: the reason `ambiguous_pose`.
    /// Absent if not.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "std::ops::Not::not"))]
    pub as_good: bool,
}

/// Whether an answer can be relied on. The measures are those of the smooth displacement field: of the answer itself where the method fits one, else of the
/// answer of the default method, with which it is compared.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ReliabilityDocument {
    /// Whether no reason was found to doubt the answer. If there is one, every confidence is multiplied by 0.1.
    pub reliable: bool,
    /// The reasons to doubt it.
    pub reasons: Vec<UnreliableReason>,
    /// Misfit of the answered pose after a coarse deformation: the mean over the points of both surfaces of `−ln` of the
    /// likelihood of the other surface there. Lower is better; about 1 for copies, 1.2 for two subjects.
    pub misfit: f64,
    /// The same for the best pose that is rotated by at least 45 degrees against the answered one.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub runner_up_misfit: Option<f64>,
    /// The same for the best pose of the other handedness.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub other_handedness_misfit: Option<f64>,
    /// Correlation of the mean curvatures of corresponding points, in `[−1, 1]`.
    pub curvature_agreement: f64,
    /// Mean cosine between the normals of corresponding points, over the area of the source.
    pub normal_agreement: f64,
    /// How far the deformation is from one that keeps angles: the mean over the area of the source of the logarithm of how many
    /// times longer than wide a small circle becomes. 0 for similarities; about 0.2 for two subjects. Absent in results of
    /// version 0.1.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub distortion: Option<f64>,
    /// Robust standard deviation of the distance between the deformed source and the target along the normals, mm.
    pub residual_mm: f64,
    /// How this answer compares with that of the default method; absent where the method fits the smooth displacement field itself.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub second_opinion: Option<SecondOpinionDocument>,
}

/// An answer beside that of the default method for the same surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SecondOpinionDocument {
    /// Angle between the two transforms, degrees; 180 if one of them mirrors.
    pub angle_deg: f64,
    /// How far the corresponding points agree: 1 less the mean distance of the two images of a vertex, divided by that of images of
    /// unrelated vertices. 1 for equal maps, about 0 for unrelated ones.
    pub agreement: f64,
}

/// Factor on the confidences of an answer that is not reliable for another reason than an ambiguous pose.
pub const UNRELIABLE_CONFIDENCE: f64 = 0.1;

/// Factor on the confidences of an answer that is not reliable for these `reasons`, where `n_as_good` other poses explain
/// the surfaces as well: of these and its own pose each is as probable. 1 without a reason.
pub fn confidence_factor(reasons: &[UnreliableReason], n_as_good: usize) -> f64 {
    let is_doubted = reasons.iter().any(|reason| *reason != UnreliableReason::AmbiguousPose);
    let of_pose = 1.0 / (1 + n_as_good) as f64;
    if is_doubted { UNRELIABLE_CONFIDENCE * of_pose } else { of_pose }
}

/// Where a pose comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PoseOrigin {
    /// RANSAC over the assignment of the chosen round, refined.
    Inference,
    /// Registration without an energy.
    Registration,
    /// The landmarks of the request.
    Landmarks,
    /// A search of all orientations.
    Search,
    /// The rigid part of a correspondence that keeps distances along the surfaces, begun from their bending-invariant forms or extremities.
    Form,
    /// Alignment of the first-order ellipsoids.
    FirstOrderEllipsoid,
}

/// The correspondences that support the transform.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SupportDocument {
    /// Correspondences whose residual is within the tolerance.
    pub inliers: u32,
    /// Their share of all correspondences, from 0 to 1.
    pub ratio: f64,
    /// Root mean square of their residuals, mm.
    pub rms_mm: f64,
    /// Largest residual of an inlier, mm.
    pub tolerance_mm: f64,
    /// RANSAC trials in all rounds that found a transform.
    pub trials: u64,
    /// Whether RANSAC reached its confidence in the chosen round before its budget of trials ended.
    pub confidence_reached: bool,
}

/// Symmetric surface distance, mm.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SurfaceDistanceDocument {
    /// Mean over the vertices of both surfaces.
    pub mean_mm: f64,
    /// 95th percentile.
    pub p95_mm: f64,
    /// Maximum (Hausdorff distance over vertices).
    pub max_mm: f64,
}

/// Energies of assignments, lower is better.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct EnergyDocument {
    /// Number of variables of the energy: vertices of the source, or of its coarse level.
    pub n_variables: u32,
    /// Number of target vertices, or of those of its coarse level, to which a variable may be assigned.
    pub n_target_vertices: u32,
    /// Energy of the assignment that minimizes every unary potential by itself.
    pub initial: f64,
    /// Energy of the answered assignment.
    pub r#final: f64,
    /// The same for each variable, which compares pairs of different sizes. By default about 2 for copies of a hippocampus and 3.5 to 4 for two
    /// subjects; 0 in results of versions that did not state it.
    pub per_variable: f64,
    /// Unary part of that energy.
    pub unary: f64,
    /// Pairwise part of that energy.
    pub pairwise: f64,
    /// No assignment has an energy below this; absent unless `inference.lower_bound_iterations` asked for a bound.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub lower_bound: Option<f64>,
    /// Number of source edges whose two target vertices are not within the neighborhood radius; each costs the truncation.
    pub broken_edges: u32,
}

/// Quality of the assignment as a map of surfaces.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ConsistencyDocument {
    /// Share of source edges whose two images lie within the neighborhood radius of each other on the target.
    pub consistency: f64,
    /// Share of target vertices that correspond to at least one source vertex.
    pub coverage: f64,
    /// Source triangles (a quad counts as two) whose image is oriented inwards.
    pub flipped_triangles: u32,
    /// Source triangles whose image has two equal corners or no area.
    pub degenerate_triangles: u32,
    /// All source triangles.
    pub n_triangles: u32,
}

/// How the map to the corresponding points deforms the source surface that was matched. Source triangles (a quad counts as two)
/// with a corner that has no counterpart are left out of areas and folds. The area ratio at every vertex is an array of the
/// bent surface.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct DeformationDocument {
    /// Source triangles whose image, the triangle between the corresponding points of its corners, faces against the target's
    /// normals there. `topology.flipped_triangles` counts the same for the nearest target vertices.
    pub folded_triangles: u32,
    /// Their share of the area of the source, from 0 to 1.
    pub folded_area_share: f64,
    /// Area of all images divided by the area of the source: the mean area ratio over the source.
    pub area_ratio: f64,
    /// 5th percentile of the area ratio over the source vertices: area of the images of the triangles around a vertex, divided by
    /// the area of these triangles.
    pub area_ratio_p05: f64,
    /// 95th percentile of the same.
    pub area_ratio_p95: f64,
    /// Volume enclosed by the images divided by the volume enclosed by the source; null unless both surfaces are closed.
    pub volume_ratio: Option<f64>,
}

/// The dense correspondence in columns of equal length, rows in ascending order of `source`.
///
/// Vertex indices count, from 0, the vertices of the uploaded mesh or, for a label volume, of the surface made from it. A
/// vertex that no face uses or that a repair dropped occurs in no column; of vertices welded into one, only the first does.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Correspondences {
    /// Source vertex.
    pub source: Vec<u32>,
    /// Index of its target vertex.
    pub target: Vec<u32>,
    /// Confidence in that target vertex, from 0 to 1.
    pub confidence: Vec<f64>,
    /// Whether the pair supports the transform.
    pub inlier: Vec<bool>,
    /// Expected distance of the true corresponding point from the answered one: the spread of the belief over target
    /// vertices, or of the displacement field, mm.
    pub spread_mm: Vec<f64>,
    /// Whether and why the pair is an outlier.
    pub outlier: Vec<OutlierReason>,
    /// Vertices of the target triangle on which the image lies; of a quad, one of its halves.
    pub triangle: Vec<[u32; 3]>,
    /// Barycentric coordinates of the image on that triangle: weights of its three vertices, not negative, of sum 1.
    pub barycentric: Vec<[f64; 3]>,
    /// The map from the target to the source, if requested: `source` has vertices of the target, `target` and `triangle`
    /// have vertices of the source.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "openapi", schema(no_recursion))]
    pub inverse: Option<Box<Correspondences>>,
}

/// Which surface is bent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum WarpDirection {
    /// The source onto the target.
    Forward,
    /// The target onto the source; needs the inverse correspondences.
    Inverse,
}

impl WarpDirection {
    /// The name used in requests.
    pub fn name(self) -> &'static str {
        match self {
            WarpDirection::Forward => "forward",
            WarpDirection::Inverse => "inverse",
        }
    }
}

/// The coordinates in which a bent surface is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum WarpSpace {
    /// Those of the source.
    Source,
    /// Those of the target.
    Target,
}

impl WarpSpace {
    /// The name used in requests.
    pub fn name(self) -> &'static str {
        match self {
            WarpSpace::Source => "source",
            WarpSpace::Target => "target",
        }
    }
}

/// Why a correspondence is an outlier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum OutlierReason {
    /// Not an outlier.
    #[default]
    None,
    /// After registration the two points are further apart than the tolerance.
    Residual,
    /// The images of most of its neighbors are not near its own image.
    Neighborhood,
    /// Both.
    Both,
    /// The displacement field moves the vertex to a place where the target has no surface.
    NoCounterpart,
}

impl OutlierReason {
    /// The name used in JSON and CSV.
    pub fn name(self) -> &'static str {
        match self {
            OutlierReason::None => "none",
            OutlierReason::Residual => "residual",
            OutlierReason::Neighborhood => "neighborhood",
            OutlierReason::Both => "both",
            OutlierReason::NoCounterpart => "no_counterpart",
        }
    }

    /// The number used where columns hold numbers: 0 none, 1 residual, 2 neighborhood, 3 both, 4 no
    /// counterpart.
    pub fn code(self) -> u8 {
        self as u8
    }
}

fn upper_median(values: &[f64]) -> Option<f64> {
    let mut values = values.to_vec();
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

impl EnergyDocument {
    /// The lowest energy of these `rounds`, or that of the answer if there were none.
    pub fn minimized(&self, rounds: &[RoundDocument]) -> f64 {
        rounds.iter().map(|round| round.energy).min_by(f64::total_cmp).unwrap_or(self.r#final)
    }
}

impl Correspondences {
    /// The median confidence, the upper one of two; `None` without pairs.
    pub fn median_confidence(&self) -> Option<f64> {
        upper_median(&self.confidence)
    }

    /// The median expected error, mm; as for the confidence.
    pub fn median_spread_mm(&self) -> Option<f64> {
        upper_median(&self.spread_mm)
    }

    /// The columns as CSV (RFC 4180): a header, then one line for each correspondence.
    pub fn to_csv(&self) -> String {
        let mut text = String::with_capacity(120 * self.source.len() + 150);
        text.push_str("source,target,confidence,inlier,spread_mm,outlier,");
        text.push_str("triangle_0,triangle_1,triangle_2,barycentric_0,barycentric_1,barycentric_2\r\n");
        for row in 0..self.source.len() {
            let (source, target, inlier) = (self.source[row], self.target[row], self.inlier[row]);
            let (confidence, spread, outlier) = (self.confidence[row], self.spread_mm[row], self.outlier[row].name());
            // Writing to a string cannot fail.
            let _ = write!(text, "{source},{target},{confidence},{inlier},{spread},{outlier},");
            let ([a, b, c], [u, v, w]) = (self.triangle[row], self.barycentric[row]);
            let _ = write!(text, "{a},{b},{c},{u},{v},{w}\r\n");
        }
        text
    }

    /// These columns, if their lengths are equal; `None` otherwise.
    pub fn checked(self) -> Option<Self> {
        let n = self.source.len();
        let lengths =
            [self.target.len(), self.confidence.len(), self.inlier.len(), self.spread_mm.len(), self.outlier.len()];
        (lengths == [n; 5] && [self.triangle.len(), self.barycentric.len()] == [n; 2]).then_some(self)
    }
}

/// Why inference ended. Not converging is an outcome, not an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum StopReason {
    /// Messages changed by no more than the tolerance in the last round.
    Converged,
    /// The last round used up its budget of iterations.
    MaxIterations,
    /// The target energy was reached, which certifies the answer.
    TargetReached,
    /// No energy of assignments was minimized.
    RegistrationOnly,
}

/// All that is needed to reproduce a result.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Provenance {
    /// Version of homolog.
    pub version: String,
    /// Commit from which it was built; `unknown` if it was not built in a git checkout.
    pub commit: String,
    /// The effective parameters.
    pub parameters: MatchParameters,
    /// Seed of all random draws.
    pub seed: u64,
    /// The source.
    pub source: InputProvenance,
    /// The target.
    pub target: InputProvenance,
}

/// One input and the surface made of it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputProvenance {
    /// Hash of the uploaded bytes: `blake3:` and 64 hexadecimal digits.
    pub hash: String,
    /// Vertices of the surface that was matched.
    pub n_vertices: u32,
    /// Faces of that surface.
    pub n_faces: u32,
    /// Format, topology and repairs.
    pub report: InputReport,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_is_divided_among_poses_that_are_as_good_and_a_tenth_for_other_reasons() {
        use UnreliableReason::{AmbiguousPose, OtherHandedness, UnlikeShape};
        assert_eq!(confidence_factor(&[], 0), 1.0);
        assert_eq!(confidence_factor(&[AmbiguousPose], 3), 0.25);
        assert_eq!(confidence_factor(&[UnlikeShape], 0), UNRELIABLE_CONFIDENCE);
        assert_eq!(confidence_factor(&[UnlikeShape, OtherHandedness, AmbiguousPose], 1), 0.5 * UNRELIABLE_CONFIDENCE);
    }

    #[test]
    fn csv_has_a_header_and_a_row_for_each_pair() {
        let columns = Correspondences {
            source: vec![0, 1],
            target: vec![5, 4],
            confidence: vec![0.5, 1.0],
            inlier: vec![true, false],
            spread_mm: vec![0.25, 3.0],
            outlier: vec![OutlierReason::None, OutlierReason::Residual],
            triangle: vec![[5, 6, 7], [2, 3, 4]],
            barycentric: vec![[0.5, 0.25, 0.25], [0.0, 0.0, 1.0]],
            inverse: None,
        };
        let text = columns.to_csv();
        let expected = [
            "source,target,confidence,inlier,spread_mm,outlier,\
             triangle_0,triangle_1,triangle_2,barycentric_0,barycentric_1,barycentric_2",
            "0,5,0.5,true,0.25,none,5,6,7,0.5,0.25,0.25",
            "1,4,1,false,3,residual,2,3,4,0,0,1",
        ];
        assert_eq!(text.split_terminator("\r\n").collect::<Vec<_>>(), expected);
    }
}
