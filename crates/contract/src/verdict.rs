//! Reliability of an answer: in short, for lists of jobs, and in words, for people.

use crate::input::InputWarning;
use crate::result::{
    DeformationDocument, ResultDocument, SimilarityDocument, SurfaceDistanceDocument, UnreliableReason,
    confidence_factor,
};

/// The verdict on an answer, with the distance between the registered surfaces.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Verdict {
    /// Whether no reason was found to doubt the answer; `None` where no smooth displacement field could be fitted,
    /// on which the checks rest.
    pub reliable: Option<bool>,
    /// The reasons to doubt it.
    pub reasons: Vec<UnreliableReason>,
    /// Findings in the inputs and changes of them that bear on the answer, a sentence each.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub warnings: Vec<String>,
    /// Symmetric distance between the registered surfaces.
    pub surface_distance: SurfaceDistanceDocument,
}

impl ResultDocument {
    /// Whether this answer is reliable, given the findings of the match and the changes of the inputs.
    pub fn verdict(&self) -> Verdict {
        let found = self.reliability.as_ref();
        let mut reasons = found.map(|found| found.reasons.clone()).unwrap_or_default();
        // The commonest cause is named first: a mirror image also looks like another structure.
        reasons.sort_by_key(|reason| *reason != UnreliableReason::OtherHandedness);
        for reason in self.warnings.iter().filter_map(|warning| warning.reason) {
            if !reasons.contains(&reason) {
                reasons.push(reason);
            }
        }
        // A method without checks finds no reason for doubt, but a warning counts for every method.
        let reliable = if reasons.is_empty() { found.map(|found| found.reliable) } else { Some(false) };
        let warnings = self.warnings.iter().map(|warning| warning.detail.clone()).collect();
        Verdict { reliable, reasons, warnings, surface_distance: self.surface_distance.clone() }
    }

    /// Records `warnings`: their reasons make the answer unreliable, and lower its confidences unless another reason has
    /// done so.
    pub fn warn(&mut self, warnings: Vec<InputWarning>) {
        let reasons = warnings.iter().filter_map(|warning| warning.reason);
        if let Some(found) = &mut self.reliability {
            let before = confidence_factor(&found.reasons, 0);
            for reason in reasons {
                if !found.reasons.contains(&reason) {
                    found.reasons.push(reason);
                }
                found.reliable = false;
            }
            let factor = confidence_factor(&found.reasons, 0) / before;
            if factor < 1.0 {
                let mut next = self.correspondences.as_mut();
                while let Some(columns) = next {
                    columns.confidence.iter_mut().for_each(|confidence| *confidence *= factor);
                    next = columns.inverse.as_deref_mut();
                }
            }
        }
        self.warnings.extend(warnings);
    }
}

impl DeformationDocument {
    /// Folds and the changes of area and volume, in one line.
    pub fn sentence(&self) -> String {
        let volume = self.volume_ratio.map(|ratio| format!(", volume × {ratio:.2}")).unwrap_or_default();
        format!(
            "{} triangles folded ({:.2} % of the area); area × {:.2} (90 % of vertices: {:.2} to {:.2}){volume}",
            self.folded_triangles,
            100.0 * self.folded_area_share,
            self.area_ratio,
            self.area_ratio_p05,
            self.area_ratio_p95
        )
    }
}

impl SimilarityDocument {
    /// The scale and the remainder after the similarity, in one line.
    pub fn sentence(&self) -> String {
        format!("scale {:.4}, RMS {:.3} mm", self.scale, self.rms_mm)
    }
}

impl Verdict {
    /// The verdict in one line.
    pub fn headline(&self) -> &'static str {
        match self.reliable {
            Some(true) => "RELIABLE: no reason was found to doubt this answer",
            Some(false) => "NOT RELIABLE: do not use this answer without looking at it",
            None => "NOT CHECKED: no displacement field could be fitted that would say whether this answer is reliable",
        }
    }

    /// The distance between the surfaces, in one sentence.
    pub fn distance(&self) -> String {
        let SurfaceDistanceDocument { mean_mm, p95_mm, max_mm } = self.surface_distance;
        format!(
            "After the rigid transform alone the surfaces are {mean_mm:.2} mm apart on average; 95 % of the vertices are within \
             {p95_mm:.2} mm, all within {max_mm:.2} mm. This is not the error of the correspondence."
        )
    }
}

