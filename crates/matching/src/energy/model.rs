//! The Markov random field of a bent surface: the place of the target that corresponds to each place of the source, if
//! distances along the surface are kept and distances in space are not.
//!
//! Variables are places spread evenly over the source, labels places spread evenly over the target. The energy depends
//! on neither pose nor deformation:
//!
//! - **Pairwise**: the distance along the target between two labels, given the distance along the source between their
//!   variables: Gaussian, with a variance from the spacing of the sites and from a deformation in proportion to the
//!   distance. Edges join neighbors and places far apart.
//! - **Unary**: curvature at several scales; the eccentricity of the place, its root mean square distance to all
//!   others; and the **chirality** of its surroundings, which changes its sign in a mirror: the signed area that a
//!   neighborhood covers in the plane of two features, `∫ n · (∇f × ∇g)`. A person's left and right hand have the same
//!   distances and curvatures, and opposite chirality.
//!
//! The energy is minimized without a start, and from assignments of extremities ([`crate::starts::extremities`]): each
//! is an initial bias of belief propagation that is then removed ([`homolog_mrf::metric`]). The labelings are fused,
//! since one may be right about the arms and another about the legs. `make energies` measures how often the labeling of
//! lowest energy is right.

use super::bias::bias_of_pairs;
use super::settings::IsometrySettings;
use super::signs::{SiteDescriptors, unary_potentials};
use super::variance::variance_of_distance;
use crate::starts::extremities::assignments;
use crate::surface::sites::Sites;
use crate::surface::smooth::SmoothSurface;
use homolog_mrf::metric::{MetricEdge, MetricModel};
use nalgebra::Point3;

/// One surface of the model: its sites, their positions, mm, and the measurements there.
pub(crate) struct SiteMeasurements<'a> {
    pub sites: &'a Sites,
    pub signs: SiteDescriptors,
    pub places: Vec<Point3<f64>>,
}

impl<'a> SiteMeasurements<'a> {
    /// The `sites` of `surface`. Cost `O(n + sites · triangles)`.
    pub(crate) fn of(surface: &SmoothSurface, sites: &'a Sites, settings: &IsometrySettings) -> SiteMeasurements<'a> {
        SiteMeasurements {
            sites,
            signs: SiteDescriptors::at_sites(surface, sites, settings),
            places: sites.places(&surface.mesh),
        }
    }
}

/// The model between two surfaces.
pub(crate) struct Isometry<'a> {
    pub settings: IsometrySettings,
    /// The energy.
    pub model: MetricModel,
    /// The energy of the mirrored source, whose places have chirality of the opposite sign.
    pub mirrored: MetricModel,
    /// The sites of the source.
    source: &'a Sites,
    /// The sites that are variables.
    pub variables: &'a [u32],
    /// The variables on the source, mm.
    pub points: Vec<Point3<f64>>,
    /// The sites of the target, which are the labels.
    pub labels: &'a Sites,
    /// The labels on the target, mm.
    pub places: Vec<Point3<f64>>,
}

impl<'a> Isometry<'a> {
    /// The model between two surfaces. Cost `O(variables · labels)`.
    pub(crate) fn new(
        source: &SiteMeasurements<'a>,
        target: &SiteMeasurements<'a>,
        settings: IsometrySettings,
    ) -> Self {
        debug_assert_eq!(settings.check(), Ok(()));
        let variables = source.sites.first(settings.n_variables);
        let places = source.sites.picked(variables);
        let labels = target.sites;
        let signs = source.signs.picked(variables);
        let unary = |signs: &SiteDescriptors| unary_potentials(signs, &target.signs, &settings);
        let edges = edges(variables.len(), |i, j| places.distance(i, j), labels.len(), &settings);
        let model = MetricModel::new(labels.distances.clone(), unary(&signs), edges, settings.truncation);
        Isometry {
            settings,
            mirrored: model.with_unary(unary(&signs.mirrored())),
            model,
            points: variables.iter().map(|&k| source.places[k as usize]).collect(),
            source: source.sites,
            variables,
            labels,
            places: target.places.clone(),
        }
    }

    /// For each assignment of extremities its bias. Cost `O(assignments · variables · labels)`.
    pub(crate) fn of_extremities(&self) -> Vec<Vec<f32>> {
        let (places, labels) = (self.source.picked(self.variables), self.labels.all());
        assignments(&places, &labels, self.settings.stretch)
            .iter()
            .map(|pairs| bias_of_pairs(pairs, &places, &labels, &self.settings))
            .collect()
    }
}

/// Edges between `n` variables at these distances on the source, for `n_labels` labels.
pub(crate) fn edges(
    n: usize,
    distance: impl Fn(usize, usize) -> f64,
    n_labels: usize,
    settings: &IsometrySettings,
) -> Vec<MetricEdge> {
    // Lengths in roots of the area: an area of 1.
    let spacing = 1.0 / (n as f64).sqrt();
    let edge = |i: usize, j: usize| {
        let length = distance(i, j);
        let weight = 0.5 * settings.pair_weight / variance_of_distance(length, n_labels, settings);
        MetricEdge { ends: [i as u32, j as u32], length: length as f32, weight: weight as f32 }
    };
    let near =
        (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| distance(i, j) < settings.near * spacing);
    // In farthest-point order the index of a variable says nothing about its place, so any step leads far away.
    let far = (0..n).flat_map(|i| settings.far_steps.map(|step| (i, (i + step) % n))).filter(|(i, j)| i != j);
    near.chain(far).map(|(i, j)| edge(i, j)).collect()
}
