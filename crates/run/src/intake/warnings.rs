//! Warnings on an input whose surface may not be the intended structure: pieces dropped, labels joined, cavities
//! filled.

use super::counted;
use super::label_names::table_of;
use homolog_contract::input::InputWarning;
use homolog_contract::result::UnreliableReason;
use homolog_mesh::volume::{BettiNumbers, FillChange, LabelVolume};
use std::collections::BTreeMap;

/// Share of a structure above which an unrequested change puts the answer in doubt: the difference between two
/// segmentations of one structure by one person.
const GRAVE_SHARE: f64 = 0.05;

/// Largest number of labels that a warning lists.
const MAX_LISTED: usize = 8;

/// The labels a surface was made from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UsedLabels {
    /// The labels that occur, ascending.
    labels: Vec<u32>,
    /// Whether a request selected them.
    asked: bool,
}

impl UsedLabels {
    pub(super) fn new(volume: &LabelVolume, requested: Option<&[u32]>) -> Self {
        let present = volume.label_counts().into_keys();
        let labels = present.filter(|label| requested.is_none_or(|list| list.contains(label))).collect();
        UsedLabels { labels, asked: requested.is_some() }
    }

    /// Whether several labels became one structure without a request.
    pub(crate) fn are_joined_unasked(&self) -> bool {
        !self.asked && self.labels.len() > 1
    }

    /// Whether two surfaces were made from different labels, some of which were joined without a request.
    pub(crate) fn disagree(&self, other: &UsedLabels) -> bool {
        self.labels != other.labels && (self.are_joined_unasked() || other.are_joined_unasked())
    }

    pub(super) fn joined_warning(&self, names: &BTreeMap<u32, String>) -> Option<InputWarning> {
        if !self.are_joined_unasked() {
            return None;
        }
        let table = table_of(&self.labels.iter().copied().collect());
        let listed = self.labels.iter().take(MAX_LISTED).map(|label| {
            let name = table.filter(|_| names.is_empty()).and_then(|table| table.name_of(*label));
            name.map_or_else(|| label.to_string(), |name| format!("{label} {name}"))
        });
        let listed: Vec<String> = listed.collect();
        let more = match self.labels.len().saturating_sub(MAX_LISTED) {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        // Names are text of the file, which may name a patient.
        let by_name = if names.is_empty() && table.is_none() { "" } else { ", by number or name" };
        let detail = format!(
            "{} labels were joined to one structure ({}{more}), because none were chosen; input.labels chooses \
             some{by_name}",
            self.labels.len(),
            listed.join(", ")
        );
        Some(InputWarning { reason: None, detail })
    }
}

/// Warning that only the largest of `n_pieces` was kept and the others, a `share` of the `measure`, were dropped;
/// `asked` if the request names the repair.
pub(super) fn piece_dropped(n_pieces: usize, share: f64, measure: &str, asked: bool) -> InputWarning {
    let n_dropped = n_pieces - 1;
    let detail = format!(
        "only the largest of {n_pieces} pieces was kept; {} with {} of the {measure} {} dropped",
        counted(n_dropped as u64, "piece", "pieces"),
        percent(share),
        if n_dropped == 1 { "was" } else { "were" },
    );
    let reason = (!asked && share >= GRAVE_SHARE).then_some(UnreliableReason::PieceDropped);
    InputWarning { reason, detail }
}

/// Warning that cavities and tunnels were closed in a structure of `n_voxels` that enclosed `n_enclosed` others. `None`
/// if only a small tunnel or a contact was closed.
pub(super) fn filled(change: FillChange, n_enclosed: usize, n_voxels: usize, asked: bool) -> Option<InputWarning> {
    let BettiNumbers { n_tunnels, n_cavities, .. } = change.before;
    let share = |n: usize| n as f64 / n_voxels.max(1) as f64;
    // Opening the wall of a cavity also changes only a few voxels.
    let grave = share(change.n_changed().max(n_enclosed)) >= GRAVE_SHARE;
    if n_cavities == 0 && !grave {
        return None;
    }
    let cavities = counted(n_cavities.into(), "cavity", "cavities");
    let mut what = match n_tunnels {
        0 => cavities,
        n => format!("{cavities} and {}", counted(n.into(), "tunnel", "tunnels")),
    };
    if n_enclosed > 0 {
        what = format!("{what} with {} of the volume", percent(share(n_enclosed)));
    }
    let detail = format!("{what} closed; {} voxels were added and {} removed for it", change.n_added, change.n_removed);
    Some(InputWarning { reason: (grave && !asked).then_some(UnreliableReason::CavityFilled), detail })
}

/// Warning that requested smoothing changed the volume by the factor `ratio`.
pub(super) fn smoothed(smoothing_mm: f64, ratio: f64) -> InputWarning {
    let what = if ratio <= 1.0 { "took" } else { "added" };
    let detail = format!(
        "smoothing by {smoothing_mm} mm {what} {} of the volume; without input.smoothing_mm none is lost",
        percent((1.0 - ratio).abs())
    );
    InputWarning { reason: None, detail }
}

/// A share in percent, with two significant digits if it is small.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let digits = if percent >= 10.0 { 0 } else { (1.0 - percent.max(1e-3).log10().floor()) as usize };
    format!("{percent:.digits$} %")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_have_two_digits() {
        let shown = [0.47, 0.0512, 0.00031, 0.0].map(percent);
        assert_eq!(shown, ["47 %", "5.1 %", "0.031 %", "0.0000 %"]);
    }

    #[test]
    fn a_change_is_a_reason_from_one_twentieth_on_unless_it_was_asked_for() {
        let reason = |share: f64, asked: bool| piece_dropped(2, share, "volume", asked).reason;
        assert_eq!(reason(0.05, false), Some(UnreliableReason::PieceDropped));
        assert_eq!((reason(0.049, false), reason(0.5, true)), (None, None));
        let closed = |n_tunnels: u32, n_cavities: u32, n_added: usize, asked: bool| {
            let before = BettiNumbers { n_pieces: 1, n_tunnels, n_cavities };
            filled(FillChange { before, n_added, n_removed: 0 }, 0, 100, asked).map(|warning| warning.reason)
        };
        assert_eq!(closed(0, 1, 5, false), Some(Some(UnreliableReason::CavityFilled)));
        assert_eq!((closed(0, 1, 5, true), closed(0, 1, 4, false)), (Some(None), Some(None)));
        let before = BettiNumbers { n_pieces: 1, n_tunnels: 0, n_cavities: 1 };
        let opened = filled(FillChange { before, n_added: 0, n_removed: 2 }, 34, 100, false).unwrap();
        assert_eq!(opened.reason, Some(UnreliableReason::CavityFilled));
        assert_eq!(opened.detail, "1 cavity with 34 % of the volume closed; 0 voxels were added and 2 removed for it");
        assert_eq!((closed(1, 0, 4, false), closed(1, 0, 6, false).flatten().is_some()), (None, true));
    }
}
