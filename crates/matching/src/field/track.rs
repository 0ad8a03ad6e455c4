//! One step of a field: the place of the source, and the target points assigned to it.

use super::base::InitialMap;
use super::displacement::FitContext;
use crate::pair::assignment::displaced;
use crate::surface::smooth::Subsample;
use faer::Mat;
use homolog_registration::alignment::{Assignment, AssignmentKernel, AssignmentTarget, OrientedPoints, assign};
use homolog_registration::deformation::{FittedField, Observation};
use nalgebra::{Point3, Vector3};

/// The vertices of the source after the base, and the functions of the field that moves them on.
pub(crate) struct BaseEvaluation {
    pub base: InitialMap,
    /// The vertices after the base, mm.
    start: Vec<Point3<f64>>,
    /// Every function at every vertex.
    values: Mat<f64>,
    /// Displacements to the landmarks.
    guided: Vec<Observation>,
}

/// The thinned vertices of a moved source.
pub(crate) struct Placed {
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
}

/// The thinned vertices of a moved source, and the target points assigned to them.
pub(crate) struct Assigned {
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    pub found: Assignment,
}

impl BaseEvaluation {
    pub(crate) fn new(displacement: &FitContext<'_>, base: InitialMap) -> BaseEvaluation {
        let vertices = displacement.source.mesh.vertices();
        let values = displacement.functions.values(vertices);
        let start = base.moved(vertices, &values);
        BaseEvaluation { start, values, guided: displacement.guides.observations(&base), base }
    }

    /// The same source on the same base, for a field of other functions.
    pub(crate) fn with_functions_of(&self, displacement: &FitContext<'_>) -> BaseEvaluation {
        BaseEvaluation {
            base: self.base.clone(),
            start: self.start.clone(),
            values: displacement.functions.values(displacement.source.mesh.vertices()),
            guided: self.guided.clone(),
        }
    }

    /// All vertices where `field` moves them, mm.
    pub(crate) fn moved(&self, field: &FittedField) -> Vec<Point3<f64>> {
        displaced(&self.start, field, &self.values)
    }

    /// The vertices of `thinned` after the base, mm.
    pub(crate) fn starts(&self, thinned: &Subsample) -> Vec<Point3<f64>> {
        thinned.vertices.iter().map(|&i| self.start[i]).collect()
    }

    /// The functions at the vertices of `thinned`.
    pub(crate) fn values(&self, thinned: &Subsample) -> Mat<f64> {
        Mat::from_fn(thinned.vertices.len(), self.values.ncols(), |i, k| self.values[(thinned.vertices[i], k)])
    }

    /// `observed`, followed by the landmarks.
    pub(crate) fn with_guides(&self, mut observed: Vec<Observation>) -> Vec<Observation> {
        observed.extend_from_slice(&self.guided);
        observed
    }
}

/// The points of `target` assigned to the source with its vertices at `moved`, see [`placed`].
pub(crate) fn assigned(
    displacement: &FitContext<'_>,
    moved: &[Point3<f64>],
    mirrored: bool,
    thinned: &Subsample,
    target: &AssignmentTarget,
    kernel: &AssignmentKernel,
) -> Option<Assigned> {
    let Placed { points, normals } = placed(displacement, moved, mirrored, thinned)?;
    let samples = OrientedPoints { points: &points, normals: &normals, ..thinned.samples() };
    let found = assign(&samples, target, kernel);
    Some(Assigned { points, normals, found })
}

/// The vertices of `thinned` of the source with its vertices at `moved`. Normals are those of the whole moved surface
/// and point outwards, also after a `mirrored` pose, which turns all faces inside out. `None` if a number is not
/// finite.
pub(crate) fn placed(
    displacement: &FitContext<'_>,
    moved: &[Point3<f64>],
    mirrored: bool,
    thinned: &Subsample,
) -> Option<Placed> {
    if !moved.iter().all(|p| p.iter().all(|x| x.is_finite())) {
        return None;
    }
    let outwards = if mirrored { -1.0 } else { 1.0 };
    let normals = displacement.source.mesh.vertex_normals_at(moved);
    let normals: Vec<Vector3<f64>> = thinned.vertices.iter().map(|&i| normals[i] * outwards).collect();
    Some(Placed { points: thinned.vertices.iter().map(|&i| moved[i]).collect(), normals })
}
