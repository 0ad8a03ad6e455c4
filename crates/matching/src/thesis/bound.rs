//! The lower bound of the energy, computed before the rounds if the parameters ask for it.

use crate::error::MatchError;
use homolog_mrf::MrfModel;
use homolog_mrf::inference::{DualBound, DualOptions};
use homolog_primitives::observe::{Observer, Phase, Quantity, TracePoint};

/// The dual method ends when the energy of a labeling is within this share of the bound.
const BOUND_GAP: f64 = 1e-9;
/// The dual method ends when an iteration raises the bound by less than this share.
const PROGRESS_TOLERANCE: f64 = 1e-6;

/// A lower bound of the energy of all labelings, after at most `iterations`; `None` if that is 0.
pub(crate) fn lower_bound(
    model: &MrfModel,
    iterations: u32,
    observer: &dyn Observer,
) -> Result<Option<f64>, MatchError> {
    if iterations == 0 {
        return Ok(None);
    }
    observer.phase(Phase::Bounding);
    let options = DualOptions { gap_tolerance: BOUND_GAP, progress_tolerance: PROGRESS_TOLERANCE };
    let found = DualBound::new(model, options).run(iterations, observer, |iteration, _| {
        observer.trace(&TracePoint {
            quantity: Some(Quantity::CurvatureEnergy),
            energy: Some(iteration.energy.total()),
            energy_unary: Some(iteration.energy.unary),
            energy_pairwise: Some(iteration.energy.pairwise),
            lower_bound: Some(iteration.bound),
            ..TracePoint::new(0, Phase::Bounding, iteration.iteration)
        });
    })?;
    Ok(Some(found.bound))
}
