//! The stored results of one match: positions of the vertices of one surface on the other, and evidence for its
//! reliability. A record is a small binary file: the match itself, with its energies and timings, is not stored.

use crate::rotation::{angle, rows};
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::{PoseDocument, WarpDirection, WarpSpace};
use homolog_formats::{VertexArray, VertexValues};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Observer;
use homolog_registration::{RigidTransform, SAME_POSE_ANGLE};
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, RunError, RunOutput, SurfaceCache, run_match_with};
use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

/// First bytes of a record.
const MAGIC: &[u8; 8] = b"hmlgrec2";

/// The stored results of one match.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Facts on the surfaces and the match.
    pub facts: Facts,
    /// For each vertex of the source the corresponding point on the target, in the target's coordinates, mm, mirrored
    /// in `x = 0` if the target was mirrored; empty if the match failed.
    pub points: Vec<[f32; 3]>,
}

/// Scalars of one match.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Facts {
    /// Reason why there is no match; without file names.
    pub error: Option<String>,
    /// Whether no reason was found to doubt the match; `None` for methods that do not judge.
    pub reliable: Option<bool>,
    /// The reasons to doubt it.
    pub reasons: Vec<String>,
    /// Mean distance between the surfaces after rigid registration, mm.
    pub rigid_distance_mm: f64,
    /// Mean distance from the vertices of the target to the bent source, mm.
    pub residual_mm: f64,
    /// Its 95th percentile, mm.
    pub residual_p95_mm: f64,
    /// Share of triangles of the source that the map turns over, or leaves without area: beyond the rigid transform,
    /// their normals rotate by 90 degrees or more.
    pub folded: f64,
    /// Median confidence of the correspondences.
    pub confidence: f64,
    /// Volume enclosed by the target as read, mm³; `None` if it is not closed.
    pub volume_mm3: Option<f64>,
    /// Area of the target as read, mm².
    pub area_mm2: f64,
    /// Vertices of the target as read.
    pub n_vertices: u32,
    /// Repairs of the target, a sentence each.
    pub repairs: Vec<String>,
    /// Rotations of the other poses that explain the surfaces as well, from the source to the target as in `points`, the best
    /// first; empty unless the pose is ambiguous, and where two of these poses differ by more than a rotation.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rivals: Vec<[[f64; 3]; 3]>,
}

/// Reason why bytes are not a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("it is not a record of a match, or is damaged; delete it, and it is computed again")]
pub struct NoRecord;

impl Record {
    /// Whether it maps a surface with this number of vertices.
    pub(crate) fn is_map_of(&self, n_vertices: usize) -> bool {
        self.facts.error.is_none() && self.points.len() == n_vertices
    }

    /// Whether it does, and is not known to be unreliable.
    pub(crate) fn is_reliable_map_of(&self, n_vertices: usize) -> bool {
        self.is_map_of(n_vertices) && self.facts.reliable != Some(false)
    }

    /// The bytes of the record; equal records have equal bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let facts = serde_json::to_vec(&self.facts).unwrap_or_default();
        let mut bytes = MAGIC.to_vec();
        bytes.extend((facts.len() as u32).to_le_bytes());
        bytes.extend((self.points.len() as u32).to_le_bytes());
        bytes.extend(self.points.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend(facts);
        let sum = blake3::hash(&bytes);
        bytes.extend(&sum.as_bytes()[..8]);
        bytes
    }

