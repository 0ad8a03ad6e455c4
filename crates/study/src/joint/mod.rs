//! Joint correspondence: maps from the template to all subjects of a group, revised together.
//!
//! A match places the template on a surface precisely, but along the surface it has an error of its own, so that the
//! shapes of a group vary more than the subjects do. The joint maps minimize an energy over the whole group: each
//! subject's surface term, which keeps the vertices on its surface, and the negative logarithm of the posterior of a
//! Gaussian model of the group with unknown modes. It is minimized by turns ([`Group::revise`]):
//!
//! 1. the shapes are aligned, and models are made of all subjects except a few in turn (`group`);
//! 2. each subject gets the prediction of the model that has not seen it. What remains between its shape and the
//!    prediction is a smooth field, so the vertices slide along the surface to where that field is smoothest (`slide`);
//!    the displacement that all subjects have in common is taken out, because it would move the vertices of the
//!    template and not the subjects';
//! 3. the vertices return to the nearest points of the surface, without turning triangles over.
//!
//! Rounds end when the vertices rest. The last step fits the mapped template to the surface. A map whose surface lies
//! further from the subject's than before is drawn back towards the match: the surface has the last word.
//!
//! Modes, their variances and the variance of the rest maximize the likelihood, as does the smoothness of what remains
//! (a pseudo-likelihood). Nothing here knows covariates or groups of subjects.
//!
//! Sources: Davies et al., *A minimum description length approach to statistical shape modeling*, IEEE TMI 21, 2002, and
//! Cates et al., *Shape modeling and analysis with entropy-based particle systems*, IPMI 2007 (a simple population as the
//! aim); Lüthi et al., *Gaussian process morphable models*, IEEE PAMI 40, 2018 (a shape model with a kernel beside it as
//! prior).

mod group;
mod settings;
mod slide;
mod step;

pub use settings::JointSettings;
pub use slide::Slidable;
pub use step::JointFindings;
pub(crate) use step::{SURFACES_BYTES, revised};

use crate::align::{Alignment, align, fit_onto, points, rms};
use crate::error::StudyError;
use crate::settings::Size;
use group::GroupModel;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::graph::EdgeGraph;
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Shares of a revision among which the largest is chosen whose surface fits as well as the match.
const SHARES: [f64; 4] = [1.0, 0.75, 0.5, 0.25];

/// The surfaces of the subjects.
pub trait Surfaces: Sync {
    /// The surface of a subject in the coordinates of its map; `None` if it cannot be read, which keeps the map.
    ///
    /// # Errors
    /// Errors that end the study.
    fn surface(&self, subject: usize) -> Result<Option<Arc<Slidable>>, StudyError>;
}

/// A round of revisions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct JointRound {
    /// Variance of all shapes before the round, mm².
    pub variance_mm2: f64,
    /// RMS slide of the vertices over all subjects, weighted by area, mm.
    pub slid_mm: f64,
}

/// A group of subjects with maps from one template.
pub struct Group<'a> {
    /// The template, triangles, mm.
    pub template: &'a SurfaceMesh,
    /// The surfaces, by subject.
    pub surfaces: &'a dyn Surfaces,
    /// Whether size is part of shape.
    pub size: Size,
    /// Settings.
    pub settings: &'a JointSettings,
    /// Receives requests to stop.
    pub observer: &'a dyn Observer,
}

/// The revised maps of the subjects that make the model, and the model at rest.
pub struct Revised {
    /// A map for each subject: the position of each vertex of the template, mm.
    pub maps: Vec<Vec<[f32; 3]>>,
    /// The rounds.
    pub rounds: Vec<JointRound>,
    /// Stiffness of the residuals, from 0 to 1.
    pub stiffness: f64,
    /// Number of modes of the model of all these subjects.
    pub modes: usize,
    model: GroupModel,
    weights: Vec<f64>,
}

/// A shape in the frame of the mean, with its normals and the rotation back.
struct Placed {
    shape: Vec<Point3<f64>>,
    normals: Vec<Vector3<f64>>,
    /// Moves displacements of the frame to the subject's coordinates.
    back: Matrix3<f64>,
}

/// A shape, and what remains between it and its prediction at each vertex, in the frame of the mean, mm.
type Residual = (Placed, Vec<Vector3<f64>>);

