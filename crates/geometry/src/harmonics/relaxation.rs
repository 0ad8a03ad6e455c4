//! Optimizes a map onto the sphere: equal areas first, then little stretching.
//!
//! The energy of a map that takes vertex `i` to the unit vector `nᵢ` is
//!
//! `E = Σ_f 2 A_f² / det_f + μ/2 Σ_ij w_ij ‖nᵢ − nⱼ‖²`
//!
//! with the target area `A_f` of triangle `f`, the determinant `det_f` of its corners (nearly twice its area on the
//! sphere) and the weights `w_ij` of the edges. The areas on the sphere always sum to `4π`, so the first sum is
//! smallest when they equal the target areas. It diverges as a triangle collapses, so a descent from a map without
//! folds creates none. The second sum selects the map with the least stretching among the many area-preserving maps.
//!
//! The Hessians of both terms resemble a Laplacian, so the Laplacian of the surface is the preconditioner. With it the
//! number of steps hardly depends on the number of vertices.
//!
//! Source: the objective and constraints of Brechbühler, Gerig, Kübler 1995 (stretching, areas), combined in one energy
//! with the barrier of symmetric distortion energies (Smith, Schaefer, ACM Trans. Graph. 34(4), 2015).

use super::sphere::{TargetAreas, determinant};
use super::weights::WeightedEdges;
use super::{HarmonicsError, ParametrizationOptions};
use crate::sparse::{Cholesky, Place, factorized};
use homolog_primitives::lbfgs::{self, Objective};
use homolog_primitives::observe::Observer;
use nalgebra::Vector3;

/// A map after relaxation.
pub(super) struct Relaxed {
    pub directions: Vec<Vector3<f64>>,
    pub iterations: u32,
    pub converged: bool,
}

/// Minimizes the energy of the map `directions`, which must have no folds; the result has none either.
///
/// # Errors
/// [`HarmonicsError::NotPositiveDefinite`]; [`HarmonicsError::Cancelled`].
pub(super) fn relax(
    directions: Vec<Vector3<f64>>,
    edges: &WeightedEdges,
    areas: &TargetAreas,
    options: &ParametrizationOptions,
    observer: &dyn Observer,
) -> Result<Relaxed, HarmonicsError> {
    let energy =
        MapEnergy { edges, areas, stretching: options.stretching, factor: preconditioner(edges, areas, observer)? };
    let start = directions.iter().flat_map(|d| [d.x, d.y, d.z]).collect();
    let minimum = lbfgs::minimize(&energy, start, options.max_iterations, options.tolerance, observer)?;
    let directions = points(&minimum.x).map(|x| x.normalize()).collect();
    Ok(Relaxed { directions, iterations: minimum.iterations, converged: minimum.converged })
}

/// `2 L + M`: twice the Laplacian, as in the Hessian of the area term, and the masses that make it definite.
fn preconditioner(
    edges: &WeightedEdges,
    areas: &TargetAreas,
    observer: &dyn Observer,
) -> Result<Cholesky, HarmonicsError> {
    let n = edges.n_vertices();
    let masses = areas.of_vertices();
    let capacity = edges.graph.n_directed_edges() / 2 + n;
    let (mut places, mut values) = (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
    for (i, mass) in masses.iter().enumerate() {
        let mut diagonal = *mass;
        for (j, w) in edges.neighbors(i) {
            diagonal += 2.0 * w;
            if j < i {
                places.push(Place::new(i, j));
                values.push(-2.0 * w);
            }
        }
        places.push(Place::new(i, i));
        values.push(diagonal);
    }
    factorized(n, &places, &values, observer)?.ok_or(HarmonicsError::NotPositiveDefinite)
}

/// The energy as a function of arbitrary vectors, of which only the directions count. Steps therefore need not stay on
/// the sphere, and gradients at different points can be compared.
struct MapEnergy<'a> {
    edges: &'a WeightedEdges,
    areas: &'a TargetAreas,
    stretching: f64,
    factor: Cholesky,
}

