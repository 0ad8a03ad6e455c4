//! The lowest eigenvalues and eigenfunctions of the Laplace-Beltrami operator of a surface, and signatures computed
//! from them.
//!
//! The eigenproblem is `L φ = λ A φ` with the cotangent Laplacian `L` and the areas `A` of the vertices. The operator
//! `A^½ (L + s A)⁻¹ A^½` has the same eigenvectors with eigenvalues `1/(λ + s)`. The lowest `λ` become the largest
//! eigenvalues, and they are far apart: block Lanczos with full orthogonalization needs only a few more products than
//! there are pairs. A single vector would find only one eigenvector of a multiple eigenvalue, and symmetric surfaces
//! have multiple eigenvalues, so blocks are used.
//!
//! Sources: Pinkall, Polthier 1993 (cotangents); Vallet, Lévy, "Spectral geometry processing with manifold harmonics",
//! Computer Graphics Forum 27(2), 2008 (shift and invert); Golub, Underwood, "The block Lanczos method", 1977; Sun,
//! Ovsjanikov, Guibas 2009 (heat kernel signature); Aubry, Schlickewei, Cremers 2011 (wave kernel signature).

use crate::curvature::{cotangent_weights, vertex_areas};
use crate::sparse::{Cholesky, Place, factorized};
use faer::{Mat, Side};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};

/// Vectors per block. Anatomical surfaces have no eigenvalue of a higher multiplicity. The eigenvalues of a sphere have
/// multiplicities 1, 3, 5, …, which the rounding of several blocks separates.
const BLOCK: usize = 6;
/// Largest relative error of an eigenvalue of the inverse.
const TOLERANCE: f64 = 1e-9;
/// The shift `s` in inverse areas of the surface; between 0 and the first eigenvalues, which are about 10 to 40.
const SHIFT: f64 = 1.0;
/// Least area of a vertex as a share of the mean: a vertex without faces then has a finite row.
const LEAST_AREA: f64 = 1e-6;

/// Eigenpairs, lowest eigenvalue first.
#[derive(Debug, Clone)]
pub struct Spectrum {
    /// Eigenvalues, 1/mm²; the first is 0 to rounding.
    pub values: Vec<f64>,
    /// Eigenfunctions as columns, `n × k`, 1/mm: orthonormal with the areas as weights. Each has an arbitrary sign.
    pub functions: Mat<f64>,
    /// Areas of the vertices, mm².
    pub areas: Vec<f64>,
}

/// The `k` lowest eigenpairs of `mesh`; fewer if it has fewer vertices. `None` if a number is not finite, so that no
/// factorization exists.
///
/// # Errors
/// [`Cancelled`]; the observer is asked for every block of vectors.
///
/// # Cost
/// One sparse Cholesky factorization, about `2.5 k` solves with it, and `O(n k²)`; memory `O(n k)`.
pub fn spectrum(mesh: &SurfaceMesh, k: usize, observer: &dyn Observer) -> Result<Option<Spectrum>, Cancelled> {
    let n = mesh.n_vertices();
    let k = k.min(n);
    let mut areas = vertex_areas(mesh);
    let total: f64 = areas.iter().sum();
    let least = LEAST_AREA * total / n as f64;
    areas.iter_mut().for_each(|a| *a = a.max(least));
    let shift = SHIFT / total;
    let Some(factor) = shifted(mesh, &areas, shift, observer)? else { return Ok(None) };
    let roots: Vec<f64> = areas.iter().map(|a| a.sqrt()).collect();
    let apply = |block: &Mat<f64>| {
        let solved = factor.solve(n, block.ncols(), &|i, c| roots[i] * block[(i, c)]);
        Mat::from_fn(n, block.ncols(), |i, c| roots[i] * solved[(i, c)])
    };
    let Some((inverse, vectors)) = largest(n, k, &apply, observer)? else { return Ok(None) };
    let values = inverse.iter().map(|theta| (1.0 / theta - shift).max(0.0)).collect();
    let functions = Mat::from_fn(n, k, |i, c| vectors[(i, c)] / roots[i]);
    Ok(Some(Spectrum { values, functions, areas }))
}

/// `L + s A`, factorized.
fn shifted(
    mesh: &SurfaceMesh,
    areas: &[f64],
    shift: f64,
    observer: &dyn Observer,
) -> Result<Option<Cholesky>, Cancelled> {
    let (mut places, mut values) = (Vec::new(), Vec::new());
    for w in cotangent_weights(mesh) {
        let (row, column) = (w.i.max(w.j), w.i.min(w.j));
        places.extend([Place::new(row, column), Place::new(w.i, w.i), Place::new(w.j, w.j)]);
        values.extend([-w.weight, w.weight, w.weight]);
    }
    for (i, area) in areas.iter().enumerate() {
        places.push(Place::new(i, i));
        values.push(shift * area);
    }
    factorized(areas.len(), &places, &values, observer)
}

