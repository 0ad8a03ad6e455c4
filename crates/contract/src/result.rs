//! The result document: what a match answers, in the form in which the service and the command line print it.

use super::parameters::{Anatomy, MatchParameters};
use crate::input::InputReport;
use std::fmt::Write;

/// Everything a finished match says. Lengths mm, angles degrees where the name says so.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ResultDocument {
    /// The rigid transform that moves the source onto the target.
    pub transform: TransformDocument,
    /// What supports the transform.
    pub support: SupportDocument,
    /// Symmetric distance of the registered surfaces, vertex to closest point on triangle.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energies; absent where nothing was minimised.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub energy: Option<EnergyDocument>,
    /// How far the labeling keeps neighbours together and covers the target.
    pub topology: ConsistencyDocument,
    /// What each round did: inference, registration, feedback.
    #[cfg_attr(feature = "serde", serde(default))]
    pub rounds: Vec<RoundDocument>,
    /// Poses that were compared, the closest first; empty where there was no choice.
    #[cfg_attr(feature = "serde", serde(default))]
    pub poses: Vec<PoseDocument>,
    /// Whether the answer can be relied on; absent where no displacement field was fitted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub reliability: Option<ReliabilityDocument>,
    /// What knowledge of the structure changed; absent where it had no say.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub anatomy: Option<AnatomyDocument>,
    /// Whether a first-order ellipsoid has two half axes so alike that the rotation about the third is arbitrary.
    #[cfg_attr(feature = "serde", serde(default))]
    pub ambiguous_axes: bool,
    /// The dense correspondence, in columns, one entry for each source vertex that has one.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub correspondences: Option<Correspondences>,
    /// Why inference ended.
    pub stop_reason: StopReason,
    /// Time of each phase, ms; `total` is all of it.
    pub timings_ms: std::collections::BTreeMap<String, f64>,
    /// What made this result, enough to make it again.
    pub provenance: Provenance,
}

/// The transform `p' = R p + t`, `target_from_source`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TransformDocument {
    /// 4×4, row-major: four rows of four numbers, `target_from_source`, mm.
    pub matrix: [[f64; 4]; 4],
    /// The rotation as a unit quaternion, scalar first, scalar not negative. Of the proper part if a reflection was asked for and found.
    pub rotation_quaternion_wxyz: [f64; 4],
    /// Angle of that rotation.
    pub rotation_angle_deg: f64,
    /// Translation `t`.
    pub translation_mm: [f64; 3],
    /// The similarity transform that fits the support best, if it was asked for.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub similarity: Option<SimilarityDocument>,
}

/// A similarity transform `p' = s R p + t`, `target_from_source`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SimilarityDocument {
    /// Scale `s`.
    pub scale: f64,
    /// 4×4, row-major, the scale included, mm.
    pub matrix: [[f64; 4]; 4],
    /// Root mean square residual over the support.
    pub rms_mm: f64,
}

/// What one round did.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RoundDocument {
    /// From 0.
    pub round: u32,
    /// What the energy heard from the registration before.
    pub feedback: Feedback,
    /// Iterations of belief propagation or sweeps.
    pub iterations: u32,
    /// Why they ended.
    pub stop_reason: StopReason,
    /// How the labeling settled.
    pub convergence: ConvergenceDocument,
    /// Energy of the labeling, without clamping terms.
    pub energy: f64,
    /// Inliers of RANSAC.
    pub support: u32,
    /// Whether the answer is this round's.
    pub chosen: bool,
}

/// What the energy of a round heard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Feedback {
    /// Nothing.
    None,
    /// Inliers were fixed to their labels.
    Hard,
    /// The registration of the round before.
    Soft,
    /// A pose on the principal axes that rivals that registration.
    RivalPose,
}

/// How the labeling of a round settled.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ConvergenceDocument {
    /// In a word.
    pub status: ConvergenceStatus,
    /// After how many iterations labelings repeat, if they oscillate.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub period: Option<u32>,
}

/// How a series of labelings settles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ConvergenceStatus {
    /// Nothing changes any more.
    Converged,
    /// Changes still become smaller.
    Slow,
    /// The same labelings return again and again.
    Oscillating,
    /// The minimiser draws at random; it ends with its budget.
    Sampled,
}

