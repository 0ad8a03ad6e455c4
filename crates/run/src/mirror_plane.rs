//! The plane in which a surface is mirrored.

use homolog_contract::input::InputSpace;
use homolog_mesh::{ClosestPointIndex, MeshError, SurfaceMesh};
use homolog_registration::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};

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
    pub(crate) fn transform(&self) -> RigidTransform {
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