fn points(x: &[f64]) -> impl Iterator<Item = Vector3<f64>> {
    x.chunks_exact(3).map(|c| Vector3::new(c[0], c[1], c[2]))
}

impl Objective for MapEnergy<'_> {
    fn evaluate(&self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let directions: Vec<Vector3<f64>> = points(x).map(|x| x.normalize()).collect();
        let mut slopes = vec![Vector3::zeros(); directions.len()];
        let mut value = 0.0;
        for (&[a, b, c], &wanted) in self.areas.triangles.iter().zip(&self.areas.areas) {
            let (p, q, r) = (directions[a], directions[b], directions[c]);
            let det = determinant([p, q, r]);
            if det <= 0.0 || det.is_nan() {
                return f64::INFINITY;
            }
            let term = 2.0 * wanted * wanted / det;
            value += term;
            let slope = -term / det;
            slopes[a] += slope * q.cross(&r);
            slopes[b] += slope * r.cross(&p);
            slopes[c] += slope * p.cross(&q);
        }
        for (i, p) in directions.iter().enumerate() {
            for (j, w) in self.edges.neighbors(i) {
                let apart = p - directions[j];
                // Every edge occurs twice, once from each end.
                value += self.stretching * w * apart.norm_squared() / 4.0;
                slopes[i] += self.stretching * w * apart;
            }
        }
        for ((slope, direction), (x, into)) in
            slopes.iter().zip(&directions).zip(points(x).zip(gradient.chunks_exact_mut(3)))
        {
            let tangential = (slope - direction * direction.dot(slope)) / x.norm();
            into.copy_from_slice(tangential.as_slice());
        }
        value
    }

    fn precondition(&self, v: &[f64]) -> Vec<f64> {
        let n = v.len() / 3;
        let solved = self.factor.solve(n, 3, &|i, k| v[3 * i + k]);
        (0..3 * n).map(|at| solved[(at / 3, at % 3)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let mesh = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 1);
        let (edges, areas) = (WeightedEdges::new(&mesh).unwrap(), TargetAreas::new(&mesh));
        let factor = preconditioner(&edges, &areas, &Silent).unwrap();
        let energy = MapEnergy { edges: &edges, areas: &areas, stretching: 0.3, factor };
        let x: Vec<f64> = mesh.vertices().iter().flat_map(|p| [p.x / 2.0, p.y / 1.8, p.z]).collect();
        let mut gradient = vec![0.0; x.len()];
        assert!(energy.evaluate(&x, &mut gradient).is_finite());
        let mut unused = vec![0.0; x.len()];
        for k in 0..x.len() {
            let mut at = |by: f64| {
                let mut moved = x.clone();
                moved[k] += by;
                energy.evaluate(&moved, &mut unused)
            };
            let slope = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!((slope - gradient[k]).abs() < 1e-6 * (1.0 + slope.abs()), "{k}: {slope} and {}", gradient[k]);
        }
    }

    #[test]
    fn a_folded_map_has_infinite_energy() {
        let mesh = ellipsoid(Vector3::new(1.0, 1.0, 1.0), 1);
        let (edges, areas) = (WeightedEdges::new(&mesh).unwrap(), TargetAreas::new(&mesh));
        let factor = preconditioner(&edges, &areas, &Silent).unwrap();
        let energy = MapEnergy { edges: &edges, areas: &areas, stretching: 0.3, factor };
        let mut x: Vec<f64> = mesh.vertices().iter().flat_map(|p| [p.x, p.y, p.z]).collect();
        let mut gradient = vec![0.0; x.len()];
        assert!(energy.evaluate(&x, &mut gradient).is_finite());
        x[..3].iter_mut().for_each(|c| *c = -*c);
        assert_eq!(energy.evaluate(&x, &mut gradient), f64::INFINITY);
    }
}
