//! Heat and wave kernel signatures of a surface of area 1.
//!
//! [`Spectrum`] computes the signatures. Here the spectrum is scaled to a surface of area 1, which makes the signatures
//! dimensionless and independent of size.
//!
//! Sources: Sun, Ovsjanikov, Guibas, "A concise and provably informative multi-scale signature based on heat diffusion", 2009;
//! Aubry, Schlickewei, Cremers, "The wave kernel signature", 2011.

use super::Descriptor;
use crate::spectrum::{Spectrum, spectrum};
use faer::Mat;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer};

/// Number of eigenfunctions used for signatures.
pub(super) const N_FUNCTIONS: usize = 80;
/// Number of times or energies.
pub(super) const N_CHANNELS: usize = 32;

/// The spectrum, for signatures, of the surface scaled to area 1. `None` under the same conditions as [`spectrum`].
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// The cost of 80 eigenpairs.
pub fn unit_spectrum(mesh: &SurfaceMesh, observer: &dyn Observer) -> Result<Option<Spectrum>, Cancelled> {
    // The first scaling is by a power of two, which rounds nothing: the solver has thresholds that do not scale.
    let root = mesh.area().sqrt();
    let size = if root.is_normal() { 2f64.powi(-(root.log2().floor() as i32)) } else { 1.0 };
    let Ok(near) = mesh.with_vertices(mesh.vertices().iter().map(|p| p * size).collect()) else { return Ok(None) };
    Ok(spectrum(&near, N_FUNCTIONS, observer)?.map(Spectrum::of_unit_area))
}

/// The heat kernel signature at 32 times ([`Spectrum::heat_signature`]), divided by its integral; the mean over the
/// surface is 1.
pub fn heat_kernel_signature(spectrum: &Spectrum) -> Descriptor {
    descriptor(&spectrum.heat_signature(N_CHANNELS))
}

/// The wave kernel signature at 32 energies ([`Spectrum::wave_signature`]), divided by its integral; the mean over the
/// surface is 1.
pub fn wave_kernel_signature(spectrum: &Spectrum) -> Descriptor {
    descriptor(&spectrum.wave_signature(N_CHANNELS))
}

fn descriptor(signature: &Mat<f64>) -> Descriptor {
    let finite = |value: f64| if value.is_finite() { value } else { 0.0 };
    let row = |i: usize| (0..signature.ncols()).map(move |c| finite(signature[(i, c)]));
    Descriptor { n_channels: signature.ncols(), values: (0..signature.nrows()).flat_map(row).collect() }
}

impl Spectrum {
    /// The spectrum of the surface scaled to area 1.
    #[must_use]
    pub fn of_unit_area(mut self) -> Self {
        let total: f64 = self.areas.iter().sum();
        let root = total.sqrt();
        self.areas.iter_mut().for_each(|a| *a /= total);
        self.values.iter_mut().for_each(|v| *v *= total);
        let (n, k) = (self.functions.nrows(), self.functions.ncols());
        self.functions = Mat::from_fn(n, k, |i, c| self.functions[(i, c)] * root);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::check_invariance;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn on_a_sphere_every_point_has_the_mean() {
        // 80 of 81 spherical harmonics up to degree 8: the one that is missing shows at the shortest time alone.
        let sphere = ellipsoid(Vector3::repeat(7.0), 4);
        let spectrum = unit_spectrum(&sphere, &Silent).unwrap().unwrap();
        for found in [heat_kernel_signature(&spectrum), wave_kernel_signature(&spectrum)] {
            let off = |c: usize| (0..found.n_vertices()).map(|i| (found.row(i)[c] - 1.0).abs()).fold(0.0, f64::max);
            for c in N_CHANNELS / 4..N_CHANNELS * 3 / 4 {
                assert!(off(c) < 0.05, "{c}: {}", off(c));
            }
        }
    }

    #[test]
    fn the_mean_over_the_area_is_one_on_any_surface() {
        let mesh = ellipsoid(Vector3::new(9.0, 4.0, 3.0), 3);
        let spectrum = unit_spectrum(&mesh, &Silent).unwrap().unwrap();
        for found in [heat_kernel_signature(&spectrum), wave_kernel_signature(&spectrum)] {
            for c in 0..N_CHANNELS {
                let mean: f64 = (0..found.n_vertices()).map(|i| spectrum.areas[i] * found.row(i)[c]).sum();
                assert!((mean - 1.0).abs() < 1e-9, "{mean}");
            }
        }
    }

    #[test]
    fn they_keep_their_numbers_when_the_surface_is_moved_scaled_or_sampled_otherwise() {
        check_invariance(&|mesh, _| heat_kernel_signature(&unit_spectrum(mesh, &Silent).unwrap().unwrap()), 1e-6, 0.2);
        // The highest of 80 eigenvalues are those of the 642 vertices more than those of the surface.
        check_invariance(&|mesh, _| wave_kernel_signature(&unit_spectrum(mesh, &Silent).unwrap().unwrap()), 1e-6, 0.6);
    }
}
