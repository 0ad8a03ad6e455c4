//! From two surfaces to an outcome, in four stages. Each is a function from the values of previous stages to an
//! immutable value:
//!
//! 1. [`prepare_problem()`]: the energy of a coarse level, if one is asked for;
//! 2. [`find_pose()`]: a rigid transform, from rounds of inference or from registration alone, unless the field searches
//!    for it;
//! 3. [`find_images_at_either_size()`]: an image of every source vertex, through a smooth displacement field if one is
//!    asked for; for surfaces of unlike sizes at the size at which they are more alike; answers without a field get a
//!    second opinion;
//! 4. [`build_outcome()`]: the outcome, with all measures of these images.

mod counting;
pub(crate) mod images;
mod inferred;
pub(crate) mod pose;
mod resized;
mod second_opinion;
mod unseen;

use self::pose::find_pose;
use self::resized::find_images_at_either_size;
use self::second_opinion::with_second_opinion;
use self::unseen::RisingProgress;
use crate::answer::outcome::MatchOutcome;
use crate::answer::report::build_outcome;
use crate::error::MatchError;
use crate::poses::posed::PoseResult;
use crate::surface::levels::Levels;
use crate::thesis::coarse::prepare_problem;
use homolog_contract::parameters::MatchParameters;
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_primitives::observe::{Observer, Phase, Quantity, TracePoint};

/// Matches `source` to `target` and registers them. Correspondences use the vertex indices of these two meshes.
///
/// `source` is moved onto `target`; both are surfaces of any topology whose faces look outwards, mm. The answer is the
/// same to the bit for the same surfaces, parameters and seed, on any number of threads, and renumbering the vertices
/// of an input permutes it. Parameters are taken as they are: `MatchParameters::check` (feature
/// `serde`) says which values are allowed.
///
/// # Errors
/// [`MatchError`].
///
/// # Cost
/// Time `O(iterations · |E→| · n' · k̄)`; memory `1.25·|E→|·n'` numbers of 32 bits for the messages, for `n'`
/// labels, `|E→|` directed edges and `k̄` labels within the neighborhood radius on the level on which the energy is
/// minimized; and `O(n log n)` for the vertices beside it.
pub fn match_surfaces(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let coarse = parameters.inference.coarse_vertices;
    let levels = |mesh: &SurfaceMesh| Levels::observed(mesh, &Numbering::identity(mesh.n_vertices()), coarse, observer);
    let (source, target) = rayon::join(|| levels(source), || levels(target));
    match_levels(&source?, &target?, parameters, observer)
}

/// [`match_surfaces`] from prebuilt levels, with the `inference.coarse_vertices` of `parameters`. The result is the
/// same to the bit, independent of other matches of these levels. Every vertex index of the outcome is an original of
/// the numbering of the levels ([`Levels::numbered`]).
///
/// # Errors
/// [`MatchError`].
pub fn match_levels(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let observer = &RisingProgress::new(observer);
    let coarse = prepare_problem(source, target, parameters, observer)?;
    let posed = find_pose(&coarse)?;
    let displaced = find_images_at_either_size((source, target), (&coarse, &posed))?;
    observer.phase(Phase::Reporting);
    let displaced = with_second_opinion(source, target, parameters, displaced, observer)?;
    let outcome = build_outcome(&coarse, &posed, &displaced);
    trace_answer(&outcome, &posed, observer);
    Ok(outcome)
}

/// The last point of the trace: the energy of the answer, if it has one.
fn trace_answer(outcome: &MatchOutcome, posed: &PoseResult<'_>, observer: &dyn Observer) {
    let Some(energy) = &outcome.energy else { return };
    let round = outcome.rounds.iter().find(|round| round.chosen).map_or(0, |round| round.round);
    let quantity = if matches!(posed, PoseResult::Inference { .. }) {
        Quantity::CurvatureEnergy
    } else {
        Quantity::IsometryEnergy
    };
    observer.trace(&TracePoint {
        quantity: Some(quantity),
        chosen: true,
        energy: Some(energy.r#final),
        energy_unary: Some(energy.unary),
        energy_pairwise: Some(energy.pairwise),
        lower_bound: energy.lower_bound,
        support: Some(outcome.support.inliers),
        ..TracePoint::new(round, Phase::Reporting, 1)
    });
}
