//! The second stage: a rigid transform, from rounds of inference and registration or from registration alone. By
//! default the displacement field searches all orientations instead.

use crate::comparison::registration_only::register;
use crate::error::MatchError;
use crate::pair::problem::{Coarse, Problem};
use crate::poses::posed::Posed;
use crate::thesis::rounds::Rounds;
use homolog_contract::parameters::{DisplacementMode, InitialPose};

/// Solves the problem of `coarse`.
pub(crate) fn posed<'c>(coarse: &'c Coarse<'c>) -> Result<Posed<'c>, MatchError> {
    match &coarse.problem {
        Problem::Registration => {
            let parameters = coarse.full.parameters;
            let searches = parameters.registration.initial == InitialPose::Search;
            if searches && parameters.displacement.mode == DisplacementMode::Smooth {
                return Ok(Posed::ByField);
            }
            Ok(Posed::Registration(register(&coarse.full)?))
        }
        Problem::Energy(problem) => Ok(Posed::Inference { problem, inferred: Rounds { problem }.run()? }),
    }
}