impl Group<'_> {
    /// Revises the maps of subjects `0..maps.len()`, at least three, together. The result does not depend on the number
    /// of threads.
    ///
    /// # Errors
    /// [`StudyError`] of alignment, decomposition and surfaces; [`StudyError::Interrupted`].
    ///
    /// # Cost
    /// In each round, for `n` subjects, `V` vertices and `M` modes: `O(n² V)` for inner products, `folds` decompositions
    /// of `n × n` matrices, `O(folds · n V M)` for modes, and `n V` closest points.
    pub fn revise(&self, maps: &[Vec<[f32; 3]>]) -> Result<Revised, StudyError> {
        let (n, graph) = (maps.len(), self.template.edge_graph());
        let edge_mm = self.template.mean_edge_length();
        let (mut shapes, mut rounds) = (maps.to_vec(), Vec::new());
        let mut stiffness = None;
        let (mut alignment, mut group) = self.group(&shapes)?;
        while rounds.len() < self.settings.max_rounds {
            let variance_mm2 =
                (0..n).map(|i| rms_from(&alignment, &shapes[i], i).powi(2)).sum::<f64>() / (n - 1) as f64;
            let residuals = self.residuals(&shapes, &alignment, &group)?;
            let stiffness = *stiffness.get_or_insert_with(|| {
                let sums: Vec<[f64; 2]> =
                    residuals.par_iter().map(|(_, residual)| slide::stiffness_sums(residual, &graph)).collect();
                let sum = |k: usize| sums.iter().map(|sums| sums[k]).sum::<f64>();
                if sum(1) > 0.0 { (sum(0) / sum(1)).clamp(0.0, self.settings.most_stiffness) } else { 0.0 }
            });
            let mut steps: Vec<Vec<Vector3<f64>>> = residuals
                .par_iter()
                .map(|(placed, residual)| self.wanted(placed, residual, &graph, stiffness))
                .collect();
            let mut common = vec![Vector3::zeros(); alignment.mean.len()];
            for step in &steps {
                common.iter_mut().zip(step).for_each(|(sum, d)| *sum += d / n as f64);
            }
            steps.iter_mut().for_each(|step| step.iter_mut().zip(&common).for_each(|(d, common)| *d -= common));
            let next: Vec<Vec<[f32; 3]>> = (0..n)
                .into_par_iter()
                .map(|i| self.slid(i, &shapes[i], &residuals[i].0, &steps[i], edge_mm))
                .collect::<Result<_, _>>()?;
            let slid = |i: usize| rms(&points(&next[i]), &points(&shapes[i]), &alignment.weights).powi(2);
            let slid_mm = ((0..n).map(slid).sum::<f64>() / n as f64).sqrt();
            shapes = next;
            rounds.push(JointRound { variance_mm2, slid_mm });
            (alignment, group) = self.group(&shapes)?;
            if slid_mm < self.settings.tolerance * edge_mm {
                break;
            }
        }
        let model = group.model(&(0..n).collect::<Vec<_>>(), self.settings)?;
        let maps = (0..n)
            .into_par_iter()
            .map(|i| self.finished(i, &maps[i], &shapes[i]))
            .collect::<Result<_, StudyError>>()?;
        let (stiffness, modes) = (stiffness.unwrap_or(0.0), model.modes.len());
        Ok(Revised { maps, rounds, stiffness, modes, model, weights: alignment.weights })
    }

    /// Revises the map of a subject that is not part of the model.
    ///
    /// # Errors
    /// As [`Group::revise`].
    pub fn revise_another(&self, subject: usize, map: &[[f32; 3]], by: &Revised) -> Result<Vec<[f32; 3]>, StudyError> {
        let (graph, edge_mm) = (self.template.edge_graph(), self.template.mean_edge_length());
        let mut shape = map.to_vec();
        for _ in 0..self.settings.max_rounds {
            checkpoint(self.observer)?;
            let (placed, residual) = self.residual(&shape, &by.model, &by.weights)?;
            let step = self.wanted(&placed, &residual, &graph, by.stiffness);
            let next = self.slid(subject, &shape, &placed, &step, edge_mm)?;
            let slid_mm = rms(&points(&next), &points(&shape), &by.weights);
            shape = next;
            if slid_mm < self.settings.tolerance * edge_mm {
                break;
            }
        }
        self.finished(subject, map, &shape)
    }

    /// The shapes in one frame.
    fn group(&self, shapes: &Vec<Vec<[f32; 3]>>) -> Result<(Alignment, group::Group), StudyError> {
        checkpoint(self.observer)?;
        let alignment = align(shapes, self.template, self.size)?;
        let aligned: Vec<Vec<Point3<f64>>> = shapes
            .par_iter()
            .zip(&alignment.onto_mean)
            .map(|(shape, onto)| points(shape).iter().map(|p| onto.apply(p)).collect())
            .collect();
        let group = group::Group::new(&aligned, &alignment.weights);
        Ok((alignment, group))
    }

    /// Each shape in the frame of the model that is made without it, and what remains between the shape and its
    /// prediction.
    fn residuals(
        &self,
        shapes: &[Vec<[f32; 3]>],
        alignment: &Alignment,
        group: &group::Group,
    ) -> Result<Vec<Residual>, StudyError> {
        let n = shapes.len();
        let n_folds = self.settings.folds.min(n);
        let folds: Vec<Vec<Residual>> = (0..n_folds)
            .into_par_iter()
            .map(|fold| {
                checkpoint(self.observer)?;
                let others: Vec<usize> = (0..n).filter(|i| i % n_folds != fold).collect();
                let model = group.model(&others, self.settings)?;
                let left = (fold..n).step_by(n_folds);
                left.map(|i| self.residual(&shapes[i], &model, &alignment.weights)).collect()
            })
            .collect::<Result<_, StudyError>>()?;
        let mut folds: Vec<_> = folds.into_iter().map(Vec::into_iter).collect();
        Ok((0..n).filter_map(|i| folds[i % n_folds].next()).collect())
    }

    fn residual(&self, shape: &[[f32; 3]], model: &GroupModel, weights: &[f64]) -> Result<Residual, StudyError> {
        let own = points(shape);
        let onto = fit_onto(&own, &model.mean, weights, self.size == Size::Removed)
            .map_err(|error| StudyError::Alignment { id: "of a joint map".to_owned(), error })?;
        let shape: Vec<Point3<f64>> = own.iter().map(|p| onto.apply(p)).collect();
        let prediction = model.shape(&model.scores(&shape, weights));
        let residual = prediction.iter().zip(&shape).map(|(p, q)| p - q).collect();
        let normals = self.template.vertex_normals_at(&shape);
        Ok((Placed { shape, normals, back: onto.rotation.transpose() / onto.scale }, residual))
    }

    /// Where the vertices of a shape want to slide, in the frame of the mean, mm.
    fn wanted(
        &self,
        placed: &Placed,
        residual: &[Vector3<f64>],
        graph: &EdgeGraph,
        stiffness: f64,
    ) -> Vec<Vector3<f64>> {
        debug_assert_eq!(placed.shape.len(), residual.len());
        slide::smoothing_slide(residual, &placed.normals, graph, stiffness, self.settings.steps)
    }

    /// The map of a subject after a step.
    fn slid(
        &self,
        subject: usize,
        shape: &[[f32; 3]],
        placed: &Placed,
        step: &[Vector3<f64>],
        edge_mm: f64,
    ) -> Result<Vec<[f32; 3]>, StudyError> {
        checkpoint(self.observer)?;
        let Some(surface) = self.surfaces.surface(subject)? else { return Ok(shape.to_vec()) };
        let longest = self.settings.longest_slide * edge_mm;
        let step: Vec<Vector3<f64>> = step.iter().map(|d| placed.back * d.cap_magnitude(longest)).collect();
        Ok(stored(&surface.slide(self.template, &points(shape), &step)))
    }

    /// The revised map, fitted to the surface. If it does not fit as well as the match, the largest share of the
    /// revision that does; at last the match.
    fn finished(&self, subject: usize, map: &[[f32; 3]], shape: &[[f32; 3]]) -> Result<Vec<[f32; 3]>, StudyError> {
        checkpoint(self.observer)?;
        let Some(surface) = self.surfaces.surface(subject)? else { return Ok(map.to_vec()) };
        let mean = |distances: Vec<f64>| distances.iter().sum::<f64>() / distances.len().max(1) as f64;
        let (before, revised) = (points(map), points(shape));
        let bound = mean(surface.distances(self.template, &before)?);
        for share in SHARES {
            let part = if share < 1.0 {
                let step: Vec<Vector3<f64>> = before.iter().zip(&revised).map(|(p, q)| share * (q - p)).collect();
                surface.slide(self.template, &before, &step)
            } else {
                revised.clone()
            };
            let fitted = surface.fitted(self.template, part, self.settings.fitting_rounds)?;
            if mean(surface.distances(self.template, &fitted)?) <= bound {
                return Ok(stored(&fitted));
            }
        }
        Ok(map.to_vec())
    }
}

/// Distance of a shape from the mean, mm.
fn rms_from(alignment: &Alignment, shape: &[[f32; 3]], i: usize) -> f64 {
    let aligned: Vec<Point3<f64>> = points(shape).iter().map(|p| alignment.onto_mean[i].apply(p)).collect();
    rms(&aligned, &alignment.mean, &alignment.weights)
}

/// Points as records keep them.
fn stored(points: &[Point3<f64>]) -> Vec<[f32; 3]> {
    points.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect()
}