/// A pose that was compared with others.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PoseDocument {
    /// Where it comes from.
    pub origin: PoseOrigin,
    /// 4×4, row-major, `target_from_source`, mm.
    pub matrix: [[f64; 4]; 4],
    /// Angle of its rotation against the answered one.
    pub angle_deg: f64,
    /// Root mean square distance of the moved source from the target, over a sample of the source.
    pub rms_mm: f64,
    /// How badly it fits after a coarse bending, lower is better; absent where nothing is bent.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub misfit: Option<f64>,
    /// Whether it mirrors.
    #[cfg_attr(feature = "serde", serde(default))]
    pub mirrored: bool,
}

/// Whether an answer can be relied on.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ReliabilityDocument {
    /// Whether nothing speaks against it. Where something does, every confidence is a tenth of what it would be.
    pub reliable: bool,
    /// What does.
    pub reasons: Vec<UnreliableReason>,
    /// How badly the surfaces fit after a coarse bending: the mean over both of `−ln` of how much of a matching surface
    /// each point sees. Lower is better; about 1 for copies, 1.2 for two subjects.
    pub misfit: f64,
    /// The same for the best pose that is turned by 45 degrees or more against the answered one.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub runner_up_misfit: Option<f64>,
    /// The same for the best pose of the other handedness.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub other_handedness_misfit: Option<f64>,
    /// Correlation of the mean curvatures of corresponding points, in `[−1, 1]`.
    pub curvature_agreement: f64,
    /// Mean cosine between the normals of corresponding points.
    pub normal_agreement: f64,
    /// Robust standard deviation of the distance between the surfaces after bending, along the normals.
    pub residual_mm: f64,
}

/// What knowledge of the structure changed in the correspondences of two subjects.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct AnatomyDocument {
    /// The structure that both surfaces look like.
    pub structure: Anatomy,
    /// How unlike those it was learned from the source is, in their standard deviations: 0.95 is usual.
    pub source_distance: f64,
    /// The same for the target.
    pub target_distance: f64,
    /// Root mean square of how far images slid along the target.
    pub slide_mm: f64,
}

/// What speaks against an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum UnreliableReason {
    /// Corresponding points have different curvatures or normals, or one closed surface is longer by half: they show
    /// different structures.
    UnlikeShape,
    /// A mirrored copy of the source fits better: the two are of different sides, or one image is mirrored.
    OtherHandedness,
    /// Another pose fits as well.
    AmbiguousPose,
}

/// Where a pose comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PoseOrigin {
    /// RANSAC over the labeling of lowest energy, refined.
    Inference,
    /// Registration without an energy.
    Registration,
    /// The landmarks of the request.
    Landmarks,
    /// A search of all orientations.
    Search,
    /// First-order ellipsoids laid on each other.
    FirstOrderEllipsoid,
}

/// What supports the transform.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SupportDocument {
    /// Correspondences whose residual is within the tolerance.
    pub inliers: u32,
    /// Their share of all correspondences.
    pub ratio: f64,
    /// Root mean square of their residuals.
    pub rms_mm: f64,
    /// The tolerance.
    pub tolerance_mm: f64,
    /// RANSAC trials in all rounds.
    pub trials: u64,
    /// Whether the last RANSAC reached its confidence before its budget of trials ended.
    pub confidence_reached: bool,
}

/// Symmetric surface distance.
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

/// Energies of labelings, lower is better.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct EnergyDocument {
    /// Variables of the energy: source vertices, or those of its coarse level.
    #[cfg_attr(feature = "serde", serde(default))]
    pub n_variables: u32,
    /// Labels of each: target vertices, or those of its coarse level.
    #[cfg_attr(feature = "serde", serde(default))]
    pub n_labels: u32,
    /// Of the labeling that each unary potential prefers alone.
    pub initial: f64,
    /// Of the labeling that is answered.
    pub r#final: f64,
    /// Its unary part.
    pub unary: f64,
    /// Its pairwise part.
    pub pairwise: f64,
    /// No labeling has an energy below this, if a bound was asked for.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub lower_bound: Option<f64>,
    /// Edges whose images are not neighbours, each counted with the truncation.
    #[cfg_attr(feature = "serde", serde(default))]
    pub broken_edges: u32,
}