    /// Reads the bytes of a record.
    ///
    /// # Errors
    /// [`NoRecord`] if a byte is missing or different.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, NoRecord> {
        let body = bytes.len().checked_sub(8).ok_or(NoRecord)?;
        let (bytes, sum) = bytes.split_at(body);
        if sum != &blake3::hash(bytes).as_bytes()[..8] {
            return Err(NoRecord);
        }
        let rest = bytes.strip_prefix(MAGIC).ok_or(NoRecord)?;
        let number = |at: usize| {
            let four = rest.get(at..at + 4).and_then(|four| <[u8; 4]>::try_from(four).ok());
            four.map(u32::from_le_bytes).ok_or(NoRecord)
        };
        let (n_facts, n_points) = (number(0)? as usize, number(4)? as usize);
        let rest = &rest[8..];
        if rest.len() != n_facts + 12 * n_points {
            return Err(NoRecord);
        }
        let (points, facts) = rest.split_at(12 * n_points);
        let facts = serde_json::from_slice(facts).map_err(|_| NoRecord)?;
        Ok(Record { facts, points: read_points(points) })
    }

    /// Offset of the points in a record, bytes.
    pub(crate) const POINTS_AT: u64 = 16;

    /// The record of a failed match.
    pub fn failed(error: String) -> Self {
        Record { facts: Facts { error: Some(error), ..Facts::default() }, points: Vec::new() }
    }

    /// The record of a match.
    pub fn of(output: &RunOutput) -> Self {
        let bent = match homolog_run::warp(
            [&output.source, &output.target],
            output.document.correspondences.as_ref().unwrap_or(&Default::default()),
            &output.document.transform.matrix,
            WarpDirection::Forward,
            WarpSpace::Target,
        ) {
            Ok(bent) => bent,
            Err(error) => return Record::failed(error.to_string()),
        };
        let distances = distances(&output.target, &bent.mesh);
        let n = distances.len().max(1);
        let confidence = |arrays: &[VertexArray]| {
            let found = arrays.iter().find(|array| array.name == "confidence").map(|array| &array.values);
            let mut values = if let Some(VertexValues::Real(values)) = found { values.clone() } else { Vec::new() };
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied().unwrap_or(0.0)
        };
        let verdict = output.document.verdict();
        let input = &output.document.provenance.target;
        let closed = output.target.boundary_vertices().is_none();
        let is_mirrored = output.document.provenance.parameters.input.target.mirror;
        let facts = Facts {
            error: None,
            reliable: verdict.reliable,
            reasons: verdict.reasons.iter().map(|reason| reason.name().to_owned()).collect(),
            rigid_distance_mm: verdict.surface_distance.mean_mm,
            residual_mm: distances.iter().sum::<f64>() / n as f64,
            residual_p95_mm: distances.get(n * 19 / 20).copied().unwrap_or(0.0),
            folded: {
                let transform = RigidTransform::of_matrix(&output.document.transform.matrix);
                folded(&output.source, &bent.mesh, &transform.rotation)
            },
            confidence: confidence(&bent.arrays),
            volume_mm3: closed.then(|| output.target.signed_volume()),
            area_mm2: output.target.area(),
            n_vertices: distances.len() as u32,
            repairs: input.report.repairs.iter().map(|repair| repair.detail.clone()).collect(),
            rivals: rivals(&output.document.poses, is_mirrored),
        };
        let points = crate::mirror::in_file(bent.mesh.vertices().to_vec(), is_mirrored);
        let points = points.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        Record { facts, points }
    }
}

/// The rotations of the poses that are as good as the answer, in the coordinates of a record; none if a rotation alone does not
/// say which pose it is.
fn rivals(poses: &[PoseDocument], is_mirrored: bool) -> Vec<[[f64; 3]; 3]> {
    let mut found: Vec<Matrix3<f64>> = Vec::new();
    for pose in poses.iter().filter(|pose| pose.as_good) {
        let linear = RigidTransform::of_matrix(&pose.matrix).rotation;
        let rotation = if is_mirrored { crate::mirror::linear() * linear } else { linear };
        let is_rotation = rotation.determinant() > 0.0;
        if !is_rotation || pose.angle_deg.to_radians() < SAME_POSE_ANGLE {
            return Vec::new();
        }
        if !found.iter().any(|other| angle(&(other.transpose() * rotation)) < SAME_POSE_ANGLE) {
            found.push(rotation);
        }
    }
    found.iter().map(rows).collect()
}

/// A hash of texts, each ended by a zero byte, which names a record by what it is made of: 64 hexadecimal digits.
pub(crate) fn hash_of_texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hasher = blake3::Hasher::new();
    for text in texts {
        hasher.update(text.as_bytes()).update(&[0]);
    }
    hasher.finalize().to_hex().to_string()
}

/// Points from their bytes, 12 bytes each.
pub(crate) fn read_points(bytes: &[u8]) -> Vec<[f32; 3]> {
    let (numbers, _) = bytes.as_chunks::<4>();
    let (points, _) = numbers.as_chunks::<3>();
    points.iter().map(|point| point.map(f32::from_le_bytes)).collect()
}

/// Matches two files and keeps the results that a study needs. A refused input or a match without a registration also
/// gives a record, with the reason: the study continues without it.
///
/// # Errors
/// `None` if the observer cancelled the match.
pub fn compute(
    surfaces: &SurfaceCache,
    source: InputFile<'_>,
    target: InputFile<'_>,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Option<Record> {
    let limits = IntakeLimits::default();
    Some(match run_match_with(surfaces, source, target, parameters, &limits, observer) {
        Ok(output) => Record::of(&output),
        Err(error) if error.is_cancelled() => return None,
        Err(RunError::Input { error, .. }) => Record::failed(error.for_command_line()),
        Err(error) => Record::failed(error.to_string()),
    })
}

/// Distances of the vertices of `target` that faces use from the bent source, mm, ascending.
pub(crate) fn distances(target: &SurfaceMesh, bent: &SurfaceMesh) -> Vec<f64> {
    let index = ClosestPointIndex::new(bent);
    let used = target.vertices().iter().zip(used_vertices(target)).filter(|(_, used)| *used);
    let mut distances: Vec<f64> = used.map(|(p, _)| (index.closest(p).point - p).norm()).collect();
    distances.sort_by(f64::total_cmp);
    distances
}

