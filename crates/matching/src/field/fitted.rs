//! Fields after their stages.

use super::base::{InitialMap, State};
use super::displacement::FitContext;
use super::functions::Functions;
use super::trace::TracedFit;
use super::track::BaseEvaluation;
use crate::pair::assignment::displaced;
use crate::surface::smooth::SmoothSurface;
use faer::Mat;
use homolog_mesh::SurfaceMesh;
use homolog_registration::deformation::{FittedField, GaussianKernel};
use homolog_registration::{RigidTransform, absolute_orientation_of};
use nalgebra::Point3;

/// A field after the middle and fine stages.
pub(crate) struct FineStageFit {
    pub track: BaseEvaluation,
    pub field: FittedField,
    pub feature_precision: Vec<f64>,
    /// Robust standard deviation of the residual along the normals, mm.
    pub residual_mm: f64,
    /// Share of the assignment's weight that is kept across the normals.
    pub across_share: f64,
    /// Its number in the energy trace, unless it is not recorded there.
    pub fit: Option<TracedFit>,
}

impl FineStageFit {
    /// The vertices of the source where the field moves them, mm.
    pub(crate) fn moved(&self) -> Vec<Point3<f64>> {
        self.track.moved(&self.field)
    }

    /// The field over its base.
    pub(crate) fn state(&self) -> State {
        let FineStageFit { track, field, feature_precision, .. } = self;
        State { base: track.base.clone(), field: field.clone(), feature_precision: feature_precision.clone() }
    }
}

/// A second, narrower kernel, and the noise along the normals under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LocalKernel {
    pub kernel: GaussianKernel,
    /// Standard deviation along the normals, mm.
    pub noise_mm: f64,
    /// Share of the assignment's weight that is kept across the normals.
    pub across_share: f64,
}

/// A field after all stages.
pub(crate) struct FinalField {
    /// The map that the field is added to, in terms of `base_functions`.
    pub base: InitialMap,
    pub base_functions: Functions,
    pub field: FittedField,
    /// The functions of the field.
    pub functions: Functions,
    /// Robust standard deviation of the residual along the normals after the fine stage, mm.
    pub residual_mm: f64,
    /// The second kernel, if the local stage added one: the covariance of the field is then that of the whole
    /// displacement.
    pub local: Option<LocalKernel>,
    /// The field after the fine stage, in terms of `base_functions`.
    pub wide: State,
}

impl FinalField {
    /// The field of the fine stage as the last one.
    pub(crate) fn of_fine_stage(displacement: &FitContext<'_>, fine: FineStageFit) -> FinalField {
        FinalField {
            wide: fine.state(),
            base: fine.track.base,
            base_functions: displacement.functions.clone(),
            field: fine.field,
            functions: displacement.functions.clone(),
            residual_mm: fine.residual_mm,
            local: None,
        }
    }

    /// The vertices of `mesh` moved by the base and the field.
    pub(crate) fn moved(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        let values = self.functions.values(mesh.vertices());
        displaced(&self.based(mesh, &values), &self.field, &values)
    }

    /// The vertices of `mesh` moved by the base alone.
    pub(crate) fn started(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        self.based(mesh, &self.functions.values(mesh.vertices()))
    }

    /// Moves the vertices of `mesh` by the base; `values` are the functions of the field there.
    fn based(&self, mesh: &SurfaceMesh, values: &Mat<f64>) -> Vec<Point3<f64>> {
        if self.local.is_some() && self.base.bend.is_some() {
            self.base.moved(mesh.vertices(), &self.base_functions.values(mesh.vertices()))
        } else {
            self.base.moved(mesh.vertices(), values)
        }
    }
}

/// The rigid part of the map of `points`, which stand for these areas, to `moved`, with the handedness of `pose`. It does
/// not otherwise depend on `pose`, which is returned if the fit fails.
pub(crate) fn rigid_part_of(
    (points, areas): (&[Point3<f64>], &[f64]),
    moved: &[Point3<f64>],
    pose: &RigidTransform,
) -> RigidTransform {
    absolute_orientation_of(points, moved, Some(areas), pose.is_reflection()).unwrap_or(*pose)
}

/// [`rigid_part_of`] all vertices of the source.
pub(crate) fn pose_of(displacement: &FitContext<'_>, moved: &[Point3<f64>], pose: &RigidTransform) -> RigidTransform {
    let SmoothSurface { mesh, areas, .. } = &*displacement.source;
    rigid_part_of((mesh.vertices(), areas), moved, pose)
}
