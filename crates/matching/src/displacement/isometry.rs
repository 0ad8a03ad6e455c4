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
//! It starts from the correspondences of the forms and from assignments of extremities ([`super::extremities`]): each is a bias of
//! belief propagation, which is then taken away ([`homolog_mrf::metric`]), and it starts from nothing as well. The labelings are
//! fused, since one is right about the arms and another about the legs. The energy says which labeling is right; `make energies`
//! measures how often.

use super::DisplacementOptions;
use super::extremities::assignments;
use super::forms::{Form, FormMatch, Measured, Places, form_matches};
use super::surface::{N_FEATURES, SmoothSurface, prepare};
use crate::MatchError;
use crate::lengths::Lengths;
use crate::side::Side;
use homolog_mesh::SurfaceMesh;
use homolog_mrf::Labeling;
use homolog_mrf::metric::{MetricEdge, MetricModel};
use homolog_primitives::points::farthest_points;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Variables.
const N_VARIABLES: usize = 160;
/// Edges join variables closer than this, in spacings of the variables, and each with so many more far away.
const NEAR: f64 = 2.2;
const FAR_STEPS: [usize; 4] = [37, 53, 71, 89];
/// Standard deviation of a label's distance from the place it stands for, in spacings of the labels, and of the change of a
/// distance, relative to it.
const LABEL_NOISE: f64 = 0.35;
pub(super) const STRETCH: f64 = 0.15;
/// Weight of a pairwise potential: distances that share an end are not independent.
const PAIR_WEIGHT: f64 = 0.5;
/// Truncation of a pairwise and of a unary term.
const TRUNCATION: f32 = 3.0;
const UNARY_TRUNCATION: f64 = 4.5;
/// Standard deviation of the difference of a feature at corresponding places, in its standard deviation over the surface.
const FEATURE_NOISE: f64 = 0.5;
/// Widths over which features and chirality are averaged, in roots of the area.
const FEATURE_WIDTH: f64 = 0.04;
const CHIRALITY_WIDTH: f64 = 0.08;
/// Pairs of features whose plane gives a chirality; `N_FEATURES` stands for the eccentricity.
const PLANES: [[usize; 2]; 7] = [[0, 2], [2, 4], [1, 3], [3, 5], [2, N_FEATURES], [4, N_FEATURES], [3, N_FEATURES]];
/// Standard deviation of the place that a form proposes, in roots of the area, the most that its bias may cost, and its
/// weight.
const BIAS_WIDTH: f64 = 0.08;
const BIAS_TRUNCATION: f64 = 6.0;
const BIAS_WEIGHT: f64 = 0.5;
/// Iterations of belief propagation, more without a bias, as what is said has to come from farther away; its damping, and sweeps
/// of conditional modes after it. Of 24 pairs of realistic people five had from nothing a labeling that was off by 5 % of the diagonal and
/// more after 10 iterations, three after 30.
const ITERATIONS: usize = 10;
const ITERATIONS_FROM_NOTHING: usize = 30;
const DAMPING: f32 = 0.4;
const SWEEPS: usize = 10;
/// Labels within so many spacings of the best one take part in the mean that is the image.
const BLENDED: f64 = 1.5;

/// Correspondences of places on both surfaces, with their energy.
#[derive(Debug, Clone)]
pub(super) struct NearIsometry {
    /// Places on the source, mm.
    pub points: Vec<Point3<f64>>,
    /// The corresponding points of the target, mm.
    pub images: Vec<Point3<f64>>,
    /// Energy of the labeling; lower is better.
    pub energy: f64,
}

impl NearIsometry {
    /// The energy over the number of variables.
    pub(super) fn mean_energy(&self) -> f64 {
        self.energy / self.points.len() as f64
    }
}

/// The energy of near isometries between two surfaces, and where its minimization begins: for measuring the energy itself.
#[derive(Debug, Clone, PartialEq)]
pub struct NearIsometryModel {
    /// The energy.
    pub model: MetricModel,
    /// The vertex of the source that each variable is.
    pub variables: Vec<u32>,
    /// The vertex of the target that each label is.
    pub labels: Vec<u32>,
    /// For each correspondence of the forms what it adds to the unary potentials at first.
    pub of_forms: Vec<Vec<f32>>,
    /// The same for each assignment of extremities.
    pub of_extremities: Vec<Vec<f32>>,
}

impl NearIsometryModel {
    /// The labeling to which belief propagation with a bias at first, or with an empty one, and conditional modes lead.
    pub fn minimised(&self, bias: &[f32]) -> Labeling {
        minimised(&self.model, bias)
    }

