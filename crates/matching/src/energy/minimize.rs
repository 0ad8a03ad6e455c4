//! Minimization of the energy of near isometries, and the correspondences of its labelings.

use super::bias::bias_away_from;
use super::model::Isometry;
use super::settings::IsometrySettings;
use homolog_mrf::Labeling;
use homolog_mrf::metric::{ActiveOptions, MetricModel, Semiring};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Correspondences of places on both surfaces, with their energy.
#[derive(Debug, Clone)]
pub(crate) struct NearIsometry {
    /// Places on the source, mm.
    pub points: Vec<Point3<f64>>,
    /// The corresponding points of the target, mm.
    pub images: Vec<Point3<f64>>,
    /// Energy of the labeling; lower is better.
    pub energy: f64,
    /// The share of each variable in the energy.
    pub shares: Vec<f64>,
}

impl NearIsometry {
    /// The energy divided by the number of variables.
    pub(crate) fn mean_energy(&self) -> f64 {
        self.energy / self.points.len() as f64
    }
}

/// The labeling from belief propagation over active labels with an initial bias (may be empty), followed by conditional
/// modes.
pub(crate) fn minimized(model: &MetricModel, bias: &[f32], settings: &IsometrySettings) -> Labeling {
    let options = ActiveOptions {
        semiring: Semiring::Max,
        iterations: settings.iterations as u32,
        damping: settings.damping,
        tolerance: settings.tolerance,
    };
    model.minimized(bias, settings.active_labels, &options, settings.sweeps, |_, _, _| ())
}

/// The labeling from fusing `labelings`, followed by conditional modes; `None` for an empty list.
pub(crate) fn fused(model: &MetricModel, labelings: &[Labeling], settings: &IsometrySettings) -> Option<Labeling> {
    model.fused_of_all(labelings, settings.sweeps)
}

impl Isometry<'_> {
    /// The labeling from conditional modes, starting at the labels nearest to the images of the variables, mm.
    pub(crate) fn of_images(&self, images: &[Point3<f64>]) -> Labeling {
        let nearest = |p: &Point3<f64>| {
            let squared = |x: &u32| (self.places[*x as usize] - p).norm_squared();
            (0..self.places.len() as u32).min_by(|x, y| squared(x).total_cmp(&squared(y))).unwrap_or(0)
        };
        self.model.descend(images.iter().map(nearest).collect(), self.settings.sweeps)
    }

    /// Labelings from belief propagation and conditional modes, without a start, from extremities and away from
    /// `known`, and the fusion of all of them.
    ///
    /// Cost `O(iterations · edges · active²)` for each start.
    pub(crate) fn candidates(&self, known: &Labeling) -> Vec<Labeling> {
        let mut labelings = self.labelings(&self.model);
        labelings.extend(fused(&self.model, &labelings, &self.settings));
        let away = |labelings: &[&Labeling]| {
            let IsometrySettings { repulsion, repulsion_width, .. } = self.settings;
            minimized(&self.model, &bias_away_from(labelings, self.labels, repulsion, repulsion_width), &self.settings)
        };
        let elsewhere = away(&[known]);
        let elsewhere_again = away(&[known, &elsewhere]);
        labelings.extend([elsewhere, elsewhere_again]);
        labelings
    }

    /// The correspondences of `labeling`.
    pub(crate) fn correspondence(&self, labeling: &Labeling) -> NearIsometry {
        NearIsometry {
            points: self.points.clone(),
            images: self.images(labeling),
            energy: self.model.energy(labeling).total(),
            shares: self.model.shares(labeling),
        }
    }

    /// The share of each variable in the lowest energy of the mirrored source, from extremities and without a start;
    /// `None` if there is no labeling.
    ///
    /// Cost as that of [`Isometry::candidates`].
    pub(crate) fn lowest_mirrored(&self) -> Option<Vec<f64>> {
        let fused = fused(&self.mirrored, &self.labelings(&self.mirrored), &self.settings)?;
        Some(self.mirrored.shares(&fused))
    }

    /// The labelings of `model` without a start and from each assignment of extremities.
    fn labelings(&self, model: &MetricModel) -> Vec<Labeling> {
        let starts: Vec<Vec<f32>> = [Vec::new()].into_iter().chain(self.of_extremities()).collect();
        starts.par_iter().map(|bias| minimized(model, bias, &self.settings)).collect()
    }

    /// For each variable the mean of the labels near its own, weighted by their cost as alternatives.
    fn images(&self, labeling: &[u32]) -> Vec<Point3<f64>> {
        let near = self.settings.blended / (self.places.len() as f64).sqrt();
        (0..labeling.len())
            .map(|i| {
                let own = labeling[i] as usize;
                let (row, cost) = (self.labels.row(own), self.model.conditional(i, labeling));
                let (mut total, mut sum) = (0.0, Vector3::zeros());
                for (x, q) in self.places.iter().enumerate() {
                    if f64::from(row[x]) <= near {
                        let weight = f64::from(cost[own] - cost[x]).min(0.0).exp();
                        total += weight;
                        sum += q.coords * weight;
                    }
                }
                Point3::from(sum / total)
            })
            .collect()
    }
}