/// Eigenvalues, descending, and eigenvectors.
type Eigenpairs = (Vec<f64>, Mat<f64>);

/// The `k` largest eigenvalues and their eigenvectors of the symmetric `n × n` operator `apply`.
fn largest(
    n: usize,
    k: usize,
    apply: &dyn Fn(&Mat<f64>) -> Mat<f64>,
    observer: &dyn Observer,
) -> Result<Option<Eigenpairs>, Cancelled> {
    let block = BLOCK.min(n);
    let mut wanted = (2 * k + 8 * block).min(n);
    let mut stream = 0x9e37_79b9_7f4a_7c15u64;
    // Columns of the Krylov basis and their images.
    let (mut basis, mut images): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let mut next: Vec<Vec<f64>> = (0..block).map(|_| random(n, &mut stream)).collect();
    loop {
        while basis.len() < wanted {
            checkpoint_within(observer)?;
            let from = basis.len();
            for mut v in next.drain(..) {
                // Only whole blocks: a direction that is left out would never come back.
                if basis.len() == n {
                    break;
                }
                // A direction that the basis already contains is replaced by a random one.
                while !orthonormalized(&mut v, &basis) {
                    v = random(n, &mut stream);
                }
                basis.push(v);
            }
            let columns = &basis[from..];
            let image = apply(&Mat::from_fn(n, columns.len(), |i, c| columns[c][i]));
            let image: Vec<Vec<f64>> = (0..columns.len()).map(|c| (0..n).map(|i| image[(i, c)]).collect()).collect();
            next = image.clone();
            images.extend(image);
        }
        let m = basis.len();
        let q = Mat::from_fn(n, m, |i, c| basis[c][i]);
        let b = Mat::from_fn(n, m, |i, c| images[c][i]);
        let projected = q.transpose() * &b;
        let Ok(eigen) = projected.self_adjoint_eigen(Side::Lower) else { return Ok(None) };
        // Eigenvalues are ascending there.
        let order: Vec<usize> = (0..m).rev().take(k).collect();
        let values: Vec<f64> = order.iter().map(|&c| eigen.S().column_vector()[c]).collect();
        let coordinates = Mat::from_fn(m, k, |i, c| eigen.U()[(i, order[c])]);
        let vectors = &q * &coordinates;
        let mapped = &b * &coordinates;
        let residual =
            |c: usize| (0..n).map(|i| (mapped[(i, c)] - values[c] * vectors[(i, c)]).powi(2)).sum::<f64>().sqrt();
        if values.iter().any(|v| !v.is_finite()) {
            return Ok(None);
        }
        if m == n || (0..k).all(|c| residual(c) <= TOLERANCE * values[0].abs()) {
            return Ok(Some((values, vectors)));
        }
        wanted = (wanted + k + 2 * block).min(n);
    }
}

/// Subtracts from `v` its projection on the orthonormal `basis`, twice for full precision, and scales it to length 1.
/// False if nothing is left.
fn orthonormalized(v: &mut [f64], basis: &[Vec<f64>]) -> bool {
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let before = norm(v);
    for _ in 0..2 {
        for q in basis {
            let share: f64 = q.iter().zip(v.iter()).map(|(a, b)| a * b).sum();
            v.iter_mut().zip(q).for_each(|(x, a)| *x -= share * a);
        }
    }
    let after = norm(v);
    if after.is_nan() || after <= 1e-12 * before {
        return false;
    }
    v.iter_mut().for_each(|x| *x /= after);
    true
}

/// Numbers in `[−1, 1)` from a multiplicative generator. Any start works that is not orthogonal to the wanted
/// eigenvectors.
fn random(n: usize, state: &mut u64) -> Vec<f64> {
    (0..n)
        .map(|_| {
            *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        })
        .collect()
}

