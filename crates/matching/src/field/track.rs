//! One step of a field: where the source is, and what of the target is assigned to it.

use super::base::Base;
use super::displacement::Displacement;
use crate::pair::assignment::displaced;
use crate::surface::smooth::Thinned;
use faer::Mat;
use homolog_registration::alignment::{Assignment, AssignmentKernel, AssignmentTarget, OrientedPoints, assign};
use homolog_registration::deformation::{FittedField, Observation};
use nalgebra::{Point3, Vector3};

/// The source after its base, at all vertices, and the functions of the field that moves it on.
pub(crate) struct Track {
    pub base: Base,
    /// The vertices after the base, mm.
    start: Vec<Point3<f64>>,
    /// Every function at every vertex.
    values: Mat<f64>,
    /// The displacements that landmarks ask for.
    guided: Vec<Observation>,
}

/// The thinned vertices of a source that was moved.
pub(crate) struct Placed {
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
}

/// The thinned vertices of a source that was moved, and what is assigned to them.
pub(crate) struct Assigned {
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    pub found: Assignment,
}

impl Track {
    pub(crate) fn new(displacement: &Displacement<'_>, base: Base) -> Track {
        let vertices = displacement.source.mesh.vertices();
        let values = displacement.functions.values(vertices);
        let start = base.moved(vertices, &values);
        Track { start, values, guided: displacement.guides.observations(&base), base }
    }

    /// The same source on the same base, moved by a field of other functions.
    pub(crate) fn with_functions_of(&self, displacement: &Displacement<'_>) -> Track {
        Track {
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
    pub(crate) fn starts(&self, thinned: &Thinned) -> Vec<Point3<f64>> {
        thinned.vertices.iter().map(|&i| self.start[i]).collect()
    }

    /// The functions at the vertices of `thinned`.
    pub(crate) fn values(&self, thinned: &Thinned) -> Mat<f64> {
        Mat::from_fn(thinned.vertices.len(), self.values.ncols(), |i, k| self.values[(thinned.vertices[i], k)])
    }

    /// `observed`, with the landmarks after them.
    pub(crate) fn with_guides(&self, mut observed: Vec<Observation>) -> Vec<Observation> {
        observed.extend_from_slice(&self.guided);
        observed
    }
}

/// What of `target` is assigned to the source with its vertices at `moved`, [`placed`].
pub(crate) fn assigned(
    displacement: &Displacement<'_>,
    moved: &[Point3<f64>],
    mirrored: bool,
    thinned: &Thinned,
    target: &AssignmentTarget,
    kernel: &AssignmentKernel,
) -> Option<Assigned> {
    let Placed { points, normals } = placed(displacement, moved, mirrored, thinned)?;
    let samples = OrientedPoints { points: &points, normals: &normals, ..thinned.samples() };
    let found = assign(&samples, target, kernel);
    Some(Assigned { points, normals, found })
}

/// The vertices of `thinned` of the source with its vertices at `moved`. Normals are those of the whole moved surface,
/// outwards after a `mirrored` pose too, which turns all faces inside out. `None` where a number is not finite.
pub(crate) fn placed(
    displacement: &Displacement<'_>,
    moved: &[Point3<f64>],
    mirrored: bool,
    thinned: &Thinned,
) -> Option<Placed> {
    if !moved.iter().all(|p| p.iter().all(|x| x.is_finite())) {
        return None;
    }
    let outwards = if mirrored { -1.0 } else { 1.0 };
    let normals = displacement.source.mesh.vertex_normals_at(moved);
    let normals: Vec<Vector3<f64>> = thinned.vertices.iter().map(|&i| normals[i] * outwards).collect();
    Some(Placed { points: thinned.vertices.iter().map(|&i| moved[i]).collect(), normals })
}
