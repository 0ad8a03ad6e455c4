//! Whether an answer can be relied on: in short, for lists of jobs, and in words, for people.

use crate::result::{
    DeformationDocument, ResultDocument, SimilarityDocument, SurfaceDistanceDocument, UnreliableReason,
};

/// The verdict on an answer, with the distance between the registered surfaces.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Verdict {
    /// Whether no reason was found to doubt the answer; `None` for methods that fit no displacement field, on which the
    /// checks rest.
    pub reliable: Option<bool>,
    /// The reasons to doubt it.
    pub reasons: Vec<UnreliableReason>,
    /// Symmetric distance between the registered surfaces.
    pub surface_distance: SurfaceDistanceDocument,
}

impl ResultDocument {
    /// Whether this answer can be relied on.
    pub fn verdict(&self) -> Verdict {
        Verdict {
            reliable: self.reliability.as_ref().map(|found| found.reliable),
            reasons: self.reliability.as_ref().map(|found| found.reasons.clone()).unwrap_or_default(),
            surface_distance: self.surface_distance.clone(),
        }
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
    /// The scale and what the similarity leaves, in one line.
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
            None => "NOT CHECKED: only methods that fit a displacement field check whether an answer is reliable",
        }
    }

    /// How far apart the surfaces are, in one sentence.
    pub fn distance(&self) -> String {
        let SurfaceDistanceDocument { mean_mm, p95_mm, max_mm } = self.surface_distance;
        format!(
            "After rigid registration the surfaces are {mean_mm:.2} mm apart on average; 95 % of the vertices are within \
             {p95_mm:.2} mm, all within {max_mm:.2} mm."
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
        }
    }

    /// What was found, in one sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            UnreliableReason::UnlikeShape => {
                "The two surfaces seem to show different structures: curvatures or normals of corresponding points \
                 disagree, one has to be drawn out far to become the other, or one surface is longer by half."
            }
            UnreliableReason::OtherHandedness => "A mirror image of the source fits the target better.",
            UnreliableReason::AmbiguousPose => "Another pose, turned by 45 degrees or more, fits as well.",
        }
    }

    /// What to check, in one sentence.
    pub fn advice(self) -> &'static str {
        match self {
            UnreliableReason::UnlikeShape => "Do both files show the same structure, and is a part of one missing?",
            UnreliableReason::OtherHandedness => {
                "Is one of them left and the other right, or is an axis of an image flipped?"
            }
            UnreliableReason::AmbiguousPose => {
                "Is the shape nearly symmetric? Landmarks (parameter landmarks) decide between the poses."
            }
        }
    }
}

#[cfg(all(test, feature = "serde"))]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_json() {
        use UnreliableReason::{AmbiguousPose, OtherHandedness, UnlikeShape};
        for reason in [UnlikeShape, OtherHandedness, AmbiguousPose] {
            assert_eq!(serde_json::to_value(reason).unwrap(), reason.name());
        }
    }
}