/// Quality of the labeling as a map of surfaces.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ConsistencyDocument {
    /// Share of source edges whose images lie within the neighbourhood radius on the target.
    pub consistency: f64,
    /// Share of target vertices that are somebody's image.
    pub coverage: f64,
    /// Source triangles (quads count as two) whose image points inwards.
    #[cfg_attr(feature = "serde", serde(default))]
    pub flipped_triangles: u32,
    /// Source triangles whose image has two equal corners or no area.
    #[cfg_attr(feature = "serde", serde(default))]
    pub degenerate_triangles: u32,
    /// Source triangles in all.
    #[cfg_attr(feature = "serde", serde(default))]
    pub n_triangles: u32,
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
    /// Its target vertex.
    pub target: Vec<u32>,
    /// Belief in that target vertex, in `[0, 1]`.
    pub confidence: Vec<f64>,
    /// Whether it supports the transform.
    pub inlier: Vec<bool>,
    /// Root mean square distance, on the target, of the belief from its mean, mm.
    #[cfg_attr(feature = "serde", serde(default))]
    pub spread_mm: Vec<f64>,
    /// Whether and why it is an outlier.
    #[cfg_attr(feature = "serde", serde(default))]
    pub outlier: Vec<OutlierReason>,
    /// The target triangle on which its image lies, by its vertices; of a quad, half of it.
    #[cfg_attr(feature = "serde", serde(default))]
    pub triangle: Vec<[u32; 3]>,
    /// Where on it: the weights of the three vertices, not negative and of sum 1.
    #[cfg_attr(feature = "serde", serde(default))]
    pub barycentric: Vec<[f64; 3]>,
    /// The map from the target to the source, if requested: `source` has vertices of the target, `target` and `triangle`
    /// have vertices of the source.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "openapi", schema(no_recursion))]
    pub inverse: Option<Box<Correspondences>>,
}

/// Why a correspondence is an outlier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum OutlierReason {
    /// It is none.
    #[default]
    None,
    /// After registration its two points are further apart than the tolerance.
    Residual,
    /// Most of its neighbours have images that are no neighbours of its own.
    Neighborhood,
    /// Both.
    Both,
    /// The target has nothing where the displacement takes it.
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

    /// The number used where columns hold numbers: 0 none, 1 residual, 2 neighbourhood, 3 both, 4 no
    /// counterpart.
    pub fn code(self) -> u8 {
        self as u8
    }
}

impl Correspondences {
    /// The columns as CSV (RFC 4180): a header, then a line for each correspondence.
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

    /// These columns with those that earlier versions did not write filled in; none if lengths differ otherwise.
    pub fn completed(mut self) -> Option<Self> {
        let n = self.source.len();
        if self.spread_mm.is_empty() {
            self.spread_mm = vec![0.0; n];
        }
        if self.outlier.is_empty() {
            self.outlier = vec![OutlierReason::None; n];
        }
        if self.triangle.is_empty() {
            self.triangle = self.target.iter().map(|&x| [x; 3]).collect();
            self.barycentric = vec![[1.0, 0.0, 0.0]; n];
        }
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
    /// The budget of iterations of the last round ended.
    MaxIterations,
    /// The stated energy was reached: the answer is certified.
    TargetReached,
    /// Nothing was minimised.
    RegistrationOnly,
}

/// What made a result.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Provenance {
    /// Version of homolog.
    pub version: String,
    /// Commit it was built from, `unknown` outside a checkout.
    pub commit: String,
    /// Effective parameters.
    pub parameters: MatchParameters,
    /// Seed of everything drawn at random.
    pub seed: u64,
    /// The source.
    pub source: InputProvenance,
    /// The target.
    pub target: InputProvenance,
}

/// What one input was and what was made of it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputProvenance {
    /// Content hash of the bytes as uploaded, `blake3:` and 64 hexadecimal digits.
    pub hash: String,
    /// Vertices of the surface that was matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs.
    pub report: InputReport,
}

#[cfg(test)]
mod tests {
    use super::*;

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
