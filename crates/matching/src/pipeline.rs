//! From two surfaces to an outcome, in four stages. Each is a function from the values of the stages before it to an
//! immutable value of its own:
//!
//! 1. [`coarse()`]: the energy of a coarse level, if one is asked for;
//! 2. [`posed()`]: a rigid transform, from rounds of inference or from registration alone, unless the field searches for it;
//! 3. [`displaced()`]: an image of every source vertex, through a smooth displacement field if one is asked for; between surfaces
//!    of unlike sizes also with the source [`resized()`];
//! 4. [`measured()`]: the outcome, with all that is measured on these images.

use super::coarse::coarse;
use super::displaced::displaced;
use super::levels::Levels;
use super::posed::posed;
use super::report::measured;
use super::resized::resized;
use super::{MatchError, MatchOutcome};
use homolog_contract::parameters::MatchParameters;
use homolog_primitives::observe::{Observer, Phase};

pub(crate) fn run(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let coarse = coarse(source, target, parameters, observer)?;
    let posed = posed(&coarse)?;
    let displaced = displaced(&coarse, &posed)?;
    let displaced = resized(source, target, parameters, displaced, observer)?;
    observer.phase(Phase::Reporting);
    Ok(measured(&coarse, &posed, &displaced))
}
