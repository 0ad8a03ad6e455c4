//! The prior of a smooth displacement, relative to the size of the displaced surface.

use homolog_registration::deformation::{GaussianKernel, SmoothPrior};

/// Settings of the prior: round numbers; nearby values gave the same accuracy within its spread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PriorOptions {
    /// Width of the field's Gaussian process in diagonals of the source.
    pub width: f64,
    /// Standard deviation of the process, and of the translation, in diagonals.
    pub amplitude: f64,
    /// Standard deviation of the entries of the linear part.
    pub linear: f64,
    /// Inducing points of the field.
    pub n_inducing: usize,
}

impl Default for PriorOptions {
    fn default() -> Self {
        PriorOptions { width: 0.3, amplitude: 0.1, linear: 0.2, n_inducing: 100 }
    }
}

impl PriorOptions {
    /// The prior of the displacement of a surface with this diagonal.
    pub(crate) fn of(&self, diagonal_mm: f64) -> SmoothPrior {
        SmoothPrior {
            translation_mm: self.amplitude * diagonal_mm,
            linear: self.linear,
            kernels: vec![GaussianKernel {
                width_mm: self.width * diagonal_mm,
                amplitude_mm: self.amplitude * diagonal_mm,
            }],
        }
    }
}
