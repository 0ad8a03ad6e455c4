//! The place of the published methods in a build without the feature `comparison`: there are none.

use crate::answer::displaced::VertexImages;
use crate::error::MatchError;
use crate::pair::problem::MatchProblem;
use homolog_contract::parameters::DisplacementMode;
use homolog_contract::result::PoseDocument;
use homolog_registration::RigidTransform;

/// `None`: no method, no memory.
pub(crate) fn limits(_: DisplacementMode) -> Option<(usize, u64)> {
    None
}

/// # Errors
/// [`MatchError::NoMethods`].
pub(crate) fn by_method(
    _: &MatchProblem<'_>,
    _: &RigidTransform,
    _: Vec<PoseDocument>,
) -> Result<Option<VertexImages>, MatchError> {
    Err(MatchError::NoMethods)
}
