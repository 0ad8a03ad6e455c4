//! The flow of a stationary velocity field: a map without folds whose inverse is the flow back.
//!
//! `v(x) = Σ_k exp(−‖x − c_k‖²/2w²) m_k` with momenta `m_k` at control points on the source; a point moves by `ẋ = v(x)` for one
//! unit of time. The momenta minimize
//!
//! `‖φ(S) − T‖² / ‖T‖² + ρ Σ_kl exp(−‖c_k − c_l‖²/2w²) m_k · m_l`
//!
//! by L-BFGS, with the varifold distance, which represents surfaces as sums of their faces' centers, areas and tangent
//! planes and needs no correspondence. Its width falls from coarse to fine. The gradient is exact for the discrete
//! flow, computed backwards through its steps.
//!
//! Sources: Arsigny et al., "A log-Euclidean framework for statistics on diffeomorphisms", MICCAI 2006 (stationary velocity
//! fields); Ashburner, "A fast diffeomorphic image registration algorithm", NeuroImage 38(1), 2007; Durrleman et al.,
//! "Morphometry of anatomical shape complexes", NeuroImage 101, 2014 (control points); Charon, Trouvé, "The varifold
//! representation of nonoriented shapes for diffeomorphic registration", SIAM J. Imaging Sci. 6(4), 2013.

mod flow;
mod varifold;

pub use flow::VelocityField;

use crate::MethodError;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::lbfgs::{Objective, minimize};
use homolog_primitives::observe::Observer;
use homolog_primitives::points::farthest_points;
use nalgebra::{Matrix3, Point3, Vector3};
use varifold::Varifold;

/// Settings; lengths in square roots of the area.
#[derive(Debug, Clone, PartialEq)]
pub struct DiffeomorphicOptions {
    /// Width `w` of the velocity field.
    pub width: f64,
    /// Largest number of control points.
    pub n_control: usize,
    /// Widths of the kernel between face centers, coarse to fine.
    pub data_widths: Vec<f64>,
    /// Weight `ρ` of the energy of the velocity field: at 1e-2 a displacement of a tenth everywhere costs as much as a
    /// varifold difference of some thousandths.
    pub regularization: f64,
    /// Steps of the flow while it is fitted.
    pub n_steps: usize,
    /// Largest number of L-BFGS steps per data width.
    pub max_iterations: u32,
}

impl Default for DiffeomorphicOptions {
    fn default() -> Self {
        DiffeomorphicOptions {
            width: 0.15,
            n_control: 200,
            data_widths: vec![0.2, 0.1, 0.05],
            regularization: 1e-2,
            n_steps: 6,
            max_iterations: 60,
        }
    }
}

/// Relative decrease of the energy over ten steps below which L-BFGS ends.
const TOLERANCE: f64 = 1e-3;

/// The velocity field whose flow moves `source` onto `target`.
///
/// # Errors
/// [`MethodError::Singular`] if no energy is finite; [`MethodError::Cancelled`].
///
/// # Cost
/// Each evaluation `O(f f' + n · control · n_steps)` for `f` and `f'` faces and `n` vertices of the source; memory
/// `O(n · n_steps + f + f')`.
pub fn register(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    options: &DiffeomorphicOptions,
    observer: &dyn Observer,
) -> Result<VelocityField, MethodError> {
    let singular = MethodError::Singular { method: "the diffeomorphic flow" };
    let control: Vec<Point3<f64>> =
        farthest_points(source.vertices(), options.n_control).into_iter().map(|i| source.vertices()[i]).collect();
    let mut field = VelocityField::new(control, options.width);
    for &data_width in &options.data_widths {
        let objective = Fit::new(source, target, &field, data_width, options);
        let start: Vec<f64> = field.momenta().iter().flat_map(|m| [m.x, m.y, m.z]).collect();
        let found = minimize(&objective, start, options.max_iterations, TOLERANCE, observer)?;
        field = field.with_momenta(vectors(&found.x));
        if found.x.iter().any(|x| !x.is_finite()) {
            return Err(singular);
        }
    }
    Ok(field)
}

fn vectors(x: &[f64]) -> Vec<Vector3<f64>> {
    x.chunks_exact(3).map(|c| Vector3::new(c[0], c[1], c[2])).collect()
}

/// The energy of momenta at one data width.
struct Fit<'a> {
    source: &'a SurfaceMesh,
    triangles: Vec<[u32; 3]>,
    target: Varifold,
    /// `‖T‖²`.
    of_target: f64,
    field: &'a VelocityField,
    data_width: f64,
    options: &'a DiffeomorphicOptions,
}

