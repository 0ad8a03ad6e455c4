//! Mirroring of a surface before matching, and its effect on the stated transforms.
//!
//! Matching sees the mirrored surface and finds a rotation. The result is stated in the coordinates of the files, so a
//! reflection precedes the rotation (for the source) or follows it (for the target).

use crate::intake::PreparedSurface;
use crate::mirror_plane::MirrorPlane;
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::{ResultDocument, TransformDocument};
use homolog_registration::RigidTransform;
use nalgebra::{Matrix3, Matrix4, Point3, Vector3};

/// The planes of source and target; `None` for an input that is not mirrored.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mirrors {
    source: Option<MirrorPlane>,
    target: Option<MirrorPlane>,
}

impl Mirrors {
    pub(crate) fn of(source: &PreparedSurface, target: &PreparedSurface) -> Self {
        Mirrors { source: source.mirror(), target: target.mirror() }
    }

    /// The parameters for the surfaces as matched: landmarks are mirrored with their surface.
    pub(crate) fn parameters(&self, parameters: &MatchParameters) -> MatchParameters {
        let mut seen = parameters.clone();
        for landmark in &mut seen.landmarks {
            for (plane, point) in [(self.source, &mut landmark.source_mm), (self.target, &mut landmark.target_mm)] {
                if let Some(plane) = plane {
                    *point = plane.mirrored(&Point3::from(*point)).into();
                }
            }
        }
        seen
    }

    /// Converts every transform of `document`, which was found for the matched surfaces, to the coordinates of the
    /// files.
    pub(crate) fn state(&self, document: &mut ResultDocument) {
        if self.source.is_none() && self.target.is_none() {
            return;
        }
        let similarity = document.transform.similarity.take().map(|mut similarity| {
            similarity.matrix = self.stated(&similarity.matrix);
            similarity
        });
        document.transform = TransformDocument { similarity, ..self.transform(&document.transform) };
        let turns = self.source.is_some() != self.target.is_some();
        for pose in &mut document.poses {
            pose.matrix = self.stated(&pose.matrix);
            pose.mirrored ^= turns;
        }
    }

    /// `S_target · M · S_source`.
    fn stated(&self, matrix: &[[f64; 4]; 4]) -> [[f64; 4]; 4] {
        let reflection = |plane: Option<MirrorPlane>| {
            let matrix = plane.map(|plane| plane.transform().matrix());
            matrix.map_or_else(Matrix4::identity, |m| Matrix4::from_fn(|r, c| m[r][c]))
        };
        let stated = reflection(self.target) * Matrix4::from_fn(|r, c| matrix[r][c]) * reflection(self.source);
        std::array::from_fn(|r| std::array::from_fn(|c| stated[(r, c)]))
    }

    /// A transform in all its forms: a rotation, or a reflection in source coordinates followed by a rotation.
    fn transform(&self, found: &TransformDocument) -> TransformDocument {
        let motion = RigidTransform::of_matrix(&found.matrix);
        let matrix = self.stated(&found.matrix);
        let whole = RigidTransform::of_matrix(&matrix);
        let (reflection, motion) = match (self.source, self.target) {
            (Some(plane), None) if !found.mirrored => (Some(plane.transform()), motion),
            // Mirroring the target after the motion equals mirroring the source before it, in the plane that the motion
            // maps to the target's.
            (None, Some(plane)) if !found.mirrored => {
                (Some(motion.inverse().after(&plane.transform()).after(&motion)), motion)
            }
            _ if whole.is_reflection() => {
                let in_origin = RigidTransform { rotation: -Matrix3::identity(), translation: Vector3::zeros() };
                (Some(in_origin), RigidTransform { rotation: -whole.rotation, ..whole })
            }
            _ => (None, whole),
        };
        let q = motion.quaternion();
        TransformDocument {
            matrix,
            mirrored: reflection.is_some(),
            reflection: reflection.map(|reflection| reflection.matrix()),
            rotation_quaternion_wxyz: [q.w, q.i, q.j, q.k],
            rotation_angle_deg: motion.angle_rad().to_degrees(),
            translation_mm: motion.translation.into(),
            similarity: None,
        }
    }
}
