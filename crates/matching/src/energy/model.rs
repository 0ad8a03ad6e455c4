//! The Markov random field of a bent surface: which place of the target each place of the source corresponds to, where
//! distances along the surface are kept and those through space are not.
//!
//! Variables are places spread evenly over the source, labels places spread evenly over the target. Neither pose nor
//! deformation takes part:
//!
//! - **Pairwise**: the distance along the target between two labels, given that along the source between the two variables:
//!   Gaussian, with the variance of sites that stand for cells and of a deformation in proportion to the distance. Edges join
//!   neighbors and places far apart.
//! - **Unary**: curvature at several scales; the eccentricity of the place, its root mean square distance to all others; and
//!   the **chirality** of its surroundings, which changes its sign in a mirror: the signed area that a neighborhood covers in
//!   the plane of two features, `∫ n · (∇f × ∇g)`. A person's left and right hand have the same distances and curvatures, and
//!   opposite chirality.
//!
//! It starts from the correspondences of the forms and from assignments of extremities ([`crate::starts::extremities`]): each is a bias of
//! belief propagation, which is then taken away ([`homolog_mrf::metric`]), and it starts from nothing as well. The labelings are
//! fused, since one is right about the arms and another about the legs. The energy says which labeling is right; `make energies`
//! measures how often.

use super::bias::bias_of_pairs;
use super::settings::IsometrySettings;
use super::signs::{Signs, unary_potentials};
use super::variance::variance_of_distance;
use crate::starts::extremities::assignments;
use crate::surface::form::{BendingInvariantForm, Places};
use crate::surface::smooth::SmoothSurface;
use homolog_mrf::metric::{MetricEdge, MetricModel};
use homolog_primitives::points::farthest_points;
use nalgebra::Point3;

/// The field between two surfaces.
pub(crate) struct Isometry<'a> {
    pub settings: IsometrySettings,
    /// The energy.
    pub model: MetricModel,
    /// The same for a source that is mirrored: the chirality of its places has the other sign.
    pub mirrored: MetricModel,
    /// For each assignment of extremities what it adds to the unary potentials at first.
    pub of_extremities: Vec<Vec<f32>>,
    /// The sites of the source's form that are variables.
    pub variables: Vec<u32>,
    /// The variables on the source, mm.
    pub points: Vec<Point3<f64>>,
    /// The labels, with their distances along the target.
    pub labels: &'a Places,
    /// The labels on the target, mm.
    pub places: Vec<Point3<f64>>,
    /// Root of the area of the target, mm.
    pub target_root_mm: f64,
}

impl<'a> Isometry<'a> {
    /// The field between two surfaces with their forms.
    ///
    /// # Cost
    /// `O(sites · (vertices of the measured level + variables))`.
    pub(crate) fn new(
        (source, of_source): (&SmoothSurface, &BendingInvariantForm),
        (target, of_target): (&SmoothSurface, &'a BendingInvariantForm),
        settings: IsometrySettings,
    ) -> Self {
        debug_assert_eq!(settings.check(), Ok(()));
        let sites = of_source.places(&source.mesh);
        let variables: Vec<u32> = farthest_points(&sites, settings.n_variables).into_iter().map(|k| k as u32).collect();
        let places = of_source.measured.sites.picked(&variables);
        let labels = &of_target.measured.labels;
        let (a, b) = rayon::join(
            || Signs::of(source, &of_source.measured, &places, &settings),
            || Signs::of(target, &of_target.measured, labels, &settings),
        );
        let n = labels.vertices.len();
        let distances: Vec<f32> = (0..n).flat_map(|x| (0..n).map(move |y| labels.distance(x, y) as f32)).collect();
        let place = |&v: &u32| target.mesh.vertices()[of_target.measured.vertices[v as usize] as usize];
        let model = MetricModel::new(
            distances,
            unary_potentials(&a, &b, &settings),
            edges(places.vertices.len(), |i, j| places.distance(i, j), n, &settings),
            settings.truncation,
        );
        Isometry {
            settings,
            of_extremities: assignments(&places, labels, settings.stretch)
                .iter()
                .map(|pairs| bias_of_pairs(pairs, &places, labels, &settings))
                .collect(),
            mirrored: model.with_unary(unary_potentials(&a.mirrored(), &b, &settings)),
            model,
            points: variables.iter().map(|&k| sites[k as usize]).collect(),
            variables,
            places: labels.vertices.iter().map(place).collect(),
            labels,
            target_root_mm: target.mesh.area().sqrt(),
        }
    }
}

/// Edges between `n` variables that lie so far apart on the source, for `n_labels` labels.
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
    // Farthest-point order leaves no trace of where a variable is, so any step leads far away.
    let far = (0..n).flat_map(|i| settings.far_steps.map(|step| (i, (i + step) % n))).filter(|(i, j)| i != j);
    near.chain(far).map(|(i, j)| edge(i, j)).collect()
}