/// Share of the faces of `source` whose normal, moved by the `linear` part of a transform, does not point to the same
/// side as the bent face.
pub(crate) fn folded(source: &SurfaceMesh, bent: &SurfaceMesh, linear: &Matrix3<f64>) -> f64 {
    // A mirroring transform would change the sign of vector areas, but the faces of `bent` are then reversed.
    let pairs = source.face_vector_areas().into_iter().zip(bent.face_vector_areas());
    let turned = pairs.filter(|(before, after)| (linear * before).dot(after) <= 0.0).count();
    turned as f64 / source.n_faces().max(1) as f64
}

/// The vertices used by faces.
fn used_vertices(mesh: &SurfaceMesh) -> Vec<bool> {
    let mut used = vec![false; mesh.n_vertices()];
    mesh.indices().iter().for_each(|&v| used[v as usize] = true);
    used
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_face_counts_and_a_rotation_does_not() {
        let mesh = homolog_mesh::shapes::ellipsoid([3.0, 2.0, 1.0].into(), 1);
        let turn = nalgebra::Rotation3::from_euler_angles(1.0, 2.0, 0.5);
        let mut bent: Vec<_> = mesh.vertices().iter().map(|p| turn * p).collect();
        let of = |points: &[nalgebra::Point3<f64>]| {
            folded(&mesh, &mesh.with_vertices(points.to_vec()).unwrap(), turn.matrix())
        };
        assert_eq!(of(&bent), 0.0);
        // A vertex that moves to the other side takes faces with it.
        bent[0] = -bent[0];
        assert!(of(&bent) > 0.0 && of(&bent) < 0.2);
    }

    #[test]
    fn rivals_are_rotations_of_the_record_and_none_where_a_rotation_does_not_tell() {
        let turned =
            |radians: f64| *nalgebra::Rotation3::from_axis_angle(&nalgebra::Vector3::z_axis(), radians).matrix();
        let pose = |linear: Matrix3<f64>, degrees: f64, as_good: bool| PoseDocument {
            origin: homolog_contract::result::PoseOrigin::Search,
            matrix: std::array::from_fn(|r| {
                std::array::from_fn(|c| if r < 3 && c < 3 { linear[(r, c)] } else { f64::from(u8::from(r == c)) })
            }),
            angle_deg: degrees,
            rms_mm: 1.0,
            misfit: None,
            mirrored: linear.determinant() < 0.0,
            as_good,
        };
        let (half, near, quarter) = (turned(3.0), turned(3.2), turned(1.5));
        let poses = [
            pose(half, 170.0, true),
            pose(near, 180.0, true),
            pose(turned(1.0), 57.0, false),
            pose(quarter, 86.0, true),
        ];
        assert_eq!(rivals(&poses, false), [rows(&half), rows(&quarter)]);
        let mirrored = poses.clone().map(|of| {
            let linear = crate::mirror::linear() * RigidTransform::of_matrix(&of.matrix).rotation;
            pose(linear, of.angle_deg, of.as_good)
        });
        assert_eq!(rivals(&mirrored, true), [rows(&half), rows(&quarter)]);
        assert!(rivals(&mirrored, false).is_empty(), "of the other handedness");
        let shifted = [poses[0].clone(), pose(turned(0.1), 5.0, true)];
        assert!(rivals(&shifted, false).is_empty(), "another place, not another rotation");
    }

    #[test]
    fn a_record_without_rivals_has_the_bytes_of_earlier_builds() {
        let record = Record { facts: Facts::default(), points: Vec::new() };
        let text = String::from_utf8_lossy(&record.to_bytes()).into_owned();
        assert!(text.contains("repairs") && !text.contains("rivals"));
        let rival = Facts { rivals: vec![[[0.5, 0.25, 1.0]; 3]], ..Facts::default() };
        let record = Record { facts: rival, points: Vec::new() };
        assert_eq!(Record::from_bytes(&record.to_bytes()), Ok(record));
    }

    #[test]
    fn a_record_comes_back_to_the_bit_and_damage_is_noticed() {
        let facts = Facts { reasons: vec!["a".to_owned()], residual_mm: 0.1 + 0.2, ..Facts::default() };
        let record = Record { facts, points: vec![[1.0, -2.5, 3.0e-7], [0.1, 0.2, 0.3]] };
        let bytes = record.to_bytes();
        assert_eq!(Record::from_bytes(&bytes), Ok(record));
        for k in 0..bytes.len() {
            let mut wrong = bytes.clone();
            wrong[k] ^= 1;
            assert_eq!(Record::from_bytes(&wrong), Err(NoRecord), "byte {k}");
            assert_eq!(Record::from_bytes(&bytes[..k]), Err(NoRecord));
        }
    }
}
