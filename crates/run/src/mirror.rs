//! Mirroring of a surface before matching, and its effect on the stated transforms.
//!
//! Matching sees the mirrored surface and finds a rotation. The result is stated in the coordinates of the files, so a
//! reflection precedes the rotation (for the source) or follows it (for the target).

use crate::intake::PreparedSurface;
use homolog_contract::input::InputSpace;
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::{ResultDocument, TransformDocument};
use homolog_mesh::{ClosestPointIndex, MeshError, SurfaceMesh};
use homolog_registration::RigidTransform;
use nalgebra::{Matrix3, Matrix4, Point3, Vector3};

/// Largest number of vertices used to compare planes.
const MAX_COMPARED: usize = 1000;

/// A mirror plane of a surface: the points `p` with `normal · p = offset_mm`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MirrorPlane {
    /// Unit normal.
    pub normal: [f64; 3],
    /// Distance from the origin along the normal, mm.
    pub offset_mm: f64,
}

impl MirrorPlane {
    /// `x = 0` in the space declared by a file, where x runs from left to right. Without a declared space: the plane
    /// through the centroid and two principal axes whose mirror image of the surface lies nearest to the surface.
    pub fn of(mesh: &SurfaceMesh, space: Option<InputSpace>) -> Self {
        match space {
            Some(InputSpace::ScannerRas | InputSpace::FreesurferRas | InputSpace::Lps) => {
                MirrorPlane { normal: [1.0, 0.0, 0.0], offset_mm: 0.0 }
            }
            Some(InputSpace::Unknown) | None => Self::best(mesh),
        }
    }

    fn best(mesh: &SurfaceMesh) -> Self {
        let center = mesh.centroid();
        let scatter: Matrix3<f64> =
            mesh.vertices().iter().map(|p| (p - center) * (p - center).transpose()).sum::<Matrix3<f64>>();
        let axes = scatter.symmetric_eigen().eigenvectors;
        let index = ClosestPointIndex::new(mesh);
        let step = mesh.n_vertices().div_ceil(MAX_COMPARED).max(1);
        let planes = (0..3).map(|k| {
            let normal = axes.column(k).into_owned();
            let plane = MirrorPlane { normal: normal.into(), offset_mm: normal.dot(&center.coords) };
            let images = mesh.vertices().iter().step_by(step).map(|p| plane.mirrored(p));
            (images.map(|p| (index.closest(&p).point - p).norm()).sum::<f64>(), plane)
        });
        let best = planes.min_by(|a, b| a.0.total_cmp(&b.0));
        best.map_or(MirrorPlane { normal: [1.0, 0.0, 0.0], offset_mm: 0.0 }, |(_, plane)| plane)
    }

    /// The mirror image of a point.
    pub fn mirrored(&self, p: &Point3<f64>) -> Point3<f64> {
        self.transform().apply(p)
    }

    /// The reflection as a transform; it is its own inverse.
    fn transform(&self) -> RigidTransform {
        let normal = Vector3::from(self.normal);
        RigidTransform {
            rotation: Matrix3::identity() - 2.0 * normal * normal.transpose(),
            translation: 2.0 * self.offset_mm * normal,
        }
    }

    /// The mirror image of a surface, with faces that still look outwards.
    ///
    /// # Errors
    /// [`MeshError::NonFinite`] if a coordinate overflows.
    pub fn surface(&self, mesh: &SurfaceMesh) -> Result<SurfaceMesh, MeshError> {
        mesh.moved(&self.transform().matrix())
    }

    /// Description of the mirroring, for people.
    pub(crate) fn note(&self) -> String {
        let [x, y, z] = self.normal;
        if self.normal == [1.0, 0.0, 0.0] {
            return "it was mirrored from left to right (x becomes -x) before it was matched, as asked for".to_owned();
        }
        format!(
            "it was mirrored before it was matched, as asked for; its file declares no left and right, so in the plane through its \
             centroid with the normal ({x:.4}, {y:.4}, {z:.4})"
        )
    }
}

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