    /// The labeling to which fusing `labelings`, and conditional modes, lead; `None` of none.
    pub fn fused(&self, labelings: &[Labeling]) -> Option<Labeling> {
        fused(&self.model, labelings)
    }
}

fn minimised(model: &MetricModel, bias: &[f32]) -> Labeling {
    let iterations = if bias.is_empty() { ITERATIONS_FROM_NOTHING } else { ITERATIONS };
    model.descend(model.max_product(bias, iterations, DAMPING), SWEEPS)
}

fn fused(model: &MetricModel, labelings: &[Labeling]) -> Option<Labeling> {
    model.fused_of_all(labelings, SWEEPS)
}

/// The model of two surfaces in canonical numbering; `None` where one has too few vertices or pieces that no form holds.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn near_isometry_model(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
) -> Result<Option<NearIsometryModel>, MatchError> {
    let (source, target) = (Side::new(source), Side::new(target));
    let root_mm = Lengths::of(&source, &target).root_mm;
    let smooth = prepare(source.mesh(), target.mesh(), root_mm, false)?;
    let (Some(of_source), Some(of_target)) = (source.form(), target.form()) else { return Ok(None) };
    let (source, target) = ((&*smooth.0, of_source), (&*smooth.1, of_target));
    let isometry = Isometry::new(source, target);
    let matches = form_matches(source, target, &DisplacementOptions::default());
    let measured = &of_target.measured;
    Ok(Some(NearIsometryModel {
        variables: isometry.variables.iter().map(|&k| of_source.sites[k as usize]).collect(),
        labels: measured.labels.vertices.iter().map(|&v| measured.vertices[v as usize]).collect(),
        of_forms: matches.iter().map(|guess| isometry.bias(guess)).collect(),
        of_extremities: isometry.of_extremities,
        model: isometry.model,
    }))
}

/// The field between two surfaces.
pub(super) struct Isometry<'a> {
    model: MetricModel,
    /// The same for a source that is mirrored: the chirality of its places has the other sign.
    mirrored: MetricModel,
    /// For each assignment of extremities what it adds to the unary potentials at first.
    of_extremities: Vec<Vec<f32>>,
    /// The sites of the source's form that are variables.
    variables: Vec<u32>,
    points: Vec<Point3<f64>>,
    labels: &'a Places,
    /// The labels on the target, mm.
    places: Vec<Point3<f64>>,
    target_root_mm: f64,
}