impl<'a> Fit<'a> {
    fn new(
        source: &'a SurfaceMesh,
        target: &SurfaceMesh,
        field: &'a VelocityField,
        data_width: f64,
        options: &'a DiffeomorphicOptions,
    ) -> Fit<'a> {
        let target = Varifold::of(target.vertices(), &target.triangles());
        let of_target = target.product(&target, data_width).max(f64::MIN_POSITIVE);
        Fit { source, triangles: source.triangles(), target, of_target, field, data_width, options }
    }
}

impl Objective for Fit<'_> {
    fn evaluate(&self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let field = self.field.with_momenta(vectors(x));
        let path = field.path(self.source.vertices(), self.options.n_steps);
        let Some(end) = path.last() else { return f64::INFINITY };
        let varifold = Varifold::of(&end.at, &self.triangles);
        let (of_source, own) = varifold.product_and_gradient(&varifold, self.data_width);
        let (of_both, cross) = varifold.product_and_gradient(&self.target, self.data_width);
        // The product of a varifold with itself depends on its faces through both factors.
        let of_faces: Vec<_> =
            own.iter().zip(&cross).map(|(a, b)| (*a * 2.0 - *b * 2.0) * (1.0 / self.of_target)).collect();
        let of_points = varifold::at_vertices(&of_faces, &end.at, &self.triangles);
        let mut of_momenta = field.back_through(&path, of_points);
        let energy = field.energy(&mut of_momenta, self.options.regularization);
        for (slot, g) in gradient.chunks_exact_mut(3).zip(&of_momenta) {
            slot.copy_from_slice(g.as_slice());
        }
        let value = (of_source - 2.0 * of_both + self.of_target) / self.of_target + energy;
        if value.is_finite() { value } else { f64::INFINITY }
    }

    fn precondition(&self, v: &[f64]) -> Vec<f64> {
        v.to_vec()
    }
}

/// Determinants of the Jacobian of the flow at `points`, the smallest along each path: nothing folds if it is above 0.
///
/// Cost `O(n · control · n_steps)`.
pub fn least_jacobians(field: &VelocityField, points: &[Point3<f64>], n_steps: usize) -> Vec<f64> {
    field.jacobians(points, n_steps).into_iter().map(|(_, least): (Matrix3<f64>, f64)| least).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{bean, rms, warped};
    use homolog_primitives::observe::Silent;

    fn fitted() -> (SurfaceMesh, Vec<Point3<f64>>, VelocityField) {
        let mesh = bean(2);
        let truth: Vec<_> = mesh.vertices().iter().map(warped).collect();
        let target = mesh.with_vertices(truth.clone()).unwrap();
        let options = DiffeomorphicOptions { max_iterations: 40, ..DiffeomorphicOptions::default() };
        let field = register(&mesh, &target, &options, &Silent).unwrap();
        (mesh, truth, field)
    }

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let mesh = bean(1);
        let target = mesh.with_vertices(mesh.vertices().iter().map(warped).collect()).unwrap();
        let control: Vec<_> = mesh.vertices().iter().step_by(7).copied().collect();
        let options = DiffeomorphicOptions { n_steps: 3, ..DiffeomorphicOptions::default() };
        let field = VelocityField::new(control, 0.3);
        let fit = Fit::new(&mesh, &target, &field, 0.2, &options);
        let n = 3 * field.momenta().len();
        let x: Vec<f64> = (0..n).map(|k| 0.05 * ((k * k) as f64).sin()).collect();
        let (mut gradient, mut scratch) = (vec![0.0; n], vec![0.0; n]);
        fit.evaluate(&x, &mut gradient);
        let largest = gradient.iter().fold(0.0f64, |a, g| a.max(g.abs()));
        for k in 0..n {
            let mut at = |d: f64| {
                let mut moved = x.clone();
                moved[k] += d;
                fit.evaluate(&moved, &mut scratch)
            };
            let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!((difference - gradient[k]).abs() < 1e-5 * largest, "{k}: {difference} {}", gradient[k]);
        }
    }

    #[test]
    fn a_warp_is_found_without_folds_and_undone_by_the_flow_back() {
        let (mesh, truth, field) = fitted();
        let moved = field.flowed(mesh.vertices(), 1.0, 20, &Silent).unwrap();
        let error = rms(&moved, &truth);
        assert!(error < 0.5 * rms(mesh.vertices(), &truth), "{error}");
        // 0.01 mm on a hippocampus, whose area is about 1,500 mm².
        let back = field.flowed(&moved, -1.0, 20, &Silent).unwrap();
        let worst = back.iter().zip(mesh.vertices()).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max);
        assert!(worst < 0.01 / 1500f64.sqrt(), "{worst}");
        assert!(least_jacobians(&field, mesh.vertices(), 20).iter().all(|j| *j > 0.0));
    }
}
