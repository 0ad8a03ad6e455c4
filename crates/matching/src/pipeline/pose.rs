//! The second stage: a rigid transform, from rounds of inference and registration or from registration alone. By
//! default the displacement field searches all orientations instead.

use crate::comparison::registration_only::register;
use crate::error::MatchError;
use crate::pair::problem::{MatchProblem, Problem};
use crate::poses::posed::PoseResult;
use crate::thesis::rounds::Rounds;
use homolog_contract::parameters::{DisplacementMode, InitialPose};

/// Solves the problem of `prepare_problem`.
pub(crate) fn find_pose<'c>(coarse: &'c MatchProblem<'c>) -> Result<PoseResult<'c>, MatchError> {
    match &coarse.problem {
        Problem::Registration => {
            let parameters = coarse.full.parameters;
            let searches = parameters.registration.initial == InitialPose::Search;
            if searches && parameters.displacement.mode == DisplacementMode::Smooth {
                return Ok(PoseResult::ByField);
            }
            Ok(PoseResult::Registration(register(&coarse.full)?))
        }
        Problem::Energy(problem) => Ok(PoseResult::Inference { problem, inferred: Rounds { problem }.run()? }),
    }
}
