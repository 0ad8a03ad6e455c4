//! Why a match has no result.

use homolog_geometry::harmonics::HarmonicsError;
use homolog_primitives::observe::Cancelled;

/// Why a match has no result. Non-convergence of a minimizer is no error but part of the [`crate::MatchOutcome`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MatchError {
    /// The observer asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No rigid transform is supported by three labels of the first round, and there is no other pose.
    ///
    /// A displacement field can start from landmarks or from a search of all orientations, and registration alone
    /// always has a pose. So this error occurs for an energy that is minimized without a displacement field (the
    /// presets `thesis`, `gibbs`, `metropolis` and `las_vegas`), and for a displacement field if the search finds no
    /// pose either, as on surfaces without area.
    #[error("no rigid transform is supported by three correspondences within {tolerance_mm} mm")]
    NoRegistration {
        /// Tolerance of an inlier, mm.
        tolerance_mm: f64,
    },
    /// A surface has no first-order ellipsoid.
    #[error("the {surface} has no first-order ellipsoid: {error}")]
    NoEllipsoid {
        /// `source` or `target`.
        surface: &'static str,
        /// The fault of the parametrization.
        error: HarmonicsError,
    },
    /// The heat flow that smooths the surface has no solution.
    #[error("curvature at scale {scale_mm} mm could not be computed: the surface has degenerate faces")]
    ScaleSpace {
        /// Scale, mm.
        scale_mm: f64,
    },
    /// The request names a published method, and the library was built without its feature `comparison`.
    #[error("this build has no published methods: it lacks the feature comparison of homolog-matching")]
    NoMethods,
    /// The spectrum for a heat or wave kernel signature could not be computed.
    #[error("the spectrum of the surface could not be computed: it has degenerate faces")]
    Spectrum,
}