impl<'a> Isometry<'a> {
    /// The field between two surfaces with their forms.
    ///
    /// # Cost
    /// `O(sites · (vertices of the measured level + variables))`.
    pub(super) fn new(
        (source, of_source): (&SmoothSurface, &Form),
        (target, of_target): (&SmoothSurface, &'a Form),
    ) -> Self {
        let sites = of_source.places(source);
        let variables: Vec<u32> = farthest_points(&sites, N_VARIABLES).into_iter().map(|k| k as u32).collect();
        let places = of_source.measured.sites.picked(&variables);
        let labels = &of_target.measured.labels;
        let (a, b) = rayon::join(
            || Signs::of(source, &of_source.measured, &places),
            || Signs::of(target, &of_target.measured, labels),
        );
        let n = labels.vertices.len();
        let distances: Vec<f32> = (0..n).flat_map(|x| (0..n).map(move |y| labels.distance(x, y) as f32)).collect();
        let place = |&v: &u32| target.mesh.vertices()[of_target.measured.vertices[v as usize] as usize];
        let model = MetricModel::new(distances, unary_potentials(&a, &b), edges(&places, n), TRUNCATION);
        Isometry {
            of_extremities: assignments(&places, labels).iter().map(|pairs| bias_of(pairs, &places, labels)).collect(),
            mirrored: model.with_unary(unary_potentials(&a.mirrored(), &b)),
            model,
            points: variables.iter().map(|&k| sites[k as usize]).collect(),
            variables,
            places: labels.vertices.iter().map(place).collect(),
            labels,
            target_root_mm: target.mesh.area().sqrt(),
        }
    }

    /// The correspondences to which belief propagation and conditional modes lead from the `guesses`, from extremities and from
    /// nothing, and the fusion of all of them.
    ///
    /// Cost `O(edges · labels²)` for each start: 0.05 s of one core, measured on people of 5,000 vertices.
    pub(super) fn correspondences(&self, guesses: &[FormMatch]) -> Vec<NearIsometry> {
        let labelings = self.labelings(&self.model, guesses);
        let fused = fused(&self.model, &labelings);
        let correspondence = |labeling: &Labeling| NearIsometry {
            points: self.points.clone(),
            images: self.images(labeling),
            energy: self.model.energy(labeling).total(),
        };
        labelings.iter().chain(&fused).map(correspondence).collect()
    }

    /// The lowest energy to which the `guesses`, extremities and nothing lead if the source is mirrored.
    ///
    /// Cost as that of [`Isometry::correspondences`].
    pub(super) fn lowest_mirrored(&self, guesses: &[FormMatch]) -> f64 {
        let fused = fused(&self.mirrored, &self.labelings(&self.mirrored, guesses));
        fused.map_or(f64::INFINITY, |labeling| self.mirrored.energy(&labeling).total())
    }

    /// The labelings of `model` from each of the `guesses`, from each assignment of extremities and from nothing.
    fn labelings(&self, model: &MetricModel, guesses: &[FormMatch]) -> Vec<Labeling> {
        let of_forms: Vec<Vec<f32>> = guesses.iter().map(|guess| self.bias(guess)).collect();
        // The longest first.
        let starts: Vec<&[f32]> =
            [[].as_slice()].into_iter().chain(of_forms.iter().chain(&self.of_extremities).map(Vec::as_slice)).collect();
        starts.par_iter().map(|bias| minimised(model, bias)).collect()
    }

    /// What `guess` adds to the unary potentials where belief propagation begins.
    fn bias(&self, guess: &FormMatch) -> Vec<f32> {
        let width_mm = BIAS_WIDTH * self.target_root_mm;
        let bias = |&k: &u32| {
            let proposed = guess.images[k as usize];
            let weight = BIAS_WEIGHT * guess.mass[k as usize].min(1.0);
            self.places.iter().map(move |q| {
                let squared = (q - proposed).norm_squared() / (width_mm * width_mm);
                (weight * (0.5 * squared).min(BIAS_TRUNCATION)) as f32
            })
        };
        self.variables.iter().flat_map(bias).collect()
    }

    /// For each variable the mean of the labels about its own, weighted by what they would cost.
    fn images(&self, labeling: &[u32]) -> Vec<Point3<f64>> {
        let near = BLENDED / (self.places.len() as f64).sqrt();
        (0..labeling.len())
            .map(|i| {
                let own = labeling[i] as usize;
                let cost = self.model.conditional(i, labeling);
                let (mut total, mut sum) = (0.0, Vector3::zeros());
                for (x, q) in self.places.iter().enumerate() {
                    if self.labels.distance(own, x) <= near {
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

/// What is measured at the places of one surface, `places × …` each.
struct Signs {
    features: Vec<Vec<f64>>,
    chirality: Vec<Vec<f64>>,
    eccentricity: Vec<Vec<f64>>,
}

impl Signs {
    /// Those of the mirror image.
    fn mirrored(&self) -> Signs {
        let negated = |values: &Vec<f64>| values.iter().map(|x| -x).collect();
        Signs {
            features: self.features.clone(),
            chirality: self.chirality.iter().map(negated).collect(),
            eccentricity: self.eccentricity.clone(),
        }
    }

    /// At `places` of the measured level of `surface`.
    fn of(surface: &SmoothSurface, measured: &Measured, places: &Places) -> Signs {
        let n = measured.mesh.n_vertices();
        // Even samples, so that each counts alike.
        let all = &measured.labels.rows;
        let mean_square = |v: usize| all.iter().map(|row| row[v] * row[v]).sum::<f64>() / all.len() as f64;
        let eccentricity: Vec<f64> = (0..n).map(|v| mean_square(v).sqrt()).collect();
        let value = |v: u32, f: usize| {
            if f == N_FEATURES {
                eccentricity[v as usize]
            } else {
                surface.features[measured.vertices[v as usize] as usize * N_FEATURES + f]
            }
        };
        let triangles: Vec<[u32; 3]> = measured.mesh.triangles();
        let at = |(&own, row): (&u32, &Vec<f64>)| {
            let weight = |distance: f64, width: f64| (-0.5 * (distance / width).powi(2)).exp();
            let (mut total, mut features) = (0.0, vec![0.0; N_FEATURES]);
            for v in 0..n as u32 {
                let w = weight(row[v as usize], FEATURE_WIDTH);
                total += w;
                features.iter_mut().enumerate().for_each(|(f, sum)| *sum += w * value(v, f));
            }
            features.iter_mut().for_each(|sum| *sum /= total);
            let mut chirality = vec![0.0; PLANES.len()];
            for t in &triangles {
                let distance = t.iter().map(|&v| row[v as usize]).sum::<f64>() / 3.0;
                if distance > 4.0 * CHIRALITY_WIDTH {
                    continue;
                }
                let w = weight(distance, CHIRALITY_WIDTH);
                for (sum, [f, g]) in chirality.iter_mut().zip(PLANES) {
                    let [a, b, c] = t.map(|v| [value(v, f), value(v, g)]);
                    *sum += w * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
                }
            }
            // A product of two features: the root has their spread.
            chirality.iter_mut().for_each(|x| *x = x.signum() * x.abs().sqrt());
            (features, chirality, vec![eccentricity[own as usize]])
        };
        let found: Vec<_> = places.vertices.par_iter().zip(&places.rows).map(at).collect();
        let mut signs = Signs { features: Vec::new(), chirality: Vec::new(), eccentricity: Vec::new() };
        for (features, chirality, eccentricity) in found {
            signs.features.push(features);
            signs.chirality.push(chirality);
            signs.eccentricity.push(eccentricity);
        }
        signs
    }
}

/// What `pairs` of a variable and a label, which correspond, add to the unary potentials of all `places` and `labels`: corresponding places
/// have the same distances from them.
fn bias_of(pairs: &[(usize, usize)], places: &Places, labels: &Places) -> Vec<f32> {
    let (n, n_labels) = (places.vertices.len(), labels.vertices.len());
    let bias = |(i, x): (usize, usize)| {
        let squared = pairs.iter().map(|&(j, y)| {
            let distance = places.distance(i, j);
            (labels.distance(x, y) - distance).powi(2) / variance_of_distance(distance, n_labels)
        });
        (BIAS_WEIGHT * (0.5 * squared.sum::<f64>()).min(BIAS_TRUNCATION)) as f32
    };
    (0..n).flat_map(|i| (0..n_labels).map(move |x| (i, x))).map(bias).collect()
}

/// Variance of the distance of the labels of two variables that are `distance` apart, for `n_labels` labels.
fn variance_of_distance(distance: f64, n_labels: usize) -> f64 {
    // Lengths in roots of the area: an area of 1.
    let spacing = 1.0 / (n_labels as f64).sqrt();
    2.0 * (LABEL_NOISE * spacing).powi(2) + (STRETCH * distance).powi(2)
}

/// For every variable and label the sum of the means over features, chirality and eccentricity.
fn unary_potentials(source: &Signs, target: &Signs) -> Vec<f32> {
    let mut unary = vec![0.0; source.features.len() * target.features.len()];
    for (a, b) in [
        (&source.features, &target.features),
        (&source.chirality, &target.chirality),
        (&source.eccentricity, &target.eccentricity),
    ] {
        let n = a[0].len();
        for f in 0..n {
            let noise = FEATURE_NOISE * pooled_deviation(a.iter().map(|x| x[f]), b.iter().map(|x| x[f]));
            for (i, x) in a.iter().enumerate() {
                for (k, y) in b.iter().enumerate() {
                    let squared = ((x[f] - y[f]) / noise).powi(2);
                    unary[i * b.len() + k] += (0.5 * squared).min(UNARY_TRUNCATION) / n as f64;
                }
            }
        }
    }
    unary.into_iter().map(|u| u as f32).collect()
}

/// Standard deviation of the values of both surfaces about their own means, and of those means.
fn pooled_deviation(a: impl Iterator<Item = f64> + Clone, b: impl Iterator<Item = f64> + Clone) -> f64 {
    let moments = |values: &mut dyn Iterator<Item = f64>| {
        let (mut n, mut sum, mut squares) = (0.0, 0.0, 0.0);
        for x in values {
            n += 1.0;
            sum += x;
            squares += x * x;
        }
        (sum / n, squares / n - (sum / n).powi(2))
    };
    let ((mean_a, var_a), (mean_b, var_b)) = (moments(&mut a.clone()), moments(&mut b.clone()));
    // A feature that is the same everywhere says nothing; the floor avoids a division by 0.
    ((var_a.max(0.0) + var_b.max(0.0) + (mean_a - mean_b).powi(2)) / 2.0).sqrt().max(f64::MIN_POSITIVE.sqrt())
}

/// Edges between `places` of the source, for `n_labels` labels.
fn edges(places: &Places, n_labels: usize) -> Vec<MetricEdge> {
    let n = places.vertices.len();
    // Lengths in roots of the area: an area of 1.
    let spacing = 1.0 / (n as f64).sqrt();
    let edge = |i: usize, j: usize| {
        let length = places.distance(i, j);
        let weight = 0.5 * PAIR_WEIGHT / variance_of_distance(length, n_labels);
        MetricEdge { ends: [i as u32, j as u32], length: length as f32, weight: weight as f32 }
    };
    let near =
        (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| places.distance(i, j) < NEAR * spacing);
    // Farthest-point order leaves no trace of where a variable is, so any step leads far away.
    let far = (0..n).flat_map(|i| FAR_STEPS.map(|step| (i, (i + step) % n))).filter(|(i, j)| i != j);
    near.chain(far).map(|(i, j)| edge(i, j)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::canonicalize;
    use homolog_mesh::shapes::ellipsoid;

    /// A surface with one plane of symmetry, `z = 0`, bent by `angle` radians within that plane, in canonical numbering.
    fn symmetric(angle: f64) -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(16.0, 6.0, 5.0), 4);
        let radius = 32.0 / angle;
        let shaped = |p: &Point3<f64>| {
            let (y, z) = (p.y * (1.0 + 0.02 * p.x) + 0.01 * p.x * p.x, p.z * (1.0 - 0.015 * p.x + 0.02 * p.y));
            let phi = p.x / radius;
            Point3::new((radius - y) * phi.sin(), radius - (radius - y) * phi.cos(), z)
        };
        canonicalize(&mesh.with_vertices(mesh.vertices().iter().map(shaped).collect()).unwrap()).mesh
    }

    fn nearest(places: &[Point3<f64>], to: Point3<f64>) -> u32 {
        let away = |k: &u32| (places[*k as usize] - to).norm();
        (0..places.len() as u32).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap()
    }

    fn at(mesh: &SurfaceMesh, vertices: &[u32]) -> Vec<Point3<f64>> {
        vertices.iter().map(|&k| mesh.vertices()[k as usize]).collect()
    }

    #[test]
    fn the_truth_has_a_lower_energy_than_its_mirror_image() {
        let mesh = symmetric(0.4);
        let found = near_isometry_model(&mesh, &mesh).unwrap().unwrap();
        let (variables, labels) = (at(&mesh, &found.variables), at(&mesh, &found.labels));
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let mirrored: Vec<u32> = variables.iter().map(|p| nearest(&labels, Point3::new(p.x, p.y, -p.z))).collect();
        let [truth, mirrored] = [truth, mirrored].map(|x| found.model.energy(&found.model.descend(x, 20)));
        assert!(truth.unary + 40.0 < mirrored.unary, "{truth:?} {mirrored:?}");
        // Distances along the surface are those of the mirror image: what they add is the distance of labels from places.
        assert!(mirrored.pairwise < 0.5 * mirrored.unary, "{truth:?} {mirrored:?}");
    }

    #[test]
    fn a_collapse_costs_more_than_the_truth() {
        let mesh = symmetric(0.4);
        let found = near_isometry_model(&mesh, &mesh).unwrap().unwrap();
        let (variables, labels) = (at(&mesh, &found.variables), at(&mesh, &found.labels));
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let energy = |x: &[u32]| found.model.energy(x).total();
        for collapsed in [vec![truth[0]; truth.len()], truth.iter().map(|&x| x % 8).collect()] {
            assert!(energy(&collapsed) > 3.0 * energy(&truth), "{} {}", energy(&collapsed), energy(&truth));
        }
    }

    #[test]
    fn propagation_from_forms_and_from_extremities_ends_as_low_as_the_truth_and_where_it_is() {
        let (source, target) = (symmetric(0.2), symmetric(1.6));
        let found = near_isometry_model(&source, &target).unwrap().unwrap();
        // Where a point of the bent surface lies on the straighter one: the same place along and about the axis.
        let unbent = |p: &Point3<f64>, angle: f64| {
            let radius = 32.0 / angle;
            let phi = p.x.atan2(radius - p.y);
            Point3::new(phi * radius, radius - (radius - p.y) / phi.cos(), p.z)
        };
        let variables: Vec<_> = at(&source, &found.variables).iter().map(|p| unbent(p, 0.2)).collect();
        let labels: Vec<_> = at(&target, &found.labels).iter().map(|p| unbent(p, 1.6)).collect();
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let energy = |x: &[u32]| found.model.energy(x).total();
        let relaxed = energy(&found.model.descend(truth, 50));
        for starts in [&found.of_forms, &found.of_extremities] {
            let labelings = starts.iter().map(|bias| found.minimised(bias));
            let best = labelings.min_by(|a, b| energy(a).total_cmp(&energy(b))).unwrap();
            let away = best.iter().zip(&variables).map(|(&x, p)| (labels[x as usize] - p).norm()).sum::<f64>() / 160.0;
            assert!(energy(&best) < 1.1 * relaxed, "{} {relaxed}", energy(&best));
            assert!(away < 2.0, "{away} mm away, of a surface 32 mm long");
        }
    }
}
