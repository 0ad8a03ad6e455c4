//! Reasons in the inputs of a match to doubt its answer, independent of the result of the match.
//!
//! Each input has its own warnings ([`InputWarning`], made by [`crate::intake`]); some are a reason for doubt only in
//! combination with the other input. [`pair_warnings`] prefixes each with the name of the input and adds warnings on
//! the pair.

use crate::intake::PreparedSurface;
use crate::scales::scale_warning;
use homolog_contract::input::{InputWarning, SamplingReport};
use homolog_contract::result::UnreliableReason;

/// Standard deviation of the rotation, degrees, of the coarser input above which voxels are too coarse. It is a bound
/// for any method, and answers are off by twice as much: beside a hippocampus of 1 mm, copies with voxels of 1, 2, 3
/// and 4 mm have 0.15, 0.4, 1.0 and 2.0, and are off by 0.3, 0.9, 1.7 and 2.3 on average.
const MAX_ROTATION_DEG: f64 = 1.2;

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
    if let (Some(a), Some(b)) = (source.labels(), target.labels())
        && a.disagree(b)
    {
        warnings.push(InputWarning {
            reason: Some(UnreliableReason::LabelsJoined),
            detail: "the labels of which the two surfaces were made differ".to_owned(),
        });
    }
    warnings.extend(scale_warning(&source.mesh, &target.mesh));
    warnings.extend(coarseness(source.report.sampling, target.report.sampling));
    warnings
}

/// A warning that the voxels leave the rotation uncertain, if they do. A mesh has no voxels.
fn coarseness(source: Option<SamplingReport>, target: Option<SamplingReport>) -> Option<InputWarning> {
    let [a, b] = [source, target].map(|sampling| sampling.map_or(0.0, |sampling| sampling.rotation_deg));
    let coarser = a.max(b);
    (coarser > MAX_ROTATION_DEG).then(|| InputWarning {
        reason: Some(UnreliableReason::TooCoarse),
        detail: format!(
            "the voxels leave the rotation uncertain by {:.1} degrees (one standard deviation; source {a:.1}, target {b:.1})",
            coarser.min(180.0)
        ),
    })
}