impl Spectrum {
    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.areas.len()
    }

    /// The heat kernel signature at `n` times, `n_vertices × n`: `Σ e^(−λt) φ²` divided by its integral, so that its
    /// only unit is 1/area. Times are spaced logarithmically between those at which the last and the first
    /// eigenfunction have faded to `1e-4`.
    ///
    /// Cost `O(vertices · k · n)`.
    pub fn heat_signature(&self, n: usize) -> Mat<f64> {
        let (first, last) = self.range();
        let faded = 4.0 * std::f64::consts::LN_10;
        let (low, high) = ((faded / last).ln(), (faded / first).ln());
        let times: Vec<f64> = (0..n).map(|s| (low + (high - low) * share(s, n)).exp()).collect();
        self.signature(n, &|s, value| (-value * times[s]).exp())
    }

    /// The wave kernel signature at `n` energies, `n_vertices × n`: `Σ exp(−(e − ln λ)²/2σ²) φ²` divided by the sum of
    /// the weights, with `σ` of seven steps of the energy as its authors propose.
    ///
    /// Cost `O(vertices · k · n)`.
    pub fn wave_signature(&self, n: usize) -> Mat<f64> {
        let (first, last) = self.range();
        let (low, high) = (first.ln(), last.ln());
        let sigma = 7.0 * (high - low) / n as f64;
        let (low, high) = (low + 2.0 * sigma, high - 2.0 * sigma);
        let weight = |s: usize, value: f64| {
            let energy = low + (high - low) * share(s, n);
            // The constant function has no energy.
            if value < 0.5 * first { 0.0 } else { (-(energy - value.ln()).powi(2) / (2.0 * sigma * sigma)).exp() }
        };
        self.signature(n, &weight)
    }

    /// The first nonzero eigenvalue, and the last.
    fn range(&self) -> (f64, f64) {
        let last = self.values.last().copied().unwrap_or(1.0).max(f64::MIN_POSITIVE);
        let first = self.values.iter().copied().find(|v| *v > 1e-6 * last).unwrap_or(last);
        (first, last)
    }

    fn signature(&self, n: usize, weight: &dyn Fn(usize, f64) -> f64) -> Mat<f64> {
        let k = self.values.len();
        let weights = Mat::from_fn(k, n, |c, s| weight(s, self.values[c]));
        let totals: Vec<f64> = (0..n).map(|s| (0..k).map(|c| weights[(c, s)]).sum::<f64>()).collect();
        let squares = Mat::from_fn(self.n_vertices(), k, |i, c| self.functions[(i, c)].powi(2));
        let sums = squares * weights;
        Mat::from_fn(self.n_vertices(), n, |i, s| sums[(i, s)] / totals[s].max(f64::MIN_POSITIVE))
    }
}

/// Position of the `s`-th of `n` values between the first, 0, and the last, 1.
fn share(s: usize, n: usize) -> f64 {
    s as f64 / (n - 1).max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn the_sphere_has_the_eigenvalues_of_spherical_harmonics() {
        let radius = 3.0;
        let found = spectrum(&ellipsoid(Vector3::new(radius, radius, radius), 4), 16, &Silent).unwrap().unwrap();
        let mut expected = Vec::new();
        for degree in 0..4u32 {
            expected.extend(vec![f64::from(degree * (degree + 1)) / (radius * radius); 2 * degree as usize + 1]);
        }
        for (value, expected) in found.values.iter().zip(&expected) {
            assert!((value - expected).abs() < 0.01 * expected.max(0.01), "{value} for {expected}");
        }
    }

    #[test]
    fn eigenfunctions_are_orthonormal_and_solve_the_equation_as_a_dense_solver_does() {
        let mesh = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 2);
        let (n, k) = (mesh.n_vertices(), 20);
        let found = spectrum(&mesh, k, &Silent).unwrap().unwrap();
        let mut dense = Mat::<f64>::zeros(n, n);
        for w in cotangent_weights(&mesh) {
            dense[(w.i, w.j)] -= w.weight;
            dense[(w.j, w.i)] -= w.weight;
            dense[(w.i, w.i)] += w.weight;
            dense[(w.j, w.j)] += w.weight;
        }
        let roots: Vec<f64> = found.areas.iter().map(|a| a.sqrt()).collect();
        let scaled = Mat::from_fn(n, n, |i, j| dense[(i, j)] / (roots[i] * roots[j]));
        let eigen = scaled.self_adjoint_eigen(Side::Lower).unwrap();
        for c in 0..k {
            assert!((found.values[c] - eigen.S().column_vector()[c]).abs() < 1e-7, "{c}");
            for d in 0..k {
                let product: f64 =
                    (0..n).map(|i| found.areas[i] * found.functions[(i, c)] * found.functions[(i, d)]).sum();
                assert!((product - f64::from(u8::from(c == d))).abs() < 1e-9);
            }
            for i in 0..n {
                let left: f64 = (0..n).map(|j| dense[(i, j)] * found.functions[(j, c)]).sum();
                let right = found.values[c] * found.areas[i] * found.functions[(i, c)];
                assert!((left - right).abs() < 1e-6, "{left} {right}");
            }
        }
    }

    #[test]
    fn signatures_do_not_depend_on_the_signs_and_fade_with_the_size() {
        let small = spectrum(&ellipsoid(Vector3::new(5.0, 3.0, 2.0), 3), 40, &Silent).unwrap().unwrap();
        let large = spectrum(&ellipsoid(Vector3::new(10.0, 6.0, 4.0), 3), 40, &Silent).unwrap().unwrap();
        for (a, b) in
            [(small.heat_signature(10), large.heat_signature(10)), (small.wave_signature(10), large.wave_signature(10))]
        {
            for i in 0..small.n_vertices() {
                for s in 0..10 {
                    // Four times the area.
                    assert!((a[(i, s)] - 4.0 * b[(i, s)]).abs() < 1e-6 * a[(i, s)].abs().max(1e-9));
                }
            }
        }
    }
}