impl UnreliableReason {
    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            UnreliableReason::UnlikeShape => "unlike_shape",
            UnreliableReason::OtherHandedness => "other_handedness",
            UnreliableReason::AmbiguousPose => "ambiguous_pose",
            UnreliableReason::SecondOpinion => "second_opinion",
            UnreliableReason::UncertainSide => "uncertain_side",
            UnreliableReason::UnitsDiffer => "units_differ",
            UnreliableReason::PieceDropped => "piece_dropped",
            UnreliableReason::LabelsJoined => "labels_joined",
            UnreliableReason::CavityFilled => "cavity_filled",
            UnreliableReason::TooCoarse => "too_coarse",
        }
    }

    /// The finding, in one sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            UnreliableReason::UnlikeShape => {
                "The two surfaces seem to show different structures: one has to be drawn out far to become the other, \
                 compared with how well curvatures of corresponding points agree."
            }
            UnreliableReason::OtherHandedness => "A mirror image of the source fits the target better.",
            UnreliableReason::AmbiguousPose => "Another pose, turned by 45 degrees or more, fits as well.",
            UnreliableReason::SecondOpinion => {
                "The default method finds another pose for these surfaces, or other corresponding points."
            }
            UnreliableReason::UncertainSide => {
                "A file states two orientations of different handedness: left and right may be exchanged."
            }
            UnreliableReason::UnitsDiffer => {
                "One surface is larger than the other by the ratio of two units of length, such as 10, 25.4 or 1000."
            }
            UnreliableReason::PieceDropped => {
                "A structure is in several pieces, and one that was dropped has 5 % or more of its volume."
            }
            UnreliableReason::LabelsJoined => {
                "Several labels of one input were joined, because none were chosen, and the other input has other labels."
            }
            UnreliableReason::CavityFilled => {
                "A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much."
            }
            UnreliableReason::TooCoarse => {
                "The voxels are so large for the structure that they leave its rotation uncertain."
            }
        }
    }

    /// The recommended check, in one sentence.
    pub fn advice(self) -> &'static str {
        match self {
            UnreliableReason::UnlikeShape => "Do both files show the same structure, and is a part of one missing?",
            UnreliableReason::OtherHandedness => {
                "Is one of them left and the other right? Match again with the source mirrored: --mirror source on the command \
                 line, the parameter input.source.mirror: true elsewhere (or without it, if it was mirrored). Or is an axis of an \
                 image flipped? Then correct the image."
            }
            UnreliableReason::AmbiguousPose => {
                "Is the shape nearly symmetric? Landmarks (parameter landmarks) decide between the poses."
            }
            UnreliableReason::SecondOpinion => {
                "Which of the two answers is right? Match again with the method balanced, and look at both."
            }
            UnreliableReason::UncertainSide => {
                "Which orientation of the file is right? Write it into both places (sform and qform)."
            }
            UnreliableReason::UnitsDiffer => {
                "Are both files in millimeters? Scale one of them, or state its unit in the file."
            }
            UnreliableReason::PieceDropped => {
                "Are left and right one label, or several structures? Choose the labels of one (input.labels), or name the \
                 repair largest_component (input.repair) to confirm that the rest is not meant."
            }
            UnreliableReason::LabelsJoined => "Which labels are the structure? Choose them (input.labels).",
            UnreliableReason::CavityFilled => {
                "Is the label a wall around something else? Name the repair fill (input.repair) to confirm that the inside \
                 belongs to the structure."
            }
            UnreliableReason::TooCoarse => {
                "Is there a segmentation of smaller voxels? Interpolating this one adds nothing."
            }
        }
    }
}

#[cfg(all(test, feature = "serde"))]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_json() {
        use UnreliableReason::{
            AmbiguousPose, CavityFilled, LabelsJoined, OtherHandedness, PieceDropped, SecondOpinion, TooCoarse,
            UncertainSide, UnitsDiffer, UnlikeShape,
        };
        let of_inputs = [PieceDropped, LabelsJoined, CavityFilled, TooCoarse, UncertainSide, UnitsDiffer];
        for reason in [UnlikeShape, OtherHandedness, AmbiguousPose, SecondOpinion].into_iter().chain(of_inputs) {
            assert_eq!(serde_json::to_value(reason).unwrap(), reason.name());
        }
    }
}
