//! The result document: what a match answers, in the form in which the service and the command line print it.

use super::parameters::MatchParameters;
use crate::intake::InputReport;
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use utoipa::ToSchema;

/// Everything a finished match says. Lengths mm, angles degrees where the name says so.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ResultDocument {
    /// The rigid transform that moves the source onto the target.
    pub transform: TransformDocument,
    /// What supports the transform.
    pub support: SupportDocument,
    /// Symmetric distance of the registered surfaces, vertex to closest point on triangle.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energy of the labeling, without clamping terms.
    pub energy: EnergyDocument,
    /// How far the labeling keeps neighbours together and covers the target.
    pub topology: ConsistencyDocument,
    /// The dense correspondence, in columns, one entry for each source vertex that has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correspondences: Option<Correspondences>,
    /// Why inference ended.
    pub stop_reason: StopReason,
    /// Time of each phase, ms; `total` is all of it.
    pub timings_ms: std::collections::BTreeMap<String, f64>,
    /// What made this result, enough to make it again.
    pub provenance: Provenance,
}

/// The transform `p' = R p + t`, `target_from_source`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct TransformDocument {
    /// 4×4, row-major: four rows of four numbers, `target_from_source`, mm.
    pub matrix: [[f64; 4]; 4],
    /// The rotation as a unit quaternion, scalar first, scalar not negative. Of the proper part if a reflection was asked for and found.
    pub rotation_quaternion_wxyz: [f64; 4],
    /// Angle of that rotation.
    pub rotation_angle_deg: f64,
    /// Translation `t`.
    pub translation_mm: [f64; 3],
}

/// What supports the transform.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SurfaceDistanceDocument {
    /// Mean over the vertices of both surfaces.
    pub mean_mm: f64,
    /// 95th percentile.
    pub p95_mm: f64,
    /// Maximum (Hausdorff distance over vertices).
    pub max_mm: f64,
}

/// Energies of labelings, lower is better.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct EnergyDocument {
    /// Of the labeling that each unary potential prefers alone.
    pub initial: f64,
    /// Of the labeling that is answered.
    pub r#final: f64,
    /// Its unary part.
    pub unary: f64,
    /// Its pairwise part.
    pub pairwise: f64,
}

/// Quality of the labeling as a map of surfaces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ConsistencyDocument {
    /// Share of source edges whose images lie within the neighbourhood radius on the target.
    pub consistency: f64,
    /// Share of target vertices that are somebody's image.
    pub coverage: f64,
}

/// The dense correspondence in columns of equal length.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, ToSchema)]
pub struct Correspondences {
    /// Source vertex, as uploaded, or of the surface made from the volume.
    pub source: Vec<u32>,
    /// Its target vertex.
    pub target: Vec<u32>,
    /// Belief in that target vertex, in `[0, 1]`.
    pub confidence: Vec<f64>,
    /// Whether it supports the transform.
    pub inlier: Vec<bool>,
}

impl Correspondences {
    /// The columns as CSV (RFC 4180): a header, then a line for each correspondence.
    pub fn to_csv(&self) -> String {
        let mut text = String::with_capacity(32 * self.source.len() + 40);
        text.push_str("source,target,confidence,inlier\r\n");
        let rows = self.source.iter().zip(&self.target).zip(self.confidence.iter().zip(&self.inlier));
        for ((source, target), (confidence, inlier)) in rows {
            // Writing to a string cannot fail.
            let _ = write!(text, "{source},{target},{confidence},{inlier}\r\n");
        }
        text
    }
}

/// Why inference ended. Not converging is an outcome, not an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum StopReason {
    /// Messages changed by no more than the tolerance in the last round.
    Converged,
    /// The budget of iterations of the last round ended.
    MaxIterations,
}

/// What made a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
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
        };
        assert_eq!(columns.to_csv(), "source,target,confidence,inlier\r\n0,5,0.5,true\r\n1,4,1,false\r\n");
    }
}
