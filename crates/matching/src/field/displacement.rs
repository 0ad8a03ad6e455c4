//! Surfaces, settings and functions that all stages of a displacement share.

use super::base::State;
use super::functions::Functions;
use super::guides::LandmarkObservations;
use super::options::{DisplacementOptions, StageSettings};
use super::schedule::Schedule;
use super::trace::FitTrace;
use crate::pair::lengths::Lengths;
use crate::poses::rigid_part::Alignment;
use crate::surface::smooth::SmoothSurface;
use homolog_registration::{RigidTransform, SamePose};
use nalgebra::Point3;
use std::sync::Arc;

/// Surfaces, settings and functions that all stages of a displacement share.
pub(crate) struct FitContext<'a> {
    pub source: Arc<SmoothSurface>,
    pub target: Arc<SmoothSurface>,
    pub functions: Functions,
    pub guides: LandmarkObservations,
    pub diagonal_mm: f64,
    pub lengths: Lengths,
    /// When two poses count as one, if the source is a part: it may fit at several places in one orientation.
    pub same_place: Option<SamePose>,
    pub options: &'a DisplacementOptions,
    pub observer: &'a FitTrace<'a>,
}

impl FitContext<'_> {
    /// Independent observations per unit of area, at `progress` through `stage`.
    pub(crate) fn density(&self, stage: &StageSettings, progress: f64) -> f64 {
        stage.observations_at(progress) / self.lengths.root_mm.powi(2)
    }

    /// The schedule of `stage`.
    pub(crate) fn schedule(&self, stage: &StageSettings) -> Schedule {
        Schedule::new(stage.steps, stage.repetitions, self.lengths.root_mm)
    }

    /// Both surfaces for a rigid alignment; `edge_mm` is the mean edge length of the target.
    pub(crate) fn alignment(&self, edge_mm: f64) -> Alignment<'_> {
        Alignment { source: &self.source, target: &self.target, edge_mm, observer: self.observer }
    }

    /// Whether two poses of one handedness differ by less than `angle`, radians.
    pub(crate) fn are_same(&self, a: &RigidTransform, b: &RigidTransform, angle: f64) -> bool {
        self.same_place.unwrap_or_else(SamePose::of_orientation).holds(a, b, angle)
    }

    /// The vertices of the source where `state` moves them, mm.
    pub(crate) fn source_moved_by(&self, state: &State) -> Vec<Point3<f64>> {
        let vertices = self.source.mesh.vertices();
        state.moved(vertices, &self.functions.values(vertices))
    }

    /// The same displacement with other functions.
    pub(crate) fn with_functions(&self, functions: Functions) -> FitContext<'_> {
        FitContext {
            source: self.source.clone(),
            target: self.target.clone(),
            guides: self.guides.with_functions(&functions),
            functions,
            ..*self
        }
    }
}
