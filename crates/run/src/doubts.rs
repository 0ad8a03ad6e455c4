//! What the inputs of a match say against its answer, whatever the match itself found.
//!
//! Each input has its own warnings ([`InputWarning`], made by [`crate::intake`]); some are a reason to doubt only beside the
//! other input. [`pair_warnings`] puts the input's name before each and adds what holds for the pair.

use crate::intake::PreparedSurface;
use crate::scales::scale_warning;
use homolog_contract::input::InputWarning;

/// The warnings of both inputs and of the pair, for [`homolog_contract::result::ResultDocument::warn`].
pub(crate) fn pair_warnings(source: &PreparedSurface, target: &PreparedSurface) -> Vec<InputWarning> {
    let mut warnings = Vec::new();
    for (name, prepared) in [("source", source), ("target", target)] {
        warnings.extend(
            prepared
                .report
                .warnings
                .iter()
                .map(|warning| InputWarning { reason: warning.reason, detail: format!("{name}: {}", warning.detail) }),
        );
    }
    warnings.extend(scale_warning(&source.mesh, &target.mesh));
    warnings
}
